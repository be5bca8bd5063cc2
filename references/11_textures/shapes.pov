// shapes.scene, written by `course export`.
// povray +Ishapes.pov +Oshapes.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.5, 0.58, 0.68> }

camera {
  perspective
  location <0, 3.4, 8>
  direction <0, -0.3355903575378423, -0.9420080211588556>
  right <0.7646543620234877, 0, 0>
  up <0, 0.5402329068301747, -0.19245797305824972>
}

light_source { <-4, 7, 6> rgb <0.85, 0.82, 0.78> }
light_source { <75809.80435789035, 53066.863050523236, 37904.90217894517> rgb <0.16, 0.17, 0.2> parallel point_at 0 }

#declare Picture0RepeatRepeat = function { pigment { image_map { png "figures/map.png" gamma srgb interpolate 2 } } }
#declare Picture0RepeatRepeatRed = function(x, y) { Picture0RepeatRepeat(x, y, 0).red }
#declare Picture0RepeatRepeatGreen = function(x, y) { Picture0RepeatRepeat(x, y, 0).green }
#declare Picture0RepeatRepeatBlue = function(x, y) { Picture0RepeatRepeat(x, y, 0).blue }
#declare Nothing = texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } }

#declare OwnX0 = function { 0.5 * x + 0 * y + 0 * z + 0 }
#declare OwnY0 = function { 0 * x + 0.5 * y + 0 * z + 0 }
#declare OwnZ0 = function { 0 * x + 0 * y + -0.5 * z + 0 }
#declare UOwn0 = function(x, y, z) { x }
#declare U0 = function(x, y, z) { UOwn0(OwnX0(x, y, z), OwnY0(x, y, z), OwnZ0(x, y, z)) }
#declare VOwn0 = function(x, y, z) { z }
#declare V0 = function(x, y, z) { VOwn0(OwnX0(x, y, z), OwnY0(x, y, z), OwnZ0(x, y, z)) }
#declare Object0Rest =
  texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } }

