#!/usr/bin/env bash
# Builds the hooke program and simulates a scene.
#
#   ./run.sh                           the curtain
#   ./run.sh SCENE.json [OPTIONS]      another scene, with options of `hooke run`
#   ./run.sh --format pc2 [OPTIONS]    the curtain, with options
#
# Frames go to out/SCENE, unless --out names another folder. Debian packages that the build needs and that are missing
# are installed, if that takes no password.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/cmake/setup.sh"

case ${1:-} in
  -h | --help) usage ;;
  '' | -*) scene=$project/demos/scenes/curtain.json ;;
  *) scene=$1 && shift ;;
esac
case " $* " in
  *" --out "* | *" --out="*) ;;
  *) set -- --out "$project/out/$(basename "$scene" .json)" "$@" ;;
esac

provide "$program_libraries" $program_packages

# Tests and benchmarks are left out of a first configuration, so that their libraries are not needed here. A build that
# test.sh or a developer configured stays as it is.
if [ ! -f "$build_dir/build.ninja" ]; then
  configure -DHOOKE_BUILD_TESTS=OFF -DHOOKE_BUILD_BENCHMARKS=OFF
fi
build --target hooke_cli

"$build_dir/bin/hooke" run "$scene" "$@"
echo "ParaView opens a .pvd file. For Blender: --format pc2 or --format obj."
