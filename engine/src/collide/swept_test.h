#pragma once

#include "collide/closest_points.h"

namespace hooke {

/// The most that the two pieces of a pair can get nearer to each other on straight ways from `start` to
/// `end` [m], at any time of it: of each piece the furthest that a particle of it goes, as seen from their
/// mean motion.
double approach_bound(PairKind kind, const PairPlaces& start, const PairPlaces& end);

/// How far along the straight ways, from 0 to 1, a pair first gets as near as `stop` [m], or a little nearer;
/// 1 where it never does. It begins further apart. `bound` is its approach_bound(). By steps as long as the
/// distance allows, so nothing is passed over (additive conservative advancement: Li et al. 2020,
/// "Incremental potential contact", supplement; here without its relative tolerance).
double first_time_near(PairKind kind, const PairPlaces& start, const PairPlaces& end, double stop,
                       double bound);

/// Places on the straight ways.
PairPlaces places_at(const PairPlaces& start, const PairPlaces& end, double time);

}  // namespace hooke
