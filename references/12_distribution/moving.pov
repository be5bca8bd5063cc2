// moving.scene, written by `course export`.
// povray +Imoving.pov +Omoving.png +W320 +H200 +FN16 -D -A File_Gamma=1.0 +KFI0 +KFF35
// then a pixel's samples are those of 36 pictures, weighed by our filter
#version 3.7;
#switch (frame_number)
#case (0)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.4, 0.5, 0.6> }

camera {
  perspective
  location <0, 1.8, 8>
  direction <-0.0012738778394110852, -0.12277069379152504, -0.9924358818133782>
  right <0.9783381806677133, 0, 0>
  up <0, 0.6067395828880445, -0.07584244786100557>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.62, 0.6, 0.55> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.2, 0.22, 0.25> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.52, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.4, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.3, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.65, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 0.7, 0>, 0.7 texture { Material1 } }
sphere { <-2.9, 0.7, 0>, 0.7 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.54, 0, 0> texture { Material2 } }
torus { 0.55, 0.16 sturm translate <0, 0, 0> matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.28, 0> texture { Material3 } }
cylinder { <-0.5, 0, 0>, <0.5, 0, 0>, 0.07 matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.28, 0> texture { Material3 } }
#break
#case (1)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.4, 0.5, 0.6> }

camera {
  perspective
  location <0, 1.8, 8>
  direction <-0.000764326703646651, -0.12277069379152504, -0.9924358818133782>
  right <0.9783381806677133, 0, 0>
  up <0, 0.6067395828880445, -0.07584244786100557>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.62, 0.6, 0.55> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.2, 0.22, 0.25> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.52, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.4, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.3, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.65, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 0.7, 0>, 0.7 texture { Material1 } }
sphere { <-2.9, 0.7, 0>, 0.7 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.64, 0, 0> texture { Material2 } }
torus { 0.55, 0.16 sturm translate <0, 0, 0> matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.3688888888888888, 0> texture { Material3 } }
cylinder { <-0.5, 0, 0>, <0.5, 0, 0>, 0.07 matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.3688888888888888, 0> texture { Material3 } }
#break
#case (2)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.4, 0.5, 0.6> }

camera {
  perspective
  location <0, 1.8, 8>
  direction <-0.0002547755678822171, -0.12277069379152504, -0.9924358818133782>
  right <0.9783381806677133, 0, 0>
  up <0, 0.6067395828880445, -0.07584244786100557>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.62, 0.6, 0.55> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.2, 0.22, 0.25> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.52, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.4, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.3, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.65, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 0.7, 0>, 0.7 texture { Material1 } }
sphere { <-2.9, 0.7, 0>, 0.7 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.31999999999999995, 0, 0> texture { Material2 } }
torus { 0.55, 0.16 sturm translate <0, 0, 0> matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.0844444444444445, 0> texture { Material3 } }
cylinder { <-0.5, 0, 0>, <0.5, 0, 0>, 0.07 matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.0844444444444445, 0> texture { Material3 } }
#break
#case (3)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.4, 0.5, 0.6> }

camera {
  perspective
  location <0, 1.8, 8>
  direction <0.0002547755678822168, -0.12277069379152504, -0.9924358818133782>
  right <0.9783381806677133, 0, 0>
  up <0, 0.6067395828880445, -0.07584244786100557>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.62, 0.6, 0.55> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.2, 0.22, 0.25> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.52, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.4, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.3, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.65, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 0.7, 0>, 0.7 texture { Material1 } }
sphere { <-2.9, 0.7, 0>, 0.7 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.45999999999999996, 0, 0> texture { Material2 } }
torus { 0.55, 0.16 sturm translate <0, 0, 0> matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.208888888888889, 0> texture { Material3 } }
cylinder { <-0.5, 0, 0>, <0.5, 0, 0>, 0.07 matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.208888888888889, 0> texture { Material3 } }
#break
#case (4)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.4, 0.5, 0.6> }

