#include "program/film.h"

namespace hooke::program {

template <class Real>
void Film::take(const Simulation<Real>& simulation) {
  positions_.resize(3 * simulation.particle_count());
  simulation.copy_positions(positions_.data(), 3 * sizeof(float));
  recording_.add(simulation.time(), positions_);
  last_step_ = simulation.steps();
}

template void Film::take(const Simulation<float>&);
template void Film::take(const Simulation<double>&);

}  // namespace hooke::program
