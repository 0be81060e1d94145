#include "study/method_traits.h"

#include <variant>

namespace hooke::study {
namespace {

template <class One>
concept ChoosesSteps = requires(One one) {
  one.smallest_step;
};

template <class One>
concept SolvesToTolerance = requires(One one) {
  one.most_iterations;
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

Method solved_for_errors(Method method, double error) {
  constexpr double share = 1e-4;
  std::visit(
      [&](auto& one) {
        if constexpr (SolvesToTolerance<decltype(one)>) one.tolerance = share * error;
      },
      method);
  return method;
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
