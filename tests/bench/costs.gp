# Seconds against traced pixels, from costs.csv of halftone-bench --costs:
#   gnuplot -e "kind='svg'" tests/bench/costs.gp    (or kind='png')
set datafile separator ','
if (kind eq 'svg') { set terminal svg size 800,560 font 'sans,13' } else { set terminal png size 800,560 }
set output 'costs.' . kind
set xlabel 'traced pixels'
set ylabel 'seconds'
set xrange [0:*]
set yrange [0:*]
set key outside below
set grid
table(name) = sprintf("< grep '^%s,' costs.csv", name)
set fit quiet logfile '/dev/null'
stats table('number') using 5 nooutput
most = STATS_max
number(x) = x > most ? NaN : a * x + b
zoom(x) = c * x + d
c = a = 1e-5
fit number(x) table('number') using 5:6 via a, b
fit zoom(x) table('zoom') using 5:6 via c, d
plot table('number') using 5:6 with points pt 7 lc rgb '#0055aa' title 'more and more prisms of glass', \
     number(x) with lines lc rgb '#0055aa' notitle, \
     table('zoom') using 5:6 with points pt 5 lc rgb '#aa3300' title 'figure 9 (a) by the field of view', \
     zoom(x) with lines lc rgb '#aa3300' notitle
