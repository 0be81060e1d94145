#!/usr/bin/env bash
# Draws the figures of hooke_scaling.
#
#   bench/plot.sh SCALING.csv FOLDER
#
# Makes size_1_thread.png, size.png, threads.png, limit.png and meshes.png in the folder. Needs gnuplot.
set -euo pipefail
if [ $# -ne 2 ]; then
  sed -n '2,/^[^#]/s/^# \{0,1\}//p' "$0"
  exit 2
fi
csv=$1
folder=$2
plots=$(dirname "${BASH_SOURCE[0]}")/plots
if ! command -v gnuplot >/dev/null; then
  echo "skipped: there is no gnuplot (Debian: gnuplot-nox)"
  exit 0
fi
[ -r "$csv" ] || { echo "plot.sh: $csv cannot be read; give a file that hooke_scaling wrote" >&2; exit 2; }
mkdir -p "$folder"

# draw NAME SCRIPT [ASSIGNMENTS]
draw() {
  gnuplot -e "plots='$plots'; csv='$csv'; png='$folder/$1.png'; ${3:-}" "$plots/$2.gp"
  echo "$folder/$1.png"
}

# has PATTERN: whether the file has a row of this kind; a plot of none would be an error.
has() {
  grep -q "$1" "$csv"
}

if has '^cloth_'; then
  draw size size
  draw limit limit
fi
if has '^cloth_.*,1,\(float\|double\),'; then
  draw size_1_thread size "threads=1"
  draw threads threads
fi
if has '^[^,]*[0-9]\+[KM],'; then
  draw meshes meshes
fi
