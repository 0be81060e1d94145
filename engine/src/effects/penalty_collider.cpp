#include "effects/penalty_collider.h"

#include <limits>

#include "collide/pose_of.h"
#include "collide/solid_bounds.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "effects/penalty_collider.cpp"
#include <hwy/foreach_target.h>

#include "collide/pose-inl.h"
#include "collide/shapes-inl.h"

#ifndef HOOKE_PENALTY
#define HOOKE_PENALTY
namespace hooke {

/// A collider at a time, as the forces of particles on it meet it.
template <class Real>
struct Penalty {
  const LocalShape<Real>& shape;
  Pose<Real> pose;
  Real velocity[3];                              ///< of its origin [m/s], in the world
  Real spin[3];                                  ///< [rad/s], in its own frame
  Real thickness, friction, stiffness, damping;  ///< [m], [1], [N/m], [N s/m]
};

/// How deep particles of a strip are in it [m]; 0 outside.
template <class Real>
struct StripDepths {
  alignas(cache_line) Real of[strip_blocks * block_size];
};

}  // namespace hooke
#endif

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

/// Calls visit(d, lane, position, surface, depth, touches) for vectors of a strip's lanes in which some
/// touch. Positions and the surface are in the solid's own frame.
template <class Real, class Visit>
HWY_INLINE void for_each_touching(const Strip<Real>& strip, const Penalty<Real>& penalty,
                                  const Visit& visit) {
  with_shape(penalty.shape, [&](const auto& shape) HWY_ATTR {
    for_each_vector(strip, [&](auto d, std::size_t lane) HWY_ATTR {
      const auto x = load_vectors(d, strip.x, strip.y, strip.z, std::ptrdiff_t(lane));
      const auto p = to_local(d, penalty.pose, x);
      const auto counts = hn::FirstN(d, strip.particles - std::min(lane, strip.particles));
      const std::size_t block = (strip.first + lane) / block_size;
      const auto surface = surface_again(d, shape, p, counts, block, lane % block_size);
      const auto depth = hn::Sub(hn::Set(d, penalty.thickness), surface.distance);
      const auto touches = hn::And(counts, hn::Gt(depth, hn::Zero(d)));
      if (!hn::AllFalse(d, touches)) visit(d, lane, p, surface, depth, touches);
    });
  });
}

/// What presses particles out of the solid, in its own frame.
template <class D, class V = hn::Vec<D>>
struct Press {
  hn::Mask<D> presses;
  Vector3<V> outwards;  ///< unit vectors
  V push;               ///< F_n [N]
  Vector3<V> along;     ///< velocity along the surface, against the solid [m/s]
  V brake;              ///< |F_t| / |along| [N s/m], at most the damping
};

/// Calls visit(d, lane, press) for vectors of lanes of which some are pressed.
template <class Real, class Visit>
HWY_INLINE void for_each_press(const Strip<Real>& strip, const Penalty<Real>& penalty, const Visit& visit) {
  for_each_touching(
      strip, penalty,
      [&](auto d, std::size_t lane, const auto& p, const auto& surface, auto depth, auto touches) HWY_ATTR {
        const auto v = load_vectors(d, strip.vx, strip.vy, strip.vz, std::ptrdiff_t(lane));
        const auto against =
            turned_back(d, penalty.pose, v - set3(d, penalty.velocity)) - cross(set3(d, penalty.spin), p);
        const auto speed = dot(against, surface.outwards);
        const auto damping = hn::Set(d, penalty.damping);
        const auto push = hn::NegMulAdd(damping, speed, hn::Mul(hn::Set(d, penalty.stiffness), depth));
        const auto presses = hn::And(touches, hn::Gt(push, hn::Zero(d)));
        if (hn::AllFalse(d, presses)) return;
        const auto along = against - scaled(speed, surface.outwards);
        const auto slip = hn::Sqrt(dot(along, along));
        const auto most = hn::Mul(hn::Set(d, penalty.friction), push);
        const auto least = hn::Set(d, std::numeric_limits<Real>::min());
        const auto brake = hn::Min(damping, hn::Div(most, hn::Max(slip, least)));
        visit(d, lane, Press<decltype(d)>{presses, surface.outwards, push, along, brake});
      });
}

