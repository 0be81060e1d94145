// What a picture costs the thread that draws it: CPU time of uploading positions and drawing them, apart from
// what the OpenGL driver spends within its own functions. Each picture is checked before it is timed: the
// cloth must cover the area that its four corners span.

#include <benchmark/benchmark.h>

#include <cmath>
#include <iostream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <epoxy/gl.h>

#include "bench_scenes.h"
#include "driver_clock.h"
#include "picture/multisampled_target.h"
#include "picture/offscreen_context.h"
#include "picture/picture_error.h"
#include "picture/renderer.h"

namespace hooke::bench {
namespace {

using namespace hooke::picture;

constexpr int width = 960, height = 540;

std::vector<float> positions_of(const Simulation<float>& simulation) {
  std::vector<float> positions(3 * simulation.particle_count());
  simulation.copy_positions(positions.data(), 3 * sizeof(float));
  return positions;
}

/// A flat cloth, the same cloth a little later, and what draws them.
class Case {
 public:
  explicit Case(Index n) : columns_(n) {
    BenchScene bench = cloth(n);
    Simulation<float> simulation(bench.scene, {.step = bench.step, .threads = 1});
    moments_[0] = positions_of(simulation);
    simulation.step(200);
    moments_[1] = positions_of(simulation);
    Subject subject = subject_of(bench.scene);
    camera_ = fitted(Camera{.up = subject.up, .elevation = 1.1}, moments_[0], double(width) / height);
    look_ = look_for(subject);
    const OffscreenContext::Current current(context_);
    target_.emplace(width, height);
    renderer_.emplace(std::move(subject));
  }
  ~Case() {
    const OffscreenContext::Current current(context_);
    renderer_.reset();
    target_.reset();
  }

  const OffscreenContext& context() const { return context_; }

  /// Takes and draws the one or the other moment. The context must be current.
  void draw(std::size_t moment) {
    renderer_->upload(moments_[moment % 2]);
    target_->begin();
    renderer_->draw(camera_, look_, width, height);
  }

  /// Whether the flat cloth covers what it should, within 5 %, and OpenGL has no complaint.
  bool is_right() {
    draw(0);
    const Image with = target_->image();
    Look empty = look_;
    empty.surface = empty.pins = empty.shadow = false;
    target_->begin();
    renderer_->draw(camera_, empty, width, height);
    const Image without = target_->image();
    Look bare = empty;
    bare.surface = true;
    target_->begin();
    renderer_->draw(camera_, bare, width, height);
    const double expected = expected_pixels();
    return std::abs(pixels_that_differ(target_->image(), without) - expected) <= 0.05 * expected &&
           pixels_that_differ(with, without) > expected && glGetError() == GL_NO_ERROR;
  }

 private:
  static double pixels_that_differ(const Image& a, const Image& b) {
    int count = 0;
    for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
      count += a.rgb[i] != b.rgb[i] || a.rgb[i + 1] != b.rgb[i + 1] || a.rgb[i + 2] != b.rgb[i + 2];
    }
    return count;
  }

  /// The area between the four corners of the flat cloth, as the camera sees them.
  double expected_pixels() const {
    const Index last = columns_ - 1;
    const Index corners[] = {0, last, last * columns_ + last, last * columns_};
    double twice = 0.0;
    for (int k = 0; k < 4; ++k) {
      const Vec3 a = seen(corners[k]), b = seen(corners[(k + 1) % 4]);
      twice += a.x() * b.y() - b.x() * a.y();
    }
    return std::abs(twice) / 2.0 * width / 2.0 * height / 2.0;
  }

  Vec3 seen(Index particle) const {
    const float* const x = moments_[0].data() + 3 * particle;
    return camera_.project(Vec3(x[0], x[1], x[2]), double(width) / height);
  }

  Index columns_;
  std::vector<float> moments_[2];
  Camera camera_;
  Look look_;
  OffscreenContext context_;
  std::optional<MultisampledTarget> target_;
  std::optional<Renderer> renderer_;
};

void time_drawing(benchmark::State& state, Case& timed) {
  const OffscreenContext::Current current(timed.context());
  if (!timed.is_right()) {
    state.SkipWithError("the cloth does not cover what it should");
    return;
  }
  timed.draw(1);
  double total_driver = 0.0;
  std::size_t frame = 0;
  unsigned long calls = 0;
  for (auto _ : state) {
    const DriverClock driver;
    const double start = thread_seconds();
    timed.draw(frame++);
    const double all = thread_seconds() - start;
    state.SetIterationTime(all - driver.seconds());
    total_driver += driver.seconds();
    calls = driver.calls();
    glFinish();  // the card works behind the thread's back: it must not fall behind
  }
  if (glGetError() != GL_NO_ERROR) state.SkipWithError("OpenGL reports an error");
  state.counters["driver_ms"] = benchmark::Counter(1e3 * total_driver, benchmark::Counter::kAvgIterations);
  state.counters["gl_calls"] = double(calls);
}

void register_all() {
  for (const auto& [n, pictures] : {std::pair(64u, 50), std::pair(256u, 50), std::pair(1024u, 5)}) {
    const auto run = [size = Index(n)](benchmark::State& state) {
      Case timed(size);
      time_drawing(state, timed);
    };
    const std::string name = "cloth_" + std::to_string(n) + "/upload_and_draw";
    // So many, as the time that decides otherwise is a small part of what a picture takes.
    benchmark::RegisterBenchmark(name.c_str(), run)
        ->UseManualTime()
        ->Iterations(pictures)
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace
}  // namespace hooke::bench

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  try {
    const hooke::picture::OffscreenContext can_draw;
  } catch (const hooke::picture::PictureError& error) {
    std::cerr << "skipped: " << error.what() << '\n';
    return 0;
  }
  hooke::bench::register_all();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
