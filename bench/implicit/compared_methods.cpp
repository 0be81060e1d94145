#include "implicit/compared_methods.h"

namespace hooke::bench {

std::vector<ComparedMethod> compared_methods() {
  const std::vector<std::uint64_t> many = {1, 2, 3, 5, 10, 20, 30, 50, 100, 200, 300, 500, 1000};
  const std::vector<std::uint64_t> few = {1, 2, 3, 5, 10, 20, 30, 50, 100, 200};
  // A tolerance of 0 is no tolerance; Newton's method must have one.
  constexpr double never_met = 1e-300;
  return {
      {"projective dynamics (2013)", many,
       [](std::uint64_t n) { return ProjectiveDynamics{.iterations = n, .history = 0}; }},
      {"projective dynamics", many, [](std::uint64_t n) { return ProjectiveDynamics{.iterations = n}; }},
      {"Newton-PCG", few,
       [](std::uint64_t n) { return BackwardEuler{.tolerance = never_met, .most_iterations = n}; }},
      {"vertex block descent", many, [](std::uint64_t n) { return VertexBlockDescent{.iterations = n}; },
       false},
      {"XPBD", many, [](std::uint64_t n) { return Xpbd{.substeps = 1, .iterations = n}; }, false},
  };
}

}  // namespace hooke::bench
