#pragma once

#include <optional>

#include <hooke/scene.h>
#include <hooke/simulation.h>

#include "viewer/live/command.h"
#include "viewer/live/drag_spring.h"
#include "viewer/live/work.h"
#include "writers/seen_tears.h"

namespace hooke::viewer {

/// A simulation whose method, step, threads and effects can be changed while it runs, and whose particles can
/// be dragged.
template <class Real>
class LiveSimulation {
 public:
  /// Throws as Simulation does.
  LiveSimulation(Scene scene, Settings settings);

  /// Goes on from the same state. Where the new settings or effects cannot be used it throws as Simulation
  /// does and goes on as before.
  void change(Setup setup);

  /// Back to the state at the start. What has been changed since the scene tore is as it was before it did.
  void reset();

  void drag(const Pull& drag);
  void release() { drag_.reset(); }

  /// Takes `count` steps, fewer if one goes bad, and adds to `work` what they took.
  Report take_steps(std::uint64_t count, Work& work);

  const Simulation<Real>& simulation() const { return simulation_; }
  const Scene& scene() const { return scene_; }  ///< as it has torn, where it has

  /// The same, null where it has not torn.
  const std::shared_ptr<const Scene>& torn() const { return tears_.scene(); }

 private:
  void pull();
  void look_for_tears();

  Scene scene_;
  std::optional<Scene> whole_;  ///< where it has torn, as it was before
  SeenTears tears_;
  Simulation<Real> simulation_;
  Snapshot<Real> start_;
  std::optional<Pull> drag_;
  DragSpring spring_;  // of the drag
};

extern template class LiveSimulation<float>;
extern template class LiveSimulation<double>;

}  // namespace hooke::viewer
