#include <doctest/doctest.h>

#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

namespace {

std::string recommended(const Scene& scene, double step) {
  return std::string(to_string(recommended_method(scene, step).method));
}

}  // namespace

TEST_CASE("the explicit method is recommended while it needs few substeps, then the implicit one") {
  const Scene scene = hung_cloth(12, 10);
  const double longest = largest_stable_step(scene, Verlet{});
  CHECK(recommended(scene, 0.5 * longest) == "verlet");
  CHECK(recommended_method(scene, 0.5 * longest).reason.find("whole") != std::string::npos);
  CHECK(recommended(scene, 20.0 * longest) == "verlet");
  CHECK(recommended_method(scene, 17.5 * longest).reason.find("20 substeps") != std::string::npos);
  CHECK(recommended(scene, 2000.0 * longest) == "backward_euler");
  CHECK(recommended_method(scene, 1799.5 * longest).reason.find("needs 2000 substeps; backward_euler") !=
        std::string::npos);
}

TEST_CASE(
    "where contact puts things back, which implicit steps know nothing of, more substeps are recommended") {
  const double longest = largest_stable_step(hung_cloth(12, 10), Verlet{});
  const auto with = [](const Effect& effect) {
    Scene scene = hung_cloth(12, 10);
    scene.effects.push_back(effect);
    return scene;
  };
  for (const Effect& contact : {Effect{Collider{}}, Effect{SelfCollision{.thickness = 1e-3}}}) {
    CHECK(recommended(with(contact), 300.0 * longest) == "verlet");
    CHECK(recommended_method(with(contact), 300.0 * longest).reason.find("contact") != std::string::npos);
    CHECK(recommended(with(contact), 3000.0 * longest) == "backward_euler");
  }
  const Scene penalty = with(Collider{.stiffness = 1e-3});
  CHECK(recommended(penalty, 300.0 * largest_stable_step(penalty, Verlet{})) == "backward_euler");
}

TEST_CASE("what is recommended takes its steps as it says, and all goes well") {
  for (double stiffer : {1.0, 100.0, 1e6}) {
    Scene scene = hung_cloth(12, 10, 0.01);
    for (double& k : scene.springs.stiffness) k *= stiffer;
    const Settings settings{.method = recommended_method(scene, 1.0 / 60.0).method};
    CHECK((to_string(settings.method) == "backward_euler") == (stiffer == 1e6));
    Simulation<double> simulation(scene, settings);
    CHECK(simulation.step(60).ok());
    CHECK(simulation.max_strain() < 1.0);
  }
}

TEST_CASE("nothing that pulls is recommended what is cheapest, and a field is mentioned") {
  Scene scene = one_particle();
  CHECK(recommended(scene, 1e3) == "verlet");
  scene.effects = {Field{[](const Vec3&, double) { return Vec3(0, 0, 0); }}};
  CHECK(recommended_method(scene, 0.1).reason.find("field") != std::string::npos);
}
