// Depth of field as POV-Ray has it, beside focal_blur.scene: its aperture is four times our lens's radius.
//   povray +Ifocal_blur.pov +W160 +H120 +FN16 -D -A File_Gamma=1.0 Declare=N=16
// Variance 0 takes N samples everywhere; with another one a pixel takes fewer where the first ones agree.
#version 3.7;
#ifndef (N) #declare N = 16; #end
#ifndef (Variance) #declare Variance = 0; #end
#ifndef (Confidence) #declare Confidence = .9; #end
#ifndef (Aperture) #declare Aperture = .6; #end
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <.1, .2, .35> }
#declare W = vnormalize(<0, 1, 6>);
#declare V = <0, W.z, -W.y>;
#declare T = 2 * tan(radians(17.5));
camera { perspective location <0, 1.6, 6> direction -W right T * 4/3 * <1, 0, 0> up T * V
  #if (N > 0) aperture Aperture blur_samples N variance Variance confidence Confidence focal_point <0, 1.6, 6> - 6 * W #end }
light_source { 1e5 * vnormalize(<1, 2, 1.5>) rgb .8 parallel point_at 0 }
#macro M(C) texture { pigment { rgb C } finish { ambient 0 diffuse 1 } } #end
plane { y, .001 texture { pigment { checker rgb <.8, .75, .7> rgb <.8, .75, .7> / 4 scale .5 } finish { ambient 0 diffuse 1 } } }
sphere { <-1.4, .5, 2.6>, .5 M(<.7, .2, .15>) }
sphere { <0, .5, 0>, .5 M(<.2, .6, .25>) }
sphere { <1.7, .5, -3.5>, .5 M(<.2, .3, .7>) }
sphere { <-2, .5, -7>, .5 M(<.7, .6, .2>) }
