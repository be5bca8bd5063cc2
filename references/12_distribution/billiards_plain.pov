// billiards_plain.scene, written by `course export`.
// povray +Ibilliards_plain.pov +Obilliards_plain.png +W180 +H120 +FN16 -D -A File_Gamma=1.0 +KFI0 +KFF127
// then a pixel's samples are those of 128 pictures, weighed by our filter, times 64
#version 3.7;
#switch (frame_number)
#case (0)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.199813748037382, 4.293902574156997, 7.203683732557872>
  direction <-0.11443336547740586, -0.509508801275567, -0.8528251086640275>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-1.7722613367019222, 5.2, -0.3936015831073746> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.7722613367019222, 4.2, -0.3936015831073746> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.6812620661454276, 5.2, 0.5133363114204258> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <1.6812620661454276, 4.2, 0.5133363114204258> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.517775789584266, 0, -0.13625678673270158> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.09810488644754514, 0, 0.18530922995647417> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.16350814407924188, 0, -0.24526221611886287> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (1)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2147363898516015, 4.3155170469022766, 7.188689833235917>
  direction <-0.1187098630189634, -0.5140580162349091, -0.8495151978792109>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-2.397953545465134, 5.2, 0.44009320156183096> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.397953545465134, 4.2, 0.44009320156183096> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.4350629400229082, 5.2, -0.16379046442452816> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.4350629400229082, 4.2, -0.16379046442452816> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.01675437045343677, 0, -0.004409044856167571> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.003174512296440651, 0, 0.005996301004387897> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.005290853827401085, 0, -0.007936280741101628> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (2)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2266447684000803, 4.263484667315732, 7.218293123899121>
  direction <-0.11843410834668613, -0.5071118523119869, -0.8537203200813449>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-1.2842896078014747, 5.2, 0.5993963713757694> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.2842896078014747, 4.2, 0.5993963713757694> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.26156202100683, 5.2, -0.47421497306786475> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.26156202100683, 4.2, -0.47421497306786475> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.8291376617911737, 0, -0.2181941215239931> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.15709976749727503, 0, 0.2967440052726306> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.2618329458287917, 0, -0.3927494187431876> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (3)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1794300198369878, 4.3179456216784216, 7.192024267157928>
  direction <-0.11373159956283915, -0.5118055293231838, -0.8515423114952916>
  right <0.7136937289148793, 0, -0.09685843463844786>
  up <-0.03299946595867764, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-2.0770170660922305, 5.2, 0.06878427285701039> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.0770170660922305, 4.2, 0.06878427285701039> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.7523415840929375, 5.2, 0.5983498251065612> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.7523415840929375, 4.2, 0.5983498251065612> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.2864085122221149, 0, -0.07537066111108287> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.05426687599997967, 0, 0.10250409911107271> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.09044479333329944, 0, -0.13566718999994917> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (4)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1633836518696257, 4.28037811915825, 7.21674249003703>
  direction <-0.11127475630577474, -0.5086995112933445, -0.8537393510409397>
  right <0.7136937289148793, 0, -0.09685843463844786>
  up <-0.032999465958677636, 0.41272076441175737, -0.2431539596955195>
}

light_source { <-2.474490966438316, 5.2, -0.5608510185498744> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.474490966438316, 4.2, -0.5608510185498744> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.6027261641807855, 5.2, 0.2269645414547995> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.6027261641807855, 4.2, 0.2269645414547995> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1995629291736986, 0, -0.05251656030886806> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.037811923422385, 0, 0.07142252202006057> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.06301987237064167, 0, -0.0945298085559625> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (5)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2284723802065483, 4.329420736378186, 7.178483449430772>
  direction <-0.11835943587166105, -0.513361872418877, -0.8499804421388213>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-1.5329463548492641, 5.2, 0.16010234537534418> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.5329463548492641, 4.2, 0.16010234537534418> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.8548284268705175, 5.2, 0.058366433694027386> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <1.8548284268705175, 4.2, 0.058366433694027386> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.6201835453975946, 0, -0.16320619615726173> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.11750846123322845, 0, 0.22196042677387598> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.19584743538871408, 0, -0.2937711530830711> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (6)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.204433041458365, 4.281397392721038, 7.210559937312314>
  direction <-0.1144343652279424, -0.5102266632469089, -0.8523942558007923>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-1.466634474368766, 5.2, -0.07219992557074872> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.466634474368766, 4.2, -0.07219992557074872> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.1600565522909165, 5.2, 0.7344553385395557> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.1600565522909165, 4.2, 0.7344553385395557> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.4292747395462356, 0, -0.11296703672269358> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.08133626644033938, 0, 0.15363516994286328> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.13556044406723228, 0, -0.20334066610084844> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (7)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1775392891138345, 4.30495741196673, 7.200073792154513>
  direction <-0.11444753759663873, -0.5113813786341297, -0.8516996388898512>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-1.9038302913773806, 5.2, 0.7240911816246808> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.9038302913773806, 4.2, 0.7240911816246808> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <3.030179591407068, 5.2, -0.3288681187201291> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <3.030179591407068, 4.2, -0.3288681187201291> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.7510155087092425, 0, -0.19763566018664278> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.14229767533438278, 0, 0.2687844978538342> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.23716279222397132, 0, -0.355744188335957> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (8)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1681937256454662, 4.291040687967759, 7.209692153024603>
  direction <-0.11153310826612524, -0.5097686109080728, -0.8530628292203408>
  right <0.7136937289148793, 0, -0.09685843463844786>
  up <-0.03299946595867764, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-2.5101660440210254, 5.2, 0.6655904983403161> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.5101660440210254, 4.2, 0.6655904983403161> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <3.00546786331106, 5.2, 0.4179420977365226> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <3.00546786331106, 4.2, 0.4179420977365226> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.5726576394413132, 0, -0.1506993788003456> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.10850355273624882, 0, 0.20495115516847> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1808392545604147, 0, -0.2712588818406221> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (9)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2250209053699963, 4.301078165304936, 7.195957406516825>
  direction <-0.1193360871785251, -0.5127195531686681, -0.8502332881544437>
  right <0.7136937289148793, 0, -0.09685843463844786>
  up <-0.032999465958677636, 0.41272076441175737, -0.2431539596955195>
}

light_source { <-1.5990738083142788, 5.2, 0.025848349649459146> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.5990738083142788, 4.2, 0.025848349649459146> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.043111885106191, 5.2, -0.058894533687271156> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.043111885106191, 4.2, -0.058894533687271156> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1502616954629775, 0, -0.03954255143762566> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.028470637035090476, 0, 0.0537778699551709> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.04745106172515079, 0, -0.07117659258772618> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (10)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2155070659086364, 4.2740629993305825, 7.213457670028336>
  direction <-0.11870974161333066, -0.5068945550353418, -0.85381329107543>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-2.029729441413656, 5.2, -0.27832821537740526> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.029729441413656, 4.2, -0.27832821537740526> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.668095528287813, 5.2, -0.522374278656207> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.668095528287813, 4.2, -0.522374278656207> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.33718318930245, 0, -0.08873241823748684> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.06388734113099052, 0, 0.12067608880298211> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.10647890188498421, 0, -0.15971835282747632> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (11)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1916091522147891, 4.336560547711887, 7.179202429286575>
  direction <-0.11312589146931734, -0.515856126487714, -0.8491941564378371>
  right <0.7136937289148793, 0, -0.09685843463844786>
  up <-0.032999465958677636, 0.41272076441175737, -0.2431539596955195>
}

