#pragma once

#include <string>

#include <hooke/hooke.h>

/// The scenes that are timed.

namespace hooke::bench {

struct BenchScene {
  std::string name;
  Scene scene;
  double step;  ///< [s] half of the largest stable one, so that a run of any length stays good
};

/// A cloth of n x n particles and 1 m, six springs a particle, hung by two corners, in gravity and drag.
BenchScene cloth(Index n);

/// A cloth from a mesh file, hung by the 2 cm furthest along -z, likewise.
BenchScene mesh_cloth(const std::string& name, const std::string& file);

/// A cloth from the jittered mesh of columns x rows vertices, hung by its highest 2 cm, likewise.
BenchScene jittered_cloth(const std::string& name, Index columns, Index rows);

}  // namespace hooke::bench
