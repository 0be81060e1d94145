#include <algorithm>
#include <cmath>
#include <string>

#include "collide/grain_pairs.h"
#include "effects/effect_functions.h"
#include "effects/named_particles.h"
#include "kernels/flush_subnormals.h"

namespace hooke {
namespace {

/// Pairs that one thread takes at a time: some microseconds of work.
constexpr std::size_t pairs_in_run = 512;

template <class Real>
using Vector = Eigen::Matrix<Real, 3, 1>;

/// What two grains that touch do to each other.
template <class Real>
struct GrainTouch {
  Vector<Real> normal = Vector<Real>::Zero();  ///< from the second to the first
  Vector<Real> force = Vector<Real>::Zero();   ///< [N] on the first
  Real held = Real(0);    ///< the share of what would hold them along their surfaces that friction can
  Real energy = Real(0);  ///< [J] of their springs

  bool sticks() const { return held == Real(1); }
};

/// The law of a pair, in the precision of the run.
template <class Real>
struct GrainLaw {
  Real stiffness, damping, shear_stiffness, shear_damping, friction;

  static Vector<Real> across(const Vector<Real>& value, const Vector<Real>& normal) {
    return value - value.dot(normal) * normal;
  }

  /// Of two that are nearer than `reach`. `apart` and `velocity` are the first one's less the second one's;
  /// they have slid since they were `anchor` apart.
  GrainTouch<Real> touch(const Vector<Real>& apart, const Vector<Real>& velocity, Real reach,
                         const Vector<Real>& anchor) const {
    GrainTouch<Real> touch;
    const Real distance = apart.norm(), depth = reach - distance;
    // Two at one place have no direction: along an axis, so that they part at all.
    touch.normal = distance > Real(0) ? Vector<Real>(apart / distance) : Vector<Real>::UnitX();
    const Real push = stiffness * depth - damping * velocity.dot(touch.normal);
    touch.force = push * touch.normal;
    touch.energy = Real(0.5) * stiffness * depth * depth;
    if (friction == Real(0)) return touch;
    const Vector<Real> way = across(apart - anchor, touch.normal);
    const Vector<Real> holding = shear_stiffness * way + shear_damping * across(velocity, touch.normal);
    const Real size = holding.norm(), most = friction * std::max(push, Real(0));
    touch.held = size <= most ? Real(1) : most / size;
    touch.force -= touch.held * holding;
    touch.energy += Real(0.5) * shear_stiffness * way.squaredNorm();
    return touch;
  }