light_source { <-1.3694130920572207, 5.2, 0.34252848776523026> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.3694130920572207, 4.2, 0.34252848776523026> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.9446878488175572, 5.2, 0.6487480198033154> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <1.9446878488175572, 4.2, 0.6487480198033154> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.8561591106495928, 0, -0.2253050291183139> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.162219620965186, 0, 0.30641483960090693> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.2703660349419767, 0, -0.405549052412965> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (12)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1899238908466798, 4.264660817915543, 7.2225709812071965>
  direction <-0.11484503581273763, -0.5061869058577791, -0.8547623763691911>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-2.2672498043626548, 5.2, -0.16961361877620218> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.2672498043626548, 4.2, -0.16961361877620218> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.8445187692064793, 5.2, 0.04279592363163831> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.8445187692064793, 4.2, 0.04279592363163831> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.2592364990839269, 0, -0.0682201313378755> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.04911849456327035, 0, 0.09277937861951067> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.08186415760545059, 0, -0.1227962364081759> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (13)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.204413398450346, 4.330144529357062, 7.181314321167502>
  direction <-0.11533798211349934, -0.5156074376541935, -0.8490431574362389>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-1.6741487191990019, 5.2, 0.8637327402597293> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.6741487191990019, 4.2, 0.8637327402597293> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.2168132391758264, 5.2, 0.31306440706830474> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.2168132391758264, 4.2, 0.31306440706830474> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.6478273780026939, 0, -0.17048088894807734> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.12274624004261568, 0, 0.23185400896938518> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.2045770667376928, 0, -0.30686560010653924> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (14)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.248377338613103, 4.296772783072105, 7.195370834202102>
  direction <-0.12318286345115054, -0.5114634908220268, -0.8504648630682864>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-1.1848693791776896, 5.2, -0.4197885635308921> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.1848693791776896, 4.2, -0.4197885635308921> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.5035888590151445, 5.2, 0.8755181117216125> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.5035888590151445, 4.2, 0.8755181117216125> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.3827357935835607, 0, -0.10071994567988439> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.07251836088951676, 0, 0.13697912612464277> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.12086393481586126, 0, -0.1812959022237919> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (15)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1632022436428846, 4.3111110473637035, 7.198327352801672>
  direction <-0.1093142573638468, -0.5107243754192173, -0.8527905002789633>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-2.1618170333327726, 5.2, 0.27786530773155393> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.1618170333327726, 4.2, 0.27786530773155393> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.715559381316416, 5.2, -0.25680354565847663> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <1.715559381316416, 4.2, -0.25680354565847663> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.7351639696909115, 0, -0.19346420255023986> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.13929422583617268, 0, 0.2631113154683262> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.2321570430602878, 0, -0.34823556459043176> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (16)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1800788401617337, 4.266119213851346, 7.223032057667242>
  direction <-0.11199403013839895, -0.5082331121624749, -0.8539215747850337>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-1.293209122400731, 5.2, -0.2254379960009828> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.293209122400731, 4.2, -0.2254379960009828> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.946907946863212, 5.2, -0.09212543258909134> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.946907946863212, 4.2, -0.09212543258909134> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.490284634665586, 0, -0.12902227228041738> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.09289603604190051, 0, 0.17547029030136765> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.15482672673650086, 0, -0.23224009010475127> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (17)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2286993380750628, 4.316820662972798, 7.186012692048991>
  direction <-0.1204509730821231, -0.5123583747971924, -0.8502986892332692>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-1.9870923403883354, 5.2, 0.406569714169018> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.9870923403883354, 4.2, 0.406569714169018> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.0062614837894217, 5.2, 0.3570619444129989> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.0062614837894217, 4.2, 0.3570619444129989> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.0997577379294671, 0, -0.026252036297228186> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.018901466134004292, 0, 0.035702769364230336> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.03150244355667382, 0, -0.047253665335010735> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (18)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2198969935627328, 4.293448208326174, 7.201230768735067>
  direction <-0.1186478269682721, -0.5108043406019079, -0.8514758224373199>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-2.566835185070522, 5.2, -0.01988692386075852> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.566835185070522, 4.2, -0.01988692386075852> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.9163050028961153, 5.2, -0.5568090067477897> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <1.9163050028961153, 4.2, -0.5568090067477897> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.8208950476720929, 0, -0.2160250125452876> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.15553800903260706, 0, 0.2937940170615912> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.2592300150543451, 0, -0.3888450225815177> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (19)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1941521505209436, 4.317980480336286, 7.190005348513243>
  direction <-0.1145519390057248, -0.5119159951205278, -0.8513647002353507>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-1.6307356393896044, 5.2, 0.6974102549487725> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.6307356393896044, 4.2, 0.6974102549487725> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.7203820994123817, 5.2, 0.6949825117830187> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.7203820994123817, 4.2, 0.6949825117830187> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.2926672968384809, 0, -0.07701770969433709> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.0554527509799227, 0, 0.10474408518429845> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.09242125163320451, 0, -0.13863187744980676> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (20)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1633528188899736, 4.331094261673047, 7.186316989003961>
  direction <-0.11141564422088023, -0.5136772399046745, -0.8507335933713773>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-2.199153822171502, 5.2, -0.4757481457432732> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.199153822171502, 4.2, -0.4757481457432732> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.9004925419809298, 5.2, 0.24998197574168446> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.9004925419809298, 4.2, 0.24998197574168446> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.17593310946831478, 0, -0.046298186702188104> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.033334694425575434, 0, 0.06296553391497582> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.05555782404262572, 0, -0.08333673606393859> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (21)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2346467950579463, 4.282665190669746, 7.205698820554574>
  direction <-0.11883621800874301, -0.5091038881414723, -0.8524705265580885>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-1.1420878366567195, 5.2, 0.31076924989465626> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.1420878366567195, 4.2, 0.31076924989465626> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.2090666151139886, 5.2, -0.012069069338031091> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.2090666151139886, 4.2, -0.012069069338031091> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.595617695619585, 0, -0.15674149884725921> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.11285387917002664, 0, 0.21316843843227254> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.18808979861671105, 0, -0.28213469792506657> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (22)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1863726906157523, 4.285553701923062, 7.210517199405453>
  direction <-0.11226292194019033, -0.5089491935798456, -0.8534554334757969>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-1.7434603644302116, 5.2, -0.19069870482198892> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.7434603644302116, 4.2, -0.19069870482198892> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.7568723113741727, 5.2, 0.8501672924961895> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <1.7568723113741727, 4.2, 0.8501672924961895> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.7746831973397638, 0, -0.20386399929993784> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.14678207949595523, 0, 0.2772550390479155> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.2446367991599254, 0, -0.36695519873988813> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (23)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2005390993208775, 4.309029924395794, 7.194508881883261>
  direction <-0.11724876521467323, -0.5134360267659047, -0.8500866834054815>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-2.28727388815023, 5.2, 0.8516895920969546> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.28727388815023, 4.2, 0.8516895920969546> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.489851948595606, 5.2, -0.30536134298890827> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.489851948595606, 4.2, -0.30536134298890827> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.4593542476114816, 0, -0.12088269673986358> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.08703554165270178, 0, 0.1644004675662145> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1450592360878363, 0, -0.21758885413175447> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (24)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1868910980341074, 4.327509238260904, 7.185273522310257>
  direction <-0.11429969762902062, -0.5153675167495028, -0.8493280200162326>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-1.202423633215949, 5.2, 0.12538009984418752> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.202423633215949, 4.2, 0.12538009984418752> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.6337095439899714, 5.2, -0.19542713791597632> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <1.6337095439899714, 4.2, -0.19542713791597632> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.5372520555451047, 0, -0.1413821198802907> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1017951263138093, 0, 0.19227968303719536> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.16965854385634885, 0, -0.2544878157845233> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (25)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2120853525494664, 4.2684260535146805, 7.217304212902335>
  direction <-0.11655213498644788, -0.5067671517827655, -0.8541825510691956>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-2.097089660842903, 5.2, 0.5308450314681977> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.097089660842903, 4.2, 0.5308450314681977> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.3505886806175114, 5.2, 0.44420975013636055> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.3505886806175114, 4.2, 0.44420975013636055> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.12088197409524583, 0, -0.03181104581453838> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.02290395298646763, 0, 0.043263022307772195> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.03817325497744605, 0, -0.05725988246616908> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (26)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2432377440467863, 4.309773407901524, 7.188267975709879>
  direction <-0.12282454730332239, -0.5106601863990156, -0.8509954743421556>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-2.34100954644382, 5.2, -0.3339480539085343> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.34100954644382, 4.2, -0.3339480539085343> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.7846135614905507, 5.2, -0.44751014434732495> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.7846135614905507, 4.2, -0.44751014434732495> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.35456155992927957, 0, -0.09330567366559989> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.06718008503923191, 0, 0.12689571618521586> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.11196680839871986, 0, -0.1679502125980798> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (27)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1593580426051262, 4.2987505487242395, 7.206265364983333>
  direction <-0.10882054534880733, -0.5116207508334503, -0.852319678803893>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-1.841889788536355, 5.2, 0.4893930658930913> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.841889788536355, 4.2, 0.4893930658930913> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.3092510050861166, 5.2, 0.5679536638548598> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.3092510050861166, 4.2, 0.5679536638548598> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.909166466193544, 0, -0.23925433320882739> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1722631199103557, 0, 0.3253858931640053> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.28710519985059285, 0, -0.4306577997758893> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (28)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2261712082897966, 4.288267240721175, 7.203487848727965>
  direction <-0.11971639638522623, -0.5096321803893535, -0.8520340984296945>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-1.4864217854570598, 5.2, -0.5507760180858895> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.4864217854570598, 4.2, -0.5507760180858895> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <3.0784375802846626, 5.2, 0.7752770723076537> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <3.0784375802846626, 4.2, 0.7752770723076537> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.40593417799915177, 0, -0.10682478368398732> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.07691384425247087, 0, 0.14528170581022276> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.12818974042078476, 0, -0.1922846106311772> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (29)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.168705922371394, 4.303673215176155, 7.20204312428676>
  direction <-0.11161385465651766, -0.5131195036935516, -0.8510413351103575>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-2.443759730574675, 5.2, 0.22531720970291647> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.443759730574675, 4.2, 0.22531720970291647> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.0991190946893767, 5.2, -0.3847702304134145> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.0991190946893767, 4.2, -0.3847702304134145> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.7100970596214755, 0, -0.18686764726880936> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.13454470603354274, 0, 0.25414000028558076> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.22424117672257124, 0, -0.33636176508385685> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (30)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2076740602927676, 4.331241460587276, 7.180213644036473>
  direction <-0.11756783683798207, -0.5150776749598586, -0.8490583919116603>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-1.8683964082971216, 5.2, -0.08921763163525609> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.8683964082971216, 4.2, -0.08921763163525609> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.8054517616052181, 5.2, 0.1755462492350489> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <1.8054517616052181, 4.2, 0.1755462492350489> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.6846019694581628, 0, -0.180158413015306> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.12971405737102032, 0, 0.24501544170081618> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.2161900956183672, 0, -0.3242851434275508> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (31)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1928933509022204, 4.270914726469728, 7.2184156379242905>
  direction <-0.1135648743497265, -0.5066195186573613, -0.8546765448879933>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-1.3874093395657838, 5.2, 0.8016859255498275> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.3874093395657838, 4.2, 0.8016859255498275> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.558338135620579, 5.2, 0.13457677743863317> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.558338135620579, 4.2, 0.13457677743863317> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.22240625795209776, 0, -0.0585279626189731> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.04214013308566063, 0, 0.07959802916180342> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.07023355514276772, 0, -0.10535033271415158> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (32)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.173401187304166, 4.2761034287558, 7.217947781612383>
  direction <-0.11248052292293644, -0.507748381827913, -0.8541463889650122>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-1.9537044260883705, 5.2, 0.05495529805775734> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.9537044260883705, 4.2, 0.05495529805775734> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.6653946781530977, 5.2, -0.4314768316922709> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <1.6653946781530977, 4.2, -0.4314768316922709> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.5933151113288477, 0, -0.15613555561285467> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.11241760004125535, 0, 0.21234435563348236> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1873626667354256, 0, -0.2810440001031384> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (33)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2388007615668042, 4.320172999793732, 7.182630382482552>
  direction <-0.11934231415770234, -0.5148650381553939, -0.8489451520723769>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-1.3226729869144038, 5.2, 0.6361970561323688> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.3226729869144038, 4.2, 0.6361970561323688> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.416149395541288, 5.2, 0.5263717546826229> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.416149395541288, 4.2, 0.5263717546826229> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.15596707188989964, 0, -0.0410439662868157> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.029551655726507302, 0, 0.05581979415006935> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.049252759544178834, 0, -0.07387913931626826> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (34)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2062541113614607, 4.299364761775498, 7.199532370678503>
  direction <-0.11789903083131607, -0.5111333906098156, -0.8513800147654479>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-1.658355309534818, 5.2, -0.31684332867152987> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.658355309534818, 4.2, -0.31684332867152987> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.7332595444982872, 5.2, -0.21935153009835628> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.7332595444982872, 4.2, -0.21935153009835628> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.46248655888601203, 0, -0.12170698918052948> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.08762903220998122, 0, 0.16552150528552012> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.14604838701663536, 0, -0.21907258052495307> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (35)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1842542338929951, 4.308600181780166, 7.196976816332136>
  direction <-0.11229724617793593, -0.5109464057153087, -0.8522524479051106>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-2.579772352264263, 5.2, 0.3682228448800743> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.579772352264263, 4.2, 0.3682228448800743> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.27979715205729, 5.2, 0.4778061978053302> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.27979715205729, 4.2, 0.4778061978053302> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.7836992451723198, 0, -0.20623664346639997> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.14849038329580797, 0, 0.28048183511430397> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.24748397215967996, 0, -0.37122595823952> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (36)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1719909895390932, 4.325431756209988, 7.188542169122273>
  direction <-0.11199521330212157, -0.5134408619106644, -0.8507967643639006>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-2.2989201214164496, 5.2, -0.4437200831249356> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.2989201214164496, 4.2, -0.4437200831249356> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.1320779610192404, 5.2, 0.11289051964413377> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.1320779610192404, 4.2, 0.11289051964413377> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.08213484148626386, 0, -0.021614431970069438> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.015562391018449995, 0, 0.029395627479294438> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.025937318364083323, 0, -0.03890597754612499> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (37)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.222507346673497, 4.2744321113935575, 7.212286164686748>
  direction <-0.11879072804769542, -0.5091620365220149, -0.8524418111673339>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-1.7279033618047834, 5.2, 0.24382110298611226> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.7279033618047834, 4.2, 0.24382110298611226> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <3.0255057541886345, 5.2, 0.1599341286113486> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <3.0255057541886345, 4.2, 0.1599341286113486> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.4819065817422233, 0, -0.1268175215111114> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.0913086154880002, 0, 0.1724718292551115> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.15218102581333368, 0, -0.2282715387200005> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (38)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.21608683158202, 4.302721050216451, 7.19618415701257>
  direction <-0.119012052094145, -0.5100191649665132, -0.8518974972657596>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-1.1154747167835013, 5.2, -0.14564686235971747> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.1154747167835013, 4.2, -0.14564686235971747> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.8740944680990652, 5.2, 0.7844888467574492> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <1.8740944680990652, 4.2, 0.7844888467574492> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.8082367021648679, 0, -0.2126938689907547> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.15313958567334338, 0, 0.2892636618274264> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.2552326427889056, 0, -0.3828489641833585> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (39)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1950890755410344, 4.286632186200513, 7.208687170884838>
  direction <-0.11378535293949381, -0.5100660935803047, -0.8525786778399016>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-2.2020431340439246, 5.2, 0.8907355379546061> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.2020431340439246, 4.2, 0.8907355379546061> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.6087177616078407, 5.2, -0.407757549919188> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.6087177616078407, 4.2, -0.407757549919188> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.3057306701771449, 0, -0.08045543952030129> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.05792791645461693, 0, 0.10941939774760977> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.09654652742436155, 0, -0.14481979113654234> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (40)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2374185248715783, 4.284594531454925, 7.204165052751617>
  direction <-0.11867522562836098, -0.5091048034228534, -0.852491826355169>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-2.4167259900365026, 5.2, -0.04222737522795794> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.4167259900365026, 4.2, -0.04222737522795794> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.5315343452617527, 5.2, -0.03650899745989589> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.5315343452617527, 4.2, -0.03650899745989589> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.22007736454368565, 0, -0.05791509593254886> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.04169886907143518, 0, 0.07876453046826645> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.06949811511905862, 0, -0.10424717267858795> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (41)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.154154229414877, 4.308093850417455, 7.201365615757508>
  direction <-0.11115281107831243, -0.5136981834499917, -0.8507566974563926>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-1.5214453859021888, 5.2, 0.7452771215233952> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.5214453859021888, 4.2, 0.7452771215233952> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.7220440585166217, 5.2, 0.27452486297115686> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <1.7220440585166217, 4.2, 0.27452486297115686> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.6730449597281404, 0, -0.1771170946653001> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.12752430815901605, 0, 0.24087924874480815> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.2125405135983601, 0, -0.3188107703975402> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (42)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1840689210690991, 4.283919361191777, 7.211810458282699>
  direction <-0.11449332980630525, -0.5082054965006455, -0.8535989535129157>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-1.428018606407568, 5.2, -0.5919624833855778> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.428018606407568, 4.2, -0.5919624833855778> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.2555142850847916, 5.2, -0.28605203577317295> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.2555142850847916, 4.2, -0.28605203577317295> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.6972429409145843, 0, -0.1834849844512064> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1321091888048686, 0, 0.24953957885364073> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.22018198134144767, 0, -0.33027297201217154> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (43)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2011596411800203, 4.340529260306385, 7.175525063941738>
  direction <-0.11557430795243893, -0.516238984555406, -0.848632156503084>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-1.8847423991188408, 5.2, 0.1958202185109258> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.8847423991188408, 4.2, 0.1958202185109258> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.821875999006443, 5.2, 0.8162477105855942> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.821875999006443, 4.2, 0.8162477105855942> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.419145865405444, 0, -0.11030154352774843> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.07941711133997886, 0, 0.1500100991977379> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1323618522332981, 0, -0.19854277834994719> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (44)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2285286487530944, 4.312928757213443, 7.188371000484014>
  direction <-0.12082234556543012, -0.5120994829260721, -0.8504036238046354>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-2.110894285165705, 5.2, -0.3814184274757281> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.110894285165705, 4.2, -0.3814184274757281> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.6395393805811183, 5.2, 0.3701849122066051> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.6395393805811183, 4.2, 0.3701849122066051> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.35950790019589474, 0, -0.0946073421568144> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.06811728635290637, 0, 0.1286659853332676> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.11352881058817728, 0, -0.17029321588226592> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (45)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.176793895385942, 4.291973274175646, 7.20796543540652>
  direction <-0.11085118181873796, -0.5111256573299107, -0.8523411485279548>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-1.2404397787991912, 5.2, 0.46632654857821765> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.2404397787991912, 4.2, 0.46632654857821765> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.9626824821112678, 5.2, -0.12386761188972739> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <1.9626824821112678, 4.2, -0.12386761188972739> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.8839979257943523, 0, -0.23263103310377695> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1674943438347194, 0, 0.31637820502113667> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.2791572397245323, 0, -0.4187358595867985> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (46)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1963493058227057, 4.323874952964657, 7.186170479573839>
  direction <-0.11554920238580654, -0.5146084488570641, -0.8496138851061321>
  right <0.7136937289148793, 0, -0.09685843463844786>
  up <-0.03299946595867764, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-1.807341910339892, 5.2, 0.09865654804743829> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.807341910339892, 4.2, 0.09865654804743829> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.0570780908688904, 5.2, 0.672521372884512> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.0570780908688904, 4.2, 0.672521372884512> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.11081153044244273, 0, -0.02916092906380072> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.02099586892593652, 0, 0.039658863526768985> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.034993114876560864, 0, -0.0524896723148413> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (47)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2209549278664598, 4.26565860087798, 7.217760956405621>
  direction <-0.1176094012946548, -0.5053727349692904, -0.8548757150154527>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-2.3529495378257708, 5.2, 0.5809957661898807> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.3529495378257708, 4.2, 0.5809957661898807> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.976844595768489, 5.2, -0.5866350487573072> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.976844595768489, 4.2, -0.5866350487573072> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.5461101077299099, 0, -0.14371318624471313> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.10347349409619346, 0, 0.19544993329280988> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.17245582349365576, 0, -0.25868373524048366> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (48)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2375464654564934, 4.30585930644087, 7.191388824394954>
  direction <-0.11840443215335954, -0.5112095334233197, -0.8512657388979252>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-1.6926871539559216, 5.2, -0.48417081534862516> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.6926871539559216, 4.2, -0.48417081534862516> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <3.0580273813335226, 5.2, 0.0953747430816293> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <3.0580273813335226, 4.2, 0.0953747430816293> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.6328767908969893, 0, -0.16654652392026037> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.11991349722258746, 0, 0.2265032725315541> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.19985582870431243, 0, -0.29978374305646865> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (49)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1561358060768672, 4.286697059260309, 7.213934762190526>
  direction <-0.11220632830604804, -0.5103316459956826, -0.8526336425909282>
  right <0.7136937289148793, 0, -0.09685843463844786>
  up <-0.032999465958677636, 0.41272076441175737, -0.2431539596955195>
}

