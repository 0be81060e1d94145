#include "scenes/hard/watched_run.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hooke::hard {

std::vector<Vec3> as_vectors(const std::vector<double>& coordinates) {
  std::vector<Vec3> vectors(coordinates.size() / 3);
  for (std::size_t i = 0; i < vectors.size(); ++i)
    vectors[i] = {coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]};
  return vectors;
}

template <class Real>
WatchedRun<Real>::WatchedRun(const Scene& scene, const Settings& settings) : simulation_(scene, settings) {
  const Energy energy = simulation_.energy();
  allowed_ = before_ = energy.total();
  most_internal_ = energy.kinetic + energy.elastic;
  least_external_ = most_external_ = energy.external;
  for (std::size_t e = 0; e < scene.effects.size(); ++e) {
    const auto* frame = std::get_if<FrameAttachment>(&scene.effects[e]);
    if (frame != nullptr && !frame->path.empty()) frames_.emplace_back(e, *frame);
  }
}

template <class Real>
bool WatchedRun<Real>::take(std::uint64_t count) {
  for (std::uint64_t i = 0; i < count && trouble_.empty(); ++i) {
    const double before = simulation_.time();
    const Report report = simulation_.step();
    if (report.ok()) allowed_ += work_of_frames(before);
    note(report);
  }
  return trouble_.empty();
}

template <class Real>
bool WatchedRun<Real>::skip(std::uint64_t count) {
  if (trouble_.empty()) note(simulation_.step(count));
  return trouble_.empty();
}

template <class Real>
void WatchedRun<Real>::note(const Report& report) {
  unsolved_ += (report.flags & flag_not_converged) != 0;
  contacts_left_ += report.contacts_left;
  if (report.ok()) {
    look();
  } else {
    trouble_ = report.message();
  }
}

template <class Real>
double WatchedRun<Real>::work_of_frames(double before) const {
  double work = 0.0;
  for (const auto& [effect, frame] : frames_) {
    const RigidKeyframe from = on_path(frame.path, before), to = on_path(frame.path, simulation_.time());
    const Vec3 turn = (to.degrees - from.degrees) * std::numbers::pi / 180.0 * frame.axis.normalized();
    const FrameLoad load = simulation_.carried_force(effect);
    work -= load.force.dot(to.displacement - from.displacement) + load.torque.dot(turn);
  }
  return work;
}

template <class Real>
void WatchedRun<Real>::look() {
  const Energy energy = simulation_.energy();
  const double total = energy.total();
  if (!std::isfinite(total)) {
    trouble_ = "energy is not finite, and the report of the step does not say so";
    return;
  }
  most_internal_ = std::max(most_internal_, energy.kinetic + energy.elastic);
  least_external_ = std::min(least_external_, energy.external);
  most_external_ = std::max(most_external_, energy.external);
  const double scale = std::max(most_internal_, most_external_ - least_external_);
  if (scale > 0.0) {
    energy_excess_ = std::max(energy_excess_, (total - allowed_) / scale);
    largest_rise_ = std::max(largest_rise_, (total - before_) / scale);
  }
  before_ = total;
}

template <class Real>
void WatchedRun<Real>::place(const Snapshot<Real>& snapshot) {
  const double before = simulation_.energy().total();
  simulation_.restore(snapshot);
  const double work = simulation_.energy().total() - before;
  allowed_ += work;
  before_ += work;
}

template <class Real>
std::vector<Vec3> WatchedRun<Real>::positions() const {
  std::vector<double> coordinates(3 * simulation_.particle_count());
  simulation_.copy_positions(coordinates.data(), 3 * sizeof(double));
  return as_vectors(coordinates);
}

template <class Real>
std::vector<Vec3> WatchedRun<Real>::velocities() const {
  std::vector<double> coordinates(3 * simulation_.particle_count());
  simulation_.copy_velocities(coordinates.data(), 3 * sizeof(double));
  return as_vectors(coordinates);
}

template class WatchedRun<float>;
template class WatchedRun<double>;

}  // namespace hooke::hard
