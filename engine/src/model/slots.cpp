#include "model/slots.h"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>
#include <string>

#include "model/row_store.h"
#include "model/spring_holders.h"

namespace hooke {
namespace {

using Lanes = std::array<Index, block_size>;

constexpr Index no_spring = ~Index{0};

/// Fewer lanes than this with one shift go into indexed slots, where they share a slot with others: an
/// indexed slot costs about twice a shift slot, but leaves few lanes empty.
constexpr std::size_t least_shift_lanes = 10;

/// As many as offsets in 32 bits lead over.
constexpr std::size_t most_particles = std::size_t{1} << 29;

/// Where no more lanes than this stay empty with shift slots alone, indexed slots are not worth their packed
/// copies of the state.
constexpr double most_empty_lanes = 0.25;

/// One end of a spring at a lane of the block being made.
struct HalfSpring {
  std::int64_t shift;  ///< to the neighbour, in the engine's order
  std::uint32_t lane;
  Index spring;

  auto operator<=>(const HalfSpring&) const = default;
};

/// Lists of slots, equal ones stored once as far as the table remembers them.
template <class Real>
class ListStore {
 public:
  using Slot = typename Slots<Real>::Slot;
  using List = typename Slots<Real>::List;

  /// The number of the list that the slots from `first_shift` on make; they are dropped if it is known.
  std::uint32_t list(std::uint32_t first_shift, std::uint32_t first_indexed) {
    const List made{first_shift, first_indexed, std::uint32_t(slots.size())};
    std::uint32_t& known = table_.place(hash(made));
    if (known != HashTable::none && equal(lists[known], made)) {
      slots.resize(first_shift);
      return known;
    }
    known = std::uint32_t(lists.size());
    lists.push_back(made);
    return known;
  }

  std::vector<Slot> slots;
  std::vector<List> lists;

 private:
  static std::array<std::uint32_t, 4> words(const Slot& slot) {
    return {slot.neighbours, slot.stiffness, slot.half_pull, slot.quarter_damping};
  }

  std::uint64_t hash(const List& list) const {
    std::uint64_t hash = list.first_indexed - list.first_shift;
    for (std::uint32_t s = list.first_shift; s < list.end; ++s) {
      for (std::uint32_t word : words(slots[s])) hash = HashTable::mix(hash, word);
    }
    return hash;
  }

  bool equal(const List& a, const List& b) const {
    return a.end - a.first_shift == b.end - b.first_shift &&
           a.first_indexed - a.first_shift == b.first_indexed - b.first_shift &&
           std::equal(slots.begin() + a.first_shift, slots.begin() + a.end, slots.begin() + b.first_shift,
                      [](const Slot& left, const Slot& right) { return words(left) == words(right); });
  }

  HashTable table_;
};

/// Makes the slots of a run of blocks, with rows numbered from zero.
template <class Real>
class SlotMaker {
 public:
  /// A spring is in a slot at the end in `holders`, or at both where that is empty. With `only_shifts` every
  /// spring gets into a shift slot, however few lanes it fills.
  SlotMaker(const Springs& springs, const Adjacency& adjacency, const Order& order,
            const std::vector<Index>& holders, bool only_shifts)
      : springs_(springs),
        adjacency_(adjacency),
        order_(order),
        holders_(holders),
        least_lanes_(only_shifts ? 1 : least_shift_lanes) {}

  void add_block(std::size_t block) {
    collect(block);
    const auto first_shift = std::uint32_t(lists.slots.size());
    rest_.clear();
    for (auto begin = halves_.begin(); begin != halves_.end();) {
      const auto end =
          std::find_if(begin, halves_.end(), [&](const auto& h) { return h.shift != begin->shift; });
      add_shift(begin, end);
      begin = end;
    }
    const auto first_indexed = std::uint32_t(lists.slots.size());
    add_indexed();
    list_of_block.push_back(lists.list(first_shift, first_indexed));
  }

  std::vector<std::uint32_t> list_of_block;
  ListStore<Real> lists;
  std::vector<std::int32_t> offsets;
  RowStore<Real> rows;

 private:
  using Iterator = std::vector<HalfSpring>::const_iterator;

