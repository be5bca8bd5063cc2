// trapezoid.scene, written by `course export`.
// povray +Itrapezoid.pov +Otrapezoid.png +W320 +H240 +FN16 -D +AM2 +A0.0 +R3 -J File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.16, 0.2, 0.28> }

camera {
  perspective
  location <0.4, 3.1, 6.3>
  direction <-0.049629166698546515, -0.44666250028691856, -0.8933250005738371>
  right <0.8140265711865213, 0, -0.045223698399251194>
  up <-0.015149797649423289, 0.5470760262291742, -0.27269635768961914>
}

light_source { <-51113.630254818665, 76670.445382228, 38846.35899366219> rgb <0.75, 0.72, 0.66> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.055> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.72, 0.7, 0.66> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.07, 0.012, 0.01> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.62, 0.1, 0.06> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.25 } specular 0.25 roughness 0.02 } }

#declare Material2 =
  texture { pigment { rgb <0.07, 0.045, 0.008> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.4, 0.05> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.25 } specular 0.25 roughness 0.02 } }

#declare Material3 =
  texture { pigment { rgb <0.008, 0.03, 0.055> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.05, 0.28, 0.5> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.25 } specular 0.25 roughness 0.02 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0.285, 0.063, -0.371>, 0.063 texture { Material1 } }