camera {
  perspective
  location <0, 1.8, 8>
  direction <0.000764326703646651, -0.12277069379152504, -0.9924358818133782>
  right <0.9783381806677133, 0, 0>
  up <0, 0.6067395828880445, -0.07584244786100557>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.62, 0.6, 0.55> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.2, 0.22, 0.25> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.52, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.4, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.3, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.65, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 0.7, 0>, 0.7 texture { Material1 } }
sphere { <-2.9, 0.7, 0>, 0.7 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.7200000000000001, 0, 0> texture { Material2 } }
torus { 0.55, 0.16 sturm translate <0, 0, 0> matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.4400000000000002, 0> texture { Material3 } }
cylinder { <-0.5, 0, 0>, <0.5, 0, 0>, 0.07 matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.4400000000000002, 0> texture { Material3 } }
#break
#case (5)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.4, 0.5, 0.6> }

camera {
  perspective
  location <0, 1.8, 8>
  direction <0.0012738778394110852, -0.12277069379152504, -0.9924358818133782>
  right <0.9783381806677133, 0, 0>
  up <0, 0.6067395828880445, -0.07584244786100557>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.62, 0.6, 0.55> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.2, 0.22, 0.25> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.52, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.4, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.3, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.65, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 0.7, 0>, 0.7 texture { Material1 } }
sphere { <-2.9, 0.7, 0>, 0.7 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.7000000000000001, 0, 0> texture { Material2 } }
torus { 0.55, 0.16 sturm translate <0, 0, 0> matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.4222222222222223, 0> texture { Material3 } }
cylinder { <-0.5, 0, 0>, <0.5, 0, 0>, 0.07 matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.4222222222222223, 0> texture { Material3 } }
#break
#case (6)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.4, 0.5, 0.6> }

camera {
  perspective
  location <0, 1.8, 8>
  direction <-0.0012738778394110852, -0.1232763101105984, -0.992372679773494>
  right <0.9783381806677133, 0, 0>
  up <0, 0.6067395828880445, -0.07584244786100557>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.62, 0.6, 0.55> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.2, 0.22, 0.25> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.52, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.4, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.3, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.65, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 0.7, 0>, 0.7 texture { Material1 } }
sphere { <-2.9, 0.7, 0>, 0.7 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.30000000000000004, 0, 0> texture { Material2 } }
torus { 0.55, 0.16 sturm translate <0, 0, 0> matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.0666666666666669, 0> texture { Material3 } }
cylinder { <-0.5, 0, 0>, <0.5, 0, 0>, 0.07 matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.0666666666666669, 0> texture { Material3 } }
#break
#case (7)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.4, 0.5, 0.6> }

camera {
  perspective
  location <0, 1.8, 8>
  direction <-0.000764326703646651, -0.1232763101105984, -0.992372679773494>
  right <0.9783381806677133, 0, 0>
  up <0, 0.6067395828880445, -0.07584244786100557>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.62, 0.6, 0.55> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.2, 0.22, 0.25> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.52, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.4, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.3, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.65, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 0.7, 0>, 0.7 texture { Material1 } }
sphere { <-2.9, 0.7, 0>, 0.7 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.26, 0, 0> texture { Material2 } }
torus { 0.55, 0.16 sturm translate <0, 0, 0> matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.031111111111111, 0> texture { Material3 } }
cylinder { <-0.5, 0, 0>, <0.5, 0, 0>, 0.07 matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.031111111111111, 0> texture { Material3 } }
#break
#case (8)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.4, 0.5, 0.6> }

camera {
  perspective
  location <0, 1.8, 8>
  direction <-0.0002547755678822171, -0.1232763101105984, -0.992372679773494>
  right <0.9783381806677133, 0, 0>
  up <0, 0.6067395828880445, -0.07584244786100557>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.62, 0.6, 0.55> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.2, 0.22, 0.25> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.52, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.4, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.3, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.65, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 0.7, 0>, 0.7 texture { Material1 } }
sphere { <-2.9, 0.7, 0>, 0.7 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.7960769515458674, 0, 0> texture { Material2 } }
torus { 0.55, 0.16 sturm translate <0, 0, 0> matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.5076239569296601, 0> texture { Material3 } }
cylinder { <-0.5, 0, 0>, <0.5, 0, 0>, 0.07 matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.5076239569296601, 0> texture { Material3 } }
#break
#case (9)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.4, 0.5, 0.6> }

