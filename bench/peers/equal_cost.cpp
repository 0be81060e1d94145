// What a sheet costs in time for each frame, against how far it is stretched: Hooke with few soft or many
// stiff steps beside Bullet with few or many iterations. The frames of all are taken in turn, so that what
// else the machine does meets all alike.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>

#include <hooke/hooke.h>

#include "falling.h"
#include "hooke_peers.h"
#include "hung_sheet.h"
#include "program/stopwatch.h"
#ifdef HOOKE_BULLET
#include "bullet_cloth.h"
#endif

namespace hooke::bench {
namespace {

constexpr double frame_seconds = 1.0 / 60.0;

struct Options {
  bool quick = false;
  std::filesystem::path folder;  ///< for figures and final sheets; none: figures to standard output only
};

/// A sheet that an engine moves.
class MovedSheet {
 public:
  virtual ~MovedSheet() = default;
  virtual void frame() = 0;
  virtual std::vector<Vec3> positions() const = 0;  ///< [m]
  /// Throws std::runtime_error where the engine can tell that its run went wrong.
  virtual void require_good() const {}
};

class HookeSheet : public MovedSheet {
 public:
  HookeSheet(const Scene& scene, unsigned substeps, unsigned threads)
      : substeps_(substeps),
        scene_({"sheet", scene, frame_seconds / substeps}),
        simulation_(scene,
                    {.step = scene_.bench.step, .unstable_step = UnstableStep::take, .threads = threads}),
        energy_before_(simulation_.energy().total()) {
    require_near<float>(scene_.check.distance(simulation_));
  }

  void frame() override {
    last_frame_ = simulation_.step(substeps_);
    require(last_frame_.ok(), last_frame_.message());
  }
  std::vector<Vec3> positions() const override { return positions_of(simulation_); }
  void require_good() const override {
    require(scene_.check.stayed_good(simulation_, last_frame_, energy_before_), "gained energy from nothing");
  }

 private:
  unsigned substeps_;
  CheckedScene scene_;
  Simulation<float> simulation_;
  double energy_before_;  // [J]
  Report last_frame_;
};

#ifdef HOOKE_BULLET
class BulletSheet : public MovedSheet {
 public:
  BulletSheet(const Scene& scene, unsigned substeps, int iterations)
      : substeps_(substeps), cloth_(scene, {.iterations = iterations, .damping = drag_rate}) {}

  void frame() override {
    for (unsigned i = 0; i < substeps_; ++i) cloth_.step(frame_seconds / substeps_);
  }
  std::vector<Vec3> positions() const override { return cloth_.positions(); }

