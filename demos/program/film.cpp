#include "program/film.h"

#include <iterator>

namespace hooke::program {

template <class Real>
void Film::take(const Simulation<Real>& simulation) {
  positions_.resize(3 * simulation.particle_count());
  simulation.copy_positions(positions_.data(), 3 * sizeof(float));
  if (torn_.look_at(simulation)) torn_from_[recording_.size()] = torn_.scene();
  recording_.add(simulation.time(), positions_);
  last_step_ = simulation.steps();
}

std::shared_ptr<const Scene> Film::torn_at(std::size_t moment) const {
  const auto after = torn_from_.upper_bound(moment);
  return after == torn_from_.begin() ? nullptr : std::prev(after)->second;
}

template void Film::take(const Simulation<float>&);
template void Film::take(const Simulation<double>&);

}  // namespace hooke::program
