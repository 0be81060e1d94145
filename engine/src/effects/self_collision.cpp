#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "collide/close_pairs.h"
#include "collide/contact_sweeps.h"
#include "collide/impact_zones.h"
#include "collide/motion_bound.h"
#include "collide/narrow_phase.h"
#include "collide/obstacles.h"
#include "collide/untangling.h"
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

/// The mean edge at the start [m].
double mean_edge(const Surface& surface, const Places& places) {
  double sum = 0.0;
  for (const auto& [a, b] : surface.edges) sum += (places[a] - places[b]).norm();
  return surface.edges.empty() ? 0.0 : sum / double(surface.edges.size());
}

/// Pairs are looked for that are so much further apart than contacts are [m]: the more, the longer they do
/// for, and the more they are.
struct Margins {
  double narrow;  ///< where cloth lies on cloth
  double wide;    ///< elsewhere: neighbours that share no particle should not be pairs

  Margins(double thickness, double edge)
      : narrow(0.5 * thickness),
        wide(std::max({narrow, 0.25 * edge, 0.6 * edge - NarrowPhase::active_distance(thickness)})) {}
};

/// More pairs than so many times the corners are of cloth that lies on cloth.
constexpr double crowd = 8.0;

/// Where cloth lies on nothing, pairs are looked for where particles are going to be, so many steps ahead, so
/// that they hold for longer: as far as uses up this share of the margin.
constexpr double most_ahead = 500.0, least_ahead = 0.2, share_ahead = 0.75;

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

