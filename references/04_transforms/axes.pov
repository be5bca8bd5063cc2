// axes.scene, written by `course export`.
// povray +Iaxes.pov +Oaxes.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.93, 0.93, 0.9> }

camera {
  orthographic
  location <0, 0, 10>
  direction <0, 0, -1>
  right <10, 0, 0>
  up <0, 7.5, 0>
}


#declare Material0 =
  texture { pigment { rgb 0.6 } finish { ambient 0 diffuse 0 emission 1 } }

#declare Material1 =
  texture { pigment { rgb <0.1, 0.2, 0.55> } finish { ambient 0 diffuse 0 emission 1 } }

#declare Material2 =
  texture { pigment { rgb <0.72, 0.3, 0.05> } finish { ambient 0 diffuse 0 emission 1 } }

#declare Material3 =
  texture { pigment { rgb <0.6, 0.1, 0.25> } finish { ambient 0 diffuse 0 emission 1 } }

#declare Material4 =
  texture { pigment { rgb <0.1, 0.2, 0.55> } finish { ambient 0 diffuse 0 emission 1 } }

#declare Material5 =
  texture { pigment { rgb <0.72, 0.3, 0.05> } finish { ambient 0 diffuse 0 emission 1 } }

#declare Material6 =
  texture { pigment { rgb <0.05, 0.4, 0.2> } finish { ambient 0 diffuse 0 emission 1 } }

