# gnuplot -e "table='times.csv'; picture='times.svg'" tests/bench/plot.gp
set datafile separator ','
set terminal svg size 1000,1250 font 'sans,12'
set output picture
set logscale xy
set xrange [0.005:100]
set yrange [0.03:10]
set format x '%g'
set format y '%g'
set key top right
set grid
set multiplot layout 5,2 title 'Error (RMSE, 8-bit levels) against time (s)'
do for [scene in 'fig9a fig9b contact nested inside mirrors sliver cyclic opaque round'] {
  set title scene
  points(method) = sprintf("< grep '^%s,%s,' %s", scene, method, table)
  plot points('areas') using 4:5 with linespoints pt 7 lc rgb '#0055aa' title 'by area, quality 0.1 to 4', \
       points('lines') using 4:5 with linespoints pt 4 lc rgb '#aa3300' title '1 to 64 virtual scanlines'
}
unset multiplot
