#include "effects/remembered_motion.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace hooke {
namespace {

template <class Real>
std::array<const Real*, 6> arrays_of(const State<Real>& state) {
  return {state.x(), state.y(), state.z(), state.vx(), state.vy(), state.vz()};
}

}  // namespace

template <class Real>
RememberedMotion<Real>::RememberedMotion(const std::vector<Index>& particles) {
  for (const Index i : particles) {
    if (runs_.empty() || runs_.back().end != i) runs_.push_back({i, i});
    ++runs_.back().end;
  }
}

template <class Real>
void RememberedMotion<Real>::remember(const State<Real>& state) {
  values_.clear();
  for (const Run& run : runs_) {
    for (const Real* array : arrays_of(state))
      values_.insert(values_.end(), array + run.begin, array + run.end);
  }
  known_ = true;
}

template <class Real>
bool RememberedMotion<Real>::is_of(const State<Real>& state) const {
  if (!known_) return false;
  const Real* value = values_.data();
  for (const Run& run : runs_) {
    const std::size_t count = run.end - run.begin;
    for (const Real* array : arrays_of(state)) {
      if (std::memcmp(array + run.begin, value, count * sizeof(Real)) != 0) return false;
      value += count;
    }
  }
  return true;
}

template <class Real>
std::size_t RememberedMotion<Real>::bytes() const {
  return values_.capacity() * sizeof(Real) + runs_.capacity() * sizeof(Run);
}

template class RememberedMotion<float>;
template class RememberedMotion<double>;

}  // namespace hooke
