#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "collide/close_pairs.h"
#include "collide/contact_sweeps.h"
#include "collide/impact_zones.h"
#include "collide/motion_bound.h"
#include "collide/narrow_phase.h"
#include "collide/obstacles.h"
#include "effects/effect_functions.h"
#include "effects/immovable.h"
#include "scene/chosen_triangles.h"

namespace hooke {
namespace {

/// More than this in a step take too long to be meant.
constexpr std::uint64_t most_sweeps = 1'000'000;

/// How often contacts are looked for in a step, where they move particles so far that new ones may come.
constexpr int most_rounds = 4;

/// How often zones may grow in a step.
constexpr int most_zone_rounds = 50;

/// Sweeps end where no pair is nearer than its thickness by more than this share of it.
constexpr double depth_tolerance = 0.01;

/// Sweeps over velocities end where nothing approaches faster than this share of the highest speed at first,
/// or than this share of the thickness in a step.
constexpr double speed_tolerance = 0.03, speed_tolerance_of_thickness = 1e-5;

/// Pairs are looked for that are so much further apart than contacts are [m]: the more, the longer they do
/// for, and the more they are. Less than the distance of neighbours that share no particle.
double margin_of(double thickness, const Surface& surface, const Places& places) {
  double sum = 0.0;
  for (const auto& [a, b] : surface.edges) sum += (places[a] - places[b]).norm();
  return std::max(0.5 * thickness, surface.edges.empty() ? 0.0 : 0.25 * sum / double(surface.edges.size()));
}

Places start_of(const Scene& scene, const Order& order) {
  Places places(order.size());
  for (std::size_t i = 0; i < places.size(); ++i) places[order.engine(i)] = scene.particles.position[i];
  return places;
}

Surface surface_of(const SelfCollision& collision, const Scene& scene, const Order& order) {
  std::vector<Triangle> triangles = chosen_triangles(scene, collision.triangles);
  for (Triangle& triangle : triangles) {
    for (Index& corner : triangle) corner = order.engine(corner);
  }
  return Surface(std::move(triangles));
}

/// What is so many margins away counts as far, and may move so much before pairs are found anew.
constexpr double far_margins = 16.0;

template <class Real>
class SelfCollisionCorrection final : public CompiledEffect<Real> {
 public:
  SelfCollisionCorrection(const SelfCollision& collision, const EffectContext<Real>& context)
      : collision_(collision),
        surface_(surface_of(collision, context.scene, context.model.order)),
        start_(start_of(context.scene, context.model.order)),
        end_(start_),
        velocity_(start_),
        margin_(margin_of(collision.thickness, surface_, start_)),
        close_pairs_(surface_, start_, collision.thickness),
        bound_(surface_.corners),
        free_mass_(inverse_masses_of_free(context.scene, context.model.order)),
        inverse_mass_(free_mass_),
        scripted_(scripted_times(context.scene, context.model.order)),
        obstacles_(context.scene, context.model.frames.get(), collision.thickness),
        narrow_phase_(collision.thickness, collision.friction, collision.swept),
        sweeps_(inverse_mass_),
        zones_(inverse_mass_) {}

  unsigned parts() const override { return corrects_everything; }

  void correct(const StepResult<Real>& result, Executor& executor) override {
    if (!is_anything_near(result, executor)) return;
    load(result, executor);
    const bool touches = push_apart(result, executor);
    if (!touches && !pushed_far_) return;
    if (collision_.swept && pushed_far_) stop_what_crosses(result, executor);
    store(result, executor);
  }

  void tell(Report& report) override {
    report.flags |= met_with_.flags;
    report.contact_sweeps = std::max(report.contact_sweeps, met_with_.contact_sweeps);
    report.impact_zone_particles = std::max(report.impact_zone_particles, met_with_.impact_zone_particles);
    if (met_with_.contacts_left > 0) report.contacts_left = met_with_.contacts_left;
    met_with_ = {};
  }