light_source { <-2.225117029179819, 5.2, 0.3250736497342587> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.225117029179819, 4.2, 0.3250736497342587> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.0857002914650367, 5.2, 0.21885442533530297> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.0857002914650367, 4.2, 0.21885442533530297> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.18840497954864988, 0, -0.04958025777596049> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.03569778559869155, 0, 0.06742915057530628> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.05949630933115259, 0, -0.08924446399672889> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (50)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.202641626905965, 4.274625998896933, 7.214865894153174>
  direction <-0.11635550549297567, -0.50631667972215, -0.8544795197368219>
  right <0.7136937289148793, 0, -0.09685843463844786>
  up <-0.03299946595867764, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-2.1464244853938, 5.2, -0.21459026997908948> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.1464244853938, 4.2, -0.21459026997908948> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.8178179098991678, 5.2, -0.3584451012080535> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <1.8178179098991678, 4.2, -0.3584451012080535> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.7686620915937237, 0, -0.20227949778782203> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.14564123840723187, 0, 0.275100116991438> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.24273539734538643, 0, -0.36410309601807966> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (51)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1817832596652416, 4.3359450587441355, 7.180905236656093>
  direction <-0.11276396955698041, -0.5162152401700432, -0.8490278062022568>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-1.1542933171382175, 5.2, 0.8076859150081873> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.1542933171382175, 4.2, 0.8076859150081873> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.567911604559049, 5.2, 0.7519095538649708> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.567911604559049, 4.2, 0.7519095538649708> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.4456848422740585, 0, -0.11728548480896278> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.0844455490624532, 0, 0.1595082593401894> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.14074258177075533, 0, -0.21111387265613302> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (52)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2341463531296535, 4.293841037122875, 7.199061229801536>
  direction <-0.12071133427795681, -0.5101935922680965, -0.8515622240170065>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-1.3533506711479277, 5.2, -0.00045507391914723083> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.3533506711479277, 4.2, -0.00045507391914723083> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.813544413098134, 5.2, 0.4997929042205215> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.813544413098134, 4.2, 0.4997929042205215> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.8431243615376297, 0, -0.22187483198358676> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.15974987902818247, 0, 0.301749771497678> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.2662497983803041, 0, -0.3993746975704562> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (53)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1749588056917488, 4.314209767491167, 7.194872587304277>
  direction <-0.11110394460538527, -0.5143267257698815, -0.8503862039429273>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-2.010475492128171, 5.2, 0.6859412542311475> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.010475492128171, 4.2, 0.6859412542311475> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.340173888974823, 5.2, -0.14930359928403047> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.340173888974823, 4.2, -0.14930359928403047> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.2722748789598699, 0, -0.07165128393680788> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.05158892443450167, 0, 0.09744574615405872> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.08598154072416946, 0, -0.12897231108625418> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (54)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2132446143998166, 4.323386726470378, 7.184170480734942>
  direction <-0.11721259682371278, -0.5128844966711767, -0.850422510029663>
  right <0.7136937289148793, 0, -0.09685843463844786>
  up <-0.03299946595867764, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-2.5377337379846723, 5.2, -0.27106462956871835> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.5377337379846723, 4.2, -0.27106462956871835> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.3786645323503763, 5.2, -0.5021295426646247> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.3786645323503763, 4.2, -0.5021295426646247> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.5110635236487724, 0, -0.13449040096020326> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.09683308869134634, 0, 0.18290694530587645> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1613884811522439, 0, -0.24208272172836587> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (55)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.200053195150618, 4.258640892385381, 7.224808245226901>
  direction <-0.11644306909604375, -0.5064248023978323, -0.8544027624995676>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-1.5842918806243689, 5.2, 0.41279323466587814> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.5842918806243689, 4.2, 0.41279323466587814> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.61686031348072, 5.2, 0.5947506418218836> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <1.61686031348072, 4.2, 0.5947506418218836> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.06741990278200939, 0, -0.017742079679476157> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.012774297369222832, 0, 0.024129228364087575> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.02129049561537139, 0, -0.031935743423057085> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (56)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.219514145115051, 4.330726449715857, 7.1789157819048715>
  direction <-0.11627212332617529, -0.5148551190092573, -0.8493677723157662>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-1.5493026135023684, 5.2, -0.11925944932736454> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.5493026135023684, 4.2, -0.11925944932736454> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.7728111708071084, 5.2, 0.019425527402199827> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <1.7728111708071084, 4.2, 0.019425527402199827> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.7216446987190284, 0, -0.1899064996629022> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1367326797572896, 0, 0.258272839541547> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.22788779959548264, 0, -0.341831699393224> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (57)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1778160625960787, 4.280287182386223, 7.21483836778737>
  direction <-0.11464385548998239, -0.5073985185977634, -0.8540627117690028>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-2.4985658480087296, 5.2, 0.7762653832091019> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.4985658480087296, 4.2, 0.7762653832091019> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.4449496923713014, 5.2, 0.3319284270750359> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.4449496923713014, 4.2, 0.3319284270750359> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.3718927349930163, 0, -0.0978665092086885> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.07046388663025571, 0, 0.13309845252381639> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1174398110504262, 0, -0.1761597165756393> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (58)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2111778737521683, 4.290783961963225, 7.204012625669985>
  direction <-0.11600727266781985, -0.5096497608294975, -0.8525269312415418>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-1.4396896867780016, 5.2, 0.21507259514182808> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.4396896867780016, 4.2, 0.21507259514182808> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.168207734148018, 5.2, 0.8838592917658389> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.168207734148018, 4.2, 0.8838592917658389> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.6544960234768222, 0, -0.17223579565179534> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.12400977286929264, 0, 0.23424068208644166> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.2066829547821544, 0, -0.3100244321732316> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (59)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.189524237460482, 4.300070502348915, 7.201379409221014>
  direction <-0.11442192461559193, -0.512543670790213, -0.8510057396436291>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-1.9326522271381692, 5.2, -0.5205285091884434> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.9326522271381692, 4.2, -0.5205285091884434> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.8795110136503355, 5.2, -0.22798633240163324> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.8795110136503355, 4.2, -0.22798633240163324> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.24551653051283207, 0, -0.06460961329285055> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.04651892157085239, 0, 0.08786907407827675> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.07753153595142065, 0, -0.11629730392713099> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (60)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2069431111871556, 4.313856778675031, 7.190743653419582>
  direction <-0.11766531872739779, -0.513237208760557, -0.850149441946249>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-1.262571939174086, 5.2, -0.36560062123462556> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.262571939174086, 4.2, -0.36560062123462556> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.686103131528944, 5.2, -0.08212232440710066> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.686103131528944, 4.2, -0.08212232440710066> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.8636800579779231, 0, -0.227284225783664> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.16364464256423808, 0, 0.30910654706578305> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.2727410709403968, 0, -0.4091116064105952> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (61)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1879095593043765, 4.296981515264528, 7.203451936364261>
  direction <-0.11326492893058573, -0.509186681638594, -0.8531769539775655>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-2.050291129294783, 5.2, 0.5071487108711153> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.050291129294783, 4.2, 0.5071487108711153> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.8982044118689374, 5.2, 0.3851401654304937> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <1.8982044118689374, 4.2, 0.3851401654304937> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.32220898530445985, 0, -0.08479183823801575> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.06105012353137134, 0, 0.11531690000370143> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.10175020588561891, 0, -0.15262530882842837> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (62)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.234713782013362, 4.274243983351603, 7.2107424538586535>
  direction <-0.12050624187328, -0.5071281808297436, -0.8534293048492243>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-1.8025490389205516, 5.2, 0.5635560313006863> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.8025490389205516, 4.2, 0.5635560313006863> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.9929903351236136, 5.2, -0.5456220046849921> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <1.9929903351236136, 4.2, -0.5456220046849921> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1389685944910161, 0, -0.03657068276079371> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.026330891587771472, 0, 0.04973612855467945> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.043884819312952454, 0, -0.06582722896942869> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (63)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1643789239191615, 4.322682645127715, 7.191224701820056>
  direction <-0.11082733710954144, -0.5148964058283031, -0.850081935496596>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-2.3698097231332214, 5.2, 0.14514893826562913> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.3698097231332214, 4.2, 0.14514893826562913> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.928613321413286, 5.2, 0.630874085566029> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.928613321413286, 4.2, 0.630874085566029> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.5637232042197138, 0, -0.14834821163676679> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.10681071237847208, 0, 0.20175356782600284> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.17801785396412015, 0, -0.2670267809461802> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (64)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.236706532511791, 4.315031519704339, 7.1859994873365105>
  direction <-0.11867952736251772, -0.5136195172382085, -0.8497824142591774>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-1.9086758175631986, 5.2, 0.10747939345892521> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.9086758175631986, 4.2, 0.10747939345892521> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.949040256231092, 5.2, 0.2964901955332607> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.949040256231092, 4.2, 0.2964901955332607> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.14381952220224772, 0, -0.03784724268480204> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.027250014733057465, 0, 0.05147225005133078> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.045416691221762444, 0, -0.06812503683264368> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (65)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1552506553010968, 4.2943906491124215, 7.209438735884541>
  direction <-0.11144510925746193, -0.5087482707305887, -0.8536869760494357>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-1.4539100943598897, 5.2, 0.5411740451585502> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.4539100943598897, 4.2, 0.5411740451585502> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.0116057513747365, 5.2, 0.05347763139288875> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.0116057513747365, 4.2, 0.05347763139288875> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.5779500955005642, 0, -0.1520921303948853> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.10950633388431742, 0, 0.20684529733704404> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.18251055647386236, 0, -0.2737658347107936> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (66)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2073412435516868, 4.25943754923194, 7.223341158835964>
  direction <-0.11642305467044288, -0.5055190099893422, -0.854948954188136>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-2.4622353408718483, 5.2, 0.500422942196019> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.4622353408718483, 4.2, 0.500422942196019> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.7045177282067017, 5.2, -0.2646000238833949> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.7045177282067017, 4.2, -0.2646000238833949> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.8542859121435321, 0, -0.22481208214303477> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.16186469914298504, 0, 0.3057444317145273> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.2697744985716417, 0, -0.4046617478574626> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (67)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1810925413302251, 4.320904750720393, 7.190023161815805>
  direction <-0.11417705064003422, -0.514520209327057, -0.8498530494182055>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-1.5386809054994957, 5.2, -0.33024545225780455> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.5386809054994957, 4.2, -0.33024545225780455> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.9273416105657817, 5.2, 0.8532442046329379> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <1.9273416105657817, 4.2, 0.8532442046329379> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.3328153000574093, 0, -0.08758297369931824> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.06305974106350913, 0, 0.11911284423107281> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.10509956843918188, 0, -0.15764935265877283> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (68)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2310560189666735, 4.2872939859027674, 7.203408863027148>
  direction <-0.12116809103723594, -0.5099110752202556, -0.8516697458283803>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-2.065122349560261, 5.2, 0.7846723940223456> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.065122349560261, 4.2, 0.7846723940223456> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.186853706976399, 5.2, 0.4256299684988335> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.186853706976399, 4.2, 0.4256299684988335> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.6386723887256811, 0, -0.1680716812436003> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.12101161049539222, 0, 0.22857748649129644> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.20168601749232037, 0, -0.30252902623848055> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (69)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.175538271673272, 4.305470259908825, 7.200037650041904>
  direction <-0.11088920457039486, -0.5106348612840412, -0.8526304659248944>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-1.2724422238767148, 5.2, -0.10059986289124934> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.2724422238767148, 4.2, -0.10059986289124934> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.9045253281015904, 5.2, -0.04270025810692457> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.9045253281015904, 4.2, -0.04270025810692457> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.2521077149850316, 0, -0.06634413552237674> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.047767777576111246, 0, 0.09022802431043236> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.07961296262685208, 0, -0.11941944394027813> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (70)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2157864246137893, 4.33404163742789, 7.1774325742028235>
  direction <-0.11782645842231183, -0.514977480470663, -0.8490834099615899>
  right <0.7136937289148793, 0, -0.09685843463844786>
  up <-0.032999465958677636, 0.41272076441175737, -0.2431539596955195>
}

