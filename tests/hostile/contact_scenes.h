#pragma once

#include <cstdint>

#include <hooke/hooke.h>

namespace hooke::test {

/// A scene made of chance, and how it is run.
struct ContactRun {
  Scene scene;
  Settings settings;
  /// By backward Euler, damped, in steps that follow the springs, with one collider, that stays: see the
  /// limits in docs/contact.md.
  bool loses_energy = false;
};

/// Cloths, ropes and blocks among colliders of every kind, huge or tiny, overlapping at the start, moving
/// fast. The same for the same seed.
ContactRun contact_run(std::uint32_t seed);

/// Likewise, with some of self-collision, untangling, grains, tearing, attachments and stitches among the
/// same bodies.
ContactRun joined_contact_run(std::uint32_t seed);

}  // namespace hooke::test
