#include <string>

#include "collide/mesh_checks.h"
#include "collide/pinch.h"
#include "collide/pose_of.h"
#include "collide/solid_bounds.h"
#include "effects/effect_functions.h"
#include "effects/in_no_step.h"
#include "effects/penalty_collider.h"
#include "effects/rigid_path_checks.h"
#include "scene/number_text.h"

namespace hooke {
namespace {

/// A collider, as it runs.
template <class Real>
struct Solid {
  const RigidMotion* motion;
  LocalShape<Real> shape;
  Vec3 half;     ///< of the extent along its own axes, thickness included [m]
  double reach;  ///< [m] from its origin, thickness included, however it is turned
  Real thickness, friction, restitution;
};

/// All colliders of a scene that put particles back: the first of them has them all, so that strips are
/// compared with many boxes at once.
template <class Real>
class Colliders final : public CompiledEffect<Real> {
 public:
  explicit Colliders(const EffectContext<Real>& context) : blocks_(block_count(context.model.particles())) {
    for (std::size_t i = 0; i < context.scene.effects.size(); ++i) {
      const auto* collider = std::get_if<Collider>(&context.scene.effects[i]);
      if (collider != nullptr && !is_penalty(*collider))
        add(*collider, context.model.frames->of(i), *context.model.meshes);
    }
    for (std::size_t block = 0; block < blocks_; ++block) free_.push_back(free_lanes(context.model, block));
  }

  unsigned parts() const override { return corrects_strips; }

  void correct_strip(const StepResult<Real>& result, std::size_t begin, std::size_t end) const override {
    for_each_strip(begin, end, [&](std::size_t first, std::size_t last) {
      const Bounds<Real> box = bounds_of(result.start, result.next, first, last);
      PushedLanes pushed;
      for_each_near(result, box, [&](const Contact<Real>& contact) {
        for (std::size_t block = first; block < last; ++block)
          pushed.add(block - first, resolve_block(contact, result, block));
      });
      for (std::size_t block = first; block < last; ++block) {
        if (pushed.again[block - first] != 0) let_go(result, box, block, pushed.again[block - first]);
      }
    });
  }

  /// One that the host has begun to move is no longer looked for in the boxes of those that are still.
  void frames_changed() override {
    for (std::size_t s = 0; s < still_.size(); ++s) {
      if (still_[s].motion->still() || bounds_.dropped(s)) continue;
      moving_.push_back(still_[s]);
      bounds_.drop(s);
    }
  }

  void disturb(double from, double to, Disturbances& disturbed) const override {
    for (const Solid<Real>& solid : moving_) disturb_near(*solid.motion, solid.half, from, to, disturbed);
  }

  Stage stage() const override {
    std::size_t bytes = free_.capacity() * sizeof(std::uint16_t) + bounds_.bytes() +
                        contacts_.capacity() * sizeof(Contact<Real>);
    for (const auto* solids : {&still_, &moving_}) {
      bytes += solids->capacity() * sizeof(Solid<Real>);
      for (const Solid<Real>& solid : *solids) bytes += solid.motion->bytes() + bytes_of(solid.shape);
    }
    return {
        std::string(Collider::name), {}, {"position", "velocity", "time"}, {"position", "velocity"}, bytes};
  }

 private:
  static std::uint16_t free_lanes(const Model<Real>& model, std::size_t block) {
    std::uint32_t lanes = 0;
    for (std::size_t lane = 0; lane < block_size; ++lane) {
      const std::size_t particle = block * block_size + lane;
      if (particle < model.particles() && !model.pinned(particle)) lanes |= 1u << lane;
    }
    return std::uint16_t(lanes);
  }

  void add(const Collider& collider, const RigidMotion* motion, PreparedMeshes& meshes) {
    Solid<Real> solid{motion,
                      local_shape<Real>(collider.shape, collider.thickness, blocks_, meshes),
                      half_extent_of(collider.shape) + Vec3::Constant(collider.thickness),
                      radius_of(collider.shape) + collider.thickness,
                      Real(collider.thickness),
                      Real(collider.friction),
                      Real(collider.restitution)};
    if (!solid.motion->still()) {
      moving_.push_back(std::move(solid));
      return;
    }
    bounds_.add(bounds_at<Real>(collider, solid.motion->at(0.0)));
    contacts_.push_back(contact_of(solid, 0.0, 0.0, 1.0));
    still_.push_back(std::move(solid));
  }

