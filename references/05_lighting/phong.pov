// phong.scene, written by `course export`.
// povray +Iphong.pov +Ophong.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.05, 0.05, 0.06> }

camera {
  perspective
  location <0, 0.75, 7>
  direction <0, -0.0995037190209989, -0.995037190209989>
  right <0.9705872913765395, 0, 0>
  up <0, 0.7243278384486269, -0.0724327838448627>
}

light_source { <-1.9, 1.2, -4> rgb <0.8, 0.76, 0.66> }
light_source { <1.9, 1.2, -4> rgb <0.8, 0.76, 0.66> }
light_source { <24174.688920761404, 72524.06676228422, 64465.837122030425> rgb 0.3 parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.01 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.14, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.45 } specular 0.45 roughness 0.0125 } }

#declare Material1 =
  texture { pigment { rgb 0.01 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.14, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.45 } phong 0.45 phong_size 20 } }

#declare Material2 =
  texture { pigment { rgb 0.01 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.12, 0.16> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.5 } specular 0.5 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb 0.01 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.12, 0.16> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.5 } phong 0.5 phong_size 20 } }

sphere { <-1.15, 0.1, -0.5>, 0.8 texture { Material0 } no_shadow }
sphere { <1.15, 0.1, -0.5>, 0.8 texture { Material1 } no_shadow }
polygon { 5, <-9, -0.7, 9>, <0, -0.7, 9>, <0, -0.7, -9>, <-9, -0.7, -9>, <-9, -0.7, 9> texture { Material2 } no_shadow }
polygon { 5, <0, -0.7, 9>, <9, -0.7, 9>, <9, -0.7, -9>, <0, -0.7, -9>, <0, -0.7, 9> texture { Material3 } no_shadow }
