#include "collide/grain_pairs.h"

#include <algorithm>
#include <utility>

#include <hooke/pair_memory.h>

namespace hooke {
namespace {

/// Groups of grains that one thread takes at a time.
constexpr std::size_t groups_at_once = 8;

/// Of the smallest radius: the more, the longer pairs hold, and the more of them there are.
constexpr double margin_of_radius = 0.3;

/// What is so many margins away counts as far.
constexpr double far_margins = 16.0;

}  // namespace

std::vector<Index> sorted_places(const std::vector<Grain>& grains) {
  std::vector<Index> places;
  for (const Grain& grain : grains) places.push_back(grain.place);
  std::sort(places.begin(), places.end());
  return places;
}

template <class Real>
GrainPairs<Real>::GrainPairs(std::vector<Grain> grains, std::size_t particles,
                             std::vector<std::pair<Index, Index>> apart)
    : grains_(std::move(grains)), apart_(std::move(apart)), bound_(sorted_places(grains_)) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Grain& grain : grains_) {
    largest_ = std::max(largest_, grain.radius);
    smallest = std::min(smallest, grain.radius);
  }
  margin_ = grains_.empty() ? 0.0 : margin_of_radius * smallest;
  boxes_.resize(grains_.size());
  begin_.assign(particles + 1, 0);
}

template <class Real>
std::span<const GrainPair> GrainPairs<Real>::find(const State<Real>& state, Executor& executor) {
  // Not so where something is not finite: such a step is not taken.
  const bool hold = known_ && bound_.since(state, state, margin_, executor) <= margin_;
  if (!hold) find_anew(state, executor);
  return pairs_;
}

template <class Real>
void GrainPairs<Real>::find_anew(const State<Real>& state, Executor& executor) {
  pairs_.clear();
  known_ = std::all_of(grains_.begin(), grains_.end(),
                       [&](const Grain& grain) { return state.position(grain.place).allFinite(); });
  if (known_) {
    const double far = 2.0 * largest_ + far_margins * margin_;
    bound_.look(state, state, 1.0);
    bound_.choose_near(far, far - 2.0 * largest_);
    for (std::size_t g = 0; g < grains_.size(); ++g) {
      boxes_[g] = {};
      boxes_[g].widen(state.position(grains_[g].place).template cast<double>());
      boxes_[g].grow(grains_[g].radius + 0.5 * margin_);
    }
    tree_.build(boxes_, BoxFrame(boxes_), executor);
    runs_.resize(tree_.groups());
    executor.parallel_for(runs_.size(), groups_at_once, [&](std::size_t begin, std::size_t end) {
      for (std::size_t g = begin; g < end; ++g) {
        runs_[g].found.clear();
        const std::span<const Index> group = tree_.group(g);
        tree_.for_each_meeting(tree_, g, runs_[g].near, [&](std::size_t place, Index other) {
          if (other > group[place]) add_if_near(group[place], other, runs_[g].found);
        });
      }
    });
    for (const Run& run : runs_) pairs_.insert(pairs_.end(), run.found.begin(), run.found.end());
    std::sort(pairs_.begin(), pairs_.end(), PairOrder{});
  }
  list_by_place();
}

template <class Real>
void GrainPairs<Real>::add_if_near(std::size_t grain, std::size_t other,
                                   std::vector<GrainPair>& found) const {
  const Grain &a = grains_[grain], &b = grains_[other];
  const double reach = a.radius + b.radius, near = reach + margin_;
  const auto middle = [&](std::size_t g) { return Vec3(0.5 * (boxes_[g].low + boxes_[g].high)); };
  if ((middle(grain) - middle(other)).squaredNorm() > near * near) return;
  if (std::binary_search(apart_.begin(), apart_.end(), std::pair(a.particle, b.particle))) return;
  found.push_back({a.particle, b.particle, a.place, b.place, reach});
}

template <class Real>
void GrainPairs<Real>::list_by_place() {
  std::fill(begin_.begin(), begin_.end(), std::size_t(0));
  for (const GrainPair& pair : pairs_) {
    ++begin_[pair.first_place];
    ++begin_[pair.second_place];
  }
  std::size_t sum = 0;
  for (std::size_t& begin : begin_) begin = sum += begin;
  of_.resize(2 * pairs_.size());
  for (std::size_t p = pairs_.size(); p-- > 0;) {
    of_[--begin_[pairs_[p].first_place]] = {Index(p), false};
    of_[--begin_[pairs_[p].second_place]] = {Index(p), true};
  }
}

template <class Real>
std::size_t GrainPairs<Real>::bytes() const {
  std::size_t found = pairs_.capacity();
  for (const Run& run : runs_) found += run.found.capacity();
  return found * sizeof(GrainPair) + of_.capacity() * sizeof(PairOfGrain) +
         begin_.capacity() * sizeof(std::size_t) + boxes_.capacity() * sizeof(AxisBox) + tree_.bytes() +
         bound_.bytes() + grains_.capacity() * sizeof(Grain) + apart_.capacity() * sizeof(apart_[0]);
}

template class GrainPairs<float>;
template class GrainPairs<double>;

}  // namespace hooke
