#include <doctest/doctest.h>

#include <algorithm>

#include "engine_run.h"
#include "reference_scenes.h"

using namespace hooke;
using namespace hooke::reference;
using namespace hooke::test;

TEST_CASE("DormandPrince delivers the tolerance asked for within a factor of 10") {
  for (const ReferenceScene& scene : reference_scenes()) {
    EngineForces forces(scene.scene);
    const auto exact = solution(solvers().front(), forces, forces.start(), scene.end, scene.scale);
    for (double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
      for (int calls : {1, 20}) {  // one covers the corner of a pin's path
        CAPTURE(scene.name);
        CAPTURE(tolerance);
        CAPTURE(calls);
        const auto y = engine_run(scene, DormandPrince{.tolerance = tolerance}, calls);
        const Error error = error_of(y, exact, scene);
        const double larger = std::max(error.position, error.velocity) / tolerance;
        CHECK(larger < 10.0);
        CHECK(larger > 1e-3);  // else most of the work is wasted
      }
    }
  }
}
