// patterns.scene, written by `course export`.
// povray +Ipatterns.pov +Opatterns.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.5, 0.58, 0.66> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <0, -0.26195063167457383, -0.9650812745905352>
  right <0.789902653232214, 0, 0>
  up <0, 0.571740194537843, -0.1551866242317002>
}

light_source { <-4, 6, 5> rgb <0.85, 0.83, 0.8> }
light_source { <75809.80435789035, 53066.863050523236, 37904.90217894517> rgb <0.16, 0.17, 0.2> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.1 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.48, 0.45> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1First =
  texture { pigment { rgb <0.09000000000000001, 0.025, 0.020000000000000004> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7200000000000001, 0.2, 0.16000000000000003> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1Second =
  texture { pigment { rgb <0.095, 0.09000000000000001, 0.08000000000000002> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.76, 0.7200000000000001, 0.6400000000000001> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 = texture { function { floor((x / 0.21 + 1e-9)) - 2 * floor(floor((x / 0.21 + 1e-9)) / 2) } texture_map { [0 Material1First] [1 Material1Second] } }

#declare Material2First =
  texture { pigment { rgb <0.020000000000000004, 0.034999999999999996, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16000000000000003, 0.27999999999999997, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2Second =
  texture { pigment { rgb <0.09000000000000001, 0.08800000000000001, 0.08000000000000002> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7200000000000001, 0.7040000000000001, 0.6400000000000001> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 = texture { function { floor((sqrt(x * x + z * z) / 0.17 + 1e-9)) - 2 * floor(floor((sqrt(x * x + z * z) / 0.17 + 1e-9)) / 2) } texture_map { [0 Material2First] [1 Material2Second] } }

#declare Material3First =
  texture { pigment { rgb <0.015, 0.04000000000000001, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.32000000000000006, 0.24> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3Second =
  texture { pigment { rgb <0.095, 0.09000000000000001, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.76, 0.7200000000000001, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 = texture { function { (y / 0.53 + 1e-9) - floor((y / 0.53 + 1e-9)) } texture_map { [0 Material3First] [1 Material3Second] } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.81, 0>, 0.8 texture { Material1 } }
box { <-0.62, 0.01, -0.62>, <0.62, 1.25, 0.62> matrix <0.9063077870366499, 0, -0.42261826174069944, 0, 1, 0, 0.42261826174069944, 0, 0.9063077870366499, 0, 0, 0> texture { Material2 } }
cone { <1.9, 0.01, 0>, 0.8, <1.9, 1.6, 0>, 0.1 texture { Material3 } }
