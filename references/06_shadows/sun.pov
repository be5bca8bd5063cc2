// sun.scene, written by `course export`.
// povray +Isun.pov +Osun.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.25, 0.38, 0.58> }

camera {
  perspective
  location <-1.5, 3.4, 9>
  direction <0.1969996403804861, -0.3006836616333735, -0.9331561912759868>
  right <0.8984051782415705, 0, 0.1896633154065538>
  up <0.04277149511547601, 0.6567869694592423, -0.20260181896804427>
}

light_source { <83770.7816583391, 46073.92991208651, 29319.773580418685> rgb <0.62, 0.5, 0.34> parallel point_at 0 }
light_source { <-32444.284226152507, 81110.71056538128, 48666.42633922876> rgb <0.1, 0.13, 0.18> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb <0.035, 0.045, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.62, 0.56, 0.45> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.035, 0.045, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.68, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.035, 0.045, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.3, 0.16> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb <0.035, 0.045, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.25, 0.4, 0.55> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-3, 0.4, -1>, 0.4 texture { Material1 } }
sphere { <-3, 1.2, -1>, 0.4 texture { Material1 } }
sphere { <-3, 2, -1>, 0.4 texture { Material1 } }
sphere { <-1, 0.4, -1>, 0.4 texture { Material1 } }
sphere { <-1, 1.2, -1>, 0.4 texture { Material1 } }
sphere { <-1, 2, -1>, 0.4 texture { Material1 } }
sphere { <1, 0.4, -1>, 0.4 texture { Material1 } }
sphere { <1, 1.2, -1>, 0.4 texture { Material1 } }
sphere { <1, 2, -1>, 0.4 texture { Material1 } }
sphere { <3, 0.4, -1>, 0.4 texture { Material1 } }
sphere { <3, 1.2, -1>, 0.4 texture { Material1 } }
sphere { <3, 2, -1>, 0.4 texture { Material1 } }
polygon { 5, <-3.6, 2.4, -1.4>, <3.6, 2.4, -1.4>, <3.6, 2.4, -0.6>, <-3.6, 2.4, -0.6>, <-3.6, 2.4, -1.4> texture { Material1 } }
polygon { 5, <-3.6, 2.7, -1.4>, <-3.6, 2.7, -0.6>, <3.6, 2.7, -0.6>, <3.6, 2.7, -1.4>, <-3.6, 2.7, -1.4> texture { Material1 } }
polygon { 5, <-3.6, 2.4, -0.6>, <3.6, 2.4, -0.6>, <3.6, 2.7, -0.6>, <-3.6, 2.7, -0.6>, <-3.6, 2.4, -0.6> texture { Material1 } }
polygon { 5, <3.6, 2.4, -1.4>, <-3.6, 2.4, -1.4>, <-3.6, 2.7, -1.4>, <3.6, 2.7, -1.4>, <3.6, 2.4, -1.4> texture { Material1 } }
polygon { 5, <3.6, 2.4, -0.6>, <3.6, 2.4, -1.4>, <3.6, 2.7, -1.4>, <3.6, 2.7, -0.6>, <3.6, 2.4, -0.6> texture { Material1 } }
polygon { 5, <-3.6, 2.4, -1.4>, <-3.6, 2.4, -0.6>, <-3.6, 2.7, -0.6>, <-3.6, 2.7, -1.4>, <-3.6, 2.4, -1.4> texture { Material1 } }
sphere { <1.1, 0.7, 1.7>, 0.7 texture { Material2 } }
sphere { <-0.6, 0.35, 2.6>, 0.35 texture { Material3 } }
