#include "model/element_slots.h"

#include <algorithm>
#include <bit>

#include "model/row_store.h"

namespace hooke {
namespace {

/// Fewer lanes than this with equal shifts go into indexed slots.
constexpr std::size_t least_shift_lanes = 8;

/// One corner of an element at a lane of the block being made.
struct Corner {
  std::uint32_t role;
  std::array<std::int32_t, most_corners> shift;  ///< from the lane's particle to each corner
  std::uint32_t lane;
  Index element;

  auto operator<=>(const Corner&) const = default;
};

template <class Real>
class ElementSlotMaker {
 public:
  using Slot = typename ElementSlots<Real>::Slot;

  ElementSlotMaker(const Elements& elements, const Order& order, bool keep_numbers)
      : elements_(elements), order_(order), keep_numbers_(keep_numbers) {
    made_.corners = elements.corners;
    made_.coefficients = elements.coefficients;
    find_elements_of_particles();
  }

  ElementSlots<Real> make() {
    for (std::size_t block = 0; block < block_count(order_.size()); ++block) add_block(block);
    made_.values = std::move(rows_.values);
    return std::move(made_);
  }

 private:
  using Iterator = std::vector<Corner>::const_iterator;

  bool has_force(std::size_t element) const {
    return elements_.values[element * elements_.coefficients] != 0.0;
  }

  Index engine(std::size_t element, std::size_t corner) const {
    return order_.engine(elements_.particles[element * elements_.corners + corner]);
  }

