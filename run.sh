#!/usr/bin/env bash
# Builds the hooke program and simulates a scene.
#
#   ./run.sh                           the curtain
#   ./run.sh SCENE.json [OPTIONS]      another scene, with options of `hooke run`
#   ./run.sh --format pc2 [OPTIONS]    the curtain, with options
#
# Frames and a picture of six moments (docs/pictures.md) go to out/SCENE, unless --out names another folder. Debian packages that the build
# needs and that are missing are installed, if that takes no password.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/cmake/setup.sh"

# given NAME WORDS...: whether the option is among the words.
given() {
  local name=$1 word
  shift
  for word in "$@"; do
    case $word in "$name" | "$name="*) return 0 ;; esac
  done
  return 1
}

# value NAME WORDS...: what the option was given.
value() {
  local name=$1 word before=
  shift
  for word in "$@"; do
    if [ "$before" = "$name" ]; then echo "$word"; fi
    case $word in "$name="*) echo "${word#*=}" ;; esac
    before=$word
  done
}

case ${1:-} in
  -h | --help) usage ;;
  '' | -*) scene=$project/demos/scenes/curtain.json ;;
  *) scene=$1 && shift ;;
esac
name=$(basename "$scene" .json)
given --out "$@" || set -- --out "$project/out/$name" "$@"

provide "$program_libraries" $program_packages

# Tests and benchmarks are left out of a first configuration, so that their libraries are not needed here. A build that
# test.sh or a developer configured stays as it is.
if [ ! -f "$build_dir/build.ninja" ]; then
  configure -DHOOKE_BUILD_TESTS=OFF -DHOOKE_BUILD_BENCHMARKS=OFF
fi
build --target hooke_cli
hooke=$build_dir/bin/hooke

# Where no picture can be drawn, as a small one shows, the run goes on without and it is said why.
words="ParaView opens a .pvd file. For Blender: --format pc2 or --format obj."
if ! given --picture "$@"; then
  sheet=$(value --out "$@")/${name}_sheet.png
  if problem=$("$hooke" run "$project/demos/scenes/spring.json" --seconds 0 --picture "$build_dir/drawn.png" 2>&1 >/dev/null)
  then
    given --sheet "$@" || set -- "$@" --sheet 3x2
    given --size "$@" || set -- "$@" --size 1600x900
    set -- "$@" --picture "$sheet"
    words="$words
To see it at a glance: $sheet"
  else
    words="$words
No picture of it was drawn: ${problem#hooke: }"
  fi
fi

"$hooke" run "$scene" "$@"
echo "$words"
