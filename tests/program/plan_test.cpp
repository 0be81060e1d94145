#include "program/plan.h"

#include <sstream>

#include <doctest/doctest.h>

namespace hooke::program {
namespace {

TEST_CASE("a plan is printed as an aligned table, then what it holds") {
  Plan plan;
  plan.stages = {{"springs", "blocks", {"x", "v"}, {"f"}, 4000}, {"gravity", "blocks", {}, {"f"}, 0}};
  plan.state_bytes = 600;
  plan.model_bytes = 400;
  plan.order = "as given";
  plan.springs = "7 slots";
  plan.tiles = "2 of 64";
  std::ostringstream out;
  print_plan(plan, 100, out);
  CHECK(out.str() ==
        "stage    sweep   reads  writes  bytes\n"
        "springs  blocks  x, v   f        4000\n"
        "gravity  blocks  -      f           0\n"
        "\n"
        "Stages of one sweep run together, on a block of particles while it is in cache.\n"
        "\n"
        "state    600 bytes\n"
        "model    400 bytes\n"
        "total    5000 bytes, 50.0 for each of 100 particles\n"
        "order    as given\n"
        "springs  7 slots\n"
        "tiles    2 of 64\n");
}

}  // namespace
}  // namespace hooke::program
