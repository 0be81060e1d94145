#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include <hooke/scene.h>

#include "viewer/control_map.h"
#include "viewer/live/energy_history.h"
#include "viewer/live/simulation_thread.h"
#include "viewer/live/study_thread.h"
#include "viewer/scene_view.h"

namespace hooke::viewer {

/// The study of accuracy, from the button to its plot.
struct StudyState {
  double budget = 10.0;                  ///< [s] of wall time
  double seconds = 2.0;                  ///< [s] of simulated time
  std::unique_ptr<StudyThread> running;  ///< also when it is done, as its result is shown
  bool shown = false;
  bool resume = false;  ///< the simulation, which stands still meanwhile so that times are right
};

/// All that panels, mouse and keys show and change.
struct State {
  Scene scene;  ///< as it was at the start
  SimulationThread simulation;
  SceneView view;
  Setup wanted;  ///< as the controls show it; what is in force is in the moment
  EnergyHistory energies{};
  StudyState study{};
  ControlMap controls{};
  std::string notice{};  ///< what was done last and cannot be seen otherwise
  bool panels = true, help = false, closing = false;
  bool save_picture = false;  ///< of the next frame

  const Moment& moment() const { return simulation.moment(); }
  /// Asks for `wanted`.
  void change() { simulation.send(Change{wanted}); }
};

}  // namespace hooke::viewer
