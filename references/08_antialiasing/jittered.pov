// jittered.scene, written by `course export`.
// povray +Ijittered.pov +Ojittered.png +W2560 +H1920 +FN16 -D +AM1 +A0.0 +R2 -J File_Gamma=1.0
// then 8 × 8 of its pixels are one of ours, weighed by our filter
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.22, 0.38, 0.66> }

camera {
  perspective
  location <0.31, 1.5, 4.6>
  direction <-0.019466877909874634, -0.14275710467241398, -0.9895662937519606>
  right <0.9703995407488449, 0, -0.019089827031124818>
  up <-0.002043906326745423, 0.720484722247181, -0.10389857160955898>
}

light_source { <69210.05095105749, 61396.01294045424, 37953.898908644434> rgb <0.72, 0.68, 0.6> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.07, 0.075, 0.09> rgb <0.007000000000000001, 0.012, 0.018> scale 0.5 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.8, 0.77, 0.7> transmit 0.5 rgb <0.08000000000000002, 0.1232, 0.13999999999999999> transmit 0.5 scale 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 specular 2.64 roughness 0.005 } }
  texture { pigment { rgb <0.9393939393939393, 0.9545454545454545, 1> filter 1 } finish { ambient 0 diffuse 0 } }
  texture { pigment { rgb <0.01, 0.01, 0.012> transmit 0.5 } finish { ambient 0 diffuse 0 emission 4 } }
  texture { pigment { rgb <0.1, 0.1, 0.11> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb <0.62, 0.63, 0.66> } } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.012, 0.008> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.52, 0.1, 0.05> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.16 } specular 0.16 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.045, 0.03, 0.006> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.33, 0.04> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.16 } specular 0.16 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.008, 0.025, 0.045> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.24, 0.42> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.16 } specular 0.16 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.05, 0.012, 0.008> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.52, 0.1, 0.05> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.16 } specular 0.16 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.045, 0.03, 0.006> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.33, 0.04> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.16 } specular 0.16 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.008, 0.025, 0.045> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.24, 0.42> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.16 } specular 0.16 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.05, 0.012, 0.008> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.52, 0.1, 0.05> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.16 } specular 0.16 roughness 0.0125 } }

#declare Material9 =
  texture { pigment { rgb <0.008, 0.025, 0.045> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.24, 0.42> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.16 } specular 0.16 roughness 0.0125 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <1.25, 0.5, 0.9>, 0.5 texture { Material1 } }
sphere { <1.33, 0.5, -1.1>, 0.5 texture { Material1 } }
sphere { <1.41, 0.5, -3.1>, 0.5 texture { Material1 } }
sphere { <1.49, 0.5, -5.6>, 0.5 texture { Material1 } }
sphere { <1.6, 0.5, -9.1>, 0.5 texture { Material1 } }
sphere { <1.8, 0.5, -15.1>, 0.5 texture { Material1 } }
sphere { <2.1, 0.5, -26.1>, 0.5 texture { Material1 } }
sphere { <-0.62, 0.6, 0.7>, 0.6 texture { Material2 } }
sphere { <-0.84, 0.5, -1.4>, 0.5 texture { Material3 } }
sphere { <-1.02, 0.5, -3.6>, 0.5 texture { Material4 } }
sphere { <-1.15, 0.5, -6.3>, 0.5 texture { Material5 } }
sphere { <-1.3, 0.5, -10.3>, 0.5 texture { Material6 } }
sphere { <-1.55, 0.5, -17.3>, 0.5 texture { Material7 } }
sphere { <-1.9, 0.5, -29.3>, 0.5 texture { Material8 } }
sphere { <0.3, 0.2, 1.45>, 0.2 texture { Material9 } }
