#include "scaling/step_cost.h"

namespace hooke::bench {

StepLimit step_limit(const StepCost& cost, const Caches& caches, unsigned threads, const ThreadLimits& limits,
                     double operation_rate) {
  double bandwidth = limits.memory_bandwidth;
  std::string_view level = "memory";
  if (cost.working_set <= caches.l2.capacity(threads)) {
    bandwidth = limits.l2_bandwidth;
    level = "L2";
  } else if (cost.working_set <= caches.l3.capacity(threads)) {
    bandwidth = limits.l3_bandwidth;
    level = "L3";
  }
  const double transfer = cost.bytes / bandwidth, arithmetic = cost.operations / operation_rate;
  return transfer >= arithmetic ? StepLimit{transfer, level} : StepLimit{arithmetic, "arithmetic"};
}

}  // namespace hooke::bench
