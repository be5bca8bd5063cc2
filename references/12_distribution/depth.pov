// depth.scene, written by `course export`.
// povray +Idepth.pov +Odepth.png +W240 +H160 +FN16 -D -A File_Gamma=1.0 +KFI0 +KFF35
// then a pixel's samples are those of 36 pictures, weighed by our filter
#version 3.7;
#switch (frame_number)
#case (0)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.36, 0.45> }

camera {
  perspective
  location <-0.09876883405951377, 1.4155062206376239, 5.997932503914983>
  direction <0.014968006792425168, -0.13326772547460042, -0.9910806999648237>
  right <0.8602361572764237, 0, 0>
  up <0, 0.5684600535122708, -0.0757946738016361>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.7, 0.68, 0.64> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.15, 0.17, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb 0.06 rgb 0.03 scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb 0.5 transmit 0.5 rgb 0.25 transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.4, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1, 0.6, 2>, 0.6 texture { Material1 } }
sphere { <0, 0.6, -0.1>, 0.6 texture { Material2 } }
sphere { <1.5, 0.6, -3>, 0.6 texture { Material3 } }
#break
#case (1)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.36, 0.45> }

camera {
  perspective
  location <-0.05795554957734409, 1.4153929195240191, 5.99794761073013>
  direction <0.008763178932394408, -0.13324884195566628, -0.9910832177673482>
  right <0.8602361572764237, 0, 0>
  up <0, 0.5684600535122708, -0.07579467380163608>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.7, 0.68, 0.64> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.15, 0.17, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb 0.06 rgb 0.03 scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb 0.5 transmit 0.5 rgb 0.25 transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.4, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1, 0.6, 2>, 0.6 texture { Material1 } }
sphere { <0, 0.6, -0.1>, 0.6 texture { Material2 } }
sphere { <1.5, 0.6, -3>, 0.6 texture { Material3 } }
#break
#case (2)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.36, 0.45> }

camera {
  perspective
  location <0.09876883405951378, 1.4155062206376239, 5.997932503914983>
  direction <-0.01676016545341772, -0.13326772547460042, -0.9910806999648237>
  right <0.8602361572764237, 0, 0>
  up <0, 0.5684600535122708, -0.0757946738016361>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.7, 0.68, 0.64> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.15, 0.17, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb 0.06 rgb 0.03 scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb 0.5 transmit 0.5 rgb 0.25 transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.4, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1, 0.6, 2>, 0.6 texture { Material1 } }
sphere { <0, 0.6, -0.1>, 0.6 texture { Material2 } }
sphere { <1.5, 0.6, -3>, 0.6 texture { Material3 } }
#break
#case (3)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.36, 0.45> }

camera {
  perspective
  location <0.014142135623730935, 1.4140180794054797, 5.998130922745936>
  direction <-0.002058329493789731, -0.13301970193590973, -0.9911137697699824>
  right <0.8602361572764237, 0, 0>
  up <0, 0.5684600535122708, -0.07579467380163608>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.7, 0.68, 0.64> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.15, 0.17, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb 0.06 rgb 0.03 scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb 0.5 transmit 0.5 rgb 0.25 transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.4, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1, 0.6, 2>, 0.6 texture { Material1 } }
sphere { <0, 0.6, -0.1>, 0.6 texture { Material2 } }
sphere { <1.5, 0.6, -3>, 0.6 texture { Material3 } }
#break
#case (4)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.36, 0.45> }

camera {
  perspective
  location <-0.08910065241883677, 1.4450008049986691, 5.993999892666844>
  direction <0.01574618806696907, -0.1381834895347746, -0.9904252647568005>
  right <0.8602361572764237, 0, 0>
  up <0, 0.5684600535122708, -0.0757946738016361>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.7, 0.68, 0.64> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.15, 0.17, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb 0.06 rgb 0.03 scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb 0.5 transmit 0.5 rgb 0.25 transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.4, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1, 0.6, 2>, 0.6 texture { Material1 } }
