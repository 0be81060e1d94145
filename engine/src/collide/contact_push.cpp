#include "collide/contact_push.h"

#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collide/contact_push.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<double, 4>;
using V = hn::Vec<D>;

/// Four doubles, in as few vectors as hold them.
struct Four {
  static constexpr std::size_t lanes = hn::MaxLanes(D()), parts = 4 / lanes;

  V part[parts];

  static HWY_INLINE Four load(const double* from) {
    Four four;
    for (std::size_t p = 0; p < parts; ++p) four.part[p] = hn::LoadU(D(), from + p * lanes);
    return four;
  }
  HWY_INLINE void store(double* to) const {
    for (std::size_t p = 0; p < parts; ++p) hn::StoreU(part[p], D(), to + p * lanes);
  }
  HWY_INLINE Four times(double factor) const {
    Four product;
    for (std::size_t p = 0; p < parts; ++p) product.part[p] = hn::Mul(part[p], hn::Set(D(), factor));
    return product;
  }
  /// This and so many times another.
  HWY_INLINE Four plus(double factor, const Four& other) const {
    Four sum;
    for (std::size_t p = 0; p < parts; ++p)
      sum.part[p] = hn::MulAdd(hn::Set(D(), factor), other.part[p], part[p]);
    return sum;
  }
  HWY_INLINE double dot(const Four& other) const {
    V sum = hn::Mul(part[0], other.part[0]);
    for (std::size_t p = 1; p < parts; ++p) sum = hn::MulAdd(part[p], other.part[p], sum);
    return hn::GetLane(hn::SumOfLanes(D(), sum));
  }
};

/// What friction holds back of a difference r along the surface, beyond what it has held back so far: all
/// together as much as all pushes together can hold. The fourth value of r is of no meaning and left out.
HWY_INLINE Four hold_back(PackedContact& contact, const Four& r, const Four& normal) {
  alignas(64) static constexpr double three[4] = {1.0, 1.0, 1.0, 0.0};
  const Four moved = r.plus(-1.0, Four::load(contact.held.data())), space = Four::load(three);
  Four along = moved.plus(-moved.dot(normal), normal);
  for (std::size_t p = 0; p < Four::parts; ++p) along.part[p] = hn::Mul(along.part[p], space.part[p]);
  const Four before = Four::load(contact.held_back.data());
  Four all = before.plus(1.0, along);
  const double length = std::sqrt(all.dot(all)), most = contact.friction * contact.pushed;
  if (length > most) all = all.times(most / length);
  all.store(contact.held_back.data());
  return all.plus(-1.0, before);
}

/// Pushes go further than to where the contact is kept, by this factor, as what they push is pushed back by
/// others: a stack of n layers then takes some n sweeps in place of n^2 (Cryer 1971).
constexpr double over_relaxation = 1.5;

HWY_INLINE double push(PackedContact& contact, double* values) {
  double* at[4];
  Four four[4];
  for (std::size_t k = 0; k < 4; ++k) {
    at[k] = values + 4 * std::size_t(contact.places[k]);
    four[k] = Four::load(at[k]);
  }
  Four r = four[0].times(contact.weights[0]);
  for (std::size_t k = 1; k < 4; ++k) r = r.plus(contact.weights[k], four[k]);
  const Four normal = Four::load(contact.normal.data());
  const double lacks = contact.least - r.dot(normal);
  if (contact.pushed == 0.0 && !(lacks > 0.0)) return 0.0;
  const double depth = std::max(over_relaxation * lacks, -contact.pushed);
  contact.pushed += depth;
  Four change = normal.times(depth);
  if (contact.friction > 0.0) change = change.plus(-1.0, hold_back(contact, r, normal));
  for (std::size_t k = 0; k < 4; ++k) {
    const double share = contact.weights[k] * at[k][3] * contact.mass;
    if (share != 0.0) four[k].plus(share, change).store(at[k]);
  }
  return std::abs(depth) / over_relaxation;
}

}  // namespace

double push_all(std::span<PackedContact> contacts, double* values) {
  double most = 0.0;
  for (PackedContact& contact : contacts) most = std::max(most, push(contact, values));
  return most;
}

}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hooke {

HWY_EXPORT(push_all);

double push_contacts(std::span<PackedContact> contacts, PackedValues values) {
  return HWY_DYNAMIC_DISPATCH(push_all)(contacts, values);
}

}  // namespace hooke
#endif
