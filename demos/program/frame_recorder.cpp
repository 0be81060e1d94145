#include "program/frame_recorder.h"

#include <algorithm>

namespace hooke::program {

template <class Real>
void FrameRecorder<Real>::record(const Simulation<Real>& simulation) {
  const double strain = simulation.max_strain();
  max_strain_ = frames_ == 0 ? strain : std::max(max_strain_, strain);
  if (writer_ != nullptr) {
    positions_.resize(simulation.particle_count());
    velocities_.resize(simulation.particle_count());
    simulation.copy_positions(positions_.data()->data(), sizeof(Vec3));
    simulation.copy_velocities(velocities_.data()->data(), sizeof(Vec3));
    torn_.look_at(simulation);
    writer_->write({simulation.time(), positions_, velocities_, torn_.scene().get()});
  }
  last_step_ = simulation.steps();
  ++frames_;
}

template class FrameRecorder<float>;
template class FrameRecorder<double>;

}  // namespace hooke::program