sphere { <0, 0.6, -0.1>, 0.6 texture { Material2 } }
sphere { <1.5, 0.6, -3>, 0.6 texture { Material3 } }
#break
#case (5)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.36, 0.45> }

camera {
  perspective
  location <0.07071067811865474, 1.4700903970273995, 5.99065461372968>
  direction <-0.010291647468948664, -0.14236508820622967, -0.9898677182672732>
  right <0.8602361572764237, 0, 0>
  up <0, 0.5684600535122708, -0.07579467380163608>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.7, 0.68, 0.64> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.15, 0.17, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb 0.06 rgb 0.03 scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb 0.5 transmit 0.5 rgb 0.25 transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.4, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1, 0.6, 2>, 0.6 texture { Material1 } }
sphere { <0, 0.6, -0.1>, 0.6 texture { Material2 } }
sphere { <1.5, 0.6, -3>, 0.6 texture { Material3 } }
#break
#case (6)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.36, 0.45> }

camera {
  perspective
  location <0.04539904997395467, 1.3116809473534232, 6.011775873686211>
  direction <-0.00905997387981957, -0.11655565914964225, -0.993308975474818>
  right <0.8602361572764237, 0, 0>
  up <0, 0.5684600535122708, -0.0757946738016361>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.7, 0.68, 0.64> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.15, 0.17, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb 0.06 rgb 0.03 scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb 0.5 transmit 0.5 rgb 0.25 transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.4, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1, 0.6, 2>, 0.6 texture { Material1 } }
sphere { <0, 0.6, -0.1>, 0.6 texture { Material2 } }
sphere { <1.5, 0.6, -3>, 0.6 texture { Material3 } }
#break
#case (7)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.36, 0.45> }

camera {
  perspective
  location <0.07071067811865475, 1.3299096029726003, 6.00934538627032>
  direction <-0.012681192350272066, -0.11959376841950509, -0.9929038942388363>
  right <0.8602361572764237, 0, 0>
  up <0, 0.5684600535122708, -0.0757946738016361>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.7, 0.68, 0.64> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.15, 0.17, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb 0.06 rgb 0.03 scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb 0.5 transmit 0.5 rgb 0.25 transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.4, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1, 0.6, 2>, 0.6 texture { Material1 } }
sphere { <0, 0.6, -0.1>, 0.6 texture { Material2 } }
sphere { <1.5, 0.6, -3>, 0.6 texture { Material3 } }
#break
#case (8)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.36, 0.45> }

camera {
  perspective
  location <-0.014142135623730952, 1.38598192059452, 6.001869077254064>
  direction <0.0020583294937897337, -0.12893915468982503, -0.991657842736127>
  right <0.8602361572764237, 0, 0>
  up <0, 0.5684600535122708, -0.0757946738016361>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.7, 0.68, 0.64> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.15, 0.17, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb 0.06 rgb 0.03 scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb 0.5 transmit 0.5 rgb 0.25 transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.4, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1, 0.6, 2>, 0.6 texture { Material1 } }
sphere { <0, 0.6, -0.1>, 0.6 texture { Material2 } }
sphere { <1.5, 0.6, -3>, 0.6 texture { Material3 } }
#break
#case (9)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.36, 0.45> }

camera {
  perspective
  location <0.015529142706151229, 1.3425528422595407, 6.007659621032062>
  direction <-0.0022894973408597802, -0.12170097496732851, -0.9926229333657932>
  right <0.8602361572764237, 0, 0>
  up <0, 0.5684600535122708, -0.0757946738016361>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.7, 0.68, 0.64> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.15, 0.17, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb 0.06 rgb 0.03 scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb 0.5 transmit 0.5 rgb 0.25 transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.4, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1, 0.6, 2>, 0.6 texture { Material1 } }
sphere { <0, 0.6, -0.1>, 0.6 texture { Material2 } }
sphere { <1.5, 0.6, -3>, 0.6 texture { Material3 } }
#break
#case (10)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.36, 0.45> }