  Stage stage() const override {
    const std::size_t places = start_.capacity() + end_.capacity() + velocity_.capacity();
    return {std::string(SelfCollision::name),
            {},
            {"position", "velocity", "mass", "triangles"},
            {"position", "velocity"},
            places * sizeof(Vec3) + (free_mass_.capacity() + inverse_mass_.capacity()) * sizeof(double) +
                close_pairs_.bytes() + bound_.bytes() + narrow_phase_.bytes() + sweeps_.bytes() +
                obstacles_.bytes()};
  }

 private:
  static constexpr std::size_t particles_in_run = 4096;

  /// No less than what rounding takes from a bound on motion.
  static constexpr double rounding = 1.0 + 1e-6;

  /// Whether a pair may touch in this step. Pairs are found anew where particles have moved too far since.
  bool is_anything_near(const StepResult<Real>& result, Executor& executor) {
    update_pairs(result, executor);
    return nearest_ - moved_ <= NarrowPhase::active_distance(collision_.thickness);
  }

  void update_pairs(const StepResult<Real>& result, Executor& executor) {
    if (pairs_hold_) measure_motion(result, executor);
    if (!pairs_hold_ || !(moved_ <= margin_)) find_pairs(result, executor);
  }

  /// How far particles have moved against each other at the ends of this step, since pairs were found.
  void measure_motion(const StepResult<Real>& result, Executor& executor) {
    const State<Real>& start = collision_.swept ? result.start : result.next;
    moved_ = rounding * bound_.since(start, result.next, margin_ / rounding, executor);
  }

  void find_pairs(const StepResult<Real>& result, Executor& executor) {
    load(result, executor);
    nearest_ = std::numeric_limits<double>::infinity();
    pairs_ = &no_pairs_;
    pairs_hold_ = false;
    if (!is_finite()) return;  // such a step is not taken
    const double motion = bound_.between(result.start, result.next, executor);
    const double active = NarrowPhase::active_distance(collision_.thickness), reach = active + margin_;
    const double longest = longest_edge();
    const double far = 2.0 * longest + reach + far_margins * margin_;
    bound_.look(result.next, far, far - 2.0 * longest - active);
    measure_motion(result, executor);
    // What is fast is looked at along its way in this step alone.
    const bool is_fast = !(moved_ <= 0.5 * margin_);
    moved_ = std::min(moved_, rounding * motion);
    pairs_ = &close_pairs_.find(is_fast ? start_ : end_, end_, reach, executor);
    pairs_hold_ = !is_fast;
    for (const ClosePair& pair : *pairs_) nearest_ = std::min(nearest_, pair.distance);
  }

  bool is_finite() const {
    return std::all_of(surface_.corners.begin(), surface_.corners.end(),
                       [&](Index i) { return start_[i].allFinite() && end_[i].allFinite(); });
  }

  /// At the end of the step [m].
  double longest_edge() const {
    double square = 0.0;
    for (const auto& [a, b] : surface_.edges) square = std::max(square, (end_[a] - end_[b]).squaredNorm());
    return std::sqrt(square);
  }

  template <class Visit>
  void for_each_corner(Executor& executor, const Visit& visit) {
    executor.parallel_for(surface_.corners.size(), particles_in_run, [&](std::size_t begin, std::size_t end) {
      for (std::size_t c = begin; c < end; ++c) visit(surface_.corners[c]);
    });
  }

  void load(const StepResult<Real>& result, Executor& executor) {
    for_each_corner(executor, [&](Index i) {
      start_[i] = result.start.position(i).template cast<double>();
      end_[i] = result.next.position(i).template cast<double>();
      velocity_[i] = result.next.velocity(i).template cast<double>();
      inverse_mass_[i] = free_mass_[i];
    });
    for (const ScriptedTime& script : scripted_) {
      if (script.holds_at(result.time)) inverse_mass_[script.particle] = 0.0;
    }
  }

