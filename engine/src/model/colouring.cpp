#include "model/colouring.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <numeric>

namespace hooke {
namespace {

/// The numbers of the springs, sorted by their lower and then their higher end in the engine's order, so that
/// a loop over them walks through memory.
std::vector<Index> sorted_springs(const Springs& springs, const Order& order) {
  const auto ends = [&](Index s) {
    const Index a = order.engine(springs.first[s]), b = order.engine(springs.second[s]);
    return std::uint64_t(std::min(a, b)) << 32 | std::max(a, b);
  };
  std::vector<Index> numbers(springs.size());
  std::iota(numbers.begin(), numbers.end(), Index{0});
  std::sort(numbers.begin(), numbers.end(), [&](Index a, Index b) {
    const std::uint64_t ends_a = ends(a), ends_b = ends(b);
    return ends_a != ends_b ? ends_a < ends_b : a < b;
  });
  return numbers;
}

template <class Real>
SpringList<Real> make_list(const Springs& springs, const Order& order, const std::vector<Index>& numbers) {
  SpringList<Real> list;
  list.first.reserve(numbers.size());
  list.second.reserve(numbers.size());
  list.stiffness.reserve(numbers.size());
  list.rest_length.reserve(numbers.size());
  if (!springs.damping.empty()) list.damping.reserve(numbers.size());
  for (Index s : numbers) {
    list.first.push_back(order.engine(springs.first[s]));
    list.second.push_back(order.engine(springs.second[s]));
    list.stiffness.push_back(Real(springs.stiffness[s]));
    list.rest_length.push_back(Real(springs.rest_length[s]));
    if (!springs.damping.empty()) list.damping.push_back(Real(springs.damping[s]));
  }
  return list;
}

/// Greedy colouring, 64 colours at a time: a bit for each colour that a particle's springs already have.
class Colouring {
 public:
  Colouring(const Springs& springs, std::size_t particles) : springs_(springs), used_(particles) {}

  /// Sorts `numbers` by colour; the batches' beginnings go to `batch_begin`. Returns whether some were left
  /// without one.
  bool sort(std::vector<Index>& numbers, std::vector<std::size_t>& batch_begin) {
    std::vector<std::vector<Index>> batches;
    for (int round = 0; round < rounds && !numbers.empty(); ++round) take_round(numbers, batches);
    const bool left_over = !numbers.empty();
    if (left_over) batches.push_back(std::move(numbers));
    numbers.clear();
    batch_begin = {0};
    for (const std::vector<Index>& batch : batches) {
      numbers.insert(numbers.end(), batch.begin(), batch.end());
      batch_begin.push_back(numbers.size());
    }
    return left_over;
  }

 private:
  static constexpr int rounds = 4, colours_in_round = 64;

  void take_round(std::vector<Index>& numbers, std::vector<std::vector<Index>>& batches) {
    std::fill(used_.begin(), used_.end(), std::uint64_t{0});
    const std::size_t first = batches.size();
    std::vector<Index> left;
    for (Index s : numbers) {
      std::uint64_t &a = used_[springs_.first[s]], &b = used_[springs_.second[s]];
      const int colour = std::countr_one(a | b);
      if (colour == colours_in_round) {
        left.push_back(s);
        continue;
      }
      a |= std::uint64_t{1} << colour;
      b |= std::uint64_t{1} << colour;
      if (first + std::size_t(colour) >= batches.size()) batches.resize(first + std::size_t(colour) + 1);
      batches[first + std::size_t(colour)].push_back(s);
    }
    numbers = std::move(left);
  }

  const Springs& springs_;
  std::vector<std::uint64_t> used_;  ///< by particle, in the user's numbering
};

}  // namespace

template <class Real>
std::size_t SpringList<Real>::bytes() const {
  return (first.capacity() + second.capacity()) * sizeof(Index) +
         (stiffness.capacity() + rest_length.capacity() + damping.capacity()) * sizeof(Real) +
         batch_begin.capacity() * sizeof(std::size_t);
}

template <class Real>
SpringList<Real> list_springs(const Springs& springs, const Order& order) {
  SpringList<Real> list = make_list<Real>(springs, order, sorted_springs(springs, order));
  list.batch_begin = {0, list.size()};
  return list;
}

template <class Real>
SpringList<Real> colour_springs(const Springs& springs, const Order& order) {
  std::vector<Index> numbers = sorted_springs(springs, order);
  std::vector<std::size_t> batch_begin;
  const bool left_over = Colouring(springs, order.size()).sort(numbers, batch_begin);
  SpringList<Real> list = make_list<Real>(springs, order, numbers);
  list.batch_begin = std::move(batch_begin);
  list.last_batch_serial = left_over;
  return list;
}

template struct SpringList<float>;
template struct SpringList<double>;
template SpringList<float> list_springs(const Springs&, const Order&);
template SpringList<double> list_springs(const Springs&, const Order&);
template SpringList<float> colour_springs(const Springs&, const Order&);
template SpringList<double> colour_springs(const Springs&, const Order&);

}  // namespace hooke