camera {
  perspective
  location <-0.08910065241883677, 1.3549991950013307, 6.006000107333156>
  direction <0.01574618806696907, -0.12377536709096015, -0.992346347749309>
  right <0.8602361572764237, 0, 0>
  up <0, 0.5684600535122708, -0.07579467380163608>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.7, 0.68, 0.64> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.15, 0.17, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb 0.06 rgb 0.03 scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb 0.5 transmit 0.5 rgb 0.25 transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.4, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1, 0.6, 2>, 0.6 texture { Material1 } }
sphere { <0, 0.6, -0.1>, 0.6 texture { Material2 } }
sphere { <1.5, 0.6, -3>, 0.6 texture { Material3 } }
#break
#case (11)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.36, 0.45> }

camera {
  perspective
  location <-0.04539904997395467, 1.3116809473534232, 6.011775873686211>
  direction <0.00905997387981957, -0.11655565914964225, -0.993308975474818>
  right <0.8602361572764237, 0, 0>
  up <0, 0.5684600535122708, -0.0757946738016361>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.7, 0.68, 0.64> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.15, 0.17, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb 0.06 rgb 0.03 scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb 0.5 transmit 0.5 rgb 0.25 transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.4, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1, 0.6, 2>, 0.6 texture { Material1 } }
sphere { <0, 0.6, -0.1>, 0.6 texture { Material2 } }
sphere { <1.5, 0.6, -3>, 0.6 texture { Material3 } }
#break
#case (12)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.36, 0.45> }

camera {
  perspective
  location <-0.07071067811865474, 1.4700903970273995, 5.99065461372968>
  direction <0.010291647468948664, -0.14354937998438022, -0.9897098126968531>
  right <0.8602361572764237, 0, 0>
  up <0, 0.5684600535122708, -0.07579467380163608>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.7, 0.68, 0.64> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.15, 0.17, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb 0.06 rgb 0.03 scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb 0.5 transmit 0.5 rgb 0.25 transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.4, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1, 0.6, 2>, 0.6 texture { Material1 } }
sphere { <0, 0.6, -0.1>, 0.6 texture { Material2 } }
sphere { <1.5, 0.6, -3>, 0.6 texture { Material3 } }
#break
#case (13)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.36, 0.45> }

camera {
  perspective
  location <-0.01564344650402309, 1.4979024240376833, 5.986946343461642>
  direction <0.0017111617535075733, -0.14818471781942752, -0.9890917676521801>
  right <0.8602361572764237, 0, 0>
  up <0, 0.5684600535122708, -0.0757946738016361>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.7, 0.68, 0.64> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.15, 0.17, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb 0.06 rgb 0.03 scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb 0.5 transmit 0.5 rgb 0.25 transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.4, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1, 0.6, 2>, 0.6 texture { Material1 } }
sphere { <0, 0.6, -0.1>, 0.6 texture { Material2 } }
sphere { <1.5, 0.6, -3>, 0.6 texture { Material3 } }
#break
#case (14)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.36, 0.45> }

camera {
  perspective
  location <0.08910065241883679, 1.3549991950013307, 6.006000107333156>
  direction <-0.015148801846638221, -0.12436751298003544, -0.992267394964099>
  right <0.8602361572764237, 0, 0>
  up <0, 0.5684600535122708, -0.07579467380163608>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.7, 0.68, 0.64> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.15, 0.17, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb 0.06 rgb 0.03 scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb 0.5 transmit 0.5 rgb 0.25 transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.4, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1, 0.6, 2>, 0.6 texture { Material1 } }
sphere { <0, 0.6, -0.1>, 0.6 texture { Material2 } }
sphere { <1.5, 0.6, -3>, 0.6 texture { Material3 } }
#break
#case (15)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.36, 0.45> }

