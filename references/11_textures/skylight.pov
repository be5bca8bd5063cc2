// skylight.scene, written by `course export`.
// povray +Iskylight.pov +Oskylight.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb 0 }

camera {
  perspective
  location <0, 1.9, 6.6>
  direction <0, -0.16439898730535726, -0.9863939238321436>
  right <0.8407967703439561, 0, 0>
  up <0, 0.6220176190837263, -0.10366960318062106>
}


sky_sphere { pigment { function { 0.5 + 0.5 * y } color_map { [0 rgb <0.3, 0.22, 0.12>] [0.5 rgb <0.85, 0.8, 0.7>] [1 rgb <0.25, 0.45, 0.9>] } } }

#declare Material0 =
  texture { pigment { average pigment_map {
  [1 rgb <6.9124966654639, 7.031497480028294, 7.648999555657873>]
  [6 rgb 0]
  [1 slope { x } color_map { [0 rgb <-5.341723446063455e-16, -5.129773793486879e-16, -5.440254403192436e-16>] [1 rgb <5.341723446063455e-16, 5.129773793486879e-16, 5.440254403192436e-16>] } sine_wave frequency 0.5 phase 0.25]
  [1 slope { y } color_map { [0 rgb <-0.21333350066512444, 0.9813341030594102, 3.3280026103750586>] [1 rgb <0.21333350066512444, -0.9813341030594102, -3.3280026103750586>] } sine_wave frequency 0.5 phase 0.25]
  [1 slope { z } color_map { [0 rgb <2.874709207605896e-16, 2.35694610342298e-16, 2.786105958903011e-16>] [1 rgb <-2.874709207605896e-16, -2.35694610342298e-16, -2.786105958903011e-16>] } sine_wave frequency 0.5 phase 0.25]
  [1 slope { <1, 0, 0> } color_map { [0 rgb 0] [1 rgb <0.8624970144996678, 0.6974970556792184, 0.28499704097300743>] } sine_wave frequency -1 phase 0.25]
  [1 slope { <0, 1, 0> } color_map { [0 rgb 0] [1 rgb <-0.8624970144996678, -0.6974970556792184, -0.28499704097300743>] } sine_wave frequency -1 phase 0.25]
  [1 slope { <0, 0, 1> } color_map { [0 rgb 0] [1 rgb <0.8624970144996896, 0.6974970556792308, 0.2849970409729973>] } sine_wave frequency -1 phase 0.25]
  [1 slope { <1, 1, 0> } color_map { [0 rgb 0] [1 rgb <1.9245334310879284e-18, -5.024095054588324e-17, -1.527441824850182e-16>] } sine_wave frequency -1 phase 0.25]
  [1 slope { <0, 1, 1> } color_map { [0 rgb 0] [1 rgb <1.3222284754527109e-18, 1.4235045013069958e-17, 5.223518594168162e-17>] } sine_wave frequency -1 phase 0.25]
  [1 slope { <1, 0, 1> } color_map { [0 rgb 0] [1 rgb <1.7125447312931249e-16, 1.7609931787191357e-16, 2.1370262643936362e-16>] } sine_wave frequency -1 phase 0.25] } } finish { ambient 0 diffuse 0 emission 1 } }

#declare Material1 =
  texture { pigment { average pigment_map {
  [1 rgb <6.9124966654639, 3.0762801475123784, 2.3903123611430854>]
  [6 rgb 0]
  [1 slope { x } color_map { [0 rgb <-5.341723446063455e-16, -2.24427603465051e-16, -1.7000795009976364e-16>] [1 rgb <5.341723446063455e-16, 2.24427603465051e-16, 1.7000795009976364e-16>] } sine_wave frequency 0.5 phase 0.25]
  [1 slope { y } color_map { [0 rgb <-0.21333350066512444, 0.4293336700884919, 1.0400008157422058>] [1 rgb <0.21333350066512444, -0.4293336700884919, -1.0400008157422058>] } sine_wave frequency 0.5 phase 0.25]
  [1 slope { z } color_map { [0 rgb <2.874709207605896e-16, 1.0311639202475537e-16, 8.706581121571909e-17>] [1 rgb <-2.874709207605896e-16, -1.0311639202475537e-16, -8.706581121571909e-17>] } sine_wave frequency 0.5 phase 0.25]
  [1 slope { <1, 0, 0> } color_map { [0 rgb 0] [1 rgb <0.8624970144996678, 0.30515496185965796, 0.08906157530406482>] } sine_wave frequency -1 phase 0.25]
  [1 slope { <0, 1, 0> } color_map { [0 rgb 0] [1 rgb <-0.8624970144996678, -0.305154961859658, -0.08906157530406482>] } sine_wave frequency -1 phase 0.25]
  [1 slope { <0, 0, 1> } color_map { [0 rgb 0] [1 rgb <0.8624970144996896, 0.3051549618596634, 0.08906157530406164>] } sine_wave frequency -1 phase 0.25]
  [1 slope { <1, 1, 0> } color_map { [0 rgb 0] [1 rgb <1.9245334310879284e-18, -2.1980415863823914e-17, -4.773255702656819e-17>] } sine_wave frequency -1 phase 0.25]
  [1 slope { <0, 1, 1> } color_map { [0 rgb 0] [1 rgb <1.3222284754527109e-18, 6.227832193218106e-18, 1.6323495606775506e-17>] } sine_wave frequency -1 phase 0.25]
  [1 slope { <1, 0, 1> } color_map { [0 rgb 0] [1 rgb <1.7125447312931249e-16, 7.704345156896217e-17, 6.678207076230112e-17>] } sine_wave frequency -1 phase 0.25] } } finish { ambient 0 diffuse 0 emission 1 } }

