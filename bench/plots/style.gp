# What all plots share. Variables given by plot.sh: csv (the file of figures), png (the picture to make).
set terminal pngcairo size 1000,620 font "sans,12" background "white"
set output png
set datafile separator ","
set datafile missing "NaN"
set grid back linetype 1 linecolor rgb "#d8d8d8" linewidth 0.7
set offsets graph 0.03, graph 0.03, 0, 0
set border 3
set tics nomirror
set key outside right center vertical samplen 4 width 1

# One colour for each mode, full lines and points for float, hollow ones and dashes for double.
set style line 1 linecolor rgb "#1b6ca8" linewidth 2 pointtype 7 pointsize 1.1
set style line 2 linecolor rgb "#1b6ca8" linewidth 2 pointtype 6 pointsize 1.1 dashtype 2
set style line 3 linecolor rgb "#d1661b" linewidth 2 pointtype 5 pointsize 1.1
set style line 4 linecolor rgb "#d1661b" linewidth 2 pointtype 4 pointsize 1.1 dashtype 2
set style line 5 linecolor rgb "#4c8c3f" linewidth 2 pointtype 9 pointsize 1.1
set style line 6 linecolor rgb "#4c8c3f" linewidth 2 pointtype 8 pointsize 1.1 dashtype 2
modes = "gather coloured atomic"
precisions = "float double"
mode_of(i) = word(modes, (i + 1) / 2)
precision_of(i) = word(precisions, 1 + (i + 1) % 2)
name_of(i) = mode_of(i) . ", " . precision_of(i)

# The series that the file has rows of.
rows_of(i) = int(system(sprintf("grep -c ',%s,[0-9]*,%s,' '%s' || true", mode_of(i), precision_of(i), csv)))
series = ""
do for [i = 1:6] { if (rows_of(i) > 0) { series = series . sprintf(" %d", i) } }

# Whether a row is of the square cloths, and of series i.
is_cloth(mesh) = mesh[1:6] eq "cloth_"
is_series(i, mode, precision) = mode eq mode_of(i) && precision eq precision_of(i)

stats csv using (is_cloth(strcol("mesh")) ? column("threads") : NaN) name "THREADS" nooutput
most_threads = int(THREADS_max)
