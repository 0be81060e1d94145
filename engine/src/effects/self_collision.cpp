#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "collide/awake_surface.h"
#include "collide/close_pairs.h"
#include "collide/contact_masses.h"
#include "collide/contact_sweeps.h"
#include "collide/impact_zones.h"
#include "collide/lasting_pairs.h"
#include "collide/narrow_phase.h"
#include "collide/obstacle_contacts.h"
#include "collide/pushed_contacts.h"
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

/// Sweeps end where nothing is too near, or approaches, by more than this share of the most at first: what
/// lies on one another then sinks by that share of a step's fall and comes to rest.
constexpr double tolerance = 0.03;

/// And, however fast it came, by no more than this share of the thickness; what is less than that one does
/// not count.
constexpr double most_depth = 0.01, least_depth = 1e-5;

/// Of places that may be so far from kept [m], or velocities [m/s].
ContactSweeps::Enough enough(double thickness, double most) {
  return {tolerance, least_depth * thickness, most * thickness};
}

/// The mean edge at the start [m].
double mean_edge(const Surface& surface, const Places& places) {
  double sum = 0.0;
  for (const auto& [a, b] : surface.edges) sum += (places[a] - places[b]).norm();
  return surface.edges.empty() ? 0.0 : sum / double(surface.edges.size());
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

/// What crosses is drawn apart by so many mean edges a second, and in a step, at most.
constexpr double drawn_edges_per_second = 15.0, drawn_edges_in_step = 0.25;

template <class Real>
class SelfCollisionCorrection final : public CompiledEffect<Real> {
 public:
  SelfCollisionCorrection(const SelfCollision& collision, const EffectContext<Real>& context)
      : collision_(collision),
        awake_(surface_of(collision, context.scene, context.model.order), context.model,
               NarrowPhase::active_distance(collision.thickness)),
        surface_(awake_.surface()),
        start_(start_of(context.scene, context.model.order)),
        end_(start_),
        velocity_(start_),
        edge_(mean_edge(surface_, start_)),
        masses_(inverse_masses_of_free(context.scene, context.model.order)),
        scripted_(scripted_times(context.scene, context.model.order)),
        obstacles_(context.scene, context.model.frames.get(), *context.model.meshes, collision.thickness,
                   masses_),
        narrow_phase_(collision.thickness, collision.friction, collision.swept),
        sweeps_(masses_.inverse()),
        pushed_(start_.size()),
        zones_(masses_.inverse()) {
    if (context.model.islands != nullptr) rest_ = start_;
    find_pairs_of(start_);
  }

  unsigned parts() const override { return corrects_everything; }

  void correct(const StepResult<Real>& result, Executor& executor) override {
    masses_.let_go();
    if (awake_.choose(result)) find_pairs_of(rest_);
    hold_scripted(result.time);
    update_pairs(result, executor);
    const bool is_tangled = is_anything_tangled(result, executor);
    if (is_tangled || (pairs_->may_touch() && any_touch(result, executor)))
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
    const std::size_t places = start_.capacity() + end_.capacity() + velocity_.capacity();
    return {std::string(SelfCollision::name),
            {},
            {"position", "velocity", "mass", "triangles"},
            {"position", "velocity"},
            awake_.bytes() + places * sizeof(Vec3) + masses_.bytes() +
                kept_apart_.capacity() * sizeof(ClosePair) + pairs_->bytes() +
                (untangling_ ? untangling_->bytes() : 0) + narrow_phase_.bytes() + sweeps_.bytes() +
                pushed_.bytes() + obstacles_.bytes()};
  }

 private:
  static constexpr std::size_t particles_in_run = 4096;

  void keep_apart(const StepResult<Real>& result, bool is_tangled, Executor& executor) {
    load(result, executor);
    obstacles_.move_to(result.time, result.h);
    if (is_tangled) draw_apart(result, executor);
    const bool touches = push_apart(result, executor);
    if (!touches && !is_tangled && !pushed_far_) return;
    if (collision_.swept && pushed_far_) stop_what_crosses(result, executor);
    store(result, executor);
  }

  /// Whether any pair touches or passes: where there are few, only their particles are looked at.
  bool any_touch(const StepResult<Real>& result, Executor& executor) {
    const std::vector<ClosePair>& pairs = pairs_kept_apart();
    if (4 * pairs.size() > surface_.corners.size()) return true;
    for (const ClosePair& pair : pairs) {
      for (const Index i : pair.particles) load(result, i);
    }
    const bool any = !narrow_phase_.contacts_of(pairs, step_of(result, executor), executor).empty();
    return any || narrow_phase_.passed();
  }

  /// Whether anything crosses at the start of the step.
  bool is_anything_tangled(const StepResult<Real>& result, Executor& executor) {
    if (!untangling_) return false;
    if (!untangling_->crossings().none_near()) load(result, executor);
    if (!untangling_->look(start_, executor)) return false;
    untangling_->leave([&](const SurfaceContact& pull) { return awake_.sleeps(pull.particles); });
    for (const SurfaceContact& pull : untangling_->pulls()) awake_.note_touch(pull.particles);
    return true;
  }

  void draw_apart(const StepResult<Real>& result, Executor& executor) {
    const double most = edge_ * std::min(drawn_edges_in_step, drawn_edges_per_second * result.h);
    obstacles_.hold_pinched(surface_.corners, end_);
    const Places& moves = untangling_->draw_apart(end_, most);
    obstacles_.keep_out(surface_.corners, moves, end_);
    begin_round(result, executor);
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
    const bool is_tangled = untangling_ && untangling_->is_tangled();
    if (!is_tangled && !awake_.any_sleeps()) return pairs_->found();
    kept_apart_.clear();
    for (const ClosePair& pair : pairs_->found()) {
      if (is_tangled && untangling_->are_entangled(pair)) continue;
      if (!awake_.any_sleeps() || !awake_.sleeps(pair.particles)) kept_apart_.push_back(pair);
    }
    return kept_apart_;
  }

  /// Begins anew with the surface as it is: nothing that was known of pairs changes what comes of them.
  void find_pairs_of(const Places& rest) {
    pairs_.emplace(surface_, rest, collision_.thickness, edge_, collision_.swept || collision_.untangle);
    if (collision_.untangle) untangling_.emplace(surface_, masses_.inverse(), collision_.thickness);
  }

  /// Pairs are found anew where particles have moved too far since.
  void update_pairs(const StepResult<Real>& result, Executor& executor) {
    if (pairs_->hold_in(result, executor)) return;
    load(result, executor);
    if (!pairs_->find(result, start_, end_, executor) || !untangling_) return;
    const ClosePairs& boxes = pairs_->boxes();
    untangling_->crossings().look(boxes.edge_boxes(), boxes.triangle_boxes(), pairs_->looked_at(),
                                  pairs_->margin(), executor);
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

  void hold_scripted(double time) {
    for (const ScriptedTime& script : scripted_) {
      if (script.holds_at(time)) masses_.hold(script.particle);
    }
  }

  void store(const StepResult<Real>& result, Executor& executor) {
    for_each_corner(executor, [&](Index i) {
      if (!masses_.can_move(i)) return;
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
    return {start_, end_, masses_.inverse(), pairs_->moved(), pairs_->motion_in(result, executor), result.h};
  }

  /// Moves apart what is too near, until that moves nothing so far that more may come near; then changes
  /// velocities. Whether anything was near.
  bool push_apart(const StepResult<Real>& result, Executor& executor) {
    pushed_.clear();
    left_ = 0, pushed_far_ = false;
    ContactSweeps::Enough kept = enough(collision_.thickness, most_depth);
    bool touches = false;
    for (int round = 0; round < most_rounds; ++round) {
      if (round > 0) begin_round(result, executor);
      std::vector<SurfaceContact>& contacts =
          narrow_phase_.contacts_of(pairs_kept_apart(), step_of(result, executor), executor);
      pushed_far_ = pushed_far_ || narrow_phase_.passed();
      if (contacts.empty()) break;
      touches = true;
      for (const SurfaceContact& contact : contacts) awake_.note_touch(contact.particles);
      pushed_far_ = push(contacts, kept, executor) > 0.1 * collision_.thickness || narrow_phase_.passed();
      pushed_.note(contacts, sweeps_, obstacles_.velocities(), result.h);
      if (!pushed_far_) break;
    }
    pushed_.forget_pinched(masses_);
    if (untangling_) add_pulls();
    settle(result.h, executor);
    return touches;
  }

  /// How far particles are moved, at most [m]. A later round need not keep contacts better than this one.
  double push(std::vector<SurfaceContact>& contacts, ContactSweeps::Enough& kept, Executor& executor) {
    sweeps_.find_particles(contacts);
    const std::size_t pairs = obstacles_.add_to(contacts, sweeps_.particles(), start_, end_, executor);
    sweeps_.set(contacts, executor);
    before_.clear();
    for (const Index i : sweeps_.particles()) before_.push_back(end_[i]);
    const auto [sweeps, depth] = sweeps_.run(end_, kept, collision_.sweeps, executor);
    met_with_.contact_sweeps = std::max(met_with_.contact_sweeps, sweeps);
    kept.least = depth;
    left_ = 0;
    for (std::size_t c = 0; c < pairs; ++c) {
      if (contacts[c].gap(end_) < -0.5 * contacts[c].least) ++left_;
    }
    double furthest = 0.0;
    for (std::size_t i = 0; i < before_.size(); ++i)
      furthest = std::max(furthest, (end_[sweeps_.particles()[i]] - before_[i]).norm());
    return furthest;
  }

  /// What crosses does not go further in.
  void add_pulls() {
    for (const SurfaceContact& pull : untangling_->pulls()) {
      if (!masses_.takes_pinched(pull)) pushed_.add(pull);
    }
  }

  /// What touches does not approach, and slides as friction lets it.
  void settle(double h, Executor& executor) {
    if (pushed_.all().empty()) return;
    sweeps_.find_particles(pushed_.all());
    sweeps_.set(pushed_.all(), executor);
    const ContactSweeps::Enough slow =
        enough(collision_.thickness / h, std::numeric_limits<double>::infinity());
    const std::uint64_t sweeps = sweeps_.run(velocity_, slow, collision_.sweeps, executor).sweeps;
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
      for (const ClosePair& pair : pairs) {
        zones_.join(pair.particles);
        awake_.note_touch(pair.particles);
      }
      zones_.move(start_, end_, velocity_);
    }
    const std::uint64_t particles = zones_.particles().size();
    met_with_.impact_zone_particles = std::max(met_with_.impact_zone_particles, particles);
    if (crossing == 0) return;
    met_with_.flags |= flag_contacts_left;
    met_with_.contacts_left = crossing;
  }

  SelfCollision collision_;
  AwakeSurface<Real> awake_;
  const Surface& surface_;  ///< of which something may touch
  Places start_, end_, velocity_;
  Places rest_;  ///< at the start of the scene, where islands may sleep
  double edge_;  ///< mean [m]
  ContactMasses masses_;
  std::vector<ScriptedTime> scripted_;
  ObstacleContacts obstacles_;
  std::optional<LastingPairs<Real>> pairs_;
  NarrowPhase narrow_phase_;
  ContactSweeps sweeps_;
  PushedContacts pushed_;
  ImpactZones zones_;
  std::optional<Untangling> untangling_;
  std::vector<ClosePair> kept_apart_;
  Places before_;
  std::size_t left_ = 0, crossings_ = 0;
  bool pushed_far_ = false;
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
