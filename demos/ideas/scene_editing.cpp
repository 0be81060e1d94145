// scene_editing: a scene is edited while it runs. A spider's web catches a fly, and a hole is burnt into it.
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <hooke/hooke.h>
#include "ideas/account/account.h"
#include "ideas/account/show.h"
#include "ideas/props/ball.h"
#include "ideas/props/web.h"

namespace {

using hooke::Index, hooke::Scene, hooke::Vec3;
using Run = hooke::Simulation<double>;
constexpr double step = 1e-4;  // [s]

/// A scene that was made from another: particle i was number was[i] there; those behind are new.
struct Edited {
  Scene scene;
  std::vector<Index> was;
};

/// What is left without the particles that go, and without what they held.
Edited without(const Scene& scene, const std::function<bool(Index)>& goes) {
  Edited edited;
  edited.scene.effects = scene.effects;
  std::vector<Index> now(scene.particles.size());
  for (Index i = 0; i < now.size(); ++i) {
    if (goes(i)) continue;
    now[i] = edited.scene.add_particle(scene.particles.mass[i], scene.particles.position[i]);
    edited.was.push_back(i);
  }
  const hooke::Springs& springs = scene.springs;
  for (std::size_t s = 0; s < springs.size(); ++s) {
    if (goes(springs.first[s]) || goes(springs.second[s])) continue;
    edited.scene.add_spring(now[springs.first[s]], now[springs.second[s]], springs.stiffness[s],
                            springs.rest_length[s], springs.damping_of(s));
  }
  for (const hooke::Pin& pin : scene.pins) {
    if (!goes(pin.particle)) edited.scene.pin(now[pin.particle], pin.path);
  }
  for (const auto& [a, b, c] : scene.triangles) {
    if (!goes(a) && !goes(b) && !goes(c)) edited.scene.triangles.push_back({now[a], now[b], now[c]});
  }
  return edited;
}

/// The edited scene, running on from where the other is. New particles begin as their scene says.
Run go_on(const Run& before, const Edited& edited) {
  Run after(edited.scene, before.settings());
  const hooke::Snapshot<double> old = before.snapshot();
  hooke::Snapshot<double> state = after.snapshot();
  for (std::size_t i = 0; i < 3 * edited.was.size(); ++i) {
    state.positions[i] = old.positions[3 * edited.was[i / 3] + i % 3];
    state.velocities[i] = old.velocities[3 * edited.was[i / 3] + i % 3];
  }
  state.time = old.time, state.step = old.step, state.remainder = old.remainder;
  after.restore(state);
  return after;
}

/// Whether what was not edited has the same bits in both.
bool goes_on(const Run& before, const Run& after, const std::vector<Index>& was) {
  const hooke::Snapshot<double> old = before.snapshot(), now = after.snapshot();
  bool same = old.time == now.time;
  for (std::size_t i = 0; i < 3 * was.size(); ++i) {
    const std::size_t j = 3 * was[i / 3] + i % 3;
    same = same && old.positions[j] == now.positions[i] && old.velocities[j] == now.velocities[i];
  }
  return same;
}

/// What goes with some particles [J]: their own energy, and that of the springs they hold.
double energy_with(const Scene& scene, const Run& run, const std::function<bool(Index)>& goes) {
  const hooke::Snapshot<double> state = run.snapshot();
  const auto x = [&](Index i) { return Vec3(state.positions.data() + 3 * i); };
  double energy = 0.0;
  for (Index i = 0; i < scene.particles.size(); ++i) {
    const Vec3 v(state.velocities.data() + 3 * i);
    if (goes(i)) energy += scene.particles.mass[i] * (v.squaredNorm() / 2 + 9.81 * x(i).y());
  }
  const hooke::Springs& springs = scene.springs;
  for (std::size_t s = 0; s < springs.size(); ++s) {
    const Index a = springs.first[s], b = springs.second[s];
    const double longer = (x(a) - x(b)).norm() - springs.rest_length[s];
    if (goes(a) || goes(b)) energy += springs.stiffness[s] * longer * longer / 2;
  }
  return energy;
}

}  // namespace

void scene_editing(hooke::ideas::Account& account) {
  const auto nothing = [](Index) { return false; };
  const auto run_on = [&](Run& run, double time) {
    const double left = std::max(0.0, account.seconds(time) - run.time());
    account.measure([&] { return run.step(std::uint64_t(std::lround(left / step))); });
  };
  const Scene web = hooke::ideas::make_web();
  Run hanging(web, {.step = step, .threads = 1});
  run_on(hanging, 0.3);
  Run rebuilt = go_on(hanging, without(web, nothing));
  run_on(hanging, 0.31), run_on(rebuilt, 0.31);
  account.claim(rebuilt.state_hash() == hanging.state_hash(),
                "rebuilt without an edit, it goes on with the same bits");

  // A fly comes, and sticks to all threads near to it.
  Edited caught = without(web, nothing);
  const Vec3 place(-0.16, 0.12, 0);  // [m]
  const Index fly = caught.scene.add_particle(4e-3, place, {0, 0, -14});
  const hooke::Snapshot<double> hangs = hanging.snapshot();
  for (Index i = 0; i < web.particles.size(); ++i) {
    const double distance = (Vec3(hangs.positions.data() + 3 * i) - place).norm();
    if (distance < 0.03) caught.scene.add_spring(i, fly, hooke::ideas::web_thread / distance, distance, 1e-3);
  }
  Run with_fly = go_on(hanging, caught);
  const Vec3 gained = with_fly.momentum() - hanging.momentum();
  account.claim(goes_on(hanging, with_fly, caught.was) && (gained - Vec3(0, 0, -0.056)).norm() < 1e-12,
                "with the fly came its %.3f N s, and nothing else changed", gained.norm());
  run_on(with_fly, 0.335);

  // A spark burns a hole.
  hooke::ideas::Moment before = hooke::ideas::moment(caught.scene, with_fly);
  const auto burns = [&](Index i) {
    return std::hypot(before.positions[3 * i] - 0.17, before.positions[3 * i + 1] + 0.12) < 0.1;
  };
  const Edited burnt = without(caught.scene, burns);
  Run with_hole = go_on(with_fly, burnt);
  const double lost = with_fly.energy().total() - with_hole.energy().total();
  account.claim(goes_on(with_fly, with_hole, burnt.was) &&
                    std::abs(lost - energy_with(caught.scene, with_fly, burns)) < 1e-9,
                "with %zu particles went the %.4f J that they and their threads held",
                caught.scene.particles.size() - burnt.scene.particles.size(), lost);
  run_on(with_hole, 0.6);
  account.print_cost(with_hole);
  hooke::ideas::Moment after = hooke::ideas::moment(burnt.scene, with_hole);
  for (hooke::ideas::Moment* moment : {&before, &after}) {
    const float* last = moment->positions.data() + moment->positions.size() - 3;  // the fly
    hooke::ideas::add_ball(*moment, {last[0], last[1], last[2]}, 0.018);
  }
  const hooke::picture::Look look{.particles = false, .full_strain = 0.2};
  hooke::ideas::show(account.picture(), {before, after}, {.azimuth = 0.5, .elevation = 0.1, .look = look});
}

int main(int argc, char** argv) {
  return hooke::ideas::give_account(argc, argv, "scene_editing: a fly and a spark", scene_editing);
}
