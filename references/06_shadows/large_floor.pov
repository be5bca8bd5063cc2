// large_floor.scene, written by `course export`.
// povray +Ilarge_floor.pov +Olarge_floor.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.04, 0.04, 0.06> }

camera {
  perspective
  location <0, 1.1, 6>
  direction <0, -0.09950371902099893, -0.995037190209989>
  right <1.0236374267611088, 0, 0>
  up <0, 0.7639179816886178, -0.0763917981688618>
}

light_source { <-5, 0.6, 1.5> rgb <0.775, 0.625, 0.425> fade_distance 7.0710678118654755 fade_power 2 }
light_source { <4, 0.25, 2.6> rgb <0.475, 0.575, 0.85> fade_distance 7.0710678118654755 fade_power 2 }
light_source { <26832.815729997474, 89442.71909999159, 35777.08763999664> rgb <0.2, 0.21, 0.24> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb <0.015, 0.015, 0.02> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.7, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.015, 0.015, 0.02> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.25, 0.14> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.015, 0.015, 0.02> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.42, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb <0.015, 0.015, 0.02> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.65, 0.25> transmit 0.5 } finish { ambient 0 diffuse 2 } }

triangle { <-2000, 0, 1500>, <2000, 0, 1500>, <0, 0, -2500> texture { Material0 } }
sphere { <-0.9, 0.6, 0.3>, 0.6 texture { Material1 } }
sphere { <0.7, 0.35, 1.3>, 0.35 texture { Material2 } }
triangle { <1.5, 0, -0.6>, <2.5, 0, -0.9>, <2, 1.5, -0.8> texture { Material3 } }
triangle { <2.5, 0, -0.9>, <2.2, 0, 0.1>, <2, 1.5, -0.8> texture { Material3 } }
triangle { <2.2, 0, 0.1>, <1.5, 0, -0.6>, <2, 1.5, -0.8> texture { Material3 } }