  void store(const StepResult<Real>& result, Executor& executor) {
    for_each_corner(executor, [&](Index i) {
      if (inverse_mass_[i] == 0.0) return;
      result.next.set_position(i, end_[i].template cast<Real>());
      result.next.set_velocity(i, velocity_[i].template cast<Real>());
    });
  }

  /// What has been moved, as a step whose pairs are looked at again.
  void begin_round(const StepResult<Real>& result, Executor& executor) {
    store(result, executor);
    update_pairs(result, executor);
  }

  NarrowPhase::Step step_of(const StepResult<Real>& result, Executor& executor) const {
    return {start_, end_, inverse_mass_, moved_, bound_.between(result.start, result.next, executor)};
  }

  /// Moves apart what is too near, until that moves nothing so far that more may come near; then changes
  /// velocities. Whether anything was near.
  bool push_apart(const StepResult<Real>& result, Executor& executor) {
    obstacles_.move_to(result.time, result.h);
    bool touches = false;
    pushed_far_ = false;
    for (int round = 0; round < most_rounds; ++round) {
      if (round > 0) begin_round(result, executor);
      std::vector<SurfaceContact>& contacts =
          narrow_phase_.contacts_of(*pairs_, step_of(result, executor), executor);
      pushed_far_ = pushed_far_ || narrow_phase_.passed();
      if (contacts.empty()) break;
      touches = true;
      pushed_far_ = push(contacts, result.h, executor) > 0.1 * collision_.thickness || narrow_phase_.passed();
      choose_touching(contacts, round > 0);
      if (!pushed_far_) break;
    }
    if (touches) settle(result.h, executor);
    return touches;
  }

  /// How far particles are moved, at most [m].
  double push(std::vector<SurfaceContact>& contacts, double h, Executor& executor) {
    const std::size_t pairs = contacts.size();
    sweeps_.set(contacts);
    if (add_obstacles(contacts, h)) sweeps_.set(contacts);
    before_.clear();
    for (const Index i : sweeps_.particles()) before_.push_back(end_[i]);
    const std::uint64_t sweeps =
        sweeps_.run(end_, 0.0, depth_tolerance * collision_.thickness, collision_.sweeps, executor);
    met_with_.contact_sweeps = std::max(met_with_.contact_sweeps, sweeps);
    left_ = 0;
    for (std::size_t c = 0; c < pairs; ++c) {
      if (contacts[c].gap(end_) < -0.5 * contacts[c].least) ++left_;
    }
    double furthest = 0.0;
    for (std::size_t i = 0; i < before_.size(); ++i)
      furthest = std::max(furthest, (end_[sweeps_.particles()[i]] - before_[i]).norm());
    return furthest;
  }

  /// What lies on a collider is not pushed into it: it carries what lies on it. Whether there is any.
  bool add_obstacles(std::vector<SurfaceContact>& contacts, double h) {
    obstacle_velocity_.clear();
    for (const Index i : sweeps_.particles()) {
      for (std::size_t o = 0; o < obstacles_.size() && inverse_mass_[i] > 0.0; ++o) {
        const ObstacleSurface surface = obstacles_.seen_from(end_[i], o);
        if (!(surface.gap < collision_.thickness)) continue;
        contacts.push_back({{i, i, i, i},
                            {1.0, 0.0, 0.0, 0.0},
                            surface.outwards,
                            surface.outwards.dot(end_[i]) - std::max(surface.gap, 0.0),
                            start_[i] + h * surface.velocity,
                            surface.friction});
        obstacle_velocity_.push_back(surface.velocity);
      }
    }
    return !obstacle_velocity_.empty();
  }

