#pragma once

#include <algorithm>
#include <vector>

#include <hooke/executor.h>

namespace hooke {

/// Blocks of particles in a run: long enough to hide the cost of handing runs out.
inline constexpr std::size_t block_run = 256;

/// Combines part(begin, end) over runs of a fixed length, in order: the same bits on any number of threads.
/// A Result has add(Result). `results` is room for those of the runs: what sums again and again keeps it, so
/// that it allocates only once.
template <class Result, class Part>
Result sum_in_order(Executor& executor, std::size_t count, std::size_t run_length, const Part& part,
                    std::vector<Result>& results) {
  const std::size_t runs = (count + run_length - 1) / run_length;
  results.resize(runs);
  executor.parallel_for(runs, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t run = begin; run < end; ++run) {
      results[run] = part(run * run_length, std::min(count, (run + 1) * run_length));
    }
  });
  Result sum{};
  for (const Result& result : results) sum.add(result);
  return sum;
}

template <class Result, class Part>
Result sum_in_order(Executor& executor, std::size_t count, std::size_t run_length, const Part& part) {
  std::vector<Result> results;
  return sum_in_order<Result>(executor, count, run_length, part, results);
}

}  // namespace hooke
