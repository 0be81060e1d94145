#!/usr/bin/env bash
# Builds everything and runs the tests.
#
#   ./test.sh                  all of them
#   ./test.sh -R determinism   options go to ctest: these tests
#   ./test.sh -LE install      all but those with the label `install`
#
# Debian packages that the build needs and that are missing are installed, if that takes no password.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/cmake/setup.sh"

provide "$program_libraries, $test_libraries" $program_packages $test_packages
configure -DHOOKE_BUILD_TESTS=ON -DHOOKE_BUILD_BENCHMARKS=ON
build
ctest --test-dir "$build_dir" --output-on-failure --no-tests=error --parallel "$(getconf _NPROCESSORS_ONLN)" "$@"
