#include <doctest/doctest.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/reciprocal_root_test.cpp"
#include <hwy/foreach_target.h>

#include "kernels/spring-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

/// 2 / sqrt(a) of the kernels, for one value.
template <class Real>
Real twice_reciprocal_root_of(Real a) {
  const hn::ScalableTag<Real> d;
  const auto root = twice_reciprocal_root(d, hn::Set(d, a));
  return hn::GetLane(hn::Mul(root.estimate, root.correction));
}

}  // namespace

float root_float(float a) {
  return twice_reciprocal_root_of(a);
}

double root_double(double a) {
  return twice_reciprocal_root_of(a);
}

}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <cmath>
#include <limits>
#include <random>

#include "instruction_sets.h"

namespace hooke {
namespace {

HWY_EXPORT(root_float);
HWY_EXPORT(root_double);

/// The largest relative error over all binary orders of magnitude of Real.
template <class Real, class Root>
double worst_error(const Root& root) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> mantissa(1.0, 2.0);
  double worst = 0.0;
  for (int e = std::numeric_limits<Real>::min_exponent; e < std::numeric_limits<Real>::max_exponent - 1;
       ++e) {
    for (int i = 0; i < 200; ++i) {
      const Real a = Real(std::ldexp(mantissa(random), e));
      const long double exact = 2.0L / std::sqrt((long double)(a));
      worst = std::max(worst, double(std::fabs((long double)(root(a)) / exact - 1.0L)));
    }
  }
  return worst;
}

TEST_CASE("reciprocal roots are as exact as they say, on every instruction set") {
  test::on_each_instruction_set([] {
    const double in_float = worst_error<float>([](float a) { return HWY_DYNAMIC_DISPATCH(root_float)(a); });
    const double in_double =
        worst_error<double>([](double a) { return HWY_DYNAMIC_DISPATCH(root_double)(a); });
    MESSAGE("relative error ", in_float, " in float, ", in_double, " in double");
    CHECK(in_float < 3e-7);
    CHECK(in_double < 6e-16);
  });
}

}  // namespace
}  // namespace hooke
#endif
