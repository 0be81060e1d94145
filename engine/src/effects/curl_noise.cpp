#include "effects/curl_noise.h"

#include <cmath>

#include "effects/lattice_random.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "effects/curl_noise.cpp"
#include <hwy/foreach_target.h>

#include "kernels/elements-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

/// Along each axis and one unused: the place in a cell, from 0 to 1, the weight of its upper corners, which
/// is 6 s^5 - 15 s^4 + 10 s^3, and its derivative.
struct CellWeights {
  alignas(cache_line) double s[4], weight[4], change[4];

  explicit HWY_INLINE CellWeights(const double* place) {
    const hn::CappedTag<double, 4> d;
    for (std::size_t i = 0; i < 4; i += hn::Lanes(d)) {
      const auto x = hn::LoadU(d, place + i), below = hn::Sub(x, hn::Set(d, 1.0));
      const auto bracket = hn::MulAdd(hn::MulSub(hn::Set(d, 6.0), x, hn::Set(d, 15.0)), x, hn::Set(d, 10.0));
      const auto square = hn::Mul(x, x);
      hn::Store(x, d, s + i);
      hn::Store(hn::Mul(hn::Mul(square, x), bracket), d, weight + i);
      hn::Store(hn::Mul(hn::Mul(hn::Set(d, 30.0), square), hn::Mul(below, below)), d, change + i);
    }
  }
};

/// Of one axis, at corners of which those lie at its end where `end` is 1 and not 0.
template <class V>
struct CornerWeights {
  V distance, weight, change;

  template <class D>
  HWY_INLINE CornerWeights(D d, const CellWeights& cell, std::size_t axis, V end) {
    const auto is_upper = hn::Gt(end, hn::Zero(d));
    const V upper = hn::Set(d, cell.weight[axis]), slope = hn::Set(d, cell.change[axis]);
    distance = hn::Sub(hn::Set(d, cell.s[axis]), end);
    weight = hn::IfThenElse(is_upper, upper, hn::Sub(hn::Set(d, 1.0), upper));
    change = hn::IfThenElse(is_upper, slope, hn::Neg(slope));
  }
};

}  // namespace

