// heart.scene, written by `course export`.
// povray +Iheart.pov +Oheart.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.82, 0.74, 0.72> }

camera {
  perspective
  location <2.2, -5.2, 1.6>
  direction <-0.3769068796200857, 0.8908708063747479, -0.25355553719896673>
  right <0.6810848613243491, 0.2881512874833785, 0>
  up <-0.05479676586931644, 0.1295196284183843, 0.536523616681145>
}

light_source { <4, -6, 6> rgb <0.6, 0.58, 0.55> }
light_source { <-68041.38174397717, -68041.38174397717, 27216.55269759087> rgb <0.2, 0.2, 0.22> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb <0.06, 0.02, 0.02> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.56, 0.05, 0.06> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material1 =
  texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 specular 1.2 roughness 0.016666666666666666 } }
  texture { pigment { rgb <1, 0.8333333333333334, 0.4> filter 1 } finish { ambient 0 diffuse 0 } }
  texture { pigment { rgb <0.1, 0.07, 0.02> transmit 0.5 } finish { ambient 0 diffuse 0 emission 4 } }
  texture { pigment { rgb <0.5, 0.36, 0.1> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb <0.3, 0.25, 0.12> } } }

#declare Material2 =
  texture { pigment { checker rgb <0.1, 0.09, 0.09> rgb <0.082, 0.072, 0.072> scale 0.5 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { checker rgb <0.4, 0.36, 0.35> transmit 0.5 rgb <0.328, 0.288, 0.27999999999999997> transmit 0.5 scale 0.5 } finish { ambient 0 diffuse 2 } }

polynomial { 6, xyz(0, 0, 0): -1, xyz(0, 0, 2): 3, xyz(0, 0, 4): -3, xyz(0, 0, 6): 1, xyz(0, 2, 0): 6.75, xyz(0, 2, 2): -13.5, xyz(0, 2, 3): -0.1125, xyz(0, 2, 4): 6.75, xyz(0, 4, 0): -15.1875, xyz(0, 4, 2): 15.1875, xyz(0, 6, 0): 11.390625, xyz(2, 0, 0): 3, xyz(2, 0, 2): -6, xyz(2, 0, 3): -1, xyz(2, 0, 4): 3, xyz(2, 2, 0): -13.5, xyz(2, 2, 2): 13.5, xyz(2, 4, 0): 15.1875, xyz(4, 0, 0): -3, xyz(4, 0, 2): 3, xyz(4, 2, 0): 6.75, xyz(6, 0, 0): 1 sturm clipped_by { box { <-2, -2, -2>, <2, 2, 2> } } texture { Material0 } }
cylinder { <0, 0, -0.03>, <0, 0, 0.03>, 1.03 matrix <1, 0, 0, 0, 0.6666666666666667, 0, 0, 0, 1, 0, 0, 0> texture { Material1 } }
plane { <0.01999500187421909, 0.009997500937109546, 0.9997500937109545>, -1.0197450955851737 texture { Material2 } }
