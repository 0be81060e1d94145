#include "effects/curl_noise.h"

#include <cmath>

#include <Eigen/Geometry>

#include "effects/lattice_random.h"

namespace hooke {
namespace {

/// Coordinates on the lattice that are larger have no fraction of a cell.
constexpr double furthest = 0x1p52;

/// 6 s^5 - 15 s^4 + 10 s^3, from 0 to 1 with two derivatives zero at the ends, and its derivative.
double smooth(double s) {
  return s * s * s * (s * (s * 6.0 - 15.0) + 10.0);
}
double slope(double s) {
  return 30.0 * s * s * (s - 1.0) * (s - 1.0);
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

/// The weights of an axis' two corners, and their derivatives.
struct AxisWeights {
  explicit AxisWeights(double s) : weight{1.0 - smooth(s), smooth(s)}, change{-slope(s), slope(s)} {}

  std::array<double, 2> weight, change;
};

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
    cell.gradients[i] = gradients_at(octave.seed, corner, octave.time);
  }
  cell.lowest = lowest;
  cell.known = true;
  return cell;
}

/// Of the potential: the sum over corners of w G d, whose curl is w curl(G d) + grad(w) x G d.
Vec3 CurlNoise::curl(Octave& octave, const Vec3& position) {
  const Vec3 place = octave.inverse_length * position;
  const bool near = place.cwiseAbs().maxCoeff<Eigen::PropagateNaN>() < furthest;
  if (!(near && std::abs(octave.time) < furthest)) return 0.0 * position;
  const Vec3 floor(std::floor(place.x()), std::floor(place.y()), std::floor(place.z()));
  const Corner lowest{std::int64_t(floor.x()), std::int64_t(floor.y()), std::int64_t(floor.z())};
  const Cell& cell = cell_at(octave, lowest);

  const Vec3 s = place - floor;
  const AxisWeights x(s.x()), y(s.y()), z(s.z());
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < 8; ++i) {
    const std::size_t a = i & 1, b = (i >> 1) & 1, c = i >> 2;
    const auto& [gx, gy, gz] = cell.gradients[i];
    const Vec3 d = s - Vec3(double(a), double(b), double(c));
    const Vec3 own(gz.y() - gy.z(), gx.z() - gz.x(), gy.x() - gx.y());
    const Vec3 change(x.change[a] * y.weight[b] * z.weight[c], x.weight[a] * y.change[b] * z.weight[c],
                      x.weight[a] * y.weight[b] * z.change[c]);
    sum +=
        x.weight[a] * y.weight[b] * z.weight[c] * own + change.cross(Vec3(gx.dot(d), gy.dot(d), gz.dot(d)));
  }
  return octave.scale * sum;
}

}  // namespace hooke
