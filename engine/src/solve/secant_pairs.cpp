#include "solve/secant_pairs.h"

#include <algorithm>

#include "kernels/flush_subnormals.h"
#include "parallel/sum.h"
#include "strip.h"

namespace hooke {
namespace {

/// Lanes whose products are added in Real, with an accumulator for each lane of a block.
template <class Real>
double dot_of_lanes(const Real* a, const Real* b, std::size_t lanes) {
  Real sums[block_size] = {};
  for (std::size_t lane = 0; lane < lanes; lane += block_size) {
    for (std::size_t i = 0; i < block_size; ++i) sums[i] += a[lane + i] * b[lane + i];
  }
  double total = 0.0;
  for (const Real sum : sums) total += double(sum);
  return total;
}

/// change = sign (now - last), last = now.
template <class Real>
void take_change(Real sign, const Real* now, Real* last, Real* change, std::size_t lanes) {
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    change[lane] = sign * (now[lane] - last[lane]);
    last[lane] = now[lane];
  }
}

}  // namespace

template <class Real>
SecantPairs<Real>::SecantPairs(const Model<Real>& model, std::size_t most, Executor& executor)
    : pairs_(most + 1,
             Pair{ParticleVectors<Real>(model.particles()), ParticleVectors<Real>(model.particles())}),
      velocity_(model.particles()),
      residual_(model.particles()),
      model_(model),
      executor_(executor) {}

template <class Real>
void SecantPairs<Real>::clear() {
  known_ = 0;
  seen_ = false;
}

template <class Real>
template <class Part>
double SecantPairs<Real>::sum(const Part& part) {
  const auto run = [&](std::size_t begin, std::size_t end) {
    const FlushSubnormals flush;
    double total = 0.0;
    model_.for_each_awake_strip(begin, end, [&](std::size_t first, std::size_t last) {
      total += part(first * block_size, (last - first) * block_size);
    });
    return DotSum{total};
  };
  return sum_in_order<DotSum>(executor_, block_count(model_.particles()), solved_blocks, run, sums_).value;
}

template <class Real>
double SecantPairs<Real>::add_and_dot(double factor, const ParticleVectors<Real>& a,
                                      ParticleVectors<Real>& total, const ParticleVectors<Real>& b) {
  return sum([&](std::size_t first, std::size_t lanes) {
    const auto coordinate = [&](const Real* a_lanes, Real* sums, const Real* b_lanes) {
      for (std::size_t lane = 0; lane < lanes; ++lane) sums[lane] += Real(factor) * a_lanes[lane];
      return dot_of_lanes(sums, b_lanes, lanes);
    };
    return coordinate(a.x() + first, total.x() + first, b.x() + first) +
           coordinate(a.y() + first, total.y() + first, b.y() + first) +
           coordinate(a.z() + first, total.z() + first, b.z() + first);
  });
}

template <class Real>
void SecantPairs<Real>::observe(const State<Real>& at, const ParticleVectors<Real>& residual) {
  Pair& next = pairs_[next_];
  next.curvature = sum([&](std::size_t first, std::size_t lanes) {
    const auto coordinate = [&](const Real* v, Real* last_v, Real* dv, const Real* r, Real* last_r,
                                Real* dr) {
      take_change(Real(1), v + first, last_v + first, dv + first, lanes);
      take_change(Real(-1), r + first, last_r + first, dr + first, lanes);
      return dot_of_lanes(dv + first, dr + first, lanes);
    };
    return coordinate(at.vx(), velocity_.x(), next.velocity.x(), residual.x(), residual_.x(),
                      next.residual.x()) +
           coordinate(at.vy(), velocity_.y(), next.velocity.y(), residual.y(), residual_.y(),
                      next.residual.y()) +
           coordinate(at.vz(), velocity_.z(), next.velocity.z(), residual.z(), residual_.z(),
                      next.residual.z());
  });
  // Only pairs along which the potential is convex keep the product positive definite.
  if (seen_ && next.curvature > 0.0) {
    next_ = (next_ + 1) % pairs_.size();
    known_ = std::min(known_ + 1, pairs_.size() - 1);
  }
  seen_ = true;
}

template <class Real>
void SecantPairs<Real>::multiply_right(ParticleVectors<Real>& residual) {
  if (known_ == 0) return;
  double along = add_and_dot(0.0, residual, residual, pair(0).velocity);
  for (std::size_t age = 0; age < known_; ++age) {
    Pair& now = pair(age);
    now.share = along / now.curvature;
    const Pair& older = pair(std::min(age + 1, known_ - 1));
    along = add_and_dot(-now.share, now.residual, residual, older.velocity);
  }
}

template <class Real>
void SecantPairs<Real>::multiply_left(ParticleVectors<Real>& direction) {
  if (known_ == 0) return;
  double along = add_and_dot(0.0, direction, direction, pair(known_ - 1).residual);
  for (std::size_t age = known_; age-- > 0;) {
    const Pair& now = pair(age);
    const Pair& newer = pair(age == 0 ? 0 : age - 1);
    along = add_and_dot(now.share - along / now.curvature, now.velocity, direction, newer.residual);
  }
}

template <class Real>
std::size_t SecantPairs<Real>::bytes() const {
  std::size_t bytes = velocity_.bytes() + residual_.bytes();
  for (const Pair& one : pairs_) bytes += one.velocity.bytes() + one.residual.bytes();
  return bytes;
}

template class SecantPairs<float>;
template class SecantPairs<double>;

}  // namespace hooke
