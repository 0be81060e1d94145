#include "picture/subject_check.h"

#include <string>
#include <string_view>

#include "picture/picture_error.h"

namespace hooke::picture {
namespace {

/// For a list whose items each name some particles.
template <class Items>
void require_particles(const Subject& subject, const Items& items, std::string_view item,
                       std::string_view part) {
  for (std::size_t k = 0; k < items.size(); ++k) {
    for (const Index particle : items[k]) {
      if (particle < subject.particles) continue;
      throw PictureError(std::string(item) + " " + std::to_string(k) + std::string(part) +
                         std::to_string(particle) + ", but there are " + std::to_string(subject.particles) +
                         " particles: give numbers below that");
    }
  }
}

}  // namespace

void require_consistent(const Subject& subject) {
  require_particles(subject, subject.triangles, "triangle", " has a corner ");
  require_particles(subject, subject.springs, "spring", " has an end ");
  for (std::size_t k = 0; k < subject.pins.size(); ++k) {
    if (subject.pins[k] < subject.particles) continue;
    throw PictureError("pin " + std::to_string(k) + " is of particle " + std::to_string(subject.pins[k]) +
                       ", but there are " + std::to_string(subject.particles) +
                       " particles: give numbers below that");
  }
  if (subject.rest_lengths.size() != subject.springs.size()) {
    throw PictureError(std::to_string(subject.rest_lengths.size()) + " rest lengths for " +
                       std::to_string(subject.springs.size()) + " springs: give one for each");
  }
}

}  // namespace hooke::picture
