# Time a call and error of t, for the methods of intersecting a ray with a `shape`. `colors` are those of its
# methods, with `names`; those of `several` stand for more than one method each.
set datafile missing NaN
set logscale xy
set xrange [2:slowest]
set yrange [1e-4:1e16]
set format y '10^{%T}'
set ytics 1e3
set xlabel 'nanoseconds a call'
set ylabel 'error of t, in units of κu|t|'
set arrow from graph 0,first 8 to graph 1,first 8 nohead linecolor rgb faint dashtype 2
set label 'demand: 8 κu' at graph 0.98,first 8 right offset 0,0.6 textcolor rgb faint font ',13'
set bmargin at screen 0.26
set key at screen 0.55,0.015 center bottom vertical maxrows 3 samplen 1 font ',14'

# Columns: 1 shape, 2 method, 3 number, 4 ns, 5 median error, 6 that of 99.99 %, 7 greatest, 11 color.
is_of(color) = strcol(1) eq shape && column(11) == color
color_of(color) = word(red.' '.orange.' '.blue.' '.green.' '.violet, color)
# Beside its point stands what a method computes with: the textbook's on the left, the course's on the right.
is_named(color) = is_of(color) && strstrt(several, sprintf('%d ', color)) > 0

plot for [i=1:words(colors)] 'kernels.csv' skip 1 using 4:(is_of(word(colors, i) + 0) ? $7 : NaN) \
         with points pointtype 7 linecolor rgb color_of(word(colors, i) + 0) title word(names, i), \
     for [i=1:words(colors)] '' skip 1 using 4:(is_of(word(colors, i) + 0) ? $6 : NaN) \
         with points pointtype 2 linecolor rgb color_of(word(colors, i) + 0) notitle, \
     for [i=1:words(colors)] '' skip 1 using 4:(is_of(word(colors, i) + 0) ? $5 : NaN):(0):($7-$5) \
         with vectors nohead linewidth 0.8 linecolor rgb color_of(word(colors, i) + 0) notitle, \
     '' skip 1 using 4:(is_named(1) ? $7 : NaN):3 \
         with labels noenhanced right offset -1,0.2 textcolor rgb red font ',14' notitle, \
     '' skip 1 using 4:(is_named(2) ? $7 : NaN):3 \
         with labels noenhanced right offset -1,0.2 textcolor rgb orange font ',14' notitle, \
     '' skip 1 using 4:(is_named(3) ? $7 : NaN):3 \
         with labels noenhanced left offset 1,0.2 textcolor rgb blue font ',14' notitle
