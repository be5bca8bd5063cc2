# Error of a `scene`'s pictures against their time: the methods of `curves`, in the order of the `table`, with
# titles of their own; the first `lone` of them have one picture each. `truth` is the standard error of the truth,
# 0 where that lies far below the plot.
set datafile missing NaN
set logscale xy
set format y '10^{%T}'
set format x '%.0s %cs'
set xlabel 'CPU time'
set ylabel 'root mean square error'
set bmargin at screen 0.26
set key at screen 0.55,0.015 center bottom vertical maxrows 3 samplen 2 width -3 font ',14'
set xrange [fastest/1.7:slowest*1.7]
set yrange [least/2:greatest*2]
if (truth > 0) {
    set arrow from graph 0,first truth to graph 1,first truth nohead linecolor rgb faint dashtype 2
    set label 'standard error of the truth' at graph 0.98,first truth right offset 0,0.6 \
        textcolor rgb faint font ',13'
}

# Columns: 1 scene, 2 method, 5 seconds, 6 error.
error_of(i) = strcol(1) eq scene && strcol(2) eq method[i] ? $6 : NaN
plot for [i=1:lone] table skip 1 using 5:(error_of(i)) \
         with points pointtype 7 linewidth 1.6 linecolor rgb sampling_color(method[i]) title title[i], \
     for [i=lone+1:curves] table skip 1 using 5:(error_of(i)) \
         with linespoints pointtype 7 linewidth 1.6 linecolor rgb sampling_color(method[i]) title title[i]
