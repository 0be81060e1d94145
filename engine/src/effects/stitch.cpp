#include <algorithm>
#include <string>
#include <vector>

#include "effects/effect_functions.h"
#include "effects/immovable.h"
#include "effects/knots.h"
#include "frames/carried.h"
#include "scene/number_text.h"
#include "scene/scene_size.h"

namespace hooke {
namespace {

/// Pairs that are further apart than this share of the scene's size are not together.
constexpr double together = 1e-6;

template <class Real>
class Seam final : public CompiledEffect<Real> {
 public:
  Seam(const Stitch& stitch, const EffectContext<Real>& context)
      : model_(context.model),
        knots_(stitch, context.scene, context.model.order),
        closing_time_(stitch.closing_time),
        pairs_(stitch.first.size()),
        inverse_mass_(inverse_masses_of_free(context.scene, context.model.order)),
        scripted_(scripted_times(context.scene, context.model.order)),
        moves_(knots_.particles.size()),
        impulse_(knots_.particles.size()) {
    if (context.model.frames == nullptr) return;
    for (const Knot& knot : knots_.knots) {
      const Index root = knots_.particles[knot.first_particle];
      const auto held = context.model.frames->held_between(root, root + std::size_t{1});
      if (!held.empty()) on_frames_.push_back({knot.first_particle, &held.front()});
    }
  }

  unsigned parts() const override { return corrects_everything | carries_forces; }

  /// Behind everything else that moves particles: a seam is closed.
  int correction_rank() const override { return 1; }

  void correct(const StepResult<Real>& result, Executor& executor) override {
    executor.parallel_for(knots_.knots.size(), knots_in_run, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        const Knot& knot = knots_.knots[k];
        if (model_.sleeps(knots_.particles[knot.first_particle])) continue;
        pull_together(knot, result);
        share_out(knot, result.next);
      }
    });
    result.next.memory[memory_] += Real(result.kick_time());
    // What the roots of knots, which do not move, were pulled by.
    for (const OnFrame& root : on_frames_) carry(*root.held, -impulse_[root.place], result);
  }

  void forget_forces(State<Real>& state) const override {
    std::fill_n(state.memory.begin() + std::ptrdiff_t(memory_), memory_size(), Real(0));
  }

  std::optional<std::vector<Vec3>> pair_forces(const State<Real>& state) const override {
    const Real* const memory = &state.memory[memory_];
    std::vector<Vec3> forces(pairs_, Vec3::Zero());
    if (memory[0] == Real(0)) return forces;
    for (std::size_t p = 0; p < pairs_; ++p) {
      const Real* const impulse = memory + 1 + 3 * p;
      forces[p] = Vec3(double(impulse[0]), double(impulse[1]), double(impulse[2])) / double(memory[0]);
    }
    return forces;
  }

  std::size_t memory_size() const override { return 1 + 3 * pairs_; }  ///< time [s], impulses [N s]
  void begin_memory(std::size_t first, std::span<Real>) override { memory_ = first; }

  void disturb(double from, double to, Disturbances& disturbed) const override {
    if (open_at(from) == open_at(to)) return;
    for (const Index particle : knots_.particles) disturbed.particle(particle);
  }

  Stage stage() const override {
    return {std::string(Stitch::name),
            {},
            {"position", "velocity", "time"},
            {"position", "velocity"},
            knots_.bytes() + inverse_mass_.capacity() * sizeof(double) +
                scripted_.capacity() * sizeof(ScriptedTime) + 2 * impulse_.capacity() * sizeof(Vec3) +
                on_frames_.capacity() * sizeof(OnFrame)};
  }

 private:
  static constexpr std::size_t knots_in_run = 512;

  /// What its particles are drawn to, and how it moves.
  struct Centre {
    Vec3 place, velocity;
  };

  /// The root of a knot that is attached to a frame, and its place in Knots::particles.
  struct OnFrame {
    std::size_t place;
    const HeldParticle* held;
  };

  double inverse_mass(Index particle, double time) const {
    for (const ScriptedTime& script : scripted_) {
      if (script.particle == particle && script.holds_at(time)) return 0.0;
    }
    return inverse_mass_[particle];
  }

  std::span<const Index> particles_of(const Knot& knot) const {
    return std::span(knots_.particles).subspan(knot.first_particle, knot.last_particle - knot.first_particle);
  }
  std::span<const KnotPair> pairs_of(const Knot& knot) const {
    return std::span(knots_.pairs).subspan(knot.first_pair, knot.last_pair - knot.first_pair);
  }

