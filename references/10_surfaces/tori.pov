// tori.scene, written by `course export`.
// povray +Itori.pov +Otori.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10 adc_bailout 0 }
background { rgb <0.55, 0.62, 0.72> }

camera {
  perspective
  location <0, 3.3, 7.2>
  direction <0, -0.3415304794971503, -0.9398706993913827>
  right <0.8922541853388618, 0, 0>
  up <0, 0.6289526739069933, -0.22854899981409052>
}

light_source { <47286.624374346036, 78811.04062391007, 39405.520311955035> rgb <0.72, 0.7, 0.64> parallel point_at 0 }
light_source { <-71554.17527999327, 44721.359549995796, 53665.63145999495> rgb <0.12, 0.14, 0.18> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.12, 0.12, 0.13> rgb <0.0744, 0.0816, 0.0936> scale 0.8 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.62, 0.58, 0.5> transmit 0.5 rgb <0.3844, 0.39440000000000003, 0.36> transmit 0.5 scale 0.8 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 specular 1.2 roughness 0.011111111111111112 } }
  texture { pigment { rgb <1, 0.8, 0.46666666666666673> filter 1 } finish { ambient 0 diffuse 0 } }
  texture { pigment { rgb <0.1, 0.08, 0.05> transmit 0.5 } finish { ambient 0 diffuse 0 emission 4 } }
  texture { pigment { rgb <0.52, 0.36, 0.14> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb <0.3, 0.24, 0.14> } } }

#declare Material2 =
  texture { pigment { rgb <0.08, 0.03, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.1, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.25 } specular 0.25 roughness 0.005 } }

#declare Material3 =
  texture { pigment { rgb 0.1 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.3, 0.3, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.5 } specular 0.5 roughness 0.005 } }

#declare Material4 =
  texture { pigment { rgb <0.04, 0.08, 0.05> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.42, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.2 } specular 0.2 roughness 0.016666666666666666 } }

#declare Material5 =
  texture { pigment { rgb <0.97, 0.99, 1> filter 1 } finish { ambient 0 diffuse 0 reflection { rgb 0, rgb 1 fresnel } conserve_energy } }

plane { <0.00999932006935214, 0.999932006935214, 0.0059995920416112845>, 0 texture { Material0 } }
torus { 0.5, 0.12 sturm matrix <0.9987523388778448, -0.04993761694389224, 0, 0.04991521613769646, 0.9983043227539291, 0.029949129682617873, -0.0014955881658935243, -0.029911763317870484, 0.9995514242055054, 0, 0, 0> translate <-2.75, 0.16, 0.95> texture { Material1 } }
torus { 0.5, 0.12 sturm matrix <0, -0.9837002310416286, 0.17981617126567406, -0.3206097383055075, -0.17032392347480088, -0.9317720519503813, 0.9472113785759088, -0.05765081561258607, -0.31538387364532383, 0, 0, 0> translate <-2.14, 0.507, 0.688> texture { Material1 } }
torus { 0.5, 0.12 sturm matrix <-0.7915052914417219, -0.6111623136448738, 0, 0.6111623136448737, -0.7915052914417217, 0, 0, 0, 1, 0, 0, 0> translate <-1.6, 0.881, 0.454> texture { Material1 } }
torus { 0.5, 0.12 sturm matrix <0, -0.9764282933874943, 0.21584204380144612, -0.22055207113151765, -0.2105269769891759, -0.9523839435224625, 0.9753752016119736, -0.04760440979766869, -0.215353282418025, 0, 0, 0> translate <-1.1, 1.315, 0.237> texture { Material1 } }
torus { 0.5, 0.12 sturm matrix <-0.6816036551035045, -0.7317215709199386, 0, 0.7317215709199386, -0.6816036551035045, 0, 0, 0, 1, 0, 0, 0> translate <-0.627, 1.795, 0.034> texture { Material1 } }
torus { 0.5, 0.12 sturm matrix <0, -0.9769000173962619, 0.21369687880543226, -0.1801712440614613, -0.21019978473837148, -0.9609133016611268, 0.9836352590332179, -0.03850203250642605, -0.17600929145794766, 0, 0, 0> translate <-0.18, 2.295, -0.159> texture { Material1 } }
merge { torus { 0.36, 0.78 sturm } sphere { 0, 0.6919537556802479 } matrix <0.9889363528682975, -0.14834045293024462, 0, 0.14762034939153687, 0.9841356626102459, 0.0984135662610246, -0.014598712993641029, -0.0973247532909402, 0.9951456023998635, 0, 0, 0> translate <1.35, 0.78, -0.6> texture { Material2 } }
torus { 1.32, 0.018 sturm matrix <0.9438583563660174, 0.33035042472810605, 0, -0.3215206485222377, 0.9186304243492507, 0.22965760608731267, 0.07586748771298381, -0.21676425060852522, 0.9732714852322782, 0, 0, 0> translate <1.35, 0.8, -0.6> texture { Material3 } }
torus { 0.35, 0.35 sturm translate <0, 0, 0> matrix <0.99033512234615, 0.13490166090005348, 0.03221625884616688, -0.08363902975803315, 0.5474275075725348, 0.27879676586011054, 0.03221625884616688, -0.4496722030001783, 0.892612470512777, 0.35, 0.4, 1.55> texture { Material4 } }
torus { 0.55, 0.22 sturm matrix <0.9701425001453318, -0.24253562503633294, 0, 0.2414022747926338, 0.9656090991705352, -0.09656090991705352, 0.023419460640809613, 0.09367784256323845, 0.9953270772344086, 0, 0, 0> translate <1.85, 0.27, 1.5> texture { Material5 } interior { ior 1.5 } }
