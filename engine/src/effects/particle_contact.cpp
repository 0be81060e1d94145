#include <algorithm>
#include <cmath>
#include <cstring>
#include <span>
#include <string>

#include "collide/grain_pairs.h"
#include "effects/effect_functions.h"
#include "effects/named_particles.h"
#include "effects/remembered_motion.h"
#include "kernels/flush_subnormals.h"

namespace hooke {
namespace {

/// Pairs that one thread takes at a time: some microseconds of work.
constexpr std::size_t pairs_in_run = 512;

template <class Real>
using Vector = Eigen::Matrix<Real, 3, 1>;

/// Two grains that touch: how far apart and how fast the first one is from the second one, and how far apart
/// they were where they have slid from.
template <class Real>
struct Meeting {
  Vector<Real> apart, velocity, anchor;
  Real reach;  ///< the sum of their radii [m]
};

/// How they press on each other.
template <class Real>
struct GrainPress {
  Vector<Real> normal;  ///< from the second to the first
  Real push;            ///< [N]
  Real energy;          ///< [J] of the spring between them
};

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

  GrainPress<Real> press(const Meeting<Real>& meeting) const {
    const Real distance = meeting.apart.norm(), depth = meeting.reach - distance;
    // Two at one place have no direction: along an axis, so that they part at all.
    const Vector<Real> normal =
        distance > Real(0) ? Vector<Real>(meeting.apart / distance) : Vector<Real>::UnitX();
    return {normal, stiffness * depth - damping * meeting.velocity.dot(normal),
            Real(0.5) * stiffness * depth * depth};
  }

  /// What friction makes of it.
  GrainTouch<Real> touch(const GrainPress<Real>& press, const Meeting<Real>& meeting) const {
    const Vector<Real>& normal = press.normal;
    GrainTouch<Real> touch{normal, press.push * normal, Real(0), press.energy};
    if (friction == Real(0)) return touch;
    const Vector<Real> way = across(meeting.apart - meeting.anchor, normal);
    const Vector<Real> holding = shear_stiffness * way + shear_damping * across(meeting.velocity, normal);
    const Real size = holding.norm(), most = friction * std::max(press.push, Real(0));
    touch.held = size <= most ? Real(1) : most / size;
    touch.force -= touch.held * holding;
    touch.energy += Real(0.5) * shear_stiffness * way.squaredNorm();
    return touch;
  }

