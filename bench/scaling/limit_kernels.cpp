#include "scaling/limit_kernels.h"

// Highway compiles this file once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "scaling/limit_kernels.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, as Highway wants it.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hooke::bench {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

double sum_floats(const float* HWY_RESTRICT values, std::size_t count) {
  const hn::ScalableTag<float> d;
  const std::size_t lanes = hn::Lanes(d);
  auto s0 = hn::Zero(d), s1 = s0, s2 = s0, s3 = s0, s4 = s0, s5 = s0, s6 = s0, s7 = s0;
  for (std::size_t i = 0; i < count; i += 8 * lanes) {
    s0 = hn::Add(s0, hn::Load(d, values + i));
    s1 = hn::Add(s1, hn::Load(d, values + i + lanes));
    s2 = hn::Add(s2, hn::Load(d, values + i + 2 * lanes));
    s3 = hn::Add(s3, hn::Load(d, values + i + 3 * lanes));
    s4 = hn::Add(s4, hn::Load(d, values + i + 4 * lanes));
    s5 = hn::Add(s5, hn::Load(d, values + i + 5 * lanes));
    s6 = hn::Add(s6, hn::Load(d, values + i + 6 * lanes));
    s7 = hn::Add(s7, hn::Load(d, values + i + 7 * lanes));
  }
  const auto low = hn::Add(hn::Add(s0, s1), hn::Add(s2, s3));
  const auto high = hn::Add(hn::Add(s4, s5), hn::Add(s6, s7));
  return double(hn::GetLane(hn::SumOfLanes(d, hn::Add(low, high))));
}

/// Twelve chains: two units of a latency of four or five cycles want eight to ten, and sixteen registers hold
/// them. Each starts elsewhere, as the compiler would make one chain of equal ones. Values tend to 1, so none
/// is subnormal.
template <class Real>
MultiplyAdds multiply_add(std::size_t rounds) {
  const hn::ScalableTag<Real> d;
  const auto half = hn::Set(d, Real(0.5));
  const auto start = [&](int chain) { return hn::Set(d, Real(2 + chain)); };
  auto x0 = start(0), x1 = start(1), x2 = start(2), x3 = start(3);
  auto x4 = start(4), x5 = start(5), x6 = start(6), x7 = start(7);
  auto x8 = start(8), x9 = start(9), x10 = start(10), x11 = start(11);
  for (std::size_t i = 0; i < rounds; ++i) {
    x0 = hn::MulAdd(x0, half, half);
    x1 = hn::MulAdd(x1, half, half);
    x2 = hn::MulAdd(x2, half, half);
    x3 = hn::MulAdd(x3, half, half);
    x4 = hn::MulAdd(x4, half, half);
    x5 = hn::MulAdd(x5, half, half);
    x6 = hn::MulAdd(x6, half, half);
    x7 = hn::MulAdd(x7, half, half);
    x8 = hn::MulAdd(x8, half, half);
    x9 = hn::MulAdd(x9, half, half);
    x10 = hn::MulAdd(x10, half, half);
    x11 = hn::MulAdd(x11, half, half);
  }
  const auto low = hn::Add(hn::Add(hn::Add(x0, x1), hn::Add(x2, x3)), hn::Add(x4, x5));
  const auto high = hn::Add(hn::Add(hn::Add(x6, x7), hn::Add(x8, x9)), hn::Add(x10, x11));
  return {double(rounds) * 12.0 * 2.0 * double(hn::Lanes(d)),
          double(hn::GetLane(hn::SumOfLanes(d, hn::Add(low, high))))};
}

MultiplyAdds floats(std::size_t rounds) {
  return multiply_add<float>(rounds);
}
MultiplyAdds doubles(std::size_t rounds) {
  return multiply_add<double>(rounds);
}

const char* target_name() {
  return hwy::TargetName(HWY_TARGET);
}

}  // namespace HWY_NAMESPACE
}  // namespace hooke::bench
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hooke::bench {

HWY_EXPORT(sum_floats);
HWY_EXPORT(floats);
HWY_EXPORT(doubles);
HWY_EXPORT(target_name);

double sum(const float* values, std::size_t count) {
  return HWY_DYNAMIC_DISPATCH(sum_floats)(values, count);
}
MultiplyAdds multiply_add_floats(std::size_t rounds) {
  return HWY_DYNAMIC_DISPATCH(floats)(rounds);
}
MultiplyAdds multiply_add_doubles(std::size_t rounds) {
  return HWY_DYNAMIC_DISPATCH(doubles)(rounds);
}
std::string vector_instructions() {
  return HWY_DYNAMIC_DISPATCH(target_name)();
}

}  // namespace hooke::bench
#endif
