// glass.scene, written by `course export`.
// povray +Iglass.pov +Oglass.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 11 adc_bailout 0 }
background { rgb <0.45, 0.55, 0.7> }

camera {
  perspective
  location <0.3, 1.7, 5.6>
  direction <-0.05289064337826071, -0.14985682290507202, -0.9872920097275333>
  right <0.8909765953639969, 0, -0.04773088903735697>
  up <-0.005364599539179635, 0.6616339431654883, -0.10013919139801987>
}

light_source { <37904.90217894517, 75809.80435789035, 53066.863050523236> rgb <0.6, 0.6, 0.58> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.133, 0.12600000000000003, 0.12299999999999998> rgb <0.035, 0.044800000000000006, 0.06> scale 0.45 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.5225, 0.49500000000000005, 0.451> transmit 0.5 rgb <0.1375, 0.17600000000000002, 0.22000000000000003> transmit 0.5 scale 0.45 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { checker rgb <0.11200000000000002, 0.07, 0.045> rgb <0.042, 0.028000000000000004, 0.063> scale 0.45 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.44000000000000006, 0.275, 0.165> transmit 0.5 rgb <0.165, 0.11000000000000001, 0.231> transmit 0.5 scale 0.45 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.96, 0.99, 0.97> filter 1 } finish { ambient 0 diffuse 0 reflection { rgb 0, rgb 1 fresnel } conserve_energy } }

#declare Material3 =
  texture { pigment { rgb <0.99, 0.95, 0.9> filter 1 } finish { ambient 0 diffuse 0 reflection { rgb 0, rgb 1 fresnel } conserve_energy } }

#declare Material4 =
  texture { pigment { rgb <0.9, 0.95, 0.99> filter 1 } finish { ambient 0 diffuse 0 reflection { rgb 0, rgb 1 fresnel } conserve_energy } }

plane { <0.009998375395986506, 0.9998375395986506, 0.014997563093979758>, -0.009998375395986506 texture { Material0 } }
plane { <0.01999500187421909, 0.009997500937109546, 0.9997500937109545>, -2.0694826939816755 texture { Material1 } }
box { <-0.5, 0, -0.5>, <0.5, 1.45, 0.5> matrix <0.838670567945424, 0, -0.5446390350150271, 0, 1, 0, 0.5446390350150271, 0, 0.838670567945424, -1.35, 0.02, 0.1> texture { Material2 } interior { ior 1.5 } }
cylinder { <0.05, 0.02, 0.3>, <0.05, 1.6, 0.3>, 0.42 texture { Material2 } interior { ior 1.5 } }
cone { <1.4, 0.02, 0.2>, 0.62, <1.4, 1.6, 0.2>, 0 texture { Material3 } interior { ior 1.5 } }
cylinder { <-0.75, 0.2, 1.35>, <0.9, 0.2, 1.6>, 0.17 texture { Material4 } interior { ior 1.35 } }