  void collect(std::size_t block) {
    halves_.clear();
    const std::size_t first = block * block_size, last = std::min(first + block_size, order_.size());
    for (std::size_t e = first; e < last; ++e) {
      const Index user = order_.user(e);
      for (std::size_t k = adjacency_.begin[user]; k < adjacency_.begin[user + 1]; ++k) {
        const Index spring = adjacency_.springs[k];
        const Index neighbour = order_.engine(other_end(springs_, spring, user));
        if (!holders_.empty() && holders_[spring] != user) continue;
        halves_.push_back({std::int64_t(neighbour) - std::int64_t(e), std::uint32_t(e - first), spring});
      }
    }
    std::sort(halves_.begin(), halves_.end());
  }

  /// Shift slots for the half springs of one shift. Several springs between the same two particles need
  /// several slots.
  void add_shift(Iterator begin, Iterator end) {
    while (begin != end) {
      Lanes lanes;
      lanes.fill(no_spring);
      std::size_t used = 0;
      std::vector<HalfSpring>& again = again_;
      again.clear();
      for (auto half = begin; half != end; ++half) {
        if (lanes[half->lane] != no_spring) {
          again.push_back(*half);
        } else {
          lanes[half->lane] = half->spring;
          ++used;
        }
      }
      // Scattering by vectors goes upwards only, so that the first of a vector's particles always is one.
      const bool backward = !holders_.empty() && begin->shift < 0;
      if (used < least_lanes_ || backward) {
        rest_.insert(rest_.end(), begin, end);
        return;
      }
      typename Slots<Real>::Slot slot{};
      slot.shift = std::int32_t(begin->shift);
      add_slot(slot, lanes);
      repeated_.swap(again);
      begin = repeated_.cbegin();
      end = repeated_.cend();
    }
  }

  /// Indexed slots for what no shift slot took. Springs of one stiffness are kept together where that costs
  /// few slots more: then the row of stiffness is one value, which is stored once, and so is less to read.
  /// Where each spring is in one slot, that never pays: slots are scattered from too, and so cost more.
  void add_indexed() {
    const auto stiffness = [this](const HalfSpring& half) { return springs_.stiffness[half.spring]; };
    std::stable_sort(rest_.begin(), rest_.end(),
                     [](const auto& a, const auto& b) { return a.lane < b.lane; });
    by_stiffness_ = rest_;
    std::stable_sort(by_stiffness_.begin(), by_stiffness_.end(),
                     [&](const auto& a, const auto& b) { return stiffness(a) < stiffness(b); });
    std::size_t slots_by_stiffness = 0;
    groups_.assign(1, 0);
    for (auto begin = by_stiffness_.cbegin(); begin != by_stiffness_.cend();) {
      const auto end = std::find_if(begin, by_stiffness_.cend(),
                                    [&](const auto& h) { return stiffness(h) != stiffness(*begin); });
      slots_by_stiffness += depth(begin, end);
      groups_.push_back(std::size_t(end - by_stiffness_.cbegin()));
      begin = end;
    }
    const bool scattered = !holders_.empty();
    if (scattered || 4 * slots_by_stiffness > 5 * depth(rest_.cbegin(), rest_.cend())) {
      add_levels(rest_.cbegin(), rest_.cend(), false);
      return;
    }
    for (std::size_t g = 0; g + 1 < groups_.size(); ++g) {
      add_levels(by_stiffness_.cbegin() + std::ptrdiff_t(groups_[g]),
                 by_stiffness_.cbegin() + std::ptrdiff_t(groups_[g + 1]), true);
    }
  }

  using LaneBegins = std::array<std::size_t, block_size + 1>;

  /// Where each lane's half springs begin in a range that is sorted by lane.
  static LaneBegins lane_begins(Iterator first, Iterator last) {
    LaneBegins begin{};
    for (auto half = first; half != last; ++half) ++begin[half->lane + 1];
    for (std::size_t lane = 0; lane < block_size; ++lane) begin[lane + 1] += begin[lane];
    return begin;
  }

  /// The most half springs that a lane has.
  static std::size_t depth(Iterator first, Iterator last) {
    const LaneBegins begin = lane_begins(first, last);
    std::size_t most = 0;
    for (std::size_t lane = 0; lane < block_size; ++lane)
      most = std::max(most, begin[lane + 1] - begin[lane]);
    return most;
  }

