// focus.scene, written by `course export`.
// povray +Ifocus.pov +Ofocus.png +W320 +H200 +FN16 -D -A File_Gamma=1.0 +KFI0 +KFF127
// then a pixel's samples are those of 128 pictures, weighed by our filter, times 32
#version 3.7;
#switch (frame_number)
#case (0)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8957309518101874, 1.4817155035979777, 7.003091331395962>
  direction <0.14030592962467262, -0.1296541445787458, -0.9815887757764604>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619045, 0.5311264062957393, -0.0706398120373333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (1)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8747997860468982, 1.559253507334563, 6.995558483140752>
  direction <0.13521892963661145, -0.14336670254884384, -0.9804545000502415>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619045, 0.5311264062957393, -0.0706398120373333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (2)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8021678786392533, 1.402271411860907, 7.027239182870412>
  direction <0.12497131669556374, -0.11812222143556315, -0.9853444814786222>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (3)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9715989090309061, 1.5375952723502762, 6.984669368890905>
  direction <0.15112104153349756, -0.13799080855790835, -0.9789123553923134>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (4)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9891926325317918, 1.3968975973058966, 7.001250664289658>
  direction <0.1541451574105466, -0.11693026949392474, -0.9813385548542756>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (5)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.850899340847427, 1.6125276037276641, 6.991742776515899>
  direction <0.13295829910965, -0.14992537198737332, -0.9798873421302927>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619045, 0.5311264062957393, -0.0706398120373333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (6)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8718899932141333, 1.4439490598794251, 7.011622628557202>
  direction <0.1367714803246515, -0.1254242937795154, -0.9826677482849303>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (7)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9614362150969176, 1.4982122190314515, 6.991466025260458>
  direction <0.14881150640051868, -0.1326695217272665, -0.9799644636240403>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (8)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9753237767188293, 1.4428165394047328, 6.997000072978096>
  direction <0.15219064362990256, -0.1239951675566186, -0.9806589635144305>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (9)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8260650869494659, 1.5270505081636234, 7.006890990042156>
  direction <0.12792684306733057, -0.13860511442218906, -0.9821424422344704>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (10)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8365510891990345, 1.4252108514953121, 7.019214085982917>
  direction <0.12940555354918643, -0.12058286549469588, -0.9843770745200794>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (11)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9436160944364264, 1.602880856887654, 6.979806727360043>
  direction <0.14797796125524568, -0.14966789431457403, -0.9777766195079447>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (12)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9011480288788588, 1.3893477441730415, 7.014853087736679>
  direction <0.14007274432777336, -0.11526340012554884, -0.9835751175660942>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (13)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9082943173663861, 1.605852544628991, 6.9844493950337245>
  direction <0.1419319025643581, -0.15054072626316126, -0.9785218864136204>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (14)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.7559970825279011, 1.5371289571165627, 7.015532915458766>
  direction <0.11625186112343679, -0.13962294502710385, -0.9836721626443597>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (15)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-1.005724439416007, 1.5066924553417012, 6.983988246858482>
  direction <0.15815991073079866, -0.13292523554249486, -0.9785942732733621>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (16)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9307013622411608, 1.3831155302698173, 7.01147698342893>
  direction <0.14571310557247594, -0.11572622313209793, -0.9827065399802478>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (17)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8395094070933175, 1.5714357491179949, 6.99894666160637>
  direction <0.12974858916558482, -0.1438515413421789, -0.9811701777098641>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (18)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.843950478296122, 1.4985540241923172, 7.008203314103025>
  direction <0.13085877093865142, -0.13334847925655385, -0.9824369958824751>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619045, 0.5311264062957393, -0.0706398120373333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (19)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9259397956075937, 1.5482922256290994, 6.989740370006395>
  direction <0.1445612188870127, -0.13975741971748215, -0.9796097185415833>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (20)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-1.0276190747888445, 1.5647600485739726, 6.972979839866555>
  direction <0.1601770290347191, -0.14249074331146921, -0.9770079374612984>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (21)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8018319821633189, 1.4785971891837901, 7.016928669730297>
  direction <0.12531612543388115, -0.12989581797285457, -0.9836973778430872>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (22)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9285179908769849, 1.4423401771287834, 7.003751262978668>
  direction <0.14580746901868258, -0.12379789424970877, -0.9815976184076854>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (23)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9043420949413976, 1.5299886201447321, 6.995309816560158>
  direction <0.139693522421957, -0.13888128500547947, -0.9804240077475059>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (24)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9510604736875827, 1.5692414822415666, 6.983308588311847>
  direction <0.14794371481006288, -0.14483510992812812, -0.9784373897382741>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (25)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8375829489487889, 1.4025533816056073, 7.022141619789412>
  direction <0.13069808398259955, -0.11744078264504072, -0.9846188528449021>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619045, 0.5311264062957393, -0.0706398120373333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (26)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.7881622203461871, 1.5649777811771717, 7.007158412505071>
  direction <0.12130420444746452, -0.14217890269509584, -0.9826035193431283>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (27)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9996434796100337, 1.4632777582837528, 6.9907489500029145>
  direction <0.157060116255798, -0.12793027279059813, -0.9794292745718339>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (28)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.826197281794172, 1.4882006630887747, 7.012144584038785>
  direction <0.12789118451277404, -0.1312949398437997, -0.9831396314350457>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (29)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9811324865194458, 1.487060232349248, 6.9901657561069666>
  direction <0.15296800617063955, -0.13237483581355775, -0.9794106710308834>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (30)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9012950691235024, 1.617219312027418, 6.983906654921493>
  direction <0.1396458205232058, -0.1518196748800556, -0.9786748979643493>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (31)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8975528593841896, 1.409809489682789, 7.012589732202452>
  direction <0.1406242203994593, -0.11823796740911331, -0.983092643995941>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619045, 0.5311264062957393, -0.0706398120373333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (32)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9598543367867752, 1.3973465844029316, 7.00538091543292>
  direction <0.14955545846578167, -0.11666424333226419, -0.9820303296826102>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (33)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8154515480623897, 1.5889648591571617, 7.000004547962615>
  direction <0.12737251498591942, -0.14823564983723192, -0.9809146307254877>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619045, 0.5311264062957393, -0.0706398120373333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (34)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8816090526876607, 1.5040877584253773, 7.002072510972605>
  direction <0.13621670991404788, -0.1339235977890431, -0.9815935242280093>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (35)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9537544794329064, 1.5154671800611859, 6.990221671358424>
  direction <0.1496411332028273, -0.13471210052180255, -0.9795687383873092>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (36)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9974633456552418, 1.5537313746932822, 6.978784549769449>
  direction <0.15570623124954514, -0.14109820155672237, -0.9778356106687532>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (37)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8240656699674651, 1.4369957433018368, 7.01939833912797>
  direction <0.12779788264369152, -0.12415521627771835, -0.9841219227574542>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (38)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8567368107608218, 1.5219753219320376, 7.003198090486249>
  direction <0.13245126036717061, -0.13556797557168668, -0.981908280035633>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619045, 0.5311264062957393, -0.0706398120373333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (39)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9035807238844052, 1.457197802569158, 7.005297337667842>
  direction <0.14149712326792693, -0.12689974506614043, -0.9817924166184204>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619045, 0.5311264062957393, -0.0706398120373333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (40)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.7946751131991941, 1.4874974891273096, 7.016743181732838>
  direction <0.1245359531559552, -0.13111866358340576, -0.9836428734070733>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619045, 0.5311264062957393, -0.0706398120373333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (41)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-1.022397729575946, 1.4898264841489919, 6.983895301497502>
  direction <0.15859886589615046, -0.1328460406380784, -0.9785423132724826>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (42)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9341050490771567, 1.4344904503549938, 7.004018431869372>
  direction <0.14504675816254745, -0.12213952262457096, -0.9819313561076877>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (43)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9225015454613912, 1.6320114192565538, 6.978869658034983>
  direction <0.14379113298909033, -0.15418179999716916, -0.9777621363461861>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (44)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8356078648441138, 1.5599527731796368, 7.001062428662176>
  direction <0.1288576522334838, -0.14220535647343313, -0.9815208652180655>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (45)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9550718947164153, 1.452570965322296, 6.9985693840324865>
  direction <0.15006593490616127, -0.1264923628236646, -0.9806235882601516>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619045, 0.5311264062957393, -0.0706398120373333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (46)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9238505365297079, 1.5699527313020587, 6.987099195533334>
  direction <0.1436070144743369, -0.14469910643437037, -0.9790753759746736>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (47)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8152752043143126, 1.4016763240761707, 7.0254474696876175>
  direction <0.12726496943146415, -0.11648343755419631, -0.9852392231859647>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (48)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.7980834537666024, 1.5501361314249318, 7.007755317339959>
  direction <0.1252953422984406, -0.14062992658784762, -0.9822435749789725>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619045, 0.5311264062957393, -0.0706398120373333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (49)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-1.003906778887305, 1.4175467165005642, 6.9963462629195945>
  direction <0.15519557453651223, -0.12085448663682195, -0.9806559229383157>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619045, 0.5311264062957393, -0.0706398120373333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (50)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8721172651998659, 1.4242409146715673, 7.014264837980306>
  direction <0.1355885367673039, -0.11993154735829625, -0.9835821843788598>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (51)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9697991411830813, 1.5894193613653607, 6.9778932093599755>
  direction <0.15152187877875495, -0.1478825155847136, -0.9775126469750672>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (52)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8017756552775591, 1.5136527804643856, 7.0121791718973245>
  direction <0.1240299680857541, -0.13521811226887914, -0.9831588032383591>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (53)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9868699741485147, 1.526388332648903, 6.984008729976432>
  direction <0.1547209172950706, -0.13852017820988344, -0.9783262444021777>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (54)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8836070997887246, 1.58822046936822, 6.990369064901638>
  direction <0.13763195408520426, -0.14629021186993407, -0.9797130202925803>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (55)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8671880736486942, 1.3762541894537046, 7.021481492338612>
  direction <0.13440642998723204, -0.11394513405867875, -0.984563498580961>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (56)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8734938941954357, 1.6157285342825203, 6.988080571176596>
  direction <0.13709979472197473, -0.15146097420309995, -0.979087296742112>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (57)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9501414266325817, 1.414867205509596, 7.004390675447614>
  direction <0.14699265118957067, -0.1187640477021946, -0.9821114715575783>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (58)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8660017558338732, 1.4810484963353587, 7.007428881806791>
  direction <0.13545197994238248, -0.12994806272204903, -0.9822423082687679>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (59)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9259845112143327, 1.491853575966911, 6.9973935130881575>
  direction <0.14409235647894006, -0.13302022673912112, -0.9805910322183712>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (60)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8923953814437495, 1.5524473383544828, 6.99396852101707>
  direction <0.13810284532384448, -0.14181554314442874, -0.9802530265855217>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (61)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9286462454573235, 1.479712499790749, 6.998660982820209>
  direction <0.14535885900953732, -0.12880356287450098, -0.980982364809913>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (62)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.7968411938216694, 1.4509103737846618, 7.021399135868986>
  direction <0.12348383773247361, -0.12479358821787663, -0.9846515786957496>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (63)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-1.0259956011173494, 1.544530806369673, 6.975957161833066>
  direction <0.16024547057165048, -0.14102891341450158, -0.9771965512991825>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619045, 0.5311264062957393, -0.0706398120373333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (64)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8151301085848385, 1.5726757634519504, 7.002261130876544>
  direction <0.12763917233689703, -0.14518703130271662, -0.9812902779050323>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (65)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-1.0073561195551282, 1.4449906812976652, 6.992128961887442>
  direction <0.15634779368872032, -0.1232380715566386, -0.9801678336774537>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619045, 0.5311264062957393, -0.0706398120373333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (66)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8459353059895381, 1.378455296097892, 7.024218880388209>
  direction <0.13172864340564447, -0.11351826009929851, -0.9850039724156752>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (67)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9661524433348332, 1.5460745248712793, 6.984296679719636>
  direction <0.1499385922975575, -0.14114693884189333, -0.9786529447446211>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (68)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8125912890669656, 1.4898778321419477, 7.013860681485455>
  direction <0.1251440499798739, -0.13186494537745277, -0.983454721331607>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (69)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9670208900706856, 1.498282063783748, 6.990658735619251>
  direction <0.15196531573487643, -0.13205639994243387, -0.9795971288185021>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619045, 0.5311264062957393, -0.0706398120373333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (70)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8842622179429541, 1.6292101604845552, 6.984712589942388>
  direction <0.13747416492955516, -0.15337013839345384, -0.978774714429481>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (71)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8806391120850255, 1.427809472127421, 7.012563127056275>
  direction <0.13742671518614183, -0.12295903562825035, -0.9829087140538176>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619045, 0.5311264062957393, -0.0706398120373333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (72)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9322453761332924, 1.4547960631703594, 7.001528337693553>
  direction <0.14555476380082122, -0.1260715565393451, -0.9813251506995007>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (73)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.879803605757209, 1.5092134254157163, 7.001634805728266>
  direction <0.13651271533379672, -0.13367178305817756, -0.9815854125958055>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (74)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-1.0035611131621671, 1.5534353772086322, 6.977953611212804>
  direction <0.15719129858620037, -0.1413838452791535, -0.9775846922583297>
  right <0.8488197355971469, 0, 0.12125996222816386>
  up <0.010091401719619046, 0.5311264062957393, -0.0706398120373333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (75)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.778885969148709, 1.4768722636621252, 7.02044076862461>
  direction <0.12019526004973664, -0.13062349233599108, -0.9843301742343965>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (76)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.950808916008058, 1.3948854769812804, 7.007007125837104>
  direction <0.1480421220276786, -0.116937954243775, -0.9822093741214912>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (77)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8753703926007266, 1.600694907655072, 6.98985277787528>
  direction <0.1368865283566745, -0.14790190922250684, -0.9796007793273782>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (78)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8546999790739892, 1.5075999843427514, 7.005440005114343>
  direction <0.1341404172199694, -0.13524649615717696, -0.9817106012629165>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (79)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9302538800342796, 1.5342916207375028, 6.9910241543235845>
  direction <0.1437834967798092, -0.1379589278887273, -0.9799649027336577>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619045, 0.5311264062957393, -0.0706398120373333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (80)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9400479804823539, 1.6224488090609435, 6.977660807272821>
  direction <0.14671512832454892, -0.15159686281001414, -0.9776952356308058>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619045, 0.5311264062957393, -0.0706398120373333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (81)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.845592973660493, 1.451188218184707, 7.0143968884377195>
  direction <0.13123000499291512, -0.12555655391897613, -0.9834414380276801>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (82)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9495732439576846, 1.4275772029477432, 7.002746916177423>
  direction <0.1487698304242583, -0.12277231884749107, -0.9813136091543326>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (83)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8132559722985674, 1.5499932145987145, 7.005607210547522>
  direction <0.1255125400305143, -0.14075985976773145, -0.982194912942835>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (84)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-1.029331234647546, 1.504569066129557, 6.980904021789911>
  direction <0.15951425120595145, -0.13484260664918804, -0.978140581412432>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (85)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.7950540986780775, 1.5112327818897, 7.013467822646673>
  direction <0.12468930649792721, -0.13435813209026154, -0.9831813236322897>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (86)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9182934478053726, 1.5714923765662063, 6.987684113493819>
  direction <0.1435619525693701, -0.1448492599340579, -0.9790614354147112>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619045, 0.5311264062957393, -0.0706398120373333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (87)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9041158577829769, 1.384083323526656, 7.015143569266671>
  direction <0.14077288946531072, -0.1138783830717805, -0.9836630634323145>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619045, 0.5311264062957393, -0.0706398120373333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (88)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8422136757507789, 1.5982944265247794, 6.994915231292954>
  direction <0.13052559159310925, -0.14829114679609365, -0.9804566594800436>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619045, 0.5311264062957393, -0.0706398120373333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (89)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9753193116701906, 1.3900991425284661, 7.0041552147039665>
  direction <0.15214998462986212, -0.11659523219593289, -0.9816690488848151>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (90)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9361834994505942, 1.4973332214661756, 6.995192848593791>
  direction <0.1468012234185864, -0.13150106508204756, -0.9804102231661674>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619045, 0.5311264062957393, -0.0706398120373333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (91)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8688882503660011, 1.4667345283078583, 7.008959135391648>
  direction <0.13450125323600756, -0.12849449542746555, -0.9825753962168006>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (92)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8787323501745391, 1.5316226602268563, 6.998746588944278>
  direction <0.13653431729960286, -0.13940234369487225, -0.980804607657139>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619045, 0.5311264062957393, -0.0706398120373333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (93)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9228150167502248, 1.4919259071188993, 6.997836481640975>
  direction <0.14421887916129833, -0.13185150915641833, -0.9807315692214011>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (94)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9913650507679079, 1.5401965941382496, 6.981492597828679>
  direction <0.15332379993948753, -0.13873779133467432, -0.9784962993860393>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (95)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8152754582971896, 1.4287170364587636, 7.02177762243814>
  direction <0.1281097675044268, -0.12210088892549764, -0.9843561693465792>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (96)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.946700309558467, 1.575779171380126, 6.983044211090059>
  direction <0.14751312433563232, -0.14559214586662056, -0.9783961620715403>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619045, 0.5311264062957393, -0.0706398120373333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (97)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8296800768664249, 1.3902132102732245, 7.02494533905343>
  direction <0.1284976459026098, -0.11469143780666677, -0.9853063265129657>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (98)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9755475309806269, 1.4604063832007486, 6.994580914996952>
  direction <0.15295283942544663, -0.12651318352844512, -0.9802083476617477>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (99)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8407186901077205, 1.549957901255709, 7.001688757671337>
  direction <0.13011320260066972, -0.14183621340244046, -0.9813915988681021>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (100)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9061775846431178, 1.4130312685584314, 7.010920387175196>
  direction <0.14154934193038868, -0.11878767827604383, -0.9828858801595819>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (101)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9082486159735397, 1.62866147784299, 6.9813604257250885>
  direction <0.1412783093770664, -0.1536276937817625, -0.9781963112771376>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (102)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-1.005149834917833, 1.4734708833840457, 6.988578975123904>
  direction <0.1578851343711575, -0.1303027357725832, -0.9789894377220846>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (103)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.7693795091266419, 1.51664212212203, 7.016401496408204>
  direction <0.11828803702454814, -0.13572579002172716, -0.9839101799806449>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619045, 0.5311264062957393, -0.0706398120373333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (104)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8873977709298903, 1.4833409475334915, 7.004061189844756>
  direction <0.13847180646138094, -0.13022558967584338, -0.9817732401080388>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (105)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9580130486687628, 1.534820935500843, 6.986986723229348>
  direction <0.14884886680735052, -0.13967608439098597, -0.9790082357758453>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619045, 0.5311264062957393, -0.0706398120373333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (106)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.833207723832368, 1.579191697856391, 6.998794309029152>
  direction <0.13033813921688375, -0.14578756260137418, -0.9808232105316449>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (107)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9709694802066581, 1.3725689934138352, 7.007155710864314>
  direction <0.1505090477067358, -0.11217925958186926, -0.9825027790143132>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (108)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8101861353708608, 1.4693061219952082, 7.016996149819099>
  direction <0.1266451053535078, -0.12925648381082006, -0.9835942903479882>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (109)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9913841696071928, 1.577835028721712, 6.976381793301026>
  direction <0.15439973528890993, -0.14487619288565642, -0.9775095255542029>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619045, 0.5311264062957393, -0.0706398120373333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (110)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8482473938314888, 1.530564787512518, 7.003245151147374>
  direction <0.13312209571388525, -0.13690251450513122, -0.9816313304165634>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (111)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8938945923490524, 1.4473432935964197, 7.008018468390621>
  direction <0.13809312826540066, -0.12532636317094323, -0.9824922320188438>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (112)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9976513403427137, 1.5054393679144122, 6.9853116085912275>
  direction <0.15611252783912663, -0.13336021539933485, -0.9788277235630298>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (113)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8223517265494058, 1.520332988951188, 7.0083331334209955>
  direction <0.1279027719749546, -0.1371925288395047, -0.9823375890053171>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (114)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8878369711090112, 1.596623231576537, 6.98862442269904>
  direction <0.13926750588390557, -0.14874608489234528, -0.9791460729825814>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (115)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8809867933801118, 1.4004972209146753, 7.016220120964421>
  direction <0.13611780449721908, -0.11634970577983557, -0.98399268177452>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (116)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.7595703774785405, 1.5571623344433347, 7.012303629257184>
  direction <0.11823000193582742, -0.1432919015678293, -0.9828916412834913>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (117)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9809120975790704, 1.430170537766227, 6.997917984506145>
  direction <0.15250689734508294, -0.12191050263331703, -0.9808967032232814>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (118)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.957127999288711, 1.5798872748408859, 6.980997012801779>
  direction <0.1482170777931599, -0.14578912840554606, -0.9782688639473249>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (119)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8497884341936216, 1.408518542516759, 7.0195884214879225>
  direction <0.13302459681483264, -0.11777593586542699, -0.9842410087889594>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (120)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8728709826963651, 1.6376715951647274, 6.985191571699592>
  direction <0.13558745414747467, -0.154062812148234, -0.9789502388173438>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (121)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9403286512443801, 1.4284425209531515, 7.0039501362643035>
  direction <0.14694502524611283, -0.12215030470688909, -0.9816587118131495>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619045, 0.5311264062957393, -0.0706398120373333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (122)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.8478196233706001, 1.4721475407680784, 7.011234316128532>
  direction <0.13323062106425515, -0.12864710986304992, -0.9827362031393644>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (123)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9074418913998739, 1.5262316693939055, 6.995376860382274>
  direction <0.1401228400606488, -0.13850941559742722, -0.9804131446473571>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (124)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.7975786626065142, 1.435022800754049, 7.02344995381102>
  direction <0.124180255420958, -0.12159840178755764, -0.9849857228986523>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (125)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-1.0256872456754653, 1.52098717514543, 6.979196419705197>
  direction <0.15942169669163844, -0.13710068308701814, -0.9778473502550569>
  right <0.8488197355971469, 0, 0.1212599622281638>
  up <0.010091401719619045, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (126)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9477437216782502, 1.458339951428327, 6.998833332066406>
  direction <0.1468927567906113, -0.12613780166029293, -0.9811250184345449>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#case (127)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.0015625, 0.001875, 0.003125> }

