#include "study/method_traits.h"

#include <variant>

namespace hooke::study {
namespace {

template <class One>
concept ChoosesSteps = requires(One one) {
  one.smallest_step;
};

}  // namespace

MethodTraits traits_of(const Method& method) {
  return std::visit(
      [](const auto& one) {
        MethodTraits traits{one.name, one.order, one.force_evaluations, one.oscillation_limit};
        if constexpr (ChoosesSteps<decltype(one)>) traits.tolerance = one.tolerance;
        return traits;
      },
      method);
}

Method with_tolerance(Method method, double tolerance, double horizon) {
  std::visit(
      [&](auto& one) {
        if constexpr (ChoosesSteps<decltype(one)>) {
          one.tolerance = tolerance;
          one.smallest_step = 4.0 * std::numeric_limits<double>::epsilon() * horizon;
        }
      },
      method);
  return method;
}

}  // namespace hooke::study