  /// Slots for half springs that are sorted by lane: each takes the next one of every lane. Where all have
  /// one stiffness, lanes without a spring get it too: their distance of zero makes the force zero.
  void add_levels(Iterator first, Iterator last, bool one_stiffness) {
    const LaneBegins begin = lane_begins(first, last);
    const std::size_t levels = depth(first, last);
    for (std::size_t level = 0; level < levels; ++level) {
      Lanes lanes;
      lanes.fill(no_spring);
      typename Slots<Real>::Slot slot{};
      slot.neighbours = std::uint32_t(offsets.size() / block_size);
      for (std::size_t lane = 0; lane < block_size; ++lane) {
        // An empty lane is its own neighbour; past the last particle that is a padding particle, at rest at
        // zero.
        std::int64_t neighbour = std::int64_t(lane);
        if (begin[lane] + level < begin[lane + 1]) {
          const HalfSpring& half = first[std::ptrdiff_t(begin[lane] + level)];
          neighbour += half.shift;
          lanes[lane] = half.spring;
        }
        offsets.push_back(std::int32_t(neighbour) * offsets_of_particle<Real>);
      }
      add_slot(slot, lanes, one_stiffness ? Real(springs_.stiffness[first->spring]) : Real(0));
    }
  }

  void add_slot(typename Slots<Real>::Slot slot, const Lanes& lanes, Real empty_stiffness = Real(0)) {
    std::array<Real, block_size> stiffness, half_pull{}, quarter_damping{};
    stiffness.fill(empty_stiffness);
    for (std::size_t lane = 0; lane < block_size; ++lane) {
      const Index spring = lanes[lane];
      if (spring == no_spring) continue;
      stiffness[lane] = Real(springs_.stiffness[spring]);
      half_pull[lane] = Real(springs_.stiffness[spring] * springs_.rest_length[spring] / 2);
      quarter_damping[lane] = Real(springs_.damping_of(spring) / 4);
    }
    slot.stiffness = rows.row(stiffness);
    slot.half_pull = rows.row(half_pull);
    slot.quarter_damping = springs_.damping.empty() ? 0 : rows.row(quarter_damping);
    lists.slots.push_back(slot);
  }

