#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <hooke/simulation.h>

#include "writers/frame_writer.h"
#include "writers/seen_tears.h"

namespace hooke::program {

/// Looks at a run's states: its largest strain, and frames for a writer.
template <class Real>
class FrameRecorder {
 public:
  /// No `writer`: only the strain is kept, and no memory is used.
  explicit FrameRecorder(FrameWriter* writer) : writer_(writer) {}

  /// Takes the newest state as the next frame.
  void record(const Simulation<Real>& simulation);

  std::size_t frames() const { return frames_; }
  std::uint64_t last_step() const { return last_step_; }  ///< steps taken up to the last frame
  double max_strain() const { return max_strain_; }       ///< [1] over the frames

 private:
  FrameWriter* writer_;
  std::vector<Vec3> positions_, velocities_;
  SeenTears torn_;
  std::size_t frames_ = 0;
  std::uint64_t last_step_ = 0;
  double max_strain_ = 0.0;
};

extern template class FrameRecorder<float>;
extern template class FrameRecorder<double>;

}  // namespace hooke::program
