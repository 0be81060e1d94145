#include "scenes/hard/contact_watch.h"

#include <algorithm>

#include "scenes/hard/crossings.h"

namespace hooke::hard {

bool ContactWatch::look(const WatchedRun<double>& run) {
  crossings_ = std::max(crossings_, count_crossings(run.positions(), scene_.triangles));
  strain_ = std::max(strain_, run.simulation().max_strain());
  return crossings_ == 0 && strain_ <= strain_limit_;
}

void ContactWatch::judge(Judge& judge) const {
  judge.at_most("largest strain of a spring", strain_, strain_limit_);
  judge.at_most("edges through triangles", double(crossings_), 0.0);
}

}  // namespace hooke::hard
