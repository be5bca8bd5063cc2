# Rays a second against the number of triangles; `grid_law` and `brute_law` say how the time of a ray grows.
set datafile missing NaN
set logscale xy
set format '10^{%T}'
set xlabel 'triangles N'
set ylabel 'rays a second'
set key bottom left
set xrange [fewest/1.5:most*1.5]
plot 'grids.csv' skip 1 using 1:(1e9/$3) with linespoints pointtype 7 linewidth 1.6 linecolor rgb blue \
         title 'grid: time a ray as '.grid_law, \
     '' skip 1 using 1:(1e9/$4) with linespoints pointtype 7 linewidth 1.6 linecolor rgb red \
         title 'every triangle: '.brute_law
