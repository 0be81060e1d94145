#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>

#include <hooke/methods.h>
#include <hooke/scene.h>

/// Scenes that break simulators, each with a criterion that a method meets or does not. `hooke hard` runs
/// them with every method; docs/hard-cases.md shows what came of it.

namespace hooke::hard {

enum class Outcome {
  pass,
  fail,
  refused,  ///< the method, or the library, says before it starts that it cannot do this
};

std::string_view to_string(Outcome outcome);

/// What a method made of a case.
struct Result {
  Outcome outcome = Outcome::fail;
  double figure = std::numeric_limits<double>::quiet_NaN();  ///< that decided; none where refused
  double limit = std::numeric_limits<double>::quiet_NaN();   ///< of the figure
  std::string figure_of;  ///< what the figure is, with its unit, and on which side of the limit it must lie
  std::string reason;     ///< why it failed or was refused; what must be known of one that passed
};

/// How much of a case is run.
enum class Extent {
  whole,
  quick,  ///< smaller scenes, shorter runs and fewer seeds
};

struct HardCase {
  int number = 0;                   ///< stays the same for good
  std::string_view name;            ///< by which it is asked for
  std::string_view scene;           ///< what it is, with its parameters
  std::string_view criterion;       ///< what passes, beside the common criteria
  std::string_view not_asked;       ///< what the case could ask of a richer engine; empty: nothing
  double step = 0.0;                ///< [s] that methods are asked to take
  Scene (*make)(Extent) = nullptr;  ///< the scene, where there are several the first of them
  Result (*run)(const Method&, Extent) = nullptr;
  /// The motion is chaotic: a last bit, as another instruction set gives, may lead to another verdict.
  bool chaotic = false;
};

/// All, by number.
std::span<const HardCase> hard_cases();

/// What is judged in every case, in words.
std::string_view common_criteria();

}  // namespace hooke::hard
