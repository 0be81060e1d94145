#pragma once

#include <vector>

#include <Eigen/Geometry>

#include <hooke/keyframe.h>
#include <hooke/rigid_pose.h>

namespace hooke {

/// Where a frame is at a time: world = rotation local + origin.
struct FramePlace {
  Vec3 origin;  ///< [m]
  Eigen::Matrix3d rotation;

  Vec3 at(const Vec3& local) const { return origin + rotation * local; }
};

/// How fast a frame is.
struct FrameVelocity {
  Vec3 origin = Vec3::Zero();  ///< of its origin, in the world [m/s]
  Vec3 spin = Vec3::Zero();    ///< in its own frame [rad/s]
};

/// How a frame moves: its pose at any time, by the keyframes of its path; or, without a path, by poses that
/// the host gives step by step.
class RigidMotion {
 public:
  /// `origin` [m] is what it turns about, and `axis`, of any length but zero, that of the path's turns.
  RigidMotion(const Vec3& origin, const Vec3& axis, std::vector<RigidKeyframe> path);

  /// Whether it is in one place at all times.
  bool still() const { return path_.size() < 2 && !moved_; }

  /// Whether the host may move it.
  bool follows_path() const { return !path_.empty(); }

  const Vec3& start() const { return origin_; }  ///< of its origin, without displacement [m]
  Vec3 origin(double time) const;                ///< of its frame, in the world [m]
  Eigen::Matrix3d rotation(double time) const;
  FramePlace at(double time) const { return {origin(time), rotation(time)}; }

  /// What it turns by from one time to another, as axis times angle [rad], in its own frame.
  Vec3 turn(double before, double after) const;

  /// In the world [m/s], just before `time`, of a point of its own frame.
  Vec3 velocity(const Vec3& local, double time) const;

  /// As forces at `time` meet it: just before; but where it begins to move, as it does then. Methods take
  /// forces at the beginning of a step or at its end, and a move by the host is one step: it counts at both,
  /// but no more when a step begins at its end.
  FrameVelocity velocity_at(double time) const;

  /// A step begins at `time` [s].
  void begin_step(double time) { rests_ = time >= to_time_; }

  /// Of a move by the host that had not ended when the step began [s]; infinite without.
  double end_of_move() const;

  /// Goes from where it is at `now` [s] evenly to a pose at `then`, and stays there.
  void move_to(const RigidPose& pose, double now, double then);

  /// Is there at all times.
  void put(const RigidPose& pose);

  /// As the host gave it, at `time`. Of one without a path.
  RigidPose pose(double time) const;

  std::size_t bytes() const { return path_.capacity() * sizeof(RigidKeyframe); }

 private:
  double share(double time) const;  ///< of the way from `from_` to `to_`, from 0 to 1
  FrameVelocity velocity_before(double time) const;

  Vec3 origin_, axis_;
  std::vector<RigidKeyframe> path_;
  bool moved_ = false;  ///< by the host
  RigidPose from_, to_;
  double from_time_ = 0.0, to_time_ = 0.0;  ///< [s]
  bool rests_ = true;                       ///< the step has begun after the move by the host
};

}  // namespace hooke
