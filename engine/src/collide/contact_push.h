#pragma once

#include <array>
#include <cstddef>
#include <span>

#include <hooke/index.h>

namespace hooke {

/// A contact as sweeps read it, see SurfaceContact, and what it has done in them. The fourth value of vectors
/// is zero.
struct PackedContact {
  std::array<double, 4> normal, held, weights;
  double least, friction;
  double mass;                      ///< of what a push moves, as its gap sees it [kg]
  std::array<Index, 4> places;      ///< of its particles among the values
  double pushed;                    ///< along the normal in all sweeps together, >= 0
  std::array<double, 4> held_back;  ///< along the surface, likewise
};

/// x, y, z of what some particles have, and their inverse masses [1/kg], for each four doubles.
using PackedValues = double*;

/// Pushes a run of contacts that share no particle, one after the other: each moves its particles so that it
/// is kept, back as far as it has pushed more than that takes. Returns the most that one lacked or took back;
/// 0 where all were kept.
double push_contacts(std::span<PackedContact> contacts, PackedValues values);

}  // namespace hooke