sphere { <0, 0, 0>, 1 matrix <1.4, 0, 0, 0, 0.02, 0, 0, 0, 0.02, -3.3, 1.4, -1> texture { Material0 } }
sphere { <0, 0, 0>, 1 matrix <0.02, 0, 0, 0, 1.4, 0, 0, 0, 0.02, -3.3, 1.4, -1> texture { Material0 } }
sphere { <0, 0, 0>, 1 matrix <1.4, 0, 0, 0, 0.02, 0, 0, 0, 0.02, 0, 1.4, -1> texture { Material0 } }
sphere { <0, 0, 0>, 1 matrix <0.02, 0, 0, 0, 1.4, 0, 0, 0, 0.02, 0, 1.4, -1> texture { Material0 } }
sphere { <0, 0, 0>, 1 matrix <1.4, 0, 0, 0, 0.02, 0, 0, 0, 0.02, 3.3, 1.4, -1> texture { Material0 } }
sphere { <0, 0, 0>, 1 matrix <0.02, 0, 0, 0, 1.4, 0, 0, 0, 0.02, 3.3, 1.4, -1> texture { Material0 } }
sphere { <0, 0, 0>, 1 matrix <1.4, 0, 0, 0, 0.02, 0, 0, 0, 0.02, -3.3, -2, -1> texture { Material0 } }
sphere { <0, 0, 0>, 1 matrix <0.02, 0, 0, 0, 1.4, 0, 0, 0, 0.02, -3.3, -2, -1> texture { Material0 } }
sphere { <0, 0, 0>, 1 matrix <1.4, 0, 0, 0, 0.02, 0, 0, 0, 0.02, 0, -2, -1> texture { Material0 } }
sphere { <0, 0, 0>, 1 matrix <0.02, 0, 0, 0, 1.4, 0, 0, 0, 0.02, 0, -2, -1> texture { Material0 } }
sphere { <0, 0, 0>, 1 matrix <1.4, 0, 0, 0, 0.02, 0, 0, 0, 0.02, 3.3, -2, -1> texture { Material0 } }
sphere { <0, 0, 0>, 1 matrix <0.02, 0, 0, 0, 1.4, 0, 0, 0, 0.02, 3.3, -2, -1> texture { Material0 } }
polygon { 11, <0, 0, 0>, <0.3, 0, 0>, <0.3, 0.6, 0>, <0.8, 0.6, 0>, <0.8, 0.86, 0>, <0.3, 0.86, 0>, <0.3, 1.14, 0>, <1, 1.14, 0>, <1, 1.4, 0>, <0, 1.4, 0>, <0, 0, 0> matrix <0.766044443118978, 0.6427876096865393, 0, -0.6427876096865393, 0.766044443118978, 0, 0, 0, 1, -3.3, 1.4, 0> texture { Material1 } }
sphere { <1.1, 0.2, 0>, 0.2 matrix <0.766044443118978, 0.6427876096865393, 0, -0.6427876096865393, 0.766044443118978, 0, 0, 0, 1, -3.3, 1.4, 0> texture { Material1 } }
polygon { 11, <0, 0, 0>, <0.3, 0, 0>, <0.3, 0.6, 0>, <0.8, 0.6, 0>, <0.8, 0.86, 0>, <0.3, 0.86, 0>, <0.3, 1.14, 0>, <1, 1.14, 0>, <1, 1.4, 0>, <0, 1.4, 0>, <0, 0, 0> matrix <0.766044443118978, 0.6427876096865393, 0, -0.6427876096865393, 0.766044443118978, 0, 0, 0, 1, 0.6, 1.4, 0> texture { Material2 } }
sphere { <1.1, 0.2, 0>, 0.2 matrix <0.766044443118978, 0.6427876096865393, 0, -0.6427876096865393, 0.766044443118978, 0, 0, 0, 1, 0.6, 1.4, 0> texture { Material2 } }
polygon { 11, <0, 0, 0>, <0.3, 0, 0>, <0.3, 0.6, 0>, <0.8, 0.6, 0>, <0.8, 0.86, 0>, <0.3, 0.86, 0>, <0.3, 1.14, 0>, <1, 1.14, 0>, <1, 1.4, 0>, <0, 1.4, 0>, <0, 0, 0> matrix <0.766044443118978, 0.6427876096865393, 0, -0.6427876096865393, 0.766044443118978, 0, 0, 0, 1, 3.7596266658713864, 1.7856725658119235, 0> texture { Material3 } }
sphere { <1.1, 0.2, 0>, 0.2 matrix <0.766044443118978, 0.6427876096865393, 0, -0.6427876096865393, 0.766044443118978, 0, 0, 0, 1, 3.7596266658713864, 1.7856725658119235, 0> texture { Material3 } }
polygon { 11, <0, 0, 0>, <0.3, 0, 0>, <0.3, 0.6, 0>, <0.8, 0.6, 0>, <0.8, 0.86, 0>, <0.3, 0.86, 0>, <0.3, 1.14, 0>, <1, 1.14, 0>, <1, 1.4, 0>, <0, 1.4, 0>, <0, 0, 0> matrix <1.225671108990365, 0.5142300877492314, 0, -1.0284601754984628, 0.6128355544951825, 0, 0, 0, 1, -3.3, -2, 0> texture { Material4 } }
sphere { <1.1, 0.2, 0>, 0.2 matrix <1.225671108990365, 0.5142300877492314, 0, -1.0284601754984628, 0.6128355544951825, 0, 0, 0, 1, -3.3, -2, 0> texture { Material4 } }
polygon { 11, <0, 0, 0>, <0.3, 0, 0>, <0.3, 0.6, 0>, <0.8, 0.6, 0>, <0.8, 0.86, 0>, <0.3, 0.86, 0>, <0.3, 1.14, 0>, <1, 1.14, 0>, <1, 1.4, 0>, <0, 1.4, 0>, <0, 0, 0> matrix <1.225671108990365, 1.0284601754984628, 0, -0.5142300877492314, 0.6128355544951825, 0, 0, 0, 1, 0, -2, 0> texture { Material5 } }
sphere { <1.1, 0.2, 0>, 0.2 matrix <1.225671108990365, 1.0284601754984628, 0, -0.5142300877492314, 0.6128355544951825, 0, 0, 0, 1, 0, -2, 0> texture { Material5 } }
polygon { 11, <0, 0, 0>, <0.3, 0, 0>, <0.3, 0.6, 0>, <0.8, 0.6, 0>, <0.8, 0.86, 0>, <0.3, 0.86, 0>, <0.3, 1.14, 0>, <1, 1.14, 0>, <1, 1.4, 0>, <0, 1.4, 0>, <0, 0, 0> matrix <-1, 0, 0, 0, 1, 0, 0, 0, 1, 3.3, -2, 0> texture { Material6 } }
sphere { <1.1, 0.2, 0>, 0.2 matrix <-1, 0, 0, 0, 1, 0, 0, 0, 1, 3.3, -2, 0> texture { Material6 } }
