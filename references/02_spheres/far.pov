// far.scene, written by `course export`.
// povray +Ifar.pov +Ofar.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 0, 4000>
  direction <0, 0, -1>
  right <9.308422681083768e-05, 0, 0>
  up <0, 6.981317010812826e-05, 0>
}

light_source { <100000, 0, 0> rgb <0.5, 0, 0> parallel point_at 0 shadowless }
light_source { <-100000, 0, 0> rgb <-0.5, 0, 0> parallel point_at 0 shadowless }
light_source { <0, 100000, 0> rgb <0, 0.5, 0> parallel point_at 0 shadowless }
light_source { <0, -100000, 0> rgb <0, -0.5, 0> parallel point_at 0 shadowless }
light_source { <0, 0, 100000> rgb <0, 0, 0.5> parallel point_at 0 shadowless }
light_source { <0, 0, -100000> rgb <0, 0, -0.5> parallel point_at 0 shadowless }

#declare Normal = texture { pigment { rgb 1 } finish { ambient 0 diffuse 1 emission 0.5 } }

sphere { <0, 0.01, 0>, 0.08 texture { Normal } }
sphere { <-0.12, -0.04, 0.1>, 0.05 texture { Normal } }
sphere { <0.12, -0.04, 0.1>, 0.05 texture { Normal } }
sphere { <-0.06, 0.09, -0.2>, 0.03 texture { Normal } }
sphere { <0.06, 0.09, -0.2>, 0.03 texture { Normal } }
sphere { <0.02, -0.06, 0.3>, 0.03 texture { Normal } }