camera {
  perspective
  location <0, 1.8, 8>
  direction <0.0002547755678822168, -0.1232763101105984, -0.992372679773494>
  right <0.9783381806677133, 0, 0>
  up <0, 0.6067395828880445, -0.07584244786100557>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.62, 0.6, 0.55> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.2, 0.22, 0.25> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.52, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.4, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.3, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.65, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 0.7, 0>, 0.7 texture { Material1 } }
sphere { <-2.9, 0.7, 0>, 0.7 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.15874507866387544, 0, 0> texture { Material2 } }
torus { 0.55, 0.16 sturm translate <0, 0, 0> matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 0.9411067365901116, 0> texture { Material3 } }
cylinder { <-0.5, 0, 0>, <0.5, 0, 0>, 0.07 matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 0.9411067365901116, 0> texture { Material3 } }
#break
#case (10)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.4, 0.5, 0.6> }

camera {
  perspective
  location <0, 1.8, 8>
  direction <0.000764326703646651, -0.1232763101105984, -0.992372679773494>
  right <0.9783381806677133, 0, 0>
  up <0, 0.6067395828880445, -0.07584244786100557>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.62, 0.6, 0.55> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.2, 0.22, 0.25> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.52, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.4, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.3, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.65, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 0.7, 0>, 0.7 texture { Material1 } }
sphere { <-2.9, 0.7, 0>, 0.7 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.6000000000000001, 0, 0> texture { Material2 } }
torus { 0.55, 0.16 sturm translate <0, 0, 0> matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.3333333333333335, 0> texture { Material3 } }
cylinder { <-0.5, 0, 0>, <0.5, 0, 0>, 0.07 matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.3333333333333335, 0> texture { Material3 } }
#break
#case (11)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.4, 0.5, 0.6> }

camera {
  perspective
  location <0, 1.8, 8>
  direction <0.0012738778394110852, -0.1232763101105984, -0.992372679773494>
  right <0.9783381806677133, 0, 0>
  up <0, 0.6067395828880445, -0.07584244786100557>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.62, 0.6, 0.55> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.2, 0.22, 0.25> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.52, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.4, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.3, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.65, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 0.7, 0>, 0.7 texture { Material1 } }
sphere { <-2.9, 0.7, 0>, 0.7 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.34, 0, 0> texture { Material2 } }
torus { 0.55, 0.16 sturm translate <0, 0, 0> matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.1022222222222222, 0> texture { Material3 } }
cylinder { <-0.5, 0, 0>, <0.5, 0, 0>, 0.07 matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.1022222222222222, 0> texture { Material3 } }
#break
#case (12)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.4, 0.5, 0.6> }

camera {
  perspective
  location <0, 1.8, 8>
  direction <-0.0012738778394110852, -0.12378192642967178, -0.9923094777336098>
  right <0.9783381806677133, 0, 0>
  up <0, 0.6067395828880445, -0.07584244786100557>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.62, 0.6, 0.55> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.2, 0.22, 0.25> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.52, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.4, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.3, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.65, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 0.7, 0>, 0.7 texture { Material1 } }
sphere { <-2.9, 0.7, 0>, 0.7 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.6599999999999999, 0, 0> texture { Material2 } }
torus { 0.55, 0.16 sturm translate <0, 0, 0> matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.3866666666666667, 0> texture { Material3 } }
cylinder { <-0.5, 0, 0>, <0.5, 0, 0>, 0.07 matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.3866666666666667, 0> texture { Material3 } }
#break
#case (13)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.4, 0.5, 0.6> }

camera {
  perspective
  location <0, 1.8, 8>
  direction <-0.000764326703646651, -0.12378192642967178, -0.9923094777336098>
  right <0.9783381806677133, 0, 0>
  up <0, 0.6067395828880445, -0.07584244786100557>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.62, 0.6, 0.55> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.2, 0.22, 0.25> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.52, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.4, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.3, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.65, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 0.7, 0>, 0.7 texture { Material1 } }
