// lamps.scene, written by `course export`.
// povray +Ilamps.pov +Olamps.png +W320 +H200 +FN16 -D -A File_Gamma=1.0 +KFI0 +KFF35
// then a pixel's samples are those of 36 pictures, weighed by our filter
#version 3.7;
#switch (frame_number)
#case (0)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.01, 0.01, 0.015> }

camera {
  perspective
  location <0, 2.6, 9>
  direction <-0.0011164549684630114, -0.20025223260060085, -0.9797450126487868>
  right <0.8574374157795926, 0, 0>
  up <0, 0.5249233033580275, -0.10790090124581676>
}

light_source { <-2.8833333333333337, 1.5, -0.6166666666666666> rgb <155971844230.0574, 77985922115.0287, 49019722472.303764> spotlight point_at <-2.8833333333333337, 0.5, -0.6166666666666666> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <-0.9175042088615695, 1.4762950088482492, -0.279016637172503> rgb <73500000000, 171500000000, 68600000000.00001> spotlight point_at <-0.9175042088615695, 0.5184687236270978, 0.008331248393842361> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.153188337241014, 1.5884433277428105, -0.46666666666666673> rgb <53248000000.00001, 77824000000.00002, 143360000000> spotlight point_at <1.631901891119183, 1.8648287269390935, -1.3000000000000003> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <3.5845480362397537, 1.4239356776939083, -0.4202144076869718> rgb <81419693026.09259, 72114585251.682, 25589046379.6291> spotlight point_at <3.5845480362397537, 0.46610939247275696, -0.13286652212062638> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0 diffuse 1 } }

