// mirrors.scene, written by `course export`.
// povray +Imirrors.pov +Omirrors.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 7 adc_bailout 0 }
background { rgb 0 }

camera {
  perspective
  location <0.7, 1.9, 3.6>
  direction <-0.12265980606405907, -0.14848292313017677, -0.9812784485124726>
  right <1.2905766863631836, 0, -0.16132208579539795>
  up <-0.01796518114826839, 0.9646521181787594, -0.14372144918614713>
}

light_source { <0, 3.6, 0> rgb <3900000000000, 3700000000000, 3400000000000> fade_distance 1e-06 fade_power 2 }
light_source { <2.5, 3.4, 2.5> rgb <1300000000000, 1450000000000, 1600000000000> fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { checker rgb 0.04 rgb <0.013999999999999999, 0.016, 0.02> scale 1 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.62, 0.6, 0.56> transmit 0.5 rgb <0.217, 0.24, 0.28> transmit 0.5 scale 1 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 specular 1.8 roughness 0.0005 } }
  texture { pigment { rgb <0.9555555555555555, 1, 0.9777777777777777> filter 1 } finish { ambient 0 diffuse 0 } }
  texture { pigment { rgb <0.012, 0.015, 0.014> transmit 0.5 } finish { ambient 0 diffuse 0 emission 2 reflection { rgb <0.86, 0.9, 0.88> } } }

#declare Material2 =
  texture { pigment { rgb 0.02 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.08, 0.06> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.02 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.45> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.016666666666666666 } }

#declare Material4 =
  texture { pigment { rgb 0.02 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.36, 0.05> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.016666666666666666 } }

#declare Material5 =
  texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 specular 2.8 roughness 0.016666666666666666 } }
  texture { pigment { rgb <1, 0.8571428571428572, 0.5> filter 1 } finish { ambient 0 diffuse 0 } }
  texture { pigment { rgb 0.02 transmit 0.5 } finish { ambient 0 diffuse 0 emission 4 } }
  texture { pigment { rgb <0.08, 0.06, 0.02> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb <0.7, 0.6, 0.35> } } }

plane { <0, 1, 0>, 0 texture { Material0 } }
polygon { 5, <-3, 0.1, -4>, <3, 0.1, -4>, <3, 3, -4>, <-3, 3, -4>, <-3, 0.1, -4> texture { Material1 } }
polygon { 5, <-3, 0.1, 4>, <3, 0.1, 4>, <3, 3, 4>, <-3, 3, 4>, <-3, 0.1, 4> texture { Material1 } }
sphere { <-1.2, 0.6, -1.5>, 0.6 texture { Material2 } }
sphere { <0.1, 0.45, -2.4>, 0.45 texture { Material3 } }
sphere { <1.2, 0.5, -1.2>, 0.5 texture { Material4 } }
sphere { <0, 0.35, -0.6>, 0.35 texture { Material5 } }
