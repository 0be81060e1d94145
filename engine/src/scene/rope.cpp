#include <utility>

#include <hooke/builders.h>

#include "scene/element_checks.h"
#include "scene/lattice.h"

namespace hooke {
namespace {

void require_good(const Rope& rope) {
  std::vector<Fault> faults;
  const ElementChecks checks(faults, Rope::name);
  checks.at_least("particles", rope.particles, 2);
  checks.finite("start", rope.start, "m");
  checks.finite("end", rope.end, "m");
  if (rope.start == rope.end) checks.add("start and end are the same point", "give two points");
  checks.positive("linear_density", rope.linear_density, "kg/m");
  checks.not_negative("stretch", rope.stretch, "N/m");
  checks.not_negative("bend", rope.bend, "N/m");
  checks.not_negative("damping", rope.damping, "N s/m");
  throw_if_any(std::move(faults));
}

Lattice lattice_of(const Rope& rope) {
  const Vec3 step = (rope.end - rope.start) / (rope.particles - 1.0);
  const double length = step.stableNorm();
  return {.size = {rope.particles, 1, 1},
          .origin = rope.start,
          .step = {step, Vec3::Zero(), Vec3::Zero()},
          .cell_mass = rope.linear_density * length,
          .springs = {{{1, 0, 0}, rope.stretch, length}, {{2, 0, 0}, rope.bend, 2.0 * length}},
          .damping = rope.damping};
}

}  // namespace

RopeParticles add(Scene& scene, const Rope& rope) {
  require_good(rope);
  const Lattice lattice = lattice_of(rope);
  make_room(scene, Rope::name, lattice, 0.0);
  return {add_lattice(scene, lattice), rope.particles};
}

}  // namespace hooke
