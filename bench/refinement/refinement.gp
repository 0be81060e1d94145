# Draws what bench_refinement found: how a sheet depends on its mesh.
#
#     bench_refinement FOLDER
#     gnuplot -c bench/refinement/refinement.gp FOLDER/refinement.csv PICTURES   # refinement_*.png
if (ARGC < 2) { print "usage: gnuplot -c refinement.gp FILE.csv FOLDER"; exit status 2 }
csv = ARG1
set terminal pngcairo size 1000, 560 font "sans,12" background "white"
set datafile separator comma
set datafile missing NaN
set grid back linetype 1 linecolor rgb "#d8d8d8" linewidth 0.7
set border 3
set tics nomirror
set key outside right center vertical samplen 3 width 1

patterns = "grid structured alternating jittered"
modes = "naive springs triangles"
names = '"naive springs" "calibrated springs" "tensile triangles"'
colours = "#7a7a7a #d1661b #1b6ca8"
points = "7 5 9 13"

# The value of a row of the file, where it is of this kind.
of(quantity, p, m) = strcol("quantity") eq quantity && strcol("pattern") eq word(patterns, p) && \
                     strcol("mode") eq word(modes, m) ? column("value") : NaN
at_0(value) = column("angle") == 0 ? value : NaN
at_32(value) = column("cells") == 32 ? value : NaN
name(p, m) = word(names, m).", ".word(patterns, p)

set logscale x 2
set xrange [7:150]
set xtics (8, 16, 32, 64, 128)
set xlabel "cells a side"

set output ARG2."/refinement_stretch.png"
set title "The same sheet, stretched, divided more and less finely"
set ylabel "Young's modulus over the material's"
plot for [m = 1:3] for [p = 1:4] csv using "cells":(at_0(of("young", p, m))) with linespoints \
     pt int(word(points, p)) ps 1.1 lw 1.6 lc rgb word(colours, m) title name(p, m)

set output ARG2."/refinement_sag.png"
set title "A strip that hangs by its own weight"
set ylabel "sag over M g L / (2 E w)"
plot for [m = 1:3] for [p = 1:4] csv using "cells":(at_0(of("sag", p, m))) with linespoints \
     pt int(word(points, p)) ps 1.1 lw 1.6 lc rgb word(colours, m) title name(p, m)

set output ARG2."/refinement_frequency.png"
set title "A membrane that is held at its rim"
set ylabel "lowest frequency over the continuum's"
plot for [m = 1:3] for [p = 1:4] csv using "cells":(at_0(of("frequency", p, m))) with linespoints \
     pt int(word(points, p)) ps 1.1 lw 1.6 lc rgb word(colours, m) title name(p, m)

unset logscale x
set xrange [-2:47]
set xtics (0, 15, 30, 45)
set xlabel "angle between the mesh and the pull [deg]"
set output ARG2."/refinement_angle.png"
set title "The same sheet of 32 x 32 cells, stretched in other directions"
set ylabel "Young's modulus over the material's"
plot for [m = 1:3] for [p = 1:4] csv using "angle":(at_32(of("young", p, m))) with linespoints \
     pt int(word(points, p)) ps 1.1 lw 1.6 lc rgb word(colours, m) title name(p, m)
