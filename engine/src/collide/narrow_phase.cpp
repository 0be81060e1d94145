#include "collide/narrow_phase.h"

#include <algorithm>
#include <tuple>

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

/// Whether the nearest points of two edges lie within both, so far from their ends [m]. Where one is an end,
/// the pair of that corner and a triangle at the other edge says the same.
bool is_within_both(const std::array<double, 4>& weights, const PairPlaces& x, double from_ends) {
  const auto is_within = [&](std::size_t a, std::size_t b) {
    const double share = std::min(std::abs(weights[a]), std::abs(weights[b]));
    return share > 0.0 && share * (x[a] - x[b]).norm() >= from_ends;
  };
  return is_within(0, 1) && is_within(2, 3);
}

/// Whether a corner is nearest to corners that edges join it to: these do not lie on one another.
bool is_neighbours_only(const ClosePair& pair, const SurfaceContact& contact) {
  for (std::size_t k = 1; k < 4; ++k) {
    if (contact.weights[k] != 0.0 && (pair.joined >> k & 1u) == 0) return false;
  }
  return true;
}

/// Whether a corner touches one that finds the same, from its own side.
bool is_found_from_other(const SurfaceContact& contact) {
  for (std::size_t k = 1; k < 4; ++k) {
    if (contact.weights[k] == -1.0) return contact.particles[k] < contact.particles[0];
  }
  return false;
}

bool is_same_corner(const ClosePair& a, const ClosePair& b) {
  return a.kind == b.kind && a.particles[0] == b.particles[0];
}

/// Whether the triangle of a corner's contact has all the corners that another contact of it touches.
bool has_touched(const SurfaceContact& contact, const SurfaceContact& other) {
  for (std::size_t k = 1; k < 4; ++k) {
    if (other.weights[k] == 0.0) continue;
    if (std::find(contact.particles.begin() + 1, contact.particles.end(), other.particles[k]) ==
        contact.particles.end())
      return false;
  }
  return true;
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
      run.contacts.clear(), run.of_corner.clear(), run.crossing.clear();
      run.passed = false;
      const std::size_t last = begin_of_particle(pairs, (r + 1) * pairs_in_run);
      const std::size_t first = std::min(begin_of_particle(pairs, r * pairs_in_run), last);
      look(std::span(pairs).subspan(first, last - first), run);
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
  const auto look_at_run = [&](std::span<const ClosePair> of_run, Run& run) {
    for (const ClosePair& pair : of_run) look(pair, step, run);
    leave_nearest(step, run);
  };
  const std::span<const Run> runs = look_at(pairs, look_at_run, executor);
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
  const Touch touch{&pair, time, distance, distance_at_end};
  if (is_left_to_others(contact, touch, step)) {
    run.passed = run.passed || passes(touch, step);
    return;
  }
  contact.held = contact.sum(step.start);
  // What would pass goes back to where it came near, and not all the way to its thickness either.
  contact.least = least_distance(pair, time < 1.0 ? distance : contact.normal.dot(contact.held), step.h);
  if (!run.of_corner.empty() && !is_same_corner(*run.of_corner.back().pair, pair)) leave_nearest(step, run);
  run.contacts.push_back(contact);
  if (pair.kind == PairKind::corner_triangle)
    run.of_corner.push_back(touch);
  else
    run.passed = run.passed || time < 1.0;
}

/// Whether another pair has this contact, too, or nearest corners are joined.
bool NarrowPhase::is_left_to_others(const SurfaceContact& contact, const Touch& touch,
                                    const Step& step) const {
  const ClosePair& pair = *touch.pair;
  if (pair.kind == PairKind::corner_triangle)
    return is_neighbours_only(pair, contact) ||
           (touch.time == 1.0 && pair.thickness == thickness_ && is_found_from_other(contact));
  // So far off the corner's pair keeps them apart as well.
  const double from_ends = touch.time == 1.0 ? skin * pair.thickness : 0.0;
  return !is_within_both(contact.weights, places_of(pair, step.end), from_ends);
}

/// Of what a corner has found last: where it touches a corner or a side of several triangles, these are one
/// surface, and it lies over the one that it meets first, or is nearest to. What others would push it by is
/// not across the surface.
void NarrowPhase::leave_nearest(const Step& step, Run& run) {
  const std::size_t first = run.contacts.size() - run.of_corner.size();
  const auto comes_before = [&](std::size_t a, std::size_t b) {
    const Touch &of_a = run.of_corner[a], &of_b = run.of_corner[b];
    return std::tie(of_a.time, of_a.distance, a) < std::tie(of_b.time, of_b.distance, b);
  };
  for (std::size_t c = 0; c < run.of_corner.size(); ++c) {
    for (std::size_t other = 0; other < run.of_corner.size() && !run.of_corner[c].is_left; ++other)
      run.of_corner[c].is_left =
          comes_before(other, c) && has_touched(run.contacts[first + other], run.contacts[first + c]);
  }
  std::size_t kept = first;
  for (std::size_t c = 0; c < run.of_corner.size(); ++c) {
    const Touch& touch = run.of_corner[c];
    run.passed = run.passed || (touch.is_left ? passes(touch, step) : touch.time < 1.0);
    if (!touch.is_left) run.contacts[kept++] = run.contacts[first + c];
  }
  run.contacts.erase(run.contacts.begin() + std::ptrdiff_t(kept), run.contacts.end());
  run.of_corner.clear();
}

/// Such a pair may still cross later in the step, where its nearest points are others.
bool NarrowPhase::passes(const Touch& touch, const Step& step) {
  return touch.time < 1.0 && is_crossing(*touch.pair, step, touch.distance_at_end);
}

bool NarrowPhase::is_crossing(const ClosePair& pair, const Step& step, double distance_at_end) {
  if (distance_at_end > step.motion) return false;
  return time_of_touch(pair, places_of(pair, step.start), places_of(pair, step.end), distance_at_end, 0.1) <
         1.0;
}

const std::vector<ClosePair>& NarrowPhase::crossing(const std::vector<ClosePair>& pairs, const Step& step,
                                                    Executor& executor) {
  crossing_.clear();
  const auto look_at_run = [&](std::span<const ClosePair> of_run, Run& run) {
    for (const ClosePair& pair : of_run) {
      if (is_far(pair, step)) continue;
      const double distance = closest_points(pair.kind, places_of(pair, step.end)).distance();
      if (is_crossing(pair, step, distance)) run.crossing.push_back(pair);
    }
  };
  for (const Run& run : look_at(pairs, look_at_run, executor))
    crossing_.insert(crossing_.end(), run.crossing.begin(), run.crossing.end());
  return crossing_;
}

std::size_t NarrowPhase::bytes() const {
  std::size_t contacts = contacts_.capacity(), pairs = crossing_.capacity(), touches = 0;
  for (const Run& run : runs_) {
    contacts += run.contacts.capacity();
    pairs += run.crossing.capacity();
    touches += run.of_corner.capacity();
  }
  return contacts * sizeof(SurfaceContact) + pairs * sizeof(ClosePair) + touches * sizeof(Touch) +
         begin_.capacity() * sizeof(std::size_t);
}

}  // namespace hooke
