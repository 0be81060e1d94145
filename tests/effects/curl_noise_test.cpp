#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include <Eigen/Core>

#include <hooke/hooke.h>

using namespace hooke;

namespace {

Vec3 random_place(std::mt19937& random, double size) {
  const auto unit = [&] { return double(random()) / 4294967296.0 - 0.5; };
  const double x = unit(), y = unit(), z = unit();
  return size * Vec3(x, y, z);
}

Vec3 turbulence_at(const TurbulenceField& field, const Vec3& x, double t) {
  return value_at(field, SteadyEnvelope{}, x, t);
}

/// Of the bits of values at places from -50 m to 50 m.
std::uint64_t hash_of(const TurbulenceField& field) {
  std::mt19937 random(3);
  std::uint64_t hash = 14695981039346656037u;
  for (int i = 0; i < 1000; ++i) {
    for (const double value : turbulence_at(field, random_place(random, 100.0), 0.01 * i))
      hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 1099511628211u;
  }
  return hash;
}

}  // namespace

TEST_CASE("turbulence has no sources, within cells and across their faces") {
  const TurbulenceField field{.amplitude = 2.0, .length = 0.7, .duration = 0.3, .octaves = 3, .seed = 9};
  std::mt19937 random(1);
  constexpr double h = 1e-5;
  double rotation = 0.0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 x = i % 2 == 0 ? random_place(random, 20.0) : Vec3(0.7 * i, 0.35 * (i % 7), 0.1 * (i % 3));
    Eigen::Matrix3d gradient;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 step = h * Vec3::Unit(axis);
      gradient.col(axis) =
          (turbulence_at(field, x + step, 0.4) - turbulence_at(field, x - step, 0.4)) / (2.0 * h);
    }
    REQUIRE(std::abs(gradient.trace()) < 2e-6);
    rotation = std::max(rotation, std::abs(gradient(0, 1) - gradient(1, 0)));
  }
  CHECK(rotation > 5.0);  // so the differences that vanish are those of something
}

TEST_CASE("the amplitude of turbulence is the root mean square of its first octave, at any time") {
  for (const double t : {0.0, 0.37}) {
    double square = 0.0;
    Vec3 mean = Vec3::Zero();
    std::mt19937 random(2);
    constexpr int samples = 60000;
    for (int i = 0; i < samples; ++i) {
      const Vec3 u = turbulence_at({.amplitude = 3.0, .length = 0.5, .duration = 2.0, .octaves = 1},
                                   random_place(random, 40.0), t);
      square += u.squaredNorm() / samples;
      mean += u / samples;
    }
    CHECK(std::sqrt(square) == doctest::Approx(3.0).epsilon(0.02));
    CHECK(mean.norm() < 0.05);
  }
}

TEST_CASE("turbulence: the same bits for the same seed, in any order, and others for another") {
  const TurbulenceField field;
  TurbulenceField other = field;
  other.seed = 2;
  CHECK(hash_of(field) == hash_of(field));
  CHECK(hash_of(field) != hash_of(other));
  const Vec3 x(0.3, -4.1, 2.2);
  CHECK(turbulence_at(field, x, 1.0) == turbulence_at(field, x, 1.0));
}

TEST_CASE("turbulence is continuous in space and time, and changes over its duration") {
  const TurbulenceField field{.amplitude = 1.0, .length = 1.0, .duration = 0.5, .octaves = 2};
  const Vec3 x(0.3, 0.4, -1.7);
  double furthest = 0.0;
  for (double t = 0.0; t < 3.0; t += 1e-3) {
    REQUIRE((turbulence_at(field, x, t + 1e-3) - turbulence_at(field, x, t)).norm() < 0.05);
    furthest = std::max(furthest, (turbulence_at(field, x, t) - turbulence_at(field, x, 0.0)).norm());
  }
  CHECK(furthest > 0.5);
  for (double s = -3.0; s < 3.0; s += 1e-3)
    REQUIRE(
        (turbulence_at(field, Vec3(s + 1e-3, 2 * s, -s), 0.0) - turbulence_at(field, Vec3(s, 2 * s, -s), 0.0))
            .norm() < 0.05);
}

TEST_CASE("turbulence drifts, and is added to its mean") {
  const TurbulenceField still{.duration = 1e9};
  TurbulenceField drifting = still;
  drifting.drift = {2.0, 0.0, -1.0};
  drifting.mean = {5.0, 6.0, 7.0};
  const Vec3 x(0.2, 0.9, 3.3);
  const Vec3 expected = turbulence_at(still, x, 0.0) + drifting.mean;
  CHECK((turbulence_at(drifting, x + 1.5 * drifting.drift, 1.5) - expected).norm() < 1e-6);
}

TEST_CASE("turbulence far away and at broken places neither fails nor invents a number") {
  CHECK(turbulence_at({}, Vec3(1e300, 0, 0), 0.0).isZero());
  CHECK(std::isnan(turbulence_at({}, Vec3(0, NAN, 0), 0.0).y()));
}
