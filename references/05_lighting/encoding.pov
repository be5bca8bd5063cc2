// encoding.scene, written by `course export`.
// povray +Iencoding.pov +Oencoding.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb 0.2 }

camera {
  perspective
  location <0, 0, 10>
  direction <0, 0, -1>
  right <0.6402100242136427, 0, 0>
  up <0, 0.48015751816023206, 0>
}

light_source { <-86874.44855261386, 39093.501848676235, 30406.056993414848> rgb 0.98 parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.95 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb 0.1225 } finish { ambient 0 diffuse 0 emission 1 } }

#declare Material2 =
  texture { pigment { rgb 0.245 } finish { ambient 0 diffuse 0 emission 1 } }

#declare Material3 =
  texture { pigment { rgb 0.3675 } finish { ambient 0 diffuse 0 emission 1 } }

#declare Material4 =
  texture { pigment { rgb 0.49 } finish { ambient 0 diffuse 0 emission 1 } }

#declare Material5 =
  texture { pigment { rgb 0.6125 } finish { ambient 0 diffuse 0 emission 1 } }

#declare Material6 =
  texture { pigment { rgb 0.735 } finish { ambient 0 diffuse 0 emission 1 } }

#declare Material7 =
  texture { pigment { rgb 0.8575 } finish { ambient 0 diffuse 0 emission 1 } }

#declare Material8 =
  texture { pigment { rgb 0.98 } finish { ambient 0 diffuse 0 emission 1 } }

sphere { <0, -0.75, 0>, 1.35 texture { Material0 } no_shadow }
polygon { 5, <-2.8, 1.1, 0>, <-2.1, 1.1, 0>, <-2.1, 1.8, 0>, <-2.8, 1.8, 0>, <-2.8, 1.1, 0> texture { Material1 } no_shadow }
polygon { 5, <-2.1, 1.1, 0>, <-1.4, 1.1, 0>, <-1.4, 1.8, 0>, <-2.1, 1.8, 0>, <-2.1, 1.1, 0> texture { Material2 } no_shadow }
polygon { 5, <-1.4, 1.1, 0>, <-0.7, 1.1, 0>, <-0.7, 1.8, 0>, <-1.4, 1.8, 0>, <-1.4, 1.1, 0> texture { Material3 } no_shadow }
polygon { 5, <-0.7, 1.1, 0>, <0, 1.1, 0>, <0, 1.8, 0>, <-0.7, 1.8, 0>, <-0.7, 1.1, 0> texture { Material4 } no_shadow }
polygon { 5, <0, 1.1, 0>, <0.7, 1.1, 0>, <0.7, 1.8, 0>, <0, 1.8, 0>, <0, 1.1, 0> texture { Material5 } no_shadow }
polygon { 5, <0.7, 1.1, 0>, <1.4, 1.1, 0>, <1.4, 1.8, 0>, <0.7, 1.8, 0>, <0.7, 1.1, 0> texture { Material6 } no_shadow }
polygon { 5, <1.4, 1.1, 0>, <2.1, 1.1, 0>, <2.1, 1.8, 0>, <1.4, 1.8, 0>, <1.4, 1.1, 0> texture { Material7 } no_shadow }
polygon { 5, <2.1, 1.1, 0>, <2.8, 1.1, 0>, <2.8, 1.8, 0>, <2.1, 1.8, 0>, <2.1, 1.1, 0> texture { Material8 } no_shadow }
