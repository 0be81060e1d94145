#pragma once

#include <functional>
#include <string_view>
#include <variant>

#include <hooke/vec3.h>

/// The effects that a scene can name, one struct of plain data each. An effect that a scene does not name is
/// not in the plan: no memory, no pass, no branch.
///
/// Every struct carries its `name` and a list of its `fields`: scene files, their schema and user interfaces
/// read this one list, so the code and the file say the same words.

namespace hooke {

/// Uniform gravity: F = m g on every particle.
struct Gravity {
  Vec3 acceleration{0.0, -9.81, 0.0};  ///< g [m/s^2]

  static constexpr std::string_view name = "gravity";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("acceleration", self.acceleration);
  }
};

/// Linear viscous drag of every particle against still air: F = -c v (Provot 1995).
struct Drag {
  double coefficient = 0.0;  ///< c [N s/m], >= 0

  static constexpr std::string_view name = "drag";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("coefficient", self.coefficient);
  }
};

/// A force that depends on place and time: F = force(x, t) on every particle.
/// The callback gets a position [m] and a time [s] and returns a force [N]. It is called from several threads
/// at once, so it must not change shared data; the same arguments must give the same force if runs are to be
/// reproducible. A callback cannot be written in a scene file.
struct Field {
  std::function<Vec3(const Vec3& position, double time)> force = nullptr;

  static constexpr std::string_view name = "field";
  template <class Self, class Visit>
  static void fields(Self&, Visit&&) {}
};

/// A plane that pushes back on what sinks below it, as a one-sided spring and damper (penalty):
/// with depth d = height - n.x > 0, F = max(0, k d - c n.v) n. It never pulls.
struct GroundPlane {
  Vec3 normal{0.0, 1.0, 0.0};  ///< n, points out of the ground; any length but zero
  double height = 0.0;         ///< [m] along the unit normal
  double stiffness = 1e3;      ///< k [N/m] for each particle, >= 0
  double damping = 0.0;        ///< c [N s/m] for each particle, >= 0

  static constexpr std::string_view name = "ground_plane";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("normal", self.normal);
    visit("height", self.height);
    visit("stiffness", self.stiffness);
    visit("damping", self.damping);
  }
};

using Effect = std::variant<Gravity, Drag, Field, GroundPlane>;

}  // namespace hooke
