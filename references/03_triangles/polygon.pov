// polygon.scene, written by `course export`.
// povray +Ipolygon.pov +Opolygon.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.05, 0.07, 0.12> }

camera {
  perspective
  location <0.4, 1.6, 7.2>
  direction <-0.05452278836601583, -0.18401441073530345, -0.9814101905882849>
  right <1.0220613866781763, 0, -0.05678118814878757>
  up <-0.007836417658537154, 0.7546179967480221, -0.1410555178536688>
}


#declare Material0 =
  texture { pigment { rgb <0.93, 0.73, 0.15> } finish { ambient 0 diffuse 0 emission 1 } }

#declare Material1 =
  texture { pigment { rgb <0.8, 0.25, 0.2> } finish { ambient 0 diffuse 0 emission 1 } }

#declare Material2 =
  texture { pigment { rgb <0.2, 0.55, 0.75> } finish { ambient 0 diffuse 0 emission 1 } }

#declare Material3 =
  texture { pigment { rgb <0.35, 0.62, 0.35> } finish { ambient 0 diffuse 0 emission 1 } }

#declare Material4 =
  texture { pigment { rgb <0.55, 0.38, 0.62> } finish { ambient 0 diffuse 0 emission 1 } }

#declare Material5 =
  texture { pigment { rgb <0.52, 0.5, 0.47> } finish { ambient 0 diffuse 0 emission 1 } }

polygon { 11, <-1.9, 2.4, -0.6>, <-2.1784, 1.55, -0.6812>, <-3.0424, 1.54, -0.9332>, <-2.3608, 1, -0.7344>, <-2.6008, 0.14, -0.8044>, <-1.9, 0.65, -0.6>, <-1.1992, 0.14, -0.3956>, <-1.4392, 1, -0.4656>, <-0.7576, 1.54, -0.2668>, <-1.6216, 1.55, -0.5188>, <-1.9, 2.4, -0.6> texture { Material0 } }
polygon { 6, <2.05, 2.55, -1.1>, <1.3684, 0.38, -0.9012>, <3.1444, 1.72, -1.4192>, <0.9556, 1.72, -0.7808>, <2.7316, 0.38, -1.2988>, <2.05, 2.55, -1.1> texture { Material1 } }
polygon { 8, <-0.965, -0.105, 0.93>, <0.235, 0.045, 0.03>, <0.19, -0.36, -0.06>, <1.14, 0.38, -0.58>, <0.33, 0.9, 0.22>, <0.285, 0.495, 0.13>, <-0.915, 0.345, 1.03>, <-0.965, -0.105, 0.93> texture { Material2 } }
polygon { 5, <-0.38, -0.6, -0.54>, <0.58, -0.6, 0.74>, <0.58, 1, 0.74>, <-0.38, 1, -0.54>, <-0.38, -0.6, -0.54> texture { Material3 } }
polygon { 14, <-2.6, -1.07, 1.36>, <2.7, -1.07, 1.36>, <2.7, -0.27, 1.96>, <2.2, -0.59, 1.72>, <1.7, -0.27, 1.96>, <1.2, -0.59, 1.72>, <0.7, -0.27, 1.96>, <0.2, -0.59, 1.72>, <-0.3, -0.27, 1.96>, <-0.8, -0.59, 1.72>, <-1.3, -0.27, 1.96>, <-1.8, -0.59, 1.72>, <-2.6, -0.27, 1.96>, <-2.6, -1.07, 1.36> texture { Material4 } }
polygon { 5, <-4.5, -1.25, -3.5>, <-4.5, -1.25, 4.5>, <4.5, -1.25, 4.5>, <4.5, -1.25, -3.5>, <-4.5, -1.25, -3.5> texture { Material5 } }
