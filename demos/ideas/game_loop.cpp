// game_loop: frames of any length in, whole steps out. A flag flies at 60 frames a second, from an
// interleaved vertex buffer.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <thread>
#include <vector>

#include <hooke/hooke.h>
#include "ideas/account/account.h"
#include "ideas/account/show.h"

namespace {

using Seconds = std::chrono::duration<double>;

/// As a renderer wants it. The engine writes the position and leaves the rest alone.
struct Vertex {
  float position[3];
  float texture[2];
};

constexpr hooke::Index columns = 60, rows = 40;
constexpr double step = 3e-4;              // [s]
constexpr std::uint64_t most_steps = 111;  // for one frame: two frames' worth
constexpr int slow_frame = 45;             // the one in which the game loads a level

/// Gusts that run along the flag and turn from side to side.
hooke::Vec3 wind(const hooke::Vec3& x, double time) {
  constexpr double strength = 9e-4;  // [N] on each particle
  const double gust = std::sin(7 * x.x() - 9 * time) + 0.5 * std::sin(11 * x.x() + 3 * x.y() - 16 * time);
  return strength * hooke::Vec3(2.2 + 0.5 * std::sin(3 * time), 0.25, 1.4 * gust);
}

hooke::Scene make_flag() {
  hooke::Scene scene;
  const auto flag = hooke::add(scene, hooke::ClothGrid{.columns = columns,
                                                       .rows = rows,
                                                       .spacing = 0.025,
                                                       .areal_density = 0.15,
                                                       .stretch = 150,
                                                       .shear = 60,
                                                       .bend = 1,
                                                       .damping = 2e-3});
  for (hooke::Index row = 0; row < rows; ++row) scene.pin(flag.at(0, row));
  scene.effects = {hooke::Gravity{}, hooke::Drag{.coefficient = 2.2e-4}, hooke::Field{wind}};
  return scene;
}

/// Whether every vertex lies where it should between the last two states, and nothing else of it was touched.
bool is_between(const hooke::Simulation<float>& simulation, const std::vector<Vertex>& vertices,
                double share) {
  std::vector<float> before(3 * vertices.size()), after(before);
  simulation.copy_positions(before.data(), 3 * sizeof(float), 0);
  simulation.copy_positions(after.data(), 3 * sizeof(float), 1);
  bool all = true;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const double wanted = before[i] + share * (double(after[i]) - double(before[i]));
    all = all && std::abs(double(vertices[i / 3].position[i % 3]) - wanted) < 1e-6;
  }
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    all = all && vertices[i].texture[0] == float(i % columns) / columns &&
          vertices[i].texture[1] == float(i / columns) / rows;
  }
  return all;
}

}  // namespace

void game_loop(hooke::ideas::Account& account) {
  const hooke::Scene scene = make_flag();
  hooke::Simulation simulation(scene, {.step = step, .max_steps_per_advance = most_steps});
  std::vector<Vertex> vertices(scene.particles.size());
  for (std::size_t i = 0; i < vertices.size(); ++i)
    vertices[i] = {{}, {float(i % columns) / columns, float(i / columns) / rows}};

  const int frames = std::max(1, int(std::lround(60 * account.seconds(1.5))));
  std::vector<double> costs;                               // [s] of the engine in each frame
  double asked = 0.0, dropped = 0.0, interpolation = 0.0;  // [s], [s], [1]
  bool all_between = true;
  auto last = std::chrono::steady_clock::now();
  for (int frame = 0; frame < frames; ++frame) {
    // The rest of a game does its work, and waits for the screen.
    std::this_thread::sleep_until(last + (frame == slow_frame ? Seconds(0.15) : Seconds(1.0 / 60)));
    const auto now = std::chrono::steady_clock::now();
    const double frame_seconds = Seconds(now - last).count();
    last = now;

    const hooke::Report report = account.measure([&] { return simulation.advance(frame_seconds); });
    simulation.copy_positions(vertices[0].position, sizeof(Vertex), report.interpolation);
    costs.push_back(Seconds(std::chrono::steady_clock::now() - now).count());

    asked += frame_seconds, dropped += report.dropped_seconds, interpolation = report.interpolation;
    all_between = all_between && is_between(simulation, vertices, report.interpolation);
    if (frame == slow_frame)
      std::printf("  a slow frame of %.0f ms: %llu steps in %.1f ms, %.0f ms dropped\n", 1e3 * frame_seconds,
                  static_cast<unsigned long long>(report.steps_taken), 1e3 * costs.back(),
                  1e3 * report.dropped_seconds);
  }
  std::sort(costs.begin(), costs.end());
  std::printf("  %d frames; the engine takes %.2f ms of a frame's 16.7 ms (median), %.2f ms at most\n",
              frames, 1e3 * costs[costs.size() / 2], 1e3 * costs.back());
  const double accounted = simulation.time() + dropped + interpolation * step;
  account.claim(std::abs(accounted - asked) < 1e-6,
                "no time is lost: %.3f s simulated, %.3f s dropped, the rest waits", simulation.time(),
                dropped);
  account.claim(all_between, "every vertex was drawn between two states, and its other data left alone");
  account.print_cost(simulation);
  hooke::ideas::show(account.picture(), {hooke::ideas::moment(scene, simulation, interpolation)},
                     {.azimuth = 0.3, .elevation = 0.1});
}

int main(int argc, char** argv) {
  return hooke::ideas::give_account(argc, argv, "game_loop: a flag at 60 frames a second", game_loop);
}
