#include "collide/motion_bound.h"

#include <array>
#include <cmath>

#include "collide/widen.h"
#include "parallel/sum.h"

namespace hooke {
namespace {

/// Particles that one thread takes at a time: some microseconds of work.
constexpr std::size_t longest_run = 16384;

/// Cells along an axis, at most: their numbers fit in 64 bits together.
constexpr double most_cells = double(1 << 20);

std::uint64_t key_of(const std::array<std::int64_t, 3>& cell) {
  return std::uint64_t(cell[0]) << 42 | std::uint64_t(cell[1]) << 21 | std::uint64_t(cell[2]);
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
  cell_.resize(particles.size());
}

template <class Real>
double MotionBound<Real>::Extents::diagonal() const {
  double square = 0.0;
  for (std::size_t k = 0; k < 3; ++k) square += std::pow(double(high[k]) - double(low[k]), 2);
  return std::sqrt(square);
}

template <class Real>
void MotionBound<Real>::Places::remember(const State<Real>& state) {
  of[0].assign(state.x(), state.x() + state.size());
  of[1].assign(state.y(), state.y() + state.size());
  of[2].assign(state.z(), state.z() + state.size());
}

template <class Real>
void MotionBound<Real>::Places::move_on(const State<Real>& start, const State<Real>& next, Real share) {
  const Real* const from[] = {start.x(), start.y(), start.z()};
  const Real* const to[] = {next.x(), next.y(), next.z()};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < next.size(); ++i) of[k][i] += share * (to[k][i] - from[k][i]);
  }
}

template <class Real>
void MotionBound<Real>::look(const State<Real>& start, const State<Real>& next, double moment) {
  looked_.remember(next);
  if (moment != 1.0) looked_.move_on(start, next, Real(moment - 1.0));
  measured_ = looked_;
  near_moved_ = all_moved_ = 0.0;
}

template <class Real>
void MotionBound<Real>::choose_near(double far, double far_motion) {
  far_motion_ = far_motion;
  sort_into_cells(far);
}

template <class Real>
void MotionBound<Real>::sort_into_cells(double size) {
  Extents all;
  for (const Run& run : runs_) {
    for (std::size_t k = 0; k < 3; ++k)
      widen(all.low[k], all.high[k], nullptr, looked_.of[k].data(), run.begin, run.end);
  }
  for (std::size_t k = 0; k < 3; ++k) size = std::max(size, (double(all.high[k]) - all.low[k]) / most_cells);
  std::vector<std::uint64_t> keys;
  keys.reserve(cell_.size());
  for (const Run& run : runs_) {
    for (std::size_t i = run.begin; i < run.end; ++i) {
      std::array<std::int64_t, 3> cell;  // from 1: neighbours' numbers are not negative
      for (std::size_t k = 0; k < 3; ++k)
        cell[k] = 1 + std::int64_t((double(looked_.of[k][i]) - double(all.low[k])) / size);
      keys.push_back(key_of(cell));
    }
  }
  std::vector<std::uint64_t> cells = keys;
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  for (std::size_t i = 0; i < keys.size(); ++i)
    cell_[i] = Index(std::lower_bound(cells.begin(), cells.end(), keys[i]) - cells.begin());
  find_neighbours(cells);
}

template <class Real>
void MotionBound<Real>::find_neighbours(const std::vector<std::uint64_t>& keys) {
  cells_ = keys.size();
  neighbours_.clear();
  const std::uint64_t x = std::uint64_t(1) << 42, y = std::uint64_t(1) << 21;
  for (std::size_t c = 0; c < keys.size(); ++c) {
    for (int n = 0; n < 27; ++n) {
      const auto step = [](int which) { return std::uint64_t(std::int64_t(which) - 1); };
      const std::uint64_t key = keys[c] + step(n / 9) * x + step(n / 3 % 3) * y + step(n % 3);
      if (key < keys[c]) continue;
      const auto found = std::lower_bound(keys.begin(), keys.end(), key);
      if (found != keys.end() && *found == key)
        neighbours_.emplace_back(Index(c), Index(found - keys.begin()));
    }
  }
}

template <class Real>
double MotionBound<Real>::since(const State<Real>& start, const State<Real>& next, double enough,
                                Executor& executor) {
  const Arrays before = {measured_.of[0].data(), measured_.of[1].data(), measured_.of[2].data()};
  double moved = extents_of(before, next, executor).diagonal();
  if (&start != &next) moved = std::max(moved, extents_of(before, start, executor).diagonal());
  if (!(near_moved_ + moved <= enough && all_moved_ + moved <= far_motion_)) {
    measure(start, next);
    moved = 0.0;
  }
  return all_moved_ + moved <= far_motion_ ? near_moved_ + moved : std::numeric_limits<double>::infinity();
}

template <class Real>
void MotionBound<Real>::measure(const State<Real>& start, const State<Real>& next) {
  cell_extents_.assign(cells_, {});
  const Arrays ends[] = {{start.x(), start.y(), start.z()}, {next.x(), next.y(), next.z()}};
  std::size_t c = 0;
  for (const Run& run : runs_) {
    for (std::size_t i = run.begin; i < run.end; ++i, ++c) {
      Extents& extents = cell_extents_[cell_[c]];
      for (std::size_t k = 0; k < 3; ++k) {
        extents.add(k, ends[0][k][i] - looked_.of[k][i]);
        extents.add(k, ends[1][k][i] - looked_.of[k][i]);
      }
    }
  }
  near_moved_ = 0.0;
  Extents all;
  for (const auto& [a, b] : neighbours_) {
    Extents both = cell_extents_[a];
    both.add(cell_extents_[b]);
    near_moved_ = std::max(near_moved_, both.diagonal());
    all.add(both);
  }
  all_moved_ = all.diagonal();
  measured_.remember(next);
}

template <class Real>
double MotionBound<Real>::between(const State<Real>& before, const State<Real>& after,
                                  Executor& executor) const {
  return extents_of({before.x(), before.y(), before.z()}, after, executor).diagonal();
}

template <class Real>
typename MotionBound<Real>::Extents MotionBound<Real>::extents_of(const Arrays& before,
                                                                  const State<Real>& after,
                                                                  Executor& executor) const {
  const Arrays now = {after.x(), after.y(), after.z()};
  const auto part = [&](std::size_t begin, std::size_t end) {
    Extents extents;
    for (std::size_t run = begin; run < end; ++run) {
      for (std::size_t k = 0; k < 3; ++k)
        widen(extents.low[k], extents.high[k], before[k], now[k], runs_[run].begin, runs_[run].end);
    }
    return extents;
  };
  return sum_in_order<Extents>(executor, runs_.size(), 1, part, extents_);
}

template <class Real>
std::size_t MotionBound<Real>::bytes() const {
  std::size_t places = 0;
  for (std::size_t k = 0; k < 3; ++k) places += looked_.of[k].capacity() + measured_.of[k].capacity();
  return places * sizeof(Real) + runs_.capacity() * sizeof(Run) + cell_.capacity() * sizeof(Index) +
         neighbours_.capacity() * sizeof(neighbours_[0]) +
         (cell_extents_.capacity() + extents_.capacity()) * sizeof(Extents);
}

template class MotionBound<float>;
template class MotionBound<double>;

}  // namespace hooke