sphere { <-2.9, 0.7, 0>, 0.7 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.28, 0, 0> texture { Material2 } }
torus { 0.55, 0.16 sturm translate <0, 0, 0> matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.048888888888889, 0> texture { Material3 } }
cylinder { <-0.5, 0, 0>, <0.5, 0, 0>, 0.07 matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.048888888888889, 0> texture { Material3 } }
#break
#case (14)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.4, 0.5, 0.6> }

camera {
  perspective
  location <0, 1.8, 8>
  direction <-0.0002547755678822171, -0.12378192642967178, -0.9923094777336098>
  right <0.9783381806677133, 0, 0>
  up <0, 0.6067395828880445, -0.07584244786100557>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.62, 0.6, 0.55> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.2, 0.22, 0.25> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.52, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.4, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.3, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.65, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 0.7, 0>, 0.7 texture { Material1 } }
sphere { <-2.9, 0.7, 0>, 0.7 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.62, 0, 0> texture { Material2 } }
torus { 0.55, 0.16 sturm translate <0, 0, 0> matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.3511111111111112, 0> texture { Material3 } }
cylinder { <-0.5, 0, 0>, <0.5, 0, 0>, 0.07 matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.3511111111111112, 0> texture { Material3 } }
#break
#case (15)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.4, 0.5, 0.6> }

camera {
  perspective
  location <0, 1.8, 8>
  direction <0.0002547755678822168, -0.12378192642967178, -0.9923094777336098>
  right <0.9783381806677133, 0, 0>
  up <0, 0.6067395828880445, -0.07584244786100557>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.62, 0.6, 0.55> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.2, 0.22, 0.25> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.52, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.4, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.3, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.65, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 0.7, 0>, 0.7 texture { Material1 } }
sphere { <-2.9, 0.7, 0>, 0.7 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.7412549213361246, 0, 0> texture { Material2 } }
torus { 0.55, 0.16 sturm translate <0, 0, 0> matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.4588932634098886, 0> texture { Material3 } }
cylinder { <-0.5, 0, 0>, <0.5, 0, 0>, 0.07 matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.4588932634098886, 0> texture { Material3 } }
#break
#case (16)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.4, 0.5, 0.6> }

camera {
  perspective
  location <0, 1.8, 8>
  direction <0.000764326703646651, -0.12378192642967178, -0.9923094777336098>
  right <0.9783381806677133, 0, 0>
  up <0, 0.6067395828880445, -0.07584244786100557>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.62, 0.6, 0.55> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.2, 0.22, 0.25> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.52, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.4, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.3, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.65, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 0.7, 0>, 0.7 texture { Material1 } }
sphere { <-2.9, 0.7, 0>, 0.7 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.7658359213500127, 0, 0> texture { Material2 } }
torus { 0.55, 0.16 sturm translate <0, 0, 0> matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.4807430412000113, 0> texture { Material3 } }
cylinder { <-0.5, 0, 0>, <0.5, 0, 0>, 0.07 matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.4807430412000113, 0> texture { Material3 } }
#break
#case (17)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.4, 0.5, 0.6> }

camera {
  perspective
  location <0, 1.8, 8>
  direction <0.0012738778394110852, -0.12378192642967178, -0.9923094777336098>
  right <0.9783381806677133, 0, 0>
  up <0, 0.6067395828880445, -0.07584244786100557>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.62, 0.6, 0.55> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.2, 0.22, 0.25> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.52, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.4, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.3, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.65, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 0.7, 0>, 0.7 texture { Material1 } }
sphere { <-2.9, 0.7, 0>, 0.7 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.68, 0, 0> texture { Material2 } }
torus { 0.55, 0.16 sturm translate <0, 0, 0> matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.4044444444444446, 0> texture { Material3 } }
cylinder { <-0.5, 0, 0>, <0.5, 0, 0>, 0.07 matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.4044444444444446, 0> texture { Material3 } }
#break
#case (18)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.4, 0.5, 0.6> }

