#!/bin/sh
# pkg_config.sh PREFIX PROGRAM: builds main.cpp against the Hooke installed in PREFIX, as a user without CMake does, and
# runs it.
set -eu
here=$(dirname "$0")
prefix=$1 program=$2

PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name hooke.pc)")
export PKG_CONFIG_PATH
"${CXX:-c++}" -std=c++20 "$here/main.cpp" $(pkg-config --cflags --libs hooke) -o "$program"
LD_LIBRARY_PATH=$(pkg-config --variable=libdir hooke) "$program"
