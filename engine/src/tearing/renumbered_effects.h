#pragma once

#include <cstddef>
#include <span>

#include <hooke/scene.h>

namespace hooke {

/// What has become of a scene's numbers.
struct Renumbering {
  std::size_t springs_before;
  std::span<const Index> spring_from;  ///< of each spring, its number before, or of that it is a part of
  std::span<const Index> split_from;   ///< of each new particle, the one that it was split from
};

/// Carries the lists of a scene's effects over to the new numbers of its springs and particles, which the
/// scene has already. Forces by a script and tethers are for both parts of a particle; pins, attachments,
/// motion scripts, stitches and spheres stay with the part that keeps the number. An effect of which nothing
/// is left has no members any more, but keeps its place.
void renumber_effects(const Renumbering& renumbering, Scene& scene);

}  // namespace hooke
