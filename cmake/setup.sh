# Sourced by run.sh and test.sh: gets a machine ready and configures the release build. Written for the bash 3.2 of
# macOS too.

project=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir=$project/build/release

tools="a C++20 compiler (GCC 11, Clang 14 or newer), CMake 3.22 or newer, Ninja"
program_libraries="Eigen 3, oneTBB, Highway, nlohmann-json, CLI11, tinyobjloader (and gnuplot for plots; for pictures \
and the viewer libepoxy, GLFW, Dear ImGui, libpng, EGL, Mesa's drivers and ffmpeg)"
program_packages="libeigen3-dev libtbb-dev libhwy-dev nlohmann-json3-dev libcli11-dev libtinyobjloader-dev gnuplot-nox \
pkg-config libepoxy-dev libglfw3-dev libimgui-dev libpng-dev libegl1 libgl1-mesa-dri ffmpeg fonts-dejavu-core"
test_libraries="doctest, Google Benchmark"
test_packages="doctest-dev libbenchmark-dev libboost-dev python3-jsonschema xvfb libxtst-dev"
# Other programs that the engine is compared with. They bring 800 MB, so only .ci/run installs them; where they are
# absent, their tests are skipped and say so.
reference_packages="libsundials-dev lammps"

fail() {
  printf '\n%s: %s\n' "$(basename "$0")" "$*" >&2
  exit 1
}

# The comment at the head of the script that was started.
usage() {
  sed -n '2,/^[^#]/s/^# \{0,1\}//p' "$0"
  exit
}

# missing_packages PACKAGE...: the names of the Debian packages that this machine lacks: of these, and of the tools,
# which may also have come by another way.
missing_packages() {
  local package
  command -v "${CXX:-c++}" >/dev/null || printf 'g++ '
  command -v cmake >/dev/null || printf 'cmake '
  command -v ninja >/dev/null || printf 'ninja-build '
  for package in "$@"; do
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || printf '%s ' "$package"
  done
}

# Runs a command as root, if that can be had without a question.
as_root() {
  if [ "$(id -u)" = 0 ]; then
    "$@"
  else
    sudo -n "$@"
  fi
}

install_packages() {
  echo "Installing $*"
  as_root env DEBIAN_FRONTEND=noninteractive apt-get update -qq || true # a package source out of reach may not matter
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "$@" >/dev/null
}

# provide LIBRARIES PACKAGE...: installs the packages that are missing, where that can be done. Where it cannot, goes on:
# CMake may find the libraries elsewhere, and if it does not, `remedy` says what to do.
provide() {
  local missing
  remedy="Hooke needs $tools, $1."
  shift
  if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    return
  fi
  missing=$(missing_packages "$@")
  if [ -z "$missing" ]; then
    return
  fi
  if as_root true 2>/dev/null; then
    install_packages $missing || fail "These packages could not be installed: $missing"
  else
    remedy="$remedy Packages that are not installed: sudo apt-get install $missing"
  fi
}

# configure OPTIONS...: configures the release build.
configure() {
  command -v cmake >/dev/null || fail "There is no CMake. $remedy"
  cmake -S "$project" --preset release "$@" || fail "CMake could not configure the build; it says why above. $remedy"
}

# build OPTIONS...: brings the release build up to date.
build() {
  cmake --build "$build_dir" "$@" || fail "The build failed; the compiler says why above."
}