  const Springs& springs_;
  const Adjacency& adjacency_;
  const Order& order_;
  const std::vector<Index>& holders_;
  std::size_t least_lanes_;
  std::vector<HalfSpring> halves_, rest_, by_stiffness_, again_, repeated_;
  std::vector<std::size_t> groups_;
};

/// Appends what was made of one run of blocks to the whole, with its rows, slots and lists numbered on.
template <class Real>
void append(Slots<Real>& whole, const SlotMaker<Real>& run) {
  const auto first_slot = std::uint32_t(whole.slots.size());
  const auto first_list = std::uint32_t(whole.lists.size());
  const auto first_row = std::uint32_t(whole.values.size() / block_size);
  const auto first_neighbours = std::uint32_t(whole.long_offsets.size() / block_size);
  for (auto slot : run.lists.slots) {
    slot.stiffness += first_row;
    slot.half_pull += first_row;
    slot.quarter_damping += first_row;
    whole.slots.push_back(slot);
  }
  for (const auto& list : run.lists.lists) {
    whole.lists.push_back(
        {first_slot + list.first_shift, first_slot + list.first_indexed, first_slot + list.end});
    for (std::uint32_t s = whole.lists.back().first_indexed; s < whole.lists.back().end; ++s)
      whole.slots[s].neighbours += first_neighbours;
  }
  for (std::uint32_t list : run.list_of_block) whole.list_of_block.push_back(first_list + list);
  whole.long_offsets.insert(whole.long_offsets.end(), run.offsets.begin(), run.offsets.end());
  whole.values.insert(whole.values.end(), run.rows.values.begin(), run.rows.values.end());
}

template <class Real>
void reserve(Slots<Real>& whole, const std::vector<SlotMaker<Real>>& runs) {
  std::size_t blocks = 0, lists = 0, slots = 0, offsets = 0, values = 0;
  for (const SlotMaker<Real>& run : runs) {
    blocks += run.list_of_block.size();
    lists += run.lists.lists.size();
    slots += run.lists.slots.size();
    offsets += run.offsets.size();
    values += run.rows.values.size();
  }
  whole.list_of_block.reserve(blocks);
  whole.lists.reserve(lists);
  whole.slots.reserve(slots);
  whole.long_offsets.reserve(offsets);
  whole.values.reserve(values);
}

/// Halves the offsets where all are short enough: they are a third of what an irregular mesh reads.
template <class Real>
void shorten_offsets(Slots<Real>& slots) {
  using Short = std::numeric_limits<std::int16_t>;
  const auto fits = [](std::int32_t offset) { return offset >= Short::min() && offset <= Short::max(); };
  if (!std::all_of(slots.long_offsets.begin(), slots.long_offsets.end(), fits)) return;
  slots.short_offsets.assign(slots.long_offsets.begin(), slots.long_offsets.end());
  AlignedVector<std::int32_t>().swap(slots.long_offsets);
}

template <class Real>
Slots<Real> make_slots(const Springs& springs, const Adjacency& adjacency, const Order& order,
                       Executor& executor, const std::vector<Index>& holders, bool only_shifts) {
  // Runs of a fixed length, so that the layout does not depend on the number of threads.
  constexpr std::size_t blocks_in_run = 1024;
  const std::size_t blocks = block_count(order.size());
  const std::size_t run_count = (blocks + blocks_in_run - 1) / blocks_in_run;
  std::vector<SlotMaker<Real>> runs(run_count,
                                    SlotMaker<Real>(springs, adjacency, order, holders, only_shifts));
  executor.parallel_for(run_count, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t run = begin; run < end; ++run) {
      const std::size_t last = std::min(blocks, (run + 1) * blocks_in_run);
      for (std::size_t b = run * blocks_in_run; b < last; ++b) runs[run].add_block(b);
    }
  });
  Slots<Real> slots;
  slots.damped = !springs.damping.empty();
  slots.ends = holders.empty() ? SpringEnds::both : SpringEnds::one;
  reserve(slots, runs);
  for (const SlotMaker<Real>& run : runs) append(slots, run);
  shorten_offsets(slots);
  return slots;
}

}  // namespace

template <class Real>
Slots<Real> make_slots(const Springs& springs, const Adjacency& adjacency, const Order& order,
                       Executor& executor, SpringEnds ends) {
  std::vector<Index> holders;
  if (ends == SpringEnds::one) holders = spring_holders(springs, adjacency, order);
  if (order.size() > most_particles) {
    throw std::length_error("there are " + std::to_string(order.size()) +
                            " particles with springs; use at most " + std::to_string(most_particles));
  }
  if (order.is_identity()) {
    Slots<Real> slots = make_slots<Real>(springs, adjacency, order, executor, holders, true);
    if (count_slots(slots, adjacency.spring_count()).empty_share() <= most_empty_lanes) return slots;
  }
  return make_slots<Real>(springs, adjacency, order, executor, holders, false);
}

template <class Real>
std::size_t Slots<Real>::bytes() const {
  return list_of_block.capacity() * sizeof(std::uint32_t) + short_offsets.capacity() * sizeof(std::int16_t) +
         long_offsets.capacity() * sizeof(std::int32_t) + lists.capacity() * sizeof(List) +
         slots.capacity() * sizeof(Slot) + values.capacity() * sizeof(Real);
}

template <class Real>
SlotCount count_slots(const Slots<Real>& slots, std::size_t springs) {
  SlotCount count;
  for (std::uint32_t number : slots.list_of_block) {
    const auto& list = slots.lists[number];
    count.slots += list.end - list.first_shift;
    count.shift_slots += list.first_indexed - list.first_shift;
  }
  count.empty_lanes = count.slots * block_size - std::size_t(slots.ends) * springs;
  return count;
}

template SlotCount count_slots(const Slots<float>&, std::size_t);
template SlotCount count_slots(const Slots<double>&, std::size_t);
template struct Slots<float>;
template struct Slots<double>;
template Slots<float> make_slots(const Springs&, const Adjacency&, const Order&, Executor&, SpringEnds);
template Slots<double> make_slots(const Springs&, const Adjacency&, const Order&, Executor&, SpringEnds);

}  // namespace hooke
