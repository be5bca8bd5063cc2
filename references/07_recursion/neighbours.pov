// neighbours.scene, written by `course export`.
// povray +Ineighbours.pov +Oneighbours.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 11 adc_bailout 0 }
background { rgb <0.55, 0.62, 0.7> }

camera {
  perspective
  location <0, 2.1, 6.5>
  direction <0, -0.18884739365012448, -0.9820064469806473>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6381464729034151, -0.12272047555834904>
}

light_source { <-42107.59605332595, 84215.1921066519, 33686.07684266076> rgb 0.65 parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.1235, 0.117, 0.0975> rgb <0.026000000000000002, 0.039, 0.0585> scale 0.5 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.6174999999999999, 0.5850000000000001, 0.48750000000000004> transmit 0.5 rgb <0.13, 0.195, 0.29250000000000004> transmit 0.5 scale 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.8, 0.93, 0.98> filter 1 } finish { ambient 0 diffuse 0 } }

#declare Material2 =
  texture { pigment { rgb <0.97, 0.97, 0.9> filter 1 } finish { ambient 0 diffuse 0 } }

#declare Material3 =
  texture { pigment { rgb <0.9, 0.96, 0.9> filter 1 } finish { ambient 0 diffuse 0 } }

#declare Material4 =
  texture { pigment { rgb 1 filter 1 } finish { ambient 0 diffuse 0 } }

#declare Material5 =
  texture { pigment { rgb <0.97, 0.9, 0.92> filter 1 } finish { ambient 0 diffuse 0 } }

#declare Material6 =
  texture { pigment { rgb 0.96 filter 1 } finish { ambient 0 diffuse 0 } }

#declare Material7 =
  texture { pigment { rgb <0.95, 0.8, 0.75> filter 1 } finish { ambient 0 diffuse 0 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.45, 1, 0>, 1 texture { Material1 } interior { ior 1.33 } }
sphere { <-1.45, 1, 0>, 0.6 texture { Material2 } interior { ior 1.5 } }
sphere { <0.5, 0.7, 1>, 0.7 texture { Material3 } interior { ior 1.5 } }
sphere { <0.5, 0.7, 1>, 0.45 texture { Material4 } interior { ior 1 } }
sphere { <1.75, 0.95, -0.7>, 0.95 texture { Material5 } interior { ior 1.2 } }
sphere { <1.75, 0.95, -0.7>, 0.7 texture { Material6 } interior { ior 1.4 } }
sphere { <1.75, 0.95, -0.7>, 0.45 texture { Material7 } interior { ior 1.6 } }
