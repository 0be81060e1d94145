#pragma once

#include <string_view>
#include <variant>

/// The integration methods, one struct of plain data each.

namespace hooke {

/// Velocity first, then position with the new velocity: v' = v + h a(x, v), x' = x + h v'. Order 1, conserves
/// the energy of an oscillator on average; stable for h w < 2 without damping. The engine's default.
struct SymplecticEuler {
  static constexpr std::string_view name = "symplectic_euler";
  template <class Self, class Visit>
  static void fields(Self&, Visit&&) {}
};

/// The lecture's method: velocity and position both from time t: v' = v + h a(x, v), x' = x + h v. Order 1;
/// the energy of an undamped oscillator grows by 1 + (h w)^2 each step, so it needs damping: stable for h <=
/// 2 zeta / w.
struct ExplicitEuler {
  static constexpr std::string_view name = "explicit_euler";
  template <class Self, class Visit>
  static void fields(Self&, Visit&&) {}
};

using Method = std::variant<SymplecticEuler, ExplicitEuler>;

}  // namespace hooke
