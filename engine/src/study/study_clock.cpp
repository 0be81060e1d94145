#include "study/study_clock.h"

#include <algorithm>

namespace hooke::study {

bool StudyClock::go_on() {
  constexpr double tell_every = 0.1;  // [s]
  const double now = elapsed();
  if (!wanted_ || !settings_.progress || now - last_told_ < tell_every) return wanted_;
  last_told_ = now;
  const double share = std::min(1.0, now / settings_.budget);
  wanted_ = settings_.progress({share, std::max(0.0, settings_.budget - now)});
  return wanted_;
}

}  // namespace hooke::study
