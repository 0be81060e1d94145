// hung_box: a rigid body of the host's, hung from a rope. The box is the demo's own: it takes what pulls at
// its frame, moves itself, and gives its pose back, step by step. First it hangs at rest, then it swings.
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include <hooke/hooke.h>
#include "ideas/account/account.h"
#include "ideas/account/show.h"

namespace {

using hooke::Vec3;

constexpr double g = 9.81;                                                                // [m/s^2]
constexpr double box_mass = 1.0;                                                          // [kg]
constexpr hooke::Index knots = 12;                                                        // of the rope
constexpr double rope = 0.55, rope_mass = 0.01, knot = rope_mass / knots, stretch = 1e4;  // [m], [kg], [N/m]
const Vec3 half(0.06, 0.09, 0.04);                                                        // of the box [m]

/// A rigid body with a mass and moments of inertia along its own axes, moved by a force and a torque.
struct Body {
  double mass;
  Vec3 inertia;  // [kg m^2]
  Vec3 start;    // its centre of mass in the scene [m]
  hooke::RigidPose pose = {};
  Vec3 velocity = Vec3::Zero(), momentum = Vec3::Zero();  // [m/s], of its turning [N m s]

  Vec3 centre() const { return start + pose.displacement; }
  Vec3 spin() const {
    const Vec3 own = pose.rotation.conjugate() * momentum;
    return pose.rotation * Vec3(own.cwiseQuotient(inertia));
  }
  /// As the engine's own particles are moved: velocities first, then places with the new velocities.
  void move(const hooke::FrameLoad& load, double h) {
    velocity += h / mass * load.force;
    momentum += h * load.torque;
    pose.displacement += h * velocity;
    const Vec3 turn = h * spin();
    if (turn.norm() > 0.0)
      pose.rotation = (Eigen::AngleAxisd(turn.norm(), turn.normalized()) * pose.rotation).normalized();
  }
  double kinetic() const { return 0.5 * mass * velocity.squaredNorm() + 0.5 * momentum.dot(spin()); }
};

/// The rope down to the middle of the box's lid, and the corners of the box, which are drawn and weigh next
/// to nothing. The rope is as long as the weight below stretches it.
struct Hung {
  hooke::Scene scene;
  std::vector<hooke::Index> on_box;
  double length = 0.0;  // of the stretched rope [m]
  std::size_t frame = 0;
  Body body;
};

void add_corners(hooke::Scene& scene, const Vec3& centre, std::vector<hooke::Index>& on_box) {
  const auto first = hooke::Index(scene.particles.size());
  for (unsigned i = 0; i < 8; ++i) {
    const Vec3 side((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
    on_box.push_back(scene.add_particle(1e-6, centre + half.cwiseProduct(side)));
  }
  constexpr unsigned sides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                    {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& [a, b, c, d] : sides) {
    scene.triangles.push_back({first + a, first + b, first + c});
    scene.triangles.push_back({first + a, first + c, first + d});
  }
}

/// What the box and all particles on it are together. The frame turns about their centre of mass.
Body body_of(const hooke::Scene& scene, const std::vector<hooke::Index>& on_box, const Vec3& box) {
  Body body{box_mass, Vec3::Zero(), box_mass * box};
  for (const hooke::Index i : on_box) {
    body.mass += scene.particles.mass[i];
    body.start += scene.particles.mass[i] * scene.particles.position[i];
  }
  body.start /= body.mass;
  const auto add = [&](double mass, const Vec3& from_centre) {
    const Vec3 square = from_centre.cwiseAbs2();
    body.inertia += mass * Vec3(square.y() + square.z(), square.z() + square.x(), square.x() + square.y());
  };
  add(box_mass / 3, half);
  add(box_mass, box - body.start);
  for (const hooke::Index i : on_box) add(scene.particles.mass[i], scene.particles.position[i] - body.start);
  return body;
}

Hung hang() {
  Hung hung;
  for (hooke::Index i = 0; i < knots; ++i) {
    const double below = box_mass + (knots - i) * knot;  // [kg]
    if (i > 0) hung.length += rope / (knots - 1) + below * g / stretch;
    hung.scene.add_particle(knot, {0, -hung.length, 0});
    if (i > 0) hung.scene.add_spring(i - 1, i, stretch, rope / (knots - 1));
  }
  hung.scene.pin(0);
  hung.on_box = {knots - 1};
  const Vec3 box(0, -hung.length - half.y(), 0);
  add_corners(hung.scene, box, hung.on_box);
  hung.body = body_of(hung.scene, hung.on_box, box);
  hung.frame = 1;
  hung.scene.effects = {hooke::Gravity{{0, -g, 0}},
                        hooke::FrameAttachment{.particles = hung.on_box, .origin = hung.body.start}};
  return hung;
}

/// The slower of the two modes of a body that hangs on a light rope, and how far the body turns in it for
/// each angle of the rope: a double pendulum.
struct Mode {
  double period, turn;
};
Mode slow_mode(const Hung& hung) {
  const double l = hung.length, m = hung.body.mass, d = -hung.length - hung.body.start.y();
  const double i = hung.body.inertia.z() + m * d * d;
  // (m l g - w2 m l^2) (m g d - w2 i) = (w2 m l d)^2
  const double a = m * l * l * i - m * l * d * m * l * d, b = m * l * g * i + m * l * l * m * g * d;
  const double c = m * l * g * m * g * d, w2 = (b - std::sqrt(b * b - 4 * a * c)) / (2 * a);
  return {2 * std::numbers::pi / std::sqrt(w2), (m * l * g - w2 * m * l * l) / (w2 * m * l * d)};
}

/// Of the rope and the body together [J]. What is on the box is counted by both the engine and the body.
double energy(const hooke::Simulation<double>& simulation, const Hung& hung) {
  std::vector<Vec3> place(simulation.particle_count()), velocity(place.size());
  simulation.copy_positions(place[0].data(), sizeof(Vec3));
  simulation.copy_velocities(velocity[0].data(), sizeof(Vec3));
  double sum =
      simulation.energy().total() + hung.body.kinetic() + hung.body.mass * g * hung.body.centre().y();
  for (const hooke::Index i : hung.on_box)
    sum -= hung.scene.particles.mass[i] * (0.5 * velocity[i].squaredNorm() + g * place[i].y());
  return sum;
}

/// One step of both. The box's own weight is no force of the engine's.
hooke::Report step(hooke::Simulation<double>& simulation, Hung& hung) {
  hooke::FrameLoad load = simulation.pull_on_frame(hung.frame);
  const Vec3 weight(0, -box_mass * g, 0);
  const Vec3 box = hung.body.pose.rotation * Vec3(0, -hung.length - half.y() - hung.body.start.y(), 0);
  load.force += weight;
  load.torque += box.cross(weight);
  hung.body.move(load, simulation.settings().step);
  simulation.move_frame(hung.frame, hung.body.pose);
  return simulation.step();
}

/// Turns the rope, and the box with it, as the slow mode does.
void incline(hooke::Simulation<double>& simulation, Hung& hung, double angle, double turn) {
  const Eigen::Quaterniond of_rope(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
  std::vector<hooke::Index> hanging;
  for (hooke::Index i = 1; i + 1 < knots; ++i) hanging.push_back(i);
  simulation.teleport(hanging, {Vec3::Zero(), of_rope});
  const Vec3 lid(0, -hung.length, 0);
  hung.body.pose.rotation = Eigen::AngleAxisd(turn * angle, Vec3::UnitZ());
  hung.body.pose.displacement =
      of_rope * lid + hung.body.pose.rotation * Vec3(hung.body.start - lid) - hung.body.start;
  simulation.teleport(
      hung.on_box, {hung.body.centre() - hung.body.pose.rotation * hung.body.start, hung.body.pose.rotation});
}

}  // namespace

void hung_box(hooke::ideas::Account& account) {
  constexpr double settled = 1.0, h = 1e-4, angle = 0.12;
  Hung hung = hang();
  hooke::Simulation<double> simulation(hung.scene, {.step = h, .threads = 1});
  const Mode mode = slow_mode(hung);
  double moved = 0.0;  // [m]
  while (simulation.time() < account.seconds(settled)) {
    account.measure([&] { return step(simulation, hung); });
    moved = std::max(moved, hung.body.pose.displacement.norm());
  }
  const hooke::FrameLoad load = simulation.carried_force(hung.frame);
  account.claim(moved < 1e-6, "a box of %.0f kg hangs %.4f m below and stays there to %.1e m", box_mass,
                -hung.body.centre().y(), moved);
  account.claim(std::abs(load.force.y() - box_mass * g) < 1e-4 * g,
                "the rope holds it up with %.4f N: its weight", load.force.y());

  incline(simulation, hung, angle, mode.turn);
  const double begin = simulation.time(), before = energy(simulation, hung);
  const double swung = 0.5 * hung.body.mass * g * hung.length * angle * angle;  // [J]
  const double periods = 4.0, seconds = account.seconds(settled + (periods + 0.5) * mode.period);
  double last = 0.0, most = 0.0;
  int crossings = 0;
  std::vector<hooke::ideas::Moment> moments{hooke::ideas::moment(hung.scene, simulation)};
  while (simulation.time() < seconds) {
    const double x = hung.body.centre().x();
    account.measure([&] { return step(simulation, hung); });
    const double now = hung.body.centre().x();
    most = std::max(most, std::abs(energy(simulation, hung) - before));
    if (x > 0.0 && now <= 0.0) {
      last = simulation.time() - begin - h * now / (now - x);
      ++crossings;
    }
  }
  moments.push_back(hooke::ideas::moment(hung.scene, simulation));
  if (account.runs_in_full(settled + (periods + 0.5) * mode.period)) {
    const double period = last / (crossings - 0.75);
    account.claim(std::abs(period / mode.period - 1.0) < 0.01,
                  "it swings in %.4f s; as a double pendulum it would in %.4f s", period, mode.period);
  }
  account.claim(most < 0.01 * swung, "energy of both together stays within %.2f %% of the swing's",
                100 * most / swung);
  account.print_cost(simulation);
  hooke::ideas::show(account.picture(), moments, {.azimuth = 0.4, .elevation = 0.1});
}

int main(int argc, char** argv) {
  return hooke::ideas::give_account(argc, argv, "hung_box: a rigid body of the host's hangs on a rope",
                                    hung_box);
}
