// planes.scene, written by `course export`.
// povray +Iplanes.pov +Oplanes.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.42, 0.62, 0.9> }

camera {
  perspective
  location <0, 2, 6>
  direction <0, -0.09950371902099893, -0.995037190209989>
  right <1.5396007178390019, 0, 0>
  up <0, 1.148969979242852, -0.11489699792428523>
}


#declare Material0 =
  texture { pigment { checker rgb <0.765, 0.7200000000000001, 0.558> rgb <0.45, 0.378, 0.25200000000000006> scale 1 } finish { ambient 0 diffuse 0 emission 1 } }

#declare Material1 =
  texture { pigment { checker rgb <0.27, 0.468, 0.216> rgb <0.117, 0.27, 0.108> scale 1 } finish { ambient 0 diffuse 0 emission 1 } }

#declare Material2 =
  texture { pigment { checker rgb <0.558, 0.54, 0.5940000000000001> rgb <0.36000000000000004, 0.342, 0.41400000000000003> scale 2 } finish { ambient 0 diffuse 0 emission 1 } }

#declare Material3 =
  texture { pigment { checker rgb <0.7200000000000001, 0.36000000000000004, 0.234> rgb <0.49500000000000005, 0.198, 0.12600000000000003> scale 1 } finish { ambient 0 diffuse 0 emission 1 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
plane { <0.5513178464199713, 0.8269767696299569, 0.11026356928399426>, -1.6539535392599138 texture { Material1 } }
plane { <-0.6547706044716511, 0.7202476649188163, 0.22916971156507787>, -2.6190824178866046 texture { Material1 } }
plane { <0.14333552726125526, 0.40953007788930074, 0.9009661713564617>, -21.62318811255508 texture { Material2 } }
plane { <-0.09918995010726928, 0.9918995010726926, 0.07935196008581541>, -0.23805588025744623 texture { Material3 } }