#declare Material2 =
  texture { pigment { average pigment_map {
  [1 rgb <3.024217291140456, 5.27362311002122, 2.8683748333717025>]
  [6 rgb 0]
  [1 slope { x } color_map { [0 rgb <-2.3370040076527614e-16, -3.8473303451151597e-16, -2.0400954011971637e-16>] [1 rgb <2.3370040076527614e-16, 3.8473303451151597e-16, 2.0400954011971637e-16>] } sine_wave frequency 0.5 phase 0.25]
  [1 slope { y } color_map { [0 rgb <-0.09333340654099193, 0.7360005772945576, 1.248000978890647>] [1 rgb <0.09333340654099193, -0.7360005772945576, -1.248000978890647>] } sine_wave frequency 0.5 phase 0.25]
  [1 slope { z } color_map { [0 rgb <1.2576852783275794e-16, 1.767709577567235e-16, 1.0447897345886291e-16>] [1 rgb <-1.2576852783275794e-16, -1.767709577567235e-16, -1.0447897345886291e-16>] } sine_wave frequency 0.5 phase 0.25]
  [1 slope { <1, 0, 0> } color_map { [0 rgb 0] [1 rgb <0.3773424438436046, 0.5231227917594137, 0.10687389036487778>] } sine_wave frequency -1 phase 0.25]
  [1 slope { <0, 1, 0> } color_map { [0 rgb 0] [1 rgb <-0.3773424438436046, -0.5231227917594138, -0.10687389036487778>] } sine_wave frequency -1 phase 0.25]
  [1 slope { <0, 0, 1> } color_map { [0 rgb 0] [1 rgb <0.37734244384361415, 0.523122791759423, 0.10687389036487396>] } sine_wave frequency -1 phase 0.25]
  [1 slope { <1, 1, 0> } color_map { [0 rgb 0] [1 rgb <8.419833761009686e-19, -3.768071290941243e-17, -5.727906843188182e-17>] } sine_wave frequency -1 phase 0.25]
  [1 slope { <0, 1, 1> } color_map { [0 rgb 0] [1 rgb <5.78474958010561e-19, 1.0676283759802466e-17, 1.9588194728130607e-17>] } sine_wave frequency -1 phase 0.25]
  [1 slope { <1, 0, 1> } color_map { [0 rgb 0] [1 rgb <7.492383199407421e-17, 1.3207448840393515e-16, 8.013848491476134e-17>] } sine_wave frequency -1 phase 0.25] } } finish { ambient 0 diffuse 0 emission 1 } }

sphere { <-1.9, 0.9, 0>, 0.85 texture { Material0 } }
box { <-0.65, 0, -0.65>, <0.65, 1.3, 0.65> matrix <0.8191520442889918, 0, -0.573576436351046, 0.11925324669497091, 0.9781476007338057, 0.17031128656494837, 0.5610424150542221, -0.20791169081775934, 0.8012516067574694, 0.1, 0.1, 0> texture { Material1 } }
torus { 0.6, 0.27 sturm matrix <0, 0.8574929257125442, -0.5144957554275265, 0.2491364395612199, 0.4982728791224398, 0.8304547985373997, 0.9684683962230045, -0.1281796406765741, -0.21363273446095687, 0, 0, 0> translate <2, 0.9, 0> texture { Material2 } }
