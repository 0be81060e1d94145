#include "collide/narrow_phase.h"

#include <algorithm>

#include "collide/swept_test.h"

namespace hooke {
namespace {

/// Pairs that one thread looks at, at a time.
constexpr std::size_t pairs_in_run = 1024;

/// What is too near at the start gets this share of the way to its thickness in a step, and no nearer: all of
/// it at once would strain stiff springs, step after step.
constexpr double recovery = 0.2;

/// What is further apart than its thickness by less than this share of it lies on one another: where only the
/// last bit of its way were contact, friction could not hold it.
constexpr double skin = 0.01;

/// That gets back to its thickness, too, within some such times [s]. Held where it is, it would rise by what
/// sweeps leave, step after step, until it falls; and where it might fall freely friction would not hold it.
constexpr double sinking_time = 0.025;

/// When a pair first comes as near as a share of its thickness, or of its distance at the start where that is
/// less; 1 where it does not, or crosses at the start already.
double time_of_touch(const ClosePair& pair, const PairPlaces& start, const PairPlaces& end,
                     double end_distance, double share) {
  const double bound = approach_bound(pair.kind, start, end);
  if (end_distance > bound) return 1.0;
  const double stop = share * std::min(pair.thickness, closest_points(pair.kind, start).distance());
  return stop > 0.0 ? first_time_near(pair.kind, start, end, stop, bound) : 1.0;
}

/// Whether the nearest points of two edges lie within both. Where one is an end, the pair of that corner and
/// a triangle at the other edge says the same.
bool is_within_both(const SurfaceContact& contact) {
  for (const double weight : contact.weights) {
    if (weight == 0.0) return false;
  }
  return true;
}

bool is_within_triangle(const SurfaceContact& contact) {
  return contact.weights[1] != 0.0 && contact.weights[2] != 0.0 && contact.weights[3] != 0.0;
}

/// Whether a corner is nearest to corners that edges join it to: these do not lie on one another.
bool is_neighbours_only(const ClosePair& pair, const SurfaceContact& contact) {
  for (std::size_t k = 1; k < 4; ++k) {
    if (contact.weights[k] != 0.0 && (pair.joined >> k & 1u) == 0) return false;
  }
  return true;
}

/// Whether two contacts of a corner are with the same points of different triangles.
bool are_same(const SurfaceContact& a, const SurfaceContact& b) {
  std::size_t common = 0, of_a = 0, of_b = 0;
  for (std::size_t k = 1; k < 4; ++k) {
    of_a += a.weights[k] != 0.0 ? 1 : 0;
    of_b += b.weights[k] != 0.0 ? 1 : 0;
    for (std::size_t j = 1; j < 4; ++j)
      common += a.weights[k] != 0.0 && b.weights[j] != 0.0 && a.particles[k] == b.particles[j] ? 1 : 0;
  }
  return of_a == of_b && common == of_a;
}

/// Whether the contacts found last have this one of a corner already; or the other corner's, of two corners.
bool is_known(const SurfaceContact& contact, const std::vector<SurfaceContact>& found) {
  if (is_within_triangle(contact)) return false;
  for (std::size_t i = found.size(); i > 0 && found[i - 1].particles[0] == contact.particles[0]; --i) {
    if (are_same(found[i - 1], contact)) return true;
  }
  return false;
}

/// The first pair from this one on that begins another first particle than the one before: what is found of a
/// corner may not depend on where runs begin.
std::size_t begin_of_particle(const std::vector<ClosePair>& pairs, std::size_t pair) {
  while (pair > 0 && pair < pairs.size() && pairs[pair].particles[0] == pairs[pair - 1].particles[0]) ++pair;
  return std::min(pair, pairs.size());
}

}  // namespace

template <class Look>
std::span<const NarrowPhase::Run> NarrowPhase::look_at(const std::vector<ClosePair>& pairs, const Look& look,
                                                       Executor& executor) {
  const std::size_t count = (pairs.size() + pairs_in_run - 1) / pairs_in_run;
  if (runs_.size() < count) runs_.resize(count);
  executor.parallel_for(count, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r) {
      Run& run = runs_[r];
      run.contacts.clear(), run.crossing.clear(), run.passed = false;
      const std::size_t last = begin_of_particle(pairs, (r + 1) * pairs_in_run);
      for (std::size_t i = begin_of_particle(pairs, r * pairs_in_run); i < last; ++i) look(pairs[i], run);
    }
  });
  return {runs_.data(), count};
}

