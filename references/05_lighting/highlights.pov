// highlights.scene, written by `course export`.
// povray +Ihighlights.pov +Ohighlights.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.05, 0.05, 0.06> }

camera {
  perspective
  location <0, 0, 12>
  direction <0, 0, -1>
  right <0.6648746742484818, 0, 0>
  up <0, 0.49865600568636137, 0>
}

light_source { <42426.40687119285, 56568.5424949238, 70710.67811865475> rgb 0.55 parallel point_at 0 }
light_source { <-6, 1, 7> rgb <0.1, 0.14, 0.22> }

#declare Material0 =
  texture { pigment { rgb 0.01 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.26, 0.55> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.7 } specular 0.7 roughness 1 } }

#declare Material1 =
  texture { pigment { rgb 0.01 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.26, 0.55> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.7 } specular 0.7 roughness 0.125 } }

#declare Material2 =
  texture { pigment { rgb 0.01 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.26, 0.55> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.7 } specular 0.7 roughness 0.025 } }

#declare Material3 =
  texture { pigment { rgb 0.01 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.26, 0.55> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.7 } specular 0.7 roughness 0.0025 } }

#declare Material4 =
  texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 specular 3.4 roughness 0.03333333333333333 } }
  texture { pigment { rgb <1, 0.7058823529411765, 0.23529411764705885> filter 1 } finish { ambient 0 diffuse 0 } }
  texture { pigment { rgb 0.01 transmit 0.5 } finish { ambient 0 diffuse 0 emission 4 } }
  texture { pigment { rgb <0.25, 0.12, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb <0.85, 0.6, 0.2> } } }

#declare Material5 =
  texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 specular 3.4 roughness 0.03333333333333333 } }
  texture { pigment { rgb <1, 0.5294117647058824, 0.35294117647058826> filter 1 } finish { ambient 0 diffuse 0 } }
  texture { pigment { rgb 0.01 transmit 0.5 } finish { ambient 0 diffuse 0 emission 4 } }
  texture { pigment { rgb <0.22, 0.1, 0.07> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb <0.85, 0.45, 0.3> } } }

#declare Material6 =
  texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 specular 2.6 roughness 0.03333333333333333 } }
  texture { pigment { rgb <0.923076923076923, 0.9538461538461538, 1> filter 1 } finish { ambient 0 diffuse 0 } }
  texture { pigment { rgb 0.01 transmit 0.5 } finish { ambient 0 diffuse 0 emission 4 } }
  texture { pigment { rgb <0.16, 0.16, 0.17> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb <0.6, 0.62, 0.65> } } }

#declare Material7 =
  texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 specular 2.8 roughness 0.03333333333333333 } }
  texture { pigment { rgb <0, 1, 0.7142857142857143> filter 1 } finish { ambient 0 diffuse 0 } }
  texture { pigment { rgb <0.11, 0.01, 0.03> transmit 0.5 } finish { ambient 0 diffuse 0 emission 4 } }
  texture { pigment { rgb <0.05, 0.2, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb <0, 0.7, 0.5> } } }

sphere { <-2.7, 1.1, 0>, 0.82 texture { Material0 } no_shadow }
sphere { <-0.9, 1.1, 0>, 0.82 texture { Material1 } no_shadow }
sphere { <0.9, 1.1, 0>, 0.82 texture { Material2 } no_shadow }
sphere { <2.7, 1.1, 0>, 0.82 texture { Material3 } no_shadow }
sphere { <-2.7, -1.1, 0>, 0.82 texture { Material4 } no_shadow }
sphere { <-0.9, -1.1, 0>, 0.82 texture { Material5 } no_shadow }
sphere { <0.9, -1.1, 0>, 0.82 texture { Material6 } no_shadow }
sphere { <2.7, -1.1, 0>, 0.82 texture { Material7 } no_shadow }
