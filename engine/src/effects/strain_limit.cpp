#include <algorithm>
#include <string>

#include "effects/effect_functions.h"
#include "effects/immovable.h"
#include "effects/named_springs.h"
#include "effects/strain_sweeps.h"
#include "frames/carried.h"
#include "scene/number_text.h"

namespace hooke {
namespace {

/// More than this in a step take too long to be meant.
constexpr std::uint64_t most_sweeps = 1'000'000;

/// Of a change of positions: how much kinetic energy is gained by changing velocities in proportion.
struct EnergyGain {
  double linear = 0.0, square = 0.0;  ///< sums of m d.v [J s] and m d^2 [J s^2]

  void add(const EnergyGain& other) {
    linear += other.linear;
    square += other.square;
  }
};

template <class Real>
class StrainLimitCorrection final : public CompiledEffect<Real> {
 public:
  StrainLimitCorrection(const StrainLimit& limit, const EffectContext<Real>& context)
      : model_(context.model),
        sweeps_(limit, context.scene, context.model.order),
        inverse_mass_(inverse_masses_of_free(context.scene, context.model.order)),
        scripted_(scripted_times(context.scene, context.model.order)),
        pins_move_(!context.model.moving_pins.empty() || !scripted_.empty() ||
                   has_attachments(context.scene)),
        frames_(context.model.frames),
        particles_(inverse_mass_.size()),
        pulled_(has_attachments(context.scene) ? inverse_mass_.size() : 0),
        gains_((inverse_mass_.size() + particles_in_run - 1) / particles_in_run) {}

  unsigned parts() const override { return corrects_everything; }

  void correct(const StepResult<Real>& result, Executor& executor) override {
    if (excess_of(result.next, executor).springs == 0) return;
    load(result, executor);
    std::uint64_t sweeps = 0;
    std::fill(pulled_.begin(), pulled_.end(), Vec3::Zero());
    const StrainExcess left =
        sweeps_.run(particles_, sweeps, pulled_.empty() ? nullptr : pulled_.data(), executor);
    met_with_.limit_sweeps = std::max(met_with_.limit_sweeps, sweeps);
    if (left.springs > 0) {
      met_with_.flags |= flag_limit_not_met;
      met_with_.springs_over_limit = left.springs;
      met_with_.largest_strain = left.largest;
    }
    const double share = velocity_share(result, executor);
    store(result, share, executor);
    if (pulled_.empty()) return;
    for (const HeldParticle& held : frames_->held()) carry(held, share * pulled_[held.particle], result);
  }

  void tell(Report& report) override {
    report.flags |= met_with_.flags;
    report.limit_sweeps = std::max(report.limit_sweeps, met_with_.limit_sweeps);
    if (met_with_.largest_strain > report.largest_strain) report.largest_strain = met_with_.largest_strain;
    report.springs_over_limit += met_with_.springs_over_limit;
    met_with_ = {};
  }

  Stage stage() const override {
    return {std::string(StrainLimit::name) + " (" + std::to_string(sweeps_.colours()) + " colours)",
            {},
            {"position", "velocity", "mass", "springs"},
            {"position", "velocity"},
            sweeps_.bytes() + inverse_mass_.capacity() * sizeof(double) +
                particles_.capacity() * sizeof(StrainSweeps::Particle) + pulled_.capacity() * sizeof(Vec3)};
  }

 private:
  static constexpr std::size_t particles_in_run = 4096;

  StrainExcess excess_of(const State<Real>& state, Executor& executor) {
    return sweeps_.template excess<Real>(
        [&](std::size_t i) -> Vec3 { return state.position(i).template cast<double>(); }, executor);
  }

  template <class Visit>
  void for_each_particle(Executor& executor, const Visit& visit) {
    executor.parallel_for(particles_.size(), particles_in_run, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) visit(i);
    });
  }

  void load(const StepResult<Real>& result, Executor& executor) {
    for_each_particle(executor, [&](std::size_t i) {
      const double inverse_mass = model_.sleeps(i) ? 0.0 : inverse_mass_[i];
      particles_[i] = {result.next.position(i).template cast<double>(), inverse_mass};
    });
    for (const ScriptedTime& script : scripted_) {
      if (script.holds_at(result.time)) particles_[script.particle].inverse_mass = 0.0;
    }
  }

