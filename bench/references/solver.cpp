#include "solver.h"

namespace hooke::reference {

std::vector<double> solution(const Solver& solver, EngineForces& forces, std::vector<double> y, double end,
                             const Scale& scale) {
  double now = 0.0;
  const auto solve_to = [&](double time) {
    y = solver.solve(forces, std::move(y), now, time, scale, solver.tolerance);
    now = time;
  };
  for (double corner : forces.corners()) {
    if (corner > 0.0 && corner < end) solve_to(corner);
  }
  solve_to(end);
  return y;
}

}  // namespace hooke::reference
