# Error against time of one scene, from times.csv of halftone-bench:
#   gnuplot -e "table='times.csv'; scene='fig9a'; kind='svg'; at=0.35" tests/bench/plot.gp    (or kind='png')
set datafile separator ','
if (kind eq 'svg') { set terminal svg size 800,560 font 'sans,13' } else { set terminal png size 800,560 }
set output scene . '.' . kind
set logscale xy
set format x '%g'
set format y '%g'
set xlabel 'seconds'
set ylabel 'RMSE, 8-bit levels'
set key outside below
set grid
set title scene
points(contender) = sprintf("< grep '^%s,%s,' %s", scene, contender, table)
plot points('areas') using 4:5 with linespoints pt 7 lw 2 lc rgb '#0055aa' title 'Halftone, rows by area', \
     points('lines') using 4:5 with linespoints pt 4 lc rgb '#5599dd' title 'Halftone, virtual scanlines', \
     points('full') using 4:5 with linespoints pt 6 lc rgb '#999999' title 'Halftone, every pixel traced', \
     points('embree') using 4:5 with linespoints pt 5 lc rgb '#aa3300' title 'Whitted on Embree, adaptive', \
     points('povray-1') using 4:5 with linespoints pt 8 lc rgb '#228833' title 'POV-Ray 3.7, method 1', \
     points('povray-2') using 4:5 with linespoints pt 10 lc rgb '#66aa22' title 'POV-Ray 3.7, method 2', \
     at with lines dt 2 lc rgb '#666666' notitle