  static Contact<Real> contact_of(const Solid<Real>& solid, double before, double after, double h) {
    Contact<Real> contact{solid.shape,
                          pose_of<Real>(solid.motion->at(before)),
                          pose_of<Real>(solid.motion->at(after)),
                          {},
                          {},
                          solid.thickness,
                          solid.friction,
                          solid.restitution};
    const Vec3 velocity = (solid.motion->origin(after) - solid.motion->origin(before)) / h;
    const Vec3 spin = solid.motion->turn(before, after) / h;
    for (Eigen::Index k = 0; k < 3; ++k) {
      contact.velocity[k] = Real(velocity[k]);
      contact.spin[k] = Real(spin[k]);
    }
    return contact;
  }

  static bool is_clear_of(const Contact<Real>& contact, const Bounds<Real>& box) {
    return hooke::is_clear_of(contact.shape, contact.after, contact.thickness, box);
  }

  /// Calls visit(contact) for each collider that may touch something in the box around a strip.
  template <class Visit>
  void for_each_near(const StepResult<Real>& result, const Bounds<Real>& box, const Visit& visit) const {
    for (std::size_t s = next_meeting(bounds_, box, 0); s < bounds_.size();
         s = next_meeting(bounds_, box, s + 1)) {
      if (!is_clear_of(contacts_[s], box)) visit(contacts_[s]);
    }
    for (const Solid<Real>& solid : moving_) {
      const Vec3 from = solid.motion->origin(result.time - result.h), to = solid.motion->origin(result.time);
      if (!may_meet(from, to, solid.reach, box)) continue;
      const Contact<Real> contact = contact_of(solid, result.time - result.h, result.time, result.h);
      if (!is_clear_of(contact, box)) visit(contact);
    }
  }

  ContactBlock<Real> block_of(const StepResult<Real>& result, std::size_t block) const {
    State<Real>& next = result.next;
    const State<Real>& start = result.start;
    const std::size_t i = block * block_size;
    return {next.x() + i,  next.y() + i,  next.z() + i,  next.vx() + i, next.vy() + i,  next.vz() + i,
            start.x() + i, start.y() + i, start.z() + i, free_[block],  Real(result.h), block};
  }

  /// Returns which particles it has pushed.
  std::uint16_t resolve_block(const Contact<Real>& contact, const StepResult<Real>& result,
                              std::size_t block) const {
    const std::uint16_t touched = resolve(contact, block_of(result, block));
    if (touched != 0) repack(result.next, block * block_size, touched);
    return touched;
  }

  /// Finds places for particles that several solids have pushed.
  void let_go(const StepResult<Real>& result, const Bounds<Real>& box, std::size_t block,
              std::uint16_t lanes) const {
    Pinch<Real> pinch(block_of(result, block), lanes);
    for (int round = 0; round < Pinch<Real>::most_rounds && pinch.is_any_left(); ++round) {
      pinch.begin_round();
      for_each_near(result, box, [&](const Contact<Real>& contact) { pinch.push(contact); });
      pinch.end_round();
      if (round > 0 || !pinch.is_any_left()) continue;
      pinch.begin_look();
      for_each_near(result, box, [&](const Contact<Real>& contact) { pinch.look(contact); });
      pinch.carry_pinched();
    }
    pinch.carry_left();
    repack(result.next, block * block_size, pinch.lanes());
  }

  /// Writes the packed copies of what has changed.
  static void repack(State<Real>& state, std::size_t first, std::uint16_t touched) {
    if (state.packed_positions() == nullptr) return;
    for (std::size_t lane = 0; lane < block_size; ++lane) {
      if ((touched >> lane & 1) == 0) continue;
      state.set_position(first + lane, state.position(first + lane));
      state.set_velocity(first + lane, state.velocity(first + lane));
    }
  }

