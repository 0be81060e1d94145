#pragma once

#include <algorithm>
#include <vector>

#include <hooke/executor.h>

namespace hooke {

/// Blocks of particles in a run: long enough to hide the cost of handing runs out.
inline constexpr std::size_t block_run = 256;

/// Combines part(begin, end) over runs of a fixed length, in order: the same bits on any number of threads.
/// A Result has add(Result).
template <class Result, class Part>
Result sum_in_order(Executor& executor, std::size_t count, std::size_t run_length, const Part& part) {
  const std::size_t runs = (count + run_length - 1) / run_length;
  std::vector<Result> results(runs);
  executor.parallel_for(runs, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t run = begin; run < end; ++run) {
      results[run] = part(run * run_length, std::min(count, (run + 1) * run_length));
    }
  });
  Result sum{};
  for (const Result& result : results) sum.add(result);
  return sum;
}

}  // namespace hooke
