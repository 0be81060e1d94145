#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <hooke/scene.h>

#include "frames/rigid_motion.h"
#include "model/order.h"
#include "state.h"

namespace hooke {

/// A particle that goes with a frame.
struct HeldParticle {
  Index particle;  ///< in the engine's order
  double mass;     ///< [kg]
  Vec3 local;      ///< where it is in the frame [m]
  const RigidMotion* frame;
  std::size_t memory = 0;  ///< where State::memory has what its frame carries: see carried.h
};

/// The frames of a scene, and the particles that attachments hold to them.
class Frames {
 public:
  Frames(const Scene& scene, const Order& order);

  /// How the frame of an effect moves; null where it has none.
  RigidMotion* of(std::size_t effect) const {
    return effect < motions_.size() ? motions_[effect].get() : nullptr;
  }

  /// Sorted by particle.
  std::span<const HeldParticle> held() const { return held_; }
  std::span<const HeldParticle> held_between(std::size_t first, std::size_t last) const;
  void set_memory(const RigidMotion& frame, std::size_t memory);

  /// Notes a velocity [m/s] that a held particle had, or less that it got, between the stages of a step.
  template <class Vector>
  void note_velocity(const HeldParticle& one, const Vector& velocity, bool first) {
    Vec3& sum = taken_[place_of(one)];
    if (first) sum = Vec3::Zero();
    sum += velocity.template cast<double>();
  }

  /// What a frame has taken of a held particle's velocity between the stages of a step [m/s]; nothing where
  /// the last stage goes from the start of the step.
  const Vec3& taken(const HeldParticle& one) const { return taken_[place_of(one)]; }

  /// They move as those of another model of the same scene, whoever moves these. Before effects are compiled
  /// for them.
  void share_motions_of(const Frames& other);

  /// A step begins at `time` [s]: see RigidMotion.
  void begin_step(double time);

  /// The first end [s] of the moves by the host that had not ended when the step began; infinite without.
  double end_of_moves() const;

  /// Of the frames that the host moves, in the order of their effects; none before it has moved the first.
  std::vector<RigidPose> poses(double time) const;
  void note_moved() { any_moved_ = true; }

  /// As many as poses() gives once a frame was moved.
  std::size_t movable() const;
  void put(std::span<const RigidPose> poses);

  /// Where the host moved frames, it has not.
  void put_back();

 private:
  std::vector<std::shared_ptr<RigidMotion>> motions_;  ///< of each effect
  std::size_t place_of(const HeldParticle& one) const { return std::size_t(&one - held_.data()); }

  std::vector<HeldParticle> held_;
  std::vector<Vec3> taken_;  ///< of each of those
  bool any_moved_ = false;
};

/// Null of a scene without frames.
std::shared_ptr<Frames> frames_of(const Scene& scene, const Order& order);

/// Puts particles where their frames are at `time` [s], with the velocities that they have there.
template <class Real>
void hold(std::span<const HeldParticle> held, double time, State<Real>& state) {
  for (const HeldParticle& one : held) {
    state.set_position(one.particle, one.frame->at(time).at(one.local).template cast<Real>());
    state.set_velocity(one.particle, one.frame->velocity(one.local, time).template cast<Real>());
  }
}

}  // namespace hooke
