#include "frames/rigid_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace hooke {
namespace {

constexpr double radians = std::numbers::pi / 180.0;

Vec3 axis_times_angle(const Eigen::Quaterniond& rotation) {
  const Eigen::AngleAxisd turn(rotation);
  return turn.angle() * turn.axis();
}

}  // namespace

RigidMotion::RigidMotion(const Vec3& origin, const Vec3& axis, std::vector<RigidKeyframe> path)
    : origin_(origin), axis_(axis.stableNormalized()), path_(std::move(path)) {}

double RigidMotion::share(double time) const {
  if (time >= to_time_) return 1.0;
  return std::max(0.0, (time - from_time_) / (to_time_ - from_time_));
}

RigidPose RigidMotion::pose(double time) const {
  const double part = share(time);
  if (part == 1.0) return to_;
  return {(1.0 - part) * from_.displacement + part * to_.displacement,
          from_.rotation.slerp(part, to_.rotation)};
}

Vec3 RigidMotion::origin(double time) const {
  return origin_ + (moved_ ? pose(time).displacement : on_path(path_, time).displacement);
}

Eigen::Matrix3d RigidMotion::rotation(double time) const {
  if (moved_) return pose(time).rotation.toRotationMatrix();
  return Eigen::AngleAxisd(on_path(path_, time).degrees * radians, axis_).toRotationMatrix();
}

Vec3 RigidMotion::turn(double before, double after) const {
  if (moved_) return axis_times_angle(pose(before).rotation.conjugate() * pose(after).rotation);
  return (on_path(path_, after).degrees - on_path(path_, before).degrees) * radians * axis_;
}

Vec3 RigidMotion::velocity(const Vec3& local, double time) const {
  const FrameVelocity velocity = velocity_before(time);
  return velocity.origin + rotation(time) * velocity.spin.cross(local);
}

double RigidMotion::end_of_move() const {
  return moved_ && !rests_ ? to_time_ : std::numeric_limits<double>::infinity();
}

FrameVelocity RigidMotion::velocity_at(double time) const {
  if (moved_ && rests_) return {};
  const bool begins = moved_ ? time == from_time_ : !path_.empty() && time == path_.front().time;
  return velocity_before(begins ? std::nextafter(time, std::numeric_limits<double>::infinity()) : time);
}

FrameVelocity RigidMotion::velocity_before(double time) const {
  if (moved_) {
    if (!(time > from_time_ && time <= to_time_)) return {};
    const double span = to_time_ - from_time_;
    return {(to_.displacement - from_.displacement) / span,
            axis_times_angle(from_.rotation.conjugate() * to_.rotation) / span};
  }
  const auto next =
      std::lower_bound(path_.begin(), path_.end(), time,
                       [](const RigidKeyframe& keyframe, double t) { return keyframe.time < t; });
  if (next == path_.begin() || next == path_.end()) return {};
  const RigidKeyframe &a = *(next - 1), &b = *next;
  const double span = b.time - a.time;
  return {(b.displacement - a.displacement) / span, (b.degrees - a.degrees) * radians / span * axis_};
}

void RigidMotion::move_to(const RigidPose& pose_then, double now, double then) {
  from_ = pose(now);
  to_ = {pose_then.displacement, pose_then.rotation.normalized()};
  from_time_ = now;
  to_time_ = then;
  rests_ = false;
  moved_ = true;
}

void RigidMotion::put(const RigidPose& pose) {
  from_ = to_ = {pose.displacement, pose.rotation.normalized()};
  from_time_ = to_time_ = 0.0;
  rests_ = true;
  moved_ = true;
}

}  // namespace hooke
