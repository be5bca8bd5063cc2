// fresnel.scene, written by `course export`.
// povray +Ifresnel.pov +Ofresnel.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 9 adc_bailout 0 }
background { rgb <0.55, 0.68, 0.85> }

camera {
  perspective
  location <0, 1.4, 6.5>
  direction <0, -0.0995037190209989, -0.9950371902099892>
  right <0.8152818172230943, 0, 0>
  up <0, 0.6084267964792213, -0.060842679647922115>
}

light_source { <39405.520311955035, 78811.04062391007, 47286.624374346036> rgb 0.6 parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.09000000000000001, 0.08600000000000001, 0.08000000000000002> rgb <0.012, 0.013000000000000001, 0.016> scale 0.5 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.49500000000000005, 0.47300000000000003, 0.44000000000000006> transmit 0.5 rgb <0.066, 0.07150000000000001, 0.08800000000000001> transmit 0.5 scale 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.1 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.16, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.1 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.3, 0.55> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 1 filter 1 } finish { ambient 0 diffuse 0 reflection { rgb 0, rgb 1 fresnel } conserve_energy } }

#declare Material4 =
  texture { pigment { rgb 1 filter 1 } finish { ambient 0 diffuse 0 reflection { rgb 0, rgb 1 fresnel } conserve_energy } }

#declare Material5 =
  texture { pigment { rgb 1 filter 1 } finish { ambient 0 diffuse 0 reflection { rgb 0, rgb 1 fresnel } conserve_energy } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-0.85, 0.3, 1.7>, 0.3 texture { Material1 } }
sphere { <0.85, 0.3, 1.7>, 0.3 texture { Material2 } }
sphere { <-1.7, 0.8, 0>, 0.8 texture { Material3 } interior { ior 1.31 } }
sphere { <0, 0.8, -0.3>, 0.8 texture { Material4 } interior { ior 1.52 } }
sphere { <1.7, 0.8, 0>, 0.8 texture { Material5 } interior { ior 2.42 } }
