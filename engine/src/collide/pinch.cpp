#include "collide/pinch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hooke {
namespace {

/// What is pushed less far than this share of the first push is on its way out.
constexpr double still_pushed = 0.5;

template <class Visit>
void for_each_lane(std::uint16_t lanes, const Visit& visit) {
  for (std::size_t lane = 0; lane < block_size; ++lane) {
    if ((lanes >> lane & 1u) != 0) visit(lane);
  }
}

/// Where a solid carries a place in a step, along an axis of the world.
template <class Real>
Real carried_along(const Contact<Real>& contact, const Real* place, std::size_t axis) {
  Real sum = contact.after.origin[axis];
  for (std::size_t j = 0; j < 3; ++j) {
    Real local = Real(0);
    for (std::size_t i = 0; i < 3; ++i)
      local += contact.before.rotation[i][j] * (place[i] - contact.before.origin[i]);
    sum += contact.after.rotation[axis][j] * local;
  }
  return sum;
}

}  // namespace

template <class Real>
void Pinch<Real>::begin_round() {
  last_ = {}, solids_ = {};
  carried_ = {};
}

template <class Real>
void Pinch<Real>::push(const Contact<Real>& contact) {
  Real* const places[] = {block_.x, block_.y, block_.z};
  const Real* const starts[] = {block_.x0, block_.y0, block_.z0};
  std::array<Values, 3> before;
  for (std::size_t k = 0; k < 3; ++k) std::copy_n(places[k], block_size, before[k].begin());
  for_each_lane(resolve(contact, block_), [&](std::size_t lane) {
    Real square = Real(0);
    const Real start[] = {starts[0][lane], starts[1][lane], starts[2][lane]};
    for (std::size_t k = 0; k < 3; ++k) {
      const Real way = places[k][lane] - before[k][lane];
      square += way * way;
      carried_[k][lane] += carried_along(contact, start, k);
    }
    last_[lane] = std::max(last_[lane], std::sqrt(square));
    solids_[lane] += Real(1);
  });
}

template <class Real>
void Pinch<Real>::end_round() {
  if (round_++ == 0) first_ = last_;
  for_each_lane(block_.free, [&](std::size_t lane) {
    if (last_[lane] <= longest_of_rounding(lane)) block_.free = std::uint16_t(block_.free & ~(1u << lane));
  });
}

template <class Real>
Real Pinch<Real>::longest_of_rounding(std::size_t lane) const {
  const Real size = std::abs(block_.x[lane]) + std::abs(block_.y[lane]) + std::abs(block_.z[lane]);
  return Real(64) * std::numeric_limits<Real>::epsilon() * size;
}

template <class Real>
void Pinch<Real>::carry_pinched() {
  for_each_lane(block_.free, [&](std::size_t lane) {
    const bool is_pinched = solids_[lane] > Real(1) && last_[lane] > Real(still_pushed) * first_[lane];
    if (!is_pinched) return;
    const auto carry = [&](std::size_t k, const Real* start, Real* place, Real* velocity) {
      const Real carried = carried_[k][lane] / solids_[lane];
      place[lane] = carried;
      velocity[lane] = (carried - start[lane]) / block_.h;
    };
    carry(0, block_.x0, block_.x, block_.vx);
    carry(1, block_.y0, block_.y, block_.vy);
    carry(2, block_.z0, block_.z, block_.vz);
  });
}

template class Pinch<float>;
template class Pinch<double>;

}  // namespace hooke
