// balls.scene, written by `course export`.
// povray +Iballs.pov +Oballs.png +W240 +H180 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.62, 0.7, 0.78> }

camera {
  perspective
  location <0, 3.4, 7.5>
  direction <0, -0.3275432154795235, -0.9448361984986255>
  right <0.9705872913765395, 0, 0>
  up <0, 0.6877845050214655, -0.23843196174077466>
}

light_source { <41959.06791483446, 75526.32224670202, 50350.88149780135> rgb <0.8, 0.74, 0.62> parallel point_at 0 }
light_source { <-80812.20356417686, 30304.57633656632, 50507.62722761053> rgb <0.14, 0.17, 0.24> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb <0.08, 0.08, 0.09> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.48, 0.45> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.09, 0.03, 0.02> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.62, 0.2, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.1, 0.08, 0.02> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.52, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb <0.03, 0.05, 0.09> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.3, 0.55> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material4 =
  texture { pigment { rgb <0.04, 0.08, 0.04> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.46, 0.22> transmit 0.5 } finish { ambient 0 diffuse 2 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-0.851, 0.317, -1.975>, 0.082 texture { Material1 } }
sphere { <-0.161, 0.94, 0.983>, 0.08 texture { Material1 } }
sphere { <-1.317, 0.172, 0.622>, 0.09 texture { Material1 } }
sphere { <-0.47, 0.841, 0.524>, 0.081 texture { Material1 } }
sphere { <-0.201, 1.07, -0.941>, 0.091 texture { Material1 } }
sphere { <0.105, 0.839, 0.676>, 0.08 texture { Material1 } }
sphere { <-1.546, 0.607, 0.296>, 0.08 texture { Material1 } }
sphere { <-0.965, 0.115, -2.193>, 0.082 texture { Material1 } }
sphere { <-0.421, 0.161, 1.662>, 0.087 texture { Material1 } }
sphere { <0.029, 0.096, 2.422>, 0.08 texture { Material1 } }
sphere { <1.315, 0.171, -2.083>, 0.162 texture { Material1 } }
sphere { <1.735, 0.225, -1.935>, 0.225 texture { Material1 } }
sphere { <1.194, 0.77, -0.497>, 0.087 texture { Material1 } }
sphere { <1.593, 0.195, 1.202>, 0.081 texture { Material1 } }
sphere { <1.953, 0.344, 0.723>, 0.15 texture { Material1 } }
sphere { <1.733, 0.505, -0.151>, 0.288 texture { Material1 } }
sphere { <-0.184, 0.368, -0.547>, 0.08 texture { Material1 } }
sphere { <0.046, 0.532, 1.379>, 0.097 texture { Material1 } }
sphere { <-0.77, 0.083, 1.366>, 0.082 texture { Material1 } }
sphere { <-0.265, 1.244, 0.26>, 0.161 texture { Material1 } }
sphere { <0.433, 0.558, -0.317>, 0.114 texture { Material1 } }
sphere { <1.273, 0.608, 1.104>, 0.082 texture { Material1 } }
sphere { <1.642, 0.122, 1.474>, 0.106 texture { Material1 } }
sphere { <0.276, 0.514, 1.337>, 0.105 texture { Material1 } }
sphere { <-0.535, 0.749, -1.281>, 0.144 texture { Material1 } }
sphere { <2.523, 0.196, 0.17>, 0.195 texture { Material1 } }
sphere { <-0.15, 0.165, -1.269>, 0.08 texture { Material1 } }
sphere { <0.69, 0.15, 1.733>, 0.094 texture { Material1 } }
sphere { <-2.514, 0.101, -0.262>, 0.096 texture { Material1 } }
sphere { <0.561, 0.14, 1.14>, 0.083 texture { Material1 } }
sphere { <1.405, 0.209, -1.724>, 0.106 texture { Material1 } }
sphere { <0.259, 0.562, -1.162>, 0.082 texture { Material1 } }
sphere { <0.494, 0.22, 1.885>, 0.089 texture { Material1 } }
sphere { <-1.956, 0.192, -1.097>, 0.081 texture { Material1 } }
sphere { <-1.555, 0.154, -1.849>, 0.096 texture { Material1 } }
sphere { <-2.039, 0.219, -1.368>, 0.137 texture { Material1 } }
sphere { <0.652, 0.62, -1.123>, 0.08 texture { Material1 } }
sphere { <-1.578, 0.392, -0.56>, 0.081 texture { Material1 } }
sphere { <0.122, 0.303, 0.99>, 0.081 texture { Material2 } }
sphere { <0.815, 0.425, -2.218>, 0.316 texture { Material2 } }
sphere { <0.521, 0.561, 1.048>, 0.101 texture { Material2 } }
sphere { <-1.696, 0.762, 1.408>, 0.535 texture { Material2 } }
sphere { <-0.204, 0.686, -1.179>, 0.153 texture { Material2 } }
sphere { <-0.493, 0.697, -0.138>, 0.133 texture { Material2 } }
sphere { <-0.93, 0.538, 1.578>, 0.08 texture { Material2 } }
sphere { <-0.791, 0.378, 1.013>, 0.146 texture { Material2 } }
sphere { <-0.363, 0.252, 0.307>, 0.085 texture { Material2 } }
sphere { <-1.057, 0.638, 1.102>, 0.109 texture { Material2 } }
sphere { <-2.291, 0.164, -0.495>, 0.08 texture { Material2 } }
sphere { <-1.708, 0.198, -1.648>, 0.098 texture { Material2 } }
sphere { <-0.127, 0.573, 1.761>, 0.11 texture { Material2 } }
sphere { <-0.061, 0.214, -2.094>, 0.081 texture { Material2 } }
sphere { <0.381, 0.157, -2.404>, 0.118 texture { Material2 } }
sphere { <-0.643, 0.781, 1.27>, 0.08 texture { Material2 } }
sphere { <1.571, 0.349, -1.411>, 0.136 texture { Material2 } }
sphere { <1.147, 0.671, -0.761>, 0.132 texture { Material2 } }
sphere { <0.703, 1.291, 0.435>, 0.42 texture { Material2 } }
sphere { <-1.258, 0.499, 0.601>, 0.087 texture { Material2 } }
sphere { <0.738, 1.176, -0.194>, 0.08 texture { Material2 } }
sphere { <-0.22, 0.533, -1.824>, 0.081 texture { Material2 } }
sphere { <-1.561, 0.296, -1.558>, 0.08 texture { Material2 } }
sphere { <2.216, 0.111, 1.053>, 0.101 texture { Material2 } }
sphere { <1.376, 0.789, 0.417>, 0.092 texture { Material2 } }
sphere { <-1.102, 0.208, 2.043>, 0.08 texture { Material2 } }
sphere { <-1.86, 0.348, 0.966>, 0.08 texture { Material2 } }
sphere { <-1.118, 0.196, 1.243>, 0.094 texture { Material2 } }
sphere { <2.055, 0.129, -1.429>, 0.081 texture { Material2 } }
sphere { <0.152, 0.111, -2.544>, 0.081 texture { Material2 } }
sphere { <1.429, 0.118, 2.049>, 0.083 texture { Material2 } }
sphere { <-2.48, 0.08, 0.607>, 0.08 texture { Material2 } }
sphere { <-0.726, 0.187, -2.416>, 0.175 texture { Material2 } }
sphere { <-0.361, 0.253, -1.437>, 0.144 texture { Material2 } }
sphere { <-1.079, 0.328, -1.793>, 0.187 texture { Material2 } }
sphere { <1.246, 0.151, -0.166>, 0.114 texture { Material2 } }
sphere { <0.327, 1.151, -0.293>, 0.08 texture { Material2 } }
sphere { <2.507, 0.089, -0.643>, 0.084 texture { Material2 } }
sphere { <1.295, 0.332, 1.383>, 0.24 texture { Material3 } }
sphere { <0.358, 1.198, -1.268>, 0.527 texture { Material3 } }
sphere { <-1.958, 0.223, 0.51>, 0.082 texture { Material3 } }
sphere { <1.468, 0.217, 1.815>, 0.08 texture { Material3 } }
sphere { <-1.309, 0.609, -0.845>, 0.143 texture { Material3 } }
sphere { <0.118, 1.597, 0.078>, 0.088 texture { Material3 } }
sphere { <-2.1, 0.205, 0.343>, 0.119 texture { Material3 } }
sphere { <-0.3, 0.593, 0.409>, 0.081 texture { Material3 } }
sphere { <-0.913, 0.903, -0.204>, 0.08 texture { Material3 } }
sphere { <-0.419, 0.356, -2.081>, 0.081 texture { Material3 } }
sphere { <1.378, 0.148, -0.337>, 0.084 texture { Material3 } }
sphere { <0.065, 0.414, -0.858>, 0.084 texture { Material3 } }
sphere { <0.55, 0.421, 1.495>, 0.126 texture { Material3 } }
sphere { <-0.25, 0.731, -0.048>, 0.082 texture { Material3 } }
sphere { <-1.966, 0.484, 0.009>, 0.322 texture { Material3 } }
sphere { <1.29, 0.23, -0.573>, 0.081 texture { Material3 } }
sphere { <-1.358, 0.313, -1.29>, 0.08 texture { Material3 } }
sphere { <-0.602, 0.902, -0.851>, 0.08 texture { Material3 } }
sphere { <-1.273, 0.202, -0.165>, 0.08 texture { Material3 } }
sphere { <1.009, 0.299, -1.731>, 0.094 texture { Material3 } }
sphere { <-2.381, 0.172, 0.811>, 0.145 texture { Material3 } }
sphere { <0.598, 0.084, -2.124>, 0.08 texture { Material3 } }
sphere { <0.982, 0.822, -0.027>, 0.196 texture { Material3 } }
sphere { <-2.21, 0.127, -1.03>, 0.081 texture { Material3 } }
sphere { <-0.692, 0.147, -1.55>, 0.107 texture { Material3 } }
sphere { <0.219, 1.21, 0.777>, 0.119 texture { Material3 } }
sphere { <0.663, 0.303, -0.523>, 0.08 texture { Material3 } }
sphere { <0.836, 0.619, -1.299>, 0.08 texture { Material3 } }
sphere { <0.873, 0.23, -1.006>, 0.087 texture { Material3 } }
sphere { <-1.65, 0.131, -0.442>, 0.087 texture { Material3 } }
sphere { <0.434, 0.53, 1.637>, 0.08 texture { Material3 } }
sphere { <-0.296, 0.528, -0.764>, 0.102 texture { Material3 } }
sphere { <2.391, 0.125, -0.13>, 0.106 texture { Material3 } }
sphere { <1.059, 0.438, -1.291>, 0.193 texture { Material3 } }
sphere { <1.701, 0.158, 1.761>, 0.086 texture { Material3 } }
sphere { <1.907, 0.171, 0.356>, 0.083 texture { Material3 } }
sphere { <0.003, 1.173, 0.546>, 0.08 texture { Material3 } }
sphere { <-2.163, 0.167, 0.992>, 0.084 texture { Material4 } }
sphere { <0.061, 0.282, -1.952>, 0.111 texture { Material4 } }
sphere { <-1.26, 0.274, 0.072>, 0.08 texture { Material4 } }
sphere { <0.898, 0.668, 1.41>, 0.172 texture { Material4 } }
sphere { <-0.296, 0.738, 1.012>, 0.087 texture { Material4 } }
sphere { <-0.429, 0.54, 1.278>, 0.08 texture { Material4 } }
sphere { <-2.481, 0.134, -0.021>, 0.08 texture { Material4 } }
sphere { <0.103, 0.082, -2.011>, 0.08 texture { Material4 } }
sphere { <1.502, 0.139, -1.197>, 0.086 texture { Material4 } }
sphere { <1.515, 0.429, -0.827>, 0.12 texture { Material4 } }
sphere { <2.176, 0.105, 0.421>, 0.08 texture { Material4 } }
sphere { <0.445, 0.446, 0.01>, 0.103 texture { Material4 } }
sphere { <-0.431, 1.152, -0.213>, 0.081 texture { Material4 } }
sphere { <2.154, 0.125, -1.289>, 0.08 texture { Material4 } }
sphere { <1.834, 0.296, -1.121>, 0.192 texture { Material4 } }
sphere { <-0.907, 0.217, 0.783>, 0.08 texture { Material4 } }
sphere { <1.001, 0.395, 1.942>, 0.286 texture { Material4 } }
sphere { <1.377, 0.141, 1.043>, 0.085 texture { Material4 } }
sphere { <2.178, 0.269, -0.81>, 0.167 texture { Material4 } }
sphere { <-0.098, 0.28, -2.452>, 0.23 texture { Material4 } }
sphere { <2.159, 0.226, 0.854>, 0.117 texture { Material4 } }
sphere { <-0.603, 0.392, 2.083>, 0.136 texture { Material4 } }
sphere { <-0.327, 0.157, -1.832>, 0.08 texture { Material4 } }
sphere { <-0.124, 0.674, -1.522>, 0.087 texture { Material4 } }
sphere { <0.225, 0.799, 0.88>, 0.157 texture { Material4 } }
sphere { <0.293, 0.656, 1.524>, 0.08 texture { Material4 } }
sphere { <0.383, 0.819, 0.685>, 0.087 texture { Material4 } }
sphere { <-1.093, 0.534, -1.1>, 0.16 texture { Material4 } }
sphere { <0.853, 0.314, 0.515>, 0.085 texture { Material4 } }
sphere { <-0.67, 0.151, 2.367>, 0.102 texture { Material4 } }
sphere { <-1.718, 0.206, 0.879>, 0.08 texture { Material4 } }
sphere { <-1.024, 0.21, 1.584>, 0.192 texture { Material4 } }
sphere { <1.761, 0.283, -0.604>, 0.117 texture { Material4 } }
sphere { <1.054, 0.224, -1.885>, 0.083 texture { Material4 } }
sphere { <0.028, 0.303, -1.458>, 0.179 texture { Material4 } }
sphere { <-0.815, 0.19, 0.284>, 0.085 texture { Material4 } }
sphere { <-1.132, 0.111, -2.26>, 0.08 texture { Material4 } }
