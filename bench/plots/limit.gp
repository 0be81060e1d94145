# How near a step is to what the machine can do, against the size of square cloths, with the most threads.
load plots . "/style.gp"
set title sprintf("Share of the machine's limit, square cloths, %d thread%s", most_threads, most_threads == 1 ? "" : "s")
set xlabel "particles along a side, n"
set ylabel "shortest possible time of a step / its time [%]"
set logscale x 2
set yrange [0:*]
is_wanted(i) = is_cloth(strcol("mesh")) && column("threads") == most_threads && \
               is_series(i, strcol("mode"), strcol("precision"))
plot for [s in series] csv using (is_wanted(int(s)) ? sqrt(column("particles")) : NaN):(100 * column("share_of_limit")) \
     with linespoints linestyle int(s) title name_of(int(s))
