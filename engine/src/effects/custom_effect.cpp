#include <array>
#include <limits>
#include <vector>

#include "effects/effect_functions.h"

namespace hooke {
namespace {

/// The masses [kg] that a user sees, in the user's order; infinite where pinned.
std::vector<double> masses(const Scene& scene) {
  std::vector<double> mass = scene.particles.mass;
  for (const Pin& pin : scene.pins) mass[pin.particle] = std::numeric_limits<double>::infinity();
  return mass;
}

/// Called with the strips of a sweep, on many threads.
template <class Real>
class ParallelCustomForce final : public CompiledEffect<Real> {
 public:
  ParallelCustomForce(const CustomEffect& effect, const EffectContext<Real>& context)
      : effect_(effect), users_(context.model.particles()), mass_(users_.size()) {
    const std::vector<double> mass = masses(context.scene);
    for (std::size_t i = 0; i < users_.size(); ++i) {
      users_[i] = context.model.order.user(i);
      mass_[i] = mass[users_[i]];
    }
  }

  void add_force(const Strip<Real>& strip, double time, StripForce<Real>& force) const override {
    constexpr std::size_t most = strip_blocks * block_size;
    const std::size_t count = strip.particles;
    std::array<std::array<double, most>, 6> values;
    const std::array<const Real*, 6> arrays{strip.x, strip.y, strip.z, strip.vx, strip.vy, strip.vz};
    for (std::size_t a = 0; a < 6; ++a) std::copy(arrays[a], arrays[a] + count, values[a].begin());
    std::array<std::array<double, most>, 3> forces;
    for (auto& coordinate : forces) std::fill(coordinate.begin(), coordinate.begin() + count, 0.0);
    const auto read = [&](std::size_t a) { return std::span<const double>(values[a].data(), count); };
    const auto write = [&](std::size_t a) { return std::span<double>(forces[a].data(), count); };
    effect_.add_forces({time, std::span(users_).subspan(strip.first, count), read(0), read(1), read(2),
                        read(3), read(4), read(5), std::span(mass_).subspan(strip.first, count), write(0),
                        write(1), write(2)});
    for (std::size_t i = 0; i < count; ++i) {
      force.x[i] += Real(forces[0][i]);
      force.y[i] += Real(forces[1][i]);
      force.z[i] += Real(forces[2][i]);
    }
  }

  bool calls_user() const override { return true; }

  Stage stage() const override {
    return {effect_.title,
            {},
            {"position", "velocity", "time"},
            {"force"},
            users_.capacity() * sizeof(Index) + mass_.capacity() * sizeof(double)};
  }

 private:
  CustomEffect effect_;
  std::vector<Index> users_;
  std::vector<double> mass_;
};

/// Called once for each evaluation, with everything.
template <class Real>
class SerialCustomForce final : public CompiledEffect<Real> {
 public:
  SerialCustomForce(const CustomEffect& effect, const EffectContext<Real>& context)
      : effect_(effect), mass_(masses(context.scene)), users_(mass_.size()), engine_(mass_.size()) {
    for (std::size_t i = 0; i < users_.size(); ++i) {
      users_[i] = Index(i);
      engine_[i] = context.model.order.engine(i);
    }
    for (auto& values : values_) values.resize(users_.size());
    for (auto& forces : forces_) forces.resize(users_.size());
    for (auto& forces : forces_in_order_) forces.resize(block_count(users_.size()) * block_size);
  }

  unsigned parts() const override { return has_force | needs_preparation; }

  void prepare(const State<Real>& state, double time, Executor&) override {
    const std::array<const Real*, 6> arrays{state.x(),  state.y(),  state.z(),
                                            state.vx(), state.vy(), state.vz()};
    for (std::size_t a = 0; a < 6; ++a) {
      for (std::size_t i = 0; i < users_.size(); ++i) values_[a][i] = double(arrays[a][engine_[i]]);
    }
    for (auto& forces : forces_) std::fill(forces.begin(), forces.end(), 0.0);
    effect_.add_forces({time, users_, values_[0], values_[1], values_[2], values_[3], values_[4], values_[5],
                        mass_, forces_[0], forces_[1], forces_[2]});
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t i = 0; i < users_.size(); ++i) forces_in_order_[c][engine_[i]] = Real(forces_[c][i]);
    }
  }

  void add_force(const Strip<Real>& strip, double, StripForce<Real>& force) const override {
    const std::array<Real*, 3> sums{force.x, force.y, force.z};
    for (std::size_t c = 0; c < 3; ++c) {
      const Real* const own = forces_in_order_[c].data() + strip.first;
      for (std::size_t i = 0; i < strip.particles; ++i) sums[c][i] += own[i];
    }
  }

  bool calls_user() const override { return true; }

  Stage stage() const override {
    return {effect_.title, {}, {"force of " + effect_.title}, {"force"}, users_.size() * 3 * sizeof(Real)};
  }

  Stage preparation_stage() const override {
    const std::size_t of_particle = 10 * sizeof(double) + 2 * sizeof(Index);
    return {effect_.title + " (called)",
            {},
            {"position", "velocity", "time"},
            {"force of " + effect_.title},
            users_.size() * of_particle};
  }

 private:
  CustomEffect effect_;
  std::vector<double> mass_;
  std::vector<Index> users_, engine_;  ///< 0, 1, 2, ...; and where each is in the engine's order
  std::array<std::vector<double>, 6> values_;
  std::array<std::vector<double>, 3> forces_;
  std::array<std::vector<Real>, 3> forces_in_order_;
};

}  // namespace

template <class Real>
EffectPointer<Real> compile_effect(const CustomEffect& effect, const EffectContext<Real>& context) {
  if (effect.parallel) return std::make_unique<ParallelCustomForce<Real>>(effect, context);
  return std::make_unique<SerialCustomForce<Real>>(effect, context);
}

template EffectPointer<float> compile_effect(const CustomEffect&, const EffectContext<float>&);
template EffectPointer<double> compile_effect(const CustomEffect&, const EffectContext<double>&);

void check_effect(const CustomEffect& effect, const Scene&, const ElementChecks& checks) {
  if (!effect.add_forces) checks.add("add_forces is not set", "give a function that adds forces to a batch");
}

void add_bounds(const CustomEffect&, const Scene&, HeldParticles&) {}

}  // namespace hooke
