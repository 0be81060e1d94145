# Speed-up against the number of threads, for each mode and precision, on the largest square cloth.
load plots . "/style.gp"
stats csv using (is_cloth(strcol("mesh")) ? column("particles") : NaN) name "PARTICLES" nooutput
largest = PARTICLES_max
is_wanted(i) = is_cloth(strcol("mesh")) && column("particles") == largest && \
               is_series(i, strcol("mode"), strcol("precision"))
array one_thread[6]
do for [s in series] {
  stats csv using (is_wanted(int(s)) && column("threads") == 1 ? column("springs_per_second") : NaN) name "ONE" nooutput
  one_thread[int(s)] = ONE_max
}
set title sprintf("Cloth of %.0f x %.0f particles: how many times as fast as one thread", sqrt(largest), sqrt(largest))
set xlabel "threads"
set ylabel "speed-up [1]"
set logscale xy 2
set xrange [0.9:1.1 * most_threads]
set yrange [0.7:1.2 * most_threads]
plot x with lines linecolor rgb "#999999" dashtype 3 title "ideal", \
     for [s in series] csv using (is_wanted(int(s)) ? column("threads") : NaN):(column("springs_per_second") / one_thread[int(s)]) \
     with linespoints linestyle int(s) title name_of(int(s))
