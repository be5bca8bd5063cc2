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
among(methods, method) = strstrt('|'.methods.'|', '|'.method.'|') > 0
sampling_color(method) = among('random|nearest|by area|all|16 shadow rays|all blurs|area_light|focal_blur', method) ? red \
    : among('regular|bilinear|4 shadow rays|lamps|adaptive area_light|focal_blur with variance', method) ? orange \
    : among('jittered|trilinear|by angle|one light at random|one shadow ray to a lamp|lens|ours', method) ? blue \
    : among('Poisson disk|anisotropic|sobol|motion|as many spotlights', method) ? green \
    : among('adaptive|gloss|area_illumination', method) ? violet : grey
