#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "scenes/hard/asked_method.h"
#include "scenes/hard/cases.h"
#include "scenes/hard/common_criteria.h"
#include "scenes/hard/shapes.h"

namespace hooke::hard {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Scene make(Extent) {
  return hung_sheet(6).scene;
}

/// Something that nobody can simulate, and the element that an error must name.
struct BadInput {
  std::string what, element;
  std::function<void(Scene&, Settings&)> spoil;
};

std::vector<BadInput> bad_masses_and_places() {
  return {
      {"mass 0", "particle 3", [](Scene& scene, Settings&) { scene.particles.mass[3] = 0.0; }},
      {"mass -1", "particle 3", [](Scene& scene, Settings&) { scene.particles.mass[3] = -1.0; }},
      {"mass NaN", "particle 3", [](Scene& scene, Settings&) { scene.particles.mass[3] = nan; }},
      {"mass infinite", "particle 3", [](Scene& scene, Settings&) { scene.particles.mass[3] = infinity; }},
      {"position NaN", "particle 4", [](Scene& scene, Settings&) { scene.particles.position[4].x() = nan; }},
      {"velocity infinite", "particle 5",
       [](Scene& scene, Settings&) {
         scene.particles.velocity.assign(scene.particles.size(), Vec3::Zero());
         scene.particles.velocity[5].y() = -infinity;
       }},
      {"pin out of range", "pin 2", [](Scene& scene, Settings&) { scene.pin(1000); }},
      {"gravity NaN", "effects[0] (gravity)",
       [](Scene& scene, Settings&) {
         scene.effects[0] = Gravity{{0.0, nan, 0.0}};
       }},
      {"drag -1", "effects[1] (drag)", [](Scene& scene, Settings&) { scene.effects.push_back(Drag{-1.0}); }},
  };
}

std::vector<BadInput> bad_springs_and_steps() {
  return {
      {"stiffness NaN", "spring 7", [](Scene& scene, Settings&) { scene.springs.stiffness[7] = nan; }},
      {"stiffness -1", "spring 7", [](Scene& scene, Settings&) { scene.springs.stiffness[7] = -1.0; }},
      {"rest length infinite", "spring 7",
       [](Scene& scene, Settings&) { scene.springs.rest_length[7] = infinity; }},
      {"index out of range", "spring 7", [](Scene& scene, Settings&) { scene.springs.second[7] = 1000; }},
      {"arrays of unequal length", "springs",
       [](Scene& scene, Settings&) { scene.springs.stiffness.pop_back(); }},
      {"step 0", "settings", [](Scene&, Settings& settings) { settings.step = 0.0; }},
      {"step -1", "settings", [](Scene&, Settings& settings) { settings.step = -1.0; }},
      {"step NaN", "settings", [](Scene&, Settings& settings) { settings.step = nan; }},
      {"step infinite", "settings", [](Scene&, Settings& settings) { settings.step = infinity; }},
  };
}

/// Why it was not refused as it must be; empty where it was.
std::string not_refused(const BadInput& bad, const Method& method) {
  Scene scene = make(Extent::whole);
  Settings settings{.method = method};
  bad.spoil(scene, settings);
  try {
    Simulation<double> simulation(scene, settings);
    return bad.what + " was accepted";
  } catch (const SceneError& error) {
    for (const Fault& fault : error.faults()) {
      if (fault.element.find(bad.element) != std::string::npos && !fault.remedy.empty()) return {};
    }
    return bad.what + " was refused, but without naming " + bad.element;
  }
}

/// What a running simulation was given, and took though it must not; empty where it did as it must.
std::string not_refused_while_running(const std::string& what, Simulation<double>& simulation,
                                      const std::function<void()>& spoil) {
  const std::uint64_t before = simulation.state_hash();
  try {
    spoil();
    return what + " was accepted";
  } catch (const std::exception&) {
    return simulation.state_hash() == before ? "" : what + " was refused, but changed the state";
  }
}

std::vector<std::string> problems_while_running(const Method& method) {
  const Scene scene = make(Extent::whole);
  // A method that bears no step on springs is to refuse bad input all the same.
  Simulation<double> simulation(scene, {.method = method, .step = 1e-4});
  simulation.step(3);
  Snapshot<double> bad = simulation.snapshot(), short_one = bad;
  bad.positions[5] = nan;
  short_one.velocities.pop_back();
  return {not_refused_while_running("an impulse of NaN", simulation,
                                    [&] {
                                      simulation.apply_impulse(9, {0.0, nan, 0.0});
                                    }),
          not_refused_while_running("an impulse on a particle that is not there", simulation,
                                    [&] { simulation.apply_impulse(1000, Vec3::UnitX()); }),
          not_refused_while_running("a snapshot with NaN", simulation, [&] { simulation.restore(bad); }),
          not_refused_while_running("a snapshot that is too short", simulation,
                                    [&] { simulation.restore(short_one); }),
          not_refused_while_running("a frame of NaN seconds", simulation, [&] { simulation.advance(nan); }),
          not_refused_while_running("a frame of -1 s", simulation, [&] { simulation.advance(-1.0); })};
}

Result run(const Method& method, Extent) {
  Judge judge;
  std::vector<std::string> problems = problems_while_running(method);
  for (const auto& inputs : {bad_masses_and_places(), bad_springs_and_steps()}) {
    for (const BadInput& bad : inputs) problems.push_back(not_refused(bad, method));
  }
  double accepted = 0.0;
  for (const std::string& problem : problems) {
    accepted += !problem.empty();
    if (!problem.empty()) judge.wrong(problem);
  }
  judge.at_most(
      "bad inputs, of " + std::to_string(problems.size()) + ", that were not refused as they must be",
      accepted, 0.0);
  return judge.result();
}

}  // namespace

const HardCase bad_input{
    17,
    "bad_input",
    "18 scenes and settings that nobody can simulate: mass 0, -1, NaN and infinite, position, velocity, "
    "gravity, "
    "stiffness NaN or negative, indices out of range, arrays of unequal length, steps of 0, -1, NaN and "
    "infinite; "
    "and, while a simulation runs, impulses, snapshots and frame times that are none.",
    "Each is refused with an error that names the element and a remedy; what runs keeps its state.",
    "",
    frame,
    make,
    run};

}  // namespace hooke::hard
