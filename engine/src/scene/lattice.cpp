#include "scene/lattice.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "scene/element_checks.h"
#include "scene/room.h"

namespace hooke {
namespace {

/// A particle's share of a cell along one axis; an axis of one particle has no extent to share.
double share(Index i, Index size) {
  const bool at_end = i == 0 || i + 1 == size;
  return at_end && size > 1 ? 0.5 : 1.0;
}

double mass_of(const Lattice& lattice, Index i, Index j, Index k) {
  const auto& size = lattice.size;
  return lattice.cell_mass * share(i, size[0]) * share(j, size[1]) * share(k, size[2]);
}

Vec3 position_of(const Lattice& lattice, Index i, Index j, Index k) {
  return lattice.origin + i * lattice.step[0] + j * lattice.step[1] + k * lattice.step[2];
}

/// How many particles have another one at `offset`.
double pairs(const Lattice& lattice, const std::array<int, 3>& offset) {
  double count = 1.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    count *= std::max(0.0, static_cast<double>(lattice.size[axis]) - std::abs(offset[axis]));
  }
  return count;
}

Counts counts_of(const Lattice& lattice, double triangles) {
  Counts counts{.particles = pairs(lattice, {0, 0, 0}), .triangles = triangles};
  for (const LatticeSpring& spring : lattice.springs) {
    if (spring.stiffness > 0.0) counts.springs += pairs(lattice, spring.offset);
  }
  return counts;
}

void add_particles(Scene& scene, const Lattice& lattice) {
  for (Index k = 0; k < lattice.size[2]; ++k) {
    for (Index j = 0; j < lattice.size[1]; ++j) {
      for (Index i = 0; i < lattice.size[0]; ++i) {
        scene.add_particle(mass_of(lattice, i, j, k), position_of(lattice, i, j, k));
      }
    }
  }
}

/// How many of the cells around a spring there are.
double spring_share(const Lattice& lattice, const std::array<int, 3>& offset,
                    const std::array<Index, 3>& place) {
  double part = 1.0;
  for (std::size_t axis = 0; axis < 3 && lattice.springs_of_cells; ++axis) {
    if (offset[axis] == 0) part *= share(place[axis], lattice.size[axis]);
  }
  return part;
}

void add_springs_of(Scene& scene, const Lattice& lattice, Index first, const std::array<Index, 3>& place) {
  const Index from = first + lattice.number(place[0], place[1], place[2]);
  for (const auto& [offset, stiffness, rest_length] : lattice.springs) {
    if (stiffness == 0.0) continue;
    std::array<std::int64_t, 3> to;
    bool inside = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      to[axis] = std::int64_t{place[axis]} + offset[axis];
      inside = inside && to[axis] >= 0 && to[axis] < std::int64_t{lattice.size[axis]};
    }
    if (!inside) continue;
    const Index second =
        lattice.number(static_cast<Index>(to[0]), static_cast<Index>(to[1]), static_cast<Index>(to[2]));
    const double own = stiffness * spring_share(lattice, offset, place);
    scene.add_spring(from, first + second, own, rest_length,
                     lattice.damping + lattice.damping_over_stiffness * own);
  }
}

}  // namespace

void make_room(Scene& scene, std::string_view builder, const Lattice& lattice, double triangles) {
  const Counts counts = counts_of(lattice, triangles);
  const auto& size = lattice.size;
  std::vector<Fault> faults;
  check_room(faults, builder, scene, counts);
  // Good parameters can still multiply to a mass or a place that a double cannot hold.
  const ElementChecks checks(faults, builder);
  checks.positive("mass of the first particle", mass_of(lattice, 0, 0, 0), "kg");
  checks.finite("position of the last particle", position_of(lattice, size[0] - 1, size[1] - 1, size[2] - 1),
                "m");
  throw_if_any(std::move(faults));
  reserve_room(scene, counts, lattice.damping > 0.0 || lattice.damping_over_stiffness > 0.0);
}

Index add_lattice(Scene& scene, const Lattice& lattice) {
  const auto first = static_cast<Index>(scene.particles.size());
  add_particles(scene, lattice);
  for (Index k = 0; k < lattice.size[2]; ++k) {
    for (Index j = 0; j < lattice.size[1]; ++j) {
      for (Index i = 0; i < lattice.size[0]; ++i) add_springs_of(scene, lattice, first, {i, j, k});
    }
  }
  return first;
}

}  // namespace hooke
