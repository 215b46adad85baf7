# Error against time of the settings in rows.csv, a plot for each scene: gnuplot rows.gp, in this folder.
set terminal svg size 1000, 1250 background "white"
set output "rows.svg"
set datafile separator ","
set logscale xy
set grid
set key top right
set format x "%g"
set format y "%g"
set multiplot layout 5, 2
do for [scene in "fig9a fig9b contact nested inside mirrors sliver cyclic opaque round"] {
  set title scene
  set xlabel "seconds, two threads"
  set ylabel "RMSE, levels"
  plot for [method in "areas lines"] "rows.csv" \
    using (stringcolumn(1) eq scene && stringcolumn(2) eq method ? $4 : NaN):6 \
    with linespoints pointtype 7 pointsize 0.5 title method eq "areas" ? "by area" : "virtual scanlines"
}
unset multiplot
