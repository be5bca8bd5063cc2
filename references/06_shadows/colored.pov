// colored.scene, written by `course export`.
// povray +Icolored.pov +Ocolored.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.03, 0.03, 0.04> }

camera {
  perspective
  location <0, 3.2, 7>
  direction <0, -0.3883512444316368, -0.9215114274649008>
  right <0.9182069687724408, 0, 0>
  up <0, 0.6346036608762836, -0.2674401142264338>
}

light_source { <1.2, 6, -2.2> rgb 0.66 }
light_source { <-56980.28822981898, 68376.34587578278, 45584.230583855184> rgb 0.22 parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.02 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.92 transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <3.8, 1.4, 1> filter 1 } finish { ambient 0 diffuse 0 } }
  texture { pigment { rgb 0.02 transmit 0.5 } finish { ambient 0 diffuse 0 emission 4 } }
  texture { pigment { rgb <0.3, 0.06, 0.05> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <1.4, 3.68, 1.6> filter 1 } finish { ambient 0 diffuse 0 } }
  texture { pigment { rgb 0.02 transmit 0.5 } finish { ambient 0 diffuse 0 emission 4 } }
  texture { pigment { rgb <0.06, 0.28, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb <1.2, 1.8, 3.88> filter 1 } finish { ambient 0 diffuse 0 } }
  texture { pigment { rgb 0.02 transmit 0.5 } finish { ambient 0 diffuse 0 emission 4 } }
  texture { pigment { rgb <0.05, 0.1, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material4 =
  texture { pigment { rgb <3.84, 3.6, 0.8> filter 1 } finish { ambient 0 diffuse 0 } }
  texture { pigment { rgb 0.02 transmit 0.5 } finish { ambient 0 diffuse 0 emission 4 } }
  texture { pigment { rgb <0.3, 0.26, 0.04> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material5 =
  texture { pigment { rgb 0.02 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.5 transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.75, 0.8, 0.3>, 0.8 texture { Material1 } interior { ior 1.000001 } }
sphere { <-0.35, 0.6, 1.1>, 0.6 texture { Material2 } interior { ior 1.000001 } }
sphere { <0.55, 0.95, -0.6>, 0.95 texture { Material3 } interior { ior 1.000001 } }
sphere { <1.9, 0.55, 0.9>, 0.55 texture { Material4 } interior { ior 1.000001 } }
sphere { <-1.2, 0.35, 2.1>, 0.35 texture { Material5 } }
sphere { <2.25, 0.7, 0.5>, 0.35 texture { Material5 } }
