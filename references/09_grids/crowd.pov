// crowd.scene, written by `course export`.
// povray +Icrowd.pov +Ocrowd.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 2 adc_bailout 0 }
background { rgb <0.3, 0.42, 0.6> }

camera {
  perspective
  location <0, 17, 31>
  direction <0, -0.5172096108466178, -0.8558587608057128>
  right <0.8664525232877501, 0, 0>
  up <0, 0.5561707371585276, -0.3361031792900454>
}

light_source { <-73179.17228850434, 57497.92108382484, 36589.58614425217> rgb <0.8, 0.7, 0.55> parallel point_at 0 }
light_source { <53916.38660171921, 64699.66392206305, 53916.38660171921> rgb <0.09, 0.1, 0.14> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.52, 0.46, 0.38> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb 0.02 transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.8 } specular 0.8 roughness 0.0033333333333333335 } }

#declare Material2 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material3 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material4 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material5 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material6 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material7 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material8 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material9 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material10 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material11 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material12 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material13 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material14 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material15 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material16 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material17 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material18 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material19 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material20 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material21 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material22 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material23 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material24 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material25 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material26 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material27 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material28 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material29 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material30 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material31 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material32 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material33 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material34 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material35 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material36 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material37 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material38 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material39 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material40 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material41 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material42 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material43 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material44 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material45 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material46 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material47 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material48 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material49 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material50 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material51 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material52 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material53 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material54 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material55 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material56 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material57 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material58 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material59 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material60 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material61 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material62 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material63 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material64 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material65 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material66 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material67 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material68 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material69 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material70 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material71 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material72 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material73 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material74 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material75 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material76 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material77 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material78 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material79 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material80 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material81 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material82 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material83 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material84 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material85 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material86 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material87 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material88 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material89 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material90 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material91 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material92 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material93 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material94 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material95 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material96 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material97 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material98 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material99 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material100 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material101 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material102 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material103 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material104 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material105 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material106 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material107 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material108 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material109 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material110 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material111 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material112 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material113 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material114 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material115 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material116 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material117 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material118 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material119 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material120 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material121 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material122 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material123 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material124 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material125 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material126 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material127 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material128 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material129 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material130 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material131 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material132 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material133 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material134 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material135 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material136 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material137 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material138 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material139 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material140 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material141 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material142 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material143 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material144 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material145 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material146 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material147 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material148 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material149 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material150 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material151 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material152 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material153 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material154 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material155 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material156 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material157 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material158 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material159 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material160 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material161 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material162 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material163 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material164 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material165 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material166 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material167 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material168 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material169 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material170 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material171 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material172 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material173 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material174 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material175 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material176 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material177 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material178 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material179 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material180 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material181 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material182 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material183 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material184 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material185 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material186 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material187 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material188 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material189 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material190 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material191 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material192 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material193 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material194 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material195 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material196 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material197 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material198 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material199 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material200 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material201 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material202 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material203 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material204 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material205 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material206 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material207 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material208 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material209 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material210 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material211 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material212 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material213 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material214 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material215 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material216 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material217 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material218 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material219 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material220 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material221 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material222 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material223 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material224 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material225 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material226 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material227 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material228 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material229 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material230 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material231 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material232 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material233 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material234 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material235 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material236 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material237 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material238 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material239 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material240 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material241 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material242 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material243 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material244 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material245 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material246 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material247 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material248 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material249 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material250 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material251 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material252 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material253 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material254 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material255 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material256 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material257 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material258 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material259 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material260 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material261 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material262 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material263 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material264 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material265 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material266 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material267 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material268 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material269 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material270 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material271 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material272 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material273 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material274 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material275 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material276 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material277 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material278 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material279 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material280 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material281 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material282 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material283 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material284 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material285 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material286 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material287 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material288 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material289 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material290 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material291 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material292 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material293 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material294 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material295 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material296 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material297 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material298 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material299 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material300 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material301 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material302 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material303 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material304 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material305 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material306 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material307 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material308 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material309 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material310 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material311 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material312 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material313 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material314 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material315 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material316 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material317 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material318 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material319 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material320 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material321 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material322 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material323 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material324 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material325 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material326 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material327 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material328 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material329 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material330 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material331 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material332 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material333 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material334 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material335 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material336 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material337 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material338 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material339 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material340 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material341 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material342 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material343 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material344 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material345 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material346 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material347 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material348 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material349 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material350 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material351 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material352 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material353 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material354 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material355 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material356 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material357 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material358 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material359 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material360 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material361 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material362 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material363 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material364 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material365 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material366 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material367 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material368 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material369 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material370 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material371 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material372 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material373 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material374 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material375 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material376 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material377 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material378 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material379 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material380 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material381 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material382 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material383 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material384 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material385 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material386 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material387 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material388 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material389 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material390 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material391 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material392 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material393 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material394 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material395 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material396 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material397 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material398 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material399 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material400 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material401 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material402 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material403 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material404 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material405 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material406 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material407 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material408 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material409 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material410 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material411 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material412 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material413 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material414 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material415 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material416 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material417 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material418 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material419 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material420 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material421 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material422 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material423 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material424 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material425 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material426 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material427 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material428 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material429 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material430 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material431 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material432 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material433 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material434 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material435 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material436 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material437 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material438 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material439 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material440 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material441 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material442 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material443 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material444 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material445 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material446 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material447 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material448 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material449 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material450 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material451 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material452 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material453 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material454 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material455 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material456 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material457 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material458 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material459 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material460 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material461 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material462 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material463 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material464 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material465 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material466 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material467 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material468 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material469 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material470 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material471 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material472 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material473 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material474 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material475 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material476 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material477 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material478 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material479 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material480 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material481 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material482 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material483 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material484 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material485 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material486 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material487 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material488 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material489 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material490 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material491 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material492 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material493 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material494 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material495 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material496 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material497 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material498 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material499 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material500 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material501 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material502 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material503 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material504 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material505 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material506 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material507 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material508 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material509 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material510 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material511 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material512 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material513 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material514 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material515 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material516 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material517 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material518 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material519 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material520 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material521 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material522 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material523 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material524 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material525 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material526 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material527 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material528 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material529 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material530 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material531 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material532 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material533 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material534 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material535 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material536 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material537 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material538 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material539 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material540 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material541 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material542 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material543 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material544 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material545 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material546 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material547 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material548 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material549 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material550 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material551 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material552 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material553 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material554 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material555 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material556 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material557 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material558 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material559 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material560 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material561 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material562 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material563 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material564 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material565 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material566 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material567 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material568 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material569 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material570 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material571 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material572 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material573 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material574 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material575 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material576 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material577 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material578 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material579 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material580 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material581 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material582 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material583 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material584 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material585 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material586 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material587 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material588 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material589 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material590 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material591 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material592 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material593 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material594 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material595 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material596 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material597 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material598 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material599 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material600 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material601 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material602 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material603 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material604 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material605 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material606 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material607 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material608 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material609 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material610 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material611 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material612 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material613 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material614 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material615 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material616 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material617 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material618 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material619 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material620 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material621 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material622 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material623 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material624 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material625 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material626 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material627 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material628 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material629 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material630 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material631 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material632 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material633 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material634 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material635 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material636 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material637 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material638 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material639 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material640 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material641 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material642 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material643 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material644 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material645 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material646 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material647 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material648 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material649 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material650 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material651 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material652 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material653 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material654 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material655 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material656 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material657 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material658 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material659 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material660 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material661 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material662 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material663 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material664 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material665 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material666 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material667 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material668 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material669 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material670 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material671 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material672 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material673 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material674 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material675 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material676 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material677 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material678 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material679 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material680 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material681 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material682 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material683 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material684 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material685 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material686 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material687 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material688 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material689 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material690 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material691 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material692 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material693 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material694 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material695 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material696 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material697 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material698 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material699 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material700 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material701 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material702 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material703 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material704 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material705 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material706 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material707 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material708 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material709 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material710 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material711 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material712 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material713 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material714 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material715 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material716 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material717 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material718 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material719 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material720 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material721 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material722 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material723 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material724 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material725 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material726 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material727 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material728 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material729 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material730 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material731 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material732 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material733 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material734 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material735 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material736 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material737 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material738 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material739 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material740 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material741 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material742 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material743 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material744 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material745 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material746 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material747 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material748 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material749 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material750 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material751 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material752 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material753 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material754 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material755 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material756 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material757 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material758 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material759 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material760 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material761 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material762 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material763 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material764 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material765 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material766 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material767 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material768 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material769 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material770 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material771 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material772 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material773 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material774 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material775 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material776 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material777 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material778 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material779 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material780 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material781 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material782 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material783 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material784 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material785 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material786 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material787 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material788 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material789 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material790 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material791 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material792 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material793 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material794 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material795 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material796 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material797 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material798 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material799 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material800 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material801 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material802 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material803 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material804 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material805 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material806 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material807 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material808 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material809 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material810 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material811 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material812 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material813 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material814 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material815 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material816 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material817 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material818 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material819 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material820 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material821 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material822 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material823 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material824 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material825 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material826 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material827 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material828 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material829 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material830 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material831 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material832 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material833 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material834 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material835 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material836 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material837 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material838 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material839 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material840 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material841 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material842 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material843 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material844 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material845 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material846 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material847 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material848 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material849 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material850 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material851 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material852 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material853 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material854 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material855 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material856 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material857 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material858 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material859 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material860 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material861 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material862 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material863 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material864 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material865 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material866 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material867 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material868 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material869 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material870 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material871 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material872 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material873 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material874 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material875 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material876 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material877 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material878 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material879 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material880 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material881 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material882 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material883 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material884 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material885 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material886 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material887 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material888 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material889 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material890 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material891 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material892 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material893 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material894 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material895 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material896 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material897 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material898 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material899 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material900 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material901 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material902 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material903 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material904 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material905 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material906 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material907 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material908 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material909 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material910 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material911 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material912 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material913 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material914 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material915 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material916 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material917 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material918 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material919 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material920 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material921 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material922 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material923 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material924 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material925 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material926 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material927 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material928 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material929 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material930 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material931 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material932 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material933 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material934 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material935 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material936 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material937 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material938 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material939 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material940 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material941 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material942 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material943 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material944 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material945 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material946 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material947 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material948 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material949 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material950 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material951 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material952 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material953 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material954 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material955 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material956 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material957 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material958 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material959 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material960 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material961 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material962 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material963 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material964 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material965 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material966 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material967 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material968 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material969 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material970 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material971 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material972 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material973 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material974 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material975 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material976 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material977 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material978 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material979 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material980 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material981 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material982 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material983 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material984 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material985 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material986 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material987 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material988 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material989 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material990 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material991 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material992 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material993 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material994 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material995 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material996 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material997 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material998 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material999 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1000 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1001 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1002 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1003 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1004 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1005 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1006 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1007 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1008 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1009 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1010 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1011 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1012 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1013 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1014 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1015 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1016 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1017 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1018 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1019 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1020 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1021 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1022 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1023 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1024 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1025 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1026 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1027 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1028 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1029 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1030 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1031 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1032 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1033 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1034 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1035 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1036 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1037 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1038 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1039 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1040 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1041 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1042 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1043 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1044 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1045 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1046 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1047 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1048 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1049 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1050 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1051 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1052 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1053 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1054 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1055 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1056 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1057 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1058 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1059 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1060 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1061 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1062 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1063 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1064 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1065 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1066 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1067 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1068 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1069 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1070 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1071 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1072 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1073 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1074 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1075 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1076 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1077 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1078 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1079 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1080 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1081 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1082 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1083 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1084 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1085 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1086 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1087 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1088 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1089 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1090 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1091 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1092 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1093 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1094 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1095 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1096 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1097 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1098 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1099 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1100 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1101 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1102 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1103 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1104 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1105 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1106 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1107 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1108 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1109 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1110 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1111 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1112 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1113 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1114 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1115 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1116 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1117 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1118 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1119 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1120 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1121 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1122 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1123 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1124 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1125 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1126 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1127 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1128 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1129 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1130 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1131 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1132 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1133 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1134 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1135 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1136 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1137 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1138 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1139 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1140 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1141 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1142 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1143 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1144 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1145 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1146 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1147 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1148 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1149 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1150 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1151 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1152 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1153 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1154 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1155 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1156 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1157 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1158 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1159 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1160 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1161 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1162 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1163 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1164 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1165 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1166 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1167 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1168 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1169 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1170 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1171 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1172 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1173 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1174 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1175 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1176 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1177 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1178 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1179 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1180 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1181 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1182 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1183 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1184 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1185 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1186 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1187 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1188 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1189 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1190 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1191 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1192 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1193 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1194 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1195 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1196 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1197 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1198 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1199 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1200 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1201 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1202 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1203 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1204 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1205 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1206 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1207 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1208 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1209 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1210 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1211 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1212 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1213 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1214 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1215 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1216 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1217 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1218 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1219 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1220 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1221 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1222 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1223 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1224 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1225 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1226 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1227 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1228 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1229 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1230 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1231 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1232 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1233 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1234 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1235 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1236 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1237 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1238 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1239 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1240 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1241 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1242 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1243 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1244 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1245 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1246 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1247 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1248 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1249 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1250 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1251 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1252 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1253 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1254 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1255 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1256 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1257 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1258 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1259 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1260 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1261 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1262 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1263 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1264 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1265 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1266 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1267 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1268 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1269 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1270 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1271 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1272 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1273 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1274 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1275 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1276 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1277 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1278 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1279 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1280 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1281 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1282 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1283 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1284 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1285 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1286 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1287 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1288 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1289 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1290 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1291 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1292 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1293 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1294 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1295 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1296 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1297 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1298 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1299 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1300 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1301 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1302 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1303 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1304 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1305 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1306 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1307 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1308 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1309 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1310 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1311 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1312 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1313 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1314 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1315 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1316 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1317 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1318 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1319 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1320 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1321 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1322 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1323 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1324 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1325 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1326 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1327 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1328 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1329 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1330 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1331 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1332 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1333 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1334 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1335 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1336 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1337 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1338 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1339 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1340 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1341 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1342 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1343 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1344 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1345 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1346 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1347 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1348 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1349 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1350 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1351 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1352 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1353 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1354 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1355 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1356 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1357 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1358 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1359 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1360 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1361 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1362 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1363 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1364 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1365 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1366 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1367 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1368 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1369 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1370 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1371 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1372 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1373 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1374 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1375 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1376 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1377 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1378 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1379 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1380 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1381 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1382 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1383 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1384 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1385 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1386 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1387 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1388 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1389 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1390 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1391 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1392 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1393 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1394 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1395 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1396 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1397 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1398 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1399 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1400 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1401 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1402 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1403 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1404 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1405 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1406 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1407 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1408 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1409 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1410 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1411 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1412 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1413 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1414 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1415 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1416 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1417 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1418 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1419 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1420 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1421 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1422 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1423 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1424 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1425 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1426 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1427 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1428 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1429 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1430 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1431 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1432 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1433 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1434 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1435 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1436 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1437 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1438 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1439 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1440 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1441 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1442 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1443 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1444 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1445 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1446 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1447 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1448 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1449 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1450 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1451 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1452 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1453 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1454 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1455 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1456 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1457 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1458 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1459 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1460 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1461 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1462 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1463 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1464 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1465 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1466 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1467 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1468 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.52, 0.62> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1469 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.15, 0.43> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1470 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.71, 0.21> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1471 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.26, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1472 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.37, 0.19> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1473 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.65, 0.47> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1474 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.58> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1475 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.63, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1476 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.41, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1477 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.22, 0.32> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1478 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.72, 0.3> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1479 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.18, 0.69> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1480 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.48, 0.13> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1481 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.57, 0.57> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1482 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.64, 0.13, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1483 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.39, 0.69, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1484 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.24, 0.3, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1485 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.71, 0.32, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1486 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.69, 0.41> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1487 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.13, 0.63> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1488 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.58, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1489 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.14, 0.47, 0.65> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1490 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.19, 0.37> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1491 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.29, 0.72, 0.26> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1492 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.34, 0.21, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1493 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.68, 0.43, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1494 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.13, 0.62, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1495 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.12, 0.54> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1496 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.66, 0.15> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1497 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.36, 0.71> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1498 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.27, 0.27> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1499 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.71, 0.36> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1500 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.45, 0.15, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

#declare Material1501 =
  texture { pigment { rgb <0.02, 0.02, 0.03> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.54, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.1 } specular 0.1 roughness 0.05 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 4.1, 0>, 4 texture { Material1 } }
sphere { <4.82, 0.82, 0>, 0.136 texture { Material2 } }
sphere { <0, 0, 0>, 1 matrix <0.199, 0, 0, 0, 0.35994517025630085, -0.006282866317422064, 0, 0.002652765778467094, 0.15197684966377148, 4.82, 0.35, 0> texture { Material2 } }
sphere { <-3.57, 0.95, 3.27>, 0.158 texture { Material3 } }
sphere { <0, 0, 0>, 1 matrix <0.20577026244462315, -0.009722992811514251, 0.00025000851614537787, 0.019776378582643063, 0.4179793370588663, -0.02152135316346451, 0.00021481314251326156, 0.009091359212251118, 0.17676623275667674, -3.57, 0.41, 3.27> texture { Material3 } }
sphere { <0.43, 1.08, -4.85>, 0.181 texture { Material4 } }
sphere { <0, 0, 0>, 1 matrix <0.2709590570254757, 0.004710562841823936, 3.684867707188706e-06, -0.008308668038346276, 0.477927198284755, 0.0007477801234511647, 2.746654158125899e-06, -0.0003160074998684839, 0.20199975280112578, 0.43, 0.47, -4.85> texture { Material4 } }
sphere { <2.98, 0.92, 3.88>, 0.154 texture { Material5 } }
sphere { <0, 0, 0>, 1 matrix <0.18184374027357958, -0.007539201906409347, -0.00012065624445121287, 0.016859643823673647, 0.40644222064511154, 0.01301820599043155, -0.00011402678047037699, -0.005501551425931761, 0.17191195400495324, 2.98, 0.4, 3.88> texture { Material5 } }
sphere { <-4.84, 1.07, -0.86>, 0.178 texture { Material6 } }
sphere { <0, 0, 0>, 1 matrix <0.251989911225827, -0.002254164579614942, -5.81588158210612e-05, 0.004204195842932629, 0.46935588133464967, 0.024235952506317507, -4.5927001382504675e-05, -0.010261605422887626, 0.19873524434497145, -4.84, 0.46, -0.86> texture { Material6 } }
sphere { <4.16, 1.21, -2.65>, 0.202 texture { Material7 } }
sphere { <0, 0, 0>, 1 matrix <0.2598147974674076, -0.009807549107303096, 0.00028809282847710934, 0.020218639698132534, 0.5346943309392658, -0.03145121730820616, 0.0002504191509070258, 0.013261147596370508, 0.22561045909858907, 4.16, 0.52, -2.65> texture { Material7 } }
sphere { <-1.29, 0.83, 4.78>, 0.139 texture { Material8 } }
sphere { <0, 0, 0>, 1 matrix <0.1693964606285265, 0.014311287708737288, 0.00016177343977640213, -0.030895544641803437, 0.3656034541996706, 0.008281280007081334, 0.00014749931273730778, -0.0034975433272414354, 0.15496046410174052, -1.29, 0.36, 4.78> texture { Material8 } }
sphere { <-2.29, 0.93, -4.42>, 0.155 texture { Material9 } }
sphere { <0, 0, 0>, 1 matrix <0.19197692237920544, 0.00297676528082093, -1.1927759062364784e-05, -0.006387642165094912, 0.4119372504044332, -0.003301477972970404, -1.0809531650268083e-05, 0.0013943135128564328, 0.17399441305105715, -2.29, 0.4, -4.42> texture { Material9 } }
sphere { <4.69, 1, 1.71>, 0.166 texture { Material10 } }
sphere { <0, 0, 0>, 1 matrix <0.22385803419478004, 0.007964074029457171, -0.00039249369678459546, -0.015608162941659367, 0.43659511206667195, -0.04315197989752883, -0.00032590994465149444, 0.01828307120943135, 0.18509895485890468, 4.69, 0.43, 1.71> texture { Material10 } }
sphere { <-4.64, 0.9, 1.91>, 0.151 texture { Material11 } }
sphere { <0, 0, 0>, 1 matrix <0.20499544960841692, -0.00136583984218134, 1.1016737516906027e-05, 0.0026583907172212425, 0.39893923036740014, -0.006436103841693535, 9.082090928571312e-06, 0.002726069045729843, 0.16897801177985713, -4.64, 0.39, 1.91> texture { Material11 } }
sphere { <2.14, 1.2, -4.56>, 0.201 texture { Material12 } }
sphere { <0, 0, 0>, 1 matrix <0.2417265888409393, -0.011499579273455778, 0.00012618976572031378, 0.02528006683255568, 0.5312709124894333, -0.011667723153487236, 0.00011680375008822435, 0.004912725538310415, 0.22394609057688236, 2.14, 0.52, -4.56> texture { Material12 } }
sphere { <1.51, 0.84, 4.83>, 0.139 texture { Material13 } }
sphere { <0, 0, 0>, 1 matrix <0.18897382466706655, -0.0031453970140156522, -8.265894610563492e-06, 0.0061410132178400835, 0.3689437995127084, 0.0019392673319495002, -6.822643170623834e-06, -0.0008198528557835285, 0.155997845481104, 1.51, 0.36, 4.83> texture { Material13 } }
sphere { <-4.4, 0.97, -2.55>, 0.162 texture { Material14 } }
sphere { <0, 0, 0>, 1 matrix <0.23192105771751445, -0.006050133844589605, -0.00013735957152488705, 0.011161453816742892, 0.4274134408749576, 0.01942092964113263, -0.00010716414847415755, -0.008213056694030389, 0.18081353438165496, -4.4, 0.42, -2.55> texture { Material14 } }
sphere { <4.98, 0.99, -1.1>, 0.165 texture { Material15 } }
sphere { <0, 0, 0>, 1 matrix <0.2119490135432325, 0.004643171774840922, 0.0002379367982482665, -0.009527262839885855, 0.4326170244851989, 0.04446055991946733, 0.00020651118338528793, -0.018806305805016067, 0.18303628114420198, 4.98, 0.43, -1.1> texture { Material15 } }
sphere { <-2.95, 0.85, 4.19>, 0.142 texture { Material16 } }
sphere { <0, 0, 0>, 1 matrix <0.20697898609852655, 0.0029494224354227098, 1.4863491286087056e-05, -0.005357405003473135, 0.37594273337880313, 0.003789384026846851, 1.1416884611052379e-05, -0.0016024256922038546, 0.15899192464259218, -2.95, 0.37, 4.19> texture { Material16 } }
sphere { <-0.66, 1.03, -5.1>, 0.171 texture { Material17 } }
sphere { <0, 0, 0>, 1 matrix <0.2503989407628617, 0.01735984548808578, -7.892697053331704e-05, -0.031399879886816515, 0.4528940788179602, -0.004123216550794088, -6.037441570676044e-05, 0.001743739158045077, 0.19199207204642235, -0.66, 0.44, -5.1> texture { Material17 } }
sphere { <3.95, 0.86, 3.33>, 0.143 texture { Material18 } }
sphere { <0, 0, 0>, 1 matrix <0.16973159361580675, 0.00954382199018253, -0.0003187325812294817, -0.021220968895817625, 0.3765615958786798, -0.025199900563783427, -0.0002999836058630416, 0.010666624577262827, 0.15964376946803766, 3.95, 0.37, 3.33> texture { Material18 } }
sphere { <-5.18, 0.86, 0.21>, 0.143 texture { Material19 } }
sphere { <0, 0, 0>, 1 matrix <0.21799952274532985, -0.00045600488033914, 1.1931366753310874e-05, 0.0007927791268281379, 0.3784805936719835, -0.019819478170703442, 8.756966424448348e-06, 0.008367062024571374, 0.1597810758393888, -5.18, 0.37, 0.21> texture { Material19 } }
sphere { <3.69, 0.99, -3.67>, 0.166 texture { Material20 } }
sphere { <0, 0, 0>, 1 matrix <0.250828006611699, 0.009288784499376273, 0.00017199338830098396, -0.01620911398695939, 0.43739973622250333, 0.01620911398695939, 0.00012676803520192046, -0.006846315268464583, 0.1848732319647981, 3.69, 0.43, -3.67> texture { Material20 } }
sphere { <-0.24, 0.87, 5.22>, 0.144 texture { Material21 } }
sphere { <0, 0, 0>, 1 matrix <0.18728638727306549, 0.016364836360181555, 3.568063634672507e-05, -0.03325195473185827, 0.3805463746710468, 0.0016625977365929134, 3.055628963735497e-05, -0.0007007283654226677, 0.16099847218551813, -0.24, 0.37, 5.22> texture { Material21 } }
sphere { <-3.36, 1.06, -4.03>, 0.177 texture { Material22 } }
sphere { <0, 0, 0>, 1 matrix <0.20998108396631132, -0.0028185331536974677, -1.5722417611351915e-05, 0.006294724043257678, 0.46892856902834745, 0.005231978425564823, -1.4823993747846092e-05, -0.0022088096551425053, 0.19798767875844336, -3.36, 0.46, -4.03> texture { Material22 } }
sphere { <5.22, 1.15, 0.7>, 0.192 texture { Material23 } }
sphere { <0, 0, 0>, 1 matrix <0.23199042038942702, -0.002107018149304468, -7.29524189790022e-05, 0.004622725163775751, 0.5077601015822505, 0.03520383009336917, -6.760676758829944e-05, -0.014869987171069493, 0.21448514846221217, 5.22, 0.5, 0.7> texture { Material23 } }
sphere { <-4.34, 1.07, 3.02>, 0.178 texture { Material24 } }
sphere { <0, 0, 0>, 1 matrix <0.23998809172517274, -0.0023907188525598994, 1.713120238308728e-05, 0.004691785748148802, 0.47092826441866026, -0.006749586514880734, 1.4204621975976538e-05, 0.0028517361283678685, 0.19897956528066615, -4.34, 0.46, 3.02> texture { Material24 } }
sphere { <1.16, 1.16, -5.18>, 0.193 texture { Material25 } }
sphere { <0, 0, 0>, 1 matrix <0.2729604156571155, 0.004648806871526993, 8.886281055707319e-06, -0.008701612862088988, 0.510922172224916, 0.001953423295570997, 7.030903692427768e-06, -0.0008257131738617131, 0.21599842163386496, 1.16, 0.5, -5.18> texture { Material25 } }
sphere { <2.65, 1.05, 4.62>, 0.175 texture { Material26 } }
sphere { <0, 0, 0>, 1 matrix <0.23197343842250318, 0.0035105032990347357, -1.5265274423471127e-05, -0.007005875118332253, 0.4629294828574092, -0.004026365010535778, -1.283072634731409e-05, 0.001695769280895198, 0.19499262601934064, 2.65, 0.45, 4.62> texture { Material26 } }
sphere { <-5.09, 1.12, -1.62>, 0.186 texture { Material27 } }
sphere { <0, 0, 0>, 1 matrix <0.22097253546223525, -0.0034829595791571583, -8.697103625508024e-05, 0.007753919063101004, 0.4913257310992503, 0.024554077033153182, -8.185509294595785e-05, -0.010380585412389962, 0.20774079220567113, -5.09, 0.48, -1.62> texture { Material27 } }
sphere { <4.87, 1.16, -2.25>, 0.193 texture { Material28 } }
sphere { <0, 0, 0>, 1 matrix <0.23899360765427116, -0.0017479440985091956, 1.3850082412458308e-05, 0.003737236126938071, 0.510922172224916, -0.008097344941699156, 1.2517229293267757e-05, 0.003422752460679095, 0.21597287933653125, 4.87, 0.5, -2.25> texture { Material28 } }
sphere { <-2.08, 0.96, 4.97>, 0.16 texture { Material29 } }
sphere { <0, 0, 0>, 1 matrix <0.2068931096341665, -0.0066512504619392464, 4.531222029897566e-05, 0.013655949016058839, 0.42474110148311567, -0.005788934908981464, 3.9183031079790536e-05, 0.00243816317342984, 0.17898338980204226, -2.08, 0.42, 4.97> texture { Material29 } }
sphere { <-1.83, 1.17, -5.08>, 0.196 texture { Material30 } }
sphere { <0, 0, 0>, 1 matrix <0.25686155507585745, 0.008434394846350345, -5.007582362602838e-05, -0.017000064320659453, 0.5176844483958917, -0.006148959435132143, -4.267161624163508e-05, 0.002599656595162045, 0.21898456558561472, -1.83, 0.51, -5.08> texture { Material30 } }
sphere { <4.8, 0.84, 2.52>, 0.14 texture { Material31 } }
sphere { <0, 0, 0>, 1 matrix <0.18784399689633932, -0.007651507228102595, -0.00029541013246386336, 0.015058817417010427, 0.3685920382939458, 0.028515632981147402, -0.0002451275567253334, -0.012022807419078364, 0.15553582228620097, 4.8, 0.36, 2.52> texture { Material31 } }
sphere { <-5.26, 1.05, 1.39>, 0.174 texture { Material32 } }
sphere { <0, 0, 0>, 1 matrix <0.20498250041264, 0.002677669581830554, 6.789839895679519e-05, -0.006021491108409198, 0.4603682155218586, 0.023363385500627686, 6.458628193451251e-05, -0.009882560027380475, 0.1947494052260941, -5.26, 0.45, 1.39> texture { Material32 } }
sphere { <2.95, 0.99, -4.59>, 0.164 texture { Material33 } }
sphere { <0, 0, 0>, 1 matrix <0.21662597178935322, -0.012733048798284956, 0.00024044670684435665, 0.02552477524080164, 0.43394036186302354, -0.016408784083372485, 0.00020388107861456968, 0.006940727060552959, 0.1838689335923192, 2.95, 0.43, -4.59> texture { Material33 } }
sphere { <0.93, 0.82, 5.4>, 0.137 texture { Material34 } }
sphere { <0, 0, 0>, 1 matrix <0.17, 0, 0, 0, 0.363, 0, 0, 0, 0.153, 0.93, 0.36, 5.4> texture { Material34 } }
sphere { <-4.35, 0.95, -3.37>, 0.158 texture { Material35 } }
sphere { <0, 0, 0>, 1 matrix <0.18990273988919254, -0.006077295179808341, -0.00012595981563588157, 0.013370049395578348, 0.41742714552741184, 0.017315309872962124, -0.00011667856606271135, -0.0072906567886156315, 0.1758488916931319, -4.35, 0.41, -3.37> texture { Material35 } }
sphere { <5.5, 0.9, -0.46>, 0.151 texture { Material36 } }
sphere { <0, 0, 0>, 1 matrix <0.21899809137113674, 0.0009140057996118742, 2.3857860790805282e-05, -0.0016652434431284832, 0.398453184367075, 0.020815543039106037, 1.8301920606645152e-05, -0.008764439174360436, 0.16777122599241695, 5.5, 0.39, -0.46> texture { Material36 } }
sphere { <-3.76, 1.21, 4.07>, 0.202 texture { Material37 } }
sphere { <0, 0, 0>, 1 matrix <0.2482696662236476, -0.01904494710566557, 0.0006803109149584, 0.040843380539861106, 0.5310746921266579, -0.0380458887220624, 0.0006174709509260979, 0.016101818073382214, 0.22542482157995927, -3.76, 0.52, 4.07> texture { Material37 } }
sphere { <0.03, 0.89, -5.56>, 0.148 texture { Material38 } }
sphere { <0, 0, 0>, 1 matrix <0.17775605718631413, 0.009315800211244002, 0, -0.02046335889099104, 0.3904641480890384, 0, 0, 0, 0.165, 0.03, 0.38, -5.56> texture { Material38 } }
sphere { <3.75, 1.22, 4.13>, 0.203 texture { Material39 } }
sphere { <0, 0, 0>, 1 matrix <0.2747928967774122, 0.010669054306116608, -0.0001875123772078583, -0.020794956756649097, 0.5352654306284516, -0.018827866252641753, -0.00015410108090536717, 0.007938615248315366, 0.22586047604836948, 3.75, 0.52, 4.13> texture { Material39 } }
sphere { <-5.57, 1.13, -0.52>, 0.188 texture { Material40 } }
sphere { <0, 0, 0>, 1 matrix <0.2739916223717338, -0.0021406086361050697, -9.308475851359474e-05, 0.0038905952583223524, 0.49610495964968926, 0.04322883620358169, -7.134233316735362e-05, -0.018229027314763363, 0.2092073074092516, -5.57, 0.49, -0.52> texture { Material40 } }
sphere { <4.47, 1, -3.39>, 0.166 texture { Material41 } }
sphere { <0, 0, 0>, 1 matrix <0.20090083313484097, -0.006311716322899026, 0.00013222248687871658, 0.013785290874391405, 0.43839836575725794, -0.018380387832521876, 0.00012169731379384362, 0.007745721523955688, 0.18483773691494154, 4.47, 0.43, -3.39> texture { Material41 } }
sphere { <-1.01, 0.99, 5.54>, 0.165 texture { Material42 } }
sphere { <0, 0, 0>, 1 matrix <0.24242738202084713, 0.016671934044801794, 0.00010517473086481044, -0.029982037767812282, 0.4359354899635432, 0.005506904896128787, 7.963847933796347e-05, -0.0023186967983700154, 0.18398537252420324, -1.01, 0.43, 5.54> texture { Material42 } }
sphere { <-3.01, 1.13, -4.78>, 0.189 texture { Material43 } }
sphere { <0, 0, 0>, 1 matrix <0.26174145682815136, -0.011635453968266624, -0.00016120927185857671, 0.022205064824936303, 0.4993147673772869, 0.013845511008489696, -0.00012982884107694539, -0.005842805645582652, 0.2109190478990932, -3.01, 0.49, -4.78> texture { Material43 } }
sphere { <5.47, 1.08, 1.5>, 0.18 texture { Material44 } }
sphere { <0, 0, 0>, 1 matrix <0.246989717465531, -0.0022534473276913003, -3.796628111638026e-05, 0.00436092235885199, 0.47770881531512777, 0.016101867171145805, -3.104934730975228e-05, -0.006804554745965383, 0.20188535625608708, 5.47, 0.47, 1.5> texture { Material44 } }
sphere { <-5.06, 1.02, 2.6>, 0.17 texture { Material45 } }
sphere { <0, 0, 0>, 1 matrix <0.2328803435858823, 0.007462705597523851, 0.00023150914905381868, -0.014412950724831472, 0.4489038226169209, 0.027885926402391327, 0.00018878428463616116, -0.011774057814343004, 0.1896347434492909, -5.06, 0.44, 2.6> texture { Material45 } }
sphere { <1.98, 1.03, -5.35>, 0.172 texture { Material46 } }
sphere { <0, 0, 0>, 1 matrix <0.239, 0, 0, 0, 0.456, 0, 0, 0, 0.192, 1.98, 0.45, -5.35> texture { Material46 } }
sphere { <2.16, 1.17, 5.3>, 0.195 texture { Material47 } }
sphere { <0, 0, 0>, 1 matrix <0.2798538346981755, -0.009045863023229577, -5.972345665950278e-05, 0.016702539939320325, 0.5166850575688725, 0.006824693738647014, -4.6498976970612877e-05, -0.0028777238588492244, 0.217981000418012, 2.16, 0.51, 5.3> texture { Material47 } }
sphere { <-5.19, 0.9, -2.46>, 0.15 texture { Material48 } }
sphere { <0, 0, 0>, 1 matrix <0.21794447583957613, 0.004918530824096792, -0.00011621335902665993, -0.008934578928175823, 0.39545729576281125, -0.018700281477577303, -8.902583008005601e-05, 0.007886229815038913, 0.1668136668672743, -5.19, 0.39, -2.46> texture { Material48 } }
sphere { <5.51, 0.85, -1.7>, 0.142 texture { Material49 } }
sphere { <0, 0, 0>, 1 matrix <0.20398960801896232, -0.002058794996715403, 3.440104067642729e-05, 0.0037845496263150796, 0.3747715601321609, -0.012528164280215436, 2.6643943268997608e-05, 0.005278533216730771, 0.15791179936021296, 5.51, 0.37, -1.7> texture { Material49 } }
sphere { <-2.92, 0.96, 4.99>, 0.16 texture { Material50 } }
sphere { <0, 0, 0>, 1 matrix <0.2357607195373191, 0.010623699353505453, 0.00014189887903167381, -0.01913166197135516, 0.4244175522706939, 0.011345520471385038, 0.00010762669214690517, -0.004778466269124522, 0.17893617486861055, -2.92, 0.42, 4.99> texture { Material50 } }
sphere { <-1.22, 1.2, -5.67>, 0.2 texture { Material51 } }
sphere { <0, 0, 0>, 1 matrix <0.2518532279420838, 0.008599452655699596, -3.145115526775832e-05, -0.018086150426669785, 0.5296771383201208, -0.0038756036628578108, -2.795658246022962e-05, 0.0016379909820380182, 0.22399400930375854, -1.22, 0.52, -5.67> texture { Material51 } }
sphere { <4.74, 1.01, 3.37>, 0.168 texture { Material52 } }
sphere { <0, 0, 0>, 1 matrix <0.21898887733790998, 0.002207114632658139, -1.572514295484573e-05, -0.004474698159361707, 0.44393237664943774, -0.006326297397718276, -1.3427405171489274e-05, 0.0026644540841741387, 0.18698101642717135, 4.74, 0.43, 3.37> texture { Material52 } }
sphere { <-5.79, 0.95, 0.72>, 0.158 texture { Material53 } }
sphere { <0, 0, 0>, 1 matrix <0.20399955011492346, -0.00042841467435237267, 3.7115518811727532e-06, 0.000877830068035744, 0.41793633657537155, -0.007242098061294889, 3.2203170733704773e-06, 0.0030666300403090797, 0.1769734323841447, -5.79, 0.41, 0.72> texture { Material53 } }
sphere { <3.79, 0.97, -4.46>, 0.162 texture { Material54 } }
sphere { <0, 0, 0>, 1 matrix <0.2067087791761078, -0.010973539786152725, 0.00024907044148674863, 0.022689251345281967, 0.42695741351120475, -0.01940528075583326, 0.0002177862314449348, 0.008206438824312665, 0.1808137354599484, 3.79, 0.42, -4.46> texture { Material54 } }
sphere { <0.21, 0.89, 5.87>, 0.148 texture { Material55 } }
sphere { <0, 0, 0>, 1 matrix <0.1902743483781184, 0.01663344542690981, -2.9026064875263608e-05, -0.03413775187093532, 0.39050832165196425, -0.0013655100748374126, -2.5074872798002594e-05, 0.0005747682712963599, 0.16499899700508808, 0.21, 0.38, 5.87> texture { Material55 } }
sphere { <-4.13, 0.91, -4.2>, 0.152 texture { Material56 } }
sphere { <0, 0, 0>, 1 matrix <0.20941664054479506, -0.015631374645821445, -0.0005751431248499312, 0.029922917179143912, 0.39979780193804587, 0.02950146764140949, -0.0004655920534499444, -0.012475745022486601, 0.1695409655811057, -4.13, 0.39, -4.2> texture { Material56 } }
sphere { <5.9, 1.22, 0.3>, 0.204 texture { Material57 } }
sphere { <0, 0, 0>, 1 matrix <0.24299963085028836, -0.00042349984058098197, -7.382994232405476e-06, 0.0009393679591487626, 0.5386716557632927, 0.018787359182975253, -6.927253847689089e-06, -0.007947157502260403, 0.22786145492304624, 5.9, 0.53, 0.3> texture { Material57 } }
sphere { <-4.57, 1.05, 3.78>, 0.175 texture { Material58 } }
sphere { <0, 0, 0>, 1 matrix <0.23187009329180036, -0.00776114740452563, 0.00015629400830271872, 0.01552229480905126, 0.4633641041261223, -0.018675260942139796, 0.0001320414897729865, 0.007888687811765948, 0.19584113758261687, -4.57, 0.45, 3.78> texture { Material58 } }
sphere { <0.82, 0.9, -5.89>, 0.151 texture { Material59 } }
sphere { <0, 0, 0>, 1 matrix <0.19297118147683942, 0.003335131605238406, 4.0753467095776906e-06, -0.006894909380777845, 0.39893923036740014, 0.0009750376902110084, 3.5474520580779896e-06, -0.0004105421853520035, 0.167999498340113, 0.82, 0.39, -5.89> texture { Material59 } }
sphere { <3.38, 0.86, 4.91>, 0.144 texture { Material60 } }
sphere { <0, 0, 0>, 1 matrix <0.16937211352226672, -0.014590978915055746, -0.000436457673546316, 0.032700958627271993, 0.3789128421353121, 0.022731154167737844, -0.00041335109082915817, -0.00960555333597321, 0.16071267058320413, 3.38, 0.37, 4.91> texture { Material60 } }
sphere { <-5.83, 1.2, -1.34>, 0.2 texture { Material61 } }
sphere { <0, 0, 0>, 1 matrix <0.297, 0, 0, 0, 0.528, 0, 0, 0, 0.223, -5.83, 0.52, -1.34> texture { Material61 } }
sphere { <5.22, 1.15, -2.96>, 0.192 texture { Material62 } }
sphere { <0, 0, 0>, 1 matrix <0.2888304635176268, 0.009893064990815837, 0.00030101375441773015, -0.017389885866209157, 0.5067625375319907, 0.030875919803269314, 0.000222895998080949, -0.013006785113975657, 0.2136042458809583, 5.22, 0.5, -2.96> texture { Material62 } }
sphere { <-1.86, 0.82, 5.72>, 0.136 texture { Material63 } }
sphere { <0, 0, 0>, 1 matrix <0.19789099122188797, 0.006569195377084862, 3.5571285489191886e-05, -0.011943991594699749, 0.3597806977268745, 0.0038975130466914975, 2.730724946645033e-05, -0.0016456166197141879, 0.151991089213332, -1.86, 0.35, 5.72> texture { Material63 } }
sphere { <-2.5, 0.96, -5.49>, 0.16 texture { Material64 } }
sphere { <0, 0, 0>, 1 matrix <0.221, 0, 0, 0, 0.423, 0, 0, 0, 0.179, -2.5, 0.41, -5.49> texture { Material64 } }
sphere { <5.57, 1.02, 2.36>, 0.17 texture { Material65 } }
sphere { <0, 0, 0>, 1 matrix <0.23491279983020733, -0.006397981105261056, -0.00020570296463910193, 0.012278678631798878, 0.4499013866671807, 0.028965088054499922, -0.00016718836700454668, -0.012266811127293758, 0.1906056069291175, 5.57, 0.44, 2.36> texture { Material65 } }
sphere { <-5.72, 1.16, 2.03>, 0.194 texture { Material66 } }
sphere { <0, 0, 0>, 1 matrix <0.23186055091395502, 0.008032879138524969, 0.00039721860873420385, -0.01779698222931825, 0.5111842542192925, 0.05069443422896713, 0.0003715363711005269, -0.02140212495658729, 0.21594168427625912, -5.72, 0.5, 2.03> texture { Material66 } }
sphere { <2.86, 1.22, -5.37>, 0.204 texture { Material67 } }
sphere { <0, 0, 0>, 1 matrix <0.3019642124474942, 0.004649089763271826, 1.9113806451928476e-05, -0.008312941960817173, 0.5399177553844513, 0.004439866729072809, 1.4430290963707593e-05, -0.0018746103967196305, 0.22799229291278075, 2.86, 0.53, -5.37> texture { Material67 } }
sphere { <1.53, 1.08, 5.91>, 0.18 texture { Material68 } }
sphere { <0, 0, 0>, 1 matrix <0.2600686798529107, 0.022027803900973014, -0.00024003096574466319, -0.04008891514544897, 0.47319248159357913, -0.010332194625115712, -0.0001848514333895682, 0.004372149725575281, 0.2009523578779924, 1.53, 0.46, 5.91> texture { Material68 } }
sphere { <-5.13, 1.03, -3.33>, 0.172 texture { Material69 } }
sphere { <0, 0, 0>, 1 matrix <0.25695421966085386, 0.004850147118148739, -7.121386089401096e-05, -0.008586836337578507, 0.4547228262936886, -0.013357300969566565, -5.3202573119261105e-05, 0.005636487442102814, 0.1919172404418145, -5.13, 0.45, -3.33> texture { Material69 } }
sphere { <6.05, 1.11, -1.01>, 0.186 texture { Material70 } }
sphere { <0, 0, 0>, 1 matrix <0.2809901972966198, -0.002346347005756552, 6.065422716517537e-05, 0.004108194757410048, 0.4913257310992503, -0.02541945506147467, 4.489707918276325e-05, 0.010746436286151894, 0.20772219932255664, 6.05, 0.48, -1.01> texture { Material70 } }
sphere { <-3.79, 1.18, 4.85>, 0.196 texture { Material71 } }
sphere { <0, 0, 0>, 1 matrix <0.25860956713504557, -0.01421259637307243, 0.00030641566616675255, 0.028534942525087505, 0.5187333061351086, -0.022394511855131964, 0.0002602758554312184, 0.009474601169478908, 0.2197957328729527, -3.79, 0.51, 4.85> texture { Material71 } }
sphere { <-0.48, 1, -6.15>, 0.167 texture { Material72 } }
sphere { <0, 0, 0>, 1 matrix <0.23285896531741784, 0.00810568590562186, -1.1282774606572927e-05, -0.015341663023086868, 0.44073135471542124, -0.0012273330418469495, -9.006850115118301e-06, 0.0005176506707109583, 0.1859992794519908, -0.48, 0.43, -6.15> texture { Material72 } }
sphere { <4.52, 0.99, 4.22>, 0.164 texture { Material73 } }
sphere { <0, 0, 0>, 1 matrix <0.20694141656949802, 0.004924038274335353, -6.28910356859427e-05, -0.010347616663458353, 0.43473500975330664, -0.011108470829889113, -5.590314283194907e-05, 0.004698755477470337, 0.18393998633195982, 4.52, 0.43, 4.22> texture { Material73 } }
sphere { <-6.21, 1.04, -0.06>, 0.174 texture { Material74 } }
sphere { <0, 0, 0>, 1 matrix <0.24, 0, 0, 0, 0.461, 0, 0, 0, 0.195, -6.21, 0.45, -0.06> texture { Material74 } }
sphere { <4.63, 0.82, -4.16>, 0.137 texture { Material75 } }
sphere { <0, 0, 0>, 1 matrix <0.20394401868416448, -0.004778432796499713, 6.183011002728903e-05, 0.00850279953494802, 0.36277887020793176, -0.009391151725166469, 4.637258252046678e-05, 0.003958254032921404, 0.15294878252079827, 4.63, 0.35, -4.16> texture { Material75 } }
sphere { <-0.61, 1.21, 6.21>, 0.201 texture { Material76 } }
sphere { <0, 0, 0>, 1 matrix <0.2556526345516544, -0.013331513048814535, 3.473654483456424e-05, 0.02775662677741464, 0.5322695420241879, -0.002775662677741464, 3.053016635850373e-05, 0.0011717150140559652, 0.22499694698336414, -0.61, 0.52, 6.21> texture { Material76 } }
sphere { <-3.76, 1.08, -5>, 0.18 texture { Material77 } }
sphere { <0, 0, 0>, 1 matrix <0.22297826305272017, 0.003113509308411379, -1.6302710459878503e-05, -0.006631914446167735, 0.4749276551992858, -0.0049739358346258, -1.4694371311370311e-05, 0.0021047602163363913, 0.20098897922151648, -3.76, 0.46, -5> texture { Material77 } }
sphere { <6.17, 1.15, 1.15>, 0.192 texture { Material78 } }
sphere { <0, 0, 0>, 1 matrix <0.27098787949935443, -0.0025621884871068457, -6.598939240375772e-05, 0.0048123761621305695, 0.5083024331900781, 0.02620071466048866, -5.2353207995601135e-05, -0.011067099512780083, 0.2147149658675795, 6.17, 0.5, 1.15> texture { Material78 } }
sphere { <-5.34, 0.87, 3.32>, 0.145 texture { Material79 } }
sphere { <0, 0, 0>, 1 matrix <0.20896435779521602, 0.003859262071388186, 5.7162026540311e-05, -0.007072236236084571, 0.3827666867483137, 0.011342265661645064, 4.430740813172432e-05, -0.004797511846439949, 0.16192894094922272, -5.34, 0.37, 3.32> texture { Material79 } }
sphere { <1.7, 0.98, -6.07>, 0.163 texture { Material80 } }
sphere { <0, 0, 0>, 1 matrix <0.19874726884538285, 0.010025870238743517, 7.108063723607645e-05, -0.021764703231845223, 0.4314079590139759, 0.006121322783956469, 6.500842199480359e-05, -0.0025788906173149937, 0.18198171638131394, 1.7, 0.42, -6.07> texture { Material80 } }
sphere { <2.86, 0.86, 5.64>, 0.143 texture { Material81 } }
sphere { <0, 0, 0>, 1 matrix <0.20061006165933257, 0.01251256524611099, -0.00019715983516893442, -0.023531092850895295, 0.37707921099821357, -0.011897743576295377, -0.00015694315237328114, 0.005036081937056244, 0.15992064672071013, 2.86, 0.37, 5.64> texture { Material81 } }
sphere { <-5.93, 0.84, -2.23>, 0.141 texture { Material82 } }
sphere { <0, 0, 0>, 1 matrix <0.1779867975182898, 0.0021676374020788932, -3.545809373592482e-05, -0.004530118615580609, 0.3717733876511036, -0.012166604281845062, -3.127483548618089e-05, 0.005134830301746438, 0.1569160047275514, -5.93, 0.36, -2.23> texture { Material82 } }
sphere { <5.9, 1.19, -2.37>, 0.198 texture { Material83 } }
sphere { <0, 0, 0>, 1 matrix <0.299, 0, 0, 0, 0.523, 0, 0, 0, 0.221, 5.9, 0.51, -2.37> texture { Material83 } }
sphere { <-2.76, 1.04, 5.75>, 0.174 texture { Material84 } }
sphere { <0, 0, 0>, 1 matrix <0.22729363437891603, 0.0179301387100222, 0.00033748579674011464, -0.036174841257062336, 0.458249561122203, 0.017283535267263114, 0.00028715896740167643, -0.007289143134454444, 0.1938628018266859, -2.76, 0.45, 5.75> texture { Material84 } }
sphere { <-1.85, 0.92, -6.12>, 0.154 texture { Material85 } }
sphere { <0, 0, 0>, 1 matrix <0.2317086399336951, 0.011623185167306475, -8.801502002961282e-05, -0.020390673978852306, 0.40644222064511154, -0.006159682764444968, -6.525251484954051e-05, 0.0026031091780946793, 0.17198028830280584, -1.85, 0.4, -6.12> texture { Material85 } }
sphere { <5.51, 0.82, 3.27>, 0.136 texture { Material86 } }
sphere { <0, 0, 0>, 1 matrix <0.2019279738740745, 0.005392459141693595, -0.00012145582018812763, -0.00963701856510588, 0.36050526204640115, -0.016250658756845206, -9.139249835938315e-05, 0.006842382634461139, 0.15184588715962927, 5.51, 0.35, 3.27> texture { Material86 } }
sphere { <-6.29, 1.1, 1.32>, 0.184 texture { Material87 } }
sphere { <0, 0, 0>, 1 matrix <0.2609842964738463, -0.0028621012622745945, 7.328312205054461e-05, 0.005329429936649244, 0.48533395389072287, -0.024870673037696477, 5.755954030789902e-05, 0.010490715993267032, 0.20473138881189645, -6.29, 0.48, 1.32> texture { Material87 } }
sphere { <3.76, 1.03, -5.23>, 0.171 texture { Material88 } }
sphere { <0, 0, 0>, 1 matrix <0.24012725596757772, -0.020481953195290736, 0.0006249278256850732, 0.03858426037619085, 0.4515129404971961, -0.027628235824926777, 0.0004978678113341662, 0.011684187837854496, 0.19164350206102, 3.76, 0.44, -5.23> texture { Material88 } }
sphere { <0.77, 1.18, 6.41>, 0.196 texture { Material89 } }
sphere { <0, 0, 0>, 1 matrix <0.29688243965079586, 0.025783690136904208, -0.00013546186050959026, -0.04499167406439661, 0.5180212430077077, -0.0054535362502298925, -9.955083037449754e-05, 0.002296777766923743, 0.21898793323268187, 0.77, 0.51, 6.41> texture { Material89 } }
sphere { <-4.91, 1.17, -4.22>, 0.196 texture { Material90 } }
sphere { <0, 0, 0>, 1 matrix <0.234863943537591, 0.007993917630220058, -0.0001590814022013036, -0.017620635457251024, 0.5172900990028693, -0.02060258915001658, -0.00014825032800887445, 0.008710361049910485, 0.21882666115494348, -4.91, 0.51, -4.22> texture { Material90 } }
sphere { <6.49, 1.14, -0.2>, 0.19 texture { Material91 } }
sphere { <0, 0, 0>, 1 matrix <0.25099876360891565, -0.0007867453726098993, 4.1213036144372204e-05, 0.0015766251889353757, 0.5002445133702415, -0.052554172964512536, 3.480941698249763e-05, 0.022150068923412838, 0.2108396861005834, 6.49, 0.49, -0.2> texture { Material91 } }
sphere { <-4.66, 1.12, 4.54>, 0.187 texture { Material92 } }
sphere { <0, 0, 0>, 1 matrix <0.2259832742578528, -0.0027494471690732453, 1.7203620494257074e-05, 0.006009853546558332, 0.4939247614072573, -0.00618156364788857, 1.5909542846458973e-05, 0.0026152769279528566, 0.2089836358987865, -4.66, 0.48, 4.54> texture { Material92 } }
sphere { <0.36, 1.04, -6.51>, 0.173 texture { Material93 } }
sphere { <0, 0, 0>, 1 matrix <0.2476408449050419, 0.025980863812192976, 8.15493056974861e-05, -0.04789243570199428, 0.45648554997403745, 0.002873546142119657, 6.353640684864379e-05, -0.0012145271276061294, 0.19399618781558908, 0.36, 0.45, -6.51> texture { Material93 } }
sphere { <4.14, 0.86, 5.06>, 0.143 texture { Material94 } }
sphere { <0, 0, 0>, 1 matrix <0.216, 0, 0, 0, 0.378, 0, 0, 0, 0.159, 4.14, 0.37, 5.06> texture { Material94 } }
sphere { <-6.49, 1.21, -0.94>, 0.201 texture { Material95 } }
sphere { <0, 0, 0>, 1 matrix <0.2569808261810821, 0.003136334109466213, -0.00013558629091968123, -0.006492333642941733, 0.5299755793848087, -0.045910073617945114, -0.00011870395119427344, 0.019416854443679795, 0.22416059348798337, -6.49, 0.52, -0.94> texture { Material95 } }
sphere { <5.43, 1.09, -3.7>, 0.182 texture { Material96 } }
sphere { <0, 0, 0>, 1 matrix <0.2448133078399629, -0.00955864734688357, 0.0002767044514835508, 0.018805175596726044, 0.48082587222523526, -0.02787195668800467, 0.00023039880858222186, 0.011796429801562142, 0.20365851605156562, 5.43, 0.47, -3.7> texture { Material96 } }
sphere { <-1.51, 1.1, 6.41>, 0.183 texture { Material97 } }
sphere { <0, 0, 0>, 1 matrix <0.25, 0, 0, 0, 0.486, 0, 0, 0, 0.205, -1.51, 0.47, 6.41> texture { Material97 } }
sphere { <-3.23, 1.04, -5.76>, 0.173 texture { Material98 } }
sphere { <0, 0, 0>, 1 matrix <0.2300393047357882, 0.02103866696742125, -0.0005410812407629662, -0.04162195153295026, 0.4544965061833009, -0.023442248564535202, -0.00045207220548594145, 0.009900118102746814, 0.19274538461989874, -3.23, 0.45, -5.76> texture { Material98 } }
sphere { <6.29, 1.2, 2.07>, 0.2 texture { Material99 } }
sphere { <0, 0, 0>, 1 matrix <0.28593295503281707, -0.006188942739425051, -0.00020546038330241067, 0.01144738010194354, 0.527711382587447, 0.03508068095756891, -0.00016020162753999155, -0.014788264373417518, 0.22250905952850647, 6.29, 0.52, 2.07> texture { Material99 } }
sphere { <-6.05, 1.18, 2.72>, 0.196 texture { Material100 } }
sphere { <0, 0, 0>, 1 matrix <0.23394588657035242, -0.00503067902977405, 0.00012010541702271602, 0.011179286732831221, 0.5192873580723784, -0.024812563236283933, 0.00011240635182895214, 0.010449906439896501, 0.21875051273130647, -6.05, 0.51, 2.72> texture { Material100 } }
sphere { <2.63, 0.96, -6.11>, 0.159 texture { Material101 } }
sphere { <0, 0, 0>, 1 matrix <0.20604631336806364, 0.019843004203608752, 0.00041464636171146055, -0.040452887796728954, 0.4196882398454113, 0.017588212085534332, 0.00035655580862144914, -0.007418724528969457, 0.17784497573538197, 2.63, 0.41, -6.11> texture { Material101 } }
sphere { <2.19, 0.91, 6.29>, 0.152 texture { Material102 } }
sphere { <0, 0, 0>, 1 matrix <0.1937633018039027, 0.009579977509126689, -8.309617522564457e-05, -0.01985129360138623, 0.4014490729713387, -0.006969071157933465, -7.281623602247205e-05, 0.0029471196439022117, 0.1699744368533113, 2.19, 0.39, 6.29> texture { Material102 } }
sphere { <-5.88, 1.19, -3.17>, 0.199 texture { Material103 } }
sphere { <0, 0, 0>, 1 matrix <0.30363038837818035, -0.014970248349328804, -0.000692038781279392, 0.025951713421369343, 0.52411303885908, 0.048590442150648984, -0.0005053704258027139, -0.020468839008432778, 0.2210537745219013, -5.88, 0.52, -3.17> texture { Material103 } }
sphere { <6.49, 0.88, -1.64>, 0.147 texture { Material104 } }
sphere { <0, 0, 0>, 1 matrix <0.17398514669170417, -0.0022727536938464215, 5.763083618771884e-05, 0.005081041304058954, 0.38846688901952925, -0.019714440259748743, 5.4318719165436164e-05, 0.008311486382002041, 0.16378924336963813, 6.49, 0.38, -1.64> texture { Material104 } }
sphere { <-3.69, 1.15, 5.61>, 0.192 texture { Material105 } }
sphere { <0, 0, 0>, 1 matrix <0.2658865832426181, -0.007766552444576588, 7.426097209531158e-05, 0.01486156088078753, 0.5086899309527197, -0.009730783910039453, 6.00229661672631e-05, 0.004110252535674818, 0.21496069924834285, -3.69, 0.5, 5.61> texture { Material105 } }
sphere { <-1.08, 1.21, -6.64>, 0.202 texture { Material106 } }
sphere { <0, 0, 0>, 1 matrix <0.2626487424126558, -0.013588042034893982, -5.676890300512855e-05, 0.027589408542332265, 0.5332681715589425, 0.004458894309871881, -4.878240334281008e-05, -0.0018870975918184366, 0.22599211597521734, -1.08, 0.52, -6.64> texture { Material106 } }
sphere { <5.29, 1.22, 4.18>, 0.204 texture { Material107 } }
sphere { <0, 0, 0>, 1 matrix <0.27374157144646066, -0.011893122346228812, -0.00032511979316240025, 0.02343900024439255, 0.5386845871403051, 0.02948777450100998, -0.00027053763810593886, -0.012450393678204214, 0.22765964619722157, 5.29, 0.53, 4.18> texture { Material107 } }
sphere { <-6.74, 0.96, 0.49>, 0.16 texture { Material108 } }
sphere { <0, 0, 0>, 1 matrix <0.2109998432998529, -0.0002571428130515524, 2.238573529804904e-06, 0.0005167229987386645, 0.4239354227463099, -0.007381757124838064, 1.8990742267065297e-06, 0.003116355012608522, 0.1789728703681899, -6.74, 0.41, 0.49> texture { Material108 } }
sphere { <4.65, 1, -4.93>, 0.167 texture { Material109 } }
sphere { <0, 0, 0>, 1 matrix <0.23070280954467726, -0.011710455157048464, 0.00028090604681192617, 0.02240701809270745, 0.4409233102148423, -0.021179236279408414, 0.00022740013313346402, 0.008960446118211252, 0.18678506014813412, 4.65, 0.43, -4.93> texture { Material109 } }
sphere { <-0.1, 1.13, 6.79>, 0.188 texture { Material110 } }
sphere { <0, 0, 0>, 1 matrix <0.2568434581980878, 0.008968722227641711, 1.5654180191219796e-06, -0.0174139781774055, 0.4986960226825288, 0.000174139781774055, 1.2852264670612362e-06, -7.363425642149419e-05, 0.21099998714773532, -0.1, 0.49, 6.79> texture { Material110 } }
sphere { <-4.52, 1.02, -5.09>, 0.169 texture { Material111 } }
sphere { <0, 0, 0>, 1 matrix <0.217700723036881, 0.011416033845702908, -0.0002633637275447058, -0.023512840351929385, 0.44790625856666105, -0.020691299509697864, -0.00022832910323830003, 0.008709700684483065, 0.1887990703891503, -4.52, 0.44, -5.09> texture { Material111 } }
sphere { <6.79, 1.02, 0.7>, 0.171 texture { Material112 } }
sphere { <0, 0, 0>, 1 matrix <0.22999681641241848, -0.0012097300518693506, -3.1517517057220305e-05, 0.0023721228408394657, 0.45038192017431283, 0.023484016124310707, -2.61732424257786e-05, -0.009945558935129368, 0.19074088489998478, 6.79, 0.44, 0.7> texture { Material112 } }
sphere { <-5.49, 0.87, 4.08>, 0.145 texture { Material113 } }
sphere { <0, 0, 0>, 1 matrix <0.21071094926704897, 0.011033917031853524, 0.0003854009772680112, -0.02002838968341185, 0.38154256936913855, 0.02670451957788246, 0.0002959002763858664, -0.011295384260096498, 0.16160546629815217, -5.49, 0.37, 4.08> texture { Material113 } }
sphere { <1.29, 0.97, -6.73>, 0.161 texture { Material114 } }
sphere { <0, 0, 0>, 1 matrix <0.2138648751500384, -0.022062790937534927, 0.00022007522601296076, 0.043817728978267044, 0.4246608493222527, -0.008495273985582386, 0.0001842490264294555, 0.003581145942400069, 0.17996427824997796, 1.29, 0.42, -6.73> texture { Material114 } }
sphere { <3.6, 0.84, 5.85>, 0.14 texture { Material115 } }
sphere { <0, 0, 0>, 1 matrix <0.16992464329602222, -0.005060975741583469, -4.6100571845245685e-05, 0.011044835294867451, 0.3707739968240845, 0.006756840415683618, -4.2575233998256317e-05, -0.0028593637338607224, 0.15697395397449518, 3.6, 0.36, 5.85> texture { Material115 } }
sphere { <-6.62, 0.99, -1.88>, 0.165 texture { Material116 } }
sphere { <0, 0, 0>, 1 matrix <0.2209383541090863, -0.005214944039282335, -0.0002191853899154566, 0.010335499951156846, 0.43633327776418457, 0.03674844427077989, -0.0001834809825084139, -0.015521603173731231, 0.18434762317330342, -6.62, 0.43, -1.88> texture { Material116 } }
sphere { <6.17, 1, -3.09>, 0.167 texture { Material117 } }
sphere { <0, 0, 0>, 1 matrix <0.24381095921246043, -0.009595643863000306, 0.00037388066868936445, 0.017421599308644, 0.4413142512546433, -0.0344560519659848, 0.0002865396928070129, 0.014544653990156113, 0.18643328816311502, 6.17, 0.43, -3.09> texture { Material117 } }
sphere { <-2.47, 1.19, 6.46>, 0.199 texture { Material118 } }
sphere { <0, 0, 0>, 1 matrix <0.2644385962528671, -0.017238955446394328, 0.00021731757953532174, 0.034282752906603056, 0.5257162544869274, -0.013270743060620538, 0.0001828747933448179, 0.0056155136670177986, 0.2229292097574149, -2.47, 0.52, 6.46> texture { Material118 } }
sphere { <-2.55, 1.16, -6.44>, 0.193 texture { Material119 } }
sphere { <0, 0, 0>, 1 matrix <0.29465096023130677, 0.014345464481907995, -0.00013886528431881362, -0.024849262204254187, 0.5102996922595873, -0.009886265608144137, -0.00010167763190801269, 0.004178930276632356, 0.21595954760881078, -2.55, 0.5, -6.44> texture { Material119 } }
sphere { <6.25, 0.97, 3.04>, 0.162 texture { Material120 } }
sphere { <0, 0, 0>, 1 matrix <0.1989064882681647, 0.006096912258229962, -0.0001912739969358449, -0.013143594767741977, 0.42795497756146456, -0.026884625661290403, -0.00017397283138385894, 0.011342930640311336, 0.1806441464812603, 6.25, 0.42, 3.04> texture { Material120 } }
sphere { <-6.67, 1.13, 1.99>, 0.188 texture { Material121 } }
sphere { <0, 0, 0>, 1 matrix <0.22897375593803806, -0.003465767452230707, 8.68768947706092e-05, 0.007536909131925293, 0.49731750830777777, -0.02494976816085614, 7.966876813025298e-05, 0.010520986573855, 0.20973626890549985, -6.67, 0.49, 1.99> texture { Material121 } }
sphere { <3.59, 1, -5.98>, 0.167 texture { Material122 } }
sphere { <0, 0, 0>, 1 matrix <0.23476173343758472, 0.010578683678278735, 0.00014129761259509894, -0.019941944125436085, 0.44239288389627623, 0.011826036632526052, 0.00011243682363950429, -0.004992029007409417, 0.1869333223487719, 3.59, 0.43, -5.98> texture { Material122 } }
sphere { <1.4, 0.9, 6.85>, 0.15 texture { Material123 } }
sphere { <0, 0, 0>, 1 matrix <0.19588537610231044, -0.00670215502962676, -2.339263218154459e-05, 0.01357528340184604, 0.396758158326581, 0.0027704660003767434, -1.993147741998952e-05, -0.0011654101311408466, 0.16699593235154694, 1.4, 0.39, 6.85> texture { Material123 } }
sphere { <-5.67, 0.82, -4.11>, 0.136 texture { Material124 } }
sphere { <0, 0, 0>, 1 matrix <0.17596283474588836, 0.003616377302662255, -5.1023484458322846e-05, -0.007417682990119739, 0.36078008855389354, -0.010183598681350828, -4.406573657764246e-05, 0.004287831023726665, 0.15193950297181713, -5.67, 0.35, -4.11> texture { Material124 } }
sphere { <6.98, 1.05, -0.8>, 0.174 texture { Material125 } }
sphere { <0, 0, 0>, 1 matrix <0.23898890893712105, -0.0023003132609967407, 9.98195659104309e-05, 0.004437005913470701, 0.4592457558202947, -0.03993305322123631, 8.144274206081183e-05, 0.016891421644557657, 0.1942670153214527, 6.98, 0.45, -0.8> texture { Material125 } }
sphere { <-4.61, 0.98, 5.31>, 0.163 texture { Material126 } }
sphere { <0, 0, 0>, 1 matrix <0.221518413729915, 0.014608814835635284, 0.0004182196556001347, -0.02849376947671206, 0.43135230427372584, 0.02474458928240784, 0.0003447486350217326, -0.01045787491612156, 0.18270061302748114, -4.61, 0.42, 5.31> texture { Material126 } }
sphere { <-0.19, 0.97, -7.05>, 0.162 texture { Material127 } }
sphere { <0, 0, 0>, 1 matrix <0.217, 0, 0, 0, 0.43, 0, 0, 0, 0.181, -0.19, 0.42, -7.05> texture { Material127 } }
sphere { <4.91, 1.03, 5.08>, 0.172 texture { Material128 } }
sphere { <0, 0, 0>, 1 matrix <0.23170541100843517, -0.011684297495498921, -0.00028231445024965964, 0.022965688180808224, 0.45488920691847984, 0.022008784506607877, -0.00023363954503420107, -0.009266856634361212, 0.19177609543600888, 4.91, 0.45, 5.08> texture { Material128 } }
sphere { <-7.07, 1.11, -0.43>, 0.185 texture { Material129 } }
sphere { <0, 0, 0>, 1 matrix <0.259997728129776, -0.001086247501466279, -3.786450373330263e-05, 0.002051336627769011, 0.48980394867757365, 0.034188943796150194, -3.014597027997555e-05, -0.014413668769456395, 0.2064975671620004, -7.07, 0.48, -0.43> texture { Material129 } }
sphere { <5.51, 1.03, -4.47>, 0.172 texture { Material130 } }
sphere { <0, 0, 0>, 1 matrix <0.2026950205526118, -0.0111169270146197, 0.0003775936015282965, 0.024862487017917947, 0.4522723929336525, -0.030782126784088888, 0.00035713286449966957, 0.013017991943931865, 0.19155783550109565, 5.51, 0.44, -4.47> texture { Material130 } }
sphere { <-1.05, 0.96, 7.03>, 0.16 texture { Material131 } }
sphere { <0, 0, 0>, 1 matrix <0.22486601202006637, 0.00776377653286586, 2.0301209080852628e-05, -0.014595899881787817, 0.4227423198290775, 0.002211499982089063, 1.6150739668767204e-05, -0.0009358356898201946, 0.178997552918232, -1.05, 0.41, 7.03> texture { Material131 } }
sphere { <-3.98, 1.22, -5.91>, 0.204 texture { Material132 } }
sphere { <0, 0, 0>, 1 matrix <0.3017155887488405, -0.013102163311007504, -0.00019189192849314004, 0.023427709231602825, 0.5392599487674699, 0.015806647192406726, -0.0001448720519749534, -0.0066739177034606184, 0.22790225500107714, -3.98, 0.53, -5.91> texture { Material132 } }
sphere { <6.94, 1.13, 1.67>, 0.188 texture { Material133 } }
sphere { <0, 0, 0>, 1 matrix <0.22998322152280026, 0.0027771947750038386, -7.076140384237565e-05, -0.006013230425877876, 0.49731750830777777, -0.02536014570913713, -6.460823829086472e-05, 0.010694037347226501, 0.20972752177764287, 6.94, 0.49, 1.67> texture { Material133 } }
sphere { <-6.26, 1.05, 3.47>, 0.176 texture { Material134 } }
sphere { <0, 0, 0>, 1 matrix <0.24592132505077852, 0.006219449411419035, 0.0001425983454639237, -0.011756276326462811, 0.4643627336608769, 0.02130825084171385, 0.00011361494191434573, -0.008981542290270783, 0.19579407291778025, -6.26, 0.45, 3.47> texture { Material134 } }
sphere { <2.28, 1.19, -6.8>, 0.198 texture { Material135 } }
sphere { <0, 0, 0>, 1 matrix <0.2614268161052709, 0.017320004159418312, 0.0001930724698034852, -0.034706115204941275, 0.5237211263864078, 0.011690480911138116, 0.0001635957568563882, -0.004943403356709832, 0.22194489406084839, 2.28, 0.51, -6.8> texture { Material135 } }
sphere { <2.92, 1.05, 6.57>, 0.175 texture { Material136 } }
sphere { <0, 0, 0>, 1 matrix <0.21531675082291837, 0.017163975387695915, -0.00030783754132248867, -0.03687076194393937, 0.46223433991456997, -0.016612101535181476, -0.0002793340652741101, 0.007017180820895623, 0.195874146190371, 2.92, 0.45, 6.57> texture { Material136 } }
sphere { <-6.6, 1.15, -2.88>, 0.192 texture { Material137 } }
sphere { <0, 0, 0>, 1 matrix <0.29093659691789836, 0.006072504285092589, -0.0001458270888336619, -0.010621665570832054, 0.5083024331900781, -0.024429830812913726, -0.00010774166357126224, 0.01031908374219342, 0.2147521941737861, -6.6, 0.5, -2.88> texture { Material137 } }
sphere { <6.82, 1.09, -2.34>, 0.182 texture { Material138 } }
sphere { <0, 0, 0>, 1 matrix <0.24198497781490177, -0.0026960198476809255, 4.459711201031243e-05, 0.005369758539595893, 0.48170637862320415, -0.015941470664425306, 3.759425971117246e-05, 0.006747012480379174, 0.20388839204148246, 6.82, 0.47, -2.34> texture { Material138 } }
sphere { <-3.46, 0.94, 6.35>, 0.156 texture { Material139 } }
sphere { <0, 0, 0>, 1 matrix <0.18844571051375877, 0.01446107809461224, 0.0003023397197679367, -0.0316766472548649, 0.4124246050099826, 0.01727817122992631, 0.00027994418497031176, -0.0073035747952587046, 0.17484730317183436, -3.46, 0.4, 6.35> texture { Material139 } }
sphere { <-1.74, 0.94, -7.03>, 0.156 texture { Material140 } }
sphere { <0, 0, 0>, 1 matrix <0.18476108954567555, 0.009398739047461632, -5.91118649874954e-05, -0.020982049873522455, 0.412433997853639, -0.0051914350202529784, -5.5597105447698374e-05, 0.002187190541220383, 0.17398624401514695, -1.74, 0.4, -7.03> texture { Material140 } }
sphere { <6.05, 0.89, 4.01>, 0.148 texture { Material141 } }
sphere { <0, 0, 0>, 1 matrix <0.2169596654857787, 0.004183281885190213, -6.0868448733976464e-05, -0.007556896308730708, 0.3917612041914856, -0.011404043520448158, -4.656296078267324e-05, 0.00482926332753672, 0.1659297322591825, 6.05, 0.38, 4.01> texture { Material141 } }
sphere { <-7.19, 0.9, 1.13>, 0.15 texture { Material142 } }
sphere { <0, 0, 0>, 1 matrix <0.22199924121015976, -0.000580411089755682, 5.00801294559048e-06, 0.0010379423542027286, 0.39693953497708734, -0.0068504195377380095, 3.7898476345009047e-06, 0.0028989180915364875, 0.1679749870056123, -7.19, 0.39, 1.13> texture { Material142 } }
sphere { <4.55, 1.14, -5.7>, 0.19 texture { Material143 } }
sphere { <0, 0, 0>, 1 matrix <0.2593936967394689, 0.01773916097418603, 0.00048193336093501417, -0.03425022618862072, 0.5000897384420563, 0.027224538765313902, 0.0003929610481470116, -0.011497215574196308, 0.21168764634634468, 4.55, 0.49, -5.7> texture { Material143 } }
sphere { <0.5, 1.16, 7.29>, 0.193 texture { Material144 } }
sphere { <0, 0, 0>, 1 matrix <0.28395695633835716, -0.004944384489278325, -3.0130563149980692e-06, 0.008879000315253332, 0.5099223245297596, 0.0006215300220677333, -2.2810109426922008e-06, -0.00026201755832267186, 0.21499984032923403, 0.5, 0.5, 7.29> texture { Material144 } }
sphere { <-5.3, 1, -5.05>, 0.167 texture { Material145 } }
sphere { <0, 0, 0>, 1 matrix <0.197, 0, 0, 0, 0.442, 0, 0, 0, 0.187, -5.3, 0.43, -5.05> texture { Material145 } }
sphere { <7.33, 0.95, 0.14>, 0.159 texture { Material146 } }
sphere { <0, 0, 0>, 1 matrix <0.242, 0, 0, 0, 0.421, 0, 0, 0, 0.178, 7.33, 0.41, 0.14> texture { Material146 } }
sphere { <-5.51, 0.89, 4.86>, 0.149 texture { Material147 } }
sphere { <0, 0, 0>, 1 matrix <0.18169774442335948, -0.010479107704362802, 0.00034347224618239044, 0.022685540854499694, 0.39250071104814777, -0.0257790236982951, 0.00031327688388064183, 0.01086121303024616, 0.16564400354104475, -5.51, 0.38, 4.86> texture { Material147 } }
sphere { <0.79, 1.04, -7.32>, 0.173 texture { Material148 } }
sphere { <0, 0, 0>, 1 matrix <0.20422942636357846, -0.017757648395560613, 8.561929293572525e-05, 0.039759807871035724, 0.45725336642411124, -0.00441775643011508, 8.102508697332048e-05, 0.0018671998854952626, 0.19399099721255852, 0.79, 0.45, -7.32> texture { Material148 } }
sphere { <4.37, 0.83, 5.94>, 0.139 texture { Material149 } }
sphere { <0, 0, 0>, 1 matrix <0.1719315428365299, 0.004852019316322278, -4.986385981154278e-05, -0.010381064583759295, 0.36777582434302725, -0.007561516178293806, -4.4935455062727507e-05, 0.0031848777381400543, 0.1549672692364358, 4.37, 0.36, 5.94> texture { Material149 } }
sphere { <-7.25, 1.07, -1.43>, 0.178 texture { Material150 } }
sphere { <0, 0, 0>, 1 matrix <0.272, 0, 0, 0, 0.471, 0, 0, 0, 0.199, -7.25, 0.46, -1.43> texture { Material150 } }
sphere { <6.32, 0.98, -3.85>, 0.163 texture { Material151 } }
sphere { <0, 0, 0>, 1 matrix <0.20992162302498107, -0.005735483658304567, 0.0001281162091655321, 0.011771397412996517, 0.43040932947922134, -0.019241707309705845, 0.00011103404794346115, 0.008125268515931471, 0.1818185020370155, 6.32, 0.42, -3.85> texture { Material151 } }
sphere { <-2.06, 0.93, 7.12>, 0.155 texture { Material152 } }
sphere { <0, 0, 0>, 1 matrix <0.19929860675227054, 0.016733902607550366, 0.0002045730305877595, -0.034388169858516, 0.4094360209157074, 0.010029882875400502, 0.00017797853661135075, -0.004246227786665906, 0.17394808959348834, -2.06, 0.4, 7.12> texture { Material152 } }
sphere { <-3.3, 1.12, -6.66>, 0.187 texture { Material153 } }
sphere { <0, 0, 0>, 1 matrix <0.26686872674314455, -0.00837129426507465, -6.417803668490125e-05, 0.015488462048490175, 0.4936990685474333, 0.007572137001484087, -5.023674032638336e-05, -0.0032035964237048056, 0.2089754398158404, -3.3, 0.48, -6.66> texture { Material153 } }
sphere { <6.94, 1.01, 2.69>, 0.168 texture { Material154 } }
sphere { <0, 0, 0>, 1 matrix <0.23292603530707479, 0.00586733042338631, -0.0001910754567235093, -0.011231027334035597, 0.4449135664158816, -0.02901348727959196, -0.00015417247151939807, 0.012229900467630693, 0.18760172111524157, 6.94, 0.44, 2.69> texture { Material154 } }
sphere { <-6.95, 1.16, 2.71>, 0.193 texture { Material155 } }
sphere { <0, 0, 0>, 1 matrix <0.23392571786204078, 0.005892512099023161, 0.00019189552306137842, -0.01289301792606777, 0.51075279373303, 0.03330696297567508, 0.00017713432897973393, -0.014051375005362923, 0.21554240298346902, -6.95, 0.5, 2.71> texture { Material155 } }
sphere { <3.3, 1.13, -6.71>, 0.189 texture { Material156 } }
sphere { <0, 0, 0>, 1 matrix <0.241, 0, 0, 0, 0.499, 0, 0, 0, 0.211, 3.3, 0.49, -6.71> texture { Material156 } }
sphere { <2.1, 0.89, 7.19>, 0.148 texture { Material157 } }
sphere { <0, 0, 0>, 1 matrix <0.21291959505707975, 0.021474327493706726, -0.0003151181083517419, -0.039235803972146405, 0.38885806108899484, -0.011443776158542703, -0.00024296489662634305, 0.004829215002965591, 0.164929135238484, 2.1, 0.38, 7.19> texture { Material157 } }
sphere { <-6.42, 1.02, -3.89>, 0.17 texture { Material158 } }
sphere { <0, 0, 0>, 1 matrix <0.2589049716685029, -0.007013625693024773, -0.00015716224055290767, 0.012158756510301634, 0.4483846611048037, 0.020108712690114237, -0.00011529276333997086, -0.008509254813188653, 0.1898093235067839, -6.42, 0.44, -3.89> texture { Material158 } }
sphere { <7.37, 0.97, -1.47>, 0.161 texture { Material159 } }
sphere { <0, 0, 0>, 1 matrix <0.19799879422794744, 0.0006909771133105442, 5.9082830575445936e-06, -0.0014866477286378374, 0.42593511813662266, 0.007284573870325401, 5.371166415949631e-06, -0.003077988959292423, 0.17997368128456184, 7.37, 0.42, -1.47> texture { Material159 } }
sphere { <-4.45, 0.9, 6.07>, 0.149 texture { Material160 } }
sphere { <0, 0, 0>, 1 matrix <0.18533427772605962, 0.01571529074497712, 0.00048490881682076097, -0.03345836094091903, 0.39383067056583626, 0.024370904882891637, 0.00043537512047885535, -0.010277629079401272, 0.16668287491224382, -4.45, 0.39, 6.07> texture { Material160 } }
sphere { <-0.82, 1.15, -7.5>, 0.192 texture { Material161 } }
sphere { <0, 0, 0>, 1 matrix <0.2588441482930928, -0.008983684909316031, -1.7316856323021693e-05, 0.017620509397422948, 0.5076905401257007, 0.0019578343774914386, -1.4308136112458077e-05, -0.000824757001541669, 0.21399841020709862, -0.82, 0.5, -7.5> texture { Material161 } }
sphere { <5.68, 1.2, 4.98>, 0.201 texture { Material162 } }
sphere { <0, 0, 0>, 1 matrix <0.2549322054740278, 0.005879173165037915, -7.703923405935021e-05, -0.012242513531902484, 0.5306765291471399, -0.01391194719534373, -6.767368011488019e-05, 0.005868693355474568, 0.22392309809077857, 5.68, 0.52, 4.98> texture { Material162 } }
sphere { <-7.57, 0.92, 0.17>, 0.153 texture { Material163 } }
sphere { <0, 0, 0>, 1 matrix <0.18099990081798903, -0.0001894182817307187, 4.959100548223435e-06, 0.0004227899769017147, 0.40344633204084784, -0.021139498845085737, 4.657718746950188e-06, 0.008895333672437068, 0.1697671140626525, -7.57, 0.39, 0.17> texture { Material163 } }
sphere { <5.48, 0.95, -5.25>, 0.158 texture { Material164 } }
sphere { <0, 0, 0>, 1 matrix <0.2247376118390729, -0.010859597618392045, 0.0002737963418369544, 0.020222984009361185, 0.4179793370588663, -0.02110224418368124, 0.0002153864555784041, 0.008914313175445296, 0.1767752489159182, 5.48, 0.41, -5.25> texture { Material164 } }
sphere { <-0.5, 1.13, 7.58>, 0.189 texture { Material165 } }
sphere { <0, 0, 0>, 1 matrix <0.2859566532139794, 0.00497920409835775, 3.0342750214417178e-06, -0.008704902269856207, 0.49992384757819563, 0.0006093431588899346, 2.238573529804904e-06, -0.0002571428130515524, 0.2109998432998529, -0.5, 0.49, 7.58> texture { Material165 } }
sphere { <-4.76, 0.98, -5.94>, 0.164 texture { Material166 } }
sphere { <0, 0, 0>, 1 matrix <0.23065945553480138, -0.012535546141122947, -0.0002750551449681407, 0.02355163214392796, 0.4329427978127637, 0.019022472116249505, -0.00021790082913060495, -0.008020996307082164, 0.18282400317647143, -4.76, 0.42, -5.94> texture { Material166 } }
sphere { <7.54, 1.19, 1.16>, 0.198 texture { Material167 } }
sphere { <0, 0, 0>, 1 matrix <0.2989744662192422, 0.003903863334380853, -0.0001685229530015561, -0.0068415531345002245, 0.5220060218000747, -0.045154250687701486, -0.0001245604435228893, 0.01904406374424051, 0.22017790107274893, 7.54, 0.51, 1.16> texture { Material167 } }
sphere { <-6.36, 1.03, 4.24>, 0.172 texture { Material168 } }
sphere { <0, 0, 0>, 1 matrix <0.21674169041274913, -0.01057795167281523, 0.000382851709675409, 0.022179576088160964, 0.4532685876317442, -0.03287330027352428, 0.00033874436985105314, 0.013871810225311344, 0.1914979324518279, -6.36, 0.44, 4.24> texture { Material168 } }
sphere { <1.83, 1.09, -7.44>, 0.181 texture { Material169 } }
sphere { <0, 0, 0>, 1 matrix <0.26239630236948447, 0.017808935731185468, 0.00014936848590075088, -0.03250300057402671, 0.4788307441247156, 0.008041979523470527, 0.00011529202523898262, -0.0034010871734677438, 0.2029714741380852, 1.83, 0.47, -7.44> texture { Material169 } }
sphere { <3.68, 0.91, 6.73>, 0.151 texture { Material170 } }
sphere { <0, 0, 0>, 1 matrix <0.20597581942336438, 0.0031562064116867016, -1.3189405437606999e-05, -0.006143877529545473, 0.40093892575771295, -0.0033512059252066213, -1.0820434558036809e-05, 0.001412353619351419, 0.16899409794478654, 3.68, 0.39, 6.73> texture { Material170 } }
sphere { <-7.27, 0.99, -2.48>, 0.165 texture { Material171 } }
sphere { <0, 0, 0>, 1 matrix <0.2189150799298699, 0.006092964929524328, -0.00025210645819877454, -0.012130286343710536, 0.43434088836800105, -0.036011787582890656, -0.00021181547172865073, 0.015197635126724495, 0.18337117281830556, -7.27, 0.43, -2.48> texture { Material171 } }
sphere { <7.05, 1.19, -3.09>, 0.198 texture { Material172 } }
sphere { <0, 0, 0>, 1 matrix <0.29497142988404346, -0.004105025480100341, 6.571126670008352e-05, 0.007305553820517558, 0.5246801841850253, -0.016802773787190382, 4.9450512567520494e-05, 0.007105172915726219, 0.2218862638210947, 7.05, 0.51, -3.09> texture { Material172 } }
sphere { <-3.12, 0.88, 7.05>, 0.147 texture { Material173 } }
sphere { <0, 0, 0>, 1 matrix <0.19039087787931072, -0.01523948596350199, 0.0002677459871161651, 0.031037487119383634, 0.38751973755768904, -0.013642851481047753, 0.00022989707794267582, 0.005751742012575402, 0.16389894633936586, -3.12, 0.38, 7.05> texture { Material173 } }
sphere { <-2.47, 0.96, -7.32>, 0.159 texture { Material174 } }
sphere { <0, 0, 0>, 1 matrix <0.21987963847610856, -0.0072761899298206785, -4.054282910028403e-05, 0.013957055229019666, 0.4217429290020584, 0.004701323866617151, -3.280283445386617e-05, -0.0019830228631702676, 0.17798895062418393, -2.47, 0.41, -7.32> texture { Material174 } }
sphere { <6.78, 1.19, 3.73>, 0.199 texture { Material175 } }
sphere { <0, 0, 0>, 1 matrix <0.26167089501346213, -0.01311406346635026, -0.0006033591419861036, 0.02632823428740548, 0.5231185169637118, 0.048268429526910045, -0.0005112432424462405, -0.020371846682460133, 0.2210627207221819, 6.78, 0.51, 3.73> texture { Material175 } }
sphere { <-7.53, 1.13, 1.83>, 0.189 texture { Material176 } }
sphere { <0, 0, 0>, 1 matrix <0.24999780351552534, 0.001047930629160626, 8.877458085155845e-06, -0.0020916695358046094, 0.49892399988303926, 0.008453831040543631, 7.492574623871533e-06, -0.0035746660311717555, 0.21096971751089516, -7.53, 0.49, 1.83> texture { Material176 } }
sphere { <4.33, 1.04, -6.45>, 0.173 texture { Material177 } }
sphere { <0, 0, 0>, 1 matrix <0.2284011798513989, 0.016545023654147385, 0.0004040232327910998, -0.03309004730829477, 0.4562571717260195, 0.022325815051379608, 0.00034227295703700164, -0.00945678628813896, 0.1937690688482642, 4.33, 0.45, -6.45> texture { Material177 } }
sphere { <1.17, 1.21, 7.69>, 0.202 texture { Material178 } }
sphere { <0, 0, 0>, 1 matrix <0.27263425924051216, 0.014126486382870918, -5.541526658906794e-05, -0.02773551905208356, 0.5352654306284516, -0.004202351371527812, -4.587490933747016e-05, 0.001771886958890458, 0.22599304925616098, 1.17, 0.52, 7.69> texture { Material178 } }
sphere { <-6.07, 0.98, -4.89>, 0.163 texture { Material179 } }
sphere { <0, 0, 0>, 1 matrix <0.208686006381753, 0.011445506138204517, -0.0003887540035439111, -0.023657696898106945, 0.4303561095756341, -0.029290481873846697, -0.0003403922614762475, 0.012407773571560058, 0.18257856196198177, -6.07, 0.42, -4.89> texture { Material179 } }
sphere { <7.79, 0.86, -0.49>, 0.143 texture { Material180 } }
sphere { <0, 0, 0>, 1 matrix <0.18799907579625535, -0.0005892898176835681, 1.5403395743729733e-05, 0.0011911177165944463, 0.37947922320673805, -0.01985196194324077, 1.3109272973387007e-05, 0.008358720818206641, 0.15978151211711022, 7.79, 0.37, -0.49> texture { Material180 } }
sphere { <-5.42, 1.22, 5.64>, 0.203 texture { Material181 } }
sphere { <0, 0, 0>, 1 matrix <0.24392251981228216, 0.006148074096015563, 7.425184656292305e-05, -0.013530802416230973, 0.5366728741092545, 0.012967018982221348, 6.9078562171244e-05, -0.005481402809989285, 0.22693379971125258, -5.42, 0.53, 5.64> texture { Material181 } }
sphere { <0.19, 0.89, -7.83>, 0.149 texture { Material182 } }
sphere { <0, 0, 0>, 1 matrix <0.20948865509252607, 0.014645930593007757, 1.0226898149478579e-05, -0.02747855549354789, 0.39304023580237074, 0.0005495711098709577, 8.08411948958783e-06, -0.0002315451884227893, 0.16599983831761023, 0.19, 0.39, -7.83> texture { Material182 } }
sphere { <5.16, 1.01, 5.91>, 0.169 texture { Material183 } }
sphere { <0, 0, 0>, 1 matrix <0.22198094472763688, 0.002908590146196254, -1.6768639679554544e-05, -0.005856485564638403, 0.4469319197349069, -0.005153707296881795, -1.4276004051512652e-05, 0.002179084293312437, 0.18898743711643468, 5.16, 0.44, 5.91> texture { Material183 } }
sphere { <-7.81, 0.86, -0.88>, 0.143 texture { Material184 } }
sphere { <0, 0, 0>, 1 matrix <0.174994801326774, 0.0013480799236036513, -4.67880590338645e-05, -0.002911852634983887, 0.37707921099821357, -0.026206673714854984, -4.2777653973818973e-05, 0.011092771942795761, 0.15961500111423563, -7.81, 0.37, -0.88> texture { Material184 } }
sphere { <6.36, 1.05, -4.64>, 0.176 texture { Material185 } }
sphere { <0, 0, 0>, 1 matrix <0.256, 0, 0, 0, 0.465, 0, 0, 0, 0.196, 6.36, 0.45, -4.64> texture { Material185 } }
sphere { <-1.56, 0.82, 7.73>, 0.137 texture { Material186 } }
sphere { <0, 0, 0>, 1 matrix <0.16261881623424054, 0.011140671204414566, 7.779260525703375e-05, -0.024810206424555135, 0.3621157502443162, 0.005063307433582682, 7.302005278727707e-05, -0.0021341213149811307, 0.15298509794841075, -1.56, 0.35, 7.73> texture { Material186 } }
sphere { <-4.08, 1.08, -6.77>, 0.18 texture { Material187 } }
sphere { <0, 0, 0>, 1 matrix <0.23376516684519702, -0.010479819085716552, -0.0001419921401134378, 0.02131792258461999, 0.4753476585431771, 0.012889906679072555, -0.00012196760753333761, -0.005443006811961311, 0.2009262521442822, -4.08, 0.47, -6.77> texture { Material187 } }
sphere { <7.59, 0.99, 2.24>, 0.165 texture { Material188 } }
sphere { <0, 0, 0>, 1 matrix <0.2209973611053577, -0.0010799549103391037, -9.04763877360791e-06, 0.0021354764516660104, 0.436933442783343, 0.007321633548569179, -7.5738152629749475e-06, -0.0030995473832615516, 0.1849740326333841, 7.59, 0.43, 2.24> texture { Material188 } }
sphere { <-7.12, 1.11, 3.48>, 0.186 texture { Material189 } }
sphere { <0, 0, 0>, 1 matrix <0.2598091434068813, 0.00995271817206882, 0.0003903884859245503, -0.01883360515637638, 0.49012779146113883, 0.03852328327440623, 0.0003123107887396402, -0.016286266099748974, 0.207361182477578, -7.12, 0.48, 3.48> texture { Material189 } }
sphere { <2.91, 0.84, -7.39>, 0.14 texture { Material190 } }
sphere { <0, 0, 0>, 1 matrix <0.20789060717515842, -0.006744890969484344, 4.352187654987307e-05, 0.012030550719609096, 0.3707739968240845, -0.004786348135758457, 3.2641407412404805e-05, 0.002012588434442909, 0.15598701363361012, 2.91, 0.36, -7.39> texture { Material190 } }
sphere { <2.85, 1.07, 7.42>, 0.179 texture { Material191 } }
sphere { <0, 0, 0>, 1 matrix <0.26144495176698557, 0.01704379746020873, -0.00021485738052171434, -0.030769909155262325, 0.4718477957728968, -0.011910932576230576, -0.00016401326757382772, 0.005036335127370223, 0.19993651099319723, 2.85, 0.46, 7.42> texture { Material191 } }
sphere { <-7.13, 0.98, -3.55>, 0.163 texture { Material192 } }
sphere { <0, 0, 0>, 1 matrix <0.2408825872225235, 0.007518246467234593, -0.00023482555495294726, -0.013445494719411243, 0.4299501056619842, -0.026890989438822486, -0.00017733714108479834, 0.011355359809433162, 0.1816453257178304, -7.13, 0.42, -3.55> texture { Material192 } }
sphere { <7.67, 1.06, -2.2>, 0.176 texture { Material193 } }
sphere { <0, 0, 0>, 1 matrix <0.2359295927819727, -0.005759251480765252, 0.0002413961760935562, 0.011396484921683783, 0.4652229240088452, -0.039073662588630105, 0.0002015044351289431, 0.01648289406843711, 0.1963091276509865, 7.67, 0.46, -2.2> texture { Material193 } }
sphere { <-4.18, 1.18, 6.82>, 0.197 texture { Material194 } }
sphere { <0, 0, 0>, 1 matrix <0.2987018247750969, -0.013348655419030273, 0.0001824130787642576, 0.023259697235166462, 0.520285987607133, -0.01422946183798419, 0.00013421698103055743, 0.006008601927747642, 0.21991789078807542, -4.18, 0.51, 6.82> texture { Material194 } }
sphere { <-1.53, 0.83, -7.86>, 0.138 texture { Material195 } }
sphere { <0, 0, 0>, 1 matrix <0.178894908277146, 0.006132811539083843, -2.0374925859450144e-05, -0.012539715213992662, 0.36577704268898903, -0.0024311692761822506, -1.764309222466353e-05, 0.001029593545924177, 0.15499657940048706, -1.53, 0.36, -7.86> texture { Material195 } }
sphere { <6.45, 0.98, 4.77>, 0.163 texture { Material196 } }
sphere { <0, 0, 0>, 1 matrix <0.216581213010586, -0.013463124485583067, -0.0005678467653071315, 0.026740122826204155, 0.4286389369037258, 0.0362577936626497, -0.0004762585773543683, -0.01531071565336948, 0.18135422565782458, 6.45, 0.42, 4.77> texture { Material196 } }
sphere { <-7.99, 1.11, 0.84>, 0.185 texture { Material197 } }
sphere { <0, 0, 0>, 1 matrix <0.23599092969144178, -0.0020671332897352953, 8.979605472624694e-05, 0.004291929288009724, 0.4881354020649553, -0.04249009995129626, 7.876179376412337e-05, 0.017949899367180257, 0.20622025824173518, -7.99, 0.48, 0.84> texture { Material197 } }
sphere { <5.33, 0.85, -6.02>, 0.141 texture { Material198 } }
sphere { <0, 0, 0>, 1 matrix <0.21292687452382067, 0.005580498592482512, 6.435041903781017e-05, -0.00977242241782149, 0.37277277847812273, 0.008599731727682912, 4.7734113652460124e-05, -0.0036427818042195715, 0.15795799397998583, 5.33, 0.37, -6.02> texture { Material198 } }
sphere { <0.14, 1.12, 8.06>, 0.186 texture { Material199 } }
sphere { <0, 0, 0>, 1 matrix <0.26199960575582676, -0.022917377325424915, -2.0007884883465052e-05, 0.042959190195568375, 0.49112398615923053, 0.0008591838039113675, -1.582372644775943e-05, -0.0003624953979991165, 0.20799968352547102, 0.14, 0.48, 8.06> texture { Material199 } }
sphere { <-5.55, 1.1, -5.86>, 0.183 texture { Material200 } }
sphere { <0, 0, 0>, 1 matrix <0.264808191232645, 0.01007913621681239, -0.0001812986979109093, -0.018408686524291305, 0.4833366948212137, -0.017399991372275343, -0.00013956579008990753, 0.007333880661041674, 0.20386808165046294, -5.55, 0.47, -5.86> texture { Material200 } }
sphere { <8.07, 1.2, 0.57>, 0.2 texture { Material201 } }
sphere { <0, 0, 0>, 1 matrix <0.25699923660908064, -0.0006263093628587275, -1.0905584562112884e-05, 0.0012916107483078815, 0.5296771383201208, 0.01845158211868402, -9.50525658332018e-06, -0.007798404518085321, 0.22386421062023829, 8.07, 0.52, 0.57> texture { Material201 } }
sphere { <-6.34, 1.1, 5.04>, 0.183 texture { Material202 } }
sphere { <0, 0, 0>, 1 matrix <0.24594197737803236, 0.005342137674932363, 7.299620183023891e-05, -0.01051054729539538, 0.4837051602772423, 0.013222946597432901, 6.0533435664100564e-05, -0.005573308069992379, 0.2039238450325516, -6.34, 0.47, 5.04> texture { Material202 } }
sphere { <1.28, 1.11, -8.01>, 0.185 texture { Material203 } }
sphere { <0, 0, 0>, 1 matrix <0.2346861386576962, -0.012141406380988918, 5.0725065422833485e-05, 0.025264458384270556, 0.4883298424949866, -0.00408314478937706, 4.468122784053843e-05, 0.0017284477942761786, 0.2069927787914601, 1.28, 0.48, -8.01> texture { Material203 } }
sphere { <4.48, 0.97, 6.78>, 0.161 texture { Material204 } }
sphere { <0, 0, 0>, 1 matrix <0.2089115303745129, -0.006080217081055267, -5.862445062396811e-05, 0.012422261691916743, 0.4267398831371539, 0.008231619193438807, -5.048995747518785e-05, -0.0034700034070702227, 0.17996654279926344, 4.48, 0.42, 6.78> texture { Material204 } }
sphere { <-7.89, 0.94, -1.98>, 0.157 texture { Material205 } }
sphere { <0, 0, 0>, 1 matrix <0.238, 0, 0, 0, 0.415, 0, 0, 0, 0.175, -7.89, 0.41, -1.98> texture { Material205 } }
sphere { <7.17, 1.07, -3.88>, 0.179 texture { Material206 } }
sphere { <0, 0, 0>, 1 matrix <0.21487990922936967, 0.007181652757444641, 0.0002201664128222588, -0.015799636066378207, 0.4718477957728968, 0.02896599945502672, 0.0002048059654160547, -0.012247779896417219, 0.19962452239673723, 7.17, 0.46, -3.88> texture { Material206 } }
sphere { <-2.67, 0.84, 7.72>, 0.139 texture { Material207 } }
sphere { <0, 0, 0>, 1 matrix <0.19457613535208704, -0.012849353005313664, 0.0001472371934855618, 0.02431492953313201, 0.3681011345458751, -0.008446238679930067, 0.00011778975478844943, 0.0035707675720029557, 0.15595908355886295, -2.67, 0.36, 7.72> texture { Material207 } }
sphere { <-3.25, 1.08, -7.5>, 0.181 texture { Material208 } }
sphere { <0, 0, 0>, 1 matrix <0.2444980742987671, 0.015673035458635316, -0.0002182285657534284, -0.030578412037664003, 0.47683561602419594, -0.013294961755506086, -0.00017992722564160222, 0.005618372959439811, 0.20192177077146017, -3.25, 0.47, -7.5> texture { Material208 } }
sphere { <7.48, 1.08, 3.35>, 0.179 texture { Material209 } }
sphere { <0, 0, 0>, 1 matrix <0.25789395035832013, 0.0073928996716279005, -0.00023537847299676243, -0.013610958697764545, 0.4738429238734165, -0.0302096888169896, -0.0001824639325556298, 0.01271986897557457, 0.19959501907652288, 7.48, 0.46, 3.35> texture { Material209 } }
sphere { <-7.78, 0.88, 2.59>, 0.146 texture { Material210 } }
sphere { <0, 0, 0>, 1 matrix <0.19797234903279526, 0.0033079117074905355, 8.208880888913507e-05, -0.006465463791913319, 0.3864696299500201, 0.019194345632242666, 6.799275079706136e-05, -0.00813403794234573, 0.16379814652107122, -7.78, 0.38, 2.59> texture { Material210 } }
sphere { <4, 1.16, -7.18>, 0.193 texture { Material211 } }
sphere { <0, 0, 0>, 1 matrix <0.24696860421850855, -0.022586967133854843, 0.0005809010723342667, 0.0465400814733864, 0.5082006885331877, -0.026212229795355556, 0.0005059460952588775, 0.011079924923281408, 0.2157150418543944, 4, 0.5, -7.18> texture { Material211 } }
sphere { <1.9, 1.03, 8.01>, 0.171 texture { Material212 } }
sphere { <0, 0, 0>, 1 matrix <0.25666653855644866, 0.013087464753510527, -7.90681773369154e-05, -0.023068566277588593, 0.452379179243822, -0.00546986623076843, -5.8762731016929346e-05, 0.0023062791392423183, 0.19098606656893413, 1.9, 0.44, 8.01> texture { Material212 } }
sphere { <-6.82, 0.96, -4.62>, 0.16 texture { Material213 } }
sphere { <0, 0, 0>, 1 matrix <0.2, 0, 0, 0, 0.424, 0, 0, 0, 0.179, -6.82, 0.41, -4.62> texture { Material213 } }
sphere { <8.17, 0.98, -1.2>, 0.164 texture { Material214 } }
sphere { <0, 0, 0>, 1 matrix <0.23299920361246498, -0.0006091701978066393, 5.256157731182801e-06, 0.0011320630714604066, 0.4329340520027174, -0.007471616271638685, 4.128226887581342e-06, 0.003157750063995102, 0.18297275370254196, 8.17, 0.42, -1.2> texture { Material214 } }
sphere { <-5.22, 0.83, 6.41>, 0.139 texture { Material215 } }
sphere { <0, 0, 0>, 1 matrix <0.17441982114777682, 0.014230474313880945, 0.0004686059960263984, -0.029924654557189647, 0.36598405749552454, 0.02416991329619163, 0.00041505102505195286, -0.010180262393776368, 0.15466476647976574, -5.22, 0.36, 6.41> texture { Material215 } }
sphere { <-0.48, 1.19, -8.27>, 0.198 texture { Material216 } }
sphere { <0, 0, 0>, 1 matrix <0.2689762539704776, 0.023489806874637947, -6.142476177134533e-05, -0.045674624478462676, 0.5230022164981665, -0.0027404774687077604, -5.050480412310616e-05, 0.0011588304724821387, 0.22199696971175262, -0.48, 0.51, -8.27> texture { Material216 } }
sphere { <5.95, 1.22, 5.78>, 0.203 texture { Material217 } }
sphere { <0, 0, 0>, 1 matrix <0.26468632678127546, 0.012885818619403114, -0.0003226353106881002, -0.026209268814559542, 0.5376870230900452, -0.026958105066404097, -0.00027637062462716505, 0.01135341345097167, 0.22671573307181206, 5.95, 0.53, 5.78> texture { Material217 } }
sphere { <-8.3, 0.96, -0.24>, 0.161 texture { Material218 } }
sphere { <0, 0, 0>, 1 matrix <0.22899987456234253, -0.00023965172332450965, -4.1812552490879354e-06, 0.0004447684821524742, 0.42474110148311567, 0.014825616071749141, -3.2683174217761593e-06, -0.006244200651395521, 0.1788910560859408, -8.3, 0.42, -0.24> texture { Material218 } }
sphere { <6.3, 0.87, -5.44>, 0.145 texture { Material219 } }
sphere { <0, 0, 0>, 1 matrix <0.20894621388146553, -0.004740859589981036, 6.288838474796417e-05, 0.008687795325180561, 0.3827666867483137, -0.010158037610980348, 4.8746020713733006e-05, 0.004296611208821974, 0.16194300465270395, 6.3, 0.37, -5.44> texture { Material219 } }
sphere { <-0.97, 1.02, 8.27>, 0.17 texture { Material220 } }
sphere { <0, 0, 0>, 1 matrix <0.2237852736765712, 0.023348010750720568, 0.0001472395543550075, -0.046696021501441136, 0.447534852915723, 0.005660123818356501, 0.0001243356236775619, -0.0023898300566394114, 0.1899849290153118, -0.97, 0.44, 8.27> texture { Material220 } }
sphere { <-4.88, 0.95, -6.77>, 0.158 texture { Material221 } }
sphere { <0, 0, 0>, 1 matrix <0.21964573314116226, -0.012477482242455781, -0.00025367256558751663, 0.023763932089040783, 0.4179793370588663, 0.017016148903263768, -0.00020409110958632016, -0.007188206099946746, 0.17685386068696288, -4.88, 0.41, -6.77> texture { Material221 } }
sphere { <8.18, 1.11, 1.7>, 0.185 texture { Material222 } }
sphere { <0, 0, 0>, 1 matrix <0.2799931799906177, 0.001953981058200222, -3.341804597363513e-05, -0.0034124883480711014, 0.4887021144123378, -0.016721192905548396, -2.4586133823460127e-05, 0.007044101714811798, 0.20587952794426503, 8.18, 0.48, 1.7> texture { Material222 } }
sphere { <-7.19, 0.89, 4.28>, 0.148 texture { Material223 } }
sphere { <0, 0, 0>, 1 matrix <0.21686246959642885, 0.007721107202218167, 0.00023191401386507971, -0.013947806558845722, 0.3910451077018511, 0.023519830667857494, 0.00017634014879142008, -0.009899928724991037, 0.164702642102038, -7.19, 0.38, 4.28> texture { Material223 } }
sphere { <2.41, 0.92, -8.03>, 0.153 texture { Material224 } }
sphere { <0, 0, 0>, 1 matrix <0.23386937373601163, 0.007817574510854432, 3.946001724649013e-05, -0.013563825860713247, 0.4057526757697529, 0.004097405728757127, 2.8836166449358175e-05, -0.0017257546295996763, 0.17099128907471844, 2.41, 0.4, -8.03> texture { Material224 } }
sphere { <3.65, 1.2, 7.56>, 0.2 texture { Material225 } }
sphere { <0, 0, 0>, 1 matrix <0.2869644121952018, -0.004519496029225913, -1.700306229246967e-05, 0.008330360276865883, 0.528919430737731, 0.003980061021169256, -1.3211438645368422e-05, -0.0016777950996611417, 0.22299368786820276, 3.65, 0.52, 7.56> texture { Material225 } }
sphere { <-7.81, 1.05, -3.11>, 0.174 texture { Material226 } }
sphere { <0, 0, 0>, 1 matrix <0.20996067128634383, -0.004062848880059235, -9.885325324390123e-05, 0.008918920636701463, 0.4603682155218586, 0.02241782754630368, -9.179230658362256e-05, -0.00948259516600698, 0.19476927879696548, -7.81, 0.45, -3.11> texture { Material226 } }
sphere { <7.87, 1.09, -2.98>, 0.181 texture { Material227 } }
sphere { <0, 0, 0>, 1 matrix <0.2709949745154103, 0.0016503348819831253, 1.3497015755204048e-05, -0.0029170125773797673, 0.4789270459799114, 0.00783426235067709, 1.006050620867608e-05, -0.0033038016593669567, 0.20197298035475386, 7.87, 0.47, -2.98> texture { Material227 } }
sphere { <-3.8, 1.08, 7.53>, 0.179 texture { Material228 } }
sphere { <0, 0, 0>, 1 matrix <0.2728675552225402, 0.00850251858963997, 6.696646051340862e-05, -0.014793759450838771, 0.47471064283407044, 0.007479990733570166, 4.905967803180119e-05, -0.0031494697825558597, 0.19997519454481538, -3.8, 0.46, 7.53> texture { Material228 } }
sphere { <-2.29, 1.21, -8.13>, 0.202 texture { Material229 } }
sphere { <0, 0, 0>, 1 matrix <0.2656621784566424, 0.013401414489978773, -9.501230906932832e-05, -0.02690359149491979, 0.5332681715589425, -0.007566635107946191, -8.036755466390554e-05, 0.003188188949977328, 0.22497739662525076, -2.29, 0.52, -8.13> texture { Material229 } }
sphere { <7.19, 0.88, 4.45>, 0.147 texture { Material230 } }
sphere { <0, 0, 0>, 1 matrix <0.18287520503726448, -0.006754207978153841, -0.00020014286476450406, 0.014394213723934417, 0.3890499796013315, 0.023085059745932553, -0.00017936300448840803, -0.009707563585469075, 0.16371234235129217, 7.19, 0.38, 4.45> texture { Material230 } }
sphere { <-8.32, 1.21, 1.58>, 0.201 texture { Material231 } }
sphere { <0, 0, 0>, 1 matrix <0.2739863965680596, -0.002729390502095482, 7.016507000837784e-05, 0.0053093618161200425, 0.5322695420241879, -0.02738512936735601, 5.7617302014178885e-05, 0.011560326656013325, 0.22470281602119002, -8.32, 0.52, 1.58> texture { Material231 } }
sphere { <5.08, 1.19, -6.79>, 0.199 texture { Material232 } }
sphere { <0, 0, 0>, 1 matrix <0.2389767034511216, -0.003336900110808608, 1.747241165879355e-05, 0.007343972628808902, 0.5259198876522618, -0.005507979471606676, 1.6229604134946313e-05, 0.0023246605374461636, 0.2219878277968988, 5.08, 0.51, -6.79> texture { Material232 } }
sphere { <0.84, 0.92, 8.45>, 0.153 texture { Material233 } }
sphere { <0, 0, 0>, 1 matrix <0.2209666738906559, -0.0038378403554903667, -3.332610934408855e-06, 0.00705051214628547, 0.4059381642334949, 0.0007050512146285471, -2.5786265601082093e-06, -0.0002969550682302501, 0.170999742137344, 0.84, 0.4, 8.45> texture { Material233 } }
sphere { <-6.34, 0.85, -5.67>, 0.141 texture { Material234 } }
sphere { <0, 0, 0>, 1 matrix <0.17270781233477903, -0.010045127176497222, -0.0003270757446503167, 0.02165799096435528, 0.3715806223882211, 0.0242440197362186, -0.0002987165760390175, -0.010269584767620746, 0.15766561577309066, -6.34, 0.36, -5.67> texture { Material234 } }
sphere { <8.52, 1.14, -0.1>, 0.191 texture { Material235 } }
sphere { <0, 0, 0>, 1 matrix <0.22499999657348368, 3.926595123540612e-05, 3.426516329563479e-07, -8.795573076730972e-05, 0.5039232383588212, 0.008795573076730972, 3.2437687919867603e-07, -0.0037171767169517796, 0.2129675623120801, 8.52, 0.49, -0.1> texture { Material235 } }
sphere { <-6.22, 0.9, 5.84>, 0.15 texture { Material236 } }
sphere { <0, 0, 0>, 1 matrix <0.2149847869603816, 0.0025575591638709403, 1.6331645472707083e-05, -0.004710667111129732, 0.39593968728193096, 0.005057039692830447, 1.2685510669498062e-05, -0.0021326404765219307, 0.16698638173119304, -6.22, 0.39, 5.84> texture { Material236 } }
sphere { <0.64, 1, -8.52>, 0.167 texture { Material237 } }
sphere { <0, 0, 0>, 1 matrix <0.243, 0, 0, 0, 0.441, 0, 0, 0, 0.186, 0.64, 0.43, -8.52> texture { Material237 } }
sphere { <5.29, 0.85, 6.73>, 0.141 texture { Material238 } }
sphere { <0, 0, 0>, 1 matrix <0.17972865669617066, -0.009877480104837981, -0.00021295297262554228, 0.020468333772803153, 0.37209139074691444, 0.016063755619161967, -0.00018574231501227858, -0.006761419925491766, 0.15685422755024353, 5.29, 0.36, 6.73> texture { Material238 } }
sphere { <-8.46, 1.06, -1.39>, 0.177 texture { Material239 } }
sphere { <0, 0, 0>, 1 matrix <0.22497820568858354, -0.0031287026068447825, -0.0001348523018894191, 0.006521606767156457, 0.46721531340502864, 0.04035244187178058, -0.00011867002566268883, -0.01703578569426984, 0.19726572921621213, -8.46, 0.46, -1.39> texture { Material239 } }
sphere { <7.18, 1.03, -4.69>, 0.172 texture { Material240 } }
sphere { <0, 0, 0>, 1 matrix <0.2475923346796229, -0.014200287217294343, 0.0006226161256668182, 0.026167464751223852, 0.4544965061833009, -0.03996485525641461, 0.00048453593650683846, 0.016877936683781226, 0.19225998147878956, 7.18, 0.45, -4.69> texture { Material240 } }
sphere { <-2.13, 0.91, 8.33>, 0.151 texture { Material241 } }
sphere { <0, 0, 0>, 1 matrix <0.2187185627923826, 0.011098875107673456, 7.253536278799097e-05, -0.020271918004883024, 0.39945181390182954, 0.00522472113527913, 5.59747776765775e-05, -0.0022074446796554324, 0.1689855735109081, -2.13, 0.39, 8.33> texture { Material241 } }
sphere { <-4.06, 0.87, -7.59>, 0.145 texture { Material242 } }
sphere { <0, 0, 0>, 1 matrix <0.17049371324081622, 0.013146125949946052, -0.00027040315547316516, -0.02959800286976158, 0.38353495876532206, -0.015808024259986297, -0.00025775271545102875, 0.006692747933448744, 0.1628623366178841, -4.06, 0.38, -7.59> texture { Material242 } }
sphere { <8.13, 0.98, 2.86>, 0.163 texture { Material243 } }
sphere { <0, 0, 0>, 1 matrix <0.20699654075418025, -0.0011966698414224966, -9.853609304682757e-06, 0.0025031789436518893, 0.4329340520027174, 0.007130267294038713, -8.711161849067365e-06, -0.0030134847917068926, 0.18297518638746024, 8.13, 0.42, 2.86> texture { Material243 } }
sphere { <-7.94, 1.19, 3.39>, 0.199 texture { Material244 } }
sphere { <0, 0, 0>, 1 matrix <0.28294092066383203, -0.005780656610021399, 0.00013936663916541927, 0.010744259282230589, 0.5252791352809059, -0.02534543215295421, 0.00010932648019336778, 0.010697121555049115, 0.22174210163646693, -7.94, 0.51, 3.39> texture { Material244 } }
sphere { <3.57, 1.09, -7.87>, 0.181 texture { Material245 } }
sphere { <0, 0, 0>, 1 matrix <0.27468671690004237, -0.013122028634573235, 0.00014114952855233718, 0.022856188058038466, 0.4783435471474409, -0.010297842971204143, 0.00010368074460935314, 0.004342722923138282, 0.20195328669748372, 3.57, 0.47, -7.87> texture { Material245 } }
sphere { <2.69, 1.11, 8.23>, 0.184 texture { Material246 } }
sphere { <0, 0, 0>, 1 matrix <0.24216429877003354, 0.020134001950949033, -0.00027270250662063655, -0.04043371585211164, 0.4861430126687718, -0.01319415990963643, -0.00023117990273189765, 0.005569665863494067, 0.20592456234752957, 2.69, 0.48, 8.23> texture { Material246 } }
sphere { <-7.55, 0.9, -4.25>, 0.149 texture { Material247 } }
sphere { <0, 0, 0>, 1 matrix <0.1918873667660358, 0.006572555288016059, -0.00019998145622215986, -0.013555895281533122, 0.3950353639028904, -0.024068630397824115, -0.00017394220410989946, 0.01015015473847633, 0.16669116384168242, -7.55, 0.39, -4.25> texture { Material247 } }
sphere { <8.45, 0.87, -1.97>, 0.145 texture { Material248 } }
sphere { <0, 0, 0>, 1 matrix <0.18799390385678236, -0.0015137541715726922, 2.570982139612626e-05, 0.003083871530384793, 0.3827666867483137, -0.01300589297597065, 2.215420779878965e-05, 0.005501187107329622, 0.16190656703667466, 8.45, 0.37, -1.97> texture { Material248 } }
sphere { <-4.91, 0.98, 7.17>, 0.163 texture { Material249 } }
sphere { <0, 0, 0>, 1 matrix <0.21045865583509848, 0.015100085504190732, 0.0003763002121876325, -0.030987379257415102, 0.43135230427372584, 0.021540007532593424, 0.0003263646390063353, -0.009103513576130708, 0.18277313677532486, -4.91, 0.42, 7.17> texture { Material249 } }
sphere { <-1.22, 1.07, -8.62>, 0.178 texture { Material250 } }
sphere { <0, 0, 0>, 1 matrix <0.25339339953741324, -0.01754359462428644, -8.578188359812445e-05, 0.032600695522296066, 0.470850231722637, 0.0046101993667893425, -6.720706628356995e-05, -0.0019437069364217781, 0.19899049597042456, -1.22, 0.46, -8.62> texture { Material250 } }
sphere { <6.73, 1.03, 5.54>, 0.171 texture { Material251 } }
sphere { <0, 0, 0>, 1 matrix <0.2439392696162327, 0.00544310576996923, -7.306624297003936e-05, -0.010105438171295333, 0.4527240446396504, -0.0121581052998397, -5.719529675113736e-05, 0.005126265148497533, 0.19093118690859628, 6.73, 0.44, 5.54> texture { Material251 } }
sphere { <-8.72, 0.93, 0.47>, 0.156 texture { Material252 } }
sphere { <0, 0, 0>, 1 matrix <0.21899925154142458, -0.0005723637128202832, 1.4969171508644912e-05, 0.001076775569324003, 0.4114353683188844, -0.02153551138648006, 1.1893314349334316e-05, 0.009095094614678471, 0.1737621337130133, -8.72, 0.4, 0.47> texture { Material252 } }
sphere { <6.12, 1.05, -6.24>, 0.175 texture { Material253 } }
sphere { <0, 0, 0>, 1 matrix <0.2649795333759272, -0.003293400174528498, 2.017836176188295e-05, 0.005741701436347797, 0.46192963516225277, -0.005660832402033039, 1.4848228466291229e-05, 0.0023893123774814777, 0.1949853609015121, 6.12, 0.45, -6.24> texture { Material253 } }
sphere { <-0.3, 1.13, 8.75>, 0.188 texture { Material254 } }
sphere { <0, 0, 0>, 1 matrix <0.2595715003408126, 0.02726966032552241, 4.2854989775622085e-05, -0.05192728422139707, 0.49427738199803184, 0.001557818526641912, 3.4481026256247655e-05, -0.0006582331802712304, 0.2099989655692123, -0.3, 0.49, 8.75> texture { Material254 } }
sphere { <-5.7, 1.18, -6.66>, 0.197 texture { Material255 } }
sphere { <0, 0, 0>, 1 matrix <0.2845990437931919, -0.015108496807021869, -0.00034292307161219016, 0.027672404678124266, 0.5207284342356282, 0.023667188211553652, -0.00026471254650765555, -0.009974677024026444, 0.2197736011115395, -5.7, 0.51, -6.66> texture { Material255 } }
sphere { <8.71, 1, 1.07>, 0.167 texture { Material256 } }
sphere { <0, 0, 0>, 1 matrix <0.20199287512256991, -0.0016955661595479754, -5.878023879823312e-05, 0.003710100210496065, 0.4409233102148423, 0.03060832673659254, -5.441536958054254e-05, -0.01294967669625069, 0.18655107320096054, 8.71, 0.43, 1.07> texture { Material256 } }
sphere { <-7.15, 1.17, 5.11>, 0.195 texture { Material257 } }
sphere { <0, 0, 0>, 1 matrix <0.2458857309530417, 0.00749545509433097, 0.00015958263454518733, -0.015691704770652234, 0.5142942103986056, 0.02191427735211778, 0.00014077004754595794, -0.009233782884290404, 0.21680340734739273, -7.15, 0.5, 5.11> texture { Material257 } }
sphere { <1.83, 1.17, -8.61>, 0.195 texture { Material258 } }
sphere { <0, 0, 0>, 1 matrix <0.2716435988138334, 0.013919389025212845, 7.637168274999286e-05, -0.026405899768418485, 0.5152928399333601, 0.005658407093232532, 6.120965749815603e-05, -0.0023905673378385502, 0.21798688364482183, 1.83, 0.5, -8.61> texture { Material258 } }
sphere { <4.47, 1.1, 7.59>, 0.183 texture { Material259 } }
sphere { <0, 0, 0>, 1 matrix <0.2257708585399751, -0.010173542601238273, -0.00013588621466592495, 0.02183260248495824, 0.4843353243559683, 0.01294724100852175, -0.0001232596194978523, -0.005472545168550429, 0.20492690417913498, 4.47, 0.47, 7.59> texture { Material259 } }
sphere { <-8.44, 0.91, -2.58>, 0.151 texture { Material260 } }
sphere { <0, 0, 0>, 1 matrix <0.19698996460654697, 0.001988150070357522, -3.3220612810079296e-05, -0.004026760802399245, 0.39875693998061923, -0.013329966794149224, -2.8498901344687317e-05, 0.00564602603561709, 0.16890565880934175, -8.44, 0.39, -2.58> texture { Material260 } }
sphere { <7.98, 1.2, -3.8>, 0.201 texture { Material261 } }
sphere { <0, 0, 0>, 1 matrix <0.27287640854337153, 0.008209673881203717, 0.0002586797929433246, -0.01596826677992371, 0.5297065106879667, 0.03342195372542172, 0.00021225008651759965, -0.01409890326646792, 0.22355575563287014, 7.98, 0.52, -3.8> texture { Material261 } }
sphere { <-3.32, 0.94, 8.2>, 0.156 texture { Material262 } }
sphere { <0, 0, 0>, 1 matrix <0.20856045891153113, -0.013546379541409975, 0.00017487118573492633, 0.026833498230352772, 0.4129915168075672, -0.010675692844333897, 0.00014642324164407705, 0.00451267209603486, 0.17494174559203407, -3.32, 0.4, 8.2> texture { Material262 } }
sphere { <-3.1, 1.18, -8.3>, 0.197 texture { Material263 } }
sphere { <0, 0, 0>, 1 matrix <0.238, 0, 0, 0, 0.523, 0, 0, 0, 0.221, -3.1, 0.51, -8.3> texture { Material263 } }
sphere { <7.9, 1.03, 4.03>, 0.172 texture { Material264 } }
sphere { <0, 0, 0>, 1 matrix <0.218891385198972, 0.006893137151345733, -0.00021481593981092855, -0.014352833520610295, 0.45488920691847984, -0.028386715185207023, -0.00018833178284793735, 0.011952301130613484, 0.1916275215850341, 7.9, 0.45, 4.03> texture { Material264 } }
sphere { <-8.56, 0.97, 2.37>, 0.161 texture { Material265 } }
sphere { <0, 0, 0>, 1 matrix <0.21397850167912738, 0.0030323219346451028, 7.643847421367015e-05, -0.00605047414062364, 0.42641481134020304, 0.021512796944439607, 6.429404373112443e-05, -0.009068626346602176, 0.17977139895562266, -8.56, 0.42, 2.37> texture { Material265 } }
sphere { <4.72, 0.97, -7.54>, 0.162 texture { Material266 } }
sphere { <0, 0, 0>, 1 matrix <0.19066498407985857, -0.01130576002941825, 0.00020889227961759713, 0.02539356572052581, 0.42795497756146456, -0.015833635096327858, 0.0001979555110512308, 0.00668039149751828, 0.18087656891663864, 4.72, 0.42, -7.54> texture { Material266 } }
sphere { <1.61, 0.83, 8.76>, 0.138 texture { Material267 } }
sphere { <0, 0, 0>, 1 matrix <0.16412561107114101, -0.0169634311831858, -0.00016060204815777362, 0.03752516595068374, 0.36300049180941973, 0.00689237741951334, -0.00014989524494725536, -0.002908016774260423, 0.15397246822031582, 1.61, 0.36, 8.76> texture { Material267 } }
sphere { <-7.12, 0.96, -5.38>, 0.16 texture { Material268 } }
sphere { <0, 0, 0>, 1 matrix <0.19, 0, 0, 0, 0.424, 0, 0, 0, 0.179, -7.12, 0.41, -5.38> texture { Material268 } }
sphere { <8.89, 1.08, -0.84>, 0.18 texture { Material269 } }
sphere { <0, 0, 0>, 1 matrix <0.2209989182813678, -0.00069135664215283, 1.2019095913287659e-05, 0.0014890758446368644, 0.47571003366108955, -0.016545287162631827, 1.0931394925659818e-05, 0.0069865603354810875, 0.20087854005638156, 8.89, 0.47, -0.84> texture { Material269 } }
sphere { <-5.99, 1, 6.64>, 0.167 texture { Material270 } }
sphere { <0, 0, 0>, 1 matrix <0.20956086854165415, 0.01356776682701341, 0.00039759199606988205, -0.02855691875019013, 0.44031805655655154, 0.025855588598145123, 0.00035404620602413303, -0.010938902868446013, 0.18667944465130248, -5.99, 0.43, 6.64> texture { Material270 } }
sphere { <-0.06, 0.96, -8.96>, 0.161 texture { Material271 } }
sphere { <0, 0, 0>, 1 matrix <0.20450068023524043, -0.014299362167310632, -4.993197647595637e-06, 0.02971477211353331, 0.4249622854106851, 0.00029714772113533314, -4.384271105205925e-06, -0.00012555537512760553, 0.17999995615728892, -0.06, 0.42, -8.96> texture { Material271 } }
sphere { <6.1, 1.08, 6.57>, 0.18 texture { Material272 } }
sphere { <0, 0, 0>, 1 matrix <0.2622286032803989, -0.020115747344538335, -0.0007185613278476273, 0.036483693853022, 0.47438694409066634, 0.03398481071240405, -0.0005518988145445655, -0.014391890490368174, 0.2014859024741229, 6.1, 0.47, 6.57> texture { Material272 } }
sphere { <-8.95, 1.03, -0.72>, 0.171 texture { Material273 } }
sphere { <0, 0, 0>, 1 matrix <0.2189947004062454, 0.0015221056432226808, -6.624492193225162e-05, -0.003148465097624997, 0.45127619823556075, -0.039355813720312466, -5.777525154821946e-05, 0.016593731612758678, 0.19027780935564728, -8.95, 0.44, -0.72> texture { Material273 } }
sphere { <7.1, 0.84, -5.52>, 0.14 texture { Material274 } }
sphere { <0, 0, 0>, 1 matrix <0.1719608634794364, -0.0036686322297556466, 5.068500204137057e-05, 0.00789182514540459, 0.3697746059970654, -0.0102205604342125, 4.597011813054541e-05, 0.004309209264154459, 0.15594046492897848, 7.1, 0.36, -5.52> texture { Material274 } }
sphere { <-1.5, 0.86, 8.88>, 0.143 texture { Material275 } }
sphere { <0, 0, 0>, 1 matrix <0.1745859187219419, 0.012031289544912805, 7.110486592916534e-05, -0.025987585417011662, 0.37707921099821357, 0.004462514667567659, 6.501016313523689e-05, -0.0018888950973831363, 0.15998883663865354, -1.5, 0.37, 8.88> texture { Material275 } }
sphere { <-4.89, 0.86, -7.57>, 0.144 texture { Material276 } }
sphere { <0, 0, 0>, 1 matrix <0.1949789852306039, 0.0028627147845203885, -1.3509494611792445e-05, -0.005578623682655116, 0.3799421241594287, -0.00358625808170686, -1.1084713527624568e-05, 0.0015100034028239413, 0.15999287411273225, -4.89, 0.37, -7.57> texture { Material276 } }
sphere { <8.73, 0.89, 2.28>, 0.148 texture { Material277 } }
sphere { <0, 0, 0>, 1 matrix <0.21898130531886906, -0.0028605348215653237, -7.253536278799096e-05, 0.005120226712573547, 0.39146277762379295, 0.019866479644785363, -5.4649930867664436e-05, -0.008362166177014248, 0.16478795826823348, 8.73, 0.38, 2.28> texture { Material277 } }
sphere { <-7.99, 0.98, 4.22>, 0.164 texture { Material278 } }
sphere { <0, 0, 0>, 1 matrix <0.2239318669616316, 0.005522923629903802, 0.00012756824205149283, -0.010676008623876545, 0.4324065885487305, 0.019989122529811405, 0.00010421869774742494, -0.008448058713523065, 0.1828048671191112, -7.99, 0.42, 4.22> texture { Material278 } }
sphere { <3.04, 1.04, -8.52>, 0.173 texture { Material279 } }
sphere { <0, 0, 0>, 1 matrix <0.20575034600008318, -0.010138390734573321, 9.030038294862867e-05, 0.02254069396327467, 0.45737232691759483, -0.008153016965439774, 8.460181509264725e-05, 0.0034356599876198173, 0.19296939934347712, 3.04, 0.45, -8.52> texture { Material279 } }
sphere { <3.52, 0.96, 8.35>, 0.16 texture { Material280 } }
sphere { <0, 0, 0>, 1 matrix <0.237, 0, 0, 0, 0.425, 0, 0, 0, 0.179, 3.52, 0.42, 8.35> texture { Material280 } }
sphere { <-8.24, 1.01, -3.79>, 0.168 texture { Material281 } }
sphere { <0, 0, 0>, 1 matrix <0.21899414257859995, 0.0016016726258306017, -1.2691079700118701e-05, -0.003261853840732641, 0.4459320720397505, -0.007067349988254057, -1.0894625495992308e-05, 0.0029790623268873603, 0.18797639497809202, -8.24, 0.44, -3.79> texture { Material281 } }
sphere { <8.65, 1.11, -2.78>, 0.184 texture { Material282 } }
sphere { <0, 0, 0>, 1 matrix <0.2649650501169912, 0.004302411548270966, 0.00010710448018843542, -0.007922931454929174, 0.487331212960232, 0.024279951232847465, 8.325857705214224e-05, -0.010249323676161019, 0.20574485274774343, 8.65, 0.48, -2.78> texture { Material282 } }
sphere { <-4.5, 1.2, 7.9>, 0.2 texture { Material283 } }
sphere { <0, 0, 0>, 1 matrix <0.24897050913800925, 0.02265690879909532, 0.000591661414937213, -0.0479420190188857, 0.5261020826498166, 0.02755288449361247, 0.000527761982123994, -0.011614921062524727, 0.2226966885160207, -4.5, 0.52, 7.9> texture { Material283 } }
sphere { <-2.02, 0.86, -8.88>, 0.143 texture { Material284 } }
sphere { <0, 0, 0>, 1 matrix <0.19754082250809674, -0.013476379973934537, -0.00010308066144767727, 0.025659571970572326, 0.3760816469479537, 0.005760312075026441, -8.277689479889232e-05, -0.002429415437477995, 0.15898141743177985, -2.02, 0.37, -8.88> texture { Material284 } }
sphere { <7.5, 0.86, 5.19>, 0.143 texture { Material285 } }
sphere { <0, 0, 0>, 1 matrix <0.19099052299794997, -0.0019026137534955865, -1.3633581896540296e-05, 0.0037853048498865073, 0.3799421241594287, 0.005445526275275327, -1.1420801588724855e-05, -0.0022928531685369796, 0.15998357007490746, 7.5, 0.37, 5.19> texture { Material285 } }
sphere { <-9.05, 1.18, 1.24>, 0.196 texture { Material286 } }
sphere { <0, 0, 0>, 1 matrix <0.23899928632908932, -0.0005840451327329097, 5.046672868337139e-06, 0.0012682821083195822, 0.5189209537861671, -0.008968566337402761, 4.624357147137379e-06, 0.003784423945840471, 0.21896729918874525, -9.05, 0.51, 1.24> texture { Material286 } }
sphere { <5.84, 1.03, -7.03>, 0.171 texture { Material287 } }
sphere { <0, 0, 0>, 1 matrix <0.20852963773387187, 0.014008474018319242, 0.0003909504549636401, -0.030429890929746108, 0.4522723929336525, 0.025292376876672094, 0.00035915065719147797, -0.010696335595420797, 0.19170148516804864, 5.84, 0.44, -7.03> texture { Material287 } }
sphere { <0.44, 1.19, 9.14>, 0.198 texture { Material288 } }
sphere { <0, 0, 0>, 1 matrix <0.2878249956922689, 0.01003851473969735, -8.750215386554638e-06, -0.018264519873616016, 0.5236807933580062, -0.0009132259936808007, -6.714575001488108e-06, 0.0003851582912279713, 0.22099966427124992, 0.44, 0.51, 9.14> texture { Material288 } }
sphere { <-6.51, 1.09, -6.45>, 0.181 texture { Material289 } }
sphere { <0, 0, 0>, 1 matrix <0.2682736455371614, -0.019741031829699385, -0.0007367309551649121, 0.035152246269241655, 0.4763759878814029, 0.03565442121594511, -0.000553232910569934, -0.01503589370693301, 0.20143886376213624, -6.51, 0.47, -6.45> texture { Material289 } }
sphere { <9.17, 1.21, 0.36>, 0.202 texture { Material290 } }
sphere { <0, 0, 0>, 1 matrix <0.2809993848231087, -0.0005877861072261392, -1.537942228293741e-05, 0.0011190945457864216, 0.5342668010936971, 0.027977363644660535, -1.2369215074533291e-05, -0.011818475109707067, 0.22569076962313667, 9.17, 0.52, 0.36> texture { Material290 } }
sphere { <-7.01, 0.88, 5.94>, 0.147 texture { Material291 } }
sphere { <0, 0, 0>, 1 matrix <0.1759547064264973, -0.00399230281261561, 5.2958639787759294e-05, 0.008801213018720777, 0.38776364088340914, -0.010290649068042754, 4.93478234385939e-05, 0.004349655791646937, 0.16394230100644105, -7.01, 0.38, 5.94> texture { Material291 } }
sphere { <1.16, 1.18, -9.13>, 0.197 texture { Material292 } }
sphere { <0, 0, 0>, 1 matrix <0.2729750211297124, 0.023677409569200024, 0.00013459318498726527, -0.04493522983935771, 0.5180212430077077, 0.005900585736481316, 0.00010806752079269476, -0.0024964016577420953, 0.21998580931545147, 1.16, 0.51, -9.13> texture { Material292 } }
sphere { <5.32, 1.03, 7.52>, 0.172 texture { Material293 } }
sphere { <0, 0, 0>, 1 matrix <0.2437771151836142, -0.01042560593720986, -0.0001576502359801974, 0.01948391929249056, 0.4553750678480857, 0.013781308767859175, -0.0001246987522302381, -0.005832878491659694, 0.19291179844354447, 5.32, 0.45, 7.52> texture { Material293 } }
sphere { <-9.01, 0.94, -1.96>, 0.157 texture { Material294 } }
sphere { <0, 0, 0>, 1 matrix <0.1969670887791057, -0.0035975476810491125, -0.0001535856975068164, 0.007615113619276547, 0.4154131891042579, 0.035537196889957226, -0.0001372136180771558, -0.014998912836049092, 0.17535966978230658, -9.01, 0.41, -1.96> texture { Material294 } }
sphere { <7.98, 0.87, -4.65>, 0.144 texture { Material295 } }
sphere { <0, 0, 0>, 1 matrix <0.20387446095720596, 0.007152450270573767, 0.00021592715360572087, -0.01339331374195676, 0.38106946719925283, 0.023036499636165626, 0.0001704130967182405, -0.009709100631996507, 0.16070688947364464, 7.98, 0.37, -4.65> texture { Material295 } }
sphere { <-2.75, 0.85, 8.83>, 0.142 texture { Material296 } }
sphere { <0, 0, 0>, 1 matrix <0.18789586057463978, -0.006256556354553281, 3.288613432428118e-05, 0.01247983315402915, 0.3747715601321609, -0.003940999943377627, 2.763834693210865e-05, 0.0016604746428097732, 0.1579912721009688, -2.75, 0.37, 8.83> texture { Material296 } }
sphere { <-3.94, 1.02, -8.38>, 0.17 texture { Material297 } }
sphere { <0, 0, 0>, 1 matrix <0.2088963444628231, -0.006581399350597967, -4.9524312206731797e-05, 0.014170477070665481, 0.4497258721585931, 0.006770339044873507, -4.5022102006119816e-05, -0.0028585875967243697, 0.18997848944015264, -3.94, 0.44, -8.38> texture { Material297 } }
sphere { <8.58, 1.2, 3.52>, 0.199 texture { Material298 } }
sphere { <0, 0, 0>, 1 matrix <0.27499400770302224, -0.0018153546092804498, -1.466535839305902e-05, 0.0034854808498184634, 0.5279195830425746, 0.0085302557640294, -1.1892272442371496e-05, -0.0036027405973078712, 0.22297089522796998, 8.58, 0.52, 3.52> texture { Material298 } }
sphere { <-8.71, 0.88, 3.2>, 0.147 texture { Material299 } }
sphere { <0, 0, 0>, 1 matrix <0.20698464655216847, -0.0025207918102827576, 4.1234974176047405e-05, 0.004749317903431283, 0.38976242253744736, -0.012755310940644018, 3.286845767655953e-05, 0.005396477705657084, 0.1649117247136687, -8.71, 0.38, 3.2> texture { Material299 } }
sphere { <4.26, 0.94, -8.26>, 0.157 texture { Material300 } }
sphere { <0, 0, 0>, 1 matrix <0.22601863114866447, -0.021078925426657843, 0.0005072243501284884, 0.03844350276051254, 0.41173206468246515, -0.01986967558408513, 0.00039103198798451746, 0.008399017457040817, 0.17479789357924394, 4.26, 0.41, -8.26> texture { Material300 } }
sphere { <2.44, 1.18, 8.98>, 0.197 texture { Material301 } }
sphere { <0, 0, 0>, 1 matrix <0.2334681958196685, 0.015766458749621133, -0.00014254545039814274, -0.03503657499915808, 0.5187333061351086, -0.009391246906990825, -0.00013401709011791197, 0.003973219845265349, 0.21996407789337047, 2.44, 0.51, 8.98> texture { Material301 } }
sphere { <-7.87, 0.97, -4.98>, 0.162 texture { Material302 } }
sphere { <0, 0, 0>, 1 matrix <0.19892365181004526, -0.0055105133813789, -0.00012244521030479682, 0.01187944844528416, 0.4284120704097122, 0.019051945619795348, -0.00011136976414657398, -0.00803823346662694, 0.18082138811410456, -7.87, 0.42, -4.98> texture { Material302 } }
sphere { <9.18, 1.07, -1.65>, 0.178 texture { Material303 } }
sphere { <0, 0, 0>, 1 matrix <0.2349988319408952, -0.0007409088827265624, 6.359432903864133e-06, 0.0014818177654531248, 0.4699284167235039, -0.008067674500800346, 5.3581604892131846e-06, 0.003398722449273338, 0.19797082779289207, 9.18, 0.46, -1.65> texture { Material303 } }
sphere { <-5.66, 1.02, 7.42>, 0.17 texture { Material304 } }
sphere { <0, 0, 0>, 1 matrix <0.25577814739076116, -0.010654140104198632, 0.0001691626145446103, 0.01868636291712963, 0.4483846611048037, -0.014248351724311343, 0.00012488958651926308, 0.005997635803774708, 0.18890477169027906, -5.66, 0.44, 7.42> texture { Material304 } }
sphere { <-0.84, 1.15, -9.31>, 0.191 texture { Material305 } }
sphere { <0, 0, 0>, 1 matrix <0.27395860378221526, -0.0047627092939474475, -3.7256596006262197e-06, 0.008812750408873561, 0.5069227814442904, 0.0007931475367986204, -2.909821731875952e-06, -0.0003347802226329482, 0.21399973811604414, -0.84, 0.5, -9.31> texture { Material305 } }
sphere { <6.92, 1.08, 6.31>, 0.18 texture { Material306 } }
sphere { <0, 0, 0>, 1 matrix <0.26883392945580264, 0.009449059742463866, -0.00018342119806877773, -0.016790522516348428, 0.47734491761268627, -0.01854475621208632, -0.000137736364349045, 0.007836905344856563, 0.20184787326922643, 6.92, 0.47, 6.31> texture { Material306 } }
sphere { <-9.37, 1.2, 0.02>, 0.2 texture { Material307 } }
sphere { <0, 0, 0>, 1 matrix <0.237, 0, 0, 0, 0.528, 0, 0, 0, 0.223, -9.37, 0.52, 0.02> texture { Material307 } }
sphere { <6.9, 0.9, -6.35>, 0.15 texture { Material308 } }
sphere { <0, 0, 0>, 1 matrix <0.20587074965873867, -0.007294837296398203, 0.00014065478313730708, 0.01402308528822179, 0.39545729576281125, -0.015260416343064891, 0.00011402596497053536, 0.00643557961942383, 0.16687591292047327, 6.9, 0.39, -6.35> texture { Material308 } }
sphere { <-0.8, 0.94, 9.36>, 0.157 texture { Material309 } }
sphere { <0, 0, 0>, 1 matrix <0.20272403090484922, -0.010581430754029121, 2.4837218563571138e-05, 0.021684114254562136, 0.4154298864579027, -0.0019515702829105924, 2.153374614378581e-05, 0.0008256643504621738, 0.17599806196284706, -0.8, 0.41, 9.36> texture { Material309 } }
sphere { <-5.74, 0.97, -7.45>, 0.161 texture { Material310 } }
sphere { <0, 0, 0>, 1 matrix <0.18954704989462065, 0.013107003997217932, -0.000349746283900508, -0.029387282646393887, 0.4243789413870836, -0.022691446094050976, -0.0003313385847478497, 0.009587934969317313, 0.17974415628266305, -5.74, 0.42, -7.45> texture { Material310 } }
sphere { <9.28, 0.97, 1.62>, 0.162 texture { Material311 } }
sphere { <0, 0, 0>, 1 matrix <0.23398367358403083, -0.002762509079922837, -9.507736358528396e-05, 0.005052794385499889, 0.42695741351120475, 0.029425096715558176, -7.354274704673672e-05, -0.012443790900738388, 0.18057172164955135, 9.28, 0.42, 1.62> texture { Material311 } }
sphere { <-7.94, 0.96, 5.08>, 0.159 texture { Material312 } }
sphere { <0, 0, 0>, 1 matrix <0.20299095903052905, 0.0019158168173328755, 1.4063730288173673e-05, -0.003982633974948145, 0.4219357273559971, 0.006195208405474891, 1.2331743799482334e-05, -0.0026131447776647646, 0.17798081728742302, -7.94, 0.41, 5.08> texture { Material312 } }
sphere { <2.43, 1.07, -9.12>, 0.179 texture { Material313 } }
sphere { <0, 0, 0>, 1 matrix <0.21097001778346935, 0.003556899191398395, 8.036470410276354e-06, -0.007973522831902563, 0.47292795980897306, 0.0021372329240151203, 7.61750749789228e-06, -0.0009036925682939198, 0.19999795819386657, 2.43, 0.46, -9.12> texture { Material313 } }
sphere { <4.37, 0.94, 8.38>, 0.156 texture { Material314 } }
sphere { <0, 0, 0>, 1 matrix <0.234294278952118, -0.018194993935606127, -0.00036475469890530316, 0.031976734023001406, 0.41142841031189087, 0.01652730073098949, -0.000270073691955416, -0.006963075852765547, 0.17386041135022529, 4.37, 0.4, 8.38> texture { Material314 } }
sphere { <-8.89, 1.21, -3.22>, 0.202 texture { Material315 } }
sphere { <0, 0, 0>, 1 matrix <0.2879543368441524, -0.005126787960800556, -0.0001262451955786653, 0.009505919343984365, 0.5332681715589425, 0.026281071127486184, -9.86290590458323e-05, -0.011073485025626202, 0.22472731966028506, -8.89, 0.52, -3.22> texture { Material315 } }
sphere { <8.75, 0.92, -3.63>, 0.153 texture { Material316 } }
sphere { <0, 0, 0>, 1 matrix <0.224, 0, 0, 0, 0.405, 0, 0, 0, 0.171, 8.75, 0.4, -3.63> texture { Material316 } }
sphere { <-4, 1.22, 8.6>, 0.203 texture { Material317 } }
sphere { <0, 0, 0>, 1 matrix <0.2734497605430801, -0.017354076320584798, 0.00025395667242457203, 0.034074792191513215, 0.5366894590397855, -0.01572682716531379, 0.000210394761461233, 0.006635668711015297, 0.22690289472547942, -4, 0.53, 8.6> texture { Material317 } }
sphere { <-2.86, 1.07, -9.05>, 0.178 texture { Material318 } }
sphere { <0, 0, 0>, 1 matrix <0.21126642980946467, -0.01761936355562419, -0.00023165374437958105, 0.03906179656199703, 0.4682115081031204, 0.012335304177472747, -0.00021744856194121052, -0.005222820279398036, 0.1989313320330712, -2.86, 0.46, -9.05> texture { Material318 } }
sphere { <8.24, 1.14, 4.75>, 0.19 texture { Material319 } }
sphere { <0, 0, 0>, 1 matrix <0.2699897898729332, -0.0023479882350856585, -1.7765621096281048e-05, 0.0043829113721598955, 0.5039232383588212, 0.007626265787558218, -1.4015101087066161e-05, -0.00322300518402758, 0.2129756137241085, 8.24, 0.49, 4.75> texture { Material319 } }
sphere { <-9.29, 1.08, 2.06>, 0.18 texture { Material320 } }
sphere { <0, 0, 0>, 1 matrix <0.237, 0, 0, 0, 0.476, 0, 0, 0, 0.201, -9.29, 0.47, 2.06> texture { Material320 } }
sphere { <5.46, 1.04, -7.81>, 0.173 texture { Material321 } }
sphere { <0, 0, 0>, 1 matrix <0.248, 0, 0, 0, 0.457, 0, 0, 0, 0.193, 5.46, 0.45, -7.81> texture { Material321 } }
sphere { <1.25, 0.9, 9.46>, 0.15 texture { Material322 } }
sphere { <0, 0, 0>, 1 matrix <0.1859929589815779, -0.019380446910875728, -0.0001322377094897729, 0.041144585153035644, 0.3948251924612045, 0.0054028243130248834, -0.00011880179248279064, -0.0022863337143279104, 0.16798439976462348, 1.25, 0.39, 9.46> texture { Material322 } }
sphere { <-7.32, 1.21, -6.14>, 0.201 texture { Material323 } }
sphere { <0, 0, 0>, 1 matrix <0.27284713564078233, -0.009132729488946108, -0.00018391493218380262, 0.01783056709746621, 0.5322695420241879, 0.021452401039139035, -0.00015157824081082634, -0.009055891620649686, 0.22481763242902447, -7.32, 0.52, -6.14> texture { Material323 } }
sphere { <9.55, 0.82, -0.42>, 0.136 texture { Material324 } }
sphere { <0, 0, 0>, 1 matrix <0.16699983748899713, 0.00023294235856783328, 4.0627750723245895e-06, -0.0005035460565448372, 0.36078008855389354, 0.012588651413620927, 3.6978551556487276e-06, -0.005300484805735127, 0.15190755362110878, 9.55, 0.35, -0.42> texture { Material324 } }
sphere { <-6.77, 1.14, 6.77>, 0.19 texture { Material325 } }
sphere { <0, 0, 0>, 1 matrix <0.24453385051623883, 0.01509896209547374, 0.0004661494837611708, -0.030999093608258334, 0.501085933140148, 0.030999093608258334, 0.00040336200227497225, -0.013065224343838503, 0.21159663799772502, -6.77, 0.49, 6.77> texture { Material325 } }
sphere { <0.42, 1.17, -9.57>, 0.195 texture { Material326 } }
sphere { <0, 0, 0>, 1 matrix <0.2500463949890457, 0.02185861152960399, 3.814420043817364e-05, -0.045023514584881526, 0.5150326589134324, 0.001800940583395261, 3.312922587857312e-05, -0.0007593908069248876, 0.21799867483096486, 0.42, 0.51, -9.57> texture { Material326 } }
sphere { <6.16, 0.87, 7.35>, 0.144 texture { Material327 } }
sphere { <0, 0, 0>, 1 matrix <0.17974067887464235, 0.009656184564708912, -0.00021553963666090214, -0.02049256946510447, 0.38106946719925283, -0.01703278500995696, -0.00019278823056891801, 0.007178739231945212, 0.16083976043173492, 6.16, 0.37, 7.35> texture { Material327 } }
sphere { <-9.52, 1.04, -1.26>, 0.174 texture { Material328 } }
sphere { <0, 0, 0>, 1 matrix <0.2469993623208539, -0.0005612392619371197, -4.856171958870182e-06, 0.0010474951407004544, 0.4609297874670964, 0.007977078379180382, -3.833819967529092e-06, -0.0033742522428203353, 0.19497080398640113, -9.52, 0.45, -1.26> texture { Material328 } }
sphere { <7.88, 0.86, -5.51>, 0.143 texture { Material329 } }
sphere { <0, 0, 0>, 1 matrix <0.18899062223357355, -0.0018826910963909208, 1.3490821876681234e-05, 0.0037653821927818415, 0.3779424287691159, -0.0054168656106686145, 1.1420801588724855e-05, 0.0022928531685369796, 0.15998357007490746, 7.88, 0.37, -5.51> texture { Material329 } }
sphere { <-2.09, 1.03, 9.4>, 0.171 texture { Material330 } }
sphere { <0, 0, 0>, 1 matrix <0.2526699075238978, -0.012919455897999862, 7.410239259438149e-05, 0.023132464513019514, 0.452379179243822, -0.005193002237616626, 5.594291298627218e-05, 0.0021895439898118665, 0.19098744138688062, -2.09, 0.44, 9.4> texture { Material330 } }
sphere { <-4.81, 1.02, -8.35>, 0.171 texture { Material331 } }
sphere { <0, 0, 0>, 1 matrix <0.2559416833938735, -0.02329130224546999, -0.000608227934555455, 0.040873063473567964, 0.4485293748110913, 0.023490266364119515, -0.00045202932101203066, -0.009948205932476336, 0.19074021303390112, -4.81, 0.44, -8.35> texture { Material331 } }
sphere { <9.2, 0.95, 2.91>, 0.159 texture { Material332 } }
sphere { <0, 0, 0>, 1 matrix <0.21192684618598537, -0.0055640095438813245, -0.00023165374437958105, 0.01104928310365112, 0.41939796789662487, 0.034989396494895214, -0.00019450172877153504, -0.014793616570288238, 0.17738407785889013, 9.2, 0.41, 2.91> texture { Material332 } }
sphere { <-8.76, 0.94, 4.07>, 0.157 texture { Material333 } }
sphere { <0, 0, 0>, 1 matrix <0.20786100438688287, -0.007596851955920968, 0.0003011571617537575, 0.015230227238553095, 0.4154131891042579, -0.032998825683531706, 0.0002548252907147179, 0.01392756191918844, 0.17544787853678476, -8.76, 0.41, 4.07> texture { Material333 } }
sphere { <3.71, 1.17, -8.93>, 0.195 texture { Material334 } }
sphere { <0, 0, 0>, 1 matrix <0.284661599738147, 0.02763092519861147, 0.0005528174994610156, -0.04994821093595151, 0.5141678199053973, 0.020630782777893014, 0.00042137837371503985, -0.008699246896674423, 0.21782595241085684, 3.71, 0.51, -8.93> texture { Material334 } }
sphere { <3.3, 0.95, 9.1>, 0.159 texture { Material335 } }
sphere { <0, 0, 0>, 1 matrix <0.20788795118979903, 0.006826280653855532, -4.052829305141596e-05, -0.013783835935669826, 0.4197441473480202, -0.004985642785242278, -3.4488018606253005e-05, 0.0021010923166378172, 0.17698752561029135, 3.3, 0.41, 9.1> texture { Material335 } }
sphere { <-8.59, 0.95, -4.49>, 0.159 texture { Material336 } }
sphere { <0, 0, 0>, 1 matrix <0.2399922938635271, -0.0019231910522157696, -1.4909698827955978e-05, 0.003365584341377597, 0.4199360319656843, 0.006511674051795784, -1.0995902885617534e-05, -0.0027442054932567948, 0.17697872531833, -8.59, 0.41, -4.49> texture { Material336 } }
sphere { <9.38, 1.14, -2.5>, 0.19 texture { Material337 } }
sphere { <0, 0, 0>, 1 matrix <0.22694209903932322, -0.005122208614734232, 0.00021601512252496043, 0.011350092216789948, 0.501085933140148, -0.042344574808793264, 0.00020174099548586616, 0.01784701761324885, 0.21124735090145658, 9.38, 0.49, -2.5> texture { Material337 } }
sphere { <-5.23, 0.88, 8.18>, 0.146 texture { Material338 } }
sphere { <0, 0, 0>, 1 matrix <0.18991810252054558, -0.005577774031247576, 5.26483796492688e-05, 0.011390401705916103, 0.38776364088340914, -0.007322401096660353, 4.544386453936886e-05, 0.0030950355150832424, 0.16397078608708185, -5.23, 0.38, 8.18> texture { Material338 } }
sphere { <-1.67, 0.89, -9.58>, 0.149 texture { Material339 } }
sphere { <0, 0, 0>, 1 matrix <0.19388520536661513, -0.00667283683108372, -1.9712209773161102e-05, 0.013517653992865473, 0.39276059501850463, 0.0023212133119061926, -1.6867148568787338e-05, -0.0009804616024845496, 0.16599710362095282, -1.67, 0.38, -9.58> texture { Material339 } }
sphere { <7.71, 0.96, 5.94>, 0.161 texture { Material340 } }
sphere { <0, 0, 0>, 1 matrix <0.19789864472663224, -0.006333181292642377, -0.0001312633868205503, 0.01359394974430813, 0.4244175522706939, 0.017605279177054792, -0.00011866740525696211, -0.007414929347512489, 0.17884631598335574, 7.71, 0.42, 5.94> texture { Material340 } }
sphere { <-9.71, 0.94, 0.83>, 0.157 texture { Material341 } }
sphere { <0, 0, 0>, 1 matrix <0.18999540217893437, -0.0013205482749420517, 5.74727633202183e-05, 0.002891305696715229, 0.41441699440616614, -0.03614132120894037, 5.323792812820222e-05, 0.015290558973013232, 0.17533452589839746, -9.71, 0.41, 0.83> texture { Material341 } }
sphere { <6.61, 1.08, -7.18>, 0.18 texture { Material342 } }
sphere { <0, 0, 0>, 1 matrix <0.25125153253041976, -0.019395730419973074, 0.0006877809179926636, 0.03679031405058384, 0.4753814659860346, -0.033807315614050024, 0.0005513164501369765, 0.014286773544012771, 0.20149338488365792, 6.61, 0.47, -7.18> texture { Material342 } }
sphere { <-0.02, 1.04, 9.77>, 0.173 texture { Material343 } }
sphere { <0, 0, 0>, 1 matrix <0.21780029508565185, -0.02289173345561611, 0, 0.04776950771331764, 0.4544965061833009, 0, 0, 0, 0.193, -0.02, 0.45, 9.77> texture { Material343 } }
sphere { <-6.59, 0.95, -7.23>, 0.158 texture { Material344 } }
sphere { <0, 0, 0>, 1 matrix <0.18774834109120783, -0.009721548248946964, -0.00022785333633886873, 0.02166664210802541, 0.4179793370588663, 0.019617094881590576, -0.00021452149219138171, -0.008286935069311533, 0.17680577108139428, -6.59, 0.41, -7.23> texture { Material344 } }
sphere { <9.75, 0.94, 0.88>, 0.157 texture { Material345 } }
sphere { <0, 0, 0>, 1 matrix <0.227995537434798, 0.0014256406415521059, -4.958405780022563e-05, -0.002601168889849456, 0.41498664490808684, -0.028901876553882846, -3.827541303877066e-05, 0.012227717003565819, 0.17557471763290253, 9.75, 0.41, 0.88> texture { Material345 } }
sphere { <-7.79, 1.22, 5.94>, 0.203 texture { Material346 } }
sphere { <0, 0, 0>, 1 matrix <0.24887454048084384, -0.007901647170052394, 0.00016453707430315613, 0.017072635250956578, 0.5372626896979608, -0.02239034131272994, 0.0001499996621157287, 0.009447225795519881, 0.22680327913165152, -7.79, 0.53, 5.94> texture { Material346 } }
sphere { <1.73, 0.91, -9.66>, 0.152 texture { Material347 } }
sphere { <0, 0, 0>, 1 matrix <0.202, 0, 0, 0, 0.402, 0, 0, 0, 0.17, 1.73, 0.39, -9.66> texture { Material347 } }
sphere { <5.25, 0.97, 8.3>, 0.161 texture { Material348 } }
sphere { <0, 0, 0>, 1 matrix <0.2269004296016886, 0.006722439439147336, -6.208507188828038e-05, -0.012615679299897643, 0.4257404923101348, -0.007866247092877357, -4.9230453479693685e-05, 0.003323766377272122, 0.1799693033643009, 5.25, 0.42, 8.3> texture { Material348 } }
sphere { <-9.49, 0.98, -2.58>, 0.163 texture { Material349 } }
sphere { <0, 0, 0>, 1 matrix <0.19596799666863915, 0.003539777680327311, -0.00011939704392323066, -0.007765838788473182, 0.4289525416117244, -0.028972552403149943, -0.0001108686836429999, 0.012262801249705324, 0.1815863745264088, -9.49, 0.42, -2.58> texture { Material349 } }
sphere { <8.75, 1.13, -4.52>, 0.188 texture { Material350 } }
sphere { <0, 0, 0>, 1 matrix <0.279, 0, 0, 0, 0.498, 0, 0, 0, 0.21, 8.75, 0.49, -4.52> texture { Material350 } }
sphere { <-3.4, 1.17, 9.25>, 0.194 texture { Material351 } }
sphere { <0, 0, 0>, 1 matrix <0.2671043497094486, 0.02188961289835803, 0.0003334868103117102, -0.041982317275209055, 0.5120440748191573, 0.0156317138790672, 0.00027002476805089974, -0.006599381151279343, 0.21689945886295978, -3.4, 0.5, 9.25> texture { Material351 } }
sphere { <-3.74, 0.85, -9.13>, 0.142 texture { Material352 } }
sphere { <0, 0, 0>, 1 matrix <0.2028940301561772, 0.006558250691841443, -4.329950607813951e-05, -0.012179608427705537, 0.3767703417861991, -0.004976614196266778, -3.391439146021765e-05, 0.0020988903374175535, 0.15898614250671517, -3.74, 0.37, -9.13> texture { Material352 } }
sphere { <8.93, 1.05, 4.21>, 0.175 texture { Material353 } }
sphere { <0, 0, 0>, 1 matrix <0.23897294197998148, 0.003595802292721707, -5.66330651550665e-05, -0.0069809718151584614, 0.46371734373686047, -0.014611336357308408, -4.644385259578676e-05, 0.006172030013000965, 0.19590279193642743, 8.93, 0.45, 4.21> texture { Material353 } }
sphere { <-9.44, 0.92, 2.94>, 0.153 texture { Material354 } }
sphere { <0, 0, 0>, 1 matrix <0.18297725787144367, 0.002884079651519276, 7.201674042841485e-05, -0.006398559226867902, 0.405443591110357, 0.020262104218415025, 6.72943312199942e-05, -0.008534038968839825, 0.17078690128447002, -9.44, 0.4, 2.94> texture { Material354 } }
sphere { <4.98, 0.89, -8.55>, 0.149 texture { Material355 } }
sphere { <0, 0, 0>, 1 matrix <0.1789185050159002, 0.0054005849622642335, 4.7380804709174604e-05, -0.011887321090123509, 0.39375998584552374, 0.006911233191932273, 4.3939740680016676e-05, -0.002911839365128826, 0.16597445363913954, 4.98, 0.39, -8.55> texture { Material355 } }
sphere { <2.1, 0.95, 9.68>, 0.158 texture { Material356 } }
sphere { <0, 0, 0>, 1 matrix <0.2179682552128892, -0.003720171121792235, -6.802454380885542e-06, 0.007133172150959423, 0.41793633657537155, 0.0015285368894913049, -5.491889775393832e-06, -0.0006435944797858126, 0.1759988231664767, 2.1, 0.41, 9.68> texture { Material356 } }
sphere { <-8.1, 0.96, -5.73>, 0.161 texture { Material357 } }
sphere { <0, 0, 0>, 1 matrix <0.2259885218190304, 0.0022776616757111392, -1.6227773094954955e-05, -0.00428321332821785, 0.4249352704414663, -0.006055577464032133, -1.285297072565016e-05, 0.0025504667436747103, 0.17898182855862926, -8.1, 0.42, -5.73> texture { Material357 } }
sphere { <9.85, 0.99, -1.25>, 0.165 texture { Material358 } }
sphere { <0, 0, 0>, 1 matrix <0.22197938540325243, -0.00302122669393331, 0.00015698808292368763, 0.005960798612354909, 0.4356005901713037, -0.04539377404793353, 0.00013082340243640635, 0.01917316940380754, 0.1840037294737535, 9.85, 0.43, -1.25> texture { Material358 } }
sphere { <-6.43, 1.06, 7.58>, 0.177 texture { Material359 } }
sphere { <0, 0, 0>, 1 matrix <0.23297950474182907, -0.003090317619895874, 1.7528839225129584e-05, 0.006233687902794252, 0.4699284167235039, -0.005331443601074032, 1.489575178787836e-05, 0.0022460124106652305, 0.1979872602122867, -6.43, 0.46, 7.58> texture { Material359 } }
sphere { <-0.39, 1.21, -9.94>, 0.202 texture { Material360 } }
sphere { <0, 0, 0>, 1 matrix <0.27383335323805136, -0.009554821294548849, -6.665870477945733e-06, 0.01862144004120104, 0.5336747016281972, 0.0007448576016480417, -5.498126744582978e-06, -0.00031523935949898395, 0.22599978007493024, -0.39, 0.52, -9.94> texture { Material360 } }
sphere { <7.01, 1.03, 7.08>, 0.172 texture { Material361 } }
sphere { <0, 0, 0>, 1 matrix <0.23492740693750794, -0.005840235206238069, -7.157062499216422e-05, 0.011282837377157804, 0.4537234354666695, 0.011123924174662623, -5.847472339785333e-05, -0.004704390840385955, 0.19194234886425565, 7.01, 0.44, 7.08> texture { Material361 } }
sphere { <-9.96, 0.85, -0.49>, 0.141 texture { Material362 } }
sphere { <0, 0, 0>, 1 matrix <0.179, 0, 0, 0, 0.374, 0, 0, 0, 0.158, -9.96, 0.37, -0.49> texture { Material362 } }
sphere { <7.68, 1.19, -6.38>, 0.198 texture { Material363 } }
sphere { <0, 0, 0>, 1 matrix <0.25243372627505206, -0.016904131797422447, 0.0006812980753279555, 0.03507774384840626, 0.5221239950683435, -0.042202910567613786, 0.0005978188645170203, 0.017845802182876687, 0.22128074917862797, 7.68, 0.51, -6.38> texture { Material363 } }
sphere { <-1.36, 1.02, 9.9>, 0.169 texture { Material364 } }
sphere { <0, 0, 0>, 1 matrix <0.1995223618404829, 0.013813854034871216, 6.754479023474367e-05, -0.030943033038111523, 0.44690869451640125, 0.004375782449833952, 6.382982677183276e-05, -0.0018460332210236987, 0.18899097355985045, -1.36, 0.44, 9.9> texture { Material364 } }
sphere { <-5.69, 1.09, -8.23>, 0.181 texture { Material365 } }
sphere { <0, 0, 0>, 1 matrix <0.26775236917405537, 0.011516908078830155, -0.0001721336229127314, -0.020627298051636097, 0.4793421766821954, -0.014338487670039726, -0.00012974250682228265, 0.006034113561141719, 0.2019098131355016, -5.69, 0.47, -8.23> texture { Material365 } }
sphere { <9.77, 0.82, 2.22>, 0.137 texture { Material366 } }
sphere { <0, 0, 0>, 1 matrix <0.19494874866027534, 0.004464669557013058, -0.00022830142240984772, -0.008311154098439693, 0.3610114480186832, -0.037022413711231356, -0.00017912880835234204, 0.015604488423742143, 0.15220206258097593, 9.77, 0.36, 2.22> texture { Material366 } }
sphere { <-8.71, 1.04, 4.96>, 0.173 texture { Material367 } }
sphere { <0, 0, 0>, 1 matrix <0.25176906664692145, 0.010778170513915868, 0.0004100245248537575, -0.01958889720386297, 0.4562571717260195, 0.03478028687216487, 0.00031565380087948, -0.01473226125152835, 0.19343955345558134, -8.71, 0.45, 4.96> texture { Material367 } }
sphere { <3.07, 0.88, -9.55>, 0.147 texture { Material368 } }
sphere { <0, 0, 0>, 1 matrix <0.2068860362774283, 0.006867795166952356, 3.718816210233697e-05, -0.012939324227591396, 0.38976242253744736, 0.004222305800582456, 2.96427379076599e-05, -0.0017863601464002698, 0.16499032710657752, 3.07, 0.38, -9.55> texture { Material368 } }
sphere { <4.19, 1.02, 9.13>, 0.17 texture { Material369 } }
sphere { <0, 0, 0>, 1 matrix <0.25947787496788627, 0.016467371691065866, -0.00024098078405251357, -0.028501220234537075, 0.4489038226169209, -0.013154409339017108, -0.00017610134219222143, 0.005554083943140557, 0.18991872245744973, 4.19, 0.44, 9.13> texture { Material369 } }
sphere { <-9.27, 1.11, -3.91>, 0.185 texture { Material370 } }
sphere { <0, 0, 0>, 1 matrix <0.2749744815394504, 0.0037457814116938887, -6.019739411699665e-05, -0.0066879224477879974, 0.490700896066376, -0.015776637569140918, -4.531222029897566e-05, 0.0066512504619392464, 0.2068931096341665, -9.27, 0.48, -3.91> texture { Material370 } }
sphere { <9.48, 0.97, -3.38>, 0.161 texture { Material371 } }
sphere { <0, 0, 0>, 1 matrix <0.2069963525489755, -0.0012287919801907891, 1.0084129303033924e-05, 0.0025347544712148165, 0.4269349658317791, -0.007007850596888021, 8.768808089594717e-06, 0.002954129057236168, 0.17997575682469347, 9.48, 0.42, -3.38> texture { Material371 } }
sphere { <-4.71, 1.15, 8.91>, 0.191 texture { Material372 } }
sphere { <0, 0, 0>, 1 matrix <0.24288482499326014, 0.007480508273542712, 6.151392405423918e-05, -0.015545912255716337, 0.5046923676446433, 0.008302930409303045, 5.39196124426047e-05, -0.003502028073626828, 0.2129712020251727, -4.71, 0.49, 8.91> texture { Material372 } }
sphere { <-2.55, 1.01, -9.76>, 0.169 texture { Material373 } }
sphere { <0, 0, 0>, 1 matrix <0.24368643525726646, 0.012365869982978644, -8.08156553436977e-05, -0.02265386837045678, 0.44638740203529453, -0.005838625868674428, -6.259901172114288e-05, 0.002468680736419389, 0.1889838662340925, -2.55, 0.44, -9.76> texture { Material373 } }
sphere { <8.48, 1.09, 5.48>, 0.182 texture { Material374 } }
sphere { <0, 0, 0>, 1 matrix <0.22763476665581686, 0.012887599684632465, -0.0005681407576182128, -0.02724483792979319, 0.4793595535675077, -0.042380859001900514, -0.0005083364673426114, 0.01793712704644752, 0.2032092543841337, 8.48, 0.47, 5.48> texture { Material374 } }
sphere { <-9.97, 1.03, 1.69>, 0.172 texture { Material375 } }
sphere { <0, 0, 0>, 1 matrix <0.2059775475873334, 0.0030385512580232547, 0.00013075228552903895, -0.006711363215536801, 0.4532685876317442, 0.03908382107871431, 0.00012186620787172567, -0.016492513510138786, 0.1912903085541588, -9.97, 0.44, 1.69> texture { Material375 } }
sphere { <6.22, 1, -7.99>, 0.167 texture { Material376 } }
sphere { <0, 0, 0>, 1 matrix <0.25061695509491694, -0.013858367138278467, 0.00029576885076035986, 0.024459189809790283, 0.4419208742651021, -0.018886209853129204, 0.00022035368562624413, 0.007972282714526324, 0.18682985348325062, 6.22, 0.43, -7.99> texture { Material376 } }
sphere { <0.81, 1.18, 10.1>, 0.196 texture { Material377 } }
sphere { <0, 0, 0>, 1 matrix <0.23567862698934758, -0.012311950268744423, -2.5709840852191996e-05, 0.027128026015877542, 0.5192873580723784, 0.0021702420812702034, -2.3966800794416266e-05, -0.0009181793420758554, 0.21999808265593646, 0.81, 0.51, 10.1> texture { Material377 } }
sphere { <-7.43, 0.99, -6.91>, 0.164 texture { Material378 } }
sphere { <0, 0, 0>, 1 matrix <0.20064465599108033, 0.011940540236832978, -0.0003814722448696471, -0.025841467676728087, 0.4333446936699093, -0.02774157559413456, -0.00034920842316425407, 0.011734367607633928, 0.1836251144868972, -7.43, 0.43, -6.91> texture { Material378 } }
sphere { <10.15, 1.1, 0.08>, 0.183 texture { Material379 } }
sphere { <0, 0, 0>, 1 matrix <0.22299991515025244, 0.00019434758919074054, -8.484974757931644e-06, -0.00042268421864353887, 0.4831544285744966, -0.04226842186435389, -7.800088903031331e-06, 0.017866033983902158, 0.20421999110969685, 10.15, 0.47, 0.08> texture { Material379 } }
sphere { <-7.54, 1.13, 6.81>, 0.189 texture { Material380 } }
sphere { <0, 0, 0>, 1 matrix <0.23193633497414787, 0.005434296121509479, 7.03165957173091e-05, -0.011711845089460082, 0.4996954135095479, 0.012935470695821582, 6.395173144979406e-05, -0.0054587686336367075, 0.21092936674436888, -7.54, 0.49, 6.81> texture { Material380 } }
sphere { <0.96, 0.86, -10.13>, 0.143 texture { Material381 } }
sphere { <0, 0, 0>, 1 matrix <0.19588156144801386, 0.006812765302260165, 1.0659469678752856e-05, -0.013138904511501745, 0.3777697326132182, 0.0011825014060351572, 8.70160790102274e-06, -0.000500529695676257, 0.15999921685528892, 0.96, 0.37, -10.13> texture { Material381 } }
sphere { <6.14, 0.82, 8.13>, 0.137 texture { Material382 } }
sphere { <0, 0, 0>, 1 matrix <0.19382984303512787, 0.008122540408904885, -0.00012761772365408466, -0.015156492927956537, 0.3615038915811557, -0.011367369695967399, -0.0001006469676240977, 0.004804440783102244, 0.15292451477428193, 6.14, 0.35, 8.13> texture { Material382 } }
sphere { <-10.02, 0.91, -1.85>, 0.151 texture { Material383 } }
sphere { <0, 0, 0>, 1 matrix <0.1939759079314318, 0.0030544945819456415, -0.00013116792887139472, -0.006313671790516506, 0.39947407393479, -0.0343744353039232, -0.00011426484525394694, 0.014486981462251924, 0.16837789139806186, -10.02, 0.39, -1.85> texture { Material383 } }
sphere { <8.65, 0.89, -5.41>, 0.149 texture { Material384 } }
sphere { <0, 0, 0>, 1 matrix <0.19786497594195832, 0.00730783158292055, 0.00021654801761405358, -0.014504938444887759, 0.39204267175211094, 0.023262637128593572, 0.0001815503582016813, -0.009825948507243087, 0.165708834331186, 8.65, 0.38, -5.41> texture { Material384 } }
sphere { <-2.72, 0.92, 9.84>, 0.153 texture { Material385 } }
sphere { <0, 0, 0>, 1 matrix <0.19897191305718445, 0.0033433145174949874, 7.89945266688105e-06, -0.006787432487778768, 0.4039384688431821, 0.0019089653871877787, 6.748276147586826e-06, -0.000803277514410699, 0.1699981020473335, -2.72, 0.39, 9.84> texture { Material385 } }
sphere { <-4.64, 0.85, -9.11>, 0.142 texture { Material386 } }
sphere { <0, 0, 0>, 1 matrix <0.21406200539318318, 0.020055745259705465, -0.000474266936030975, -0.035074233570461646, 0.37394023265847076, -0.017734163041244658, -0.00035073694339034895, 0.007499287030739097, 0.1588226610960386, -4.64, 0.37, -9.11> texture { Material386 } }
sphere { <9.59, 0.94, 3.58>, 0.156 texture { Material387 } }
sphere { <0, 0, 0>, 1 matrix <0.1959854624358697, -0.002386836689929568, -3.904374366427678e-05, 0.005041583620565515, 0.41374780238590564, 0.013540253152375956, -3.486048541453283e-05, -0.005723536960545392, 0.17490637469631526, 9.59, 0.4, 3.58> texture { Material387 } }
sphere { <-9.5, 1.05, 3.84>, 0.176 texture { Material388 } }
sphere { <0, 0, 0>, 1 matrix <0.23587727768399616, 0.007603599294050183, 0.0003084641996853309, -0.01498166810056498, 0.4632305346126617, 0.03765662522574441, 0.0002561821319420545, -0.0158724699876256, 0.19535608274944294, -9.5, 0.45, 3.84> texture { Material388 } }
sphere { <4.42, 1.09, -9.26>, 0.181 texture { Material389 } }
sphere { <0, 0, 0>, 1 matrix <0.21889138486774287, 0.0068962988410572, 5.189389652284336e-05, -0.015115175542043177, 0.47970759696916593, 0.007221694981198407, 4.810256161706486e-05, -0.0030541751691318267, 0.2029770176650052, 4.42, 0.47, -9.26> texture { Material389 } }
sphere { <3, 0.82, 9.82>, 0.137 texture { Material390 } }
sphere { <0, 0, 0>, 1 matrix <0.20597124886781626, -0.003441593293627524, -8.685237847169268e-06, 0.006047848409190115, 0.3619448656466136, 0.001826954206942847, -6.450686362217952e-06, -0.0007721657283487724, 0.15299805135516142, 3, 0.35, 9.82> texture { Material390 } }
sphere { <-8.85, 0.96, -5.22>, 0.16 texture { Material391 } }
sphere { <0, 0, 0>, 1 matrix <0.20296782583160586, 0.0036136869873181015, -5.425448003720471e-05, -0.007547799421787561, 0.4237417106560966, -0.01272766177007314, -4.7840157274185424e-05, 0.00537323456802616, 0.17891932836224353, -8.85, 0.41, -5.22> texture { Material391 } }
sphere { <10.06, 1, -2.13>, 0.166 texture { Material392 } }
sphere { <0, 0, 0>, 1 matrix <0.2069875454792574, 0.0022699423804246784, 5.812109679870779e-05, -0.004824998296554872, 0.4393969952920125, 0.022516658717256072, 5.22247536452157e-05, -0.00951840573047643, 0.185756284482989, 10.06, 0.43, -2.13> texture { Material392 } }
sphere { <-5.98, 0.89, 8.38>, 0.148 texture { Material393 } }
sphere { <0, 0, 0>, 1 matrix <0.17755223654650173, 0.012613504654666813, 0.0003206207444802356, -0.027707192808846766, 0.3895121269538725, 0.019839718307569285, 0.00029720462269235327, -0.008372259643859162, 0.16478718681338078, -5.98, 0.38, 8.38> texture { Material393 } }
sphere { <-1.25, 1.16, -10.23>, 0.194 texture { Material394 } }
sphere { <0, 0, 0>, 1 matrix <0.2838294999250297, 0.009839438256123267, -2.0666675753971106e-05, -0.017773351497856468, 0.5126874942607962, -0.0021543456361038144, -1.571831677062591e-05, 0.0009070928994121323, 0.21599809474948237, -1.25, 0.5, -10.23> texture { Material394 } }
sphere { <7.84, 1.1, 6.71>, 0.183 texture { Material395 } }
sphere { <0, 0, 0>, 1 matrix <0.26198314230110664, -0.0029719962201731837, -1.9710540244566313e-05, 0.005490252559403897, 0.48392628445569336, 0.006419372223303017, -1.5347138205692852e-05, -0.0027056858131277177, 0.20398205565379024, 7.84, 0.47, 6.71> texture { Material395 } }
sphere { <-10.32, 0.82, 0.35>, 0.136 texture { Material396 } }
sphere { <0, 0, 0>, 1 matrix <0.15999964953865262, 0.0003346805016172342, 1.1682044912422672e-05, -0.0007530311286387769, 0.3591230580935367, 0.025101037621292562, 1.1097942666801538e-05, -0.010598215884545749, 0.15163006857777328, -10.32, 0.35, 0.35> texture { Material396 } }
sphere { <7.38, 1.02, -7.24>, 0.17 texture { Material397 } }
sphere { <0, 0, 0>, 1 matrix <0.2069378448692756, -0.005071921374791107, 6.304306116331061e-05, 0.011025916032154581, 0.4497258721585931, -0.011183429118328219, 5.7865611695792355e-05, 0.004721892294405248, 0.18994130773670856, 7.38, 0.44, -7.24> texture { Material397 } }
sphere { <-0.55, 0.9, 10.33>, 0.149 texture { Material398 } }
sphere { <0, 0, 0>, 1 matrix <0.20187725392304975, -0.007040902699371059, 6.1373038475140175e-06, 0.013768101813126576, 0.39475937667254285, -0.0006884050906563288, 5.073909616509113e-06, 0.00029104721554330863, 0.16699974630451916, -0.55, 0.39, 10.33> texture { Material398 } }
sphere { <-6.58, 0.98, -8>, 0.164 texture { Material399 } }
sphere { <0, 0, 0>, 1 matrix <0.24091205894407847, -0.006509583570952909, -7.195177302670404e-05, 0.011749663291968944, 0.43473500975330664, 0.009613360875247319, -5.463557868832714e-05, -0.004044241471655769, 0.18295529816289136, -6.58, 0.42, -8> texture { Material399 } }
sphere { <10.26, 1.18, 1.46>, 0.196 texture { Material400 } }
sphere { <0, 0, 0>, 1 matrix <0.23599718136386866, 0.00115325237188245, -1.9931784071406677e-05, -0.002541064548215568, 0.5196832300499298, -0.0179689564480958, -1.8580476676735042e-05, 0.0076022508049636076, 0.2198686094863574, 10.26, 0.51, 1.46> texture { Material400 } }
sphere { <-8.56, 1.14, 5.86>, 0.189 texture { Material401 } }
sphere { <0, 0, 0>, 1 matrix <0.24580795595051938, 0.009714452695338095, 0.0002796430895945792, -0.01978431219660319, 0.4997795891801719, 0.028808735303825703, 0.0002409932316831333, -0.012190522723375346, 0.2116490800310579, -8.56, 0.49, 5.86> texture { Material401 } }
sphere { <2.36, 0.85, -10.12>, 0.141 texture { Material402 } }
sphere { <0, 0, 0>, 1 matrix <0.17589849258305396, -0.005976598338827244, 2.4068768966586286e-05, 0.01266631352490092, 0.37277277847812273, -0.003003352691471352, 2.1470435953147994e-05, 0.001264145770941025, 0.1569949090718874, 2.36, 0.36, -10.12> texture { Material402 } }
sphere { <5.1, 1.04, 9.06>, 0.174 texture { Material403 } }
sphere { <0, 0, 0>, 1 matrix <0.22476590405470492, 0.010260165242452393, -0.00013184714160297328, -0.020976337829013782, 0.459369585987104, -0.01181425923703075, -0.00011368153542656364, 0.004982535417356447, 0.19393597246855285, 5.1, 0.45, 9.06> texture { Material403 } }
sphere { <-9.89, 1.2, -3.24>, 0.201 texture { Material404 } }
sphere { <0, 0, 0>, 1 matrix <0.2639651820033421, -0.004286176032994471, -0.00010670031233866775, 0.00863729412709492, 0.5312709124894333, 0.026469127163677976, -9.053359834796052e-05, -0.01114489564786441, 0.22372255832764334, -9.89, 0.52, -3.24> texture { Material404 } }
sphere { <9.49, 1.11, -4.3>, 0.186 texture { Material405 } }
sphere { <0, 0, 0>, 1 matrix <0.266, 0, 0, 0, 0.491, 0, 0, 0, 0.207, 9.49, 0.48, -4.3> texture { Material405 } }
sphere { <-4.1, 1.04, 9.59>, 0.174 texture { Material406 } }
sphere { <0, 0, 0>, 1 matrix <0.229732808001745, 0.011082603412888723, 0.00011326617317330895, -0.022165206825777446, 0.459369585987104, 0.009396120284840439, 9.553755476357364e-05, -0.003962711598389229, 0.19395950038439372, -4.1, 0.45, 9.59> texture { Material406 } }
sphere { <-3.46, 1.22, -9.85>, 0.203 texture { Material407 } }
sphere { <0, 0, 0>, 1 matrix <0.2940006069460862, 0.024259431549029736, -0.00035085075296972996, -0.04416038895535244, 0.5349565528752674, -0.015503115271559901, -0.0002699766810987414, 0.006553458410882863, 0.22690522095238025, -3.46, 0.53, -9.85> texture { Material407 } }
sphere { <9.21, 1.06, 4.93>, 0.177 texture { Material408 } }
sphere { <0, 0, 0>, 1 matrix <0.2539227420011358, 0.006262600901765918, -0.0001446532744691035, -0.011588277259173154, 0.46935588133464967, -0.021697199974622078, -0.00011276121395623028, 0.009140522542500366, 0.1977888726206777, 9.21, 0.46, 4.93> texture { Material408 } }
sphere { <-10.13, 1.11, 2.59>, 0.184 texture { Material409 } }
sphere { <0, 0, 0>, 1 matrix <0.23699775162896555, 0.0010323016577363185, 8.723679613616463e-06, -0.0021255831602334323, 0.4879256752363189, 0.008247262661705716, 7.582607596645531e-06, -0.003481426451457741, 0.205970579482525, -10.13, 0.48, 2.59> texture { Material409 } }
sphere { <5.73, 1.04, -8.76>, 0.174 texture { Material410 } }
sphere { <0, 0, 0>, 1 matrix <0.2176283109435635, 0.012722383736891892, 0.00024336783457151682, -0.026845396876010418, 0.45887946311951916, 0.01757734319262587, 0.0002165750454443773, -0.007413053433411779, 0.19385819491072095, 5.73, 0.45, -8.76> texture { Material410 } }
sphere { <1.7, 0.99, 10.34>, 0.164 texture { Material411 } }
sphere { <0, 0, 0>, 1 matrix <0.19697075969621905, 0.0033940834347500814, -4.725705661570759e-06, -0.007494549716326322, 0.4349337473930302, -0.0012112403581941529, -4.413857064614312e-06, 0.000512340749213159, 0.1839992866493633, 1.7, 0.43, 10.34> texture { Material411 } }
sphere { <-8.25, 0.85, -6.48>, 0.142 texture { Material412 } }
sphere { <0, 0, 0>, 1 matrix <0.1929551868556124, 0.004158437811842812, -5.710061946162704e-05, -0.008122958834532332, 0.3767703417861991, -0.010350221740775068, -4.7041442976159056e-05, 0.004365212882714153, 0.15894006009685296, -8.25, 0.37, -6.48> texture { Material412 } }
sphere { <10.47, 1.08, -0.79>, 0.18 texture { Material413 } }
sphere { <0, 0, 0>, 1 matrix <0.2679976643263226, -0.0011185093803469512, 2.919592096774345e-05, 0.0019907797553190133, 0.4763462880779317, -0.02488474694148767, 2.189694072580759e-05, 0.010486025440752667, 0.20072628824092742, 10.47, 0.47, -0.79> texture { Material413 } }
sphere { <-7.19, 1.03, 7.66>, 0.172 texture { Material414 } }
sphere { <0, 0, 0>, 1 matrix <0.2388246290544562, 0.009152588200126483, 0.00016335923694490328, -0.017424383393546235, 0.45437643831333113, 0.016230932476180054, 0.00013123419871724447, -0.0068490967811572975, 0.19187775444503052, -7.19, 0.44, 7.66> texture { Material414 } }
sphere { <0.13, 0.96, -10.52>, 0.16 texture { Material415 } }
sphere { <0, 0, 0>, 1 matrix <0.19373415632675467, -0.010152667890426785, 2.6584367324535193e-06, 0.022189336007943074, 0.4234189227359393, -0.00022189336007943076, 2.452887500562783e-06, 9.367667795806157e-05, 0.17899997547112498, 0.13, 0.41, -10.52> texture { Material415 } }
sphere { <7.02, 1.14, 7.85>, 0.19 texture { Material416 } }
sphere { <0, 0, 0>, 1 matrix <0.26543704933950707, 0.017289300937893156, -0.0005029025900403713, -0.032693678089324274, 0.501085933140148, -0.029206352426463023, -0.00040080958303969445, 0.012309635615129544, 0.2116419434391512, 7.02, 0.49, 7.85> texture { Material416 } }
sphere { <-10.49, 1.14, -1.05>, 0.19 texture { Material417 } }
sphere { <0, 0, 0>, 1 matrix <0.23098747086960467, 0.002402624263735403, -0.0001252913039533535, -0.0052212873610180625, 0.4992499914748732, -0.052212873610180614, -0.00011498595860654088, 0.022050058178004563, 0.2108501404139346, -10.49, 0.49, -1.05> texture { Material417 } }
sphere { <8.45, 1.06, -6.32>, 0.177 texture { Material418 } }
sphere { <0, 0, 0>, 1 matrix <0.2698667907781446, 0.008478424911356901, 0.00017761229580723123, -0.014727338086764392, 0.4683572517998951, 0.01963645078235253, 0.0001302490169253029, -0.008290015468882304, 0.1978263346440996, 8.45, 0.46, -6.32> texture { Material418 } }
sphere { <-1.97, 1.22, 10.38>, 0.203 texture { Material419 } }
sphere { <0, 0, 0>, 1 matrix <0.3028221073071242, -0.010381239644370974, 3.448939963918097e-05, 0.01836417310027341, 0.5356734832822354, -0.0035604009071958645, 2.5724766727573927e-05, 0.00150121381534751, 0.2259950125452263, -1.97, 0.52, 10.38> texture { Material419 } }
sphere { <-5.56, 1.09, -8.99>, 0.182 texture { Material420 } }
sphere { <0, 0, 0>, 1 matrix <0.2305948236777347, -0.013673458464898513, -0.00025263935388306253, 0.02858995860842416, 0.48182343627549507, 0.01782668007348801, -0.00022311007875387337, -0.007529281024827233, 0.2038608843038358, -5.56, 0.47, -8.99> texture { Material420 } }
sphere { <10.18, 1.01, 2.87>, 0.168 texture { Material421 } }
sphere { <0, 0, 0>, 1 matrix <0.23999732053741196, -0.0011340388438739277, -9.526978090710812e-06, 0.0020979718611667665, 0.44393237664943774, 0.007459455506370725, -7.462799504390138e-06, -0.0031585081873821987, 0.18797346560176217, 10.18, 0.43, 2.87> texture { Material421 } }
sphere { <-9.46, 0.92, 4.77>, 0.153 texture { Material422 } }
sphere { <0, 0, 0>, 1 matrix <0.20589783265291428, -0.006483955493959913, 0.00020206430868059943, 0.012747582403173618, 0.40401344035522885, -0.025211885197387818, 0.00016773299409894422, 0.010645018194452634, 0.170668261411671, -9.46, 0.4, 4.77> texture { Material422 } }
sphere { <3.76, 1.13, -9.91>, 0.189 texture { Material423 } }
sphere { <0, 0, 0>, 1 matrix <0.28784591950022165, 0.009419306540783273, 5.7370398853631175e-05, -0.016352962744415406, 0.4996954135095479, 0.006088869106963183, 4.203178527123673e-05, -0.0025695027631384634, 0.21098434986718623, 3.76, 0.49, -9.91> texture { Material423 } }
sphere { <3.93, 0.91, 9.86>, 0.152 texture { Material424 } }
sphere { <0, 0, 0>, 1 matrix <0.1905983141248921, 0.012379705705307682, -0.00015981050945153554, -0.025990900459834453, 0.4000231841541895, -0.010340465774342738, -0.00014140301621628015, 0.004357951909885094, 0.1689437428860215, 3.93, 0.39, 9.86> texture { Material424 } }
sphere { <-9.56, 0.86, -4.62>, 0.144 texture { Material425 } }
sphere { <0, 0, 0>, 1 matrix <0.18087199551871208, 0.006800695398640486, -0.0002679163561840383, -0.014315275949624449, 0.37955017997295504, -0.02996220547595815, -0.00023831233892613357, 0.012661194439971817, 0.1605012067324802, -9.56, 0.37, -4.62> texture { Material425 } }
sphere { <10.18, 1.03, -3.06>, 0.171 texture { Material426 } }
sphere { <0, 0, 0>, 1 matrix <0.2238973861725223, -0.006770899330996226, 0.0003396871530296196, 0.013662707578617385, 0.44952389670645954, -0.045228273363698925, 0.00028964395637793455, 0.019111947372713486, 0.19004117862716272, 10.18, 0.44, -3.06> texture { Material426 } }
sphere { <-5.45, 1.2, 9.14>, 0.2 texture { Material427 } }
sphere { <0, 0, 0>, 1 matrix <0.2592680360750728, 0.019490947939873406, 0.0004340716298986746, -0.03965658253920397, 0.5269869952905334, 0.02351727569185352, 0.0003722998979515555, -0.009913709790705737, 0.22277921750237756, -5.45, 0.52, 9.14> texture { Material427 } }
sphere { <-2.16, 0.85, -10.43>, 0.142 texture { Material428 } }
sphere { <0, 0, 0>, 1 matrix <0.17997368128456184, -0.003077988959292423, -5.371166415949631e-06, 0.006429576937188618, 0.37594273337880313, 0.0013121585586099221, -4.74453033408884e-06, -0.0005548755606887703, 0.15899903172850324, -2.16, 0.37, -10.43> texture { Material428 } }
sphere { <8.64, 0.82, 6.24>, 0.136 texture { Material429 } }
sphere { <0, 0, 0>, 1 matrix <0.165, 0, 0, 0, 0.361, 0, 0, 0, 0.152, 8.64, 0.35, 6.24> texture { Material429 } }
sphere { <-10.6, 1.08, 1.24>, 0.18 texture { Material430 } }
sphere { <0, 0, 0>, 1 matrix <0.26199768900168696, -0.0011002700909536049, 1.9065736082888836e-05, 0.002003163486201792, 0.47670942448810866, -0.016526098761164783, 1.4626766994888002e-05, 0.00696382777986189, 0.20087932917229218, -10.6, 0.47, 1.24> texture { Material430 } }
sphere { <6.98, 1.13, -8.08>, 0.188 texture { Material431 } }
sphere { <0, 0, 0>, 1 matrix <0.2816032643848425, 0.014949459998526902, 0.0003393133550689039, -0.02640011021016453, 0.49678689702939244, 0.022579041627114403, 0.00025268015803003483, -0.009521282613843423, 0.20978389197010588, 6.98, 0.49, -8.08> texture { Material431 } }
sphere { <0.31, 1.02, 10.68>, 0.17 texture { Material432 } }
sphere { <0, 0, 0>, 1 matrix <0.20222821831613982, -0.017684659470779227, -2.315345051580541e-05, 0.03920244710271257, 0.4482876141412855, 0.0011760734130813772, -2.1670717231542008e-05, -0.0004965643299676925, 0.18999934987848305, 0.31, 0.44, 10.68> texture { Material432 } }
sphere { <-7.45, 0.83, -7.68>, 0.138 texture { Material433 } }
sphere { <0, 0, 0>, 1 matrix <0.1858689572113441, -0.00697957833373223, -0.00012740271119320766, 0.013771533593977035, 0.3664970392549286, 0.013388990994144341, -0.0001061689259943397, -0.0056547509648293545, 0.15489678021083883, -7.45, 0.36, -7.68> texture { Material433 } }
sphere { <10.69, 0.99, 0.63>, 0.165 texture { Material434 } }
sphere { <0, 0, 0>, 1 matrix <0.20099605026254333, 0.0012583502713857321, -6.582895761122372e-05, -0.0027295558125581053, 0.43361154638056715, -0.04549259687596842, -6.026133433067246e-05, 0.019198710608206857, 0.18299564442782212, 10.69, 0.43, 0.63> texture { Material434 } }
sphere { <-8.31, 0.85, 6.77>, 0.141 texture { Material435 } }
sphere { <0, 0, 0>, 1 matrix <0.18789827884282204, -0.006182309188362863, 0.00012594048031558204, 0.012298849130041013, 0.3734874459982106, -0.015227146541955543, 0.0001058435951588402, 0.006432858699542717, 0.15786895554885094, -8.31, 0.37, 6.77> texture { Material435 } }
sphere { <1.56, 0.92, -10.61>, 0.153 texture { Material436 } }
sphere { <0, 0, 0>, 1 matrix <0.21, 0, 0, 0, 0.405, 0, 0, 0, 0.171, 1.56, 0.4, -10.61> texture { Material436 } }
sphere { <6.02, 1.12, 8.89>, 0.186 texture { Material437 } }
sphere { <0, 0, 0>, 1 matrix <0.259, 0, 0, 0, 0.493, 0, 0, 0, 0.208, 6.02, 0.48, 8.89> texture { Material437 } }
sphere { <-10.46, 1.15, -2.49>, 0.192 texture { Material438 } }
sphere { <0, 0, 0>, 1 matrix <0.22899257437874024, -0.0018438814111178005, -3.131675053038784e-05, 0.004090357016802807, 0.5076905401257007, 0.01725063611434227, -2.926543499346287e-05, -0.007267000252892217, 0.2138765762089406, -10.46, 0.5, -2.49> texture { Material438 } }
sphere { <9.4, 0.94, -5.23>, 0.156 texture { Material439 } }
sphere { <0, 0, 0>, 1 matrix <0.19773878836652822, -0.010156597846341292, 0.00046378392065397103, 0.0211852268209038, 0.41073754278709684, -0.03761458639629859, 0.00040991003088103496, 0.015938384066228217, 0.1742722005574153, 9.4, 0.4, -5.23> texture { Material439 } }
sphere { <-3.4, 0.89, 10.22>, 0.148 texture { Material440 } }
sphere { <0, 0, 0>, 1 matrix <0.2248769029869292, -0.007441557882771149, 4.14642570343814e-05, 0.012931773920726752, 0.39076181336446647, -0.004355965952244801, 3.0407121825213023e-05, 0.0018381953506915402, 0.1649897576010694, -3.4, 0.38, 10.22> texture { Material440 } }
sphere { <-4.4, 0.83, -9.84>, 0.139 texture { Material441 } }
sphere { <0, 0, 0>, 1 matrix <0.19178127143566595, 0.009161561810320221, -9.854803448017722e-05, -0.017511943668685005, 0.3664970392549286, -0.007889996597978958, -7.955700700222642e-05, 0.0033322873915169987, 0.1549641556342078, -4.4, 0.36, -9.84> texture { Material441 } }
sphere { <9.9, 1.11, 4.29>, 0.186 texture { Material442 } }
sphere { <0, 0, 0>, 1 matrix <0.22979968774796547, 0.009585992368893119, -0.00046071817967940063, -0.020464009796202266, 0.4883102506258222, -0.047067222531265204, -0.00041464636171146055, 0.019843004203608752, 0.20604631336806364, 9.9, 0.48, 4.29> texture { Material442 } }
sphere { <-10.2, 1.03, 3.53>, 0.172 texture { Material443 } }
sphere { <0, 0, 0>, 1 matrix <0.20896915965391297, 0.0035892103796354574, 8.878281449297071e-05, -0.007813831209254227, 0.45437643831333113, 0.022494362572095496, 8.156124585000179e-05, -0.009492126623829308, 0.19176520247406817, -10.2, 0.45, 3.53> texture { Material443 } }
sphere { <5.15, 0.96, -9.5>, 0.16 texture { Material444 } }
sphere { <0, 0, 0>, 1 matrix <0.19997652371200425, 0.00306427806959874, 1.2805247997676699e-05, -0.006496269507549328, 0.4239354227463099, 0.003543419731390542, 1.1460696957920642e-05, -0.0014959248394313845, 0.17899374871075022, 5.15, 0.41, -9.5> texture { Material444 } }
sphere { <2.63, 1.02, 10.49>, 0.171 texture { Material445 } }
sphere { <0, 0, 0>, 1 matrix <0.21096971751089516, -0.0035746660311717555, -7.492574623871533e-06, 0.007657578417486415, 0.45193115821068885, 0.0018946585775224119, -6.782377977059066e-06, -0.0008006190006787183, 0.19099832188586136, 2.63, 0.44, 10.49> texture { Material445 } }
sphere { <-9.03, 1.11, -5.97>, 0.185 texture { Material446 } }
sphere { <0, 0, 0>, 1 matrix <0.2428193861453238, 0.009363301851827674, -0.00027256272614770193, -0.01891926423558596, 0.48980394867757365, -0.028550889664611535, -0.00023218306301470905, 0.012036729451272073, 0.2066496146503596, -9.03, 0.48, -5.97> texture { Material446 } }
sphere { <10.7, 0.92, -1.7>, 0.154 texture { Material447 } }
sphere { <0, 0, 0>, 1 matrix <0.21798648250143185, -0.0024262009568940097, 8.363952239033378e-05, 0.004518521048160404, 0.40501100440548865, -0.0279583489854925, 6.599081583090555e-05, 0.011844423708139679, 0.17159168182704626, 10.7, 0.4, -1.7> texture { Material447 } }
sphere { <-6.75, 0.98, 8.49>, 0.163 texture { Material448 } }
sphere { <0, 0, 0>, 1 matrix <0.21848930609978337, 0.01494183174364131, 0.00040593617709526193, -0.029406070691823764, 0.4293599148775423, 0.023374056190936836, 0.00033735335265450996, -0.009870251106149662, 0.1817318473350695, -6.75, 0.42, 8.49> texture { Material448 } }
sphere { <-0.76, 1.08, -10.83>, 0.18 texture { Material449 } }
sphere { <0, 0, 0>, 1 matrix <0.22178433940404513, 0.02325294720548255, -8.509624171684141e-05, -0.04973836689244474, 0.47438694409066634, -0.003481685682471132, -7.708269429059178e-05, 0.0014744245447781317, 0.20199460421139967, -0.76, 0.47, -10.83> texture { Material449 } }
sphere { <7.89, 0.99, 7.48>, 0.165 texture { Material450 } }
sphere { <0, 0, 0>, 1 matrix <0.25092785248631483, 0.006017226964362124, -7.632997824662798e-05, -0.010476207902096605, 0.43673379140734486, -0.011083524302218147, -5.5955043814261154e-05, 0.004666747074618167, 0.18394080118552983, 7.89, 0.43, 7.48> texture { Material450 } }
sphere { <-10.87, 1.19, -0.19>, 0.199 texture { Material451 } }
sphere { <0, 0, 0>, 1 matrix <0.2709997360486287, 0.0003780044943528669, -1.319756856432712e-05, -0.0007336913801830553, 0.5247186904366675, -0.03668456900915276, -1.0811292329448785e-05, 0.0154828409126082, 0.22145943538352758, -10.87, 0.51, -0.19> texture { Material451 } }
sphere { <8.15, 0.95, -7.21>, 0.158 texture { Material452 } }
sphere { <0, 0, 0>, 1 matrix <0.20877780799646778, 0.00963136213257651, 0.0002524909131047868, -0.01926272426515302, 0.4169817730086065, 0.021889459392219337, 0.00021383201731840792, -0.00926898160866704, 0.17675700907122907, 8.15, 0.41, -7.21> texture { Material452 } }
sphere { <-1.14, 0.86, 10.84>, 0.143 texture { Material453 } }
sphere { <0, 0, 0>, 1 matrix <0.17657319163898466, -0.012284385852849003, 4.3111955658115937e-05, 0.02630385445327555, 0.37807677504847337, -0.002656954995280359, 3.8971259351969205e-05, 0.0011216696549996238, 0.15999606350915638, -1.14, 0.37, 10.84> texture { Material453 } }
sphere { <-6.49, 1.02, -8.77>, 0.169 texture { Material454 } }
sphere { <0, 0, 0>, 1 matrix <0.2387878490396312, 0.010066711025825504, -0.00015646133327197148, -0.018869818157195923, 0.4473860315700491, -0.013916490890931993, -0.00012372883677155906, 0.005871019594611935, 0.18890874998288099, -6.49, 0.44, -8.77> texture { Material454 } }
sphere { <10.71, 1.21, 2.09>, 0.202 texture { Material455 } }
sphere { <0, 0, 0>, 1 matrix <0.2889856518546322, 0.002878809690166402, -7.400622347598976e-05, -0.005339245653734227, 0.5352654306284516, -0.027539267056102854, -5.787337891201968e-05, 0.011611705885595607, 0.22570149520350644, 10.71, 0.52, 2.09> texture { Material455 } }
sphere { <-9.32, 1, 5.7>, 0.166 texture { Material456 } }
sphere { <0, 0, 0>, 1 matrix <0.23975128525265577, -0.010915857016129573, 0.00040655295238959874, 0.020012404529570885, 0.438325667160368, -0.03271258432718317, 0.00031507853810193903, 0.013828501556491068, 0.18548496777425644, -9.32, 0.43, 5.7> texture { Material456 } }
sphere { <3.02, 1.07, -10.51>, 0.178 texture { Material457 } }
sphere { <0, 0, 0>, 1 matrix <0.2318697519939453, -0.007772815905581015, 3.7989001765957726e-05, 0.015746652912168434, 0.469713688698975, -0.004592773766049127, 3.2421648058877714e-05, 0.0019348280971866539, 0.19799054368598284, 3.02, 0.46, -10.51> texture { Material457 } }
sphere { <4.88, 0.83, 9.8>, 0.138 texture { Material458 } }
sphere { <0, 0, 0>, 1 matrix <0.172, 0, 0, 0, 0.365, 0, 0, 0, 0.154, 4.88, 0.36, 9.8> texture { Material458 } }
sphere { <-10.22, 1.12, -3.93>, 0.187 texture { Material459 } }
sphere { <0, 0, 0>, 1 matrix <0.23899525635882568, 0.0015057515760326038, -1.2254406367027149e-05, -0.0031249070364526, 0.4959244567975701, -0.008072676510835885, -1.07161963627978e-05, 0.003401591513638508, 0.20897231649272943, -10.22, 0.49, -3.93> texture { Material459 } }
sphere { <10.2, 1.19, -4.01>, 0.199 texture { Material460 } }
sphere { <0, 0, 0>, 1 matrix <0.281906127182592, -0.007271848749039031, 0.00023595059510645559, 0.01356380298579621, 0.5247186904366675, -0.03409280209943372, 0.00018574834082848635, 0.0143889773119283, 0.2215331190352149, 10.2, 0.51, -4.01> texture { Material460 } }
sphere { <-4.82, 0.84, 9.86>, 0.14 texture { Material461 } }
sphere { <0, 0, 0>, 1 matrix <0.20636425371566658, 0.016207966743500182, 0.00031080929456300734, -0.028970761812053467, 0.3685920382939458, 0.014163483552559473, 0.00023423309155473017, -0.005971630903241292, 0.1558854860441288, -4.82, 0.36, 9.86> texture { Material461 } }
sphere { <-3.11, 1.09, -10.53>, 0.181 texture { Material462 } }
sphere { <0, 0, 0>, 1 matrix <0.2626678255374414, 0.013213782232218458, -9.688421824625561e-05, -0.024116408636748517, 0.4793421766821954, -0.007033952519051651, -7.478135476802239e-05, 0.002974775752848928, 0.202978188771526, -3.11, 0.47, -10.53> texture { Material462 } }
sphere { <9.41, 1.01, 5.67>, 0.168 texture { Material463 } }
sphere { <0, 0, 0>, 1 matrix <0.25298968380483455, 0.0022846437880919127, -1.7061399696674793e-05, -0.0040184446075134436, 0.4449322243445941, -0.006645889158579925, -1.2678036138240557e-05, 0.002807701487220283, 0.18797903247869444, 9.41, 0.43, 5.67> texture { Material463 } }
sphere { <-10.78, 0.83, 2.18>, 0.138 texture { Material464 } }
sphere { <0, 0, 0>, 1 matrix <0.2059987455098847, 0.0007188953805150106, 6.147001564920133e-06, -0.0012702811578032226, 0.3639445610369264, 0.006224377673235789, 4.595331266979129e-06, -0.0026333905540612953, 0.1539774828767918, -10.78, 0.36, 2.18> texture { Material464 } }
sphere { <6.49, 1.04, -8.9>, 0.173 texture { Material465 } }
sphere { <0, 0, 0>, 1 matrix <0.20526269468585098, -0.017405106954114444, 0.0005370495498122406, 0.03869679118924474, 0.4554910280786692, -0.02818655160698073, 0.0005031580733677789, 0.011877738995954762, 0.19263350214409014, 6.49, 0.45, -8.9> texture { Material465 } }
sphere { <1.23, 1.16, 10.95>, 0.193 texture { Material466 } }
sphere { <0, 0, 0>, 1 matrix <0.27334068940812856, -0.018996371952037742, -7.3256732430165e-05, 0.03549687021694643, 0.51075279373303, 0.003944096690771825, -5.774983286465562e-05, -0.0016639157914193638, 0.21599358335190394, 1.23, 0.5, 10.95> texture { Material466 } }
sphere { <-8.31, 1.19, -7.25>, 0.198 texture { Material467 } }
sphere { <0, 0, 0>, 1 matrix <0.243, 0, 0, 0, 0.525, 0, 0, 0, 0.222, -8.31, 0.51, -7.25> texture { Material467 } }
sphere { <11.04, 1.06, -0.27>, 0.177 texture { Material468 } }
sphere { <0, 0, 0>, 1 matrix <0.26799959223474157, 0.0004670613781911694, 2.0388262923074654e-05, -0.0008173574118345464, 0.46721531340502864, 0.04086787059172732, 1.5062970368540228e-05, -0.017253386731688723, 0.197246851481573, 11.04, 0.46, -0.27> texture { Material468 } }
sphere { <-7.96, 0.86, 7.66>, 0.143 texture { Material469 } }
sphere { <0, 0, 0>, 1 matrix <0.17753318616440483, 0.012873637173528617, 0.0004871100893166873, -0.027338398042661895, 0.3759292764492073, 0.02852702404451676, 0.0004351151921424342, -0.011999462494915781, 0.1585459667560253, -7.96, 0.37, 7.66> texture { Material469 } }
sphere { <0.7, 0.9, -11.04>, 0.151 texture { Material470 } }
sphere { <0, 0, 0>, 1 matrix <0.21886706966638297, 0.007629269430093001, 7.975820017020413e-06, -0.01389990183838862, 0.39875693998061923, 0.0008339941103033172, 6.154856542814839e-06, -0.0003532456256673198, 0.16899963070860746, 0.7, 0.39, -11.04> texture { Material470 } }
sphere { <6.94, 0.92, 8.62>, 0.153 texture { Material471 } }
sphere { <0, 0, 0>, 1 matrix <0.22566682662712167, 0.012264213973566173, -0.00026910157040173073, -0.02203217200561003, 0.40501100440548865, -0.017795215850685022, -0.00020361225017122105, 0.007495029336125958, 0.1708355439517848, 6.94, 0.4, 8.62> texture { Material471 } }
sphere { <-10.95, 0.99, -1.67>, 0.164 texture { Material472 } }
sphere { <0, 0, 0>, 1 matrix <0.2339800170411461, 0.003055197392124146, -0.00013188752843600046, -0.0056795336135641175, 0.4333446936699093, -0.03748492184952318, -0.00010370643261634223, 0.01585569108117762, 0.18331553754473212, -10.95, 0.43, -1.67> texture { Material472 } }
sphere { <9.21, 0.93, -6.18>, 0.156 texture { Material473 } }
sphere { <0, 0, 0>, 1 matrix <0.2257309771118954, -0.01101666856247116, 0.00039873035201217714, 0.02008348428202707, 0.41043221561379917, -0.02976659277514726, 0.00030698708517751683, 0.012571328016688406, 0.173545001284469, 9.21, 0.4, -6.18> texture { Material473 } }
sphere { <-2.62, 1, 10.78>, 0.166 texture { Material474 } }
sphere { <0, 0, 0>, 1 matrix <0.20197100918104657, -0.003422192124628885, 7.172986132805924e-06, 0.007454279875429254, 0.4399329858688122, -0.0018443579073227018, 6.6048288153559485e-06, 0.0007796603880955058, 0.18599836581555085, -2.62, 0.43, 10.78> texture { Material474 } }
sphere { <-5.36, 0.88, -9.73>, 0.146 texture { Material475 } }
sphere { <0, 0, 0>, 1 matrix <0.18197863657792387, -0.002788493043334853, -1.1652775677885795e-05, 0.005914056674325568, 0.38594121033036705, 0.0032258490950866727, -1.0436277118106507e-05, -0.0013622108873034397, 0.16299430748520832, -5.36, 0.38, -9.73> texture { Material475 } }
sphere { <10.53, 0.9, 3.56>, 0.151 texture { Material476 } }
sphere { <0, 0, 0>, 1 matrix <0.22991081453821952, -0.006399004263883999, -0.0002647693396608134, 0.011073059552286223, 0.39648548984051474, 0.032873145545849726, -0.00019339673505659415, -0.013876101637444106, 0.16742585344280075, 10.53, 0.39, 3.56> texture { Material476 } }
sphere { <-10.18, 1.13, 4.49>, 0.189 texture { Material477 } }
sphere { <0, 0, 0>, 1 matrix <0.235, 0, 0, 0, 0.5, 0, 0, 0, 0.211, -10.18, 0.49, 4.49> texture { Material477 } }
sphere { <4.47, 0.93, -10.2>, 0.156 texture { Material478 } }
sphere { <0, 0, 0>, 1 matrix <0.18490521985091224, -0.005920977429771849, 4.1208760472933746e-05, 0.013186176762518927, 0.4117490207318674, -0.005733120331529968, 3.8758509850218756e-05, 0.002421269266228676, 0.17398314847397817, 4.47, 0.4, -10.2> texture { Material478 } }
sphere { <3.59, 1.14, 10.55>, 0.191 texture { Material479 } }
sphere { <0, 0, 0>, 1 matrix <0.24546181970189557, 0.01626229398174391, -0.00018128178462464638, -0.03338397748284827, 0.5037698453812113, -0.011245129257380472, -0.00015696349644329138, 0.0047429951125188925, 0.21294712808540858, 3.59, 0.49, 10.55> texture { Material479 } }
sphere { <-9.78, 1.21, -5.36>, 0.201 texture { Material480 } }
sphere { <0, 0, 0>, 1 matrix <0.2908374585383562, -0.009720283499611118, -0.0002979926796803596, 0.017770415195165343, 0.5307040747382265, 0.032579094524469804, -0.00023040671109306155, -0.01377875238346937, 0.22457758769632938, -9.78, 0.52, -5.36> texture { Material480 } }
sphere { <10.84, 1.05, -2.66>, 0.174 texture { Material481 } }
sphere { <0, 0, 0>, 1 matrix <0.2639420481292562, -0.005526334166564836, 0.00023422214425617652, 0.009671084791488462, 0.46024195051838646, -0.03908730103226587, 0.000173004992916494, 0.016497886799332995, 0.1943007714869625, 10.84, 0.45, -2.66> texture { Material481 } }
sphere { <-6.2, 1.05, 9.29>, 0.175 texture { Material482 } }
sphere { <0, 0, 0>, 1 matrix <0.2254090246568391, -0.016328276619376896, 0.0003987303520121771, 0.03352354137783575, 0.46223433991456997, -0.022618292977816895, 0.0003458015442229501, 0.009554278930284724, 0.19576668811474116, -6.2, 0.45, 9.29> texture { Material482 } }
sphere { <-1.7, 1.2, -11.05>, 0.2 texture { Material483 } }
sphere { <0, 0, 0>, 1 matrix <0.26436896000379834, 0.018276866384379108, -9.561212063661306e-05, -0.03648476346164735, 0.527711382587447, -0.005527994463885961, -8.081930197208048e-05, 0.0023407764837626755, 0.22398775465121637, -1.7, 0.52, -11.05> texture { Material483 } }
sphere { <8.73, 1.14, 7>, 0.191 texture { Material484 } }
sphere { <0, 0, 0>, 1 matrix <0.251, 0, 0, 0, 0.505, 0, 0, 0, 0.213, 8.73, 0.49, 7> texture { Material484 } }
sphere { <-11.18, 1.22, 0.73>, 0.203 texture { Material485 } }
sphere { <0, 0, 0>, 1 matrix <0.253, 0, 0, 0, 0.537, 0, 0, 0, 0.227, -11.18, 0.53, 0.73> texture { Material485 } }
sphere { <7.75, 0.84, -8.1>, 0.14 texture { Material486 } }
sphere { <0, 0, 0>, 1 matrix <0.19062113656584748, -0.012018754889929721, 0.00036307745772948746, 0.02340825559714061, 0.37058442769012934, -0.02243291161392642, 0.00029844586839544257, 0.00946765355749045, 0.15671398937612105, 7.75, 0.36, -8.1> texture { Material486 } }
sphere { <-0.25, 1.14, 11.22>, 0.19 texture { Material487 } }
sphere { <0, 0, 0>, 1 matrix <0.2528459408594874, -0.00882780728079743, 3.081182810251344e-06, 0.017585829523801996, 0.5036929768176243, -0.0003517165904760399, 2.5940392829388785e-06, 0.00014864213049880256, 0.21299994811921433, -0.25, 0.49, 11.22> texture { Material487 } }
sphere { <-7.4, 1.16, -8.45>, 0.193 texture { Material488 } }
sphere { <0, 0, 0>, 1 matrix <0.282975708819465, 0.003707797348529458, -2.137623887078349e-05, -0.006694998039217503, 0.510922172224916, -0.005891598274511403, -1.6315433201728743e-05, 0.0024903820494999278, 0.2159856424187825, -7.4, 0.5, -8.45> texture { Material488 } }
sphere { <11.17, 1.19, 1.23>, 0.198 texture { Material489 } }
sphere { <0, 0, 0>, 1 matrix <0.295, 0, 0, 0, 0.523, 0, 0, 0, 0.221, 11.17, 0.51, 1.23> texture { Material489 } }
sphere { <-9.08, 0.86, 6.65>, 0.144 texture { Material490 } }
sphere { <0, 0, 0>, 1 matrix <0.20495671092560863, -0.004212257653669104, 5.9430763147478315e-05, 0.007828634956331359, 0.3807679050942755, -0.010747786973946443, 4.667489203289761e-05, 0.004541715755394691, 0.1609359209109379, -9.08, 0.37, 6.65> texture { Material490 } }
sphere { <2.2, 0.86, -11.04>, 0.143 texture { Material491 } }
sphere { <0, 0, 0>, 1 matrix <0.17308492215737104, -0.017820629786784243, 0.00018675058012835644, 0.038816199363167984, 0.37692379834457557, -0.00792167333942204, 0.00017172467138239675, 0.0033442420430277735, 0.15996495414869746, 2.2, 0.37, -11.04> texture { Material491 } }
sphere { <5.84, 0.98, 9.64>, 0.163 texture { Material492 } }
sphere { <0, 0, 0>, 1 matrix <0.24597256377531293, 0.0036739072651924974, -1.6589345159612643e-05, -0.006436805005276287, 0.43093435661240465, -0.0038920216310972897, -1.2273417963615858e-05, 0.0016434986934099924, 0.18199257886355688, 5.84, 0.42, 9.64> texture { Material492 } }
sphere { <-10.82, 1.1, -3.17>, 0.183 texture { Material493 } }
sphere { <0, 0, 0>, 1 matrix <0.2779966804854726, 0.0013584953170781486, -1.1381192665443434e-05, -0.0023651501203806615, 0.48392628445569336, -0.00810908612701941, -8.351666560253455e-06, 0.003417879276677603, 0.20397136571465055, -10.82, 0.47, -3.17> texture { Material493 } }
sphere { <10.13, 0.84, -4.98>, 0.141 texture { Material494 } }
sphere { <0, 0, 0>, 1 matrix <0.1949770849956406, 0.0029890014479542447, 4.6871599826051464e-05, -0.005702095069943482, 0.3717733876511036, 0.011663376279429849, 3.7737647039436314e-05, -0.00492244644051206, 0.15692280935832842, 10.13, 0.36, -4.98> texture { Material494 } }
sphere { <-4.11, 0.91, 10.52>, 0.152 texture { Material495 } }
sphere { <0, 0, 0>, 1 matrix <0.17914244114099903, 0.017546383836905148, 0.00033195826800038044, -0.03928440381262653, 0.4007923238334142, 0.015206865991984465, 0.00031351614200035935, -0.006414806994137367, 0.16987863891277405, -4.11, 0.39, 10.52> texture { Material495 } }
sphere { <-4.08, 0.95, -10.54>, 0.158 texture { Material496 } }
sphere { <0, 0, 0>, 1 matrix <0.23450215139405192, 0.015287375584538365, -0.00019271558939924758, -0.02719201274185973, 0.4169817730086065, -0.010525940416203765, -0.00014515174180283752, 0.004457156587722647, 0.17694381222897954, -4.08, 0.41, -10.54> texture { Material496 } }
sphere { <10.14, 0.9, 5.02>, 0.151 texture { Material497 } }
sphere { <0, 0, 0>, 1 matrix <0.18591259707476698, 0.005698621507692326, -0.00017877871070385502, -0.012193824516459924, 0.39703049200341006, -0.024941913783668022, -0.00016147754515186908, 0.010528245014211627, 0.16766970502128029, 10.14, 0.39, 5.02> texture { Material497 } }
sphere { <-10.88, 1.2, 3.15>, 0.2 texture { Material498 } }
sphere { <0, 0, 0>, 1 matrix <0.25497260165881347, 0.00373678727574619, 9.393716978249117e-05, -0.00778130997420089, 0.5302722829546788, 0.02667877705440305, 8.251735698540402e-05, -0.011254324030482642, 0.2237170833474786, -10.88, 0.52, 3.15> texture { Material498 } }
sphere { <5.9, 1.12, -9.68>, 0.187 texture { Material499 } }
sphere { <0, 0, 0>, 1 matrix <0.2559716282567491, 0.003811197492795067, 1.7356831165288614e-05, -0.007354420161877981, 0.4939247614072573, 0.00449917468726653, 1.4170225443536408e-05, -0.001903496983074301, 0.20899133115619922, 5.9, 0.48, -9.68> texture { Material499 } }
sphere { <2.19, 0.83, 11.13>, 0.138 texture { Material500 } }
sphere { <0, 0, 0>, 1 matrix <0.18700742571259174, -0.01929211486630961, -0.00019243787204854243, 0.03755805340994318, 0.36399501370478804, 0.007281663416213474, -0.0001586588838698089, -0.0030837645615111706, 0.15496923960414768, 2.19, 0.36, 11.13> texture { Material500 } }
sphere { <-9.14, 0.85, -6.73>, 0.141 texture { Material501 } }
sphere { <0, 0, 0>, 1 matrix <0.19598965206736926, -0.0020139713720317876, -1.4206483781198967e-05, 0.003832710825346208, 0.37294319029333395, 0.005261857234797336, -1.1452165497088965e-05, -0.002228883225463751, 0.15798427753550398, -9.14, 0.36, -6.73> texture { Material501 } }
sphere { <11.3, 0.98, -1.21>, 0.163 texture { Material502 } }
sphere { <0, 0, 0>, 1 matrix <0.19498697279996116, 0.0022509313547965752, 0.0001172448003497607, -0.004986678693703182, 0.42963345879909404, 0.04488010824332864, 0.00011002973571285236, -0.01901171251974338, 0.1820097323785843, 11.3, 0.42, -1.21> texture { Material502 } }
sphere { <-7.52, 0.89, 8.53>, 0.149 texture { Material503 } }
sphere { <0, 0, 0>, 1 matrix <0.1963918019542098, -0.015458773264803664, 0.0005352142802953915, 0.030917546529607327, 0.3918416267750997, -0.027207440946054453, 0.00045370956756005267, 0.01153208791368298, 0.16660073558054717, -7.52, 0.39, 8.53> texture { Material503 } }
sphere { <-0.22, 1.08, -11.38>, 0.18 texture { Material504 } }
sphere { <0, 0, 0>, 1 matrix <0.24540099596553056, -0.017156661551809088, -1.1980080689389193e-05, 0.03333692773075099, 0.47683561602419594, 0.0006667385546150198, -9.837302029498444e-06, -0.0002817598075988159, 0.20199980325395941, -0.22, 0.47, -11.38> texture { Material504 } }
sphere { <7.85, 1.14, 8.25>, 0.19 texture { Material505 } }
sphere { <0, 0, 0>, 1 matrix <0.2539798345630413, 0.003200509626044196, -1.932521041872658e-05, -0.0063254166624967965, 0.5019235429685084, -0.006061857634892764, -1.6129703184133996e-05, 0.002559987686448737, 0.2119845423677819, 7.85, 0.49, 8.25> texture { Material505 } }
sphere { <-11.37, 1.15, -0.78>, 0.192 texture { Material506 } }
sphere { <0, 0, 0>, 1 matrix <0.2269957880014802, 0.0013815241542543036, -6.017140742577698e-05, -0.0030977788304644956, 0.5070631013286985, -0.04425398329234993, -5.6990540072872466e-05, 0.018692743433900268, 0.21418584942753038, -11.37, 0.5, -0.78> texture { Material506 } }
sphere { <8.92, 0.92, -7.11>, 0.153 texture { Material507 } }
sphere { <0, 0, 0>, 1 matrix <0.2215291257863248, -0.01443937333366539, 0.0005923901397849256, 0.0264071422228295, 0.403775889519519, -0.033221888602914536, 0.00045630051307757796, 0.013992470322902429, 0.17042594451580564, 8.92, 0.4, -7.11> texture { Material507 } }
sphere { <-1.77, 1.14, 11.28>, 0.19 texture { Material508 } }
sphere { <0, 0, 0>, 1 matrix <0.2341285169990396, 0.020219240596734404, 0.00014084573752894884, -0.043277778809180455, 0.501085933140148, 0.0069943884944130025, 0.00012706083555803042, -0.0029479331228937505, 0.21197946491546535, -1.77, 0.49, 11.28> texture { Material508 } }
sphere { <-6.32, 0.91, -9.52>, 0.152 texture { Material509 } }
sphere { <0, 0, 0>, 1 matrix <0.197, 0, 0, 0, 0.402, 0, 0, 0, 0.17, -6.32, 0.39, -9.52> texture { Material509 } }
sphere { <11.1, 0.87, 2.76>, 0.145 texture { Material510 } }
sphere { <0, 0, 0>, 1 matrix <0.18199840095930245, 0.0007628934980289357, -6.462789485993455e-06, -0.0016054297238740792, 0.38294166724489787, -0.006488611800657737, -5.752592839180988e-06, 0.00274453031777168, 0.16197674993727498, 11.1, 0.37, 2.76> texture { Material510 } }
sphere { <-10.05, 1.02, 5.47>, 0.17 texture { Material511 } }
sphere { <0, 0, 0>, 1 matrix <0.24278796954717574, -0.01014153528713066, 0.00038872249684449007, 0.018738886188978048, 0.4472914194431938, -0.0343546246797931, 0.0003023397197679367, 0.01446107809461224, 0.18844571051375877, -10.05, 0.44, 5.47> texture { Material511 } }
sphere { <3.72, 0.91, -10.83>, 0.152 texture { Material512 } }
sphere { <0, 0, 0>, 1 matrix <0.22596908661814444, -0.003737885034676256, 1.0412928625031558e-05, 0.0066653436680288985, 0.4029386211480257, -0.0022451683934413135, 7.832733921483915e-06, 0.0009470933669603555, 0.16999736160541593, 3.72, 0.39, -10.83> texture { Material512 } }
sphere { <4.58, 1.16, 10.51>, 0.194 texture { Material513 } }
sphere { <0, 0, 0>, 1 matrix <0.2846823460061169, 0.027415938175034314, -0.0005728930408187328, -0.049176140852421696, 0.5101897323239242, -0.02138093080540074, -0.00043467758691491273, 0.009044175408912204, 0.2168110097448196, 4.58, 0.5, 10.51> texture { Material513 } }
sphere { <-10.48, 0.83, -4.66>, 0.138 texture { Material514 } }
sphere { <0, 0, 0>, 1 matrix <0.18992190142666987, 0.005444383479105818, -0.0001733407359278483, -0.010516256509641239, 0.36610600644535546, -0.023340959570179336, -0.0001414095477306131, 0.009857898456070291, 0.1546861397843052, -10.48, 0.36, -4.66> texture { Material514 } }
sphere { <10.89, 1.03, -3.65>, 0.171 texture { Material515 } }
sphere { <0, 0, 0>, 1 matrix <0.22891120230109682, -0.0063711825062149376, 0.0002636181686188099, 0.01263107798175363, 0.4522723929336525, -0.0374985127583311, 0.00022102484006467904, 0.01585840187136469, 0.191343832506058, 10.89, 0.44, -3.65> texture { Material515 } }
sphere { <-5.57, 0.97, 10.05>, 0.162 texture { Material516 } }
sphere { <0, 0, 0>, 1 matrix <0.23097302788124638, -0.0035298965876907834, 1.4881168967509716e-05, 0.006570803171891935, 0.4299345089172482, -0.0036252707155265845, 1.1660136723459994e-05, 0.001525986045372818, 0.18099356682111808, -5.57, 0.42, 10.05> texture { Material516 } }
sphere { <-2.69, 1.11, -11.18>, 0.185 texture { Material517 } }
sphere { <0, 0, 0>, 1 matrix <0.25085523658151443, -0.008523444221850217, -3.432534665121112e-05, 0.016639393102416758, 0.4897015052393569, 0.003945423106758612, -2.8308154409564552e-05, -0.0016667399655082302, 0.20699328775720185, -2.69, 0.48, -11.18> texture { Material517 } }
sphere { <9.54, 1.08, 6.44>, 0.18 texture { Material518 } }
sphere { <0, 0, 0>, 1 matrix <0.2649873744222212, -0.0025867057514452957, -1.8712909922169123e-05, 0.004665831506380571, 0.477927198284755, 0.006915428839814058, -1.4264180393502502e-05, -0.002922419718917238, 0.2019788584469168, 9.54, 0.47, 6.44> texture { Material518 } }
sphere { <-11.39, 0.85, 1.7>, 0.141 texture { Material519 } }
sphere { <0, 0, 0>, 1 matrix <0.17598497008222952, 0.00229792624364893, 9.919745728519691e-05, -0.004883093267753977, 0.37257681708631285, 0.03222841556717625, 8.905226279011996e-05, -0.013615212993619914, 0.1574122550655852, -11.39, 0.37, 1.7> texture { Material519 } }
sphere { <7.26, 0.99, -8.96>, 0.165 texture { Material520 } }
sphere { <0, 0, 0>, 1 matrix <0.25, 0, 0, 0, 0.436, 0, 0, 0, 0.184, 7.26, 0.43, -8.96> texture { Material520 } }
sphere { <0.7, 0.91, 11.52>, 0.152 texture { Material521 } }
sphere { <0, 0, 0>, 1 matrix <0.21796691664417425, -0.0037977947142201316, -1.985001349543836e-06, 0.007003272821635289, 0.4019387734528693, 0.00042019636929811733, -1.5479368322130834e-06, -0.00017769498204149242, 0.1699999071237901, 0.7, 0.39, 11.52> texture { Material521 } }
sphere { <-8.3, 0.94, -8.03>, 0.156 texture { Material522 } }
sphere { <0, 0, 0>, 1 matrix <0.21560060179098606, 0.0131229471860694, -0.0004108095864143326, -0.02509156105484566, 0.41142841031189087, -0.025808462799269818, -0.0003328318408449454, 0.010935789321724499, 0.17465765867798805, -8.3, 0.4, -8.03> texture { Material522 } }
sphere { <11.55, 0.98, 0.31>, 0.164 texture { Material523 } }
sphere { <0, 0, 0>, 1 matrix <0.2129995334483313, 0.000445543417777943, -1.5551722289662682e-05, -0.0009078208606367477, 0.4329427978127637, -0.03026069535455826, -1.3361338868583431e-05, 0.012759694124157053, 0.1825546220377139, 11.55, 0.42, 0.31> texture { Material523 } }
sphere { <-8.73, 1.14, 7.58>, 0.191 texture { Material524 } }
sphere { <0, 0, 0>, 1 matrix <0.245, 0, 0, 0, 0.505, 0, 0, 0, 0.213, -8.73, 0.49, 7.58> texture { Material524 } }
sphere { <1.32, 1.08, -11.5>, 0.18 texture { Material525 } }
sphere { <0, 0, 0>, 1 matrix <0.2593743768106329, -0.018025754407043112, 6.951368770745584e-05, 0.03307032635445986, 0.47583805197393614, -0.003674480706051095, 5.373942780461009e-05, 0.0015483660836819082, 0.20099402895246618, 1.32, 0.47, -11.5> texture { Material525 } }
sphere { <6.8, 1.18, 9.38>, 0.196 texture { Material526 } }
sphere { <0, 0, 0>, 1 matrix <0.2847448105551241, 0.012056463454250238, -0.00018587873145281024, -0.021955454500897805, 0.5182887285376239, -0.015992244636456425, -0.00014283313048479103, 0.006748172592261959, 0.21889596105310366, 6.8, 0.51, 9.38> texture { Material526 } }
sphere { <-11.36, 0.92, -2.33>, 0.154 texture { Material527 } }
sphere { <0, 0, 0>, 1 matrix <0.206979838400791, 0.0028873406026215295, -9.879183612396309e-05, -0.00567704166795634, 0.4060085684557484, -0.027817504172986063, -8.208790247981474e-05, 0.01175580028932089, 0.1715977692778489, -11.36, 0.4, -2.33> texture { Material527 } }
sphere { <9.95, 0.93, -5.96>, 0.154 texture { Material528 } }
sphere { <0, 0, 0>, 1 matrix <0.194, 0, 0, 0, 0.408, 0, 0, 0, 0.172, 9.95, 0.4, -5.96> texture { Material528 } }
sphere { <-3.31, 1.19, 11.13>, 0.198 texture { Material529 } }
sphere { <0, 0, 0>, 1 matrix <0.25396454957488024, 0.004243517944569859, 1.0708982588257254e-05, -0.008771050869681796, 0.5249200399571055, 0.0026495882835497093, 9.35981942753193e-06, -0.0011203973313295913, 0.22199717255454796, -3.31, 0.51, 11.13> texture { Material529 } }
sphere { <-5.08, 1.01, -10.45>, 0.168 texture { Material530 } }
sphere { <0, 0, 0>, 1 matrix <0.21757140294428035, 0.013661651268441278, -0.0002095363383518301, -0.0278246475375593, 0.44291843831536193, -0.013603161018362326, -0.00017973988656785425, 0.005729259257733682, 0.18691212716656683, -5.08, 0.43, -10.45> texture { Material530 } }
sphere { <10.81, 1.22, 4.28>, 0.204 texture { Material531 } }
sphere { <0, 0, 0>, 1 matrix <0.25595205642525726, 0.004952806253786496, -0.00012050682300208913, -0.010427978792152036, 0.5382613192327154, -0.026210865612706476, -0.00010732638923623562, 0.011087342040254316, 0.22773023367029813, 10.81, 0.53, 4.28> texture { Material531 } }
sphere { <-10.87, 0.84, 4.15>, 0.14 texture { Material532 } }
sphere { <0, 0, 0>, 1 matrix <0.2029355586580952, 0.005111880154280777, 0.00016647346658743513, -0.009292038309998061, 0.3681011345458751, 0.024004432300828327, 0.00012793034870758562, -0.010148215281651, 0.15566951326583875, -10.87, 0.36, 4.15> texture { Material532 } }
sphere { <5.22, 1.08, -10.41>, 0.181 texture { Material533 } }
sphere { <0, 0, 0>, 1 matrix <0.2545053021051234, -0.015874149939096034, 0.0002501281490949168, 0.029818501258145096, 0.4778331800744558, -0.015076770299062129, 0.00019814072987126742, 0.006358053445533508, 0.20189981648489655, 5.22, 0.47, -10.41> texture { Material533 } }
sphere { <3.19, 1.03, 11.21>, 0.172 texture { Material534 } }
sphere { <0, 0, 0>, 1 matrix <0.23070662865971578, -0.01163807047813946, -8.251068945494301e-05, 0.022923472153911058, 0.45437643831333113, 0.006447226543287485, -6.85803133131994e-05, -0.002720587903980653, 0.19198071178688067, 3.19, 0.45, 11.21> texture { Material534 } }
sphere { <-9.93, 0.94, -6.12>, 0.157 texture { Material535 } }
sphere { <0, 0, 0>, 1 matrix <0.20192460881450564, 0.005516989042750108, -0.00012323559167351183, -0.011334408181887596, 0.41443125692314814, -0.018527397989623957, -0.00010676350763794341, 0.007812758188395644, 0.1748254827278995, -9.93, 0.41, -6.12> texture { Material535 } }
sphere { <11.46, 1.15, -2.2>, 0.191 texture { Material536 } }
sphere { <0, 0, 0>, 1 matrix <0.24896567438201395, 0.004130573028223967, 0.00017704792434914993, -0.008377266583345795, 0.5030783225363316, 0.04320905921936252, 0.00015145063408180296, -0.01822481111628558, 0.21221883357157806, 11.46, 0.49, -2.2> texture { Material536 } }
sphere { <-6.97, 1.04, 9.37>, 0.173 texture { Material537 } }
sphere { <0, 0, 0>, 1 matrix <0.2146648133157518, -0.011998113483989551, 0.00025139001318614276, 0.025502966800852213, 0.4558867709687397, -0.019127225100639158, 0.00022566638392988633, 0.00807779965956971, 0.1928307502120526, -6.97, 0.45, 9.37> texture { Material537 } }
sphere { <-1.19, 0.9, -11.63>, 0.15 texture { Material538 } }
sphere { <0, 0, 0>, 1 matrix <0.18101305479888993, 0.018927864485777626, -9.969143445556194e-05, -0.041391703655711515, 0.3958197143565728, -0.004180980167243588, -9.202286257436487e-05, 0.0017648358494897556, 0.16799070476135614, -1.19, 0.39, -11.63> texture { Material538 } }
sphere { <8.74, 0.86, 7.78>, 0.143 texture { Material539 } }
sphere { <0, 0, 0>, 1 matrix <0.17889293811812196, 0.006188852075388742, -0.00012166122940685855, -0.013069196002776227, 0.3774819641372289, -0.014851359094063894, -0.00010874746762624229, 0.0062862895636249284, 0.15987642333224292, 8.74, 0.37, 7.78> texture { Material539 } }
sphere { <-11.71, 1.11, 0.17>, 0.186 texture { Material540 } }
sphere { <0, 0, 0>, 1 matrix <0.22299991515025244, -0.00019434758919074054, 8.484974757931644e-06, 0.0004279133017607785, 0.48913159676304707, -0.042791330176077856, 7.876187331353589e-06, 0.01804033675447681, 0.20621238126686461, -11.71, 0.48, 0.17> texture { Material540 } }
sphere { <8.53, 0.84, -8.04>, 0.14 texture { Material541 } }
sphere { <0, 0, 0>, 1 matrix <0.19998562689077462, 0.002397666755687392, 1.5206332948606051e-05, -0.004435683498021675, 0.36994364720786477, 0.004692824570370757, 1.186093969991272e-05, -0.0019785963053455084, 0.15598745146959284, 8.53, 0.36, -8.04> texture { Material541 } }
sphere { <-0.86, 1.03, 11.7>, 0.171 texture { Material542 } }
sphere { <0, 0, 0>, 1 matrix <0.2311214747311026, 0.020170774310069126, 6.149676882282052e-05, -0.0394721186929801, 0.4522723929336525, 0.0027630483085086073, 5.062880536706345e-05, -0.0011624278126104494, 0.1909964559836243, -0.86, 0.44, 11.7> texture { Material542 } }
sphere { <-7.27, 1.21, -9.21>, 0.202 texture { Material543 } }
sphere { <0, 0, 0>, 1 matrix <0.26889957996939406, -0.007349117013862501, -7.98210499688385e-05, 0.014643593752528999, 0.5356734832822354, 0.011639779649446125, -6.706155127493495e-05, -0.004907817538759, 0.2259466946643712, -7.27, 0.52, -9.21> texture { Material543 } }
sphere { <11.59, 1.04, 1.88>, 0.173 texture { Material544 } }
sphere { <0, 0, 0>, 1 matrix <0.21399668162149885, 0.0011915676248738238, -2.053246697573779e-05, -0.002555745513163949, 0.458720389601765, -0.015813675362701937, -1.861354482847258e-05, 0.0066837756434949365, 0.19388482869137383, 11.59, 0.45, 1.88> texture { Material544 } }
sphere { <-9.83, 1.06, 6.45>, 0.177 texture { Material545 } }
sphere { <0, 0, 0>, 1 matrix <0.20976021049129862, 0.010025965023119851, 0.0003662239769257486, -0.022391321884967664, 0.46721531340502864, 0.034197655242496065, 0.0003452968925299915, -0.014437389633292583, 0.19747263747322694, -9.83, 0.46, 6.45> texture { Material545 } }
sphere { <2.89, 1.2, -11.4>, 0.199 texture { Material546 } }
sphere { <0, 0, 0>, 1 matrix <0.27955653580816664, 0.028443011144347885, 0.0003720268535653153, -0.053444519160909906, 0.5251075607544483, 0.013774360608481934, 0.0002952383926870651, -0.005817580332748999, 0.22292390763075076, 2.89, 0.52, -11.4> texture { Material546 } }
sphere { <5.58, 0.88, 10.37>, 0.146 texture { Material547 } }
sphere { <0, 0, 0>, 1 matrix <0.21236936210698157, 0.01637499899028368, -0.00033681796558938113, -0.029674880799293427, 0.38453115346341377, -0.015849084063258988, -0.00025775271545102875, 0.006692747933448744, 0.1628623366178841, 5.58, 0.38, 10.37> texture { Material547 } }
sphere { <-11.12, 0.9, -3.88>, 0.149 texture { Material548 } }
sphere { <0, 0, 0>, 1 matrix <0.20399659088817765, 0.0011793268002424605, -9.710803372730833e-06, -0.0022892814357647765, 0.39593968728193096, -0.0065209834836936036, -7.949530211990438e-06, 0.0027500107115576563, 0.1669773558836386, -11.12, 0.39, -3.88> texture { Material548 } }
sphere { <10.83, 1.05, -4.66>, 0.175 texture { Material549 } }
sphere { <0, 0, 0>, 1 matrix <0.23395114994818625, -0.00477976553620144, 0.00011523601966327956, 0.009457399330176355, 0.46236547459136773, -0.0223097625224673, 9.603001638606629e-05, 0.009396120284840439, 0.1947734676536534, 10.83, 0.45, -4.66> texture { Material549 } }
sphere { <-4.85, 1.19, 10.76>, 0.199 texture { Material550 } }
sphere { <0, 0, 0>, 1 matrix <0.27972040395182224, 0.026779903588776716, 0.0005765212964317641, -0.05012892984945392, 0.5231185169637118, 0.02258556180030341, 0.0004554723409532085, -0.009532309352979766, 0.22179478718704304, -4.85, 0.51, 10.76> texture { Material550 } }
sphere { <-3.7, 1.09, -11.22>, 0.182 texture { Material551 } }
sphere { <0, 0, 0>, 1 matrix <0.27284970001805764, -0.009057526959313977, -4.9045257265400934e-05, 0.015958499880696052, 0.48070698779618504, 0.005207510487385028, -3.6469550274272484e-05, -0.002197764301328817, 0.20298809940991053, -3.7, 0.47, -11.22> texture { Material551 } }
sphere { <10.31, 1.17, 5.78>, 0.195 texture { Material552 } }
sphere { <0, 0, 0>, 1 matrix <0.27863192906192613, -0.01431156969257182, -0.0006535137063760501, 0.02646870953895003, 0.513173298010029, 0.04699546387527863, -0.0005106307813260893, -0.019854672722501437, 0.21709336983723734, 10.31, 0.5, 5.78> texture { Material552 } }
sphere { <-11.51, 0.96, 2.71>, 0.16 texture { Material553 } }
sphere { <0, 0, 0>, 1 matrix <0.21098460757091675, 0.002547774337068739, 6.491589656844027e-05, -0.005119698193920119, 0.4234189227359393, 0.02159177064392398, 5.5070831686022785e-05, -0.009115393738826397, 0.17876774475332416, -11.51, 0.41, 2.71> texture { Material553 } }
sphere { <6.67, 1.07, -9.78>, 0.179 texture { Material554 } }
sphere { <0, 0, 0>, 1 matrix <0.247, 0, 0, 0, 0.474, 0, 0, 0, 0.2, 6.67, 0.46, -9.78> texture { Material554 } }
sphere { <1.69, 1, 11.72>, 0.167 texture { Material555 } }
sphere { <0, 0, 0>, 1 matrix <0.24566947536779796, 0.012747811098505708, -4.674085707907613e-05, -0.022904603681054972, 0.44139425436152163, -0.003239034863987572, -3.553065151946032e-05, 0.001370360903994742, 0.1869949754634215, 1.69, 0.43, 11.72> texture { Material555 } }
sphere { <-9.17, 0.85, -7.51>, 0.142 texture { Material556 } }
sphere { <0, 0, 0>, 1 matrix <0.20579878090413578, -0.009099521669712946, -0.00024593445050071947, 0.016608835668990622, 0.3750840828976939, 0.020299688039877428, -0.00018982319237676888, -0.008584176591331146, 0.15876799387598395, -9.17, 0.37, -7.51> texture { Material556 } }
sphere { <11.84, 0.99, -0.66>, 0.164 texture { Material557 } }
sphere { <0, 0, 0>, 1 matrix <0.19399735191027032, -0.001012671674151058, 4.413482882829997e-05, 0.0022706813312150013, 0.4333446936699093, -0.03784468885358336, 4.185983765158348e-05, 0.016007868388642155, 0.18330233603914028, 11.84, 0.43, -0.66> texture { Material557 } }
sphere { <-8.29, 0.82, 8.49>, 0.137 texture { Material558 } }
sphere { <0, 0, 0>, 1 matrix <0.18694143820298767, -0.00467925645751147, 5.693508042866186e-05, 0.009108285296974198, 0.36377826103495087, -0.008855277372058249, 4.658324762345061e-05, 0.0037221358184750335, 0.15295471073147718, -8.29, 0.36, 8.49> texture { Material558 } }
sphere { <0.38, 1.16, -11.87>, 0.194 texture { Material559 } }
sphere { <0, 0, 0>, 1 matrix <0.24863170530729176, -0.026120364296477402, 4.104884078124721e-05, 0.05370346899355754, 0.5111842542192925, -0.0016111040698067259, 3.563039379812258e-05, 0.0006801742862802715, 0.21699893108818605, 0.38, 0.5, -11.87> texture { Material559 } }
sphere { <7.75, 1.01, 9.02>, 0.168 texture { Material560 } }
sphere { <0, 0, 0>, 1 matrix <0.25291098874774137, -0.006710139727357775, -7.612804469490401e-05, 0.011775897387141708, 0.4437295271964785, 0.010071491186371198, -5.6569456136924706e-05, -0.004264505277112128, 0.18795161822830395, 7.75, 0.43, 9.02> texture { Material560 } }
sphere { <-11.81, 1.13, -1.42>, 0.188 texture { Material561 } }
sphere { <0, 0, 0>, 1 matrix <0.2839943643492532, -0.0017885346405798735, -4.649411866111867e-05, 0.003129935621014779, 0.4963188787730232, 0.025821968873371924, -3.4379453939559584e-05, -0.010910691073255742, 0.20971636950499864, -11.81, 0.49, -1.42> texture { Material561 } }
sphere { <9.67, 1.08, -6.94>, 0.179 texture { Material562 } }
sphere { <0, 0, 0>, 1 matrix <0.24768013533162686, -0.012583759949558012, 0.00044670755410729457, 0.024101959580806676, 0.47319248159357913, -0.03365963320767829, 0.00036204926764341213, 0.014243339525775446, 0.20049437947104973, 9.67, 0.46, -6.94> texture { Material562 } }
sphere { <-2.45, 1.11, 11.66>, 0.185 texture { Material563 } }
sphere { <0, 0, 0>, 1 matrix <0.2558508982268788, -0.008735951904202765, 3.1950379954548134e-05, 0.01668703312951231, 0.4887021144123378, -0.003575792813466923, 2.571007136967545e-05, 0.0015063667066956773, 0.2059944906989922, -2.45, 0.48, 11.66> texture { Material563 } }
sphere { <-6.08, 1.17, -10.26>, 0.195 texture { Material564 } }
sphere { <0, 0, 0>, 1 matrix <0.2917039411224457, 0.013144577166201663, -0.0001755697994798676, -0.02327310409221322, 0.5162914694681147, -0.01380149196166133, -0.00013107608317332586, 0.005819584618263384, 0.21792226883439722, -6.08, 0.51, -10.26> texture { Material564 } }
sphere { <11.42, 1.17, 3.46>, 0.195 texture { Material565 } }
sphere { <0, 0, 0>, 1 matrix <0.25399676499484314, 0.0012818960457554784, -1.0708982588257254e-05, -0.0025991199352916198, 0.5149215630055415, -0.00860398323406881, -9.191174032441265e-06, 0.003642074456363108, 0.21796957404458225, 11.42, 0.5, 3.46> texture { Material565 } }
sphere { <-10.77, 1.02, 5.16>, 0.169 texture { Material566 } }
sphere { <0, 0, 0>, 1 matrix <0.251971470204834, -0.003791389865129164, 5.9713524766011545e-05, 0.0067552938469960105, 0.448726481331574, -0.014138987121619557, 4.478514357450866e-05, 0.005951600369679502, 0.18890626365298357, -10.77, 0.44, 5.16> texture { Material566 } }
sphere { <4.45, 1.02, -11.09>, 0.171 texture { Material567 } }
sphere { <0, 0, 0>, 1 matrix <0.21529037690754937, 0.017492109782281273, 0.0002823231658136927, -0.03660385935921822, 0.450280003537469, 0.01456282576657069, 0.00024964687347414497, -0.006153760445608411, 0.19090067812560707, 4.45, 0.44, -11.09> texture { Material567 } }
sphere { <4.21, 1.12, 11.19>, 0.186 texture { Material568 } }
sphere { <0, 0, 0>, 1 matrix <0.28, 0, 0, 0, 0.492, 0, 0, 0, 0.208, 4.21, 0.48, 11.19> texture { Material568 } }
sphere { <-10.67, 1.15, -5.42>, 0.192 texture { Material569 } }
sphere { <0, 0, 0>, 1 matrix <0.22899289889768726, -0.0018033461088603122, -1.4044402351852912e-05, 0.004000435909611522, 0.5079226291394467, 0.007911973243453899, -1.312446333317259e-05, -0.0033329966025573508, 0.2139740427280744, -10.67, 0.5, -5.42> texture { Material569 } }
sphere { <11.54, 1.22, -3.22>, 0.203 texture { Material570 } }
sphere { <0, 0, 0>, 1 matrix <0.245, 0, 0, 0, 0.537, 0, 0, 0, 0.227, 11.54, 0.52, -3.22> texture { Material570 } }
sphere { <-6.34, 0.86, 10.17>, 0.144 texture { Material571 } }
sphere { <0, 0, 0>, 1 matrix <0.1785095373903331, 0.013238260313358783, 0.00030581786249819125, -0.028103569380314736, 0.37855398527486334, 0.017523402084196255, 0.000275065228280496, -0.007424388777777886, 0.16082848874001335, -6.34, 0.37, 10.17> texture { Material571 } }
sphere { <-2.2, 0.83, -11.79>, 0.139 texture { Material572 } }
sphere { <0, 0, 0>, 1 matrix <0.19354284819771336, 0.013310103723010487, -8.396665756285278e-05, -0.025179423022396126, 0.36610600644535546, -0.004624791983705411, -6.708676248578445e-05, 0.0019532500203660453, 0.15498767794158425, -2.2, 0.36, -11.79> texture { Material572 } }
sphere { <9.6, 0.96, 7.21>, 0.161 texture { Material573 } }
sphere { <0, 0, 0>, 1 matrix <0.2448791249653534, 0.007693385567712743, -0.00016116671286211723, -0.013377070415696442, 0.42541618180544843, -0.017836093887595262, -0.00011840819720482081, 0.007536377698983913, 0.17984212240372688, 9.6, 0.42, 7.21> texture { Material573 } }
sphere { <-11.96, 1.03, 1.16>, 0.172 texture { Material574 } }
sphere { <0, 0, 0>, 1 matrix <0.21599706910402958, 0.0011248464134937265, 2.9308959704163576e-05, -0.0023694681395353963, 0.45437643831333113, 0.02369468139535396, 2.605240862592318e-05, -0.009998634786610902, 0.19173947591374077, -11.96, 0.44, 1.16> texture { Material574 } }
sphere { <8.04, 0.9, -8.94>, 0.15 texture { Material575 } }
sphere { <0, 0, 0>, 1 matrix <0.21184034224295048, -0.008224870955988076, 0.00014455499624751254, 0.015363438200807916, 0.39545729576281125, -0.013910139992623385, 0.00011387115270440848, 0.0058661448958790535, 0.1668969004428217, 8.04, 0.39, -8.94> texture { Material575 } }
sphere { <0.11, 1.16, 12.03>, 0.193 texture { Material576 } }
sphere { <0, 0, 0>, 1 matrix <0.24805257456738788, 0.021700694936544574, -9.474254326120984e-06, -0.04453435788182441, 0.509055490724882, -0.00044534357881824405, -8.218630258803744e-06, 0.00018824699222062761, 0.21599991781369743, 0.11, 0.5, 12.03> texture { Material576 } }
sphere { <-8.22, 1.08, -8.8>, 0.179 texture { Material577 } }
sphere { <0, 0, 0>, 1 matrix <0.23282903167233598, -0.00892281611142038, -0.0001592581682349894, 0.01819029035589991, 0.4743490290084226, 0.016944380057550605, -0.000136702290330463, -0.007134475813705518, 0.19987266088024014, -8.22, 0.46, -8.8> texture { Material577 } }
sphere { <12.01, 1.13, 0.94>, 0.188 texture { Material578 } }
sphere { <0, 0, 0>, 1 matrix <0.24899903539540702, 0.0006929839624033796, -1.20575574121745e-05, -0.0013859679248067593, 0.49769663185550966, -0.01732459906008449, -1.0169024323520662e-05, 0.007305553820517555, 0.20987288719595598, 12.01, 0.49, 0.94> texture { Material578 } }
sphere { <-9.5, 0.98, 7.43>, 0.164 texture { Material579 } }
sphere { <0, 0, 0>, 1 matrix <0.24349051943025649, 0.01574628581586206, 0.0006491768549957531, -0.027943203927328988, 0.43062798069446234, 0.035605050165467576, 0.0004868826412468149, -0.015047861848223019, 0.18237961727970164, -9.5, 0.42, 7.43> texture { Material579 } }
sphere { <1.99, 0.94, -11.9>, 0.157 texture { Material580 } }
sphere { <0, 0, 0>, 1 matrix <0.215, 0, 0, 0, 0.416, 0, 0, 0, 0.176, 1.99, 0.41, -11.9> texture { Material580 } }
sphere { <6.58, 0.87, 10.13>, 0.145 texture { Material581 } }
sphere { <0, 0, 0>, 1 matrix <0.18468112802318132, 0.010855364182869663, -0.00020498912795486625, -0.022473537740751788, 0.3820670312495127, -0.014447274261911867, -0.00017950399312804504, 0.006110857520704236, 0.16188460457584627, 6.58, 0.37, 10.13> texture { Material581 } }
sphere { <-11.7, 1.01, -3.03>, 0.169 texture { Material582 } }
sphere { <0, 0, 0>, 1 matrix <0.219997912904525, 0.0009582547033839244, -8.097930443019502e-06, -0.0019469993291482465, 0.4469319197349069, -0.0075543573970951955, -6.95685842604857e-06, 0.003194124268570452, 0.18897300738930695, -11.7, 0.44, -3.03> texture { Material582 } }
sphere { <10.68, 1.07, -5.68>, 0.178 texture { Material583 } }
sphere { <0, 0, 0>, 1 matrix <0.239, 0, 0, 0, 0.471, 0, 0, 0, 0.199, 10.68, 0.46, -5.68> texture { Material583 } }
sphere { <-4.04, 1.05, 11.41>, 0.176 texture { Material584 } }
sphere { <0, 0, 0>, 1 matrix <0.259964745687102, 0.0042814538024250936, 1.2376514102500083e-05, -0.007657215454337186, 0.46492917824772195, 0.0026881713829056087, 9.377589531509678e-06, -0.0011388597041557095, 0.1969967078675049, -4.04, 0.46, 11.41> texture { Material584 } }
sphere { <-4.73, 0.93, -11.15>, 0.156 texture { Material585 } }
sphere { <0, 0, 0>, 1 matrix <0.19659321761799028, 0.012652155979460055, -0.00017244035759107697, -0.026460346515418995, 0.4109963887070475, -0.01121688602284066, -0.0001523077270093776, 0.004737228563044356, 0.1739354347678982, -4.73, 0.4, -11.15> texture { Material585 } }
sphere { <11.02, 1, 5.03>, 0.167 texture { Material586 } }
sphere { <0, 0, 0>, 1 matrix <0.20486300913130284, -0.007487281975787493, -0.00029681354884384753, 0.0161067870796209, 0.4393218618584598, 0.03489803867251195, -0.0002693040004144178, -0.014718900664596876, 0.1854165079991021, 11.02, 0.43, 5.03> texture { Material586 } }
sphere { <-11.54, 1, 3.74>, 0.166 texture { Material587 } }
sphere { <0, 0, 0>, 1 matrix <0.201997039282911, -0.0010936355040839737, 9.073165272821717e-06, 0.0023821763455294472, 0.4399329858688122, -0.007300217833074112, 8.354498716558608e-06, 0.00308600117489042, 0.18597439750393313, -11.54, 0.43, 3.74> texture { Material587 } }
sphere { <5.98, 0.91, -10.56>, 0.152 texture { Material588 } }
sphere { <0, 0, 0>, 1 matrix <0.22989363179866934, -0.006993888002121992, 5.990852718623834e-05, 0.012254508108065925, 0.4027545032886956, -0.0069019643367267845, 4.4280215746350075e-05, 0.0029114986035820183, 0.16997506056814288, 5.98, 0.39, -10.56> texture { Material588 } }
sphere { <2.72, 1.1, 11.84>, 0.183 texture { Material589 } }
sphere { <0, 0, 0>, 1 matrix <0.2351458845431593, -0.020059298496578667, -0.0001937169077370607, 0.04122355835101972, 0.4831544285744966, 0.00934967302806633, -0.00016827104273770102, -0.003951923651038345, 0.20496183543360588, 2.72, 0.47, 11.84> texture { Material589 } }
sphere { <-10.01, 1.01, -6.89>, 0.168 texture { Material590 } }
sphere { <0, 0, 0>, 1 matrix <0.24795078287900235, 0.004940066451297826, -7.080357757556494e-05, -0.008844312517646108, 0.4437295271964785, -0.01272339695521019, -5.367367977502505e-05, 0.005387384296350261, 0.18792278523260436, -10.01, 0.43, -6.89> texture { Material590 } }
sphere { <12.05, 1.11, -1.68>, 0.186 texture { Material591 } }
sphere { <0, 0, 0>, 1 matrix <0.2579876781928117, -0.0025199818572704457, 8.713277940281932e-05, 0.004805546797585501, 0.4908015127278335, -0.03398208092578319, 7.02465818441334e-05, 0.014366408196266063, 0.20750325631410219, 12.05, 0.48, -1.68> texture { Material591 } }
sphere { <-7.75, 1.03, 9.38>, 0.171 texture { Material592 } }
sphere { <0, 0, 0>, 1 matrix <0.2256744079203843, -0.01212387617569008, 0.0002706219882520216, 0.0243013978211841, 0.4518965147677004, -0.020198564422802365, 0.00022871150334573503, 0.00851639250497848, 0.19080990212708926, -7.75, 0.44, 9.38> texture { Material592 } }
sphere { <-0.62, 0.86, -12.16>, 0.143 texture { Material593 } }
sphere { <0, 0, 0>, 1 matrix <0.18974026095099156, -0.00993142515395925, -1.298695245042253e-05, 0.019758308990508407, 0.3774819641372289, 0.0009879154495254202, -1.0936381010882128e-05, -0.0004181652696403895, 0.15999945318094946, -0.62, 0.37, -12.16> texture { Material593 } }
sphere { <8.68, 0.85, 8.56>, 0.141 texture { Material594 } }
sphere { <0, 0, 0>, 1 matrix <0.17488178513751604, 0.006430151649167283, -0.0001199036462337198, -0.013742152667363223, 0.3734874459982106, -0.013938469134039838, -0.00010825586345672988, 0.005888444179621108, 0.15789019762420817, 8.68, 0.37, 8.56> texture { Material594 } }
sphere { <-12.19, 0.99, -0.45>, 0.164 texture { Material595 } }
sphere { <0, 0, 0>, 1 matrix <0.19999980537604445, -0.0002789728845123752, -4.865598889011484e-06, 0.000606766023814416, 0.43473500975330664, 0.015169150595360397, -4.476350977890565e-06, -0.006416376343784628, 0.18388809122555272, -12.19, 0.43, -0.45> texture { Material595 } }
sphere { <9.3, 0.95, -7.91>, 0.159 texture { Material596 } }
sphere { <0, 0, 0>, 1 matrix <0.19788536519337455, -0.006735300811844986, 0.00013403454313131114, 0.014287001722095424, 0.419424404596921, -0.016704802013526955, 0.00011981875825374783, 0.007039880848557788, 0.1768599042211187, 9.3, 0.41, -7.91> texture { Material596 } }
sphere { <-1.51, 0.86, 12.12>, 0.144 texture { Material597 } }
sphere { <0, 0, 0>, 1 matrix <0.19652706642026324, -0.013642172776264096, 5.7325282392336265e-05, 0.026384100648510763, 0.38007190314899303, -0.003198072805880092, 4.6849596269878875e-05, 0.0013514165925110101, 0.1609943212610582, -1.51, 0.37, 12.12> texture { Material597 } }
sphere { <-7.08, 1.19, -9.97>, 0.198 texture { Material598 } }
sphere { <0, 0, 0>, 1 matrix <0.2735551213978484, 0.015604375657305774, -0.0003146702307902117, -0.029784994411572698, 0.5217259982858881, -0.0210674350716002, -0.00025380336133079117, 0.008902300479586317, 0.22082048054930262, -7.08, 0.51, -9.97> texture { Material598 } }
sphere { <11.96, 0.9, 2.57>, 0.15 texture { Material599 } }
sphere { <0, 0, 0>, 1 matrix <0.19898802681339242, 0.0021822151386691356, -5.587487083547272e-05, -0.004364430277338271, 0.3974545548323204, -0.020367341294245264, -4.7170745227936765e-05, 0.008597269692043228, 0.16777986985560298, 11.96, 0.39, 2.57> texture { Material599 } }
sphere { <-10.56, 0.94, 6.19>, 0.156 texture { Material600 } }
sphere { <0, 0, 0>, 1 matrix <0.23896212006775266, -0.004254537881620818, 6.387596418173362e-05, 0.00736978528448125, 0.41374780238590564, -0.012427481067948774, 4.677110348034888e-05, 0.005253162287176414, 0.1749211310804057, -10.56, 0.4, 6.19> texture { Material600 } }
sphere { <3.61, 1.22, -11.7>, 0.204 texture { Material601 } }
sphere { <0, 0, 0>, 1 matrix <0.30991551506391635, -0.02594737361943273, 0.00032760482444193156, 0.04505331753856487, 0.5379451369695426, -0.013609856339774804, 0.00024017331180951895, 0.0057463837879049165, 0.22792744764539088, 3.61, 0.53, -11.7> texture { Material601 } }
sphere { <5.25, 1.22, 11.08>, 0.203 texture { Material602 } }
sphere { <0, 0, 0>, 1 matrix <0.27469316400299665, 0.012986306581650906, -0.0001465994207905114, -0.025358715033987404, 0.5362640601632062, -0.012115830516238426, -0.00012101115825253122, 0.005121589436100788, 0.22694218355772378, 5.25, 0.53, 11.08> texture { Material602 } }
sphere { <-11.36, 1.04, -4.63>, 0.174 texture { Material603 } }
sphere { <0, 0, 0>, 1 matrix <0.2078867601269446, -0.006856978745394807, -0.000277139689319768, 0.015197438469360608, 0.4592457558202947, 0.03719373099080359, -0.0002598184587372825, -0.015732706167476577, 0.19436412850887982, -11.36, 0.45, -4.63> texture { Material603 } }
sphere { <11.51, 0.91, -4.26>, 0.151 texture { Material604 } }
sphere { <0, 0, 0>, 1 matrix <0.216935638968325, 0.005281918821339656, 0.00017285534221287248, -0.009736255891870334, 0.3990256201039297, 0.026148801538166046, 0.00013462005914274401, -0.011047868649875154, 0.16863844898401664, 11.51, 0.39, -4.26> texture { Material604 } }
sphere { <-5.61, 1.21, 10.93>, 0.202 texture { Material605 } }
sphere { <0, 0, 0>, 1 matrix <0.26687164050996065, 0.008277867485921355, 6.634310721136401e-05, -0.01652473172283177, 0.532675310801178, 0.008540872575845633, 5.5907112818565185e-05, -0.0036054340141937475, 0.22497110418888028, -5.61, 0.52, 10.93> texture { Material605 } }
sphere { <-3.25, 1.1, -11.86>, 0.183 texture { Material606 } }
sphere { <0, 0, 0>, 1 matrix <0.21796906653521672, -0.003672324002387452, -8.377813378804213e-06, 0.00813638758327128, 0.482926436760537, 0.0022036049704693057, -7.839788666403942e-06, -0.0009307151428069117, 0.20399787672390285, -3.25, 0.47, -11.86> texture { Material606 } }
sphere { <10.41, 1.02, 6.55>, 0.17 texture { Material607 } }
sphere { <0, 0, 0>, 1 matrix <0.21199096085780267, -0.0019576272449494136, -1.4496737486242183e-05, 0.004146106759350409, 0.4489316151252197, 0.006649416500844996, -1.299235906785856e-05, -0.002813784265390978, 0.18997916319772137, 10.41, 0.44, 6.55> texture { Material607 } }
sphere { <-12.11, 0.88, 2.2>, 0.146 texture { Material608 } }
sphere { <0, 0, 0>, 1 matrix <0.17999642153825077, -0.0011348364848400771, 1.9482736190241097e-05, 0.002439898442406166, 0.3867642500563901, -0.013283891519766904, 1.7642699994496105e-05, 0.005595024076801048, 0.16290394530002997, -12.11, 0.38, 2.2> texture { Material608 } }
sphere { <7.45, 1.2, -9.81>, 0.199 texture { Material609 } }
sphere { <0, 0, 0>, 1 matrix <0.23697689840132144, -0.003308976260508954, 1.732619900892917e-05, 0.007371896479108557, 0.5279195830425746, -0.0055289223593314165, 1.6302710459878503e-05, 0.002335131981308534, 0.22298777296715508, 7.45, 0.52, -9.81> texture { Material609 } }
sphere { <1.13, 0.87, 12.27>, 0.145 texture { Material610 } }
sphere { <0, 0, 0>, 1 matrix <0.1949349186511076, 0.020405104799044657, -9.58573214003166e-05, -0.039873240500174, 0.3809018859260487, -0.0035885916450156597, -7.922901054515962e-05, 0.0015178899386228115, 0.16199286938905094, 1.13, 0.37, 12.27> texture { Material610 } }
sphere { <-9.13, 0.89, -8.29>, 0.148 texture { Material611 } }
sphere { <0, 0, 0>, 1 matrix <0.20598586638562472, 0.0024130076011741, -1.5610260653295498e-05, -0.004591742619709939, 0.3919402965013054, -0.005071476923261723, -1.2579142079840061e-05, 0.0021476152277077705, 0.1659861066191954, -9.13, 0.38, -8.29> texture { Material611 } }
sphere { <12.34, 1.17, -0.06>, 0.195 texture { Material612 } }
sphere { <0, 0, 0>, 1 matrix <0.24, 0, 0, 0, 0.5156856667418535, -0.018008140298490502, 0, 0.007608090281145211, 0.21786720029016288, 12.34, 0.5, -0.06> texture { Material612 } }
sphere { <-9.07, 1.16, 8.39>, 0.194 texture { Material613 } }
sphere { <0, 0, 0>, 1 matrix <0.2899794800860961, -0.0034497309652212677, 2.2028731102721183e-05, 0.006102455121236243, 0.5129218676152287, -0.00655116505662126, 1.6483567756174127e-05, 0.002771155589253048, 0.2169823044052029, -9.07, 0.5, 8.39> texture { Material613 } }
sphere { <1.02, 0.86, -12.32>, 0.143 texture { Material614 } }
sphere { <0, 0, 0>, 1 matrix <0.1713496503097975, -0.014943046269081113, 5.202797521619763e-05, 0.03283995052158524, 0.3765615958786798, -0.0026271960417268187, 4.8398116480183835e-05, 0.0011120406525827805, 0.1599961281506816, 1.02, 0.37, -12.32> texture { Material614 } }
sphere { <7.57, 1, 9.78>, 0.167 texture { Material615 } }
sphere { <0, 0, 0>, 1 matrix <0.21497948555272767, 0.002969939489352815, -1.5840269412803797e-05, -0.006091829371184146, 0.44093283356396856, -0.004703817615724468, -1.3703674933867471e-05, 0.0019839230760198435, 0.1859894186813802, 7.57, 0.43, 9.78> texture { Material615 } }
sphere { <-12.2, 0.88, -2.1>, 0.146 texture { Material616 } }
sphere { <0, 0, 0>, 1 matrix <0.20898541785924118, -0.0024673692209567213, -8.491952559540318e-05, 0.004556959422436816, 0.38505972340029215, 0.026537587224779103, -6.622910369402259e-05, -0.011206286833261643, 0.16261431286672304, -12.2, 0.38, -2.1> texture { Material616 } }
sphere { <10.42, 0.95, -6.7>, 0.158 texture { Material617 } }
sphere { <0, 0, 0>, 1 matrix <0.2269595636693145, 0.004283982084901805, 6.290095884412641e-05, -0.00786969396213239, 0.4167459748669629, 0.012241746163317049, 4.8769025359322674e-05, -0.005166780155260913, 0.17592413707166327, 10.42, 0.41, -6.7> texture { Material617 } }
sphere { <-3.16, 1.04, 11.98>, 0.174 texture { Material618 } }
sphere { <0, 0, 0>, 1 matrix <0.2518567783280628, 0.008494806440973232, 3.8389314127496585e-05, -0.015506392709713043, 0.4597197804287841, 0.004156352685077723, 2.9553678336247365e-05, -0.0017528965671849527, 0.1939920783954975, -3.16, 0.45, 11.98> texture { Material618 } }
sphere { <-5.77, 1.14, -10.98>, 0.191 texture { Material619 } }
sphere { <0, 0, 0>, 1 matrix <0.2747053060037038, -0.012726768415270467, -0.00015562491939238453, 0.023370974726223948, 0.5043079150510598, 0.012341975417219387, -0.0001205385739293742, -0.005205625274985603, 0.2129363447980373, -5.77, 0.49, -10.98> texture { Material619 } }
sphere { <11.68, 1.13, 4.2>, 0.188 texture { Material620 } }
sphere { <0, 0, 0>, 1 matrix <0.275, 0, 0, 0, 0.497, 0, 0, 0, 0.21, 11.68, 0.49, 4.2> texture { Material620 } }
sphere { <-11.46, 0.92, 4.79>, 0.153 texture { Material621 } }
sphere { <0, 0, 0>, 1 matrix <0.20582809888714668, 0.008404122196004058, 0.00040551031750014026, -0.01652266742418274, 0.40278136762415073, 0.038976548795508, 0.00033661293345885424, -0.016456765046992266, 0.17020593872107143, -11.46, 0.4, 4.79> texture { Material621 } }
sphere { <5.22, 1.22, -11.28>, 0.203 texture { Material622 } }
sphere { <0, 0, 0>, 1 matrix <0.26796635028791843, 0.004246748423435173, 1.5530636345350737e-05, -0.008525188999284042, 0.5379180599941386, 0.0039347026150541725, 1.3154680785054545e-05, -0.0016601812149020395, 0.22699392860886844, 5.22, 0.53, -11.28> texture { Material622 } }
sphere { <3.78, 0.83, 11.85>, 0.139 texture { Material623 } }
sphere { <0, 0, 0>, 1 matrix <0.20454591319767831, -0.013636305649372972, -0.00014339583231211213, 0.024412313040584784, 0.36610600644535546, 0.007709151486500457, -0.00010842123906525549, -0.003255908665960684, 0.15496576171397938, 3.78, 0.36, 11.85> texture { Material623 } }
sphere { <-10.8, 1.13, -6.19>, 0.189 texture { Material624 } }
sphere { <0, 0, 0>, 1 matrix <0.2759060859053189, -0.007197573022011772, -0.00016341052474512423, 0.013039081561615528, 0.4993147673772869, 0.022688001917211018, -0.00012492616203341018, -0.00957433680906305, 0.21078262847806187, -10.8, 0.49, -6.19> texture { Material624 } }
sphere { <12.15, 0.82, -2.73>, 0.137 texture { Material625 } }
sphere { <0, 0, 0>, 1 matrix <0.16795584499962185, -0.003846484541426635, 0.00019669045623002266, 0.008311154098439693, 0.3610114480186832, -0.037022413711231356, 0.00017912880835234204, 0.015604488423742143, 0.15220206258097593, 12.15, 0.35, -2.73> texture { Material625 } }
sphere { <-7.12, 1.14, 10.23>, 0.191 texture { Material626 } }
sphere { <0, 0, 0>, 1 matrix <0.2759716583792154, -0.00395517171572629, 1.9700882740550376e-05, 0.007222487480891486, 0.5039232383588212, -0.0050205095903757884, 1.5203942114989962e-05, 0.0021217629816469106, 0.2129894314060908, -7.12, 0.49, 10.23> texture { Material626 } }
sphere { <-1.66, 1.22, -12.36>, 0.203 texture { Material627 } }
sphere { <0, 0, 0>, 1 matrix <0.2570348739104591, -0.0222947871126044, -0.00012673372892961474, 0.046404266199490556, 0.5349565528752674, 0.006093489500943206, -0.00011150603281791687, -0.0025758326195793437, 0.22698535779367038, -1.66, 0.53, -12.36> texture { Material627 } }
sphere { <9.58, 1.2, 8>, 0.199 texture { Material628 } }
sphere { <0, 0, 0>, 1 matrix <0.2608538549532754, -0.008731290830091335, -0.00017583075934055853, 0.017663300989610057, 0.527276394350415, 0.021251159003124596, -0.00015023087867028565, -0.008975394806243911, 0.2228192534740998, 9.58, 0.52, 8> texture { Material628 } }
sphere { <-12.47, 1.19, 0.57>, 0.198 texture { Material629 } }
sphere { <0, 0, 0>, 1 matrix <0.2519976086382023, -0.0010967922241398277, 4.7827235954120827e-05, 0.002280631450195515, 0.5220060218000747, -0.0456126290039103, 4.194372676928851e-05, 0.019237387423404917, 0.22016112546461422, -12.47, 0.51, 0.57> texture { Material629 } }
sphere { <8.82, 1.14, -8.86>, 0.19 texture { Material630 } }
sphere { <0, 0, 0>, 1 matrix <0.2629198937530111, -0.0064902274147023665, 8.01062469889073e-05, 0.01243754607228134, 0.5036929768176243, -0.01243754607228134, 6.487692246630135e-05, 0.005256343875785566, 0.2129351230775337, 8.82, 0.49, -8.86> texture { Material630 } }
sphere { <-0.52, 0.97, 12.49>, 0.161 texture { Material631 } }
sphere { <0, 0, 0>, 1 matrix <0.1958807928272192, 0.00683483567055319, 4.768286911231254e-06, -0.014890177710848022, 0.4267398831371539, 0.000595607108433921, 4.379039000110335e-06, -0.00025107559606113764, 0.17999982483844, -0.52, 0.42, 12.49> texture { Material631 } }
sphere { <-8.06, 1.02, -9.57>, 0.169 texture { Material632 } }
sphere { <0, 0, 0>, 1 matrix <0.21898048449168417, 0.002923549504835049, -1.6434112265955974e-05, -0.00598059442084978, 0.4479317674300633, -0.005036290038610342, -1.4182864010345565e-05, 0.002124684860038738, 0.18898805653557024, -8.06, 0.44, -9.57> texture { Material632 } }
sphere { <12.42, 1.01, 1.61>, 0.168 texture { Material633 } }
sphere { <0, 0, 0>, 1 matrix <0.23397827110072555, -0.003184536244956732, -0.00016547392524388695, 0.006056062517118571, 0.4425622434388816, 0.04611924532267219, -0.0001329448630164562, -0.019484085664409824, 0.18698757373549008, 12.42, 0.44, 1.61> texture { Material633 } }
sphere { <-10.25, 1, 7.2>, 0.166 texture { Material634 } }
sphere { <0, 0, 0>, 1 matrix <0.20895852266819148, 0.004163201162585667, 5.9669144005214e-05, -0.008744714403708652, 0.438732573061383, 0.012580115457966832, 5.2817184884998044e-05, -0.005301415398004246, 0.1849240173831479, -10.25, 0.43, 7.2> texture { Material634 } }
sphere { <2.7, 0.97, -12.25>, 0.161 texture { Material635 } }
sphere { <0, 0, 0>, 1 matrix <0.1982759902652217, 0.0169589980362146, 0.00015514494316678414, -0.036389407846550925, 0.42537513608517535, 0.00779773025283234, 0.00014033210939709114, -0.003287099404004265, 0.1799699288337006, 2.7, 0.42, -12.25> texture { Material635 } }
sphere { <6.29, 1.06, 10.86>, 0.177 texture { Material636 } }
sphere { <0, 0, 0>, 1 matrix <0.24188918254734568, -0.00732252076754885, -6.368819118064269e-05, 0.014160907930631662, 0.46771490704493685, 0.008138452833696358, -5.2108520056889476e-05, -0.0034431915834869206, 0.19797005257467995, 6.29, 0.46, 10.86> texture { Material636 } }
sphere { <-11.98, 0.92, -3.76>, 0.154 texture { Material637 } }
sphere { <0, 0, 0>, 1 matrix <0.19493271229371298, 0.005117838967249331, -0.00021307773657555805, -0.01070809383916783, 0.40644743682143214, -0.03390896382403146, -0.0001879454907230563, 0.014294955337581891, 0.171404839279377, -11.98, 0.4, -3.76> texture { Material637 } }
sphere { <11.38, 1.22, -5.32>, 0.203 texture { Material638 } }
sphere { <0, 0, 0>, 1 matrix <0.274882361451572, 0.008038805707177122, 0.0002548835215940047, -0.015697595144560417, 0.5356918949895256, 0.034011456146547575, 0.00021039476146123302, -0.014377282207199813, 0.22654414468350068, 11.38, 0.53, -5.32> texture { Material638 } }
sphere { <-4.8, 0.83, 11.62>, 0.138 texture { Material639 } }
sphere { <0, 0, 0>, 1 matrix <0.207, 0, 0, 0, 0.364, 0, 0, 0, 0.154, -4.8, 0.36, 11.62> texture { Material639 } }
sphere { <-4.31, 1.06, -11.82>, 0.176 texture { Material640 } }
sphere { <0, 0, 0>, 1 matrix <0.22197010008378862, 0.0036434258372579405, -1.0814863310500151e-05, -0.007664323720718281, 0.46692887363803476, -0.002772202196855549, -9.596973298056441e-06, 0.0011694300487806062, 0.196996528754339, -4.31, 0.46, -11.82> texture { Material640 } }
sphere { <11.17, 0.87, 5.8>, 0.145 texture { Material641 } }
sphere { <0, 0, 0>, 1 matrix <0.217, 0, 0, 0, 0.383, 0, 0, 0, 0.162, 11.17, 0.37, 5.8> texture { Material641 } }
sphere { <-12.17, 0.91, 3.27>, 0.152 texture { Material642 } }
sphere { <0, 0, 0>, 1 matrix <0.23, 0, 0, 0, 0.401, 0, 0, 0, 0.169, -12.17, 0.39, 3.27> texture { Material642 } }
sphere { <6.77, 1.16, -10.63>, 0.194 texture { Material643 } }
sphere { <0, 0, 0>, 1 matrix <0.2647430253976627, -0.011666328168150582, 0.00016519795864541412, 0.022584250378344335, 0.5122969513290964, -0.014518446671792787, 0.0001352753095322825, 0.006141331243233986, 0.21691303730101497, 6.77, 0.5, -10.63> texture { Material643 } }
sphere { <2.19, 1.19, 12.42>, 0.199 texture { Material644 } }
sphere { <0, 0, 0>, 1 matrix <0.24541826181330806, 0.016907589566410523, -0.00010091376707921663, -0.036152000455007875, 0.5247186904366675, -0.0062712653850523865, -9.106852151051257e-05, 0.002646807824109562, 0.2219842023993298, 2.19, 0.51, 12.42> texture { Material644 } }
sphere { <-10.02, 1.12, -7.68>, 0.187 texture { Material645 } }
sphere { <0, 0, 0>, 1 matrix <0.228, 0, 0, 0, 0.496, 0, 0, 0, 0.21, -10.02, 0.49, -7.68> texture { Material645 } }
sphere { <12.58, 1.1, -1.1>, 0.184 texture { Material646 } }
sphere { <0, 0, 0>, 1 matrix <0.2679986882326089, -0.0008383872402577305, 1.4575193234213089e-05, 0.0015234872612146073, 0.48670333275829963, -0.016927636235717858, 1.1203320172566778e-05, 0.007160355368702009, 0.20587551866474924, 12.58, 0.48, -1.1> texture { Material646 } }
sphere { <-8.54, 1.17, 9.32>, 0.195 texture { Material647 } }
sphere { <0, 0, 0>, 1 matrix <0.296975474818504, -0.0038166540874645825, 2.253665326659625e-05, 0.006618103889037913, 0.5149215630055415, -0.006081500871007812, 1.646617427222689e-05, 0.0025624964835120295, 0.21698486892093902, -8.54, 0.5, 9.32> texture { Material647 } }
sphere { <0, 0.86, -12.65>, 0.143 texture { Material648 } }
sphere { <0, 0, 0>, 1 matrix <0.2149672544586241, -0.003752267384015955, 0, 0.006614462039730451, 0.3789422764642723, 0, 0, 0, 0.16, 0, 0.37, -12.65> texture { Material648 } }
sphere { <8.55, 0.83, 9.33>, 0.138 texture { Material649 } }
sphere { <0, 0, 0>, 1 matrix <0.1949355953373793, -0.005011004677099887, -5.9182662948759864e-05, 0.009353875397253122, 0.36377826103495087, 0.008595453067746112, -4.673912868773856e-05, -0.0036365378363541244, 0.15395705053039505, 8.55, 0.36, 9.33> texture { Material649 } }
sphere { <-12.62, 1.05, -1.11>, 0.175 texture { Material650 } }
sphere { <0, 0, 0>, 1 matrix <0.25999713699056953, -0.0012197314268191204, -3.181121589422904e-05, 0.002167368919963206, 0.46136684505661313, 0.02408187688848007, -2.385841192067178e-05, -0.010164428556826003, 0.19473490653421477, -12.62, 0.45, -1.11> texture { Material650 } }
sphere { <10.06, 1.2, -7.71>, 0.2 texture { Material651 } }
sphere { <0, 0, 0>, 1 matrix <0.2947315870457697, 0.012576595726124414, 0.00034761677679006427, -0.02255260725125361, 0.527711382587447, 0.029207474964738283, 0.00026277471601418427, -0.012312413832016327, 0.2226596852038505, 10.06, 0.52, -7.71> texture { Material651 } }
sphere { <-2.21, 0.92, 12.49>, 0.153 texture { Material652 } }
sphere { <0, 0, 0>, 1 matrix <0.18475387037095334, 0.009539683433337743, 4.269595605911239e-05, -0.020832605984153773, 0.40344633204084784, 0.0036138194054144306, 3.94649107357201e-05, -0.0015296116790244247, 0.17099315404609688, -2.21, 0.4, 12.49> texture { Material652 } }
sphere { <-6.81, 0.97, -10.71>, 0.162 texture { Material653 } }
sphere { <0, 0, 0>, 1 matrix <0.20345071772021786, 0.014955961100176387, -0.0003531100370027888, -0.0313781928964485, 0.4263713307832671, -0.02017169543343118, -0.00031329861126227836, 0.008530553442642625, 0.18079859374990281, -6.81, 0.42, -10.71> texture { Material653 } }
sphere { <12.26, 0.99, 3.3>, 0.165 texture { Material654 } }
sphere { <0, 0, 0>, 1 matrix <0.21196538415179333, -0.0038287391236193364, -0.00012914374138635153, 0.007874199329707692, 0.43493792591328334, 0.029376820576217152, -0.00011208702082589, -0.012397557307394395, 0.18358182919153418, 12.26, 0.43, 3.3> texture { Material654 } }
sphere { <-11.28, 0.89, 5.85>, 0.148 texture { Material655 } }
sphere { <0, 0, 0>, 1 matrix <0.2219714894663619, -0.003557361560671164, 5.516168464765098e-05, 0.006265443109110024, 0.39076181336446647, -0.012122270363278089, 4.099854940028113e-05, 0.0051155360868053315, 0.1649206767196386, -11.28, 0.38, 5.85> texture { Material655 } }
sphere { <4.36, 1.11, -11.94>, 0.185 texture { Material656 } }
sphere { <0, 0, 0>, 1 matrix <0.2594399265917644, -0.017055305670302837, 0.00020257974340437193, 0.032077094126069565, 0.48780882057705405, -0.011602353194535803, 0.00016128464186424994, 0.004911425585416996, 0.20694166300187888, 4.36, 0.48, -11.94> texture { Material656 } }
sphere { <4.85, 1.09, 11.76>, 0.182 texture { Material657 } }
sphere { <0, 0, 0>, 1 matrix <0.24548809062012428, -0.015860411610696172, -0.00021144083081823105, 0.03114056426002541, 0.48182343627549507, 0.012862406976967016, -0.00017534117677609403, -0.005432569406420851, 0.20392757647046203, 4.85, 0.47, 11.76> texture { Material657 } }
sphere { <-11.53, 0.92, -5.4>, 0.153 texture { Material658 } }
sphere { <0, 0, 0>, 1 matrix <0.21085899964246294, -0.007706421936054444, -0.00030550077466366747, 0.014791947318019194, 0.403458852727157, 0.032049219189041585, -0.00024758593586486795, -0.013531892546484226, 0.17046356380562613, -11.53, 0.4, -5.4> texture { Material658 } }
sphere { <12.16, 0.86, -3.81>, 0.143 texture { Material659 } }
sphere { <0, 0, 0>, 1 matrix <0.21192684618598537, 0.0055640095438813245, 0.00023165374437958105, -0.009946979326089726, 0.3775577905767716, 0.0314987678659508, 0.00017483301462609891, -0.013297632872169203, 0.1594463621203507, 12.16, 0.37, -3.81> texture { Material659 } }
sphere { <-6.39, 0.82, 11.03>, 0.137 texture { Material660 } }
sphere { <0, 0, 0>, 1 matrix <0.17627112046971055, 0.016041091429759485, 0.0004188962817755468, -0.0328978315762864, 0.3610114480186832, 0.018906799756486438, 0.0003620967859415743, -0.00796898171554387, 0.15279189839888416, -6.39, 0.35, 11.03> texture { Material660 } }
sphere { <-2.74, 0.94, -12.46>, 0.157 texture { Material661 } }
sphere { <0, 0, 0>, 1 matrix <0.2379653428470992, -0.004061471224708954, -7.426532764453023e-06, 0.0070819771355219155, 0.41493679348990237, 0.0015175665290404104, -5.460685856215458e-06, -0.0006399376929688477, 0.1749988298530308, -2.74, 0.41, -12.46> texture { Material661 } }
sphere { <10.44, 1.22, 7.34>, 0.203 texture { Material662 } }
sphere { <0, 0, 0>, 1 matrix <0.26078798834103156, 0.010513576584488819, -0.0002997406213001652, -0.021631381708316078, 0.5356918949895256, -0.030582298277274454, -0.0002606939503261973, 0.012927712679592739, 0.22663143269091815, 10.44, 0.52, 7.34> texture { Material662 } }
sphere { <-12.67, 1.02, 1.64>, 0.169 texture { Material663 } }
sphere { <0, 0, 0>, 1 matrix <0.24299937264764168, -0.0005521503670069639, 4.777529497997791e-06, 0.001017956232177448, 0.4479317674300633, -0.007752128229659027, 3.7158562762205043e-06, 0.003270429096887402, 0.18897170232528107, -12.67, 0.44, 1.64> texture { Material663 } }
sphere { <8.24, 0.88, -9.77>, 0.146 texture { Material664 } }
sphere { <0, 0, 0>, 1 matrix <0.17298458363954958, 0.0023094706134085085, 1.2982198274020014e-05, -0.005166272412653716, 0.3869410580255234, 0.00435054518960313, 1.2231782188816547e-05, -0.0018324001702979592, 0.162989699551841, 8.24, 0.38, -9.77> texture { Material664 } }
sphere { <0.53, 1.13, 12.78>, 0.189 texture { Material665 } }
sphere { <0, 0, 0>, 1 matrix <0.2813141595180415, -0.01965560739469513, -2.74336192783377e-05, 0.03485036772109066, 0.4987820251299121, 0.0013940147088436267, -2.052657328982005e-05, -0.0005882742071320104, 0.2109991789370684, 0.53, 0.49, 12.78> texture { Material665 } }
sphere { <-9.03, 1.21, -9.07>, 0.201 texture { Material666 } }
sphere { <0, 0, 0>, 1 matrix <0.302, 0, 0, 0, 0.532, 0, 0, 0, 0.225, -9.03, 0.52, -9.07> texture { Material666 } }
sphere { <12.79, 1.17, 0.59>, 0.196 texture { Material667 } }
sphere { <0, 0, 0>, 1 matrix <0.275, 0, 0, 0, 0.518, 0, 0, 0, 0.219, 12.79, 0.51, 0.59> texture { Material667 } }
sphere { <-9.84, 1.09, 8.21>, 0.181 texture { Material668 } }
sphere { <0, 0, 0>, 1 matrix <0.2739318027657695, 0.006112340085949054, 8.20497974335688e-05, -0.010685441245144514, 0.4787082061421469, 0.012855921498064493, 6.048926672109815e-05, -0.005421495078515717, 0.2019272238509762, -9.84, 0.47, 8.21> texture { Material668 } }
sphere { <1.71, 1.22, -12.71>, 0.203 texture { Material669 } }
sphere { <0, 0, 0>, 1 matrix <0.27363085769463436, -0.014217994501494951, 4.8473232017712404e-05, 0.027917084094176217, 0.5372626896979608, -0.0036658797295382912, 4.01584805402216e-05, 0.0015467559453628105, 0.2269947266641715, 1.71, 0.53, -12.71> texture { Material669 } }
sphere { <7.33, 0.97, 10.53>, 0.161 texture { Material670 } }
sphere { <0, 0, 0>, 1 matrix <0.2134509589986307, 0.015314778663018088, -0.00038165045217134294, -0.030486428553484605, 0.4243789413870836, -0.021191785701812467, -0.0003210143990226249, 0.008954275648653155, 0.17977685584458183, 7.33, 0.42, 10.53> texture { Material670 } }
sphere { <-12.53, 0.99, -2.82>, 0.165 texture { Material671 } }
sphere { <0, 0, 0>, 1 matrix <0.23999824625984995, 0.0009174590820685701, -7.812115213808631e-06, -0.001666717332424569, 0.4359335950881866, -0.007424468117163989, -5.989288330586617e-06, 0.003133261774215995, 0.18397332044289103, -12.53, 0.43, -2.82> texture { Material671 } }
sphere { <11.15, 0.86, -6.38>, 0.143 texture { Material672 } }
sphere { <0, 0, 0>, 1 matrix <0.1868868997414309, 0.006499844381278346, 0.0001967944499102201, -0.013173481393072157, 0.37807677504847337, 0.022921857623945552, 0.00016838027799804934, -0.009676773667101025, 0.1597070183162834, 11.15, 0.37, -6.38> texture { Material672 } }
sphere { <-3.91, 1.14, 12.25>, 0.19 texture { Material673 } }
sphere { <0, 0, 0>, 1 matrix <0.26208995773532645, 0.02185798403362813, 0.0002873817677916501, -0.041804433341881934, 0.501085933140148, 0.013201400002699558, 0.00023165374437958105, -0.0055640095438813245, 0.21192684618598537, -3.91, 0.49, 12.25> texture { Material673 } }
sphere { <-5.39, 0.87, -11.68>, 0.145 texture { Material674 } }
sphere { <0, 0, 0>, 1 matrix <0.18990458271016178, -0.006020591853621882, -4.4038749156101494e-05, 0.0121362456838799, 0.3827666867483137, 0.005601344161790723, -3.754882822783391e-05, -0.0023692369561621332, 0.16198266977158715, -5.39, 0.37, -11.68> texture { Material674 } }
sphere { <11.87, 0.99, 4.97>, 0.166 texture { Material675 } }
sphere { <0, 0, 0>, 1 matrix <0.242, 0, 0, 0, 0.438, 0, 0, 0, 0.185, 11.87, 0.43, 4.97> texture { Material675 } }
sphere { <-12.12, 0.97, 4.36>, 0.161 texture { Material676 } }
sphere { <0, 0, 0>, 1 matrix <0.2128650057298578, -0.007572981108367756, 0.0003732194527460662, 0.015181516118652733, 0.4246608493222527, -0.041972426916275195, 0.0003153967206304785, 0.01769329471880453, 0.17912802083119808, -12.12, 0.42, 4.36> texture { Material676 } }
sphere { <6, 0.88, -11.41>, 0.147 texture { Material677 } }
sphere { <0, 0, 0>, 1 matrix <0.20577924740641082, -0.009533506521984422, 0.00011657721234484075, 0.018048871570747207, 0.3894655185542838, -0.009531426559832796, 9.337495163543073e-05, 0.004032526621467721, 0.1649506896322824, 6, 0.38, -11.41> texture { Material677 } }
sphere { <3.28, 0.99, 12.47>, 0.165 texture { Material678 } }
sphere { <0, 0, 0>, 1 matrix <0.24971064230551535, -0.025406390737478003, -0.00033230868414553066, 0.044132216579842266, 0.43361154638056715, 0.011374282623670687, -0.0002436047724413452, -0.004800155969622492, 0.1839372152648347, 3.28, 0.43, 12.47> texture { Material678 } }
sphere { <-10.85, 1.2, -6.98>, 0.2 texture { Material679 } }
sphere { <0, 0, 0>, 1 matrix <0.27598770784446314, 0.002604755869871299, -1.9121130835152383e-05, -0.005001886271854305, 0.5299192784328874, -0.0077807119784400304, -1.55185989386744e-05, 0.003288451855038805, 0.2239758599572065, -10.85, 0.52, -6.98> texture { Material679 } }
sphere { <12.73, 1.07, -2.18>, 0.178 texture { Material680 } }
sphere { <0, 0, 0>, 1 matrix <0.24697307890325895, 0.0036433114598628346, 0.00015677579866831372, -0.006962117445567845, 0.47020389749930386, 0.04054409571242451, 0.00012630924670038233, -0.01709380306519593, 0.1982644343868625, 12.73, 0.46, -2.18> texture { Material680 } }
sphere { <-7.91, 0.93, 10.21>, 0.155 texture { Material681 } }
sphere { <0, 0, 0>, 1 matrix <0.2226596852038505, 0.012312413832016327, 0.00026277471601418427, -0.022581960795043397, 0.40800369655626806, 0.017436703905033508, 0.00020385661825315633, -0.007375427324133978, 0.1728425917251463, -7.91, 0.4, 10.21> texture { Material681 } }
sphere { <-1.06, 0.87, -12.89>, 0.145 texture { Material682 } }
sphere { <0, 0, 0>, 1 matrix <0.17334208810409749, 0.015116802621047172, -5.263295167219992e-05, -0.03327434140150039, 0.38154256936913855, -0.002661947312120031, -4.900309293618613e-05, 0.0011259411607400652, 0.1619960797525651, -1.06, 0.37, -12.89> texture { Material682 } }
sphere { <9.49, 1.08, 8.79>, 0.18 texture { Material683 } }
sphere { <0, 0, 0>, 1 matrix <0.262, 0, 0, 0, 0.476, 0, 0, 0, 0.201, 9.49, 0.47, 8.79> texture { Material683 } }
sphere { <-12.95, 1.06, -0.07>, 0.177 texture { Material684 } }
sphere { <0, 0, 0>, 1 matrix <0.2469999849549319, -8.619744709056429e-05, -1.5045068121522528e-06, 0.0001633214786979113, 0.46771490704493685, 0.016332147869791133, -1.1999507773036185e-06, -0.006874857116130028, 0.19688000492226965, -12.95, 0.46, -0.07> texture { Material684 } }
sphere { <9.6, 0.96, -8.7>, 0.16 texture { Material685 } }
sphere { <0, 0, 0>, 1 matrix <0.21546696420216424, -0.015153901777313976, 0.0005887261050723356, 0.029676390980573203, 0.42068276174077956, -0.03277690944123011, 0.0004878795037405003, 0.013870134255272315, 0.17846114801079407, 9.6, 0.41, -8.7> texture { Material685 } }
sphere { <-1.2, 1.21, 12.91>, 0.201 texture { Material686 } }
sphere { <0, 0, 0>, 1 matrix <0.2979549778361319, 0.005179880910935544, 4.051994748126326e-06, -0.009247304176569496, 0.5319189738232002, 0.0008322573758912546, 3.0593920078135012e-06, -0.0003519885518337073, 0.2249997246547193, -1.2, 0.52, 12.91> texture { Material686 } }
sphere { <-7.84, 0.88, -10.33>, 0.147 texture { Material687 } }
sphere { <0, 0, 0>, 1 matrix <0.1919251448241065, -0.005360562693504149, -5.614138192013456e-05, 0.010888642971180303, 0.38976242253744736, 0.008166482228385227, -4.824650008761564e-05, -0.0034550501735475963, 0.1649638151249343, -7.84, 0.38, -10.33> texture { Material687 } }
sphere { <12.77, 1.07, 2.33>, 0.178 texture { Material688 } }
sphere { <0, 0, 0>, 1 matrix <0.22299556668349957, -0.0014059363117740957, -2.4136945391243135e-05, 0.002975793449136202, 0.47171247035301317, 0.016201542111963767, -2.1539247232544324e-05, -0.006830734915849132, 0.19888273076506727, 12.77, 0.46, 2.33> texture { Material688 } }
sphere { <-10.99, 0.94, 6.91>, 0.157 texture { Material689 } }
sphere { <0, 0, 0>, 1 matrix <0.22599036393331795, -0.0020869045158422995, 1.5454069207031763e-05, 0.003841381763674321, 0.41593664118505874, -0.006160706602119194, 1.2035027347068982e-05, 0.0026064527932042744, 0.17598069854104714, -10.99, 0.41, 6.91> texture { Material689 } }
sphere { <3.44, 0.89, -12.53>, 0.149 texture { Material690 } }
sphere { <0, 0, 0>, 1 matrix <0.20128385849150146, -0.016993254315590626, 0.00019395499188502125, 0.03314525841753815, 0.39250071104814777, -0.008976840821416584, 0.0001603489289346463, 0.003804904612123273, 0.16695657216508022, 3.44, 0.39, -12.53> texture { Material690 } }
sphere { <5.93, 0.86, 11.57>, 0.144 texture { Material691 } }
sphere { <0, 0, 0>, 1 matrix <0.172, 0, 0, 0, 0.38, 0, 0, 0, 0.16, 5.93, 0.37, 11.57> texture { Material691 } }
sphere { <-12.2, 1.22, -4.53>, 0.203 texture { Material692 } }
sphere { <0, 0, 0>, 1 matrix <0.25698093798989036, 0.0031296787209790762, -5.1195112865913935e-05, -0.0065516231590923854, 0.5376722649362735, -0.01759578791299098, -4.5219029651994024e-05, 0.007424245085964595, 0.2268785546060775, -12.2, 0.53, -4.53> texture { Material692 } }
sphere { <12.06, 0.98, -4.91>, 0.163 texture { Material693 } }
sphere { <0, 0, 0>, 1 matrix <0.23499487930985533, -0.0015513030297487477, 1.2532215354068616e-05, 0.0028583583484306715, 0.4329340520027174, -0.006995455958001382, 9.759129403381093e-06, 0.0029565091000329164, 0.18297611581488119, 12.06, 0.42, -4.91> texture { Material693 } }
sphere { <-5.58, 0.83, 11.77>, 0.138 texture { Material694 } }
sphere { <0, 0, 0>, 1 matrix <0.1749783001190255, 0.0027557902617231177, 1.0367720910042482e-05, -0.00576353849023235, 0.3659442564272392, 0.0027536906119999005, 9.123594400837385e-06, -0.0011586567055955866, 0.15399564094934182, -5.58, 0.36, 11.77> texture { Material694 } }
sphere { <-3.84, 1.18, -12.46>, 0.197 texture { Material695 } }
sphere { <0, 0, 0>, 1 matrix <0.28456427794433786, -0.028617889783225423, -0.0004337077043146035, 0.05213258943028128, 0.5181459074868704, 0.01574838639039747, -0.00033362131101123357, -0.006649990414371293, 0.2198992185622987, -3.84, 0.51, -12.46> texture { Material695 } }
sphere { <11.25, 1.13, 6.6>, 0.189 texture { Material696 } }
sphere { <0, 0, 0>, 1 matrix <0.2758250765373934, -0.009820394413881172, -0.0002949689761601936, 0.01779056959036444, 0.4987820251299121, 0.02999978401512435, -0.00022550164481811898, -0.012659908854382475, 0.21061974232442435, 11.25, 0.49, 6.6> texture { Material696 } }
sphere { <-12.76, 0.89, 2.74>, 0.149 texture { Material697 } }
sphere { <0, 0, 0>, 1 matrix <0.2059779695082035, 0.0030108981375972493, 0.00010280896171707828, -0.0057733240987908425, 0.3940377998526306, 0.0269421791276906, 8.334512915899065e-05, -0.01139074408689704, 0.1666110560639247, -12.76, 0.39, 2.74> texture { Material697 } }
sphere { <7.57, 1.12, -10.65>, 0.187 texture { Material698 } }
sphere { <0, 0, 0>, 1 matrix <0.22490864216863501, -0.006410811356739014, 6.461895389231018e-05, 0.014103784984825831, 0.4946984593744524, -0.009975847916096318, 6.0023828282190344e-05, 0.004212024675685112, 0.20895754412145892, 7.57, 0.48, -10.65> texture { Material698 } }
sphere { <1.61, 1.17, 12.97>, 0.195 texture { Material699 } }
sphere { <0, 0, 0>, 1 matrix <0.23496472661171752, -0.004071514460297365, -4.275562216056848e-06, 0.008957331812654205, 0.5169212583958543, 0.0010857371894126308, -3.9662662259591185e-06, -0.00045781568141577085, 0.21799951924045746, 1.61, 0.51, 12.97> texture { Material699 } }
sphere { <-9.96, 0.91, -8.48>, 0.152 texture { Material700 } }
sphere { <0, 0, 0>, 1 matrix <0.20079315374281564, 0.009113227644678706, -0.00024185100840017624, -0.018226455289357412, 0.40102074820444933, -0.021310932338325584, -0.00020455060411955203, 0.0090120858147148, 0.1697608331397987, -9.96, 0.39, -8.48> texture { Material700 } }
sphere { <13.08, 0.87, -0.47>, 0.145 texture { Material701 } }
sphere { <0, 0, 0>, 1 matrix <0.18199982289220043, 0.0002538653249062614, 4.42769498900045e-06, -0.0005356279382637603, 0.38376607757533276, 0.013390698456594005, 3.941135100099302e-06, -0.005649200911375597, 0.16190147162249752, 13.08, 0.38, -0.47> texture { Material701 } }
sphere { <-9.33, 1.18, 9.19>, 0.196 texture { Material702 } }
sphere { <0, 0, 0>, 1 matrix <0.2916493957460775, 0.014300472034974566, 0.00035561288612138937, -0.025417619815588356, 0.5177357420848487, 0.025780728670096766, 0.00026670966459104204, -0.010878573369462796, 0.21872948019734337, -9.33, 0.51, 9.19> texture { Material702 } }
sphere { <0.67, 1.15, -13.08>, 0.191 texture { Material703 } }
sphere { <0, 0, 0>, 1 matrix <0.2649903139076352, -0.023154502509618587, 5.048430461823866e-05, 0.04404578296942483, 0.5040745172344232, -0.0022022891484712414, 4.0615192437229587e-05, 0.0009314029204996949, 0.21399796924037814, 0.67, 0.49, -13.08> texture { Material703 } }
sphere { <8.35, 0.88, 10.11>, 0.147 texture { Material704 } }
sphere { <0, 0, 0>, 1 matrix <0.21950488182512828, 0.014745762124546572, -0.00041152679469856856, -0.026006162292382135, 0.3865235428595973, -0.021615511515746193, -0.0003067745196843875, 0.009136453321088598, 0.16374501858104154, 8.35, 0.38, 10.11> texture { Material704 } }
sphere { <-12.99, 0.94, -1.82>, 0.156 texture { Material705 } }
sphere { <0, 0, 0>, 1 matrix <0.22398328818895868, -0.002733614165449151, -0.00011817637807785445, 0.0050523047522140554, 0.4124246050099826, 0.035727012176370816, -9.232529537332379e-05, -0.01510199790063984, 0.1743471282684315, -12.99, 0.4, -1.82> texture { Material705 } }
sphere { <10.81, 0.95, -7.44>, 0.158 texture { Material706 } }
sphere { <0, 0, 0>, 1 matrix <0.2149040090303606, 0.006422447602205294, 0.00013809227211282558, -0.012486433012659596, 0.41742714552741184, 0.017962938719966435, 0.0001136852658789308, -0.007606316156540811, 0.17683645277540222, 10.81, 0.41, -7.44> texture { Material706 } }
sphere { <-2.95, 1.21, 12.8>, 0.201 texture { Material707 } }
sphere { <0, 0, 0>, 1 matrix <0.2939323556789491, -0.025074123120723334, 0.00024214613467132587, 0.04521841864482989, 0.5299755793848087, -0.01025572381635317, 0.0001846877298340621, 0.004337477177968916, 0.22495811206127475, -2.95, 0.52, 12.8> texture { Material707 } }
sphere { <-6.47, 1.18, -11.43>, 0.197 texture { Material708 } }
sphere { <0, 0, 0>, 1 matrix <0.23475549979046959, 0.010716172586561388, -0.0001377070145631054, -0.023803583362489555, 0.5212846171418876, -0.01340661591680446, -0.00012891720512290722, 0.005650297895971228, 0.21992739145918364, -6.47, 0.51, -11.43> texture { Material708 } }
sphere { <12.51, 0.93, 4.06>, 0.156 texture { Material709 } }
sphere { <0, 0, 0>, 1 matrix <0.1869890373874545, -0.0020245414992536392, -3.359510296201455e-05, 0.004460487153435825, 0.4117490207318674, 0.013669234825045269, -3.125961452080499e-05, -0.005772929270771545, 0.17390420440711366, 12.51, 0.4, 4.06> texture { Material709 } }
sphere { <-11.97, 0.96, 5.46>, 0.159 texture { Material710 } }
sphere { <0, 0, 0>, 1 matrix <0.22899411467604475, 0.0016417286938789275, 1.3062548290951184e-05, -0.003025369034134967, 0.4219357273559971, 0.006714843466006878, 1.0153421815673844e-05, -0.0028323273387422378, 0.1779774643564579, -11.97, 0.41, 5.46> texture { Material710 } }
sphere { <5.14, 0.96, -12.12>, 0.161 texture { Material711 } }
sphere { <0, 0, 0>, 1 matrix <0.195, 0, 0, 0, 0.425, 0, 0, 0, 0.18, 5.14, 0.42, -12.12> texture { Material711 } }
sphere { <4.39, 1.11, 12.42>, 0.185 texture { Material712 } }
sphere { <0, 0, 0>, 1 matrix <0.28084760449964186, 0.009253117555944589, -5.3500547998080615e-05, -0.016135329545953196, 0.4897015052393569, -0.005664530585281442, -3.941143571388856e-05, 0.0023929751656188948, 0.20698616407044088, 4.39, 0.48, 12.42> texture { Material712 } }
sphere { <-11.64, 1.04, -6.19>, 0.174 texture { Material713 } }
sphere { <0, 0, 0>, 1 matrix <0.2549655235512631, -0.004192568820539161, -6.455164869889295e-05, 0.007563065323325545, 0.4597197804287841, 0.01416063294580102, -4.9109881755236216e-05, -0.005972093024968256, 0.19390804958309657, -11.64, 0.45, -6.19> texture { Material713 } }
sphere { <12.77, 1.1, -3.3>, 0.183 texture { Material714 } }
sphere { <0, 0, 0>, 1 matrix <0.218, 0, 0, 0, 0.483, 0, 0, 0, 0.204, 12.77, 0.47, -3.3> texture { Material714 } }
sphere { <-7.19, 0.86, 11.06>, 0.143 texture { Material715 } }
sphere { <0, 0, 0>, 1 matrix <0.17470162575744774, 0.010212922724569178, 0.00019536408738539193, -0.02200155352664332, 0.3760816469479537, 0.014405779094825983, 0.00017750222796729894, -0.006075646886146768, 0.15888377830311665, -7.19, 0.37, 11.06> texture { Material715 } }
sphere { <-2.17, 1.12, -13.02>, 0.186 texture { Material716 } }
sphere { <0, 0, 0>, 1 matrix <0.27298388790526323, 0.023574774142575437, -0.00016422013652311486, -0.04233134627060991, 0.49012779146113883, -0.0068414297003005905, -0.00012466346130221852, 0.00289231174321651, 0.20797985236989053, -2.17, 0.48, -13.02> texture { Material716 } }
sphere { <10.4, 0.83, 8.14>, 0.139 texture { Material717 } }
sphere { <0, 0, 0>, 1 matrix <0.1679122423905033, 0.005428291779210741, -0.00011182017984257384, -0.011858232636728226, 0.3664970392549286, -0.015109683520992418, -0.0001031674278309461, 0.006381473966631675, 0.15486854472905412, 10.4, 0.36, 8.14> texture { Material717 } }
sphere { <-13.18, 0.91, 1.02>, 0.152 texture { Material718 } }
sphere { <0, 0, 0>, 1 matrix <0.19199925620850664, -0.0005343490794435698, 9.297393667218892e-06, 0.0011215764532070765, 0.4027545032886956, -0.014019705665088453, 8.232067309516727e-06, 0.005914019759466593, 0.16989709915863105, -13.18, 0.39, 1.02> texture { Material718 } }
sphere { <9.03, 0.88, -9.66>, 0.146 texture { Material719 } }
sphere { <0, 0, 0>, 1 matrix <0.21492987533354, -0.005490393628565884, 6.532160711341875e-05, 0.00988270853141859, 0.3867642500563901, -0.00920581068680088, 4.982671426325896e-05, 0.0039011704202463675, 0.16395358607438493, 9.03, 0.38, -9.66> texture { Material719 } }
sphere { <-0.13, 0.84, 13.24>, 0.139 texture { Material720 } }
sphere { <0, 0, 0>, 1 matrix <0.17006333777419733, -0.0178734735674311, 9.366622258026874e-06, 0.03856907454024606, 0.36697857939089285, -0.00038569074540246057, 8.54498872662101e-06, 0.00016305625008884513, 0.15599991455011272, -0.13, 0.36, 13.24> texture { Material720 } }
sphere { <-8.85, 0.83, -9.85>, 0.139 texture { Material721 } }
sphere { <0, 0, 0>, 1 matrix <0.20457132405256714, -0.013244724759703567, -0.00038812551997298005, 0.023711287740542483, 0.3656034541996706, 0.02146832808941009, -0.00029346075900396054, -0.009067005051385732, 0.15473429904252345, -8.85, 0.36, -9.85> texture { Material721 } }
sphere { <13.19, 0.97, 1.29>, 0.161 texture { Material722 } }
sphere { <0, 0, 0>, 1 matrix <0.19399532104703374, 0.00134655954128624, -4.678952966278276e-05, -0.002956878167979063, 0.4249622854106851, -0.02956878167979063, -4.341296566649946e-05, 0.01249385141399604, 0.17956587034333502, 13.19, 0.42, 1.29> texture { Material722 } }
sphere { <-10.6, 1.11, 7.96>, 0.184 texture { Material723 } }
sphere { <0, 0, 0>, 1 matrix <0.2718658040431679, -0.008541228058848434, 0.00017892794244284035, 0.015323967987933952, 0.487331212960232, -0.020431957317245276, 0.00013551160346773937, 0.008624965588837144, 0.205819317862043, -10.6, 0.48, 7.96> texture { Material723 } }
sphere { <2.44, 0.96, -13.04>, 0.16 texture { Material724 } }
sphere { <0, 0, 0>, 1 matrix <0.20950514495628764, 0.014407844236248465, 9.089174272267569e-05, -0.029021514818729048, 0.42196959325990563, 0.005330482313644111, 7.74743902255188e-05, -0.002255688733196917, 0.17898577000995858, 2.44, 0.41, -13.04> texture { Material724 } }
sphere { <7.01, 0.95, 11.27>, 0.159 texture { Material725 } }
sphere { <0, 0, 0>, 1 matrix <0.23435609657390097, 0.01737983895887885, -0.00040149272450879853, -0.031135796602927642, 0.41939796789662487, -0.019414084940649005, -0.00030410938281943034, 0.008208330449965613, 0.17781037885541845, 7.01, 0.41, 11.27> texture { Material725 } }
sphere { <-12.79, 0.93, -3.58>, 0.155 texture { Material726 } }
sphere { <0, 0, 0>, 1 matrix <0.23299739868840413, -0.001100962710927605, -9.249107896398414e-06, 0.0019373163582846265, 0.4099375550141204, 0.006888235940567561, -6.867363373720711e-06, -0.0029064995554102147, 0.17297558270800453, -12.79, 0.4, -3.58> texture { Material726 } }
sphere { <11.86, 0.87, -6.01>, 0.144 texture { Material727 } }
sphere { <0, 0, 0>, 1 matrix <0.1929042801068566, 0.006074773836574094, 0.00018931267755027036, -0.012023645624721782, 0.38106946719925283, 0.023780099124449745, 0.00015792404707561415, -0.010022502510566515, 0.16068766132911713, 11.86, 0.37, -6.01> texture { Material727 } }
sphere { <-4.69, 0.95, 12.45>, 0.158 texture { Material728 } }
sphere { <0, 0, 0>, 1 matrix <0.22851008767656691, 0.01497018888060006, 0.0001824141629804046, -0.02739086961122893, 0.4179793370588663, 0.010198728046734174, 0.00014099260632109874, -0.004308293232152622, 0.17694750275296553, -4.69, 0.41, 12.45> texture { Material728 } }
sphere { <-4.95, 0.86, -12.35>, 0.144 texture { Material729 } }
sphere { <0, 0, 0>, 1 matrix <0.1737941256957538, 0.008461392609667766, -8.190698125923244e-05, -0.01847890340042386, 0.37947922320673805, -0.007351821782964329, -7.578749415365761e-05, 0.0031148508080454133, 0.16096984798619693, -4.95, 0.37, -12.35> texture { Material729 } }
sphere { <12, 0.92, 5.76>, 0.153 texture { Material730 } }
sphere { <0, 0, 0>, 1 matrix <0.18095389966496916, 0.004083734308080364, -9.648907332030021e-05, -0.00913763754017982, 0.40444496157560245, -0.01912528787479497, -9.115818529155435e-05, 0.008075121547135654, 0.170809203798227, 12, 0.4, 5.76> texture { Material730 } }
sphere { <-12.75, 0.84, 3.86>, 0.14 texture { Material731 } }
sphere { <0, 0, 0>, 1 matrix <0.19399011742979752, -0.001957873673347001, 3.271471515307302e-05, 0.0037441810969677186, 0.3707739968240845, -0.012394530527893138, 2.647531071666218e-05, 0.005245124778650196, 0.15691235759211036, -12.75, 0.36, 3.86> texture { Material731 } }
sphere { <6.8, 1.07, -11.47>, 0.178 texture { Material732 } }
sphere { <0, 0, 0>, 1 matrix <0.24056567725206762, -0.014459895895289936, 0.00025756349005292265, 0.028199796974216887, 0.46885510362211735, -0.016723135414942573, 0.00021160817854970409, 0.007045065557784318, 0.1978745114289996, 6.8, 0.46, -11.47> texture { Material732 } }
sphere { <2.73, 1.01, 13.06>, 0.168 texture { Material733 } }
sphere { <0, 0, 0>, 1 matrix <0.2530720997241277, 0.021690469824504826, -0.00018936740323924412, -0.03800101996812853, 0.44330664065082676, -0.007755310197577253, -0.00014016170003534604, 0.0032764007126843226, 0.18797139557142134, 2.73, 0.44, 13.06> texture { Material733 } }
sphere { <-10.84, 0.83, -7.79>, 0.138 texture { Material734 } }
sphere { <0, 0, 0>, 1 matrix <0.205, 0, 0, 0, 0.365, 0, 0, 0, 0.154, -10.84, 0.36, -7.79> texture { Material734 } }
sphere { <13.26, 1.14, -1.58>, 0.19 texture { Material735 } }
sphere { <0, 0, 0>, 1 matrix <0.225, 0, 0, 0, 0.502, 0, 0, 0, 0.212, 13.26, 0.49, -1.58> texture { Material735 } }
sphere { <-8.71, 1.22, 10.13>, 0.204 texture { Material736 } }
sphere { <0, 0, 0>, 1 matrix <0.27240002172748456, 0.01808216941941473, 0.0005131393120198106, -0.03570069346910088, 0.5369489422714508, 0.03053348783541523, 0.00042855590893962203, -0.012915835299581952, 0.22763347191998587, -8.71, 0.53, 10.13> texture { Material736 } }
sphere { <-0.42, 0.87, -13.37>, 0.144 texture { Material737 } }
sphere { <0, 0, 0>, 1 matrix <0.17603124735756256, 0.018493217921906, -2.906257927312302e-05, -0.03991191664501747, 0.37990736403068043, -0.0011973574993505238, -2.6435453463123205e-05, 0.0005046454382079433, 0.1609992069363961, -0.42, 0.37, -13.37> texture { Material737 } }
sphere { <9.34, 0.93, 9.58>, 0.154 texture { Material738 } }
sphere { <0, 0, 0>, 1 matrix <0.20043394512330573, -0.01506422178391207, -0.0005503311301194395, 0.030653068207064853, 0.40675945520562373, 0.029801594090201944, -0.00047366808711772645, -0.012605564248422827, 0.17253948935974664, 9.34, 0.4, 9.58> texture { Material738 } }
sphere { <-13.37, 0.95, -0.75>, 0.158 texture { Material739 } }
sphere { <0, 0, 0>, 1 matrix <0.21599705161143498, -0.0011275107299826214, -4.9139809417076256e-05, 0.0021767221037164493, 0.4154131891042579, 0.03627870172860749, -4.003984471021028e-05, -0.015311874110875104, 0.17533266925482982, -13.37, 0.41, -0.75> texture { Material739 } }
sphere { <10.37, 0.92, -8.48>, 0.154 texture { Material740 } }
sphere { <0, 0, 0>, 1 matrix <0.2065452901962368, -0.013701614231409445, 0.0005557564268216608, 0.02700608022422731, 0.4057649333102555, -0.03300743138516671, 0.0004617879488566457, 0.01391489754472714, 0.17143559250695298, 10.37, 0.4, -8.48> texture { Material740 } }
sphere { <-1.92, 1.14, 13.27>, 0.19 texture { Material741 } }
sphere { <0, 0, 0>, 1 matrix <0.27633847114906884, 0.019132187838296635, 9.354953447511997e-05, -0.03481091216787546, 0.5027722813309514, 0.004922755256063197, 7.1935201600002e-05, -0.002080450137979089, 0.21298982734522828, -1.92, 0.49, 13.27> texture { Material741 } }
sphere { <-7.55, 0.94, -11.08>, 0.157 texture { Material742 } }
sphere { <0, 0, 0>, 1 matrix <0.1938172987326989, 0.00841662146468694, -0.00012326832492605684, -0.018091397684404403, 0.4164285159926573, -0.012206244220802971, -0.00011183105766487631, 0.0051517961219695995, 0.1759245477201297, -7.55, 0.41, -11.08> texture { Material742 } }
sphere { <13.06, 1.07, 3.08>, 0.178 texture { Material743 } }
sphere { <0, 0, 0>, 1 matrix <0.27098023057686466, -0.003272259930548001, -8.337539322297306e-05, 0.005687211908812208, 0.4703545108694043, 0.023985198050208007, -6.122399723753371e-05, -0.010133873486181303, 0.19874179444643303, 13.06, 0.46, 3.08> texture { Material743 } }
sphere { <-11.72, 1.21, 6.56>, 0.202 texture { Material744 } }
sphere { <0, 0, 0>, 1 matrix <0.25566227182743045, -0.013131762872037225, 0.000599639816603114, 0.027443332564609044, 0.5320692140220262, -0.04872591700246912, 0.0005293695255949366, 0.020583284565529013, 0.22506009900557633, -11.72, 0.52, 6.56> texture { Material744 } }
sphere { <4.21, 0.88, -12.76>, 0.147 texture { Material745 } }
sphere { <0, 0, 0>, 1 matrix <0.196, 0, 0, 0, 0.389, 0, 0, 0, 0.164, 4.21, 0.38, -12.76> texture { Material745 } }
sphere { <5.52, 0.89, 12.26>, 0.148 texture { Material746 } }
sphere { <0, 0, 0>, 1 matrix <0.17664159188272271, 0.011257084043383494, -0.00016148058031173235, -0.024930943192126156, 0.3910451077018511, -0.011232622756892005, -0.0001505327443583946, 0.004728017231855053, 0.16493217755473963, 5.52, 0.38, 12.26> texture { Material746 } }
sphere { <-12.36, 1.06, -5.32>, 0.177 texture { Material747 } }
sphere { <0, 0, 0>, 1 matrix <0.24585117579182342, -0.008548812516730125, -0.00034229567880610025, 0.016263594544023166, 0.46621911870693694, 0.037406267451253285, -0.0002755062780634466, -0.015825728537068696, 0.19736633556045408, -12.36, 0.46, -5.32> texture { Material747 } }
sphere { <12.71, 1.05, -4.43>, 0.175 texture { Material748 } }
sphere { <0, 0, 0>, 1 matrix <0.26396030193690695, 0.004576703447001082, 0.00011307933123489778, -0.0080265670301572, 0.46236547459136773, 0.02286355457075081, 8.352450602577676e-05, -0.009629358836493322, 0.1947620817101084, 12.71, 0.45, -4.43> texture { Material748 } }
sphere { <-6.38, 0.89, 11.86>, 0.148 texture { Material749 } }
sphere { <0, 0, 0>, 1 matrix <0.17891515915141384, -0.005510333254996483, 4.5312725949418975e-05, 0.012067321988595652, 0.3917612041914856, -0.006445046971181769, 4.176871386398956e-05, 0.002712838648584163, 0.16497769170964083, -6.38, 0.38, 11.86> texture { Material749 } }
sphere { <-3.3, 0.91, -13.06>, 0.151 texture { Material750 } }
sphere { <0, 0, 0>, 1 matrix <0.22396800875769712, 0.003785628762750165, -8.24516554198349e-06, -0.0067600513620538665, 0.3999390780625565, -0.0017422812788798628, -6.220682931228617e-06, 0.000736113840326742, 0.1689983967312033, -3.3, 0.39, -13.06> texture { Material750 } }
sphere { <11.27, 0.87, 7.4>, 0.144 texture { Material751 } }
sphere { <0, 0, 0>, 1 matrix <0.19396453792641172, -0.003708786008934487, -5.416025784394903e-05, 0.007302867295943166, 0.3817672959212946, 0.011153470051985926, -4.494743047874122e-05, -0.004700808058559514, 0.16093135301526884, 11.27, 0.37, 7.4> texture { Material751 } }
sphere { <-13.32, 1.13, 2.15>, 0.189 texture { Material752 } }
sphere { <0, 0, 0>, 1 matrix <0.24699616990892626, -0.0013753140343169836, 2.3698688518725397e-05, 0.0027840365067145416, 0.4996954135095479, -0.017226225885296226, 2.024462865364801e-05, 0.0072694673235950075, 0.21087473636020554, -13.32, 0.49, 2.15> texture { Material752 } }
sphere { <8.37, 0.98, -10.59>, 0.164 texture { Material753 } }
sphere { <0, 0, 0>, 1 matrix <0.22865815341738482, -0.0125050006680209, 0.0002717242066941228, 0.023644826590624668, 0.4319452337625039, -0.01879460575152217, 0.00021714205163766143, 0.007943216749488585, 0.18282739990767263, 8.37, 0.42, -10.59> texture { Material753 } }
sphere { <0.98, 0.84, 13.47>, 0.14 texture { Material754 } }
sphere { <0, 0, 0>, 1 matrix <0.20450306528337542, -0.014265170159424485, -3.478543016372053e-05, 0.025677306286964074, 0.3681011345458751, 0.0017974114400874852, -2.647086392946538e-05, -0.0007598812592239775, 0.15599814703952494, 0.98, 0.36, 13.47> texture { Material754 } }
sphere { <-9.83, 1.15, -9.28>, 0.191 texture { Material755 } }
sphere { <0, 0, 0>, 1 matrix <0.25633569050238114, 0.01845317908772328, -0.0007028201931329943, -0.036331940149369565, 0.5032280790563463, -0.038438139578318535, -0.0005852277094570459, 0.01625644638292523, 0.21338084604651644, -9.83, 0.49, -9.28> texture { Material755 } }
sphere { <13.52, 1.19, 0.2>, 0.198 texture { Material756 } }
sphere { <0, 0, 0>, 1 matrix <0.2599999010720432, -0.00022659360174705177, -9.892795681893397e-06, 0.00045667325890559667, 0.5220060218000747, 0.04566732589055967, -8.408876329609388e-06, -0.0192604561484994, 0.22015911236703906, 13.52, 0.51, 0.2> texture { Material756 } }
sphere { <-10.11, 1.22, 8.99>, 0.203 texture { Material757 } }
sphere { <0, 0, 0>, 1 matrix <0.2948235572337764, -0.010199504816981446, 0.0002005031434358842, 0.018601130818766166, 0.5372626896979608, -0.021137648657688822, 0.00015428546969473126, 0.008918673318392868, 0.22682467560261962, -10.11, 0.53, 8.99> texture { Material757 } }
sphere { <1.38, 1.16, -13.47>, 0.194 texture { Material758 } }
sphere { <0, 0, 0>, 1 matrix <0.24366898385128946, -0.012705321362154796, 3.343597461722502e-05, 0.026764488443227725, 0.513295580863851, -0.0027034836811341135, 2.9736092180073068e-05, 0.0011413540054593437, 0.21699699635432526, 1.38, 0.5, -13.47> texture { Material758 } }
sphere { <8.08, 1.22, 10.87>, 0.204 texture { Material759 } }
sphere { <0, 0, 0>, 1 matrix <0.29328399439294284, 0.020499030694249198, -0.0005370042052928686, -0.03765128086698833, 0.5379451369695426, -0.02823846065024125, -0.0004164522408393676, 0.011922905607879638, 0.22768766081937047, 8.08, 0.53, 10.87> texture { Material759 } }
sphere { <-13.31, 0.9, -2.56>, 0.15 texture { Material760 } }
sphere { <0, 0, 0>, 1 matrix <0.20195991225830862, -0.0040188415575823, -0.00020676835188194453, 0.007878521073280152, 0.39383067056583626, 0.04063658237797131, -0.0001709421522984393, -0.01713714458868992, 0.16611829837235542, -13.31, 0.39, -2.56> texture { Material760 } }
sphere { <11.55, 0.93, -7.11>, 0.156 texture { Material761 } }
sphere { <0, 0, 0>, 1 matrix <0.22676475730147028, -0.010324581427755889, 0.00038453133413516216, 0.0187388878776891, 0.41043221561379917, -0.030630874415453334, 0.0002947508904824591, 0.012936340165749708, 0.17351819565978827, 11.55, 0.4, -7.11> texture { Material761 } }
sphere { <-3.72, 0.91, 13.05>, 0.152 texture { Material762 } }
sphere { <0, 0, 0>, 1 matrix <0.20726651686511952, 0.017451316000735653, 0.00020629213168513562, -0.03381192475142533, 0.40146646333097347, 0.009509603836338375, 0.0001686041460888128, -0.004011495414832565, 0.16995258008391254, -3.72, 0.39, 13.05> texture { Material762 } }
sphere { <-6.08, 1.07, -12.14>, 0.178 texture { Material763 } }
sphere { <0, 0, 0>, 1 matrix <0.25987386211670493, 0.008097636752038066, -6.377758144134155e-05, -0.014700325180622947, 0.47171247035301317, -0.007432748686831828, -4.881437964164218e-05, 0.0031337224336430805, 0.1989753185720913, -6.08, 0.46, -12.14> texture { Material763 } }
sphere { <12.69, 1.21, 4.85>, 0.202 texture { Material764 } }
sphere { <0, 0, 0>, 1 matrix <0.24998015364044113, 0.003149628122958792, -5.126976219375032e-05, -0.006740204183131815, 0.5346740924552162, -0.01741219413975719, -4.634786502315029e-05, 0.007355431543149766, 0.22588026801535688, 12.69, 0.52, 4.85> texture { Material764 } }
sphere { <-12.64, 1, 5>, 0.167 texture { Material765 } }
sphere { <0, 0, 0>, 1 matrix <0.19789703805691206, 0.006379290933143798, 0.00025879623532921835, -0.014208420714729367, 0.4393218618584598, 0.0357130574721576, 0.0002431116150062354, -0.015062650090297763, 0.18538893567038972, -12.64, 0.43, 5> texture { Material765 } }
sphere { <5.95, 0.84, -12.23>, 0.141 texture { Material766 } }
sphere { <0, 0, 0>, 1 matrix <0.17081085777088087, 0.008040044587012513, 9.246953423602862e-05, -0.017537641116699806, 0.37248881646345605, 0.008573957879275462, 8.489892909389761e-05, -0.0036088777132607173, 0.15695849385688743, 5.95, 0.36, -12.23> texture { Material766 } }
sphere { <3.88, 0.92, 13.04>, 0.154 texture { Material767 } }
sphere { <0, 0, 0>, 1 matrix <0.22122586605848693, 0.018521919432521114, -0.00023385296149874214, -0.03395685229295537, 0.4054512421233404, -0.0102577991301636, -0.000181183375575602, 0.004334991278594937, 0.17194526752196151, 3.88, 0.4, 13.04> texture { Material767 } }
sphere { <-11.68, 1.01, -7>, 0.169 texture { Material768 } }
sphere { <0, 0, 0>, 1 matrix <0.20279901862324057, -0.009024587836382353, -0.0003389097725747344, 0.019871875679127644, 0.44529903004701027, 0.03350943741970543, -0.0003155366848109596, -0.014168419848600284, 0.18846791853149525, -11.68, 0.44, -7> texture { Material768 } }
sphere { <13.35, 1.16, -2.73>, 0.193 texture { Material769 } }
sphere { <0, 0, 0>, 1 matrix <0.23398717757427312, 0.002448833034529734, 6.282988606180102e-05, -0.005347665301900402, 0.5102996922595873, 0.026203559979311966, 5.7996817903200935e-05, -0.011076260186949871, 0.21571581559227432, 13.35, 0.5, -2.73> texture { Material769 } }
sphere { <-8, 1.22, 11.03>, 0.204 texture { Material770 } }
sphere { <0, 0, 0>, 1 matrix <0.2747537645707338, 0.011633429648837951, 0.00017935667070008006, -0.022801522111722382, 0.5382613192327154, 0.01660851610606939, 0.0001487029851622482, -0.007025494753587794, 0.22789168547994354, -8, 0.53, 11.03> texture { Material770 } }
sphere { <-1.55, 0.94, -13.55>, 0.157 texture { Material771 } }
sphere { <0, 0, 0>, 1 matrix <0.20671977328329194, -0.01076728211922959, -3.1136301856450596e-05, 0.021690611805404537, 0.4164285159926573, 0.0024100679783782813, -2.6473377423842053e-05, -0.0010171989549030635, 0.17599705851361958, -1.55, 0.41, -13.55> texture { Material771 } }
sphere { <10.3, 0.86, 8.95>, 0.144 texture { Material772 } }
sphere { <0, 0, 0>, 1 matrix <0.16971767336247867, -0.009788177526053167, -0.000320825724456079, 0.02193703316133092, 0.37955017997295504, 0.02492844677423968, -0.0003038408331613454, -0.010534068059455613, 0.160654726325953, 10.3, 0.37, 8.95> texture { Material772 } }
sphere { <-13.65, 0.9, 0.36>, 0.151 texture { Material773 } }
sphere { <0, 0, 0>, 1 matrix <0.2249988916812989, -0.0007052498360048898, 3.6943956703122494e-05, 0.0012506430425153379, 0.39681423625194107, -0.041688101417177936, 2.7584821004998126e-05, 0.017552884807232817, 0.16708050596650006, -13.65, 0.39, 0.36> texture { Material773 } }
sphere { <9.83, 1.17, -9.49>, 0.195 texture { Material774 } }
sphere { <0, 0, 0>, 1 matrix <0.23884319521136246, -0.008654555386679193, 0.0001636223881435143, 0.018685148868311567, 0.5152928399333601, -0.01949754664519468, 0.00014924552558697121, 0.008237335598163644, 0.21784426553851793, 9.83, 0.5, -9.49> texture { Material774 } }
sphere { <-0.83, 0.87, 13.64>, 0.145 texture { Material775 } }
sphere { <0, 0, 0>, 1 matrix <0.19652183927977818, 0.013717356268516475, 2.8689643213310067e-05, -0.026668768785999032, 0.3820670312495127, 0.0016001261271599415, 2.3592498479980872e-05, -0.0006768157509136045, 0.16199858445009122, -0.83, 0.37, 13.64> texture { Material775 } }
sphere { <-8.61, 0.95, -10.63>, 0.159 texture { Material776 } }
sphere { <0, 0, 0>, 1 matrix <0.1937140016179717, 0.01052768810120282, -0.00023099869317670692, -0.022791902074768992, 0.41897690110912617, -0.018408843983467264, -0.000210756539650913, 0.007758012821604061, 0.1768297735641281, -8.61, 0.41, -10.63> texture { Material776 } }
sphere { <13.53, 0.94, 2.03>, 0.157 texture { Material777 } }
sphere { <0, 0, 0>, 1 matrix <0.2259876453177451, 0.002361676273796271, -8.154090288254548e-05, -0.004347156326987825, 0.41498664490808684, -0.02869123175811965, -6.350088012092037e-05, 0.01213859805151216, 0.1755808941912019, 13.53, 0.41, 2.03> texture { Material777 } }
sphere { <-11.35, 1.16, 7.65>, 0.193 texture { Material778 } }
sphere { <0, 0, 0>, 1 matrix <0.2716762202408653, 0.013258999331823697, 0.000479887857288992, -0.024909370068242315, 0.509055490724882, 0.036919244922573424, 0.00038108741608243473, -0.015605786503475263, 0.2154351740083064, -11.35, 0.5, 7.65> texture { Material778 } }
sphere { <3.21, 1.02, -13.32>, 0.171 texture { Material779 } }
sphere { <0, 0, 0>, 1 matrix <0.20996971849291224, 0.003566127374704255, 7.180151165136477e-06, -0.007675664635077731, 0.45193115821068885, 0.0018200029547091527, 6.5305184406717475e-06, -0.000769072045020903, 0.1909984515265553, 3.21, 0.44, -13.32> texture { Material779 } }
sphere { <6.64, 0.91, 11.99>, 0.151 texture { Material780 } }
sphere { <0, 0, 0>, 1 matrix <0.18280773134670297, 0.008385827750609965, -0.00010607925699145545, -0.018375502338768286, 0.40045044343658415, -0.010138208186906639, -9.796390399757361e-05, 0.004272711181015516, 0.1689459509495186, 6.64, 0.39, 11.99> texture { Material780 } }
sphere { <-13, 1, -4.36>, 0.166 texture { Material781 } }
sphere { <0, 0, 0>, 1 matrix <0.22487439990972735, -0.007507678021501095, -0.00037287526799692196, 0.014648314006395468, 0.43659511206667195, 0.04348718220648654, -0.00030824355487745544, -0.018425093144433934, 0.18508490194645755, -13, 0.43, -4.36> texture { Material781 } }
sphere { <12.54, 0.89, -5.57>, 0.149 texture { Material782 } }
sphere { <0, 0, 0>, 1 matrix <0.20586772507763482, 0.007375200250533154, 0.00029358580329829937, -0.014105965527718752, 0.39250071104814777, 0.031308362512741626, 0.00023657885120154223, -0.01319083293684038, 0.16547491035465026, 12.54, 0.39, -5.57> texture { Material782 } }
sphere { <-5.49, 1.2, 12.59>, 0.2 texture { Material783 } }
sphere { <0, 0, 0>, 1 matrix <0.28067612354806465, 0.013486802472355123, 0.0001408158486675567, -0.02538974557962939, 0.5282750238851696, 0.011039019817230171, 0.00011175065570414641, -0.004653499847338994, 0.2229514127583895, -5.49, 0.52, 12.59> texture { Material783 } }
sphere { <-4.46, 0.95, -13>, 0.159 texture { Material784 } }
sphere { <0, 0, 0>, 1 matrix <0.23986869651939113, 0.007937661741622559, -4.4228540836673485e-05, -0.013923981638429572, 0.4207435381750393, -0.004690183288734172, -3.280283445386617e-05, 0.0019830228631702676, 0.17798895062418393, -4.46, 0.41, -13> texture { Material784 } }
sphere { <12.07, 1.21, 6.58>, 0.202 texture { Material785 } }
sphere { <0, 0, 0>, 1 matrix <0.2488609181307584, 0.008317355984203328, -0.0002549834269429881, -0.017837221267327622, 0.5326992028387462, -0.03270157232343397, -0.00023040671109306155, 0.01377875238346937, 0.22457758769632938, 12.07, 0.52, 6.58> texture { Material785 } }
sphere { <-13.35, 1.19, 3.31>, 0.198 texture { Material786 } }
sphere { <0, 0, 0>, 1 matrix <0.2919769152438098, 0.003670457689864091, 9.330088960188463e-05, -0.0065867117448246025, 0.5232818762113967, 0.026621293301999437, 7.061471439046748e-05, -0.011227682862102815, 0.22071459886267186, -13.35, 0.51, 3.31> texture { Material786 } }
sphere { <7.61, 0.85, -11.46>, 0.142 texture { Material787 } }
sphere { <0, 0, 0>, 1 matrix <0.20991110707486943, -0.0061093090288115125, 5.8904950387719156e-05, 0.010967664304104478, 0.3767703417861991, -0.007267729358141523, 4.459946243641593e-05, 0.003065169676245364, 0.15897044613934938, 7.61, 0.37, -11.46> texture { Material787 } }
sphere { <2.13, 1.18, 13.6>, 0.197 texture { Material788 } }
sphere { <0, 0, 0>, 1 matrix <0.26496054497909083, -0.004572698180102198, -5.978033471087737e-06, 0.008990097176729226, 0.5209206491764798, 0.0013621359358680645, -4.962895711846422e-06, -0.0005751821610191443, 0.21999924804610427, 2.13, 0.51, 13.6> texture { Material788 } }
sphere { <-10.77, 0.87, -8.6>, 0.146 texture { Material789 } }
sphere { <0, 0, 0>, 1 matrix <0.19857791005170558, 0.012943402222519877, -0.0005310163865639649, -0.02504125555613142, 0.38289092971678523, -0.031503515054487924, -0.00043495312065289595, 0.013337851828263718, 0.162452800912727, -10.77, 0.38, -8.6> texture { Material789 } }
sphere { <13.75, 0.94, -0.93>, 0.157 texture { Material790 } }
sphere { <0, 0, 0>, 1 matrix <0.20299864344533824, 0.0007418785568724828, 1.937935231118104e-05, -0.0015129937071192505, 0.41343262738839354, 0.02161419581598929, 1.6706338199293998e-05, -0.009136435429464072, 0.17476133802572436, 13.75, 0.41, -0.93> texture { Material790 } }
sphere { <-9.52, 1.13, 9.98>, 0.188 texture { Material791 } }
sphere { <0, 0, 0>, 1 matrix <0.2826406522214963, -0.014252828410457732, 0.00034437495439936926, 0.025080948934303716, 0.49678689702939244, -0.02403590939537439, 0.0002555432523811574, 0.010135624443832574, 0.20975510438313472, -9.52, 0.49, 9.98> texture { Material791 } }
sphere { <0.27, 0.82, -13.8>, 0.136 texture { Material792 } }
sphere { <0, 0, 0>, 1 matrix <0.20296909447895586, -0.0035421301515666786, 6.181104208830924e-07, 0.006299059038007738, 0.3609450179514572, -0.00012598118076015475, 4.628215959321677e-07, 5.304470768848621e-05, 0.15199999074356807, 0.27, 0.35, -13.8> texture { Material792 } }
sphere { <9.12, 0.95, 10.36>, 0.158 texture { Material793 } }
sphere { <0, 0, 0>, 1 matrix <0.23981463499836433, 0.009429434345437393, -0.0001631212014393634, -0.01646222079474278, 0.41842577506216644, -0.014486754299373648, -0.00012030188606153053, 0.006119702890188868, 0.17689413434026585, 9.12, 0.41, 10.36> texture { Material793 } }
sphere { <-13.74, 1.06, -1.48>, 0.177 texture { Material794 } }
sphere { <0, 0, 0>, 1 matrix <0.26599950593794636, 0.0005126607031616866, -4.446558482918301e-06, -0.0009039017661008684, 0.46892856902834745, -0.008135115894907816, -3.3098442842775326e-06, 0.003434441252007991, 0.1979702114014415, -13.74, 0.46, -1.48> texture { Material794 } }
sphere { <11.13, 1.19, -8.19>, 0.198 texture { Material795 } }
sphere { <0, 0, 0>, 1 matrix <0.28386508191361387, -0.008751054868504093, 0.00018522652537753722, 0.01611549893037902, 0.5222832466766422, -0.022124668023062722, 0.00014413754263533707, 0.009349047099611589, 0.22080211625502608, 11.13, 0.51, -8.19> texture { Material795 } }
sphere { <-2.68, 0.96, 13.57>, 0.16 texture { Material796 } }
sphere { <0, 0, 0>, 1 matrix <0.18755863181883856, 0.012874482816173004, 8.557138206191478e-05, -0.02889910504481387, 0.42097202920964577, 0.0056028877127700365, 8.101971280330228e-05, -0.0023633033480404417, 0.1779842920964973, -2.68, 0.41, 13.57> texture { Material796 } }
sphere { <-7.2, 1.17, -11.82>, 0.195 texture { Material797 } }
sphere { <0, 0, 0>, 1 matrix <0.24157104075705405, -0.014400118130834513, -0.0002624221250963486, 0.030704384113680205, 0.5147430499340693, 0.018783858516604357, -0.00023639679037604957, -0.007935816194999515, 0.21785538078706407, -7.2, 0.5, -11.82> texture { Material797 } }
sphere { <13.3, 1.01, 3.86>, 0.168 texture { Material798 } }
sphere { <0, 0, 0>, 1 matrix <0.24195378321276959, -0.004726698660901931, -0.00015845755621853987, 0.008711188441166369, 0.4449135664158816, 0.029866931798284688, -0.00012309925854994008, -0.012589648381339733, 0.18757794539925735, 13.3, 0.44, 3.86> texture { Material798 } }
sphere { <-12.42, 0.94, 6.14>, 0.156 texture { Material799 } }
sphere { <0, 0, 0>, 1 matrix <0.21397485225162607, 0.0032802374864728634, 5.143857621935904e-05, -0.0063458799971951654, 0.41374780238590564, 0.012980209085171928, 4.206425625414875e-05, -0.0054868033572586655, 0.1749139594758438, -12.42, 0.41, 6.14> texture { Material799 } }
sphere { <5.01, 1.05, -12.92>, 0.174 texture { Material800 } }
sphere { <0, 0, 0>, 1 matrix <0.234719910390316, 0.011469608148436951, 0.00010842178439380583, -0.0225487615513952, 0.46136684505661313, 0.008728552858604592, 8.996701258209422e-05, -0.0036841294533071335, 0.19496517405964564, 5.01, 0.45, -12.92> texture { Material800 } }
sphere { <5.04, 1.15, 12.92>, 0.191 texture { Material801 } }
sphere { <0, 0, 0>, 1 matrix <0.22772825348507256, -0.011127960246143086, -0.0001051921993267563, 0.024696262651528075, 0.5053065445858144, 0.009559843607043126, -9.873302919265725e-05, -0.004043095912860136, 0.21396178076289316, 5.04, 0.49, 12.92> texture { Material801 } }
sphere { <-12.45, 1.21, -6.13>, 0.201 texture { Material802 } }
sphere { <0, 0, 0>, 1 matrix <0.2519925961270764, 0.001931648981251047, -1.514428552551059e-05, -0.004085590900820667, 0.5329188215183566, -0.008356890478951363, -1.3521683504920168e-05, 0.003527768025823746, 0.22497234201101265, -12.45, 0.52, -6.13> texture { Material802 } }
sphere { <13.33, 1.13, -3.89>, 0.188 texture { Material803 } }
sphere { <0, 0, 0>, 1 matrix <0.24097410588146684, 0.00353163032727385, 8.877983497090342e-05, -0.007312379806264113, 0.49831613784253237, 0.025071016478619812, 7.772840323178681e-05, -0.010601171296570702, 0.210733502617491, 13.33, 0.49, -3.89> texture { Material803 } }
sphere { <-7.2, 1.07, 11.88>, 0.179 texture { Material804 } }
sphere { <0, 0, 0>, 1 matrix <0.22537024287936241, 0.016855522196547866, 0.0003807833752692424, -0.03535184743877738, 0.47219628689548737, 0.02137553566065609, 0.0003369764382913649, -0.009019213358926621, 0.19979624680475405, -7.2, 0.46, 11.88> texture { Material804 } }
sphere { <-2.72, 0.9, -13.63>, 0.149 texture { Material805 } }
sphere { <0, 0, 0>, 1 matrix <0.2015276127565435, -0.013806230572341979, -9.640555988908477e-05, 0.02699733205977763, 0.3940377998526306, 0.0055096596040362525, -7.970162624493642e-05, -0.0023294003895545676, 0.16698373436199082, -2.72, 0.39, -13.63> texture { Material805 } }
sphere { <11.22, 1.06, 8.22>, 0.177 texture { Material806 } }
sphere { <0, 0, 0>, 1 matrix <0.23754804927613188, -0.014647160005374265, -0.0006204747225986082, 0.02886352118706105, 0.4664307689277201, 0.039626190104270265, -0.0005161932566156488, -0.016729180470459515, 0.19729132790193446, 11.22, 0.46, 8.22> texture { Material806 } }
sphere { <-13.83, 1.19, 1.52>, 0.198 texture { Material807 } }
sphere { <0, 0, 0>, 1 matrix <0.2759815615014835, -0.0031859336098659223, 0.00016594648664889207, 0.006060199801375395, 0.5221239950683435, -0.054541798212378555, 0.0001334786957828045, 0.02306338895837722, 0.22079869173795474, -13.83, 0.51, 1.52> texture { Material807 } }
sphere { <9.18, 1, -10.47>, 0.167 texture { Material808 } }
sphere { <0, 0, 0>, 1 matrix <0.24797871302907182, 0.003249235838994013, 1.873253441679967e-05, -0.0057909767775619105, 0.44193268125912494, 0.005096059564254482, 1.4124935225570718e-05, -0.0021560252002615116, 0.1869875700570015, 9.18, 0.43, -10.47> texture { Material808 } }
sphere { <0.3, 1.19, 13.93>, 0.199 texture { Material809 } }
sphere { <0, 0, 0>, 1 matrix <0.26196011208614006, 0.004571616254731378, -7.97758277198868e-07, -0.009195579260471131, 0.5269197353474182, -0.0001839115852094226, -6.759631203746135e-07, 7.747319149239434e-05, 0.2219999864807376, 0.3, 0.51, 13.93> texture { Material809 } }
sphere { <-9.63, 1.2, -10.07>, 0.2 texture { Material810 } }
sphere { <0, 0, 0>, 1 matrix <0.3011376223919474, 0.022791431908582172, -0.0008264452077170763, -0.039847271681229764, 0.5251075607544483, -0.03818696869451185, -0.0006102558984136027, 0.016128208369083605, 0.22241517143068695, -9.63, 0.52, -10.07> texture { Material810 } }
sphere { <13.91, 1.01, 0.92>, 0.168 texture { Material811 } }
sphere { <0, 0, 0>, 1 matrix <0.245, 0, 0, 0, 0.446, 0, 0, 0, 0.188, 13.91, 0.44, 0.92> texture { Material811 } }
sphere { <-10.89, 1.02, 8.73>, 0.169 texture { Material812 } }
sphere { <0, 0, 0>, 1 matrix <0.22865595914555714, -0.012540769883487247, 0.00042595534359596006, 0.02453390789433313, 0.446295224745102, -0.030375314535841018, 0.00035155266349186224, 0.01281458581980793, 0.18856474432139103, -10.89, 0.44, 8.73> texture { Material812 } }
sphere { <2.13, 0.99, -13.8>, 0.165 texture { Material813 } }
sphere { <0, 0, 0>, 1 matrix <0.2171890607866935, -0.018785547041830008, 0.00012286957777370982, 0.03774343855193368, 0.43633327776418457, -0.005718702810899042, 0.0001042700545327354, 0.002415433835653705, 0.184984201506889, 2.13, 0.43, -13.8> texture { Material813 } }
sphere { <7.75, 1.03, 11.62>, 0.171 texture { Material814 } }
sphere { <0, 0, 0>, 1 matrix <0.23390094788342597, -0.006807515774961401, -6.563694471774421e-05, 0.013207744281335367, 0.4537234354666695, 0.00875211970449934, -5.357545487644933e-05, -0.0036820591708356257, 0.19096449819255176, 7.75, 0.44, 11.62> texture { Material814 } }
sphere { <-13.57, 0.92, -3.34>, 0.153 texture { Material815 } }
sphere { <0, 0, 0>, 1 matrix <0.19998418852315744, -0.002514012116345268, -6.390471890540044e-05, 0.005078304475017442, 0.40344633204084784, 0.02052481391986216, -5.463853466411738e-05, -0.008687483119545618, 0.17077916925573253, -13.57, 0.4, -3.34> texture { Material815 } }
sphere { <12.27, 0.99, -6.71>, 0.165 texture { Material816 } }
sphere { <0, 0, 0>, 1 matrix <0.23579407742030234, -0.00984939229532031, 0.0003775247294456776, 0.01823806963158888, 0.4353370830660928, -0.03343646099124629, 0.00029434131448307065, 0.01407850989105107, 0.18346037425678102, 12.27, 0.43, -6.71> texture { Material816 } }
sphere { <-4.51, 1.04, 13.24>, 0.173 texture { Material817 } }
sphere { <0, 0, 0>, 1 matrix <0.2279688130483935, -0.0037709636633017096, 1.0505078435872545e-05, 0.007575005955228873, 0.4579302443816272, -0.0025515809533402517, 8.892456746155268e-06, 0.0010752295283726389, 0.19299700464614866, -4.51, 0.45, 13.24> texture { Material817 } }
sphere { <-5.62, 1.14, -12.82>, 0.191 texture { Material818 } }
sphere { <0, 0, 0>, 1 matrix <0.23225432416962527, -0.018623205803722256, -0.00032420688277163157, 0.04036360056171562, 0.5030783225363316, 0.017549391548572008, -0.0002963779657955258, -0.007402020593754133, 0.2128711400148715, -5.62, 0.49, -12.82> texture { Material818 } }
sphere { <12.81, 1.19, 5.66>, 0.198 texture { Material819 } }
sphere { <0, 0, 0>, 1 matrix <0.29788245513246475, 0.008364891732767868, -0.00026741457364269774, -0.014736805905044066, 0.5237211263864078, -0.03352623343397525, -0.00019921488372039902, 0.01417680728065239, 0.2215467861395361, 12.81, 0.51, 5.66> texture { Material819 } }
sphere { <-13.28, 0.96, 4.48>, 0.16 texture { Material820 } }
sphere { <0, 0, 0>, 1 matrix <0.19898764704613825, -0.0022169749987128273, 3.66728317770751e-05, 0.00471246444450013, 0.4227423198290775, -0.01399012881960976, 3.298712004068564e-05, 0.005920172715626825, 0.17890206948737922, -13.28, 0.41, 4.48> texture { Material820 } }
sphere { <6.77, 0.84, -12.28>, 0.14 texture { Material821 } }
sphere { <0, 0, 0>, 1 matrix <0.17291877822924032, 0.005300393661807376, 4.430278405072985e-05, -0.011397378278568461, 0.3717733876511036, 0.006216751788310069, 4.0205416739679704e-05, -0.0026237366418405397, 0.15697806977268744, 6.77, 0.36, -12.28> texture { Material821 } }
sphere { <3.31, 0.82, 13.63>, 0.137 texture { Material822 } }
sphere { <0, 0, 0>, 1 matrix <0.17210695812107904, 0.01755409193068759, -0.0002209588154031189, -0.036630214953631335, 0.3590224042279466, -0.009063145967908784, -0.00019541444368021503, 0.003841167127673252, 0.15295165003455335, 3.31, 0.35, 13.63> texture { Material822 } }
sphere { <-11.65, 1.12, -7.82>, 0.187 texture { Material823 } }
sphere { <0, 0, 0>, 1 matrix <0.2618003536900828, 0.010221900428095902, -0.000295904352198736, -0.019351384016547964, 0.4947917689288728, -0.028681515595955012, -0.0002371752441287578, 0.012143383619255146, 0.20964847240602344, -11.65, 0.49, -7.82> texture { Material823 } }
sphere { <13.88, 0.94, -2.11>, 0.156 texture { Material824 } }
sphere { <0, 0, 0>, 1 matrix <0.22298095641100674, -0.0029115770018960877, 0.00012568768735567564, 0.005392292833108001, 0.41142841031189087, -0.035589132698512806, 9.863383536880374e-05, 0.015080140973946105, 0.17434901668656588, 13.88, 0.4, -2.11> texture { Material824 } }
sphere { <-8.82, 0.84, 10.94>, 0.14 texture { Material825 } }
sphere { <0, 0, 0>, 1 matrix <0.21182416820478733, -0.008631430660145923, 0.00014201798844097545, 0.015105003655255366, 0.3704915573939469, -0.012200195260013947, 0.00010517369898694882, 0.005162885864749838, 0.1569150520123567, -8.82, 0.36, 10.94> texture { Material825 } }
sphere { <-0.88, 1.12, -14.03>, 0.187 texture { Material826 } }
sphere { <0, 0, 0>, 1 matrix <0.22486342773943457, 0.007838290510369522, -8.194335633925082e-06, -0.0172790759695257, 0.4956978502014715, -0.001036744558171542, -7.611627322179297e-06, 0.000436854057777928, 0.20899954330236067, -0.88, 0.48, -14.03> texture { Material826 } }
sphere { <10.13, 1.13, 9.75>, 0.188 texture { Material827 } }
sphere { <0, 0, 0>, 1 matrix <0.256, 0, 0, 0, 0.498, 0, 0, 0, 0.21, 10.13, 0.49, 9.75> texture { Material827 } }
sphere { <-14.07, 0.91, -0.35>, 0.152 texture { Material828 } }
sphere { <0, 0, 0>, 1 matrix <0.2189997866961243, 0.0003054722666541618, -1.0665193784456233e-05, -0.000560729914132297, 0.40102074820444933, -0.02803649570661485, -8.278917549577898e-06, 0.011856229527672946, 0.16958605412252112, -14.07, 0.39, -0.35> texture { Material828 } }
sphere { <10.61, 0.95, -9.25>, 0.158 texture { Material829 } }
sphere { <0, 0, 0>, 1 matrix <0.19894709368365304, 0.004588060626833511, 6.012081403063016e-05, -0.009637232874454308, 0.417745365693982, 0.010951400993698077, 5.347429187649014e-05, -0.004637315731781243, 0.17693923375923126, 10.61, 0.41, -9.25> texture { Material829 } }
sphere { <-1.58, 0.98, 14>, 0.163 texture { Material830 } }
sphere { <0, 0, 0>, 1 matrix <0.20396930871663668, -0.0035385152293415665, 3.410142595922306e-06, 0.007510672030906364, 0.4329340520027174, -0.0008345191145451514, 3.0590985051655984e-06, 0.000352695145408228, 0.18299966010016608, -1.58, 0.42, 14> texture { Material830 } }
sphere { <-8.3, 0.84, -11.39>, 0.141 texture { Material831 } }
sphere { <0, 0, 0>, 1 matrix <0.187, 0, 0, 0, 0.372, 0, 0, 0, 0.157, -8.3, 0.36, -11.39> texture { Material831 } }
sphere { <13.82, 1.05, 2.8>, 0.176 texture { Material832 } }
sphere { <0, 0, 0>, 1 matrix <0.2189786696124311, -0.003054722666541618, -0.0001045188990876711, 0.006486054976903436, 0.4638672833708183, 0.03178166938682683, -9.354202840723076e-05, -0.01339614451573776, 0.19554164406080457, 13.82, 0.45, 2.8> texture { Material832 } }
sphere { <-12.09, 0.99, 7.28>, 0.165 texture { Material833 } }
sphere { <0, 0, 0>, 1 matrix <0.2059244176205081, 0.005578404991363333, 0.00012500162762123156, -0.011806721243856374, 0.4354024771529942, 0.01952650051868554, 0.00011165193923449808, -0.008240541503298485, 0.18381534486972756, -12.09, 0.43, 7.28> texture { Material833 } }
sphere { <4, 1.03, -13.54>, 0.171 texture { Material834 } }
sphere { <0, 0, 0>, 1 matrix <0.20653529094492695, 0.013862006462432578, 0.00013554014106296593, -0.030268729087050847, 0.45089895071744057, 0.0088283793170565, 0.00012506360842041785, -0.0037305762158358216, 0.19096352311421072, 4, 0.44, -13.54> texture { Material834 } }
sphere { <6.2, 1.13, 12.69>, 0.188 texture { Material835 } }
sphere { <0, 0, 0>, 1 matrix <0.23274227988663884, 0.010955148472362078, -0.00012599649986546588, -0.02336784888739894, 0.4963188787730232, -0.011424281678283927, -0.00011355907713196496, 0.004827161272514335, 0.2099444822289577, 6.2, 0.49, 12.69> texture { Material835 } }
sphere { <-13.15, 1.01, -5.17>, 0.168 texture { Material836 } }
sphere { <0, 0, 0>, 1 matrix <0.20399575413380877, 0.001316123659143824, -1.0672042048209108e-05, -0.0028774076077360076, 0.4459320720397505, -0.007232402905931046, -9.835019142467218e-06, 0.003048636202500082, 0.18797527954647975, -13.15, 0.44, -5.17> texture { Material836 } }
sphere { <13.2, 1.07, -5.07>, 0.179 texture { Material837 } }
sphere { <0, 0, 0>, 1 matrix <0.22998174134920585, -0.0028976578731220886, 4.71681812182503e-05, 0.005971694921129869, 0.4737112520070514, -0.015426878546252165, 4.101580975500026e-05, 0.006509231454114838, 0.19989404249146625, 13.2, 0.46, -5.07> texture { Material837 } }
sphere { <-6.31, 1.05, 12.66>, 0.175 texture { Material838 } }
sphere { <0, 0, 0>, 1 matrix <0.22397270697202531, 0.003496619137958988, 1.3646513987342242e-05, -0.007242996785772189, 0.4639293305525656, 0.0036214983928860947, 1.1940699738924461e-05, -0.0015297708728570572, 0.19599402965013055, -6.31, 0.45, 12.66> texture { Material838 } }
sphere { <-3.9, 1.07, -13.61>, 0.178 texture { Material839 } }
sphere { <0, 0, 0>, 1 matrix <0.2167259244928699, 0.010902626404530059, -7.993868957961014e-05, -0.023714468492802707, 0.4713531404041588, -0.006916719977067457, -7.330783053614018e-05, 0.0029161594818568307, 0.19897861854942697, -3.9, 0.46, -13.61> texture { Material839 } }
sphere { <12.08, 1.2, 7.4>, 0.2 texture { Material840 } }
sphere { <0, 0, 0>, 1 matrix <0.23596084801261694, 0.0042981518547205765, -6.399844091457637e-05, -0.009634416657403326, 0.5286777474931017, -0.015748565689986206, -6.0473103067586985e-05, 0.006638809355135962, 0.2229011497353703, 12.08, 0.52, 7.4> texture { Material840 } }
sphere { <-13.91, 1.1, 2.7>, 0.183 texture { Material841 } }
sphere { <0, 0, 0>, 1 matrix <0.2199987861464446, 0.0007307905936029371, 6.260928864614183e-06, -0.0016044175305009937, 0.482926436760537, 0.008275416736268283, 5.805588583551333e-06, -0.0034952070687344298, 0.2039700553852006, -13.91, 0.47, 2.7> texture { Material841 } }
sphere { <8.44, 1.14, -11.39>, 0.19 texture { Material842 } }
sphere { <0, 0, 0>, 1 matrix <0.24062427911207526, -0.013449048137867358, 0.0002817906659435368, 0.028125810213631322, 0.5027722813309514, -0.02109435766022349, 0.000249051501435574, 0.008914877344499214, 0.2128132113739233, 8.44, 0.49, -11.39> texture { Material842 } }
sphere { <1.48, 0.98, 14.11>, 0.163 texture { Material843 } }
sphere { <0, 0, 0>, 1 matrix <0.20687517478963038, -0.0071876210795296545, -1.2608607108040146e-05, 0.015034975494861548, 0.4327362280992685, 0.0015186843934203585, -1.1146739617252883e-05, -0.0006418458290898975, 0.1829988740667053, 1.48, 0.42, 14.11> texture { Material843 } }
sphere { <-10.62, 0.85, -9.41>, 0.141 texture { Material844 } }
sphere { <0, 0, 0>, 1 matrix <0.16789951733991337, 0.0058085315567894345, -0.00011418484100755441, -0.012896323039776541, 0.37248881646345605, -0.014654912545200615, -0.00010738812428091426, 0.0062077109440796165, 0.15787796804058987, -10.62, 0.36, -9.41> texture { Material844 } }
sphere { <14.2, 0.82, -0.24>, 0.137 texture { Material845 } }
sphere { <0, 0, 0>, 1 matrix <0.186, 0, 0, 0, 0.364, 0, 0, 0, 0.154, 14.2, 0.36, -0.24> texture { Material845 } }
sphere { <-10.31, 1.09, 9.77>, 0.182 texture { Material846 } }
sphere { <0, 0, 0>, 1 matrix <0.23657445599154686, -0.014188871708296483, 0.0004502132263344909, 0.028796824015572188, 0.4791696497821296, -0.030466205117924194, 0.00038562567487722215, 0.012857878667232042, 0.2025920192135357, -10.31, 0.47, 9.77> texture { Material846 } }
sphere { <1.01, 0.85, -14.18>, 0.142 texture { Material847 } }
sphere { <0, 0, 0>, 1 matrix <0.19473406237152144, -0.01018059947854568, 1.8615633993499027e-05, 0.019682492325188317, 0.37648333460247435, -0.0013777744627631824, 1.5178901563929978e-05, 0.0005810772933139151, 0.15899893747689053, 1.01, 0.37, -14.18> texture { Material847 } }
sphere { <8.84, 0.91, 11.14>, 0.152 texture { Material848 } }
sphere { <0, 0, 0>, 1 matrix <0.21581859501616787, -0.0088494775790849, -0.0001441937050973291, 0.016469861049963563, 0.4014490729713387, 0.0130914280140736, -0.00011348578641919423, -0.0055361760258520205, 0.16990979334925654, 8.84, 0.39, 11.14> texture { Material848 } }
sphere { <-14.05, 0.86, -2.24>, 0.143 texture { Material849 } }
sphere { <0, 0, 0>, 1 matrix <0.19099925951102384, -0.0005318319733680074, -4.581775539898552e-06, 0.0010525261043618157, 0.3779424287691159, 0.006512505270738735, -3.838136577925489e-06, -0.0027566159876142794, 0.1599762515299241, -14.05, 0.37, -2.24> texture { Material849 } }
sphere { <11.88, 1.11, -7.84>, 0.185 texture { Material850 } }
sphere { <0, 0, 0>, 1 matrix <0.25689253238416127, 0.007429704127255874, 0.00016217840208394255, -0.014165583744573456, 0.48932847202974117, 0.021377153650901756, 0.00013062618377967356, -0.009030756746401355, 0.20680287321356883, 11.88, 0.48, -7.84> texture { Material850 } }
sphere { <-3.47, 0.98, 13.82>, 0.164 texture { Material851 } }
sphere { <0, 0, 0>, 1 matrix <0.199971296218858, 0.0033883090342860245, 7.101966468124676e-06, -0.007352630604400673, 0.4339338996978738, 0.0018192075722228468, 6.498299318334079e-06, -0.0007670852205455783, 0.18299839217336455, -3.47, 0.42, 13.82> texture { Material851 } }
sphere { <-6.78, 0.98, -12.54>, 0.163 texture { Material852 } }
sphere { <0, 0, 0>, 1 matrix <0.21989671219903395, 0.0067403850034544665, -5.6338800526939695e-05, -0.01320502698404034, 0.43073744644523027, -0.007202741991294731, -4.660755316319558e-05, 0.0030415291007323455, 0.1819745776982746, -6.78, 0.42, -12.54> texture { Material852 } }
sphere { <13.47, 1.18, 4.67>, 0.197 texture { Material853 } }
sphere { <0, 0, 0>, 1 matrix <0.2749586478509447, 0.00476739942395946, -0.00011779097003635186, -0.00904939090657032, 0.5212846171418876, -0.02577705288538212, -9.423277602908148e-05, 0.01086389202065913, 0.21973157936525048, 13.47, 0.51, 4.67> texture { Material853 } }
sphere { <-13.1, 1.22, 5.66>, 0.203 texture { Material854 } }
sphere { <0, 0, 0>, 1 matrix <0.3028166921338313, -0.010529634929143203, 0.00042160809218800156, 0.018696183471548, 0.5359527475733591, -0.0430012219845604, 0.00031585820767879985, 0.01814363827229593, 0.22627352612233878, -13.1, 0.53, 5.66> texture { Material854 } }
sphere { <5.83, 1.08, -13.03>, 0.18 texture { Material855 } }
sphere { <0, 0, 0>, 1 matrix <0.26286682195717426, -0.008368411661717683, 6.000329402040014e-05, 0.015145870536036565, 0.47571003366108955, -0.006823963648104385, 4.5858030791256386e-05, 0.0028815476749348354, 0.20097933868942372, 5.83, 0.47, -13.03> texture { Material855 } }
sphere { <4.5, 0.82, 13.55>, 0.137 texture { Material856 } }
sphere { <0, 0, 0>, 1 matrix <0.168, 0, 0, 0, 0.362, 0, 0, 0, 0.153, 4.5, 0.35, 13.55> texture { Material856 } }
sphere { <-12.48, 1.05, -6.96>, 0.175 texture { Material857 } }
sphere { <0, 0, 0>, 1 matrix <0.22986507477181373, -0.00787337352210257, -0.00023956111943279566, 0.015849443220580392, 0.4618721552702986, 0.02814084816715294, -0.00020414773656012152, -0.011912756459529106, 0.19563753361059733, -12.48, 0.45, -6.96> texture { Material857 } }
sphere { <13.91, 0.82, -3.3>, 0.136 texture { Material858 } }
sphere { <0, 0, 0>, 1 matrix <0.19799357959384528, -0.0015942730104861332, 2.7077365087409572e-05, 0.0028986782008838786, 0.3597806977268745, -0.012224860238510271, 2.0786664107506337e-05, 0.005161607656259892, 0.1519123345035466, 13.91, 0.35, -3.3> texture { Material858 } }
sphere { <-8.03, 0.88, 11.84>, 0.147 texture { Material859 } }
sphere { <0, 0, 0>, 1 matrix <0.19966521181526042, -0.011565127256433473, 0.00022588118488453126, 0.022436346877480938, 0.3870548515008118, -0.015137776206493167, 0.00018522257160531568, 0.006398441489342472, 0.16387503055409763, -8.03, 0.38, 11.84> texture { Material859 } }
sphere { <-2.08, 0.84, -14.16>, 0.139 texture { Material860 } }
sphere { <0, 0, 0>, 1 matrix <0.16560470702124727, 0.011448904980403515, -5.989287556859536e-05, -0.025449674323909016, 0.3681011345458751, -0.0038560112611983354, -5.628487101627033e-05, 0.0016301836226204347, 0.15599147198923996, -2.08, 0.36, -14.16> texture { Material860 } }
sphere { <11.1, 1.04, 9.04>, 0.174 texture { Material861 } }
sphere { <0, 0, 0>, 1 matrix <0.24776149064352412, -0.01086998406642829, -0.0002952972984939346, 0.020205897800900974, 0.45987702716977896, 0.02501682584873454, -0.00023099869317670692, -0.01052768810120282, 0.1937140016179717, 11.1, 0.45, 9.04> texture { Material861 } }
sphere { <-14.3, 1.15, 0.83>, 0.192 texture { Material862 } }
sphere { <0, 0, 0>, 1 matrix <0.2769998486664109, 0.0002895382942676082, 2.5222264854295537e-06, -0.0005309944169239891, 0.5079226291394467, 0.00884990694873315, 1.94857930643294e-06, -0.0037281104075371934, 0.2139675236782261, -14.3, 0.5, 0.83> texture { Material862 } }
sphere { <9.99, 0.97, -10.28>, 0.161 texture { Material863 } }
sphere { <0, 0, 0>, 1 matrix <0.2019367407326391, -0.005054597884584583, 6.150206548978448e-05, 0.010659696528876397, 0.4257404923101348, -0.010363593847518721, 5.480382073347131e-05, 0.00437898331585298, 0.17994671850762023, 9.99, 0.42, -10.28> texture { Material863 } }
sphere { <-0.42, 0.85, 14.34>, 0.141 texture { Material864 } }
sphere { <0, 0, 0>, 1 matrix <0.198727522645779, -0.010410171768605796, 8.17432062663025e-06, 0.019512533013517398, 0.37248881646345605, -0.0005853759904055219, 6.490164115615978e-06, 0.00024796087529241947, 0.15799980529507654, -0.42, 0.36, 14.34> texture { Material864 } }
sphere { <-9.38, 1.01, -10.86>, 0.168 texture { Material865 } }
sphere { <0, 0, 0>, 1 matrix <0.21298126399145748, -0.0028250543048833525, -1.6024217832414597e-05, 0.005902108759028601, 0.4449322243445941, 0.0050478561754849875, -1.4143441091520866e-05, -0.0021325774404296126, 0.18798790363590856, -9.38, 0.44, -10.86> texture { Material865 } }
sphere { <14.26, 0.87, 1.68>, 0.146 texture { Material866 } }
sphere { <0, 0, 0>, 1 matrix <0.19899298093758125, 0.0016703844839111243, -5.7907264954695004e-05, -0.003240042265274844, 0.38505972340029215, -0.026730348688517466, -4.743157883223762e-05, 0.011287686104218516, 0.16260868947463405, 14.26, 0.38, 1.68> texture { Material866 } }
sphere { <-11.65, 0.91, 8.4>, 0.152 texture { Material867 } }
sphere { <0, 0, 0>, 1 matrix <0.2259883333108694, -0.002296288725130447, 1.6293134820340786e-05, 0.00407438840166951, 0.40093892575771295, -0.005690094147159143, 1.218380435680351e-05, 0.002398069603166821, 0.16898298468701897, -11.65, 0.39, 8.4> texture { Material867 } }
sphere { <2.92, 1.09, -14.07>, 0.182 texture { Material868 } }
sphere { <0, 0, 0>, 1 matrix <0.2228695860755879, -0.007625411079626365, 2.661508661471655e-05, 0.016481830225918866, 0.48170637862320415, -0.003363638821616096, 2.422808333088547e-05, 0.001416636267195161, 0.2029950554931978, 2.92, 0.47, -14.07> texture { Material868 } }
sphere { <7.36, 1.2, 12.35>, 0.201 texture { Material869 } }
sphere { <0, 0, 0>, 1 matrix <0.2635242273632608, -0.01583988595998566, -0.0002821442380662721, 0.03185977062406206, 0.5297065106879667, 0.018893584904967037, -0.00023939511108653393, -0.00797017517648327, 0.22385803313179753, 7.36, 0.52, 12.35> texture { Material869 } }
sphere { <-13.78, 1.11, -4.14>, 0.185 texture { Material870 } }
sphere { <0, 0, 0>, 1 matrix <0.221988691079459, 0.002240453378778527, -3.743642661846499e-05, -0.004935052712714863, 0.4887021144123378, -0.016336726221400928, -3.490693833343357e-05, 0.00691554668267892, 0.20688444599724104, -13.78, 0.48, -4.14> texture { Material870 } }
sphere { <12.96, 0.9, -6.25>, 0.149 texture { Material871 } }
sphere { <0, 0, 0>, 1 matrix <0.19097837622667976, -0.0028736327946018666, 4.525906043773097e-05, 0.00594285316161119, 0.39475937667254285, -0.0124385298731397, 3.9572058079063206e-05, 0.00525882149066919, 0.16691717476216011, 12.96, 0.39, -6.25> texture { Material871 } }
sphere { <-5.34, 1.01, 13.38>, 0.168 texture { Material872 } }
sphere { <0, 0, 0>, 1 matrix <0.2474784392825824, -0.016074172852964946, 0.00020750265101560637, 0.028842769836973394, 0.4439160023656218, -0.01147508047277436, 0.00015730039673763708, 0.004847899166026021, 0.18793741812172804, -5.34, 0.44, 13.38> texture { Material872 } }
sphere { <-5.1, 1.03, -13.47>, 0.171 texture { Material873 } }
sphere { <0, 0, 0>, 1 matrix <0.2237303933482235, 0.010986401367577656, -0.00010038545544868974, -0.022218034908538742, 0.452379179243822, -0.008272672572328254, -8.559652674419527e-05, 0.0034880363384430387, 0.19096812895280801, -5.1, 0.44, -13.47> texture { Material873 } }
sphere { <12.87, 1.2, 6.49>, 0.2 texture { Material874 } }
sphere { <0, 0, 0>, 1 matrix <0.25099221669571836, 0.001976593333292307, -1.5393646245917382e-05, -0.004165808260205699, 0.528919430737731, -0.008239043003517937, -1.3737756012292805e-05, 0.0034887441073497504, 0.22397282977144237, 12.87, 0.52, 6.49> texture { Material874 } }
sphere { <-13.88, 1.14, 3.91>, 0.191 texture { Material875 } }
sphere { <0, 0, 0>, 1 matrix <0.2409569663575765, -0.00455158787136084, 0.00015300850639468063, 0.009537559647457363, 0.5037698453812113, -0.033911323190959505, 0.00013523158448990448, 0.014303191761731435, 0.21251917658848032, -13.88, 0.49, 3.91> texture { Material875 } }
sphere { <7.6, 0.86, -12.27>, 0.144 texture { Material876 } }
sphere { <0, 0, 0>, 1 matrix <0.20763516590895592, -0.012312031864497362, 0.0002274847861804199, 0.022493135137062487, 0.3790743390987332, -0.01402513132075661, 0.0001749882970618615, 0.005905318450844889, 0.1598908896500673, 7.6, 0.37, -12.27> texture { Material876 } }
sphere { <2.68, 0.88, 14.19>, 0.147 texture { Material877 } }
sphere { <0, 0, 0>, 1 matrix <0.187, 0, 0, 0, 0.39, 0, 0, 0, 0.165, 2.68, 0.38, 14.19> texture { Material877 } }
sphere { <-11.57, 1.04, -8.65>, 0.174 texture { Material878 } }
sphere { <0, 0, 0>, 1 matrix <0.22668903072805746, 0.011870612162231044, -0.00041462569592340545, -0.02410727844400225, 0.4592457558202947, -0.032143037925336335, -0.00035434971369665484, 0.013526571274436548, 0.19352753371507114, -11.57, 0.45, -8.65> texture { Material878 } }
sphere { <14.38, 0.97, -1.43>, 0.162 texture { Material879 } }
sphere { <0, 0, 0>, 1 matrix <0.22099700125921545, 0.0011508845249171924, 2.998740784546366e-05, -0.0022392775824180665, 0.42941069994446673, 0.022392775824180665, 2.4695512343323013e-05, -0.009477872558141583, 0.18175304487656677, 14.38, 0.42, -1.43> texture { Material879 } }
sphere { <-9.64, 0.85, 10.78>, 0.141 texture { Material880 } }
sphere { <0, 0, 0>, 1 matrix <0.1789393552456844, -0.004658777653193333, 5.417598052193388e-05, 0.009707955668386108, 0.37277277847812273, -0.008672440397091589, 4.782013923165114e-05, 0.003673580650778743, 0.15795728067561973, -9.64, 0.37, 10.78> texture { Material880 } }
sphere { <-0.17, 0.89, -14.47>, 0.148 texture { Material881 } }
sphere { <0, 0, 0>, 1 matrix <0.2246916761521639, 0.011775001419309414, -3.08323847836104e-06, -0.02051466913941907, 0.39146277762379295, -0.00020514669139419072, -2.274744832924145e-06, 8.687334380468281e-05, 0.16599997725255167, -0.17, 0.38, -14.47> texture { Material881 } }
sphere { <9.9, 0.88, 10.56>, 0.147 texture { Material882 } }
sphere { <0, 0, 0>, 1 matrix <0.19998369069603958, -0.0025540604509244683, -1.5192228346704265e-05, 0.004954877274793468, 0.38794090572067985, 0.004615502118985697, -1.2457627244297497e-05, -0.0019508823389527172, 0.16398839563489573, 9.9, 0.38, 10.56> texture { Material882 } }
sphere { <-14.44, 1.17, -1.09>, 0.195 texture { Material883 } }
sphere { <0, 0, 0>, 1 matrix <0.2639936114486246, -0.0018348670767615878, -7.985689219230333e-05, 0.0035932813586581095, 0.5150326589134324, 0.04491601698322637, -6.594243370425048e-05, -0.01893944236430048, 0.21717571957869689, -14.44, 0.51, -1.09> texture { Material883 } }
sphere { <11.39, 1.05, -8.95>, 0.175 texture { Material884 } }
sphere { <0, 0, 0>, 1 matrix <0.2516344917902922, 0.01355970643792064, 0.0004657282026922003, -0.024967078520615783, 0.46223433991456997, 0.0318128903730427, 0.000362233046538378, -0.013438203692061139, 0.1955384449890882, 11.39, 0.45, -8.95> texture { Material884 } }
sphere { <-2.36, 1.12, 14.3>, 0.187 texture { Material885 } }
sphere { <0, 0, 0>, 1 matrix <0.27663004429013555, 0.014311359861846513, 5.979082179627607e-05, -0.02552278617961075, 0.49332299016875947, 0.004124894736098707, 4.511293052498808e-05, -0.0017451477729648374, 0.2089927090213293, -2.36, 0.48, 14.3> texture { Material885 } }
sphere { <-7.93, 1.03, -12.14>, 0.172 texture { Material886 } }
sphere { <0, 0, 0>, 1 matrix <0.21019096420738131, -0.018452044768278955, -0.0005297258165955591, 0.039789954358137085, 0.45250746239256434, 0.02605294630592309, -0.0004820253876130206, -0.01099377074887304, 0.1916843881390629, -7.93, 0.44, -12.14> texture { Material886 } }
sphere { <14.06, 1.02, 3.6>, 0.171 texture { Material887 } }
sphere { <0, 0, 0>, 1 matrix <0.21798139068270986, 0.002847473018727126, -7.220415108576269e-05, -0.005903934882865417, 0.4513805497090674, -0.022907267345517818, -6.326143512559943e-05, 0.009679840847331644, 0.19075454563171268, 14.06, 0.44, 3.6> texture { Material887 } }
sphere { <-12.8, 0.82, 6.84>, 0.137 texture { Material888 } }
sphere { <0, 0, 0>, 1 matrix <0.1839005218137654, -0.006046766486622209, 0.00018625702954561943, 0.011929218666542727, 0.3621157502443162, -0.022335558354377873, 0.0001548767691330422, 0.009414160959283236, 0.15271001796417644, -12.8, 0.36, 6.84> texture { Material888 } }
sphere { <4.82, 0.98, -13.7>, 0.164 texture { Material889 } }
sphere { <0, 0, 0>, 1 matrix <0.21652939856290077, 0.014282586014680866, 0.00016521114281143568, -0.02856517202936173, 0.4329427978127637, 0.010028198691158908, 0.0001393255259654043, -0.004228480093276682, 0.18295108784726746, 4.82, 0.42, -13.7> texture { Material889 } }
sphere { <5.7, 0.88, 13.37>, 0.146 texture { Material890 } }
sphere { <0, 0, 0>, 1 matrix <0.18, 0, 0, 0, 0.387, 0, 0, 0, 0.164, 5.7, 0.38, 13.37> texture { Material890 } }
sphere { <-13.24, 0.85, -6.01>, 0.141 texture { Material891 } }
sphere { <0, 0, 0>, 1 matrix <0.17388827263839057, -0.006229538075693052, -0.00024798024162089367, 0.013354124725479935, 0.3715806223882211, 0.029639642683382296, -0.0002251774607821908, -0.012555130144703493, 0.15750021587972735, -13.24, 0.36, -6.01> texture { Material891 } }
sphere { <13.83, 0.83, -4.52>, 0.138 texture { Material892 } }
sphere { <0, 0, 0>, 1 matrix <0.196, 0, 0, 0, 0.366, 0, 0, 0, 0.154, 13.83, 0.36, -4.52> texture { Material892 } }
sphere { <-7.15, 1.11, 12.68>, 0.184 texture { Material893 } }
sphere { <0, 0, 0>, 1 matrix <0.27596808710935694, 0.004196972020440399, 1.797392691393269e-05, -0.00742073313759027, 0.4879256752363189, 0.004179493376343944, 1.341532226184831e-05, -0.0017642943350960093, 0.20599244424378355, -7.15, 0.48, 12.68> texture { Material893 } }
sphere { <-3.29, 1.06, -14.18>, 0.177 texture { Material894 } }
sphere { <0, 0, 0>, 1 matrix <0.21671843917023098, 0.011050505258800717, -6.676184623389355e-05, -0.023883350075472518, 0.4683572517998951, -0.005663062389029566, -6.091633895995817e-05, 0.0023908024584815652, 0.19798555591962805, -3.29, 0.46, -14.18> texture { Material894 } }
sphere { <12.02, 1.13, 8.24>, 0.188 texture { Material895 } }
sphere { <0, 0, 0>, 1 matrix <0.27278335191089026, 0.010869488607158613, -0.0003116691808246069, -0.019867673314916293, 0.4977844610796523, -0.02858156511970414, -0.00024088716906224192, 0.012085591663842831, 0.21065346056380518, 12.02, 0.49, 8.24> texture { Material895 } }
sphere { <-14.43, 0.94, 2.04>, 0.157 texture { Material896 } }
sphere { <0, 0, 0>, 1 matrix <0.196, 0, 0, 0, 0.415, 0, 0, 0, 0.175, -14.43, 0.41, 2.04> texture { Material896 } }
sphere { <9.27, 1, -11.26>, 0.167 texture { Material897 } }
sphere { <0, 0, 0>, 1 matrix <0.20370610272459466, 0.010943675840003433, 0.00024427825488235574, -0.023764943123144713, 0.4419208742651021, 0.019752679998457943, 0.00022392173364215942, -0.008338038735240711, 0.18681388323437534, 9.27, 0.43, -11.26> texture { Material897 } }
sphere { <0.78, 0.88, 14.57>, 0.146 texture { Material898 } }
sphere { <0, 0, 0>, 1 matrix <0.18474709618912333, 0.009670071860434008, -1.2645190543832462e-05, -0.020281015577558893, 0.38746825948477465, -0.0010140507788779446, -1.1209790536154181e-05, 0.0004286194013813993, 0.16399943951047322, 0.78, 0.38, 14.57> texture { Material898 } }
sphere { <-10.42, 0.99, -10.22>, 0.165 texture { Material899 } }
sphere { <0, 0, 0>, 1 matrix <0.21485476459751973, -0.007899900597548377, -0.00014731019394428432, 0.016057007261063443, 0.4364011066877488, 0.016286393079078636, -0.00012675528316136094, -0.006894697298923449, 0.1848714339270792, -10.42, 0.43, -10.22> texture { Material899 } }
sphere { <14.6, 0.96, 0.5>, 0.16 texture { Material900 } }
sphere { <0, 0, 0>, 1 matrix <0.2119999709663661, -0.00011094738984406433, -9.677877963348244e-07, 0.00022241811643267613, 0.4249352704414663, 0.0074139372144225385, -8.171415827544035e-07, -0.0031225759091332572, 0.17897276194724152, 14.6, 0.42, 0.5> texture { Material900 } }
sphere { <-11.11, 1.08, 9.49>, 0.181 texture { Material901 } }
sphere { <0, 0, 0>, 1 matrix <0.2745579156929654, 0.015578310120109812, 0.0005168985743789301, -0.027077935408772687, 0.47618106568785434, 0.03166035524718037, 0.00037968549827106866, -0.013379480669310533, 0.20155606003279075, -11.11, 0.47, 9.49> texture { Material901 } }
sphere { <1.78, 1.17, -14.51>, 0.195 texture { Material902 } }
sphere { <0, 0, 0>, 1 matrix <0.27483490309641967, 0.009527625071950348, 2.0011745888528363e-05, -0.01784264331656156, 0.5146862759148343, 0.0021627446444317045, 1.5863856740724297e-05, -0.0009154919077400224, 0.21799807710827387, 1.78, 0.5, -14.51> texture { Material902 } }
sphere { <8.5, 1.16, 11.91>, 0.194 texture { Material903 } }
sphere { <0, 0, 0>, 1 matrix <0.25407655714411753, 0.02167177620248605, -0.0006612306869281895, -0.04368350183559933, 0.5111842542192925, -0.03127954452425631, -0.0005626943492683025, 0.013205566462575133, 0.21659708305854863, 8.5, 0.5, 11.91> texture { Material903 } }
sphere { <-14.31, 0.9, -3.04>, 0.151 texture { Material904 } }
sphere { <0, 0, 0>, 1 matrix <0.20195141856477816, -0.0044241542382918225, -0.00022671336436863132, 0.008738799708309096, 0.39681423625194107, 0.04078106530544245, -0.0001885536891778716, -0.017170974865449454, 0.1671200827838366, -14.31, 0.39, -3.04> texture { Material904 } }
sphere { <12.62, 1.18, -7.43>, 0.197 texture { Material905 } }
sphere { <0, 0, 0>, 1 matrix <0.23684979398319647, 0.008432729985832745, 0.0002532885773549488, -0.018608935791521206, 0.5217259982858881, 0.03137977407982007, 0.00023618892656305355, -0.013259904534684964, 0.22060172063363878, 12.62, 0.51, -7.43> texture { Material905 } }
sphere { <-4.29, 0.93, 14.01>, 0.155 texture { Material906 } }
sphere { <0, 0, 0>, 1 matrix <0.234, 0, 0, 0, 0.411, 0, 0, 0, 0.173, -4.29, 0.4, 14.01> texture { Material906 } }
sphere { <-6.3, 1.14, -13.23>, 0.19 texture { Material907 } }
sphere { <0, 0, 0>, 1 matrix <0.2638180971361945, -0.02499385428691484, -0.0005646869238182055, 0.047441164929502504, 0.5002445133702415, 0.022666334355206753, -0.0004517495390545644, -0.009553206527443004, 0.21178416410911835, -6.3, 0.49, -13.23> texture { Material907 } }
sphere { <13.59, 1.01, 5.5>, 0.168 texture { Material908 } }
sphere { <0, 0, 0>, 1 matrix <0.24299470498848869, -0.0016041133456550882, -1.2958843961866696e-05, 0.0029375738222901823, 0.4449322243445941, 0.007189325407183868, -1.0025772283254894e-05, -0.0030372880371922857, 0.1879754632415173, 13.59, 0.43, 5.5> texture { Material908 } }
sphere { <-13.74, 1.08, 5.13>, 0.18 texture { Material909 } }
sphere { <0, 0, 0>, 1 matrix <0.25399528976721114, 0.0015468083395708996, 1.2650339490117446e-05, -0.0028987431875423155, 0.47592750289444224, 0.007785195989399363, 1.0010701722494515e-05, -0.0032874462056077143, 0.20097311411537389, -13.74, 0.46, 5.13> texture { Material909 } }
sphere { <6.67, 0.86, -13.07>, 0.143 texture { Material910 } }
sphere { <0, 0, 0>, 1 matrix <0.20897464920639042, 0.0032551228501611507, 1.2817816993612482e-05, -0.005918405182111184, 0.3799421241594287, 0.0029924520583708234, 9.812682865923431e-06, -0.001259979814050873, 0.1599950385311352, 6.67, 0.37, -13.07> texture { Material910 } }
sphere { <3.91, 1.22, 14.15>, 0.203 texture { Material911 } }
sphere { <0, 0, 0>, 1 matrix <0.29783177343577477, 0.010011617926845016, -4.73137211883487e-05, -0.018041069888307965, 0.5366728741092545, -0.0050740509060866155, -3.6040988958909916e-05, 0.002144896751734938, 0.22698986347185532, 3.91, 0.53, 14.15> texture { Material911 } }
sphere { <-12.45, 0.91, -7.8>, 0.151 texture { Material912 } }
sphere { <0, 0, 0>, 1 matrix <0.229, 0, 0, 0, 0.4, 0, 0, 0, 0.169, -12.45, 0.39, -7.8> texture { Material912 } }
sphere { <14.46, 0.91, -2.66>, 0.151 texture { Material913 } }
sphere { <0, 0, 0>, 1 matrix <0.20399087608069483, -0.0019287322928774778, 4.967467177257038e-05, 0.003791282595313082, 0.40045044343658415, -0.020641427463371224, 4.115205651747252e-05, 0.008699254965859693, 0.168775949914516, 14.46, 0.39, -2.66> texture { Material913 } }
sphere { <-8.87, 1.12, 11.73>, 0.187 texture { Material914 } }
sphere { <0, 0, 0>, 1 matrix <0.25338141012179416, -0.01771004692632414, 0.00046394240865438313, 0.03451367412807263, 0.49311637555541404, -0.025885255596054476, 0.0003817478874360869, 0.010929330140556333, 0.20871368908442292, -8.87, 0.48, 11.73> texture { Material914 } }
sphere { <-1.39, 1.06, -14.65>, 0.176 texture { Material915 } }
sphere { <0, 0, 0>, 1 matrix <0.2380978403371959, -0.020746369182040206, -8.119436965236912e-05, 0.04053788455235472, 0.4652229240088452, 0.003648409609711925, -6.69259030188984e-05, -0.0015390507347178785, 0.1969939766687283, -1.39, 0.46, -14.65> texture { Material915 } }
sphere { <10.92, 0.83, 9.87>, 0.138 texture { Material916 } }
sphere { <0, 0, 0>, 1 matrix <0.18394950704846208, -0.00430995899292131, -5.576833453441756e-05, 0.00854964691530586, 0.3647776518619699, 0.009442893607949754, -4.6675671295110356e-05, -0.003984124974313047, 0.15394844776603225, 10.92, 0.36, 9.87> texture { Material916 } }
sphere { <-14.73, 1.12, 0.1>, 0.186 texture { Material917 } }
sphere { <0, 0, 0>, 1 matrix <0.2839999956749749, -4.9562356226023726e-05, 4.3250250559823467e-07, 8.58615467014214e-05, 0.4919250660169445, -0.008586154670142138, 3.167623984663127e-07, 0.003629919047539766, 0.20796832376015334, -14.73, 0.48, 0.1> texture { Material917 } }
sphere { <10.79, 1.09, -10.03>, 0.181 texture { Material918 } }
sphere { <0, 0, 0>, 1 matrix <0.23893236019376823, 0.005685242258773669, 7.261332139584688e-05, -0.011394272142061037, 0.4787082061421469, 0.012232086270153758, 6.137192854377019e-05, -0.005158416339396784, 0.20193411542965156, 10.79, 0.47, -10.03> texture { Material918 } }
sphere { <-1.19, 1.12, 14.69>, 0.187 texture { Material919 } }
sphere { <0, 0, 0>, 1 matrix <0.28131743061731956, 0.019608677902995374, 5.460555061443371e-05, -0.03434995348964438, 0.49279664082835317, 0.0027479962791715504, 4.047007120005903e-05, -0.0011626138104187328, 0.20899676239430398, -1.19, 0.48, 14.69> texture { Material919 } }
sphere { <-9.06, 0.86, -11.64>, 0.143 texture { Material920 } }
sphere { <0, 0, 0>, 1 matrix <0.20882055888559412, 0.008657654936481062, -0.00013855579719946972, -0.015741190793601933, 0.37947922320673805, -0.012154590359616682, -0.00010607142369337396, 0.005117722256680708, 0.15991809674879373, -9.06, 0.37, -11.64> texture { Material920 } }
sphere { <14.55, 1.01, 2.47>, 0.169 texture { Material921 } }
sphere { <0, 0, 0>, 1 matrix <0.22899101102473662, 0.0020283317287180477, -5.2347561827944775e-05, -0.0039680900195008095, 0.4473860315700491, -0.02310828893709295, -4.3203882906033026e-05, 0.009748809395336087, 0.18874840091719428, 14.55, 0.44, 2.47> texture { Material921 } }
sphere { <-12.4, 0.83, 8.01>, 0.138 texture { Material922 } }
sphere { <0, 0, 0>, 1 matrix <0.20991584254936932, -0.005943223783774825, 0.0001309115898699508, 0.010358190023150408, 0.365498409720174, -0.016112740036011746, 9.600183257129726e-05, 0.006779677501491281, 0.1538506638160002, -12.4, 0.36, 8.01> texture { Material922 } }
sphere { <3.73, 0.96, -14.29>, 0.161 texture { Material923 } }
sphere { <0, 0, 0>, 1 matrix <0.20552945093405472, 0.013915102981696055, 0.00012127553246011778, -0.028775892573798638, 0.4249622854106851, 0.007416467158195526, 0.00010596891185835534, -0.003133718517547405, 0.17997268842477876, 3.73, 0.42, -14.29> texture { Material923 } }
sphere { <6.9, 1, 13.07>, 0.167 texture { Material924 } }
sphere { <0, 0, 0>, 1 matrix <0.23697191506641105, 0.0036484578605808704, -1.4999907712274997e-05, -0.0068196912752629775, 0.4429325289542813, -0.003642335112924545, -1.1835370220233858e-05, 0.0015375094043270654, 0.18699367883635964, 6.9, 0.43, 13.07> texture { Material924 } }
sphere { <-13.92, 1.09, -4.97>, 0.182 texture { Material925 } }
sphere { <0, 0, 0>, 1 matrix <0.23993236290072914, 0.005694406475845792, -0.00018699668621942022, -0.0114362663389903, 0.48082587222523526, -0.03161791281956141, -0.00015816803042725962, 0.013316257888736447, 0.20256271191587757, -13.92, 0.47, -4.97> texture { Material925 } }
sphere { <13.63, 1.17, -5.74>, 0.195 texture { Material926 } }
sphere { <0, 0, 0>, 1 matrix <0.2849933878953298, -0.0019412914905200594, 1.5597785375805263e-05, 0.0035147593302047395, 0.5159214107006979, -0.008291227137918874, 1.1930937585703675e-05, 0.0035028827830742527, 0.2179718552241568, 13.63, 0.5, -5.74> texture { Material926 } }
sphere { <-6.18, 1.17, 13.45>, 0.195 texture { Material927 } }
sphere { <0, 0, 0>, 1 matrix <0.2422376959343108, 0.01922953151342495, 0.00035183264570270707, -0.0408330792630752, 0.5140364642153407, 0.018846036582957786, 0.0003156358714534574, -0.007962085223032553, 0.21785432190548304, -6.18, 0.5, 13.45> texture { Material927 } }
sphere { <-4.53, 0.85, -14.1>, 0.142 texture { Material928 } }
sphere { <0, 0, 0>, 1 matrix <0.2049717821951951, -0.0034012378540458927, -9.207915252121045e-06, 0.00623836796644515, 0.37594273337880313, 0.0020356779679978915, -7.141748902864618e-06, -0.0008608319066799595, 0.15899766953456854, -4.53, 0.37, -14.1> texture { Material928 } }
sphere { <12.87, 0.87, 7.34>, 0.144 texture { Material929 } }
sphere { <0, 0, 0>, 1 matrix <0.19799251257348435, -0.0017218580390628163, -1.3028122137272768e-05, 0.00332196854001008, 0.3819418195497415, 0.005780225259617538, -1.0593574061115738e-05, -0.0024361682376922086, 0.16098156718113366, 12.87, 0.37, 7.34> texture { Material929 } }
sphere { <-14.45, 1.22, 3.28>, 0.203 texture { Material930 } }
sphere { <0, 0, 0>, 1 matrix <0.25197054838244354, 0.003850394278267011, 0.00013119356911522558, -0.008220286197252588, 0.5366894590397855, 0.036617638515034245, 0.00011817833408395323, -0.0154501932024401, 0.22647356923908057, -14.45, 0.53, 3.28> texture { Material930 } }
sphere { <8.44, 1.21, -12.19>, 0.201 texture { Material931 } }
sphere { <0, 0, 0>, 1 matrix <0.2688895171679286, 0.007708544551692661, 7.679904180575392e-05, -0.015245151306693292, 0.531675919974159, 0.010597239322945337, 6.395161845534898e-05, -0.004461995504398036, 0.22395554582619567, 8.44, 0.52, -12.19> texture { Material931 } }
sphere { <2.01, 0.96, 14.7>, 0.16 texture { Material932 } }
sphere { <0, 0, 0>, 1 matrix <0.23368559852058832, 0.012125966654676162, -4.4460815270340717e-05, -0.021920016644991522, 0.42242029320118474, -0.003099800333635165, -3.401062364697003e-05, 0.001311735838583202, 0.178995190416858, 2.01, 0.41, 14.7> texture { Material932 } }
sphere { <-11.42, 0.82, -9.49>, 0.136 texture { Material933 } }
sphere { <0, 0, 0>, 1 matrix <0.17590145008343472, -0.005887766996536685, -0.0001185678683675797, 0.01207661298721445, 0.36050526204640115, 0.014529675000242383, -0.0001030732037513619, -0.006158006302041786, 0.15287599005173663, -11.42, 0.35, -9.49> texture { Material933 } }
sphere { <14.83, 0.99, -0.72>, 0.165 texture { Material934 } }
sphere { <0, 0, 0>, 1 matrix <0.2379985542243437, -0.0008290663515154117, 2.891551312527885e-05, 0.0015187938204231912, 0.43493792591328334, -0.030375876408463825, 2.2354850483408857e-05, 0.012819177199902164, 0.1835529029903318, 14.83, 0.43, -0.72> texture { Material934 } }
sphere { <-10.46, 1.16, 10.55>, 0.194 texture { Material935 } }
sphere { <0, 0, 0>, 1 matrix <0.27366154143411914, 0.013610635174579024, 0.00033369154382623524, -0.025482685564084083, 0.5117503577832898, 0.02512377449980121, 0.0002630561075418497, -0.010578431368337351, 0.21574064890805733, -10.46, 0.5, 10.55> texture { Material935 } }
sphere { <0.58, 0.9, -14.85>, 0.149 texture { Material936 } }
sphere { <0, 0, 0>, 1 matrix <0.19352818066134775, 0.013521942675783176, 1.8872773546090475e-05, -0.02753179049966162, 0.3940377998526306, 0.0011012716199864652, 1.624615042369644e-05, -0.0004656009127537713, 0.16699935015398307, 0.58, 0.39, -14.85> texture { Material936 } }
sphere { <9.61, 1.09, 11.35>, 0.181 texture { Material937 } }
sphere { <0, 0, 0>, 1 matrix <0.2215121055805918, -0.014704181725677912, -0.00041727812186226354, 0.031792825352817106, 0.47817345508403786, 0.027191232209646213, -0.00037968549827106866, -0.011442976888226116, 0.20167526898174187, 9.61, 0.47, 11.35> texture { Material937 } }
sphere { <-14.76, 1.12, -1.88>, 0.186 texture { Material938 } }
sphere { <0, 0, 0>, 1 matrix <0.2799934954447931, 0.0019078927960422334, -4.9534689653136774e-05, -0.003359254101602932, 0.4923243606340049, -0.025582012004514633, -3.679719802804445e-05, 0.010793222103324632, 0.20771977518424797, -14.76, 0.48, -1.88> texture { Material938 } }
sphere { <12.16, 1.07, -8.59>, 0.178 texture { Material939 } }
sphere { <0, 0, 0>, 1 matrix <0.2608807222474876, -0.007887985939498344, 0.0001686340638968505, 0.014234641293117698, 0.4703545108694043, -0.02012483769026985, 0.00012857539737729214, 0.008502850743871975, 0.19881822098991486, 12.16, 0.46, -8.59> texture { Material939 } }
sphere { <-3.17, 0.83, 14.55>, 0.138 texture { Material940 } }
sphere { <0, 0, 0>, 1 matrix <0.192, 0, 0, 0, 0.365, 0, 0, 0, 0.154, -3.17, 0.36, 14.55> texture { Material940 } }
sphere { <-7.5, 1.21, -12.87>, 0.202 texture { Material941 } }
sphere { <0, 0, 0>, 1 matrix <0.3038615951108026, 0.009171943176135905, -8.046795883569318e-05, -0.016141413155370755, 0.5346740924552162, -0.0093845425321923, -5.982157466074559e-05, 0.0039643114248139434, 0.22596522001473213, -7.5, 0.52, -12.87> texture { Material941 } }
sphere { <14.23, 0.84, 4.43>, 0.14 texture { Material942 } }
sphere { <0, 0, 0>, 1 matrix <0.20799712730813869, -0.0010931371410447047, -9.096857560831778e-06, 0.0019392673319495002, 0.3689437995127084, 0.0061410132178400835, -6.822643170623834e-06, -0.0025962007099811736, 0.15597839496329302, 14.23, 0.36, 4.43> texture { Material942 } }
sphere { <-13.49, 1.01, 6.35>, 0.169 texture { Material943 } }
sphere { <0, 0, 0>, 1 matrix <0.22294320234965817, 0.005031341164099011, 0.00011887880304103286, -0.01010780646419891, 0.4473860315700491, 0.02115587399483493, 0.00010075378374329691, -0.008925134341570985, 0.18878911998751405, -13.49, 0.44, 6.35> texture { Material943 } }
sphere { <5.66, 1.05, -13.8>, 0.176 texture { Material944 } }
sphere { <0, 0, 0>, 1 matrix <0.23971814555257645, 0.01162744294973859, 0.0001151663333558563, -0.02252817071511852, 0.4643627336608769, 0.009205059001876383, 9.405250557394932e-05, -0.0038799818588554215, 0.19596156994395902, 5.66, 0.45, -13.8> texture { Material944 } }
sphere { <5.15, 1.1, 14.01>, 0.184 texture { Material945 } }
sphere { <0, 0, 0>, 1 matrix <0.24916450532597811, 0.020419415017125027, -0.00031108844245495354, -0.03969534279329105, 0.48415062327258834, -0.01478018082728922, -0.00025509252281306194, 0.006234438414803065, 0.20490501874150577, 5.15, 0.48, 14.01> texture { Material945 } }
sphere { <-13.27, 1.06, -6.86>, 0.176 texture { Material946 } }
sphere { <0, 0, 0>, 1 matrix <0.2469682788206819, -0.003957965340026025, -6.1373586071936e-05, 0.007467254447174607, 0.4657161253908986, 0.014447514039098695, -4.894978322336595e-05, -0.006107640055155457, 0.19690529281072003, -13.27, 0.46, -6.86> texture { Material946 } }
sphere { <14.42, 0.92, -3.91>, 0.154 texture { Material947 } }
sphere { <0, 0, 0>, 1 matrix <0.18595255692208862, 0.004197051992689722, 0.00017699917528476934, -0.009206436629125842, 0.40644743682143214, 0.034347090500969485, 0.000163676656714948, -0.014479655799428313, 0.17138936016533268, 14.42, 0.4, -3.91> texture { Material947 } }
sphere { <-8, 1.15, 12.63>, 0.191 texture { Material948 } }
sphere { <0, 0, 0>, 1 matrix <0.2259753802501075, -0.0033357577126650554, 1.553388981313851e-05, 0.007468554878798752, 0.505922933749134, -0.004712302483051594, 1.4709081504476287e-05, 0.0019929500620020574, 0.21399071927000313, -8, 0.49, 12.63> texture { Material948 } }
sphere { <-2.64, 1.16, -14.72>, 0.193 texture { Material949 } }
sphere { <0, 0, 0>, 1 matrix <0.29295683102685544, -0.005029422614328726, -7.928995067371025e-06, 0.008788615626403783, 0.5119220199200724, 0.0016142355232170212, -5.845265988232565e-06, -0.0006810056113571807, 0.21599892637971643, -2.64, 0.5, -14.72> texture { Material949 } }
sphere { <11.89, 0.92, 9.08>, 0.153 texture { Material950 } }
sphere { <0, 0, 0>, 1 matrix <0.22698708624017905, -0.0024212394529919594, -1.672437747305331e-05, 0.004309166251139875, 0.4039384688431821, 0.005580723505574593, -1.2598539858555578e-05, -0.0023621379194387507, 0.17098368385821597, 11.89, 0.4, 9.08> texture { Material950 } }
sphere { <-14.91, 0.9, 1.34>, 0.151 texture { Material951 } }
sphere { <0, 0, 0>, 1 matrix <0.22599557658010677, -0.001413135021889368, 4.9149109924785054e-05, 0.0024948711227161854, 0.39802805605366987, -0.02772079025240206, 3.653562153700836e-05, 0.01167191168522192, 0.1675940486495888, -14.91, 0.39, 1.34> texture { Material951 } }
sphere { <10.09, 0.85, -11.06>, 0.141 texture { Material952 } }
sphere { <0, 0, 0>, 1 matrix <0.20238889969939217, 0.01572981706044849, 0.0005532935154152043, -0.02890257026377974, 0.37095666697236596, 0.02616854334693571, 0.00043064224352513437, -0.011084798522294484, 0.15761009418491645, 10.09, 0.37, -11.06> texture { Material952 } }
sphere { <0.03, 0.88, 14.98>, 0.147 texture { Material953 } }
sphere { <0, 0, 0>, 1 matrix <0.22215141767445926, -0.01943573063272777, 0, 0.03390358392883903, 0.38751973755768904, 0, 0, 0, 0.164, 0.03, 0.38, 14.98> texture { Material953 } }
sphere { <-10.15, 0.93, -11.03>, 0.155 texture { Material954 } }
sphere { <0, 0, 0>, 1 matrix <0.19185733701036445, 0.007398989742092068, -0.00013109572020564544, -0.015799926011759103, 0.40943810924937524, -0.014518850929724578, -0.00011812270622696178, 0.006126246855713054, 0.17289145481049412, -10.15, 0.4, -11.03> texture { Material954 } }
sphere { <14.94, 0.9, 1.28>, 0.15 texture { Material955 } }
sphere { <0, 0, 0>, 1 matrix <0.2119989623332578, 0.0006632018467710405, -1.152963046885513e-05, -0.0012450676179946894, 0.3977575491536001, -0.013834084644385437, -9.136688296073877e-06, 0.005839513116222998, 0.16789848124115475, 14.94, 0.39, 1.28> texture { Material955 } }
sphere { <-11.89, 1.07, 9.15>, 0.178 texture { Material956 } }
sphere { <0, 0, 0>, 1 matrix <0.21968730212325485, -0.011718587184721163, 0.00040496938135848296, 0.02503516353099521, 0.4682115081031204, -0.0324225888352233, 0.00036447244322263466, 0.013658877849732371, 0.19752797831123628, -11.89, 0.46, 9.15> texture { Material956 } }
sphere { <2.58, 0.87, -14.79>, 0.144 texture { Material957 } }
sphere { <0, 0, 0>, 1 matrix <0.2018804715673003, 0.006948005360200574, 2.052508440298218e-05, -0.013139297265329797, 0.3817672959212946, 0.002256242964753602, 1.6359101925149165e-05, -0.0009509296265060993, 0.16099719086128558, 2.58, 0.37, -14.79> texture { Material957 } }
sphere { <8.09, 1.11, 12.66>, 0.186 texture { Material958 } }
sphere { <0, 0, 0>, 1 matrix <0.2383564781133925, -0.017521934818343902, -0.0004136926413905222, 0.03607025912395481, 0.49012779146113883, 0.023188023722542382, -0.0003600337632185298, -0.009803066939611414, 0.20776854972364522, 8.09, 0.48, 12.66> texture { Material958 } }
sphere { <-14.52, 1.02, -3.87>, 0.17 texture { Material959 } }
sphere { <0, 0, 0>, 1 matrix <0.22697914718563797, 0.003075823548473675, -7.779703819682777e-05, -0.006097447563053541, 0.44938329063955823, -0.022748169754468976, -6.511646368897478e-05, 0.009604782785220234, 0.18975706550085267, -14.52, 0.44, -3.87> texture { Material959 } }
sphere { <13.33, 1.08, -6.96>, 0.18 texture { Material960 } }
sphere { <0, 0, 0>, 1 matrix <0.26692285797642334, -0.006416043424612, 0.00014925304561570708, 0.011462369713632674, 0.4763462880779317, -0.02217719357637626, 0.00011235903433991432, 0.009345106727152261, 0.20078260969442932, 13.33, 0.47, -6.96> texture { Material960 } }
sphere { <-5.13, 0.92, 14.14>, 0.154 texture { Material961 } }
sphere { <0, 0, 0>, 1 matrix <0.22796929197794508, 0.0037418968058324795, 1.1107156913486642e-05, -0.00667961403497289, 0.4069380119286512, 0.0024160306083944503, 8.37908328561273e-06, -0.0010210252202551486, 0.17199696926774774, -5.13, 0.4, 14.14> texture { Material961 } }
sphere { <-5.77, 1, -13.9>, 0.167 texture { Material962 } }
sphere { <0, 0, 0>, 1 matrix <0.21388863619462858, -0.006902839341692019, -4.599809352297337e-05, 0.0142895225624746, 0.4427301363694594, 0.005902194101891682, -4.0194595742037483e-05, -0.002491445365809807, 0.1869833978843674, -5.77, 0.43, -13.9> texture { Material962 } }
sphere { <13.65, 1.07, 6.35>, 0.179 texture { Material963 } }
sphere { <0, 0, 0>, 1 matrix <0.24283761570198337, -0.008875168390811516, -0.00035183264570270707, 0.01727553353437797, 0.4712000921973956, 0.03743032265781893, -0.0002895741939939976, -0.015826774908168684, 0.19937258924634635, 13.65, 0.46, 6.35> texture { Material963 } }
sphere { <-14.36, 1.18, 4.54>, 0.196 texture { Material964 } }
sphere { <0, 0, 0>, 1 matrix <0.263941684467681, -0.005545547663313681, 0.00018466585234340292, 0.010902042565378032, 0.5177357420848487, -0.03452313479036377, 0.000153188718421232, 0.014567565547378931, 0.2185149023916661, -14.36, 0.51, 4.54> texture { Material964 } }
sphere { <7.53, 1.18, -13.05>, 0.196 texture { Material965 } }
sphere { <0, 0, 0>, 1 matrix <0.24155686520337863, 0.0146361201714903, 0.0002546751704720496, -0.03138903458265895, 0.5177357420848487, 0.018039675047505144, 0.00023047050550982997, -0.007612117216577315, 0.2188675456864886, 7.53, 0.51, -13.05> texture { Material965 } }
sphere { <3.27, 1.15, 14.72>, 0.192 texture { Material966 } }
sphere { <0, 0, 0>, 1 matrix <0.2939573707076628, -0.005006407400105993, -9.569841136915573e-06, 0.008667555668890986, 0.5089224768346031, 0.0019457778032204258, -6.998353212370232e-06, -0.0008218904276864274, 0.2149984289411156, 3.27, 0.5, 14.72> texture { Material966 } }
sphere { <-12.36, 0.84, -8.65>, 0.14 texture { Material967 } }
sphere { <0, 0, 0>, 1 matrix <0.1786805467974754, 0.010679466131299407, -0.00045956425626347396, -0.022015212304187046, 0.36697857939089285, -0.03167100717444453, -0.000400514100430737, 0.013389368886757036, 0.15542382182043296, -12.36, 0.36, -8.65> texture { Material967 } }
sphere { <14.96, 1.01, -1.97>, 0.169 texture { Material968 } }
sphere { <0, 0, 0>, 1 matrix <0.21697984969597198, 0.0029531810476735505, 0.00015345231529027123, -0.006096889904874427, 0.4455458091249864, 0.046430161583274475, 0.00013365201654313947, -0.01958772441794392, 0.18798218848940226, 14.96, 0.44, -1.97> texture { Material968 } }
sphere { <-9.7, 0.95, 11.56>, 0.158 texture { Material969 } }
sphere { <0, 0, 0>, 1 matrix <0.2045386398825059, -0.013740369252418396, 0.00038346814960548434, 0.027949921845163272, 0.4154131891042579, -0.023231103871304542, 0.0003292214357588548, 0.009804974295802396, 0.17572636140404457, -9.7, 0.41, 11.56> texture { Material969 } }
sphere { <-0.66, 0.99, -15.09>, 0.165 texture { Material970 } }
sphere { <0, 0, 0>, 1 matrix <0.23367982341510612, -0.012236828210935635, -1.280706339575571e-05, 0.022904832292264136, 0.43739973622250333, 0.0009161932916905656, -1.0125242428268402e-05, -0.00038697661863642613, 0.18499959499030286, -0.66, 0.43, -15.09> texture { Material970 } }
sphere { <10.68, 0.99, 10.69>, 0.166 texture { Material971 } }
sphere { <0, 0, 0>, 1 matrix <0.24383280324005802, -0.009029734732461396, -0.00016719675994199238, 0.01624612109651866, 0.43839836575725794, 0.01624612109651866, -0.00012676803520192046, -0.006846315268464583, 0.1848732319647981, 10.68, 0.43, 10.69> texture { Material971 } }
sphere { <-15.1, 1.06, -0.67>, 0.177 texture { Material972 } }
sphere { <0, 0, 0>, 1 matrix <0.2459990427417954, 0.0006858552367510643, -2.3931455115145655e-05, -0.0013047977674776345, 0.46685997552159775, -0.03261994418694086, -1.926190289755626e-05, 0.013800745617551902, 0.1975184524275611, -15.1, 0.46, -0.67> texture { Material972 } }
sphere { <11.59, 0.85, -9.71>, 0.142 texture { Material973 } }
sphere { <0, 0, 0>, 1 matrix <0.1938069162966247, 0.008650157832281808, 0.00023230383062341673, -0.01676525435535031, 0.3750840828976939, 0.02017069664628084, 0.00019039334571713023, -0.008529629698826206, 0.1587709330059341, 11.59, 0.37, -9.71> texture { Material973 } }
sphere { <-1.99, 1.18, 15>, 0.197 texture { Material974 } }
sphere { <0, 0, 0>, 1 matrix <0.2448532824900169, 0.008477598875135876, 1.9265935654345017e-05, -0.018027873526309354, 0.5206826208769489, 0.0023672965236567847, 1.730002385288124e-05, -0.0009996261712178361, 0.2199977282796961, -1.99, 0.51, 15> texture { Material974 } }
sphere { <-8.67, 1.02, -12.41>, 0.17 texture { Material975 } }
sphere { <0, 0, 0>, 1 matrix <0.2139780249751887, -0.0030666911129182102, -1.5275322124919494e-05, 0.006462979868813611, 0.4509313105155325, 0.004492559177102145, -1.3562201886610765e-05, -0.0018926524249432536, 0.18999057261576174, -8.67, 0.44, -12.41> texture { Material975 } }
sphere { <14.78, 0.95, 3.29>, 0.159 texture { Material976 } }
sphere { <0, 0, 0>, 1 matrix <0.1999868496197703, 0.0022927162196982897, -5.857896647777192e-05, -0.004814704061366408, 0.419424404596921, -0.02144731809154127, -5.1842385332828155e-05, 0.009038512624292392, 0.17676906573806286, 14.78, 0.41, 3.29> texture { Material976 } }
sphere { <-13.13, 0.97, 7.56>, 0.161 texture { Material977 } }
sphere { <0, 0, 0>, 1 matrix <0.2139676325807147, 0.0037214292872030353, 5.6319309556436095e-05, -0.0074254687179238135, 0.4267398831371539, 0.012920315569187435, 4.7371381869899516e-05, -0.005446503050242946, 0.17991757379554638, -13.13, 0.42, 7.56> texture { Material977 } }
sphere { <4.58, 1.2, -14.45>, 0.199 texture { Material978 } }
sphere { <0, 0, 0>, 1 matrix <0.29135320318888813, -0.019423420729838575, 0.00020425162456164263, 0.03512180186765332, 0.5267138185371872, -0.011091095326627363, 0.00015598668588098048, 0.004684307306511177, 0.2229507410465639, 4.58, 0.52, -14.45> texture { Material978 } }
sphere { <6.39, 1.15, 13.75>, 0.191 texture { Material979 } }
sphere { <0, 0, 0>, 1 matrix <0.23525965531068865, 0.018675594391639044, -0.00034169754891291715, -0.04004174051766677, 0.5040745172344232, -0.018480803315846204, -0.00030984438757357744, 0.007815991916187918, 0.21385699489804297, 6.39, 0.5, 13.75> texture { Material979 } }
sphere { <-14.01, 0.9, -5.83>, 0.151 texture { Material980 } }
sphere { <0, 0, 0>, 1 matrix <0.19198295397753232, -0.002558061552061406, -4.126931755332191e-05, 0.00531597166287761, 0.39875693998061923, 0.012870247183808952, -3.611065285915667e-05, -0.0054190514458142955, 0.16791257420886732, -14.01, 0.39, -5.83> texture { Material980 } }
sphere { <14.27, 0.96, -5.17>, 0.161 texture { Material981 } }
sphere { <0, 0, 0>, 1 matrix <0.20594194482312583, -0.004887698891767639, 0.00016050548900500237, 0.010107571494626282, 0.4249622854106851, -0.027944462367496186, 0.00014024751466456517, 0.011807519310209656, 0.17961225687122148, 14.27, 0.42, -5.17> texture { Material981 } }
sphere { <-7.04, 1.06, 13.46>, 0.177 texture { Material982 } }
sphere { <0, 0, 0>, 1 matrix <0.2657123093468567, 0.012367156166281102, 0.00014869404544486174, -0.021805249030021942, 0.4683572517998951, 0.011270128712146171, 0.00011068203382737829, -0.004757964786790921, 0.1979427935555499, -7.04, 0.46, 13.46> texture { Material982 } }
sphere { <-3.9, 1, -14.68>, 0.167 texture { Material983 } }
sphere { <0, 0, 0>, 1 matrix <0.22387269184716693, 0.007550939058642873, -3.4123834779996964e-05, -0.014865911271703156, 0.44073135471542124, -0.003984677248085383, -2.8334969951247474e-05, 0.001680612172661862, 0.18599240505960069, -3.9, 0.43, -14.68> texture { Material983 } }
sphere { <12.8, 1.18, 8.19>, 0.197 texture { Material984 } }
sphere { <0, 0, 0>, 1 matrix <0.29498686164535004, 0.0027840687739566416, -2.0437440566557795e-05, -0.004907511059177809, 0.5199208014813235, -0.007633906092054369, -1.5241481100483784e-05, 0.0032297295004845407, 0.21997629102939925, 12.8, 0.51, 8.19> texture { Material984 } }
sphere { <-14.98, 0.99, 2.61>, 0.165 texture { Material985 } }
sphere { <0, 0, 0>, 1 matrix <0.237, 0, 0, 0, 0.436, 0, 0, 0, 0.184, -14.98, 0.43, 2.61> texture { Material985 } }
sphere { <9.29, 1.16, -12.05>, 0.193 texture { Material986 } }
sphere { <0, 0, 0>, 1 matrix <0.2819730926784614, -0.003895455516267413, 2.0776539415863582e-05, 0.007058786414229249, 0.510922172224916, -0.005450455332506129, 1.5913945084491255e-05, 0.00230391066892627, 0.21598771201708666, 9.29, 0.5, -12.05> texture { Material986 } }
sphere { <1.29, 1.13, 15.17>, 0.188 texture { Material987 } }
sphere { <0, 0, 0>, 1 matrix <0.243, 0, 0, 0, 0.497, 0, 0, 0, 0.21, 1.29, 0.49, 15.17> texture { Material987 } }
sphere { <-11.2, 1.01, -10.32>, 0.168 texture { Material988 } }
sphere { <0, 0, 0>, 1 matrix <0.24737801708488694, -0.017540197222352314, -0.0006768637605642086, 0.03147333775784992, 0.4425622434388816, 0.03425039697177785, -0.0005131063991373839, -0.014469830630773561, 0.1874416195068211, -11.2, 0.44, -10.32> texture { Material988 } }
sphere { <15.24, 0.86, 0.04>, 0.143 texture { Material989 } }
sphere { <0, 0, 0>, 1 matrix <0.187, 0, 0, 0, 0.3759292764492073, -0.03951175911517301, 0, 0.016620025659556902, 0.15812898136355547, 15.24, 0.37, 0.04> texture { Material989 } }
sphere { <-11.27, 1.01, 10.26>, 0.168 texture { Material990 } }
sphere { <0, 0, 0>, 1 matrix <0.23841020576072802, 0.016767511688787224, 0.0006514145329272602, -0.031149686986700953, 0.44156772154351337, 0.03440413189575926, 0.000509684174298735, -0.014490028523664373, 0.18643706524032677, -11.27, 0.43, 10.26> texture { Material990 } }
sphere { <1.38, 1.13, -15.19>, 0.189 texture { Material991 } }
sphere { <0, 0, 0>, 1 matrix <0.28146215295032373, 0.029462472745559375, 0.00013840623447086527, -0.052053838773073104, 0.49726094768413664, 0.004684845489576579, 0.00010319334089523875, -0.0019770047966013162, 0.21099071259931942, 1.38, 0.49, -15.19> texture { Material991 } }
sphere { <9.25, 1.2, 12.13>, 0.2 texture { Material992 } }
sphere { <0, 0, 0>, 1 matrix <0.2394224934560736, 0.016633572083704362, -0.0004403487397438609, -0.03673247168484713, 0.5279831899886251, -0.02800850965969594, -0.0004109921570942702, 0.011837558799569605, 0.22368661848021562, 9.25, 0.52, 12.13> texture { Material992 } }
sphere { <-15.02, 0.91, -2.7>, 0.152 texture { Material993 } }
sphere { <0, 0, 0>, 1 matrix <0.18698513403275002, 0.0023565016374738745, -8.093693280543027e-05, -0.0050784500529517185, 0.4020183122547092, -0.02764933917718158, -7.357902982311842e-05, 0.01166349295315352, 0.1695994030598519, -15.02, 0.39, -2.7> texture { Material993 } }
sphere { <12.91, 0.9, -8.16>, 0.149 texture { Material994 } }
sphere { <0, 0, 0>, 1 matrix <0.1799309413357193, 0.00498438396305629, 0.00011075446158222828, -0.01093795369670686, 0.3944586662280567, 0.01754200121169968, 0.00010275552824573401, -0.007416491651528726, 0.1668352033980965, 12.91, 0.39, -8.16> texture { Material994 } }
sphere { <-4.01, 1.01, 14.74>, 0.168 texture { Material995 } }
sphere { <0, 0, 0>, 1 matrix <0.23686549224105263, 0.007983561756404928, 3.642918471490737e-05, -0.014990231989874234, 0.4447289180234976, 0.0040598544972576065, 2.889741234769024e-05, -0.0017151744842346741, 0.18799217361748918, -4.01, 0.44, 14.74> texture { Material995 } }
sphere { <-7.01, 1.02, -13.58>, 0.17 texture { Material996 } }
sphere { <0, 0, 0>, 1 matrix <0.20090336982210522, 0.006231653051199223, -4.9943687451251556e-05, -0.013920458805912691, 0.448726481331574, -0.0071948438772133005, -4.696197476759475e-05, 0.003028564571922748, 0.18897572751865943, -7.01, 0.44, -13.58> texture { Material996 } }
sphere { <14.35, 0.83, 5.29>, 0.138 texture { Material997 } }
sphere { <0, 0, 0>, 1 matrix <0.17291984508429512, 0.00526125778419966, -0.00021527320217882786, -0.01113075346252645, 0.36460725950157885, -0.02989402358507104, -0.00019163048055225137, 0.012578359650549016, 0.15348533528080252, 14.35, 0.36, 5.29> texture { Material997 } }
sphere { <-14.16, 0.93, 5.8>, 0.156 texture { Material998 } }
sphere { <0, 0, 0>, 1 matrix <0.23681425138294793, -0.009370362055305094, 0.0004545952996274408, 0.016289405767028264, 0.4097430208917286, -0.03986617727193761, 0.0003337535111188806, 0.016836686517760057, 0.1731831821964722, -14.16, 0.4, 5.8> texture { Material998 } }
sphere { <6.53, 0.9, -13.84>, 0.151 texture { Material999 } }
sphere { <0, 0, 0>, 1 matrix <0.19178577268572855, 0.00906680314064354, 0.00010235305015192068, -0.018794727343625674, 0.3974545548323204, 0.008979703064176711, 8.955891888293059e-05, -0.0037904274240745917, 0.16795721073875594, 6.53, 0.39, -13.84> texture { Material999 } }
sphere { <4.54, 1.09, 14.62>, 0.181 texture { Material1000 } }
sphere { <0, 0, 0>, 1 matrix <0.217909084448162, -0.021829160198146805, -0.000344499647948839, 0.04774505815028456, 0.4763759878814029, 0.015077386784300387, -0.0003177576661445912, -0.006358313424694527, 0.20189965547384908, 4.54, 0.47, 14.62> texture { Material1000 } }
sphere { <-13.23, 1.09, -7.72>, 0.182 texture { Material1001 } }
sphere { <0, 0, 0>, 1 matrix <0.25491171467320545, 0.0067078061773102726, -0.00015185076208668066, -0.012679068931229612, 0.48133943575170457, -0.021807998561714934, -0.00012088511648469089, 0.00918469648968492, 0.20279207759964635, -13.23, 0.47, -7.72> texture { Material1001 } }
sphere { <14.98, 0.86, -3.25>, 0.143 texture { Material1002 } }
sphere { <0, 0, 0>, 1 matrix <0.1919538235863238, 0.004205136701742722, 0.0002154899304889961, -0.008300764635210895, 0.37692379834457557, 0.03873690163098418, 0.00017957494207416342, -0.016353309395666146, 0.1591619836036539, 14.98, 0.37, -3.25> texture { Material1002 } }
sphere { <-8.85, 1.07, 12.52>, 0.178 texture { Material1003 } }
sphere { <0, 0, 0>, 1 matrix <0.26632279054735286, -0.018998468157690723, 0.00047900180796993825, 0.03344299638245183, 0.4682115081031204, -0.023654802319295194, 0.000357008838149879, 0.01001554396072286, 0.19874748155350375, -8.85, 0.46, 12.52> texture { Material1003 } }
sphere { <-1.93, 0.97, -15.22>, 0.162 texture { Material1004 } }
sphere { <0, 0, 0>, 1 matrix <0.2025138843619957, 0.014040034398730732, -6.383336660662693e-05, -0.029670811611110754, 0.42795497756146456, -0.003896167181256969, -5.6915464806893956e-05, 0.0016438374354487443, 0.18099252625209605, -1.93, 0.42, -15.22> texture { Material1004 } }
sphere { <11.71, 0.99, 9.92>, 0.165 texture { Material1005 } }
sphere { <0, 0, 0>, 1 matrix <0.24674581579341026, -0.011198841931520598, -0.0002971999953972315, 0.019858675166016283, 0.436933054013803, 0.023219374040265188, -0.00022259918683598307, -0.009807269857189634, 0.18473973018154563, 11.71, 0.43, 9.92> texture { Material1005 } }
sphere { <-15.34, 1.03, 0.59>, 0.172 texture { Material1006 } }
sphere { <0, 0, 0>, 1 matrix <0.21899978688676866, 0.0003054753085410508, 5.327830783467575e-06, -0.0006332684478430917, 0.4537234354666695, 0.015831711196077288, 4.670974933451024e-06, -0.006695349228297003, 0.1918832256266637, -15.34, 0.44, 0.59> texture { Material1006 } }
sphere { <10.92, 1.1, -10.8>, 0.183 texture { Material1007 } }
sphere { <0, 0, 0>, 1 matrix <0.2729180272913635, -0.00668905572617378, 8.314374733132271e-05, 0.011883487279099937, 0.4847045511042614, -0.01205325138308708, 6.243394946124964e-05, 0.005094673265016188, 0.204936674136975, 10.92, 0.47, -10.8> texture { Material1007 } }
sphere { <-0.75, 0.86, 15.35>, 0.143 texture { Material1008 } }
sphere { <0, 0, 0>, 1 matrix <0.1765699121156996, -0.012331491110775451, 2.1504394215018305e-05, 0.026265379371538673, 0.3760816469479537, -0.0013132689685769337, 1.9317506667728306e-05, 0.0005538720583653381, 0.15899903412466662, -0.75, 0.37, 15.35> texture { Material1008 } }
sphere { <-9.82, 1.15, -11.83>, 0.192 texture { Material1009 } }
sphere { <0, 0, 0>, 1 matrix <0.2449779312940299, -0.0032882886793137124, -1.8342820546577233e-05, 0.006818165914658636, 0.5079226291394467, 0.005667046994001983, -1.6096760887812676e-05, -0.0023984549285638312, 0.21498662087406728, -9.82, 0.5, -11.83> texture { Material1009 } }
sphere { <15.24, 0.96, 2.09>, 0.16 texture { Material1010 } }
sphere { <0, 0, 0>, 1 matrix <0.2069777675641574, 0.0030296893529886647, -0.0001572150820297746, -0.006191104330020314, 0.42068276174077956, -0.043779952048000795, -0.0001359492738325104, 0.018526268124331304, 0.17803864442075581, 15.24, 0.41, 2.09> texture { Material1010 } }
sphere { <-12.66, 0.89, 8.75>, 0.149 texture { Material1011 } }
sphere { <0, 0, 0>, 1 matrix <0.18391784958877372, 0.005496420273515229, 0.00011818129334306933, -0.01176950862915761, 0.3934600366933021, 0.01693157381738463, 0.00010662007986385601, -0.007133607242857484, 0.1658466167272134, -12.66, 0.39, 8.75> texture { Material1011 } }
sphere { <3.42, 1.02, -15.01>, 0.171 texture { Material1012 } }
sphere { <0, 0, 0>, 1 matrix <0.21596868051991555, 0.0036781768653839945, 7.030903692427768e-06, -0.007679897066148989, 0.4509313105155325, 0.0017240585250538547, 6.21714169098937e-06, -0.0007301445194795704, 0.1909986043151306, 3.42, 0.44, -15.01> texture { Material1012 } }
sphere { <7.62, 1, 13.38>, 0.167 texture { Material1013 } }
sphere { <0, 0, 0>, 1 matrix <0.22897352155087947, -0.0034822702633364178, -1.4913149504676035e-05, 0.006706031380486289, 0.44093283356396856, 0.003776960202802622, -1.2112863789824204e-05, -0.0015930036229507658, 0.18599317781234825, 7.62, 0.43, 13.38> texture { Material1013 } }
sphere { <-14.67, 0.98, -4.72>, 0.164 texture { Material1014 } }
sphere { <0, 0, 0>, 1 matrix <0.2029524121386779, -0.0043928509653961036, -0.00014583376856779502, 0.009369972748849816, 0.4319452337625039, 0.028714432617442984, -0.00013146590959559843, -0.012135660898365049, 0.18259712059962638, -14.67, 0.42, -4.72> texture { Material1014 } }
sphere { <14.01, 0.91, -6.43>, 0.152 texture { Material1015 } }
sphere { <0, 0, 0>, 1 matrix <0.18997967442346642, 0.002778734701671638, 4.40387491561015e-05, -0.005893842551440369, 0.4027545032886956, 0.012769992194787467, 3.940309135019608e-05, -0.0053868453427143165, 0.16991462663540793, 14.01, 0.39, -6.43> texture { Material1015 } }
sphere { <-5.99, 1.22, 14.21>, 0.203 texture { Material1016 } }
sphere { <0, 0, 0>, 1 matrix <0.29064405910264823, 0.028101610489600828, 0.0005748010325730142, -0.051776254943168655, 0.535052779708131, 0.02194862981286497, 0.00044684874792491185, -0.009260853099480201, 0.2268105749872927, -5.99, 0.53, 14.21> texture { Material1016 } }
sphere { <-5.18, 0.86, -14.53>, 0.143 texture { Material1017 } }
sphere { <0, 0, 0>, 1 matrix <0.20455840365889114, -0.013447452547738775, -0.00015972633614575477, 0.02479579055144028, 0.37707921099821357, 0.008968690199457124, -0.0001246644574796135, -0.0037962709838971955, 0.1599549086004861, -5.18, 0.37, -14.53> texture { Material1017 } }
sphere { <13.64, 1.2, 7.22>, 0.201 texture { Material1018 } }
sphere { <0, 0, 0>, 1 matrix <0.26268023731401785, 0.012951234591689065, -0.000598704603541053, -0.026148690373334196, 0.5280911264405531, -0.04895925006071084, -0.0005099233125216572, 0.020653242963463707, 0.22304524996804456, 13.64, 0.52, 7.22> texture { Material1018 } }
sphere { <-14.94, 0.82, 3.89>, 0.137 texture { Material1019 } }
sphere { <0, 0, 0>, 1 matrix <0.208992069641157, -0.0018204066374472574, 3.076979231082223e-05, 0.0031704689762239316, 0.36377826103495087, -0.012301419627748854, 2.2672478544816382e-05, 0.0052044467655860535, 0.1539120307832461, -14.94, 0.36, 3.89> texture { Material1019 } }
sphere { <8.39, 1.22, -12.97>, 0.203 texture { Material1020 } }
sphere { <0, 0, 0>, 1 matrix <0.28172654023449384, 0.01241473412610741, 0.0001757955635396482, -0.023684847375339674, 0.5372626896979608, 0.015225973312718362, 0.00014150919476418493, -0.006424341899604216, 0.22690902980336589, 8.39, 0.53, -12.97> texture { Material1020 } }
sphere { <2.58, 1.07, 15.24>, 0.178 texture { Material1021 } }
sphere { <0, 0, 0>, 1 matrix <0.226, 0, 0, 0, 0.471, 0, 0, 0, 0.199, 2.58, 0.46, 15.24> texture { Material1021 } }
sphere { <-12.2, 0.94, -9.5>, 0.156 texture { Material1022 } }
sphere { <0, 0, 0>, 1 matrix <0.23278799925987914, -0.00993337899724403, -0.0002745583355663898, 0.01760723401657418, 0.4119939527573074, 0.02280281126736656, -0.0002062133421635975, -0.009662208164138373, 0.17473293681916516, -12.2, 0.4, -9.5> texture { Material1022 } }
sphere { <15.42, 0.94, -1.23>, 0.157 texture { Material1023 } }
sphere { <0, 0, 0>, 1 matrix <0.2349997723902178, -0.00032706031721744074, 2.8451222772696054e-06, 0.0005789663487764057, 0.41593664118505874, -0.007237079359705073, 2.130814982125322e-06, 0.0030618412675675307, 0.17597336481272344, 15.42, 0.41, -1.23> texture { Material1023 } }
sphere { <-10.54, 0.91, 11.33>, 0.151 texture { Material1024 } }
sphere { <0, 0, 0>, 1 matrix <0.2169292230110613, 0.005541467057668822, 6.592924997028777e-05, -0.010214685820587691, 0.39975633080763834, 0.009515049805478945, 5.134582140543149e-05, -0.004020108542814854, 0.16895217101567714, -10.54, 0.39, 11.33> texture { Material1024 } }
sphere { <0.12, 0.89, -15.48>, 0.149 texture { Material1025 } }
sphere { <0, 0, 0>, 1 matrix <0.19473278599854205, -0.010205001230068159, 2.672140014579568e-06, 0.02061933581870182, 0.3934600366933021, -0.00020619335818701824, 2.274744832924145e-06, 8.687334380468281e-05, 0.16599997725255167, 0.12, 0.39, -15.48> texture { Material1025 } }
sphere { <10.38, 0.97, 11.5>, 0.161 texture { Material1026 } }
sphere { <0, 0, 0>, 1 matrix <0.19973227775660407, -0.010342072605262728, -0.00024239716631794546, 0.022080325012235922, 0.42595984946094495, 0.01999164561918658, -0.0002181574496861509, -0.008427391595910032, 0.1798024790658247, 10.38, 0.42, 11.5> texture { Material1026 } }
sphere { <-15.43, 0.84, -1.47>, 0.139 texture { Material1027 } }
sphere { <0, 0, 0>, 1 matrix <0.171993519683879, 0.0014916391324378642, -6.480316120987785e-05, -0.003191413957774035, 0.36659964889776236, -0.03191413957774035, -5.8774960167098536e-05, 0.01352882003838993, 0.155412250398329, -15.43, 0.36, -1.47> texture { Material1027 } }
sphere { <12.38, 0.83, -9.34>, 0.139 texture { Material1028 } }
sphere { <0, 0, 0>, 1 matrix <0.20971231917573596, -0.01098162358620493, 0.00038357443235204904, 0.01919169455303433, 0.3656034541996706, -0.025588926070712437, 0.0002831144619741314, 0.010807312100709612, 0.15462251405070115, 12.38, 0.36, -9.34> texture { Material1028 } }
sphere { <-2.82, 1.07, 15.25>, 0.179 texture { Material1029 } }
sphere { <0, 0, 0>, 1 matrix <0.24310180769897685, -0.020916115247274963, 0.00016497409610629024, 0.040632125521345624, 0.47219628689548737, -0.007463043463104299, 0.00013522466893958217, 0.003148963486541898, 0.19997516281590907, -2.82, 0.46, 15.25> texture { Material1029 } }
sphere { <-8.23, 1.22, -13.16>, 0.203 texture { Material1030 } }
sphere { <0, 0, 0>, 1 matrix <0.2510059811537787, 0.022352030623763862, -0.0006197999864674172, -0.047808509945272706, 0.5360473016034993, -0.029810012083522987, -0.0005583118925718401, 0.012554494884897436, 0.22665187611404344, -8.23, 0.53, -13.16> texture { Material1030 } }
sphere { <14.96, 0.96, 4.14>, 0.161 texture { Material1031 } }
sphere { <0, 0, 0>, 1 matrix <0.1999442118634265, 0.004719406370391254, -0.00019835781892801505, -0.010028738537081413, 0.42338274668899184, -0.03565773702073391, -0.00017852203703521352, 0.015102100385252008, 0.17936525497943034, 14.96, 0.42, 4.14> texture { Material1031 } }
sphere { <-13.84, 1.21, 7.05>, 0.201 texture { Material1032 } }
sphere { <0, 0, 0>, 1 matrix <0.30596204765356755, -0.004818688767310465, 7.506130738865581e-05, 0.008393336970511367, 0.532675310801178, -0.016600155341678035, 5.5192137785776335e-05, 0.007007570266186787, 0.22489084221637926, -13.84, 0.52, 7.05> texture { Material1032 } }
sphere { <5.44, 1.16, -14.55>, 0.194 texture { Material1033 } }
sphere { <0, 0, 0>, 1 matrix <0.274, 0, 0, 0, 0.513, 0, 0, 0, 0.216, 5.44, 0.5, -14.55> texture { Material1033 } }
sphere { <5.82, 1.06, 14.41>, 0.177 texture { Material1034 } }
sphere { <0, 0, 0>, 1 matrix <0.25469828765757024, 0.01240031675554759, -0.0001200360932247372, -0.022855485784734772, 0.46935588133464967, -0.009093042731561144, -9.320449591567831e-05, 0.003830686086912993, 0.1979629186414099, 5.82, 0.46, 14.41> texture { Material1034 } }
sphere { <-14.03, 1.01, -6.7>, 0.169 texture { Material1035 } }
sphere { <0, 0, 0>, 1 matrix <0.244, 0, 0, 0, 0.447, 0, 0, 0, 0.189, -14.03, 0.44, -6.7> texture { Material1035 } }
sphere { <14.88, 0.88, -4.54>, 0.147 texture { Material1036 } }
sphere { <0, 0, 0>, 1 matrix <0.18799042307629862, 0.0018973208793259598, 3.1702919839060446e-05, -0.003915747346694002, 0.38776364088340914, 0.012962473975262906, 2.7655738583010176e-05, -0.005478983845214218, 0.16390844996882867, 14.88, 0.38, -4.54> texture { Material1036 } }
sphere { <-7.91, 1.16, 13.41>, 0.193 texture { Material1037 } }
sphere { <0, 0, 0>, 1 matrix <0.25597115431273654, 0.0038428982792133117, 1.7106163377151172e-05, -0.0076857965584266235, 0.5119220199200724, 0.004557856098601834, 1.4433325349471297e-05, -0.001922845541597649, 0.21599144070240903, -7.91, 0.5, 13.41> texture { Material1037 } }
sphere { <-3.23, 0.84, -15.23>, 0.14 texture { Material1038 } }
sphere { <0, 0, 0>, 1 matrix <0.165, 0, 0, 0, 0.37, 0, 0, 0, 0.156, -3.23, 0.36, -15.23> texture { Material1038 } }
sphere { <12.68, 1.13, 9.06>, 0.189 texture { Material1039 } }
sphere { <0, 0, 0>, 1 matrix <0.24688526644472072, 0.007525924423982721, -0.00016023134444171247, -0.015234664825875955, 0.4993147673772869, -0.02127599742924056, -0.00013687778816680703, 0.008978470915139517, 0.21080884308893946, 12.68, 0.49, 9.06> texture { Material1039 } }
sphere { <-15.47, 1.22, 1.88>, 0.203 texture { Material1040 } }
sphere { <0, 0, 0>, 1 matrix <0.26899051192065004, -0.0022579569154376504, 7.827665463725104e-05, 0.004515913830875301, 0.5366894590397855, -0.03725628910472124, 6.605502082771742e-05, 0.015719661016304315, 0.22645504607817135, -15.47, 0.53, 1.88> texture { Material1040 } }
sphere { <10.14, 0.86, -11.85>, 0.143 texture { Material1041 } }
sphere { <0, 0, 0>, 1 matrix <0.17344949238782156, 0.013822152892146717, 0.00047082887883681757, -0.03010687325358394, 0.37692379834457557, 0.025749299493196796, 0.0004329460954821312, -0.010870416672589676, 0.15962971715517976, 10.14, 0.37, -11.85> texture { Material1041 } }
sphere { <0.53, 0.94, 15.59>, 0.156 texture { Material1042 } }
sphere { <0, 0, 0>, 1 matrix <0.22796530572050874, -0.0039773592585607975, -1.0408283847374526e-06, 0.007204602516603549, 0.41293709809958956, 0.00021613807549810646, -7.943163988785821e-07, -9.106059355126035e-05, 0.17399997617050803, 0.53, 0.4, 15.59> texture { Material1042 } }
sphere { <-10.92, 1.09, -11.15>, 0.182 texture { Material1043 } }
sphere { <0, 0, 0>, 1 matrix <0.26897922444575256, -0.0033431118752760983, -2.0482940807345337e-05, 0.005990259940085797, 0.48192658906538055, 0.005905890081774729, -1.553353131858159e-05, -0.002499588333365238, 0.20398468525081268, -10.92, 0.47, -11.15> texture { Material1043 } }
sphere { <15.59, 1.15, 0.84>, 0.192 texture { Material1044 } }
sphere { <0, 0, 0>, 1 matrix <0.257999902008355, 0.0002248551495528592, -1.959832900301868e-06, -0.00044273804640640495, 0.5079226291394467, -0.008854760928128098, -1.6255978320333321e-06, 0.003730155194132703, 0.21396748804335933, 15.59, 0.5, 0.84> texture { Material1044 } }
sphere { <-12.07, 1.19, 9.92>, 0.199 texture { Material1045 } }
sphere { <0, 0, 0>, 1 matrix <0.24993893191651825, -0.005524920043245586, 7.463876869990046e-05, 0.011646531451161696, 0.5266789658390635, -0.014234649551419848, 6.627922660551161e-05, 0.005996379886935875, 0.22191899205637106, -12.07, 0.51, 9.92> texture { Material1045 } }
sphere { <2.2, 0.99, -15.47>, 0.165 texture { Material1046 } }
sphere { <0, 0, 0>, 1 matrix <0.22786383164949767, 0.007878696288780466, 1.9256130374070863e-05, -0.015135390238973001, 0.43773318223436397, 0.0021403582156123437, 1.562449175089083e-05, -0.0009040325796536155, 0.184997790475914, 2.2, 0.43, -15.47> texture { Material1046 } }
sphere { <8.83, 1.09, 12.9>, 0.181 texture { Material1047 } }
sphere { <0, 0, 0>, 1 matrix <0.269293967510383, -0.01950723312934408, -0.0004763592701030435, 0.03467952556327836, 0.47817345508403786, 0.023398234114982992, -0.00035815159937376977, -0.009895503177794892, 0.2027583555474105, 8.83, 0.47, 12.9> texture { Material1047 } }
sphere { <-15.23, 1.15, -3.55>, 0.191 texture { Material1048 } }
sphere { <0, 0, 0>, 1 matrix <0.22697056589327336, 0.0036533284211593842, -0.0001241351457602549, -0.00814354264804691, 0.504767409431471, -0.0343445059504587, -0.00011702608454931518, 0.014525146785371862, 0.21350645520863984, -15.23, 0.5, -3.55> texture { Material1048 } }
sphere { <13.63, 1.04, -7.68>, 0.174 texture { Material1049 } }
sphere { <0, 0, 0>, 1 matrix <0.25666095257675636, -0.01318305882075612, 0.00060198215963672, 0.02359613641069189, 0.45748007186940576, -0.0418951809740856, 0.00045441454851954737, 0.01766883719341871, 0.1931931823322204, 13.63, 0.45, -7.68> texture { Material1049 } }
sphere { <-4.87, 1, 14.88>, 0.167 texture { Material1050 } }
sphere { <0, 0, 0>, 1 matrix <0.22296930453428543, 0.0036998831290352887, 1.0016415127917041e-05, -0.007349992045572345, 0.4429325289542813, 0.0023984184569762392, 8.399415376325053e-06, -0.0010124249468500151, 0.18699725913814036, -4.87, 0.43, 14.88> texture { Material1050 } }
sphere { <-6.46, 0.86, -14.27>, 0.144 texture { Material1051 } }
sphere { <0, 0, 0>, 1 matrix <0.1816314673596358, 0.011575080767772857, -0.00016604217862562312, -0.02416775105359168, 0.3790743390987332, -0.010888766958211636, -0.00014597114604450383, 0.0045847439824049, 0.1599342327803536, -6.46, 0.37, -14.27> texture { Material1051 } }
sphere { <14.41, 1.03, 6.16>, 0.172 texture { Material1052 } }
sphere { <0, 0, 0>, 1 matrix <0.21599498872067102, -0.0014712946033415188, -1.182147944271557e-05, 0.003099254835742551, 0.45493070129615804, 0.007311062689443968, -1.0507981726858282e-05, -0.003085107772248883, 0.19197521194054176, 14.41, 0.44, 6.16> texture { Material1052 } }
sphere { <-14.79, 1, 5.19>, 0.166 texture { Material1053 } }
sphere { <0, 0, 0>, 1 matrix <0.20798609723020145, -0.0024045354321194693, 3.9601829123134396e-05, 0.005074956993752149, 0.438732573061383, -0.01445593810341521, 3.5413174119725956e-05, 0.006124839378667948, 0.1858991261100832, -14.79, 0.43, 5.19> texture { Material1053 } }
sphere { <7.4, 0.84, -13.82>, 0.14 texture { Material1054 } }
sphere { <0, 0, 0>, 1 matrix <0.17766263527858434, 0.01095242255393736, 0.00018018343075608832, -0.022704741137094864, 0.3681011345458751, 0.012126395834584755, 0.00015791356852780776, -0.005126606369092742, 0.1559156597986272, 7.4, 0.36, -13.82> texture { Material1054 } }
sphere { <3.88, 0.88, 15.2>, 0.146 texture { Material1055 } }
sphere { <0, 0, 0>, 1 matrix <0.19397229329907698, 0.0032786249105961254, -7.140902299753559e-06, -0.006540349692787116, 0.3869410580255234, -0.0016856571373162672, -6.036639057523629e-06, 0.0007143353243407437, 0.16399844416519135, 3.88, 0.38, 15.2> texture { Material1055 } }
sphere { <-13.14, 1.08, -8.59>, 0.18 texture { Material1056 } }
sphere { <0, 0, 0>, 1 matrix <0.25980995194220335, 0.00993502006539723, -0.00029025521554401087, -0.018226940658440303, 0.47583805197393614, -0.027837509369254276, -0.00022438960893979304, 0.01173027124364803, 0.20065729586998288, -13.14, 0.47, -8.59> texture { Material1056 } }
sphere { <15.49, 0.96, -2.54>, 0.161 texture { Material1057 } }
sphere { <0, 0, 0>, 1 matrix <0.1959992401264957, -0.0005457542763357563, 4.701717307958724e-06, 0.0011833957522586552, 0.4249352704414663, -0.007322261217100429, 4.293915296554141e-06, 0.0030839641361434748, 0.17897343139910257, 15.49, 0.42, -2.54> texture { Material1057 } }
sphere { <-9.71, 1.2, 12.34>, 0.199 texture { Material1058 } }
sphere { <0, 0, 0>, 1 matrix <0.25739244289379976, 0.0176890640436315, 0.000476816969422967, -0.03613231298834806, 0.5249946058943499, 0.028357005130095942, 0.00041213249682682805, -0.011999264030382154, 0.22267655424299668, -9.71, 0.52, 12.34> texture { Material1058 } }
sphere { <-1.18, 0.98, -15.67>, 0.163 texture { Material1059 } }
sphere { <0, 0, 0>, 1 matrix <0.23967269214956483, -0.012529968588979298, -2.291154953046034e-05, 0.02250173525770866, 0.43040932947922134, 0.0015751214680396063, -1.737459172726576e-05, -0.0006651324992649845, 0.1819987837785791, -1.18, 0.42, -15.67> texture { Material1059 } }
sphere { <11.46, 1.1, 10.76>, 0.183 texture { Material1060 } }
sphere { <0, 0, 0>, 1 matrix <0.27768538679951743, -0.013217862356973434, -0.0003377465240474918, 0.023059939723496813, 0.4838185643760147, 0.02475552352669511, -0.00024905768859617196, -0.010463674892726798, 0.20473262924606586, 11.46, 0.47, 10.76> texture { Material1060 } }
sphere { <-15.73, 0.95, -0.2>, 0.158 texture { Material1061 } }
sphere { <0, 0, 0>, 1 matrix <0.18899997410079677, 9.89100119221991e-05, -2.5899203218232736e-06, -0.000219276693097362, 0.41842577506216644, -0.0219276693097362, -2.4254809363106847e-06, 0.009263001116523405, 0.17675745190636893, -15.73, 0.41, -0.2> texture { Material1061 } }
sphere { <11.73, 1.07, -10.48>, 0.178 texture { Material1062 } }
sphere { <0, 0, 0>, 1 matrix <0.2177643044010643, 0.010131047233231385, 0.00026383835701755806, -0.021935111440757857, 0.470850231722637, 0.024554229224728944, 0.00024084327085547734, -0.010352312745171737, 0.19873039932366926, 11.73, 0.46, -10.48> texture { Material1062 } }
sphere { <-1.57, 0.85, 15.66>, 0.141 texture { Material1063 } }
sphere { <0, 0, 0>, 1 matrix <0.20296939438705602, -0.003524901785084969, 3.0914760549486474e-06, 0.0064767899794911, 0.37294319029333395, -0.000654221210049606, 2.406173481191558e-06, 0.0002771231935330771, 0.15799975695217364, -1.57, 0.37, 15.66> texture { Material1063 } }
sphere { <-9.42, 0.87, -12.62>, 0.145 texture { Material1064 } }
sphere { <0, 0, 0>, 1 matrix <0.18471158355076317, 0.010323958114130545, -0.00021631233692761122, -0.021429188734195293, 0.3830645952997725, -0.01607189155064647, -0.0001894194517960704, 0.006780329247928979, 0.16185793541115295, -9.42, 0.38, -12.62> texture { Material1064 } }
sphere { <15.48, 0.97, 2.94>, 0.162 texture { Material1065 } }
sphere { <0, 0, 0>, 1 matrix <0.233, 0, 0, 0, 0.429, 0, 0, 0, 0.181, 15.48, 0.42, 2.94> texture { Material1065 } }
sphere { <-13.4, 0.84, 8.29>, 0.14 texture { Material1066 } }
sphere { <0, 0, 0>, 1 matrix <0.1738813424944482, 0.006422033815293816, 0.00019029977305477436, -0.013656048917578805, 0.3690986985961349, 0.02190121052819242, 0.00017061358963531495, -0.009234023898373021, 0.15572637443171694, -13.4, 0.36, 8.29> texture { Material1066 } }
sphere { <4.28, 1.1, -15.17>, 0.184 texture { Material1067 } }
sphere { <0, 0, 0>, 1 matrix <0.2319672554234512, -0.0038977335078333518, 9.209412154353787e-06, 0.008181880251357078, 0.48692582754116254, -0.0023011538206941786, 8.177322861193447e-06, 0.000973383340991788, 0.20599770012794527, 4.28, 0.48, -15.17> texture { Material1067 } }
sphere { <7.09, 1.19, 14.09>, 0.198 texture { Material1068 } }
sphere { <0, 0, 0>, 1 matrix <0.23688502046791945, -0.0073813073470500815, -5.81357184676844e-05, 0.016319852531030563, 0.5236807933580062, 0.008251610830296352, -5.4210944225140314e-05, -0.003480164109724225, 0.220972589972021, 7.09, 0.51, 14.09> texture { Material1068 } }
sphere { <-14.75, 0.97, -5.6>, 0.161 texture { Material1069 } }
sphere { <0, 0, 0>, 1 matrix <0.20290416412274306, 0.006231800319623787, -0.0002546496167113383, -0.013108269637829342, 0.42537513608517535, -0.03483054503766083, -0.00022579768969478272, 0.014682665355454214, 0.17940002328166813, -14.75, 0.42, -5.6> texture { Material1069 } }
sphere { <14.67, 0.87, -5.84>, 0.145 texture { Material1070 } }
sphere { <0, 0, 0>, 1 matrix <0.20689235796858985, -0.006669258702832152, 0.0002705597005714555, 0.012339739532293306, 0.38154256936913855, -0.03101610206765615, 0.00021174237436026954, 0.013119082336710955, 0.16146778268066203, 14.67, 0.37, -5.84> texture { Material1070 } }
sphere { <-6.87, 1.2, 14.22>, 0.2 texture { Material1071 } }
sphere { <0, 0, 0>, 1 matrix <0.23573896160191743, -0.011096201886169315, 0.00012761877239592253, 0.024919436439278547, 0.5292736534199242, -0.012182835592536181, 0.00012112968227409596, 0.005148972024015291, 0.22394078104422155, -6.87, 0.52, 14.22> texture { Material1071 } }
sphere { <-4.54, 0.94, -15.14>, 0.156 texture { Material1072 } }
sphere { <0, 0, 0>, 1 matrix <0.2189694344759794, 0.0036587812199244066, -9.233335381213931e-06, -0.006899893350816346, 0.41293709809958956, -0.0020843427830591044, -7.336074686443945e-06, 0.0008781492596907607, 0.17399778389410514, -4.54, 0.4, -15.14> texture { Material1072 } }
sphere { <13.58, 1.22, 8.1>, 0.204 texture { Material1073 } }
sphere { <0, 0, 0>, 1 matrix <0.28098886498785625, -0.00250147961661546, -1.877668714445109e-05, 0.004807113853994123, 0.5399177553844513, 0.00810611355771558, -1.5235176757775264e-05, -0.003422581279924356, 0.227974309309781, 13.58, 0.53, 8.1> texture { Material1073 } }
sphere { <-15.49, 0.99, 3.2>, 0.165 texture { Material1074 } }
sphere { <0, 0, 0>, 1 matrix <0.20895422135673605, -0.004368416168705029, 0.00022431535199325572, 0.009113059567250684, 0.43361154638056715, -0.044653991879528336, 0.00019748337208975623, 0.0188448039124615, 0.18303233147676018, -15.49, 0.43, 3.2> texture { Material1074 } }
sphere { <9.26, 1.17, -12.83>, 0.195 texture { Material1075 } }
sphere { <0, 0, 0>, 1 matrix <0.27275555537385576, 0.011548822887755493, 0.00017805225854953405, -0.021870847739815347, 0.5162914694681147, 0.01593061748949513, 0.000142180924409518, -0.006717359018781311, 0.21789643611678813, 9.26, 0.51, -12.83> texture { Material1075 } }
sphere { <1.84, 1.02, 15.72>, 0.17 texture { Material1076 } }
sphere { <0, 0, 0>, 1 matrix <0.20372447323342724, -0.010598957042591292, -3.339718382700074e-05, 0.023380052299833736, 0.44938329063955823, 0.00283394573331318, -3.11052202310301e-05, -0.001196554865176676, 0.18999622967027502, 1.84, 0.44, 15.72> texture { Material1076 } }
sphere { <-11.98, 1.14, -10.36>, 0.19 texture { Material1077 } }
sphere { <0, 0, 0>, 1 matrix <0.28170979778842786, -0.012785722367161167, -0.0003393133550689039, 0.022851078273224214, 0.5027722813309514, 0.026718183827154466, -0.0002562898745733211, -0.01129161340314266, 0.21270033799280658, -11.98, 0.49, -10.36> texture { Material1077 } }
sphere { <15.84, 1.21, -0.46>, 0.202 texture { Material1078 } }
sphere { <0, 0, 0>, 1 matrix <0.3079999578190602, -0.00016118771732062177, 1.4060313267505937e-06, 0.0002805084950774457, 0.5359183646038258, -0.009350283169248191, 1.031698311187124e-06, 0.003942470142257632, 0.22596561005629376, 15.84, 0.52, -0.46> texture { Material1078 } }
sphere { <-11.37, 1.21, 11.04>, 0.202 texture { Material1079 } }
sphere { <0, 0, 0>, 1 matrix <0.2507028981966043, 0.012205058390453516, 0.0003055904263498609, -0.026014765892002516, 0.533696766889006, 0.0267580449174883, 0.0002751531328887194, -0.01130339841374272, 0.22571698534902876, -11.37, 0.52, 11.04> texture { Material1079 } }
sphere { <0.93, 0.95, -15.83>, 0.158 texture { Material1080 } }
sphere { <0, 0, 0>, 1 matrix <0.19226821117148954, -0.01679086195113009, 4.3907329710628325e-05, 0.036452700298049256, 0.41740557850044135, -0.0021871620178829554, 4.026734382788193e-05, 0.0009239324037357592, 0.17699758395937032, 0.93, 0.41, -15.83> texture { Material1080 } }
sphere { <10.01, 0.85, 12.3>, 0.142 texture { Material1081 } }
sphere { <0, 0, 0>, 1 matrix <0.1888432442957774, 0.007695001862111224, -0.00012661037648747342, -0.015308575133088996, 0.37548470506771975, -0.012364618376725726, -0.00010651349133073162, 0.005228655111434549, 0.15891396987238673, 10.01, 0.37, 12.3> texture { Material1081 } }
sphere { <-15.7, 0.83, -2.31>, 0.139 texture { Material1082 } }
sphere { <0, 0, 0>, 1 matrix <0.18599745722229696, 0.0009724326162377441, -1.6782332840171507e-05, -0.001918724570748667, 0.36677643351600814, -0.012663582166941204, -1.3985277366809588e-05, 0.005348379389307593, 0.15490769716937905, -15.7, 0.36, -2.31> texture { Material1082 } }
sphere { <13.14, 0.94, -8.9>, 0.156 texture { Material1083 } }
sphere { <0, 0, 0>, 1 matrix <0.189, 0, 0, 0, 0.414, 0, 0, 0, 0.175, 13.14, 0.4, -8.9> texture { Material1083 } }
sphere { <-3.68, 1.08, 15.45>, 0.18 texture { Material1084 } }
sphere { <0, 0, 0>, 1 matrix <0.21896842071403705, -0.0037189614050487235, 7.487871929356613e-06, 0.008100203608256808, 0.4769273505895986, -0.0019206668349474906, 6.872430400916342e-06, 0.0008093375971162383, 0.20099837045464722, -3.68, 0.47, 15.45> texture { Material1084 } }
sphere { <-7.73, 1.01, -13.88>, 0.168 texture { Material1085 } }
sphere { <0, 0, 0>, 1 matrix <0.2349728277923872, 0.0035735087855199043, -1.5303887046283268e-05, -0.006766857061941947, 0.4449322243445941, -0.003811218345231671, -1.2243109637026614e-05, 0.0016101326941652901, 0.18799310445549178, -7.73, 0.43, -13.88> texture { Material1085 } }
sphere { <15.08, 0.86, 5.02>, 0.143 texture { Material1086 } }
sphere { <0, 0, 0>, 1 matrix <0.20994787276026197, -0.0046761923644552455, -0.0001547527429722591, 0.008417146256019442, 0.37707921099821357, 0.024988402947557716, -0.0001179068517883879, -0.010577101776744006, 0.15964996403375323, 15.08, 0.37, 5.02> texture { Material1086 } }
sphere { <-14.52, 1.03, 6.49>, 0.172 texture { Material1087 } }
sphere { <0, 0, 0>, 1 matrix <0.23697563815618616, 0.0033976457659679396, 5.407140944043663e-05, -0.006522906428335074, 0.4547228262936886, 0.01447767036532907, 4.3804686128961314e-05, -0.006109258703611388, 0.19190277496493327, -14.52, 0.44, 6.49> texture { Material1087 } }
sphere { <6.32, 0.83, -14.6>, 0.138 texture { Material1088 } }
sphere { <0, 0, 0>, 1 matrix <0.17064967634730277, -0.010939139034394446, 0.00015231463160749495, 0.023349624254701593, 0.3641108783448358, -0.01015201054552243, 0.00013717224133072642, 0.0042833140383848065, 0.1539403598950736, 6.32, 0.36, -14.6> texture { Material1088 } }
sphere { <5.2, 0.89, 15.04>, 0.148 texture { Material1089 } }
sphere { <0, 0, 0>, 1 matrix <0.18360004566555904, -0.01212451770757802, -0.00013893150564791472, 0.02589638836455523, 0.39204267175211094, 0.008995587537161292, -0.00012534038009540132, -0.0037996629291826324, 0.1659564607100721, 5.2, 0.38, 15.04> texture { Material1089 } }
sphere { <-14, 0.97, -7.58>, 0.162 texture { Material1090 } }
sphere { <0, 0, 0>, 1 matrix <0.22799203746397237, 0.001905423817823216, -1.4597982717351435e-05, -0.0035768482194225284, 0.42793481352693546, -0.006557555068941303, -1.1588749437897413e-05, 0.0027731716529868595, 0.18097875395936383, -14, 0.42, -7.58> texture { Material1090 } }
sphere { <15.45, 0.97, -3.87>, 0.162 texture { Material1091 } }
sphere { <0, 0, 0>, 1 matrix <0.24196599380008185, 0.004054498009749724, 0.000137441724669132, -0.007204273323109013, 0.4289525416117244, 0.029117271347565594, 0.00010279732299633425, -0.012256339799789238, 0.18058452748622314, 15.45, 0.42, -3.87> texture { Material1091 } }
sphere { <-8.79, 1.22, 13.29>, 0.203 texture { Material1092 } }
sphere { <0, 0, 0>, 1 matrix <0.29172192743170094, 0.012739038502170025, 0.00018426495489693082, -0.02347124217180642, 0.5372626896979608, 0.01555323276445004, 0.00014324707110138115, -0.00656242348983301, 0.22690507724204126, -8.79, 0.53, 13.29> texture { Material1092 } }
sphere { <-2.5, 1.13, -15.74>, 0.188 texture { Material1093 } }
sphere { <0, 0, 0>, 1 matrix <0.24409143261602004, 0.02107963381361672, -0.0001468391731684786, -0.042847582200739295, 0.49610495964968926, -0.006924861769816452, -0.00012586214843012447, 0.00292012243305513, 0.20997965864267795, -2.5, 0.49, -15.74> texture { Material1093 } }
sphere { <12.49, 0.98, 9.92>, 0.163 texture { Material1094 } }
sphere { <0, 0, 0>, 1 matrix <0.249, 0, 0, 0, 0.431, 0, 0, 0, 0.182, 12.49, 0.42, 9.92> texture { Material1094 } }
sphere { <-15.92, 0.89, 1.12>, 0.148 texture { Material1095 } }
sphere { <0, 0, 0>, 1 matrix <0.18399658586904122, 0.0011198257461796997, 4.8773299411202485e-05, -0.0023796297106318622, 0.3895121269538725, 0.033994710151883746, 4.373692610243701e-05, -0.014345593798109508, 0.16437518676996518, -15.92, 0.38, 1.12> texture { Material1095 } }
sphere { <10.98, 1.21, -11.58>, 0.201 texture { Material1096 } }
sphere { <0, 0, 0>, 1 matrix <0.2734493264261516, 0.017354969235574284, 0.0005204996793909305, -0.03369650961067708, 0.5299755793848087, 0.0318501255224208, 0.0004274176199378078, -0.013470447824332104, 0.22459600252362044, 10.98, 0.52, -11.58> texture { Material1096 } }
sphere { <-0.28, 1.2, 15.97>, 0.199 texture { Material1097 } }
sphere { <0, 0, 0>, 1 matrix <0.30325976737203775, 0.021201728096544564, 1.4804652559245182e-05, -0.036754311535786136, 0.5257162544869274, 0.0007350862307157227, 1.0859991844446302e-05, -0.0003110516687848314, 0.2229997828001631, -0.28, 0.52, 15.97> texture { Material1097 } }
sphere { <-10.58, 0.96, -11.97>, 0.161 texture { Material1098 } }
sphere { <0, 0, 0>, 1 matrix <0.23198008638203493, 0.0030396077203492383, -1.752398380926421e-05, -0.0055682469015018365, 0.4249352704414663, -0.004900057273321617, -1.3596194334773954e-05, 0.002075318374583273, 0.1799880353489854, -10.58, 0.42, -11.97> texture { Material1098 } }
sphere { <15.89, 1.22, 1.67>, 0.204 texture { Material1099 } }
sphere { <0, 0, 0>, 1 matrix <0.29799266828580373, -0.002089109732436799, -7.258397054304264e-05, 0.0037856350856237306, 0.5386845871403051, 0.03747778734767493, -5.5534044576556124e-05, -0.01582395465790719, 0.2274502129586921, 15.89, 0.53, 1.67> texture { Material1099 } }
sphere { <-12.86, 1.08, 9.51>, 0.18 texture { Material1100 } }
sphere { <0, 0, 0>, 1 matrix <0.22495171343912876, -0.004660722481194178, 6.547330287625754e-05, 0.009880731660131656, 0.47670942448810866, -0.013397602251025976, 5.848948390279006e-05, 0.005645530508293965, 0.20092069222521658, -12.86, 0.47, 9.51> texture { Material1100 } }
sphere { <3.06, 0.83, -15.7>, 0.139 texture { Material1101 } }
sphere { <0, 0, 0>, 1 matrix <0.16660793358375553, -0.01143637569308985, 7.601287661882856e-05, 0.0252011152997429, 0.3671035704956153, -0.004885930517297093, 7.055087350849356e-05, 0.0020579326907093735, 0.15498632176942181, 3.06, 0.36, -15.7> texture { Material1101 } }
sphere { <8.35, 1.12, 13.65>, 0.186 texture { Material1102 } }
sphere { <0, 0, 0>, 1 matrix <0.268, 0, 0, 0, 0.493, 0, 0, 0, 0.208, 8.35, 0.48, 13.65> texture { Material1102 } }
sphere { <-15.38, 1.04, -4.42>, 0.174 texture { Material1103 } }
sphere { <0, 0, 0>, 1 matrix <0.2509970028843655, -0.0012265551244122852, -1.0275825032468712e-05, 0.0022429832753196773, 0.4589300920767836, 0.007690228372524607, -7.94227114063319e-06, -0.0032503361748796814, 0.1939727693560893, -15.38, 0.45, -4.42> texture { Material1103 } }
sphere { <14.34, 1.19, -7.13>, 0.199 texture { Material1104 } }
sphere { <0, 0, 0>, 1 matrix <0.2697945136969543, 0.01052385293231539, 0.000410972606091481, -0.020502024601473684, 0.5239984111962582, 0.04100404920294737, 0.0003379108094529955, -0.017305891488696417, 0.22132417838109403, 14.34, 0.51, -7.13> texture { Material1104 } }
sphere { <-5.76, 1.08, 14.95>, 0.181 texture { Material1105 } }
sphere { <0, 0, 0>, 1 matrix <0.25776606808621527, 0.025247296743102412, 0.0004776510634005475, -0.04659539707800367, 0.4753814659860346, 0.01803692790116271, 0.000372530945200427, -0.007622300075386754, 0.20185579447282564, -5.76, 0.47, 14.95> texture { Material1105 } }
sphere { <-5.86, 1.13, -14.92>, 0.189 texture { Material1106 } }
sphere { <0, 0, 0>, 1 matrix <0.24618853285261433, -0.020002551463997566, -0.00032284176831473197, 0.04057197685612462, 0.49909354374396453, 0.016141539179318397, -0.00027578790734578314, -0.006798133267138087, 0.21089027792933554, -5.86, 0.49, -14.92> texture { Material1106 } }
sphere { <14.4, 1.18, 7.05>, 0.196 texture { Material1107 } }
sphere { <0, 0, 0>, 1 matrix <0.2339725019947687, -0.0035868017375450937, -5.624591979126176e-05, 0.007970670527877987, 0.5196832300499298, 0.016303644261568606, -5.2880779290929864e-05, -0.0068976956491251795, 0.2198918347696322, 14.4, 0.51, 7.05> texture { Material1107 } }
sphere { <-15.39, 0.9, 4.53>, 0.151 texture { Material1108 } }
sphere { <0, 0, 0>, 1 matrix <0.1819978267926475, 0.0008893746320439678, 7.450996637088866e-06, -0.001949782847173314, 0.39893923036740014, 0.006684969761737077, 6.9187825915825204e-06, -0.002831478420384877, 0.16897627845968602, -15.39, 0.39, 4.53> texture { Material1108 } }
sphere { <8.29, 1.15, -13.74>, 0.192 texture { Material1109 } }
sphere { <0, 0, 0>, 1 matrix <0.26797011012920274, -0.0040024680775267866, 1.807294513323654e-05, 0.007586767848446296, 0.5079226291394467, -0.004587348001386133, 1.443138156161425e-05, 0.001932465496646914, 0.2139912740483581, 8.29, 0.5, -13.74> texture { Material1109 } }
sphere { <3.17, 0.89, 15.74>, 0.148 texture { Material1110 } }
sphere { <0, 0, 0>, 1 matrix <0.20273291928348006, 0.010409633416439001, -5.450626867754532e-05, -0.020050082097673148, 0.3904641480890384, -0.004091853489321051, -4.430312478716738e-05, 0.0017267412422966074, 0.1649909585459618, 3.17, 0.38, 15.74> texture { Material1110 } }
sphere { <-12.98, 1.22, -9.46>, 0.203 texture { Material1111 } }
sphere { <0, 0, 0>, 1 matrix <0.27998521723909897, 0.002877101960045411, -2.0294976830284242e-05, -0.005517870544801377, 0.5369182122989822, -0.0075753815954052815, -1.6453427644551867e-05, 0.0032022562796219715, 0.22697741139594563, -12.98, 0.53, -9.46> texture { Material1111 } }
sphere { <15.97, 0.83, -1.79>, 0.139 texture { Material1112 } }
sphere { <0, 0, 0>, 1 matrix <0.17298844253535012, 0.0019969801250246536, 0.00010401718184876205, -0.004247911479821229, 0.36598405749552454, 0.03823120331839106, 9.379584027980858e-05, -0.016206705754535342, 0.1551558374374817, 15.97, 0.36, -1.79> texture { Material1112 } }
sphere { <-10.57, 0.98, 12.11>, 0.163 texture { Material1113 } }
sphere { <0, 0, 0>, 1 matrix <0.20471856982825967, -0.01073526118517934, 0.0002476585511314894, 0.02262259918047549, 0.4309476697122441, -0.019907887278818433, 0.00021987246978502967, 0.008387119177650358, 0.18180651222658917, -10.57, 0.42, 12.11> texture { Material1113 } }
sphere { <-0.38, 1.04, -16.08>, 0.174 texture { Material1114 } }
sphere { <0, 0, 0>, 1 matrix <0.24296300472111462, -0.004240086831678339, -7.399055777073471e-07, 0.008026501821284098, 0.45992993977194, 0.00016053003642568195, -5.907065105976351e-07, -6.770179797083109e-05, 0.1939999881858698, -0.38, 0.45, -16.08> texture { Material1114 } }
sphere { <11.15, 0.95, 11.6>, 0.159 texture { Material1115 } }
sphere { <0, 0, 0>, 1 matrix <0.2319815811756913, -0.0029233001308750137, -1.765137329584475e-05, 0.005292181271411662, 0.4199360319656843, 0.0050716737184361765, -1.3466780488640176e-05, -0.002137348209912389, 0.17698709433536505, 11.15, 0.41, 11.6> texture { Material1115 } }
sphere { <-16.06, 0.98, -1.02>, 0.164 texture { Material1116 } }
sphere { <0, 0, 0>, 1 matrix <0.22299951271017432, 0.0004661170090166409, -8.121497094956857e-06, -0.0009071514884000993, 0.43373561892628754, -0.015119191473334988, -6.6647263155923985e-06, 0.006375142948433878, 0.18288892122807346, -16.06, 0.42, -1.02> texture { Material1116 } }
sphere { <12.54, 1.02, -10.1>, 0.17 texture { Material1117 } }
sphere { <0, 0, 0>, 1 matrix <0.22494588613336594, -0.004933945979294272, 6.699812059452605e-05, 0.009889820607385408, 0.4507252629856122, -0.01224453979962003, 5.6576190724266446e-05, 0.005158453574119303, 0.18992995328767473, 12.54, 0.44, -10.1> texture { Material1117 } }
sphere { <-2.43, 1.2, 15.92>, 0.2 texture { Material1118 } }
sphere { <0, 0, 0>, 1 matrix <0.27395920499724863, -0.004727997363577366, 6.181061022936e-06, 0.00912814089537382, 0.528919430737731, -0.0013830516508142152, 5.030571562462509e-06, 0.0005830255541239509, 0.2229992377921875, -2.43, 0.52, 15.92> texture { Material1118 } }
sphere { <-8.97, 1.21, -13.38>, 0.202 texture { Material1119 } }
sphere { <0, 0, 0>, 1 matrix <0.30349112195919586, 0.01757899342977888, -0.0003433394010244875, -0.03099454104724171, 0.5346943309392658, -0.020911979501753445, -0.0002552457389195204, 0.008817364491410967, 0.225827786007476, -8.97, 0.52, -13.38> texture { Material1119 } }
sphere { <15.66, 0.95, 3.81>, 0.159 texture { Material1120 } }
sphere { <0, 0, 0>, 1 matrix <0.211, 0, 0, 0, 0.421, 0, 0, 0, 0.178, 15.66, 0.41, 3.81> texture { Material1120 } }
sphere { <-14.13, 1.01, 7.77>, 0.169 texture { Material1121 } }
sphere { <0, 0, 0>, 1 matrix <0.23992458076611156, -0.006014684197953337, 0.00013826859546210496, 0.011177288134529952, 0.44538877250053993, -0.020491694913304912, 0.00010831039977864888, 0.008637754806505209, 0.18780143093373913, -14.13, 0.44, 7.77> texture { Material1121 } }
sphere { <5.17, 1.14, -15.28>, 0.19 texture { Material1122 } }
sphere { <0, 0, 0>, 1 matrix <0.2843764984351229, 0.01884046253982526, 0.00021002157974806592, -0.03325176371063897, 0.5017747172806916, 0.011200594092004709, 0.00015622657861961395, -0.00472072752983101, 0.2119473763103597, 5.17, 0.49, -15.28> texture { Material1122 } }
sphere { <6.51, 1.19, 14.77>, 0.198 texture { Material1123 } }
sphere { <0, 0, 0>, 1 matrix <0.2668636880975155, -0.00853043872885687, -5.9917319773424844e-05, 0.016773334579212946, 0.5246801841850253, 0.007372894320533163, -4.959448565515688e-05, -0.003103637418738722, 0.22097820022608566, 6.51, 0.51, 14.77> texture { Material1123 } }
sphere { <-14.78, 0.87, -6.49>, 0.145 texture { Material1124 } }
sphere { <0, 0, 0>, 1 matrix <0.21595293791844006, -0.004507425861099653, -0.00010824278758787275, 0.008013201530843828, 0.38347374134575635, 0.018430363520940806, -8.118209069090457e-05, -0.0077753096103969025, 0.16181328119141092, -14.78, 0.38, -6.49> texture { Material1124 } }
sphere { <15.29, 1, -5.2>, 0.166 texture { Material1125 } }
sphere { <0, 0, 0>, 1 matrix <0.219, 0, 0, 0, 0.44, 0, 0, 0, 0.186, 15.29, 0.43, -5.2> texture { Material1125 } }
sphere { <-7.77, 1.12, 14.17>, 0.187 texture { Material1126 } }
sphere { <0, 0, 0>, 1 matrix <0.2398873223989461, 0.007353147276495781, 6.146050966575239e-05, -0.01516586625777255, 0.4946984593744524, 0.008272290686057752, 5.352186050059272e-05, -0.0034927449563354955, 0.20897080625790876, -7.77, 0.48, 14.17> texture { Material1126 } }
sphere { <-3.85, 0.94, -15.7>, 0.156 texture { Material1127 } }
sphere { <0, 0, 0>, 1 matrix <0.2324651652170718, 0.0157774981953088, -0.00013233025556986676, -0.027966123410568814, 0.4119939527573074, -0.006919453214986098, -9.882173591912796e-05, 0.002915217577258066, 0.17397554926121586, -3.85, 0.4, -15.7> texture { Material1127 } }
sphere { <13.45, 1.04, 8.98>, 0.173 texture { Material1128 } }
sphere { <0, 0, 0>, 1 matrix <0.2569510260167276, -0.005016468893532094, -7.258643949300994e-05, 0.00893985507096381, 0.45772099877474587, 0.013250142337321358, -5.451043899669619e-05, -0.005583575264417079, 0.19291920774220134, 13.45, 0.45, 8.98> texture { Material1128 } }
sphere { <-15.99, 1.06, 2.46>, 0.177 texture { Material1129 } }
sphere { <0, 0, 0>, 1 matrix <0.23897959005484576, -0.003120479387682354, 0.00013470563801796625, 0.006136507582471575, 0.4682115081031204, -0.040500950044312395, 0.00011159713944584653, 0.01706210235909331, 0.1972634588796574, -15.99, 0.46, 2.46> texture { Material1129 } }
sphere { <10.13, 1.02, -12.62>, 0.17 texture { Material1130 } }
sphere { <0, 0, 0>, 1 matrix <0.2574058414545973, -0.017492926674658443, 0.00047989728667143097, 0.03051091861859031, 0.4482876141412855, -0.0246434342688614, 0.00035341273049446467, 0.010405005580185926, 0.1897145512561391, 10.13, 0.44, -12.62> texture { Material1130 } }
sphere { <1.06, 0.92, 16.16>, 0.153 texture { Material1131 } }
sphere { <0, 0, 0>, 1 matrix <0.21969996780376777, 0.011485804539897691, -2.1002253736255314e-05, -0.02114432199390257, 0.40444496157560245, -0.00148010253957318, -1.6324479040452998e-05, 0.0006249321833753427, 0.1709988572864672, 1.06, 0.4, 16.16> texture { Material1131 } }
sphere { <-11.7, 0.95, -11.21>, 0.158 texture { Material1132 } }
sphere { <0, 0, 0>, 1 matrix <0.20562472491389128, 0.012422526323840975, -0.0003915913942003896, -0.025206873802745278, 0.4164093838023496, -0.026302824837647242, -0.00033646445035664545, 0.011137799034123354, 0.1766489066604974, -11.7, 0.41, -11.21> texture { Material1132 } }
sphere { <16.2, 1.09, 0.36>, 0.182 texture { Material1133 } }
sphere { <0, 0, 0>, 1 matrix <0.2769999325306215, 0.00019330455468623622, -3.3734689266388235e-06, -0.00033636388216160955, 0.48170637862320415, -0.01681819410808048, -2.4844319892935733e-06, 0.0071180738548722354, 0.2038757784005353, 16.2, 0.47, 0.36> texture { Material1133 } }
sphere { <-12.19, 1.01, 10.68>, 0.168 texture { Material1134 } }
sphere { <0, 0, 0>, 1 matrix <0.24885107034308587, 0.00860907355738434, 0.00016923824649333957, -0.015385693706972013, 0.4443901429657854, 0.01748374284883183, 0.0001277782744608347, -0.007386390237259291, 0.1878547974153854, -12.19, 0.43, 10.68> texture { Material1134 } }
sphere { <1.78, 1.05, -16.12>, 0.175 texture { Material1135 } }
sphere { <0, 0, 0>, 1 matrix <0.23243934537260566, 0.016153849141696326, 6.229495859937388e-05, -0.03216903863410771, 0.4628697193205584, 0.003574337626011967, 5.2402626117928247e-05, -0.0015098495144360896, 0.1959941774859869, 1.78, 0.45, -16.12> texture { Material1135 } }
sphere { <9.58, 1.17, 13.09>, 0.194 texture { Material1136 } }
sphere { <0, 0, 0>, 1 matrix <0.2839717393676148, -0.004006347063491805, -2.0584905070716874e-05, 0.00726503076654324, 0.5149215630055415, 0.005291812533654952, -1.5728607043470286e-05, -0.002229754019035193, 0.21698854336030168, 9.58, 0.5, 13.09> texture { Material1136 } }
sphere { <-15.92, 0.89, -3.18>, 0.149 texture { Material1137 } }
sphere { <0, 0, 0>, 1 matrix <0.20797974100176103, 0.0029012891079482034, -9.926909137093876e-05, -0.005481762593382904, 0.39204267175211094, -0.026860636707576224, -7.922437099796075e-05, 0.011345714232716676, 0.16561180058211, -15.92, 0.38, -3.18> texture { Material1137 } }
sphere { <13.89, 1.01, -8.41>, 0.169 texture { Material1138 } }
sphere { <0, 0, 0>, 1 matrix <0.211991355599308, 0.0019144050714446066, 1.4296508836739352e-05, -0.004027474820114597, 0.4459320720397505, 0.006660823740958756, 1.2678036138240557e-05, -0.002807701487220283, 0.18797903247869444, 13.89, 0.44, -8.41> texture { Material1138 } }
sphere { <-4.57, 0.94, 15.59>, 0.157 texture { Material1139 } }
sphere { <0, 0, 0>, 1 matrix <0.18989333137435174, -0.006365668198536176, 3.111168248074124e-05, 0.013937463003110785, 0.4157465840399438, -0.004065093375907313, 2.8819242719002408e-05, 0.0017198471974992477, 0.17599159438754028, -4.57, 0.41, 15.59> texture { Material1139 } }
sphere { <-7.17, 1.03, -14.58>, 0.172 texture { Material1140 } }
sphere { <0, 0, 0>, 1 matrix <0.23893887650417728, 0.022537616800938482, -0.0005187714868466586, -0.042727565185112545, 0.45250746239256434, -0.020889031868277248, -0.0004150171894773269, 0.008814712348811498, 0.19179710270736663, -7.17, 0.44, -14.58> texture { Material1140 } }
sphere { <15.14, 0.93, 5.92>, 0.156 texture { Material1141 } }
sphere { <0, 0, 0>, 1 matrix <0.21893047953755096, 0.005514786964470394, -0.00017959452799334134, -0.010374850362382658, 0.4109963887070475, -0.02680169676948854, -0.0001426915427892301, 0.011319163198764576, 0.1736313801811278, 15.14, 0.4, 5.92> texture { Material1141 } }
sphere { <-15.17, 0.85, 5.87>, 0.141 texture { Material1142 } }
sphere { <0, 0, 0>, 1 matrix <0.213847227807845, 0.008075109980855274, 0.0003946614964004523, -0.014112575387102207, 0.3719511888677342, 0.0364574864166807, 0.00029138559080033396, -0.01540182581239452, 0.15724725389043248, -15.17, 0.37, 5.87> texture { Material1142 } }
sphere { <7.22, 1.22, -14.58>, 0.204 texture { Material1143 } }
sphere { <0, 0, 0>, 1 matrix <0.2996681715278611, -0.014105341380723705, 0.00016222725304566423, 0.02538961448530267, 0.5392599487674699, -0.012412700415036863, 0.0001232927123147048, 0.005240917953015564, 0.22793972356286837, 7.22, 0.53, -14.58> texture { Material1143 } }
sphere { <4.52, 1.2, 15.64>, 0.2 texture { Material1144 } }
sphere { <0, 0, 0>, 1 matrix <0.27, 0, 0, 0, 0.53, 0, 0, 0, 0.224, 4.52, 0.52, 15.64> texture { Material1144 } }
sphere { <-13.9, 1.13, -8.48>, 0.188 texture { Material1145 } }
sphere { <0, 0, 0>, 1 matrix <0.28589325802449805, -0.007811182506071933, -0.00017448207533972464, 0.01357397799132081, 0.4963188787730232, 0.02218823325504363, -0.0001281162091655321, -0.009375309826074773, 0.2097905792734794, -13.9, 0.49, -8.48> texture { Material1145 } }
sphere { <15.98, 1.05, -3.14>, 0.175 texture { Material1146 } }
sphere { <0, 0, 0>, 1 matrix <0.24999448290401138, 0.0016606347514906083, 2.8456600362360537e-05, -0.0030688530207546444, 0.46171856208282225, 0.015828820843892377, 2.219614828264122e-05, -0.0066809958107337955, 0.1948855146035948, 15.98, 0.45, -3.14> texture { Material1146 } }
sphere { <-9.67, 1.12, 13.12>, 0.187 texture { Material1147 } }
sphere { <0, 0, 0>, 1 matrix <0.22519111164564234, -0.01909492316325177, 0.0005891902828037203, 0.041907441986605655, 0.49328286010266353, -0.030525173792712756, 0.0005474776964105366, 0.012923964710624352, 0.20960121994952813, -9.67, 0.49, 13.12> texture { Material1147 } }
sphere { <-1.73, 0.86, -16.21>, 0.143 texture { Material1148 } }
sphere { <0, 0, 0>, 1 matrix <0.172, 0, 0, 0, 0.378, 0, 0, 0, 0.16, -1.73, 0.37, -16.21> texture { Material1148 } }
sphere { <12.23, 1.01, 10.79>, 0.169 texture { Material1149 } }
sphere { <0, 0, 0>, 1 matrix <0.2129858418296327, -0.00245579340992354, -1.6088829962815846e-05, 0.005153707296881795, 0.4469319197349069, 0.005856485564638403, -1.4276004051512652e-05, -0.002476232151491405, 0.1889837772681233, 12.23, 0.44, 10.79> texture { Material1149 } }
sphere { <-16.31, 1.09, 0.31>, 0.182 texture { Material1150 } }
sphere { <0, 0, 0>, 1 matrix <0.24199963179405765, -0.0004217494534412798, 1.841029711710472e-05, 0.000838270607872957, 0.4791696497821296, -0.04191353039364785, 1.5443348408149832e-05, 0.017689078315822275, 0.20222783257959254, -16.31, 0.47, 0.31> texture { Material1150 } }
sphere { <11.82, 0.98, -11.25>, 0.164 texture { Material1151 } }
sphere { <0, 0, 0>, 1 matrix <0.21793642439230423, 0.005264078469505128, 6.633976455211978e-05, -0.010455715492182204, 0.4327362280992685, 0.010910311817929256, 5.568888492219229e-05, -0.004611055572011672, 0.18294188985921161, 11.82, 0.42, -11.25> texture { Material1151 } }
sphere { <-1.12, 0.85, 16.29>, 0.142 texture { Material1152 } }
sphere { <0, 0, 0>, 1 matrix <0.19525779761765563, -0.01704082657229978, 5.1954166764107e-05, 0.03277750825386233, 0.37556540118058807, -0.0022944255777703633, 4.214649242598475e-05, 0.0009676755089270232, 0.1589970497455302, -1.12, 0.37, 16.29> texture { Material1152 } }
sphere { <-10.18, 0.92, -12.77>, 0.153 texture { Material1153 } }
sphere { <0, 0, 0>, 1 matrix <0.21826480613427737, -0.017920181290734687, -0.00058438486762567, 0.033140061291084696, 0.40278136762415073, 0.02634210000060578, -0.0004563005130775779, -0.011122220000255773, 0.1706372995921691, -10.18, 0.4, -12.77> texture { Material1153 } }
sphere { <16.14, 0.84, 2.54>, 0.139 texture { Material1154 } }
sphere { <0, 0, 0>, 1 matrix <0.1799825645508668, -0.0025029620854758257, -0.00010788184151153527, 0.005131072275225443, 0.3675958435958541, 0.03174850970295743, -9.349759597666392e-05, -0.013422134183364116, 0.15542148362489439, 16.14, 0.36, 2.54> texture { Material1154 } }
sphere { <-13.62, 1.12, 9.04>, 0.186 texture { Material1155 } }
sphere { <0, 0, 0>, 1 matrix <0.25695223055228167, 0.004954393753428041, 7.208843928401821e-05, -0.009503953776031223, 0.49269967772041423, 0.014342330243828931, 5.834395086021707e-05, -0.006051125133299022, 0.20791195367415638, -13.62, 0.48, 9.04> texture { Material1155 } }
sphere { <3.94, 1.02, -15.87>, 0.171 texture { Material1156 } }
sphere { <0, 0, 0>, 1 matrix <0.23396641657606385, 0.003964321570114649, 8.30930076770587e-06, -0.007657578417486415, 0.45193115821068885, 0.0018946585775224119, 6.782377977059066e-06, -0.0008006190006787183, 0.19099832188586136, 3.94, 0.44, -15.87> texture { Material1156 } }
sphere { <7.82, 0.82, 14.37>, 0.136 texture { Material1157 } }
sphere { <0, 0, 0>, 1 matrix <0.17027804163735633, -0.015691827850003077, -0.000393795470532915, 0.03303542705263805, 0.3580278823325784, 0.018019323846893483, -0.0003500404182514799, -0.007608158957577249, 0.15180906886277193, 7.82, 0.35, 14.37> texture { Material1157 } }
sphere { <-15.48, 1.07, -5.32>, 0.178 texture { Material1158 } }
sphere { <0, 0, 0>, 1 matrix <0.2629956870502923, -0.0015061337211466983, -1.2416067340282406e-05, 0.0026972965120155698, 0.47092826441866026, 0.007764944504287244, -9.394666922875282e-06, -0.003280730268265736, 0.19897295474673718, -15.48, 0.46, -5.32> texture { Material1158 } }
sphere { <15.01, 1.22, -6.53>, 0.203 texture { Material1159 } }
sphere { <0, 0, 0>, 1 matrix <0.2898245568277593, -0.010077868414031448, 0.0004035192961535328, 0.018626680930761575, 0.5339603581771757, -0.042841366140751624, 0.00031446676182999455, 0.018063710350391542, 0.22527672644779104, 15.01, 0.52, -6.53> texture { Material1159 } }
sphere { <-6.66, 0.84, 14.97>, 0.141 texture { Material1160 } }
sphere { <0, 0, 0>, 1 matrix <0.18, 0, 0, 0, 0.373, 0, 0, 0, 0.157, -6.66, 0.36, 14.97> texture { Material1160 } }
sphere { <-5.2, 1.13, -15.54>, 0.188 texture { Material1161 } }
sphere { <0, 0, 0>, 1 matrix <0.24286705522588353, -0.00803688251339284, -4.4781397597131905e-05, 0.01640450093268662, 0.4956978502014715, 0.005525726629957599, -3.8699973232089296e-05, -0.0023395213554255963, 0.20998696421954285, -5.2, 0.49, -15.54> texture { Material1161 } }
sphere { <14.34, 1.01, 7.95>, 0.169 texture { Material1162 } }
sphere { <0, 0, 0>, 1 matrix <0.25291908633271126, 0.006396425614182992, -0.00014665602196086463, -0.011275912347532072, 0.44538877250053993, -0.020437591129901882, -0.0001095572654174048, 0.008660772922761113, 0.18880142745643097, 14.34, 0.44, 7.95> texture { Material1162 } }
sphere { <-15.95, 1.14, 3.83>, 0.19 texture { Material1163 } }
sphere { <0, 0, 0>, 1 matrix <0.26098096007587335, 0.003151512331634791, 8.029881044721759e-05, -0.006085678985225803, 0.5033092855163052, 0.0256656896333436, 6.553121312359136e-05, -0.010846809309329736, 0.2127236292316092, -15.95, 0.49, 3.83> texture { Material1163 } }
sphere { <9.18, 1.03, -13.6>, 0.172 texture { Material1164 } }
sphere { <0, 0, 0>, 1 matrix <0.23638026037022505, -0.01712301574686869, 0.00041813758153489366, 0.032945549285114444, 0.45426478232983597, -0.022228322409233846, 0.00033874436985105314, 0.009359293645993198, 0.19177144958178727, 9.18, 0.45, -13.6> texture { Material1164 } }
sphere { <2.42, 1.03, 16.23>, 0.171 texture { Material1165 } }
sphere { <0, 0, 0>, 1 matrix <0.20172937863217386, -0.010452565015897163, -4.100323754942024e-05, 0.023388907857354046, 0.4513805497090674, 0.003543773917780916, -3.8770387979897345e-05, -0.0014974796864959182, 0.19099412569879093, 2.42, 0.44, 16.23> texture { Material1165 } }
sphere { <-12.75, 0.89, -10.34>, 0.148 texture { Material1166 } }
sphere { <0, 0, 0>, 1 matrix <0.207, 0, 0, 0, 0.391, 0, 0, 0, 0.165, -12.75, 0.38, -10.34> texture { Material1166 } }
sphere { <16.4, 1.11, -0.99>, 0.186 texture { Material1167 } }
sphere { <0, 0, 0>, 1 matrix <0.2229989037370476, 0.0006989980284225303, 1.8271049206658142e-05, -0.001542183990959125, 0.4913257310992503, 0.02570306651598542, 1.7042054865403108e-05, -0.010866337063668633, 0.20771596575224327, 16.4, 0.48, -0.99> texture { Material1167 } }
sphere { <-11.42, 1.14, 11.81>, 0.19 texture { Material1168 } }
sphere { <0, 0, 0>, 1 matrix <0.27180836753486887, -0.010206695197715951, 0.00018630934109974454, 0.01887488119283501, 0.5023106559815507, -0.018350578937478487, 0.00014521169232774203, 0.007734240029314988, 0.21185882196579248, -11.42, 0.49, 11.81> texture { Material1168 } }
sphere { <0.45, 0.86, -16.43>, 0.144 texture { Material1169 } }
sphere { <0, 0, 0>, 1 matrix <0.21248160925701123, -0.014851447259264766, 1.5551722289662682e-05, 0.026495539711364376, 0.3790743390987332, -0.0007948661913409312, 1.1755057693125315e-05, 0.0003367722547523419, 0.16099964734826921, 0.45, 0.37, -16.43> texture { Material1169 } }
sphere { <10.77, 0.99, 12.42>, 0.164 texture { Material1170 } }
sphere { <0, 0, 0>, 1 matrix <0.2049288087699142, -0.005401806544252733, -6.182396296922717e-05, 0.011462369984146042, 0.43473500975330664, 0.00995416340728472, -5.549077651872097e-05, -0.004210496705610089, 0.18395181064144425, 10.77, 0.42, 12.42> texture { Material1170 } }
sphere { <-16.34, 1.1, -1.88>, 0.183 texture { Material1171 } }
sphere { <0, 0, 0>, 1 matrix <0.22599328628486245, 0.0017409489299110013, -6.042343623801931e-05, -0.0037284039029952414, 0.4828210003257549, -0.033555635126957174, -5.454150881661919e-05, 0.014143284227064594, 0.20350912642065042, -16.34, 0.47, -1.88> texture { Material1171 } }
sphere { <13.33, 0.89, -9.66>, 0.149 texture { Material1172 } }
sphere { <0, 0, 0>, 1 matrix <0.21498864895145098, -0.0022092032907491546, 1.558364292325397e-05, 0.004038218108206594, 0.3929401441964618, -0.005543994351944647, 1.203202197795423e-05, 0.0023417380723226755, 0.1659834814613523, 13.33, 0.38, -9.66> texture { Material1172 } }
sphere { <-3.31, 1.11, 16.13>, 0.185 texture { Material1173 } }
sphere { <0, 0, 0>, 1 matrix <0.2725590153512625, 0.028062371043556803, 0.00029407849974235446, -0.050082114745617794, 0.4863212068350856, 0.010220839744003634, 0.0002210955144048358, -0.004305711630398258, 0.20595487846644797, -3.31, 0.48, 16.13> texture { Material1173 } }
sphere { <-8.46, 1.01, -14.13>, 0.169 texture { Material1174 } }
sphere { <0, 0, 0>, 1 matrix <0.2529705832038124, -0.02283662326662677, -0.0006104681000647545, 0.04018886063063845, 0.4445512872296182, 0.023832928978634434, -0.0004542459484733802, -0.010077010239288385, 0.18873062158869602, -8.46, 0.44, -14.13> texture { Material1174 } }
sphere { <15.79, 0.86, 4.71>, 0.143 texture { Material1175 } }
sphere { <0, 0, 0>, 1 matrix <0.18294176718906371, -0.004612229092923683, -0.00019277068447869284, 0.009577306313174862, 0.37855398527486334, 0.03170418641602713, -0.0001685426749540484, -0.013349131122537739, 0.15944206562773833, 15.79, 0.37, 4.71> texture { Material1175 } }
sphere { <-14.83, 1.06, 7.2>, 0.177 texture { Material1176 } }
sphere { <0, 0, 0>, 1 matrix <0.22576117297846282, 0.010375650993913533, 0.0004885098167806036, -0.021531771310378083, 0.4664307689277201, 0.044042259498500616, 0.00042798647664849334, -0.01859353386077425, 0.19712457311594628, -14.83, 0.46, 7.2> texture { Material1176 } }
sphere { <6.08, 1.18, -15.33>, 0.196 texture { Material1177 } }
sphere { <0, 0, 0>, 1 matrix <0.24917867697633028, 0.020245497433195918, 0.0003267629233954777, -0.04211063466104751, 0.5180212430077077, 0.01675369335977159, 0.00028624432089443847, -0.007055882395749957, 0.21888611785082696, 6.08, 0.51, -15.33> texture { Material1177 } }
sphere { <5.88, 1, 15.41>, 0.167 texture { Material1178 } }
sphere { <0, 0, 0>, 1 matrix <0.23187708929010087, 0.007550708486773212, -4.75783393158003e-05, -0.014385401513593792, 0.44173074554244035, -0.005568542521391144, -3.8349782120925236e-05, 0.002355921835973176, 0.18698515492304996, 5.88, 0.43, 15.41> texture { Material1178 } }
sphere { <-14.75, 1.14, -7.4>, 0.19 texture { Material1179 } }
sphere { <0, 0, 0>, 1 matrix <0.2659257790966772, -0.006281597233261875, -0.0001467924532384736, 0.011854743650742334, 0.5013120264467961, 0.023446048553690393, -0.00011699248152840751, -0.009901518512713871, 0.21176861486986603, -14.75, 0.49, -7.4> texture { Material1179 } }
sphere { <15.88, 0.88, -4.51>, 0.147 texture { Material1180 } }
sphere { <0, 0, 0>, 1 matrix <0.1879916049899066, -0.0017763902613487591, 2.9848924776542134e-05, 0.0036756160194929112, 0.38876303171042825, -0.013068856958197017, 2.6038423741238885e-05, 0.005509749463095915, 0.16390741893780894, 15.88, 0.38, -4.51> texture { Material1180 } }
sphere { <-8.67, 1.16, 14.06>, 0.194 texture { Material1181 } }
sphere { <0, 0, 0>, 1 matrix <0.27096996584991795, 0.004034509845888528, 1.8373832991379746e-05, -0.007622394985590134, 0.5119220199200724, 0.0046631122264786705, 1.464482629571227e-05, -0.001967250470545689, 0.21599104081214848, -8.67, 0.5, 14.06> texture { Material1181 } }
sphere { <-3.11, 0.83, -16.23>, 0.138 texture { Material1182 } }
sphere { <0, 0, 0>, 1 matrix <0.203521068569378, 0.013970183481379217, -9.285405287569475e-05, -0.025064152716592125, 0.36510844239509566, -0.004859376547094392, -7.055087350849356e-05, 0.0020579326907093735, 0.15498632176942181, -3.11, 0.36, -16.23> texture { Material1182 } }
sphere { <13.26, 0.83, 9.87>, 0.138 texture { Material1183 } }
sphere { <0, 0, 0>, 1 matrix <0.17484653516636892, -0.007324429743133156, -0.00020461977817476737, 0.015318521634209915, 0.36510844239509566, 0.02042469551227989, -0.0001800654047937953, -0.008593997565276236, 0.15375991279360826, 13.26, 0.36, 9.87> texture { Material1183 } }
sphere { <-16.45, 0.83, 1.68>, 0.138 texture { Material1184 } }
sphere { <0, 0, 0>, 1 matrix <0.167, 0, 0, 0, 0.364, 0, 0, 0, 0.154, -16.45, 0.36, 1.68> texture { Material1184 } }
sphere { <11, 0.91, -12.35>, 0.151 texture { Material1185 } }
sphere { <0, 0, 0>, 1 matrix <0.22868562190571448, -0.011992072250761312, 0.00027665272297127357, 0.02089448396530028, 0.39802805605366987, -0.01838714588946425, 0.00020416729337181328, 0.007788039236389619, 0.1688203327818328, 11, 0.39, -12.35> texture { Material1185 } }
sphere { <0.23, 1.09, 16.55>, 0.182 texture { Material1186 } }
sphere { <0, 0, 0>, 1 matrix <0.22445196611184928, -0.015694421890950695, -5.480338881507407e-06, 0.03355118635354348, 0.4798283081749754, 0.0003355118635354348, -4.94448352420446e-06, -0.00014159856194946626, 0.20299995055516476, 0.23, 0.47, 16.55> texture { Material1186 } }
sphere { <-11.35, 0.84, -12.05>, 0.139 texture { Material1187 } }
sphere { <0, 0, 0>, 1 matrix <0.1766442729103242, 0.011211056768965867, -0.00033623519435107543, -0.023372203094623758, 0.3675958435958541, -0.02209153443190465, -0.0002963428831568801, 0.009339510491536926, 0.1557198950830435, -11.35, 0.36, -12.05> texture { Material1187 } }
sphere { <16.52, 1.03, 1.21>, 0.172 texture { Material1188 } }
sphere { <0, 0, 0>, 1 matrix <0.247, 0, 0, 0, 0.456, 0, 0, 0, 0.193, 16.52, 0.45, 1.21> texture { Material1188 } }
sphere { <-13, 1.22, 10.26>, 0.203 texture { Material1189 } }
sphere { <0, 0, 0>, 1 matrix <0.2609846086812334, 0.0028343705768986366, 1.936327199673299e-05, -0.005842495671921328, 0.5379180599941386, 0.007350236490481671, 1.6840853422445934e-05, -0.003101307961597285, 0.22697881311988788, -13, 0.53, 10.26> texture { Material1189 } }
sphere { <2.66, 1.09, -16.36>, 0.181 texture { Material1190 } }
sphere { <0, 0, 0>, 1 matrix <0.23711739168413376, 0.0204773585617991, 0.00014264376822080776, -0.04129887441035113, 0.47817345508403786, 0.0066745655612688685, 0.00012166674348245367, -0.0028227850186199593, 0.20298033668792204, 2.66, 0.47, -16.36> texture { Material1190 } }
sphere { <9.1, 1.15, 13.86>, 0.192 texture { Material1191 } }
sphere { <0, 0, 0>, 1 matrix <0.2679714304456202, 0.003913069767348355, -1.870625584392279e-05, -0.007417311350048374, 0.5079226291394467, -0.004856572907769769, -1.4937084890296555e-05, 0.0020458791383124618, 0.21399021976584565, 9.1, 0.5, 13.86> texture { Material1191 } }
sphere { <-16.08, 0.84, -4.08>, 0.14 texture { Material1192 } }
sphere { <0, 0, 0>, 1 matrix <0.17199836827081044, -0.0007491809499183408, -6.33110925545161e-06, 0.0016116101829638729, 0.36994364720786477, 0.006253047509899827, -5.742168859595645e-06, -0.002636420031201008, 0.15597772038482477, -16.08, 0.36, -4.08> texture { Material1192 } }
sphere { <14.61, 0.99, -7.86>, 0.165 texture { Material1193 } }
sphere { <0, 0, 0>, 1 matrix <0.2508642987785604, 0.00824857819642486, 0.000254078882695383, -0.014361070405727747, 0.4359354899635432, 0.026888812674554077, 0.00018625702954561937, -0.011321605336654349, 0.18365126343404223, 14.61, 0.43, -7.86> texture { Material1193 } }
sphere { <-5.47, 0.95, 15.67>, 0.158 texture { Material1194 } }
sphere { <0, 0, 0>, 1 matrix <0.21097138976914814, -0.0034745644319680562, 1.004401721395199e-05, 0.006899727473908131, 0.4189361842705279, -0.002422244751478387, 8.425549985163518e-06, 0.0010232394296221347, 0.17699704209415412, -5.47, 0.41, 15.67> texture { Material1194 } }
sphere { <-6.55, 0.88, -15.26>, 0.147 texture { Material1195 } }
sphere { <0, 0, 0>, 1 matrix <0.22288484757690402, 0.007165356777837932, -4.881461413851001e-05, -0.012531341450030464, 0.38976242253744736, -0.0053121990929476965, -3.6118436470197985e-05, 0.0022474688470163332, 0.16498468892367024, -6.55, 0.38, -15.26> texture { Material1195 } }
sphere { <15.14, 1.11, 6.83>, 0.185 texture { Material1196 } }
sphere { <0, 0, 0>, 1 matrix <0.24999357497384797, 0.001792280233492279, -1.4260423898418322e-05, -0.003520038378578836, 0.4909252183217881, -0.007812768108553027, -1.180763098789037e-05, 0.0032937739276384446, 0.20697379281902686, 15.14, 0.48, 6.83> texture { Material1196 } }
sphere { <-15.78, 0.92, 5.2>, 0.153 texture { Material1197 } }
sphere { <0, 0, 0>, 1 matrix <0.2169872786795595, -0.002349334253144597, 3.898469167249817e-05, 0.004373875752398237, 0.4037538941157147, -0.013403812789607497, 3.072065564975663e-05, 0.005673396007482382, 0.1709058560552669, -15.78, 0.4, 5.2> texture { Material1197 } }
sphere { <8.13, 1.06, -14.5>, 0.177 texture { Material1198 } }
sphere { <0, 0, 0>, 1 matrix <0.21889871897351557, 0.006659397706368331, 5.704333675559216e-05, -0.01423104167388301, 0.46771490704493685, 0.008015184391037556, 5.1573427751631264e-05, -0.003391039550054351, 0.19797095289701347, 8.13, 0.46, -14.5> texture { Material1198 } }
sphere { <3.8, 0.94, 16.19>, 0.156 texture { Material1199 } }
sphere { <0, 0, 0>, 1 matrix <0.20791602045941812, -0.02125705468579188, -0.00025702607663281336, 0.04200556739345476, 0.41073754278709684, 0.009960082990200615, -0.00021398343222061976, -0.004196257724685005, 0.17394926166040128, 3.8, 0.4, 16.19> texture { Material1199 } }
sphere { <-13.74, 0.9, -9.37>, 0.15 texture { Material1200 } }
sphere { <0, 0, 0>, 1 matrix <0.212, 0, 0, 0, 0.398, 0, 0, 0, 0.168, -13.74, 0.39, -9.37> texture { Material1200 } }
sphere { <16.47, 0.88, -2.37>, 0.147 texture { Material1201 } }
sphere { <0, 0, 0>, 1 matrix <0.200997599381939, 0.0009822191811371716, 1.6975799145562468e-05, -0.001900911748568954, 0.38876303171042825, 0.013442161650594742, 1.3850900795384305e-05, -0.005667132418245599, 0.16390205434437552, 16.47, 0.38, -2.37> texture { Material1201 } }
sphere { <-10.55, 1.02, 12.88>, 0.169 texture { Material1202 } }
sphere { <0, 0, 0>, 1 matrix <0.24264542460291885, 0.013119213281090995, 0.00029010714306638264, -0.02418686234538587, 0.44690869451640125, 0.019789251009861165, 0.000225638889051631, -0.00834859026978518, 0.18881538636350323, -10.55, 0.44, 12.88> texture { Material1202 } }
sphere { <-0.92, 1.11, -16.63>, 0.186 texture { Material1203 } }
sphere { <0, 0, 0>, 1 matrix <0.266, 0, 0, 0, 0.491, 0, 0, 0, 0.207, -0.92, 0.48, -16.63> texture { Material1203 } }
sphere { <11.92, 0.99, 11.64>, 0.165 texture { Material1204 } }
sphere { <0, 0, 0>, 1 matrix <0.20462094151459326, -0.012454648949741793, -0.000389888727846936, 0.02648891191262157, 0.43434088836800105, 0.027245737967267897, -0.0003499489069455426, -0.011498201343984616, 0.183640052552856, 11.92, 0.43, 11.64> texture { Material1204 } }
sphere { <-16.66, 0.84, -0.53>, 0.14 texture { Material1205 } }
sphere { <0, 0, 0>, 1 matrix <0.1969993259266377, 0.0005148588052822918, -2.246911207691461e-05, -0.0009722206881472717, 0.37058442769012934, -0.03240735627157572, -1.7906855817642608e-05, 0.01367729821139083, 0.15640310480607858, -16.66, 0.36, -0.53> texture { Material1205 } }
sphere { <12.65, 1, -10.86>, 0.166 texture { Material1206 } }
sphere { <0, 0, 0>, 1 matrix <0.24698410743653945, -0.002801843764819757, 1.8582074200030075e-05, 0.004991138690367178, 0.4399329858688122, -0.005835792930275471, 1.3992978952249367e-05, 0.002466948829616449, 0.18598363897845582, 12.65, 0.43, -10.86> texture { Material1206 } }
sphere { <-1.99, 0.89, 16.56>, 0.149 texture { Material1207 } }
sphere { <0, 0, 0>, 1 matrix <0.1779732822846201, 0.0030839556337571537, 3.238510955140932e-06, -0.006808958225093042, 0.3929401441964618, 0.0008253282697082474, 3.020184373895476e-06, -0.0003486119408945778, 0.16599963391704559, -1.99, 0.38, 16.56> texture { Material1207 } }
sphere { <-9.72, 0.87, -13.56>, 0.146 texture { Material1208 } }
sphere { <0, 0, 0>, 1 matrix <0.18283420988282428, 0.007787015059102045, -0.00011871391106410277, -0.016425070015373713, 0.3854710004152655, -0.011761161245576237, -0.00010573971313359974, 0.004966500733235561, 0.16292428514368212, -9.72, 0.38, -13.56> texture { Material1208 } }
sphere { <16.34, 0.87, 3.43>, 0.145 texture { Material1209 } }
sphere { <0, 0, 0>, 1 matrix <0.1969789320054179, 0.0028793540442070783, -9.831730804982729e-05, -0.0056125479846473, 0.3830645952997725, -0.026191890595020736, -8.084976601051787e-05, 0.011049703844774373, 0.16162270109195093, 16.34, 0.38, 3.43> texture { Material1209 } }
sphere { <-14.37, 1.18, 8.51>, 0.196 texture { Material1210 } }
sphere { <0, 0, 0>, 1 matrix <0.23991442440484095, 0.006406882148546845, 0.00014430394477797342, -0.013881577988518164, 0.5192873580723784, 0.023408151117893374, 0.00013167734960990073, -0.009858432874651248, 0.2187779558418343, -14.37, 0.51, 8.51> texture { Material1210 } }
sphere { <4.85, 0.89, -15.99>, 0.148 texture { Material1211 } }
sphere { <0, 0, 0>, 1 matrix <0.19497278412244742, 0.003257818894453239, 8.221463010669938e-06, -0.006565758079590374, 0.3929401441964618, 0.0019834060865429252, 6.998783896262615e-06, -0.0008377745810842891, 0.16599788578403135, 4.85, 0.38, -15.99> texture { Material1211 } }
sphere { <7.22, 1.1, 15.07>, 0.183 texture { Material1212 } }
sphere { <0, 0, 0>, 1 matrix <0.22488840911069474, -0.007085238535332741, -5.3315647112510306e-05, 0.015241135338226871, 0.4837051602772423, 0.007281875772708394, -4.857647848028717e-05, -0.0030842655648868197, 0.20497679123805942, 7.22, 0.47, 15.07> texture { Material1212 } }
sphere { <-15.51, 1.15, -6.24>, 0.191 texture { Material1213 } }
sphere { <0, 0, 0>, 1 matrix <0.27697694087506414, 0.0035736345919274736, -5.795942213612905e-05, -0.006528011204026359, 0.5056917584716625, -0.016408244377687876, -4.477731529650403e-05, 0.006939455132065623, 0.21388745161290337, -15.51, 0.5, -6.24> texture { Material1213 } }
sphere { <15.66, 0.94, -5.88>, 0.156 texture { Material1214 } }
sphere { <0, 0, 0>, 1 matrix <0.215, 0, 0, 0, 0.413, 0, 0, 0, 0.174, 15.66, 0.4, -5.88> texture { Material1214 } }
sphere { <-7.57, 1.11, 14.92>, 0.185 texture { Material1215 } }
sphere { <0, 0, 0>, 1 matrix <0.23388647590503442, 0.007287873076834259, 5.739982329720739e-05, -0.01526093080191789, 0.4897015052393569, 0.007716200967261856, 5.0776766762914226e-05, -0.0032597012249453144, 0.2069743263538839, -7.57, 0.48, 14.92> texture { Material1215 } }
sphere { <-4.5, 1.1, -16.12>, 0.183 texture { Material1216 } }
sphere { <0, 0, 0>, 1 matrix <0.23986451551874477, -0.00806304799477451, -3.810501035303251e-05, 0.0162268840894837, 0.48270576945022325, 0.004563811150167291, -3.238925880007763e-05, -0.001927572411250781, 0.20399089052096248, -4.5, 0.47, -16.12> texture { Material1216 } }
sphere { <14.21, 0.87, 8.86>, 0.146 texture { Material1217 } }
sphere { <0, 0, 0>, 1 matrix <0.21396350511089107, 0.003951588915201301, -5.852953913696916e-05, -0.007109166973609817, 0.3847654684023519, -0.011401494202959139, -4.458091065105595e-05, 0.004827126117096986, 0.1629285023131068, 14.21, 0.38, 8.86> texture { Material1217 } }
sphere { <-16.47, 1.13, 3.07>, 0.188 texture { Material1218 } }
sphere { <0, 0, 0>, 1 matrix <0.26997853576921127, -0.0034024355193473053, 0.00011686081207201162, 0.006275603291240585, 0.49678689702939244, -0.034167173474532075, 9.089174272267569e-05, 0.014407844236248465, 0.20950514495628764, -16.47, 0.49, 3.07> texture { Material1218 } }
sphere { <10.07, 0.94, -13.39>, 0.156 texture { Material1219 } }
sphere { <0, 0, 0>, 1 matrix <0.206, 0, 0, 0, 0.413, 0, 0, 0, 0.174, 10.07, 0.4, -13.39> texture { Material1219 } }
sphere { <1.62, 0.84, 16.68>, 0.14 texture { Material1220 } }
sphere { <0, 0, 0>, 1 matrix <0.17258275316331642, -0.01200797941456286, -4.172468366835781e-05, 0.025681805684325196, 0.3690986985961349, 0.0025681805684325196, -3.762457024429954e-05, -0.0010828004558796568, 0.15599623754297556, 1.62, 0.36, 16.68> texture { Material1220 } }
sphere { <-12.47, 0.86, -11.21>, 0.143 texture { Material1221 } }
sphere { <0, 0, 0>, 1 matrix <0.1929867583127455, -0.00226073042245923, -1.4625147116922483e-05, 0.004451179070126981, 0.3799421241594287, 0.004916227629692487, -1.2124474293821746e-05, -0.0020699905809231523, 0.15998660878958593, -12.47, 0.37, -11.21> texture { Material1221 } }
sphere { <16.78, 1.12, -0.16>, 0.186 texture { Material1222 } }
sphere { <0, 0, 0>, 1 matrix <0.2559999961013859, -4.467592673895097e-05, 3.898614134970003e-07, 8.603606204024542e-05, 0.4929249137121009, -0.008603606204024542, 3.167623984663127e-07, 0.003629919047539766, 0.20796832376015334, 16.78, 0.48, -0.16> texture { Material1222 } }
sphere { <-12.27, 1.15, 11.45>, 0.191 texture { Material1223 } }
sphere { <0, 0, 0>, 1 matrix <0.2659247188767463, 0.006327508120643499, 8.081649996357856e-05, -0.012036538003930865, 0.5056917584716625, 0.012921577563043428, 6.501778568498424e-05, -0.005464856914014414, 0.21393020149477934, -12.27, 0.5, 11.45> texture { Material1223 } }
sphere { <1.31, 0.82, -16.74>, 0.136 texture { Material1224 } }
sphere { <0, 0, 0>, 1 matrix <0.194, 0, 0, 0, 0.361, 0, 0, 0, 0.152, 1.31, 0.35, -16.74> texture { Material1224 } }
sphere { <10.34, 0.88, 13.23>, 0.147 texture { Material1225 } }
sphere { <0, 0, 0>, 1 matrix <0.216, 0, 0, 0, 0.39, 0, 0, 0, 0.165, 10.34, 0.38, 13.23> texture { Material1225 } }
sphere { <-16.57, 1.11, -2.77>, 0.185 texture { Material1226 } }
sphere { <0, 0, 0>, 1 matrix <0.271981022285711, 0.003211121665551332, -0.00011051727732990272, -0.005784741235735854, 0.48880638462731385, -0.03368761072575586, -8.410689855621272e-05, 0.014231296775982576, 0.20651020100252557, -16.57, 0.48, -2.77> texture { Material1226 } }
sphere { <14.1, 1.07, -9.15>, 0.179 texture { Material1227 } }
sphere { <0, 0, 0>, 1 matrix <0.21296205753992944, 0.004019771736053235, 5.902160455418028e-05, -0.008926535357526667, 0.4727118611800323, 0.013885721667263703, 5.541934699923031e-05, -0.005871341085523765, 0.1999137921268901, 14.1, 0.46, -9.15> texture { Material1227 } }
sphere { <-4.21, 0.86, 16.28>, 0.144 texture { Material1228 } }
sphere { <0, 0, 0>, 1 matrix <0.21024709367419217, -0.01780791809618891, 0.00019404802211541735, 0.03215552983245486, 0.37955017997295504, -0.008287507688777025, 0.00014806507848617154, 0.0035020701781971154, 0.1609618388972974, -4.21, 0.37, 16.28> texture { Material1228 } }
sphere { <-7.89, 1.08, -14.85>, 0.181 texture { Material1229 } }
sphere { <0, 0, 0>, 1 matrix <0.25, 0, 0, 0, 0.479, 0, 0, 0, 0.202, -7.89, 0.47, -14.85> texture { Material1229 } }
sphere { <15.86, 0.93, 5.62>, 0.156 texture { Material1230 } }
sphere { <0, 0, 0>, 1 matrix <0.18897157979574017, 0.003276503604103047, -8.095452122498364e-05, -0.007142431136986536, 0.4114353683188844, -0.020345106875052553, -7.45295592230008e-05, 0.008592350961794039, 0.17378770367978902, 15.86, 0.4, 5.62> texture { Material1230 } }
sphere { <-15.5, 0.82, 6.57>, 0.137 texture { Material1231 } }
sphere { <0, 0, 0>, 1 matrix <0.20699519752397638, 0.0014099906615356221, 1.1328917799269087e-05, -0.0024657807704149526, 0.3619448656466136, 0.005816713612260915, 8.373547938590194e-06, -0.0024584452560108285, 0.15298024701511923, -15.5, 0.35, 6.57> texture { Material1231 } }
sphere { <6.99, 0.95, -15.32>, 0.159 texture { Material1232 } }
sphere { <0, 0, 0>, 1 matrix <0.23253209564429805, -0.014757298476993641, 0.00021595585647782948, 0.026601138885567935, 0.41897690110912617, -0.012277448716415968, 0.00016405230298959574, 0.005174067673346729, 0.1769242835524663, 6.99, 0.41, -15.32> texture { Material1232 } }
sphere { <5.19, 1.09, 16.03>, 0.182 texture { Material1233 } }
sphere { <0, 0, 0>, 1 matrix <0.24745402135905653, 0.01644614154532531, -0.00017816145125523723, -0.03196387187438226, 0.48082587222523526, -0.010430316085324737, -0.0001465521615164048, 0.004414490625324162, 0.2039521777157157, 5.19, 0.47, 16.03> texture { Material1233 } }
sphere { <-14.66, 1.07, -8.31>, 0.179 texture { Material1234 } }
sphere { <0, 0, 0>, 1 matrix <0.21080663913690645, 0.009024579279508923, -0.00034331418549263026, -0.020230454972548436, 0.4712000921973956, -0.03591937923697376, -0.0003254162895664743, 0.015187898197451907, 0.19942222005730037, -14.66, 0.46, -8.31> texture { Material1234 } }
sphere { <16.43, 0.84, -3.77>, 0.14 texture { Material1235 } }
sphere { <0, 0, 0>, 1 matrix <0.1929640694570046, -0.0037205915348800032, 0.00015842103047988438, 0.007152017924562079, 0.3695882329920376, -0.03153389721284189, 0.00012887099370643444, 0.013344533321876488, 0.15643179607320346, 16.43, 0.36, -3.77> texture { Material1235 } }
sphere { <-9.57, 0.99, 13.89>, 0.165 texture { Material1236 } }
sphere { <0, 0, 0>, 1 matrix <0.222, 0, 0, 0, 0.436, 0, 0, 0, 0.184, -9.57, 0.43, 13.89> texture { Material1236 } }
sphere { <-2.32, 0.92, -16.71>, 0.154 texture { Material1237 } }
sphere { <0, 0, 0>, 1 matrix <0.18289070698183363, -0.006323690442310637, -1.5455578326556878e-05, 0.014029608303705568, 0.4057526757697529, 0.0019839850126452323, -1.452655449272012e-05, -0.0008405059659482263, 0.17199794573976868, -2.32, 0.4, -16.71> texture { Material1237 } }
sphere { <13.01, 1.03, 10.76>, 0.171 texture { Material1238 } }
sphere { <0, 0, 0>, 1 matrix <0.21551654100953063, 0.014431986040487147, -0.0005816615979084522, -0.030267081834910548, 0.45051841860182784, -0.036415082832626754, -0.0005143396537060851, 0.015353820796979492, 0.19038118510413488, 13.01, 0.44, 10.76> texture { Material1238 } }
sphere { <-16.86, 0.93, 0.85>, 0.155 texture { Material1239 } }
sphere { <0, 0, 0>, 1 matrix <0.22299966123298068, -0.0003886438866236995, 6.77534038611696e-06, 0.0007162898538221546, 0.4107496299048483, -0.014325797076443094, 5.286588462710093e-06, 0.00606493598856715, 0.1738942682307458, -16.86, 0.4, 0.85> texture { Material1239 } }
sphere { <11.86, 0.9, -12.02>, 0.149 texture { Material1240 } }
sphere { <0, 0, 0>, 1 matrix <0.20698401286346013, 0.0025725805136882986, 1.576196560267838e-05, -0.0049214583740123975, 0.39593968728193096, 0.004852142058885462, 1.2716175148054539e-05, -0.0020462316258431116, 0.16698746292591038, 11.86, 0.39, -12.02> texture { Material1240 } }
sphere { <-0.62, 1.08, 16.88>, 0.179 texture { Material1241 } }
sphere { <0, 0, 0>, 1 matrix <0.2196989792791596, 0.01150471028378564, 1.2040828833616479e-05, -0.024839715385446267, 0.4743490290084226, 0.000993588615417851, 1.1000939070713238e-05, -0.0004204448667347117, 0.20099955996243718, -0.62, 0.46, 16.88> texture { Material1241 } }
sphere { <-10.95, 1.02, -12.88>, 0.169 texture { Material1242 } }
sphere { <0, 0, 0>, 1 matrix <0.22891943250289634, 0.006073604733458224, -6.890641199657319e-05, -0.011881986552791633, 0.4477270905045549, -0.010162225341203372, -5.687035749935516e-05, 0.004287188815820172, 0.1889513608784545, -10.95, 0.44, -12.88> texture { Material1242 } }
sphere { <16.78, 0.86, 2.1>, 0.143 texture { Material1243 } }
sphere { <0, 0, 0>, 1 matrix <0.1839983770088183, 0.0007727087661658905, -1.33896772490517e-05, -0.0015958115822991216, 0.3797685142672564, -0.013165445553967753, -1.1643197607871046e-05, 0.005543345496407475, 0.15990394361973506, 16.78, 0.37, 2.1> texture { Material1243 } }
sphere { <-13.79, 1.18, 9.79>, 0.197 texture { Material1244 } }
sphere { <0, 0, 0>, 1 matrix <0.2776472355370555, 0.013991563925029926, 0.0004987359648525948, -0.02622160001777191, 0.5190174377057994, 0.03707191726650512, 0.0003946831376531326, -0.015654168519445538, 0.21944199970193867, -13.79, 0.51, 9.79> texture { Material1244 } }
sphere { <3.56, 1, -16.54>, 0.166 texture { Material1245 } }
sphere { <0, 0, 0>, 1 matrix <0.2182032254677565, 0.018663419949401995, 0.00017073739976646092, -0.03741206099446336, 0.43732947246227627, 0.00801687021309929, 0.00014423022354701035, -0.0033784077207821613, 0.18496909352352564, 3.56, 0.43, -16.54> texture { Material1245 } }
sphere { <8.55, 1.04, 14.61>, 0.174 texture { Material1246 } }
sphere { <0, 0, 0>, 1 matrix <0.2445584685757534, -0.014699894167410932, -0.00026183840275089646, 0.027599801293914403, 0.45887946311951916, 0.016367324023135284, -0.00020733326585173028, -0.006902741001061403, 0.19387704655164606, 8.55, 0.45, 14.61> texture { Material1246 } }
sphere { <-16.18, 1.17, -5>, 0.195 texture { Material1247 } }
sphere { <0, 0, 0>, 1 matrix <0.2919960433261269, 0.0015200399918036559, -1.2661356393949972e-05, -0.0026860980677078303, 0.5159214107006979, -0.008595513816665058, -9.452656485894158e-06, 0.0036314380078158576, 0.21796975149924513, -16.18, 0.5, -5> texture { Material1247 } }
sphere { <15.31, 0.95, -7.25>, 0.159 texture { Material1248 } }
sphere { <0, 0, 0>, 1 matrix <0.21694473053755975, -0.0048959687560963475, 0.00011568027022378534, 0.009476068560186478, 0.419424404596921, -0.019833631870157745, 9.435671810880186e-05, 0.008358459145280763, 0.17680250919465598, 15.31, 0.41, -7.25> texture { Material1248 } }
sphere { <-6.4, 1.22, 15.69>, 0.203 texture { Material1249 } }
sphere { <0, 0, 0>, 1 matrix <0.254966718758441, -0.0041197257951278345, 1.3598786873563818e-05, 0.008659502063484389, 0.5359183646038258, -0.003538291165724804, 1.2052258170295776e-05, 0.001491891424354115, 0.2259950754213928, -6.4, 0.52, 15.69> texture { Material1249 } }
sphere { <-5.89, 0.87, -15.9>, 0.144 texture { Material1250 } }
sphere { <0, 0, 0>, 1 matrix <0.21388550962863695, 0.006999068054609794, -4.2629393592628726e-05, -0.01249366353673337, 0.3817672959212946, -0.0046518959977198725, -3.207164658137021e-05, 0.0019606158524421453, 0.16098805842946437, -5.89, 0.37, -15.9> texture { Material1250 } }
sphere { <15.08, 0.91, 7.75>, 0.152 texture { Material1251 } }
sphere { <0, 0, 0>, 1 matrix <0.2168259153045913, 0.008683835977299563, -0.0003368160411168119, -0.016087106280527303, 0.4004702686328817, -0.031125053455802826, -0.00026386510133575127, 0.013162336038523584, 0.1694894783908939, 15.08, 0.39, 7.75> texture { Material1251 } }
sphere { <-16.36, 0.89, 4.48>, 0.149 texture { Material1252 } }
sphere { <0, 0, 0>, 1 matrix <0.183969369877428, -0.003355317605486882, 0.00011309583718884956, 0.007166520755197526, 0.39204267175211094, -0.02646099971149855, 0.00010203211398559255, 0.011176910819615164, 0.1656232660406686, -16.36, 0.38, 4.48> texture { Material1252 } }
sphere { <9.04, 1.13, -14.36>, 0.188 texture { Material1253 } }
sphere { <0, 0, 0>, 1 matrix <0.25275033808214614, 0.011235762801417769, 0.00015567154877946528, -0.02216065469528643, 0.49831613784253237, 0.013817819986472716, 0.00012982884107694539, -0.005842805645582652, 0.2109190478990932, 9.04, 0.49, -14.36> texture { Material1253 } }
sphere { <3.03, 1.17, 16.7>, 0.195 texture { Material1254 } }
sphere { <0, 0, 0>, 1 matrix <0.2459637557426841, 0.004222655164248692, -6.657108486598198e-06, -0.008840111421089742, 0.5149215630055415, -0.001623693934485871, -5.899388821456941e-06, 0.0006873112188697473, 0.21799891643878788, 3.03, 0.5, 16.7> texture { Material1254 } }
sphere { <-13.52, 0.84, -10.27>, 0.141 texture { Material1255 } }
sphere { <0, 0, 0>, 1 matrix <0.1869077402796779, 0.005872094290458298, -0.00012301296042945274, -0.011681385433425062, 0.37149018692870145, -0.015575180577900086, -0.00010327826089531594, 0.006573396104113747, 0.15686229565213958, -13.52, 0.36, -10.27> texture { Material1255 } }
sphere { <16.92, 0.87, -1.56>, 0.144 texture { Material1256 } }
sphere { <0, 0, 0>, 1 matrix <0.19099789678922607, 0.0008960334712401999, 2.3369008599222103e-05, -0.0017920669424803999, 0.3814764822762472, 0.019911854916448885, 1.9698483688349522e-05, -0.00839216921871275, 0.16078112795901833, 16.92, 0.37, -1.56> texture { Material1256 } }
sphere { <-11.42, 1.03, 12.58>, 0.172 texture { Material1257 } }
sphere { <0, 0, 0>, 1 matrix <0.21783582362718495, 0.008457650322666984, 0.0001486461753865931, -0.017652435306483843, 0.45437643831333113, 0.015982610345059697, 0.0001309177324505774, -0.006744310299453762, 0.19188146637737585, -11.42, 0.44, 12.58> texture { Material1257 } }
sphere { <-0.08, 0.86, -17>, 0.144 texture { Material1258 } }
sphere { <0, 0, 0>, 1 matrix <0.1848873029985327, -0.0064564068899626795, 0, 0.01329670824365287, 0.3807679050942755, 0, 0, 0, 0.161, -0.08, 0.37, -17> texture { Material1258 } }
sphere { <11.54, 1.17, 12.49>, 0.195 texture { Material1259 } }
sphere { <0, 0, 0>, 1 matrix <0.2749103056591791, -0.007022596501654038, -8.355089281948911e-05, 0.013151407994006652, 0.5146862759148343, 0.012250626624554142, -6.592924997028777e-05, -0.005161914519472328, 0.21693858645208247, 11.54, 0.5, 12.49> texture { Material1259 } }
sphere { <-16.96, 1.21, -1.41>, 0.201 texture { Material1260 } }
sphere { <0, 0, 0>, 1 matrix <0.283998899808416, 0.000790391346676947, -1.3752394799427941e-05, -0.001480592240958225, 0.531675919974159, -0.01850740301197781, -1.0895383203772138e-05, 0.007827379093411668, 0.22486380770995285, -16.96, 0.52, -1.41> texture { Material1260 } }
sphere { <13.46, 0.89, -10.42>, 0.149 texture { Material1261 } }
sphere { <0, 0, 0>, 1 matrix <0.21954984079365347, -0.014054448639528505, 0.0005829930705143568, 0.025170239836246507, 0.3918416267750997, -0.03259752372235203, 0.0004398947713881056, 0.013733982075914813, 0.16543030021410393, 13.46, 0.39, -10.42> texture { Material1261 } }
sphere { <-2.89, 1.22, 16.78>, 0.203 texture { Material1262 } }
sphere { <0, 0, 0>, 1 matrix <0.2421017967638572, -0.0208733374112694, 0.00015423691933765278, 0.04604160021580411, 0.5339603581771757, -0.007906133370390605, 0.00014344668218234372, 0.003333556234530367, 0.22597536774144342, -2.89, 0.52, 16.78> texture { Material1262 } }
sphere { <-9.21, 1.22, -14.33>, 0.203 texture { Material1263 } }
sphere { <0, 0, 0>, 1 matrix <0.2508918091192471, 0.007368533062332324, -6.955128048403404e-05, -0.015793907520058926, 0.5376722649362735, -0.010153226262895026, -6.290095884412641e-05, 0.004283982084901805, 0.2269595636693145, -9.21, 0.53, -14.33> texture { Material1263 } }
sphere { <16.47, 1.08, 4.35>, 0.18 texture { Material1264 } }
sphere { <0, 0, 0>, 1 matrix <0.2429776773837446, -0.003292621684048912, -8.328052987589932e-05, 0.006449744533363301, 0.4753476585431771, 0.02406250845139385, -6.888636421833648e-05, -0.010160849156996143, 0.20074300087195468, 16.47, 0.47, 4.35> texture { Material1264 } }
sphere { <-15.09, 1.03, 7.92>, 0.172 texture { Material1265 } }
sphere { <0, 0, 0>, 1 matrix <0.22681789296839736, -0.009084012750447009, 0.00035233751766597377, 0.01820804317820876, 0.4532685876317442, -0.03522860527957782, 0.0002980123497439073, 0.014865697172920751, 0.19142341088853898, -15.09, 0.45, 7.92> texture { Material1265 } }
sphere { <5.78, 0.98, -16.04>, 0.163 texture { Material1266 } }
sphere { <0, 0, 0>, 1 matrix <0.24470308140786595, 0.012057794805681863, 0.00010739608651657294, -0.021261091249202304, 0.4314079590139759, 0.007690181941200834, 7.977994998373989e-05, -0.0032398451696725736, 0.1819711434223463, 5.78, 0.42, -16.04> texture { Material1266 } }
sphere { <6.58, 1.18, 15.74>, 0.197 texture { Material1267 } }
sphere { <0, 0, 0>, 1 matrix <0.27496449626900515, 0.00441877415296064, -1.5050494660864729e-05, -0.008371568486154522, 0.5209206491764798, -0.0035488170756524597, -1.2040395728691784e-05, 0.0014985407996996952, 0.21999489591920196, 6.58, 0.51, 15.74> texture { Material1267 } }
sphere { <-15.49, 1.05, -7.16>, 0.174 texture { Material1268 } }
sphere { <0, 0, 0>, 1 matrix <0.25582892847616356, 0.009349971638056577, -0.00037065496831231693, -0.016873776940555228, 0.46024195051838646, -0.036559850037869664, -0.00028233483914414764, 0.015431105535464467, 0.19438827451518767, -15.49, 0.45, -7.16> texture { Material1268 } }
sphere { <16.26, 1.15, -5.18>, 0.192 texture { Material1269 } }
sphere { <0, 0, 0>, 1 matrix <0.2429463232032064, -0.005104424553731911, 0.00016997652317972314, 0.010712989804128702, 0.5087576656325103, -0.033924467713074224, 0.00015039075096148346, 0.014301491290805799, 0.2145237626219553, 16.26, 0.5, -5.18> texture { Material1269 } }
sphere { <-8.5, 0.9, 14.81>, 0.149 texture { Material1270 } }
sphere { <0, 0, 0>, 1 matrix <0.20362644835326132, -0.012337886425553807, 0.00021468485444751289, 0.023950014826075037, 0.3950353639028904, -0.013764376336824735, 0.00017574691516046397, 0.005804673859216491, 0.16689899602576985, -8.5, 0.39, 14.81> texture { Material1270 } }
sphere { <-3.74, 1.04, -16.67>, 0.173 texture { Material1271 } }
sphere { <0, 0, 0>, 1 matrix <0.2299666505536138, 0.003916577217769994, -7.486610413233272e-06, -0.007816125838940988, 0.4589300920767836, -0.0017546404944561403, -6.314793131161977e-06, 0.0007416127580054275, 0.19399858239337872, -3.74, 0.45, -16.67> texture { Material1271 } }
sphere { <14.02, 0.91, 9.77>, 0.152 texture { Material1272 } }
sphere { <0, 0, 0>, 1 matrix <0.19365377697603478, 0.011574393460737907, -0.0004980752274587371, -0.023984052428951744, 0.39979780193804587, -0.034503373669720054, -0.000436457673546316, 0.014590978915055746, 0.16937211352226672, 14.02, 0.39, 9.77> texture { Material1272 } }
sphere { <-16.94, 0.95, 2.27>, 0.158 texture { Material1273 } }
sphere { <0, 0, 0>, 1 matrix <0.21599108105222514, -0.0019617065528007116, 6.79212176701055e-05, 0.0037871834838791515, 0.41598420895834665, -0.028840858838771993, 5.5343214397863736e-05, 0.012172640660968514, 0.17557854013650856, -16.94, 0.41, 2.27> texture { Material1273 } }
sphere { <10.96, 1.01, -13.12>, 0.169 texture { Material1274 } }
sphere { <0, 0, 0>, 1 matrix <0.2, 0, 0, 0, 0.448, 0, 0, 0, 0.189, 10.96, 0.44, -13.12> texture { Material1274 } }
sphere { <0.78, 0.9, 17.09>, 0.151 texture { Material1275 } }
sphere { <0, 0, 0>, 1 matrix <0.18001093572235158, 0.018896046537385514, -4.9453213882420674e-05, -0.04165482081998244, 0.39681423625194107, -0.002082741040999122, -4.590132559252306e-05, 0.0008769435962101566, 0.16799770493372038, 0.78, 0.39, 17.09> texture { Material1275 } }
sphere { <-12.12, 1.17, -12.08>, 0.195 texture { Material1276 } }
sphere { <0, 0, 0>, 1 matrix <0.2308417112641533, -0.008548642308190912, -0.00015828873584672229, 0.019095668532582297, 0.5152928399333601, 0.019095668532582297, -0.0001493807117514522, -0.008067549883920428, 0.21785061928824856, -12.12, 0.5, -12.08> texture { Material1276 } }
sphere { <17.1, 1.2, 0.72>, 0.2 texture { Material1277 } }
sphere { <0, 0, 0>, 1 matrix <0.27399833442057053, 0.0009544636747588037, -4.163948573728916e-05, -0.0018497088003537401, 0.5289793846867169, -0.0462427200088435, -3.404103943486413e-05, 0.019507286783391607, 0.2231489740141284, 17.1, 0.52, 0.72> texture { Material1277 } }
sphere { <-13.1, 0.89, 11.03>, 0.149 texture { Material1278 } }
sphere { <0, 0, 0>, 1 matrix <0.19095172427540633, -0.004293682547158642, 5.732742295498162e-05, 0.008834645241012285, 0.39276059501850463, -0.010491141223702087, 4.9823833562968325e-05, 0.004431372628841085, 0.165940834197644, -13.1, 0.38, 11.03> texture { Material1278 } }
sphere { <2.21, 1, -16.99>, 0.167 texture { Material1279 } }
sphere { <0, 0, 0>, 1 matrix <0.2058852540598215, 0.021453221981557625, 0.00014638078002343846, -0.04580832906206991, 0.4395786777527768, 0.006015235129362716, 0.0001322377094897729, -0.0025449071701149953, 0.18698263545228921, 2.21, 0.43, -16.99> texture { Material1279 } }
sphere { <9.85, 1.04, 14.02>, 0.174 texture { Material1280 } }
sphere { <0, 0, 0>, 1 matrix <0.2349034815407554, 0.006734230370437825, -6.70920997187813e-05, -0.013210554045837607, 0.4607191712558032, -0.009182946105033458, -5.567216785175469e-05, 0.0038843264435607905, 0.19496130105405426, 9.85, 0.45, 14.02> texture { Material1280 } }
sphere { <-16.74, 0.89, -3.69>, 0.148 texture { Material1281 } }
sphere { <0, 0, 0>, 1 matrix <0.20797569072836605, -0.0031781032138076914, -0.00010828675546018619, 0.005974222868263497, 0.3900475436515913, 0.026612447322264667, -8.590055120639772e-05, -0.011230316644945448, 0.1646173520900806, -16.74, 0.38, -3.69> texture { Material1281 } }
sphere { <14.84, 1.21, -8.59>, 0.202 texture { Material1282 } }
sphere { <0, 0, 0>, 1 matrix <0.28672884058802534, 0.012463922472867546, 0.0004718173768358599, -0.02323414119506668, 0.5329641634790839, 0.04042740567941603, 0.00037153563472092115, -0.0170777452028935, 0.2253535279955856, 14.84, 0.52, -8.59> texture { Material1282 } }
sphere { <-5.14, 0.86, 16.37>, 0.144 texture { Material1283 } }
sphere { <0, 0, 0>, 1 matrix <0.1963183333606818, -0.016372710473858333, 0.0002152631492583843, 0.031664988276852914, 0.37955017997295504, -0.009999469982164078, 0.00017592572096751204, 0.004225497813985345, 0.16094444450916814, -5.14, 0.37, 16.37> texture { Material1283 } }
sphere { <-7.27, 1.19, -15.55>, 0.198 texture { Material1284 } }
sphere { <0, 0, 0>, 1 matrix <0.26569947368466884, -0.01264003341627784, -0.0001387044532297664, 0.02494743437423258, 0.5242805057461513, 0.011514200480415036, -0.00011576085946243662, -0.004868861917432643, 0.22194657191101733, -7.27, 0.51, -15.55> texture { Material1284 } }
sphere { <15.87, 0.84, 6.56>, 0.14 texture { Material1285 } }
sphere { <0, 0, 0>, 1 matrix <0.1929828651961653, 0.002571384789311726, -4.1484261915578796e-05, -0.004929597782618335, 0.3697746059970654, -0.011934815684233865, -3.353132051207405e-05, 0.005031976342541846, 0.15591881890823392, 15.87, 0.36, 6.56> texture { Material1285 } }
sphere { <-16.14, 1.16, 5.88>, 0.194 texture { Material1286 } }
sphere { <0, 0, 0>, 1 matrix <0.23485106265970226, -0.008355166950546585, 0.00041176794082312465, 0.01820359778161639, 0.509195210428556, -0.05032759386682178, 0.00037847606475657417, 0.021231953662565438, 0.2149536249974377, -16.14, 0.5, 5.88> texture { Material1286 } }
sphere { <7.93, 1, -15.24>, 0.167 texture { Material1287 } }
sphere { <0, 0, 0>, 1 matrix <0.255507864857992, 0.015863993686693733, 0.000254361983509775, -0.027452145325020796, 0.4419208742651021, 0.01418874926911187, 0.00018580348014190595, -0.0059893817456521895, 0.1869039667406008, 7.93, 0.43, -15.24> texture { Material1287 } }
sphere { <4.45, 1.15, 16.6>, 0.191 texture { Material1288 } }
sphere { <0, 0, 0>, 1 matrix <0.26439774312911174, 0.01785517764380171, -0.00016142967673293942, -0.03416066062417912, 0.5057649734817309, -0.009156465734316055, -0.00013036207856924163, 0.0038648593040308396, 0.21396505758718762, 4.45, 0.5, 16.6> texture { Material1288 } }
sphere { <-14.5, 0.87, -9.23>, 0.145 texture { Material1289 } }
sphere { <0, 0, 0>, 1 matrix <0.1768030447167558, 0.008342032924573174, -0.0003063748850465374, -0.01809796973466723, 0.3825387640672303, -0.028152397365037905, -0.00028041091173750877, 0.011876792638375367, 0.16156380524840833, -14.5, 0.38, -9.23> texture { Material1289 } }
sphere { <16.94, 1.2, -2.99>, 0.199 texture { Material1290 } }
sphere { <0, 0, 0>, 1 matrix <0.26599526639404286, -0.0015866667374186203, 2.7287846105892897e-05, 0.003143508912103808, 0.5266789658390635, -0.018121404316833716, 2.287665293839893e-05, 0.007668070517369865, 0.22286812282423749, 16.94, 0.52, -2.99> texture { Material1290 } }
sphere { <-10.47, 0.86, 13.65>, 0.143 texture { Material1291 } }
sphere { <0, 0, 0>, 1 matrix <0.20798015346496443, -0.0028732437850483047, 1.532453971099158e-05, 0.005207754360400053, 0.3769425810739595, -0.004021177417524092, 1.1714431798306063e-05, 0.0016959342424040598, 0.15899095467924435, -10.47, 0.37, 13.65> texture { Material1291 } }
sphere { <-1.5, 1.2, -17.15>, 0.2 texture { Material1292 } }
sphere { <0, 0, 0>, 1 matrix <0.24540557123689788, -0.017091013539074953, -5.349858867919081e-05, 0.03675262667549045, 0.527711382587447, 0.0033077364007941404, -4.849668811162419e-05, -0.0013943765923952614, 0.22299563529806996, -1.5, 0.52, -17.15> texture { Material1292 } }
sphere { <12.69, 0.95, 11.64>, 0.159 texture { Material1293 } }
sphere { <0, 0, 0>, 1 matrix <0.23773457505738013, -0.011233360626895107, -0.0002888447904980579, 0.019823577576873717, 0.41897690110912617, 0.02157271677483316, -0.0002160267760867828, -0.009142722823619769, 0.1777649120377879, 12.69, 0.41, 11.64> texture { Material1293 } }
sphere { <-17.22, 0.9, -0.01>, 0.15 texture { Material1294 } }
sphere { <0, 0, 0>, 1 matrix <0.212, 0, 0, 0, 0.39648548984051474, 0.03468798561356795, 0, -0.014642164781606572, 0.16736070927941327, -17.22, 0.39, -0.01> texture { Material1294 } }
sphere { <12.71, 1.19, -11.63>, 0.199 texture { Material1295 } }
sphere { <0, 0, 0>, 1 matrix <0.2979168899873878, -0.0070369368521657726, 9.044324901913046e-05, 0.012420901960534218, 0.5256795750120444, -0.013516863898228412, 6.737718551089585e-05, 0.005704836093929102, 0.22192667776870875, 12.71, 0.51, -11.63> texture { Material1295 } }
sphere { <-1.51, 1.12, 17.17>, 0.187 texture { Material1296 } }
sphere { <0, 0, 0>, 1 matrix <0.2719589059443889, -0.0047279449925317725, 3.6984650050012107e-06, 0.008586782449671674, 0.4939247614072573, -0.0007728104204704506, 2.84183524281343e-06, 0.00032695825481442143, 0.20899974423482814, -1.51, 0.48, 17.17> texture { Material1296 } }
sphere { <-10.48, 1.17, -13.69>, 0.196 texture { Material1297 } }
sphere { <0, 0, 0>, 1 matrix <0.27534203037323846, -0.019039647911748156, -0.0005080524966133695, 0.03573383195030994, 0.5160288536115242, 0.027591946189479827, -0.0004031286114432171, -0.011665320879336066, 0.21868872347724005, -10.48, 0.51, -13.69> texture { Material1297 } }
sphere { <16.98, 1.08, 3.01>, 0.18 texture { Material1298 } }
sphere { <0, 0, 0>, 1 matrix <0.2579713200322568, 0.003843267657085185, -0.00016533157875479588, -0.00710557624972726, 0.4751848709897626, -0.04096155720431009, -0.00012944565468398747, 0.01734640367981266, 0.2012537838729982, 16.98, 0.47, 3.01> texture { Material1298 } }
sphere { <-14.56, 0.88, 9.25>, 0.147 texture { Material1299 } }
sphere { <0, 0, 0>, 1 matrix <0.17492986879114109, -0.004952686486479021, 0.00010909299155829235, 0.011037415598438962, 0.3894655185542838, -0.017169313153127273, 0.00010285910632638991, 0.00726394018016923, 0.16483999694571452, -14.56, 0.38, 9.25> texture { Material1299 } }
sphere { <4.49, 1.1, -16.67>, 0.183 texture { Material1300 } }
sphere { <0, 0, 0>, 1 matrix <0.25696348137607405, 0.0043323369298075235, 9.78849713479158e-06, -0.00817581093757451, 0.48492613215084973, 0.0021914544781127553, 7.807945185339586e-06, -0.0009262848825012677, 0.2049979071487132, 4.49, 0.47, -16.67> texture { Material1300 } }
sphere { <7.95, 1.17, 15.33>, 0.195 texture { Material1301 } }
sphere { <0, 0, 0>, 1 matrix <0.274, 0, 0, 0, 0.517, 0, 0, 0, 0.218, 7.95, 0.51, 15.33> texture { Material1301 } }
sphere { <-16.22, 1.02, -5.93>, 0.17 texture { Material1302 } }
sphere { <0, 0, 0>, 1 matrix <0.244, 0, 0, 0, 0.449, 0, 0, 0, 0.19, -16.22, 0.44, -5.93> texture { Material1302 } }
sphere { <15.97, 0.93, -6.59>, 0.155 texture { Material1303 } }
sphere { <0, 0, 0>, 1 matrix <0.20098215494522917, 0.002677970687314285, 4.320381681363388e-05, -0.005449204035380808, 0.40875084825081015, 0.013192809769869326, 3.7185374670441086e-05, -0.0055803327388444825, 0.17290997225079788, 15.97, 0.4, -6.59> texture { Material1303 } }
sphere { <-7.33, 1, 15.65>, 0.167 texture { Material1304 } }
sphere { <0, 0, 0>, 1 matrix <0.2155662345887055, -0.013680585712577794, 0.0002001994205974728, 0.02799453187481197, 0.4409233102148423, -0.012920553172990137, 0.00017332079468392321, 0.005466387880880443, 0.18692000578706894, -7.33, 0.43, 15.65> texture { Material1304 } }
sphere { <-5.17, 0.85, -16.5>, 0.142 texture { Material1305 } }
sphere { <0, 0, 0>, 1 matrix <0.18259464446426893, 0.01217289723822075, -0.0001280070112834952, -0.024944461553731048, 0.37408651884743405, -0.00787719838538875, -0.00011051971466006689, 0.0033189262530437936, 0.15796509903747577, -5.17, 0.37, -16.5> texture { Material1305 } }
sphere { <14.96, 0.96, 8.68>, 0.16 texture { Material1306 } }
sphere { <0, 0, 0>, 1 matrix <0.1899707601893766, 0.0033328281890028727, -5.029247427230824e-05, -0.007455010422769583, 0.42474110148311567, -0.012822617927163682, -4.7380804709174604e-05, 0.0054005849622642335, 0.1789185050159002, 14.96, 0.42, 8.68> texture { Material1306 } }
sphere { <-16.9, 1.15, 3.71>, 0.191 texture { Material1307 } }
sphere { <0, 0, 0>, 1 matrix <0.270992752327315, -0.0019816765898763525, 3.382247253000994e-05, 0.0037074170888092644, 0.5066911492986815, -0.01730127974777657, 2.6708520743255082e-05, 0.007302709794919498, 0.21387536023653148, -16.9, 0.5, 3.71> texture { Material1307 } }
sphere { <9.96, 0.88, -14.16>, 0.147 texture { Material1308 } }
sphere { <0, 0, 0>, 1 matrix <0.189826442151175, -0.008118299705204399, 0.00012276042965671109, 0.01666387834226166, 0.3894655185542838, -0.011786645656721662, 0.00010596163401947694, 0.0049564356094932115, 0.16392505152715697, 9.96, 0.38, -14.16> texture { Material1308 } }
sphere { <2.22, 1.11, 17.17>, 0.185 texture { Material1309 } }
sphere { <0, 0, 0>, 1 matrix <0.2410947266912058, 0.02091216465600878, -0.0001188742728719642, -0.042169984926166464, 0.4861430126687718, -0.0055374727680824656, -0.00010119049674225054, 0.002337539734067598, 0.20598671235901364, 2.22, 0.48, 17.17> texture { Material1309 } }
sphere { <-13.24, 0.99, -11.17>, 0.166 texture { Material1310 } }
sphere { <0, 0, 0>, 1 matrix <0.228, 0, 0, 0, 0.439, 0, 0, 0, 0.185, -13.24, 0.43, -11.17> texture { Material1310 } }
sphere { <17.31, 1.17, -0.71>, 0.194 texture { Material1311 } }
sphere { <0, 0, 0>, 1 matrix <0.27699892211169647, 0.0007722841486993693, 2.6947207589005476e-05, -0.0014358351501089356, 0.5137454858838095, 0.03589587875272338, 2.111026731701873e-05, -0.015125059590953347, 0.21647224331707451, 17.31, 0.5, -0.71> texture { Material1311 } }
sphere { <-12.29, 1.09, 12.22>, 0.181 texture { Material1312 } }
sphere { <0, 0, 0>, 1 matrix <0.22257570883722963, -0.013743136927716917, 0.00042429116277037176, 0.02958164002378529, 0.47817345508403786, -0.02958164002378529, 0.0003843354927337, 0.01244894017667631, 0.2016156645072663, -12.29, 0.47, 12.22> texture { Material1312 } }
sphere { <0.81, 1.08, -17.32>, 0.18 texture { Material1313 } }
sphere { <0, 0, 0>, 1 matrix <0.21270881885558526, -0.01113365030417537, 1.4559057220736835e-05, 0.024880833543603174, 0.4753476585431771, -0.0012440416771801587, 1.3738828644920674e-05, 0.0005253201199857394, 0.20099931305856777, 0.81, 0.47, -17.32> texture { Material1313 } }
sphere { <11.11, 0.82, 13.32>, 0.137 texture { Material1314 } }
sphere { <0, 0, 0>, 1 matrix <0.20783141131216484, -0.008371668698200599, -0.00014012566261623055, 0.01461017181464816, 0.3625025211159103, 0.012143519430356912, -0.0001030732037513619, -0.005118342900398368, 0.15291432876571315, 11.11, 0.35, 13.32> texture { Material1314 } }
sphere { <-17.2, 1.1, -2.32>, 0.184 texture { Material1315 } }
sphere { <0, 0, 0>, 1 matrix <0.21699103976080025, -0.0019707885275821965, -6.823566775191153e-05, 0.004422921718583086, 0.4858136924765344, 0.03368225001074811, -6.477671685204505e-05, -0.01424752259181542, 0.2055067003870498, -17.2, 0.48, -2.32> texture { Material1315 } }
sphere { <14.25, 0.99, -9.91>, 0.165 texture { Material1316 } }
sphere { <0, 0, 0>, 1 matrix <0.24280715939320996, 0.009675039309668655, 0.0002774198202944303, -0.01739914476677038, 0.4359354899635432, 0.025030348611845107, 0.00021006274458508303, -0.010539094152355833, 0.18369780447270215, 14.25, 0.43, -9.91> texture { Material1316 } }
sphere { <-3.82, 0.96, 16.94>, 0.16 texture { Material1317 } }
sphere { <0, 0, 0>, 1 matrix <0.2211957535155664, -0.018878718975003168, 0.00018054512915856923, 0.03588657390743845, 0.4203941625947166, -0.008056169652690265, 0.00014476140986587982, 0.003398099995684519, 0.17796750254064234, -3.82, 0.41, 16.94> texture { Material1317 } }
sphere { <-8.63, 0.83, -15.08>, 0.138 texture { Material1318 } }
sphere { <0, 0, 0>, 1 matrix <0.177, 0, 0, 0, 0.365, 0, 0, 0, 0.154, -8.63, 0.36, -15.08> texture { Material1318 } }
sphere { <16.55, 0.97, 5.29>, 0.161 texture { Material1319 } }
sphere { <0, 0, 0>, 1 matrix <0.2259500783700603, 0.004747324893594288, -0.0001580851614757919, -0.008948497365801621, 0.4249622854106851, -0.02833690832503847, -0.00012590853568868383, 0.011973341545790902, 0.17960128963698582, 16.55, 0.42, 5.29> texture { Material1319 } }
sphere { <-15.78, 1.19, 7.28>, 0.198 texture { Material1320 } }
sphere { <0, 0, 0>, 1 matrix <0.2549386298977902, 0.0055926116619158745, 0.00013296855478793395, -0.01149226866997615, 0.5232818762113967, 0.024899915451614994, 0.00011523941414954277, -0.010501681898486475, 0.220750314602676, -15.78, 0.51, 7.28> texture { Material1320 } }
sphere { <6.72, 1.18, -16.04>, 0.197 texture { Material1321 } }
sphere { <0, 0, 0>, 1 matrix <0.25486832346237903, 0.008193569409635304, 5.581940181757871e-05, -0.01677271855619462, 0.521682011703968, 0.007110174170560763, 4.815791529359731e-05, -0.002996625129355111, 0.21997958523156033, 6.72, 0.51, -16.04> texture { Material1321 } }
sphere { <5.88, 1.01, 16.37>, 0.169 texture { Material1322 } }
sphere { <0, 0, 0>, 1 matrix <0.22687771596194414, 0.007449835136659644, -4.4230396743612615e-05, -0.014669939674391458, 0.44672769967753584, -0.005306148392864996, -3.6826189359219314e-05, 0.0022435392533590253, 0.18898667988895518, 5.88, 0.44, 16.37> texture { Material1322 } }
sphere { <-15.4, 0.84, -8.1>, 0.14 texture { Material1323 } }
sphere { <0, 0, 0>, 1 matrix <0.18599371263937378, 0.0015292874289028564, -1.1772079470393037e-05, -0.003050352882381504, 0.37094349490302114, -0.005711299013820687, -9.936647725009175e-06, 0.0024169109034227706, 0.1569813952127702, -15.4, 0.36, -8.1> texture { Material1323 } }
sphere { <16.83, 0.9, -4.43>, 0.15 texture { Material1324 } }
sphere { <0, 0, 0>, 1 matrix <0.1829930561929748, -0.0015939445677169764, 2.6941971257801285e-05, 0.0034491915235842774, 0.39575876749956196, -0.013382863111506996, 2.4586389071326858e-05, 0.005643783180862799, 0.16690460481040326, 16.83, 0.39, -4.43> texture { Material1324 } }
sphere { <-9.42, 1.08, 14.64>, 0.179 texture { Material1325 } }
sphere { <0, 0, 0>, 1 matrix <0.2257808443014029, 0.009949396852837855, 0.00014088580624099467, -0.02091134294291142, 0.4743490290084226, 0.013443006177585913, 0.00012467770463804842, -0.005660213127404595, 0.1999198500470184, -9.42, 0.46, 14.64> texture { Material1325 } }
sphere { <-2.94, 0.94, -17.17>, 0.156 texture { Material1326 } }
sphere { <0, 0, 0>, 1 matrix <0.21050073628759852, -0.014506297679866297, -8.573215263459364e-05, 0.028462593551965152, 0.4129915168075672, 0.004887516064478865, -7.110486592916534e-05, -0.002065979012762805, 0.1749877900735273, -2.94, 0.4, -17.17> texture { Material1326 } }
sphere { <13.77, 0.96, 10.68>, 0.159 texture { Material1327 } }
sphere { <0, 0, 0>, 1 matrix <0.24198623290803228, -0.0025812332494451725, -1.7829512548365202e-05, 0.004501158806883731, 0.4219357273559971, 0.005829369602357618, -1.3114269560367793e-05, -0.0024588336237432607, 0.17798301594597918, 13.77, 0.41, 10.68> texture { Material1327 } }
sphere { <-17.37, 0.92, 1.43>, 0.153 texture { Material1328 } }
sphere { <0, 0, 0>, 1 matrix <0.18799708770396723, -0.00104579615482642, 3.6403700409622475e-05, 0.00225291192928032, 0.40401344035522885, -0.028161399116004, 3.311187643641194e-05, 0.011890368515646134, 0.17058610154454487, -17.37, 0.4, 1.43> texture { Material1328 } }
sphere { <11.85, 0.99, -12.79>, 0.165 texture { Material1329 } }
sphere { <0, 0, 0>, 1 matrix <0.222, 0, 0, 0, 0.436, 0, 0, 0, 0.184, 11.85, 0.43, -12.79> texture { Material1329 } }
sphere { <-0.09, 0.99, 17.44>, 0.165 texture { Material1330 } }
sphere { <0, 0, 0>, 1 matrix <0.20487513202571206, -0.007154039130998251, 1.2486797428794e-06, 0.015250317562176761, 0.43673379140734486, -0.0001525031756217676, 1.1268573289399463e-06, 6.45608409382769e-05, 0.1849999887314267, -0.09, 0.43, 17.44> texture { Material1330 } }
sphere { <-11.72, 0.82, -12.93>, 0.137 texture { Material1331 } }
sphere { <0, 0, 0>, 1 matrix <0.18375369553607573, 0.009514706796841708, -0.00022300539301250982, -0.018770861778551848, 0.3621157502443162, -0.016995239718418566, -0.00018543383223322828, 0.007163282856523528, 0.15283210720595097, -11.72, 0.35, -12.93> texture { Material1331 } }
sphere { <17.38, 1.05, 1.62>, 0.175 texture { Material1332 } }
sphere { <0, 0, 0>, 1 matrix <0.26299195869987585, -0.0020546717930497566, -8.934777915720955e-05, 0.0036171598486009022, 0.4612381452164782, 0.04019066498445446, -6.658617762286339e-05, -0.017013758827112473, 0.1952601535819682, 17.38, 0.45, 1.62> texture { Material1332 } }
sphere { <-13.91, 1.08, 10.55>, 0.18 texture { Material1333 } }
sphere { <0, 0, 0>, 1 matrix <0.2636383441066395, 0.013805469651229054, 0.0004822078578140046, -0.024839386683082578, 0.47319248159357913, 0.0331191822441101, 0.0003671355281083898, -0.014014643433823434, 0.20051048596252216, -13.91, 0.46, 10.55> texture { Material1333 } }
sphere { <3.13, 0.95, -17.18>, 0.158 texture { Material1334 } }
sphere { <0, 0, 0>, 1 matrix <0.2059696491178574, 0.0035360445684358968, 5.574651822110686e-06, -0.007192245991139033, 0.4189361842705279, 0.0013210247738826794, 4.789870740357241e-06, -0.0005580462648621343, 0.1769991202278232, 3.13, 0.41, -17.18> texture { Material1334 } }
sphere { <9.3, 0.99, 14.79>, 0.164 texture { Material1335 } }
sphere { <0, 0, 0>, 1 matrix <0.202977737521776, 0.003006306346707203, -1.3881309951448884e-05, -0.006442085028658292, 0.4349337473930302, -0.004016829488457523, -1.2582074044663026e-05, 0.0016990727031636422, 0.18399215470677213, 9.3, 0.43, 14.79> texture { Material1335 } }
sphere { <-16.86, 1.09, -4.63>, 0.182 texture { Material1336 } }
sphere { <0, 0, 0>, 1 matrix <0.22096321055930213, -0.004030028210938049, -0.00013583793488443344, 0.008807708714403065, 0.48182343627549507, 0.032520770637795925, -0.00012538886297024625, -0.013735480766274056, 0.20353702573672525, -16.86, 0.47, -4.63> texture { Material1336 } }
sphere { <15.56, 1.21, -7.98>, 0.202 texture { Material1337 } }
sphere { <0, 0, 0>, 1 matrix <0.30691130111895865, -0.007377248432044509, 0.00017161305244952087, 0.012832086849224, 0.5332681715589425, -0.024827298469150785, 0.00012633403861104795, 0.010507433434509508, 0.22575557109920907, 15.56, 0.52, -7.98> texture { Material1337 } }
sphere { <-6.09, 0.92, 16.4>, 0.153 texture { Material1338 } }
sphere { <0, 0, 0>, 1 matrix <0.23150366961119442, 0.015166304892136306, 0.00018480386817228765, -0.026541033561238537, 0.40501100440548865, 0.00988229973024839, 0.0001362131959373327, -0.004162249393774568, 0.17094928232066164, -6.09, 0.4, 16.4> texture { Material1338 } }
sphere { <-6.59, 1.18, -16.21>, 0.197 texture { Material1339 } }
sphere { <0, 0, 0>, 1 matrix <0.28440507967390344, 0.018403574788912545, -0.00024308572464159974, -0.03364302619306469, 0.5197308701853685, -0.013746612853080193, -0.00018764512077597178, 0.005804711761377433, 0.21992332780011303, -6.59, 0.51, -16.21> texture { Material1339 } }
sphere { <15.81, 1.09, 7.5>, 0.181 texture { Material1340 } }
sphere { <0, 0, 0>, 1 matrix <0.224, 0, 0, 0, 0.479, 0, 0, 0, 0.202, 15.81, 0.47, 7.5> texture { Material1340 } }
sphere { <-16.74, 1.09, 5.15>, 0.182 texture { Material1341 } }
sphere { <0, 0, 0>, 1 matrix <0.2599470374097458, -0.005244711930900468, 0.00017532443670367437, 0.009702717072165865, 0.4798283081749754, -0.03211933927337666, 0.0001368879255801765, 0.01355556314448121, 0.20254685376359668, -16.74, 0.47, 5.15> texture { Material1341 } }
sphere { <8.86, 0.9, -15.11>, 0.15 texture { Material1342 } }
sphere { <0, 0, 0>, 1 matrix <0.198, 0, 0, 0, 0.397, 0, 0, 0, 0.168, 8.86, 0.39, -15.11> texture { Material1342 } }
sphere { <3.67, 1.02, 17.13>, 0.17 texture { Material1343 } }
sphere { <0, 0, 0>, 1 matrix <0.25766194299253314, 0.013202949884209243, -7.244078731433145e-05, -0.023028400960830073, 0.44938329063955823, -0.0049346573487493006, -5.334786662683324e-05, 0.002083521991694149, 0.18998856831429425, 3.67, 0.44, 17.13> texture { Material1343 } }
sphere { <-14.29, 1.18, -10.16>, 0.196 texture { Material1344 } }
sphere { <0, 0, 0>, 1 matrix <0.2837655165824715, 0.011533618827033198, -0.00032746822103115776, -0.021117893626962196, 0.5187333061351086, -0.029492230754895484, -0.00025367256558751663, 0.012477482242455781, 0.21964573314116226, -14.29, 0.51, -10.16> texture { Material1344 } }
sphere { <17.4, 0.96, -2.16>, 0.161 texture { Material1345 } }
sphere { <0, 0, 0>, 1 matrix <0.206, 0, 0, 0, 0.425, 0, 0, 0, 0.18, 17.4, 0.42, -2.16> texture { Material1345 } }
sphere { <-11.38, 1.13, 13.35>, 0.188 texture { Material1346 } }
sphere { <0, 0, 0>, 1 matrix <0.24980212460609985, -0.009943334531861284, 0.000169235534256706, 0.019846895725595122, 0.49831613784253237, -0.01697431871268004, 0.00014283479091265985, 0.007177517531814606, 0.2108778386656668, -11.38, 0.49, 13.35> texture { Material1346 } }
sphere { <-0.63, 0.91, -17.54>, 0.151 texture { Material1347 } }
sphere { <0, 0, 0>, 1 matrix <0.21670308410717104, 0.011347827870824927, -1.1876635713158072e-05, -0.02091765506142844, 0.39945181390182954, -0.0008367062024571376, -9.249545785823568e-06, 0.00035350837053814063, 0.1689996300181686, -0.63, 0.39, -17.54> texture { Material1347 } }
sphere { <12.31, 0.85, 12.51>, 0.142 texture { Material1348 } }
sphere { <0, 0, 0>, 1 matrix <0.215, 0, 0, 0, 0.375, 0, 0, 0, 0.159, 12.31, 0.37, 12.51> texture { Material1348 } }
sphere { <-17.54, 0.9, -0.9>, 0.15 texture { Material1349 } }
sphere { <0, 0, 0>, 1 matrix <0.2199986635687211, 0.0007663638543419772, -2.6728625577988854e-05, -0.0013829384098807498, 0.3960329279531502, -0.027658768197614998, -2.0410950441373305e-05, 0.011704466139041107, 0.16759178099117256, -17.54, 0.39, -0.9> texture { Material1349 } }
sphere { <13.55, 1.12, -11.18>, 0.186 texture { Material1350 } }
sphere { <0, 0, 0>, 1 matrix <0.23386897340638485, -0.007828053847668093, 0.00015764137044325938, 0.016492438234616963, 0.4923243606340049, -0.019842464751023532, 0.00014012566261623055, 0.008371668698200599, 0.20783141131216484, 13.55, 0.48, -11.18> texture { Material1350 } }
sphere { <-2.44, 1.15, 17.4>, 0.192 texture { Material1351 } }
sphere { <0, 0, 0>, 1 matrix <0.2668405396948065, 0.009226368022387651, 2.2549942148582986e-05, -0.017554288222370512, 0.5076905401257007, 0.002482424597102901, 1.815819311590015e-05, -0.001050632457435283, 0.21499743217471087, -2.44, 0.5, 17.4> texture { Material1351 } }
sphere { <-9.96, 1.08, -14.48>, 0.179 texture { Material1352 } }
sphere { <0, 0, 0>, 1 matrix <0.21297812766222052, -0.003052360780614854, -1.5203942114989962e-05, 0.006792577511790802, 0.47392780750412944, 0.004721669733805801, -1.4276001985906069e-05, -0.0019922657104665827, 0.19999007643764397, -9.96, 0.46, -14.48> texture { Material1352 } }
sphere { <17.13, 1.08, 3.95>, 0.18 texture { Material1353 } }
sphere { <0, 0, 0>, 1 matrix <0.2689499206421463, -0.00518569493721617, -0.0002208044414460565, 0.009195451617294102, 0.4751848709897626, 0.040543582130796715, -0.00016498770531842884, -0.017084402533103022, 0.20027255420836876, 17.13, 0.47, 3.95> texture { Material1353 } }
sphere { <-15.31, 0.96, 8.66>, 0.16 texture { Material1354 } }
sphere { <0, 0, 0>, 1 matrix <0.19873746911585413, -0.010207893795060187, 0.00046612626368757696, 0.021800778205530547, 0.4226718055315161, -0.038707504160839956, 0.0004192794030154586, 0.016302689987742005, 0.17825556514158478, -15.31, 0.42, 8.66> texture { Material1354 } }
sphere { <5.44, 0.99, -16.73>, 0.166 texture { Material1355 } }
sphere { <0, 0, 0>, 1 matrix <0.23383653363100204, 0.02335233178208081, 0.00037965744672564214, -0.043624143201419045, 0.43659511206667195, 0.014235246728884113, 0.0002988792665712502, -0.0059989080748144895, 0.1849024709761715, 5.44, 0.43, -16.73> texture { Material1355 } }
sphere { <7.3, 0.86, 16.02>, 0.143 texture { Material1356 } }
sphere { <0, 0, 0>, 1 matrix <0.17943062568576532, 0.01430331282307993, -0.00025653128443540725, -0.030195882626502073, 0.37855398527486334, -0.013604738326226207, -0.00022802780838702865, 0.005728310874200508, 0.15989726219622122, 7.3, 0.37, 16.02> texture { Material1356 } }
sphere { <-16.21, 1.15, -6.88>, 0.192 texture { Material1357 } }
sphere { <0, 0, 0>, 1 matrix <0.24785624533578277, 0.008436032837597076, -0.00033911356687136825, -0.01728026081249724, 0.5060669066306067, -0.04076369217307041, -0.0002926221907680355, 0.017172106545348557, 0.2133097117551113, -16.21, 0.5, -6.88> texture { Material1357 } }
sphere { <16.6, 1.13, -5.87>, 0.188 texture { Material1358 } }
sphere { <0, 0, 0>, 1 matrix <0.23096526419479355, 0.004004615516125946, 9.894441483053556e-05, -0.008633326956842949, 0.49731750830777777, 0.02459190102858294, 8.994946802775959e-05, -0.010370078746992807, 0.20974378030319363, 16.6, 0.49, -5.87> texture { Material1358 } }
sphere { <-8.28, 1.09, 15.55>, 0.182 texture { Material1359 } }
sphere { <0, 0, 0>, 1 matrix <0.23688766882058704, -0.007295804365554003, 5.999506173191228e-05, 0.014837880608426285, 0.48170637862320415, -0.007924777143136765, 5.164131895911435e-05, 0.0033540550564313282, 0.20397241884101047, -8.28, 0.47, 15.55> texture { Material1359 } }
sphere { <-4.4, 0.92, -17.07>, 0.153 texture { Material1360 } }
sphere { <0, 0, 0>, 1 matrix <0.22696758030355912, 0.0038363291479655694, -8.355591866206484e-06, -0.006827651875674405, 0.4039384688431821, -0.0017597040916686613, -6.2943004807106124e-06, 0.0007448252467211413, 0.17099837775760807, -4.4, 0.39, -17.07> texture { Material1360 } }
sphere { <14.78, 1.11, 9.61>, 0.185 texture { Material1361 } }
sphere { <0, 0, 0>, 1 matrix <0.2618922564993292, 0.007511252077121165, -0.00016455371011542993, -0.013990423716164612, 0.487331212960232, -0.021367192584687767, -0.00012938192474724644, 0.009019757525503443, 0.20580239851493148, 14.78, 0.48, 9.61> texture { Material1361 } }
sphere { <-17.4, 0.92, 2.89>, 0.153 texture { Material1362 } }
sphere { <0, 0, 0>, 1 matrix <0.1839885907351535, 0.002047802642516045, 7.059482623771291e-05, -0.004518521048160404, 0.40501100440548865, 0.0279583489854925, 6.560714829700495e-05, -0.011775560779603985, 0.1705940557699123, -17.4, 0.4, 2.89> texture { Material1362 } }
sphere { <10.88, 0.85, -13.89>, 0.142 texture { Material1363 } }
sphere { <0, 0, 0>, 1 matrix <0.1987000149029887, -0.010920103004793104, 0.00023543134195823845, 0.02068783333068844, 0.3760816469479537, -0.016236021094970673, 0.00018810845915256236, 0.00684755266339612, 0.15885237057636128, 10.88, 0.37, -13.89> texture { Material1363 } }
sphere { <1.36, 0.86, 17.6>, 0.143 texture { Material1364 } }
sphere { <0, 0, 0>, 1 matrix <0.21596731136106967, -0.003757714282923788, -2.6150911144265314e-06, 0.006593396820500535, 0.3789422764642723, 0.0005274717456400427, -1.937104529204838e-06, -0.00022267936491400221, 0.15999984503163767, 1.36, 0.37, 17.6> texture { Material1364 } }
sphere { <-12.9, 0.9, -12.06>, 0.15 texture { Material1365 } }
sphere { <0, 0, 0>, 1 matrix <0.22198429165211495, -0.002640828531996971, -1.6863373464841735e-05, 0.004734458359165741, 0.39793938267224377, 0.005082580297339692, -1.2761471811231582e-05, -0.002145410778776553, 0.16798630018467325, -12.9, 0.39, -12.06> texture { Material1365 } }
sphere { <17.66, 1.11, 0.18>, 0.184 texture { Material1366 } }
sphere { <0, 0, 0>, 1 matrix <0.24399986634761223, 0.0002550366988569116, -1.3365238777535423e-05, -0.0005100733977138232, 0.48532668493971737, -0.05100733977138232, -1.128376716464056e-05, 0.02153178687070647, 0.20487162328353592, 17.66, 0.48, 0.18> texture { Material1366 } }
sphere { <-13.15, 0.87, 11.8>, 0.145 texture { Material1367 } }
sphere { <0, 0, 0>, 1 matrix <0.2188647975866943, -0.007692728935314447, 0.00014932803857643987, 0.013488620598907524, 0.38347374134575635, -0.0148978794674501, 0.0001104618367551747, 0.006285042900330511, 0.1618779973743301, -13.15, 0.38, 11.8> texture { Material1367 } }
sphere { <1.72, 0.98, -17.59>, 0.163 texture { Material1368 } }
sphere { <0, 0, 0>, 1 matrix <0.22514851660270743, -0.01959944441459054, 8.514833972925813e-05, 0.03746442472169519, 0.4303561095756341, -0.0037464424721695196, 6.857078686161494e-05, 0.0015783623378121587, 0.18199314292131383, 1.72, 0.42, -17.59> texture { Material1368 } }
sphere { <10.61, 0.84, 14.14>, 0.141 texture { Material1369 } }
sphere { <0, 0, 0>, 1 matrix <0.18592748404835316, 0.005193045109332144, -5.438696373513035e-05, -0.010386090218664289, 0.3717733876511036, -0.0077895676639982165, -4.590727584094336e-05, 0.0032875325893755914, 0.1569655695431193, 10.61, 0.36, 14.14> texture { Material1369 } }
sphere { <-17.38, 1.19, -3.26>, 0.198 texture { Material1370 } }
sphere { <0, 0, 0>, 1 matrix <0.27998747697350274, 0.00264727961767497, -6.818092204078288e-05, -0.004944740143014319, 0.5222832466766422, -0.026921363000855736, -5.381422775361791e-05, 0.011375948801508828, 0.22070701142667476, -17.38, 0.51, -3.26> texture { Material1370 } }
sphere { <15.02, 1.11, -9.34>, 0.185 texture { Material1371 } }
sphere { <0, 0, 0>, 1 matrix <0.265897946640563, 0.007365811856516519, 0.00016367048211595958, -0.013540909766302922, 0.4883298424949866, 0.021716553398787704, 0.0001273676308195625, -0.00919289683752363, 0.20679573115811956, 15.02, 0.48, -9.34> texture { Material1371 } }
sphere { <-4.77, 0.88, 17.04>, 0.146 texture { Material1372 } }
sphere { <0, 0, 0>, 1 matrix <0.2085282061361145, -0.014034587221605024, 0.00013269202421779358, 0.02605464039226196, 0.3870548515008118, -0.007327867610323677, 0.00010412197115654616, 0.0030973461033326883, 0.16397071569561222, -4.77, 0.38, 17.04> texture { Material1372 } }
sphere { <-8, 1.02, -15.79>, 0.17 texture { Material1373 } }
sphere { <0, 0, 0>, 1 matrix <0.20637267727146957, 0.01610023195701773, -0.0003171856492569608, -0.03492272535604329, 0.4472914194431938, -0.017657557764291548, -0.0002911365862745051, 0.0074720177621723696, 0.18985279610806344, -8, 0.44, -15.79> texture { Material1373 } }
sphere { <16.57, 1.13, 6.24>, 0.188 texture { Material1374 } }
sphere { <0, 0, 0>, 1 matrix <0.28391576712905203, -0.006912741683227936, -0.00022622542483159347, 0.012072957305919214, 0.4947917689288728, 0.0324245139073259, -0.00016727936343181207, -0.013728120807537172, 0.20955073542392597, 16.57, 0.49, 6.24> texture { Material1374 } }
sphere { <-16.44, 1.21, 6.59>, 0.201 texture { Material1375 } }
sphere { <0, 0, 0>, 1 matrix <0.24487259759567398, -0.007893567063738538, 0.0003202276649275681, 0.017140317052689397, 0.5299755793848087, -0.043082418537840915, 0.00029408663105592994, 0.018220947689876327, 0.22426080927869727, -16.44, 0.52, 6.59> texture { Material1375 } }
sphere { <7.67, 1.19, -15.97>, 0.199 texture { Material1376 } }
sphere { <0, 0, 0>, 1 matrix <0.2786887009339493, 0.013175198313747647, 0.00014873177600200973, -0.02488648570374555, 0.5262777648156605, 0.011890209836233987, 0.00011834571423815827, -0.005008779096098567, 0.22194345704764176, 7.67, 0.52, -15.97> texture { Material1376 } }
sphere { <5.13, 1.09, 16.97>, 0.182 texture { Material1377 } }
sphere { <0, 0, 0>, 1 matrix <0.2586747316501165, -0.012975883441087833, -9.825814736064534e-05, 0.024098069247734544, 0.48034080621695, 0.0072796250852531445, -7.70131425259112e-05, -0.003072274204379186, 0.20297673561319532, 5.13, 0.47, 16.97> texture { Material1377 } }
sphere { <-15.25, 0.97, -9.05>, 0.162 texture { Material1378 } }
sphere { <0, 0, 0>, 1 matrix <0.19287768033230768, -0.006867159861880674, -0.0002062645376772368, 0.01526430870853269, 0.42795497756146456, 0.025739814684976693, -0.00019343979958331533, -0.010859921813475015, 0.18067380739678107, -15.25, 0.42, -9.05> texture { Material1378 } }
sphere { <17.36, 1.16, -3.63>, 0.194 texture { Material1379 } }
sphere { <0, 0, 0>, 1 matrix <0.22894984062532325, -0.004786446424083502, 0.00024578093591605534, 0.0107224760504578, 0.5101897323239242, -0.05254013264724321, 0.00023290158556237556, 0.022224578527196445, 0.21585878223074437, 17.36, 0.5, -3.63> texture { Material1379 } }
sphere { <-10.35, 0.99, 14.41>, 0.166 texture { Material1380 } }
sphere { <0, 0, 0>, 1 matrix <0.2515942034162404, 0.01429238875044935, 0.0002905703933093372, -0.024898248656536764, 0.4379306180640628, 0.01782837558122385, 0.00021331556651677533, -0.00751309677113078, 0.18484725552027192, -10.35, 0.43, 14.41> texture { Material1380 } }
sphere { <-2.1, 0.98, -17.63>, 0.163 texture { Material1381 } }
sphere { <0, 0, 0>, 1 matrix <0.22586432036287576, -0.007829975513675558, -1.644601662111785e-05, 0.015001678749652728, 0.4327362280992685, 0.0018183853029882097, -1.3316907264002506e-05, -0.0007685092620019454, 0.18299838582942254, -2.1, 0.42, -17.63> texture { Material1381 } }
sphere { <13.46, 1.02, 11.58>, 0.17 texture { Material1382 } }
sphere { <0, 0, 0>, 1 matrix <0.23961418096840614, 0.013595616104823106, -0.0004511114830943389, -0.025435131796106562, 0.4472914194431938, -0.02973953871544767, -0.00035712992411635167, 0.012584660035490105, 0.18958243270411013, 13.46, 0.44, 11.58> texture { Material1382 } }
sphere { <-17.75, 0.87, 0.55>, 0.145 texture { Material1383 } }
sphere { <0, 0, 0>, 1 matrix <0.1789991182709, 0.0005610654250883345, 2.9390969999373004e-05, -0.0012004919430661013, 0.3809018859260487, 0.04001639810220338, 2.6599648826248192e-05, -0.016925996064117356, 0.16111334503912506, -17.75, 0.37, 0.55> texture { Material1383 } }
sphere { <12.72, 0.86, -12.4>, 0.143 texture { Material1384 } }
sphere { <0, 0, 0>, 1 matrix <0.18266162096180763, -0.011118052477086577, 0.0003480470107121429, 0.023025911960742145, 0.3775577905767716, -0.023683795159620488, 0.0003043033973439501, 0.009998435951290971, 0.1596870022198748, 12.72, 0.37, -12.4> texture { Material1384 } }
sphere { <-1, 0.84, 17.75>, 0.14 texture { Material1385 } }
sphere { <0, 0, 0>, 1 matrix <0.19452669370333373, 0.013578093768328489, 2.839837779997697e-05, -0.025833193784871124, 0.3700962626463948, 0.0015499916270922671, 2.286433494664813e-05, -0.0006559263758854068, 0.1569986281399032, -1, 0.36, 17.75> texture { Material1385 } }
sphere { <-11.25, 0.84, -13.77>, 0.14 texture { Material1386 } }
sphere { <0, 0, 0>, 1 matrix <0.16744871826260527, 0.013591295276245117, -0.0004510486942320726, -0.030014110401707962, 0.3689676231816294, -0.024556999419579246, -0.0004215157440144964, 0.010392045576479627, 0.15665512348216995, -11.25, 0.36, -13.77> texture { Material1386 } }
sphere { <17.6, 1.05, 2.55>, 0.175 texture { Material1387 } }
sphere { <0, 0, 0>, 1 matrix <0.222, 0, 0, 0, 0.463, 0, 0, 0, 0.196, 17.6, 0.45, 2.55> texture { Material1387 } }
sphere { <-14.71, 0.82, 10.01>, 0.136 texture { Material1388 } }
sphere { <0, 0, 0>, 1 matrix <0.16387503055409763, -0.006398441489342472, 0.00018522257160531568, 0.014045359366849329, 0.3591230580935367, -0.02081722906158025, 0.00017166970051224375, 0.00878949671488944, 0.15174556097959793, -14.71, 0.35, 10.01> texture { Material1388 } }
sphere { <4.08, 1.16, -17.32>, 0.194 texture { Material1389 } }
sphere { <0, 0, 0>, 1 matrix <0.2539633737961891, -0.004313315967499433, 8.684563790212693e-06, 0.008711539729634682, 0.5129218676152287, -0.0020656228224906975, 7.419489537307693e-06, 0.0008737624804687746, 0.21699824073959426, 4.08, 0.5, -17.32> texture { Material1389 } }
sphere { <8.69, 0.85, 15.54>, 0.141 texture { Material1390 } }
sphere { <0, 0, 0>, 1 matrix <0.21, 0, 0, 0, 0.374, 0, 0, 0, 0.158, 8.69, 0.37, 15.54> texture { Material1390 } }
sphere { <-16.91, 1.04, -5.59>, 0.174 texture { Material1391 } }
sphere { <0, 0, 0>, 1 matrix <0.21394983348609392, -0.004630887224604759, -0.0001537360910025031, 0.009932603906979367, 0.4578818990692593, 0.030438624876227092, -0.00013936823203030655, -0.012865126854004478, 0.19357290380506842, -16.91, 0.45, -5.59> texture { Material1391 } }
sphere { <16.25, 0.85, -7.31>, 0.142 texture { Material1392 } }
sphere { <0, 0, 0>, 1 matrix <0.20991368052421408, -0.006017476476906431, 0.00019158712918341126, 0.010745493708761484, 0.37408651884743405, -0.02384975432920232, 0.00014414650671894753, 0.010048696490703909, 0.15768006507045307, 16.25, 0.37, -7.31> texture { Material1392 } }
sphere { <-7.05, 0.92, 16.37>, 0.153 texture { Material1393 } }
sphere { <0, 0, 0>, 1 matrix <0.19959026473368746, -0.012794314660110462, 0.0001781457679619824, 0.025844515613423134, 0.403015876304969, -0.011236745918879623, 0.00015231463160749495, 0.0047561474062584545, 0.1709337762471272, -7.05, 0.4, 16.37> texture { Material1393 } }
sphere { <-5.86, 1.02, -16.84>, 0.17 texture { Material1394 } }
sphere { <0, 0, 0>, 1 matrix <0.2548617051509205, 0.008396957212689928, -4.855031935768881e-05, -0.01478523054312854, 0.448726481331574, -0.005190559658757893, -3.617474775670931e-05, 0.0021964506351091306, 0.18998730035451095, -5.86, 0.44, -16.84> texture { Material1394 } }
sphere { <15.7, 0.91, 8.46>, 0.152 texture { Material1395 } }
sphere { <0, 0, 0>, 1 matrix <0.21288484318658712, 0.006999789465492013, -0.0002156127570283529, -0.013243733120156252, 0.4020183122547092, -0.02479677690582447, -0.00017208529903671357, 0.01046017884364804, 0.1696777977379738, 15.7, 0.39, 8.46> texture { Material1395 } }
sphere { <-17.3, 1.05, 4.37>, 0.174 texture { Material1396 } }
sphere { <0, 0, 0>, 1 matrix <0.2129979793121083, -0.0009277647810035268, 7.840269019832516e-06, 0.0020123348771062415, 0.46192963516225277, -0.007807859323172216, 7.177711074494556e-06, 0.00329552503900126, 0.19497215048103098, -17.3, 0.45, 4.37> texture { Material1396 } }
sphere { <9.8, 0.84, -14.91>, 0.141 texture { Material1397 } }
sphere { <0, 0, 0>, 1 matrix <0.17731749587162973, 0.01556617994669978, 0.00044687770309957117, -0.032531567079619766, 0.36996214507699765, 0.021300430825941515, 0.000394156176329397, -0.008989697956109726, 0.1567419215512129, 9.8, 0.36, -14.91> texture { Material1397 } }
sphere { <2.84, 1.22, 17.62>, 0.203 texture { Material1398 } }
sphere { <0, 0, 0>, 1 matrix <0.2666434000919357, -0.013794704271166133, -5.763230837402784e-05, 0.027744405219536382, 0.5362640601632062, 0.004483944277904869, -4.89982546850349e-05, -0.001895447581162766, 0.22699208109015193, 2.84, 0.52, 17.62> texture { Material1398 } }
sphere { <-14.01, 1.16, -11.08>, 0.193 texture { Material1399 } }
sphere { <0, 0, 0>, 1 matrix <0.2869323069410378, -0.006232493954087756, -8.516223546861207e-05, 0.01109687947922942, 0.510688712606758, 0.01396059031257895, -6.409422599728295e-05, -0.0059011497211684015, 0.21591936532858405, -14.01, 0.5, -11.08> texture { Material1399 } }
sphere { <17.82, 1.21, -1.29>, 0.202 texture { Material1400 } }
sphere { <0, 0, 0>, 1 matrix <0.2969944891473111, 0.001807544818561798, 7.872646698438662e-05, -0.0032438430582270653, 0.5309717740829004, 0.0463406151175295, 5.9641262866959564e-05, -0.019562173361058418, 0.22414798195904345, 17.82, 0.52, -1.29> texture { Material1400 } }
sphere { <-12.27, 0.99, 12.99>, 0.165 texture { Material1401 } }
sphere { <0, 0, 0>, 1 matrix <0.22892632321459966, -0.0058080710874323935, 6.963970126883589e-05, 0.011083524302218147, 0.43673379140734486, -0.010476207902096605, 5.62591473132517e-05, 0.00443500792194021, 0.1849468235456902, -12.27, 0.43, 12.99> texture { Material1401 } }
sphere { <0.27, 1.13, -17.87>, 0.188 texture { Material1402 } }
sphere { <0, 0, 0>, 1 matrix <0.234, 0, 0, 0, 0.498, 0, 0, 0, 0.21, 0.27, 0.49, -17.87> texture { Material1402 } }
sphere { <11.88, 0.87, 13.37>, 0.146 texture { Material1403 } }
sphere { <0, 0, 0>, 1 matrix <0.20783935033191575, -0.008172176432712406, -0.00014137170791411497, 0.01516567357224514, 0.3854710004152655, 0.013345792743575724, -0.00011078648264423433, -0.005635658593789749, 0.16290250789527308, 11.88, 0.38, 13.37> texture { Material1403 } }
sphere { <-17.79, 1, -1.83>, 0.166 texture { Material1404 } }
sphere { <0, 0, 0>, 1 matrix <0.20799872025068145, 0.0007295296855229436, -1.2669518253489614e-05, -0.0015432358732216116, 0.43973196388840213, -0.015278035144893952, -1.1329473053601292e-05, 0.006458442129432443, 0.18588783821676935, -17.79, 0.43, -1.83> texture { Material1404 } }
sphere { <14.36, 1.17, -10.67>, 0.195 texture { Material1405 } }
sphere { <0, 0, 0>, 1 matrix <0.29359724684603034, 0.0153742730206869, 0.0005370042052928686, -0.02698341795467497, 0.5140364642153407, 0.03597789060623329, 0.00039818679167974615, -0.015199961535191583, 0.21746908427776035, 14.36, 0.5, -10.67> texture { Material1405 } }
sphere { <-3.38, 1.15, 17.58>, 0.192 texture { Material1406 } }
sphere { <0, 0, 0>, 1 matrix <0.2859580188243499, 0.004900143243421798, 8.139207523998436e-06, -0.008720884303852082, 0.5089224768346031, 0.0016907836915631591, 6.118635026782043e-06, -0.0007141817164755976, 0.2149988137340254, -3.38, 0.5, 17.58> texture { Material1406 } }
sphere { <-9.38, 1.12, -15.25>, 0.187 texture { Material1407 } }
sphere { <0, 0, 0>, 1 matrix <0.24089317079024322, -0.007174677374833034, -6.535434008649535e-05, 0.014706600096130784, 0.4936990685474333, 0.008996978882338833, -5.667658538621382e-05, -0.003806414142527968, 0.20896532726541078, -9.38, 0.48, -15.25> texture { Material1407 } }
sphere { <17.22, 1.18, 4.91>, 0.197 texture { Material1408 } }
sphere { <0, 0, 0>, 1 matrix <0.2759230123715286, -0.006512780791139931, -0.00027373379012066076, 0.012294053594869216, 0.5190174377057994, 0.043712190559534986, -0.00021819360082081654, -0.018458122693085787, 0.21922420053041486, 17.22, 0.51, 4.91> texture { Material1408 } }
sphere { <-16.02, 0.84, 8.02>, 0.14 texture { Material1409 } }
sphere { <0, 0, 0>, 1 matrix <0.1929461479911981, 0.004557700248193766, 0.00010650730629708798, -0.008737560061304111, 0.3694929278591923, 0.017280952121245908, 8.608880716241309e-05, -0.007286023056525302, 0.15582973547027879, -16.02, 0.36, 8.02> texture { Material1409 } }
sphere { <6.4, 1.08, -16.74>, 0.18 texture { Material1410 } }
sphere { <0, 0, 0>, 1 matrix <0.22996953489630512, -0.0037433782207505115, 1.1792943365758345e-05, 0.007763440918686929, 0.4769273505895986, -0.003005202936265908, 1.030600702833664e-05, 0.001266343375659219, 0.20099601057792454, 6.4, 0.47, -16.74> texture { Material1410 } }
sphere { <6.59, 1.03, 16.67>, 0.172 texture { Material1411 } }
sphere { <0, 0, 0>, 1 matrix <0.23821481518937174, 0.0193546955461353, -0.00031238535476607663, -0.036846805328416575, 0.4532685876317442, -0.01465948168980014, -0.0002509539251677269, 0.006185979086684895, 0.1919001581157935, 6.59, 0.45, 16.67> texture { Material1411 } }
sphere { <-16.13, 0.87, -7.85>, 0.145 texture { Material1412 } }
sphere { <0, 0, 0>, 1 matrix <0.21397485225162607, 0.0032802374864728634, -5.143857621935904e-05, -0.00588603362058682, 0.38376607757533276, -0.012039614223927587, -3.893948293241199e-05, 0.005079212250719451, 0.16192035105763825, -16.13, 0.38, -7.85> texture { Material1412 } }
sphere { <17.2, 1.07, -5.11>, 0.178 texture { Material1413 } }
sphere { <0, 0, 0>, 1 matrix <0.22898906315197007, -0.002237755728564362, 3.7497764674156545e-05, 0.004592773766049127, 0.469713688698975, -0.015746652912168434, 3.2585393756144776e-05, 0.006667199850045785, 0.19888827864997893, 17.2, 0.46, -5.11> texture { Material1413 } }
sphere { <-9.23, 0.94, 15.39>, 0.157 texture { Material1414 } }
sphere { <0, 0, 0>, 1 matrix <0.23289499166705444, 0.0069942103594977404, 6.22723834909788e-05, -0.012487517208373647, 0.4157465840399438, 0.007405388111942512, 4.7038366928808016e-05, -0.003133048816591063, 0.17597210515449568, -9.23, 0.41, 15.39> texture { Material1414 } }
sphere { <-3.59, 0.95, -17.59>, 0.158 texture { Material1415 } }
sphere { <0, 0, 0>, 1 matrix <0.22896651674535926, 0.003915885953766472, -6.8333172736248085e-06, -0.007164874299686251, 0.4189361842705279, -0.0014622192448339292, -5.281646975683803e-06, 0.0006176916618988197, 0.17699892211286208, -3.59, 0.41, -17.59> texture { Material1415 } }
sphere { <14.53, 1.17, 10.55>, 0.196 texture { Material1416 } }
sphere { <0, 0, 0>, 1 matrix <0.2886187843091594, 0.014829815714157377, -0.0005233639145438541, -0.026580776954787274, 0.5160288536115242, -0.03649225310741982, -0.0003965975684605677, 0.015428191950820349, 0.21845551859245244, 14.53, 0.51, 10.55> texture { Material1416 } }
sphere { <-17.85, 1.04, 2.04>, 0.174 texture { Material1417 } }
sphere { <0, 0, 0>, 1 matrix <0.20598623793226664, -0.0023779069696825356, 0.00012385860960026002, 0.005309889349776537, 0.45748007186940576, -0.04778900414798883, 0.0001166435449633517, 0.02015449305371703, 0.19295020809532984, -17.85, 0.45, 2.04> texture { Material1417 } }
sphere { <11.79, 1.1, -13.56>, 0.183 texture { Material1418 } }
sphere { <0, 0, 0>, 1 matrix <0.2155367756919618, 0.014132662738151629, 0.0004076373910736062, -0.03160220417836684, 0.4811620391783131, 0.027809939676962818, 0.00038499086934729477, -0.0117458130312638, 0.20366120803497437, 11.79, 0.47, -13.56> texture { Material1418 } }
sphere { <0.47, 0.9, 17.97>, 0.149 texture { Material1419 } }
sphere { <0, 0, 0>, 1 matrix <0.196, 0, 0, 0, 0.395, 0, 0, 0, 0.167, 0.47, 0.39, 17.97> texture { Material1419 } }
sphere { <-12.49, 1.2, -12.94>, 0.2 texture { Material1420 } }
sphere { <0, 0, 0>, 1 matrix <0.3017842577643689, -0.011411354819474405, -0.0002067529758131436, 0.020026549848746474, 0.5292736534199242, 0.019192110271715367, -0.00015335320060312638, -0.008111382454460834, 0.22385303651608868, -12.49, 0.52, -12.94> texture { Material1420 } }
sphere { <17.95, 1.03, 1.1>, 0.171 texture { Material1421 } }
sphere { <0, 0, 0>, 1 matrix <0.247, 0, 0, 0, 0.453, 0, 0, 0, 0.191, 17.95, 0.44, 1.1> texture { Material1421 } }
sphere { <-13.99, 1.21, 11.32>, 0.202 texture { Material1422 } }
sphere { <0, 0, 0>, 1 matrix <0.23894251904833094, 0.00524094706245036, 7.11668925426299e-05, -0.011709898457525073, 0.5336747016281972, 0.014497969518840569, 6.699812059452605e-05, -0.0061086950219833855, 0.2249170499459306, -13.99, 0.52, 11.32> texture { Material1422 } }
sphere { <2.67, 0.93, -17.8>, 0.156 texture { Material1423 } }
sphere { <0, 0, 0>, 1 matrix <0.21596784043578723, -0.003727180403404055, 4.8726612443583055e-06, 0.007109251510196623, 0.4119372504044332, -0.001077159319726761, 3.925199335733079e-06, 0.00045491680007877773, 0.1739994052728279, 2.67, 0.4, -17.8> texture { Material1423 } }
sphere { <10.06, 1.15, 14.93>, 0.191 texture { Material1424 } }
sphere { <0, 0, 0>, 1 matrix <0.2349754046288388, -0.0033998447225027273, -1.659446728947073e-05, 0.007320516721644171, 0.505922933749134, 0.004939143812193659, -1.5111557446581857e-05, -0.002088886908714314, 0.21398980425039746, 10.06, 0.49, 14.93> texture { Material1424 } }
sphere { <-17.51, 1.17, -4.22>, 0.195 texture { Material1425 } }
sphere { <0, 0, 0>, 1 matrix <0.23995138648316844, 0.004825980801157236, -0.0002050222231591634, -0.010375858722488057, 0.5140364642153407, -0.04375905635136268, -0.00018622851936957342, 0.01848735326472299, 0.21721460146178917, -17.51, 0.5, -4.22> texture { Material1425 } }
sphere { <15.77, 0.97, -8.72>, 0.161 texture { Material1426 } }
sphere { <0, 0, 0>, 1 matrix <0.1988263618925431, -0.008305207910037042, 0.00031833653033766886, 0.01782072250043124, 0.42537513608517535, -0.032671324584123945, 0.0002879425902551778, 0.013772455328202132, 0.17947210525119883, 15.77, 0.42, -8.72> texture { Material1426 } }
sphere { <-5.74, 0.94, 17.09>, 0.157 texture { Material1427 } }
sphere { <0, 0, 0>, 1 matrix <0.2182515589522224, 0.01808848963452535, 0.00025210645819877454, -0.03419467903513011, 0.4124246050099826, 0.011518207674991196, 0.00020145493235061888, -0.004868807592085651, 0.17493214149647135, -5.74, 0.41, 17.09> texture { Material1427 } }
sphere { <-7.31, 0.82, -16.48>, 0.137 texture { Material1428 } }
sphere { <0, 0, 0>, 1 matrix <0.17679835960475454, 0.008445814793888954, -9.084896928641336e-05, -0.017273361329874583, 0.3615038915811557, -0.007782503456317119, -7.853046497639123e-05, 0.003289290134852263, 0.1529646181421535, -7.31, 0.35, -16.48> texture { Material1428 } }
sphere { <16.53, 1.08, 7.21>, 0.18 texture { Material1429 } }
sphere { <0, 0, 0>, 1 matrix <0.2599937044102801, -0.0018092698399262684, -1.4479856355806169e-05, 0.003319314283249346, 0.4769273505895986, 0.007634422851473495, -1.1194042798142461e-05, -0.0032170209499919763, 0.2009742537015643, 16.53, 0.47, 7.21> texture { Material1429 } }
sphere { <-17.07, 1.22, 5.85>, 0.203 texture { Material1430 } }
sphere { <0, 0, 0>, 1 matrix <0.27389375297161805, 0.007623161601322676, 0.00031542086550896903, -0.014968105625954744, 0.5359527475733591, 0.04443656357705315, 0.0002613158265348028, -0.01874925637916555, 0.2262242186399748, -17.07, 0.53, 5.85> texture { Material1430 } }
sphere { <8.64, 0.99, -15.85>, 0.166 texture { Material1431 } }
sphere { <0, 0, 0>, 1 matrix <0.22657383292029676, -0.013901230182433543, 0.0002324547707472221, 0.02682263797315371, 0.436933054013803, -0.014630529803538385, 0.0001894455180098506, 0.006179561675010505, 0.18489666608108554, 8.64, 0.43, -15.85> texture { Material1431 } }
sphere { <4.34, 1.13, 17.52>, 0.189 texture { Material1432 } }
sphere { <0, 0, 0>, 1 matrix <0.2267068504155046, 0.011532506831209679, -7.25318559576295e-05, -0.025351193430720835, 0.49831613784253237, -0.006272460230281444, -6.741947844519745e-05, 0.0026522827827442576, 0.2109833188919311, 4.34, 0.49, 17.52> texture { Material1432 } }
sphere { <-15.04, 1.14, -9.99>, 0.19 texture { Material1433 } }
sphere { <0, 0, 0>, 1 matrix <0.23098926499726724, -0.0022269246909535105, -1.620009503309062e-05, 0.0048491044136347, 0.5029233906636648, 0.007317739387848729, -1.4937749965577063e-05, -0.0030987643928663605, 0.21297745757732467, -15.04, 0.49, -9.99> texture { Material1433 } }
sphere { <17.85, 1.01, -2.79>, 0.168 texture { Material1434 } }
sphere { <0, 0, 0>, 1 matrix <0.2079971564636439, 0.0010874515278357568, 1.876733995029932e-05, -0.002326518893687076, 0.4447289180234976, 0.015355024698334701, 1.6962788032001308e-05, -0.006487066614127918, 0.18788804559898878, 17.85, 0.44, -2.79> texture { Material1434 } }
sphere { <-11.28, 0.88, 14.12>, 0.147 texture { Material1435 } }
sphere { <0, 0, 0>, 1 matrix <0.217, 0, 0, 0, 0.389, 0, 0, 0, 0.164, -11.28, 0.38, 14.12> texture { Material1435 } }
sphere { <-1.22, 0.87, -18.03>, 0.144 texture { Material1436 } }
sphere { <0, 0, 0>, 1 matrix <0.20287694087459096, -0.007067304094514823, -8.614138778633914e-06, 0.013299064847806217, 0.3817672959212946, 0.0009309345393464354, -6.831903169261379e-06, -0.0003923572273161678, 0.16099952176677815, -1.22, 0.37, -18.03> texture { Material1436 } }
sphere { <13.09, 0.89, 12.48>, 0.148 texture { Material1437 } }
sphere { <0, 0, 0>, 1 matrix <0.19194400680423124, 0.0046362525969953425, -5.8427682541316504e-05, -0.009441535236589473, 0.39076181336446647, -0.009852036768615102, -5.021128968394387e-05, 0.004157509122305606, 0.16494760561076457, 13.09, 0.38, 12.48> texture { Material1437 } }
sphere { <-18.08, 1.07, -0.36>, 0.178 texture { Material1438 } }
sphere { <0, 0, 0>, 1 matrix <0.2529999845929127, -8.829152003412508e-05, -7.703543669134108e-07, 0.00016401981982624026, 0.4699284167235039, 0.008200990991312013, -6.05930905200667e-07, -0.003472334483555512, 0.19896970345473997, -18.08, 0.46, -0.36> texture { Material1438 } }
sphere { <13.58, 1.05, -11.95>, 0.175 texture { Material1439 } }
sphere { <0, 0, 0>, 1 matrix <0.2507331569718345, 0.011566851173572748, 0.00030323071382440907, -0.021290379450958602, 0.4608745912200388, 0.024193613012452955, 0.00023557764619824603, -0.01021158990785352, 0.1947322981293202, 13.58, 0.45, -11.95> texture { Material1439 } }
sphere { <-1.94, 0.97, 17.99>, 0.162 texture { Material1440 } }
sphere { <0, 0, 0>, 1 matrix <0.23086099712627195, 0.008012475729930515, 1.544476374755989e-05, -0.014845626027750043, 0.427739273964173, 0.001649514003083338, 1.2101741291378092e-05, -0.0006975748470983274, 0.18099865536207874, -1.94, 0.42, 17.99> texture { Material1440 } }
sphere { <-10.73, 1.01, -14.58>, 0.168 texture { Material1441 } }
sphere { <0, 0, 0>, 1 matrix <0.253, 0, 0, 0, 0.444, 0, 0, 0, 0.187, -10.73, 0.43, -14.58> texture { Material1441 } }
sphere { <17.77, 1.12, 3.51>, 0.186 texture { Material1442 } }
sphere { <0, 0, 0>, 1 matrix <0.2319884817656563, -0.002311016775496904, -5.940984029906445e-05, 0.004910910647930921, 0.4923243606340049, 0.02532996018406475, -5.3263994750885364e-05, -0.01068687975311454, 0.2077252699218112, 17.77, 0.48, 3.51> texture { Material1442 } }
sphere { <-15.48, 1.08, 9.42>, 0.181 texture { Material1443 } }
sphere { <0, 0, 0>, 1 matrix <0.256829508542548, 0.009355526431719613, 0.0002786879592965355, -0.017400551106466825, 0.47683561602419594, 0.028443208539416932, 0.00021904656722918358, -0.012019933315820545, 0.20164194311126, -15.48, 0.47, 9.42> texture { Material1443 } }
sphere { <5.05, 1.08, -17.4>, 0.18 texture { Material1444 } }
sphere { <0, 0, 0>, 1 matrix <0.24169434897361528, -0.012158689354360711, 8.914821602887398e-05, 0.023865196046782385, 0.4743490290084226, -0.00696068218031153, 7.404459265208128e-05, 0.002945467617352879, 0.2009784036604765, 5.05, 0.46, -17.4> texture { Material1444 } }
sphere { <8.03, 1.17, 16.25>, 0.195 texture { Material1445 } }
sphere { <0, 0, 0>, 1 matrix <0.2579682855059612, 0.0040451740029445625, -1.550486375230846e-05, -0.008106026974892785, 0.5169212583958543, -0.0039629465210586955, -1.310100890698932e-05, 0.0016710296742568581, 0.21799359506231214, 8.03, 0.51, 16.25> texture { Material1445 } }
sphere { <-16.91, 0.9, -6.56>, 0.151 texture { Material1446 } }
sphere { <0, 0, 0>, 1 matrix <0.22788693604321103, -0.007173497682994703, -0.00029208188837150204, 0.012553620945240731, 0.3974816845386065, 0.032430187441871886, -0.00021521823353689624, -0.01365481576499869, 0.16744401956336302, -16.91, 0.39, -6.56> texture { Material1446 } }
sphere { <16.9, 1.2, -6.59>, 0.199 texture { Material1447 } }
sphere { <0, 0, 0>, 1 matrix <0.286948743359581, -0.005422282836405883, 0.00013241298774903097, 0.009975488981262392, 0.527276394350415, -0.025770013201594513, 0.00010288535285029235, 0.010883926030218895, 0.22273421283847009, 16.9, 0.52, -6.59> texture { Material1447 } }
sphere { <-8.02, 1.22, 16.28>, 0.203 texture { Material1448 } }
sphere { <0, 0, 0>, 1 matrix <0.24987708496549113, -0.007838290510369522, 6.0091794648783934e-05, 0.016805294854232256, 0.5356734832822354, -0.00821592192873577, 5.432298236250067e-05, 0.003464176037116202, 0.22597344209751166, -8.02, 0.52, 16.28> texture { Material1448 } }
sphere { <-5.09, 0.86, -17.42>, 0.144 texture { Material1449 } }
sphere { <0, 0, 0>, 1 matrix <0.2, 0, 0, 0, 0.381, 0, 0, 0, 0.161, -5.09, 0.37, -17.42> texture { Material1449 } }
sphere { <15.52, 1.04, 9.42>, 0.174 texture { Material1450 } }
sphere { <0, 0, 0>, 1 matrix <0.2059916002521578, -0.0018602237958376838, -1.3891890662114653e-05, 0.00415389779653075, 0.45992993977194, 0.006869907894262394, -1.3082654312865256e-05, -0.0028973089814932707, 0.19397836330248258, 15.52, 0.45, 9.42> texture { Material1450 } }
sphere { <-17.81, 1.03, 3.55>, 0.171 texture { Material1451 } }
sphere { <0, 0, 0>, 1 matrix <0.23697691642989116, -0.003305795762421751, 0.0001131094935332331, 0.006332621418310021, 0.4528940788179602, -0.0310298449497191, 9.163300741932809e-05, 0.01312275381133495, 0.1915509982636453, -17.81, 0.44, 3.55> texture { Material1451 } }
sphere { <10.74, 1.01, -14.65>, 0.168 texture { Material1452 } }
sphere { <0, 0, 0>, 1 matrix <0.2094778945407078, 0.014794156665170196, 0.0003802990382498594, -0.03127907409207413, 0.44231044595273505, 0.02278352310410338, 0.0003386472388224938, -0.009595763109160656, 0.18675333102357372, 10.74, 0.43, -14.65> texture { Material1452 } }
sphere { <1.98, 0.84, 18.07>, 0.14 texture { Material1453 } }
sphere { <0, 0, 0>, 1 matrix <0.16560056365601947, 0.011508750890650602, -4.438181599783719e-05, -0.025652035117715195, 0.3690986985961349, -0.002850226124190577, -4.17082126244735e-05, 0.0012017169604695405, 0.15599536575415285, 1.98, 0.36, 18.07> texture { Material1453 } }
sphere { <-13.66, 0.89, -11.99>, 0.148 texture { Material1454 } }
sphere { <0, 0, 0>, 1 matrix <0.21049554016464342, -0.014570482334054542, -0.0005732498129052162, 0.02700027769012003, 0.38885806108899484, 0.030682133738772755, -0.0004482759200443635, -0.012947703495901547, 0.16449059554540413, -13.66, 0.38, -11.99> texture { Material1454 } }
sphere { <18.18, 0.98, -0.39>, 0.164 texture { Material1455 } }
sphere { <0, 0, 0>, 1 matrix <0.23499964244464275, -0.0004095500890855403, 1.787776786165128e-05, 0.0007546178237193147, 0.43135230427372584, -0.03773089118596574, 1.3921836249711423e-05, 0.015946311979288058, 0.18230390818751444, 18.18, 0.42, -0.39> texture { Material1455 } }
sphere { <-13.15, 1.19, 12.57>, 0.199 texture { Material1456 } }
sphere { <0, 0, 0>, 1 matrix <0.26492271772459003, -0.00639899446981128, 8.064237434087955e-05, 0.012725547492794507, 0.5266789658390635, -0.013278832166394269, 6.75570079383972e-05, 0.0055937395463748155, 0.22192950573084688, -13.15, 0.51, 12.57> texture { Material1456 } }
sphere { <1.2, 0.92, -18.16>, 0.153 texture { Material1457 } }
sphere { <0, 0, 0>, 1 matrix <0.22996514069655685, -0.004004255044133855, 2.4401512410195635e-06, 0.007050970838583528, 0.4049383165383385, -0.000493567958700847, 1.8141994009319366e-06, 0.00020839536034035762, 0.17099987300604194, 1.2, 0.4, -18.16> texture { Material1457 } }
sphere { <11.38, 1.02, 14.21>, 0.17 texture { Material1458 } }
sphere { <0, 0, 0>, 1 matrix <0.23864766178708885, 0.012969677609213784, -0.0002845808642743966, -0.02447416151362099, 0.4499013866671807, -0.019767591991770802, -0.00022623583352357894, 0.008327810373473287, 0.18981727105753865, 11.38, 0.44, 14.21> texture { Material1458 } }
sphere { <-17.99, 1.21, -2.79>, 0.202 texture { Material1459 } }
sphere { <0, 0, 0>, 1 matrix <0.24597899227402537, -0.0032118741814638457, -0.00013865099143271843, 0.006998229923839925, 0.5339603581771757, 0.046188317497343506, -0.00012737855310485514, -0.019474924914924686, 0.22515930154950795, -17.99, 0.52, -2.79> texture { Material1459 } }
sphere { <15.16, 1.2, -10.1>, 0.2 texture { Material1460 } }
sphere { <0, 0, 0>, 1 matrix <0.29965167324170455, -0.014442936281582388, 0.0005256567443367437, 0.02551585409746222, 0.5279831899886251, -0.038505743456170256, 0.0003924903691047686, 0.016274125536192712, 0.22340769635207827, 15.16, 0.52, -10.1> texture { Material1460 } }
sphere { <-4.35, 1.01, 17.69>, 0.169 texture { Material1461 } }
sphere { <0, 0, 0>, 1 matrix <0.221, 0, 0, 0, 0.447, 0, 0, 0, 0.189, -4.35, 0.44, 17.69> texture { Material1461 } }
sphere { <-8.74, 1.12, -15.99>, 0.186 texture { Material1462 } }
sphere { <0, 0, 0>, 1 matrix <0.21958697463641094, -0.013472557886058941, -0.00022528656195766017, 0.030190777444668443, 0.4917990767780933, 0.016467696788000967, -0.00021299820403269688, -0.006947831504876676, 0.20788381916143672, -8.74, 0.48, -15.99> texture { Material1462 } }
sphere { <17.26, 1.12, 5.89>, 0.187 texture { Material1463 } }
sphere { <0, 0, 0>, 1 matrix <0.22499650800716814, -0.001253505926859294, -1.0366853719611064e-05, 0.0027577130390904468, 0.49492460910241365, 0.008186960584799764, -9.629655232883166e-06, -0.0034567166913599, 0.20897141196102736, 17.26, 0.48, 5.89> texture { Material1463 } }
sphere { <-16.71, 1.08, 7.32>, 0.18 texture { Material1464 } }
sphere { <0, 0, 0>, 1 matrix <0.2249945518935116, -0.0015657142845515784, 1.25306449232938e-05, 0.0033123555530957835, 0.47592750289444224, -0.007618417772120301, 1.1194042798142461e-05, 0.0032170209499919763, 0.2009742537015643, -16.71, 0.47, 7.32> texture { Material1464 } }
sphere { <7.38, 0.83, -16.69>, 0.139 texture { Material1465 } }
sphere { <0, 0, 0>, 1 matrix <0.2073366628214483, -0.016595880002138293, 0.00029157678178095463, 0.029282153657619006, 0.3656034541996706, -0.012871276333019344, 0.00021728077488484602, 0.0054360976338365076, 0.15490449196708359, 7.38, 0.36, -16.69> texture { Material1465 } }
sphere { <5.83, 0.84, 17.29>, 0.14 texture { Material1466 } }
sphere { <0, 0, 0>, 1 matrix <0.2033028220376866, -0.01684955198832498, -0.00023483889256872145, 0.03056046193960904, 0.3685920382939458, 0.010294050337552518, -0.0001795826825525517, -0.004340194196373494, 0.1559395089911402, 5.83, 0.36, 17.29> texture { Material1466 } }
sphere { <-15.99, 0.82, -8.81>, 0.136 texture { Material1467 } }
sphere { <0, 0, 0>, 1 matrix <0.1989374648852342, 0.004987175647469642, -0.00011464771040399537, -0.009047087481088144, 0.36050526204640115, -0.0165863270486616, -8.81462296070919e-05, 0.007029662156357963, 0.15283839857905365, -15.99, 0.35, -8.81> texture { Material1467 } }
sphere { <17.75, 0.98, -4.3>, 0.163 texture { Material1468 } }
sphere { <0, 0, 0>, 1 matrix <0.22499209325805455, -0.0018859878436500702, 3.19564153628082e-05, 0.003621096659808134, 0.4317368372722494, -0.014635265666724543, 2.584918931569374e-05, 0.006165783220703395, 0.18189552619318242, 17.75, 0.42, -4.3> texture { Material1468 } }
sphere { <-10.18, 1.16, 15.16>, 0.193 texture { Material1469 } }
sphere { <0, 0, 0>, 1 matrix <0.2437702107772089, -0.010585853800946461, 0.00015503851176266943, 0.022126169829847112, 0.5093010627248327, -0.014928500126161908, 0.00013724720713416638, 0.00632265887696269, 0.21590739947470464, -10.18, 0.5, 15.16> texture { Material1469 } }
sphere { <-2.74, 1.02, -18.07>, 0.171 texture { Material1470 } }
sphere { <0, 0, 0>, 1 matrix <0.2560439845054139, 0.022146264173166567, -0.00014485083251304323, -0.03894984982984937, 0.450280003537469, -0.005901492398462025, -0.00010765178603109438, 0.002493772230323555, 0.19098368912332864, -2.74, 0.44, -18.07> texture { Material1470 } }
sphere { <14.23, 1.18, 11.48>, 0.197 texture { Material1471 } }
sphere { <0, 0, 0>, 1 matrix <0.2809831031615714, 0.003081444474878148, -2.091989519741546e-05, -0.005724249166855492, 0.5219204968716362, -0.007087165635154419, -1.637856563498719e-05, 0.0029869280454673797, 0.2199797217758805, 14.23, 0.51, 11.48> texture { Material1471 } }
sphere { <-18.25, 1.04, 1.15>, 0.173 texture { Material1472 } }
sphere { <0, 0, 0>, 1 matrix <0.26399769317792643, 0.001102959001488837, 3.8447034559968825e-05, -0.0019176446275885463, 0.4578818990692593, 0.03196074379314245, 2.825274509331042e-05, -0.013508462518234498, 0.19352912091511149, -18.25, 0.45, 1.15> texture { Material1472 } }
sphere { <12.69, 1.11, -13.18>, 0.185 texture { Material1473 } }
sphere { <0, 0, 0>, 1 matrix <0.24850608903086924, -0.015668429149698956, 0.0004733313454169758, 0.030833454953222844, 0.4881354020649553, -0.02954872766350523, 0.00039349232329844976, 0.012482829849684862, 0.20662290319017232, 12.69, 0.48, -13.18> texture { Material1473 } }
sphere { <-0.45, 1.04, 18.29>, 0.173 texture { Material1474 } }
sphere { <0, 0, 0>, 1 matrix <0.24984776764771485, 0.008723129724108132, 3.044647045702909e-06, -0.0159807736545661, 0.45772099877474587, 0.00031961547309132196, 2.350467519282646e-06, -0.00013468512294022956, 0.19299995299064962, -0.45, 0.45, 18.29> texture { Material1474 } }
sphere { <-12.02, 0.95, -13.8>, 0.159 texture { Material1475 } }
sphere { <0, 0, 0>, 1 matrix <0.18993477070199968, 0.004977909542590035, -5.740178224030015e-05, -0.011003800041514814, 0.4197441473480202, -0.009683344036533037, -5.347429187649014e-05, 0.004080837843967494, 0.17695294262314867, -12.02, 0.41, -13.8> texture { Material1475 } }
sphere { <18.19, 1.16, 2.05>, 0.194 texture { Material1476 } }
sphere { <0, 0, 0>, 1 matrix <0.2689875167534961, 0.0025890555113310602, -0.00011234921853517119, -0.004947117222394664, 0.5120440748191573, -0.04452405500155198, -9.063115398562137e-05, 0.018797120496764165, 0.2161843196141294, 18.19, 0.5, 2.05> texture { Material1476 } }
sphere { <-14.81, 0.97, 10.78>, 0.161 texture { Material1477 } }
sphere { <0, 0, 0>, 1 matrix <0.23380240862331617, -0.009610418033830094, 0.0002712695171422264, 0.017495889241075296, 0.4249622854106851, -0.024019780144527103, 0.0002086688593401741, 0.010149202877969199, 0.17971352241344823, -14.81, 0.42, 10.78> texture { Material1477 } }
sphere { <3.64, 0.84, -17.95>, 0.139 texture { Material1478 } }
sphere { <0, 0, 0>, 1 matrix <0.18057672232145727, 0.012370929374227218, 8.638319970259574e-05, -0.025220292481159354, 0.3681011345458751, 0.005146998465542727, 7.445181852820407e-05, -0.002175966830961153, 0.15598480575132076, 3.64, 0.36, -17.95> texture { Material1478 } }
sphere { <9.45, 0.91, 15.7>, 0.151 texture { Material1479 } }
sphere { <0, 0, 0>, 1 matrix <0.208, 0, 0, 0, 0.4, 0, 0, 0, 0.169, 9.45, 0.39, 15.7> texture { Material1479 } }
sphere { <-17.58, 1.18, -5.2>, 0.197 texture { Material1480 } }
sphere { <0, 0, 0>, 1 matrix <0.2499880602095743, -0.002442964769175068, -4.0936424316764785e-05, 0.005100910438037542, 0.521682011703968, 0.017488835787557284, -3.618779909602008e-05, -0.007404277220402605, 0.2208759275459565, -17.58, 0.51, -5.2> texture { Material1480 } }
sphere { <16.48, 1.07, -8.04>, 0.178 texture { Material1481 } }
sphere { <0, 0, 0>, 1 matrix <0.22599336001872727, -0.0017323518641378438, 1.3581779876053148e-05, 0.0036026786555079047, 0.4699284167235039, -0.007369115431720714, 1.1959177855462727e-05, 0.0031201148317285578, 0.19897553804529564, 16.48, 0.46, -8.04> texture { Material1481 } }
sphere { <-6.72, 1.07, 17.07>, 0.179 texture { Material1482 } }
sphere { <0, 0, 0>, 1 matrix <0.2541622505158569, 0.020650407381859838, 0.00033329818186338724, -0.03838546313333946, 0.47219628689548737, 0.015271635870253333, 0.00026141033871638215, -0.006443728215296766, 0.1998959980372849, -6.72, 0.46, 17.07> texture { Material1482 } }
sphere { <-6.58, 1, -17.13>, 0.166 texture { Material1483 } }
sphere { <0, 0, 0>, 1 matrix <0.20089351270392358, -0.006541777611385412, -4.1220888803775263e-05, 0.014320309199052642, 0.43973196388840213, 0.005543345496407474, -3.8144703072150235e-05, -0.002343323323481341, 0.1859852343084882, -6.58, 0.43, -17.13> texture { Material1483 } }
sphere { <16.43, 1, 8.19>, 0.167 texture { Material1484 } }
sphere { <0, 0, 0>, 1 matrix <0.19890130435888323, -0.006263626909213704, -0.0001951980457642684, 0.013880700839011271, 0.43992574616458247, 0.027452941659377846, -0.0001824464146339393, -0.011578791720281811, 0.18563916153550178, 16.43, 0.43, 8.19> texture { Material1484 } }
sphere { <-17.65, 0.89, 5.06>, 0.149 texture { Material1485 } }
sphere { <0, 0, 0>, 1 matrix <0.18997958554970415, 0.002784272872124612, 6.999240101440518e-05, -0.0057737026927215645, 0.3934600366933021, 0.019795552089331075, 6.115125562311191e-05, -0.00834025798687553, 0.16579033855214934, -17.65, 0.39, 5.06> texture { Material1485 } }
sphere { <9.6, 1, -15.66>, 0.167 texture { Material1486 } }
sphere { <0, 0, 0>, 1 matrix <0.2119060257573924, 0.006311334454209973, 5.74901248893652e-05, -0.013158536928117017, 0.44173074554244035, 0.008049928473671588, 5.071062902977026e-05, -0.0034057389696302873, 0.18696897702694648, 9.6, 0.43, -15.66> texture { Material1486 } }
sphere { <3.5, 0.91, 18.04>, 0.152 texture { Material1487 } }
sphere { <0, 0, 0>, 1 matrix <0.17904966291631122, 0.018471173808168775, -0.0001842490264294555, -0.041354905803844544, 0.4007923238334142, -0.008017787859929045, -0.0001740129694055969, 0.00338219339004451, 0.16996626279164587, 3.5, 0.39, 18.04> texture { Material1487 } }
sphere { <-14.77, 0.82, -10.94>, 0.137 texture { Material1488 } }
sphere { <0, 0, 0>, 1 matrix <0.2098963928274458, 0.006594330486610922, -0.00013814289673895762, -0.011398771269713165, 0.3625025211159103, -0.015198361692950892, -0.0001006469676240977, 0.006405921044136326, 0.15286580404316785, -14.77, 0.36, -10.94> texture { Material1488 } }
sphere { <18.28, 1.02, -1.91>, 0.169 texture { Material1489 } }
sphere { <0, 0, 0>, 1 matrix <0.24399062222335507, -0.0021372056046415765, 9.283998878476378e-05, 0.0039240496347517475, 0.446295224745102, -0.0388480913840423, 7.191294213246046e-05, 0.016389038552642843, 0.18828806187288866, 18.28, 0.44, -1.91> texture { Material1489 } }
sphere { <-12.2, 0.96, 13.76>, 0.16 texture { Material1490 } }
sphere { <0, 0, 0>, 1 matrix <0.22298085889307667, -0.002921691903611552, 1.684417409252551e-05, 0.005555145144086539, 0.4239354227463099, -0.004888527726796154, 1.3520659921802987e-05, 0.0020637888280578102, 0.1789881018192688, -12.2, 0.41, 13.76> texture { Material1490 } }
sphere { <-0.3, 1.16, -18.39>, 0.194 texture { Material1491 } }
sphere { <0, 0, 0>, 1 matrix <0.29188549234394384, -0.025531526830226237, -2.229015312112266e-05, 0.04470195653210259, 0.5110478801210655, 0.0008940391306420519, -1.6432331311134795e-05, -0.00037643752869139023, 0.21599967135337375, -0.3, 0.5, -18.39> texture { Material1491 } }
sphere { <12.65, 1.02, 13.36>, 0.17 texture { Material1492 } }
sphere { <0, 0, 0>, 1 matrix <0.24492117549160222, -0.006213875180877451, -7.450535725268469e-05, 0.011413240128142257, 0.4497258721585931, 0.010787857107422135, -5.777966480820445e-05, -0.004554873000911568, 0.1899453863442224, 12.65, 0.44, 13.36> texture { Material1492 } }
sphere { <-18.36, 0.88, -1.31>, 0.147 texture { Material1493 } }
sphere { <0, 0, 0>, 1 matrix <0.221, 0, 0, 0, 0.388, 0, 0, 0, 0.164, -18.36, 0.38, -1.31> texture { Material1493 } }
sphere { <14.42, 1.09, -11.44>, 0.181 texture { Material1494 } }
sphere { <0, 0, 0>, 1 matrix <0.2228816700993189, -0.007262160316264709, 0.00014886664924400182, 0.015598990096371279, 0.4783435471474409, -0.0196245359276929, 0.00013484781680398372, 0.008275900328588657, 0.20183035274660144, 14.42, 0.47, -11.44> texture { Material1494 } }
sphere { <-2.91, 0.93, 18.19>, 0.155 texture { Material1495 } }
sphere { <0, 0, 0>, 1 matrix <0.2109686817050874, 0.0036352873336663307, 5.061542612139239e-06, -0.00706382846826159, 0.4099375550141204, 0.0011416288433554085, 4.149985174881935e-06, -0.00048171168268411135, 0.17299932929532524, -2.91, 0.4, 18.19> texture { Material1495 } }
sphere { <-10.14, 1.05, -15.38>, 0.175 texture { Material1496 } }
sphere { <0, 0, 0>, 1 matrix <0.2237866840571953, -0.00977241309755509, -0.00014135393800312503, 0.020199228857892885, 0.46236547459136773, 0.013385031170892878, -0.00012305365138664902, -0.00563732414324862, 0.19491845842377994, -10.14, 0.45, -15.38> texture { Material1496 } }
sphere { <17.87, 1.06, 4.49>, 0.177 texture { Material1497 } }
sphere { <0, 0, 0>, 1 matrix <0.23199796166240752, 0.000972479623861061, -8.238281103024624e-06, -0.001965917860305334, 0.46892856902834745, -0.007945584685400726, -7.03094680344343e-06, 0.0033544259439431644, 0.19797158325666941, 17.87, 0.46, 4.49> texture { Material1497 } }
sphere { <-16.22, 1, 8.77>, 0.166 texture { Material1498 } }
sphere { <0, 0, 0>, 1 matrix <0.1989374648852342, 0.004987175647469642, 0.00011464771040399537, -0.011051982213739257, 0.4403956248267671, 0.020261967391855307, 0.00010715816148313134, -0.008545863797925367, 0.18580354337061425, -16.22, 0.43, 8.77> texture { Material1498 } }
sphere { <6.04, 1, -17.42>, 0.167 texture { Material1499 } }
sphere { <0, 0, 0>, 1 matrix <0.22272791908386755, 0.011012036002759028, 9.551776842947804e-05, -0.021777165368684896, 0.4403956248267671, 0.007645175076240443, 7.966952882458707e-05, -0.0032244956103871254, 0.1859720309100935, 6.04, 0.43, -17.42> texture { Material1499 } }
sphere { <7.32, 1.04, 16.93>, 0.173 texture { Material1500 } }
sphere { <0, 0, 0>, 1 matrix <0.25119351798603246, 0.020141836319905612, -0.00035064435389893197, -0.0366869161541138, 0.45725336642411124, -0.01595083311048426, -0.0002699404946682254, 0.0067417464562831075, 0.19388263456753554, 7.32, 0.45, 16.93> texture { Material1500 } }
sphere { <-16.84, 1.04, -7.54>, 0.174 texture { Material1501 } }
sphere { <0, 0, 0>, 1 matrix <0.21597779680057475, 0.003096588546198629, -4.9280271895081485e-05, -0.006580250660672087, 0.458720389601765, -0.014604946588320974, -4.4260984942804664e-05, 0.00617289681510734, 0.19390176220415134, -16.84, 0.45, -7.54> texture { Material1501 } }