  /// The particle that cannot be moved, or the mean by mass.
  Centre centre_of(const Knot& knot, const StepResult<Real>& result) const {
    Vec3 place = Vec3::Zero(), velocity = Vec3::Zero();
    double mass = 0.0;
    for (const Index i : particles_of(knot)) {
      const Vec3 x = result.next.position(i).template cast<double>();
      const Vec3 v = result.next.velocity(i).template cast<double>();
      const double inverse = inverse_mass(i, result.time);
      if (inverse == 0.0) return {x, v};
      place += x / inverse;
      velocity += v / inverse;
      mass += 1.0 / inverse;
    }
    return {place / mass, velocity / mass};
  }

  /// How far apart pairs may be at a time, as a share of what they were at the start.
  double open_at(double time) const { return time < closing_time_ ? 1.0 - time / closing_time_ : 0.0; }

  /// Whether no pair of a knot's tree is further apart than it may be.
  bool is_in_time(const Knot& knot, const State<Real>& state, double open) const {
    constexpr double rounding = 1.0 + 1e-6;
    return std::ranges::all_of(pairs_of(knot), [&](const KnotPair& pair) {
      const Vec3 gap = (state.position(pair.child) - state.position(pair.parent)).template cast<double>();
      return !pair.in_tree || gap.norm() <= rounding * open * pair.distance;
    });
  }

  void pull_together(const Knot& knot, const StepResult<Real>& result) {
    for (std::size_t n = knot.first_particle; n < knot.last_particle; ++n) impulse_[n] = Vec3::Zero();
    const double open = open_at(result.time);
    if (open == 0.0) {
      close(knot, result);
    } else {
      draw_in(knot, result, open);
    }
  }

  void close(const Knot& knot, const StepResult<Real>& result) {
    const Centre centre = centre_of(knot, result);
    for (std::size_t n = knot.first_particle; n < knot.last_particle; ++n)
      move(n, centre.place, centre.velocity, result);
  }

  /// From the root on, each particle to where its pair may be; then all so that their centre stays.
  void draw_in(const Knot& knot, const StepResult<Real>& result, double open) {
    if (!find_moves(knot, result.next, open)) return;
    const Vec3 shift = mean_move(knot, result.time);
    for (std::size_t n = knot.first_particle; n < knot.last_particle; ++n) moves_[n] -= shift;
    const double rate = velocity_share(knot, result, centre_of(knot, result).velocity);
    for (std::size_t n = knot.first_particle; n < knot.last_particle; ++n) {
      const Index i = knots_.particles[n];
      move(n, result.next.position(i).template cast<double>() + moves_[n],
           result.next.velocity(i).template cast<double>() + rate * moves_[n], result);
    }
  }

  /// By mass; zero of a knot with a particle that does not move.
  Vec3 mean_move(const Knot& knot, double time) const {
    Vec3 sum = Vec3::Zero();
    double mass = 0.0;
    for (std::size_t n = knot.first_particle; n < knot.last_particle; ++n) {
      const double inverse = inverse_mass(knots_.particles[n], time);
      if (inverse == 0.0) return Vec3::Zero();
      sum += moves_[n] / inverse;
      mass += 1.0 / inverse;
    }
    return sum / mass;
  }

  /// With the root where it is. Returns whether there are any.
  bool find_moves(const Knot& knot, const State<Real>& state, double open) {
    bool any = false;
    moves_[knot.first_particle] = Vec3::Zero();
    const auto pairs = pairs_of(knot);
    for (auto pair = pairs.rbegin(); pair != pairs.rend(); ++pair) {
      if (!pair->in_tree) continue;
      const Vec3 gap = (state.position(pair->child) - state.position(pair->parent)).template cast<double>();
      const double distance = gap.norm(), allowed = open * pair->distance;
      moves_[pair->child_place] = moves_[pair->parent_place];
      if (!(distance > allowed)) continue;
      moves_[pair->child_place] -= (1.0 - allowed / distance) * gap;
      any = true;
    }
    return any;
  }

  /// Velocities change by the moves times this [1/s]: a seam that closes in time gives them the speed of
  /// that; one that is late is drawn in with the least kinetic energy.
  double velocity_share(const Knot& knot, const StepResult<Real>& result, const Vec3& mean) const {
    const double inverse_h = 1.0 / result.h;
    if (is_in_time(knot, result.start, open_at(result.time - result.h))) return inverse_h;
    double linear = 0.0, square = 0.0;
    for (std::size_t n = knot.first_particle; n < knot.last_particle; ++n) {
      const Index i = knots_.particles[n];
      const double inverse = inverse_mass(i, result.time);
      if (inverse == 0.0) continue;
      linear += moves_[n].dot(result.next.velocity(i).template cast<double>() - mean) / inverse;
      square += moves_[n].squaredNorm() / inverse;
    }
    return square > 0.0 ? std::clamp(-linear / square, 0.0, inverse_h) : 0.0;
  }