camera {
  perspective
  location <-0.05795554957734409, 1.3846070804759805, 6.00205238926987>
  direction <0.009957951373056106, -0.12930216055914373, -0.9916094419535513>
  right <0.8602361572764237, 0, 0>
  up <0, 0.5684600535122708, -0.07579467380163608>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.7, 0.68, 0.64> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.15, 0.17, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb 0.06 rgb 0.03 scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb 0.5 transmit 0.5 rgb 0.25 transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.4, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1, 0.6, 2>, 0.6 texture { Material1 } }
sphere { <0, 0.6, -0.1>, 0.6 texture { Material2 } }
sphere { <1.5, 0.6, -3>, 0.6 texture { Material3 } }
#break
#case (16)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.36, 0.45> }

camera {
  perspective
  location <-0.07071067811865474, 1.3299096029726003, 6.00934538627032>
  direction <0.012681192350272062, -0.12018591430858037, -0.9928249414536263>
  right <0.8602361572764237, 0, 0>
  up <0, 0.5684600535122708, -0.0757946738016361>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.7, 0.68, 0.64> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.15, 0.17, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb 0.06 rgb 0.03 scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb 0.5 transmit 0.5 rgb 0.25 transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.4, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1, 0.6, 2>, 0.6 texture { Material1 } }
sphere { <0, 0.6, -0.1>, 0.6 texture { Material2 } }
sphere { <1.5, 0.6, -3>, 0.6 texture { Material3 } }
#break
#case (17)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.36, 0.45> }

camera {
  perspective
  location <-0.09876883405951377, 1.384493779362376, 6.002067496085017>
  direction <0.01795493789407942, -0.12928327704020962, -0.9916119597560757>
  right <0.8602361572764237, 0, 0>
  up <0, 0.5684600535122708, -0.07579467380163608>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.7, 0.68, 0.64> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.15, 0.17, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb 0.06 rgb 0.03 scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb 0.5 transmit 0.5 rgb 0.25 transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.4, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1, 0.6, 2>, 0.6 texture { Material1 } }
sphere { <0, 0.6, -0.1>, 0.6 texture { Material2 } }
sphere { <1.5, 0.6, -3>, 0.6 texture { Material3 } }
#break
#case (18)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.36, 0.45> }

camera {
  perspective
  location <0.04242640687119284, 1.3579457617835602, 6.005607231762192>
  direction <-0.008564533362692597, -0.12545075333281563, -0.9921229629170616>
  right <0.8602361572764237, 0, 0>
  up <0, 0.5684600535122708, -0.0757946738016361>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.7, 0.68, 0.64> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.15, 0.17, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb 0.06 rgb 0.03 scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb 0.5 transmit 0.5 rgb 0.25 transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.4, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1, 0.6, 2>, 0.6 texture { Material1 } }
sphere { <0, 0.6, -0.1>, 0.6 texture { Material2 } }
sphere { <1.5, 0.6, -3>, 0.6 texture { Material3 } }
#break
#case (19)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.36, 0.45> }

camera {
  perspective
  location <0.05795554957734409, 1.4153929195240191, 5.99794761073013>
  direction <-0.010555337593386956, -0.13502527962289212, -0.9908463594117181>
  right <0.8602361572764237, 0, 0>
  up <0, 0.5684600535122708, -0.07579467380163608>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.7, 0.68, 0.64> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.15, 0.17, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb 0.06 rgb 0.03 scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb 0.5 transmit 0.5 rgb 0.25 transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.4, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1, 0.6, 2>, 0.6 texture { Material1 } }
sphere { <0, 0.6, -0.1>, 0.6 texture { Material2 } }
sphere { <1.5, 0.6, -3>, 0.6 texture { Material3 } }
#break
#case (20)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.36, 0.45> }

