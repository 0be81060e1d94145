#include "methods/tableau.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numeric>

#include "methods/splitting.h"

using namespace hooke;

namespace {

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// sum_i b_i weight(i).
template <class Weight>
double weighted(const ButcherTableau& tableau, const Weight& weight) {
  double result = 0.0;
  for (std::size_t i = 0; i < tableau.stages(); ++i) result += tableau.b[i] * weight(i);
  return result;
}

/// The conditions of Butcher's trees up to order 4 (Hairer, Norsett and Wanner 1993, section II.2).
void check_conditions(const ButcherTableau& tableau, int order) {
  const auto c = [&](std::size_t i) { return sum(tableau.a[i]); };
  const auto inner = [&](std::size_t i, const auto& f) {
    double result = 0.0;
    for (std::size_t j = 0; j < i; ++j) result += tableau.a[i][j] * f(j);
    return result;
  };
  const auto ac = [&](std::size_t i) { return inner(i, c); };
  const auto check = [](double value, double expected) {
    CHECK(value == doctest::Approx(expected).epsilon(1e-14));
  };
  check(weighted(tableau, [](std::size_t) { return 1.0; }), 1.0);
  if (order >= 2) check(weighted(tableau, c), 1.0 / 2);
  if (order >= 3) {
    check(weighted(tableau, [&](std::size_t i) { return c(i) * c(i); }), 1.0 / 3);
    check(weighted(tableau, ac), 1.0 / 6);
  }
  if (order >= 4) {
    check(weighted(tableau, [&](std::size_t i) { return c(i) * c(i) * c(i); }), 1.0 / 4);
    check(weighted(tableau, [&](std::size_t i) { return c(i) * ac(i); }), 1.0 / 8);
    check(weighted(tableau, [&](std::size_t i) { return inner(i, [&](auto j) { return c(j) * c(j); }); }),
          1.0 / 12);
    check(weighted(tableau, [&](std::size_t i) { return inner(i, ac); }), 1.0 / 24);
  }
  if (order >= 5) check(weighted(tableau, [&](std::size_t i) { return std::pow(c(i), 4.0); }), 1.0 / 5);
}

template <class M>
void check_runge_kutta(const M& method) {
  CAPTURE(M::name);
  const ButcherTableau coefficients = tableau(method);
  CHECK(coefficients.stages() == std::size_t(M::force_evaluations));
  REQUIRE(coefficients.a.size() == coefficients.stages());
  for (std::size_t i = 0; i < coefficients.stages(); ++i) CHECK(coefficients.a[i].size() == i);
  check_conditions(coefficients, M::order);
}

template <class M>
void check_splitting(const M& method) {
  CAPTURE(M::name);
  const Splitting coefficients = splitting(method);
  CHECK(coefficients.stages() == std::size_t(M::force_evaluations));
  CHECK(coefficients.kicks.size() == coefficients.drifts.size());
  CHECK(sum(coefficients.kicks) + coefficients.last_kick == doctest::Approx(1.0).epsilon(1e-15));
  CHECK(sum(coefficients.drifts) == doctest::Approx(1.0).epsilon(1e-15));
}

}  // namespace

TEST_CASE("tableaus have the stages and meet the conditions of the order that their methods state") {
  check_runge_kutta(ExplicitEuler{});
  check_runge_kutta(Midpoint{});
  check_runge_kutta(Heun{});
  check_runge_kutta(RungeKutta4{});
  check_runge_kutta(DormandPrince{});
}

TEST_CASE("kicks and drifts add up to a step") {
  check_splitting(SymplecticEuler{});
  check_splitting(Verlet{});
  check_splitting(BlanesMoan{});
}

TEST_CASE("rows of Nystrom's form: Runge-Kutta 4, as its textbooks have it for second-order equations") {
  const std::vector<NystromRow> rows = nystrom_rows(tableau(RungeKutta4{}));
  REQUIRE(rows.size() == 4);
  CHECK(rows[0].time == 0.5);
  CHECK(rows[1].position == std::vector<double>{0.25, 0.0});
  CHECK(rows[2].position == std::vector<double>{0.0, 0.5, 0.0});
  CHECK(rows[3].time == doctest::Approx(1.0));
  for (std::size_t j = 0; j < 3; ++j) CHECK(rows[3].position[j] == doctest::Approx(1.0 / 6));
  CHECK(rows[3].position[3] == 0.0);
}

TEST_CASE("the error estimate of Dormand and Prince vanishes where accelerations are a cubic in time") {
  // The embedded results are of order 5 and 4: both are exact there.
  const NystromRow error = dormand_prince_error();
  const std::vector<NystromRow> rows = nystrom_rows(tableau(DormandPrince{}));
  REQUIRE(error.velocity.size() == 7);
  for (int power = 0; power <= 4; ++power) {
    double velocity = 0.0;
    for (std::size_t j = 0; j < 7; ++j) {
      const double c = j == 0 ? 0.0 : rows[j - 1].time;
      velocity += error.velocity[j] * (power == 0 ? 1.0 : std::pow(c, power));
    }
    CAPTURE(power);
    if (power <= 3) {
      CHECK(velocity == doctest::Approx(0.0));
    } else {
      CHECK(std::abs(velocity) > 1e-4);  // an estimate that is always zero would accept anything
    }
  }
}
