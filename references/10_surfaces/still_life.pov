// still_life.scene, written by `course export`.
// povray +Istill_life.pov +Ostill_life.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.5, 0.6, 0.72> }

camera {
  perspective
  location <0.6, 2.7, 6.2>
  direction <-0.091364955501897, -0.3167318457399096, -0.944104540186269>
  right <0.8114907678243968, 0, -0.07853136462816743>
  up <-0.018655038050364985, 0.5799803496427577, -0.1927687265204382>
}

light_source { <-3, 6, 4> rgb <0.375, 0.36, 0.33> fade_distance 10 fade_power 2 }
light_source { <70710.67811865475, 56568.5424949238, 42426.40687119285> rgb <0.18, 0.2, 0.24> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.1, 0.1, 0.11> rgb <0.072, 0.06999999999999999, 0.0726> scale 0.4 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.42, 0.3, 0.2> transmit 0.5 rgb <0.3024, 0.21, 0.132> transmit 0.5 scale 0.4 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.1, 0.1, 0.11> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.34, 0.5> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb <0.1, 0.1, 0.11> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.2, 0.14> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb <0.1, 0.1, 0.11> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.44, 0.16> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 0.016666666666666666 } }

#declare Material4 =
  texture { pigment { rgb <0.1, 0.1, 0.11> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.3, 0.46, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 0.016666666666666666 } }

#declare Material5 =
  texture { pigment { rgb <0.1, 0.1, 0.11> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.46, 0.42> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.25 } specular 0.25 roughness 0.016666666666666666 } }

#declare Material6 =
  texture { pigment { rgb <0.1, 0.1, 0.11> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.3, 0.34> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 0.016666666666666666 } }

#declare Material7 =
  texture { pigment { rgb <0.1, 0.1, 0.11> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.62, 0.5, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 0.016666666666666666 } }

box { <-2.7, -0.23, -1.9>, <2.7, -0.01, 1.9> texture { Material0 } }
box { <-0.5, 0, -0.5>, <0.5, 1, 0.5> matrix <0.882947592858927, 0, -0.4694715627858908, 0, 1, 0, 0.4694715627858908, 0, 0.882947592858927, -1.3, -0.01, -0.3> texture { Material1 } }
cylinder { <0.35, -0.01, -0.5>, <0.35, 1.5, -0.5>, 0.42 texture { Material2 } }
cone { <1.45, -0.01, 0.1>, 0.55, <1.45, 1.35, 0.1>, 0 texture { Material3 } }
cone { <-0.35, -0.01, 0.85>, 0.42, <-0.35, 0.5, 0.85>, 0.2 texture { Material4 } }
disc { <0.35, 1.508, -0.5>, <0, 1, 0>, 0.55 texture { Material5 } }
cylinder { <0.7, 0.12, 0.95>, <1.35, 0.12, 1.2>, 0.13 texture { Material6 } }
cone { <0.7, 0.12, 0.95>, 0.13, <0.47, 0.12, 0.86>, 0 texture { Material7 } }
