#include <algorithm>

#include "effects/effect_functions.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "effects/ground_plane.cpp"
#include <hwy/foreach_target.h>

#include "effects/lanes-inl.h"

#ifndef HOOKE_PLANE
#define HOOKE_PLANE
namespace hooke {

/// A plane in the precision of the run.
template <class Real>
struct Plane {
  Real nx, ny, nz, height;  ///< unit normal, [m]
  Real stiffness, damping;  ///< [N/m], [N s/m]
};

}  // namespace hooke
#endif

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

template <class Real>
HWY_INLINE void add(const Strip<Real>& strip, const Plane<Real>& plane, StripForce<Real>& force) {
  for_each_vector(strip, [&](auto d, std::size_t lane) HWY_ATTR {
    const auto nx = hn::Set(d, plane.nx), ny = hn::Set(d, plane.ny), nz = hn::Set(d, plane.nz);
    const auto along_normal = [&](const Real* x, const Real* y, const Real* z) HWY_ATTR {
      return hn::MulAdd(nx, hn::LoadU(d, x + lane),
                        hn::MulAdd(ny, hn::LoadU(d, y + lane), hn::Mul(nz, hn::LoadU(d, z + lane))));
    };
    const auto depth = hn::Sub(hn::Set(d, plane.height), along_normal(strip.x, strip.y, strip.z));
    const auto speed = along_normal(strip.vx, strip.vy, strip.vz);
    const auto resistance =
        hn::NegMulAdd(hn::Set(d, plane.damping), speed, hn::Mul(hn::Set(d, plane.stiffness), depth));
    const auto zero = hn::Zero(d);
    const auto pushes = hn::And(hn::Gt(depth, zero), hn::Gt(resistance, zero));
    const auto push = hn::IfThenElseZero(pushes, resistance);
    add_product(d, push, nx, force.x + lane);
    add_product(d, push, ny, force.y + lane);
    add_product(d, push, nz, force.z + lane);
  });
}

}  // namespace

void push_float(const Strip<float>& strip, const Plane<float>& plane, StripForce<float>& force) {
  add(strip, plane, force);
}

void push_double(const Strip<double>& strip, const Plane<double>& plane, StripForce<double>& force) {
  add(strip, plane, force);
}

}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hooke {
namespace {

HWY_EXPORT(push_float);
HWY_EXPORT(push_double);

/// Pushes lanes that are below the plane outwards.
void add_push(const Strip<float>& strip, const Plane<float>& plane, StripForce<float>& force) {
  HWY_DYNAMIC_DISPATCH(push_float)(strip, plane, force);
}

void add_push(const Strip<double>& strip, const Plane<double>& plane, StripForce<double>& force) {
  HWY_DYNAMIC_DISPATCH(push_double)(strip, plane, force);
}

template <class Real>
class GroundPlaneForce final : public CompiledEffect<Real> {
 public:
  explicit GroundPlaneForce(const GroundPlane& plane) : n_(plane.normal.stableNormalized()) {
    plane_ = {Real(n_.x()),       Real(n_.y()),          Real(n_.z()),
              Real(plane.height), Real(plane.stiffness), Real(plane.damping)};
  }

  void add_force(const Strip<Real>& strip, double, StripForce<Real>& force) const override {
    add_push(strip, plane_, force);
  }

  void add_derivative(const Strip<Real>& strip, double, const DerivativeWeights<Real>& weights,
                      StripBlocks<Real>& blocks) const override {
    const Plane<Real>& p = plane_;
    const Real weight = weights.stiffness * p.stiffness + weights.damping * p.damping;
    for (std::size_t lane = 0; lane < strip.particles; ++lane) {
      const Real depth = p.height - (p.nx * strip.x[lane] + p.ny * strip.y[lane] + p.nz * strip.z[lane]);
      const Real speed = p.nx * strip.vx[lane] + p.ny * strip.vy[lane] + p.nz * strip.vz[lane];
      if (!(depth > Real(0) && p.stiffness * depth > p.damping * speed)) continue;
      blocks.xx[lane] += weight * p.nx * p.nx;
      blocks.xy[lane] += weight * p.nx * p.ny;
      blocks.xz[lane] += weight * p.nx * p.nz;
      blocks.yy[lane] += weight * p.ny * p.ny;
      blocks.yz[lane] += weight * p.ny * p.nz;
      blocks.zz[lane] += weight * p.nz * p.nz;
    }
  }

  double energy(const Strip<Real>& strip) const override {
    double sum = 0.0;
    for (std::size_t lane = 0; lane < strip.particles; ++lane) {
      const Vec3 position(strip.x[lane], strip.y[lane], strip.z[lane]);
      const double depth = std::max(double(plane_.height) - n_.dot(position), 0.0);
      sum += 0.5 * double(plane_.stiffness) * depth * depth;
    }
    return sum;
  }

  unsigned parts() const override { return has_force | has_own_derivative; }

  Stage stage() const override {
    return {std::string(GroundPlane::name), {}, {"position", "velocity"}, {"force"}, 0};
  }

 private:
  Vec3 n_;
  Plane<Real> plane_;
};

}  // namespace

template <class Real>
EffectPointer<Real> compile_effect(const GroundPlane& plane, const EffectContext<Real>&) {
  return std::make_unique<GroundPlaneForce<Real>>(plane);
}

template EffectPointer<float> compile_effect(const GroundPlane&, const EffectContext<float>&);
template EffectPointer<double> compile_effect(const GroundPlane&, const EffectContext<double>&);

void check_effect(const GroundPlane& ground, const Scene&, const ElementChecks& checks) {
  checks.direction("normal", ground.normal);
  checks.finite("height", ground.height, "m");
  checks.not_negative("stiffness", ground.stiffness, "N/m");
  checks.not_negative("damping", ground.damping, "N s/m");
}

void add_bounds(const GroundPlane& ground, const Scene&, HeldParticles& held) {
  held.add_to_each(ground.stiffness, ground.damping);
}

}  // namespace hooke
#endif
