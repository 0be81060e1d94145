# Draws what bench_equal_cost found: cost against strain, and two of the final sheets.
#
#     bench_equal_cost --out FOLDER
#     gnuplot -c bench/peers/equal_cost.gp FOLDER     # makes FOLDER/equal_cost.png and FOLDER/sheets.png
if (ARGC < 1) { print "usage: gnuplot -c equal_cost.gp FOLDER"; exit status 2 }
figures = ARG1."/equal_cost.csv"

set terminal pngcairo size 1100, 700 font "sans,12"
set output ARG1."/equal_cost.png"
set datafile separator comma
set title "A sheet of 1 m hung by two corners, after 5 s"
set logscale xy
set xlabel "ms for each frame of 1/60 s"
set ylabel "99th percentile of |l - l0| / l0, structural and shear springs [%]"
set grid
set offsets graph 0.05, graph 0.4, graph 0.08, graph 0.05
set key top right
of(engine) = strcol("engine") eq engine ? column("strain_percentile_99") * 100 : NaN
label(setting, threads) = setting.", ".threads.(threads eq "1" ? " thread" : " threads")
plot figures using "ms_per_frame":(of("hooke")) title "Hooke" with points pt 7 ps 1.6 lc rgb "#0060ad", \
     "" using "ms_per_frame":(strcol("threads") eq "1" ? NaN : of("hooke")):(label(strcol("setting"), strcol("threads"))) notitle with labels left offset 1, 0.4, \
     "" using "ms_per_frame":(strcol("threads") eq "1" ? of("hooke") : NaN):(label(strcol("setting"), strcol("threads"))) notitle with labels left offset 1, -0.6, \
     figures using "ms_per_frame":(of("bullet")) title "Bullet" with points pt 5 ps 1.6 lc rgb "#c04000", \
     "" using "ms_per_frame":(of("bullet")):(label(strcol("setting"), strcol("threads"))) notitle with labels left offset 1, 0.4

# Gravity is along +z, so -z is up. A line for every fourth row and column of particles.
reset
first_file(pattern) = system("ls ".ARG1."/".pattern." 2>/dev/null | head -n 1")
hooke = first_file("hooke_600_substeps_*.txt")
bullet = first_file("bullet_8_substeps_of_10_iterations_*.txt")
if (hooke eq "" || bullet eq "") { print "skipped: sheets.png, which needs a sheet of each engine"; exit }
set terminal pngcairo size 1300, 750 font "sans,12"
set output ARG1."/sheets.png"
stats hooke using (-$3) name "hooke" nooutput
stats bullet using (-$3) name "bullet" nooutput
lowest = hooke_min < bullet_min ? hooke_min : bullet_min
set view 80, 20, 1.6
set view equal xyz
set xrange [-0.1:1.1]
set yrange [-0.3:0.3]
set zrange [lowest:0.05]
set xyplane at lowest
set multiplot layout 1, 2
set hidden3d
unset key
unset border
unset tics
set title "Hooke, 600 substeps a frame"
splot hooke using 1:2:(-$3) every 4:4 with lines lc rgb "#0060ad"
set title "Bullet, 8 substeps of 10 iterations"
splot bullet using 1:2:(-$3) every 4:4 with lines lc rgb "#c04000"
unset multiplot
