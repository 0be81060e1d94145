#include "methods/next_strip.h"

#include <cmath>

namespace hooke {

template <class Real>
void note_first_bad(const NextStrip<Real>& next, const Strip<Real>& strip, const Order& order,
                    std::atomic<Index>& first_bad) {
  for (std::size_t lane = 0; lane < strip.particles; ++lane) {
    const Real values[] = {next.x[lane],  next.y[lane],  next.z[lane],
                           next.vx[lane], next.vy[lane], next.vz[lane]};
    bool finite = true;
    for (Real value : values) finite = finite && std::isfinite(value);
    if (finite) continue;
    const Index particle = order.user(strip.first + lane);
    Index lowest = first_bad.load();
    while (particle < lowest && !first_bad.compare_exchange_weak(lowest, particle)) {
    }
  }
}

template void note_first_bad(const NextStrip<float>&, const Strip<float>&, const Order&, std::atomic<Index>&);
template void note_first_bad(const NextStrip<double>&, const Strip<double>&, const Order&,
                             std::atomic<Index>&);

}  // namespace hooke