/// What crosses is drawn apart by so many mean edges a second, and in a step, at most.
constexpr double drawn_edges_per_second = 15.0, drawn_edges_in_step = 0.25;

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
        looked_(start_),
        edge_(mean_edge(surface_, start_)),
        margins_(collision.thickness, edge_),
        margin_(margins_.wide),
        close_pairs_(surface_, start_, collision.thickness),
        bound_(surface_.corners),
        free_mass_(inverse_masses_of_free(context.scene, context.model.order)),
        inverse_mass_(free_mass_),
        is_pinched_(free_mass_.size(), 0),
        scripted_(scripted_times(context.scene, context.model.order)),
        obstacles_(context.scene, context.model.frames.get(), collision.thickness),
        narrow_phase_(collision.thickness, collision.friction, collision.swept),
        sweeps_(inverse_mass_),
        zones_(inverse_mass_) {
    if (collision.untangle) untangling_.emplace(surface_, inverse_mass_, collision.thickness);
  }

  unsigned parts() const override { return corrects_everything; }

  void correct(const StepResult<Real>& result, Executor& executor) override {
    update_pairs(result, executor);
    const bool is_tangled = is_anything_tangled(result, executor);
    if (is_tangled || (is_anything_near() && may_touch(result, executor)))
      keep_apart(result, is_tangled, executor);
    if (untangling_) count_crossings(result, executor);
  }

  void tell(Report& report) override {
    report.flags |= met_with_.flags;
    report.contact_sweeps = std::max(report.contact_sweeps, met_with_.contact_sweeps);
    report.impact_zone_particles = std::max(report.impact_zone_particles, met_with_.impact_zone_particles);
    if (met_with_.contacts_left > 0) report.contacts_left = met_with_.contacts_left;
    report.crossings += crossings_;
    met_with_ = {};
  }

  Stage stage() const override {
    const std::size_t places =
        start_.capacity() + end_.capacity() + velocity_.capacity() + looked_.capacity();
    return {std::string(SelfCollision::name),
            {},
            {"position", "velocity", "mass", "triangles"},
            {"position", "velocity"},
            places * sizeof(Vec3) + (free_mass_.capacity() + inverse_mass_.capacity()) * sizeof(double) +
                is_pinched_.capacity() + kept_apart_.capacity() * sizeof(ClosePair) + close_pairs_.bytes() +
                bound_.bytes() + (untangling_ ? untangling_->bytes() : 0) + narrow_phase_.bytes() +
                sweeps_.bytes() + obstacles_.bytes()};
  }

 private:
  static constexpr std::size_t particles_in_run = 4096;

  /// No less than what rounding takes from a bound on motion.
  static constexpr double rounding = 1.0 + 1e-6;

  void keep_apart(const StepResult<Real>& result, bool is_tangled, Executor& executor) {
    load(result, executor);
    let_all_go(result);
    if (is_tangled) draw_apart(result, executor);
    const bool touches = push_apart(result, executor);
    if (!touches && !is_tangled && !pushed_far_) return;
    if (collision_.swept && pushed_far_) stop_what_crosses(result, executor);
    store(result, executor);
  }

  /// Whether a pair may touch in this step.
  bool is_anything_near() const {
    return nearest_ - moved_ <= NarrowPhase::active_distance(collision_.thickness);
  }

  /// Whether any pair touches or passes: where there are few, only their particles are looked at.
  bool may_touch(const StepResult<Real>& result, Executor& executor) {
    if (4 * pairs_->size() > surface_.corners.size()) return true;
    for (const ClosePair& pair : *pairs_) {
      for (const Index i : pair.particles) load(result, i);
    }
    let_all_go(result);
    const bool touches = !narrow_phase_.contacts_of(*pairs_, step_of(result, executor), executor).empty();
    return touches || narrow_phase_.passed();
  }

  /// Whether anything crosses at the start of the step.
  bool is_anything_tangled(const StepResult<Real>& result, Executor& executor) {
    if (!untangling_) return false;
    if (!untangling_->crossings().none_near()) load(result, executor), let_all_go(result);
    return untangling_->look(start_, executor);
  }

  void draw_apart(const StepResult<Real>& result, Executor& executor) {
    const double most = edge_ * std::min(drawn_edges_in_step, drawn_edges_per_second * result.h);
    obstacles_.move_to(result.time, result.h);
    for (const Index i : surface_.corners) hold_if_pinched(i);
    const Places& moves = untangling_->draw_apart(end_, most);
    for (const Index i : surface_.corners) keep_out_of_obstacles(i, moves[i]);
    begin_round(result, executor);
  }

  /// Takes back as much of a particle's move as went into colliders.
  void keep_out_of_obstacles(Index i, const Vec3& move) {
    for (std::size_t o = 0; o < obstacles_.size() && inverse_mass_[i] > 0.0; ++o) {
      const ObstacleSurface surface = obstacles_.seen_from(end_[i], o);
      const double inwards = -move.dot(surface.outwards);
      if (surface.gap < 0.0 && inwards > 0.0) end_[i] += std::min(-surface.gap, inwards) * surface.outwards;
    }
  }

  void count_crossings(const StepResult<Real>& result, Executor& executor) {
    update_pairs(result, executor);
    crossings_ = 0;
    if (untangling_->crossings().none_near()) return;
    load(result, executor);
    crossings_ = untangling_->crossings().find(end_, executor).size();
  }

  /// Those close pairs that are kept apart.
  const std::vector<ClosePair>& pairs_kept_apart() {
    if (!untangling_ || !untangling_->is_tangled()) return *pairs_;
    kept_apart_.clear();
    for (const ClosePair& pair : *pairs_) {
      if (!untangling_->are_entangled(pair)) kept_apart_.push_back(pair);
    }
    return kept_apart_;
  }

  /// Pairs are found anew where particles have moved too far since.
  void update_pairs(const StepResult<Real>& result, Executor& executor) {
    if (pairs_hold_) measure_motion(result, executor);
    if (!pairs_hold_ || !(moved_ <= margin_)) find_pairs(result, executor);
  }

  /// How far particles have moved against each other at the ends of this step, since pairs were found.
  void measure_motion(const StepResult<Real>& result, Executor& executor) {
    const State<Real>& start = collision_.swept || untangling_ ? result.start : result.next;
    moved_ = rounding * bound_.since(start, result.next, margin_ / rounding, executor);
  }

  void find_pairs(const StepResult<Real>& result, Executor& executor) {
    load(result, executor);
    nearest_ = std::numeric_limits<double>::infinity();
    pairs_ = &no_pairs_;
    pairs_hold_ = false;
    if (!is_finite()) return;  // such a step is not taken
    margin_ = is_crowd_ ? margins_.narrow : margins_.wide;
    look(result, 0.0, executor);
    pairs_hold_ = moved_ <= margin_;
    if (pairs_hold_ && !is_crowd_) look_ahead(result, executor);
    // What is fast is looked at along its way in this step alone.
    if (!pairs_hold_)
      moved_ = std::min(moved_, rounding * bound_.between(result.start, result.next, executor));
    const double reach = NarrowPhase::active_distance(collision_.thickness) + margin_;
    pairs_ = pairs_hold_ ? &close_pairs_.find(looked_, looked_, reach, executor)
                         : &close_pairs_.find(start_, end_, reach, executor);
    if (untangling_) {
      untangling_->crossings().look(close_pairs_.edge_boxes(), close_pairs_.triangle_boxes(),
                                    pairs_hold_ ? &looked_ : nullptr, margin_, executor);
    }
    for (const ClosePair& pair : *pairs_) nearest_ = std::min(nearest_, pair.distance);
    is_crowd_ = double(pairs_->size()) > crowd * double(surface_.corners.size());
  }

  /// Unless that leads too far from where they are: what is far moves more, and others are near each other
  /// there.
  void look_ahead(const StepResult<Real>& result, Executor& executor) {
    const double motion = rounding * bound_.since(result.start, result.next, margin_, executor);
    const double ahead = std::min(most_ahead, share_ahead * margin_ / motion - 1.0);
    if (!(ahead > least_ahead)) return;
    look(result, ahead, executor);
    if (!(moved_ <= margin_)) look(result, 0.0, executor);
  }

  /// At where particles are going to be after so many more steps like this one.
  void look(const StepResult<Real>& result, double ahead, Executor& executor) {
    bound_.look(result.start, result.next, ahead);
    for (const Index i : surface_.corners) looked_[i] = bound_.looked(i);
    const double edges = 2.0 * longest_edge(), active = NarrowPhase::active_distance(collision_.thickness);
    const double far = edges + active + margin_ + far_margins * margins_.wide;
    bound_.choose_near(far, far - edges - active);
    measure_motion(result, executor);
  }

  bool is_finite() const {
    return std::all_of(surface_.corners.begin(), surface_.corners.end(),
                       [&](Index i) { return start_[i].allFinite() && end_[i].allFinite(); });
  }

  /// Where pairs are looked for [m].
  double longest_edge() const {
    double square = 0.0;
    for (const auto& [a, b] : surface_.edges)
      square = std::max(square, (looked_[a] - looked_[b]).squaredNorm());
    return std::sqrt(square);
  }

  template <class Visit>
  void for_each_corner(Executor& executor, const Visit& visit) {
    executor.parallel_for(surface_.corners.size(), particles_in_run, [&](std::size_t begin, std::size_t end) {
      for (std::size_t c = begin; c < end; ++c) visit(surface_.corners[c]);
    });
  }

  void load(const StepResult<Real>& result, Executor& executor) {
    for_each_corner(executor, [&](Index i) { load(result, i); });
  }

  void load(const StepResult<Real>& result, Index i) {
    start_[i] = result.start.position(i).template cast<double>();
    end_[i] = result.next.position(i).template cast<double>();
    velocity_[i] = result.next.velocity(i).template cast<double>();
  }

  /// At the start of a step nothing is known to be pinched.
  void let_all_go(const StepResult<Real>& result) {
    if (!holds_any_ && scripted_.empty()) return;
    holds_any_ = false;
    for (const Index i : surface_.corners) {
      inverse_mass_[i] = free_mass_[i];
      is_pinched_[i] = 0;
    }
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

  /// What has been moved, as a step whose pairs are looked at again. Read back as it is stored, whether pairs
  /// are found anew or not: when they are may change no bits.
  void begin_round(const StepResult<Real>& result, Executor& executor) {
    store(result, executor);
    load(result, executor);
    update_pairs(result, executor);
  }

  NarrowPhase::Step step_of(const StepResult<Real>& result, Executor& executor) const {
    return {start_, end_, inverse_mass_, moved_, bound_.between(result.start, result.next, executor)};
  }

  /// Moves apart what is too near, until that moves nothing so far that more may come near; then changes
  /// velocities. Whether anything was near.
  bool push_apart(const StepResult<Real>& result, Executor& executor) {
    obstacles_.move_to(result.time, result.h);
    touching_.clear();
    left_ = 0, pushed_far_ = false;
    bool touches = false;
    for (int round = 0; round < most_rounds; ++round) {
      if (round > 0) begin_round(result, executor);
      std::vector<SurfaceContact>& contacts =
          narrow_phase_.contacts_of(pairs_kept_apart(), step_of(result, executor), executor);
      pushed_far_ = pushed_far_ || narrow_phase_.passed();
      if (contacts.empty()) break;
      touches = true;
      pushed_far_ = push(contacts, result.h, executor) > 0.1 * collision_.thickness || narrow_phase_.passed();
      choose_touching(contacts, round > 0);
      if (!pushed_far_) break;
    }
    if (untangling_) add_pulls();
    settle(result.h, executor);
    return touches;
  }

  /// How far particles are moved, at most [m].
  double push(std::vector<SurfaceContact>& contacts, double h, Executor& executor) {
    sweeps_.find_particles(contacts);
    const std::size_t pairs = add_obstacles(contacts, h);
    sweeps_.set(contacts, executor);
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

  /// What lies on a collider is not pushed into it: it carries what lies on it. Leaves out what is pinched;
  /// returns how many contacts of pairs there are then.
  std::size_t add_obstacles(std::vector<SurfaceContact>& contacts, double h) {
    on_obstacles_.clear(), obstacle_velocity_.clear();
    if (obstacles_.size() > 0) {
      for (const Index i : sweeps_.particles()) find_obstacles_at(i, h);
      std::erase_if(contacts, [&](const SurfaceContact& contact) {
        return takes_pinched(contact) || is_squeezed(contact);
      });
    }
    const std::size_t pairs = contacts.size();
    contacts.insert(contacts.end(), on_obstacles_.begin(), on_obstacles_.end());
    return pairs;
  }

  void find_obstacles_at(Index i, double h) {
    const std::size_t others = on_obstacles_.size();
    std::size_t deep_in = 0;
    for (std::size_t o = 0; o < obstacles_.size() && inverse_mass_[i] > 0.0; ++o) {
      const ObstacleSurface surface = obstacles_.seen_from(end_[i], o);
      if (!(surface.gap < collision_.thickness)) continue;
      deep_in += is_deep(surface) ? 1 : 0;
      on_obstacles_.push_back({{i, i, i, i},
                               {1.0, 0.0, 0.0, 0.0},
                               surface.outwards,
                               surface.outwards.dot(end_[i]) - std::max(surface.gap, 0.0),
                               start_[i] + h * surface.velocity,
                               surface.friction});
      obstacle_velocity_.push_back(surface.velocity);
    }
    if (deep_in < 2) return;
    hold(i);
    on_obstacles_.erase(on_obstacles_.begin() + std::ptrdiff_t(others), on_obstacles_.end());
    obstacle_velocity_.resize(others);
  }

  /// Whether two pieces are so near that there is no room for both between solids that they lie on: these
  /// hold each against the push of the other.
  bool is_squeezed(const SurfaceContact& contact) const {
    if (!(contact.gap(end_) < 0.0)) return false;
    const auto is_held = [&](double side) {
      for (std::size_t k = 0; k < 4; ++k) {
        if (!(side * contact.weights[k] > 0.0)) continue;
        auto on = std::lower_bound(
            on_obstacles_.begin(), on_obstacles_.end(), contact.particles[k],
            [](const SurfaceContact& a, Index particle) { return a.particles[0] < particle; });
        for (; on != on_obstacles_.end() && on->particles[0] == contact.particles[k]; ++on) {
          if (side * contact.normal.dot(on->normal) < -0.5) return true;
        }
      }
      return false;
    };
    return is_held(1.0) && is_held(-1.0);
  }

  /// What is so deep in several solids is pinched: colliders leave it there.
  bool is_deep(const ObstacleSurface& surface) const { return surface.gap < -0.01 * collision_.thickness; }

  void hold(Index pinched) {
    holds_any_ = true;
    inverse_mass_[pinched] = 0.0;
    is_pinched_[pinched] = 1;
  }

  bool takes_pinched(const SurfaceContact& contact) const {
    for (std::size_t k = 0; k < 4; ++k) {
      if (contact.weights[k] != 0.0 && is_pinched_[contact.particles[k]] != 0) return true;
    }
    return false;
  }

  void hold_if_pinched(Index i) {
    std::size_t deep_in = 0;
    for (std::size_t o = 0; o < obstacles_.size() && inverse_mass_[i] > 0.0; ++o)
      deep_in += is_deep(obstacles_.seen_from(end_[i], o)) ? 1 : 0;
    if (deep_in > 1) hold(i);
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

  /// What crosses does not go further in.
  void add_pulls() {
    for (const SurfaceContact& pull : untangling_->pulls()) {
      if (!takes_pinched(pull)) touching_.push_back(pull);
    }
  }

  /// What touches does not approach, and slides as friction lets it.
  void settle(double h, Executor& executor) {
    if (touching_.empty()) return;
    sweeps_.find_particles(touching_);
    sweeps_.set(touching_, executor);
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
      const auto& pairs = narrow_phase_.crossing(pairs_kept_apart(), step_of(result, executor), executor);
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
  Places looked_;  ///< where pairs were looked for
  double edge_;    ///< mean [m]
  Margins margins_;
  double margin_;  ///< of the pairs that are known
  ClosePairs close_pairs_;
  MotionBound<Real> bound_;
  std::vector<double> free_mass_, inverse_mass_;
  std::vector<unsigned char> is_pinched_;  ///< of each particle in this step
  std::vector<ScriptedTime> scripted_;
  Obstacles obstacles_;
  NarrowPhase narrow_phase_;
  ContactSweeps sweeps_;
  ImpactZones zones_;
  std::optional<Untangling> untangling_;
  std::vector<ClosePair> kept_apart_;
  std::vector<SurfaceContact> touching_;
  std::vector<SurfaceContact> on_obstacles_;  ///< the last contacts, sorted by particle
  std::vector<Vec3> obstacle_velocity_;       ///< of each of these [m/s]
  Places before_;
  std::size_t left_ = 0, crossings_ = 0;
  const std::vector<ClosePair> no_pairs_;
  const std::vector<ClosePair>* pairs_ = &no_pairs_;
  bool pairs_hold_ = false, pushed_far_ = false, holds_any_ = false;
  bool is_crowd_ = true;  ///< whether much lay on one another when pairs were found last
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
