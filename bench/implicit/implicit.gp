# Draws what bench_implicit found: what is left of the error of one frame against iterations and against time.
#
#     bench_implicit FILE.csv
#     gnuplot -c bench/implicit/implicit.gp FILE.csv FOLDER   # FOLDER/implicit_iterations.png, implicit_time.png
if (ARGC < 2) { print "usage: gnuplot -c implicit.gp FILE.csv FOLDER"; exit status 2 }
csv = ARG1
set terminal pngcairo size 1100, 640 font "sans,12" background "white"
set datafile separator comma
set datafile missing "nan"
set grid back linetype 1 linecolor rgb "#d8d8d8" linewidth 0.7
set border 3
set tics nomirror
set logscale xy
set format y "10^{%T}"
set key outside right center vertical samplen 3 width 1
set ylabel "(g(x) - g(x*)) / (g(x_0) - g(x*))"

# Each method has a row here; those that the file lacks are left out.
names = '"projective dynamics (2013)" "projective dynamics" "Newton-PCG" "vertex block descent" "XPBD"'
colours = "#1b6ca8 #d1661b #2c8a3d #8d4bab #7a7a7a"
has(name) = int(system("grep -c '^".name.",' ".csv)) > 0
shown = ""
do for [i = 1:words(names)] { if (has(word(names, i))) { shown = shown." ".i } }
of(i, kind) = strcol("method") eq word(names, int(i)) && strcol("precision") eq kind
float_column(i, what) = of(i, "float") ? column(what) : NaN
double_column(i, what) = of(i, "double") ? column(what) : NaN
colour(i) = word(colours, int(i))

$published << PUBLISHED
1,5.4,3.61e-1
10,50.6,1.96e-1
100,501,4.02e-2
1000,5050,2.98e-4
PUBLISHED
$published_newton << PUBLISHED
1,181,2.496e-1
PUBLISHED

set output ARG2."/implicit_iterations.png"
set title "One frame of a curtain of 32,158 springs, 1/30 s: error against iterations, double precision"
set xlabel "iterations"
plot for [i in shown] csv using "iterations":(double_column(i, "potential_error")) with linespoints pt 7 ps 0.9 lw 2 \
         lc rgb colour(i) title word(names, int(i)), \
     $published using 1:3 with linespoints pt 6 ps 1.2 dt 2 lc rgb "black" title "published, Liu et al. 2013", \
     $published_newton using 1:3 with points pt 4 ps 1.4 lc rgb "black" title "published, Newton + PCG"

set output ARG2."/implicit_time.png"
set title "One frame of a curtain of 32,158 springs, 1/30 s: error against time, float, one thread"
set xlabel "time of the frame [ms]"
substeps = real(system("awk -F, '$1 == \"symplectic Euler\" && $2 == \"float\" { print $6 }' ".csv))
set arrow 1 from substeps, graph 0 to substeps, graph 1 nohead dt 3 lw 1.5 lc rgb "#555555"
set label 1 "explicit\nsubsteps" at substeps, graph 0.06 offset 0.5, 0 tc rgb "#555555"
plot for [i in shown] csv using "milliseconds":(float_column(i, "potential_error")) with linespoints pt 7 ps 0.9 lw 2 \
         lc rgb colour(i) title word(names, int(i)), \
     $published using 2:3 with linespoints pt 6 ps 1.2 dt 2 lc rgb "black" title "published, Liu et al. 2013", \
     $published_newton using 2:3 with points pt 4 ps 1.4 lc rgb "black" title "published, Newton + PCG"