camera {
  perspective
  location <0, 1.8, 8>
  direction <-0.0012738778394110852, -0.12428754274874515, -0.9922462756937257>
  right <0.9783381806677133, 0, 0>
  up <0, 0.6067395828880445, -0.07584244786100557>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.62, 0.6, 0.55> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.2, 0.22, 0.25> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.52, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.4, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.3, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.65, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 0.7, 0>, 0.7 texture { Material1 } }
sphere { <-2.9, 0.7, 0>, 0.7 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.4000000000000001, 0, 0> texture { Material2 } }
torus { 0.55, 0.16 sturm translate <0, 0, 0> matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.1555555555555557, 0> texture { Material3 } }
cylinder { <-0.5, 0, 0>, <0.5, 0, 0>, 0.07 matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.1555555555555557, 0> texture { Material3 } }
#break
#case (19)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.4, 0.5, 0.6> }

camera {
  perspective
  location <0, 1.8, 8>
  direction <-0.000764326703646651, -0.12428754274874515, -0.9922462756937257>
  right <0.9783381806677133, 0, 0>
  up <0, 0.6067395828880445, -0.07584244786100557>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.62, 0.6, 0.55> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.2, 0.22, 0.25> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.52, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.4, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.3, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.65, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 0.7, 0>, 0.7 texture { Material1 } }
sphere { <-2.9, 0.7, 0>, 0.7 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.38000000000000006, 0, 0> texture { Material2 } }
torus { 0.55, 0.16 sturm translate <0, 0, 0> matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.137777777777778, 0> texture { Material3 } }
cylinder { <-0.5, 0, 0>, <0.5, 0, 0>, 0.07 matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.137777777777778, 0> texture { Material3 } }
#break
#case (20)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.4, 0.5, 0.6> }

camera {
  perspective
  location <0, 1.8, 8>
  direction <-0.0002547755678822171, -0.12428754274874515, -0.9922462756937257>
  right <0.9783381806677133, 0, 0>
  up <0, 0.6067395828880445, -0.07584244786100557>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.62, 0.6, 0.55> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.2, 0.22, 0.25> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.52, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.4, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.3, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.65, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 0.7, 0>, 0.7 texture { Material1 } }
sphere { <-2.9, 0.7, 0>, 0.7 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.22000000000000003, 0, 0> texture { Material2 } }
torus { 0.55, 0.16 sturm translate <0, 0, 0> matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 0.9955555555555556, 0> texture { Material3 } }
cylinder { <-0.5, 0, 0>, <0.5, 0, 0>, 0.07 matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 0.9955555555555556, 0> texture { Material3 } }
#break
#case (21)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.4, 0.5, 0.6> }

camera {
  perspective
  location <0, 1.8, 8>
  direction <0.0002547755678822168, -0.12428754274874515, -0.9922462756937257>
  right <0.9783381806677133, 0, 0>
  up <0, 0.6067395828880445, -0.07584244786100557>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.62, 0.6, 0.55> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.2, 0.22, 0.25> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.52, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.4, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.3, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.65, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 0.7, 0>, 0.7 texture { Material1 } }
sphere { <-2.9, 0.7, 0>, 0.7 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.44000000000000006, 0, 0> texture { Material2 } }
torus { 0.55, 0.16 sturm translate <0, 0, 0> matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.1911111111111112, 0> texture { Material3 } }
cylinder { <-0.5, 0, 0>, <0.5, 0, 0>, 0.07 matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.1911111111111112, 0> texture { Material3 } }
#break
#case (22)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.4, 0.5, 0.6> }

camera {
  perspective
  location <0, 1.8, 8>
  direction <0.000764326703646651, -0.12428754274874515, -0.9922462756937257>
  right <0.9783381806677133, 0, 0>
  up <0, 0.6067395828880445, -0.07584244786100557>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.62, 0.6, 0.55> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.2, 0.22, 0.25> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.52, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.4, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.3, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.65, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 0.7, 0>, 0.7 texture { Material1 } }