camera {
  perspective
  location <0.09876883405951378, 1.384493779362376, 6.002067496085017>
  direction <-0.01676016545341772, -0.12987542292928492, -0.9915330069708657>
  right <0.8602361572764237, 0, 0>
  up <0, 0.5684600535122708, -0.07579467380163608>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.7, 0.68, 0.64> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.15, 0.17, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb 0.06 rgb 0.03 scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb 0.5 transmit 0.5 rgb 0.25 transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.4, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1, 0.6, 2>, 0.6 texture { Material1 } }
sphere { <0, 0.6, -0.1>, 0.6 texture { Material2 } }
sphere { <1.5, 0.6, -3>, 0.6 texture { Material3 } }
#break
#case (21)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.36, 0.45> }

camera {
  perspective
  location <0.08910065241883679, 1.4450008049986691, 5.993999892666844>
  direction <-0.014551415626307372, -0.13995992720200046, -0.9901884064011703>
  right <0.8602361572764237, 0, 0>
  up <0, 0.5684600535122708, -0.0757946738016361>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.7, 0.68, 0.64> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.15, 0.17, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb 0.06 rgb 0.03 scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb 0.5 transmit 0.5 rgb 0.25 transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.4, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1, 0.6, 2>, 0.6 texture { Material1 } }
sphere { <0, 0.6, -0.1>, 0.6 texture { Material2 } }
sphere { <1.5, 0.6, -3>, 0.6 texture { Material3 } }
#break
#case (22)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.36, 0.45> }

camera {
  perspective
  location <0.01414213562373094, 1.3859819205945199, 6.001869077254064>
  direction <-0.001460943273458882, -0.13012344646797558, -0.991499937165707>
  right <0.8602361572764237, 0, 0>
  up <0, 0.5684600535122708, -0.07579467380163608>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.7, 0.68, 0.64> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.15, 0.17, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb 0.06 rgb 0.03 scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb 0.5 transmit 0.5 rgb 0.25 transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.4, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1, 0.6, 2>, 0.6 texture { Material1 } }
sphere { <0, 0.6, -0.1>, 0.6 texture { Material2 } }
sphere { <1.5, 0.6, -3>, 0.6 texture { Material3 } }
#break
#case (23)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.36, 0.45> }

camera {
  perspective
  location <-0.01552914270615125, 1.3425528422595407, 6.007659621032062>
  direction <0.004081656001852333, -0.12288526674547907, -0.9924650277953732>
  right <0.8602361572764237, 0, 0>
  up <0, 0.5684600535122708, -0.0757946738016361>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.7, 0.68, 0.64> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.15, 0.17, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb 0.06 rgb 0.03 scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb 0.5 transmit 0.5 rgb 0.25 transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.4, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1, 0.6, 2>, 0.6 texture { Material1 } }
sphere { <0, 0.6, -0.1>, 0.6 texture { Material2 } }
sphere { <1.5, 0.6, -3>, 0.6 texture { Material3 } }
#break
#case (24)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.36, 0.45> }

camera {
  perspective
  location <-0.014142135623730968, 1.4140180794054797, 5.998130922745936>
  direction <0.0008635570531280367, -0.13538828549221085, -0.9907979586291423>
  right <0.8602361572764237, 0, 0>
  up <0, 0.5684600535122708, -0.07579467380163608>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.7, 0.68, 0.64> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.15, 0.17, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb 0.06 rgb 0.03 scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb 0.5 transmit 0.5 rgb 0.25 transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.4, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1, 0.6, 2>, 0.6 texture { Material1 } }
sphere { <0, 0.6, -0.1>, 0.6 texture { Material2 } }
sphere { <1.5, 0.6, -3>, 0.6 texture { Material3 } }
#break
#case (25)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.36, 0.45> }

camera {
  perspective
  location <0.04242640687119284, 1.4420542382164396, 5.994392768237808>
  direction <-0.007967147142361748, -0.14006097862737082, -0.9901749328777877>
  right <0.8602361572764237, 0, 0>
  up <0, 0.5684600535122708, -0.07579467380163608>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.7, 0.68, 0.64> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.15, 0.17, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb 0.06 rgb 0.03 scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb 0.5 transmit 0.5 rgb 0.25 transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.4, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1, 0.6, 2>, 0.6 texture { Material1 } }
