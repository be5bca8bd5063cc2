# True over estimated error of pictures, for the methods of `curves`.
set datafile missing NaN
set logscale xy
set xlabel 'samples a pixel'
set ylabel 'true error / estimated error'
set yrange [0.05:4]
set xrange [3:400]
set ytics (0.05, 0.1, 0.2, 0.5, 1, 2, 4)
set bmargin at screen 0.25
set key at screen 0.55,0.015 center bottom vertical maxrows 2 samplen 1 font ',14'
set object 1 rectangle from graph 0,first 1/1.5 to graph 1,first 1.5 behind \
    fillcolor rgb '#8e959e' fillstyle solid 0.25 noborder

# Columns: 2 method, 3 samples asked for, 6 error, 7 its estimate. Side by side, so that the methods' points do
# not cover each other.
plot for [i=1:curves] 'pictures.csv' skip 1 using ($3*(0.85+0.05*i)): \
    (strcol(2) eq method[i] && $7 > 0 ? ($6/$7 > 0.05 ? $6/$7 : 0.052) : NaN) \
    with points pointtype 7 linecolor rgb sampling_color(method[i]) title method[i]
