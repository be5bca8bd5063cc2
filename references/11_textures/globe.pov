// globe.scene, written by `course export`.
// povray +Iglobe.pov +Oglobe.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout 0 }
background { rgb <0.42, 0.5, 0.62> }

camera {
  perspective
  location <0.4, 2.2, 6.4>
  direction <-0.06131393394849658, -0.18394180184548978, -0.9810229431759453>
  right <0.7883643798088862, 0, -0.049272773738055387>
  up <-0.006797492087477278, 0.58231848882722, -0.10875987339963644>
}

light_source { <-4, 6, 5> rgb <0.9, 0.86, 0.8> }
light_source { <81110.71056538128, 48666.42633922876, 32444.284226152507> rgb <0.14, 0.16, 0.2> parallel point_at 0 }

#declare Picture0RepeatRepeat = function { pigment { image_map { png "figures/bricks.png" gamma srgb interpolate 2 } } }
#declare Picture0RepeatRepeatRed = function(x, y) { Picture0RepeatRepeat(x, y, 0).red }
#declare Picture0RepeatRepeatGreen = function(x, y) { Picture0RepeatRepeat(x, y, 0).green }
#declare Picture0RepeatRepeatBlue = function(x, y) { Picture0RepeatRepeat(x, y, 0).blue }
#declare Picture1RepeatRepeat = function { pigment { image_map { png "figures/earth.png" gamma srgb interpolate 2 } } }
#declare Picture1RepeatRepeatRed = function(x, y) { Picture1RepeatRepeat(x, y, 0).red }
#declare Picture1RepeatRepeatGreen = function(x, y) { Picture1RepeatRepeat(x, y, 0).green }
#declare Picture1RepeatRepeatBlue = function(x, y) { Picture1RepeatRepeat(x, y, 0).blue }
#declare Nothing = texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } }

#declare OwnX0 = function { 1 * x + 0 * y + 0 * z + 0 }
#declare OwnY0 = function { 0 * x + 1 * y + 0 * z + 0 }
#declare OwnZ0 = function { 0 * x + 0 * y + -1 * z + 0 }
#declare UOwn0 = function(x, y, z) { x }
#declare U0 = function(x, y, z) { UOwn0(OwnX0(x, y, z), OwnY0(x, y, z), OwnZ0(x, y, z)) }
#declare VOwn0 = function(x, y, z) { z }
#declare V0 = function(x, y, z) { VOwn0(OwnX0(x, y, z), OwnY0(x, y, z), OwnZ0(x, y, z)) }
#declare Object0Rest =
  texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } }

#declare Object0Red =
  texture { pigment { rgb <104857.90000000001, 0, 0> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <943721.1, 0, 0> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Object0Green =
  texture { pigment { rgb <0, 104857.90000000001, 0> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0, 943721.1, 0> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Object0Blue =
  texture { pigment { rgb <0, 0, 104857.90000000001> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0, 0, 943721.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Object0 = texture { average texture_map { [1 Object0Rest]
  [9.5367431640625e-07 function { Picture0RepeatRepeatRed(U0(x, y, z), V0(x, y, z)) } texture_map { [0 Nothing] [1 Object0Red] }]
  [9.5367431640625e-07 function { Picture0RepeatRepeatGreen(U0(x, y, z), V0(x, y, z)) } texture_map { [0 Nothing] [1 Object0Green] }]
  [9.5367431640625e-07 function { Picture0RepeatRepeatBlue(U0(x, y, z), V0(x, y, z)) } texture_map { [0 Nothing] [1 Object0Blue] }] } }

#declare OwnX1 = function { 1 * x + 0 * y + 0 * z + 0 }
#declare OwnY1 = function { 0 * x + 0 * y + 1 * z + 2.4 }
#declare OwnZ1 = function { 0 * x + 1 * y + 0 * z + 0 }
#declare UOwn1 = function(x, y, z) { x }
#declare U1 = function(x, y, z) { UOwn1(OwnX1(x, y, z), OwnY1(x, y, z), OwnZ1(x, y, z)) }
#declare VOwn1 = function(x, y, z) { z }
#declare V1 = function(x, y, z) { VOwn1(OwnX1(x, y, z), OwnY1(x, y, z), OwnZ1(x, y, z)) }
#declare Object1Rest =
  texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } }

#declare Object1Red =
  texture { pigment { rgb <104857.90000000001, 0, 0> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <943721.1, 0, 0> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Object1Green =
  texture { pigment { rgb <0, 104857.90000000001, 0> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0, 943721.1, 0> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Object1Blue =
  texture { pigment { rgb <0, 0, 104857.90000000001> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0, 0, 943721.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Object1 = texture { average texture_map { [1 Object1Rest]
  [9.5367431640625e-07 function { Picture0RepeatRepeatRed(U1(x, y, z), V1(x, y, z)) } texture_map { [0 Nothing] [1 Object1Red] }]
  [9.5367431640625e-07 function { Picture0RepeatRepeatGreen(U1(x, y, z), V1(x, y, z)) } texture_map { [0 Nothing] [1 Object1Green] }]
  [9.5367431640625e-07 function { Picture0RepeatRepeatBlue(U1(x, y, z), V1(x, y, z)) } texture_map { [0 Nothing] [1 Object1Blue] }] } }

#declare OwnX2 = function { -0.8292377398532409 * x + 0.3588432136444157 * y + 0.3288655224285275 * z + -0.5203226597844027 }
#declare OwnY2 = function { 0.3818729717642121 * x + 0.8824563708499819 * y + 0 * z + -1.2795617377324737 }
#declare OwnZ2 = function { -0.30181785443676024 * x + 0.13060824853499484 * y + -0.9035505969095272 * z + -0.1893819603757425 }
#declare UOwn2 = function(x, y, z) { atan2(z, x) / (2 * pi) + (z < 0) }
#declare U2 = function(x, y, z) { UOwn2(OwnX2(x, y, z), OwnY2(x, y, z), OwnZ2(x, y, z)) }
#declare VOwn2 = function(x, y, z) { 0.5 + asin(min(max(y, -1), 1)) / pi }
#declare V2 = function(x, y, z) { VOwn2(OwnX2(x, y, z), OwnY2(x, y, z), OwnZ2(x, y, z)) }
#declare Object2Rest =
  texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } }

#declare Object2Red =
  texture { pigment { rgb <104857.90000000001, 0, 0> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <943721.1, 0, 0> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Object2Green =
  texture { pigment { rgb <0, 104857.90000000001, 0> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0, 943721.1, 0> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Object2Blue =
  texture { pigment { rgb <0, 0, 104857.90000000001> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0, 0, 943721.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Object2 = texture { average texture_map { [1 Object2Rest]
  [9.5367431640625e-07 function { Picture1RepeatRepeatRed(U2(x, y, z), V2(x, y, z)) } texture_map { [0 Nothing] [1 Object2Red] }]
  [9.5367431640625e-07 function { Picture1RepeatRepeatGreen(U2(x, y, z), V2(x, y, z)) } texture_map { [0 Nothing] [1 Object2Green] }]
  [9.5367431640625e-07 function { Picture1RepeatRepeatBlue(U2(x, y, z), V2(x, y, z)) } texture_map { [0 Nothing] [1 Object2Blue] }] } }

#declare Material2 =
  texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 specular 0.8 roughness 0.0125 } }
  texture { pigment { rgb <1, 0.8999999999999999, 0.6> filter 1 } finish { ambient 0 diffuse 0 } }
  texture { pigment { rgb 0.1 transmit 0.5 } finish { ambient 0 diffuse 0 emission 4 } }
  texture { pigment { rgb <0.45, 0.33, 0.16> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb <0.2, 0.18, 0.12> } } }

plane { <0, 1, 0>, 0 texture { Object0 } }
plane { <0, 0, 1>, 0 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -2.4> texture { Object1 } }
sphere { <0, 0, 0>, 1.04 matrix <-0.8624072494473706, 0.3731969421901923, 0.34202014332566866, 0.39714789063478056, 0.9177546256839811, 0, -0.3138905686142306, 0.13583257847639463, -0.9396926207859084, 0, 1.45, 0> texture { Object2 } }
cylinder { <0, 0.01, 0>, <0, 0.12, 0>, 0.6 texture { Material2 } }
cone { <0, 0.12, 0>, 0.3, <0, 0.42, 0>, 0.09 texture { Material2 } }