sphere { <-0.172, 0.074, -0.639>, 0.074 texture { Material1 } }
sphere { <-0.749, 0.083, -0.309>, 0.083 texture { Material1 } }
sphere { <-0.809, 0.09, 0.469>, 0.09 texture { Material1 } }
sphere { <-0.134, 0.097, 1.037>, 0.097 texture { Material1 } }
sphere { <0.812, 0.103, 0.808>, 0.103 texture { Material1 } }
sphere { <1.226, 0.108, -0.165>, 0.108 texture { Material1 } }
sphere { <0.658, 0.113, -1.148>, 0.113 texture { Material1 } }
sphere { <-0.542, 0.118, -1.294>, 0.118 texture { Material1 } }
sphere { <-1.43, 0.123, -0.377>, 0.123 texture { Material1 } }
sphere { <-1.226, 0.127, 0.95>, 0.127 texture { Material1 } }
sphere { <0.008, 0.131, 1.62>, 0.131 texture { Material1 } }
sphere { <1.343, 0.135, 1.019>, 0.135 texture { Material1 } }
sphere { <1.688, 0.139, -0.462>, 0.139 texture { Material1 } }
sphere { <0.683, 0.142, -1.678>, 0.142 texture { Material1 } }
sphere { <-0.946, 0.146, -1.614>, 0.146 texture { Material1 } }
sphere { <-1.913, 0.149, -0.238>, 0.149 texture { Material1 } }
sphere { <-1.393, 0.153, 1.413>, 0.153 texture { Material1 } }
sphere { <0.282, 0.156, 2.019>, 0.156 texture { Material1 } }
sphere { <1.82, 0.159, 1.031>, 0.159 texture { Material1 } }
sphere { <1.973, 0.162, -0.837>, 0.162 texture { Material1 } }
sphere { <0.549, 0.165, -2.124>, 0.165 texture { Material1 } }
sphere { <-1.382, 0.168, -1.766>, 0.168 texture { Material1 } }
sphere { <-2.291, 0.171, 0.022>, 0.171 texture { Material1 } }
sphere { <-1.405, 0.174, 1.869>, 0.174 texture { Material1 } }
sphere { <0.641, 0.176, 2.297>, 0.176 texture { Material1 } }
sphere { <2.255, 0.179, 0.905>, 0.179 texture { Material1 } }
sphere { <2.129, 0.182, -1.262>, 0.182 texture { Material1 } }
sphere { <0.299, 0.184, -2.501>, 0.184 texture { Material1 } }
sphere { <-0.199, 0.051, -0.182>, 0.051 texture { Material2 } }
sphere { <-0.532, 0.067, 0.094>, 0.067 texture { Material2 } }
sphere { <-0.329, 0.077, 0.634>, 0.077 texture { Material2 } }
sphere { <0.362, 0.086, 0.773>, 0.086 texture { Material2 } }
sphere { <0.951, 0.093, 0.209>, 0.093 texture { Material2 } }
sphere { <0.826, 0.099, -0.696>, 0.099 texture { Material2 } }
sphere { <-0.054, 0.105, -1.176>, 0.105 texture { Material2 } }
sphere { <-1.04, 0.11, -0.723>, 0.11 texture { Material2 } }
sphere { <-1.286, 0.115, 0.41>, 0.115 texture { Material2 } }
sphere { <-0.484, 0.12, 1.344>, 0.12 texture { Material2 } }
sphere { <0.813, 0.124, 1.264>, 0.124 texture { Material2 } }
sphere { <1.569, 0.128, 0.13>, 0.128 texture { Material2 } }
sphere { <1.103, 0.132, -1.216>, 0.132 texture { Material2 } }
sphere { <-0.306, 0.136, -1.68>, 0.136 texture { Material2 } }
sphere { <-1.575, 0.14, -0.808>, 0.14 texture { Material2 } }
sphere { <-1.655, 0.144, 0.784>, 0.144 texture { Material2 } }
sphere { <-0.397, 0.147, 1.848>, 0.147 texture { Material2 } }
sphere { <1.262, 0.15, 1.483>, 0.15 texture { Material2 } }
sphere { <2, 0.154, -0.102>, 0.154 texture { Material2 } }
sphere { <1.166, 0.157, -1.694>, 0.157 texture { Material2 } }
sphere { <-0.651, 0.16, -2.006>, 0.16 texture { Material2 } }
sphere { <-2.036, 0.163, -0.721>, 0.163 texture { Material2 } }
sphere { <-1.853, 0.166, 1.204>, 0.166 texture { Material2 } }
sphere { <-0.176, 0.169, 2.252>, 0.169 texture { Material2 } }
sphere { <1.716, 0.172, 1.542>, 0.172 texture { Material2 } }
sphere { <2.314, 0.174, -0.433>, 0.174 texture { Material2 } }
sphere { <1.085, 0.177, -2.14>, 0.177 texture { Material2 } }
sphere { <-1.058, 0.18, -2.204>, 0.18 texture { Material2 } }
sphere { <-2.436, 0.183, -0.511>, 0.183 texture { Material2 } }
sphere { <-1.921, 0.185, 1.651>, 0.185 texture { Material2 } }
sphere { <0.033, 0.058, 0.38>, 0.058 texture { Material3 } }
sphere { <0.509, 0.071, 0.324>, 0.071 texture { Material3 } }
sphere { <0.717, 0.08, -0.262>, 0.08 texture { Material3 } }
sphere { <0.268, 0.088, -0.854>, 0.088 texture { Material3 } }
sphere { <-0.581, 0.095, -0.826>, 0.095 texture { Material3 } }
sphere { <-1.112, 0.101, -0.046>, 0.101 texture { Material3 } }
sphere { <-0.774, 0.107, 0.927>, 0.107 texture { Material3 } }
sphere { <0.284, 0.112, 1.263>, 0.112 texture { Material3 } }
sphere { <1.25, 0.117, 0.577>, 0.117 texture { Material3 } }
sphere { <1.287, 0.121, -0.676>, 0.121 texture { Material3 } }
sphere { <0.259, 0.126, -1.505>, 0.126 texture { Material3 } }
sphere { <-1.085, 0.13, -1.173>, 0.13 texture { Material3 } }
sphere { <-1.657, 0.134, 0.154>, 0.134 texture { Material3 } }
sphere { <-0.921, 0.137, 1.463>, 0.137 texture { Material3 } }
sphere { <0.623, 0.141, 1.679>, 0.141 texture { Material3 } }
sphere { <1.769, 0.145, 0.545>, 0.145 texture { Material3 } }
sphere { <1.556, 0.148, -1.106>, 0.148 texture { Material3 } }
sphere { <0.072, 0.151, -1.964>, 0.151 texture { Material3 } }
sphere { <-1.558, 0.155, -1.287>, 0.155 texture { Material3 } }
sphere { <-2.021, 0.158, 0.465>, 0.158 texture { Material3 } }
sphere { <-0.882, 0.161, 1.934>, 0.161 texture { Material3 } }
sphere { <1.022, 0.164, 1.922>, 0.164 texture { Material3 } }
sphere { <2.196, 0.167, 0.366>, 0.167 texture { Material3 } }
sphere { <1.662, 0.17, -1.553>, 0.17 texture { Material3 } }
sphere { <-0.226, 0.173, -2.312>, 0.173 texture { Material3 } }
sphere { <-2.011, 0.175, -1.252>, 0.175 texture { Material3 } }
sphere { <-2.26, 0.178, 0.851>, 0.178 texture { Material3 } }
sphere { <-0.713, 0.181, 2.354>, 0.181 texture { Material3 } }
sphere { <1.46, 0.183, 2.034>, 0.183 texture { Material3 } }
sphere { <2.546, 0.186, 0.08>, 0.186 texture { Material3 } }
