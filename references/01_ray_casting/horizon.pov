// horizon.scene, written by `course export`.
// povray +Ihorizon.pov +Ohorizon.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.2, 0.42, 0.78> }

camera {
  perspective
  location <0, 1.5, 0>
  direction <0, -0.12403473458920847, -0.9922778767136677>
  right <1.5396007178390019, 0, 0>
  up <0, 1.1457837984630928, -0.1432229748078866>
}


#declare Material0 =
  texture { pigment { checker rgb <0.855, 0.8280000000000001, 0.7200000000000001> rgb <0.036000000000000004, 0.117, 0.09000000000000001> scale 1 } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
