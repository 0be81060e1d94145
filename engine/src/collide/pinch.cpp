#include "collide/pinch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hooke {
namespace {

/// What is pushed less far than this share of the first push is on its way out.
constexpr double still_pushed = 0.5;

/// And by this share of it at a place that rounds in an earlier step have led to.
constexpr double left_by_rounds = 0.1;

/// Two directions are opposite where their mean is shorter than this: solids that close in on each other at
/// less than 60 degrees.
constexpr double opposite = 0.5;

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
  last_ = {}, solids_ = {}, carried_ = {};
}

template <class Real>
void Pinch<Real>::push(const Contact<Real>& contact) {
  Real* const places[] = {block_.x, block_.y, block_.z};
  Vectors before;
  for (std::size_t k = 0; k < 3; ++k) std::copy_n(places[k], block_size, before[k].begin());
  for_each_lane(resolve(contact, block_), [&](std::size_t lane) {
    Real square = Real(0);
    const Real start[] = {block_.x0[lane], block_.y0[lane], block_.z0[lane]};
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
  if (rounds_++ == 0) first_ = last_;
  for_each_lane(block_.free, [&](std::size_t lane) {
    if (last_[lane] <= rounding_of(lane)) block_.free = std::uint16_t(block_.free & ~(1u << lane));
    for (Values& along : carried_) along[lane] /= std::max(solids_[lane], Real(1));
  });
}

template <class Real>
Real Pinch<Real>::rounding_of(std::size_t lane) const {
  const Real size = std::abs(block_.x[lane]) + std::abs(block_.y[lane]) + std::abs(block_.z[lane]);
  return Real(64) * std::numeric_limits<Real>::epsilon() * size;
}

template <class Real>
void Pinch<Real>::begin_look() {
  deep_in_ = {}, outwards_ = {};
}

template <class Real>
void Pinch<Real>::look(const Contact<Real>& contact) {
  alignas(cache_line) Vectors place = carried_, velocity = {};
  ContactBlock<Real> there = block_;
  there.x = place[0].data(), there.y = place[1].data(), there.z = place[2].data();
  there.vx = velocity[0].data(), there.vy = velocity[1].data(), there.vz = velocity[2].data();
  for_each_lane(resolve(contact, there), [&](std::size_t lane) {
    Real way[3], square = Real(0);
    for (std::size_t k = 0; k < 3; ++k) {
      way[k] = place[k][lane] - carried_[k][lane];
      square += way[k] * way[k];
    }
    const Real length = std::sqrt(square);
    if (!(length > std::max(rounding_of(lane), Real(left_by_rounds) * first_[lane]))) return;
    deep_in_[lane] += Real(1);
    for (std::size_t k = 0; k < 3; ++k) outwards_[k][lane] += way[k] / length;
  });
}

template <class Real>
void Pinch<Real>::carry_pinched() {
  for_each_lane(block_.free, [&](std::size_t lane) {
    Real square = Real(0);
    for (const Values& along : outwards_) square += along[lane] * along[lane];
    const Real most = Real(opposite) * deep_in_[lane];
    if (deep_in_[lane] > Real(1) && square < most * most) carry(lane);
  });
}

template <class Real>
void Pinch<Real>::carry_left() {
  for_each_lane(block_.free, [&](std::size_t lane) {
    if (solids_[lane] > Real(1) && last_[lane] > Real(still_pushed) * first_[lane]) carry(lane);
  });
}

template <class Real>
void Pinch<Real>::carry(std::size_t lane) {
  const auto along = [&](std::size_t k, const Real* start, Real* place, Real* velocity) {
    place[lane] = carried_[k][lane];
    velocity[lane] = (carried_[k][lane] - start[lane]) / block_.h;
  };
  along(0, block_.x0, block_.x, block_.vx);
  along(1, block_.y0, block_.y, block_.vy);
  along(2, block_.z0, block_.z, block_.vz);
  block_.free = std::uint16_t(block_.free & ~(1u << lane));
}

template class Pinch<float>;
template class Pinch<double>;

}  // namespace hooke
