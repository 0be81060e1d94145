#!/usr/bin/env bash
# Draws every picture of docs/gallery.md, writes what the demos cost into its table, and makes of six pictures the one
# at the head of README.md (with ffmpeg).
#
#   docs/gallery.sh            with the demos of build/release
#   docs/gallery.sh BUILD      with those of another build
set -euo pipefail
docs=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
demos=${1:-$docs/../build/release}/bin/demos
[ -x "$demos/hello" ] || { echo "There are no demos in $demos: build them, or name another build" >&2; exit 1; }

table=$(mktemp)
trap 'rm -f "$table"' EXIT
processor=$(sed -n 's/^model name[[:space:]]*: //p' /proc/cpuinfo 2>/dev/null | head -n 1)
{
  echo
  echo "On $(getconf _NPROCESSORS_ONLN) cores of ${processor:-an unknown processor}, $(date +%Y-%m-%d):"
  echo
  echo '| demo | ms a step | particles | springs | threads |'
  echo '|---|---|---|---|---|'
} >"$table"

# Each in the order in which it is shown. A demo that finds untrue what it claims ends this.
for demo in $(grep -o 'bin/demos/[a-z_]*' "$docs/gallery.md" | sed 's#.*/##' | awk '!seen[$0]++'); do
  said=$("$demos/$demo" --picture "$docs/pictures/gallery/$demo.png")
  echo "$said"
  row=$(sed -n 's/^  cost: \([^ ]*\) ms a step (\([0-9]*\) particles\{0,1\}, \([0-9]*\) springs\{0,1\}, \([0-9]*\) thread.*/\1 | \2 | \3 | \4/p' \
    <<<"$said")
  [ -n "$row" ] || { echo "$demo does not say what it costs" >&2; exit 1; }
  echo "| \`$demo\` | $row |" >>"$table"
done
echo >>"$table"

(
  cd "$docs/pictures/gallery"
  small='scale=480:270:flags=lanczos,setsar=1'
  ffmpeg -y -loglevel error -i curtain.png -i rope_bridge.png -i thread_pool.png -i million_springs.png -i scene_editing.png \
    -i game_loop.png -frames:v 1 -filter_complex "[0]$small[a];[1]$small[b];[2]$small[c];[3]$small[d];[4]$small[e];[5]$small[f];
    [a][b][c]hstack=3[upper];[d][e][f]hstack=3[lower];[upper][lower]vstack" ../demos.png
)

# The table goes between the two marks.
awk -v table="$table" '
  /<!-- end of costs -->/ { while ((getline line < table) > 0) print line; inside = 0 }
  !inside { print }
  /<!-- costs -->/ { inside = 1 }' "$docs/gallery.md" >"$table.new"
mv "$table.new" "$docs/gallery.md"
