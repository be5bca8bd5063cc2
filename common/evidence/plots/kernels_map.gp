# Correct digits of t by distance and depth, a map for each of the `maps` methods: map i is called title[i] and
# has the rows first[i] to last[i] of the table.
set multiplot layout 1,3 margins 0.10,0.89,0.20,0.89 spacing 0.02,0
unset key
unset grid
set cbrange [0:16]
set cbtics 4
set palette defined (0 '#7a1f3d', 4 '#d1495b', 8 '#f0b429', 12 '#58b67c', 16 '#14537d')
set object 1 rectangle from graph 0,0 to graph 1,1 behind fillcolor rgb '#8e959e' fillstyle solid 0.35 noborder
set xrange [0:8]
set yrange [-16:0]
set xtics 1,2,7 format '10^{%.0f}'
set ytics 4 format '10^{%.0f}'
set xlabel 'distance / radius'
set ylabel 'depth under the rim / radius'
do for [i=1:maps] {
    if (i > 1) { set format y ''; unset ylabel }
    if (i < maps) {
        unset colorbox
    } else {
        set colorbox user origin 0.91,0.20 size 0.015,0.69
        set cblabel 'correct digits of t'
    }
    set title title[i]
    plot 'kernels_map.csv' skip 1 every ::first[i]::last[i] using 2:3:4 with image pixels
}
unset multiplot