  std::size_t blocks_;
  std::vector<Solid<Real>> still_, moving_;
  std::vector<Contact<Real>> contacts_;  ///< with those that are still
  BoundsList<Real> bounds_;              ///< around these
  std::vector<std::uint16_t> free_;      ///< of each block the lanes of particles that are not pinned
};

/// Of those that put particles back, or of those that are forces.
bool is_first_of_its_kind(const Collider& collider, const Scene& scene) {
  for (const Effect& effect : scene.effects) {
    const auto* one = std::get_if<Collider>(&effect);
    if (one != nullptr && is_penalty(*one) == is_penalty(collider)) return one == &collider;
  }
  return false;
}

void check_shape(const PlaneShape& plane, const ElementChecks& checks) {
  checks.direction("shape.plane.normal", plane.normal);
  checks.finite("shape.plane.height", plane.height, "m");
}

void check_shape(const SphereShape& sphere, const ElementChecks& checks) {
  checks.finite("shape.sphere.centre", sphere.centre, "m");
  checks.positive("shape.sphere.radius", sphere.radius, "m");
}

void check_shape(const CapsuleShape& capsule, const ElementChecks& checks) {
  checks.finite("shape.capsule.start", capsule.start, "m");
  checks.finite("shape.capsule.end", capsule.end, "m");
  checks.positive("shape.capsule.radius", capsule.radius, "m");
}

void check_shape(const BoxShape& box, const ElementChecks& checks) {
  checks.finite("shape.box.centre", box.centre, "m");
  for (Eigen::Index k = 0; k < 3; ++k)
    checks.positive("shape.box.half_size[" + std::to_string(k) + "]", box.half_size[k], "m");
}

void check_shape(const MeshShape& mesh, const ElementChecks& checks) {
  check_mesh(mesh, checks);
}

void check_shape(const HeightfieldShape& field, const ElementChecks& checks) {
  check_heightfield(field, checks);
}

void check_penalty(const Collider& collider, const ElementChecks& checks) {
  checks.not_negative("stiffness", collider.stiffness, "N/m");
  checks.not_negative("damping", collider.damping, "N s/m");
  if (is_penalty(collider) && collider.restitution != 0.0)
    checks.add("restitution is " + to_text(collider.restitution) + " beside a stiffness",
               "give 0: the damping decides how fast particles come back; or a stiffness of 0");
  if (collider.stiffness == 0.0 && collider.damping > 0.0)
    checks.add("damping is " + to_text(collider.damping) + " N s/m without a stiffness",
               "give a stiffness > 0 [N/m], or a damping of 0");
}

}  // namespace

template <class Real>
EffectPointer<Real> compile_effect(const Collider& collider, const EffectContext<Real>& context) {
  if (!is_first_of_its_kind(collider, context.scene)) return std::make_unique<InNoStep<Real>>();
  if (is_penalty(collider)) return penalty_colliders(context);
  return std::make_unique<Colliders<Real>>(context);
}

template EffectPointer<float> compile_effect(const Collider&, const EffectContext<float>&);
template EffectPointer<double> compile_effect(const Collider&, const EffectContext<double>&);

void check_effect(const Collider& collider, const Scene&, const ElementChecks& checks) {
  std::visit([&](const auto& shape) { check_shape(shape, checks); }, collider.shape);
  checks.not_negative("thickness", collider.thickness, "m");
  checks.not_negative("friction", collider.friction, "");
  if (!(collider.restitution >= 0.0 && collider.restitution <= 1.0))
    checks.add("restitution is " + to_text(collider.restitution), "give a value from 0 to 1");
  check_penalty(collider, checks);
  checks.direction("axis", collider.axis);
  check_rigid_path(collider.path, checks);
}

/// Where it puts particles back it takes no shorter steps. Penalties add up: solids overlap, and the host may
/// move any one into another.
void add_bounds(const Collider& collider, const Scene&, HeldParticles& held) {
  if (is_penalty(collider)) held.add_to_each(collider.stiffness, collider.damping);
}

}  // namespace hooke
