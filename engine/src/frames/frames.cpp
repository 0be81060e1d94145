#include "frames/frames.h"

#include <algorithm>
#include <limits>

#include "collide/local_shape.h"

namespace hooke {
namespace {

std::shared_ptr<RigidMotion> motion_of(const Effect& effect) {
  if (const auto* collider = std::get_if<Collider>(&effect))
    return std::make_shared<RigidMotion>(origin_of(collider->shape), collider->axis, collider->path);
  if (const auto* attachment = std::get_if<FrameAttachment>(&effect))
    return std::make_shared<RigidMotion>(attachment->origin, attachment->axis, attachment->path);
  return nullptr;
}

}  // namespace

Frames::Frames(const Scene& scene, const Order& order) {
  for (const Effect& effect : scene.effects) {
    motions_.push_back(motion_of(effect));
    const auto* attachment = std::get_if<FrameAttachment>(&effect);
    if (attachment == nullptr) continue;
    for (const Index particle : attachment->particles)
      held_.push_back({order.engine(particle), scene.particles.mass[particle],
                       scene.particles.position[particle] - attachment->origin, motions_.back().get()});
  }
  std::sort(held_.begin(), held_.end(),
            [](const HeldParticle& a, const HeldParticle& b) { return a.particle < b.particle; });
  taken_.assign(held_.size(), Vec3::Zero());
}

std::span<const HeldParticle> Frames::held_between(std::size_t first, std::size_t last) const {
  const auto before = [](const HeldParticle& one, std::size_t particle) { return one.particle < particle; };
  const auto begin = std::lower_bound(held_.begin(), held_.end(), first, before);
  return {begin, std::lower_bound(begin, held_.end(), last, before)};
}

void Frames::set_memory(const RigidMotion& frame, std::size_t memory) {
  for (HeldParticle& held : held_) {
    if (held.frame == &frame) held.memory = memory;
  }
}

void Frames::share_motions_of(const Frames& other) {
  for (HeldParticle& held : held_) {
    const auto own = std::find_if(motions_.begin(), motions_.end(),
                                  [&](const auto& motion) { return motion.get() == held.frame; });
    held.frame = other.motions_[std::size_t(own - motions_.begin())].get();
  }
  motions_ = other.motions_;
}

void Frames::begin_step(double time) {
  if (!any_moved_) return;
  for (const auto& motion : motions_) {
    if (motion != nullptr) motion->begin_step(time);
  }
}

double Frames::end_of_moves() const {
  double first = std::numeric_limits<double>::infinity();
  if (!any_moved_) return first;
  for (const auto& motion : motions_) {
    if (motion != nullptr) first = std::min(first, motion->end_of_move());
  }
  return first;
}

std::size_t Frames::movable() const {
  return std::size_t(std::count_if(motions_.begin(), motions_.end(), [](const auto& motion) {
    return motion != nullptr && !motion->follows_path();
  }));
}

std::vector<RigidPose> Frames::poses(double time) const {
  std::vector<RigidPose> poses;
  for (const auto& motion : motions_) {
    if (any_moved_ && motion != nullptr && !motion->follows_path()) poses.push_back(motion->pose(time));
  }
  return poses;
}

void Frames::put(std::span<const RigidPose> poses) {
  any_moved_ = true;
  std::size_t n = 0;
  for (const auto& motion : motions_) {
    if (motion != nullptr && !motion->follows_path()) motion->put(poses[n++]);
  }
}

void Frames::put_back() {
  if (any_moved_) put(std::vector<RigidPose>(movable()));
  any_moved_ = false;
}

std::shared_ptr<Frames> frames_of(const Scene& scene, const Order& order) {
  const bool any = std::any_of(scene.effects.begin(), scene.effects.end(), [](const Effect& effect) {
    return std::holds_alternative<Collider>(effect) || std::holds_alternative<FrameAttachment>(effect);
  });
  return any ? std::make_shared<Frames>(scene, order) : nullptr;
}

}  // namespace hooke
