#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include <hooke/executor.h>

#include "aligned.h"
#include "model/tiles.h"
#include "parallel/tile_walk.h"

namespace hooke {

/// Steps tiles many times on several threads without a barrier.
///
/// The row of tiles is cut into one stretch for each thread. A worker walks through its own stretch; only at
/// the two ends must it see that the neighbour's last tile has done the step before, by a counter. Every
/// other stretch is walked from its end, so that neighbours come to their common end at the same time. A
/// worker whose stretch has to wait helps where it can: the run comes to its end on any number of threads,
/// also on one that calls all workers in turn. Which worker runs a tile changes no bit.
class TileWorkers {
 public:
  TileWorkers(const Tiles& tiles, unsigned threads);

  /// From now on only these are stepped, in ascending order: what reads of the others, reads what stays.
  void choose(std::vector<std::size_t> tiles) { chosen_ = std::move(tiles); }

  /// Calls work(step, first block, last block) for each tile and each of `steps` steps. Where it throws, the
  /// others stop, and the exception reaches the caller.
  template <class Work>
  void run(Executor& executor, std::size_t steps, const Work& work) {
    const std::size_t count = start(steps);
    executor.parallel_for(count, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t home = begin; home < end; ++home) work_from(home, work);
    });
  }

 private:
  /// A part of the row of tiles. `busy` is held by the worker that walks on in it.
  struct alignas(2 * cache_line) Stretch {
    std::size_t first = 0, last = 0;  ///< of those chosen: [first, last)
    bool from_end = false;
    TileWalk walk{0, 0, 1};
    std::atomic<bool> busy{false};
    std::atomic<bool> done{true};
    std::atomic<std::size_t> steps_of_first{0}, steps_of_last{0};  ///< that its end tiles have done

    std::size_t tile() const { return from_end ? last - 1 - walk.tile() : first + walk.tile(); }
  };

  /// Cuts the row for a run and returns the number of stretches.
  std::size_t start(std::size_t steps);

  template <class Work>
  void work_from(std::size_t home, const Work& work) {
    unsigned idle = 0;
    while (!stopped_.load(std::memory_order_relaxed) && !all_done()) {
      bool ran = walk_on(home, ~std::size_t{0}, work);
      for (std::size_t other = 1; other < count_ && !ran; ++other)
        ran = walk_on((home + other) % count_, 1, work);
      idle = ran ? 0 : idle + 1;
      if (!ran) wait(idle);
    }
  }

  /// Walks on in a stretch for at most `most` tiles, as long as they are ready; returns whether any was.
  template <class Work>
  bool walk_on(std::size_t number, std::size_t most, const Work& work) {
    Stretch& stretch = stretches_[number];
    if (stretch.done.load(std::memory_order_acquire) ||
        stretch.busy.exchange(true, std::memory_order_acquire))
      return false;
    std::size_t ran = 0;
    try {
      for (; ran < most && !stretch.walk.done() && ready(number); ++ran) {
        const std::size_t tile = stretch.tile(), step = stretch.walk.step();
        work(step, tiles_.begin(chosen_[tile]), tiles_.end(chosen_[tile]));
        stretch.walk.next();
        publish(stretch, tile, step + 1);
      }
    } catch (...) {
      stopped_.store(true, std::memory_order_relaxed);
      throw;
    }
    if (stretch.walk.done()) stretch.done.store(true, std::memory_order_release);
    stretch.busy.store(false, std::memory_order_release);
    return ran > 0;
  }

  bool ready(std::size_t number) const;
  static void publish(Stretch& stretch, std::size_t tile, std::size_t steps);
  bool all_done() const;
  static void wait(unsigned idle);

  Tiles tiles_;
  std::vector<std::size_t> chosen_;  ///< those that are stepped: walks go by places in this list
  std::size_t most_stretches_;
  std::unique_ptr<Stretch[]> stretches_;
  std::size_t count_ = 0;  ///< stretches of this run
  std::atomic<bool> stopped_{false};
};

}  // namespace hooke