double NarrowPhase::least_distance(const ClosePair& pair, double before, double h) const {
  if (before <= 0.0) return pair.thickness;
  if (before < pair.thickness) return before + recovery * (pair.thickness - before);
  const bool lies_on_it = pair.thickness == thickness_ && before < (1.0 + skin) * pair.thickness;
  if (!lies_on_it) return pair.thickness;
  return before - std::min(recovery, h / sinking_time) * (before - pair.thickness);
}

std::vector<SurfaceContact>& NarrowPhase::contacts_of(const std::vector<ClosePair>& pairs, const Step& step,
                                                      Executor& executor) {
  passed_ = false;
  const auto look_at_one = [&](const ClosePair& pair, Run& run) { look(pair, step, run); };
  const std::span<const Run> runs = look_at(pairs, look_at_one, executor);
  begin_.assign(1, 0);
  for (const Run& run : runs) {
    begin_.push_back(begin_.back() + run.contacts.size());
    passed_ = passed_ || run.passed;
  }
  contacts_.resize(begin_.back());
  executor.parallel_for(runs.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r)
      std::copy(runs[r].contacts.begin(), runs[r].contacts.end(),
                contacts_.begin() + std::ptrdiff_t(begin_[r]));
  });
  return contacts_;
}

void NarrowPhase::look(const ClosePair& pair, const Step& step, Run& run) const {
  if (is_far(pair, step)) return;
  const PairPlaces end = places_of(pair, step.end);
  ClosestPoints points = closest_points(pair.kind, end);
  const double distance_at_end = points.distance();
  double distance = distance_at_end, time = 1.0;
  if (swept_ && distance <= step.motion) {
    const PairPlaces start = places_of(pair, step.start);
    time = time_of_touch(pair, start, end, distance, 0.5);
    if (time < 1.0) {
      points = closest_points(pair.kind, places_at(start, end, time));
      distance = points.distance();
    }
  }
  if (!(distance < reach_of(pair)) || distance == 0.0) return;
  SurfaceContact contact{pair.particles, points.weights, points.between / distance,
                         pair.thickness, Vec3::Zero(),   friction_};
  if (!can_be_moved(contact, step.inverse_mass)) return;
  if (is_left_to_others(pair, contact, run)) {
    run.passed = run.passed || (time < 1.0 && is_crossing(pair, step, distance_at_end));
    return;
  }
  contact.held = contact.sum(step.start);
  // What would pass goes back to where it came near, and not all the way to its thickness either.
  contact.least = least_distance(pair, time < 1.0 ? distance : contact.normal.dot(contact.held), step.h);
  run.contacts.push_back(contact);
  run.passed = run.passed || time < 1.0;
}

/// Whether another pair has this contact, too, or nearest corners are joined. Where such a pair comes near,
/// it may still cross later in the step, where its nearest points are others.
bool NarrowPhase::is_left_to_others(const ClosePair& pair, const SurfaceContact& contact, const Run& run) {
  if (pair.kind == PairKind::edge_edge) return !is_within_both(contact);
  return is_neighbours_only(pair, contact) || is_known(contact, run.contacts);
}

bool NarrowPhase::is_crossing(const ClosePair& pair, const Step& step, double distance_at_end) {
  if (distance_at_end > step.motion) return false;
  return time_of_touch(pair, places_of(pair, step.start), places_of(pair, step.end), distance_at_end, 0.1) <
         1.0;
}

const std::vector<ClosePair>& NarrowPhase::crossing(const std::vector<ClosePair>& pairs, const Step& step,
                                                    Executor& executor) {
  crossing_.clear();
  const auto look_at_one = [&](const ClosePair& pair, Run& run) {
    if (is_far(pair, step)) return;
    const double distance = closest_points(pair.kind, places_of(pair, step.end)).distance();
    if (is_crossing(pair, step, distance)) run.crossing.push_back(pair);
  };
  for (const Run& run : look_at(pairs, look_at_one, executor))
    crossing_.insert(crossing_.end(), run.crossing.begin(), run.crossing.end());
  return crossing_;
}

std::size_t NarrowPhase::bytes() const {
  std::size_t contacts = contacts_.capacity(), pairs = crossing_.capacity();
  for (const Run& run : runs_) {
    contacts += run.contacts.capacity();
    pairs += run.crossing.capacity();
  }
  return contacts * sizeof(SurfaceContact) + pairs * sizeof(ClosePair) +
         begin_.capacity() * sizeof(std::size_t);
}

}  // namespace hooke