 private:
  unsigned substeps_;
  BulletCloth cloth_;
};
#endif

/// An engine with one of its settings.
struct Contender {
  std::string engine, setting;
  unsigned threads;
  double stretch;  ///< stiffness of structural springs [N/m]; 0 where the engine has none in N/m
  double step;     ///< [s]
  HungSheet sheet;
  std::unique_ptr<MovedSheet> moved;
  std::vector<double> seconds{};  ///< [s] of wall-clock time, each frame
  std::vector<Vec3> before{};     ///< [m] positions one frame before the end
};

Contender hooke_contender(Index particles_a_side, unsigned substeps, unsigned threads) {
  HungSheet sheet = hung_sheet(particles_a_side, frame_seconds / substeps);
  auto moved = std::make_unique<HookeSheet>(sheet.scene, substeps, threads);
  const double stretch =
      *std::max_element(sheet.scene.springs.stiffness.begin(), sheet.scene.springs.stiffness.end());
  return {"hooke",
          std::to_string(substeps) + " substeps",
          threads,
          stretch,
          frame_seconds / substeps,
          std::move(sheet),
          std::move(moved)};
}

#ifdef HOOKE_BULLET
Contender bullet_contender(Index particles_a_side, unsigned substeps, int iterations) {
  HungSheet sheet = hung_sheet(particles_a_side, frame_seconds);  // of its springs only the lengths are used
  auto moved = std::make_unique<BulletSheet>(sheet.scene, substeps, iterations);
  std::string setting = std::to_string(iterations) + " iterations";
  if (substeps > 1) setting = std::to_string(substeps) + " substeps of " + setting;
  return {"bullet", setting, 1, 0.0, frame_seconds / substeps, std::move(sheet), std::move(moved)};
}
#endif

std::vector<Contender> contenders(Index particles_a_side) {
  std::vector<Contender> result;
  const unsigned all = make_tbb_executor()->threads();
  for (unsigned substeps : {150u, 300u, 600u}) {
    result.push_back(hooke_contender(particles_a_side, substeps, all));
  }
  if (all > 1) result.push_back(hooke_contender(particles_a_side, 300, 1));
#ifdef HOOKE_BULLET
  for (int iterations : {10, 20, 40, 80}) {
    result.push_back(bullet_contender(particles_a_side, 1, iterations));
  }
  result.push_back(bullet_contender(particles_a_side, 4, 10));
  result.push_back(bullet_contender(particles_a_side, 8, 10));
#else
  std::cerr << "skipped: Bullet, which was not found when this was configured (Debian: libbullet-dev)\n";
#endif
  return result;
}

void take_frames(std::vector<Contender>& all, int frames) {
  for (int frame = 1; frame <= frames; ++frame) {
    for (Contender& one : all) {
      if (frame == frames) one.before = one.moved->positions();
      const program::Stopwatch watch;
      one.moved->frame();
      one.seconds.push_back(watch.seconds());
    }
    if (frame % 60 == 0) std::cerr << frame / 60 << " s simulated" << std::endl;
  }
}

/// The root of the mean square of velocities in the last frame [m/s]: how far the sheet has settled.
double rms_speed(const Contender& one, const std::vector<Vec3>& positions) {
  double sum = 0.0;
  for (std::size_t i = 0; i < positions.size(); ++i) sum += (positions[i] - one.before[i]).squaredNorm();
  return std::sqrt(sum / double(positions.size())) / frame_seconds;
}

/// [s] of wall-clock time. Half of the frames took longer: a busy machine disturbs it less than their mean.
double median_frame(const Contender& one) {
  std::vector<double> sorted = one.seconds;
  std::sort(sorted.begin(), sorted.end());
  return sorted[sorted.size() / 2];
}

void write_row(std::ostream& out, const Contender& one, const std::vector<Vec3>& positions) {
  const Strain strain = strain_of(one.sheet, positions);
  out << one.engine << ',' << one.setting << ',' << one.threads << ',' << 1e3 * median_frame(one) << ','
      << median_frame(one) / frame_seconds << ',' << strain.largest << ',' << strain.percentile_99 << ','
      << strain.median << ',';
  if (one.stretch > 0.0) out << one.stretch;
  out << ',' << mean_fall(one.sheet.scene, positions) << ',' << rms_speed(one, positions) << '\n';
}

std::string file_name(const Contender& one) {
  std::string name = one.engine + " " + one.setting + " threads " + std::to_string(one.threads) + ".txt";
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

void run(const Options& options) {
  const int frames = options.quick ? 30 : 300;
  std::vector<Contender> all = contenders(options.quick ? 32 : 256);
  take_frames(all, frames);
  std::ofstream file;
  if (!options.folder.empty()) {
    std::filesystem::create_directories(options.folder);
    file.exceptions(std::ios::failbit | std::ios::badbit);
    file.open(options.folder / "equal_cost.csv");
  }
  std::ostream& out = options.folder.empty() ? std::cout : file;
  out << "engine,setting,threads,ms_per_frame,seconds_per_simulated_second,strain_largest,strain_percentile_"
         "99,"
         "strain_median,stretch_stiffness,mean_fall,rms_speed\n";
  for (const Contender& one : all) {
    const std::vector<Vec3> positions = one.moved->positions();
    require_falling(one.sheet.scene, positions, frames * frame_seconds, one.step);
    one.moved->require_good();
    write_row(out, one, positions);
    if (!options.folder.empty()) write_points(options.folder / file_name(one), one.sheet, positions);
  }
}

}  // namespace
}  // namespace hooke::bench

int main(int argc, char** argv) {
  hooke::bench::Options options;
  CLI::App app("What a sheet costs in time for each frame, against how far it is stretched");
  app.add_flag("--quick", options.quick, "a small sheet for half a second: shows that it works");
  app.add_option("--out", options.folder, "folder for equal_cost.csv and the final sheets");
  CLI11_PARSE(app, argc, argv);
  try {
    hooke::bench::run(options);
  } catch (const std::exception& failure) {
    std::cerr << "FAILED: " << failure.what() << '\n';
    return 1;
  }
}