template <class Real>
HWY_INLINE void push_out(const Strip<Real>& strip, const Penalty<Real>& penalty, StripForce<Real>& force) {
  for_each_press(strip, penalty, [&](auto d, std::size_t lane, const auto& press) HWY_ATTR {
    const auto f =
        turned(d, penalty.pose, scaled(press.push, press.outwards) - scaled(press.brake, press.along));
    const auto add = [&](auto value, Real* sum) HWY_ATTR {
      hn::Store(hn::Add(hn::Load(d, sum), hn::IfThenElseZero(press.presses, value)), d, sum);
    };
    add(f.x, force.x + lane);
    add(f.y, force.y + lane);
    add(f.z, force.z + lane);
  });
}

/// Along the normal that of spring and damper, across it the brake, in all directions. Of a particle that
/// slides that is more than the derivative along its way, which is zero: so no step of a solver makes
/// friction turn a particle round.
template <class Real>
HWY_INLINE void add_stiffness(const Strip<Real>& strip, const Penalty<Real>& penalty,
                              const DerivativeWeights<Real>& weights, StripBlocks<Real>& blocks) {
  const Real normal = weights.stiffness * penalty.stiffness + weights.damping * penalty.damping;
  for_each_press(strip, penalty, [&](auto d, std::size_t lane, const auto& press) HWY_ATTR {
    const auto n = turned(d, penalty.pose, press.outwards);
    const auto zero = hn::Zero(d);
    const auto across = hn::Mul(hn::Set(d, weights.damping), press.brake);
    const auto more = hn::Sub(hn::Set(d, normal), across);
    const auto add = [&](auto a, auto b, auto isotropic, Real* sum) HWY_ATTR {
      const auto value = hn::MulAdd(hn::Mul(more, a), b, isotropic);
      hn::Store(hn::Add(hn::Load(d, sum), hn::IfThenElseZero(press.presses, value)), d, sum);
    };
    add(n.x, n.x, across, blocks.xx + lane);
    add(n.x, n.y, zero, blocks.xy + lane);
    add(n.x, n.z, zero, blocks.xz + lane);
    add(n.y, n.y, across, blocks.yy + lane);
    add(n.y, n.z, zero, blocks.yz + lane);
    add(n.z, n.z, across, blocks.zz + lane);
  });
}

template <class Real>
HWY_INLINE void find_depths(const Strip<Real>& strip, const Penalty<Real>& penalty,
                            StripDepths<Real>& depths) {
  for_each_touching(strip, penalty,
                    [&](auto d, std::size_t lane, const auto&, const auto&, auto depth, auto touches)
                        HWY_ATTR { hn::Store(hn::IfThenElseZero(touches, depth), d, depths.of + lane); });
}

}  // namespace

