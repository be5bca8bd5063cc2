// tubes.scene, written by `course export`.
// povray +Itubes.pov +Otubes.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.4, 6>
  direction <0, -0.3579360116324523, -0.9337461173020496>
  right <0.9705872913765395, 0, 0>
  up <0, 0.6797115861191677, -0.2605561080123476>
}

light_source { <100000, 0, 0> rgb <0.5, 0, 0> parallel point_at 0 shadowless }
light_source { <-100000, 0, 0> rgb <-0.5, 0, 0> parallel point_at 0 shadowless }
light_source { <0, 100000, 0> rgb <0, 0.5, 0> parallel point_at 0 shadowless }
light_source { <0, -100000, 0> rgb <0, -0.5, 0> parallel point_at 0 shadowless }
light_source { <0, 0, 100000> rgb <0, 0, 0.5> parallel point_at 0 shadowless }
light_source { <0, 0, -100000> rgb <0, 0, -0.5> parallel point_at 0 shadowless }

#declare Normal = texture { pigment { rgb 1 } finish { ambient 0 diffuse 1 emission 0.5 } }

cylinder { <-1.7, -0.6, 1.2>, <-1.2, 0.4, -1.4>, 0.75 open texture { Normal } }
cylinder { <-1.7, -0.6, 1.2>, <-1.2, 0.4, -1.4>, 0.6 open texture { Normal } }
cone { <0.9, -0.9, 0.2>, 0.25, <1.2, 1.1, 0.3>, 1.15 open texture { Normal } }
cone { <0.9, -0.9, 0.2>, 0.18, <1.2, 1.1, 0.3>, 1.05 open texture { Normal } }
cone { <-0.25, -0.9, 1.7>, 0.55, <-0.1, 0.5, 1.6>, 0 open texture { Normal } }
cone { <-0.5, 1.9, -0.9>, 0, <-0.2, 0.9, -0.2>, 0.7 open texture { Normal } }
cylinder { <2.3, -0.9, -0.8>, <2.3, -0.5, -0.8>, 0.5 open texture { Normal } }
cylinder { <2.3, -0.5, -0.8>, <2.3, 0.1, -0.8>, 0.35 open texture { Normal } }
disc { <0, -0.9, 0>, <0, 1, 0>, 4 texture { Normal } }
