#include "stability/energy_watch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <hooke/stability.h>

#include "effects/effect_functions.h"
#include "kernels/flush_subnormals.h"
#include "parallel/sum.h"
#include "stability/step_division.h"

namespace hooke {
namespace {

/// Parts of steps between looks.
constexpr std::uint64_t parts_between_looks = 512;

/// In larger scenes the memory of one more state counts: they are watched where that is asked for.
constexpr std::size_t most_watched_unasked = 500'000;

/// Springs strained by less than this hold too little energy to speak of.
constexpr double small_strain = 1e-3;

Vec3 gravity_of(const Scene& scene) {
  Vec3 sum = Vec3::Zero();
  for (const Effect& effect : scene.effects) {
    if (const auto* gravity = std::get_if<Gravity>(&effect)) sum += gravity->acceleration;
  }
  return sum;
}

/// The energy [J] of springs under a small strain, with what rounding of positions adds to it, and of what
/// gravity gives in a step, in which methods see it late or early.
template <class Real>
double slack_of(const Scene& scene, const Vec3& gravity, double step) {
  double sum = 0.0;
  for (std::size_t s = 0; s < scene.springs.size(); ++s) {
    const Vec3& a = scene.particles.position[scene.springs.first[s]];
    const Vec3& b = scene.particles.position[scene.springs.second[s]];
    const double length = std::max(scene.springs.rest_length[s], (b - a).norm());
    const double rounding = 64.0 * double(std::numeric_limits<Real>::epsilon()) * a.norm();
    const double stretch = std::hypot(small_strain * length, rounding);
    sum += 0.5 * scene.springs.stiffness[s] * stretch * stretch;
  }
  double mass = 0.0;
  for (const double m : scene.particles.mass) mass += m;
  return sum + 4.0 * mass * gravity.squaredNorm() * step * step;
}

/// The integral of the square of a path's speed [m^2/s].
double squared_speed(const std::vector<Keyframe>& path, double from, double to) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Keyframe &a = path[i], &b = path[i + 1];
    const double time = std::min(b.time, to) - std::max(a.time, from);
    if (time > 0.0) sum += time * ((b.displacement - a.displacement) / (b.time - a.time)).squaredNorm();
  }
  return sum;
}

}  // namespace

template <class Real>
void EnergyWatch<Real>::Sums::add(const Sums& other) {
  kinetic += other.kinetic;
  gravity += other.gravity;
}

template <class Real>
EnergyWatch<Real>::EnergyWatch(const Scene& scene, const Model<Real>& model, Executor& executor, double step,
                               const State<Real>& start)
    : model_(model), executor_(executor), gravity_(gravity_of(scene)), good_(start) {
  slack_ = slack_of<Real>(scene, gravity_, step);
  constexpr std::size_t not_moving = ~std::size_t{0};
  std::vector<std::size_t> pin_of;
  for (const Pin& pin : scene.pins) {
    if (pin.path.size() < 2) continue;
    pin_of.resize(scene.particles.size(), not_moving);
    pin_of[pin.particle] = pins_.size();
    pins_.push_back({pin.path});
  }
  for (std::size_t s = 0; s < scene.springs.size() && !pins_.empty(); ++s) {
    for (const Index end : {scene.springs.first[s], scene.springs.second[s]}) {
      if (pin_of[end] == not_moving) continue;
      pins_[pin_of[end]].stiffness += scene.springs.stiffness[s];
      pins_[pin_of[end]].damping += scene.springs.damping_of(s);
    }
  }
  sums(start);  // takes the room that it needs
}

template <class Real>
void EnergyWatch<Real>::begin(const State<Real>& state, std::uint64_t steps, double energy) {
  time_ = state.time;
  put_in_ = energy;
  keep(state, steps);
}

template <class Real>
void EnergyWatch<Real>::add_work(double work) {
  put_in_ += std::max(work, 0.0);
}

template <class Real>
void EnergyWatch<Real>::keep(const State<Real>& state, std::uint64_t steps) {
  good_ = state;
  good_steps_ = steps;
  good_put_in_ = put_in_;
}