light_source { <-1.7633705947315321, 5.2, 0.24101326810196044> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.7633705947315321, 4.2, 0.24101326810196044> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.7462799952132628, 5.2, -0.5135908355237916> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <1.7462799952132628, 4.2, -0.5135908355237916> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.3924452946952078, 0, -0.10327507755137047> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.07435805583698674, 0, 0.14045410546986384> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.12393009306164456, 0, -0.18589513959246684> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (71)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2001044860360452, 4.275867780910261, 7.214465151206094>
  direction <-0.11498285854484812, -0.5096594034081006, -0.8526601733253545>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-2.4024362445576117, 5.2, -0.5301095836563036> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.4024362445576117, 4.2, -0.5301095836563036> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.469606794207357, 5.2, 0.6609258742304519> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.469606794207357, 4.2, 0.6609258742304519> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.7421253467001951, 0, -0.1952961438684724> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.14061322358530012, 0, 0.2656027556611225> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.23435537264216688, 0, -0.3515330589632503> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (72)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1868982547334612, 4.290769442659214, 7.207316428404931>
  direction <-0.11354020936796481, -0.5099818074273403, -0.8526625190163877>
  right <0.7136937289148793, 0, -0.09685843463844786>
  up <-0.032999465958677636, 0.41272076441175737, -0.2431539596955195>
}

