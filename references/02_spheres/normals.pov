// normals.scene, written by `course export`.
// povray +Inormals.pov +Onormals.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 1.2, 7>
  direction <0, -0.1552378339921335, -0.9878771254044861>
  right <1.0236374267611088, 0, 0>
  up <0, 0.758420998953907, -0.1191804426927568>
}

light_source { <100000, 0, 0> rgb <0.5, 0, 0> parallel point_at 0 shadowless }
light_source { <-100000, 0, 0> rgb <-0.5, 0, 0> parallel point_at 0 shadowless }
light_source { <0, 100000, 0> rgb <0, 0.5, 0> parallel point_at 0 shadowless }
light_source { <0, -100000, 0> rgb <0, -0.5, 0> parallel point_at 0 shadowless }
light_source { <0, 0, 100000> rgb <0, 0, 0.5> parallel point_at 0 shadowless }
light_source { <0, 0, -100000> rgb <0, 0, -0.5> parallel point_at 0 shadowless }

#declare Normal = texture { pigment { rgb 1 } finish { ambient 0 diffuse 1 emission 0.5 } }

sphere { <0, 0.3, 0>, 1.3 texture { Normal } }
sphere { <-2.1, -0.2, -0.6>, 0.8 texture { Normal } }
sphere { <2.1, -0.2, -0.6>, 0.8 texture { Normal } }
sphere { <-1.1, -0.65, 1.3>, 0.35 texture { Normal } }
sphere { <1.1, -0.65, 1.3>, 0.35 texture { Normal } }
sphere { <0, -0.8, 1.7>, 0.2 texture { Normal } }
sphere { <-1.5, 1.6, -1.2>, 0.3 texture { Normal } }
sphere { <1.5, 1.6, -1.2>, 0.3 texture { Normal } }
sphere { <0, 0.9, 1.05>, 0.25 texture { Normal } }
sphere { <0, -101, 0>, 100 texture { Normal } }
