#include "scenes/hard/asked_method.h"
#include "scenes/hard/cases.h"
#include "scenes/hard/common_criteria.h"
#include "scenes/hard/measures.h"
#include "scenes/hard/shapes.h"

namespace hooke::hard {
namespace {

constexpr int steps = 60;

/// A hung cloth, all of it `size` times as large: lengths and gravity grow with the size, mass, stiffness and
/// drag with its square, so that it moves in the same time.
Scene sheet_of_size(double size, Extent extent) {
  Scene scene = hung_sheet(extent == Extent::whole ? 20 : 10).scene;
  for (double& mass : scene.particles.mass) mass *= size * size;
  for (Vec3& position : scene.particles.position) position *= size;
  for (double& length : scene.springs.rest_length) length *= size;
  for (double& stiffness : scene.springs.stiffness) stiffness *= size * size;
  scene.effects = {Gravity{Vec3{0.0, -9.81, 0.0} * size}, Drag{1e-3 * size * size}};
  return scene;
}

Scene make(Extent extent) {
  return sheet_of_size(1e-6, extent);
}

std::vector<Vec3> end_of(const Method& method, double size, Extent extent, std::string& trouble) {
  const Scene scene = sheet_of_size(size, extent);
  WatchedRun<double> run(scene, asked_of(method, scene, frame));
  run.take(steps);
  trouble += run.trouble();
  std::vector<Vec3> positions = run.positions();
  for (Vec3& position : positions) position /= size;
  return positions;
}

Result run(const Method& method, Extent extent) {
  const Scene scene = make(extent);
  const auto drive = [&](WatchedRun<double>& run, Judge& judge) {
    run.take(steps);
    std::string trouble;
    const std::vector<Vec3> one = end_of(method, 1.0, extent, trouble);
    for (const auto& [size, text] : {std::pair{1e-6, "1e-6 m"}, std::pair{1e6, "1e6 m"}}) {
      judge.at_most(std::string("distance from the cloth of 1 m, as a share of the size, of that of ") + text,
                    largest_distance(one, end_of(method, size, extent, trouble)), 1e-6);
    }
    if (!trouble.empty()) judge.wrong(trouble);
  };
  return judged(scene, asked_of(method, scene, frame), steps, drive);
}

}  // namespace

const HardCase tiny_and_huge_cloth{15,
                                   "tiny_and_huge_cloth",
                                   "A cloth of 20 x 20 particles (quick: 10 x 10) hung by two corners, in "
                                   "gravity and drag: 1e-6 m, 1 m and 1e6 m "
                                   "large, with mass, stiffness, drag and gravity scaled so that they move "
                                   "in the same time. 1 s in steps of 1/60 s.",
                                   "Relative to its size each moves as the one of 1 m, to 1e-6.",
                                   "",
                                   frame,
                                   make,
                                   run};

}  // namespace hooke::hard
