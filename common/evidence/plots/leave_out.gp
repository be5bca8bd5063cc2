# Instructions of the general renderer over those of one for just the scene, a row a feature; a bar marks what is
# allowed. `rows` is their number, `most` the greatest ratio that is shown.
set datafile missing NaN
set lmargin 30
set yrange [rows-0.3:-0.7]
set ytics noenhanced
set xrange [0.995:most*1.005]
set xlabel 'instructions, over those of a renderer for just the scene'
unset key
set arrow from 1,graph 0 to 1,graph 1 nohead linecolor rgb 'black' linewidth 0.6

# Columns: 1 feature, 3 instructions of the minimal renderer, 4 ratio, 5 limit.
plot 'leave_out.csv' skip 1 using ($5/$3):($0-0.35):(0):(0.7) with vectors nohead linewidth 2 linecolor rgb red, \
     '' skip 1 using 4:0:ytic(1) with points pointtype 7 linecolor rgb blue
