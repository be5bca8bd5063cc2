// uv.scene, written by `course export`.
// povray +Iuv.pov +Ouv.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.02, 0.02, 0.03> }

camera {
  perspective
  location <1.5, 2.2, 7>
  direction <-0.20028505270122426, -0.2937514106284623, -0.9346635792723799>
  right <1.0009151470269997, 0, -0.21448181722007137>
  up <-0.04725325227191397, 0.733857326950179, -0.22051517726893188>
}


#declare SphereUv = texture { pigment { average pigment_map { [function { atan2(z, x) / (2 * pi) + (z < 0) } color_map { [0 rgb 0] [1 rgb <1, 0, 0>] }] [function { 0.5 + asin(min(max(y, -1), 1)) / pi } color_map { [0 rgb 0] [1 rgb <0, 1, 0>] }] } } finish { ambient 0 diffuse 0 emission 2 } }

#declare MeshUv = texture { pigment { uv_mapping average pigment_map { [function { x } color_map { [0 rgb 0] [1 rgb <1, 0, 0>] }] [function { y } color_map { [0 rgb 0] [1 rgb <0, 1, 0>] }] } } finish { ambient 0 diffuse 0 emission 2 } }

#declare NoUv = texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } }

mesh { triangle { <0, 1, 1.61803>, <0, -1, 1.61803>, <1.61803, 0, 1> uv_vectors <0, 0>, <1, 0>, <0, 1> } texture { MeshUv } }
mesh { triangle { <0, 1, 1.61803>, <-1.61803, 0, 1>, <0, -1, 1.61803> uv_vectors <0, 0>, <1, 0>, <0, 1> } texture { MeshUv } }
mesh { triangle { <0, 1, 1.61803>, <1, 1.61803, 0>, <-1, 1.61803, 0> uv_vectors <0, 0>, <1, 0>, <0, 1> } texture { MeshUv } }
mesh { triangle { <0, 1, 1.61803>, <1.61803, 0, 1>, <1, 1.61803, 0> uv_vectors <0, 0>, <1, 0>, <0, 1> } texture { MeshUv } }
mesh { triangle { <0, 1, 1.61803>, <-1, 1.61803, 0>, <-1.61803, 0, 1> uv_vectors <0, 0>, <1, 0>, <0, 1> } texture { MeshUv } }
mesh { triangle { <0, 1, -1.61803>, <1.61803, 0, -1>, <0, -1, -1.61803> uv_vectors <0, 0>, <1, 0>, <0, 1> } texture { MeshUv } }
mesh { triangle { <0, 1, -1.61803>, <0, -1, -1.61803>, <-1.61803, 0, -1> uv_vectors <0, 0>, <1, 0>, <0, 1> } texture { MeshUv } }
mesh { triangle { <0, 1, -1.61803>, <-1, 1.61803, 0>, <1, 1.61803, 0> uv_vectors <0, 0>, <1, 0>, <0, 1> } texture { MeshUv } }
mesh { triangle { <0, 1, -1.61803>, <1, 1.61803, 0>, <1.61803, 0, -1> uv_vectors <0, 0>, <1, 0>, <0, 1> } texture { MeshUv } }
mesh { triangle { <0, 1, -1.61803>, <-1.61803, 0, -1>, <-1, 1.61803, 0> uv_vectors <0, 0>, <1, 0>, <0, 1> } texture { MeshUv } }
mesh { triangle { <0, -1, 1.61803>, <-1, -1.61803, 0>, <1, -1.61803, 0> uv_vectors <0, 0>, <1, 0>, <0, 1> } texture { MeshUv } }
mesh { triangle { <0, -1, 1.61803>, <1, -1.61803, 0>, <1.61803, 0, 1> uv_vectors <0, 0>, <1, 0>, <0, 1> } texture { MeshUv } }
mesh { triangle { <0, -1, 1.61803>, <-1.61803, 0, 1>, <-1, -1.61803, 0> uv_vectors <0, 0>, <1, 0>, <0, 1> } texture { MeshUv } }
mesh { triangle { <0, -1, -1.61803>, <1, -1.61803, 0>, <-1, -1.61803, 0> uv_vectors <0, 0>, <1, 0>, <0, 1> } texture { MeshUv } }
mesh { triangle { <0, -1, -1.61803>, <1.61803, 0, -1>, <1, -1.61803, 0> uv_vectors <0, 0>, <1, 0>, <0, 1> } texture { MeshUv } }
mesh { triangle { <0, -1, -1.61803>, <-1, -1.61803, 0>, <-1.61803, 0, -1> uv_vectors <0, 0>, <1, 0>, <0, 1> } texture { MeshUv } }
mesh { triangle { <1, 1.61803, 0>, <1.61803, 0, 1>, <1.61803, 0, -1> uv_vectors <0, 0>, <1, 0>, <0, 1> } texture { MeshUv } }
mesh { triangle { <1, -1.61803, 0>, <1.61803, 0, -1>, <1.61803, 0, 1> uv_vectors <0, 0>, <1, 0>, <0, 1> } texture { MeshUv } }
mesh { triangle { <-1, 1.61803, 0>, <-1.61803, 0, -1>, <-1.61803, 0, 1> uv_vectors <0, 0>, <1, 0>, <0, 1> } texture { MeshUv } }
mesh { triangle { <-1, -1.61803, 0>, <-1.61803, 0, 1>, <-1.61803, 0, -1> uv_vectors <0, 0>, <1, 0>, <0, 1> } texture { MeshUv } }
sphere { <2.4, -1.2, 0.8>, 0.6 texture { SphereUv scale 0.6 translate <2.4, -1.2, 0.8> } }
sphere { <-2.4, 1.2, 0.3>, 0.6 texture { SphereUv scale 0.6 translate <-2.4, 1.2, 0.3> } }