sphere { <-2.9, 0.7, 0>, 0.7 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.2, 0, 0> texture { Material2 } }
torus { 0.55, 0.16 sturm translate <0, 0, 0> matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 0.9777777777777779, 0> texture { Material3 } }
cylinder { <-0.5, 0, 0>, <0.5, 0, 0>, 0.07 matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 0.9777777777777779, 0> texture { Material3 } }
#break
#case (23)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.4, 0.5, 0.6> }

camera {
  perspective
  location <0, 1.8, 8>
  direction <0.0012738778394110852, -0.12428754274874515, -0.9922462756937257>
  right <0.9783381806677133, 0, 0>
  up <0, 0.6067395828880445, -0.07584244786100557>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.62, 0.6, 0.55> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.2, 0.22, 0.25> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.52, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.4, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.3, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.65, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 0.7, 0>, 0.7 texture { Material1 } }
sphere { <-2.9, 0.7, 0>, 0.7 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.18000000000000002, 0, 0> texture { Material2 } }
torus { 0.55, 0.16 sturm translate <0, 0, 0> matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 0.9600000000000001, 0> texture { Material3 } }
cylinder { <-0.5, 0, 0>, <0.5, 0, 0>, 0.07 matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 0.9600000000000001, 0> texture { Material3 } }
#break
#case (24)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.4, 0.5, 0.6> }

camera {
  perspective
  location <0, 1.8, 8>
  direction <-0.0012738778394110852, -0.12479315906781853, -0.9921830736538415>
  right <0.9783381806677133, 0, 0>
  up <0, 0.6067395828880445, -0.07584244786100557>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.62, 0.6, 0.55> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.2, 0.22, 0.25> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.52, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.4, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.3, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.65, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 0.7, 0>, 0.7 texture { Material1 } }
sphere { <-2.9, 0.7, 0>, 0.7 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.06, 0, 0> texture { Material2 } }
torus { 0.55, 0.16 sturm translate <0, 0, 0> matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 0.8533333333333334, 0> texture { Material3 } }
cylinder { <-0.5, 0, 0>, <0.5, 0, 0>, 0.07 matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 0.8533333333333334, 0> texture { Material3 } }
#break
#case (25)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.4, 0.5, 0.6> }

camera {
  perspective
  location <0, 1.8, 8>
  direction <-0.000764326703646651, -0.12479315906781853, -0.9921830736538415>
  right <0.9783381806677133, 0, 0>
  up <0, 0.6067395828880445, -0.07584244786100557>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.62, 0.6, 0.55> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.2, 0.22, 0.25> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.52, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.4, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.3, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.65, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 0.7, 0>, 0.7 texture { Material1 } }
sphere { <-2.9, 0.7, 0>, 0.7 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.5800000000000001, 0, 0> texture { Material2 } }
torus { 0.55, 0.16 sturm translate <0, 0, 0> matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.3155555555555556, 0> texture { Material3 } }
cylinder { <-0.5, 0, 0>, <0.5, 0, 0>, 0.07 matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.3155555555555556, 0> texture { Material3 } }
#break
#case (26)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.4, 0.5, 0.6> }

camera {
  perspective
  location <0, 1.8, 8>
  direction <-0.0002547755678822171, -0.12479315906781853, -0.9921830736538415>
  right <0.9783381806677133, 0, 0>
  up <0, 0.6067395828880445, -0.07584244786100557>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.62, 0.6, 0.55> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.2, 0.22, 0.25> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.52, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.4, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.3, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.65, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 0.7, 0>, 0.7 texture { Material1 } }
sphere { <-2.9, 0.7, 0>, 0.7 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.56, 0, 0> texture { Material2 } }
torus { 0.55, 0.16 sturm translate <0, 0, 0> matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.297777777777778, 0> texture { Material3 } }
cylinder { <-0.5, 0, 0>, <0.5, 0, 0>, 0.07 matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.297777777777778, 0> texture { Material3 } }
#break
#case (27)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.4, 0.5, 0.6> }

camera {
  perspective
  location <0, 1.8, 8>
  direction <0.0002547755678822168, -0.12479315906781853, -0.9921830736538415>
  right <0.9783381806677133, 0, 0>
  up <0, 0.6067395828880445, -0.07584244786100557>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.62, 0.6, 0.55> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.2, 0.22, 0.25> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.52, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.4, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.3, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.65, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 0.7, 0>, 0.7 texture { Material1 } }
