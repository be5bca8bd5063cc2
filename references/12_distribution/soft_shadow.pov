// soft_shadow.scene, written by `course export`.
// povray +Isoft_shadow.pov +Osoft_shadow.png +W320 +H240 +FN16 -D -A File_Gamma=1.0 +KFI0 +KFF63
// then a pixel's samples are those of 64 pictures, weighed by our filter
#version 3.7;
#switch (frame_number)
#case (0)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <-0.0011846030591824708, -0.25436763855670036, -0.9671083226503098>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.5, 3.6, 0.3> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.5, 2.6, 0.3> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (1)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <-0.0008461450422731935, -0.25436763855670036, -0.9671083226503098>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.9, 3.6, 1.3> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.9, 2.6, 1.3> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (2)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <-0.0005076870253639161, -0.25436763855670036, -0.9671083226503098>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.5, 3.6, 1.3> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.5, 2.6, 1.3> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (3)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <-0.0001692290084546387, -0.25436763855670036, -0.9671083226503098>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.5, 3.6, 0.9000000000000001> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.5, 2.6, 0.9000000000000001> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (4)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <0.0001692290084546387, -0.25436763855670036, -0.9671083226503098>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.7000000000000002, 3.6, -0.1> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.7000000000000002, 2.6, -0.1> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (5)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <0.0005076870253639161, -0.25436763855670036, -0.9671083226503098>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.9, 3.6, 0.5> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.9, 2.6, 0.5> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (6)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <0.0008461450422731935, -0.25436763855670036, -0.9671083226503098>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <2.5, 3.6, 0.3> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <2.5, 2.6, 0.3> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (7)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <0.0011846030591824708, -0.25436763855670036, -0.9671083226503098>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <2.1, 3.6, 0.7> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <2.1, 2.6, 0.7> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (8)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <-0.0011846030591824708, -0.25469486167677935, -0.9670218422542889>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <2.1, 3.6, 0.9000000000000001> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <2.1, 2.6, 0.9000000000000001> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (9)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <-0.0008461450422731935, -0.25469486167677935, -0.9670218422542889>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.3, 3.6, 0.10000000000000003> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.3, 2.6, 0.10000000000000003> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (10)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <-0.0005076870253639161, -0.25469486167677935, -0.9670218422542889>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.1, 3.6, 1.1> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.1, 2.6, 1.1> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (11)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <-0.0001692290084546387, -0.25469486167677935, -0.9670218422542889>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.1, 3.6, 0.10000000000000003> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.1, 2.6, 0.10000000000000003> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (12)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <0.0001692290084546387, -0.25469486167677935, -0.9670218422542889>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.7000000000000002, 3.6, 1.1> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.7000000000000002, 2.6, 1.1> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (13)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <0.0005076870253639161, -0.25469486167677935, -0.9670218422542889>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.9, 3.6, -0.1> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.9, 2.6, -0.1> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (14)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <0.0008461450422731935, -0.25469486167677935, -0.9670218422542889>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.3, 3.6, 0.5> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.3, 2.6, 0.5> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (15)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <0.0011846030591824708, -0.25469486167677935, -0.9670218422542889>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.3, 3.6, 0.9000000000000001> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.3, 2.6, 0.9000000000000001> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (16)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <-0.0011846030591824708, -0.25502208479685834, -0.966935361858268>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <2.1, 3.6, 1.3> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <2.1, 2.6, 1.3> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (17)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <-0.0008461450422731935, -0.25502208479685834, -0.966935361858268>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <2.3, 3.6, 0.3> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <2.3, 2.6, 0.3> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (18)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <-0.0005076870253639161, -0.25502208479685834, -0.966935361858268>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.3, 3.6, 0.3> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.3, 2.6, 0.3> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (19)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <-0.0001692290084546387, -0.25502208479685834, -0.966935361858268>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.5, 3.6, 1.1> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.5, 2.6, 1.1> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (20)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <0.0001692290084546387, -0.25502208479685834, -0.966935361858268>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.5, 3.6, 0.10000000000000003> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.5, 2.6, 0.10000000000000003> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (21)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <0.0005076870253639161, -0.25502208479685834, -0.966935361858268>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <2.1, 3.6, 0.10000000000000003> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <2.1, 2.6, 0.10000000000000003> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (22)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <0.0008461450422731935, -0.25502208479685834, -0.966935361858268>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.3, 3.6, 1.3> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.3, 2.6, 1.3> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (23)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <0.0011846030591824708, -0.25502208479685834, -0.966935361858268>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <2.3, 3.6, 0.10000000000000003> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <2.3, 2.6, 0.10000000000000003> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (24)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <-0.0011846030591824708, -0.25534930791693733, -0.9668488814622471>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.5, 3.6, 0.7> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.5, 2.6, 0.7> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (25)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <-0.0008461450422731935, -0.25534930791693733, -0.9668488814622471>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.7000000000000002, 3.6, 0.7> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.7000000000000002, 2.6, 0.7> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (26)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <-0.0005076870253639161, -0.25534930791693733, -0.9668488814622471>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.5, 3.6, -0.1> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.5, 2.6, -0.1> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (27)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <-0.0001692290084546387, -0.25534930791693733, -0.9668488814622471>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.7000000000000002, 3.6, 0.5> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.7000000000000002, 2.6, 0.5> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (28)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <0.0001692290084546387, -0.25534930791693733, -0.9668488814622471>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.1, 3.6, 1.3> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.1, 2.6, 1.3> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (29)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <0.0005076870253639161, -0.25534930791693733, -0.9668488814622471>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.7000000000000002, 3.6, 1.3> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.7000000000000002, 2.6, 1.3> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (30)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <0.0008461450422731935, -0.25534930791693733, -0.9668488814622471>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.9, 3.6, 0.3> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.9, 2.6, 0.3> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (31)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <0.0011846030591824708, -0.25534930791693733, -0.9668488814622471>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <2.5, 3.6, 0.10000000000000003> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <2.5, 2.6, 0.10000000000000003> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (32)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <-0.0011846030591824708, -0.2556765310370164, -0.9667624010662264>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.7000000000000002, 3.6, 0.10000000000000003> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.7000000000000002, 2.6, 0.10000000000000003> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (33)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <-0.0008461450422731935, -0.2556765310370164, -0.9667624010662264>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.1, 3.6, 0.3> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.1, 2.6, 0.3> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (34)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <-0.0005076870253639161, -0.2556765310370164, -0.9667624010662264>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.9, 3.6, 0.7> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.9, 2.6, 0.7> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (35)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <-0.0001692290084546387, -0.2556765310370164, -0.9667624010662264>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <2.5, 3.6, 0.9000000000000001> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <2.5, 2.6, 0.9000000000000001> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (36)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <0.0001692290084546387, -0.2556765310370164, -0.9667624010662264>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.9, 3.6, 0.10000000000000003> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.9, 2.6, 0.10000000000000003> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (37)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <0.0005076870253639161, -0.2556765310370164, -0.9667624010662264>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <2.5, 3.6, 1.1> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <2.5, 2.6, 1.1> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (38)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <0.0008461450422731935, -0.2556765310370164, -0.9667624010662264>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.7000000000000002, 3.6, 0.3> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.7000000000000002, 2.6, 0.3> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (39)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <0.0011846030591824708, -0.2556765310370164, -0.9667624010662264>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <2.3, 3.6, 0.7> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <2.3, 2.6, 0.7> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (40)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <-0.0011846030591824708, -0.25600375415709536, -0.9666759206702055>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <2.3, 3.6, 1.1> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <2.3, 2.6, 1.1> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (41)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <-0.0008461450422731935, -0.25600375415709536, -0.9666759206702055>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <2.5, 3.6, 0.7> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <2.5, 2.6, 0.7> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (42)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <-0.0005076870253639161, -0.25600375415709536, -0.9666759206702055>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <2.1, 3.6, 0.3> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <2.1, 2.6, 0.3> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (43)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <-0.0001692290084546387, -0.25600375415709536, -0.9666759206702055>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <2.1, 3.6, 1.1> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <2.1, 2.6, 1.1> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (44)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <0.0001692290084546387, -0.25600375415709536, -0.9666759206702055>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.1, 3.6, 0.9000000000000001> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.1, 2.6, 0.9000000000000001> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (45)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <0.0005076870253639161, -0.25600375415709536, -0.9666759206702055>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.3, 3.6, 1.1> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.3, 2.6, 1.1> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (46)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <0.0008461450422731935, -0.25600375415709536, -0.9666759206702055>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <2.5, 3.6, -0.1> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <2.5, 2.6, -0.1> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (47)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <0.0011846030591824708, -0.25600375415709536, -0.9666759206702055>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <2.3, 3.6, 0.5> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <2.3, 2.6, 0.5> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (48)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <-0.0011846030591824708, -0.25633097727717435, -0.9665894402741846>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <2.1, 3.6, -0.1> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <2.1, 2.6, -0.1> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (49)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <-0.0008461450422731935, -0.25633097727717435, -0.9665894402741846>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.3, 3.6, -0.1> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.3, 2.6, -0.1> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (50)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <-0.0005076870253639161, -0.25633097727717435, -0.9665894402741846>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.9, 3.6, 0.9000000000000001> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.9, 2.6, 0.9000000000000001> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (51)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <-0.0001692290084546387, -0.25633097727717435, -0.9665894402741846>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.1, 3.6, -0.1> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.1, 2.6, -0.1> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (52)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <0.0001692290084546387, -0.25633097727717435, -0.9665894402741846>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.5, 3.6, 0.5> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.5, 2.6, 0.5> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (53)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <0.0005076870253639161, -0.25633097727717435, -0.9665894402741846>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.1, 3.6, 0.7> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.1, 2.6, 0.7> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (54)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <0.0008461450422731935, -0.25633097727717435, -0.9665894402741846>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.7000000000000002, 3.6, 0.9000000000000001> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.7000000000000002, 2.6, 0.9000000000000001> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (55)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <0.0011846030591824708, -0.25633097727717435, -0.9665894402741846>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <2.3, 3.6, -0.1> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <2.3, 2.6, -0.1> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (56)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <-0.0011846030591824708, -0.25665820039725334, -0.9665029598781637>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <2.3, 3.6, 0.9000000000000001> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <2.3, 2.6, 0.9000000000000001> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (57)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <-0.0008461450422731935, -0.25665820039725334, -0.9665029598781637>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.9, 3.6, 1.1> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.9, 2.6, 1.1> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (58)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <-0.0005076870253639161, -0.25665820039725334, -0.9665029598781637>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <2.1, 3.6, 0.5> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <2.1, 2.6, 0.5> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (59)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <-0.0001692290084546387, -0.25665820039725334, -0.9665029598781637>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.3, 3.6, 0.7> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.3, 2.6, 0.7> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (60)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <0.0001692290084546387, -0.25665820039725334, -0.9665029598781637>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <2.3, 3.6, 1.3> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <2.3, 2.6, 1.3> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (61)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <0.0005076870253639161, -0.25665820039725334, -0.9665029598781637>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <1.1, 3.6, 0.5> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <1.1, 2.6, 0.5> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (62)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <0.0008461450422731935, -0.25665820039725334, -0.9665029598781637>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <2.5, 3.6, 0.5> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <2.5, 2.6, 0.5> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (63)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <0.0011846030591824708, -0.25665820039725334, -0.9665029598781637>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6282683905516719, -0.1660423603600847>
}

light_source { <2.5, 3.6, 1.3> rgb <3259493234522.017, 3096518572795.916, 2852056580206.765> spotlight point_at <2.5, 2.6, 1.3> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.72, 0.68> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.35, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.5, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.2, 0.7, 0.3>, 0.7 texture { Material1 } }
box { <0.35, 0, 0.2>, <0.6, 1.5, 0.45> texture { Material2 } }
box { <1.5, 0, -0.6>, <1.75, 1.5, -0.35> texture { Material2 } }
polygon { 5, <1, 3.6, -0.2>, <2.6, 3.6, -0.2>, <2.6, 3.6, 1.4000000000000001>, <1, 3.6, 1.4000000000000001>, <1, 3.6, -0.2> texture { pigment { rgb <8, 7.6, 7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#end