light_source { <-1.3728327126242221, 5.2, -0.4677564449608326> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.3728327126242221, 4.2, -0.4677564449608326> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.795741971838288, 5.2, -0.17048981089610604> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <1.795741971838288, 4.2, -0.17048981089610604> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.042235591907644705, 0, -0.011114629449380187> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.008002533203553734, 0, 0.015115896051157054> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.013337555339256223, 0, -0.020006333008884335> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (73)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2072800173812714, 4.300916635307771, 7.198462016456451>
  direction <-0.11729491685888277, -0.5099488319317645, -0.8521727368685372>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-2.019722865568474, 5.2, 0.2986791267525405> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.019722865568474, 4.2, 0.2986791267525405> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.5450327943777666, 5.2, 0.5086197072872892> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.5450327943777666, 4.2, 0.5086197072872892> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.5251561466581187, 0, -0.13819898596266283> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.09950326989311724, 0, 0.18795062090922146> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1658387831551954, 0, -0.2487581747327931> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (74)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.170253783964513, 4.32558359189419, 7.1886868313254455>
  direction <-0.11095763128634994, -0.513889465890185, -0.8506684166783285>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-2.526481366157532, 5.2, -0.1892962364014238> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.526481366157532, 4.2, -0.1892962364014238> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.106592402001843, 5.2, 0.617335459892638> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.106592402001843, 4.2, 0.617335459892638> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.8280658652447163, 0, -0.21791206980124114> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.15689669025689362, 0, 0.29636041492968795> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.26149448376148937, 0, -0.3922417256422341> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (75)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2428525098129817, 4.279599884028074, 7.2064243718228225>
  direction <-0.12194609037467007, -0.5100288000070095, -0.8514935253319619>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-1.6134300498757512, 5.2, 0.8325797822093591> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.6134300498757512, 4.2, 0.8325797822093591> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <3.094260234758258, 5.2, -0.46306722240988163> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <3.094260234758258, 4.2, -0.46306722240988163> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.2753180310712196, 0, -0.07245211343979463> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.05216552167665213, 0, 0.0985348742781207> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.08694253612775356, 0, -0.13041380419163034> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (76)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.175471602261734, 4.273438333530927, 7.219265853860208>
  direction <-0.11277553829661922, -0.5082837262950152, -0.853785144484037>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-2.1748424616176636, 5.2, -0.24067977236118165> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.1748424616176636, 4.2, -0.24067977236118165> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.362047771480866, 5.2, 0.0764244247460738> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.362047771480866, 4.2, 0.0764244247460738> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.610673314750893, 0, -0.16070350388181395> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.11570652279490604, 0, 0.21855676527926698> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.19284420465817673, 0, -0.28926630698726513> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (77)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.217641739441751, 4.326737427151489, 7.181563307642012>
  direction <-0.11696426726190517, -0.5128313046498758, -0.8504881271115459>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-1.1770665568998084, 5.2, 0.3907153293024749> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.1770665568998084, 4.2, 0.3907153293024749> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.6386553124990315, 5.2, 0.23374532230664047> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <1.6386553124990315, 4.2, 0.23374532230664047> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.20418375900597308, 0, -0.0537325681594666> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.03868744907481595, 0, 0.07307629269687459> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.06447908179135992, 0, -0.09671862268703989> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (78)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2156437514014176, 4.29759828768183, 7.199317946843567>
  direction <-0.11569800933487565, -0.5119175288144213, -0.8512082419029154>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-1.682300249603577, 5.2, -0.03276628106832502> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.682300249603577, 4.2, -0.03276628106832502> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.326416304241866, 5.2, -0.33227603186387566> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.326416304241866, 4.2, -0.33227603186387566> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.4229387101181782, 0, -0.11129966055741532> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.08013575560133902, 0, 0.15136753835808484> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.13355959266889839, 0, -0.20033938900334758> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (79)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.191864906751417, 4.3141358785336505, 7.19262252124926>
  direction <-0.11640078663806361, -0.5119790299597149, -0.8510759642960212>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-2.2496754742693157, 5.2, 0.7059560323599726> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.2496754742693157, 4.2, 0.7059560323599726> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.783107019867748, 5.2, 0.7187051417771727> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.783107019867748, 4.2, 0.7187051417771727> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.7459546347963624, 0, -0.19630385126220062> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.14133877290878444, 0, 0.26697323771659287> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.23556462151464075, 0, -0.3533469322719611> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (80)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1942149147940107, 4.341484944850266, 7.175894151796367>
  direction <-0.11463964778875098, -0.5149566833661985, -0.849528383953109>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-1.7543880436802284, 5.2, 0.6441705842502415> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.7543880436802284, 4.2, 0.6441705842502415> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.9321355311200024, 5.2, -0.3158862696960568> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <1.9321355311200024, 4.2, -0.3158862696960568> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.22826086596120146, 0, -0.060068648937158284> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.04324942723475396, 0, 0.08169336255453527> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.07208237872458993, 0, -0.10812356808688492> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (81)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2156214174451399, 4.280868079496119, 7.209359102791917>
  direction <-0.1180083324968355, -0.508857722754308, -0.8527305816812891>
  right <0.7136937289148793, 0, -0.09685843463844786>
  up <-0.03299946595867764, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-2.2766527064610274, 5.2, 0.018129209498874865> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.2766527064610274, 4.2, 0.018129209498874865> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.6658565546618775, 5.2, 0.8372390928911045> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.6658565546618775, 4.2, 0.8372390928911045> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.6760263795731589, 0, -0.17790167883504182> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.12808920876123012, 0, 0.2419462832156569> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.21348201460205019, 0, -0.3202230219030753> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (82)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.179479728425424, 4.284735907307191, 7.211943349615092>
  direction <-0.11178928916990685, -0.5105334056747669, -0.852569184951954>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-1.1301640810212121, 5.2, -0.2877207700163126> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.1301640810212121, 4.2, -0.2877207700163126> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.022503525740467, 5.2, 0.2632588286418468> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.022503525740467, 4.2, 0.2632588286418468> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.398438691063784, 0, -0.10485228712204843> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.07549364672787487, 0, 0.14259911048598586> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.12582274454645812, 0, -0.1887341168196872> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (83)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.233457796802005, 4.307445389469968, 7.190992065323462>
  direction <-0.12113860545006229, -0.5115980542659427, -0.8506615600163703>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-2.1854452289640904, 5.2, 0.35643051294609907> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.1854452289640904, 4.2, 0.35643051294609907> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.9880538874072955, 5.2, 0.0034659999422729237> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.9880538874072955, 4.2, 0.0034659999422729237> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.7083381800423375, 0, -0.18640478422166779> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1342114446396008, 0, 0.25351050654146823> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.22368574106600134, 0, -0.33552861159900205> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (84)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1542601313947807, 4.312646933080285, 7.198619393748252>
  direction <-0.11147230260515292, -0.5138257062898172, -0.8506368241881402>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-2.562527453666553, 5.2, 0.868871028861031> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.562527453666553, 4.2, 0.868871028861031> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.223943997663446, 5.2, -0.09746495427098123> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.223943997663446, 4.2, -0.09746495427098123> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.5327526045870036, 0, -0.14019805383868517> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.10094259876385332, 0, 0.19066935322061185> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1682376646064222, 0, -0.2523564969096333> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (85)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.236711879398783, 4.292297664569716, 7.199639074768336>
  direction <-0.11851583329930063, -0.5093874432883011, -0.8523438742519871>
  right <0.7136937289148793, 0, -0.09685843463844786>
  up <-0.032999465958677636, 0.41272076441175737, -0.2431539596955195>
}

