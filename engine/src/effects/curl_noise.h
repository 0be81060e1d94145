#pragma once

#include <array>
#include <cstdint>

#include <hooke/fields.h>

#include "aligned.h"

namespace hooke {

/// What the eight corners of a lattice cell have, x fastest: the gradients of the three components of the
/// potential there, and what their curl is.
struct NoiseCell {
  alignas(cache_line) double gradient[3][3][8];  ///< of each component, along each axis
  alignas(cache_line) double curl[3][8];
};

/// The values of a TurbulenceField at one time: the curl of a vector potential, each component of which is
/// gradient noise (Perlin 1985, with the quintic of 2002) on a lattice whose gradients change with time.
/// Derivatives are those of the polynomials, so there are no sources to rounding.
///
/// It remembers some of the lattice cells that it was asked for, as places that are asked for behind one
/// another are mostly in few of them: one object for each thread.
class CurlNoise {
 public:
  CurlNoise(const TurbulenceField& field, double time);

  Vec3 operator()(const Vec3& position) const;

 private:
  static constexpr std::size_t most_octaves = 8;

  using Corner = std::array<std::int64_t, 3>;

  struct Cell : NoiseCell {
    Corner lowest{};
    bool known = false;
  };

  struct Octave {
    double scale = 0.0;           ///< of the curl on the lattice
    double inverse_length = 0.0;  ///< [1/m]
    double time = 0.0;            ///< in durations
    std::uint64_t seed = 0;
    std::array<Cell, 8> cells;  ///< each at the place that the last bits of its coordinates say
  };

  static Vec3 curl(Octave& octave, const Vec3& position);
  static const Cell& cell_at(Octave& octave, const Corner& lowest);

  Vec3 mean_, shift_;
  std::size_t octaves_;
  mutable std::array<Octave, most_octaves> octave_;
};

}  // namespace hooke
