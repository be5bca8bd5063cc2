// columns.scene, written by `course export`.
// povray +Icolumns.pov +Ocolumns.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.42, 0.58, 0.8> }

camera {
  perspective
  location <6.5, 2.1, 11>
  direction <-0.4847801184246384, -0.027815252696495655, -0.8741936561755775>
  right <0.7577404834213642, 0, -0.4202015408063928>
  up <-0.008766009030739985, 0.649587957261533, -0.015807557268547517>
}

light_source { <55296.67538733549, 71095.72549800278, 43447.387804335034> rgb <0.62, 0.58, 0.5> parallel point_at 0 }
light_source { <-61357.19910778964, 38348.24944236852, 69026.84899626333> rgb <0.1, 0.11, 0.14> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb <0.13, 0.14, 0.17> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.36, 0.4, 0.28> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.13, 0.14, 0.17> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.62, 0.58, 0.5> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.13, 0.14, 0.17> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.32, 0.24> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb <0.13, 0.14, 0.17> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.66, 0.62, 0.55> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material4 =
  texture { pigment { rgb <0.13, 0.14, 0.17> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.42, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0.009997500937109546, 0.9997500937109545, 0.01999500187421909>, -0.6098475571636822 texture { Material0 } }
box { <-3.9, -0.6, -2.4>, <3.9, -0.41, 2.4> texture { Material1 } }
box { <-3.65, -0.41, -2.15>, <3.65, -0.205, 2.15> texture { Material1 } }
box { <-3.4, -0.205, -1.9>, <3.4, 0, 1.9> texture { Material1 } }
box { <-3.35, 2.92, -1.85>, <3.35, 3.25, 1.85> texture { Material1 } }
box { <-3.5, 3.25, -2>, <3.5, 3.42, 2> texture { Material1 } }
triangle { <-3.5, 3.42, 2>, <3.5, 3.42, 2>, <0, 4.45, 2> texture { Material1 } }
triangle { <-3.5, 3.42, -2>, <0, 4.45, -2>, <3.5, 3.42, -2> texture { Material1 } }
polygon { 5, <3.5, 3.42, 2>, <3.5, 3.42, -2>, <0, 4.45, -2>, <0, 4.45, 2>, <3.5, 3.42, 2> texture { Material2 } }
polygon { 5, <-3.5, 3.42, 2>, <0, 4.45, 2>, <0, 4.45, -2>, <-3.5, 3.42, -2>, <-3.5, 3.42, 2> texture { Material2 } }
cylinder { <0, 0, 0>, <0, 0.14, 0>, 0.34 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, -2.9, 0, 1.45> texture { Material3 } }
cone { <0, 0.14, 0>, 0.28, <0, 2.6, 0>, 0.22 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, -2.9, 0, 1.45> texture { Material3 } }
cone { <0, 2.6, 0>, 0.22, <0, 2.76, 0>, 0.36 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, -2.9, 0, 1.45> texture { Material3 } }
box { <-0.38, 2.76, -0.38>, <0.38, 2.92, 0.38> matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, -2.9, 0, 1.45> texture { Material3 } }
cylinder { <0, 0, 0>, <0, 0.14, 0>, 0.34 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, -1.45, 0, 1.45> texture { Material3 } }
cone { <0, 0.14, 0>, 0.28, <0, 2.6, 0>, 0.22 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, -1.45, 0, 1.45> texture { Material3 } }
cone { <0, 2.6, 0>, 0.22, <0, 2.76, 0>, 0.36 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, -1.45, 0, 1.45> texture { Material3 } }
box { <-0.38, 2.76, -0.38>, <0.38, 2.92, 0.38> matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, -1.45, 0, 1.45> texture { Material3 } }
cylinder { <0, 0, 0>, <0, 0.14, 0>, 0.34 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1.45> texture { Material3 } }
cone { <0, 0.14, 0>, 0.28, <0, 2.6, 0>, 0.22 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1.45> texture { Material3 } }
cone { <0, 2.6, 0>, 0.22, <0, 2.76, 0>, 0.36 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1.45> texture { Material3 } }
box { <-0.38, 2.76, -0.38>, <0.38, 2.92, 0.38> matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1.45> texture { Material3 } }
cylinder { <0, 0, 0>, <0, 0.14, 0>, 0.34 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 1.45, 0, 1.45> texture { Material3 } }
cone { <0, 0.14, 0>, 0.28, <0, 2.6, 0>, 0.22 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 1.45, 0, 1.45> texture { Material3 } }
cone { <0, 2.6, 0>, 0.22, <0, 2.76, 0>, 0.36 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 1.45, 0, 1.45> texture { Material3 } }
box { <-0.38, 2.76, -0.38>, <0.38, 2.92, 0.38> matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 1.45, 0, 1.45> texture { Material3 } }
cylinder { <0, 0, 0>, <0, 0.14, 0>, 0.34 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 2.9, 0, 1.45> texture { Material3 } }
cone { <0, 0.14, 0>, 0.28, <0, 2.6, 0>, 0.22 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 2.9, 0, 1.45> texture { Material3 } }
cone { <0, 2.6, 0>, 0.22, <0, 2.76, 0>, 0.36 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 2.9, 0, 1.45> texture { Material3 } }
box { <-0.38, 2.76, -0.38>, <0.38, 2.92, 0.38> matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 2.9, 0, 1.45> texture { Material3 } }
cylinder { <0, 0, 0>, <0, 0.14, 0>, 0.34 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 2.9, 0, 0> texture { Material3 } }
cone { <0, 0.14, 0>, 0.28, <0, 2.6, 0>, 0.22 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 2.9, 0, 0> texture { Material3 } }
cone { <0, 2.6, 0>, 0.22, <0, 2.76, 0>, 0.36 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 2.9, 0, 0> texture { Material3 } }
box { <-0.38, 2.76, -0.38>, <0.38, 2.92, 0.38> matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 2.9, 0, 0> texture { Material3 } }
cylinder { <0, 0, 0>, <0, 0.14, 0>, 0.34 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 2.9, 0, -1.45> texture { Material3 } }
cone { <0, 0.14, 0>, 0.28, <0, 2.6, 0>, 0.22 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 2.9, 0, -1.45> texture { Material3 } }
cone { <0, 2.6, 0>, 0.22, <0, 2.76, 0>, 0.36 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 2.9, 0, -1.45> texture { Material3 } }
box { <-0.38, 2.76, -0.38>, <0.38, 2.92, 0.38> matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 2.9, 0, -1.45> texture { Material3 } }
box { <-2.2, 0, -1.5>, <1.9, 2.92, 0.4> texture { Material4 } }