sphere { <0, 0.6, -0.1>, 0.6 texture { Material2 } }
sphere { <1.5, 0.6, -3>, 0.6 texture { Material3 } }
#break
#case (26)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.36, 0.45> }

camera {
  perspective
  location <0.05795554957734409, 1.3846070804759805, 6.00205238926987>
  direction <-0.009957951373056106, -0.1304864523372943, -0.9914515363831312>
  right <0.8602361572764237, 0, 0>
  up <0, 0.5684600535122708, -0.07579467380163608>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.7, 0.68, 0.64> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.15, 0.17, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb 0.06 rgb 0.03 scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb 0.5 transmit 0.5 rgb 0.25 transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.4, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1, 0.6, 2>, 0.6 texture { Material1 } }
sphere { <0, 0.6, -0.1>, 0.6 texture { Material2 } }
sphere { <1.5, 0.6, -3>, 0.6 texture { Material3 } }
#break
#case (27)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.36, 0.45> }

camera {
  perspective
  location <0.015529142706151229, 1.457447157740459, 5.992340378967938>
  direction <-0.0022894973408597802, -0.1426264652147074, -0.9898328679994761>
  right <0.8602361572764237, 0, 0>
  up <0, 0.5684600535122708, -0.0757946738016361>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.7, 0.68, 0.64> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.15, 0.17, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb 0.06 rgb 0.03 scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb 0.5 transmit 0.5 rgb 0.25 transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.4, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1, 0.6, 2>, 0.6 texture { Material1 } }
sphere { <0, 0.6, -0.1>, 0.6 texture { Material2 } }
sphere { <1.5, 0.6, -3>, 0.6 texture { Material3 } }
#break
#case (28)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.36, 0.45> }

camera {
  perspective
  location <-0.04242640687119284, 1.3579457617835602, 6.005607231762192>
  direction <0.007967147142361748, -0.1260428992218909, -0.9920440101318516>
  right <0.8602361572764237, 0, 0>
  up <0, 0.5684600535122708, -0.0757946738016361>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.7, 0.68, 0.64> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.15, 0.17, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb 0.06 rgb 0.03 scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb 0.5 transmit 0.5 rgb 0.25 transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.4, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1, 0.6, 2>, 0.6 texture { Material1 } }
sphere { <0, 0.6, -0.1>, 0.6 texture { Material2 } }
sphere { <1.5, 0.6, -3>, 0.6 texture { Material3 } }
#break
#case (29)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.36, 0.45> }

camera {
  perspective
  location <-0.04539904997395467, 1.4883190526465766, 5.988224126313789>
  direction <0.00905997387981957, -0.14777178103239366, -0.9891468258904513>
  right <0.8602361572764237, 0, 0>
  up <0, 0.5684600535122708, -0.0757946738016361>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.7, 0.68, 0.64> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.15, 0.17, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb 0.06 rgb 0.03 scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb 0.5 transmit 0.5 rgb 0.25 transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.4, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1, 0.6, 2>, 0.6 texture { Material1 } }
sphere { <0, 0.6, -0.1>, 0.6 texture { Material2 } }
sphere { <1.5, 0.6, -3>, 0.6 texture { Material3 } }
#break
#case (30)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.36, 0.45> }

camera {
  perspective
  location <0.04539904997395467, 1.4883190526465766, 5.988224126313789>
  direction <-0.00905997387981957, -0.14836392692146894, -0.9890678731052412>
  right <0.8602361572764237, 0, 0>
  up <0, 0.5684600535122708, -0.0757946738016361>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.7, 0.68, 0.64> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.15, 0.17, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb 0.06 rgb 0.03 scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb 0.5 transmit 0.5 rgb 0.25 transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.4, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1, 0.6, 2>, 0.6 texture { Material1 } }
