#include "model/slots.h"

#include <algorithm>
#include <array>
#include <functional>

namespace hooke {
namespace {

using Lanes = std::array<Index, block_size>;

constexpr Index no_spring = ~Index{0};

/// Fewer lanes than this with one shift go into indexed slots, where they share a slot with others: an
/// indexed slot costs about three times a shift slot, but leaves few lanes empty.
constexpr std::size_t least_shift_lanes = 6;

/// One end of a spring at a lane of the block being made.
struct HalfSpring {
  std::int64_t shift;  ///< to the neighbour, in the engine's order
  std::uint32_t lane;
  Index spring;

  auto operator<=>(const HalfSpring&) const = default;
};

/// Rows of 16 values, equal ones stored once as far as a small table remembers them.
template <class Real>
class RowStore {
 public:
  std::uint32_t row(const std::array<Real, block_size>& lanes) {
    std::uint32_t& known = table_[hash(lanes) % table_.size()];
    if (known != none && std::equal(lanes.begin(), lanes.end(), &values[std::size_t(known) * block_size])) {
      return known;
    }
    known = std::uint32_t(values.size() / block_size);
    values.insert(values.end(), lanes.begin(), lanes.end());
    return known;
  }

  std::vector<Real> values;

 private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  static std::size_t hash(const std::array<Real, block_size>& lanes) {
    std::uint64_t h = 0;
    for (Real lane : lanes) h = (h ^ std::hash<Real>{}(lane)) * 0x9E3779B97F4A7C15u;
    return h >> 40;
  }

  std::vector<std::uint32_t> table_ = std::vector<std::uint32_t>(4096, none);
};

/// Makes the slots of a run of blocks, with rows numbered from zero.
template <class Real>
class SlotMaker {
 public:
  SlotMaker(const Springs& springs, const Adjacency& adjacency, const Order& order)
      : springs_(springs), adjacency_(adjacency), order_(order) {}

  void add_block(std::size_t block) {
    collect(block);
    first_shift.push_back(std::uint32_t(slots.size()));
    rest_.clear();
    for (auto begin = halves_.begin(); begin != halves_.end();) {
      const auto end =
          std::find_if(begin, halves_.end(), [&](const auto& h) { return h.shift != begin->shift; });
      add_shift(begin, end);
      begin = end;
    }
    first_indexed.push_back(std::uint32_t(slots.size()));
    add_indexed(block);
  }

