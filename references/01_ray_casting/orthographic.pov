// orthographic.scene, written by `course export`.
// povray +Iorthographic.pov +Oorthographic.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb 0 }

camera {
  orthographic
  location <9, 7, 11>
  direction <-0.5680749627880228, -0.44183608216846215, -0.6943138434075834>
  right <9.28748759043985, 0, -7.598853483087153>
  up <-2.5180857389545497, 8.073862210616175, -3.0776603476111157>
}


#declare Material0 =
  texture { pigment { checker rgb <0.81, 0.792, 0.7200000000000001> rgb <0.27, 0.25200000000000006, 0.234> scale 1 } finish { ambient 0 diffuse 0 emission 1 } }

#declare Material1 =
  texture { pigment { checker rgb <0.7200000000000001, 0.378, 0.27> rgb <0.405, 0.14400000000000002, 0.108> scale 1 } finish { ambient 0 diffuse 0 emission 1 } }

#declare Material2 =
  texture { pigment { checker rgb <0.36000000000000004, 0.54, 0.675> rgb <0.108, 0.234, 0.378> scale 1 } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
plane { <1, 0, 0>, 0 texture { Material1 } }
plane { <0, 0, 1>, 0 texture { Material2 } }