  /// The anchor from now on of what slides: so much nearer that it is held by no more than friction.
  Vector<Real> slid_anchor(const GrainTouch<Real>& touch, const Meeting<Real>& meeting) const {
    const Vector<Real> way = across(meeting.apart - meeting.anchor, touch.normal);
    const Vector<Real> drag = shear_damping * across(meeting.velocity, touch.normal);
    return meeting.apart - (touch.held * (shear_stiffness * way + drag) - drag) / shear_stiffness;
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
      : model_(context.model),
        law_{Real(contact.stiffness), Real(contact.damping), Real(contact.shear_stiffness),
             Real(contact.shear_damping), Real(contact.friction)},
        pairs_(grains_of(contact, context.scene, context.model.order), context.scene.particles.size(),
               joined_pairs(context.scene.springs)),
        touched_(sorted_places(grains_of(contact, context.scene, context.model.order))) {}

  unsigned parts() const override {
    const unsigned force = has_force | needs_preparation | is_coupled | has_own_derivative;
    return anchors() ? force | corrects_everything | remembers_pairs : force;
  }

  void prepare(const State<Real>& state, double, Executor& executor) override {
    find_touches(state, executor);
    // What is met in a step may have gone apart again at its end.
    Islands* const islands = model_.islands.get();
    if (islands == nullptr || islands->asleep() == 0) return;
    for_each_pressing_pair([&](Index a, Index b) {
      if (islands->particle_sleeps(a) != islands->particle_sleeps(b)) islands->note_touch(a, b);
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

  /// What it finds is of use to the next step, too.
  void note_touches(const State<Real>& state, Executor& executor, Islands& islands) override {
    find_touches(state, executor);
    for_each_pressing_pair([&](Index a, Index b) { islands.note_touch(a, b); });
  }

  double energy(const Strip<Real>& strip) const override {
    double sum = 0.0;
    for_each_touch(strip, [&](std::size_t, const GrainTouch<Real>& touch, Real, Index) {
      sum += 0.5 * double(touch.energy);
    });
    return sum;
  }

  void begin_pairs(std::size_t list) override { list_ = list; }

  /// Remembers the anchors of all that touch, and how they touch with these: what the next step begins with,
  /// where nothing else changes this one's result.
  void correct(const StepResult<Real>& result, Executor& executor) override {
    touched_.forget();
    pairs_.find(result.next, executor);
    kept_.resize((pairs_.pairs().size() + pairs_in_run - 1) / pairs_in_run);
    for (auto& run : kept_) run.clear();
    for_each_meeting(
        result.next, memory_in(result.start), executor,
        [&](std::size_t p, const GrainPair& pair, Meeting<Real>& meeting) { keep(p, pair, meeting); });
    std::vector<PairMemory<Real>>& memory = result.next.pairs[list_];
    memory.clear();
    for (const auto& run : kept_) memory.insert(memory.end(), run.begin(), run.end());
    touched_.remember(result.next);
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
            pairs_.bytes() + touched_.bytes() + touches_.capacity() * sizeof(GrainTouch<Real>)};
  }

 private:
  struct Stiffness {
    Real along, across;
  };

  void find_touches(const State<Real>& state, Executor& executor) {
    if (touched_.is_of(state) && are_kept(memory_in(state))) return;
    touched_.forget();
    pairs_.find(state, executor);
    for_each_meeting(state, memory_in(state), executor,
                     [&](std::size_t p, const GrainPair&, const Meeting<Real>& meeting) {
                       touches_[p] = law_.touch(law_.press(meeting), meeting);
                     });
  }

  /// Calls visit(first, second), of the user's numbering, for those that press on each other.
  template <class Visit>
  void for_each_pressing_pair(const Visit& visit) const {
    for (std::size_t p = 0; p < touches_.size(); ++p) {
      if (touches_[p].energy > Real(0)) visit(pairs_.pairs()[p].first, pairs_.pairs()[p].second);
    }
  }

  bool anchors() const { return law_.friction > Real(0) && law_.shear_stiffness > Real(0); }

  Stiffness stiffness(const GrainTouch<Real>& touch, const DerivativeWeights<Real>& weights) const {
    const Real along = weights.stiffness * law_.stiffness + weights.damping * law_.damping;
    const Real across = weights.stiffness * law_.shear_stiffness + weights.damping * law_.shear_damping;
    return {along, touch.sticks() ? across : Real(0)};
  }

  /// What is remembered in a state, sorted like pairs.
  using Memory = std::span<const PairMemory<Real>>;
  Memory memory_in(const State<Real>& state) const { return anchors() ? state.pairs[list_] : Memory{}; }

  /// Remembers the anchor of a pair from now on, and how it touches with that.
  void keep(std::size_t p, const GrainPair& pair, Meeting<Real>& meeting) {
    const GrainPress<Real> press = law_.press(meeting);
    touches_[p] = law_.touch(press, meeting);
    if (!touches_[p].sticks()) {
      meeting.anchor = law_.slid_anchor(touches_[p], meeting);
      touches_[p] = law_.touch(press, meeting);
    }
    const Vector<Real>& anchor = meeting.anchor;
    kept_[p / pairs_in_run].push_back({pair.first, pair.second, {anchor.x(), anchor.y(), anchor.z()}});
  }

  /// Whether this is what was kept last, bit for bit.
  bool are_kept(Memory memory) const {
    for (const auto& run : kept_) {
      if (run.size() > memory.size()) return false;
      if (!run.empty() && std::memcmp(run.data(), memory.data(), run.size() * sizeof(run[0])) != 0)
        return false;
      memory = memory.subspan(run.size());
    }
    return memory.empty();
  }

  /// Calls visit(number, pair, meeting) for each pair found last that touches, on several threads; the others
  /// do nothing to each other.
  template <class Visit>
  void for_each_meeting(const State<Real>& state, Memory memory, Executor& executor, const Visit& visit) {
    const std::span<const GrainPair> pairs = pairs_.pairs();
    touches_.resize(pairs.size());
    executor.parallel_for(
        (pairs.size() + pairs_in_run - 1) / pairs_in_run, 1, [&](std::size_t begin, std::size_t end) {
          const FlushSubnormals flush;
          Memory left = memory_from(memory, pairs[begin * pairs_in_run]);
          for (std::size_t p = begin * pairs_in_run; p < std::min(pairs.size(), end * pairs_in_run); ++p) {
            const GrainPair& pair = pairs[p];
            const Vector<Real> apart = state.position(pair.first_place) - state.position(pair.second_place);
            const Real reach = Real(pair.reach);
            if (apart.squaredNorm() < reach * reach) {
              Meeting<Real> meeting = meeting_of(pair, apart, state, left);
              visit(p, pair, meeting);
            } else {
              touches_[p] = {};
            }
          }
        });
  }

  /// `left` of the memory goes along with the pairs. Without one they have just met.
  static Meeting<Real> meeting_of(const GrainPair& pair, const Vector<Real>& apart, const State<Real>& state,
                                  Memory& left) {
    while (!left.empty() && PairOrder{}(left.front(), pair)) left = left.subspan(1);
    const bool known =
        !left.empty() && left.front().first == pair.first && left.front().second == pair.second;
    return {apart, state.velocity(pair.first_place) - state.velocity(pair.second_place),
            known ? Vector<Real>(left.front().value.data()) : apart, Real(pair.reach)};
  }

  static Memory memory_from(Memory memory, const GrainPair& pair) {
    const auto first = std::lower_bound(memory.begin(), memory.end(), pair, PairOrder{});
    return memory.subspan(std::size_t(first - memory.begin()));
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

  const Model<Real>& model_;
  GrainLaw<Real> law_;
  GrainPairs<Real> pairs_;
  std::vector<GrainTouch<Real>> touches_;            ///< of each pair
  RememberedMotion<Real> touched_;                   ///< what these are of, where correct() found them
  std::vector<std::vector<PairMemory<Real>>> kept_;  ///< likewise; run by run
  std::size_t list_ = 0;                             ///< in State::pairs
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
