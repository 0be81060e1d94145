#include "kernels/gather_derivative.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/gather_derivative.cpp"
#include <hwy/foreach_target.h>

#include "kernels/slot_reader-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

/// What a sum of derivatives is made with. Dampers are read in any case, also where no spring has one, and
/// count nothing then: to leave them out gains 3 to 6 % of a product, and makes twice the code.
template <class Real, class D = hn::CappedTag<Real, block_size>, class V = hn::Vec<D>>
struct Weights {
  V of_stiffness, of_damping, least_across;

  Weights(const Slots<Real>& slots, const DerivativeWeights<Real>& weights, PressedSprings pressed)
      : of_stiffness(hn::Set(D(), weights.stiffness)),
        of_damping(hn::Set(D(), slots.damped ? weights.damping : Real(0))),
        least_across(hn::Set(
            D(), pressed == PressedSprings::no_push ? Real(0) : std::numeric_limits<Real>::lowest())) {}
};

/// The weighted derivative of springs: across I + along u u^T, with u twice the unit vector along the spring,
/// or zero where both ends are at one place.
template <class V>
struct SpringDerivative {
  V across, along;
  Vector3<V> twice_unit;
};

/// With r = 2 / l: k l0 / l = half_pull r, and u = r d.
template <class D, class Ends, class V = hn::Vec<D>, class Real = hn::TFromD<D>>
HWY_INLINE SpringDerivative<V> derivative(D d, const Ends& own, const Ends& other, const SpringRows<V>& rows,
                                          const Weights<Real>& weights) {
  const Vector3<V> apart = own.position - other.position;
  const V tiny = hn::Set(d, std::numeric_limits<Real>::min());
  const V square =
      hn::MulAdd(apart.x, apart.x, hn::MulAdd(apart.y, apart.y, hn::MulAdd(apart.z, apart.z, tiny)));
  const TwiceReciprocalRoot<V> root = twice_reciprocal_root(d, square);
  const V twice_inverse = hn::Mul(root.estimate, root.correction);
  V across = hn::NegMulAdd(rows.half_pull, twice_inverse, rows.stiffness);
  across = hn::Max(across, weights.least_across);
  const V quarter = hn::Set(d, Real(0.25));
  V along = hn::Mul(hn::Mul(quarter, weights.of_stiffness), hn::Sub(rows.stiffness, across));
  along = hn::MulAdd(weights.of_damping, rows.quarter_damping, along);
  return {
      hn::Mul(weights.of_stiffness, across),
      along,
      {hn::Mul(apart.x, twice_inverse), hn::Mul(apart.y, twice_inverse), hn::Mul(apart.z, twice_inverse)}};
}

template <std::size_t vectors, class Reader, class List, class Real, class V = typename Reader::V>
HWY_INLINE void multiply(const Reader& reader, const List& list, std::size_t first, std::size_t lane,
                         const Weights<Real>& weights, Vector3<V>* HWY_RESTRICT sums) {
  const typename Reader::D d;
  Vector3<V> sum[vectors];
  for (std::size_t v = 0; v < vectors; ++v) sum[v] = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
  const auto add = [&](std::size_t v, const auto& own, const auto& other, const auto& rows) HWY_ATTR {
    const auto spring = derivative(d, own, other, rows, weights);
    const Vector3<V> p = own.velocity - other.velocity;
    const Vector3<V>& u = spring.twice_unit;
    const V along = hn::Mul(spring.along, dot(p, u));
    sum[v] = {hn::MulAdd(spring.across, p.x, hn::MulAdd(along, u.x, sum[v].x)),
              hn::MulAdd(spring.across, p.y, hn::MulAdd(along, u.y, sum[v].y)),
              hn::MulAdd(spring.across, p.z, hn::MulAdd(along, u.z, sum[v].z))};
  };
  for_each_spring<vectors>(reader, list, first, lane, add);
  for (std::size_t v = 0; v < vectors; ++v) sums[v] = sum[v];
}

template <class V>
struct Symmetric3 {
  V xx, xy, xz, yy, yz, zz;
};

template <std::size_t vectors, class Reader, class List, class Real, class V = typename Reader::V>
HWY_INLINE void diagonal(const Reader& reader, const List& list, std::size_t first, std::size_t lane,
                         const Weights<Real>& weights, Symmetric3<V>* HWY_RESTRICT sums) {
  const typename Reader::D d;
  const V zero = hn::Zero(d);
  Symmetric3<V> sum[vectors];
  for (std::size_t v = 0; v < vectors; ++v) sum[v] = {zero, zero, zero, zero, zero, zero};
  const auto add = [&](std::size_t v, const auto& own, const auto& other, const auto& rows) HWY_ATTR {
    const auto spring = derivative(d, own, other, rows, weights);
    const Vector3<V>& u = spring.twice_unit;
    const V x = hn::Mul(spring.along, u.x), y = hn::Mul(spring.along, u.y), z = hn::Mul(spring.along, u.z);
    Symmetric3<V>& s = sum[v];
    s = {hn::Add(s.xx, hn::MulAdd(x, u.x, spring.across)),
         hn::MulAdd(x, u.y, s.xy),
         hn::MulAdd(x, u.z, s.xz),
         hn::Add(s.yy, hn::MulAdd(y, u.y, spring.across)),
         hn::MulAdd(y, u.z, s.yz),
         hn::Add(s.zz, hn::MulAdd(z, u.z, spring.across))};
  };
  for_each_spring<vectors>(reader, list, first, lane, add);
  for (std::size_t v = 0; v < vectors; ++v) sums[v] = sum[v];
}

