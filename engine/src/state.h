#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include <hooke/pair_memory.h>

#include "aligned.h"

namespace hooke {

/// Particles are worked on in blocks of 16: one cache line of floats in each array.
inline constexpr std::size_t block_size = 16;

inline std::size_t block_count(std::size_t particles) {
  return (particles + block_size - 1) / block_size;
}

/// Values of one particle in a packed array: x, y, z and one unused, so that a particle is one vector load.
inline constexpr std::size_t packed_width = 4;

/// Which packed copies a state keeps beside its arrays, for neighbours that are read one by one.
enum class Packed { none = 0, positions = 1, positions_and_velocities = 2 };

/// Positions [m], velocities [m/s] and time [s]: all that changes from step to step. Structure of arrays in
/// the engine's order, padded with zeros to whole blocks.
///
/// Before and behind each array lies one more block of zeros, so that a vector load of the neighbours i + d
/// of a whole block stays inside although some of its lanes have no such neighbour.
///
/// Who writes positions or velocities through the arrays writes the packed copies too; set_position and
/// set_velocity do.
template <class Real>
class State {
 public:
  explicit State(std::size_t particles, Packed packed = Packed::none)
      : particles_(particles),
        stride_(array_stride(particles)),
        values_(6 * stride_, Real(0)),
        packed_positions_(packed == Packed::none ? 0 : packed_size(particles), Real(0)),
        packed_velocities_(packed == Packed::positions_and_velocities ? packed_size(particles) : 0, Real(0)) {
  }

  std::size_t size() const { return particles_; }

  Real* x() { return array(0); }
  Real* y() { return array(1); }
  Real* z() { return array(2); }
  Real* vx() { return array(3); }
  Real* vy() { return array(4); }
  Real* vz() { return array(5); }
  const Real* x() const { return array(0); }
  const Real* y() const { return array(1); }
  const Real* z() const { return array(2); }
  const Real* vx() const { return array(3); }
  const Real* vy() const { return array(4); }
  const Real* vz() const { return array(5); }

  /// packed_width values for each particle, the padding included; null where there is no such copy.
  Real* packed_positions() { return packed_positions_.empty() ? nullptr : packed_positions_.data(); }
  Real* packed_velocities() { return packed_velocities_.empty() ? nullptr : packed_velocities_.data(); }
  const Real* packed_positions() const { return const_cast<State*>(this)->packed_positions(); }
  const Real* packed_velocities() const { return const_cast<State*>(this)->packed_velocities(); }

  Eigen::Matrix<Real, 3, 1> position(std::size_t i) const { return {x()[i], y()[i], z()[i]}; }
  Eigen::Matrix<Real, 3, 1> velocity(std::size_t i) const { return {vx()[i], vy()[i], vz()[i]}; }
  void set_position(std::size_t i, const Eigen::Matrix<Real, 3, 1>& value) {
    x()[i] = value.x();
    y()[i] = value.y();
    z()[i] = value.z();
    pack(packed_positions_, i, value);
  }
  void set_velocity(std::size_t i, const Eigen::Matrix<Real, 3, 1>& value) {
    vx()[i] = value.x();
    vy()[i] = value.y();
    vz()[i] = value.z();
    pack(packed_velocities_, i, value);
  }

  /// What the values of some particles take, without guards and padding.
  static std::size_t bytes_of(std::size_t particles, Packed packed) {
    const std::size_t copies = std::size_t(packed);
    return particles * (6 + copies * packed_width) * sizeof(Real);
  }

  std::size_t bytes() const {
    return (values_.capacity() + packed_positions_.capacity() + packed_velocities_.capacity() +
            memory.capacity()) *
           sizeof(Real);
  }

  double time = 0.0;

  /// The velocities lack this time [s] of the accelerations here: a splitting method does the last kick of a
  /// step together with the first of the next one. 0 where they are whole.
  double pending_kick = 0.0;

  /// What effects remember of the past, such as how far springs have yielded: mostly nothing.
  std::vector<Real> memory;

  /// Likewise of pairs of particles that come and go, in the user's numbering; a list for each effect that
  /// does, sorted.
  std::vector<std::vector<PairMemory<Real>>> pairs;

  /// From one array's base to the next one's. The bases of a state's arrays differ by five cache lines modulo
  /// 4 KiB: with equal low address bits, loads from one array would falsely wait for stores to another.
  static std::size_t array_stride(std::size_t particles) {
    constexpr std::size_t page = 4096 / sizeof(Real), offset = 5 * cache_line / sizeof(Real);
    const std::size_t needed = (block_count(particles) + 2) * block_size;
    if (needed < page) return needed;  // everything fits in the first-level cache; do not waste memory
    return (needed + page - 1 - offset) / page * page + offset;
  }

 private:
  Real* array(std::size_t which) { return values_.data() + which * stride_ + block_size; }
  const Real* array(std::size_t which) const { return values_.data() + which * stride_ + block_size; }

  static std::size_t packed_size(std::size_t particles) {
    return block_count(particles) * block_size * packed_width;
  }

  static void pack(AlignedVector<Real>& packed, std::size_t i, const Eigen::Matrix<Real, 3, 1>& value) {
    if (packed.empty()) return;
    std::copy(value.begin(), value.end(), packed.begin() + std::ptrdiff_t(i * packed_width));
  }

  std::size_t particles_, stride_;
  AlignedVector<Real> values_, packed_positions_, packed_velocities_;
};

}  // namespace hooke