camera {
  perspective
  location <-0.9059104145517981, 1.5613797488053867, 6.990825546297583>
  direction <0.14206642918845072, -0.14348710735368111, -0.9794599451764651>
  right <0.8488197355971469, 0, 0.12125996222816383>
  up <0.010091401719619046, 0.5311264062957393, -0.07063981203733333>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.028125, 0.0271875, 0.025> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.0046875, 0.005625, 0.0078125> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.001875, 0.001875, 0.0021875> rgb <0.00103125, 0.00103125, 0.0012031250000000002> scale 0.6 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5, 0.5, 0.52> transmit 0.5 rgb <0.275, 0.275, 0.28600000000000003> transmit 0.5 scale 0.6 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.2, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material2 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.45, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material3 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.65, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material4 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.6, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material5 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.45, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material6 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.25, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material7 =
  texture { pigment { rgb <0.001875, 0.001875, 0.0021875> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.2, 0.6> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.3 } specular 0.3 roughness 0.0125 } }

#declare Material8 =
  texture { pigment { rgb <0.25, 0.21875, 0.125> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.9, 0.5, 2.2>, 0.5 texture { Material1 } }
sphere { <-1.1, 0.5, 1.3>, 0.5 texture { Material2 } }
sphere { <-0.3, 0.5, 0.4>, 0.5 texture { Material3 } }
sphere { <0.6, 0.5, -0.6>, 0.5 texture { Material4 } }
sphere { <1.5, 0.5, -1.7>, 0.5 texture { Material5 } }
sphere { <2.5, 0.5, -3>, 0.5 texture { Material6 } }
sphere { <3.7, 0.5, -4.6>, 0.5 texture { Material7 } }
sphere { <-3.4, 2.2, -9>, 0.07 texture { Material8 } }
sphere { <-2.2, 3, -9>, 0.07 texture { Material8 } }
sphere { <-1, 2.4, -9>, 0.07 texture { Material8 } }
sphere { <0.4, 3.1, -9>, 0.07 texture { Material8 } }
sphere { <1.6, 2.5, -9>, 0.07 texture { Material8 } }
#break
#end