sphere { <0, 0.6, -0.1>, 0.6 texture { Material2 } }
sphere { <1.5, 0.6, -3>, 0.6 texture { Material3 } }
#break
#case (31)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.36, 0.45> }

camera {
  perspective
  location <-0.01552914270615125, 1.457447157740459, 5.992340378967938>
  direction <0.0016921111205289337, -0.14321861110378267, -0.989753915214266>
  right <0.8602361572764237, 0, 0>
  up <0, 0.5684600535122708, -0.0757946738016361>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.7, 0.68, 0.64> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.15, 0.17, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb 0.06 rgb 0.03 scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb 0.5 transmit 0.5 rgb 0.25 transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.4, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1, 0.6, 2>, 0.6 texture { Material1 } }
sphere { <0, 0.6, -0.1>, 0.6 texture { Material2 } }
sphere { <1.5, 0.6, -3>, 0.6 texture { Material3 } }
#break
#case (32)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.36, 0.45> }

camera {
  perspective
  location <-0.04242640687119284, 1.4420542382164396, 5.994392768237808>
  direction <0.006772374701700048, -0.1406531245164461, -0.9900959800925776>
  right <0.8602361572764237, 0, 0>
  up <0, 0.5684600535122708, -0.07579467380163608>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.7, 0.68, 0.64> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.15, 0.17, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb 0.06 rgb 0.03 scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb 0.5 transmit 0.5 rgb 0.25 transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.4, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1, 0.6, 2>, 0.6 texture { Material1 } }
sphere { <0, 0.6, -0.1>, 0.6 texture { Material2 } }
sphere { <1.5, 0.6, -3>, 0.6 texture { Material3 } }
#break
#case (33)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.36, 0.45> }

camera {
  perspective
  location <-0.01564344650402309, 1.3020975759623166, 6.013053656538358>
  direction <0.0029059341941692724, -0.11732701414075894, -0.9932061281426692>
  right <0.8602361572764237, 0, 0>
  up <0, 0.5684600535122708, -0.0757946738016361>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.7, 0.68, 0.64> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.15, 0.17, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb 0.06 rgb 0.03 scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb 0.5 transmit 0.5 rgb 0.25 transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.4, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1, 0.6, 2>, 0.6 texture { Material1 } }
sphere { <0, 0.6, -0.1>, 0.6 texture { Material2 } }
sphere { <1.5, 0.6, -3>, 0.6 texture { Material3 } }
#break
#case (34)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.36, 0.45> }

camera {
  perspective
  location <0.01564344650402307, 1.4979024240376833, 5.986946343461642>
  direction <-0.0017111617535075707, -0.14996115548665337, -0.98885490929655>
  right <0.8602361572764237, 0, 0>
  up <0, 0.5684600535122708, -0.0757946738016361>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.7, 0.68, 0.64> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.15, 0.17, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb 0.06 rgb 0.03 scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb 0.5 transmit 0.5 rgb 0.25 transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.4, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1, 0.6, 2>, 0.6 texture { Material1 } }
sphere { <0, 0.6, -0.1>, 0.6 texture { Material2 } }
sphere { <1.5, 0.6, -3>, 0.6 texture { Material3 } }
#break
#case (35)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.36, 0.45> }

camera {
  perspective
  location <0.01564344650402307, 1.3020975759623166, 6.013053656538358>
  direction <-0.0011137755331767207, -0.11732701414075894, -0.9932061281426692>
  right <0.8602361572764237, 0, 0>
  up <0, 0.5684600535122708, -0.0757946738016361>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.7, 0.68, 0.64> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.15, 0.17, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb 0.06 rgb 0.03 scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb 0.5 transmit 0.5 rgb 0.25 transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.06 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.15, 0.4, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1, 0.6, 2>, 0.6 texture { Material1 } }
sphere { <0, 0.6, -0.1>, 0.6 texture { Material2 } }
sphere { <1.5, 0.6, -3>, 0.6 texture { Material3 } }
#break
#end
