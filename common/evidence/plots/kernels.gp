# Time a call and error of t, for the methods of intersecting a ray with a `shape`; `has_constants` says
# whether there is a textbook's formula with its constants for it.
set datafile missing NaN
set logscale xy
set xrange [2:20000]
set yrange [1e-4:1e14]
set format y '10^{%T}'
set ytics 1e3
set xlabel 'nanoseconds a call'
set ylabel 'error of t, in units of κu|t|'
set arrow from graph 0,first 8 to graph 1,first 8 nohead linecolor rgb faint dashtype 2
set label 'demand: 8 κu' at graph 0.98,first 8 right offset 0,0.6 textcolor rgb faint font ',13'
set bmargin at screen 0.26
set key at screen 0.55,0.015 center bottom vertical maxrows 3 samplen 1 font ',14'

# Columns: 1 shape, 2 method, 3 number, 4 ns, 5 median error, 6 that of 99.99 %, 7 greatest.
is_way(way) = strcol(1) ne shape ? 0 : \
    way == 1 ? strcol(2) eq 'textbook' : \
    way == 2 ? strcol(2) eq 'textbook with its constants' : \
    way == 3 ? (strcol(2) eq 'stable' || strcol(2) eq 'watertight') && strcol(3) ne 'interval' : \
    way == 4 ? strcol(3) eq 'interval' : strcol(3) eq 'exact'
name_of(way) = word("textbook 'textbook with its constants' stable intervals exact", way)
color_of(way) = word(red.' '.orange.' '.blue.' '.green.' '.violet, way)
ways = has_constants ? '1 2 3 4 5' : '1 3 4 5'
# What a method computes with stands beside its point: the textbook's on the left, the course's on the right.
is_named(way) = is_way(way) && strcol(3) ne 'interval' && strcol(3) ne 'exact'

plot for [way in ways] 'kernels.csv' skip 1 using 4:(is_way(way + 0) ? $7 : NaN) \
         with points pointtype 7 linecolor rgb color_of(way + 0) title name_of(way + 0), \
     for [way in ways] '' skip 1 using 4:(is_way(way + 0) ? $6 : NaN) \
         with points pointtype 2 linecolor rgb color_of(way + 0) notitle, \
     for [way in ways] '' skip 1 using 4:(is_way(way + 0) ? $5 : NaN):(0):($7-$5) \
         with vectors nohead linewidth 0.8 linecolor rgb color_of(way + 0) notitle, \
     '' skip 1 using 4:(is_named(1) ? $7 : NaN):3 \
         with labels noenhanced right offset -1,0.2 textcolor rgb red font ',14' notitle, \
     '' skip 1 using 4:(is_named(3) ? $7 : NaN):3 \
         with labels noenhanced left offset 1,0.2 textcolor rgb blue font ',14' notitle