  /// For each of the engine's particles the places in elements_.particles where it is a corner.
  void find_elements_of_particles() {
    const std::size_t places = elements_.particles.size();
    begin_.assign(order_.size() + 2, 0);
    for (std::size_t p = 0; p < places; ++p) {
      if (has_force(p / elements_.corners)) ++begin_[order_.engine(elements_.particles[p]) + 2];
    }
    for (std::size_t i = 2; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    places_.resize(begin_.back());
    for (std::size_t p = 0; p < places; ++p) {
      if (has_force(p / elements_.corners)) places_[begin_[order_.engine(elements_.particles[p]) + 1]++] = p;
    }
    begin_.pop_back();
  }

  void add_block(std::size_t block) {
    collect(block);
    const auto first = std::uint32_t(made_.slots.size());
    rest_.clear();
    for (auto begin = corners_.cbegin(); begin != corners_.cend();) {
      const auto end = std::find_if(begin, corners_.cend(), [&](const Corner& c) {
        return c.role != begin->role || c.shift != begin->shift;
      });
      add_shifts(block, begin, end);
      begin = end;
    }
    add_indexed(block);
    made_.list_of_block.push_back(list_from(first));
  }

  void collect(std::size_t block) {
    corners_.clear();
    const std::size_t first = block * block_size, last = std::min(first + block_size, order_.size());
    for (std::size_t own = first; own < last; ++own) {
      for (std::size_t k = begin_[own]; k < begin_[own + 1]; ++k) {
        const std::size_t element = places_[k] / elements_.corners;
        Corner corner{
            std::uint32_t(places_[k] % elements_.corners), {}, std::uint32_t(own - first), Index(element)};
        for (std::size_t c = 0; c < elements_.corners; ++c) {
          const Index particle = engine(element, c);
          corner.shift[c] = std::int32_t(std::int64_t(particle) - std::int64_t(own));
          const std::size_t other = particle / block_size;
          made_.reach = std::max(made_.reach, other > block ? other - block : block - other);
        }
        corners_.push_back(corner);
      }
    }
    std::sort(corners_.begin(), corners_.end());
  }

  /// Whether vector loads of all 16 lanes stay within a state's arrays and the blocks around them.
  bool fits(std::size_t block, const Corner& corner) const {
    const auto first = std::int64_t(block * block_size);
    const auto end = std::int64_t(block_count(order_.size()) * block_size);
    return std::all_of(corner.shift.begin(), corner.shift.begin() + std::ptrdiff_t(elements_.corners),
                       [&](std::int32_t shift) {
                         return first + shift >= -std::int64_t(block_size) && first + shift <= end;
                       });
  }

  /// Shift slots for corners of one role and equal shifts. Equal elements need several slots.
  void add_shifts(std::size_t block, Iterator begin, Iterator end) {
    if (!fits(block, *begin)) {
      rest_.insert(rest_.end(), begin, end);
      return;
    }
    std::vector<Corner> left(begin, end);
    while (left.size() >= least_shift_lanes) {
      Slot slot = new_slot(begin->role);
      slot.shift = begin->shift;
      std::vector<Corner> taken;
      take_one_of_each_lane(left, taken);
      if (taken.size() < least_shift_lanes) {
        left.insert(left.end(), taken.begin(), taken.end());
        break;
      }
      finish(slot, taken);
    }
    rest_.insert(rest_.end(), left.begin(), left.end());
  }

  /// Moves the first corner of each lane.
  static void take_one_of_each_lane(std::vector<Corner>& from, std::vector<Corner>& taken) {
    std::array<bool, block_size> used{};
    std::vector<Corner> left;
    for (const Corner& corner : from) {
      (used[corner.lane] ? left : taken).push_back(corner);
      used[corner.lane] = true;
    }
    from = std::move(left);
  }

  void add_indexed(std::size_t block) {
    for (std::uint32_t role = 0; role < elements_.corners; ++role) {
      std::vector<Corner> left;
      std::copy_if(rest_.begin(), rest_.end(), std::back_inserter(left),
                   [&](const Corner& corner) { return corner.role == role; });
      std::stable_sort(left.begin(), left.end(),
                       [](const Corner& a, const Corner& b) { return a.element < b.element; });
      while (!left.empty()) {
        std::vector<Corner> taken;
        take_one_of_each_lane(left, taken);
        Slot slot = new_slot(role);
        slot.particles = std::uint32_t(made_.particles.size() / block_size);
        for (std::size_t c = 0; c < elements_.corners; ++c) add_particles(block, taken, c);
        finish(slot, taken);
      }
    }
  }

  void add_particles(std::size_t block, const std::vector<Corner>& taken, std::size_t corner) {
    std::array<LaneIndex<Real>, block_size> row;
    for (std::size_t lane = 0; lane < block_size; ++lane)
      row[lane] = LaneIndex<Real>(block * block_size + lane);
    for (const Corner& one : taken) row[one.lane] += one.shift[corner];
    made_.particles.insert(made_.particles.end(), row.begin(), row.end());
  }

  static Slot new_slot(std::uint32_t role) {
    return {role, ElementSlots<Real>::no_row, ElementSlots<Real>::no_row, {}, {}};
  }

  void finish(Slot slot, const std::vector<Corner>& taken) {
    for (std::size_t k = 0; k < elements_.coefficients; ++k) {
      std::array<Real, block_size> lanes{};
      for (const Corner& one : taken)
        lanes[one.lane] = Real(elements_.values[one.element * elements_.coefficients + k]);
      slot.row[k] = rows_.row(lanes);
    }
    if (keep_numbers_) {
      slot.elements = std::uint32_t(made_.elements.size() / block_size);
      std::array<LaneIndex<Real>, block_size> numbers{};
      for (const Corner& one : taken) numbers[one.lane] = LaneIndex<Real>(one.element);
      made_.elements.insert(made_.elements.end(), numbers.begin(), numbers.end());
    }
    made_.slots.push_back(slot);
  }

  /// The number of the list of the slots from `first` on; they are dropped if an equal list is known.
  std::uint32_t list_from(std::uint32_t first) {
    const auto end = std::uint32_t(made_.slots.size());
    std::uint64_t hash = end - first;
    for (std::uint32_t s = first; s < end; ++s) {
      const Slot& slot = made_.slots[s];
      hash = HashTable::mix(HashTable::mix(hash, slot.role), slot.particles);
      for (const std::int32_t shift : slot.shift)
        hash = HashTable::mix(hash, std::bit_cast<std::uint32_t>(shift));
      for (const std::uint32_t row : slot.row) hash = HashTable::mix(hash, row);
    }
    std::uint32_t& known = known_lists_.place(hash);
    if (known != HashTable::none) {
      const auto& list = made_.lists[known];
      const auto begin = made_.slots.begin();
      if (std::equal(begin + list.begin, begin + list.end, begin + first, begin + end)) {
        made_.slots.resize(first);
        return known;
      }
    }
    known = std::uint32_t(made_.lists.size());
    made_.lists.push_back({first, end});
    return known;
  }

  const Elements& elements_;
  const Order& order_;
  bool keep_numbers_;
  std::vector<std::size_t> begin_, places_;
  std::vector<Corner> corners_, rest_;
  RowStore<Real> rows_;
  HashTable known_lists_;
  ElementSlots<Real> made_;
};

}  // namespace

template <class Real>
std::size_t ElementSlots<Real>::bytes() const {
  return list_of_block.capacity() * sizeof(std::uint32_t) + lists.capacity() * sizeof(List) +
         slots.capacity() * sizeof(Slot) +
         (particles.capacity() + elements.capacity()) * sizeof(LaneIndex<Real>) +
         values.capacity() * sizeof(Real);
}

template <class Real>
ElementSlots<Real> make_element_slots(const Elements& elements, const Order& order, bool keep_numbers) {
  return ElementSlotMaker<Real>(elements, order, keep_numbers).make();
}

template struct ElementSlots<float>;
template struct ElementSlots<double>;
template ElementSlots<float> make_element_slots(const Elements&, const Order&, bool);
template ElementSlots<double> make_element_slots(const Elements&, const Order&, bool);

}  // namespace hooke