template <class Real>
void EnergyWatch<Real>::go_back() {
  time_ = good_.time;
  put_in_ = good_put_in_;
}

template <class Real>
std::uint64_t EnergyWatch<Real>::steps_until_look(std::uint64_t steps, std::uint64_t parts) const {
  const std::uint64_t period = std::max<std::uint64_t>(1, parts_between_looks / parts);
  const std::uint64_t since = steps - good_steps_;
  return since < period ? period - since : 1;
}

template <class Real>
auto EnergyWatch<Real>::sums(const State<Real>& state) -> Sums {
  const std::size_t blocks = block_count(state.size());
  const auto part = [&](std::size_t begin, std::size_t end) {
    const FlushSubnormals flush;
    std::array<double, block_size> kinetic{}, gravity{};
    for (std::size_t block = begin; block < end; ++block) {
      const Real* const inverse_mass = model_.inverse_mass_awake().block(block);
      const std::size_t i = block * block_size;
      const Real *const x = state.x() + i, *const y = state.y() + i, *const z = state.z() + i;
      const Real *const vx = state.vx() + i, *const vy = state.vy() + i, *const vz = state.vz() + i;
      for (std::size_t lane = 0; lane < block_size; ++lane) {
        const double mass = inverse_mass[lane] > Real(0) ? 1.0 / double(inverse_mass[lane]) : 0.0;
        const double square = double(vx[lane]) * double(vx[lane]) + double(vy[lane]) * double(vy[lane]) +
                              double(vz[lane]) * double(vz[lane]);
        const double fall =
            gravity_.x() * double(x[lane]) + gravity_.y() * double(y[lane]) + gravity_.z() * double(z[lane]);
        kinetic[lane] += 0.5 * mass * square;
        gravity[lane] -= mass * fall;
      }
    }
    Sums sum;
    for (std::size_t lane = 0; lane < block_size; ++lane) sum.add({kinetic[lane], gravity[lane]});
    return sum;
  };
  // Not worth a thread's attention.
  if (blocks <= block_run) return part(0, blocks);
  return sum_in_order<Sums>(executor_, blocks, block_run, part, sums_);
}

template <class Real>
double EnergyWatch<Real>::work_of_pins(double from, double to, double energy) const {
  double pulled = 0.0, damped = 0.0;
  for (const PulledPin& pin : pins_) {
    const double square = squared_speed(pin.path, from, to);
    pulled += pin.stiffness * square;
    damped += 0.25 * pin.damping * square;
  }
  if (pulled == 0.0) return damped;
  // The integral of a root is at most the root of the time times the integral (Cauchy and Schwarz).
  const double root = std::sqrt((to - from) * pulled);
  return 2.0 * std::sqrt(std::max(energy, 0.0)) * root + root * root + damped;
}

template <class Real>
auto EnergyWatch<Real>::balance(const State<Real>& state, double factor) -> Balance {
  const Sums now = sums(state);
  const double there = std::max(put_in_ - now.gravity, 0.0);
  if (!pins_.empty()) put_in_ += work_of_pins(time_, state.time, factor * there);
  time_ = state.time;
  const double put_in = std::max(put_in_ - now.gravity, 0.0);
  return {now.kinetic, put_in, factor * put_in + slack_};
}

double energy_factor(double step, double longest) {
  constexpr double most = 1e8, beyond = 100.0;
  const double share = longest > 0.0 ? step / longest : 2.0;
  if (share > 1.0 + 1e-9) return beyond;
  return share >= 1.0 ? most : std::min(most, 4.0 * (1.0 + share) / (1.0 - share));
}

bool is_watched(const Scene& scene, const Settings& settings) {
  const bool asked_for = settings.on_trouble || settings.decide_on_trouble;
  if (!asked_for && scene.particles.size() > most_watched_unasked) return false;
  if (on_trouble(settings) == OnTrouble::ignore && !settings.decide_on_trouble) return false;
  if (std::holds_alternative<DormandPrince>(settings.method) || solves_equations(settings.method))
    return false;
  return !does_unknown_work_in(scene);
}

template class EnergyWatch<float>;
template class EnergyWatch<double>;

}  // namespace hooke
