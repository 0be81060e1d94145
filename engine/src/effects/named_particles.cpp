#include "effects/named_particles.h"

#include <string>

namespace hooke {

void check_named_once(const std::vector<Index>& particles, std::size_t count, const ElementChecks& checks) {
  std::vector<bool> named(particles.empty() ? 0 : count, false);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const std::string at = "particles[" + std::to_string(i) + "]";
    checks.in_range(at, particles[i], count, "particles");
    if (particles[i] >= count) continue;
    if (named[particles[i]])
      checks.add(at + " is " + std::to_string(particles[i]) + ", which is named before", "name it once");
    named[particles[i]] = true;
  }
}

}  // namespace hooke