/// Of the potential: the sum over corners of w G d, whose curl is w curl(G d) + grad(w) x G d.
void curl_in_cell(const NoiseCell& cell, const double* place, double* result) {
  const CellWeights weights(place);
  alignas(cache_line) static constexpr double upper[3][8] = {
      {0, 1, 0, 1, 0, 1, 0, 1}, {0, 0, 1, 1, 0, 0, 1, 1}, {0, 0, 0, 0, 1, 1, 1, 1}};
  const hn::CappedTag<double, 8> d;
  using V = hn::Vec<decltype(d)>;
  Vector3<V> sum{hn::Zero(d), hn::Zero(d), hn::Zero(d)};
  for (std::size_t i = 0; i < 8; i += hn::Lanes(d)) {
    const auto at = [&](const double(&values)[3][8]) HWY_ATTR {
      return Vector3<V>{hn::Load(d, values[0] + i), hn::Load(d, values[1] + i), hn::Load(d, values[2] + i)};
    };
    const Vector3<V> end = at(upper);
    const CornerWeights<V> x(d, weights, 0, end.x), y(d, weights, 1, end.y), z(d, weights, 2, end.z);
    const Vector3<V> distance{x.distance, y.distance, z.distance};
    const V yz = hn::Mul(y.weight, z.weight);
    const Vector3<V> potential{dot(at(cell.gradient[0]), distance), dot(at(cell.gradient[1]), distance),
                               dot(at(cell.gradient[2]), distance)};
    const Vector3<V> change{hn::Mul(x.change, yz), hn::Mul(x.weight, hn::Mul(y.change, z.weight)),
                            hn::Mul(x.weight, hn::Mul(y.weight, z.change))};
    sum = sum + scaled(hn::Mul(x.weight, yz), at(cell.curl)) + cross(change, potential);
  }
  result[0] = hn::GetLane(hn::SumOfLanes(d, sum.x));
  result[1] = hn::GetLane(hn::SumOfLanes(d, sum.y));
  result[2] = hn::GetLane(hn::SumOfLanes(d, sum.z));
}

}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hooke {
namespace {

HWY_EXPORT(curl_in_cell);

/// Coordinates on the lattice that are larger have no fraction of a cell.
constexpr double furthest = 0x1p52;

/// 6 s^5 - 15 s^4 + 10 s^3, from 0 to 1 with two derivatives zero at the ends.
double smooth(double s) {
  return s * s * s * (s * (s * 6.0 - 15.0) + 10.0);
}

/// Of a number of less than 2^52 in size; std::floor is a call where SSE4.1 cannot be counted on.
std::int64_t floor_of(double x) {
  const auto towards_zero = std::int64_t(x);
  return towards_zero - (double(towards_zero) > x ? 1 : 0);
}

/// Root mean square of the curl's magnitude on the lattice: with w the weight along one axis at the distance
/// d from a corner, and sums over both corners, the integrals of w^2, (w d)^2, (w + w' d)^2 and w'^2 are P =
/// 181/231, Q = 535/9009, R = 60/77 and T = 20/7; the mean square is 2 (R P^2 + 2 T Q P).
double curl_on_lattice() {
  return std::sqrt(238536280.0 / 160243083.0);
}

/// Three numbers from (-1, 1) whose mean is 0 and mean square 1/3.
Vec3 random_vector(std::uint64_t hash) {
  constexpr std::uint64_t ones = (std::uint64_t{1} << 21) - 1;
  const auto number = [&](unsigned shift) { return (double((hash >> shift) & ones) + 0.5) * 0x1p-20 - 1.0; };
  return {number(0), number(21), number(42)};
}

using Gradients = std::array<Vec3, 3>;

/// At a corner they go from one random value to the next, each corner at times of its own. The weights keep
/// the mean square.
Gradients gradients_at(std::uint64_t seed, const std::array<std::int64_t, 3>& corner, double time) {
  std::uint64_t hash = seed;
  for (const std::int64_t c : corner) hash = mixed(hash, std::uint64_t(c));
  const double own_time = time + unit_interval(hash);
  const double moment = std::floor(own_time);
  const double next = smooth(own_time - moment), last = 1.0 - next;
  const double scale = 1.0 / std::sqrt(last * last + next * next);
  const std::uint64_t from = mixed(hash, std::uint64_t(std::int64_t(moment)));
  const std::uint64_t to = mixed(hash, std::uint64_t(std::int64_t(moment) + 1));
  Gradients gradients;
  for (std::size_t i = 0; i < 3; ++i)
    gradients[i] = scale * (last * random_vector(mixed(from, i)) + next * random_vector(mixed(to, i)));
  return gradients;
}

}  // namespace

CurlNoise::CurlNoise(const TurbulenceField& field, double time)
    : mean_(field.mean),
      shift_(time * field.drift),
      octaves_(std::min<std::size_t>(field.octaves, most_octaves)) {
  double part = 1.0;
  for (std::size_t i = 0; i < octaves_; ++i) {
    Octave& octave = octave_[i];
    octave.scale = part * field.amplitude / curl_on_lattice();
    octave.inverse_length = 1.0 / (part * field.length);
    octave.time = time / (part * field.duration);
    octave.seed = mixed(field.seed, i);
    part *= 0.5;
  }
}

Vec3 CurlNoise::operator()(const Vec3& position) const {
  Vec3 sum = mean_;
  for (std::size_t i = 0; i < octaves_; ++i) sum += curl(octave_[i], position - shift_);
  return sum;
}

auto CurlNoise::cell_at(Octave& octave, const Corner& lowest) -> const Cell& {
  Cell& cell = octave.cells[std::size_t((lowest[0] & 1) | (lowest[1] & 1) << 1 | (lowest[2] & 1) << 2)];
  if (cell.known && cell.lowest == lowest) return cell;
  for (std::size_t i = 0; i < 8; ++i) {
    const Corner corner{lowest[0] + std::int64_t(i & 1), lowest[1] + std::int64_t((i >> 1) & 1),
                        lowest[2] + std::int64_t(i >> 2)};
    const Gradients g = gradients_at(octave.seed, corner, octave.time);
    for (std::size_t component = 0; component < 3; ++component) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        cell.gradient[component][axis][i] = g[component][Eigen::Index(axis)];
    }
    cell.curl[0][i] = g[2].y() - g[1].z();
    cell.curl[1][i] = g[0].z() - g[2].x();
    cell.curl[2][i] = g[1].x() - g[0].y();
  }
  cell.lowest = lowest;
  cell.known = true;
  return cell;
}

Vec3 CurlNoise::curl(Octave& octave, const Vec3& position) {
  const Vec3 place = octave.inverse_length * position;
  const auto is_near = [](double x) { return std::abs(x) < furthest; };
  if (!(is_near(place.x()) && is_near(place.y()) && is_near(place.z()) && is_near(octave.time)))
    return 0.0 * position;
  const Corner lowest{floor_of(place.x()), floor_of(place.y()), floor_of(place.z())};
  const double in_cell[4] = {place.x() - double(lowest[0]), place.y() - double(lowest[1]),
                             place.z() - double(lowest[2]), 0.0};
  Vec3 sum;
  HWY_DYNAMIC_DISPATCH(curl_in_cell)(cell_at(octave, lowest), in_cell, sum.data());
  return octave.scale * sum;
}

}  // namespace hooke
#endif