light_source { <-1.6244385914411397, 5.2, -0.15845685373060403> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.6244385914411397, 4.2, -0.15845685373060403> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.8556920832721517, 5.2, 0.3474456331226975> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.8556920832721517, 4.2, 0.3474456331226975> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.12428956521674991, 0, -0.03270778032019735> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.02354960183054209, 0, 0.044482581235468395> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.03924933638423681, 0, -0.05887400457635523> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (86)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1984393733480077, 4.323248803631408, 7.186262517152497>
  direction <-0.11457243571503313, -0.5144134570153356, -0.8498634414022028>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-1.3061305001843722, 5.2, 0.2865628716303036> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.3061305001843722, 4.2, 0.2865628716303036> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.6955046403687448, 5.2, 0.7082631400320679> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <1.6955046403687448, 4.2, 0.7082631400320679> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.34270421477966007, 0, -0.09018531967885791> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.0649334301687777, 0, 0.12265203476324678> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.10822238361462949, 0, -0.16233357542194424> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (87)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1884980307593829, 4.263243357970777, 7.2236149667573315>
  direction <-0.11439866963562668, -0.5052960786451568, -0.8553574509636582>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-1.9741872084792704, 5.2, -0.43240324188955126> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.9741872084792704, 4.2, -0.43240324188955126> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.5014274717774243, 5.2, -0.5673447695095092> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.5014274717774243, 4.2, -0.5673447695095092> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.9263487905132274, 0, -0.2437759975034809> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.17551871820250622, 0, 0.33153535660473404> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.29253119700417707, 0, -0.4387967955062656> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (88)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2305229443190053, 4.324957885902382, 7.18088286887242>
  direction <-0.12011812585180537, -0.5136105972714596, -0.8495925278728236>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-1.4940637129126118, 5.2, 0.45048536660615357> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.4940637129126118, 4.2, 0.45048536660615357> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.2714687924832107, 5.2, 0.763867377745919> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.2714687924832107, 4.2, 0.763867377745919> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.29875411824556064, 0, -0.07861950480146333> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.0566060434570536, 0, 0.10692252652999014> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.094343405761756, 0, -0.141515108642634> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (89)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1688395970560816, 4.276857736827487, 7.218114269731611>
  direction <-0.11155162550856362, -0.5092280341193693, -0.8533846622392318>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-2.4581330509623514, 5.2, -0.40666840157937256> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.4581330509623514, 4.2, -0.40666840157937256> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.768720664572902, 5.2, -0.3705487817293033> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.768720664572902, 4.2, -0.3705487817293033> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.8147889735887291, 0, -0.21441815094440242> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.15438106867996973, 0, 0.2916086852843873> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.2573017811332829, 0, -0.38595267169992437> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (90)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1865011616076306, 4.302485055476117, 7.200340951924723>
  direction <-0.11272370073585324, -0.5097494982410097, -0.8529127164139727>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-1.8520572026260198, 5.2, 0.6088530465262011> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.8520572026260198, 4.2, 0.6088530465262011> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.427509353286587, 5.2, 0.18836867236532273> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.427509353286587, 4.2, 0.18836867236532273> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.09172818953371004, 0, -0.024138997245713167> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.01738007801691348, 0, 0.03282903625416991> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.0289667966948558, 0, -0.0434501950422837> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (91)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2081414317880905, 4.287943413718874, 7.206129043168864>
  direction <-0.11763638217778256, -0.5103443935681946, -0.8518890581648285>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-1.3976543774129824, 5.2, 0.06459238249808552> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.3976543774129824, 4.2, 0.06459238249808552> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.6861302112462, 5.2, 0.13975514341145756> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <1.6861302112462, 4.2, 0.13975514341145756> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.5005757886439096, 0, -0.13173047069576568> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.09484593890095129, 0, 0.17915344014624135> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1580765648349188, 0, -0.23711484725237825> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (92)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2107915339271484, 4.307858759837876, 7.193820178778591>
  direction <-0.11714303179693601, -0.5136364817776999, -0.8499807599336688>
  right <0.7136937289148793, 0, -0.09685843463844786>
  up <-0.03299946595867764, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-1.8334272001171485, 5.2, -0.5712131683481857> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.8334272001171485, 4.2, -0.5712131683481857> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.8351761143654586, 5.2, 0.4334125380031765> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <1.8351761143654586, 4.2, 0.4334125380031765> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.16961894670734182, 0, -0.04463656492298469> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.03213832674454898, 0, 0.060705728295259186> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.05356387790758163, 0, -0.08034581686137245> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (93)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.190721335521398, 4.299806492870462, 7.201375351599819>
  direction <-0.11378666117823409, -0.5109834905157352, -0.8520280621319571>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-2.323816530779004, 5.2, 0.166920683789067> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.323816530779004, 4.2, 0.166920683789067> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.5914341456023977, 5.2, -0.18921304810792205> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.5914341456023977, 4.2, -0.18921304810792205> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.6024396225600502, 0, -0.1585367427789606> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.11414645480085163, 0, 0.21560997017938643> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1902440913347527, 0, -0.2853661370021291> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (94)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1738690360627178, 4.319767575837048, 7.191685799603546>
  direction <-0.11437735935926556, -0.512461916413402, -0.8510608404116456>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-1.2103096619481222, 5.2, 0.734027388249524> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.2103096619481222, 4.2, 0.734027388249524> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.1460168030112983, 5.2, -0.4564923957455903> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.1460168030112983, 4.2, -0.4564923957455903> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.4525427746435161, 0, -0.11909020385355687> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.08574494677456095, 0, 0.16196267724083735> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.14290824462426824, 0, -0.21436236693640237> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (95)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2249797907815914, 4.271251108491793, 7.213859220441709>
  direction <-0.11665227414998842, -0.5078066802168123, -0.8535452436937158>
  right <0.7136937289148793, 0, -0.09685843463844786>
  up <-0.03299946595867764, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-2.0870690889656545, 5.2, -0.08245885991491375> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.0870690889656545, 4.2, -0.08245885991491375> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <3.045155318826437, 5.2, 0.5487308924552053> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <3.045155318826437, 4.2, 0.5487308924552053> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.7799853365716989, 0, -0.2052592990978155> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.14778669535042716, 0, 0.2791526467730291> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.2463111589173786, 0, -0.3694667383760679> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (96)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1887604050651353, 4.329014261508039, 7.1841168166934795>
  direction <-0.1141781404541968, -0.5151958992321668, -0.8494474875717889>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-2.43185015746858, 5.2, 0.5599306678399444> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.43185015746858, 4.2, 0.5599306678399444> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.176474039349705, 5.2, -0.5883941448060795> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.176474039349705, 4.2, -0.5883941448060795> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.794471910947468, 0, -0.2090715555124916> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.15053151996899394, 0, 0.2843373154969886> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.2508858666149899, 0, -0.37632879992248486> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (97)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2136153633587317, 4.264427583204646, 7.219495650764242>
  direction <-0.11827166474133433, -0.5052415345178731, -0.8548645566756822>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-1.4996723073069007, 5.2, 0.13462136811576786> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.4996723073069007, 4.2, 0.13462136811576786> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.8748589424882085, 5.2, 0.6785593386506662> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.8748589424882085, 4.2, 0.6785593386506662> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.47360301750362843, 0, -0.12463237302727065> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.08973530857963487, 0, 0.1695000273170881> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.14955884763272478, 0, -0.22433827144908716> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (98)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1684696933373784, 4.295810362571257, 7.206792895504316>
  direction <-0.11051297929278998, -0.5100168529560244, -0.8530523300665226>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-1.885425485461019, 5.2, -0.344927505380474> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.885425485461019, 4.2, -0.344927505380474> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.464856835687533, 5.2, -0.11873940357472745> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.464856835687533, 4.2, -0.11873940357472745> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1639836834021844, 0, -0.043153600895311686> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.031070592644624414, 0, 0.058688897217623895> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.05178432107437402, 0, -0.07767648161156104> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (99)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.225521484254707, 4.310242471000667, 7.190390887393605>
  direction <-0.11962736728313113, -0.5133362523774477, -0.8498237377578364>
  right <0.7136937289148793, 0, -0.09685843463844786>
  up <-0.03299946595867764, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-1.415875358064659, 5.2, 0.5181447288254276> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.415875358064659, 4.2, 0.5181447288254276> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.7757898463401944, 5.2, 0.37654158726800235> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <1.7757898463401944, 4.2, 0.37654158726800235> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.5872616668278351, 0, -0.15454254390206187> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.11127063160948454, 0, 0.21017785970680417> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.18545105268247425, 0, -0.2781765790237114> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (100)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1903736946067447, 4.272724686680193, 7.217671615152398>
  direction <-0.11390310241711525, -0.5068924265046203, -0.8544668977990637>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-1.2284008676884697, 5.2, -0.5126021275296807> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.2284008676884697, 4.2, -0.5126021275296807> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.9232673945603893, 5.2, -0.2773681706981733> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.9232673945603893, 4.2, -0.2773681706981733> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.4815383777173701, 0, -0.1267206257150974> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.09123885051487013, 0, 0.17234005097253247> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.15206475085811688, 0, -0.22809712628717532> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (101)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2060153892661638, 4.336162215577925, 7.177486296395695>
  direction <-0.11656384021187009, -0.5156784411053714, -0.8488341889093249>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-2.1207770264241845, 5.2, 0.2011106390040368> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.1207770264241845, 4.2, 0.2011106390040368> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.9785343304043637, 5.2, 0.8291675862623379> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <1.9785343304043637, 4.2, 0.8291675862623379> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.0781701627473056, 0, -0.02057109545981726> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.014811188731068427, 0, 0.027976689825351477> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.024685314551780715, 0, -0.03702797182767107> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (102)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1582560600808007, 4.30206859852982, 7.204424089871142>
  direction <-0.10864950264010409, -0.5130141855806571, -0.8515068308946073>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-2.357867646054365, 5.2, -0.12468916552606968> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.357867646054365, 4.2, -0.12468916552606968> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.8908494748407976, 5.2, -0.016263150167651452> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <1.8908494748407976, 4.2, -0.016263150167651452> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.7959701136732473, 0, -0.20946581938769668> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1508153899591416, 0, 0.2848735143672675> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.251358983265236, 0, -0.377038474897854> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (103)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2455175468221527, 4.291302315285287, 7.1990412294743935>
  direction <-0.12303340100171681, -0.5099355315816655, -0.8514019228020692>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-1.8214542923029513, 5.2, 0.7633676395984367> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.8214542923029513, 4.2, 0.7633676395984367> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.6911351086106152, 5.2, 0.28196717854589226> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.6911351086106152, 4.2, 0.28196717854589226> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.3128581422043498, 0, -0.08233109005377627> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.05927838483871891, 0, 0.11197028247313573> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.09879730806453152, 0, -0.14819596209679728> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (104)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2027824129306783, 4.294519751278081, 7.2029105360497026>
  direction <-0.11552939582973958, -0.5099917283820076, -0.8523866054237752>
  right <0.7136937289148793, 0, -0.09685843463844786>
  up <-0.032999465958677636, 0.41272076441175737, -0.2431539596955195>
}

