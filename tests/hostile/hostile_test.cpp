#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "hostile/base_scenes.h"
#include "hostile/mutation.h"
#include "hostile/watchdog.h"
#include "sanitized.h"
#include "scene_file/scene_file.h"

/// Spoilt files: each must either run or be refused with a message. Meant for the sanitizers, which see more.

using namespace hooke;
namespace fs = std::filesystem;

namespace {

std::size_t mutations() {
  const char* wanted = std::getenv("HOOKE_HOSTILE_MUTATIONS");
  return wanted != nullptr ? std::strtoull(wanted, nullptr, 10) : 10'000;
}

/// A folder of its own for meshes, removed at the end.
class Folder {
 public:
  explicit Folder(const char* name) : path_(fs::temp_directory_path() / name) {
    fs::create_directories(path_);
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  const fs::path& path() const { return path_; }
  void write(const char* name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
  }

 private:
  fs::path path_;
};

struct Outcomes {
  std::size_t ran = 0, went_bad = 0, refused = 0;
};

bool all_finite(const Simulation<float>& simulation) {
  constexpr std::size_t stride = 3 * sizeof(float);
  std::vector<float> values(6 * simulation.particle_count());
  simulation.copy_positions(values.data(), stride);
  simulation.copy_velocities(values.data() + values.size() / 2, stride);
  return std::all_of(values.begin(), values.end(), [](float x) { return std::isfinite(x); });
}

/// Reads and simulates what a spoilt file says, if it can be.
void use(const std::string& text, const fs::path& folder, Outcomes& outcomes) {
  try {
    SceneFile file = parse_scene(text, folder, {.max_particles = 2000});
    file.settings.threads = 1;
    Simulation<float> simulation(file.scene, file.settings);
    // With sanitizers some 100,000 substeps of turbulent wind take minutes; so long a step taken whole goes
    // bad soon.
    constexpr std::uint64_t too_many = 10'000;
    if (test::sanitized && simulation.plan().substeps > too_many) {
      file.settings.unstable_step = UnstableStep::take;
      simulation = Simulation<float>(file.scene, file.settings);
    }
    const Report report = simulation.step(3);
    CHECK(all_finite(simulation));
    CHECK(report.ok() == (report.steps_taken == 3));
    CHECK((report.ok() || !report.message().empty()));
    CHECK(report.message().empty() == (report.flags == flag_none));
    (report.ok() ? outcomes.ran : outcomes.went_bad) += 1;
  } catch (const SceneFileError& error) {
    CHECK(!error.faults().empty());
    outcomes.refused += 1;
  } catch (const SceneError& error) {
    CHECK(!error.faults().empty());
    outcomes.refused += 1;
  } catch (const std::exception& error) {
    FAIL_CHECK(error.what());
  }
}

/// A test in which everything were refused, or nothing, would show nothing.
void check_both_happened(const Outcomes& outcomes, std::size_t count) {
  MESSAGE(outcomes.ran << " ran, " << outcomes.went_bad << " ran until they went bad, " << outcomes.refused
                       << " were refused");
  CHECK(outcomes.ran + outcomes.went_bad + outcomes.refused == count);
  CHECK(outcomes.ran > count / 20);
  CHECK(outcomes.refused > count / 20);
}

}  // namespace

TEST_CASE("the scenes to be spoilt can be simulated as they are") {
  const Folder folder("hooke_hostile_base");
  folder.write("mesh.obj", test::small_mesh());
  Outcomes outcomes;
  const auto scenes = test::small_scenes();
  for (const auto& scene : scenes) use(scene.dump(), folder.path(), outcomes);
  CHECK(outcomes.ran == scenes.size());
}

TEST_CASE("a spoilt scene file runs or is refused") {
  const Folder folder("hooke_hostile_scenes");
  folder.write("mesh.obj", test::small_mesh());
  test::Watchdog watchdog(std::chrono::seconds(60));
  const auto scenes = test::small_scenes();
  const std::vector<std::string> modes{"gather", "coloured", "atomic"};
  const std::size_t count = mutations();
  Outcomes outcomes;
  for (std::size_t seed = 0; seed < count; ++seed) {
    test::Chance chance(seed);
    auto scene = scenes[chance.below(scenes.size())];
    scene["accumulation"] = modes[chance.below(modes.size())];
    const std::string text =
        seed % 2 == 0 ? test::mutate_bytes(scene.dump(1), chance) : test::mutate_values(scene, chance);
    CAPTURE(seed);
    CAPTURE(text);
    watchdog.begin("seed " + std::to_string(seed) + ": " + text.substr(0, 4000));
    use(text, folder.path(), outcomes);
  }
  check_both_happened(outcomes, count);
}

TEST_CASE("a spoilt mesh runs or is refused") {
  const Folder folder("hooke_hostile_meshes");
  test::Watchdog watchdog(std::chrono::seconds(60));
  const std::string scene = R"({"step": 1e-4, "cloth_mesh": {"file": "mesh.obj"}, "effects": {"gravity": {}},
                               "pins": [{"furthest_along": [1, 0, 0], "within": 0.01}]})";
  const std::size_t count = mutations() / 5;
  Outcomes outcomes;
  for (std::size_t seed = 0; seed < count; ++seed) {
    test::Chance chance(seed);
    const std::string mesh = test::mutate_bytes(test::small_mesh(), chance);
    folder.write("mesh.obj", mesh);
    CAPTURE(seed);
    CAPTURE(mesh);
    watchdog.begin("seed " + std::to_string(seed) + ": " + mesh);
    use(scene, folder.path(), outcomes);
  }
  check_both_happened(outcomes, count);
}