void push_float(const Strip<float>& strip, const Penalty<float>& penalty, StripForce<float>& force) {
  push_out(strip, penalty, force);
}
void push_double(const Strip<double>& strip, const Penalty<double>& penalty, StripForce<double>& force) {
  push_out(strip, penalty, force);
}
void stiffness_float(const Strip<float>& strip, const Penalty<float>& penalty,
                     const DerivativeWeights<float>& weights, StripBlocks<float>& blocks) {
  add_stiffness(strip, penalty, weights, blocks);
}
void stiffness_double(const Strip<double>& strip, const Penalty<double>& penalty,
                      const DerivativeWeights<double>& weights, StripBlocks<double>& blocks) {
  add_stiffness(strip, penalty, weights, blocks);
}
void depths_float(const Strip<float>& strip, const Penalty<float>& penalty, StripDepths<float>& depths) {
  find_depths(strip, penalty, depths);
}
void depths_double(const Strip<double>& strip, const Penalty<double>& penalty, StripDepths<double>& depths) {
  find_depths(strip, penalty, depths);
}

}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hooke {
namespace {

HWY_EXPORT(push_float);
HWY_EXPORT(push_double);
HWY_EXPORT(stiffness_float);
HWY_EXPORT(stiffness_double);
HWY_EXPORT(depths_float);
HWY_EXPORT(depths_double);

void push(const Strip<float>& strip, const Penalty<float>& penalty, StripForce<float>& force) {
  HWY_DYNAMIC_DISPATCH(push_float)(strip, penalty, force);
}
void push(const Strip<double>& strip, const Penalty<double>& penalty, StripForce<double>& force) {
  HWY_DYNAMIC_DISPATCH(push_double)(strip, penalty, force);
}
void add_matrices(const Strip<float>& strip, const Penalty<float>& penalty,
                  const DerivativeWeights<float>& weights, StripBlocks<float>& blocks) {
  HWY_DYNAMIC_DISPATCH(stiffness_float)(strip, penalty, weights, blocks);
}
void add_matrices(const Strip<double>& strip, const Penalty<double>& penalty,
                  const DerivativeWeights<double>& weights, StripBlocks<double>& blocks) {
  HWY_DYNAMIC_DISPATCH(stiffness_double)(strip, penalty, weights, blocks);
}
void find(const Strip<float>& strip, const Penalty<float>& penalty, StripDepths<float>& depths) {
  HWY_DYNAMIC_DISPATCH(depths_float)(strip, penalty, depths);
}
void find(const Strip<double>& strip, const Penalty<double>& penalty, StripDepths<double>& depths) {
  HWY_DYNAMIC_DISPATCH(depths_double)(strip, penalty, depths);
}

template <class Real>
class PenaltyColliders final : public CompiledEffect<Real> {
 public:
  explicit PenaltyColliders(const EffectContext<Real>& context) {
    const std::size_t blocks = block_count(context.model.particles());
    for (std::size_t i = 0; i < context.scene.effects.size(); ++i) {
      const auto* collider = std::get_if<Collider>(&context.scene.effects[i]);
      if (collider == nullptr || !is_penalty(*collider)) continue;
      const RigidMotion* motion = context.model.frames->of(i);
      bounds_.add(bounds_at<Real>(*collider, motion->at(0.0)));
      if (!motion->still()) bounds_.widen(solids_.size());
      solids_.push_back({*collider, motion, blocks, *context.model.meshes});
    }
    for (const Solid& solid : solids_) at_start_.push_back(penalty_of(solid, 0.0));
  }

  unsigned parts() const override { return has_force | has_own_derivative; }

  void add_force(const Strip<Real>& strip, double time, StripForce<Real>& force) const override {
    for_each_near(strip, time, [&](const Penalty<Real>& penalty) { push(strip, penalty, force); });
  }

  void add_derivative(const Strip<Real>& strip, double time, const DerivativeWeights<Real>& weights,
                      StripBlocks<Real>& blocks) const override {
    for_each_near(strip, time,
                  [&](const Penalty<Real>& penalty) { add_matrices(strip, penalty, weights, blocks); });
  }

  double energy(const Strip<Real>& strip) const override {
    double sum = 0.0;
    for_each_near(strip, strip.state.time, [&](const Penalty<Real>& penalty) {
      StripDepths<Real> depths{};
      find(strip, penalty, depths);
      double squares = 0.0;
      for (std::size_t lane = 0; lane < strip.particles; ++lane)
        squares += double(depths.of[lane]) * double(depths.of[lane]);
      sum += 0.5 * double(penalty.stiffness) * squares;
    });
    return sum;
  }

  void disturb(double from, double to, Disturbances& disturbed) const override {
    for (const Solid& solid : solids_) disturb_near(*solid.motion, solid.half, from, to, disturbed);
  }

  /// Those that the host has begun to move are anywhere from now on.
  void frames_changed() override {
    for (std::size_t s = 0; s < solids_.size(); ++s) {
      if (!solids_[s].motion->still()) bounds_.widen(s);
    }
  }

  Stage stage() const override {
    std::size_t bytes =
        solids_.capacity() * sizeof(Solid) + at_start_.capacity() * sizeof(Penalty<Real>) + bounds_.bytes();
    for (const Solid& solid : solids_) bytes += solid.motion->bytes() + bytes_of(solid.shape);
    return {
        std::string(Collider::name) + " (penalty)", {}, {"position", "velocity", "time"}, {"force"}, bytes};
  }

 private:
  struct Solid {
    Solid(const Collider& collider, const RigidMotion* how, std::size_t blocks, PreparedMeshes& meshes)
        : motion(how),
          shape(local_shape<Real>(collider.shape, collider.thickness, blocks, meshes)),
          half(half_extent_of(collider.shape) + Vec3::Constant(collider.thickness)),
          reach(radius_of(collider.shape) + collider.thickness),
          thickness(Real(collider.thickness)),
          friction(Real(collider.friction)),
          stiffness(Real(collider.stiffness)),
          damping(Real(collider.damping)) {}

    const RigidMotion* motion;
    LocalShape<Real> shape;
    Vec3 half;     ///< of the extent along its own axes, thickness included [m]
    double reach;  ///< [m] from its origin, however it is turned
    Real thickness, friction, stiffness, damping;
  };

  static Penalty<Real> penalty_of(const Solid& solid, double time) {
    Penalty<Real> penalty{solid.shape,
                          pose_of<Real>(solid.motion->at(time)),
                          {},
                          {},
                          solid.thickness,
                          solid.friction,
                          solid.stiffness,
                          solid.damping};
    const FrameVelocity velocity = solid.motion->velocity_at(time);
    for (Eigen::Index k = 0; k < 3; ++k) {
      penalty.velocity[k] = Real(velocity.origin[k]);
      penalty.spin[k] = Real(velocity.spin[k]);
    }
    return penalty;
  }

  /// Calls visit(penalty) for each that may touch something of a strip, in the order of the scene.
  template <class Visit>
  void for_each_near(const Strip<Real>& strip, double time, const Visit& visit) const {
    const std::size_t begin = strip.first / block_size, end = begin + strip.lanes / block_size;
    const Bounds<Real> box = bounds_of(strip.state, strip.state, begin, end);
    for (std::size_t s = next_meeting(bounds_, box, 0); s < bounds_.size();
         s = next_meeting(bounds_, box, s + 1)) {
      const Solid& solid = solids_[s];
      if (solid.motion->still()) {
        visit_unless_clear(at_start_[s], box, visit);
      } else {
        const Vec3 origin = solid.motion->origin(time);
        if (may_meet(origin, origin, solid.reach, box))
          visit_unless_clear(penalty_of(solid, time), box, visit);
      }
    }
  }

  template <class Visit>
  static void visit_unless_clear(const Penalty<Real>& penalty, const Bounds<Real>& box, const Visit& visit) {
    if (!is_clear_of(penalty.shape, penalty.pose, penalty.thickness, box)) visit(penalty);
  }

  std::vector<Solid> solids_;
  std::vector<Penalty<Real>> at_start_;  ///< of each, which those that are still are at all times
  BoundsList<Real> bounds_;              ///< around those that are still
};

}  // namespace

template <class Real>
EffectPointer<Real> penalty_colliders(const EffectContext<Real>& context) {
  return std::make_unique<PenaltyColliders<Real>>(context);
}

template EffectPointer<float> penalty_colliders(const EffectContext<float>&);
template EffectPointer<double> penalty_colliders(const EffectContext<double>&);

}  // namespace hooke
#endif
