// lenses.scene, written by `course export`.
// povray +Ilenses.pov +Olenses.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 13 adc_bailout 0 }
background { rgb <0.45, 0.55, 0.7> }

camera {
  perspective
  location <0.2, 1.5, 5.8>
  direction <-0.034248131855492976, -0.11130642853035218, -0.9931958238092963>
  right <0.8659378499288316, 0, -0.029859925859614885>
  up <-0.0024927012777111288, 0.6458013771793141, -0.07228833705362274>
}

light_source { <37904.90217894517, 75809.80435789035, 53066.863050523236> rgb <0.6, 0.6, 0.58> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.133, 0.12600000000000003, 0.12299999999999998> rgb <0.035, 0.044800000000000006, 0.06> scale 0.45 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5225, 0.49500000000000005, 0.451> transmit 0.5 rgb <0.1375, 0.17600000000000002, 0.22000000000000003> transmit 0.5 scale 0.45 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { checker rgb <0.11200000000000002, 0.07, 0.045> rgb <0.042, 0.028000000000000004, 0.063> scale 0.45 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.44000000000000006, 0.275, 0.165> transmit 0.5 rgb <0.165, 0.11000000000000001, 0.231> transmit 0.5 scale 0.45 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.97, 0.99, 0.98> filter 1 } finish { ambient 0 diffuse 0 } }

#declare Material3 =
  texture { pigment { rgb <0.99, 0.95, 0.9> filter 1 } finish { ambient 0 diffuse 0 } }

plane { <0.009998375395986506, 0.9998375395986506, 0.014997563093979758>, -0.009998375395986506 texture { Material0 } }
plane { <0.01999500187421909, 0.009997500937109546, 0.9997500937109545>, -2.0694826939816755 texture { Material1 } }
intersection { sphere { <-1.15, 0.9, -1.05>, 1.6 } sphere { <-1.15, 0.9, 1.45>, 1.6 } texture { Material2 } interior { ior 1.5 } }
difference { cylinder { <1.05, 0.85, -0.1>, <1.05, 0.85, 0.55>, 0.8 } sphere { <1.05, 0.85, -1.22>, 1.25 } sphere { <1.05, 0.85, 1.67>, 1.25 } texture { Material2 } interior { ior 1.5000015 } }
difference { sphere { <-0.1, 0.44, 1.6>, 0.42 } sphere { <-0.1, 0.44, 1.6>, 0.36 } plane { <0, -1, 0>, -0.55 } texture { Material3 } interior { ior 1.5000015 } }