light_source { <-1.9642322756350041, 5.2, 0.8239050027681515> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.9642322756350041, 4.2, 0.8239050027681515> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.394494678499177, 5.2, 0.8032508034724742> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.394494678499177, 4.2, 0.8032508034724742> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.36371500282897606, 0, -0.09571447442867792> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.0689144215886481, 0, 0.130171685223002> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1148573693144135, 0, -0.17228605397162025> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (105)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1833381309156104, 4.316234852164172, 7.19252034236295>
  direction <-0.11412073927040221, -0.5143478713926217, -0.8499640944361738>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-1.3176727346377448, 5.2, -0.2055109236622229> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.3176727346377448, 4.2, -0.2055109236622229> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.6022117467597128, 5.2, -0.3951008055824786> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <1.6022117467597128, 4.2, -0.3951008055824786> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.8908007721074426, 0, -0.23442125581774806> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1687833041887786, 0, 0.3188129079121374> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.28130550698129764, 0, -0.4219582604719465> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (106)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2317255412034704, 4.318668464227517, 7.184493312300162>
  direction <-0.11835664561417351, -0.5135065037175606, -0.8498940420374129>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-2.596881422121078, 5.2, -0.5041169285774231> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.596881422121078, 4.2, -0.5041169285774231> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.7969021677505226, 5.2, 0.11984747936949136> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.7969021677505226, 4.2, 0.11984747936949136> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.10308907580794767, 0, -0.02712870415998623> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.019532666995190084, 0, 0.03689503765758127> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.032554444991983476, 0, -0.04883166748797521> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (107)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.167819148552743, 4.269648158112294, 7.222578506400466>
  direction <-0.11307598834422902, -0.5062155871578898, -0.8549852526027079>
  right <0.7136937289148793, 0, -0.09685843463844786>
  up <-0.032999465958677636, 0.41272076441175737, -0.2431539596955195>
}

