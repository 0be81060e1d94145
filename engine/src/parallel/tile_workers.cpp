#include "parallel/tile_workers.h"

#include <algorithm>
#include <numeric>
#include <thread>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace hooke {
namespace {

/// Blocks, times steps, that one thread should have: less is done before another thread has woken up.
constexpr std::size_t least_work = 256;

/// Turns of waiting before the thread is offered to others.
constexpr unsigned turns_before_yield = 256;

}  // namespace

TileWorkers::TileWorkers(const Tiles& tiles, unsigned threads)
    : tiles_(tiles),
      chosen_(tiles.count()),
      most_stretches_(std::clamp<std::size_t>(tiles.count() / 2, 1, threads)),
      stretches_(std::make_unique<Stretch[]>(most_stretches_)) {
  std::iota(chosen_.begin(), chosen_.end(), std::size_t{0});
}

std::size_t TileWorkers::start(std::size_t steps) {
  const std::size_t tiles = chosen_.size();
  const std::size_t blocks = tiles * tiles_.blocks / std::max<std::size_t>(tiles_.count(), 1);
  const std::size_t most = std::clamp<std::size_t>(tiles / 2, 1, most_stretches_);
  count_ = std::clamp<std::size_t>(blocks * steps / least_work, 1, most);
  stopped_.store(false, std::memory_order_relaxed);
  for (std::size_t i = 0; i < count_; ++i) {
    Stretch& stretch = stretches_[i];
    stretch.first = tiles * i / count_;
    stretch.last = tiles * (i + 1) / count_;
    stretch.from_end = i % 2 == 0 && count_ > 1;
    stretch.walk = TileWalk(stretch.last - stretch.first, steps, tiles_.steps_in_pass);
    stretch.busy.store(false, std::memory_order_relaxed);
    stretch.done.store(false, std::memory_order_relaxed);
    stretch.steps_of_first.store(0, std::memory_order_relaxed);
    stretch.steps_of_last.store(0, std::memory_order_relaxed);
  }
  return count_;
}

bool TileWorkers::ready(std::size_t number) const {
  const Stretch& stretch = stretches_[number];
  const std::size_t tile = stretch.tile(), step = stretch.walk.step();
  if (tile == stretch.first && number > 0 &&
      stretches_[number - 1].steps_of_last.load(std::memory_order_acquire) < step)
    return false;
  return !(tile + 1 == stretch.last && number + 1 < count_ &&
           stretches_[number + 1].steps_of_first.load(std::memory_order_acquire) < step);
}

void TileWorkers::publish(Stretch& stretch, std::size_t tile, std::size_t steps) {
  if (tile == stretch.first) stretch.steps_of_first.store(steps, std::memory_order_release);
  if (tile + 1 == stretch.last) stretch.steps_of_last.store(steps, std::memory_order_release);
}

bool TileWorkers::all_done() const {
  for (std::size_t i = 0; i < count_; ++i) {
    if (!stretches_[i].done.load(std::memory_order_acquire)) return false;
  }
  return true;
}

void TileWorkers::wait(unsigned idle) {
  if (idle >= turns_before_yield) {
    std::this_thread::yield();
    return;
  }
#if defined(__SSE2__)
  _mm_pause();
#elif defined(__aarch64__)
  asm volatile("yield");
#endif
}

}  // namespace hooke
