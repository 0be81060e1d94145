#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <hooke/scene.h>
#include <hooke/simulation.h>

#include "picture/image.h"
#include "viewer/control_map.h"
#include "viewer/live/simulation_thread.h"

namespace hooke::viewer {

/// What is viewed, and how.
struct ViewSettings {
  Scene scene;
  Settings settings;
  Precision precision = Precision::single;
  double seconds = 2.0;            ///< [s] of simulated time that a study of accuracy is to cover
  double study_budget = 10.0;      ///< [s] of wall time for it
  int width = 1440, height = 900;  ///< of the window [units of the mouse]
  bool debug = false;              ///< OpenGL reports what it does not like
};

/// A window with a scene that runs, and panels to change it.
class Viewer {
 public:
  /// Throws WindowError where there is no display, SceneError where the scene cannot be simulated.
  explicit Viewer(ViewSettings settings);
  ~Viewer();

  /// Draws a frame and does what the user asked for since the last one; false once the window is to close.
  bool frame();
  /// Likewise, and returns the whole window as it is shown.
  picture::Image picture();

  void set_running(bool running);
  void start_study();

  const Moment& moment() const;
  const ControlMap& controls() const;
  /// Where a particle is seen in the window [units of the mouse]; nothing where it is behind the eye.
  std::optional<std::array<double, 2>> place_of(Index particle) const;
  bool studies() const;  ///< a study that is not done
  /// OpenGL's errors so far.
  const std::vector<std::string>& complaints() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hooke::viewer
