// directions.scene, written by `course export`.
// povray +Idirections.pov +Odirections.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.5, 0.5, 0> }

camera {
  perspective
  location <0, 0, 0>
  direction <0, 0, -1>
  right <2.666666666666666, 0, 0>
  up <0, 1.9999999999999998, 0>
}

light_source { <100000, 0, 0> rgb <-0.5, 0, 0> parallel point_at 0 shadowless }
light_source { <-100000, 0, 0> rgb <0.5, 0, 0> parallel point_at 0 shadowless }
light_source { <0, 100000, 0> rgb <0, -0.5, 0> parallel point_at 0 shadowless }
light_source { <0, -100000, 0> rgb <0, 0.5, 0> parallel point_at 0 shadowless }
light_source { <0, 0, 100000> rgb <0, 0, -0.5> parallel point_at 0 shadowless }
light_source { <0, 0, -100000> rgb <0, 0, 0.5> parallel point_at 0 shadowless }

sphere { <0, 0, 0>, 1 texture { pigment { rgb 1 } finish { ambient 0 diffuse 1 emission 0.5 } } }
