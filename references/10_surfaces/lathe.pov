// lathe.scene, written by `course export`.
// povray +Ilathe.pov +Olathe.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 3 adc_bailout 0 }
background { rgb <0.1, 0.11, 0.14> }

camera {
  perspective
  location <0, 2.2, 7>
  direction <0, -0.162112586908358, -0.9867722681378313>
  right <0.789902653232214, 0, 0>
  up <0, 0.5845905245535319, -0.09603987189093739>
}

light_source { <3, 6, 5> rgb <0.45, 0.43, 0.4> fade_distance 9.128709291752768 fade_power 2 }
light_source { <-5, 3, 4> rgb <0.1, 0.12, 0.16> fade_distance 9.128709291752768 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.08, 0.08, 0.09> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.3, 0.27, 0.25> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.08, 0.08, 0.09> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.36, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.08, 0.08, 0.09> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.32, 0.5> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.08, 0.08, 0.09> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.42, 0.2, 0.24> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.08, 0.08, 0.09> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.3, 0.4, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.0125 } }

plane { <0.004999687529293824, 0.9999375058587648, 0.009999375058587648>, 0 texture { Material0 } }
cylinder { <-1.9, 0.02, 0>, <-1.9, 0.16, 0>, 0.6 texture { Material1 } }
cone { <-1.9, 0.16, 0>, 0.52, <-1.9, 0.34, 0>, 0.4 texture { Material1 } }
cone { <-1.9, 0.34, 0>, 0.34, <-1.9, 1.15, 0>, 0.17 texture { Material1 } }
cone { <-1.9, 1.15, 0>, 0.36, <-1.9, 1.23, 0>, 0.3 texture { Material1 } }
sphere { <-1.9, 1.5, 0>, 0.33 texture { Material1 } }
cylinder { <0, 0.02, 0>, <0, 0.16, 0>, 0.6 matrix <0.383022221559489, 0, -0.3213938048432696, 0, 1.35, 0, 0.7070663706551933, 0, 0.8426488874308758, 0, 0, 0> texture { Material2 } }
cone { <0, 0.16, 0>, 0.52, <0, 0.34, 0>, 0.4 matrix <0.383022221559489, 0, -0.3213938048432696, 0, 1.35, 0, 0.7070663706551933, 0, 0.8426488874308758, 0, 0, 0> texture { Material2 } }
cone { <0, 0.34, 0>, 0.34, <0, 1.15, 0>, 0.17 matrix <0.383022221559489, 0, -0.3213938048432696, 0, 1.35, 0, 0.7070663706551933, 0, 0.8426488874308758, 0, 0, 0> texture { Material2 } }
cone { <0, 1.15, 0>, 0.36, <0, 1.23, 0>, 0.3 matrix <0.383022221559489, 0, -0.3213938048432696, 0, 1.35, 0, 0.7070663706551933, 0, 0.8426488874308758, 0, 0, 0> texture { Material2 } }
sphere { <0, 1.5, 0>, 0.33 matrix <0.383022221559489, 0, -0.3213938048432696, 0, 1.35, 0, 0.7070663706551933, 0, 0.8426488874308758, 0, 0, 0> texture { Material2 } }
cylinder { <0, 0.02, 0>, <0, 0.16, 0>, 0.6 matrix <0.09473496022644876, -0.9945218953682733, 0.044175637448602256, 0.9914772319657861, 0.11498130959441881, 0.462333426151966, -0.2958327832184896, 0, 0.6344154509256549, 1.3534091072136856, 0.26400747616223247, 0.2150666295392136> texture { Material3 } }
cone { <0, 0.16, 0>, 0.52, <0, 0.34, 0>, 0.4 matrix <0.09473496022644876, -0.9945218953682733, 0.044175637448602256, 0.9914772319657861, 0.11498130959441881, 0.462333426151966, -0.2958327832184896, 0, 0.6344154509256549, 1.3534091072136856, 0.26400747616223247, 0.2150666295392136> texture { Material3 } }
cone { <0, 0.34, 0>, 0.34, <0, 1.15, 0>, 0.17 matrix <0.09473496022644876, -0.9945218953682733, 0.044175637448602256, 0.9914772319657861, 0.11498130959441881, 0.462333426151966, -0.2958327832184896, 0, 0.6344154509256549, 1.3534091072136856, 0.26400747616223247, 0.2150666295392136> texture { Material3 } }
cone { <0, 1.15, 0>, 0.36, <0, 1.23, 0>, 0.3 matrix <0.09473496022644876, -0.9945218953682733, 0.044175637448602256, 0.9914772319657861, 0.11498130959441881, 0.462333426151966, -0.2958327832184896, 0, 0.6344154509256549, 1.3534091072136856, 0.26400747616223247, 0.2150666295392136> texture { Material3 } }
sphere { <0, 1.5, 0>, 0.33 matrix <0.09473496022644876, -0.9945218953682733, 0.044175637448602256, 0.9914772319657861, 0.11498130959441881, 0.462333426151966, -0.2958327832184896, 0, 0.6344154509256549, 1.3534091072136856, 0.26400747616223247, 0.2150666295392136> texture { Material3 } }
cone { <0, 0, 0>, 0.8, <0, 0.9, 0>, 0.5 open matrix <0.9396926207859084, 0, -0.3420201433256687, 0, 2, 0, 0.20521208599540122, 0, 0.563815572471545, 1.2, 0.02, -1.6> texture { Material4 } }
box { <-0.2, 0, -0.2>, <0.2, 1.2, 0.2> matrix <0.9396926207859084, 0, -0.3420201433256687, 0, 2, 0, 0.20521208599540122, 0, 0.563815572471545, 1.2, 0.02, -1.6> texture { Material4 } }