light_source { <-1.6495034452760593, 5.2, 0.33661458673886957> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.6495034452760593, 4.2, 0.33661458673886957> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.3323594148037956, 5.2, 0.1618107096059248> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.3323594148037956, 4.2, 0.1618107096059248> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.5516490967047866, 0, -0.14517081492231226> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.10452298674406482, 0, 0.1974323082943447> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.17420497790677472, 0, -0.2613074668601621> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (108)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2311412111403335, 4.280897854238003, 7.20723498023101>
  direction <-0.11828517471915112, -0.5099579026375569, -0.8520329023068826>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-2.2162783772451804, 5.2, -0.010890171071514465> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.2162783772451804, 4.2, -0.010890171071514465> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.8325667164986954, 5.2, 0.5402560179121793> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <1.8325667164986954, 4.2, 0.5402560179121793> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.6912553231557831, 0, -0.18190929556731134> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.13097469280846416, 0, 0.24739664197154343> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.2182911546807736, 0, -0.3274367320211604> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (109)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.174288377836202, 4.333980272213294, 7.183101271108539>
  direction <-0.11279625518980659, -0.5144476732952294, -0.8500839647055473>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-1.1073907857295127, 5.2, 0.6712762418668717> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.1073907857295127, 4.2, 0.6712762418668717> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.577312792907469, 5.2, -0.42101470325142143> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.577312792907469, 4.2, -0.42101470325142143> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.410926848470699, 0, -0.10813864433439448> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.07785982392076402, 0, 0.1470685562947765> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.12976637320127338, 0, -0.19464955980191007> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (110)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.220103423473761, 4.304688011468741, 7.1944588713616024>
  direction <-0.11649724830857938, -0.5102326642363865, -0.8521106925033051>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-1.7121588067617268, 5.2, -0.2541735642822459> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.7121588067617268, 4.2, -0.2541735642822459> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.0769079404650257, 5.2, -0.20800344881135968> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.0769079404650257, 4.2, -0.20800344881135968> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.2120292533573229, 0, -0.055797171936137605> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.04017396379401907, 0, 0.07588415383314714> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.06695660632336513, 0, -0.10043490948504769> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (111)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1973963225588868, 4.28270211409792, 7.210732087765399>
  direction <-0.11687427186100033, -0.5095647580398456, -0.8524602687391156>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-2.3101005831500516, 5.2, 0.42386882866267117> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.3101005831500516, 4.2, 0.42386882866267117> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <3.0765276522375644, 5.2, 0.4593147925101221> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <3.0765276522375644, 4.2, 0.4593147925101221> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.6652693999325856, 0, -0.17507089471910148> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.12605104419775306, 0, 0.23809641681797802> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.21008507366292176, 0, -0.31512761049438265> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (112)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1658606896928336, 4.31006951288668, 7.198591484381107>
  direction <-0.11071109950578041, -0.5114178096845668, -0.8521848682862054>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-1.99986341947224, 5.2, -0.1313736997777596> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.99986341947224, 4.2, -0.1313736997777596> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.0555400856770576, 5.2, -0.24329353859648106> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.0555400856770576, 4.2, -0.24329353859648106> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.31821634796564463, 0, -0.08374114420148543> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.0602936238250695, 0, 0.1138879561140202> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.10048937304178251, 0, -0.15073405956267377> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (113)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2260467956230563, 4.298366657772708, 7.197445083073246>
  direction <-0.11866836141157165, -0.511933478387137, -0.8507955529488773>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-1.3430258725071327, 5.2, 0.8874644806841389> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.3430258725071327, 4.2, 0.8874644806841389> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.966238543065265, 5.2, 0.8940510975429788> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.966238543065265, 4.2, 0.8940510975429788> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.8752724530319433, 0, -0.23033485606103773> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.16584109636394717, 0, 0.31325540424301135> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.27640182727324525, 0, -0.41460274090986793> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (114)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2119791901990962, 4.325470227190737, 7.183092116444252>
  direction <-0.11546161256456247, -0.51460236857206, -0.8496294204671606>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-2.5491477080155165, 5.2, 0.26231829668395223> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.5491477080155165, 4.2, 0.26231829668395223> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.6487159814219923, 5.2, 0.022345359530299924> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.6487159814219923, 4.2, 0.022345359530299924> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.5570661382609977, 0, -0.1465963521739468> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.10554937356524169, 0, 0.19937103895656763> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.17591562260873614, 0, -0.26387343391310425> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (115)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1975739292504735, 4.266957369664628, 7.220154830660087>
  direction <-0.11702090440362663, -0.5055964990544756, -0.8548213239995526>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-1.5755194844910876, 5.2, -0.4589781287591904> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.5755194844910876, 4.2, -0.4589781287591904> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.9659042810322718, 5.2, 0.32232431389857086> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <1.9659042810322718, 4.2, 0.32232431389857086> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1280504002375528, 0, -0.033697473746724424> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.024262181097641583, 0, 0.04582856429554522> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.04043696849606931, 0, -0.060655452744103965> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (116)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2489884836327683, 4.304024653473236, 7.190936770851612>
  direction <-0.12107293864562568, -0.5130030191827197, -0.8498274929897633>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-1.704800966801122, 5.2, 0.3776725759729743> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.704800966801122, 4.2, 0.3776725759729743> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.7371287101646886, 5.2, -0.06293890639208255> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <1.7371287101646886, 4.2, -0.06293890639208255> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.3759624730166979, 0, -0.09893749289913102> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.07123499488737434, 0, 0.1345549903428182> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.11872499147895722, 0, -0.17808748721843584> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (117)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1659078448233364, 4.288169017014367, 7.211725382279642>
  direction <-0.11211274037850255, -0.5093019627234096, -0.8532641537730304>
  right <0.7136937289148793, 0, -0.09685843463844786>
  up <-0.03299946595867764, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-2.2406945161288605, 5.2, -0.29696192268747834> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.2406945161288605, 4.2, -0.29696192268747834> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.520566122047603, 5.2, 0.40539066537749024> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.520566122047603, 4.2, 0.40539066537749024> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.7235183169867377, 0, -0.1903995571017731> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.13708768111327663, 0, 0.2589433976584114> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.2284794685221277, 0, -0.34271920278319157> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (118)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1854739353874686, 4.331538085250237, 7.183048543332987>
  direction <-0.11524394918137332, -0.5149172222507707, -0.8494700482905099>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-2.136343817715533, 5.2, 0.6243160946527496> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.136343817715533, 4.2, 0.6243160946527496> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.834980299603194, 5.2, -0.540677267499268> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.834980299603194, 4.2, -0.540677267499268> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.6583009511535056, 0, -0.17323709240881727> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.12473070653434842, 0, 0.2356024456759915> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.20788451089058071, 0, -0.3118267663358711> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (119)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2086503982624177, 4.269834936627065, 7.216925055402433>
  direction <-0.11561354817273826, -0.5061543356885182, -0.8546776203647474>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-1.1618557541165502, 5.2, 0.03577725912909957> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.1618557541165502, 4.2, 0.03577725912909957> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.2408843405079097, 5.2, 0.6278792989673093> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.2408843405079097, 4.2, 0.6278792989673093> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.23867746502161025, 0, -0.06280985921621322> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.04522309863567352, 0, 0.08542140853404999> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.07537183105945587, 0, -0.1130577465891838> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (120)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2213347820781315, 4.336517556462386, 7.175194031411965>
  direction <-0.11871810071112365, -0.5144471254397268, -0.849280614383813>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-1.4417421326739714, 5.2, -0.37520425734110174> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.4417421326739714, 4.2, -0.37520425734110174> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.7375682960497216, 5.2, 0.20831337743438783> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.7375682960497216, 4.2, 0.20831337743438783> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.059613747734184444, 0, -0.01568782835110117> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.011295236412792842, 0, 0.021335446557497594> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.018825394021321402, 0, -0.028238091031982108> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (121)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1818084406665126, 4.283053733254596, 7.212636614528216>
  direction <-0.11272142982311854, -0.5093486708422824, -0.8531535210485088>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-1.9287159792380408, 5.2, 0.4703571232734248> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.9287159792380408, 4.2, 0.4703571232734248> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.2992120628710837, 5.2, 0.0803140420233831> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.2992120628710837, 4.2, 0.0803140420233831> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.503730268375948, 0, -0.13256059694103897> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.09544362979754806, 0, 0.18028241183981303> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.15907271632924677, 0, -0.23860907449387014> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (122)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2172783336964699, 4.286174693575652, 7.205950267138659>
  direction <-0.11576937564817535, -0.5092249388227005, -0.8528141104697144>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-1.5593624437693507, 5.2, 0.5856510095531121> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.5593624437693507, 4.2, 0.5856510095531121> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.6583623602287845, 5.2, 0.7429997269995511> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <1.6583623602287845, 4.2, 0.7429997269995511> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.26471151485922745, 0, -0.06966092496295459> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.0501558659733273, 0, 0.09473885794961825> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.0835931099555455, 0, -0.12538966493331827> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (123)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1991664039742362, 4.308673885876198, 7.194908799363492>
  direction <-0.11714233130445299, -0.5136777654851226, -0.8499560847760522>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-2.4937472640536726, 5.2, 0.07979081184603276> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.4937472640536726, 4.2, 0.07979081184603276> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.3980858392547817, 5.2, -0.34897207086905835> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.3980858392547817, 4.2, -0.34897207086905835> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.8362217510468326, 0, -0.22005835553864017> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.15844201598782093, 0, 0.29927936353255064> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.2640700266463682, 0, -0.3961050399695523> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (124)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2328332717733814, 4.270244024270493, 7.213397641411317>
  direction <-0.11950375917870415, -0.5057484784041063, -0.8543931775274421>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-1.2509751126868651, 5.2, 0.1739721452817321> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.2509751126868651, 4.2, 0.1739721452817321> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.1269106507766993, 5.2, 0.48231049671303483> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.1269106507766993, 4.2, 0.48231049671303483> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.18383463113219475, 0, -0.048377534508472306> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.034831824846100055, 0, 0.06579344693152234> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.05805304141016676, 0, -0.08707956211525016> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (125)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.159167203821966, 4.316515417448848, 7.19563234329771>
  direction <-0.11138728929995896, -0.5138677011774871, -0.8506231647755291>
  right <0.7136937289148793, 0, -0.09685843463844789>
  up <-0.03299946595867765, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-2.037873051967472, 5.2, -0.5819438194390386> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.037873051967472, 4.2, -0.5819438194390386> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <3.014440453518182, 5.2, -0.13524104005191473> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <3.014440453518182, 4.2, -0.13524104005191473> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.622157674607588, 0, -0.1637257038441021> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1178825067677535, 0, 0.22266695722797886> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1964708446129225, 0, -0.2947062669193838> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (126)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.1798913027091897, 4.292900501080963, 7.20698873684089>
  direction <-0.11440916684901799, -0.5096015640549478, -0.852772735095966>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.4127207644117573, -0.24315395969551956>
}

light_source { <-2.385349744022824, 5.2, 0.7568241895409301> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-2.385349744022824, 4.2, 0.7568241895409301> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.863227780815214, 5.2, -0.48924414524808524> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <1.863227780815214, 4.2, -0.48924414524808524> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.43853238793206395, 0, -0.1154032599821221> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.0830903471871279, 0, 0.15694843357568608> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1384839119785465, 0, -0.20772586796781978> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (127)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.0003125, 0.000390625, 0.00046875> }

camera {
  perspective
  location <1.2021671978777446, 4.317759904057163, 7.1890499378537225>
  direction <-0.11431170826835829, -0.5140505209678763, -0.85011658746987>
  right <0.7136937289148793, 0, -0.0968584346384479>
  up <-0.03299946595867766, 0.41272076441175737, -0.24315395969551956>
}

light_source { <-1.7828091009519995, 5.2, -0.05409505453426389> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <-1.7828091009519995, 4.2, -0.05409505453426389> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.6213011597516016, 5.2, 0.575479864818044> rgb <61548200648.81891, 59310084261.58913, 53714793293.51467> spotlight point_at <2.6213011597516016, 4.2, 0.575479864818044> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.06, 0.3, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <6.25e-05, 9.375e-05, 6.25e-05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.22, 0.09, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.05 } specular 0.05 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.82, 0.8, 0.74> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material3 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.52, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material4 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.03, 0.03> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material5 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.08, 0.4> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

#declare Material6 =
  texture { pigment { rgb 0.00015625 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.015 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.06 } specular 0.06 roughness 0.0033333333333333335 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
box { <-6, 0, -2.9>, <6, 0.55, -2.4> texture { Material1 } }
sphere { <-1.65, 0.5, 0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.757658287200611, 0, -0.1993837597896345> texture { Material2 } }
sphere { <0.35, 0.5, -0.35>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.14355630704853684, 0, 0.27116191331390294> texture { Material3 } }
sphere { <1.75, 0.5, 0.7>, 0.5 texture { Material4 } }
sphere { <1.55, 0.5, -0.75>, 0.5 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.23926051174756138, 0, -0.3588907676213421> texture { Material5 } }
sphere { <-0.55, 0.5, -1.35>, 0.5 texture { Material6 } }
polygon { 5, <-2.6, 5.2, -0.6>, <-1.1, 5.2, -0.6>, <-1.1, 5.2, 0.9>, <-2.6, 5.2, 0.9>, <-2.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
polygon { 5, <1.6, 5.2, -0.6>, <3.1, 5.2, -0.6>, <3.1, 5.2, 0.9>, <1.6, 5.2, 0.9>, <1.6, 5.2, -0.6> texture { pigment { rgb <0.171875, 0.165625, 0.15> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#end
