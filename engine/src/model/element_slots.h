#pragma once

#include <array>
#include <cstdint>
#include <type_traits>
#include <vector>

#include <hooke/scene.h>

#include "aligned.h"
#include "model/order.h"
#include "state.h"
#include "strip.h"

namespace hooke {

/// What an element has at most: particles, and numbers that its force depends on.
inline constexpr std::size_t most_corners = 4, most_coefficients = 8;

/// Elements of effects, such as hinges or triangles: each joins the same number of particles, its corners,
/// and has the same number of coefficients, of which the first is not zero where the element has a force.
struct Elements {
  std::size_t corners = 0, coefficients = 0;
  std::vector<Index> particles = {};  ///< those of one element behind one another, in the user's numbering
  std::vector<double> values = {};    ///< likewise the coefficients

  std::size_t size() const { return corners == 0 ? 0 : particles.size() / corners; }
  void add(std::initializer_list<Index> of_corners, std::initializer_list<double> of_coefficients) {
    particles.insert(particles.end(), of_corners);
    values.insert(values.end(), of_coefficients);
  }
};

/// The number of a particle as vectors gather by it: as wide as a value.
template <class Real>
using LaneIndex = std::conditional_t<sizeof(Real) == 4, std::int32_t, std::int64_t>;

/// Elements as each particle sees them, like the springs in Slots: for each block of 16 particles a list of
/// slots, each with one element for each lane, in which the lane's particle is always the same corner, the
/// slot's role. An element is in as many slots as it has corners.
///
/// In a shift slot corner c of lane i's element is particle i + shift[c], so that a grid's elements are read
/// by plain vector loads; in an indexed slot there is a number for each lane. A lane without an element has
/// coefficients zero; in an indexed slot all its corners are itself.
template <class Real>
struct ElementSlots {
  static constexpr std::uint32_t no_row = ~std::uint32_t{0};

  struct Slot {
    std::uint32_t role;
    std::uint32_t particles;  ///< of an indexed slot: the first of `corners` rows; else no_row
    std::uint32_t elements;   ///< row of the elements' numbers; no_row where they are not kept
    std::array<std::int32_t, most_corners> shift;      ///< of a shift slot
    std::array<std::uint32_t, most_coefficients> row;  ///< in `values`, for each coefficient

    bool indexed() const { return particles != no_row; }
    bool operator==(const Slot&) const = default;
  };

  struct List {
    std::uint32_t begin, end;
  };

  std::size_t corners = 0, coefficients = 0;
  std::size_t reach = 0;  ///< the most blocks between two corners
  std::vector<std::uint32_t> list_of_block;
  std::vector<List> lists;
  std::vector<Slot> slots;
  AlignedVector<LaneIndex<Real>> particles;  ///< rows of 16, in the engine's order
  AlignedVector<LaneIndex<Real>> elements;   ///< rows of 16 numbers of elements
  AlignedVector<Real> values;                ///< rows of 16 coefficients, equal ones stored once

  const List& list(std::size_t block) const { return lists[list_of_block[block]]; }
  const Real* value_row(const Slot& slot, std::size_t coefficient) const {
    return values.data() + std::size_t(slot.row[coefficient]) * block_size;
  }
  const LaneIndex<Real>* particle_row(const Slot& slot, std::size_t corner) const {
    return particles.data() + (std::size_t(slot.particles) + corner) * block_size;
  }
  const LaneIndex<Real>* element_row(const Slot& slot) const {
    return elements.data() + std::size_t(slot.elements) * block_size;
  }
  /// The particle at a corner of the element of a lane.
  std::size_t particle(std::size_t block, const Slot& slot, std::size_t lane, std::size_t corner) const {
    return slot.indexed() ? std::size_t(particle_row(slot, corner)[lane])
                          : std::size_t(std::int64_t(block * block_size + lane) + slot.shift[corner]);
  }
  bool has_element(const Slot& slot, std::size_t lane) const { return value_row(slot, 0)[lane] != Real(0); }

  std::size_t bytes() const;
};

/// Elements whose first coefficient is zero are left out. `keep_numbers`: each lane knows its element.
template <class Real>
ElementSlots<Real> make_element_slots(const Elements& elements, const Order& order,
                                      bool keep_numbers = false);

/// One corner of one element, as who needs no speed sees it.
template <class Real>
struct ElementCorner {
  std::size_t own;                                  ///< the particle
  std::size_t role;                                 ///< which corner it is
  std::array<std::size_t, most_corners> particles;  ///< of all corners
  std::array<double, most_coefficients> coefficients;
  std::size_t element;  ///< its number, where that is kept
};

/// Calls visit(ElementCorner) for all elements of the particles of the blocks [begin, end).
template <class Real, class Visit>
void for_each_corner(const ElementSlots<Real>& slots, std::size_t begin, std::size_t end,
                     const Visit& visit) {
  for (std::size_t block = begin; block < end; ++block) {
    const auto& list = slots.list(block);
    for (std::uint32_t s = list.begin; s < list.end; ++s) {
      const auto& slot = slots.slots[s];
      for (std::size_t lane = 0; lane < block_size; ++lane) {
        if (!slots.has_element(slot, lane)) continue;
        ElementCorner<Real> corner{block * block_size + lane, slot.role, {}, {}, 0};
        for (std::size_t c = 0; c < slots.corners; ++c)
          corner.particles[c] = slots.particle(block, slot, lane, c);
        for (std::size_t k = 0; k < slots.coefficients; ++k)
          corner.coefficients[k] = double(slots.value_row(slot, k)[lane]);
        if (slot.elements != ElementSlots<Real>::no_row)
          corner.element = std::size_t(slots.element_row(slot)[lane]);
        visit(corner);
      }
    }
  }
}

/// Likewise for those of a strip.
template <class Real, class Visit>
void for_each_corner(const ElementSlots<Real>& slots, const Strip<Real>& strip, const Visit& visit) {
  const std::size_t begin = strip.first / block_size;
  for_each_corner(slots, begin, begin + strip.lanes / block_size, visit);
}

}  // namespace hooke
