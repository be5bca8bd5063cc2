// shadows.scene, written by `course export`.
// povray +Ishadows.pov +Oshadows.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.05, 0.06, 0.08> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <0, -0.30600918041312064, -0.9520285612852643>
  right <0.9705872913765395, 0, 0>
  up <0, 0.6930201169582264, -0.2227564661651442>
}

light_source { <-4.5, 3.8, 0.8> rgb <0.66, 0.58, 0.47> }
light_source { <4, 3.2, -1.2> rgb <0.6599999999999999, 0.7899999999999998, 1.0499999999999998> fade_distance 3.1622776601683795 fade_power 2 }

#declare Material0 =
  texture { pigment { checker rgb <0.02, 0.02, 0.024> rgb <0.0124, 0.012, 0.01392> scale 1 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.75, 0.72, 0.66> transmit 0.5 rgb <0.46499999999999997, 0.432, 0.3828> transmit 0.5 scale 1 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.02, 0.02, 0.024> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.2, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb <0.02, 0.02, 0.024> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.85, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb <0.02, 0.02, 0.024> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.45, 0.75> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material4 =
  texture { pigment { rgb <0.02, 0.02, 0.024> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.3, 0.62, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material5 =
  texture { pigment { rgb <0.02, 0.02, 0.024> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.6 transmit 0.5 } finish { ambient 0 diffuse 2 } }

triangle { <-8, 0, 8>, <8, 0, 8>, <8, 0, -8> texture { Material0 } }
triangle { <-8, 0, 8>, <8, 0, -8>, <-8, 0, -8> texture { Material0 } }
sphere { <-1.1, 0.8, 0.2>, 0.8 texture { Material1 } }
sphere { <0.45, 0.35, 1.2>, 0.35 texture { Material2 } }
sphere { <-2.2, 0.3, 1.5>, 0.3 texture { Material3 } }
triangle { <1.9, 0, -0.2>, <1.9, 0.9, 0.7>, <2.8, 0.9, -0.2> texture { Material4 } }
triangle { <1.9, 0, -0.2>, <1, 0.9, -0.2>, <1.9, 0.9, 0.7> texture { Material4 } }
triangle { <1.9, 0, -0.2>, <1.9, 0.9, -1.1>, <1, 0.9, -0.2> texture { Material4 } }
triangle { <1.9, 0, -0.2>, <2.8, 0.9, -0.2>, <1.9, 0.9, -1.1> texture { Material4 } }
triangle { <1.9, 1.8, -0.2>, <2.8, 0.9, -0.2>, <1.9, 0.9, 0.7> texture { Material4 } }
triangle { <1.9, 1.8, -0.2>, <1.9, 0.9, 0.7>, <1, 0.9, -0.2> texture { Material4 } }
triangle { <1.9, 1.8, -0.2>, <1, 0.9, -0.2>, <1.9, 0.9, -1.1> texture { Material4 } }
triangle { <1.9, 1.8, -0.2>, <1.9, 0.9, -1.1>, <2.8, 0.9, -0.2> texture { Material4 } }
polygon { 5, <-0.4, 1.7, -0.9>, <0.7, 1.5, -0.9>, <0.8, 2.2, -1.3>, <-0.3, 2.4, -1.3>, <-0.4, 1.7, -0.9> texture { Material5 } }