  std::vector<std::uint32_t> first_shift, first_indexed;
  std::vector<typename Slots<Real>::Slot> slots;
  std::vector<Index> neighbours;
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
      if (used < least_shift_lanes) {
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

  /// Indexed slots for what no shift slot took: each takes the next spring of every lane.
  void add_indexed(std::size_t block) {
    std::stable_sort(rest_.begin(), rest_.end(),
                     [](const auto& a, const auto& b) { return a.lane < b.lane; });
    std::array<std::size_t, block_size + 1> begin{};
    for (const HalfSpring& half : rest_) ++begin[half.lane + 1];
    std::size_t depth = *std::max_element(begin.begin(), begin.end());
    for (std::size_t lane = 0; lane < block_size; ++lane) begin[lane + 1] += begin[lane];
    for (std::size_t level = 0; level < depth; ++level) {
      Lanes lanes;
      lanes.fill(no_spring);
      typename Slots<Real>::Slot slot{};
      slot.neighbours = std::uint32_t(neighbours.size() / block_size);
      for (std::size_t lane = 0; lane < block_size; ++lane) {
        // An empty lane is its own neighbour; past the last particle that is a padding particle, at rest at
        // zero.
        std::int64_t neighbour = std::int64_t(block * block_size + lane);
        if (begin[lane] + level < begin[lane + 1]) {
          const HalfSpring& half = rest_[begin[lane] + level];
          neighbour += half.shift;
          lanes[lane] = half.spring;
        }
        neighbours.push_back(Index(neighbour));
      }
      add_slot(slot, lanes);
    }
  }

  void add_slot(typename Slots<Real>::Slot slot, const Lanes& lanes) {
    std::array<Real, block_size> stiffness{}, rest_length{}, damping{};
    for (std::size_t lane = 0; lane < block_size; ++lane) {
      if (lanes[lane] == no_spring) continue;
      stiffness[lane] = Real(springs_.stiffness[lanes[lane]]);
      rest_length[lane] = Real(springs_.rest_length[lanes[lane]]);
      damping[lane] = Real(springs_.damping_of(lanes[lane]));
    }
    slot.stiffness = rows.row(stiffness);
    slot.rest_length = rows.row(rest_length);
    slot.damping = springs_.damping.empty() ? 0 : rows.row(damping);
    slots.push_back(slot);
  }

  const Springs& springs_;
  const Adjacency& adjacency_;
  const Order& order_;
  std::vector<HalfSpring> halves_, rest_, again_, repeated_;
};

/// Appends what was made of one run of blocks to the whole, with its rows and slots numbered on.
template <class Real>
void append(Slots<Real>& whole, SlotMaker<Real>& run) {
  const auto first_slot = std::uint32_t(whole.slots.size());
  const auto first_row = std::uint32_t(whole.values.size() / block_size);
  const auto first_neighbours = std::uint32_t(whole.neighbours.size() / block_size);
  for (std::size_t b = 0; b < run.first_shift.size(); ++b) {
    whole.first_shift.push_back(first_slot + run.first_shift[b]);
    whole.first_indexed.push_back(first_slot + run.first_indexed[b]);
    const std::size_t end = b + 1 < run.first_shift.size() ? run.first_shift[b + 1] : run.slots.size();
    for (std::size_t s = run.first_indexed[b]; s < end; ++s) run.slots[s].neighbours += first_neighbours;
  }
  for (auto slot : run.slots) {
    slot.stiffness += first_row;
    slot.rest_length += first_row;
    slot.damping += first_row;
    whole.slots.push_back(slot);
  }
  whole.neighbours.insert(whole.neighbours.end(), run.neighbours.begin(), run.neighbours.end());
  whole.values.insert(whole.values.end(), run.rows.values.begin(), run.rows.values.end());
}

template <class Real>
void reserve(Slots<Real>& whole, const std::vector<SlotMaker<Real>>& runs) {
  std::size_t blocks = 0, slots = 0, neighbours = 0, values = 0;
  for (const SlotMaker<Real>& run : runs) {
    blocks += run.first_shift.size();
    slots += run.slots.size();
    neighbours += run.neighbours.size();
    values += run.rows.values.size();
  }
  whole.first_shift.reserve(blocks + 1);
  whole.first_indexed.reserve(blocks);
  whole.slots.reserve(slots);
  whole.neighbours.reserve(neighbours);
  whole.values.reserve(values);
}

}  // namespace

template <class Real>
Slots<Real> make_slots(const Springs& springs, const Adjacency& adjacency, const Order& order,
                       Executor& executor) {
  // Runs of a fixed length, so that the layout does not depend on the number of threads.
  constexpr std::size_t blocks_in_run = 1024;
  const std::size_t blocks = block_count(order.size());
  const std::size_t run_count = (blocks + blocks_in_run - 1) / blocks_in_run;
  std::vector<SlotMaker<Real>> runs(run_count, SlotMaker<Real>(springs, adjacency, order));
  executor.parallel_for(run_count, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t run = begin; run < end; ++run) {
      const std::size_t last = std::min(blocks, (run + 1) * blocks_in_run);
      for (std::size_t b = run * blocks_in_run; b < last; ++b) runs[run].add_block(b);
    }
  });
  Slots<Real> slots;
  slots.damped = !springs.damping.empty();
  reserve(slots, runs);
  for (SlotMaker<Real>& run : runs) append(slots, run);
  slots.first_shift.push_back(std::uint32_t(slots.slots.size()));
  return slots;
}

template <class Real>
std::size_t Slots<Real>::shift_slots() const {
  return slots.size() - neighbours.size() / block_size;
}

template <class Real>
std::size_t Slots<Real>::bytes() const {
  return (first_shift.capacity() + first_indexed.capacity()) * sizeof(std::uint32_t) +
         slots.capacity() * sizeof(Slot) + neighbours.capacity() * sizeof(Index) +
         values.capacity() * sizeof(Real);
}

template struct Slots<float>;
template struct Slots<double>;
template Slots<float> make_slots(const Springs&, const Adjacency&, const Order&, Executor&);
template Slots<double> make_slots(const Springs&, const Adjacency&, const Order&, Executor&);

}  // namespace hooke