#declare Material2 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
cylinder { <-3, 0, 0.3>, <-3, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <-1, 0, 0.3>, <-1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <1, 0, 0.3>, <1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <3, 0, 0.3>, <3, 0.5, 0.3>, 0.1 texture { Material1 } }
plane { <0, 0, 1>, -2 texture { Material2 } }
polygon { 5, <-3.7, 1.5, -0.7>, <-2.3000000000000003, 1.5, -0.7>, <-2.3000000000000003, 1.5, 0.30000000000000004>, <-3.7, 1.5, 0.30000000000000004>, <-3.7, 1.5, -0.7> texture { pigment { rgb <0.7, 0.35, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
disc { <-1, 1.5, -0.2>, <0, -0.9578262852211513, 0.2873478855663454>, 0.7 texture { pigment { rgb <0.3, 0.7, 0.28> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
sphere { <1, 1.5, -0.2>, 0.32 texture { pigment { rgb <0.26, 0.38, 0.7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
triangle { <2.3, 1.4, -0.5>, <3, 1.7, 0.5>, <3.7, 1.4, -0.5> texture { pigment { rgb <0.7, 0.62, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (1)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.01, 0.01, 0.015> }

camera {
  perspective
  location <0, 2.6, 9>
  direction <-0.0006698729810778068, -0.20025223260060085, -0.9797450126487868>
  right <0.8574374157795926, 0, 0>
  up <0, 0.5249233033580275, -0.10790090124581676>
}

light_source { <-2.8833333333333337, 1.5, -0.44999999999999996> rgb <155971844230.0574, 77985922115.0287, 49019722472.303764> spotlight point_at <-2.8833333333333337, 0.5, -0.44999999999999996> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <-0.7525126265847084, 1.5711149734552528, 0.037049911517508693> rgb <73500000000, 171500000000, 68600000000.00001> spotlight point_at <-0.7525126265847084, 0.6132886882341014, 0.3243977970838541> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <0.9999999999999999, 1.1844757449013539, -0.2533333333333333> rgb <53248000000.00001, 77824000000.00002, 143360000000> spotlight point_at <0.9999999999999997, 0.19846244771808452, -0.4199999999999998> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.518911977067733, 1.4793856620135735, -0.23538112662142152> rgb <81419693026.09259, 72114585251.682, 25589046379.6291> spotlight point_at <2.518911977067733, 0.5215593767924221, 0.05196675894492392> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0 diffuse 1 } }

#declare Material2 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
cylinder { <-3, 0, 0.3>, <-3, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <-1, 0, 0.3>, <-1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <1, 0, 0.3>, <1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <3, 0, 0.3>, <3, 0.5, 0.3>, 0.1 texture { Material1 } }
plane { <0, 0, 1>, -2 texture { Material2 } }
polygon { 5, <-3.7, 1.5, -0.7>, <-2.3000000000000003, 1.5, -0.7>, <-2.3000000000000003, 1.5, 0.30000000000000004>, <-3.7, 1.5, 0.30000000000000004>, <-3.7, 1.5, -0.7> texture { pigment { rgb <0.7, 0.35, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
disc { <-1, 1.5, -0.2>, <0, -0.9578262852211513, 0.2873478855663454>, 0.7 texture { pigment { rgb <0.3, 0.7, 0.28> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
sphere { <1, 1.5, -0.2>, 0.32 texture { pigment { rgb <0.26, 0.38, 0.7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
triangle { <2.3, 1.4, -0.5>, <3, 1.7, 0.5>, <3.7, 1.4, -0.5> texture { pigment { rgb <0.7, 0.62, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (2)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.01, 0.01, 0.015> }

camera {
  perspective
  location <0, 2.6, 9>
  direction <-0.00022329099369260234, -0.20025223260060085, -0.9797450126487868>
  right <0.8574374157795926, 0, 0>
  up <0, 0.5249233033580275, -0.10790090124581676>
}

light_source { <-2.8833333333333337, 1.5, 0.21666666666666679> rgb <155971844230.0574, 77985922115.0287, 49019722472.303764> spotlight point_at <-2.8833333333333337, 0.5, 0.21666666666666679> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <-0.7525126265847084, 1.4288850265447472, -0.4370499115175087> rgb <73500000000, 171500000000, 68600000000.00001> spotlight point_at <-0.7525126265847084, 0.47105874132359593, -0.14970202595116333> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.24, 1.6385640646055102, -0.36> rgb <53248000000.00001, 77824000000.00002, 143360000000> spotlight point_at <1.99, 2.0715767664977296, -0.86> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.6536270398786455, 1.421650635094611, -0.4278312163512968> rgb <81419693026.09259, 72114585251.682, 25589046379.6291> spotlight point_at <2.6536270398786455, 0.46382434987345966, -0.14048333078495134> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0 diffuse 1 } }

#declare Material2 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
cylinder { <-3, 0, 0.3>, <-3, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <-1, 0, 0.3>, <-1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <1, 0, 0.3>, <1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <3, 0, 0.3>, <3, 0.5, 0.3>, 0.1 texture { Material1 } }
plane { <0, 0, 1>, -2 texture { Material2 } }
polygon { 5, <-3.7, 1.5, -0.7>, <-2.3000000000000003, 1.5, -0.7>, <-2.3000000000000003, 1.5, 0.30000000000000004>, <-3.7, 1.5, 0.30000000000000004>, <-3.7, 1.5, -0.7> texture { pigment { rgb <0.7, 0.35, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
disc { <-1, 1.5, -0.2>, <0, -0.9578262852211513, 0.2873478855663454>, 0.7 texture { pigment { rgb <0.3, 0.7, 0.28> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
sphere { <1, 1.5, -0.2>, 0.32 texture { pigment { rgb <0.26, 0.38, 0.7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
triangle { <2.3, 1.4, -0.5>, <3, 1.7, 0.5>, <3.7, 1.4, -0.5> texture { pigment { rgb <0.7, 0.62, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (3)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.01, 0.01, 0.015> }

camera {
  perspective
  location <0, 2.6, 9>
  direction <0.00022329099369260206, -0.20025223260060085, -0.9797450126487868>
  right <0.8574374157795926, 0, 0>
  up <0, 0.5249233033580275, -0.10790090124581676>
}

light_source { <-2.8833333333333337, 1.5, -0.1166666666666667> rgb <155971844230.0574, 77985922115.0287, 49019722472.303764> spotlight point_at <-2.8833333333333337, 0.5, -0.1166666666666667> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <-0.6619259607988262, 1.5260298868740785, -0.11323371041973852> rgb <73500000000, 171500000000, 68600000000.00001> spotlight point_at <-0.6619259607988262, 0.5682036016529272, 0.17411417514660688> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <0.8468116627589859, 1.5884433277428107, 0.06666666666666665> rgb <53248000000.00001, 77824000000.00002, 143360000000> spotlight point_at <0.36809810888081695, 1.8648287269390942, 0.9> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <3.0154260903410925, 1.4806871530459877, -0.23104282318004055> rgb <81419693026.09259, 72114585251.682, 25589046379.6291> spotlight point_at <3.0154260903410925, 0.5228608678248364, 0.056305062386304894> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0 diffuse 1 } }

#declare Material2 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
cylinder { <-3, 0, 0.3>, <-3, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <-1, 0, 0.3>, <-1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <1, 0, 0.3>, <1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <3, 0, 0.3>, <3, 0.5, 0.3>, 0.1 texture { Material1 } }
plane { <0, 0, 1>, -2 texture { Material2 } }
polygon { 5, <-3.7, 1.5, -0.7>, <-2.3000000000000003, 1.5, -0.7>, <-2.3000000000000003, 1.5, 0.30000000000000004>, <-3.7, 1.5, 0.30000000000000004>, <-3.7, 1.5, -0.7> texture { pigment { rgb <0.7, 0.35, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
disc { <-1, 1.5, -0.2>, <0, -0.9578262852211513, 0.2873478855663454>, 0.7 texture { pigment { rgb <0.3, 0.7, 0.28> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
sphere { <1, 1.5, -0.2>, 0.32 texture { pigment { rgb <0.26, 0.38, 0.7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
triangle { <2.3, 1.4, -0.5>, <3, 1.7, 0.5>, <3.7, 1.4, -0.5> texture { pigment { rgb <0.7, 0.62, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (4)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.01, 0.01, 0.015> }

camera {
  perspective
  location <0, 2.6, 9>
  direction <0.0006698729810778068, -0.20025223260060085, -0.9797450126487868>
  right <0.8574374157795926, 0, 0>
  up <0, 0.5249233033580275, -0.10790090124581676>
}

light_source { <-2.6500000000000004, 1.5, -0.6166666666666666> rgb <155971844230.0574, 77985922115.0287, 49019722472.303764> spotlight point_at <-2.6500000000000004, 0.5, -0.6166666666666666> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <-0.9094133342141179, 1.5971448603293312, 0.12381620109777025> rgb <73500000000, 171500000000, 68600000000.00001> spotlight point_at <-0.9094133342141179, 0.6393185751081799, 0.41116408666411564> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1, 1.6768866554856214, 0.06666666666666665> rgb <53248000000.00001, 77824000000.00002, 143360000000> spotlight point_at <1, 2.229657453878188, 0.9> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.956735931203199, 1.6381569860407206, 0.29385662013573544> rgb <81419693026.09259, 72114585251.682, 25589046379.6291> spotlight point_at <2.956735931203199, 0.6803307008195693, 0.5812045057020809> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0 diffuse 1 } }

#declare Material2 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
cylinder { <-3, 0, 0.3>, <-3, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <-1, 0, 0.3>, <-1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <1, 0, 0.3>, <1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <3, 0, 0.3>, <3, 0.5, 0.3>, 0.1 texture { Material1 } }
plane { <0, 0, 1>, -2 texture { Material2 } }
polygon { 5, <-3.7, 1.5, -0.7>, <-2.3000000000000003, 1.5, -0.7>, <-2.3000000000000003, 1.5, 0.30000000000000004>, <-3.7, 1.5, 0.30000000000000004>, <-3.7, 1.5, -0.7> texture { pigment { rgb <0.7, 0.35, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
disc { <-1, 1.5, -0.2>, <0, -0.9578262852211513, 0.2873478855663454>, 0.7 texture { pigment { rgb <0.3, 0.7, 0.28> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
sphere { <1, 1.5, -0.2>, 0.32 texture { pigment { rgb <0.26, 0.38, 0.7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
triangle { <2.3, 1.4, -0.5>, <3, 1.7, 0.5>, <3.7, 1.4, -0.5> texture { pigment { rgb <0.7, 0.62, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (5)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.01, 0.01, 0.015> }

camera {
  perspective
  location <0, 2.6, 9>
  direction <0.0011164549684630114, -0.20025223260060085, -0.9797450126487868>
  right <0.8574374157795926, 0, 0>
  up <0, 0.5249233033580275, -0.10790090124581676>
}

light_source { <-2.416666666666667, 1.5, 0.21666666666666679> rgb <155971844230.0574, 77985922115.0287, 49019722472.303764> spotlight point_at <-2.416666666666667, 0.5, 0.21666666666666679> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <-0.7351722084852643, 1.350649842895048, -0.6978338570165067> rgb <73500000000, 171500000000, 68600000000.00001> spotlight point_at <-0.7351722084852643, 0.39282355767389665, -0.4104859714501613> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1, 1.7771281292110204, -0.36> rgb <53248000000.00001, 77824000000.00002, 143360000000> spotlight point_at <1, 2.6431535329954587, -0.86> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.789502061812326, 1.5775117367011733, 0.09170578900391091> rgb <81419693026.09259, 72114585251.682, 25589046379.6291> spotlight point_at <2.789502061812326, 0.619685451480022, 0.37905367457025635> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0 diffuse 1 } }

#declare Material2 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
cylinder { <-3, 0, 0.3>, <-3, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <-1, 0, 0.3>, <-1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <1, 0, 0.3>, <1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <3, 0, 0.3>, <3, 0.5, 0.3>, 0.1 texture { Material1 } }
plane { <0, 0, 1>, -2 texture { Material2 } }
polygon { 5, <-3.7, 1.5, -0.7>, <-2.3000000000000003, 1.5, -0.7>, <-2.3000000000000003, 1.5, 0.30000000000000004>, <-3.7, 1.5, 0.30000000000000004>, <-3.7, 1.5, -0.7> texture { pigment { rgb <0.7, 0.35, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
disc { <-1, 1.5, -0.2>, <0, -0.9578262852211513, 0.2873478855663454>, 0.7 texture { pigment { rgb <0.3, 0.7, 0.28> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
sphere { <1, 1.5, -0.2>, 0.32 texture { pigment { rgb <0.26, 0.38, 0.7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
triangle { <2.3, 1.4, -0.5>, <3, 1.7, 0.5>, <3.7, 1.4, -0.5> texture { pigment { rgb <0.7, 0.62, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (6)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.01, 0.01, 0.015> }

camera {
  perspective
  location <0, 2.6, 9>
  direction <-0.0011164549684630114, -0.20068966868673255, -0.979655095231082>
  right <0.8574374157795926, 0, 0>
  up <0, 0.5249233033580275, -0.10790090124581676>
}

light_source { <-3.5833333333333335, 1.5, 0.050000000000000044> rgb <155971844230.0574, 77985922115.0287, 49019722472.303764> spotlight point_at <-3.5833333333333335, 0.5, 0.050000000000000044> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <-0.4238484679861696, 1.5262214824427573, -0.11259505852414203> rgb <73500000000, 171500000000, 68600000000.00001> spotlight point_at <-0.4238484679861696, 0.568395197221606, 0.17475282704220335> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.2732520204255893, 1.342237872450677, -0.14666666666666667> rgb <53248000000.00001, 77824000000.00002, 143360000000> spotlight point_at <2.127164584255556, 0.8492312238590427, 0.020000000000000046> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <3.461917416744122, 1.421650635094611, -0.4278312163512968> rgb <81419693026.09259, 72114585251.682, 25589046379.6291> spotlight point_at <3.461917416744122, 0.46382434987345966, -0.14048333078495134> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0 diffuse 1 } }

#declare Material2 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
cylinder { <-3, 0, 0.3>, <-3, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <-1, 0, 0.3>, <-1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <1, 0, 0.3>, <1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <3, 0, 0.3>, <3, 0.5, 0.3>, 0.1 texture { Material1 } }
plane { <0, 0, 1>, -2 texture { Material2 } }
polygon { 5, <-3.7, 1.5, -0.7>, <-2.3000000000000003, 1.5, -0.7>, <-2.3000000000000003, 1.5, 0.30000000000000004>, <-3.7, 1.5, 0.30000000000000004>, <-3.7, 1.5, -0.7> texture { pigment { rgb <0.7, 0.35, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
disc { <-1, 1.5, -0.2>, <0, -0.9578262852211513, 0.2873478855663454>, 0.7 texture { pigment { rgb <0.3, 0.7, 0.28> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
sphere { <1, 1.5, -0.2>, 0.32 texture { pigment { rgb <0.26, 0.38, 0.7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
triangle { <2.3, 1.4, -0.5>, <3, 1.7, 0.5>, <3.7, 1.4, -0.5> texture { pigment { rgb <0.7, 0.62, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (7)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.01, 0.01, 0.015> }

camera {
  perspective
  location <0, 2.6, 9>
  direction <-0.0006698729810778068, -0.20068966868673255, -0.979655095231082>
  right <0.8574374157795926, 0, 0>
  up <0, 0.5249233033580275, -0.10790090124581676>
}

light_source { <-3.5833333333333335, 1.5, 0.21666666666666679> rgb <155971844230.0574, 77985922115.0287, 49019722472.303764> spotlight point_at <-3.5833333333333335, 0.5, 0.21666666666666679> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <-1.2474873734152916, 1.5711149734552528, 0.037049911517508693> rgb <73500000000, 171500000000, 68600000000.00001> spotlight point_at <-1.2474873734152916, 0.6132886882341014, 0.3243977970838541> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.2732520204255893, 1.657762127549323, -0.14666666666666667> rgb <53248000000.00001, 77824000000.00002, 143360000000> spotlight point_at <2.127164584255556, 2.1507687761409575, 0.020000000000000073> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.8541666666666665, 1.4625, -0.2916666666666667> rgb <81419693026.09259, 72114585251.682, 25589046379.6291> spotlight point_at <2.8541666666666665, 0.5046737147788486, -0.004318781100321245> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0 diffuse 1 } }

#declare Material2 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
cylinder { <-3, 0, 0.3>, <-3, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <-1, 0, 0.3>, <-1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <1, 0, 0.3>, <1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <3, 0, 0.3>, <3, 0.5, 0.3>, 0.1 texture { Material1 } }
plane { <0, 0, 1>, -2 texture { Material2 } }
polygon { 5, <-3.7, 1.5, -0.7>, <-2.3000000000000003, 1.5, -0.7>, <-2.3000000000000003, 1.5, 0.30000000000000004>, <-3.7, 1.5, 0.30000000000000004>, <-3.7, 1.5, -0.7> texture { pigment { rgb <0.7, 0.35, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
disc { <-1, 1.5, -0.2>, <0, -0.9578262852211513, 0.2873478855663454>, 0.7 texture { pigment { rgb <0.3, 0.7, 0.28> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
sphere { <1, 1.5, -0.2>, 0.32 texture { pigment { rgb <0.26, 0.38, 0.7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
triangle { <2.3, 1.4, -0.5>, <3, 1.7, 0.5>, <3.7, 1.4, -0.5> texture { pigment { rgb <0.7, 0.62, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (8)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.01, 0.01, 0.015> }

camera {
  perspective
  location <0, 2.6, 9>
  direction <-0.00022329099369260234, -0.20068966868673255, -0.979655095231082>
  right <0.8574374157795926, 0, 0>
  up <0, 0.5249233033580275, -0.10790090124581676>
}

light_source { <-3.116666666666667, 1.5, -0.2833333333333333> rgb <155971844230.0574, 77985922115.0287, 49019722472.303764> spotlight point_at <-3.116666666666667, 0.5, -0.2833333333333333> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <-1.0912534379401346, 1.334444075510015, -0.7518530816332825> rgb <73500000000, 171500000000, 68600000000.00001> spotlight point_at <-1.0912534379401346, 0.3766177902888638, -0.4645051960669371> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.2732520204255895, 1.342237872450677, -0.2533333333333333> rgb <53248000000.00001, 77824000000.00002, 143360000000> spotlight point_at <2.1271645842555564, 0.8492312238590425, -0.4199999999999998> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.879186650334696, 1.6100347193521427, 0.20011573117380888> rgb <81419693026.09259, 72114585251.682, 25589046379.6291> spotlight point_at <2.879186650334696, 0.6522084341309914, 0.4874636167401543> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0 diffuse 1 } }

#declare Material2 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
cylinder { <-3, 0, 0.3>, <-3, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <-1, 0, 0.3>, <-1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <1, 0, 0.3>, <1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <3, 0, 0.3>, <3, 0.5, 0.3>, 0.1 texture { Material1 } }
plane { <0, 0, 1>, -2 texture { Material2 } }
polygon { 5, <-3.7, 1.5, -0.7>, <-2.3000000000000003, 1.5, -0.7>, <-2.3000000000000003, 1.5, 0.30000000000000004>, <-3.7, 1.5, 0.30000000000000004>, <-3.7, 1.5, -0.7> texture { pigment { rgb <0.7, 0.35, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
disc { <-1, 1.5, -0.2>, <0, -0.9578262852211513, 0.2873478855663454>, 0.7 texture { pigment { rgb <0.3, 0.7, 0.28> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
sphere { <1, 1.5, -0.2>, 0.32 texture { pigment { rgb <0.26, 0.38, 0.7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
triangle { <2.3, 1.4, -0.5>, <3, 1.7, 0.5>, <3.7, 1.4, -0.5> texture { pigment { rgb <0.7, 0.62, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (9)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.01, 0.01, 0.015> }

camera {
  perspective
  location <0, 2.6, 9>
  direction <0.00022329099369260206, -0.20068966868673255, -0.979655095231082>
  right <0.8574374157795926, 0, 0>
  up <0, 0.5249233033580275, -0.10790090124581676>
}

light_source { <-3.35, 1.5, -0.1166666666666667> rgb <155971844230.0574, 77985922115.0287, 49019722472.303764> spotlight point_at <-3.35, 0.5, -0.1166666666666667> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <-0.4238484679861696, 1.4737785175572427, -0.2874049414758581> rgb <73500000000, 171500000000, 68600000000.00001> spotlight point_at <-0.4238484679861696, 0.5159522323360913, -5.705590951271544e-05> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <0.9999999999999999, 1.1844757449013539, -0.14666666666666667> rgb <53248000000.00001, 77824000000.00002, 143360000000> spotlight point_at <0.9999999999999997, 0.19846244771808452, 0.020000000000000073> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.5862695084731895, 1.4505181485540921, -0.3316061714863592> rgb <81419693026.09259, 72114585251.682, 25589046379.6291> spotlight point_at <2.5862695084731895, 0.4926918633329408, -0.04425828592001374> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0 diffuse 1 } }

#declare Material2 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
cylinder { <-3, 0, 0.3>, <-3, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <-1, 0, 0.3>, <-1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <1, 0, 0.3>, <1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <3, 0, 0.3>, <3, 0.5, 0.3>, 0.1 texture { Material1 } }
plane { <0, 0, 1>, -2 texture { Material2 } }
polygon { 5, <-3.7, 1.5, -0.7>, <-2.3000000000000003, 1.5, -0.7>, <-2.3000000000000003, 1.5, 0.30000000000000004>, <-3.7, 1.5, 0.30000000000000004>, <-3.7, 1.5, -0.7> texture { pigment { rgb <0.7, 0.35, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
disc { <-1, 1.5, -0.2>, <0, -0.9578262852211513, 0.2873478855663454>, 0.7 texture { pigment { rgb <0.3, 0.7, 0.28> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
sphere { <1, 1.5, -0.2>, 0.32 texture { pigment { rgb <0.26, 0.38, 0.7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
triangle { <2.3, 1.4, -0.5>, <3, 1.7, 0.5>, <3.7, 1.4, -0.5> texture { pigment { rgb <0.7, 0.62, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (10)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.01, 0.01, 0.015> }

camera {
  perspective
  location <0, 2.6, 9>
  direction <0.0006698729810778068, -0.20068966868673255, -0.979655095231082>
  right <0.8574374157795926, 0, 0>
  up <0, 0.5249233033580275, -0.10790090124581676>
}

light_source { <-3.35, 1.5, -0.6166666666666666> rgb <155971844230.0574, 77985922115.0287, 49019722472.303764> spotlight point_at <-3.35, 0.5, -0.6166666666666666> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <-1.5761515320138304, 1.4737785175572427, -0.2874049414758581> rgb <73500000000, 171500000000, 68600000000.00001> spotlight point_at <-1.5761515320138304, 0.5159522323360913, -5.705590951271544e-05> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.153188337241014, 1.5884433277428107, 0.06666666666666665> rgb <53248000000.00001, 77824000000.00002, 143360000000> spotlight point_at <1.6319018911191832, 1.864828726939094, 0.9> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.9125, 1.4375, -0.375> rgb <81419693026.09259, 72114585251.682, 25589046379.6291> spotlight point_at <2.9125, 0.4796737147788487, -0.08765211443365456> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0 diffuse 1 } }

#declare Material2 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
cylinder { <-3, 0, 0.3>, <-3, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <-1, 0, 0.3>, <-1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <1, 0, 0.3>, <1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <3, 0, 0.3>, <3, 0.5, 0.3>, 0.1 texture { Material1 } }
plane { <0, 0, 1>, -2 texture { Material2 } }
polygon { 5, <-3.7, 1.5, -0.7>, <-2.3000000000000003, 1.5, -0.7>, <-2.3000000000000003, 1.5, 0.30000000000000004>, <-3.7, 1.5, 0.30000000000000004>, <-3.7, 1.5, -0.7> texture { pigment { rgb <0.7, 0.35, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
disc { <-1, 1.5, -0.2>, <0, -0.9578262852211513, 0.2873478855663454>, 0.7 texture { pigment { rgb <0.3, 0.7, 0.28> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
sphere { <1, 1.5, -0.2>, 0.32 texture { pigment { rgb <0.26, 0.38, 0.7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
triangle { <2.3, 1.4, -0.5>, <3, 1.7, 0.5>, <3.7, 1.4, -0.5> texture { pigment { rgb <0.7, 0.62, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (11)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.01, 0.01, 0.015> }

camera {
  perspective
  location <0, 2.6, 9>
  direction <0.0011164549684630114, -0.20068966868673255, -0.979655095231082>
  right <0.8574374157795926, 0, 0>
  up <0, 0.5249233033580275, -0.10790090124581676>
}

light_source { <-3.5833333333333335, 1.5, -0.44999999999999996> rgb <155971844230.0574, 77985922115.0287, 49019722472.303764> spotlight point_at <-3.5833333333333335, 0.5, -0.44999999999999996> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <-0.9087465620598654, 1.665555924489985, 0.3518530816332824> rgb <73500000000, 171500000000, 68600000000.00001> spotlight point_at <-0.9087465620598654, 0.7077296392688336, 0.6392009671996277> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.153188337241014, 1.4115566722571895, 0.06666666666666665> rgb <53248000000.00001, 77824000000.00002, 143360000000> spotlight point_at <1.6319018911191834, 1.1351712730609065, 0.9> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.552590742770461, 1.464951905283833, -0.28349364905389035> rgb <81419693026.09259, 72114585251.682, 25589046379.6291> spotlight point_at <2.552590742770461, 0.5071256200626816, 0.0038542365124550892> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0 diffuse 1 } }

#declare Material2 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
cylinder { <-3, 0, 0.3>, <-3, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <-1, 0, 0.3>, <-1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <1, 0, 0.3>, <1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <3, 0, 0.3>, <3, 0.5, 0.3>, 0.1 texture { Material1 } }
plane { <0, 0, 1>, -2 texture { Material2 } }
polygon { 5, <-3.7, 1.5, -0.7>, <-2.3000000000000003, 1.5, -0.7>, <-2.3000000000000003, 1.5, 0.30000000000000004>, <-3.7, 1.5, 0.30000000000000004>, <-3.7, 1.5, -0.7> texture { pigment { rgb <0.7, 0.35, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
disc { <-1, 1.5, -0.2>, <0, -0.9578262852211513, 0.2873478855663454>, 0.7 texture { pigment { rgb <0.3, 0.7, 0.28> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
sphere { <1, 1.5, -0.2>, 0.32 texture { pigment { rgb <0.26, 0.38, 0.7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
triangle { <2.3, 1.4, -0.5>, <3, 1.7, 0.5>, <3.7, 1.4, -0.5> texture { pigment { rgb <0.7, 0.62, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (12)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.01, 0.01, 0.015> }

camera {
  perspective
  location <0, 2.6, 9>
  direction <-0.0011164549684630114, -0.20112710477286425, -0.9795651778133772>
  right <0.8574374157795926, 0, 0>
  up <0, 0.5249233033580275, -0.10790090124581676>
}

light_source { <-2.416666666666667, 1.5, -0.6166666666666666> rgb <155971844230.0574, 77985922115.0287, 49019722472.303764> spotlight point_at <-2.416666666666667, 0.5, -0.6166666666666666> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <-1.5761515320138304, 1.5262214824427573, -0.11259505852414203> rgb <73500000000, 171500000000, 68600000000.00001> spotlight point_at <-1.5761515320138304, 0.568395197221606, 0.17475282704220335> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <0.7267479795744106, 1.3422378724506772, -0.14666666666666667> rgb <53248000000.00001, 77824000000.00002, 143360000000> spotlight point_at <-0.1271645842555562, 0.8492312238590431, 0.020000000000000046> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <3.3608811196359376, 1.464951905283833, -0.28349364905389035> rgb <81419693026.09259, 72114585251.682, 25589046379.6291> spotlight point_at <3.3608811196359376, 0.5071256200626816, 0.0038542365124550892> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0 diffuse 1 } }

#declare Material2 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
cylinder { <-3, 0, 0.3>, <-3, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <-1, 0, 0.3>, <-1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <1, 0, 0.3>, <1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <3, 0, 0.3>, <3, 0.5, 0.3>, 0.1 texture { Material1 } }
plane { <0, 0, 1>, -2 texture { Material2 } }
polygon { 5, <-3.7, 1.5, -0.7>, <-2.3000000000000003, 1.5, -0.7>, <-2.3000000000000003, 1.5, 0.30000000000000004>, <-3.7, 1.5, 0.30000000000000004>, <-3.7, 1.5, -0.7> texture { pigment { rgb <0.7, 0.35, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
disc { <-1, 1.5, -0.2>, <0, -0.9578262852211513, 0.2873478855663454>, 0.7 texture { pigment { rgb <0.3, 0.7, 0.28> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
sphere { <1, 1.5, -0.2>, 0.32 texture { pigment { rgb <0.26, 0.38, 0.7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
triangle { <2.3, 1.4, -0.5>, <3, 1.7, 0.5>, <3.7, 1.4, -0.5> texture { pigment { rgb <0.7, 0.62, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (13)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.01, 0.01, 0.015> }

camera {
  perspective
  location <0, 2.6, 9>
  direction <-0.0006698729810778068, -0.20112710477286425, -0.9795651778133772>
  right <0.8574374157795926, 0, 0>
  up <0, 0.5249233033580275, -0.10790090124581676>
}

light_source { <-2.416666666666667, 1.5, -0.2833333333333333> rgb <155971844230.0574, 77985922115.0287, 49019722472.303764> spotlight point_at <-2.416666666666667, 0.5, -0.2833333333333333> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <-1.0912534379401346, 1.665555924489985, 0.3518530816332824> rgb <73500000000, 171500000000, 68600000000.00001> spotlight point_at <-1.0912534379401346, 0.7077296392688336, 0.6392009671996277> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <0.8468116627589859, 1.4115566722571895, 0.06666666666666665> rgb <53248000000.00001, 77824000000.00002, 143360000000> spotlight point_at <0.3680981088808167, 1.1351712730609065, 0.9> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <3.4728482070015145, 1.4718070330817252, -0.2606432230609155> rgb <81419693026.09259, 72114585251.682, 25589046379.6291> spotlight point_at <3.4728482070015145, 0.5139807478605739, 0.026704662505429966> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0 diffuse 1 } }

#declare Material2 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
cylinder { <-3, 0, 0.3>, <-3, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <-1, 0, 0.3>, <-1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <1, 0, 0.3>, <1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <3, 0, 0.3>, <3, 0.5, 0.3>, 0.1 texture { Material1 } }
plane { <0, 0, 1>, -2 texture { Material2 } }
polygon { 5, <-3.7, 1.5, -0.7>, <-2.3000000000000003, 1.5, -0.7>, <-2.3000000000000003, 1.5, 0.30000000000000004>, <-3.7, 1.5, 0.30000000000000004>, <-3.7, 1.5, -0.7> texture { pigment { rgb <0.7, 0.35, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
disc { <-1, 1.5, -0.2>, <0, -0.9578262852211513, 0.2873478855663454>, 0.7 texture { pigment { rgb <0.3, 0.7, 0.28> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
sphere { <1, 1.5, -0.2>, 0.32 texture { pigment { rgb <0.26, 0.38, 0.7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
triangle { <2.3, 1.4, -0.5>, <3, 1.7, 0.5>, <3.7, 1.4, -0.5> texture { pigment { rgb <0.7, 0.62, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (14)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.01, 0.01, 0.015> }

camera {
  perspective
  location <0, 2.6, 9>
  direction <-0.00022329099369260234, -0.20112710477286425, -0.9795651778133772>
  right <0.8574374157795926, 0, 0>
  up <0, 0.5249233033580275, -0.10790090124581676>
}

light_source { <-3.35, 1.5, 0.21666666666666679> rgb <155971844230.0574, 77985922115.0287, 49019722472.303764> spotlight point_at <-3.35, 0.5, 0.21666666666666679> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <-0.5875210443078474, 1.6185249557587544, 0.1950831858625146> rgb <73500000000, 171500000000, 68600000000.00001> spotlight point_at <-0.5875210443078474, 0.6606986705376031, 0.48243107142886> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.24, 1.6385640646055102, -0.04000000000000001> rgb <53248000000.00001, 77824000000.00002, 143360000000> spotlight point_at <1.99, 2.0715767664977296, 0.45999999999999996> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <3.361148377763275, 1.5196783884695422, -0.10107203843485918> rgb <81419693026.09259, 72114585251.682, 25589046379.6291> spotlight point_at <3.361148377763275, 0.5618521032483909, 0.18627584713148626> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0 diffuse 1 } }

#declare Material2 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
cylinder { <-3, 0, 0.3>, <-3, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <-1, 0, 0.3>, <-1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <1, 0, 0.3>, <1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <3, 0, 0.3>, <3, 0.5, 0.3>, 0.1 texture { Material1 } }
plane { <0, 0, 1>, -2 texture { Material2 } }
polygon { 5, <-3.7, 1.5, -0.7>, <-2.3000000000000003, 1.5, -0.7>, <-2.3000000000000003, 1.5, 0.30000000000000004>, <-3.7, 1.5, 0.30000000000000004>, <-3.7, 1.5, -0.7> texture { pigment { rgb <0.7, 0.35, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
disc { <-1, 1.5, -0.2>, <0, -0.9578262852211513, 0.2873478855663454>, 0.7 texture { pigment { rgb <0.3, 0.7, 0.28> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
sphere { <1, 1.5, -0.2>, 0.32 texture { pigment { rgb <0.26, 0.38, 0.7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
triangle { <2.3, 1.4, -0.5>, <3, 1.7, 0.5>, <3.7, 1.4, -0.5> texture { pigment { rgb <0.7, 0.62, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (15)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.01, 0.01, 0.015> }

camera {
  perspective
  location <0, 2.6, 9>
  direction <0.00022329099369260206, -0.20112710477286425, -0.9795651778133772>
  right <0.8574374157795926, 0, 0>
  up <0, 0.5249233033580275, -0.10790090124581676>
}

light_source { <-3.116666666666667, 1.5, -0.44999999999999996> rgb <155971844230.0574, 77985922115.0287, 49019722472.303764> spotlight point_at <-3.116666666666667, 0.5, -0.44999999999999996> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <-0.9094133342141179, 1.4028551396706688, -0.5238162010977703> rgb <73500000000, 171500000000, 68600000000.00001> spotlight point_at <-0.9094133342141179, 0.44502885444951745, -0.2364683155314249> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1, 1.2228718707889796, -0.04000000000000001> rgb <53248000000.00001, 77824000000.00002, 143360000000> spotlight point_at <0.9999999999999999, 0.35684646700454115, 0.45999999999999996> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <3.026048890048556, 1.663292454632993, 0.37764151544331004> rgb <81419693026.09259, 72114585251.682, 25589046379.6291> spotlight point_at <3.026048890048556, 0.7054661694118417, 0.6649894010096555> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0 diffuse 1 } }

#declare Material2 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
cylinder { <-3, 0, 0.3>, <-3, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <-1, 0, 0.3>, <-1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <1, 0, 0.3>, <1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <3, 0, 0.3>, <3, 0.5, 0.3>, 0.1 texture { Material1 } }
plane { <0, 0, 1>, -2 texture { Material2 } }
polygon { 5, <-3.7, 1.5, -0.7>, <-2.3000000000000003, 1.5, -0.7>, <-2.3000000000000003, 1.5, 0.30000000000000004>, <-3.7, 1.5, 0.30000000000000004>, <-3.7, 1.5, -0.7> texture { pigment { rgb <0.7, 0.35, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
disc { <-1, 1.5, -0.2>, <0, -0.9578262852211513, 0.2873478855663454>, 0.7 texture { pigment { rgb <0.3, 0.7, 0.28> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
sphere { <1, 1.5, -0.2>, 0.32 texture { pigment { rgb <0.26, 0.38, 0.7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
triangle { <2.3, 1.4, -0.5>, <3, 1.7, 0.5>, <3.7, 1.4, -0.5> texture { pigment { rgb <0.7, 0.62, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (16)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.01, 0.01, 0.015> }

camera {
  perspective
  location <0, 2.6, 9>
  direction <0.0006698729810778068, -0.20112710477286425, -0.9795651778133772>
  right <0.8574374157795926, 0, 0>
  up <0, 0.5249233033580275, -0.10790090124581676>
}

light_source { <-3.5833333333333335, 1.5, -0.6166666666666666> rgb <155971844230.0574, 77985922115.0287, 49019722472.303764> spotlight point_at <-3.5833333333333335, 0.5, -0.6166666666666666> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <-1.2648277915147357, 1.649350157104952, 0.29783385701650666> rgb <73500000000, 171500000000, 68600000000.00001> spotlight point_at <-1.2648277915147357, 0.6915238718838007, 0.585181742582852> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <0.8468116627589859, 1.4115566722571895, -0.46666666666666673> rgb <53248000000.00001, 77824000000.00002, 143360000000> spotlight point_at <0.36809810888081684, 1.1351712730609067, -1.3000000000000003> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <3.2598448225277528, 1.5082531754730548, -0.13915608175648397> rgb <81419693026.09259, 72114585251.682, 25589046379.6291> spotlight point_at <3.2598448225277528, 0.5504268902519035, 0.14819180380986147> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0 diffuse 1 } }

#declare Material2 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
cylinder { <-3, 0, 0.3>, <-3, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <-1, 0, 0.3>, <-1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <1, 0, 0.3>, <1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <3, 0, 0.3>, <3, 0.5, 0.3>, 0.1 texture { Material1 } }
plane { <0, 0, 1>, -2 texture { Material2 } }
polygon { 5, <-3.7, 1.5, -0.7>, <-2.3000000000000003, 1.5, -0.7>, <-2.3000000000000003, 1.5, 0.30000000000000004>, <-3.7, 1.5, 0.30000000000000004>, <-3.7, 1.5, -0.7> texture { pigment { rgb <0.7, 0.35, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
disc { <-1, 1.5, -0.2>, <0, -0.9578262852211513, 0.2873478855663454>, 0.7 texture { pigment { rgb <0.3, 0.7, 0.28> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
sphere { <1, 1.5, -0.2>, 0.32 texture { pigment { rgb <0.26, 0.38, 0.7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
triangle { <2.3, 1.4, -0.5>, <3, 1.7, 0.5>, <3.7, 1.4, -0.5> texture { pigment { rgb <0.7, 0.62, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (17)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.01, 0.01, 0.015> }

camera {
  perspective
  location <0, 2.6, 9>
  direction <0.0011164549684630114, -0.20112710477286425, -0.9795651778133772>
  right <0.8574374157795926, 0, 0>
  up <0, 0.5249233033580275, -0.10790090124581676>
}

light_source { <-3.116666666666667, 1.5, -0.6166666666666666> rgb <155971844230.0574, 77985922115.0287, 49019722472.303764> spotlight point_at <-3.116666666666667, 0.5, -0.6166666666666666> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <-1.3380740392011738, 1.5260298868740785, -0.11323371041973852> rgb <73500000000, 171500000000, 68600000000.00001> spotlight point_at <-1.3380740392011738, 0.5682036016529272, 0.17411417514660688> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <0.846811662758986, 1.5884433277428107, -0.46666666666666673> rgb <53248000000.00001, 77824000000.00002, 143360000000> spotlight point_at <0.36809810888081723, 1.864828726939094, -1.3000000000000003> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <3.2494485485250353, 1.5675497438573591, 0.058499146191197116> rgb <81419693026.09259, 72114585251.682, 25589046379.6291> spotlight point_at <3.2494485485250353, 0.6097234586362078, 0.34584703175754256> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0 diffuse 1 } }

#declare Material2 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
cylinder { <-3, 0, 0.3>, <-3, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <-1, 0, 0.3>, <-1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <1, 0, 0.3>, <1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <3, 0, 0.3>, <3, 0.5, 0.3>, 0.1 texture { Material1 } }
plane { <0, 0, 1>, -2 texture { Material2 } }
polygon { 5, <-3.7, 1.5, -0.7>, <-2.3000000000000003, 1.5, -0.7>, <-2.3000000000000003, 1.5, 0.30000000000000004>, <-3.7, 1.5, 0.30000000000000004>, <-3.7, 1.5, -0.7> texture { pigment { rgb <0.7, 0.35, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
disc { <-1, 1.5, -0.2>, <0, -0.9578262852211513, 0.2873478855663454>, 0.7 texture { pigment { rgb <0.3, 0.7, 0.28> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
sphere { <1, 1.5, -0.2>, 0.32 texture { pigment { rgb <0.26, 0.38, 0.7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
triangle { <2.3, 1.4, -0.5>, <3, 1.7, 0.5>, <3.7, 1.4, -0.5> texture { pigment { rgb <0.7, 0.62, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (18)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.01, 0.01, 0.015> }

camera {
  perspective
  location <0, 2.6, 9>
  direction <-0.0011164549684630114, -0.20156454085899592, -0.9794752603956722>
  right <0.8574374157795926, 0, 0>
  up <0, 0.5249233033580275, -0.10790090124581676>
}

light_source { <-3.35, 1.5, 0.050000000000000044> rgb <155971844230.0574, 77985922115.0287, 49019722472.303764> spotlight point_at <-3.35, 0.5, 0.050000000000000044> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <-0.7351722084852643, 1.649350157104952, 0.29783385701650666> rgb <73500000000, 171500000000, 68600000000.00001> spotlight point_at <-0.7351722084852643, 0.6915238718838007, 0.585181742582852> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <0.7267479795744107, 1.6577621275493233, -0.2533333333333333> rgb <53248000000.00001, 77824000000.00002, 143360000000> spotlight point_at <-0.12716458425555555, 2.1507687761409584, -0.4199999999999998> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.864810071321915, 1.545236875482778, -0.015877081724072872> rgb <81419693026.09259, 72114585251.682, 25589046379.6291> spotlight point_at <2.864810071321915, 0.5874105902616268, 0.27147080384227257> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0 diffuse 1 } }

#declare Material2 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
cylinder { <-3, 0, 0.3>, <-3, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <-1, 0, 0.3>, <-1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <1, 0, 0.3>, <1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <3, 0, 0.3>, <3, 0.5, 0.3>, 0.1 texture { Material1 } }
plane { <0, 0, 1>, -2 texture { Material2 } }
polygon { 5, <-3.7, 1.5, -0.7>, <-2.3000000000000003, 1.5, -0.7>, <-2.3000000000000003, 1.5, 0.30000000000000004>, <-3.7, 1.5, 0.30000000000000004>, <-3.7, 1.5, -0.7> texture { pigment { rgb <0.7, 0.35, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
disc { <-1, 1.5, -0.2>, <0, -0.9578262852211513, 0.2873478855663454>, 0.7 texture { pigment { rgb <0.3, 0.7, 0.28> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
sphere { <1, 1.5, -0.2>, 0.32 texture { pigment { rgb <0.26, 0.38, 0.7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
triangle { <2.3, 1.4, -0.5>, <3, 1.7, 0.5>, <3.7, 1.4, -0.5> texture { pigment { rgb <0.7, 0.62, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (19)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.01, 0.01, 0.015> }

camera {
  perspective
  location <0, 2.6, 9>
  direction <-0.0006698729810778068, -0.20156454085899592, -0.9794752603956722>
  right <0.8574374157795926, 0, 0>
  up <0, 0.5249233033580275, -0.10790090124581676>
}

light_source { <-2.8833333333333337, 1.5, 0.050000000000000044> rgb <155971844230.0574, 77985922115.0287, 49019722472.303764> spotlight point_at <-2.8833333333333337, 0.5, 0.050000000000000044> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <-0.9175042088615696, 1.5237049911517508, -0.12098336282749718> rgb <73500000000, 171500000000, 68600000000.00001> spotlight point_at <-0.9175042088615696, 0.5658787059305995, 0.16636452273884822> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.24, 1.3614359353944898, -0.36> rgb <53248000000.00001, 77824000000.00002, 143360000000> spotlight point_at <1.9900000000000002, 0.9284232335022707, -0.86> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.687305805581374, 1.4072168783648702, -0.4759437387837656> rgb <81419693026.09259, 72114585251.682, 25589046379.6291> spotlight point_at <2.687305805581374, 0.4493905931437189, -0.18859585321742017> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0 diffuse 1 } }

#declare Material2 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
cylinder { <-3, 0, 0.3>, <-3, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <-1, 0, 0.3>, <-1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <1, 0, 0.3>, <1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <3, 0, 0.3>, <3, 0.5, 0.3>, 0.1 texture { Material1 } }
plane { <0, 0, 1>, -2 texture { Material2 } }
polygon { 5, <-3.7, 1.5, -0.7>, <-2.3000000000000003, 1.5, -0.7>, <-2.3000000000000003, 1.5, 0.30000000000000004>, <-3.7, 1.5, 0.30000000000000004>, <-3.7, 1.5, -0.7> texture { pigment { rgb <0.7, 0.35, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
disc { <-1, 1.5, -0.2>, <0, -0.9578262852211513, 0.2873478855663454>, 0.7 texture { pigment { rgb <0.3, 0.7, 0.28> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
sphere { <1, 1.5, -0.2>, 0.32 texture { pigment { rgb <0.26, 0.38, 0.7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
triangle { <2.3, 1.4, -0.5>, <3, 1.7, 0.5>, <3.7, 1.4, -0.5> texture { pigment { rgb <0.7, 0.62, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (20)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.01, 0.01, 0.015> }

camera {
  perspective
  location <0, 2.6, 9>
  direction <-0.00022329099369260234, -0.20156454085899592, -0.9794752603956722>
  right <0.8574374157795926, 0, 0>
  up <0, 0.5249233033580275, -0.10790090124581676>
}

light_source { <-3.116666666666667, 1.5, 0.21666666666666679> rgb <155971844230.0574, 77985922115.0287, 49019722472.303764> spotlight point_at <-3.116666666666667, 0.5, 0.21666666666666679> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <-1.0905866657858823, 1.4028551396706688, -0.5238162010977703> rgb <73500000000, 171500000000, 68600000000.00001> spotlight point_at <-1.0905866657858823, 0.44502885444951745, -0.2364683155314249> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1, 1.8155242550986461, -0.2533333333333333> rgb <53248000000.00001, 77824000000.00002, 143360000000> spotlight point_at <1, 2.8015375522819155, -0.4199999999999998> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <3.090734099850681, 1.4484122918275926, -0.33862569390802433> rgb <81419693026.09259, 72114585251.682, 25589046379.6291> spotlight point_at <3.090734099850681, 0.49058600660644125, -0.05127780834167889> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0 diffuse 1 } }

#declare Material2 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
cylinder { <-3, 0, 0.3>, <-3, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <-1, 0, 0.3>, <-1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <1, 0, 0.3>, <1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <3, 0, 0.3>, <3, 0.5, 0.3>, 0.1 texture { Material1 } }
plane { <0, 0, 1>, -2 texture { Material2 } }
polygon { 5, <-3.7, 1.5, -0.7>, <-2.3000000000000003, 1.5, -0.7>, <-2.3000000000000003, 1.5, 0.30000000000000004>, <-3.7, 1.5, 0.30000000000000004>, <-3.7, 1.5, -0.7> texture { pigment { rgb <0.7, 0.35, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
disc { <-1, 1.5, -0.2>, <0, -0.9578262852211513, 0.2873478855663454>, 0.7 texture { pigment { rgb <0.3, 0.7, 0.28> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
sphere { <1, 1.5, -0.2>, 0.32 texture { pigment { rgb <0.26, 0.38, 0.7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
triangle { <2.3, 1.4, -0.5>, <3, 1.7, 0.5>, <3.7, 1.4, -0.5> texture { pigment { rgb <0.7, 0.62, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (21)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.01, 0.01, 0.015> }

camera {
  perspective
  location <0, 2.6, 9>
  direction <0.00022329099369260206, -0.20156454085899592, -0.9794752603956722>
  right <0.8574374157795926, 0, 0>
  up <0, 0.5249233033580275, -0.10790090124581676>
}

light_source { <-2.6500000000000004, 1.5, 0.21666666666666679> rgb <155971844230.0574, 77985922115.0287, 49019722472.303764> spotlight point_at <-2.6500000000000004, 0.5, 0.21666666666666679> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <-1.5197538057765478, 1.5760977059309642, 0.053659019769880745> rgb <73500000000, 171500000000, 68600000000.00001> spotlight point_at <-1.5197538057765478, 0.6182714207098129, 0.34100690533622613> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <0.7599999999999999, 1.36143593539449, -0.04000000000000001> rgb <53248000000.00001, 77824000000.00002, 143360000000> spotlight point_at <0.009999999999999565, 0.9284232335022713, 0.45999999999999996> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <3.146503565873787, 1.4954703269782466, -0.18176557673917781> rgb <81419693026.09259, 72114585251.682, 25589046379.6291> spotlight point_at <3.146503565873787, 0.5376440417570952, 0.10558230882716763> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0 diffuse 1 } }

#declare Material2 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
cylinder { <-3, 0, 0.3>, <-3, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <-1, 0, 0.3>, <-1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <1, 0, 0.3>, <1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <3, 0, 0.3>, <3, 0.5, 0.3>, 0.1 texture { Material1 } }
plane { <0, 0, 1>, -2 texture { Material2 } }
polygon { 5, <-3.7, 1.5, -0.7>, <-2.3000000000000003, 1.5, -0.7>, <-2.3000000000000003, 1.5, 0.30000000000000004>, <-3.7, 1.5, 0.30000000000000004>, <-3.7, 1.5, -0.7> texture { pigment { rgb <0.7, 0.35, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
disc { <-1, 1.5, -0.2>, <0, -0.9578262852211513, 0.2873478855663454>, 0.7 texture { pigment { rgb <0.3, 0.7, 0.28> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
sphere { <1, 1.5, -0.2>, 0.32 texture { pigment { rgb <0.26, 0.38, 0.7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
triangle { <2.3, 1.4, -0.5>, <3, 1.7, 0.5>, <3.7, 1.4, -0.5> texture { pigment { rgb <0.7, 0.62, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (22)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.01, 0.01, 0.015> }

camera {
  perspective
  location <0, 2.6, 9>
  direction <0.0006698729810778068, -0.20156454085899592, -0.9794752603956722>
  right <0.8574374157795926, 0, 0>
  up <0, 0.5249233033580275, -0.10790090124581676>
}

light_source { <-3.116666666666667, 1.5, -0.1166666666666667> rgb <155971844230.0574, 77985922115.0287, 49019722472.303764> spotlight point_at <-3.116666666666667, 0.5, -0.1166666666666667> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <-0.9087465620598654, 1.334444075510015, -0.7518530816332825> rgb <73500000000, 171500000000, 68600000000.00001> spotlight point_at <-0.9087465620598654, 0.3766177902888638, -0.4645051960669371> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.24, 1.3614359353944898, -0.04000000000000001> rgb <53248000000.00001, 77824000000.00002, 143360000000> spotlight point_at <1.9900000000000002, 0.9284232335022707, 0.45999999999999996> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <3.2356092043868174, 1.457282196186948, -0.3090593460435067> rgb <81419693026.09259, 72114585251.682, 25589046379.6291> spotlight point_at <3.2356092043868174, 0.49945591096579667, -0.02171146047716127> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0 diffuse 1 } }

#declare Material2 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
cylinder { <-3, 0, 0.3>, <-3, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <-1, 0, 0.3>, <-1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <1, 0, 0.3>, <1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <3, 0, 0.3>, <3, 0.5, 0.3>, 0.1 texture { Material1 } }
plane { <0, 0, 1>, -2 texture { Material2 } }
polygon { 5, <-3.7, 1.5, -0.7>, <-2.3000000000000003, 1.5, -0.7>, <-2.3000000000000003, 1.5, 0.30000000000000004>, <-3.7, 1.5, 0.30000000000000004>, <-3.7, 1.5, -0.7> texture { pigment { rgb <0.7, 0.35, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
disc { <-1, 1.5, -0.2>, <0, -0.9578262852211513, 0.2873478855663454>, 0.7 texture { pigment { rgb <0.3, 0.7, 0.28> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
sphere { <1, 1.5, -0.2>, 0.32 texture { pigment { rgb <0.26, 0.38, 0.7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
triangle { <2.3, 1.4, -0.5>, <3, 1.7, 0.5>, <3.7, 1.4, -0.5> texture { pigment { rgb <0.7, 0.62, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (23)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.01, 0.01, 0.015> }

camera {
  perspective
  location <0, 2.6, 9>
  direction <0.0011164549684630114, -0.20156454085899592, -0.9794752603956722>
  right <0.8574374157795926, 0, 0>
  up <0, 0.5249233033580275, -0.10790090124581676>
}

light_source { <-3.35, 1.5, -0.2833333333333333> rgb <155971844230.0574, 77985922115.0287, 49019722472.303764> spotlight point_at <-3.35, 0.5, -0.2833333333333333> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <-1.2474873734152916, 1.4288850265447472, -0.4370499115175087> rgb <73500000000, 171500000000, 68600000000.00001> spotlight point_at <-1.2474873734152916, 0.47105874132359593, -0.14970202595116333> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <0.76, 1.6385640646055102, -0.04000000000000001> rgb <53248000000.00001, 77824000000.00002, 143360000000> spotlight point_at <0.010000000000000231, 2.0715767664977296, 0.45999999999999996> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <3.057397927360757, 1.5336584577695453, -0.05447180743484897> rgb <81419693026.09259, 72114585251.682, 25589046379.6291> spotlight point_at <3.057397927360757, 0.575832172548394, 0.23287607813149647> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0 diffuse 1 } }

#declare Material2 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
cylinder { <-3, 0, 0.3>, <-3, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <-1, 0, 0.3>, <-1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <1, 0, 0.3>, <1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <3, 0, 0.3>, <3, 0.5, 0.3>, 0.1 texture { Material1 } }
plane { <0, 0, 1>, -2 texture { Material2 } }
polygon { 5, <-3.7, 1.5, -0.7>, <-2.3000000000000003, 1.5, -0.7>, <-2.3000000000000003, 1.5, 0.30000000000000004>, <-3.7, 1.5, 0.30000000000000004>, <-3.7, 1.5, -0.7> texture { pigment { rgb <0.7, 0.35, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
disc { <-1, 1.5, -0.2>, <0, -0.9578262852211513, 0.2873478855663454>, 0.7 texture { pigment { rgb <0.3, 0.7, 0.28> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
sphere { <1, 1.5, -0.2>, 0.32 texture { pigment { rgb <0.26, 0.38, 0.7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
triangle { <2.3, 1.4, -0.5>, <3, 1.7, 0.5>, <3.7, 1.4, -0.5> texture { pigment { rgb <0.7, 0.62, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (24)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.01, 0.01, 0.015> }

camera {
  perspective
  location <0, 2.6, 9>
  direction <-0.0011164549684630114, -0.20200197694512761, -0.9793853429779674>
  right <0.8574374157795926, 0, 0>
  up <0, 0.5249233033580275, -0.10790090124581676>
}

light_source { <-2.8833333333333337, 1.5, -0.2833333333333333> rgb <155971844230.0574, 77985922115.0287, 49019722472.303764> spotlight point_at <-2.8833333333333337, 0.5, -0.2833333333333333> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <-1.4124789556921526, 1.6185249557587544, 0.1950831858625146> rgb <73500000000, 171500000000, 68600000000.00001> spotlight point_at <-1.4124789556921526, 0.6606986705376031, 0.48243107142886> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1, 1.2228718707889796, -0.36> rgb <53248000000.00001, 77824000000.00002, 143360000000> spotlight point_at <0.9999999999999999, 0.35684646700454115, -0.86> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.7375, 1.5125, -0.125> rgb <81419693026.09259, 72114585251.682, 25589046379.6291> spotlight point_at <2.7375, 0.5546737147788486, 0.16234788556634544> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0 diffuse 1 } }

#declare Material2 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
cylinder { <-3, 0, 0.3>, <-3, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <-1, 0, 0.3>, <-1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <1, 0, 0.3>, <1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <3, 0, 0.3>, <3, 0.5, 0.3>, 0.1 texture { Material1 } }
plane { <0, 0, 1>, -2 texture { Material2 } }
polygon { 5, <-3.7, 1.5, -0.7>, <-2.3000000000000003, 1.5, -0.7>, <-2.3000000000000003, 1.5, 0.30000000000000004>, <-3.7, 1.5, 0.30000000000000004>, <-3.7, 1.5, -0.7> texture { pigment { rgb <0.7, 0.35, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
disc { <-1, 1.5, -0.2>, <0, -0.9578262852211513, 0.2873478855663454>, 0.7 texture { pigment { rgb <0.3, 0.7, 0.28> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
sphere { <1, 1.5, -0.2>, 0.32 texture { pigment { rgb <0.26, 0.38, 0.7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
triangle { <2.3, 1.4, -0.5>, <3, 1.7, 0.5>, <3.7, 1.4, -0.5> texture { pigment { rgb <0.7, 0.62, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (25)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.01, 0.01, 0.015> }

camera {
  perspective
  location <0, 2.6, 9>
  direction <-0.0006698729810778068, -0.20200197694512761, -0.9793853429779674>
  right <0.8574374157795926, 0, 0>
  up <0, 0.5249233033580275, -0.10790090124581676>
}

light_source { <-2.6500000000000004, 1.5, 0.050000000000000044> rgb <155971844230.0574, 77985922115.0287, 49019722472.303764> spotlight point_at <-2.6500000000000004, 0.5, 0.050000000000000044> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <-1.3380740392011738, 1.4739701131259215, -0.2867662895802616> rgb <73500000000, 171500000000, 68600000000.00001> spotlight point_at <-1.3380740392011738, 0.5161438279047702, 0.0005815959860837605> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1, 1.8155242550986461, -0.14666666666666667> rgb <53248000000.00001, 77824000000.00002, 143360000000> spotlight point_at <1, 2.8015375522819155, 0.020000000000000073> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <3.1588085254195684, 1.5515544456622767, 0.005181485540922459> rgb <81419693026.09259, 72114585251.682, 25589046379.6291> spotlight point_at <3.1588085254195684, 0.5937281604411254, 0.2925293711072679> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0 diffuse 1 } }

#declare Material2 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
cylinder { <-3, 0, 0.3>, <-3, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <-1, 0, 0.3>, <-1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <1, 0, 0.3>, <1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <3, 0, 0.3>, <3, 0.5, 0.3>, 0.1 texture { Material1 } }
plane { <0, 0, 1>, -2 texture { Material2 } }
polygon { 5, <-3.7, 1.5, -0.7>, <-2.3000000000000003, 1.5, -0.7>, <-2.3000000000000003, 1.5, 0.30000000000000004>, <-3.7, 1.5, 0.30000000000000004>, <-3.7, 1.5, -0.7> texture { pigment { rgb <0.7, 0.35, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
disc { <-1, 1.5, -0.2>, <0, -0.9578262852211513, 0.2873478855663454>, 0.7 texture { pigment { rgb <0.3, 0.7, 0.28> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
sphere { <1, 1.5, -0.2>, 0.32 texture { pigment { rgb <0.26, 0.38, 0.7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
triangle { <2.3, 1.4, -0.5>, <3, 1.7, 0.5>, <3.7, 1.4, -0.5> texture { pigment { rgb <0.7, 0.62, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (26)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.01, 0.01, 0.015> }

camera {
  perspective
  location <0, 2.6, 9>
  direction <-0.00022329099369260234, -0.20200197694512761, -0.9793853429779674>
  right <0.8574374157795926, 0, 0>
  up <0, 0.5249233033580275, -0.10790090124581676>
}

light_source { <-3.116666666666667, 1.5, 0.050000000000000044> rgb <155971844230.0574, 77985922115.0287, 49019722472.303764> spotlight point_at <-3.116666666666667, 0.5, 0.050000000000000044> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <-1.2648277915147357, 1.350649842895048, -0.6978338570165067> rgb <73500000000, 171500000000, 68600000000.00001> spotlight point_at <-1.2648277915147357, 0.39282355767389665, -0.4104859714501613> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1, 1.7771281292110204, -0.04000000000000001> rgb <53248000000.00001, 77824000000.00002, 143360000000> spotlight point_at <1, 2.6431535329954587, 0.45999999999999996> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.970833333333333, 1.4124999999999999, -0.4583333333333333> rgb <81419693026.09259, 72114585251.682, 25589046379.6291> spotlight point_at <2.970833333333333, 0.45467371477884855, -0.17098544776698787> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0 diffuse 1 } }

#declare Material2 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
cylinder { <-3, 0, 0.3>, <-3, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <-1, 0, 0.3>, <-1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <1, 0, 0.3>, <1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <3, 0, 0.3>, <3, 0.5, 0.3>, 0.1 texture { Material1 } }
plane { <0, 0, 1>, -2 texture { Material2 } }
polygon { 5, <-3.7, 1.5, -0.7>, <-2.3000000000000003, 1.5, -0.7>, <-2.3000000000000003, 1.5, 0.30000000000000004>, <-3.7, 1.5, 0.30000000000000004>, <-3.7, 1.5, -0.7> texture { pigment { rgb <0.7, 0.35, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
disc { <-1, 1.5, -0.2>, <0, -0.9578262852211513, 0.2873478855663454>, 0.7 texture { pigment { rgb <0.3, 0.7, 0.28> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
sphere { <1, 1.5, -0.2>, 0.32 texture { pigment { rgb <0.26, 0.38, 0.7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
triangle { <2.3, 1.4, -0.5>, <3, 1.7, 0.5>, <3.7, 1.4, -0.5> texture { pigment { rgb <0.7, 0.62, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (27)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.01, 0.01, 0.015> }

camera {
  perspective
  location <0, 2.6, 9>
  direction <0.00022329099369260206, -0.20200197694512761, -0.9793853429779674>
  right <0.8574374157795926, 0, 0>
  up <0, 0.5249233033580275, -0.10790090124581676>
}

light_source { <-2.6500000000000004, 1.5, -0.1166666666666667> rgb <155971844230.0574, 77985922115.0287, 49019722472.303764> spotlight point_at <-2.6500000000000004, 0.5, -0.1166666666666667> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <-1.0824957911384308, 1.5237049911517508, -0.12098336282749717> rgb <73500000000, 171500000000, 68600000000.00001> spotlight point_at <-1.0824957911384308, 0.5658787059305995, 0.16636452273884822> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.2732520204255893, 1.657762127549323, -0.2533333333333333> rgb <53248000000.00001, 77824000000.00002, 143360000000> spotlight point_at <2.127164584255556, 2.1507687761409575, -0.4199999999999998> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.7958333333333334, 1.4874999999999998, -0.20833333333333337> rgb <81419693026.09259, 72114585251.682, 25589046379.6291> spotlight point_at <2.7958333333333334, 0.5296737147788485, 0.07901455223301207> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0 diffuse 1 } }

#declare Material2 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
cylinder { <-3, 0, 0.3>, <-3, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <-1, 0, 0.3>, <-1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <1, 0, 0.3>, <1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <3, 0, 0.3>, <3, 0.5, 0.3>, 0.1 texture { Material1 } }
plane { <0, 0, 1>, -2 texture { Material2 } }
polygon { 5, <-3.7, 1.5, -0.7>, <-2.3000000000000003, 1.5, -0.7>, <-2.3000000000000003, 1.5, 0.30000000000000004>, <-3.7, 1.5, 0.30000000000000004>, <-3.7, 1.5, -0.7> texture { pigment { rgb <0.7, 0.35, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
disc { <-1, 1.5, -0.2>, <0, -0.9578262852211513, 0.2873478855663454>, 0.7 texture { pigment { rgb <0.3, 0.7, 0.28> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
sphere { <1, 1.5, -0.2>, 0.32 texture { pigment { rgb <0.26, 0.38, 0.7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
triangle { <2.3, 1.4, -0.5>, <3, 1.7, 0.5>, <3.7, 1.4, -0.5> texture { pigment { rgb <0.7, 0.62, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (28)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.01, 0.01, 0.015> }

camera {
  perspective
  location <0, 2.6, 9>
  direction <0.0006698729810778068, -0.20200197694512761, -0.9793853429779674>
  right <0.8574374157795926, 0, 0>
  up <0, 0.5249233033580275, -0.10790090124581676>
}

light_source { <-3.35, 1.5, -0.44999999999999996> rgb <155971844230.0574, 77985922115.0287, 49019722472.303764> spotlight point_at <-3.35, 0.5, -0.44999999999999996> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <-0.48024619422345205, 1.5760977059309642, 0.053659019769880745> rgb <73500000000, 171500000000, 68600000000.00001> spotlight point_at <-0.48024619422345205, 0.6182714207098129, 0.34100690533622613> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1, 1.6768866554856212, -0.46666666666666673> rgb <53248000000.00001, 77824000000.00002, 143360000000> spotlight point_at <1, 2.2296574538781875, -1.3000000000000003> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <3.324714842899848, 1.4190940653956492, -0.43635311534783555> rgb <81419693026.09259, 72114585251.682, 25589046379.6291> spotlight point_at <3.324714842899848, 0.4612677801744979, -0.1490052297814901> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0 diffuse 1 } }

#declare Material2 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
cylinder { <-3, 0, 0.3>, <-3, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <-1, 0, 0.3>, <-1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <1, 0, 0.3>, <1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <3, 0, 0.3>, <3, 0.5, 0.3>, 0.1 texture { Material1 } }
plane { <0, 0, 1>, -2 texture { Material2 } }
polygon { 5, <-3.7, 1.5, -0.7>, <-2.3000000000000003, 1.5, -0.7>, <-2.3000000000000003, 1.5, 0.30000000000000004>, <-3.7, 1.5, 0.30000000000000004>, <-3.7, 1.5, -0.7> texture { pigment { rgb <0.7, 0.35, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
disc { <-1, 1.5, -0.2>, <0, -0.9578262852211513, 0.2873478855663454>, 0.7 texture { pigment { rgb <0.3, 0.7, 0.28> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
sphere { <1, 1.5, -0.2>, 0.32 texture { pigment { rgb <0.26, 0.38, 0.7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
triangle { <2.3, 1.4, -0.5>, <3, 1.7, 0.5>, <3.7, 1.4, -0.5> texture { pigment { rgb <0.7, 0.62, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (29)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.01, 0.01, 0.015> }

camera {
  perspective
  location <0, 2.6, 9>
  direction <0.0011164549684630114, -0.20200197694512761, -0.9793853429779674>
  right <0.8574374157795926, 0, 0>
  up <0, 0.5249233033580275, -0.10790090124581676>
}

light_source { <-2.416666666666667, 1.5, -0.44999999999999996> rgb <155971844230.0574, 77985922115.0287, 49019722472.303764> spotlight point_at <-2.416666666666667, 0.5, -0.44999999999999996> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <-0.48024619422345205, 1.4239022940690358, -0.45365901976988077> rgb <73500000000, 171500000000, 68600000000.00001> spotlight point_at <-0.48024619422345205, 0.46607600884788447, -0.16631113420353538> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1, 1.3231133445143786, 0.06666666666666665> rgb <53248000000.00001, 77824000000.00002, 143360000000> spotlight point_at <0.9999999999999999, 0.770342546121812, 0.9> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <3.057772228311384, 1.5948557158514987, 0.149519052838329> rgb <81419693026.09259, 72114585251.682, 25589046379.6291> spotlight point_at <3.057772228311384, 0.6370294306303473, 0.43686693840467444> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0 diffuse 1 } }

#declare Material2 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
cylinder { <-3, 0, 0.3>, <-3, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <-1, 0, 0.3>, <-1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <1, 0, 0.3>, <1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <3, 0, 0.3>, <3, 0.5, 0.3>, 0.1 texture { Material1 } }
plane { <0, 0, 1>, -2 texture { Material2 } }
polygon { 5, <-3.7, 1.5, -0.7>, <-2.3000000000000003, 1.5, -0.7>, <-2.3000000000000003, 1.5, 0.30000000000000004>, <-3.7, 1.5, 0.30000000000000004>, <-3.7, 1.5, -0.7> texture { pigment { rgb <0.7, 0.35, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
disc { <-1, 1.5, -0.2>, <0, -0.9578262852211513, 0.2873478855663454>, 0.7 texture { pigment { rgb <0.3, 0.7, 0.28> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
sphere { <1, 1.5, -0.2>, 0.32 texture { pigment { rgb <0.26, 0.38, 0.7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
triangle { <2.3, 1.4, -0.5>, <3, 1.7, 0.5>, <3.7, 1.4, -0.5> texture { pigment { rgb <0.7, 0.62, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (30)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.01, 0.01, 0.015> }

camera {
  perspective
  location <0, 2.6, 9>
  direction <-0.0011164549684630114, -0.2024394130312593, -0.9792954255602626>
  right <0.8574374157795926, 0, 0>
  up <0, 0.5249233033580275, -0.10790090124581676>
}

light_source { <-2.416666666666667, 1.5, 0.050000000000000044> rgb <155971844230.0574, 77985922115.0287, 49019722472.303764> spotlight point_at <-2.416666666666667, 0.5, 0.050000000000000044> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <-1.5197538057765478, 1.4239022940690358, -0.45365901976988077> rgb <73500000000, 171500000000, 68600000000.00001> spotlight point_at <-1.5197538057765478, 0.46607600884788447, -0.16631113420353538> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <0.7267479795744107, 1.6577621275493233, -0.14666666666666667> rgb <53248000000.00001, 77824000000.00002, 143360000000> spotlight point_at <-0.12716458425555555, 2.1507687761409584, 0.020000000000000073> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.9682922888477266, 1.571846588560844, 0.07282196186947998> rgb <81419693026.09259, 72114585251.682, 25589046379.6291> spotlight point_at <2.9682922888477266, 0.6140203033396926, 0.3601698474358254> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0 diffuse 1 } }

#declare Material2 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
cylinder { <-3, 0, 0.3>, <-3, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <-1, 0, 0.3>, <-1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <1, 0, 0.3>, <1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <3, 0, 0.3>, <3, 0.5, 0.3>, 0.1 texture { Material1 } }
plane { <0, 0, 1>, -2 texture { Material2 } }
polygon { 5, <-3.7, 1.5, -0.7>, <-2.3000000000000003, 1.5, -0.7>, <-2.3000000000000003, 1.5, 0.30000000000000004>, <-3.7, 1.5, 0.30000000000000004>, <-3.7, 1.5, -0.7> texture { pigment { rgb <0.7, 0.35, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
disc { <-1, 1.5, -0.2>, <0, -0.9578262852211513, 0.2873478855663454>, 0.7 texture { pigment { rgb <0.3, 0.7, 0.28> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
sphere { <1, 1.5, -0.2>, 0.32 texture { pigment { rgb <0.26, 0.38, 0.7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
triangle { <2.3, 1.4, -0.5>, <3, 1.7, 0.5>, <3.7, 1.4, -0.5> texture { pigment { rgb <0.7, 0.62, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (31)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.01, 0.01, 0.015> }

camera {
  perspective
  location <0, 2.6, 9>
  direction <-0.0006698729810778068, -0.2024394130312593, -0.9792954255602626>
  right <0.8574374157795926, 0, 0>
  up <0, 0.5249233033580275, -0.10790090124581676>
}

light_source { <-2.6500000000000004, 1.5, -0.2833333333333333> rgb <155971844230.0574, 77985922115.0287, 49019722472.303764> spotlight point_at <-2.6500000000000004, 0.5, -0.2833333333333333> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <-1.0824957911384305, 1.4762950088482492, -0.2790166371725029> rgb <73500000000, 171500000000, 68600000000.00001> spotlight point_at <-1.0824957911384305, 0.5184687236270978, 0.008331248393842472> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <0.7599999999999999, 1.36143593539449, -0.36> rgb <53248000000.00001, 77824000000.00002, 143360000000> spotlight point_at <0.009999999999999565, 0.9284232335022713, -0.86> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <3.1660421093602698, 1.4161374306091974, -0.4462085646360081> rgb <81419693026.09259, 72114585251.682, 25589046379.6291> spotlight point_at <3.1660421093602698, 0.45831114538804607, -0.15886067906966267> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0 diffuse 1 } }

#declare Material2 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
cylinder { <-3, 0, 0.3>, <-3, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <-1, 0, 0.3>, <-1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <1, 0, 0.3>, <1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <3, 0, 0.3>, <3, 0.5, 0.3>, 0.1 texture { Material1 } }
plane { <0, 0, 1>, -2 texture { Material2 } }
polygon { 5, <-3.7, 1.5, -0.7>, <-2.3000000000000003, 1.5, -0.7>, <-2.3000000000000003, 1.5, 0.30000000000000004>, <-3.7, 1.5, 0.30000000000000004>, <-3.7, 1.5, -0.7> texture { pigment { rgb <0.7, 0.35, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
disc { <-1, 1.5, -0.2>, <0, -0.9578262852211513, 0.2873478855663454>, 0.7 texture { pigment { rgb <0.3, 0.7, 0.28> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
sphere { <1, 1.5, -0.2>, 0.32 texture { pigment { rgb <0.26, 0.38, 0.7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
triangle { <2.3, 1.4, -0.5>, <3, 1.7, 0.5>, <3.7, 1.4, -0.5> texture { pigment { rgb <0.7, 0.62, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (32)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.01, 0.01, 0.015> }

camera {
  perspective
  location <0, 2.6, 9>
  direction <-0.00022329099369260234, -0.2024394130312593, -0.9792954255602626>
  right <0.8574374157795926, 0, 0>
  up <0, 0.5249233033580275, -0.10790090124581676>
}

light_source { <-2.6500000000000004, 1.5, -0.44999999999999996> rgb <155971844230.0574, 77985922115.0287, 49019722472.303764> spotlight point_at <-2.6500000000000004, 0.5, -0.44999999999999996> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <-1.0905866657858823, 1.5971448603293312, 0.12381620109777025> rgb <73500000000, 171500000000, 68600000000.00001> spotlight point_at <-1.0905866657858823, 0.6393185751081799, 0.41116408666411564> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <0.7267479795744105, 1.3422378724506772, -0.2533333333333333> rgb <53248000000.00001, 77824000000.00002, 143360000000> spotlight point_at <-0.12716458425555643, 0.8492312238590431, -0.4199999999999998> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.6791666666666667, 1.5374999999999999, -0.04166666666666663> rgb <81419693026.09259, 72114585251.682, 25589046379.6291> spotlight point_at <2.6791666666666667, 0.5796737147788485, 0.2456812188996788> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0 diffuse 1 } }

#declare Material2 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
cylinder { <-3, 0, 0.3>, <-3, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <-1, 0, 0.3>, <-1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <1, 0, 0.3>, <1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <3, 0, 0.3>, <3, 0.5, 0.3>, 0.1 texture { Material1 } }
plane { <0, 0, 1>, -2 texture { Material2 } }
polygon { 5, <-3.7, 1.5, -0.7>, <-2.3000000000000003, 1.5, -0.7>, <-2.3000000000000003, 1.5, 0.30000000000000004>, <-3.7, 1.5, 0.30000000000000004>, <-3.7, 1.5, -0.7> texture { pigment { rgb <0.7, 0.35, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
disc { <-1, 1.5, -0.2>, <0, -0.9578262852211513, 0.2873478855663454>, 0.7 texture { pigment { rgb <0.3, 0.7, 0.28> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
sphere { <1, 1.5, -0.2>, 0.32 texture { pigment { rgb <0.26, 0.38, 0.7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
triangle { <2.3, 1.4, -0.5>, <3, 1.7, 0.5>, <3.7, 1.4, -0.5> texture { pigment { rgb <0.7, 0.62, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (33)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.01, 0.01, 0.015> }

camera {
  perspective
  location <0, 2.6, 9>
  direction <0.00022329099369260206, -0.2024394130312593, -0.9792954255602626>
  right <0.8574374157795926, 0, 0>
  up <0, 0.5249233033580275, -0.10790090124581676>
}

light_source { <-3.5833333333333335, 1.5, -0.2833333333333333> rgb <155971844230.0574, 77985922115.0287, 49019722472.303764> spotlight point_at <-3.5833333333333335, 0.5, -0.2833333333333333> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <-0.5875210443078471, 1.3814750442412456, -0.5950831858625145> rgb <73500000000, 171500000000, 68600000000.00001> spotlight point_at <-0.5875210443078471, 0.42364875902009425, -0.30773530029616913> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <0.76, 1.6385640646055102, -0.36> rgb <53248000000.00001, 77824000000.00002, 143360000000> spotlight point_at <0.010000000000000231, 2.0715767664977296, -0.86> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <3.1377487192867957, 1.615421099245176, 0.21807033081725358> rgb <81419693026.09259, 72114585251.682, 25589046379.6291> spotlight point_at <3.1377487192867957, 0.6575948140240248, 0.505418216383599> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0 diffuse 1 } }

#declare Material2 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
cylinder { <-3, 0, 0.3>, <-3, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <-1, 0, 0.3>, <-1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <1, 0, 0.3>, <1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <3, 0, 0.3>, <3, 0.5, 0.3>, 0.1 texture { Material1 } }
plane { <0, 0, 1>, -2 texture { Material2 } }
polygon { 5, <-3.7, 1.5, -0.7>, <-2.3000000000000003, 1.5, -0.7>, <-2.3000000000000003, 1.5, 0.30000000000000004>, <-3.7, 1.5, 0.30000000000000004>, <-3.7, 1.5, -0.7> texture { pigment { rgb <0.7, 0.35, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
disc { <-1, 1.5, -0.2>, <0, -0.9578262852211513, 0.2873478855663454>, 0.7 texture { pigment { rgb <0.3, 0.7, 0.28> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
sphere { <1, 1.5, -0.2>, 0.32 texture { pigment { rgb <0.26, 0.38, 0.7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
triangle { <2.3, 1.4, -0.5>, <3, 1.7, 0.5>, <3.7, 1.4, -0.5> texture { pigment { rgb <0.7, 0.62, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (34)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.01, 0.01, 0.015> }

camera {
  perspective
  location <0, 2.6, 9>
  direction <0.0006698729810778068, -0.2024394130312593, -0.9792954255602626>
  right <0.8574374157795926, 0, 0>
  up <0, 0.5249233033580275, -0.10790090124581676>
}

light_source { <-2.416666666666667, 1.5, -0.1166666666666667> rgb <155971844230.0574, 77985922115.0287, 49019722472.303764> spotlight point_at <-2.416666666666667, 0.5, -0.1166666666666667> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <-1.4124789556921526, 1.3814750442412456, -0.5950831858625145> rgb <73500000000, 171500000000, 68600000000.00001> spotlight point_at <-1.4124789556921526, 0.42364875902009425, -0.30773530029616913> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1.153188337241014, 1.4115566722571895, -0.46666666666666673> rgb <53248000000.00001, 77824000000.00002, 143360000000> spotlight point_at <1.631901891119183, 1.1351712730609065, -1.3000000000000003> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.6199482741759175, 1.4360843918243515, -0.37971869391882795> rgb <81419693026.09259, 72114585251.682, 25589046379.6291> spotlight point_at <2.6199482741759175, 0.47825810660320023, -0.09237080835248251> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0 diffuse 1 } }

#declare Material2 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
cylinder { <-3, 0, 0.3>, <-3, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <-1, 0, 0.3>, <-1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <1, 0, 0.3>, <1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <3, 0, 0.3>, <3, 0.5, 0.3>, 0.1 texture { Material1 } }
plane { <0, 0, 1>, -2 texture { Material2 } }
polygon { 5, <-3.7, 1.5, -0.7>, <-2.3000000000000003, 1.5, -0.7>, <-2.3000000000000003, 1.5, 0.30000000000000004>, <-3.7, 1.5, 0.30000000000000004>, <-3.7, 1.5, -0.7> texture { pigment { rgb <0.7, 0.35, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
disc { <-1, 1.5, -0.2>, <0, -0.9578262852211513, 0.2873478855663454>, 0.7 texture { pigment { rgb <0.3, 0.7, 0.28> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
sphere { <1, 1.5, -0.2>, 0.32 texture { pigment { rgb <0.26, 0.38, 0.7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
triangle { <2.3, 1.4, -0.5>, <3, 1.7, 0.5>, <3.7, 1.4, -0.5> texture { pigment { rgb <0.7, 0.62, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#case (35)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.01, 0.01, 0.015> }

camera {
  perspective
  location <0, 2.6, 9>
  direction <0.0011164549684630114, -0.2024394130312593, -0.9792954255602626>
  right <0.8574374157795926, 0, 0>
  up <0, 0.5249233033580275, -0.10790090124581676>
}

light_source { <-3.5833333333333335, 1.5, -0.1166666666666667> rgb <155971844230.0574, 77985922115.0287, 49019722472.303764> spotlight point_at <-3.5833333333333335, 0.5, -0.1166666666666667> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <-0.6619259607988262, 1.4739701131259215, -0.2867662895802616> rgb <73500000000, 171500000000, 68600000000.00001> spotlight point_at <-0.6619259607988262, 0.5161438279047702, 0.0005815959860837605> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <1, 1.3231133445143788, -0.46666666666666673> rgb <53248000000.00001, 77824000000.00002, 143360000000> spotlight point_at <0.9999999999999999, 0.7703425461218124, -1.3000000000000003> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }
light_source { <2.9401180808315037, 1.512962014264383, -0.12345995245205676> rgb <81419693026.09259, 72114585251.682, 25589046379.6291> spotlight point_at <2.9401180808315037, 0.5551357290432316, 0.16388793311428868> radius 90 falloff 90 tightness 1 fade_distance 1e-06 fade_power 2 }

#declare Material0 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

#declare Material1 =
  texture { pigment { rgb <0.6, 0.6, 0.65> } finish { ambient 0 diffuse 1 } }

#declare Material2 =
  texture { pigment { rgb 0.85 } finish { ambient 0 diffuse 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
cylinder { <-3, 0, 0.3>, <-3, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <-1, 0, 0.3>, <-1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <1, 0, 0.3>, <1, 0.5, 0.3>, 0.1 texture { Material1 } }
cylinder { <3, 0, 0.3>, <3, 0.5, 0.3>, 0.1 texture { Material1 } }
plane { <0, 0, 1>, -2 texture { Material2 } }
polygon { 5, <-3.7, 1.5, -0.7>, <-2.3000000000000003, 1.5, -0.7>, <-2.3000000000000003, 1.5, 0.30000000000000004>, <-3.7, 1.5, 0.30000000000000004>, <-3.7, 1.5, -0.7> texture { pigment { rgb <0.7, 0.35, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
disc { <-1, 1.5, -0.2>, <0, -0.9578262852211513, 0.2873478855663454>, 0.7 texture { pigment { rgb <0.3, 0.7, 0.28> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
sphere { <1, 1.5, -0.2>, 0.32 texture { pigment { rgb <0.26, 0.38, 0.7> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
triangle { <2.3, 1.4, -0.5>, <3, 1.7, 0.5>, <3.7, 1.4, -0.5> texture { pigment { rgb <0.7, 0.62, 0.22> } finish { ambient 0 diffuse 0 emission 1 } } interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } } }
#break
#end