sphere { <-2.9, 0.7, 0>, 0.7 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.5, 0, 0> texture { Material2 } }
torus { 0.55, 0.16 sturm translate <0, 0, 0> matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.2444444444444445, 0> texture { Material3 } }
cylinder { <-0.5, 0, 0>, <0.5, 0, 0>, 0.07 matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.2444444444444445, 0> texture { Material3 } }
#break
#case (28)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.4, 0.5, 0.6> }

camera {
  perspective
  location <0, 1.8, 8>
  direction <0.000764326703646651, -0.12479315906781853, -0.9921830736538415>
  right <0.9783381806677133, 0, 0>
  up <0, 0.6067395828880445, -0.07584244786100557>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.62, 0.6, 0.55> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.2, 0.22, 0.25> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.52, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.4, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.3, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.65, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 0.7, 0>, 0.7 texture { Material1 } }
sphere { <-2.9, 0.7, 0>, 0.7 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.10392304845413265, 0, 0> texture { Material2 } }
torus { 0.55, 0.16 sturm translate <0, 0, 0> matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 0.8923760430703402, 0> texture { Material3 } }
cylinder { <-0.5, 0, 0>, <0.5, 0, 0>, 0.07 matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 0.8923760430703402, 0> texture { Material3 } }
#break
#case (29)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.4, 0.5, 0.6> }

camera {
  perspective
  location <0, 1.8, 8>
  direction <0.0012738778394110852, -0.12479315906781853, -0.9921830736538415>
  right <0.9783381806677133, 0, 0>
  up <0, 0.6067395828880445, -0.07584244786100557>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.62, 0.6, 0.55> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.2, 0.22, 0.25> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.52, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.4, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.3, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.65, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 0.7, 0>, 0.7 texture { Material1 } }
sphere { <-2.9, 0.7, 0>, 0.7 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.52, 0, 0> texture { Material2 } }
torus { 0.55, 0.16 sturm translate <0, 0, 0> matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.2622222222222224, 0> texture { Material3 } }
cylinder { <-0.5, 0, 0>, <0.5, 0, 0>, 0.07 matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.2622222222222224, 0> texture { Material3 } }
#break
#case (30)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.4, 0.5, 0.6> }

camera {
  perspective
  location <0, 1.8, 8>
  direction <-0.0012738778394110852, -0.12529877538689188, -0.9921198716139573>
  right <0.9783381806677133, 0, 0>
  up <0, 0.6067395828880445, -0.07584244786100557>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.62, 0.6, 0.55> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.2, 0.22, 0.25> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.52, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.4, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.3, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.65, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 0.7, 0>, 0.7 texture { Material1 } }
sphere { <-2.9, 0.7, 0>, 0.7 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.48, 0, 0> texture { Material2 } }
torus { 0.55, 0.16 sturm translate <0, 0, 0> matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.2266666666666668, 0> texture { Material3 } }
cylinder { <-0.5, 0, 0>, <0.5, 0, 0>, 0.07 matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.2266666666666668, 0> texture { Material3 } }
#break
#case (31)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.4, 0.5, 0.6> }

camera {
  perspective
  location <0, 1.8, 8>
  direction <-0.000764326703646651, -0.12529877538689188, -0.9921198716139573>
  right <0.9783381806677133, 0, 0>
  up <0, 0.6067395828880445, -0.07584244786100557>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.62, 0.6, 0.55> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.2, 0.22, 0.25> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.52, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.4, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.3, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.65, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 0.7, 0>, 0.7 texture { Material1 } }
sphere { <-2.9, 0.7, 0>, 0.7 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.8400000000000001, 0, 0> texture { Material2 } }
torus { 0.55, 0.16 sturm translate <0, 0, 0> matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.5466666666666669, 0> texture { Material3 } }
cylinder { <-0.5, 0, 0>, <0.5, 0, 0>, 0.07 matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.5466666666666669, 0> texture { Material3 } }
#break
#case (32)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.4, 0.5, 0.6> }

