#include "collide/swept_test.h"

#include <algorithm>
#include <cmath>

namespace hooke {

double approach_bound(PairKind kind, const PairPlaces& start, const PairPlaces& end) {
  PairPlaces moves;
  Vec3 mean = Vec3::Zero();
  for (std::size_t i = 0; i < 4; ++i) mean += 0.25 * (moves[i] = end[i] - start[i]);
  const std::size_t in_first = kind == PairKind::corner_triangle ? 1 : 2;
  double first = 0.0, second = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    double& furthest = i < in_first ? first : second;
    furthest = std::max(furthest, (moves[i] - mean).squaredNorm());
  }
  return std::sqrt(first) + std::sqrt(second);
}

PairPlaces places_at(const PairPlaces& start, const PairPlaces& end, double time) {
  PairPlaces x;
  for (std::size_t i = 0; i < 4; ++i) x[i] = start[i] + time * (end[i] - start[i]);
  return x;
}

double first_time_near(PairKind kind, const PairPlaces& start, const PairPlaces& end, double stop,
                       double bound) {
  constexpr int most_steps = 10'000;  // what only grazes is taken for near where these end
  double time = 0.0;
  for (int i = 0; i < most_steps; ++i) {
    const double distance = closest_points(kind, places_at(start, end, time)).distance();
    if (i > 0 && distance <= stop) return time;
    time += (distance - 0.5 * stop) / bound;
    if (!(time < 1.0)) return 1.0;
  }
  return time;
}

}  // namespace hooke