template <class Real>
void product_of_blocks(const Slots<Real>& slots, const State<Real>& state, std::size_t begin, std::size_t end,
                       const DerivativeWeights<Real>& weights, PressedSprings pressed,
                       StripForce<Real>& product) {
  const Weights<Real> all(slots, weights, pressed);
  with_reader_of<true, true>(slots, state, [&](const auto& reader) HWY_ATTR {
    using Reader = std::remove_cvref_t<decltype(reader)>;
    const typename Reader::D d;
    const auto of_list = [&]<std::size_t vectors>(const auto& list, std::size_t first, std::size_t lane)
                             HWY_ATTR {
                               Vector3<typename Reader::V> sums[vectors];
                               multiply<vectors>(reader, list, first, lane, all, sums);
                               for (std::size_t v = 0; v < vectors; ++v) {
                                 const std::size_t out = first - begin * block_size + v * block_size;
                                 hn::Store(sums[v].x, d, product.x + out);
                                 hn::Store(sums[v].y, d, product.y + out);
                                 hn::Store(sums[v].z, d, product.z + out);
                               }
                             };
    for_each_vector_of_blocks(slots, begin, end, of_list);
  });
}

template <class Real>
void diagonal_of_blocks(const Slots<Real>& slots, const State<Real>& state, std::size_t begin,
                        std::size_t end, const DerivativeWeights<Real>& weights, PressedSprings pressed,
                        StripBlocks<Real>& blocks) {
  const Weights<Real> all(slots, weights, pressed);
  with_reader_of<true, true>(slots, state, [&](const auto& reader) HWY_ATTR {
    using Reader = std::remove_cvref_t<decltype(reader)>;
    const typename Reader::D d;
    const auto of_list = [&]<std::size_t vectors>(const auto& list, std::size_t first, std::size_t lane)
                             HWY_ATTR {
                               Symmetric3<typename Reader::V> sums[vectors];
                               diagonal<vectors>(reader, list, first, lane, all, sums);
                               for (std::size_t v = 0; v < vectors; ++v) {
                                 const std::size_t out = first - begin * block_size + v * block_size;
                                 hn::Store(sums[v].xx, d, blocks.xx + out);
                                 hn::Store(sums[v].xy, d, blocks.xy + out);
                                 hn::Store(sums[v].xz, d, blocks.xz + out);
                                 hn::Store(sums[v].yy, d, blocks.yy + out);
                                 hn::Store(sums[v].yz, d, blocks.yz + out);
                                 hn::Store(sums[v].zz, d, blocks.zz + out);
                               }
                             };
    for_each_vector_of_blocks(slots, begin, end, of_list);
  });
}

}  // namespace

void product_float(const Slots<float>& slots, const State<float>& state, std::size_t begin, std::size_t end,
                   const DerivativeWeights<float>& weights, PressedSprings pressed,
                   StripForce<float>& product) {
  product_of_blocks(slots, state, begin, end, weights, pressed, product);
}

void product_double(const Slots<double>& slots, const State<double>& state, std::size_t begin,
                    std::size_t end, const DerivativeWeights<double>& weights, PressedSprings pressed,
                    StripForce<double>& product) {
  product_of_blocks(slots, state, begin, end, weights, pressed, product);
}

void diagonal_float(const Slots<float>& slots, const State<float>& state, std::size_t begin, std::size_t end,
                    const DerivativeWeights<float>& weights, PressedSprings pressed,
                    StripBlocks<float>& blocks) {
  diagonal_of_blocks(slots, state, begin, end, weights, pressed, blocks);
}

void diagonal_double(const Slots<double>& slots, const State<double>& state, std::size_t begin,
                     std::size_t end, const DerivativeWeights<double>& weights, PressedSprings pressed,
                     StripBlocks<double>& blocks) {
  diagonal_of_blocks(slots, state, begin, end, weights, pressed, blocks);
}

}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hooke {
namespace {

HWY_EXPORT(product_float);
HWY_EXPORT(product_double);
HWY_EXPORT(diagonal_float);
HWY_EXPORT(diagonal_double);

}  // namespace

template <>
void gather_product(const Slots<float>& slots, const State<float>& state, std::size_t begin, std::size_t end,
                    const DerivativeWeights<float>& weights, PressedSprings pressed,
                    StripForce<float>& product) {
  HWY_DYNAMIC_DISPATCH(product_float)(slots, state, begin, end, weights, pressed, product);
}

template <>
void gather_product(const Slots<double>& slots, const State<double>& state, std::size_t begin,
                    std::size_t end, const DerivativeWeights<double>& weights, PressedSprings pressed,
                    StripForce<double>& product) {
  HWY_DYNAMIC_DISPATCH(product_double)(slots, state, begin, end, weights, pressed, product);
}

template <>
void gather_diagonal(const Slots<float>& slots, const State<float>& state, std::size_t begin, std::size_t end,
                     const DerivativeWeights<float>& weights, PressedSprings pressed,
                     StripBlocks<float>& blocks) {
  HWY_DYNAMIC_DISPATCH(diagonal_float)(slots, state, begin, end, weights, pressed, blocks);
}

template <>
void gather_diagonal(const Slots<double>& slots, const State<double>& state, std::size_t begin,
                     std::size_t end, const DerivativeWeights<double>& weights, PressedSprings pressed,
                     StripBlocks<double>& blocks) {
  HWY_DYNAMIC_DISPATCH(diagonal_double)(slots, state, begin, end, weights, pressed, blocks);
}

}  // namespace hooke
#endif
