# Springs updated each second against the size of square cloths, for each mode and precision.
# With the variable threads: with so many; without it, with the most there are.
load plots . "/style.gp"
if (!exists("threads")) threads = most_threads
set title sprintf("Square cloths of n x n particles, %d thread%s", threads, threads == 1 ? "" : "s")
set xlabel "particles along a side, n"
set ylabel "springs updated each second [10^6 / s]"
set logscale x 2
set logscale y 10
side(particles) = sqrt(particles)
is_wanted(i) = is_cloth(strcol("mesh")) && column("threads") == threads && \
               is_series(i, strcol("mode"), strcol("precision"))
plot for [s in series] csv using (is_wanted(int(s)) ? side(column("particles")) : NaN):(column("springs_per_second") / 1e6) \
     with linespoints linestyle int(s) title name_of(int(s))
