# Springs updated each second on each irregular mesh, with the most threads, for each mode and precision.
load plots . "/style.gp"
set title sprintf("Irregular meshes, from small to large, %d thread%s", most_threads, most_threads == 1 ? "" : "s")
set ylabel "springs updated each second [10^6 / s]"
set yrange [0:*]
set grid noxtics

meshes = "jittered10K square26K skirt32K jittered100K jittered1M"
place(mesh) = (sum [m = 1:words(meshes)] (word(meshes, m) eq mesh ? m : 0))
set xrange [0.5:words(meshes) + 0.5]
set xtics () scale 0
set for [m = 1:words(meshes)] xtics add (word(meshes, m) m)

# Six bars for each mesh, side by side.
set boxwidth 0.11
set style fill solid 0.9 border
is_wanted(i) = place(strcol("mesh")) > 0 && column("threads") == most_threads && \
               is_series(i, strcol("mode"), strcol("precision"))
plot for [s in series] csv using (is_wanted(int(s)) ? place(strcol("mesh")) + 0.13 * (s - 3.5) : NaN):(column("springs_per_second") / 1e6) \
     with boxes linestyle int(s) dashtype 1 fillstyle solid (s % 2 == 1 ? 0.9 : 0.35) title name_of(int(s))