  /// What `anchor` is from now on: so much nearer that what slides is held by no more than friction.
  Vector<Real> anchor_after(const GrainTouch<Real>& touch, const Vector<Real>& apart,
                            const Vector<Real>& velocity, const Vector<Real>& anchor) const {
    if (touch.sticks()) return anchor;
    const Vector<Real> way = across(apart - anchor, touch.normal);
    const Vector<Real> drag = shear_damping * across(velocity, touch.normal);
    return apart - (touch.held * (shear_stiffness * way + drag) - drag) / shear_stiffness;
  }
};

double radius_of(const ParticleContact& contact, std::size_t grain) {
  return contact.radius[contact.radius.size() == 1 ? 0 : grain];
}

/// Sorted by the user's numbering.
std::vector<Grain> grains_of(const ParticleContact& contact, const Scene& scene, const Order& order) {
  const bool all = contact.particles.empty();
  std::vector<Grain> grains(all ? scene.particles.size() : contact.particles.size());
  for (std::size_t g = 0; g < grains.size(); ++g) {
    const Index particle = all ? Index(g) : contact.particles[g];
    grains[g] = {particle, order.engine(particle), radius_of(contact, g)};
  }
  std::sort(grains.begin(), grains.end(),
            [](const Grain& a, const Grain& b) { return a.particle < b.particle; });
  return grains;
}

/// Pairs of particles that springs join, sorted.
std::vector<std::pair<Index, Index>> joined_pairs(const Springs& springs) {
  std::vector<std::pair<Index, Index>> pairs(springs.size());
  for (std::size_t s = 0; s < springs.size(); ++s)
    pairs[s] = std::minmax({springs.first[s], springs.second[s]});
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

template <class Real>
class GrainForce final : public CompiledEffect<Real> {
 public:
  GrainForce(const ParticleContact& contact, const EffectContext<Real>& context)
      : law_{Real(contact.stiffness), Real(contact.damping), Real(contact.shear_stiffness),
             Real(contact.shear_damping), Real(contact.friction)},
        pairs_(grains_of(contact, context.scene, context.model.order), context.scene.particles.size(),
               joined_pairs(context.scene.springs)) {}

  unsigned parts() const override {
    const unsigned force = has_force | needs_preparation | is_coupled | has_own_derivative;
    return anchors() ? force | corrects_everything | remembers_pairs : force;
  }

  void prepare(const State<Real>& state, double, Executor& executor) override {
    pairs_.find(state, executor);
    touches_.resize(pairs_.pairs().size());
    for_each_pair(state, executor, [&](std::size_t p, const GrainPair&, const Meeting& meeting) {
      touches_[p] = meeting.touch;
    });
  }

  void add_force(const Strip<Real>& strip, double, StripForce<Real>& force) const override {
    for_each_touch(strip, [&](std::size_t lane, const GrainTouch<Real>& touch, Real sign, Index) {
      force.x[lane] += sign * touch.force.x();
      force.y[lane] += sign * touch.force.y();
      force.z[lane] += sign * touch.force.z();
    });
  }

  void add_derivative(const Strip<Real>& strip, double, const DerivativeWeights<Real>& weights,
                      StripBlocks<Real>& blocks) const override {
    for_each_touch(strip, [&](std::size_t lane, const GrainTouch<Real>& touch, Real, Index) {
      const Stiffness of = stiffness(touch, weights);
      const Eigen::Matrix3d normal = (touch.normal * touch.normal.transpose()).template cast<double>();
      const Eigen::Matrix3d whole =
          double(of.along - of.across) * normal + double(of.across) * Eigen::Matrix3d::Identity();
      add_matrix(whole, lane, blocks);
    });
  }

  /// (a - b)^2 <= 2 (a^2 + b^2).
  double coupling() const override { return 2.0; }

  void add_product(const Strip<Real>& search, const DerivativeWeights<Real>& weights, Curvature,
                   StripForce<Real>& product) const override {
    const State<Real>& state = search.state;
    for_each_touch(search, [&](std::size_t lane, const GrainTouch<Real>& touch, Real, Index other) {
      const Stiffness of = stiffness(touch, weights);
      const Vector<Real> way = state.velocity(search.first + lane) - state.velocity(other);
      const Vector<Real> pull =
          of.across * way + (of.along - of.across) * way.dot(touch.normal) * touch.normal;
      product.x[lane] += pull.x();
      product.y[lane] += pull.y();
      product.z[lane] += pull.z();
    });
  }

  void note_touches(Islands& islands) const override {
    for (std::size_t p = 0; p < touches_.size(); ++p) {
      const GrainPair& pair = pairs_.pairs()[p];
      if (touches_[p].energy > Real(0)) islands.note_touch(pair.first, pair.second);
    }
  }

  double energy(const Strip<Real>& strip) const override {
    double sum = 0.0;
    for_each_touch(strip, [&](std::size_t, const GrainTouch<Real>& touch, Real, Index) {
      sum += 0.5 * double(touch.energy);
    });
    return sum;
  }

  void begin_pairs(std::size_t list) override { list_ = list; }

  /// Remembers the anchors of all that touch.
  void correct(const StepResult<Real>& result, Executor& executor) override {
    pairs_.find(result.next, executor);
    runs_.resize((pairs_.pairs().size() + pairs_in_run - 1) / pairs_in_run);
    for (auto& run : runs_) run.clear();
    for_each_pair(result.next, executor, [&](std::size_t p, const GrainPair& pair, const Meeting& meeting) {
      if (!meeting.touches) return;
      const Vector<Real> anchor =
          law_.anchor_after(meeting.touch, meeting.apart, meeting.velocity, meeting.anchor);
      runs_[p / pairs_in_run].push_back({pair.first, pair.second, {anchor.x(), anchor.y(), anchor.z()}});
    });
    std::vector<PairMemory<Real>>& kept = result.next.pairs[list_];
    kept.clear();
    for (const auto& run : runs_) kept.insert(kept.end(), run.begin(), run.end());
  }

  Stage stage() const override {
    return {std::string(ParticleContact::name),
            {},
            {"position", "velocity", "slid way"},
            {"force", "slid way"},
            0};
  }

  Stage preparation_stage() const override {
    return {std::string(ParticleContact::name) + " (pairs)",
            {},
            {"position", "velocity", "slid way"},
            {"touching grains"},
            pairs_.bytes() + touches_.capacity() * sizeof(GrainTouch<Real>)};
  }

 private:
  /// Two grains in a state.
  struct Meeting {
    Vector<Real> apart, velocity, anchor;
    bool touches;
    GrainTouch<Real> touch;
  };
  struct Stiffness {
    Real along, across;
  };

  bool anchors() const { return law_.friction > Real(0) && law_.shear_stiffness > Real(0); }

  Stiffness stiffness(const GrainTouch<Real>& touch, const DerivativeWeights<Real>& weights) const {
    const Real along = weights.stiffness * law_.stiffness + weights.damping * law_.damping;
    const Real across = weights.stiffness * law_.shear_stiffness + weights.damping * law_.shear_damping;
    return {along, touch.sticks() ? across : Real(0)};
  }

  /// Calls visit(number, pair, meeting) for each pair found last, on several threads.
  template <class Visit>
  void for_each_pair(const State<Real>& state, Executor& executor, const Visit& visit) const {
    const std::span<const GrainPair> pairs = pairs_.pairs();
    executor.parallel_for(
        (pairs.size() + pairs_in_run - 1) / pairs_in_run, 1, [&](std::size_t begin, std::size_t end) {
          const FlushSubnormals flush;
          std::size_t known = memory_from(state, pairs[begin * pairs_in_run]);
          for (std::size_t p = begin * pairs_in_run; p < std::min(pairs.size(), end * pairs_in_run); ++p)
            visit(p, pairs[p], meeting_of(pairs[p], state, known));
        });
  }

  /// `known` goes along the memory, which is sorted like the pairs.
  Meeting meeting_of(const GrainPair& pair, const State<Real>& state, std::size_t& known) const {
    Meeting meeting;
    meeting.apart = state.position(pair.first_place) - state.position(pair.second_place);
    const Real reach = Real(pair.reach);
    meeting.touches = meeting.apart.squaredNorm() < reach * reach;
    if (!meeting.touches) return meeting;
    meeting.velocity = state.velocity(pair.first_place) - state.velocity(pair.second_place);
    const PairMemory<Real>* const memory = memory_of(pair, state, known);
    meeting.anchor = memory == nullptr ? meeting.apart : Eigen::Map<const Vector<Real>>(memory->value.data());
    meeting.touch = law_.touch(meeting.apart, meeting.velocity, reach, meeting.anchor);
    return meeting;
  }

  std::size_t memory_from(const State<Real>& state, const GrainPair& pair) const {
    if (!anchors()) return 0;
    const auto& memory = state.pairs[list_];
    return std::size_t(std::lower_bound(memory.begin(), memory.end(), pair, PairOrder{}) - memory.begin());
  }

  const PairMemory<Real>* memory_of(const GrainPair& pair, const State<Real>& state,
                                    std::size_t& known) const {
    if (!anchors()) return nullptr;
    const auto& memory = state.pairs[list_];
    while (known < memory.size() && PairOrder{}(memory[known], pair)) ++known;
    const bool found =
        known < memory.size() && memory[known].first == pair.first && memory[known].second == pair.second;
    return found ? &memory[known] : nullptr;
  }

  /// Calls visit(lane, touch, sign, other) for what presses on each particle of a strip.
  template <class Visit>
  void for_each_touch(const Strip<Real>& strip, const Visit& visit) const {
    for (std::size_t lane = 0; lane < strip.particles; ++lane) {
      for (const PairOfGrain& one : pairs_.of(strip.first + lane)) {
        const GrainTouch<Real>& touch = touches_[one.pair];
        if (touch.energy == Real(0)) continue;
        const GrainPair& pair = pairs_.pairs()[one.pair];
        visit(lane, touch, one.is_second ? Real(-1) : Real(1),
              one.is_second ? pair.first_place : pair.second_place);
      }
    }
  }

  GrainLaw<Real> law_;
  GrainPairs<Real> pairs_;
  std::vector<GrainTouch<Real>> touches_;
  std::vector<std::vector<PairMemory<Real>>> runs_;
  std::size_t list_ = 0;  ///< in State::pairs
};

}  // namespace

template <class Real>
EffectPointer<Real> compile_effect(const ParticleContact& contact, const EffectContext<Real>& context) {
  return std::make_unique<GrainForce<Real>>(contact, context);
}

template EffectPointer<float> compile_effect(const ParticleContact&, const EffectContext<float>&);
template EffectPointer<double> compile_effect(const ParticleContact&, const EffectContext<double>&);

void check_effect(const ParticleContact& contact, const Scene& scene, const ElementChecks& checks) {
  const std::size_t grains = contact.particles.empty() ? scene.particles.size() : contact.particles.size();
  if (contact.radius.size() != 1 && contact.radius.size() != grains)
    checks.add("there are " + std::to_string(contact.radius.size()) + " radii of " + std::to_string(grains) +
                   " particles",
               "give one for all, or one for each");
  for (std::size_t i = 0; i < contact.radius.size(); ++i)
    checks.positive("radius[" + std::to_string(i) + "]", contact.radius[i], "m");
  checks.not_negative("stiffness", contact.stiffness, "N/m");
  checks.not_negative("damping", contact.damping, "N s/m");
  checks.not_negative("shear_stiffness", contact.shear_stiffness, "N/m");
  checks.not_negative("shear_damping", contact.shear_damping, "N s/m");
  checks.not_negative("friction", contact.friction, "");
  check_named_once(contact.particles, scene.particles.size(), checks);
}

/// A contact is as stiff as the stiffer of its two springs, which counts twice for each grain. A grain
/// touches at most so many of the smallest as their caps cover of the sphere that their middles lie on: 14 of
/// its own size (at most 12 fit without overlap).
void add_bounds(const ParticleContact& contact, const Scene& scene, HeldParticles& held) {
  if (contact.radius.empty()) return;
  const bool rubs = contact.friction > 0.0;
  const double stiffness = std::max(contact.stiffness, rubs ? contact.shear_stiffness : 0.0);
  const double damping = std::max(contact.damping, rubs ? contact.shear_damping : 0.0);
  const double smallest = *std::min_element(contact.radius.begin(), contact.radius.end());
  const std::size_t grains = contact.particles.empty() ? scene.particles.size() : contact.particles.size();
  for (std::size_t g = 0; g < grains; ++g) {
    const double radius = radius_of(contact, g);
    const double neighbours = 3.5 * std::pow(1.0 + radius / smallest, 2);
    const Index particle = contact.particles.empty() ? Index(g) : contact.particles[g];
    held.add(particle, 2.0 * neighbours * stiffness, 2.0 * neighbours * damping);
  }
}

}  // namespace hooke
