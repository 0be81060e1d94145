#include "collide/lasting_pairs.h"

#include <algorithm>
#include <cmath>

#include "collide/narrow_phase.h"

namespace hooke {
namespace {

/// More pairs than so many times the corners are of cloth that lies on cloth.
constexpr double crowd = 8.0;

/// Moments of a step, as MotionBound counts them. Where cloth lies on cloth pairs are looked for in its
/// middle: what rests falls in each step and is pushed back, and both places are half as far from there.
constexpr double middle_of_step = 0.5, end_of_step = 1.0;

/// Elsewhere they are looked for where particles are going to be so many steps after its end: as far as uses
/// up this share of the margin.
constexpr double most_ahead = 500.0, least_ahead = 0.2, share_ahead = 0.75;

/// What is so many margins away counts as far, and may move so much before pairs are found anew.
constexpr double far_margins = 16.0;

/// No less than what rounding takes from a bound on motion.
constexpr double rounding = 1.0 + 1e-6;

}  // namespace

template <class Real>
LastingPairs<Real>::Margins::Margins(double thickness, double edge)
    : narrow(0.5 * thickness),
      wide(std::max({narrow, 0.25 * edge, 0.6 * edge - NarrowPhase::active_distance(thickness)})) {}

template <class Real>
LastingPairs<Real>::LastingPairs(const Surface& surface, const Places& rest, double thickness, double edge,
                                 bool from_starts)
    : surface_(surface),
      thickness_(thickness),
      from_starts_(from_starts),
      margins_(thickness, edge),
      margin_(margins_.wide),
      close_pairs_(surface, rest, thickness),
      bound_(surface.corners),
      looked_(rest) {}

template <class Real>
bool LastingPairs<Real>::hold_in(const StepResult<Real>& result, Executor& executor) {
  if (hold_) measure_motion(result, executor);
  return hold_ && moved_ <= margin_;
}

template <class Real>
bool LastingPairs<Real>::may_touch() const {
  return nearest_ - moved_ <= NarrowPhase::active_distance(thickness_);
}

template <class Real>
bool LastingPairs<Real>::find(const StepResult<Real>& result, const Places& start, const Places& end,
                              Executor& executor) {
  nearest_ = std::numeric_limits<double>::infinity();
  pairs_ = &no_pairs_;
  hold_ = false;
  if (!are_finite(start, end)) return false;  // such a step is not taken
  margin_ = is_crowd_ ? margins_.narrow : margins_.wide;
  look(result, is_crowd_ ? middle_of_step : end_of_step, executor);
  hold_ = moved_ <= margin_;
  if (hold_ && !is_crowd_) look_ahead(result, executor);
  // What is fast is looked at along its way in this step alone.
  if (!hold_) moved_ = std::min(moved_, rounding * motion_in(result, executor));
  const double reach = NarrowPhase::active_distance(thickness_) + margin_;
  pairs_ = hold_ ? &close_pairs_.find(looked_, looked_, reach, executor)
                 : &close_pairs_.find(start, end, reach, executor);
  for (const ClosePair& pair : *pairs_) nearest_ = std::min(nearest_, pair.distance);
  is_crowd_ = double(pairs_->size()) > crowd * double(surface_.corners.size());
  return true;
}

/// How far particles have moved against each other at the ends of this step, since pairs were found.
template <class Real>
void LastingPairs<Real>::measure_motion(const StepResult<Real>& result, Executor& executor) {
  const State<Real>& start = from_starts_ ? result.start : result.next;
  moved_ = rounding * bound_.since(start, result.next, margin_ / rounding, executor);
}

/// Unless that leads too far from where they are: what is far moves more, and others are near each other
/// there.
template <class Real>
void LastingPairs<Real>::look_ahead(const StepResult<Real>& result, Executor& executor) {
  const double motion = rounding * bound_.since(result.start, result.next, margin_, executor);
  const double moment = std::min(end_of_step + most_ahead, share_ahead * margin_ / motion);
  if (!(moment > end_of_step + least_ahead)) return;
  look(result, moment, executor);
  if (!(moved_ <= margin_)) look(result, end_of_step, executor);
}

/// At where particles are at a moment of this step, or are going to be after it.
template <class Real>
void LastingPairs<Real>::look(const StepResult<Real>& result, double moment, Executor& executor) {
  bound_.look(result.start, result.next, moment);
  for (const Index i : surface_.corners) looked_[i] = bound_.looked(i);
  const double edges = 2.0 * longest_edge(), active = NarrowPhase::active_distance(thickness_);
  const double far = edges + active + margin_ + far_margins * margins_.wide;
  bound_.choose_near(far, far - edges - active);
  measure_motion(result, executor);
}

template <class Real>
bool LastingPairs<Real>::are_finite(const Places& start, const Places& end) const {
  return std::all_of(surface_.corners.begin(), surface_.corners.end(),
                     [&](Index i) { return start[i].allFinite() && end[i].allFinite(); });
}

/// Where pairs are looked for [m].
template <class Real>
double LastingPairs<Real>::longest_edge() const {
  double square = 0.0;
  for (const auto& [a, b] : surface_.edges)
    square = std::max(square, (looked_[a] - looked_[b]).squaredNorm());
  return std::sqrt(square);
}

template class LastingPairs<float>;
template class LastingPairs<double>;

}  // namespace hooke
