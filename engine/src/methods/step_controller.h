#pragma once

namespace hooke {

/// Chooses the length of steps so that their errors stay near what is allowed: a proportional-integral
/// controller (Gustafsson 1991; Hairer, Norsett and Wanner 1993, section IV.2).
/// An error here is that of a step divided by what is allowed in it.
class StepController {
 public:
  /// The error of a step falls as its length to this power, > 0.
  explicit StepController(double order) : order_(order) {}

  /// Whether a step with this error is taken.
  static bool accepts(double error) { return error <= 1.0; }

  /// The factor by which the next step is longer than one with this error, which need not be finite.
  double after(double error);

  double last_error() const { return last_error_; }
  void set_last_error(double error) { last_error_ = error; }

 private:
  double order_;
  double last_error_ = 1.0;  ///< of the last step that was taken
  bool rejected_ = false;    ///< the step before was
};

}  // namespace hooke
