#include "methods/tableau.h"

#include <numeric>

namespace hooke {
namespace {

/// The row for the weights of the k_j. The positions' k_j is V_j = v + h sum_l a[j][l] A_l.
NystromRow nystrom_row(const ButcherTableau& tableau, const std::vector<double>& weights) {
  NystromRow row;
  row.time = std::accumulate(weights.begin(), weights.end(), 0.0);
  row.velocity = weights;
  row.position.assign(weights.size(), 0.0);
  for (std::size_t j = 0; j < weights.size(); ++j) {
    for (std::size_t l = 0; l < j; ++l) row.position[l] += weights[j] * tableau.a[j][l];
  }
  return row;
}

}  // namespace

ButcherTableau tableau(const ExplicitEuler&) {
  return {{{}}, {1.0}};
}

ButcherTableau tableau(const Midpoint&) {
  return {{{}, {1.0 / 2}}, {0.0, 1.0}};
}

ButcherTableau tableau(const Heun&) {
  return {{{}, {1.0}}, {1.0 / 2, 1.0 / 2}};
}

ButcherTableau tableau(const RungeKutta4&) {
  return {{{}, {1.0 / 2}, {0.0, 1.0 / 2}, {0.0, 0.0, 1.0}}, {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6}};
}

ButcherTableau tableau(const DormandPrince&) {
  return {{{},
           {1.0 / 5},
           {3.0 / 40, 9.0 / 40},
           {44.0 / 45, -56.0 / 15, 32.0 / 9},
           {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
           {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656}},
          {35.0 / 384, 0.0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}};
}

std::vector<NystromRow> nystrom_rows(const ButcherTableau& tableau) {
  std::vector<NystromRow> rows;
  for (std::size_t i = 1; i < tableau.stages(); ++i) rows.push_back(nystrom_row(tableau, tableau.a[i]));
  rows.push_back(nystrom_row(tableau, tableau.b));
  return rows;
}

NystromRow dormand_prince_error() {
  ButcherTableau with_result = tableau(DormandPrince{});
  with_result.a.push_back(with_result.b);
  NystromRow row = nystrom_row(
      with_result, {71.0 / 57600, 0.0, -71.0 / 16695, 71.0 / 1920, -17253.0 / 339200, 22.0 / 525, -1.0 / 40});
  row.time = 0.0;
  return row;
}

}  // namespace hooke
