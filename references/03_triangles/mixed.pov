// mixed.scene, written by `course export`.
// povray +Imixed.pov +Omixed.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0.5, 2.2, 7.6>
  direction <-0.07612644106337939, -0.25375480354459795, -0.9642682534694722>
  right <1.0740613241133758, 0, -0.08479431506158232>
  up <-0.016137723570112922, 0.7816037449124692, -0.20441116522143035>
}

light_source { <100000, 0, 0> rgb <0.5, 0, 0> parallel point_at 0 shadowless }
light_source { <-100000, 0, 0> rgb <-0.5, 0, 0> parallel point_at 0 shadowless }
light_source { <0, 100000, 0> rgb <0, 0.5, 0> parallel point_at 0 shadowless }
light_source { <0, -100000, 0> rgb <0, -0.5, 0> parallel point_at 0 shadowless }
light_source { <0, 0, 100000> rgb <0, 0, 0.5> parallel point_at 0 shadowless }
light_source { <0, 0, -100000> rgb <0, 0, -0.5> parallel point_at 0 shadowless }

#declare Normal = texture { pigment { rgb 1 } finish { ambient 0 diffuse 1 emission 0.5 } }

plane { <0.049778974257458246, 0.9955794851491648, 0.07964635881193319>, -0.9955794851491648 texture { Normal } }
triangle { <0, 1.75, 0>, <0, 0.35, 1.35>, <1.35, 0.35, 0> texture { Normal } }
triangle { <0, 1.75, 0>, <1.35, 0.35, 0>, <0, 0.35, -1.35> texture { Normal } }
triangle { <0, 1.75, 0>, <0, 0.35, -1.35>, <-1.35, 0.35, 0> texture { Normal } }
triangle { <0, 1.75, 0>, <-1.35, 0.35, 0>, <0, 0.35, 1.35> texture { Normal } }
triangle { <0, -1.05, 0>, <1.35, 0.35, 0>, <0, 0.35, 1.35> texture { Normal } }
triangle { <0, -1.05, 0>, <0, 0.35, -1.35>, <1.35, 0.35, 0> texture { Normal } }
triangle { <0, -1.05, 0>, <-1.35, 0.35, 0>, <0, 0.35, -1.35> texture { Normal } }
triangle { <0, -1.05, 0>, <0, 0.35, 1.35>, <-1.35, 0.35, 0> texture { Normal } }
sphere { <0, 0.35, 0>, 0.92 texture { Normal } }
smooth_triangle { <2.15, 0.95, 0.35>, <0.05, 1, 0.05>, <1.4, -0.75, 1.1>, <-0.8, -0.5, 0.7>, <3.05, -0.8, 0.85>, <0.9, -0.4, 0.4> texture { Normal } }
smooth_triangle { <2.15, 0.95, 0.35>, <0.05, 1, 0.05>, <3.05, -0.8, 0.85>, <0.9, -0.4, 0.4>, <2.1, -0.7, -0.7>, <0, -0.5, -0.9> texture { Normal } }
smooth_triangle { <2.15, 0.95, 0.35>, <0.05, 1, 0.05>, <2.1, -0.7, -0.7>, <0, -0.5, -0.9>, <1.4, -0.75, 1.1>, <-0.8, -0.5, 0.7> texture { Normal } }
smooth_triangle { <1.4, -0.75, 1.1>, <-0.8, -0.5, 0.7>, <2.1, -0.7, -0.7>, <0, -0.5, -0.9>, <3.05, -0.8, 0.85>, <0.9, -0.4, 0.4> texture { Normal } }
triangle { <-3.1, -0.75, 0.3>, <-1.5, -0.75, 0.3>, <-2.3, 0.35, 1.1> texture { Normal } }
triangle { <-1.5, -0.75, 0.3>, <-1.5, -0.75, 1.9>, <-2.3, 0.35, 1.1> texture { Normal } }
triangle { <-1.5, -0.75, 1.9>, <-3.1, -0.75, 1.9>, <-2.3, 0.35, 1.1> texture { Normal } }
triangle { <-3.1, -0.75, 1.9>, <-3.1, -0.75, 0.3>, <-2.3, 0.35, 1.1> texture { Normal } }
sphere { <-2.3, 0.3, 1.1>, 0.28 texture { Normal } }
sphere { <-1.75, -0.55, 1.95>, 0.3 texture { Normal } }
sphere { <-2.9, -0.55, 1.9>, 0.22 texture { Normal } }
