// attenuation.scene, written by `course export`.
// povray +Iattenuation.pov +Oattenuation.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb 0 }

camera {
  perspective
  location <0, 0, 10>
  direction <0, 0, -1>
  right <0.7899026532322141, 0, 0>
  up <0, 0.5924269899241605, 0>
}

light_source { <-2.5, 1.5, 0.8> rgb 0.125 }
light_source { <0, 1.5, 0.8> rgb <1.1, 0.95, 0.8> fade_distance 0.25 fade_power 1 }
light_source { <2.5, 1.5, 0.8> rgb <150000.00000000003, 130000.00000000003, 190000.00000000003> fade_distance 1e-06 fade_power 1 }
light_source { <-2.5, -1.5, 0.8> rgb <1.7, 1.6, 1.2> fade_distance 0.3333333333333333 fade_power 2 }
light_source { <0, -1.5, 0.8> rgb <125000000000, 156250000000, 175000000000> fade_distance 1e-06 fade_power 2 }
light_source { <2.5, -1.5, 0.8> rgb <8.591229182759271, 9.163977794943223, 7.445731958391369> fade_distance 0.07513444358617222 fade_power 1 }
light_source { <2.5, -1.5, 0.8> rgb <-1.0912291827592713, -1.1639777949432228, -0.9457319583913685> fade_distance 0.5915322230804945 fade_power 1 }

#declare Material0 =
  texture { pigment { checker rgb 0.8 rgb 0.6400000000000001 scale 0.25 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.8, 0.5, 0.3> } finish { ambient 0 diffuse 1 } }

plane { <0, 0, 1>, -0.01 texture { Material0 } no_shadow }
sphere { <-2.5, 1.5, 0>, 0.3 texture { Material1 } no_shadow }
sphere { <0, 1.5, 0>, 0.3 texture { Material1 } no_shadow }
sphere { <2.5, 1.5, 0>, 0.3 texture { Material1 } no_shadow }
sphere { <-2.5, -1.5, 0>, 0.3 texture { Material1 } no_shadow }
sphere { <0, -1.5, 0>, 0.3 texture { Material1 } no_shadow }
sphere { <2.5, -1.5, 0>, 0.3 texture { Material1 } no_shadow }
