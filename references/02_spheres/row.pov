// row.scene, written by `course export`.
// povray +Irow.pov +Orow.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.35, 0.55, 0.8> }

camera {
  perspective
  location <-0.9, 2.3, 6.4>
  direction <0.2051550221994277, -0.2548895730356526, -0.9449564658882732>
  right <0.948491243232475, 0, 0.2059224409649452>
  up <0.03936561229201069, 0.7038967170588434, -0.18132039601168565>
}


#declare Material0 =
  texture { pigment { checker rgb <0.8, 0.8, 0.78> rgb <0.2, 0.24, 0.27299999999999996> scale 1 } finish { ambient 0 diffuse 0 emission 1 } }

#declare Material1 =
  texture { pigment { rgb <0.55, 0.2, 0.5> } finish { ambient 0 diffuse 0 emission 1 } }

#declare Material2 =
  texture { pigment { rgb <0.2, 0.3, 0.65> } finish { ambient 0 diffuse 0 emission 1 } }

#declare Material3 =
  texture { pigment { rgb <0.15, 0.5, 0.4> } finish { ambient 0 diffuse 0 emission 1 } }

#declare Material4 =
  texture { pigment { rgb <0.85, 0.6, 0.1> } finish { ambient 0 diffuse 0 emission 1 } }

#declare Material5 =
  texture { pigment { rgb <0.8, 0.25, 0.1> } finish { ambient 0 diffuse 0 emission 1 } }

#declare Material6 =
  texture { pigment { rgb <0.9, 0.9, 0.85> } finish { ambient 0 diffuse 0 emission 1 } }

#declare Material7 =
  texture { pigment { rgb <0.1, 0.12, 0.15> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, -0.37 texture { Material0 } }
sphere { <3.6, 0.63, -4.5>, 1 texture { Material1 } }
sphere { <2.4, 0.63, -3.2>, 1 texture { Material2 } }
sphere { <1.2, 0.63, -1.9>, 1 texture { Material3 } }
sphere { <0, 0.63, -0.6>, 1 texture { Material4 } }
sphere { <-1.2, 0.33, 0.6>, 0.7 texture { Material5 } }
sphere { <0.6, -0.25, 2.1>, 0.45 texture { Material6 } }
sphere { <1, -0.25, 1.8>, 0.45 texture { Material7 } }
