// whitted.scene, written by `course export`.
// povray +Iwhitted.pov +Owhitted.png +W512 +H512 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 9 adc_bailout 0 }
background { rgb <0.18, 0.33, 0.66> }

camera {
  perspective
  location <0, 2.3, 7>
  direction <0, -0.13448147184361486, -0.9909161083213729>
  right <0.7279404685324047, 0, 0>
  up <0, 0.7213279361677672, -0.09789450562276839>
}

light_source { <-29319.773580418685, 83770.7816583391, 46073.92991208651> rgb 0.72 parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.1, 0.09000000000000001, 0.012> rgb <0.09000000000000001, 0.007000000000000001, 0.004> scale 1 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.75, 0.675, 0.09> transmit 0.5 rgb <0.675, 0.052500000000000005, 0.03> transmit 0.5 scale 1 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.12 } finish { ambient 0 diffuse 1 reflection { rgb 0.65 } specular 0.65 roughness 0.008333333333333333 } }

#declare Material2 =
  texture { pigment { rgb 0.88 filter 1 } finish { ambient 0 diffuse 0 reflection { rgb 0.1 } specular 0.1 roughness 0.008333333333333333 } }

#declare Material3 =
  texture { pigment { rgb 1 filter 1 } finish { ambient 0 diffuse 0 } }

polygon { 5, <-6, 0, 5>, <6, 0, 5>, <6, 0, -20>, <-6, 0, -20>, <-6, 0, 5> texture { Material0 } }
sphere { <1.05, 1.05, -1.1>, 1 texture { Material1 } }
sphere { <-0.35, 1.75, 1.5>, 0.95 texture { Material2 } interior { ior 1.5 } }
sphere { <-0.35, 1.75, 1.5>, 0.88 texture { Material3 } interior { ior 1 } }
