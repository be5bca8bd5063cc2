// city.scene, written by `course export`.
// povray +Icity.pov +Ocity.png +W320 +H240 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 2 adc_bailout 0 }
background { rgb <0.5, 0.64, 0.82> }

camera {
  perspective
  location <0, 34, 150>
  direction <0, -0.05325764291615076, -0.9985808046778267>
  right <1.0774032688937514, 0, 0>
  up <0, 0.8069056674108325, -0.04303496892857773>
}

light_source { <-52572.95452059881, 70097.27269413177, 48191.874977215586> rgb <0.8, 0.72, 0.58> parallel point_at 0 }
light_source { <66742.38124719146, 47673.12946227961, 57207.755354735535> rgb <0.12, 0.14, 0.2> parallel point_at 0 }

#declare Material0 =
  texture { pigment { rgb <0.05, 0.05, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.3, 0.3, 0.31> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material1 =
  texture { pigment { rgb <0.2, 0.26, 0.34> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.13, 0.12> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material2 =
  texture { pigment { rgb <0.087, 0.077, 0.064> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.62, 0.55, 0.46> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material3 =
  texture { pigment { rgb <0.059, 0.064, 0.073> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.42, 0.46, 0.52> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material4 =
  texture { pigment { rgb <0.077, 0.05, 0.039> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.55, 0.36, 0.28> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material5 =
  texture { pigment { rgb <0.098, 0.095, 0.09> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.7, 0.68, 0.64> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material6 =
  texture { pigment { rgb 0.02 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.1, 0.11> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material7 =
  texture { pigment { rgb <0.75, 0.68, 0.5> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.2, 0.2, 0.18> transmit 0.5 } finish { ambient 0 diffuse 2 } }

#declare Material8 =
  texture { pigment { rgb <0.072, 0.01, 0.007> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.6, 0.08, 0.06> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.2 } specular 0.2 roughness 0.016666666666666666 } }

#declare Material9 =
  texture { pigment { rgb <0.012, 0.024, 0.06> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.1, 0.2, 0.5> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.2 } specular 0.2 roughness 0.016666666666666666 } }

#declare Material10 =
  texture { pigment { rgb <0.09, 0.09, 0.086> } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.75, 0.75, 0.72> transmit 0.5 } finish { ambient 0 diffuse 2 reflection { rgb 0.2 } specular 0.2 roughness 0.016666666666666666 } }

plane { <0, 1, 0>, 0 texture { Material0 } }
sphere { <-1618, -260, -1500>, 333 texture { Material1 } }
sphere { <-1220, -260, -1500>, 386 texture { Material1 } }
sphere { <-818, -260, -1500>, 373 texture { Material1 } }
sphere { <-322, -260, -1500>, 378 texture { Material1 } }
sphere { <73, -260, -1500>, 375 texture { Material1 } }
sphere { <487, -260, -1500>, 365 texture { Material1 } }
sphere { <919, -260, -1500>, 358 texture { Material1 } }
sphere { <1383, -260, -1500>, 368 texture { Material1 } }
sphere { <1830, -260, -1500>, 365 texture { Material1 } }
box { <-179.55, 0, -307.02>, <-167.23, 6.55, -292.49> texture { Material2 } }
box { <-170.75, 6.55, -302.13>, <-167.44, 9.71, -299.13> texture { Material2 } }
box { <-170.35, 6.55, -301.73>, <-170.05, 18.55, -301.43> texture { Material2 } }
box { <-181.89, 0, -285.69>, <-166.06, 5.77, -270.16> texture { Material2 } }
box { <-178.76, 5.77, -281.39>, <-175.66, 8.11, -278.39> texture { Material2 } }
box { <-180.2, 0, -262.46>, <-166.9, 3.98, -248.77> texture { Material2 } }
box { <-175.19, 3.98, -258.76>, <-171.74, 6.82, -255.76> texture { Material2 } }
box { <-174.79, 3.98, -258.36>, <-174.49, 15.98, -258.06> texture { Material2 } }
box { <-181.9, 0, -241.68>, <-166.05, 4.31, -226.16> texture { Material2 } }
box { <-173.63, 4.31, -231.82>, <-170.76, 7.87, -228.82> texture { Material2 } }
box { <-173.23, 4.31, -231.42>, <-172.93, 16.31, -231.12> texture { Material2 } }
box { <-180.08, 0, -197.04>, <-166.96, 6.43, -182.48> texture { Material2 } }
box { <-171.05, 6.43, -189.39>, <-168.29, 8.54, -186.39> texture { Material2 } }
box { <-170.65, 6.43, -188.99>, <-170.35, 18.43, -188.69> texture { Material2 } }
box { <-181.45, 0, -175.04>, <-166.27, 7.87, -160.48> texture { Material2 } }
box { <-177.18, 7.87, -172.43>, <-174.75, 11.3, -169.43> texture { Material2 } }
box { <-176.78, 7.87, -172.03>, <-176.48, 19.87, -171.73> texture { Material2 } }
box { <-179.71, 0, -153.79>, <-167.15, 7.96, -138.1> texture { Material2 } }
box { <-171.32, 7.96, -148.27>, <-168.89, 10.15, -145.27> texture { Material2 } }
box { <-181.29, 0, -87.98>, <-166.35, 6.86, -72.01> texture { Material2 } }
box { <-174.67, 6.86, -78.01>, <-171.39, 8.95, -75.01> texture { Material2 } }
box { <-180.62, 0, -63.36>, <-166.69, 12.11, -51.32> texture { Material2 } }
box { <-172.05, 12.11, -54.79>, <-168.17, 14.12, -51.79> texture { Material2 } }
box { <-181.25, 0, 24.72>, <-166.38, 9, 36.64> texture { Material2 } }
box { <-175.28, 9, 34.38>, <-172.17, 11.14, 37.38> texture { Material2 } }
box { <-179.11, 0, 68.22>, <-167.45, 7.94, 80.89> texture { Material2 } }
box { <-176.33, 7.94, 74.4>, <-172.4, 11.85, 77.4> texture { Material2 } }
box { <-175.93, 7.94, 74.8>, <-175.63, 19.94, 75.1> texture { Material2 } }
box { <-157.25, 0, -305.33>, <-145.37, 5.3, -293.33> texture { Material2 } }
box { <-151.04, 5.3, -295.4>, <-148.69, 8.01, -292.4> texture { Material2 } }
box { <-159.98, 0, -196.79>, <-144.01, 11.04, -182.6> texture { Material2 } }
box { <-153.3, 11.04, -192.8>, <-149.45, 14.56, -189.8> texture { Material2 } }
box { <-159, 0, -87.55>, <-144.5, 11.52, -72.23> texture { Material2 } }
box { <-153.36, 11.52, -85.15>, <-150.91, 14.25, -82.15> texture { Material2 } }
box { <-159.56, 0, -65.7>, <-144.22, 8.5, -50.15> texture { Material2 } }
box { <-156.27, 8.5, -62.65>, <-154.05, 11.66, -59.65> texture { Material2 } }
box { <-137.49, 0, -261.96>, <-122.26, 5.61, -249.02> texture { Material2 } }
box { <-127.66, 5.61, -259.66>, <-124.22, 8.8, -256.66> texture { Material2 } }
box { <-127.26, 5.61, -259.26>, <-126.96, 17.61, -258.96> texture { Material2 } }
box { <-136.14, 0, -241.5>, <-122.93, 7.77, -226.25> texture { Material2 } }
box { <-128.33, 7.77, -232.99>, <-125.57, 10.29, -229.99> texture { Material2 } }
box { <-136.75, 0, -129.18>, <-122.63, 15.48, -117.41> texture { Material2 } }
box { <-129.18, 15.48, -124.84>, <-126.95, 19.05, -121.84> texture { Material2 } }
box { <-136.43, 0, 23.03>, <-122.79, 8.17, 37.48> texture { Material2 } }
box { <-133.43, 8.17, 28.5>, <-130.94, 11.15, 31.5> texture { Material2 } }
box { <-133.03, 8.17, 28.9>, <-132.73, 20.17, 29.2> texture { Material2 } }
box { <-136.34, 0, 45.56>, <-122.83, 13.34, 59.22> texture { Material2 } }
box { <-133.8, 13.34, 51.25>, <-131.03, 16.51, 54.25> texture { Material2 } }
box { <-133.4, 13.34, 51.65>, <-133.1, 25.34, 51.95> texture { Material2 } }
box { <-136.74, 0, 67.52>, <-122.63, 6.28, 81.24> texture { Material2 } }
box { <-127.02, 6.28, 71.4>, <-123.91, 9.75, 74.4> texture { Material2 } }
box { <-113.12, 0, -305.45>, <-101.44, 7.27, -293.28> texture { Material2 } }
box { <-109.24, 7.27, -299.12>, <-105.39, 9.56, -296.12> texture { Material2 } }
box { <-113.27, 0, -263.26>, <-101.37, 6.75, -248.37> texture { Material2 } }
box { <-107.9, 6.75, -254.38>, <-105.26, 9.1, -251.38> texture { Material2 } }
box { <-114.26, 0, -241.68>, <-100.87, 4.7, -226.16> texture { Material2 } }
box { <-104.93, 4.7, -232.81>, <-102.9, 6.7, -229.81> texture { Material2 } }
box { <-114.86, 0, -174.7>, <-100.57, 9.4, -160.65> texture { Material2 } }
box { <-108.99, 9.4, -166.27>, <-106.25, 13.33, -163.27> texture { Material2 } }
box { <-114.47, 0, -109.67>, <-100.77, 10.83, -94.17> texture { Material2 } }
box { <-108.59, 10.83, -107.2>, <-104.61, 14.2, -104.2> texture { Material2 } }
box { <-113.66, 0, -85.62>, <-101.17, 24.84, -73.19> texture { Material2 } }
box { <-105.21, 24.84, -82.08>, <-102.86, 27.98, -79.08> texture { Material2 } }
box { <-104.81, 24.84, -81.68>, <-104.51, 36.84, -81.38> texture { Material2 } }
box { <-91.54, 0, -283.89>, <-79.23, 8.06, -271.05> texture { Material2 } }
box { <-82.97, 8.06, -278.7>, <-79.44, 10.79, -275.7> texture { Material2 } }
box { <-92.37, 0, -263.31>, <-78.82, 5.06, -248.35> texture { Material2 } }
box { <-86, 5.06, -254.14>, <-82.65, 7.69, -251.14> texture { Material2 } }
box { <-92.4, 0, -195.39>, <-78.8, 12.74, -183.3> texture { Material2 } }
box { <-90.01, 12.74, -189.41>, <-86.86, 16.6, -186.41> texture { Material2 } }
box { <-89.61, 12.74, -189.01>, <-89.31, 24.74, -188.71> texture { Material2 } }
box { <-93.94, 0, -173.62>, <-78.03, 11.76, -161.19> texture { Material2 } }
box { <-88.3, 11.76, -168.33>, <-84.59, 14.61, -165.33> texture { Material2 } }
box { <-93.23, 0, -130.71>, <-78.38, 16.25, -116.65> texture { Material2 } }
box { <-89.22, 16.25, -125.89>, <-86.5, 19.4, -122.89> texture { Material2 } }
box { <-93.35, 0, -109.94>, <-78.32, 22.42, -94.03> texture { Material2 } }
box { <-87.59, 22.42, -100.71>, <-83.86, 24.55, -97.71> texture { Material2 } }
box { <-93.67, 0, -41.79>, <-78.16, 41.82, -29.1> texture { Material2 } }
box { <-85.38, 41.82, -35.89>, <-82.88, 44.82, -32.89> texture { Material2 } }
box { <-93.42, 0, 24.57>, <-78.29, 23.94, 36.72> texture { Material2 } }
box { <-88.56, 23.94, 31.88>, <-84.72, 26.23, 34.88> texture { Material2 } }
box { <-88.16, 23.94, 32.28>, <-87.86, 35.94, 32.58> texture { Material2 } }
box { <-69.22, 0, -307.31>, <-57.39, 6.54, -292.34> texture { Material2 } }
box { <-66.18, 6.54, -304.4>, <-62.75, 10.43, -301.4> texture { Material2 } }
box { <-65.78, 6.54, -304>, <-65.48, 18.54, -303.7> texture { Material2 } }
box { <-71.01, 0, -263.66>, <-56.5, 5.85, -248.17> texture { Material2 } }
box { <-68.09, 5.85, -260.94>, <-65.57, 8.73, -257.94> texture { Material2 } }
box { <-70.28, 0, -240.12>, <-56.86, 9.47, -226.94> texture { Material2 } }
box { <-67.46, 9.47, -231.54>, <-63.79, 12.53, -228.54> texture { Material2 } }
box { <-69.13, 0, -195.26>, <-57.44, 10.4, -183.37> texture { Material2 } }
box { <-62.9, 10.4, -185.82>, <-60.61, 14.38, -182.82> texture { Material2 } }
box { <-71.55, 0, -175.76>, <-56.22, 10.38, -160.12> texture { Material2 } }
box { <-63.65, 10.38, -169.55>, <-60.17, 13.49, -166.55> texture { Material2 } }
box { <-69.16, 0, 1.45>, <-57.42, 44.15, 15.28> texture { Material2 } }
box { <-63.24, 44.15, 9.54>, <-60.69, 48.11, 12.54> texture { Material2 } }
box { <-70.21, 0, 22.73>, <-56.89, 26.89, 37.63> texture { Material2 } }
box { <-62.82, 26.89, 32.12>, <-59.94, 29.7, 35.12> texture { Material2 } }
box { <-71.05, 0, 46.21>, <-56.47, 30.25, 58.89> texture { Material2 } }
box { <-66.15, 30.25, 52.84>, <-63.13, 33.49, 55.84> texture { Material2 } }
box { <-71.79, 0, 67.5>, <-56.1, 20.87, 81.25> texture { Material2 } }
box { <-67.47, 20.87, 75.56>, <-64.89, 23.55, 78.56> texture { Material2 } }
box { <-47.61, 0, -261.24>, <-35.2, 7.54, -249.38> texture { Material2 } }
box { <-43.91, 7.54, -258.83>, <-40.57, 11.38, -255.83> texture { Material2 } }
box { <-47.09, 0, -173.89>, <-35.45, 29.96, -161.06> texture { Material2 } }
box { <-43.82, 29.96, -171.76>, <-40.97, 33.56, -168.76> texture { Material2 } }
box { <-43.42, 29.96, -171.36>, <-43.12, 41.96, -171.06> texture { Material2 } }
box { <-47.27, 0, -153.35>, <-35.36, 35.08, -138.33> texture { Material2 } }
box { <-42.73, 35.08, -144.17>, <-39.44, 37.75, -141.17> texture { Material2 } }
box { <-49.21, 0, -131.29>, <-34.4, 43.7, -116.35> texture { Material2 } }
box { <-44.81, 43.7, -127.75>, <-41.84, 46.39, -124.75> texture { Material2 } }
box { <-47.61, 0, -63.84>, <-35.19, 63.28, -51.08> texture { Material2 } }
box { <-43.95, 63.28, -58.02>, <-41.16, 66.27, -55.02> texture { Material2 } }
box { <-47.15, 0, 0.99>, <-35.43, 56.28, 15.51> texture { Material2 } }
box { <-39.02, 56.28, 8.84>, <-36.71, 59.64, 11.84> texture { Material2 } }
box { <-26.39, 0, -262.98>, <-12.81, 7.56, -248.51> texture { Material2 } }
box { <-19.28, 7.56, -256.78>, <-16.64, 11.37, -253.78> texture { Material2 } }
box { <-27.25, 0, -108.96>, <-12.38, 35.63, -94.52> texture { Material2 } }
box { <-17.81, 35.63, -99.15>, <-14.58, 37.97, -96.15> texture { Material2 } }
box { <-17.41, 35.63, -98.75>, <-17.11, 47.63, -98.45> texture { Material2 } }
box { <-27.71, 0, -42.08>, <-12.15, 54.5, -28.96> texture { Material2 } }
box { <-25.3, 54.5, -39.74>, <-22.82, 57.23, -36.74> texture { Material2 } }
box { <-27.48, 0, 45.63>, <-12.26, 28.82, 59.18> texture { Material2 } }
box { <-21.27, 28.82, 50.62>, <-18.06, 31.08, 53.62> texture { Material2 } }
box { <-20.87, 28.82, 51.02>, <-20.57, 40.82, 51.32> texture { Material2 } }
box { <-25.25, 0, 66.2>, <-13.37, 12.75, 81.9> texture { Material2 } }
box { <-20.56, 12.75, 75.67>, <-18.33, 15.88, 78.67> texture { Material2 } }
box { <-25.16, 0, 88.27>, <-13.42, 12.88, 103.87> texture { Material2 } }
box { <-20.69, 12.88, 95.37>, <-17.54, 16.02, 98.37> texture { Material2 } }
box { <-20.29, 12.88, 95.77>, <-19.99, 24.88, 96.07> texture { Material2 } }
box { <14.5, 0, -307.43>, <26.75, 7.54, -292.28> texture { Material2 } }
box { <16.7, 7.54, -300.31>, <20.45, 11.09, -297.31> texture { Material2 } }
box { <13, 0, -261.82>, <27.5, 8.82, -249.09> texture { Material2 } }
box { <16.28, 8.82, -255.37>, <18.48, 12.64, -252.37> texture { Material2 } }
box { <14.94, 0, 89.88>, <26.53, 26.94, 103.06> texture { Material2 } }
box { <20.41, 26.94, 95.52>, <24.13, 29.34, 98.52> texture { Material2 } }
box { <20.81, 26.94, 95.92>, <21.11, 38.94, 96.22> texture { Material2 } }
box { <34.09, 0, -152.44>, <49.95, 49.36, -138.78> texture { Material2 } }
box { <43.46, 49.36, -149.94>, <46.3, 51.7, -146.94> texture { Material2 } }
box { <36.69, 0, -85.94>, <48.66, 82.34, -73.03> texture { Material2 } }
box { <43.42, 82.34, -77.8>, <47.41, 86.26, -74.8> texture { Material2 } }
box { <43.82, 82.34, -77.4>, <44.12, 94.34, -77.1> texture { Material2 } }
box { <34.53, 0, 22.97>, <49.73, 22.85, 37.52> texture { Material2 } }
box { <43.94, 22.85, 31.86>, <46.82, 26.32, 34.86> texture { Material2 } }
box { <34.25, 0, 68.92>, <49.87, 31.83, 80.54> texture { Material2 } }
box { <41.94, 31.83, 76.1>, <44.69, 35.53, 79.1> texture { Material2 } }
box { <42.34, 31.83, 76.5>, <42.64, 43.83, 76.8> texture { Material2 } }
box { <57.12, 0, -217.95>, <71.44, 16.51, -205.03> texture { Material2 } }
box { <62.95, 16.51, -215.88>, <66.44, 19.67, -212.88> texture { Material2 } }
box { <63.35, 16.51, -215.48>, <63.65, 28.51, -215.18> texture { Material2 } }
box { <57.81, 0, -43.64>, <71.1, 72.27, -28.18> texture { Material2 } }
box { <64.62, 72.27, -37.31>, <67.98, 74.73, -34.31> texture { Material2 } }
box { <57.57, 0, -20.34>, <71.22, 38.48, -6.83> texture { Material2 } }
box { <63.94, 38.48, -13.73>, <66.6, 41.06, -10.73> texture { Material2 } }
box { <78.28, 0, -306.62>, <93.86, 6.35, -292.69> texture { Material2 } }
box { <84.37, 6.35, -297.1>, <87.41, 9.07, -294.1> texture { Material2 } }
box { <80.12, 0, -285.56>, <92.94, 9.84, -270.22> texture { Material2 } }
box { <86.25, 9.84, -275.84>, <88.45, 12.07, -272.84> texture { Material2 } }
box { <86.65, 9.84, -275.44>, <86.95, 21.84, -275.14> texture { Material2 } }
box { <80.17, 0, -217.73>, <92.91, 12.81, -205.13> texture { Material2 } }
box { <82.61, 12.81, -212.99>, <85.84, 14.81, -209.99> texture { Material2 } }
box { <80.3, 0, -175.32>, <92.85, 14.74, -160.34> texture { Material2 } }
box { <85.58, 14.74, -168.93>, <88.39, 17.32, -165.93> texture { Material2 } }
box { <79.47, 0, -129.04>, <93.26, 14.53, -117.48> texture { Material2 } }
box { <85.71, 14.53, -121.18>, <88.49, 17.06, -118.18> texture { Material2 } }
box { <78.4, 0, -65.56>, <93.8, 46.36, -50.22> texture { Material2 } }
box { <85.83, 46.36, -61.57>, <88.37, 50.02, -58.57> texture { Material2 } }
box { <79.93, 0, -41.75>, <93.03, 25.26, -29.13> texture { Material2 } }
box { <86.63, 25.26, -34.98>, <89.61, 28.25, -31.98> texture { Material2 } }
box { <78.65, 0, 66.01>, <93.67, 12.8, 81.99> texture { Material2 } }
box { <86.02, 12.8, 71.6>, <89.93, 16.42, 74.6> texture { Material2 } }
box { <100.91, 0, -306.9>, <115.54, 5.2, -292.55> texture { Material2 } }
box { <103.51, 5.2, -304.16>, <107.01, 9.03, -301.16> texture { Material2 } }
box { <100.79, 0, -151.69>, <115.6, 14.8, -139.16> texture { Material2 } }
box { <105.35, 14.8, -147.61>, <108.94, 17.38, -144.61> texture { Material2 } }
box { <102.38, 0, 89.66>, <114.81, 6.06, 103.17> texture { Material2 } }
box { <105.96, 6.06, 95.56>, <108.03, 9.87, 98.56> texture { Material2 } }
box { <106.36, 6.06, 95.96>, <106.66, 18.06, 96.26> texture { Material2 } }
box { <124.47, 0, -283.4>, <136.76, 6.87, -271.3> texture { Material2 } }
box { <133.43, 6.87, -273.97>, <137.14, 8.97, -270.97> texture { Material2 } }
box { <122.76, 0, -175.87>, <137.62, 7.7, -160.07> texture { Material2 } }
box { <125.14, 7.7, -169.54>, <128.9, 10.36, -166.54> texture { Material2 } }
box { <125.54, 7.7, -169.14>, <125.84, 19.7, -168.84> texture { Material2 } }
box { <124.73, 0, -131.18>, <136.63, 15.21, -116.41> texture { Material2 } }
box { <129.83, 15.21, -124.41>, <131.94, 17.38, -121.41> texture { Material2 } }
box { <130.23, 15.21, -124.01>, <130.53, 27.21, -123.71> texture { Material2 } }
box { <124.07, 0, -21.59>, <136.96, 14.72, -6.21> texture { Material2 } }
box { <128.61, 14.72, -15.54>, <131.93, 18.58, -12.54> texture { Material2 } }
box { <129.01, 14.72, -15.14>, <129.31, 26.72, -14.84> texture { Material2 } }
box { <123.83, 0, 45.01>, <137.09, 10.17, 59.49> texture { Material2 } }
box { <132.62, 10.17, 53.62>, <136.6, 13.92, 56.62> texture { Material2 } }
box { <123.15, 0, 67.86>, <137.42, 10.21, 81.07> texture { Material2 } }
box { <129.62, 10.21, 73.02>, <133.3, 12.67, 76.02> texture { Material2 } }
box { <145.98, 0, -197.13>, <159.01, 9.89, -182.43> texture { Material2 } }
box { <148.77, 9.89, -187.4>, <151.85, 12.3, -184.4> texture { Material2 } }
box { <149.17, 9.89, -187>, <149.47, 21.89, -186.7> texture { Material2 } }
box { <145.89, 0, -153.47>, <159.05, 6.52, -138.27> texture { Material2 } }
box { <147.95, 6.52, -144.56>, <150.63, 10.13, -141.56> texture { Material2 } }
box { <144.19, 0, -85.76>, <159.91, 6.52, -73.12> texture { Material2 } }
box { <153.51, 6.52, -77.3>, <156.98, 8.82, -74.3> texture { Material2 } }
box { <153.91, 6.52, -76.9>, <154.21, 18.52, -76.6> texture { Material2 } }
box { <144.54, 0, 2.83>, <159.73, 12.57, 14.59> texture { Material2 } }
box { <152.03, 12.57, 6.96>, <155.39, 14.96, 9.96> texture { Material2 } }
box { <145.37, 0, 66.89>, <159.31, 6.92, 81.55> texture { Material2 } }
box { <149.22, 6.92, 73.94>, <152.34, 8.95, 76.94> texture { Material2 } }
box { <149.62, 6.92, 74.34>, <149.92, 18.92, 74.64> texture { Material2 } }
box { <168.59, 0, -197.14>, <180.71, 7.2, -182.43> texture { Material2 } }
box { <177.45, 7.2, -187.81>, <179.92, 9.39, -184.81> texture { Material2 } }
box { <177.85, 7.2, -187.41>, <178.15, 19.2, -187.11> texture { Material2 } }
box { <167.09, 0, -152.94>, <181.45, 10.52, -138.53> texture { Material2 } }
box { <175.12, 10.52, -144.71>, <177.8, 13.48, -141.71> texture { Material2 } }
box { <175.52, 10.52, -144.31>, <175.82, 22.52, -144.01> texture { Material2 } }
box { <168.39, 0, -107.47>, <180.8, 7.32, -95.27> texture { Material2 } }
box { <176.03, 7.32, -102.83>, <178.68, 9.36, -99.83> texture { Material2 } }
box { <176.43, 7.32, -102.43>, <176.73, 19.32, -102.13> texture { Material2 } }
box { <168.25, 0, -85.92>, <180.88, 9.76, -73.04> texture { Material2 } }
box { <177.43, 9.76, -76.7>, <179.93, 13.53, -73.7> texture { Material2 } }
box { <-179.52, 0, -107.17>, <-167.24, 6.02, -95.41> texture { Material3 } }
box { <-172.16, 6.02, -103.34>, <-169.23, 8.8, -100.34> texture { Material3 } }
box { <-180.35, 0, 0.54>, <-166.83, 9.3, 15.73> texture { Material3 } }
box { <-171.71, 9.3, 8.87>, <-168.4, 11.55, 11.87> texture { Material3 } }
box { <-159.58, 0, -284.2>, <-144.21, 6, -270.9> texture { Material3 } }
box { <-151.87, 6, -279.57>, <-147.95, 8.36, -276.57> texture { Material3 } }
box { <-158.92, 0, -42.49>, <-144.54, 5.58, -28.75> texture { Material3 } }
box { <-150.11, 5.58, -36.69>, <-146.88, 8.27, -33.69> texture { Material3 } }
box { <-149.71, 5.58, -36.29>, <-149.41, 17.58, -35.99> texture { Material3 } }
box { <-136.6, 0, -307.7>, <-122.7, 3.67, -292.15> texture { Material3 } }
box { <-129.39, 3.67, -300.59>, <-125.83, 7.21, -297.59> texture { Material3 } }
box { <-128.99, 3.67, -300.19>, <-128.69, 15.67, -299.89> texture { Material3 } }
box { <-137.63, 0, -285.76>, <-122.18, 3.76, -270.12> texture { Material3 } }
box { <-129.9, 3.76, -280.36>, <-127.4, 6.83, -277.36> texture { Material3 } }
box { <-135.07, 0, -217.24>, <-123.46, 7.03, -205.38> texture { Material3 } }
box { <-126.22, 7.03, -210.98>, <-123.57, 10.7, -207.98> texture { Material3 } }
box { <-136.66, 0, -195.31>, <-122.67, 10.49, -183.35> texture { Material3 } }
box { <-128.6, 10.49, -188.42>, <-125.93, 13.23, -185.42> texture { Material3 } }
box { <-137.51, 0, 90.28>, <-122.24, 9.64, 102.86> texture { Material3 } }
box { <-128.46, 9.64, 94.04>, <-124.88, 12.17, 97.04> texture { Material3 } }
box { <-128.06, 9.64, 94.44>, <-127.76, 21.64, 94.74> texture { Material3 } }
box { <-114.02, 0, -65.35>, <-100.99, 12.63, -50.33> texture { Material3 } }
box { <-104.95, 12.63, -61.88>, <-101.17, 16.26, -58.88> texture { Material3 } }
box { <-114.43, 0, -41.13>, <-100.78, 24.36, -29.44> texture { Material3 } }
box { <-105.07, 24.36, -32.59>, <-101.28, 27.92, -29.59> texture { Material3 } }
box { <-113.83, 0, -20.92>, <-101.09, 11.35, -6.54> texture { Material3 } }
box { <-104.16, 11.35, -14.48>, <-101.53, 15.01, -11.48> texture { Material3 } }
box { <-115.77, 0, 24.14>, <-100.11, 10.26, 36.93> texture { Material3 } }
box { <-107.86, 10.26, 32.87>, <-105.16, 13.91, 35.87> texture { Material3 } }
box { <-114.95, 0, 88.96>, <-100.52, 14.02, 103.52> texture { Material3 } }
box { <-112.62, 14.02, 95.38>, <-110.09, 16.06, 98.38> texture { Material3 } }
box { <-93.96, 0, -306.41>, <-78.02, 9.66, -292.79> texture { Material3 } }
box { <-90.76, 9.66, -299.82>, <-88.36, 12.45, -296.82> texture { Material3 } }
box { <-92.58, 0, -239.51>, <-78.71, 7.05, -227.25> texture { Material3 } }
box { <-83.79, 7.05, -233.4>, <-80.33, 9.81, -230.4> texture { Material3 } }
box { <-83.39, 7.05, -233>, <-83.09, 19.05, -232.7> texture { Material3 } }
box { <-71.23, 0, -283.38>, <-56.38, 11.57, -271.31> texture { Material3 } }
box { <-63.49, 11.57, -276.34>, <-60.49, 15.01, -273.34> texture { Material3 } }
box { <-70, 0, -218.84>, <-57, 12.37, -204.58> texture { Material3 } }
box { <-61.27, 12.37, -209.75>, <-57.29, 14.94, -206.75> texture { Material3 } }
box { <-60.87, 12.37, -209.35>, <-60.57, 24.37, -209.05> texture { Material3 } }
box { <-71.05, 0, -41.08>, <-56.48, 47.95, -29.46> texture { Material3 } }
box { <-65.29, 47.95, -37.16>, <-61.55, 51.11, -34.16> texture { Material3 } }
box { <-64.89, 47.95, -36.76>, <-64.59, 59.95, -36.46> texture { Material3 } }
box { <-71.32, 0, -21.07>, <-56.34, 39.51, -6.47> texture { Material3 } }
box { <-63.7, 39.51, -18.39>, <-60.65, 43.46, -15.39> texture { Material3 } }
box { <-49.78, 0, -196.86>, <-34.11, 21.59, -182.57> texture { Material3 } }
box { <-44.27, 21.59, -190.7>, <-41.14, 25.31, -187.7> texture { Material3 } }
box { <-43.87, 21.59, -190.3>, <-43.57, 33.59, -190> texture { Material3 } }
box { <-49.43, 0, -109.95>, <-34.28, 52.06, -94.03> texture { Material3 } }
box { <-40.62, 52.06, -104.16>, <-37.48, 55.97, -101.16> texture { Material3 } }
box { <-40.22, 52.06, -103.76>, <-39.92, 64.06, -103.46> texture { Material3 } }
box { <-47.95, 0, -87.5>, <-35.02, 34.45, -72.25> texture { Material3 } }
box { <-45.17, 34.45, -77.75>, <-42.62, 38.39, -74.75> texture { Material3 } }
box { <-48.09, 0, -20.75>, <-34.95, 54.49, -6.63> texture { Material3 } }
box { <-45.84, 54.49, -13.55>, <-41.93, 58.27, -10.55> texture { Material3 } }
box { <-49.8, 0, 22.28>, <-34.1, 24.54, 37.86> texture { Material3 } }
box { <-46.5, 24.54, 29.3>, <-44.29, 27.67, 32.3> texture { Material3 } }
box { <-46.1, 24.54, 29.7>, <-45.8, 36.54, 30> texture { Material3 } }
box { <-49.88, 0, 90.55>, <-34.06, 10.84, 102.72> texture { Material3 } }
box { <-47.7, 10.84, 92.71>, <-44.83, 13.11, 95.71> texture { Material3 } }
box { <-47.3, 10.84, 93.11>, <-47, 22.84, 93.41> texture { Material3 } }
box { <-26.29, 0, -307.37>, <-12.86, 7.91, -292.31> texture { Material3 } }
box { <-21.9, 7.91, -300.51>, <-19.11, 10.66, -297.51> texture { Material3 } }
box { <-25.63, 0, -240.92>, <-13.19, 16.93, -226.54> texture { Material3 } }
box { <-19.51, 16.93, -233.27>, <-16.75, 19.35, -230.27> texture { Material3 } }
box { <-19.11, 16.93, -232.87>, <-18.81, 28.93, -232.57> texture { Material3 } }
box { <-27.08, 0, -197.68>, <-12.46, 25.66, -182.16> texture { Material3 } }
box { <-24.45, 25.66, -195.13>, <-21.36, 28.05, -192.13> texture { Material3 } }
box { <-24.05, 25.66, -194.73>, <-23.75, 37.66, -194.43> texture { Material3 } }
box { <14.15, 0, -196.6>, <26.92, 22.02, -182.7> texture { Material3 } }
box { <17.88, 22.02, -190.61>, <20.07, 25.68, -187.61> texture { Material3 } }
box { <18.28, 22.02, -190.21>, <18.58, 34.02, -189.91> texture { Material3 } }
box { <13.42, 0, -153.99>, <27.29, 46.16, -138.01> texture { Material3 } }
box { <23.22, 46.16, -149.84>, <27.04, 49.65, -146.84> texture { Material3 } }
box { <14.39, 0, -64.51>, <26.81, 39.27, -50.74> texture { Material3 } }
box { <23.95, 39.27, -56.75>, <25.99, 41.79, -53.75> texture { Material3 } }
box { <14.37, 0, -42.59>, <26.81, 100.99, -28.7> texture { Material3 } }
box { <16.68, 100.99, -39.45>, <19.49, 103.08, -36.45> texture { Material3 } }
box { <17.08, 100.99, -39.05>, <17.38, 112.99, -38.75> texture { Material3 } }
box { <12.36, 0, 2.57>, <27.82, 72.63, 14.71> texture { Material3 } }
box { <16.78, 72.63, 10.27>, <19.78, 74.91, 13.27> texture { Material3 } }
box { <17.18, 72.63, 10.67>, <17.48, 84.63, 10.97> texture { Material3 } }
box { <13.09, 0, 24.81>, <27.46, 63.45, 36.6> texture { Material3 } }
box { <19.96, 63.45, 29.22>, <22.54, 66.77, 32.22> texture { Material3 } }
box { <34.21, 0, -285.66>, <49.9, 4.96, -270.17> texture { Material3 } }
box { <37.74, 4.96, -280.82>, <41.02, 8.38, -277.82> texture { Material3 } }
box { <35.9, 0, -131.92>, <49.05, 61.51, -116.04> texture { Material3 } }
box { <40.3, 61.51, -128.23>, <42.53, 63.58, -125.23> texture { Material3 } }
box { <34.85, 0, -43.33>, <49.58, 40.74, -28.33> texture { Material3 } }
box { <38.2, 40.74, -33.99>, <41.73, 43.83, -30.99> texture { Material3 } }
box { <56.35, 0, -240.82>, <71.82, 5.67, -226.59> texture { Material3 } }
box { <66.31, 5.67, -234.4>, <68.78, 8.56, -231.4> texture { Material3 } }
box { <57.07, 0, -197.2>, <71.46, 9.55, -182.4> texture { Material3 } }
box { <65.02, 9.55, -189.17>, <68.22, 11.75, -186.17> texture { Material3 } }
box { <65.42, 9.55, -188.77>, <65.72, 21.55, -188.47> texture { Material3 } }
box { <56.67, 0, 0.87>, <71.66, 24.3, 15.57> texture { Material3 } }
box { <66.36, 24.3, 9.78>, <69.92, 26.85, 12.78> texture { Material3 } }
box { <56.48, 0, 24.17>, <71.76, 32.12, 36.91> texture { Material3 } }
box { <62.25, 32.12, 31.54>, <64.72, 35.44, 34.54> texture { Material3 } }
box { <58.59, 0, 66.44>, <70.71, 10.45, 81.78> texture { Material3 } }
box { <61.09, 10.45, 72.8>, <64.42, 13.39, 75.8> texture { Material3 } }
box { <61.49, 10.45, 73.2>, <61.79, 22.45, 73.5> texture { Material3 } }
box { <78.03, 0, -240.43>, <93.98, 7.02, -226.78> texture { Material3 } }
box { <85.97, 7.02, -233.39>, <88.97, 10.05, -230.39> texture { Material3 } }
box { <80.92, 0, -197.84>, <92.54, 14.71, -182.08> texture { Material3 } }
box { <88.41, 14.71, -193.93>, <91.63, 17.17, -190.93> texture { Material3 } }
box { <78.06, 0, 23.32>, <93.97, 22.91, 37.34> texture { Material3 } }
box { <80.59, 22.91, 27.14>, <83.98, 25.74, 30.14> texture { Material3 } }
box { <78.72, 0, 45.59>, <93.64, 17.45, 59.21> texture { Material3 } }
box { <82.1, 17.45, 50.48>, <84.3, 21.17, 53.48> texture { Material3 } }
box { <82.5, 17.45, 50.88>, <82.8, 29.45, 51.18> texture { Material3 } }
box { <100.68, 0, -108.54>, <115.66, 24.19, -94.73> texture { Material3 } }
box { <105.43, 24.19, -99.14>, <108.69, 27.49, -96.14> texture { Material3 } }
box { <101.17, 0, -65.82>, <115.41, 20.9, -50.09> texture { Material3 } }
box { <107.53, 20.9, -63.81>, <111.2, 24.17, -60.81> texture { Material3 } }
box { <100.18, 0, -41.09>, <115.91, 26.51, -29.45> texture { Material3 } }
box { <108.24, 26.51, -35.93>, <111.06, 29.66, -32.93> texture { Material3 } }
box { <145.74, 0, -305.54>, <159.13, 3.77, -293.23> texture { Material3 } }
box { <150.61, 3.77, -297.36>, <153.45, 5.85, -294.36> texture { Material3 } }
box { <144.31, 0, -261.45>, <159.84, 3.73, -249.28> texture { Material3 } }
box { <150.59, 3.73, -252.73>, <153.39, 5.79, -249.73> texture { Material3 } }
box { <150.99, 3.73, -252.33>, <151.29, 15.73, -252.03> texture { Material3 } }
box { <145.37, 0, -174.8>, <159.31, 4.58, -160.6> texture { Material3 } }
box { <153.77, 4.58, -165.8>, <157.2, 7.77, -162.8> texture { Material3 } }
box { <154.17, 4.58, -165.4>, <154.47, 16.58, -165.1> texture { Material3 } }
box { <144.53, 0, -131.04>, <159.73, 11.73, -116.48> texture { Material3 } }
box { <153.16, 11.73, -122.3>, <155.82, 14.7, -119.3> texture { Material3 } }
box { <145.79, 0, -109.2>, <159.1, 7.06, -94.4> texture { Material3 } }
box { <152.67, 7.06, -101.31>, <156.65, 10.75, -98.31> texture { Material3 } }
box { <146.25, 0, -41.25>, <158.88, 12.25, -29.37> texture { Material3 } }
box { <151.9, 12.25, -35.71>, <155.45, 15.74, -32.71> texture { Material3 } }
box { <146.13, 0, 44.29>, <158.93, 5.91, 59.85> texture { Material3 } }
box { <155.74, 5.91, 48.57>, <158.42, 8.88, 51.57> texture { Material3 } }
box { <156.14, 5.91, 48.97>, <156.44, 17.91, 49.27> texture { Material3 } }
box { <144.93, 0, 88.04>, <159.54, 11.35, 103.98> texture { Material3 } }
box { <152.66, 11.35, 94.82>, <156.05, 13.95, 97.82> texture { Material3 } }
box { <166.38, 0, -240.65>, <181.81, 11.07, -226.67> texture { Material3 } }
box { <175.33, 11.07, -235.03>, <178.86, 14.99, -232.03> texture { Material3 } }
box { <168.59, 0, -64.29>, <180.7, 10.17, -50.86> texture { Material3 } }
box { <175.41, 10.17, -56.13>, <179, 13.14, -53.13> texture { Material3 } }
box { <168.02, 0, 0.04>, <180.99, 5.65, 15.98> texture { Material3 } }
box { <177.17, 5.65, 4.79>, <179.84, 8.92, 7.79> texture { Material3 } }
box { <168.92, 0, 46.19>, <180.54, 8.99, 58.9> texture { Material3 } }
box { <171.73, 8.99, 50.35>, <175.38, 11, 53.35> texture { Material3 } }
box { <172.13, 8.99, 50.75>, <172.43, 20.99, 51.05> texture { Material3 } }
box { <166.41, 0, 67.99>, <181.79, 9.08, 81> texture { Material3 } }
box { <175.49, 9.08, 76.22>, <179.04, 12.9, 79.22> texture { Material3 } }
box { <-181.49, 0, -130.35>, <-166.26, 8.05, -116.83> texture { Material4 } }
box { <-175.24, 8.05, -124.1>, <-172.02, 11.79, -121.1> texture { Material4 } }
box { <-180.61, 0, 90.82>, <-166.7, 11.06, 102.59> texture { Material4 } }
box { <-171.65, 11.06, 98.54>, <-167.88, 14.49, 101.54> texture { Material4 } }
box { <-159.76, 0, -262.01>, <-144.12, 5.34, -248.99> texture { Material4 } }
box { <-152.99, 5.34, -252.71>, <-149.72, 8, -249.71> texture { Material4 } }
box { <-152.59, 5.34, -252.31>, <-152.29, 17.34, -252.01> texture { Material4 } }
box { <-157.23, 0, -240.82>, <-145.39, 7.59, -226.59> texture { Material4 } }
box { <-154.7, 7.59, -236.79>, <-151.48, 11.1, -233.79> texture { Material4 } }
box { <-158.51, 0, -217.6>, <-144.75, 7.23, -205.2> texture { Material4 } }
box { <-155.93, 7.23, -209.23>, <-153.35, 10.45, -206.23> texture { Material4 } }
box { <-158.76, 0, -151.12>, <-144.62, 9.32, -139.44> texture { Material4 } }
box { <-150.66, 9.32, -149.06>, <-147.46, 13.11, -146.06> texture { Material4 } }
box { <-158.4, 0, -109.59>, <-144.8, 5.64, -94.2> texture { Material4 } }
box { <-154.18, 5.64, -104.59>, <-151.66, 8.5, -101.59> texture { Material4 } }
box { <-158.15, 0, -20.68>, <-144.93, 6.04, -6.66> texture { Material4 } }
box { <-149.09, 6.04, -14.31>, <-146.85, 9.08, -11.31> texture { Material4 } }
box { <-148.69, 6.04, -13.91>, <-148.39, 18.04, -13.61> texture { Material4 } }
box { <-157.34, 0, 68.8>, <-145.33, 6.09, 80.6> texture { Material4 } }
box { <-151.61, 6.09, 71.09>, <-149.21, 8.65, 74.09> texture { Material4 } }
box { <-137.87, 0, -173.4>, <-122.07, 5.27, -161.3> texture { Material4 } }
box { <-130.54, 5.27, -165.55>, <-126.97, 8.22, -162.55> texture { Material4 } }
box { <-137.05, 0, -85.18>, <-122.48, 18.57, -73.41> texture { Material4 } }
box { <-128.41, 18.57, -79.83>, <-124.8, 21.56, -76.83> texture { Material4 } }
box { <-135.48, 0, -64.2>, <-123.26, 12.73, -50.9> texture { Material4 } }
box { <-126.96, 12.73, -54.94>, <-124.01, 16.51, -51.94> texture { Material4 } }
box { <-115.68, 0, -284.73>, <-100.16, 11.08, -270.64> texture { Material4 } }
box { <-106.39, 11.08, -282.54>, <-103.1, 14.44, -279.54> texture { Material4 } }
box { <-115.55, 0, -218.22>, <-100.22, 10.93, -204.89> texture { Material4 } }
box { <-113.42, 10.93, -210.01>, <-109.79, 14.74, -207.01> texture { Material4 } }
box { <-113.02, 10.93, -209.61>, <-112.72, 22.93, -209.31> texture { Material4 } }
box { <-114.13, 0, -151.22>, <-100.94, 14.53, -139.39> texture { Material4 } }
box { <-107.44, 14.53, -147.04>, <-105.08, 18.06, -144.04> texture { Material4 } }
box { <-115.88, 0, -130.49>, <-100.06, 13.38, -116.75> texture { Material4 } }
box { <-106.24, 13.38, -125.03>, <-102.51, 15.72, -122.03> texture { Material4 } }
box { <-115.7, 0, 68.83>, <-100.15, 10.62, 80.58> texture { Material4 } }
box { <-113.47, 10.62, 74.74>, <-109.72, 14.2, 77.74> texture { Material4 } }
box { <-92.82, 0, -151.3>, <-78.59, 22.17, -139.35> texture { Material4 } }
box { <-85.97, 22.17, -142.99>, <-83.7, 25.71, -139.99> texture { Material4 } }
box { <-91.45, 0, -20.8>, <-79.28, 31.77, -6.6> texture { Material4 } }
box { <-82.51, 31.77, -15.63>, <-78.9, 35.5, -12.63> texture { Material4 } }
box { <-92, 0, 46.8>, <-79, 24.59, 58.6> texture { Material4 } }
box { <-89.58, 24.59, 53.21>, <-85.82, 27.57, 56.21> texture { Material4 } }
box { <-92.06, 0, 66.8>, <-78.97, 11.82, 81.6> texture { Material4 } }
box { <-82.7, 11.82, 69.45>, <-79.08, 14.91, 72.45> texture { Material4 } }
box { <-71.86, 0, -129.1>, <-56.07, 32.07, -117.45> texture { Material4 } }
box { <-68.34, 32.07, -123.89>, <-64.67, 34.51, -120.89> texture { Material4 } }
box { <-70.97, 0, -108.79>, <-56.52, 35.41, -94.6> texture { Material4 } }
box { <-61.46, 35.41, -101.96>, <-58.37, 39.36, -98.96> texture { Material4 } }
box { <-61.06, 35.41, -101.56>, <-60.76, 47.41, -101.26> texture { Material4 } }
box { <-69.69, 0, 88.06>, <-57.16, 13.55, 103.97> texture { Material4 } }
box { <-66.32, 13.55, 94.06>, <-63.03, 17.01, 97.06> texture { Material4 } }
box { <-65.92, 13.55, 94.46>, <-65.62, 25.55, 94.76> texture { Material4 } }
box { <-47.84, 0, -241.49>, <-35.08, 6.68, -226.25> texture { Material4 } }
box { <-39.7, 6.68, -239.21>, <-36.32, 9.85, -236.21> texture { Material4 } }
box { <-48.64, 0, -217.43>, <-34.68, 11.43, -205.29> texture { Material4 } }
box { <-43.93, 11.43, -214.76>, <-40.34, 14.08, -211.76> texture { Material4 } }
box { <-47.21, 0, 66.39>, <-35.4, 20.66, 81.8> texture { Material4 } }
box { <-39.15, 20.66, 75.27>, <-35.24, 24.58, 78.27> texture { Material4 } }
box { <-38.75, 20.66, 75.67>, <-38.45, 32.66, 75.97> texture { Material4 } }
box { <-25.58, 0, -217.28>, <-13.21, 8.81, -205.36> texture { Material4 } }
box { <-16.23, 8.81, -211.95>, <-13.47, 11.98, -208.95> texture { Material4 } }
box { <-27.29, 0, -152.26>, <-12.35, 21.22, -138.87> texture { Material4 } }
box { <-21.38, 21.22, -149.1>, <-17.58, 25.21, -146.1> texture { Material4 } }
box { <-26.76, 0, -63.74>, <-12.62, 90.34, -51.13> texture { Material4 } }
box { <-18, 90.34, -61.53>, <-15.36, 93.07, -58.53> texture { Material4 } }
box { <-17.6, 90.34, -61.13>, <-17.3, 102.34, -60.83> texture { Material4 } }
box { <13.16, 0, -285.25>, <27.42, 9.99, -270.38> texture { Material4 } }
box { <15.99, 9.99, -276.43>, <19.21, 12.7, -273.43> texture { Material4 } }
box { <12.81, 0, -240.2>, <27.6, 17.02, -226.9> texture { Material4 } }
box { <15.97, 17.02, -237.14>, <19.53, 19.94, -234.14> texture { Material4 } }
box { <14.42, 0, -175.37>, <26.79, 35.13, -160.31> texture { Material4 } }
box { <23.99, 35.13, -172.97>, <26.96, 38.95, -169.97> texture { Material4 } }
box { <13.64, 0, -130.68>, <27.18, 28.34, -116.66> texture { Material4 } }
box { <19.84, 28.34, -126.27>, <22.33, 31.49, -123.27> texture { Material4 } }
box { <14.57, 0, -108.38>, <26.72, 70.18, -94.81> texture { Material4 } }
box { <17.75, 70.18, -99.94>, <20.95, 73.41, -96.94> texture { Material4 } }
box { <36.64, 0, -219.63>, <48.68, 10.98, -204.18> texture { Material4 } }
box { <40.31, 10.98, -216.97>, <42.9, 14.15, -213.97> texture { Material4 } }
box { <40.71, 10.98, -216.57>, <41.01, 22.98, -216.27> texture { Material4 } }
box { <34.13, 0, -108.87>, <49.94, 78.15, -94.56> texture { Material4 } }
box { <41.1, 78.15, -99.97>, <44.58, 80.68, -96.97> texture { Material4 } }
box { <35.1, 0, -20.08>, <49.45, 46.38, -6.96> texture { Material4 } }
box { <38.47, 46.38, -12.6>, <40.93, 50.02, -9.6> texture { Material4 } }
box { <36.66, 0, 90.4>, <48.67, 16.74, 102.8> texture { Material4 } }
box { <44.19, 16.74, 97.63>, <46.58, 19.66, 100.63> texture { Material4 } }
box { <56.06, 0, -283.09>, <71.97, 10.84, -271.46> texture { Material4 } }
box { <64.5, 10.84, -280.43>, <68.01, 12.93, -277.43> texture { Material4 } }
box { <58.86, 0, -263.56>, <70.57, 10.97, -248.22> texture { Material4 } }
box { <66.7, 10.97, -254>, <70.19, 13.89, -251> texture { Material4 } }
box { <56.28, 0, -130.32>, <71.86, 48.63, -116.84> texture { Material4 } }
box { <62.68, 48.63, -125.88>, <66.23, 52.26, -122.88> texture { Material4 } }
box { <63.08, 48.63, -125.48>, <63.38, 60.63, -125.18> texture { Material4 } }
box { <57.58, 0, 90.53>, <71.21, 7.8, 102.73> texture { Material4 } }
box { <67.5, 7.8, 95.55>, <71.11, 11.59, 98.55> texture { Material4 } }
box { <79.36, 0, -107.16>, <93.32, 48.52, -95.42> texture { Material4 } }
box { <82.36, 48.52, -103.11>, <86.21, 52.09, -100.11> texture { Material4 } }
box { <79.88, 0, 0.4>, <93.06, 24.11, 15.8> texture { Material4 } }
box { <85.88, 24.11, 9.01>, <88.98, 27.99, 12.01> texture { Material4 } }
box { <100.75, 0, -241.38>, <115.63, 9.21, -226.31> texture { Material4 } }
box { <104.26, 9.21, -236.37>, <106.65, 12.46, -233.37> texture { Material4 } }
box { <104.66, 9.21, -235.97>, <104.96, 21.21, -235.67> texture { Material4 } }
box { <100.57, 0, -218.56>, <115.72, 9.34, -204.72> texture { Material4 } }
box { <104.93, 9.34, -213>, <107.64, 11.62, -210> texture { Material4 } }
box { <105.33, 9.34, -212.6>, <105.63, 21.34, -212.3> texture { Material4 } }
box { <102.51, 0, -196.16>, <114.74, 8.8, -182.92> texture { Material4 } }
box { <110.19, 8.8, -189.4>, <112.54, 12.11, -186.4> texture { Material4 } }
box { <110.59, 8.8, -189>, <110.89, 20.8, -188.7> texture { Material4 } }
box { <102.29, 0, -173.87>, <114.86, 10.02, -161.06> texture { Material4 } }
box { <105.42, 10.02, -164.45>, <108.1, 13.91, -161.45> texture { Material4 } }
box { <105.82, 10.02, -164.05>, <106.12, 22.02, -163.75> texture { Material4 } }
box { <102.06, 0, -130.01>, <114.97, 22.47, -116.99> texture { Material4 } }
box { <109.88, 22.47, -127.99>, <113.31, 25.53, -124.99> texture { Material4 } }
box { <100.86, 0, 0.97>, <115.57, 12.34, 15.51> texture { Material4 } }
box { <107.95, 12.34, 4.33>, <110.82, 15.95, 7.33> texture { Material4 } }
box { <108.35, 12.34, 4.73>, <108.65, 24.34, 5.03> texture { Material4 } }
box { <100.77, 0, 24.58>, <115.61, 18.55, 36.71> texture { Material4 } }
box { <104.22, 18.55, 29.26>, <106.47, 20.6, 32.26> texture { Material4 } }
box { <123.96, 0, -239.67>, <137.02, 8.86, -227.17> texture { Material4 } }
box { <127.91, 8.86, -235.05>, <130.95, 12.47, -232.05> texture { Material4 } }
box { <128.31, 8.86, -234.65>, <128.61, 20.86, -234.35> texture { Material4 } }
box { <124.57, 0, -63.7>, <136.71, 17.79, -51.15> texture { Material4 } }
box { <128.6, 17.79, -54.24>, <131.37, 21.04, -51.24> texture { Material4 } }
box { <123.65, 0, -41.85>, <137.17, 18.16, -29.08> texture { Material4 } }
box { <127.67, 18.16, -37.64>, <130.69, 21.56, -34.64> texture { Material4 } }
box { <122.39, 0, 1.42>, <137.81, 17.05, 15.29> texture { Material4 } }
box { <125.5, 17.05, 10.22>, <127.74, 19.25, 13.22> texture { Material4 } }
box { <125.9, 17.05, 10.62>, <126.2, 29.05, 10.92> texture { Material4 } }
box { <144.11, 0, -284.37>, <159.94, 7.33, -270.81> texture { Material4 } }
box { <152.58, 7.33, -279.31>, <155.41, 9.96, -276.31> texture { Material4 } }
box { <152.98, 7.33, -278.91>, <153.28, 19.33, -278.61> texture { Material4 } }
box { <144.37, 0, -218.2>, <159.82, 7.24, -204.9> texture { Material4 } }
box { <149.37, 7.24, -208.84>, <151.77, 9.58, -205.84> texture { Material4 } }
box { <149.77, 7.24, -208.44>, <150.07, 19.24, -208.14> texture { Material4 } }
box { <144.15, 0, 23.5>, <159.92, 9.9, 37.25> texture { Material4 } }
box { <150.97, 9.9, 32.63>, <153.13, 12.25, 35.63> texture { Material4 } }
box { <166.66, 0, -261.55>, <181.67, 7.41, -249.22> texture { Material4 } }
box { <176.13, 7.41, -256.45>, <179.88, 10.05, -253.45> texture { Material4 } }
box { <176.53, 7.41, -256.05>, <176.83, 19.41, -255.75> texture { Material4 } }
box { <168.7, 0, -175.54>, <180.65, 6.29, -160.23> texture { Material4 } }
box { <177.58, 6.29, -172.99>, <180.56, 10.02, -169.99> texture { Material4 } }
box { <167.3, 0, -131.79>, <181.35, 5.51, -116.11> texture { Material4 } }
box { <174.73, 5.51, -122.09>, <177.62, 7.68, -119.09> texture { Material4 } }
box { <167.57, 0, -20.98>, <181.22, 10.56, -6.51> texture { Material4 } }
box { <170.38, 10.56, -14.11>, <173.33, 13.92, -11.11> texture { Material4 } }
box { <170.78, 10.56, -13.71>, <171.08, 22.56, -13.41> texture { Material4 } }
box { <167.94, 0, 23.7>, <181.03, 11.31, 37.15> texture { Material4 } }
box { <177.66, 11.31, 26.16>, <181.22, 13.58, 29.16> texture { Material4 } }
box { <166.09, 0, 90.93>, <181.96, 3.85, 102.53> texture { Material4 } }
box { <173.86, 3.85, 99.73>, <175.87, 7.68, 102.73> texture { Material4 } }
box { <174.26, 3.85, 100.13>, <174.56, 15.85, 100.43> texture { Material4 } }
box { <-180.16, 0, -218.36>, <-166.92, 4.32, -204.82> texture { Material5 } }
box { <-174.17, 4.32, -209.63>, <-171.08, 7.64, -206.63> texture { Material5 } }
box { <-181.82, 0, -41>, <-166.09, 4.31, -29.5> texture { Material5 } }
box { <-175.17, 4.31, -32.15>, <-171.89, 6.43, -29.15> texture { Material5 } }
box { <-174.77, 4.31, -31.75>, <-174.47, 16.31, -31.45> texture { Material5 } }
box { <-180.64, 0, -19.97>, <-166.68, 7.49, -7.01> texture { Material5 } }
box { <-173.61, 7.49, -14.64>, <-170.98, 9.97, -11.64> texture { Material5 } }
box { <-180.44, 0, 44.1>, <-166.78, 9.24, 59.95> texture { Material5 } }
box { <-173.29, 9.24, 53.2>, <-171.08, 13.18, 56.2> texture { Material5 } }
box { <-172.89, 9.24, 53.6>, <-172.59, 21.24, 53.9> texture { Material5 } }
box { <-159.62, 0, -175.1>, <-144.19, 6.65, -160.45> texture { Material5 } }
box { <-154.77, 6.65, -169.87>, <-152.59, 9.31, -166.87> texture { Material5 } }
box { <-158.13, 0, -129.92>, <-144.94, 11.78, -117.04> texture { Material5 } }
box { <-150.17, 11.78, -126.58>, <-147.73, 15.1, -123.58> texture { Material5 } }
box { <-158.21, 0, 0.46>, <-144.9, 11.51, 15.77> texture { Material5 } }
box { <-150.87, 11.51, 3.04>, <-147.08, 15.35, 6.04> texture { Material5 } }
box { <-159.75, 0, 24>, <-144.13, 10.64, 37> texture { Material5 } }
box { <-154.38, 10.64, 30>, <-151.67, 12.93, 33> texture { Material5 } }
box { <-153.98, 10.64, 30.4>, <-153.68, 22.64, 30.7> texture { Material5 } }
box { <-159.55, 0, 44.11>, <-144.22, 11.84, 59.94> texture { Material5 } }
box { <-154.47, 11.84, 48.1>, <-152.19, 15.06, 51.1> texture { Material5 } }
box { <-158.97, 0, 89.33>, <-144.51, 9.75, 103.33> texture { Material5 } }
box { <-154.82, 9.75, 96.37>, <-151.71, 11.76, 99.37> texture { Material5 } }
box { <-135.97, 0, -151.25>, <-123.01, 13.99, -139.37> texture { Material5 } }
box { <-129.99, 13.99, -148.15>, <-126.79, 17.75, -145.15> texture { Material5 } }
box { <-129.59, 13.99, -147.75>, <-129.29, 25.99, -147.45> texture { Material5 } }
box { <-136.45, 0, -109.41>, <-122.78, 16.17, -94.29> texture { Material5 } }
box { <-132.13, 16.17, -104.77>, <-130.06, 19.78, -101.77> texture { Material5 } }
box { <-136.17, 0, -41.07>, <-122.91, 16.24, -29.46> texture { Material5 } }
box { <-133.62, 16.24, -33.9>, <-130.42, 18.72, -30.9> texture { Material5 } }
box { <-137.21, 0, -19.76>, <-122.4, 10.27, -7.12> texture { Material5 } }
box { <-130.35, 10.27, -13.42>, <-128.28, 14.25, -10.42> texture { Material5 } }
box { <-136.04, 0, 0.42>, <-122.98, 11.08, 15.79> texture { Material5 } }
box { <-129.84, 11.08, 8.74>, <-126.96, 14, 11.74> texture { Material5 } }
box { <-129.44, 11.08, 9.14>, <-129.14, 23.08, 9.44> texture { Material5 } }
box { <-115.13, 0, -196.54>, <-100.44, 15.06, -182.73> texture { Material5 } }
box { <-110.18, 15.06, -194>, <-107.33, 17.9, -191> texture { Material5 } }
box { <-115.15, 0, 0.29>, <-100.42, 9.07, 15.86> texture { Material5 } }
box { <-111.26, 9.07, 7.7>, <-108.78, 11.37, 10.7> texture { Material5 } }
box { <-115.01, 0, 44.61>, <-100.49, 11.99, 59.69> texture { Material5 } }
box { <-106.84, 11.99, 47.52>, <-103.4, 14.18, 50.52> texture { Material5 } }
box { <-92.49, 0, -219.18>, <-78.76, 6.78, -204.41> texture { Material5 } }
box { <-86.02, 6.78, -209.55>, <-83.29, 9.56, -206.55> texture { Material5 } }
box { <-85.62, 6.78, -209.15>, <-85.32, 18.78, -208.85> texture { Material5 } }
box { <-92.76, 0, -85.97>, <-78.62, 32, -73.02> texture { Material5 } }
box { <-89.89, 32, -79.09>, <-86.3, 35.97, -76.09> texture { Material5 } }
box { <-92.45, 0, -64.22>, <-78.78, 42.04, -50.89> texture { Material5 } }
box { <-89.68, 42.04, -58.21>, <-87.62, 45.45, -55.21> texture { Material5 } }
box { <-93.47, 0, 2.86>, <-78.27, 15.36, 14.57> texture { Material5 } }
box { <-86.25, 15.36, 8.51>, <-83.55, 17.84, 11.51> texture { Material5 } }
box { <-85.85, 15.36, 8.91>, <-85.55, 27.36, 9.21> texture { Material5 } }
box { <-93.78, 0, 90.99>, <-78.11, 15.78, 102.51> texture { Material5 } }
box { <-85.9, 15.78, 94.27>, <-82.08, 19.7, 97.27> texture { Material5 } }
box { <-70.88, 0, -151.33>, <-56.56, 14.87, -139.33> texture { Material5 } }
box { <-63.61, 14.87, -148.97>, <-61.17, 17.65, -145.97> texture { Material5 } }
box { <-69.28, 0, -85.26>, <-57.36, 52.6, -73.37> texture { Material5 } }
box { <-61.91, 52.6, -79.38>, <-59.65, 55.15, -76.38> texture { Material5 } }
box { <-61.51, 52.6, -78.98>, <-61.21, 64.6, -78.68> texture { Material5 } }
box { <-70.36, 0, -64.06>, <-56.82, 57.97, -50.97> texture { Material5 } }
box { <-61.34, 57.97, -57.18>, <-57.48, 60.92, -54.18> texture { Material5 } }
box { <-47.94, 0, -307.65>, <-35.03, 10.57, -292.17> texture { Material5 } }
box { <-38.56, 10.57, -301.32>, <-34.72, 13.06, -298.32> texture { Material5 } }
box { <-47.55, 0, -285.56>, <-35.22, 12.01, -270.22> texture { Material5 } }
box { <-40.9, 12.01, -282.5>, <-37.03, 14.27, -279.5> texture { Material5 } }
box { <-40.5, 12.01, -282.1>, <-40.2, 24.01, -281.8> texture { Material5 } }
box { <-48.71, 0, -43.34>, <-34.64, 68.22, -28.33> texture { Material5 } }
box { <-40.62, 68.22, -35.45>, <-38.44, 71.26, -32.45> texture { Material5 } }
box { <-40.22, 68.22, -35.05>, <-39.92, 80.22, -34.75> texture { Material5 } }
box { <-48.81, 0, 44.14>, <-34.6, 39.44, 59.93> texture { Material5 } }
box { <-42.01, 39.44, 46.69>, <-39.4, 42.26, 49.69> texture { Material5 } }
box { <-41.61, 39.44, 47.09>, <-41.31, 51.44, 47.39> texture { Material5 } }
box { <-26.02, 0, -285.4>, <-12.99, 8.69, -270.3> texture { Material5 } }
box { <-23.45, 8.69, -277.76>, <-21.4, 10.77, -274.76> texture { Material5 } }
box { <-27.64, 0, -174.84>, <-12.18, 23.86, -160.58> texture { Material5 } }
box { <-23.92, 23.86, -169.34>, <-21.34, 26.31, -166.34> texture { Material5 } }
box { <-27.03, 0, -129.26>, <-12.49, 27.14, -117.37> texture { Material5 } }
box { <-21.13, 27.14, -119.37>, <-18.47, 29.43, -116.37> texture { Material5 } }
box { <-20.73, 27.14, -118.97>, <-20.43, 39.14, -118.67> texture { Material5 } }
box { <-26.92, 0, -86.73>, <-12.54, 88.75, -72.64> texture { Material5 } }
box { <-23.44, 88.75, -83.61>, <-19.65, 91.25, -80.61> texture { Material5 } }
box { <-28, 0, -19.34>, <-12, 31.95, -7.33> texture { Material5 } }
box { <-24.42, 31.95, -15.85>, <-22.35, 33.96, -12.85> texture { Material5 } }
box { <-24.02, 31.95, -15.45>, <-23.72, 43.95, -15.15> texture { Material5 } }
box { <-26.94, 0, 2.68>, <-12.53, 51.58, 14.66> texture { Material5 } }
box { <-23.2, 51.58, 7.63>, <-19.44, 53.63, 10.63> texture { Material5 } }
box { <-27.7, 0, 24.14>, <-12.15, 43.73, 36.93> texture { Material5 } }
box { <-17.88, 43.73, 26.66>, <-14.1, 47.26, 29.66> texture { Material5 } }
box { <13.67, 0, -217.53>, <27.17, 13.31, -205.23> texture { Material5 } }
box { <20.52, 13.31, -208.33>, <22.84, 16.75, -205.33> texture { Material5 } }
box { <13.17, 0, -86.51>, <27.42, 54.66, -72.74> texture { Material5 } }
box { <19.84, 54.66, -77.28>, <22.95, 57.99, -74.28> texture { Material5 } }
box { <14.05, 0, -19.85>, <26.98, 81.41, -7.08> texture { Material5 } }
box { <22.48, 81.41, -17.6>, <25.21, 85.2, -14.6> texture { Material5 } }
box { <14.34, 0, 44.47>, <26.83, 20.15, 59.77> texture { Material5 } }
box { <16.57, 20.15, 47.69>, <19.92, 22.71, 50.69> texture { Material5 } }
box { <13.85, 0, 66.13>, <27.07, 13.6, 81.94> texture { Material5 } }
box { <21.02, 13.6, 72.35>, <23.53, 17.28, 75.35> texture { Material5 } }
box { <35.25, 0, -307.84>, <49.37, 5.62, -292.08> texture { Material5 } }
box { <41.79, 5.62, -298.36>, <43.94, 8.02, -295.36> texture { Material5 } }
box { <42.19, 5.62, -297.96>, <42.49, 17.62, -297.66> texture { Material5 } }
box { <36.45, 0, -263.88>, <48.78, 6.99, -248.06> texture { Material5 } }
box { <42.39, 6.99, -260.52>, <44.94, 10.3, -257.52> texture { Material5 } }
box { <36.15, 0, -240.8>, <48.92, 9.43, -226.6> texture { Material5 } }
box { <40.91, 9.43, -236.19>, <43.08, 12.26, -233.19> texture { Material5 } }
box { <36.2, 0, -196.36>, <48.9, 12.85, -182.82> texture { Material5 } }
box { <39.66, 12.85, -193.03>, <41.99, 15.73, -190.03> texture { Material5 } }
box { <34.57, 0, -174.83>, <49.72, 33.4, -160.58> texture { Material5 } }
box { <41.6, 33.4, -172.6>, <44.49, 36.06, -169.6> texture { Material5 } }
box { <34.4, 0, -65.1>, <49.8, 60.15, -50.45> texture { Material5 } }
box { <39.65, 60.15, -55.32>, <43.4, 62.32, -52.32> texture { Material5 } }
box { <34.73, 0, 2.55>, <49.64, 26.17, 14.72> texture { Material5 } }
box { <43.49, 26.17, 8.28>, <45.99, 29.61, 11.28> texture { Material5 } }
box { <35.68, 0, 46.52>, <49.16, 22.65, 58.74> texture { Material5 } }
box { <42.77, 22.65, 49.95>, <44.78, 24.94, 52.95> texture { Material5 } }
box { <56.8, 0, -306.16>, <71.6, 9.11, -292.92> texture { Material5 } }
box { <60.01, 9.11, -299.26>, <63.96, 11.19, -296.26> texture { Material5 } }
box { <57.37, 0, -175.48>, <71.31, 16.62, -160.26> texture { Material5 } }
box { <62.95, 16.62, -167.84>, <66.49, 20.02, -164.84> texture { Material5 } }
box { <56.46, 0, -152.35>, <71.77, 22.1, -138.83> texture { Material5 } }
box { <64.51, 22.1, -146.49>, <68.3, 25.94, -143.49> texture { Material5 } }
box { <56.15, 0, -109.23>, <71.93, 26.86, -94.39> texture { Material5 } }
box { <62.42, 26.86, -99.51>, <64.9, 30.01, -96.51> texture { Material5 } }
box { <57.19, 0, -86.82>, <71.41, 24.2, -72.59> texture { Material5 } }
box { <60.92, 24.2, -84.8>, <63.61, 27.63, -81.8> texture { Material5 } }
box { <61.32, 24.2, -84.4>, <61.62, 36.2, -84.1> texture { Material5 } }
box { <56.52, 0, -63.64>, <71.74, 69.93, -51.18> texture { Material5 } }
box { <61.18, 69.93, -61.6>, <65.18, 72.66, -58.6> texture { Material5 } }
box { <57.98, 0, 46.47>, <71.01, 21.41, 58.77> texture { Material5 } }
box { <63.13, 21.41, 55.12>, <66.02, 24.51, 58.12> texture { Material5 } }
box { <80.08, 0, -263.76>, <92.96, 11.3, -248.12> texture { Material5 } }
box { <82.4, 11.3, -258.41>, <84.91, 15.03, -255.41> texture { Material5 } }
box { <82.8, 11.3, -258.01>, <83.1, 23.3, -257.71> texture { Material5 } }
box { <78.46, 0, -151.29>, <93.77, 25.87, -139.35> texture { Material5 } }
box { <81.88, 25.87, -147.88>, <85.58, 29.84, -144.88> texture { Material5 } }
box { <82.28, 25.87, -147.48>, <82.58, 37.87, -147.18> texture { Material5 } }
box { <80.39, 0, -86.39>, <92.81, 40.9, -72.81> texture { Material5 } }
box { <83.69, 40.9, -77.1>, <87.64, 44.02, -74.1> texture { Material5 } }
box { <84.09, 40.9, -76.7>, <84.39, 52.9, -76.4> texture { Material5 } }
box { <78.05, 0, -21.58>, <93.97, 51.84, -6.21> texture { Material5 } }
box { <84.44, 51.84, -13.8>, <88.2, 54.02, -10.8> texture { Material5 } }
box { <80.2, 0, 90.38>, <92.9, 19.04, 102.81> texture { Material5 } }
box { <88.8, 19.04, 92.53>, <90.91, 22, 95.53> texture { Material5 } }
box { <100.33, 0, -285.24>, <115.84, 6.8, -270.38> texture { Material5 } }
box { <109.51, 6.8, -282.53>, <112.86, 10.55, -279.53> texture { Material5 } }
box { <102.93, 0, -261.37>, <114.53, 4.32, -249.31> texture { Material5 } }
box { <108.53, 4.32, -253.31>, <111.11, 7.5, -250.31> texture { Material5 } }
box { <108.93, 4.32, -252.91>, <109.23, 16.32, -252.61> texture { Material5 } }
box { <102.83, 0, -85.96>, <114.58, 16.65, -73.02> texture { Material5 } }
box { <111.6, 16.65, -83.54>, <114.16, 18.76, -80.54> texture { Material5 } }
box { <100.63, 0, -20.01>, <115.68, 25.46, -6.99> texture { Material5 } }
box { <104, 25.46, -12.22>, <107.45, 28.02, -9.22> texture { Material5 } }
box { <104.4, 25.46, -11.82>, <104.7, 37.46, -11.52> texture { Material5 } }
box { <102.37, 0, 45.96>, <114.82, 13.82, 59.02> texture { Material5 } }
box { <106.19, 13.82, 50.96>, <110.16, 17.36, 53.96> texture { Material5 } }
box { <106.59, 13.82, 51.36>, <106.89, 25.82, 51.66> texture { Material5 } }
box { <102.81, 0, 67.21>, <114.59, 10.4, 81.4> texture { Material5 } }
box { <110.56, 10.4, 69.93>, <113.88, 13.3, 72.93> texture { Material5 } }
box { <122.66, 0, -307.38>, <137.67, 4.86, -292.31> texture { Material5 } }
box { <128.63, 4.86, -305.18>, <132.12, 6.94, -302.18> texture { Material5 } }
box { <123.24, 0, -261.01>, <137.38, 7.82, -249.5> texture { Material5 } }
box { <130.5, 7.82, -254.18>, <133.46, 10.23, -251.18> texture { Material5 } }
box { <122.84, 0, -217.36>, <137.58, 5.44, -205.32> texture { Material5 } }
box { <126.66, 5.44, -214.89>, <129.19, 8.53, -211.89> texture { Material5 } }
box { <127.06, 5.44, -214.49>, <127.36, 17.44, -214.19> texture { Material5 } }
box { <122.04, 0, -196.95>, <137.98, 8.8, -182.52> texture { Material5 } }
box { <128.71, 8.8, -194.13>, <131.29, 11.94, -191.13> texture { Material5 } }
box { <129.11, 8.8, -193.73>, <129.41, 20.8, -193.43> texture { Material5 } }
box { <122.46, 0, -151.03>, <137.77, 16.68, -139.48> texture { Material5 } }
box { <128.41, 16.68, -144.74>, <131.11, 19.16, -141.74> texture { Material5 } }
box { <128.81, 16.68, -144.34>, <129.11, 28.68, -144.04> texture { Material5 } }
box { <124.23, 0, -109.12>, <136.89, 13.23, -94.44> texture { Material5 } }
box { <130.11, 13.23, -104.5>, <133.42, 16.9, -101.5> texture { Material5 } }
box { <122.15, 0, -87.45>, <137.92, 15.98, -72.28> texture { Material5 } }
box { <124.61, 15.98, -83.47>, <128.03, 19.04, -80.47> texture { Material5 } }
box { <122.88, 0, 22>, <137.56, 10.87, 38> texture { Material5 } }
box { <124.96, 10.87, 28.03>, <128.01, 13.56, 31.03> texture { Material5 } }
box { <125.36, 10.87, 28.43>, <125.66, 22.87, 28.73> texture { Material5 } }
box { <123.03, 0, 89.83>, <137.48, 11.63, 103.08> texture { Material5 } }
box { <132.66, 11.63, 98.62>, <136.06, 14.18, 101.62> texture { Material5 } }
box { <144.66, 0, -241.8>, <159.67, 6.68, -226.1> texture { Material5 } }
box { <153.66, 6.68, -239.57>, <157.37, 8.73, -236.57> texture { Material5 } }
box { <154.06, 6.68, -239.17>, <154.36, 18.68, -238.87> texture { Material5 } }
box { <147, 0, -63.34>, <158.5, 11.21, -51.33> texture { Material5 } }
box { <153.88, 11.21, -58.5>, <157.68, 14.03, -55.5> texture { Material5 } }
box { <144.57, 0, -20.02>, <159.72, 11.97, -6.99> texture { Material5 } }
box { <148.99, 11.97, -12.25>, <151.65, 15, -9.25> texture { Material5 } }
box { <149.39, 11.97, -11.85>, <149.69, 23.97, -11.55> texture { Material5 } }
box { <168.09, 0, -305.79>, <180.96, 3.66, -293.1> texture { Material5 } }
box { <174.47, 3.66, -296.96>, <176.72, 6.61, -293.96> texture { Material5 } }
box { <167.61, 0, -283.79>, <181.19, 7.82, -271.11> texture { Material5 } }
box { <174, 7.82, -279.08>, <177.44, 11.25, -276.08> texture { Material5 } }
box { <167.15, 0, -219.17>, <181.42, 8, -204.42> texture { Material5 } }
box { <169.6, 8, -212.34>, <172.65, 10.13, -209.34> texture { Material5 } }
box { <170, 8, -211.94>, <170.3, 20, -211.64> texture { Material5 } }
box { <167.38, 0, -42.15>, <181.31, 9.36, -28.93> texture { Material5 } }
box { <173.25, 9.36, -38.36>, <175.46, 12.69, -35.36> texture { Material5 } }
box { <-3.2, 0, 110>, <-3.08, 5, 110.12> texture { Material6 } }
box { <-3.2, 0, 102>, <-3.08, 5, 102.12> texture { Material6 } }
box { <-3.2, 0, 94>, <-3.08, 5, 94.12> texture { Material6 } }
box { <-3.2, 0, 86>, <-3.08, 5, 86.12> texture { Material6 } }
box { <-3.2, 0, 78>, <-3.08, 5, 78.12> texture { Material6 } }
box { <-3.2, 0, 70>, <-3.08, 5, 70.12> texture { Material6 } }
box { <-3.2, 0, 62>, <-3.08, 5, 62.12> texture { Material6 } }
box { <-3.2, 0, 54>, <-3.08, 5, 54.12> texture { Material6 } }
box { <-3.2, 0, 46>, <-3.08, 5, 46.12> texture { Material6 } }
box { <-3.2, 0, 38>, <-3.08, 5, 38.12> texture { Material6 } }
box { <-3.2, 0, 30>, <-3.08, 5, 30.12> texture { Material6 } }
box { <-3.2, 0, 22>, <-3.08, 5, 22.12> texture { Material6 } }
box { <-3.2, 0, 14>, <-3.08, 5, 14.12> texture { Material6 } }
box { <-3.2, 0, 6>, <-3.08, 5, 6.12> texture { Material6 } }
box { <-3.2, 0, -2>, <-3.08, 5, -1.88> texture { Material6 } }
box { <-3.2, 0, -10>, <-3.08, 5, -9.88> texture { Material6 } }
box { <-3.2, 0, -18>, <-3.08, 5, -17.88> texture { Material6 } }
box { <-3.2, 0, -26>, <-3.08, 5, -25.88> texture { Material6 } }
box { <-3.2, 0, -34>, <-3.08, 5, -33.88> texture { Material6 } }
box { <-3.2, 0, -42>, <-3.08, 5, -41.88> texture { Material6 } }
box { <-3.2, 0, -50>, <-3.08, 5, -49.88> texture { Material6 } }
box { <-3.2, 0, -58>, <-3.08, 5, -57.88> texture { Material6 } }
box { <-3.2, 0, -66>, <-3.08, 5, -65.88> texture { Material6 } }
box { <-3.2, 0, -74>, <-3.08, 5, -73.88> texture { Material6 } }
box { <-3.2, 0, -82>, <-3.08, 5, -81.88> texture { Material6 } }
box { <-3.2, 0, -90>, <-3.08, 5, -89.88> texture { Material6 } }
box { <-3.2, 0, -98>, <-3.08, 5, -97.88> texture { Material6 } }
box { <-3.2, 0, -106>, <-3.08, 5, -105.88> texture { Material6 } }
box { <-3.2, 0, -114>, <-3.08, 5, -113.88> texture { Material6 } }
box { <-3.2, 0, -122>, <-3.08, 5, -121.88> texture { Material6 } }
box { <-3.2, 0, -130>, <-3.08, 5, -129.88> texture { Material6 } }
box { <-3.2, 0, -138>, <-3.08, 5, -137.88> texture { Material6 } }
box { <-3.2, 0, -146>, <-3.08, 5, -145.88> texture { Material6 } }
box { <-3.2, 0, -154>, <-3.08, 5, -153.88> texture { Material6 } }
box { <-3.2, 0, -162>, <-3.08, 5, -161.88> texture { Material6 } }
box { <-3.2, 0, -170>, <-3.08, 5, -169.88> texture { Material6 } }
box { <-3.2, 0, -178>, <-3.08, 5, -177.88> texture { Material6 } }
box { <-3.2, 0, -186>, <-3.08, 5, -185.88> texture { Material6 } }
box { <-3.2, 0, -194>, <-3.08, 5, -193.88> texture { Material6 } }
box { <-3.2, 0, -202>, <-3.08, 5, -201.88> texture { Material6 } }
box { <8.9, 0, 110>, <9.02, 5, 110.12> texture { Material6 } }
box { <8.9, 0, 102>, <9.02, 5, 102.12> texture { Material6 } }
box { <8.9, 0, 94>, <9.02, 5, 94.12> texture { Material6 } }
box { <8.9, 0, 86>, <9.02, 5, 86.12> texture { Material6 } }
box { <8.9, 0, 78>, <9.02, 5, 78.12> texture { Material6 } }
box { <8.9, 0, 70>, <9.02, 5, 70.12> texture { Material6 } }
box { <8.9, 0, 62>, <9.02, 5, 62.12> texture { Material6 } }
box { <8.9, 0, 54>, <9.02, 5, 54.12> texture { Material6 } }
box { <8.9, 0, 46>, <9.02, 5, 46.12> texture { Material6 } }
box { <8.9, 0, 38>, <9.02, 5, 38.12> texture { Material6 } }
box { <8.9, 0, 30>, <9.02, 5, 30.12> texture { Material6 } }
box { <8.9, 0, 22>, <9.02, 5, 22.12> texture { Material6 } }
box { <8.9, 0, 14>, <9.02, 5, 14.12> texture { Material6 } }
box { <8.9, 0, 6>, <9.02, 5, 6.12> texture { Material6 } }
box { <8.9, 0, -2>, <9.02, 5, -1.88> texture { Material6 } }
box { <8.9, 0, -10>, <9.02, 5, -9.88> texture { Material6 } }
box { <8.9, 0, -18>, <9.02, 5, -17.88> texture { Material6 } }
box { <8.9, 0, -26>, <9.02, 5, -25.88> texture { Material6 } }
box { <8.9, 0, -34>, <9.02, 5, -33.88> texture { Material6 } }
box { <8.9, 0, -42>, <9.02, 5, -41.88> texture { Material6 } }
box { <8.9, 0, -50>, <9.02, 5, -49.88> texture { Material6 } }
box { <8.9, 0, -58>, <9.02, 5, -57.88> texture { Material6 } }
box { <8.9, 0, -66>, <9.02, 5, -65.88> texture { Material6 } }
box { <8.9, 0, -74>, <9.02, 5, -73.88> texture { Material6 } }
box { <8.9, 0, -82>, <9.02, 5, -81.88> texture { Material6 } }
box { <8.9, 0, -90>, <9.02, 5, -89.88> texture { Material6 } }
box { <8.9, 0, -98>, <9.02, 5, -97.88> texture { Material6 } }
box { <8.9, 0, -106>, <9.02, 5, -105.88> texture { Material6 } }
box { <8.9, 0, -114>, <9.02, 5, -113.88> texture { Material6 } }
box { <8.9, 0, -122>, <9.02, 5, -121.88> texture { Material6 } }
box { <8.9, 0, -130>, <9.02, 5, -129.88> texture { Material6 } }
box { <8.9, 0, -138>, <9.02, 5, -137.88> texture { Material6 } }
box { <8.9, 0, -146>, <9.02, 5, -145.88> texture { Material6 } }
box { <8.9, 0, -154>, <9.02, 5, -153.88> texture { Material6 } }
box { <8.9, 0, -162>, <9.02, 5, -161.88> texture { Material6 } }
box { <8.9, 0, -170>, <9.02, 5, -169.88> texture { Material6 } }
box { <8.9, 0, -178>, <9.02, 5, -177.88> texture { Material6 } }
box { <8.9, 0, -186>, <9.02, 5, -185.88> texture { Material6 } }
box { <8.9, 0, -194>, <9.02, 5, -193.88> texture { Material6 } }
box { <8.9, 0, -202>, <9.02, 5, -201.88> texture { Material6 } }
sphere { <-3.14, 5.2, 110.06>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, 102.06>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, 94.06>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, 86.06>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, 78.06>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, 70.06>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, 62.06>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, 54.06>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, 46.06>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, 38.06>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, 30.06>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, 22.06>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, 14.06>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, 6.06>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, -1.94>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, -9.94>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, -17.94>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, -25.94>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, -33.94>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, -41.94>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, -49.94>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, -57.94>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, -65.94>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, -73.94>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, -81.94>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, -89.94>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, -97.94>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, -105.94>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, -113.94>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, -121.94>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, -129.94>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, -137.94>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, -145.94>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, -153.94>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, -161.94>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, -169.94>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, -177.94>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, -185.94>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, -193.94>, 0.35 texture { Material7 } }
sphere { <-3.14, 5.2, -201.94>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, 110.06>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, 102.06>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, 94.06>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, 86.06>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, 78.06>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, 70.06>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, 62.06>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, 54.06>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, 46.06>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, 38.06>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, 30.06>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, 22.06>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, 14.06>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, 6.06>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, -1.94>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, -9.94>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, -17.94>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, -25.94>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, -33.94>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, -41.94>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, -49.94>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, -57.94>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, -65.94>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, -73.94>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, -81.94>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, -89.94>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, -97.94>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, -105.94>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, -113.94>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, -121.94>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, -129.94>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, -137.94>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, -145.94>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, -153.94>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, -161.94>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, -169.94>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, -177.94>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, -185.94>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, -193.94>, 0.35 texture { Material7 } }
sphere { <8.96, 5.2, -201.94>, 0.35 texture { Material7 } }
box { <-1, 0.3, 105.13>, <0.8, 1, 109.33> texture { Material8 } }
box { <-0.8, 1, 106.13>, <0.6, 1.5, 108.33> texture { Material8 } }
box { <5, 0.3, 84.04>, <6.8, 1, 88.24> texture { Material8 } }
box { <5.2, 1, 85.04>, <6.6, 1.5, 87.24> texture { Material8 } }
box { <-1, 0.3, 61.72>, <0.8, 1, 65.92> texture { Material8 } }
box { <-0.8, 1, 62.72>, <0.6, 1.5, 64.92> texture { Material8 } }
box { <5, 0.3, 38.13>, <6.8, 1, 42.33> texture { Material8 } }
box { <5.2, 1, 39.13>, <6.6, 1.5, 41.33> texture { Material8 } }
box { <-1, 0.3, 16.89>, <0.8, 1, 21.09> texture { Material8 } }
box { <-0.8, 1, 17.89>, <0.6, 1.5, 20.09> texture { Material8 } }
box { <5, 0.3, -6.27>, <6.8, 1, -2.07> texture { Material8 } }
box { <5.2, 1, -5.27>, <6.6, 1.5, -3.07> texture { Material8 } }
box { <-1, 0.3, -28.14>, <0.8, 1, -23.94> texture { Material8 } }
box { <-0.8, 1, -27.14>, <0.6, 1.5, -24.94> texture { Material8 } }
box { <5, 0.3, -51.91>, <6.8, 1, -47.71> texture { Material8 } }
box { <5.2, 1, -50.91>, <6.6, 1.5, -48.71> texture { Material8 } }
box { <-1, 0.3, -73.25>, <0.8, 1, -69.05> texture { Material8 } }
box { <-0.8, 1, -72.25>, <0.6, 1.5, -70.05> texture { Material8 } }
box { <5, 0.3, -96.38>, <6.8, 1, -92.18> texture { Material8 } }
box { <5.2, 1, -95.38>, <6.6, 1.5, -93.18> texture { Material8 } }
box { <-1, 0.3, -119.96>, <0.8, 1, -115.76> texture { Material8 } }
box { <-0.8, 1, -118.96>, <0.6, 1.5, -116.76> texture { Material8 } }
box { <5, 0.3, -141.2>, <6.8, 1, -137> texture { Material8 } }
box { <5.2, 1, -140.2>, <6.6, 1.5, -138> texture { Material8 } }
box { <5, 0.3, 97.53>, <6.8, 1, 101.73> texture { Material9 } }
box { <5.2, 1, 98.53>, <6.6, 1.5, 100.73> texture { Material9 } }
box { <-1, 0.3, 76.9>, <0.8, 1, 81.1> texture { Material9 } }
box { <-0.8, 1, 77.9>, <0.6, 1.5, 80.1> texture { Material9 } }
box { <5, 0.3, 54.24>, <6.8, 1, 58.44> texture { Material9 } }
box { <5.2, 1, 55.24>, <6.6, 1.5, 57.44> texture { Material9 } }
box { <-1, 0.3, 32.69>, <0.8, 1, 36.89> texture { Material9 } }
box { <-0.8, 1, 33.69>, <0.6, 1.5, 35.89> texture { Material9 } }
box { <5, 0.3, 8.12>, <6.8, 1, 12.32> texture { Material9 } }
box { <5.2, 1, 9.12>, <6.6, 1.5, 11.32> texture { Material9 } }
box { <-1, 0.3, -12.38>, <0.8, 1, -8.18> texture { Material9 } }
box { <-0.8, 1, -11.38>, <0.6, 1.5, -9.18> texture { Material9 } }
box { <5, 0.3, -35.8>, <6.8, 1, -31.6> texture { Material9 } }
box { <5.2, 1, -34.8>, <6.6, 1.5, -32.6> texture { Material9 } }
box { <-1, 0.3, -58.11>, <0.8, 1, -53.91> texture { Material9 } }
box { <-0.8, 1, -57.11>, <0.6, 1.5, -54.91> texture { Material9 } }
box { <5, 0.3, -80>, <6.8, 1, -75.8> texture { Material9 } }
box { <5.2, 1, -79>, <6.6, 1.5, -76.8> texture { Material9 } }
box { <-1, 0.3, -103.26>, <0.8, 1, -99.06> texture { Material9 } }
box { <-0.8, 1, -102.26>, <0.6, 1.5, -100.06> texture { Material9 } }
box { <5, 0.3, -127.34>, <6.8, 1, -123.14> texture { Material9 } }
box { <5.2, 1, -126.34>, <6.6, 1.5, -124.14> texture { Material9 } }
box { <-1, 0.3, -148.87>, <0.8, 1, -144.67> texture { Material9 } }
box { <-0.8, 1, -147.87>, <0.6, 1.5, -145.67> texture { Material9 } }
box { <-1, 0.3, 92.13>, <0.8, 1, 96.33> texture { Material10 } }
box { <-0.8, 1, 93.13>, <0.6, 1.5, 95.33> texture { Material10 } }
box { <5, 0.3, 70.3>, <6.8, 1, 74.5> texture { Material10 } }
box { <5.2, 1, 71.3>, <6.6, 1.5, 73.5> texture { Material10 } }
box { <-1, 0.3, 46.23>, <0.8, 1, 50.43> texture { Material10 } }
box { <-0.8, 1, 47.23>, <0.6, 1.5, 49.43> texture { Material10 } }
box { <5, 0.3, 22.95>, <6.8, 1, 27.15> texture { Material10 } }
box { <5.2, 1, 23.95>, <6.6, 1.5, 26.15> texture { Material10 } }
box { <-1, 0.3, 2.64>, <0.8, 1, 6.84> texture { Material10 } }
box { <-0.8, 1, 3.64>, <0.6, 1.5, 5.84> texture { Material10 } }
box { <5, 0.3, -20.42>, <6.8, 1, -16.22> texture { Material10 } }
box { <5.2, 1, -19.42>, <6.6, 1.5, -17.22> texture { Material10 } }
box { <-1, 0.3, -43.45>, <0.8, 1, -39.25> texture { Material10 } }
box { <-0.8, 1, -42.45>, <0.6, 1.5, -40.25> texture { Material10 } }
box { <5, 0.3, -67.38>, <6.8, 1, -63.18> texture { Material10 } }
box { <5.2, 1, -66.38>, <6.6, 1.5, -64.18> texture { Material10 } }
box { <-1, 0.3, -87.77>, <0.8, 1, -83.57> texture { Material10 } }
box { <-0.8, 1, -86.77>, <0.6, 1.5, -84.57> texture { Material10 } }
box { <5, 0.3, -112.46>, <6.8, 1, -108.26> texture { Material10 } }
box { <5.2, 1, -111.46>, <6.6, 1.5, -109.26> texture { Material10 } }
box { <-1, 0.3, -133.84>, <0.8, 1, -129.64> texture { Material10 } }
box { <-0.8, 1, -132.84>, <0.6, 1.5, -130.64> texture { Material10 } }
box { <5, 0.3, -157.28>, <6.8, 1, -153.08> texture { Material10 } }
box { <5.2, 1, -156.28>, <6.6, 1.5, -154.08> texture { Material10 } }
