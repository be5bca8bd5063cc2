// filters.scene, written by `course export`.
// povray +Ifilters.pov +Ofilters.png +W1280 +H960 +FN16 -D -A File_Gamma=1.0
// then 4 × 4 of its pixels are one of ours, weighed by our filter
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.78, 0.74, 0.62> }

camera {
  orthographic
  location <0.033713, 0.021319, 5>
  direction <0, 0, -1>
  right <3.2, 0, 0>
  up <0, 2.4, 0>
}


#declare Material0 =
  texture { pigment { rgb <0.04, 0.09, 0.2> } finish { ambient 0 diffuse 0 emission 1 } }

triangle { <0, 0, 0>, <1.0999, 0.0148, 0>, <1.0978, 0.0687, 0> texture { Material0 } }
triangle { <0, 0, 0>, <1.0932, 0.1225, 0>, <1.0858, 0.176, 0> texture { Material0 } }
triangle { <0, 0, 0>, <1.0759, 0.2291, 0>, <1.0633, 0.2816, 0> texture { Material0 } }
triangle { <0, 0, 0>, <1.0482, 0.3334, 0>, <1.0306, 0.3845, 0> texture { Material0 } }
triangle { <0, 0, 0>, <1.0105, 0.4346, 0>, <0.988, 0.4836, 0> texture { Material0 } }
triangle { <0, 0, 0>, <0.9631, 0.5315, 0>, <0.9358, 0.5782, 0> texture { Material0 } }
triangle { <0, 0, 0>, <0.9063, 0.6234, 0>, <0.8746, 0.6671, 0> texture { Material0 } }
triangle { <0, 0, 0>, <0.8408, 0.7092, 0>, <0.805, 0.7496, 0> texture { Material0 } }
triangle { <0, 0, 0>, <0.7673, 0.7882, 0>, <0.7277, 0.8249, 0> texture { Material0 } }
triangle { <0, 0, 0>, <0.6863, 0.8596, 0>, <0.6433, 0.8923, 0> texture { Material0 } }
triangle { <0, 0, 0>, <0.5988, 0.9228, 0>, <0.5528, 0.951, 0> texture { Material0 } }
triangle { <0, 0, 0>, <0.5054, 0.977, 0>, <0.4569, 1.0006, 0> texture { Material0 } }
triangle { <0, 0, 0>, <0.4072, 1.0218, 0>, <0.3566, 1.0406, 0> texture { Material0 } }
triangle { <0, 0, 0>, <0.3051, 1.0568, 0>, <0.2529, 1.0705, 0> texture { Material0 } }
triangle { <0, 0, 0>, <0.2001, 1.0817, 0>, <0.1468, 1.0902, 0> texture { Material0 } }
triangle { <0, 0, 0>, <0.0931, 1.0961, 0>, <0.0392, 1.0993, 0> texture { Material0 } }
triangle { <0, 0, 0>, <-0.0148, 1.0999, 0>, <-0.0687, 1.0978, 0> texture { Material0 } }
triangle { <0, 0, 0>, <-0.1225, 1.0932, 0>, <-0.176, 1.0858, 0> texture { Material0 } }
triangle { <0, 0, 0>, <-0.2291, 1.0759, 0>, <-0.2816, 1.0633, 0> texture { Material0 } }
triangle { <0, 0, 0>, <-0.3334, 1.0482, 0>, <-0.3845, 1.0306, 0> texture { Material0 } }
triangle { <0, 0, 0>, <-0.4346, 1.0105, 0>, <-0.4836, 0.988, 0> texture { Material0 } }
triangle { <0, 0, 0>, <-0.5315, 0.9631, 0>, <-0.5782, 0.9358, 0> texture { Material0 } }
triangle { <0, 0, 0>, <-0.6234, 0.9063, 0>, <-0.6671, 0.8746, 0> texture { Material0 } }
triangle { <0, 0, 0>, <-0.7092, 0.8408, 0>, <-0.7496, 0.805, 0> texture { Material0 } }
triangle { <0, 0, 0>, <-0.7882, 0.7673, 0>, <-0.8249, 0.7277, 0> texture { Material0 } }
triangle { <0, 0, 0>, <-0.8596, 0.6863, 0>, <-0.8923, 0.6433, 0> texture { Material0 } }
triangle { <0, 0, 0>, <-0.9228, 0.5988, 0>, <-0.951, 0.5528, 0> texture { Material0 } }
triangle { <0, 0, 0>, <-0.977, 0.5054, 0>, <-1.0006, 0.4569, 0> texture { Material0 } }
triangle { <0, 0, 0>, <-1.0218, 0.4072, 0>, <-1.0406, 0.3566, 0> texture { Material0 } }
triangle { <0, 0, 0>, <-1.0568, 0.3051, 0>, <-1.0705, 0.2529, 0> texture { Material0 } }
triangle { <0, 0, 0>, <-1.0817, 0.2001, 0>, <-1.0902, 0.1468, 0> texture { Material0 } }
triangle { <0, 0, 0>, <-1.0961, 0.0931, 0>, <-1.0993, 0.0392, 0> texture { Material0 } }
triangle { <0, 0, 0>, <-1.0999, -0.0148, 0>, <-1.0978, -0.0687, 0> texture { Material0 } }
triangle { <0, 0, 0>, <-1.0932, -0.1225, 0>, <-1.0858, -0.176, 0> texture { Material0 } }
triangle { <0, 0, 0>, <-1.0759, -0.2291, 0>, <-1.0633, -0.2816, 0> texture { Material0 } }
triangle { <0, 0, 0>, <-1.0482, -0.3334, 0>, <-1.0306, -0.3845, 0> texture { Material0 } }
triangle { <0, 0, 0>, <-1.0105, -0.4346, 0>, <-0.988, -0.4836, 0> texture { Material0 } }
triangle { <0, 0, 0>, <-0.9631, -0.5315, 0>, <-0.9358, -0.5782, 0> texture { Material0 } }
triangle { <0, 0, 0>, <-0.9063, -0.6234, 0>, <-0.8746, -0.6671, 0> texture { Material0 } }
triangle { <0, 0, 0>, <-0.8408, -0.7092, 0>, <-0.805, -0.7496, 0> texture { Material0 } }
triangle { <0, 0, 0>, <-0.7673, -0.7882, 0>, <-0.7277, -0.8249, 0> texture { Material0 } }
triangle { <0, 0, 0>, <-0.6863, -0.8596, 0>, <-0.6433, -0.8923, 0> texture { Material0 } }
triangle { <0, 0, 0>, <-0.5988, -0.9228, 0>, <-0.5528, -0.951, 0> texture { Material0 } }
triangle { <0, 0, 0>, <-0.5054, -0.977, 0>, <-0.4569, -1.0006, 0> texture { Material0 } }
triangle { <0, 0, 0>, <-0.4072, -1.0218, 0>, <-0.3566, -1.0406, 0> texture { Material0 } }
triangle { <0, 0, 0>, <-0.3051, -1.0568, 0>, <-0.2529, -1.0705, 0> texture { Material0 } }
triangle { <0, 0, 0>, <-0.2001, -1.0817, 0>, <-0.1468, -1.0902, 0> texture { Material0 } }
triangle { <0, 0, 0>, <-0.0931, -1.0961, 0>, <-0.0392, -1.0993, 0> texture { Material0 } }
triangle { <0, 0, 0>, <0.0148, -1.0999, 0>, <0.0687, -1.0978, 0> texture { Material0 } }
triangle { <0, 0, 0>, <0.1225, -1.0932, 0>, <0.176, -1.0858, 0> texture { Material0 } }
triangle { <0, 0, 0>, <0.2291, -1.0759, 0>, <0.2816, -1.0633, 0> texture { Material0 } }
triangle { <0, 0, 0>, <0.3334, -1.0482, 0>, <0.3845, -1.0306, 0> texture { Material0 } }
triangle { <0, 0, 0>, <0.4346, -1.0105, 0>, <0.4836, -0.988, 0> texture { Material0 } }
triangle { <0, 0, 0>, <0.5315, -0.9631, 0>, <0.5782, -0.9358, 0> texture { Material0 } }
triangle { <0, 0, 0>, <0.6234, -0.9063, 0>, <0.6671, -0.8746, 0> texture { Material0 } }
triangle { <0, 0, 0>, <0.7092, -0.8408, 0>, <0.7496, -0.805, 0> texture { Material0 } }
triangle { <0, 0, 0>, <0.7882, -0.7673, 0>, <0.8249, -0.7277, 0> texture { Material0 } }
triangle { <0, 0, 0>, <0.8596, -0.6863, 0>, <0.8923, -0.6433, 0> texture { Material0 } }
triangle { <0, 0, 0>, <0.9228, -0.5988, 0>, <0.951, -0.5528, 0> texture { Material0 } }
triangle { <0, 0, 0>, <0.977, -0.5054, 0>, <1.0006, -0.4569, 0> texture { Material0 } }
triangle { <0, 0, 0>, <1.0218, -0.4072, 0>, <1.0406, -0.3566, 0> texture { Material0 } }
triangle { <0, 0, 0>, <1.0568, -0.3051, 0>, <1.0705, -0.2529, 0> texture { Material0 } }
triangle { <0, 0, 0>, <1.0817, -0.2001, 0>, <1.0902, -0.1468, 0> texture { Material0 } }
triangle { <0, 0, 0>, <1.0961, -0.0931, 0>, <1.0993, -0.0392, 0> texture { Material0 } }
