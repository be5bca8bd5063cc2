// adaptive.scene, written by `course export`.
// povray +Iadaptive.pov +Oadaptive.png +W2560 +H1920 +FN16 -D +AM1 +A0.0 +R2 -J File_Gamma=1.0
// then 8 × 8 of its pixels are one of ours, weighed by our filter
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.24, 0.44, 0.72> }

camera {
  perspective
  location <0, 1.72, 5.2>
  direction <0, -0.01922721423134318, -0.9998151400298467>
  right <0.9705872913765395, 0, 0>
  up <0, 0.7278059014791184, -0.013996267336136873>
}

light_source { <-51832.105534881615, 60470.78979069521, 60470.78979069521> rgb <0.62, 0.6, 0.55> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb <0.3, 0.3, 0.28> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.5, 0.46> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.07, 0.05, 0.02> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.4, 0.28, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.03, 0.06, 0.02> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.16, 0.36, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

triangle { <0.364, 1.949, 0.004>, <0.489, 2.839, 0.054>, <0.495, 2.839, 0.033> texture { Material0 } }
triangle { <0.327, 1.947, 0.011>, <0.114, 2.817, 0.099>, <0.123, 2.817, 0.119> texture { Material0 } }
triangle { <0.362, 1.944, -0.03>, <0.484, 2.794, -0.3>, <0.464, 2.794, -0.308> texture { Material0 } }
triangle { <0.363, 1.942, 0.036>, <0.474, 2.772, 0.366>, <0.494, 2.772, 0.359> texture { Material0 } }
triangle { <0.311, 1.94, -0.02>, <-0.033, 2.75, -0.209>, <-0.043, 2.75, -0.19> texture { Material0 } }
triangle { <0.396, 1.938, -0.013>, <0.815, 2.728, -0.116>, <0.809, 2.728, -0.137> texture { Material0 } }
triangle { <0.322, 1.936, 0.044>, <0.065, 2.706, 0.432>, <0.083, 2.706, 0.444> texture { Material0 } }
triangle { <0.34, 1.933, -0.054>, <0.262, 2.683, -0.546>, <0.241, 2.683, -0.542> texture { Material0 } }
triangle { <0.397, 1.931, 0.035>, <0.809, 2.661, 0.363>, <0.822, 2.661, 0.345> texture { Material0 } }
triangle { <0.289, 1.929, 0.006>, <-0.263, 2.639, 0.045>, <-0.261, 2.639, 0.067> texture { Material0 } }
triangle { <0.393, 1.927, -0.048>, <0.79, 2.617, -0.468>, <0.774, 2.617, -0.483> texture { Material0 } }
triangle { <0.35, 1.924, 0.067>, <0.342, 2.594, 0.668>, <0.364, 2.594, 0.668> texture { Material0 } }
triangle { <0.303, 1.922, -0.051>, <-0.111, 2.572, -0.516>, <-0.127, 2.572, -0.501> texture { Material0 } }
triangle { <0.421, 1.92, 0.006>, <1.061, 2.55, 0.071>, <1.063, 2.55, 0.049> texture { Material0 } }
triangle { <0.292, 1.918, 0.045>, <-0.238, 2.528, 0.441>, <-0.225, 2.528, 0.458> texture { Material0 } }
triangle { <0.363, 1.916, -0.074>, <0.489, 2.506, -0.742>, <0.468, 2.506, -0.746> texture { Material0 } }
triangle { <0.392, 1.913, 0.065>, <0.759, 2.483, 0.657>, <0.777, 2.483, 0.645> texture { Material0 } }
triangle { <0.273, 1.911, -0.02>, <-0.412, 2.461, -0.213>, <-0.418, 2.461, -0.192> texture { Material0 } }
triangle { <0.422, 1.909, -0.038>, <1.071, 2.439, -0.366>, <1.061, 2.439, -0.385> texture { Material0 } }
triangle { <0.322, 1.907, 0.078>, <0.06, 2.417, 0.771>, <0.081, 2.417, 0.779> texture { Material0 } }
triangle { <0.318, 1.904, -0.077>, <0.037, 2.394, -0.778>, <0.017, 2.394, -0.77> texture { Material0 } }
triangle { <0.427, 1.902, 0.036>, <1.119, 2.372, 0.368>, <1.128, 2.372, 0.348> texture { Material0 } }
triangle { <0.267, 1.9, 0.026>, <-0.479, 2.35, 0.252>, <-0.472, 2.35, 0.273> texture { Material0 } }
triangle { <0.394, 1.898, -0.076>, <0.797, 2.328, -0.756>, <0.778, 2.328, -0.767> texture { Material0 } }
triangle { <0.369, 1.896, 0.087>, <0.534, 2.306, 0.871>, <0.555, 2.306, 0.866> texture { Material0 } }
triangle { <0.276, 1.893, -0.052>, <-0.383, 2.283, -0.524>, <-0.396, 2.283, -0.506> texture { Material0 } }
triangle { <0.44, 1.891, -0.012>, <1.255, 2.261, -0.11>, <1.252, 2.261, -0.132> texture { Material0 } }
triangle { <0.291, 1.889, 0.071>, <-0.249, 2.239, 0.7>, <-0.232, 2.239, 0.714> texture { Material0 } }
triangle { <0.346, 1.887, -0.093>, <0.319, 2.217, -0.93>, <0.297, 2.217, -0.929> texture { Material0 } }
triangle { <0.416, 1.884, 0.066>, <1.007, 2.194, 0.671>, <1.023, 2.194, 0.655> texture { Material0 } }
triangle { <0.255, 1.882, -0.004>, <-0.595, 2.172, -0.051>, <-0.596, 2.172, -0.029> texture { Material0 } }
triangle { <0.423, 1.88, -0.061>, <1.087, 2.15, -0.606>, <1.073, 2.15, -0.622> texture { Material0 } }
triangle { <0.338, 1.878, 0.095>, <0.215, 2.128, 0.951>, <0.237, 2.128, 0.954> texture { Material0 } }
triangle { <0.294, 1.876, -0.079>, <-0.196, 2.106, -0.798>, <-0.214, 2.106, -0.785> texture { Material0 } }
triangle { <0.445, 1.873, 0.021>, <1.297, 2.083, 0.22>, <1.302, 2.083, 0.199> texture { Material0 } }
triangle { <0.265, 1.871, 0.049>, <-0.502, 2.061, 0.48>, <-0.491, 2.061, 0.499> texture { Material0 } }
triangle { <0.379, 1.869, -0.094>, <0.655, 2.039, -0.933>, <0.634, 2.039, -0.94> texture { Material0 } }
triangle { <0.392, 1.867, 0.089>, <0.757, 2.017, 0.898>, <0.777, 2.017, 0.889> texture { Material0 } }
triangle { <0.259, 1.864, -0.038>, <-0.56, 1.994, -0.389>, <-0.569, 1.994, -0.368> texture { Material0 } }
triangle { <0.443, 1.862, -0.034>, <1.286, 1.972, -0.329>, <1.279, 1.972, -0.35> texture { Material0 } }
triangle { <0.304, 1.86, 0.088>, <-0.119, 1.95, 0.877>, <-0.1, 1.95, 0.888> texture { Material0 } }
triangle { <0.324, 1.858, -0.096>, <0.103, 1.928, -0.966>, <0.081, 1.928, -0.96> texture { Material0 } }
triangle { <0.434, 1.856, 0.054>, <1.186, 1.906, 0.546>, <1.198, 1.906, 0.527> texture { Material0 } }
triangle { <0.252, 1.853, 0.017>, <-0.636, 1.883, 0.162>, <-0.632, 1.883, 0.184> texture { Material0 } }
triangle { <0.411, 1.851, -0.079>, <0.968, 1.861, -0.786>, <0.95, 1.861, -0.8> texture { Material0 } }
triangle { <0.359, 1.849, 0.1>, <0.426, 1.839, 0.997>, <0.447, 1.839, 0.995> texture { Material0 } }
triangle { <0.276, 1.847, -0.068>, <-0.379, 1.817, -0.684>, <-0.394, 1.817, -0.668> texture { Material0 } }
triangle { <0.45, 1.844, 0>, <1.348, 1.794, 0.012>, <1.348, 1.794, -0.01> texture { Material0 } }
triangle { <0.276, 1.842, 0.067>, <-0.393, 1.772, 0.665>, <-0.378, 1.772, 0.681> texture { Material0 } }
triangle { <0.359, 1.84, -0.099>, <0.449, 1.75, -0.99>, <0.427, 1.75, -0.992> texture { Material0 } }
triangle { <0.41, 1.838, 0.079>, <0.944, 1.728, 0.795>, <0.962, 1.728, 0.782> texture { Material0 } }
triangle { <0.253, 1.836, -0.017>, <-0.622, 1.706, -0.184>, <-0.626, 1.706, -0.162> texture { Material0 } }
triangle { <0.433, 1.833, -0.053>, <1.188, 1.683, -0.519>, <1.177, 1.683, -0.538> texture { Material0 } }
triangle { <0.324, 1.831, 0.095>, <0.084, 1.661, 0.945>, <0.105, 1.661, 0.951> texture { Material0 } }
triangle { <0.305, 1.829, -0.087>, <-0.09, 1.639, -0.873>, <-0.109, 1.639, -0.863> texture { Material0 } }
triangle { <0.441, 1.827, 0.033>, <1.259, 1.617, 0.345>, <1.267, 1.617, 0.324> texture { Material0 } }
triangle { <0.261, 1.824, 0.037>, <-0.548, 1.594, 0.358>, <-0.54, 1.594, 0.378> texture { Material0 } }
triangle { <0.391, 1.822, -0.087>, <0.768, 1.572, -0.865>, <0.748, 1.572, -0.874> texture { Material0 } }
triangle { <0.378, 1.82, 0.091>, <0.624, 1.55, 0.914>, <0.645, 1.55, 0.907> texture { Material0 } }
triangle { <0.268, 1.818, -0.048>, <-0.463, 1.528, -0.485>, <-0.474, 1.528, -0.466> texture { Material0 } }
triangle { <0.442, 1.816, -0.02>, <1.269, 1.506, -0.19>, <1.265, 1.506, -0.211> texture { Material0 } }
triangle { <0.296, 1.813, 0.076>, <-0.195, 1.483, 0.754>, <-0.177, 1.483, 0.767> texture { Material0 } }
triangle { <0.338, 1.811, -0.091>, <0.243, 1.461, -0.915>, <0.222, 1.461, -0.912> texture { Material0 } }
triangle { <0.42, 1.809, 0.059>, <1.039, 1.439, 0.597>, <1.054, 1.439, 0.58> texture { Material0 } }
triangle { <0.26, 1.807, 0.004>, <-0.551, 1.417, 0.025>, <-0.55, 1.417, 0.047> texture { Material0 } }
triangle { <0.413, 1.804, -0.063>, <0.989, 1.394, -0.62>, <0.974, 1.394, -0.635> texture { Material0 } }
triangle { <0.346, 1.802, 0.088>, <0.298, 1.372, 0.877>, <0.32, 1.372, 0.878> texture { Material0 } }
triangle { <0.295, 1.8, -0.067>, <-0.196, 1.35, -0.672>, <-0.213, 1.35, -0.658> texture { Material0 } }
triangle { <0.435, 1.798, 0.011>, <1.194, 1.328, 0.125>, <1.197, 1.328, 0.104> texture { Material0 } }
triangle { <0.281, 1.796, 0.048>, <-0.345, 1.306, 0.469>, <-0.333, 1.306, 0.487> texture { Material0 } }
triangle { <0.368, 1.793, -0.08>, <0.542, 1.283, -0.801>, <0.521, 1.283, -0.806> texture { Material0 } }
triangle { <0.39, 1.791, 0.07>, <0.742, 1.261, 0.707>, <0.761, 1.261, 0.696> texture { Material0 } }
triangle { <0.275, 1.789, -0.024>, <-0.401, 1.239, -0.252>, <-0.407, 1.239, -0.231> texture { Material0 } }
triangle { <0.42, 1.787, -0.032>, <1.057, 1.217, -0.314>, <1.048, 1.217, -0.334> texture { Material0 } }
triangle { <0.321, 1.784, 0.07>, <0.048, 1.194, 0.692>, <0.068, 1.194, 0.701> texture { Material0 } }
triangle { <0.325, 1.782, -0.069>, <0.112, 1.172, -0.696>, <0.091, 1.172, -0.688> texture { Material0 } }
triangle { <0.413, 1.78, 0.033>, <0.977, 1.15, 0.343>, <0.987, 1.15, 0.323> texture { Material0 } }
triangle { <0.283, 1.778, 0.018>, <-0.322, 1.128, 0.165>, <-0.316, 1.128, 0.186> texture { Material0 } }
triangle { <0.386, 1.776, -0.056>, <0.721, 1.106, -0.555>, <0.702, 1.106, -0.567> texture { Material0 } }
triangle { <0.361, 1.773, 0.063>, <0.447, 1.083, 0.635>, <0.469, 1.083, 0.631> texture { Material0 } }
triangle { <0.301, 1.771, -0.038>, <-0.129, 1.061, -0.385>, <-0.142, 1.061, -0.368> texture { Material0 } }
triangle { <0.408, 1.769, -0.005>, <0.934, 1.039, -0.037>, <0.932, 1.039, -0.059> texture { Material0 } }
triangle { <0.312, 1.767, 0.041>, <-0.034, 1.017, 0.398>, <-0.018, 1.017, 0.413> texture { Material0 } }
triangle { <0.35, 1.764, -0.052>, <0.364, 0.994, -0.518>, <0.342, 0.994, -0.518> texture { Material0 } }
triangle { <0.382, 1.762, 0.036>, <0.663, 0.972, 0.363>, <0.68, 0.972, 0.348> texture { Material0 } }
triangle { <0.307, 1.76, -0.004>, <-0.083, 0.95, -0.052>, <-0.085, 0.95, -0.03> texture { Material0 } }
triangle { <0.381, 1.758, -0.023>, <0.665, 0.928, -0.225>, <0.652, 0.928, -0.242> texture { Material0 } }
triangle { <0.344, 1.756, 0.032>, <0.28, 0.906, 0.321>, <0.302, 0.906, 0.325> texture { Material0 } }
triangle { <0.336, 1.753, -0.022>, <0.223, 0.883, -0.223>, <0.205, 0.883, -0.211> texture { Material0 } }
triangle { <0.364, 1.751, 0.004>, <0.49, 0.861, 0.05>, <0.496, 0.861, 0.029> texture { Material0 } }
sphere { <0.492, 2.839, 0.044>, 0.05 texture { Material0 } }
sphere { <0.119, 2.817, 0.109>, 0.05 texture { Material0 } }
sphere { <0.474, 2.794, -0.304>, 0.05 texture { Material0 } }
sphere { <0.484, 2.772, 0.363>, 0.05 texture { Material0 } }
sphere { <-0.038, 2.75, -0.199>, 0.05 texture { Material0 } }
sphere { <0.812, 2.728, -0.126>, 0.05 texture { Material0 } }
sphere { <0.074, 2.706, 0.438>, 0.05 texture { Material0 } }
sphere { <0.252, 2.683, -0.544>, 0.05 texture { Material0 } }
sphere { <0.816, 2.661, 0.354>, 0.05 texture { Material0 } }
sphere { <-0.262, 2.639, 0.056>, 0.05 texture { Material0 } }
sphere { <0.782, 2.617, -0.475>, 0.05 texture { Material0 } }
sphere { <0.353, 2.594, 0.668>, 0.05 texture { Material0 } }
sphere { <-0.119, 2.572, -0.508>, 0.05 texture { Material0 } }
sphere { <1.062, 2.55, 0.06>, 0.05 texture { Material0 } }
sphere { <-0.232, 2.528, 0.45>, 0.05 texture { Material0 } }
sphere { <0.479, 2.506, -0.744>, 0.05 texture { Material0 } }
sphere { <0.768, 2.483, 0.651>, 0.05 texture { Material0 } }
sphere { <-0.415, 2.461, -0.202>, 0.05 texture { Material0 } }
sphere { <1.066, 2.439, -0.375>, 0.05 texture { Material0 } }
sphere { <0.07, 2.417, 0.775>, 0.05 texture { Material0 } }
sphere { <0.027, 2.394, -0.774>, 0.05 texture { Material0 } }
sphere { <1.124, 2.372, 0.358>, 0.05 texture { Material0 } }
sphere { <-0.475, 2.35, 0.262>, 0.05 texture { Material0 } }
sphere { <0.787, 2.328, -0.762>, 0.05 texture { Material0 } }
sphere { <0.545, 2.306, 0.869>, 0.05 texture { Material0 } }
sphere { <-0.389, 2.283, -0.515>, 0.05 texture { Material0 } }
sphere { <1.254, 2.261, -0.121>, 0.05 texture { Material0 } }
sphere { <-0.241, 2.239, 0.707>, 0.05 texture { Material0 } }
sphere { <0.308, 2.217, -0.929>, 0.05 texture { Material0 } }
sphere { <1.015, 2.194, 0.663>, 0.05 texture { Material0 } }
sphere { <-0.596, 2.172, -0.04>, 0.05 texture { Material0 } }
sphere { <1.08, 2.15, -0.614>, 0.05 texture { Material0 } }
sphere { <0.226, 2.128, 0.953>, 0.05 texture { Material0 } }
sphere { <-0.205, 2.106, -0.791>, 0.05 texture { Material0 } }
sphere { <1.3, 2.083, 0.21>, 0.05 texture { Material0 } }
sphere { <-0.496, 2.061, 0.489>, 0.05 texture { Material0 } }
sphere { <0.645, 2.039, -0.937>, 0.05 texture { Material0 } }
sphere { <0.767, 2.017, 0.893>, 0.05 texture { Material0 } }
sphere { <-0.564, 1.994, -0.378>, 0.05 texture { Material0 } }
sphere { <1.283, 1.972, -0.34>, 0.05 texture { Material0 } }
sphere { <-0.109, 1.95, 0.883>, 0.05 texture { Material0 } }
sphere { <0.092, 1.928, -0.963>, 0.05 texture { Material0 } }
sphere { <1.192, 1.906, 0.537>, 0.05 texture { Material0 } }
sphere { <-0.634, 1.883, 0.173>, 0.05 texture { Material0 } }
sphere { <0.959, 1.861, -0.793>, 0.05 texture { Material0 } }
sphere { <0.436, 1.839, 0.996>, 0.05 texture { Material0 } }
sphere { <-0.386, 1.817, -0.676>, 0.05 texture { Material0 } }
sphere { <1.348, 1.794, 0.001>, 0.05 texture { Material0 } }
sphere { <-0.386, 1.772, 0.673>, 0.05 texture { Material0 } }
sphere { <0.438, 1.75, -0.991>, 0.05 texture { Material0 } }
sphere { <0.953, 1.728, 0.788>, 0.05 texture { Material0 } }
sphere { <-0.624, 1.706, -0.173>, 0.05 texture { Material0 } }
sphere { <1.182, 1.683, -0.528>, 0.05 texture { Material0 } }
sphere { <0.094, 1.661, 0.948>, 0.05 texture { Material0 } }
sphere { <-0.1, 1.639, -0.868>, 0.05 texture { Material0 } }
sphere { <1.263, 1.617, 0.334>, 0.05 texture { Material0 } }
sphere { <-0.544, 1.594, 0.368>, 0.05 texture { Material0 } }
sphere { <0.758, 1.572, -0.87>, 0.05 texture { Material0 } }
sphere { <0.635, 1.55, 0.91>, 0.05 texture { Material0 } }
sphere { <-0.469, 1.528, -0.475>, 0.05 texture { Material0 } }
sphere { <1.267, 1.506, -0.201>, 0.05 texture { Material0 } }
sphere { <-0.186, 1.483, 0.761>, 0.05 texture { Material0 } }
sphere { <0.232, 1.461, -0.914>, 0.05 texture { Material0 } }
sphere { <1.046, 1.439, 0.588>, 0.05 texture { Material0 } }
sphere { <-0.55, 1.417, 0.036>, 0.05 texture { Material0 } }
sphere { <0.982, 1.394, -0.627>, 0.05 texture { Material0 } }
sphere { <0.309, 1.372, 0.878>, 0.05 texture { Material0 } }
sphere { <-0.204, 1.35, -0.665>, 0.05 texture { Material0 } }
sphere { <1.195, 1.328, 0.115>, 0.05 texture { Material0 } }
sphere { <-0.339, 1.306, 0.478>, 0.05 texture { Material0 } }
sphere { <0.532, 1.283, -0.804>, 0.05 texture { Material0 } }
sphere { <0.751, 1.261, 0.702>, 0.05 texture { Material0 } }
sphere { <-0.404, 1.239, -0.241>, 0.05 texture { Material0 } }
sphere { <1.053, 1.217, -0.324>, 0.05 texture { Material0 } }
sphere { <0.058, 1.194, 0.696>, 0.05 texture { Material0 } }
sphere { <0.102, 1.172, -0.692>, 0.05 texture { Material0 } }
sphere { <0.982, 1.15, 0.333>, 0.05 texture { Material0 } }
sphere { <-0.319, 1.128, 0.176>, 0.05 texture { Material0 } }
sphere { <0.712, 1.106, -0.561>, 0.05 texture { Material0 } }
sphere { <0.458, 1.083, 0.633>, 0.05 texture { Material0 } }
sphere { <-0.136, 1.061, -0.377>, 0.05 texture { Material0 } }
sphere { <0.933, 1.039, -0.048>, 0.05 texture { Material0 } }
sphere { <-0.026, 1.017, 0.405>, 0.05 texture { Material0 } }
sphere { <0.353, 0.994, -0.518>, 0.05 texture { Material0 } }
sphere { <0.672, 0.972, 0.355>, 0.05 texture { Material0 } }
sphere { <-0.084, 0.95, -0.041>, 0.05 texture { Material0 } }
sphere { <0.658, 0.928, -0.233>, 0.05 texture { Material0 } }
sphere { <0.291, 0.906, 0.323>, 0.05 texture { Material0 } }
sphere { <0.214, 0.883, -0.217>, 0.05 texture { Material0 } }
sphere { <0.493, 0.861, 0.039>, 0.05 texture { Material0 } }
sphere { <0.35, 1.85, 0>, 0.13 texture { Material1 } }
polygon { 5, <-0.285, -0.6, 0>, <-0.215, -0.6, 0>, <0.37, 1.75, 0>, <0.33, 1.75, 0>, <-0.285, -0.6, 0> texture { Material2 } }