  Vec3 move_of(const State<Real>& next, std::size_t i) const {
    return particles_[i].position - next.position(i).template cast<double>();
  }

  /// Velocities change by the moves times this [1/s].
  double velocity_share(const StepResult<Real>& result, Executor& executor) {
    if (pins_move_ && excess_of(result.start, executor).springs == 0) return 1.0 / result.h;
    const auto part = [&](std::size_t begin, std::size_t end) {
      EnergyGain sum;
      for (std::size_t i = begin; i < end; ++i) {
        if (particles_[i].inverse_mass == 0.0) continue;
        const Vec3 move = move_of(result.next, i), velocity = result.next.velocity(i).template cast<double>();
        sum.add({move.dot(velocity) / inverse_mass_[i], move.squaredNorm() / inverse_mass_[i]});
      }
      return sum;
    };
    const EnergyGain gain =
        sum_in_order<EnergyGain>(executor, particles_.size(), particles_in_run, part, gains_);
    return gain.square > 0.0 ? std::clamp(-gain.linear / gain.square, 0.0, 1.0 / result.h) : 0.0;
  }

  void store(const StepResult<Real>& result, double share, Executor& executor) {
    for_each_particle(executor, [&](std::size_t i) {
      if (particles_[i].inverse_mass == 0.0) return;
      const Vec3 velocity = result.next.velocity(i).template cast<double>() + share * move_of(result.next, i);
      result.next.set_velocity(i, velocity.template cast<Real>());
      result.next.set_position(i, particles_[i].position.template cast<Real>());
    });
  }

  const Model<Real>& model_;
  StrainSweeps sweeps_;
  std::vector<double> inverse_mass_;  ///< [1/kg], 0 where pinned or attached
  std::vector<ScriptedTime> scripted_;
  bool pins_move_;
  std::shared_ptr<const Frames> frames_;
  std::vector<StrainSweeps::Particle> particles_;
  std::vector<Vec3> pulled_;  ///< see StrainSweeps::run(); only where particles are attached
  std::vector<EnergyGain> gains_;
  Report met_with_;  ///< since it was told last
};

/// Springs between two pins that stay where they are.
void check_pinned_springs(const StrainLimit& limit, const Scene& scene, const ElementChecks& checks) {
  const Springs& springs = scene.springs;
  const std::size_t particles = scene.particles.position.size();
  std::vector<bool> stays(particles, false);
  for (const Pin& pin : scene.pins) {
    if (pin.particle < particles && pin.path.empty()) stays[pin.particle] = true;
  }
  for (const Index s : chosen_springs(limit.springs, springs)) {
    if (s >= std::min({springs.first.size(), springs.second.size(), springs.rest_length.size()})) continue;
    const Index a = springs.first[s], b = springs.second[s];
    const double rest = springs.rest_length[s];
    if (a >= particles || b >= particles || !stays[a] || !stays[b] || !(rest > 0.0)) continue;
    const double strain = ((scene.particles.position[b] - scene.particles.position[a]).norm() - rest) / rest;
    if (!(strain > limit.limit)) continue;
    checks.add("spring " + std::to_string(s) + " between two pins has a strain of " + to_text(strain) +
                   ", and the limit is " + to_text(limit.limit),
               "move the pins closer together, use a larger limit or leave the spring out");
  }
}

}  // namespace

template <class Real>
EffectPointer<Real> compile_effect(const StrainLimit& limit, const EffectContext<Real>& context) {
  return std::make_unique<StrainLimitCorrection<Real>>(limit, context);
}

template EffectPointer<float> compile_effect(const StrainLimit&, const EffectContext<float>&);
template EffectPointer<double> compile_effect(const StrainLimit&, const EffectContext<double>&);

void check_effect(const StrainLimit& limit, const Scene& scene, const ElementChecks& checks) {
  checks.not_negative("limit", limit.limit, "");
  checks.at_least("sweeps", limit.sweeps, 1);
  checks.at_most("sweeps", limit.sweeps, most_sweeps);
  check_strained_springs(limit.springs, scene, checks);
  check_pinned_springs(limit, scene, checks);
}

void add_bounds(const StrainLimit&, const Scene&, HeldParticles&) {}

}  // namespace hooke
