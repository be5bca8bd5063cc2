// random.scene, written by `course export`.
// povray +Irandom.pov +Orandom.png +W2560 +H1920 +FN16 -D +AM1 +A0.0 +R2 -J File_Gamma=1.0
// then 8 × 8 of its pixels are one of ours, weighed by our filter
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.3, 0.52, 0.8> }

camera {
  perspective
  location <0.13, 1.5, 0>
  direction <-0.01996583772932904, -0.05490605375565485, -0.998291886466452>
  right <1.300360190139606, 0, -0.026007203802792117>
  up <-0.0010709646975227815, 0.9739937121834464, -0.05354823487613908>
}


#declare Material0 =
  texture { pigment { checker rgb <0.8280000000000001, 0.792, 0.684> rgb <0.045000000000000005, 0.14400000000000002, 0.117> scale 0.5 } finish { ambient 0 diffuse 0 emission 1 } }

#declare Material1 =
  texture { pigment { rgb <0.86, 0.2, 0.05> } finish { ambient 0 diffuse 0 emission 1 } }

#declare Material2 =
  texture { pigment { rgb <0.85, 0.83, 0.8> } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
triangle { <-0.85, 2.08, -4>, <-0.0503, 2.1014, -4>, <-0.0544, 2.164, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-0.0635, 2.2262, -4>, <-0.0774, 2.2875, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-0.096, 2.3474, -4>, <-0.1193, 2.4058, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-0.1471, 2.4621, -4>, <-0.1793, 2.5161, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-0.2156, 2.5673, -4>, <-0.2558, 2.6156, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-0.2996, 2.6606, -4>, <-0.3469, 2.702, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-0.3972, 2.7395, -4>, <-0.4504, 2.773, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-0.506, 2.8022, -4>, <-0.5637, 2.827, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-0.6232, 2.8472, -4>, <-0.6841, 2.8626, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-0.746, 2.8732, -4>, <-0.8085, 2.8789, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-0.8714, 2.8797, -4>, <-0.934, 2.8756, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-0.9962, 2.8665, -4>, <-1.0575, 2.8526, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-1.1174, 2.834, -4>, <-1.1758, 2.8107, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-1.2321, 2.7829, -4>, <-1.2861, 2.7507, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-1.3373, 2.7144, -4>, <-1.3856, 2.6742, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-1.4306, 2.6304, -4>, <-1.472, 2.5831, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-1.5095, 2.5328, -4>, <-1.543, 2.4796, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-1.5722, 2.424, -4>, <-1.597, 2.3663, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-1.6172, 2.3068, -4>, <-1.6326, 2.2459, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-1.6432, 2.184, -4>, <-1.6489, 2.1215, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-1.6497, 2.0586, -4>, <-1.6456, 1.996, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-1.6365, 1.9338, -4>, <-1.6226, 1.8725, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-1.604, 1.8126, -4>, <-1.5807, 1.7542, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-1.5529, 1.6979, -4>, <-1.5207, 1.6439, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-1.4844, 1.5927, -4>, <-1.4442, 1.5444, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-1.4004, 1.4994, -4>, <-1.3531, 1.458, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-1.3028, 1.4205, -4>, <-1.2496, 1.387, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-1.194, 1.3578, -4>, <-1.1363, 1.333, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-1.0768, 1.3128, -4>, <-1.0159, 1.2974, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-0.954, 1.2868, -4>, <-0.8915, 1.2811, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-0.8286, 1.2803, -4>, <-0.766, 1.2844, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-0.7038, 1.2935, -4>, <-0.6425, 1.3074, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-0.5826, 1.326, -4>, <-0.5242, 1.3493, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-0.4679, 1.3771, -4>, <-0.4139, 1.4093, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-0.3627, 1.4456, -4>, <-0.3144, 1.4858, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-0.2694, 1.5296, -4>, <-0.228, 1.5769, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-0.1905, 1.6272, -4>, <-0.157, 1.6804, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-0.1278, 1.736, -4>, <-0.103, 1.7937, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-0.0828, 1.8532, -4>, <-0.0674, 1.9141, -4> texture { Material1 } }
triangle { <-0.85, 2.08, -4>, <-0.0568, 1.976, -4>, <-0.0511, 2.0385, -4> texture { Material1 } }
triangle { <1.585, 0, -3.2>, <1.655, 0, -3.2>, <1.624, 1.9, -3.2> texture { Material2 } }
triangle { <1.615, 0, -3.7>, <1.685, 0, -3.7>, <1.654, 1.9, -3.7> texture { Material2 } }
triangle { <1.645, 0, -4.2>, <1.715, 0, -4.2>, <1.684, 1.9, -4.2> texture { Material2 } }
triangle { <1.675, 0, -4.7>, <1.745, 0, -4.7>, <1.714, 1.9, -4.7> texture { Material2 } }
triangle { <1.705, 0, -5.2>, <1.775, 0, -5.2>, <1.744, 1.9, -5.2> texture { Material2 } }
triangle { <1.735, 0, -5.7>, <1.805, 0, -5.7>, <1.774, 1.9, -5.7> texture { Material2 } }
triangle { <1.765, 0, -6.2>, <1.835, 0, -6.2>, <1.804, 1.9, -6.2> texture { Material2 } }
triangle { <1.795, 0, -6.7>, <1.865, 0, -6.7>, <1.834, 1.9, -6.7> texture { Material2 } }
triangle { <1.825, 0, -7.2>, <1.895, 0, -7.2>, <1.864, 1.9, -7.2> texture { Material2 } }
triangle { <1.855, 0, -7.7>, <1.925, 0, -7.7>, <1.894, 1.9, -7.7> texture { Material2 } }
triangle { <1.885, 0, -8.2>, <1.955, 0, -8.2>, <1.924, 1.9, -8.2> texture { Material2 } }
triangle { <1.915, 0, -8.7>, <1.985, 0, -8.7>, <1.954, 1.9, -8.7> texture { Material2 } }
triangle { <1.945, 0, -9.2>, <2.015, 0, -9.2>, <1.984, 1.9, -9.2> texture { Material2 } }
triangle { <1.975, 0, -9.7>, <2.045, 0, -9.7>, <2.014, 1.9, -9.7> texture { Material2 } }
triangle { <2.005, 0, -10.2>, <2.075, 0, -10.2>, <2.044, 1.9, -10.2> texture { Material2 } }
triangle { <2.035, 0, -10.7>, <2.105, 0, -10.7>, <2.074, 1.9, -10.7> texture { Material2 } }
triangle { <2.065, 0, -11.2>, <2.135, 0, -11.2>, <2.104, 1.9, -11.2> texture { Material2 } }
triangle { <2.095, 0, -11.7>, <2.165, 0, -11.7>, <2.134, 1.9, -11.7> texture { Material2 } }
triangle { <2.125, 0, -12.2>, <2.195, 0, -12.2>, <2.164, 1.9, -12.2> texture { Material2 } }
triangle { <2.155, 0, -12.7>, <2.225, 0, -12.7>, <2.194, 1.9, -12.7> texture { Material2 } }
triangle { <2.185, 0, -13.2>, <2.255, 0, -13.2>, <2.224, 1.9, -13.2> texture { Material2 } }
triangle { <2.215, 0, -13.7>, <2.285, 0, -13.7>, <2.254, 1.9, -13.7> texture { Material2 } }
triangle { <2.245, 0, -14.2>, <2.315, 0, -14.2>, <2.284, 1.9, -14.2> texture { Material2 } }
triangle { <2.275, 0, -14.7>, <2.345, 0, -14.7>, <2.314, 1.9, -14.7> texture { Material2 } }
triangle { <2.305, 0, -15.2>, <2.375, 0, -15.2>, <2.344, 1.9, -15.2> texture { Material2 } }
triangle { <2.335, 0, -15.7>, <2.405, 0, -15.7>, <2.374, 1.9, -15.7> texture { Material2 } }
triangle { <2.365, 0, -16.2>, <2.435, 0, -16.2>, <2.404, 1.9, -16.2> texture { Material2 } }
triangle { <2.395, 0, -16.7>, <2.465, 0, -16.7>, <2.434, 1.9, -16.7> texture { Material2 } }
triangle { <2.425, 0, -17.2>, <2.495, 0, -17.2>, <2.464, 1.9, -17.2> texture { Material2 } }
triangle { <2.455, 0, -17.7>, <2.525, 0, -17.7>, <2.494, 1.9, -17.7> texture { Material2 } }
triangle { <2.485, 0, -18.2>, <2.555, 0, -18.2>, <2.524, 1.9, -18.2> texture { Material2 } }
triangle { <2.515, 0, -18.7>, <2.585, 0, -18.7>, <2.554, 1.9, -18.7> texture { Material2 } }
triangle { <2.545, 0, -19.2>, <2.615, 0, -19.2>, <2.584, 1.9, -19.2> texture { Material2 } }
triangle { <2.575, 0, -19.7>, <2.645, 0, -19.7>, <2.614, 1.9, -19.7> texture { Material2 } }
triangle { <2.605, 0, -20.2>, <2.675, 0, -20.2>, <2.644, 1.9, -20.2> texture { Material2 } }
triangle { <2.635, 0, -20.7>, <2.705, 0, -20.7>, <2.674, 1.9, -20.7> texture { Material2 } }
triangle { <2.665, 0, -21.2>, <2.735, 0, -21.2>, <2.704, 1.9, -21.2> texture { Material2 } }
triangle { <2.695, 0, -21.7>, <2.765, 0, -21.7>, <2.734, 1.9, -21.7> texture { Material2 } }
triangle { <2.725, 0, -22.2>, <2.795, 0, -22.2>, <2.764, 1.9, -22.2> texture { Material2 } }
triangle { <2.755, 0, -22.7>, <2.825, 0, -22.7>, <2.794, 1.9, -22.7> texture { Material2 } }
