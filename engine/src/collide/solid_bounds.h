#pragma once

#include <hooke/contact_effects.h>

#include "collide/contact.h"
#include "collide/strip_bounds.h"
#include "frames/rigid_motion.h"
#include "sleep/disturbances.h"

namespace hooke {

/// Whether a collider is a force, rather than putting particles back.
inline bool is_penalty(const Collider& collider) {
  return collider.stiffness > 0.0;
}

/// Around a collider that is at a place, with its thickness, in the world; of a plane across an axis the side
/// below it, of other planes everything.
template <class Real>
Bounds<Real> bounds_at(const Collider& collider, const FramePlace& place);

/// Whether a box lies wholly above a plane and its thickness, in the world. Of other shapes their own boxes
/// say enough.
template <class Real>
bool is_clear_of(const LocalShape<Real>& shape, const Pose<Real>& pose, Real thickness,
                 const Bounds<Real>& box);

/// Disturbs what is where a solid goes from one time [s] to another, if it does. `half`: of its extent along
/// its own axes, thickness included [m].
void disturb_near(const RigidMotion& motion, const Vec3& half, double from, double to,
                  Disturbances& disturbed);

/// Whether what is within `reach` [m] of a point that goes from one place to another may meet a box.
template <class Real>
bool may_meet(const Vec3& from, const Vec3& to, double reach, const Bounds<Real>& box);

}  // namespace hooke
