# Springs updated each second on irregular meshes, with the most threads, for each mode and precision.
load plots . "/style.gp"
set title sprintf("Irregular meshes, %d thread%s", most_threads, most_threads == 1 ? "" : "s")
set xlabel "particles"
set ylabel "springs updated each second [10^6 / s]"
set logscale x 10
set logscale y 10
is_wanted(i) = !is_cloth(strcol("mesh")) && column("threads") == most_threads && \
               is_series(i, strcol("mode"), strcol("precision"))
plot for [i = 1:6] csv using (is_wanted(i) ? column("particles") : NaN):(column("springs_per_second") / 1e6) \
     with linespoints linestyle i title name_of(i)
