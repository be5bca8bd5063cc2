// Soft shadows as POV-Ray has them, beside soft_shadow.scene: three balls over a floor under a square light of 2 × 2.
//   povray +Isoft_shadow.pov +W240 +H180 +FN16 -D -A File_Gamma=1.0 Declare=N=8 Declare=Mode=1
// Mode 0 is area_light with N × N lamps, 1 also area_illumination, 2 as many spotlights, in the middles of N × N
// cells. Jitter 1 is jitter. Adaptive k of 0 or more is adaptive k, with N of 2^k + 1 or more.
#version 3.7;
#ifndef (N) #declare N = 8; #end
#ifndef (Mode) #declare Mode = 0; #end
#ifndef (Jitter) #declare Jitter = 0; #end
#ifndef (Adaptive) #declare Adaptive = -1; #end
#declare Near = 1e-6;
#declare Lamp = 6 * 4 / pi / (2 * Near * Near);
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb 0 }
#declare W = vnormalize(<0, 5.1, 6.5>);
#declare V = <0, W.z, -W.y>;
#declare T = 2 * tan(radians(20));
camera { perspective location <0, 5.5, 6.5> direction -W right T * 4/3 * <1, 0, 0> up T * V }
#if (Mode < 2)
light_source { <0, 4, 0> rgb Lamp spotlight point_at <0, 3, 0> radius 90 falloff 90 tightness 1 fade_distance Near fade_power 2
  area_light <2, 0, 0>, <0, 0, 2>, N, N
  #if (Adaptive >= 0) adaptive Adaptive #end
  #if (Jitter) jitter #end
  #if (Mode = 1) area_illumination on #end
}
#else
#for (I, 0, N - 1) #for (J, 0, N - 1)
light_source { <2 * (I + .5) / N - 1, 4, 2 * (J + .5) / N - 1> rgb Lamp / (N * N)
  spotlight point_at <2 * (I + .5) / N - 1, 3, 2 * (J + .5) / N - 1> radius 90 falloff 90 tightness 1 fade_distance Near fade_power 2 }
#end #end
#end
#declare Floor = texture { pigment { rgb .8 } finish { ambient 0 diffuse 1 } }
#declare Ball = texture { pigment { rgb .7 } finish { ambient 0 diffuse 1 } }
plane { y, 0 texture { Floor } }
sphere { <-.9, 1.2, .2>, .7 texture { Ball } }
sphere { <1.2, .6, -.3>, .5 texture { Ball } }
sphere { <.4, .4, 1.3>, .4 texture { Ball } }
