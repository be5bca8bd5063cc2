// tir.scene, written by `course export`.
// povray +Itir.pov +Otir.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 7 adc_bailout 0 }
background { rgb <0.5, 0.7, 0.9> }

camera {
  perspective
  location <0, -1.8, 2.4>
  direction <0, 0.6332377902572627, -0.773957299203321>
  right <3.1780095802512265, 0, 0>
  up <0, 1.8447327836801393, 1.509326823011023>
}

light_source { <18814.417367671947, 94072.08683835973, 28221.626051507916> rgb 0.7 parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.2375, 0.2125, 0.15> rgb <0.15, 0.125, 0.075> scale 1 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.475, 0.425, 0.3> transmit 0.5 rgb <0.3, 0.25, 0.15> transmit 0.5 scale 1 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.12, 0.08> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.35, 0.5> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.5, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material4 =
  texture { pigment { rgb 1 filter 1 } finish { ambient 0 diffuse 0 reflection { rgb 0, rgb 1 fresnel } conserve_energy } }

plane { <0, 1, 0>, -2 texture { Material0 } }
sphere { <0, 0, 0>, 1 matrix <0.16, 0, 0, 0, 2.4, 0, 0, 0, 0.16, -0.8, 0, -1.4> texture { Material1 } }
sphere { <0.9, -0.6, -0.6>, 0.4 texture { Material2 } }
sphere { <0.6, 0.25, 0.4>, 0.3 texture { Material3 } }
plane { <0, 1, 0>, 0 texture { Material4 } interior { ior 1.33 } }
