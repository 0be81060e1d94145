#pragma once

#include <string_view>

#include <hooke/scene.h>

namespace hooke {

/// How many elements a builder is about to add. As doubles, because the counts of bad parameters fit into no
/// integer; exact for all that a scene can hold.
struct Counts {
  double particles = 0.0;
  double springs = 0.0;
  double triangles = 0.0;
};

/// Adds a fault for each kind of element of which the scene would then have more than Index can count.
void check_room(std::vector<Fault>& faults, std::string_view builder, const Scene& scene,
                const Counts& extra);

/// Reserves what is then added through Scene's functions, so that adding cannot fail halfway. No more than
/// needed for the first large part of a scene, and growing by a factor for the many small parts that follow.
void reserve_room(Scene& scene, const Counts& extra, bool damped);

}  // namespace hooke
