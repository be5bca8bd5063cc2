# Time to build a grid against the number of triangles, which grows as `build_law`, and from how many rays on it
# has paid.
set datafile missing NaN
set logscale xy
set format x '10^{%T}'
set format y '%.0s %cs'
set xlabel 'triangles N'
set ylabel 'time to build the grid'
set y2tics
set logscale y2
set format y2 '%g'
set ytics nomirror
set y2range [10:10000]
set y2label 'rays until building has paid'
set key top left
set xrange [fewest/1.5:most*1.5]
plot 'grids.csv' skip 1 using 1:2 with linespoints pointtype 7 linewidth 1.6 linecolor rgb blue \
         title 'time to build: '.build_law, \
     '' skip 1 using 1:8 axes x1y2 with linespoints pointtype 7 linewidth 1.6 linecolor rgb orange \
         title 'rays until it has paid (right)'
