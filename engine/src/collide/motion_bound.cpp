#include "collide/motion_bound.h"

#include <algorithm>
#include <cmath>

#include "parallel/sum.h"

namespace hooke {
namespace {

/// Particles that one thread takes at a time: some microseconds of work.
constexpr std::size_t longest_run = 16384;

/// The smallest and the largest of the differences after - before. In several lanes, as compilers do not
/// reorder comparisons of numbers that may be NaN.
template <class Real>
void widen(Real& lowest, Real& highest, const Real* before, const Real* after, std::size_t begin,
           std::size_t end) {
  constexpr std::size_t lanes = 16;
  Real low[lanes], high[lanes];
  std::fill(low, low + lanes, lowest);
  std::fill(high, high + lanes, highest);
  std::size_t i = begin;
  for (; i + lanes <= end; i += lanes) {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const Real move = after[i + lane] - before[i + lane];
      low[lane] = move < low[lane] ? move : low[lane];
      high[lane] = move > high[lane] ? move : high[lane];
    }
  }
  for (; i < end; ++i) {
    low[0] = std::min(low[0], after[i] - before[i]);
    high[0] = std::max(high[0], after[i] - before[i]);
  }
  lowest = *std::min_element(low, low + lanes);
  highest = *std::max_element(high, high + lanes);
}

}  // namespace

template <class Real>
MotionBound<Real>::MotionBound(const std::vector<Index>& particles) {
  for (const Index i : particles) {
    const bool follows = !runs_.empty() && runs_.back().end == i;
    if (follows && runs_.back().end - runs_.back().begin < longest_run)
      ++runs_.back().end;
    else
      runs_.push_back({i, std::size_t(i) + 1});
  }
}

template <class Real>
void MotionBound<Real>::look(const State<Real>& state) {
  x_.assign(state.x(), state.x() + state.size());
  y_.assign(state.y(), state.y() + state.size());
  z_.assign(state.z(), state.z() + state.size());
}

template <class Real>
double MotionBound<Real>::since(const State<Real>& state, Executor& executor) const {
  const Real* const before[] = {x_.data(), y_.data(), z_.data()};
  return diagonal(before, state, executor);
}

template <class Real>
double MotionBound<Real>::between(const State<Real>& before, const State<Real>& after,
                                  Executor& executor) const {
  const Real* const places[] = {before.x(), before.y(), before.z()};
  return diagonal(places, after, executor);
}

template <class Real>
double MotionBound<Real>::diagonal(const Real* const before[3], const State<Real>& after,
                                   Executor& executor) const {
  const Real* const now[] = {after.x(), after.y(), after.z()};
  const auto part = [&](std::size_t begin, std::size_t end) {
    Extents extents;
    for (std::size_t run = begin; run < end; ++run) {
      for (std::size_t k = 0; k < 3; ++k)
        widen(extents.axis[k].low, extents.axis[k].high, before[k], now[k], runs_[run].begin, runs_[run].end);
    }
    return extents;
  };
  const Extents all = sum_in_order<Extents>(executor, runs_.size(), 1, part, extents_);
  double square = 0.0;
  for (const Extent& extent : all.axis) square += std::pow(double(extent.high) - double(extent.low), 2);
  return std::sqrt(square);
}

template class MotionBound<float>;
template class MotionBound<double>;

}  // namespace hooke