  void move(std::size_t n, const Vec3& place, const Vec3& velocity, const StepResult<Real>& result) {
    const Index i = knots_.particles[n];
    const double inverse = inverse_mass(i, result.time);
    if (inverse == 0.0) return;
    const Eigen::Matrix<Real, 3, 1> rounded = velocity.template cast<Real>();
    impulse_[n] = (rounded - result.next.velocity(i)).template cast<double>() / inverse;
    result.next.set_position(i, place.template cast<Real>());
    result.next.set_velocity(i, rounded);
  }

  /// From the ends of a knot's tree of pairs to its root: a pair carries what all behind it got.
  void share_out(const Knot& knot, State<Real>& next) {
    for (const KnotPair& pair : pairs_of(knot)) {
      if (!pair.in_tree) continue;
      const Vec3 carried = impulse_[pair.child_place];
      impulse_[pair.parent_place] += carried;
      Real* const memory = &next.memory[memory_ + 1 + 3 * pair.number];
      for (Eigen::Index k = 0; k < 3; ++k) memory[k] += Real(pair.child_is_first ? carried[k] : -carried[k]);
    }
  }

  const Model<Real>& model_;
  Knots knots_;
  double closing_time_;
  std::size_t pairs_;
  std::vector<double> inverse_mass_;  ///< [1/kg], 0 where pinned or attached
  std::vector<ScriptedTime> scripted_;
  std::vector<OnFrame> on_frames_;
  std::vector<Vec3> moves_;    ///< [m] of each of the knots' particles in a step
  std::vector<Vec3> impulse_;  ///< [N s] on each of the knots' particles in a step
  std::size_t memory_ = 0;
};

void check_ends(const std::vector<Index>& ends, const char* name, const Scene& scene,
                const ElementChecks& checks) {
  for (std::size_t i = 0; i < ends.size(); ++i)
    checks.in_range(std::string(name) + "[" + std::to_string(i) + "]", ends[i], scene.particles.size(),
                    "particles");
}

bool is_sound(const Stitch& stitch, const Scene& scene) {
  const auto exists = [&](Index particle) { return particle < scene.particles.size(); };
  return stitch.first.size() == stitch.second.size() && std::ranges::all_of(stitch.first, exists) &&
         std::ranges::all_of(stitch.second, exists);
}

/// Pairs of a particle with itself, and pairs that are apart and have no time to close.
void check_pairs(const Stitch& stitch, const Scene& scene, const ElementChecks& checks) {
  const double allowed = together * scene_size(scene);
  for (std::size_t i = 0; i < stitch.first.size(); ++i) {
    const Index a = stitch.first[i], b = stitch.second[i];
    const std::string pair = "pair " + std::to_string(i);
    if (a == b)
      checks.add(pair + " sews particle " + std::to_string(a) + " to itself", "give two different particles");
    const double distance = (scene.particles.position[a] - scene.particles.position[b]).norm();
    if (stitch.closing_time == 0.0 && distance > allowed)
      checks.add(pair + " is " + to_text(distance) + " m apart at the start",
                 "give a closing_time > 0, or put its particles together");
  }
}

/// What is sewn to two places at once, directly or by pairs between.
void check_fixed(const Stitch& stitch, const Scene& scene, const ElementChecks& checks) {
  constexpr Index none = ~Index{0};
  const std::vector<bool> fixed = fixed_particles(scene);
  const std::vector<Index> roots = knot_roots(stitch, scene.particles.size());
  std::vector<Index> holder(roots.size(), none);
  for (std::size_t i = 0; i < roots.size(); ++i) {
    Index& found = holder[roots[i]];
    if (!fixed[i]) continue;
    if (found != none)
      checks.add("sews particle " + std::to_string(i) + " to particle " + std::to_string(found) +
                     ", and both are pinned, attached or moved by a script",
                 "leave one of the two out");
    found = Index(i);
  }
}

}  // namespace

template <class Real>
EffectPointer<Real> compile_effect(const Stitch& stitch, const EffectContext<Real>& context) {
  return std::make_unique<Seam<Real>>(stitch, context);
}

template EffectPointer<float> compile_effect(const Stitch&, const EffectContext<float>&);
template EffectPointer<double> compile_effect(const Stitch&, const EffectContext<double>&);

void check_effect(const Stitch& stitch, const Scene& scene, const ElementChecks& checks) {
  checks.at_least("the number of pairs", stitch.first.size(), 1);
  if (stitch.first.size() != stitch.second.size())
    checks.add("first has " + std::to_string(stitch.first.size()) + " particles and second " +
                   std::to_string(stitch.second.size()),
               "give each the same number");
  checks.not_negative("closing_time", stitch.closing_time, "s");
  check_ends(stitch.first, "first", scene, checks);
  check_ends(stitch.second, "second", scene, checks);
  if (!is_sound(stitch, scene)) return;
  check_pairs(stitch, scene, checks);
  check_fixed(stitch, scene, checks);
}

/// It takes no shorter steps.
void add_bounds(const Stitch&, const Scene&, HeldParticles&) {}

}  // namespace hooke
