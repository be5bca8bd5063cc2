// far.scene, written by `course export`.
// povray +Ifar.pov +Ofar.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <1200, 900, 3700>
  direction <-0.30056408699137455, -0.22542306524353092, -0.9267392682234049>
  right <0.0016601972481343826, 0, -0.0005384423507462862>
  up <-9.103299387162017e-05, 0.0012753048122940865, -0.00028068506443749557>
}

light_source { <100000, 0, 0> rgb <0.5, 0, 0> parallel point_at 0 shadowless }
light_source { <-100000, 0, 0> rgb <-0.5, 0, 0> parallel point_at 0 shadowless }
light_source { <0, 100000, 0> rgb <0, 0.5, 0> parallel point_at 0 shadowless }
light_source { <0, -100000, 0> rgb <0, -0.5, 0> parallel point_at 0 shadowless }
light_source { <0, 0, 100000> rgb <0, 0, 0.5> parallel point_at 0 shadowless }
light_source { <0, 0, -100000> rgb <0, 0, -0.5> parallel point_at 0 shadowless }

#declare Normal = texture { pigment { rgb 1 } finish { ambient 0 diffuse 1 emission 0.5 } }

cylinder { <-1.9, -1.2, 0>, <-1.9, 1.2, 0>, 0.35 texture { Normal } }
cylinder { <-1, -1.2, 0.2>, <-0.9, 1.2, -0.2>, 0.1 texture { Normal } }
cone { <-0.3, -1.2, 0>, 0.5, <-0.1, 1.2, 0>, 0.02 texture { Normal } }
cone { <0.9, -1.2, 0.3>, 0.05, <0.7, 1.2, 0>, 0.5 texture { Normal } }
cylinder { <1.3, -1, 0>, <2.2, 0.6, 0.4>, 0.2 texture { Normal } }
cone { <1.9, -1.1, -0.5>, 0.4, <2, -0.3, -0.5>, 0 texture { Normal } }
disc { <1.5, 1, 0>, <0.2683281572999747, 0.35777087639996635, 0.8944271909999159>, 0.45 texture { Normal } }
box { <-0.4, -1.7, -0.5>, <0.9, -1.4, 0.6> texture { Normal } }
