#include <algorithm>
#include <initializer_list>
#include <limits>
#include <string>
#include <utility>
#include <variant>

#include <hooke/scene.h>

#include "effects/effect_functions.h"
#include "scene/element_checks.h"

namespace hooke {
namespace {

using Faults = std::vector<Fault>;

struct ArrayLength {
  std::string_view array;
  std::size_t length;
  bool may_be_empty = false;
};

/// The first array says how many elements there are.
void check_lengths(Faults& faults, std::string_view element, std::initializer_list<ArrayLength> arrays) {
  const std::size_t expected = arrays.begin()->length;
  const auto good = [&](const ArrayLength& a) {
    return a.length == expected || (a.may_be_empty && a.length == 0);
  };
  if (std::all_of(arrays.begin(), arrays.end(), good)) return;
  std::string problem = "arrays differ in length:";
  std::string remedy = "give each the same number of values";
  for (const ArrayLength& a : arrays) {
    problem.append(&a == arrays.begin() ? " " : ", ").append(a.array).append(" has ");
    problem.append(std::to_string(a.length));
    if (a.may_be_empty) remedy.append("; ").append(a.array).append(" may be empty");
  }
  ElementChecks(faults, element).add(std::move(problem), std::move(remedy));
}

void check_count(Faults& faults, std::string_view element, std::size_t count) {
  constexpr std::size_t most = std::numeric_limits<Index>::max();
  if (count <= most) return;
  ElementChecks(faults, element)
      .add("there are " + std::to_string(count), "use at most " + std::to_string(most));
}

/// Each array is walked on its own, so one of a wrong length is never read past its end.
void check_particles(Faults& faults, const Particles& particles) {
  const auto& [mass, position, velocity] = particles;
  check_lengths(faults, "particles",
                {{"position", position.size()}, {"mass", mass.size()}, {"velocity", velocity.size(), true}});
  check_count(faults, "particles", position.size());
  for (std::size_t i = 0; i < mass.size(); ++i) {
    ElementChecks(faults, "particle", i).positive("mass", mass[i], "kg");
  }
  for (std::size_t i = 0; i < position.size(); ++i) {
    ElementChecks(faults, "particle", i).finite("position", position[i], "m");
  }
  for (std::size_t i = 0; i < velocity.size(); ++i) {
    ElementChecks(faults, "particle", i).finite("velocity", velocity[i], "m/s");
  }
}

void check_spring_ends(Faults& faults, const Springs& springs, std::size_t particle_count) {
  const auto& first = springs.first;
  const auto& second = springs.second;
  for (std::size_t i = 0; i < first.size(); ++i) {
    ElementChecks(faults, "spring", i).in_range("first", first[i], particle_count, "particles");
  }
  for (std::size_t i = 0; i < second.size(); ++i) {
    ElementChecks(faults, "spring", i).in_range("second", second[i], particle_count, "particles");
  }
  const std::size_t pairs = std::min(first.size(), second.size());
  for (std::size_t i = 0; i < pairs; ++i) {
    if (first[i] != second[i]) continue;
    ElementChecks(faults, "spring", i)
        .add("joins particle " + std::to_string(first[i]) + " to itself",
             "give two different particles or leave the spring out");
  }
}

void check_springs(Faults& faults, const Springs& springs, std::size_t particle_count) {
  const auto& [first, second, stiffness, rest_length, damping] = springs;
  check_lengths(faults, "springs",
                {{"first", first.size()},
                 {"second", second.size()},
                 {"stiffness", stiffness.size()},
                 {"rest_length", rest_length.size()},
                 {"damping", damping.size(), true}});
  check_count(faults, "springs", springs.size());
  check_spring_ends(faults, springs, particle_count);
  for (std::size_t i = 0; i < stiffness.size(); ++i) {
    ElementChecks(faults, "spring", i).not_negative("stiffness", stiffness[i], "N/m");
  }
  for (std::size_t i = 0; i < rest_length.size(); ++i) {
    ElementChecks(faults, "spring", i).not_negative("rest_length", rest_length[i], "m");
  }
  for (std::size_t i = 0; i < damping.size(); ++i) {
    ElementChecks(faults, "spring", i).not_negative("damping", damping[i], "N s/m");
  }
}

void check_path(Faults& faults, std::size_t pin, const std::vector<Keyframe>& path) {
  const std::string kind = "pin " + std::to_string(pin) + " keyframe";
  double latest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < path.size(); ++i) {
    const ElementChecks checks(faults, kind, i);
    checks.later_time("time", path[i].time, latest);
    checks.finite("displacement", path[i].displacement, "m");
  }
}

void check_pins(Faults& faults, const std::vector<Pin>& pins, std::size_t particle_count) {
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> pin_of(pins.empty() ? 0 : particle_count, none);
  for (std::size_t i = 0; i < pins.size(); ++i) {
    const Index particle = pins[i].particle;
    const ElementChecks checks(faults, "pin", i);
    checks.in_range("particle", particle, particle_count, "particles");
    if (particle < particle_count) {
      if (pin_of[particle] == none) {
        pin_of[particle] = i;
      } else {
        checks.add("particle " + std::to_string(particle) + " is already pinned by pin " +
                       std::to_string(pin_of[particle]),
                   "keep one of the two");
      }
    }
    if (!pins[i].path.empty()) check_path(faults, i, pins[i].path);
  }
}

void check_triangles(Faults& faults, const std::vector<Triangle>& triangles, std::size_t particle_count) {
  constexpr std::array<std::string_view, 3> corner_names{"corner 0", "corner 1", "corner 2"};
  check_count(faults, "triangles", triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& [a, b, c] = triangles[i];
    const ElementChecks checks(faults, "triangle", i);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      checks.in_range(corner_names[corner], triangles[i][corner], particle_count, "particles");
    }
    if (a == b || b == c || c == a) {
      checks.add(
          "has a corner twice: " + std::to_string(a) + ", " + std::to_string(b) + ", " + std::to_string(c),
          "give three different particles or leave the triangle out");
    }
  }
}

void check_effects(Faults& faults, const Scene& scene) {
  for (std::size_t i = 0; i < scene.effects.size(); ++i) {
    const auto check = [&](const auto& effect) {
      const std::string element = "effects[" + std::to_string(i) + "] (" + std::string(effect.name) + ")";
      check_effect(effect, scene, ElementChecks(faults, element));
    };
    std::visit(check, scene.effects[i]);
  }
}

}  // namespace

std::vector<Fault> validate(const Scene& scene) {
  Faults faults;
  const std::size_t particle_count = scene.particles.size();
  if (particle_count == 0 && scene.particles.mass.empty()) {
    ElementChecks(faults, "scene").add("has no particles", "add at least one");
  }
  check_particles(faults, scene.particles);
  check_springs(faults, scene.springs, particle_count);
  check_pins(faults, scene.pins, particle_count);
  check_triangles(faults, scene.triangles, particle_count);
  check_effects(faults, scene);
  return faults;
}

}  // namespace hooke
