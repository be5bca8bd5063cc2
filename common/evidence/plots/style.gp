# What all plots share. `name`, `width` and `height` are set before.
set terminal svg size width,height enhanced font 'sans-serif,15' linewidth 1.2 background '#ffffff'
set output name.'.svg'
set encoding utf8
set datafile separator ','
set border linewidth 0.6
set tics scale 0.6
set grid linecolor rgb '#d0d3d8' linewidth 0.5 dashtype 1
set pointsize 0.6

# Colours that can be read on white and on nearly black.
red = '#d1495b'
blue = '#1d83d4'
green = '#2f9e6b'
orange = '#d98514'
violet = '#8f6fd6'
grey = '#858c95'
faint = '#7c848e'
sampling_color(method) = method eq 'random' || method eq 'nearest' ? red \
    : method eq 'regular' || method eq 'bilinear' ? orange : method eq 'jittered' || method eq 'trilinear' ? blue \
    : method eq 'Poisson disk' || method eq 'anisotropic' ? green : method eq 'adaptive' ? violet : grey