#declare Object0Red =
  texture { pigment { rgb <125829.48, 0, 0> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <838863.2000000001, 0, 0> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Object0Green =
  texture { pigment { rgb <0, 125829.48, 0> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0, 838863.2000000001, 0> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Object0Blue =
  texture { pigment { rgb <0, 0, 125829.48> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0, 0, 838863.2000000001> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Object0 = texture { average texture_map { [1 Object0Rest]
  [9.5367431640625e-07 function { Picture0RepeatRepeatRed(U0(x, y, z), V0(x, y, z)) } texture_map { [0 Nothing] [1 Object0Red] }]
  [9.5367431640625e-07 function { Picture0RepeatRepeatGreen(U0(x, y, z), V0(x, y, z)) } texture_map { [0 Nothing] [1 Object0Green] }]
  [9.5367431640625e-07 function { Picture0RepeatRepeatBlue(U0(x, y, z), V0(x, y, z)) } texture_map { [0 Nothing] [1 Object0Blue] }] } }

#declare OwnX1 = function { 1.25 * x + 0 * y + 0 * z + 2.9999999999999996 }
#declare OwnY1 = function { 0 * x + 1.25 * y + 0 * z + -1.0125 }
#declare OwnZ1 = function { 0 * x + 0 * y + 1.25 * z + 1.25 }
#declare UOwn1 = function(x, y, z) { atan2(z, x) / (2 * pi) + (z < 0) }
#declare U1 = function(x, y, z) { UOwn1(OwnX1(x, y, z), OwnY1(x, y, z), OwnZ1(x, y, z)) }
#declare VOwn1 = function(x, y, z) { 0.5 + asin(min(max(y, -1), 1)) / pi }
#declare V1 = function(x, y, z) { VOwn1(OwnX1(x, y, z), OwnY1(x, y, z), OwnZ1(x, y, z)) }
#declare Object1Rest =
  texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } }

#declare Object1Red =
  texture { pigment { rgb <125829.48, 0, 0> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <838863.2000000001, 0, 0> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Object1Green =
  texture { pigment { rgb <0, 125829.48, 0> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0, 838863.2000000001, 0> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Object1Blue =
  texture { pigment { rgb <0, 0, 125829.48> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0, 0, 838863.2000000001> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Object1 = texture { average texture_map { [1 Object1Rest]
  [9.5367431640625e-07 function { Picture0RepeatRepeatRed(U1(x, y, z), V1(x, y, z)) } texture_map { [0 Nothing] [1 Object1Red] }]
  [9.5367431640625e-07 function { Picture0RepeatRepeatGreen(U1(x, y, z), V1(x, y, z)) } texture_map { [0 Nothing] [1 Object1Green] }]
  [9.5367431640625e-07 function { Picture0RepeatRepeatBlue(U1(x, y, z), V1(x, y, z)) } texture_map { [0 Nothing] [1 Object1Blue] }] } }

#declare OwnX2 = function { 1.510512978394417 * x + 0 * y + -0.7043637695678328 * z + -0.3869933580001366 }
#declare OwnY2 = function { 0 * x + 1.6666666666666667 * y + 0 * z + -1.0166666666666668 }
#declare OwnZ2 = function { 0.7043637695678328 * x + 0 * y + 1.510512978394417 * z + 2.2101941912614835 }
#declare UOwn2 = function(x, y, z) { 0.5 + 0.5 * select(abs(x) - max(abs(y), abs(z)), select(abs(y) - abs(z), x * (2 * (z > 0) - 1), x), z * (1 - 2 * (x > 0))) }
#declare U2 = function(x, y, z) { UOwn2(OwnX2(x, y, z), OwnY2(x, y, z), OwnZ2(x, y, z)) }
#declare VOwn2 = function(x, y, z) { 0.5 + 0.5 * select(abs(x) - max(abs(y), abs(z)), select(abs(y) - abs(z), y, z * (1 - 2 * (y > 0))), y) }
#declare V2 = function(x, y, z) { VOwn2(OwnX2(x, y, z), OwnY2(x, y, z), OwnZ2(x, y, z)) }
#declare Object2Rest =
  texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } }

#declare Object2Red =
  texture { pigment { rgb <125829.48, 0, 0> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <838863.2000000001, 0, 0> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Object2Green =
  texture { pigment { rgb <0, 125829.48, 0> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0, 838863.2000000001, 0> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Object2Blue =
  texture { pigment { rgb <0, 0, 125829.48> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0, 0, 838863.2000000001> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Object2 = texture { average texture_map { [1 Object2Rest]
  [9.5367431640625e-07 function { Picture0RepeatRepeatRed(U2(x, y, z), V2(x, y, z)) } texture_map { [0 Nothing] [1 Object2Red] }]
  [9.5367431640625e-07 function { Picture0RepeatRepeatGreen(U2(x, y, z), V2(x, y, z)) } texture_map { [0 Nothing] [1 Object2Green] }]
  [9.5367431640625e-07 function { Picture0RepeatRepeatBlue(U2(x, y, z), V2(x, y, z)) } texture_map { [0 Nothing] [1 Object2Blue] }] } }

#declare OwnX3 = function { 1 * x + 0 * y + 0 * z + -1.9 }
#declare OwnY3 = function { 0 * x + 0.9396926207859084 * y + 0.3420201433256687 * z + 0.0037307998427417166 }
#declare OwnZ3 = function { 0 * x + -0.3420201433256687 * y + 0.9396926207859084 * z + 1.0628198723831492 }
#declare UOwn3 = function(x, y, z) { 0.5 - atan2(z, x) / (2 * pi) }
#declare U3 = function(x, y, z) { UOwn3(OwnX3(x, y, z), OwnY3(x, y, z), OwnZ3(x, y, z)) }
#declare VOwn3 = function(x, y, z) { 0.5 + atan2(y, sqrt(x * x + z * z) - 0.75) / (2 * pi) }
#declare V3 = function(x, y, z) { VOwn3(OwnX3(x, y, z), OwnY3(x, y, z), OwnZ3(x, y, z)) }
#declare Object3Rest =
  texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } }

#declare Object3Red =
  texture { pigment { rgb <125829.48, 0, 0> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <838863.2000000001, 0, 0> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Object3Green =
  texture { pigment { rgb <0, 125829.48, 0> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0, 838863.2000000001, 0> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Object3Blue =
  texture { pigment { rgb <0, 0, 125829.48> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0, 0, 838863.2000000001> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Object3 = texture { average texture_map { [1 Object3Rest]
  [9.5367431640625e-07 function { Picture0RepeatRepeatRed(U3(x, y, z), V3(x, y, z)) } texture_map { [0 Nothing] [1 Object3Red] }]
  [9.5367431640625e-07 function { Picture0RepeatRepeatGreen(U3(x, y, z), V3(x, y, z)) } texture_map { [0 Nothing] [1 Object3Green] }]
  [9.5367431640625e-07 function { Picture0RepeatRepeatBlue(U3(x, y, z), V3(x, y, z)) } texture_map { [0 Nothing] [1 Object3Blue] }] } }

#declare OwnX4 = function { 1 * x + 0 * y + 0 * z + 1.9000000000000001 }
#declare OwnY4 = function { 0 * x + 0.9174311926605504 * y + 0 * z + -0.009174311926605503 }
#declare OwnZ4 = function { 0 * x + 0 * y + 1 * z + -1.1 }
#declare UOwn4 = function(x, y, z) { select(y - 1e-7, 0.5 + (1 * x + 0 * z) / 1.1, select(y - 1 + 1e-7, atan2(z, x) / (2 * pi) + (z < 0), 0.5 + (1 * x + 0 * z) / 1.1)) }
#declare U4 = function(x, y, z) { UOwn4(OwnX4(x, y, z), OwnY4(x, y, z), OwnZ4(x, y, z)) }
#declare VOwn4 = function(x, y, z) { select(y - 1e-7, 0.5 + (0 * x + 1 * z) / 1.1, select(y - 1 + 1e-7, min(max(y, 0), 1), 0.5 + (0 * x + -1 * z) / 1.1)) }
#declare V4 = function(x, y, z) { VOwn4(OwnX4(x, y, z), OwnY4(x, y, z), OwnZ4(x, y, z)) }
#declare Object4Rest =
  texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } }

#declare Object4Red =
  texture { pigment { rgb <125829.48, 0, 0> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <838863.2000000001, 0, 0> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Object4Green =
  texture { pigment { rgb <0, 125829.48, 0> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0, 838863.2000000001, 0> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Object4Blue =
  texture { pigment { rgb <0, 0, 125829.48> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0, 0, 838863.2000000001> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Object4 = texture { average texture_map { [1 Object4Rest]
  [9.5367431640625e-07 function { Picture0RepeatRepeatRed(U4(x, y, z), V4(x, y, z)) } texture_map { [0 Nothing] [1 Object4Red] }]
  [9.5367431640625e-07 function { Picture0RepeatRepeatGreen(U4(x, y, z), V4(x, y, z)) } texture_map { [0 Nothing] [1 Object4Green] }]
  [9.5367431640625e-07 function { Picture0RepeatRepeatBlue(U4(x, y, z), V4(x, y, z)) } texture_map { [0 Nothing] [1 Object4Blue] }] } }

#declare OwnX5 = function { 1 * x + 0 * y + 0 * z + 0.3 }
#declare OwnY5 = function { 0 * x + 0.7751937984496124 * y + 0 * z + -0.007751937984496125 }
#declare OwnZ5 = function { 0 * x + 0 * y + 1.0000000000000002 * z + -1.3000000000000003 }
#declare UOwn5 = function(x, y, z) { select(y - 1e-7, 0.5 + (1 * x + 0 * z) / 1.2, select(y - 1 + 1e-7, atan2(z, x) / (2 * pi) + (z < 0), 0.5 + (1 * x + 0 * z) / 0.24)) }
#declare U5 = function(x, y, z) { UOwn5(OwnX5(x, y, z), OwnY5(x, y, z), OwnZ5(x, y, z)) }
#declare VOwn5 = function(x, y, z) { select(y - 1e-7, 0.5 + (0 * x + 0.9999999999999998 * z) / 1.2, select(y - 1 + 1e-7, min(max(y, 0), 1), 0.5 + (0 * x + -0.9999999999999998 * z) / 0.24)) }
#declare V5 = function(x, y, z) { VOwn5(OwnX5(x, y, z), OwnY5(x, y, z), OwnZ5(x, y, z)) }
#declare Object5Rest =
  texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } }

#declare Object5Red =
  texture { pigment { rgb <125829.48, 0, 0> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <838863.2000000001, 0, 0> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Object5Green =
  texture { pigment { rgb <0, 125829.48, 0> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0, 838863.2000000001, 0> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Object5Blue =
  texture { pigment { rgb <0, 0, 125829.48> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0, 0, 838863.2000000001> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Object5 = texture { average texture_map { [1 Object5Rest]
  [9.5367431640625e-07 function { Picture0RepeatRepeatRed(U5(x, y, z), V5(x, y, z)) } texture_map { [0 Nothing] [1 Object5Red] }]
  [9.5367431640625e-07 function { Picture0RepeatRepeatGreen(U5(x, y, z), V5(x, y, z)) } texture_map { [0 Nothing] [1 Object5Green] }]
  [9.5367431640625e-07 function { Picture0RepeatRepeatBlue(U5(x, y, z), V5(x, y, z)) } texture_map { [0 Nothing] [1 Object5Blue] }] } }

#declare OwnX6 = function { 1.5536778079906948 * x + 0.1458813604333406 * y + 0.4077507982238722 * z + -2.455831279760819 }
#declare OwnY6 = function { -0.4327873504838303 * x + 0.5770498006451071 * y + 1.4426245016127675 * z + -1.6157394418062996 }
#declare OwnZ6 = function { 0.015401105001701521 * x + 1.4990626978450294 * y + -0.5950047476375014 * z + -0.3538195173285608 }
#declare UOwn6 = function(x, y, z) { 0.5 + 0.5 * x }
#declare U6 = function(x, y, z) { UOwn6(OwnX6(x, y, z), OwnY6(x, y, z), OwnZ6(x, y, z)) }
#declare VOwn6 = function(x, y, z) { 0.5 + 0.5 * z }
#declare V6 = function(x, y, z) { VOwn6(OwnX6(x, y, z), OwnY6(x, y, z), OwnZ6(x, y, z)) }
#declare Object6Rest =
  texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } }

#declare Object6Red =
  texture { pigment { rgb <125829.48, 0, 0> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <838863.2000000001, 0, 0> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Object6Green =
  texture { pigment { rgb <0, 125829.48, 0> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0, 838863.2000000001, 0> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Object6Blue =
  texture { pigment { rgb <0, 0, 125829.48> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0, 0, 838863.2000000001> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Object6 = texture { average texture_map { [1 Object6Rest]
  [9.5367431640625e-07 function { Picture0RepeatRepeatRed(U6(x, y, z), V6(x, y, z)) } texture_map { [0 Nothing] [1 Object6Red] }]
  [9.5367431640625e-07 function { Picture0RepeatRepeatGreen(U6(x, y, z), V6(x, y, z)) } texture_map { [0 Nothing] [1 Object6Green] }]
  [9.5367431640625e-07 function { Picture0RepeatRepeatBlue(U6(x, y, z), V6(x, y, z)) } texture_map { [0 Nothing] [1 Object6Blue] }] } }

#declare OwnX7 = function { 0.8333333333333333 * x + -0.49358974358974345 * y + 0.13461538461538458 * z + -1.7963461538461536 }
#declare OwnY7 = function { 0 * x + 0.19230769230769226 * y + 0.705128205128205 * z + -0.7070512820512819 }
#declare OwnZ7 = function { 0 * x + 0.846153846153846 * y + -0.23076923076923073 * z + 0.22230769230769223 }
#declare UOwn7 = function(x, y, z) { x }
#declare U7 = function(x, y, z) { UOwn7(OwnX7(x, y, z), OwnY7(x, y, z), OwnZ7(x, y, z)) }
#declare VOwn7 = function(x, y, z) { z }
#declare V7 = function(x, y, z) { VOwn7(OwnX7(x, y, z), OwnY7(x, y, z), OwnZ7(x, y, z)) }
#declare Object7Rest =
  texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } }

#declare Object7Red =
  texture { pigment { rgb <125829.48, 0, 0> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <838863.2000000001, 0, 0> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Object7Green =
  texture { pigment { rgb <0, 125829.48, 0> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0, 838863.2000000001, 0> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Object7Blue =
  texture { pigment { rgb <0, 0, 125829.48> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0, 0, 838863.2000000001> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Object7 = texture { average texture_map { [1 Object7Rest]
  [9.5367431640625e-07 function { Picture0RepeatRepeatRed(U7(x, y, z), V7(x, y, z)) } texture_map { [0 Nothing] [1 Object7Red] }]
  [9.5367431640625e-07 function { Picture0RepeatRepeatGreen(U7(x, y, z), V7(x, y, z)) } texture_map { [0 Nothing] [1 Object7Green] }]
  [9.5367431640625e-07 function { Picture0RepeatRepeatBlue(U7(x, y, z), V7(x, y, z)) } texture_map { [0 Nothing] [1 Object7Blue] }] } }

plane { <0, 1, 0>, 0 matrix <2, 0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0> texture { Object0 } }
sphere { <-2.4, 0.81, -1>, 0.8 texture { Object1 } }
box { <-0.6, 0, -0.6>, <0.6, 1.2, 0.6> matrix <0.9063077870366499, 0, -0.42261826174069944, 0, 1, 0, 0.42261826174069944, 0, 0.9063077870366499, -0.35, 0.01, -1.3> texture { Object2 } }
torus { 0.75, 0.3 sturm translate <0, 0, 0> matrix <1, 0, 0, 0, 0.9396926207859084, 0.3420201433256687, 0, -0.3420201433256687, 0.9396926207859084, 1.9, 0.36, -1> texture { Object3 } }
cylinder { <-1.9, 0.01, 1.1>, <-1.9, 1.1, 1.1>, 0.55 texture { Object4 } }
cone { <-0.3, 0.01, 1.3>, 0.6, <-0.3, 1.3, 1.3>, 0.12 texture { Object5 } }
disc { <1.2, 0.7, 1.2>, <-0.2683281572999747, 0.35777087639996635, 0.8944271909999159>, 0.62 texture { Object6 } }
triangle { <-0.6, 0, 0>, <0.6, 0, 0>, <0.1, 1.1, -0.3> matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 2.6, 0.01, 1> texture { Object7 } }