camera {
  perspective
  location <0, 1.8, 8>
  direction <-0.0002547755678822171, -0.12529877538689188, -0.9921198716139573>
  right <0.9783381806677133, 0, 0>
  up <0, 0.6067395828880445, -0.07584244786100557>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.62, 0.6, 0.55> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.2, 0.22, 0.25> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.52, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.4, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.3, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.65, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 0.7, 0>, 0.7 texture { Material1 } }
sphere { <-2.9, 0.7, 0>, 0.7 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.36000000000000004, 0, 0> texture { Material2 } }
torus { 0.55, 0.16 sturm translate <0, 0, 0> matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.12, 0> texture { Material3 } }
cylinder { <-0.5, 0, 0>, <0.5, 0, 0>, 0.07 matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.12, 0> texture { Material3 } }
#break
#case (33)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.4, 0.5, 0.6> }

camera {
  perspective
  location <0, 1.8, 8>
  direction <0.0002547755678822168, -0.12529877538689188, -0.9921198716139573>
  right <0.9783381806677133, 0, 0>
  up <0, 0.6067395828880445, -0.07584244786100557>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.62, 0.6, 0.55> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.2, 0.22, 0.25> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.52, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.4, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.3, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.65, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 0.7, 0>, 0.7 texture { Material1 } }
sphere { <-2.9, 0.7, 0>, 0.7 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.24000000000000005, 0, 0> texture { Material2 } }
torus { 0.55, 0.16 sturm translate <0, 0, 0> matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.0133333333333334, 0> texture { Material3 } }
cylinder { <-0.5, 0, 0>, <0.5, 0, 0>, 0.07 matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.0133333333333334, 0> texture { Material3 } }
#break
#case (34)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.4, 0.5, 0.6> }

camera {
  perspective
  location <0, 1.8, 8>
  direction <0.000764326703646651, -0.12529877538689188, -0.9921198716139573>
  right <0.9783381806677133, 0, 0>
  up <0, 0.6067395828880445, -0.07584244786100557>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.62, 0.6, 0.55> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.2, 0.22, 0.25> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.52, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.4, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.3, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.65, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 0.7, 0>, 0.7 texture { Material1 } }
sphere { <-2.9, 0.7, 0>, 0.7 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.42000000000000004, 0, 0> texture { Material2 } }
torus { 0.55, 0.16 sturm translate <0, 0, 0> matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.1733333333333333, 0> texture { Material3 } }
cylinder { <-0.5, 0, 0>, <0.5, 0, 0>, 0.07 matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 1.1733333333333333, 0> texture { Material3 } }
#break
#case (35)
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
background { rgb <0.4, 0.5, 0.6> }

camera {
  perspective
  location <0, 1.8, 8>
  direction <0.0012738778394110852, -0.12529877538689188, -0.9921198716139573>
  right <0.9783381806677133, 0, 0>
  up <0, 0.6067395828880445, -0.07584244786100557>
}

light_source { <37139.06763541037, 74278.13527082074, 55708.60145311556> rgb <0.62, 0.6, 0.55> parallel point_at 0 }
light_source { <-57735.02691896258, 57735.02691896258, 57735.02691896258> rgb <0.2, 0.22, 0.25> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.52, 0.48> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.4, 0.7> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.3, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

#declare Material3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.8, 0.65, 0.2> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <0, 0.7, 0>, 0.7 texture { Material1 } }
sphere { <-2.9, 0.7, 0>, 0.7 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1341640786499874, 0, 0> texture { Material2 } }
torus { 0.55, 0.16 sturm translate <0, 0, 0> matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 0.9192569587999888, 0> texture { Material3 } }
cylinder { <-0.5, 0, 0>, <0.5, 0, 0>, 0.07 matrix <0.9396926207859084, 0.3420201433256687, 0, -0.144543958452599, 0.39713126196710286, 0.9063077870366499, 0.30997551921944466, -0.8516507396391465, 0.42261826174069944, 2, 0.9192569587999888, 0> texture { Material3 } }
#break
#end
