// lambert.scene, written by `course export`.
// povray +Ilambert.pov +Olambert.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 1.7, 6.2>
  direction <0, -0.24253562503633297, -0.9701425001453319>
  right <1.0774032688937514, 0, 0>
  up <0, 0.783926025712003, -0.19598150642800075>
}

light_source { <2.5, 4, 3.5> rgb <0.72, 0.7, 0.66> }
light_source { <-78811.04062391007, 39405.520311955035, -47286.624374346036> rgb <0.06, 0.09, 0.18> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb <0.012, 0.012, 0.014> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.85, 0.82, 0.75> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.012, 0.012, 0.014> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.22, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.012, 0.012, 0.014> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.35, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb <0.012, 0.012, 0.014> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.62, 0.25> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material4 =
  texture { pigment { checker rgb <0.012, 0.012, 0.014> rgb <0.006600000000000001, 0.006600000000000001, 0.007700000000000001> scale 1 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 1 } finish { ambient 0 diffuse 2 } }

sphere { <-1.15, 0.25, 0>, 1.05 texture { Material0 } no_shadow }
sphere { <0.55, -0.3, 1.5>, 0.5 texture { Material1 } no_shadow }
sphere { <-0.45, -0.5, 2.1>, 0.3 texture { Material2 } no_shadow }
polygon { 5, <-1, -1, 1>, <1, -1, 1>, <1, 1, 1>, <-1, 1, 1>, <-1, -1, 1> matrix <0.7063580742871416, 0, -0.3755772502287127, 0, 0.8, 0, 0.3755772502287127, 0, 0.7063580742871416, 1.55, 0, -0.3> texture { Material3 } no_shadow }
polygon { 5, <1, -1, -1>, <-1, -1, -1>, <-1, 1, -1>, <1, 1, -1>, <1, -1, -1> matrix <0.7063580742871416, 0, -0.3755772502287127, 0, 0.8, 0, 0.3755772502287127, 0, 0.7063580742871416, 1.55, 0, -0.3> texture { Material3 } no_shadow }
polygon { 5, <1, -1, 1>, <1, -1, -1>, <1, 1, -1>, <1, 1, 1>, <1, -1, 1> matrix <0.7063580742871416, 0, -0.3755772502287127, 0, 0.8, 0, 0.3755772502287127, 0, 0.7063580742871416, 1.55, 0, -0.3> texture { Material3 } no_shadow }
polygon { 5, <-1, -1, -1>, <-1, -1, 1>, <-1, 1, 1>, <-1, 1, -1>, <-1, -1, -1> matrix <0.7063580742871416, 0, -0.3755772502287127, 0, 0.8, 0, 0.3755772502287127, 0, 0.7063580742871416, 1.55, 0, -0.3> texture { Material3 } no_shadow }
polygon { 5, <-1, 1, 1>, <1, 1, 1>, <1, 1, -1>, <-1, 1, -1>, <-1, 1, 1> matrix <0.7063580742871416, 0, -0.3755772502287127, 0, 0.8, 0, 0.3755772502287127, 0, 0.7063580742871416, 1.55, 0, -0.3> texture { Material3 } no_shadow }
polygon { 5, <-1, -1, -1>, <1, -1, -1>, <1, -1, 1>, <-1, -1, 1>, <-1, -1, -1> matrix <0.7063580742871416, 0, -0.3755772502287127, 0, 0.8, 0, 0.3755772502287127, 0, 0.7063580742871416, 1.55, 0, -0.3> texture { Material3 } no_shadow }
plane { <0, 1, 0>, -0.8 texture { Material4 } no_shadow }
