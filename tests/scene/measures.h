#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

#include <hooke/hooke.h>

/// What several tests of builders ask of a scene.

namespace hooke::test {

inline double total_mass(const Scene& scene) {
  return std::accumulate(scene.particles.mass.begin(), scene.particles.mass.end(), 0.0);
}

/// The springs of one kind, told apart by their stiffness.
inline std::size_t count_springs(const Scene& scene, double stiffness) {
  const auto& all = scene.springs.stiffness;
  return static_cast<std::size_t>(std::count(all.begin(), all.end(), stiffness));
}

/// Largest |l - l0| / l0 of all springs [1]; not a number counts as infinite.
inline double worst_strain(const Scene& scene) {
  double worst = 0.0;
  for (std::size_t i = 0; i < scene.springs.size(); ++i) {
    const Vec3& first = scene.particles.position[scene.springs.first[i]];
    const Vec3& second = scene.particles.position[scene.springs.second[i]];
    const double rest = scene.springs.rest_length[i];
    const double strain = std::abs((second - first).norm() - rest) / rest;
    worst = std::isnan(strain) ? INFINITY : std::max(worst, strain);
  }
  return worst;
}

inline Vec3 normal_of(const Scene& scene, const Triangle& triangle) {
  const auto& position = scene.particles.position;
  const Vec3 u = position[triangle[1]] - position[triangle[0]];
  const Vec3 v = position[triangle[2]] - position[triangle[0]];
  return {u.y() * v.z() - u.z() * v.y(), u.z() * v.x() - u.x() * v.z(), u.x() * v.y() - u.y() * v.x()};
}

/// Messages of the SceneError that `action` throws; empty when it throws none.
template <class Action>
std::vector<std::string> messages_of(Action&& action) {
  std::vector<std::string> messages;
  try {
    action();
  } catch (const SceneError& error) {
    for (const Fault& fault : error.faults()) messages.push_back(fault.message());
  }
  return messages;
}

inline bool same_arrays(const Scene& a, const Scene& b) {
  return a.particles.mass == b.particles.mass && a.particles.position == b.particles.position &&
         a.particles.velocity == b.particles.velocity && a.springs.first == b.springs.first &&
         a.springs.second == b.springs.second && a.springs.stiffness == b.springs.stiffness &&
         a.springs.rest_length == b.springs.rest_length && a.springs.damping == b.springs.damping &&
         a.triangles == b.triangles;
}

/// A scene with something in every array, to see that a builder that fails leaves it alone.
inline Scene occupied_scene() {
  Scene scene;
  scene.add_particle(1.0, {0, 0, 0}, {1, 2, 3});
  scene.add_particle(2.0, {1, 0, 0});
  scene.add_particle(3.0, {0, 1, 0});
  scene.add_spring(0, 1, 10.0, 1.0, 0.5);
  scene.triangles.push_back({0, 1, 2});
  return scene;
}

}  // namespace hooke::test

/// So that a failed comparison of messages shows them.
template <>
struct doctest::StringMaker<std::vector<std::string>> {
  static String convert(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += "\n  " + line;
    return text.c_str();
  }
};