  /// The contacts that push, for velocities; and with pushes in several rounds, all that touch after them.
  void choose_touching(const std::vector<SurfaceContact>& contacts, bool again) {
    touching_.clear();
    const std::size_t pairs = contacts.size() - obstacle_velocity_.size();
    for (std::size_t c = 0; c < contacts.size(); ++c) {
      const bool touches = again && contacts[c].gap(end_) < 1e-3 * collision_.thickness;
      if (!touches && !sweeps_.pushed(c)) continue;
      touching_.push_back(contacts[c]);
      touching_.back().held = c < pairs ? Vec3::Zero().eval() : obstacle_velocity_[c - pairs];
      touching_.back().least = touching_.back().normal.dot(touching_.back().held);
    }
  }

  /// What touches does not approach, and slides as friction lets it.
  void settle(double h, Executor& executor) {
    if (touching_.empty()) return;
    sweeps_.set(touching_);
    const std::uint64_t sweeps =
        sweeps_.run(velocity_, speed_tolerance, speed_tolerance_of_thickness * collision_.thickness / h,
                    collision_.sweeps, executor);
    met_with_.contact_sweeps = std::max(met_with_.contact_sweeps, sweeps);
    if (left_ == 0) return;
    met_with_.flags |= flag_contacts_left;
    met_with_.contacts_left = left_;
  }

  /// Moves what still passes as one piece, and what that passes then, until nothing does.
  void stop_what_crosses(const StepResult<Real>& result, Executor& executor) {
    zones_.clear();
    std::size_t crossing = 0;
    for (int round = 0; round < most_zone_rounds; ++round) {
      begin_round(result, executor);
      const auto& pairs = narrow_phase_.crossing(*pairs_, step_of(result, executor), executor);
      crossing = pairs.size();
      if (crossing == 0) break;
      for (const ClosePair& pair : pairs) zones_.join(pair.particles);
      zones_.move(start_, end_, velocity_);
    }
    const std::uint64_t particles = zones_.particles().size();
    met_with_.impact_zone_particles = std::max(met_with_.impact_zone_particles, particles);
    if (crossing == 0) return;
    met_with_.flags |= flag_contacts_left;
    met_with_.contacts_left = crossing;
  }

  SelfCollision collision_;
  Surface surface_;
  Places start_, end_, velocity_;
  double margin_;
  ClosePairs close_pairs_;
  MotionBound<Real> bound_;
  std::vector<double> free_mass_, inverse_mass_;
  std::vector<ScriptedTime> scripted_;
  Obstacles obstacles_;
  NarrowPhase narrow_phase_;
  ContactSweeps sweeps_;
  ImpactZones zones_;
  std::vector<SurfaceContact> touching_;
  std::vector<Vec3> obstacle_velocity_;  ///< of the last contacts, which are those with obstacles [m/s]
  Places before_;
  std::size_t left_ = 0;
  const std::vector<ClosePair> no_pairs_;
  const std::vector<ClosePair>* pairs_ = &no_pairs_;
  bool pairs_hold_ = false, pushed_far_ = false;
  double moved_ = 0.0, nearest_ = 0.0;
  Report met_with_;  ///< since it was told last
};

}  // namespace

template <class Real>
EffectPointer<Real> compile_effect(const SelfCollision& collision, const EffectContext<Real>& context) {
  return std::make_unique<SelfCollisionCorrection<Real>>(collision, context);
}

template EffectPointer<float> compile_effect(const SelfCollision&, const EffectContext<float>&);
template EffectPointer<double> compile_effect(const SelfCollision&, const EffectContext<double>&);

void check_effect(const SelfCollision& collision, const Scene& scene, const ElementChecks& checks) {
  checks.positive("thickness", collision.thickness, "m");
  checks.not_negative("friction", collision.friction, "");
  checks.at_least("sweeps", collision.sweeps, 1);
  checks.at_most("sweeps", collision.sweeps, most_sweeps);
  if (scene.triangles.empty())
    checks.add("the scene has no triangles", "add triangles, or leave self_collision out");
  check_chosen_triangles(scene, collision.triangles, checks);
}

/// It takes no shorter steps.
void add_bounds(const SelfCollision&, const Scene&, HeldParticles&) {}

}  // namespace hooke
