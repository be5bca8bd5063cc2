// surfaces.scene, written by `course export`.
// povray +Isurfaces.pov +Osurfaces.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 3 adc_bailout 0 }
background { rgb <0.62, 0.68, 0.76> }

camera {
  perspective
  location <1.2, 3.4, 9>
  direction <-0.12687052322453285, -0.2801724054541767, -0.9515289241839964>
  right <0.8081300841507715, 0, -0.10775067788676954>
  up <-0.02264157495964079, 0.5869721508404988, -0.1698118121973059>
}

light_source { <-4, 8, 6> rgb <0.66, 0.64, 0.6> }
light_source { <69673.30142916176, 62705.971286245585, 34836.65071458088> rgb <0.16, 0.17, 0.2> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb <0.07, 0.07, 0.08> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.4, 0.16> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.025 } }

#declare Material1 =
  texture { pigment { rgb <0.07, 0.07, 0.08> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.36, 0.5> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.025 } }

#declare Material2 =
  texture { pigment { rgb <0.07, 0.07, 0.08> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.14> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.025 } }

#declare Material3 =
  texture { pigment { rgb <0.07, 0.07, 0.08> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.42, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.025 } }

#declare Material4 =
  texture { pigment { checker rgb <0.1, 0.1, 0.11> rgb <0.08000000000000002, 0.07800000000000001, 0.08360000000000001> scale 0.7 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.4, 0.36, 0.33> transmit 0.5 rgb <0.32000000000000006, 0.2808, 0.2508> transmit 0.5 scale 0.7 } finish { ambient 0 diffuse 2 } }

isosurface { function { 4 * (2.618033988749895 * pow(x, 2) - pow(y, 2)) * (2.618033988749895 * pow(y, 2) - pow(z, 2)) * (2.618033988749895 * pow(z, 2) - pow(x, 2)) - 4.23606797749979 * pow(pow(x, 2) + pow(y, 2) + pow(z, 2) - 1, 2) } contained_by { box { <-1.28, -1.28, -1.28>, <1.28, 1.28, 1.28> } } accuracy 2.56e-07 max_gradient 405.2 open matrix <0.9702957262759965, 0, -0.24192189559966773, 0, 1, 0, 0.24192189559966773, 0, 0.9702957262759965, -1.75, 1.28, -0.2> texture { Material0 } }
isosurface { function { 0.6 - exp((-4) * (pow(x, 2) + pow(y, 2) + pow(z, 2))) - 0.6 * exp((-7) * (pow(x - 0.15, 2) + pow(y - 0.85, 2) + pow(z, 2))) } contained_by { box { <-0.44999999999999996, -0.44375, -0.45>, <0.44999999999999996, 0.9625, 0.45000000000000007> } } accuracy 1.41e-07 max_gradient 2.40829 open matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 1.1, 0.62, 1.1> texture { Material1 } }
quadric { <1, -0.6, 1>, <0, 0, 0>, <0, 0, 0>, -0.16 clipped_by { box { <-0.9, -0.9, -0.9>, <0.9, 0.9, 0.9> } } matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 2.1, 0.9, -1.6> texture { Material2 } }
quadric { <0, 0, 0>, <0, 1, 0>, <0, -0.9, 0>, 0 clipped_by { box { <-0.55, -0.4, -0.55>, <0.55, 0.4, 0.55> } } matrix <0.8191520442889918, 0, -0.573576436351046, 0, 1, 0, 0.573576436351046, 0, 0.8191520442889918, -0.1, 0.42, 2.3> texture { Material3 } }
plane { <0.009997500937109546, 0.9997500937109545, 0.01999500187421909>, -0.009997500937109546 texture { Material4 } }
