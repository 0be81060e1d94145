#include "tearing/strained_springs.h"

#include <algorithm>
#include <cmath>

#include "tearing/longest_lengths.h"

namespace hooke {
namespace {

/// Springs that one thread looks at at a time: some microseconds of work.
constexpr std::size_t run_length = 4096;

}  // namespace

template <class Real>
StrainedSprings<Real>::StrainedSprings(const Scene& scene, const Order& order,
                                       std::vector<RelaxingSpring> relaxing)
    : relaxing_(std::move(relaxing)) {
  const std::vector<double> longest = longest_lengths(scene);
  for (std::size_t s = 0; s < longest.size(); ++s) {
    if (std::isinf(longest[s])) continue;
    springs_.push_back({Index(s), order.engine(scene.springs.first[s]), order.engine(scene.springs.second[s]),
                        Real(longest[s] * longest[s])});
    rest_.push_back(scene.springs.rest_length[s]);
    longest_.push_back(longest[s]);
  }
  of_runs_.resize((springs_.size() + run_length - 1) / run_length);
}

template <class Real>
void StrainedSprings<Real>::look_at(std::size_t begin, std::size_t end, const State<Real>& state,
                                    std::vector<Strained>& found) const {
  found.clear();
  for (std::size_t i = begin; i < end; ++i) {
    const Spring& spring = springs_[i];
    const Eigen::Matrix<Real, 3, 1> way = state.position(spring.second) - state.position(spring.first);
    if (!(way.squaredNorm() > spring.longest_square)) continue;
    const double length = way.template cast<double>().norm();
    found.push_back({spring.number, length, (length - rest_[i]) / (longest_[i] - rest_[i])});
  }
}

template <class Real>
void StrainedSprings<Real>::pass_over_relaxing(std::vector<Strained>& found) {
  const auto number_of = [](const auto& one) { return one.number; };
  std::erase_if(relaxing_, [&](const RelaxingSpring& one) {
    const auto at = std::ranges::lower_bound(found, one.spring, {}, number_of);
    if (at == found.end() || at->number != one.spring) return true;  // it has relaxed
    if (at->length <= one.length) found.erase(at);
    return false;
  });
}

template <class Real>
std::vector<Index> StrainedSprings<Real>::find(const State<Real>& state, Executor& executor) {
  executor.parallel_for(of_runs_.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t run = begin; run < end; ++run)
      look_at(run * run_length, std::min((run + 1) * run_length, springs_.size()), state, of_runs_[run]);
  });
  std::vector<Strained> found;
  for (const auto& of_run : of_runs_) found.insert(found.end(), of_run.begin(), of_run.end());
  if (!relaxing_.empty()) pass_over_relaxing(found);
  std::ranges::stable_sort(found, [](const Strained& a, const Strained& b) { return a.excess > b.excess; });
  std::vector<Index> numbers;
  for (const Strained& one : found) numbers.push_back(one.number);
  return numbers;
}

template <class Real>
std::size_t StrainedSprings<Real>::bytes() const {
  return springs_.capacity() * sizeof(Spring) + (rest_.capacity() + longest_.capacity()) * sizeof(double) +
         relaxing_.capacity() * sizeof(RelaxingSpring);
}

template class StrainedSprings<float>;
template class StrainedSprings<double>;

}  // namespace hooke
