// inside.scene, written by `course export`.
// povray +Iinside.pov +Oinside.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb 0 }

camera {
  perspective
  location <0.5, 0.4, 3>
  direction <-0.1629953416597021, -0.13039627332776169, -0.9779720499582125>
  right <2.0183644760929784, 0, -0.33639407934882976>
  up <-0.03289840073745807, 1.5215510341074354, -0.1973904044247484>
}

light_source { <100000, 0, 0> rgb <0.5, 0, 0> parallel point_at 0 shadowless }
light_source { <-100000, 0, 0> rgb <-0.5, 0, 0> parallel point_at 0 shadowless }
light_source { <0, 100000, 0> rgb <0, 0.5, 0> parallel point_at 0 shadowless }
light_source { <0, -100000, 0> rgb <0, -0.5, 0> parallel point_at 0 shadowless }
light_source { <0, 0, 100000> rgb <0, 0, 0.5> parallel point_at 0 shadowless }
light_source { <0, 0, -100000> rgb <0, 0, -0.5> parallel point_at 0 shadowless }

#declare Normal = texture { pigment { rgb 1 } finish { ambient 0 diffuse 1 emission 0.5 } }

sphere { <0, 0, 0>, 5 texture { Normal } }
sphere { <-1.3, 0.5, -0.8>, 0.9 texture { Normal } }
sphere { <1.4, 0.2, -1.6>, 0.7 texture { Normal } }
sphere { <0.1, -1.1, 0>, 0.6 texture { Normal } }
sphere { <-3.6, -2.6, -2>, 1.4 texture { Normal } }
sphere { <0.2, 1.9, -3>, 0.5 texture { Normal } }
sphere { <0.5, 0.4, 9>, 1 texture { Normal } }
