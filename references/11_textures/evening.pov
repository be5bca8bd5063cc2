// evening.scene, written by `course export`.
// povray +Ievening.pov +Oevening.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 7 adc_bailout 0 }
background { rgb 0 }

camera {
  perspective
  location <0, 1.2, 6>
  direction <0, -0.07478994824163422, -0.9971993098884564>
  right <0.8664525232877501, 0, 0>
  up <0, 0.6480193937052421, -0.04860145452789315>
}

light_source { <-4, 6, 5> rgb <0.5, 0.48, 0.45> }

#declare Picture0RepeatClamp = function { pigment { image_map { png "figures/sunset.png" gamma 1.0 interpolate 2 } } }
#declare Picture0RepeatClampRed = function(x, y) { Picture0RepeatClamp(x, min(max(y, 0.00390625), 0.99609375), 0).red }
#declare Picture0RepeatClampGreen = function(x, y) { Picture0RepeatClamp(x, min(max(y, 0.00390625), 0.99609375), 0).green }
#declare Picture0RepeatClampBlue = function(x, y) { Picture0RepeatClamp(x, min(max(y, 0.00390625), 0.99609375), 0).blue }
#declare SkyX = function { 0.9396926207859084 * x - 0.3420201433256687 * z }
#declare SkyZ = function { 0.3420201433256687 * x + 0.9396926207859084 * z }
#declare SkyU = function { atan2(SkyZ(x, y, z), SkyX(x, y, z)) / (2 * pi) }
#declare SkyV = function { 0.5 + atan2(y, sqrt(x * x + z * z)) / pi }
sky_sphere { pigment { average pigment_map {
  [function { Picture0RepeatClampRed(SkyU(x, y, z), SkyV(x, y, z)) } color_map { [0 rgb 0] [1 rgb <3, 0, 0>] }]
  [function { Picture0RepeatClampGreen(SkyU(x, y, z), SkyV(x, y, z)) } color_map { [0 rgb 0] [1 rgb <0, 3, 0>] }]
  [function { Picture0RepeatClampBlue(SkyU(x, y, z), SkyV(x, y, z)) } color_map { [0 rgb 0] [1 rgb <0, 0, 3>] }]
} } }

#declare Material0 =
  texture { pigment { rgb <0.06, 0.06, 0.07> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.32, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection { rgb 0.9 } specular 0.9 roughness 1e+30 } }

#declare Material2 =
  texture { pigment { rgb <0.95, 0.97, 0.96> filter 1 } finish { ambient 0 diffuse 0 reflection { rgb 0, rgb 1 fresnel } conserve_energy } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1.1, 0.9, -0.6>, 0.89 texture { Material1 } }
sphere { <1, 0.8, 0.5>, 0.79 texture { Material2 } interior { ior 1.5 } }
