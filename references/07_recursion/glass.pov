// glass.scene, written by `course export`.
// povray +Iglass.pov +Oglass.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 9 adc_bailout 0 }
background { rgb <0.4, 0.55, 0.75> }

camera {
  perspective
  location <0, 1.3, 5>
  direction <0, -0.03996803834887157, -0.9992009587217894>
  right <0.9705872913765395, 0, 0>
  up <0, 0.7273588140499673, -0.029094352561998688>
}

light_source { <44112.87732562847, 73521.46220938078, 51465.02354656655> rgb <0.7, 0.7, 0.68> parallel point_at 0 }

#declare Material0 =
  texture { pigment { checker rgb <0.1104, 0.1056, 0.096> rgb <0.03, 0.0408, 0.048> scale 0.5 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.644, 0.616, 0.5599999999999999> transmit 0.5 rgb <0.175, 0.238, 0.27999999999999997> transmit 0.5 scale 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { checker rgb <0.102, 0.036, 0.0264> rgb <0.06, 0.0144, 0.0096> scale 0.5 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.595, 0.21, 0.154> transmit 0.5 rgb <0.35, 0.08399999999999999, 0.055999999999999994> transmit 0.5 scale 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { checker rgb <0.03, 0.072, 0.036> rgb <0.012, 0.036, 0.016800000000000002> scale 0.5 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.175, 0.42, 0.21> transmit 0.5 rgb <0.06999999999999999, 0.21, 0.098> transmit 0.5 scale 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb <0.9, 0.94, 0.92> filter 1 } finish { ambient 0 diffuse 0 reflection { rgb 0.06 } specular 0.06 roughness 0.005 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
polygon { 5, <-3, 0, -2.2>, <0, 0, -2.2>, <0, 2.75, -2.2>, <-3, 2.75, -2.2>, <-3, 0, -2.2> texture { Material1 } }
polygon { 5, <0, 0, -2.2>, <3, 0, -2.2>, <3, 2.75, -2.2>, <0, 2.75, -2.2>, <0, 0, -2.2> texture { Material2 } }
sphere { <0, 1.05, 0.8>, 1 texture { Material3 } interior { ior 1.5 } }
