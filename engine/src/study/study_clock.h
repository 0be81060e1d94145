#pragma once

#include <chrono>

#include <hooke/study.h>

namespace hooke::study {

/// Wall time of a study: what is left of its budget, and whether its caller still wants it.
class StudyClock {
 public:
  explicit StudyClock(const StudySettings& settings) : settings_(settings) {}

  double elapsed() const { return std::chrono::duration<double>(Time::now() - start_).count(); }
  double left() const { return settings_.budget - elapsed(); }

  /// Tells the caller how far the study is, now and then; false once the caller has said to stop.
  bool go_on();

 private:
  using Time = std::chrono::steady_clock;

  const StudySettings& settings_;
  Time::time_point start_ = Time::now();
  double last_told_ = -1.0;  // [s]
  bool wanted_ = true;
};

}  // namespace hooke::study
