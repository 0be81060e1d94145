#pragma once

#include <cstddef>

#include "scenes/hard/judge.h"
#include "scenes/hard/watched_run.h"

namespace hooke::hard {

/// Whether surfaces stay whole where they touch: no edge through a triangle, no spring strained too much.
class ContactWatch {
 public:
  ContactWatch(const Scene& scene, double strain_limit) : scene_(scene), strain_limit_(strain_limit) {}

  /// Looks at the newest state. False where it is not so: then there is no more to be seen.
  bool look(const WatchedRun<double>& run);

  void judge(Judge& judge) const;

  double strain() const { return strain_; }  ///< the largest so far [1]

 private:
  const Scene& scene_;
  double strain_limit_;
  std::size_t crossings_ = 0;
  double strain_ = 0.0;
};

}  // namespace hooke::hard
