#include "scaling/machine_limits.h"

#include <hwy/aligned_allocator.h>

#include <algorithm>
#include <atomic>
#include <barrier>
#include <functional>
#include <memory>
#include <new>
#include <thread>

#include "program/stopwatch.h"
#include "scaling/available_memory.h"
#include "scaling/limit_kernels.h"

namespace hooke::bench {
namespace {

constexpr std::size_t mebibyte = 1024 * 1024;

/// Keeps the compiler from leaving out work whose result nobody asks for.
std::atomic<double> unused_result;

/// Does a little work and says how much it was, in bytes or operations.
using Work = std::function<double()>;

/// The most work each second that threads do together: each makes its own work, so that what it reads is near
/// it, then all start at once.
double best_rate(unsigned threads, const Effort& effort, const std::function<Work()>& make_work) {
  std::barrier<> together{std::ptrdiff_t(threads)};
  std::vector<std::vector<double>> rates(threads, std::vector<double>(std::size_t(effort.repeats)));
  const auto run = [&](unsigned thread) {
    const Work work = make_work();
    for (double& rate : rates[thread]) {
      together.arrive_and_wait();
      const program::Stopwatch watch;
      double done = 0.0, seconds = 0.0;
      do {
        done += work();
        seconds = watch.seconds();
      } while (seconds < effort.seconds);
      rate = done / seconds;
    }
  };
  std::vector<std::thread> running;
  for (unsigned thread = 0; thread < threads; ++thread) running.emplace_back(run, thread);
  for (std::thread& thread : running) thread.join();

  double best = 0.0;
  for (int repeat = 0; repeat < effort.repeats; ++repeat) {
    double rate = 0.0;
    for (unsigned thread = 0; thread < threads; ++thread) rate += rates[thread][std::size_t(repeat)];
    best = std::max(best, rate);
  }
  return best;
}

/// The bandwidth [bytes/s] of threads that each read a part of `bytes` again and again.
double read_bandwidth(unsigned threads, std::size_t bytes, const Effort& effort) {
  constexpr std::size_t granule = 1024;  // floats, as sum() wants them
  const std::size_t floats = std::max(granule, bytes / sizeof(float) / threads / granule * granule);
  const std::size_t piece = std::min(floats, mebibyte / sizeof(float));
  return best_rate(threads, effort, [=] {
    std::shared_ptr<float[]> values(hwy::AllocateAligned<float>(floats));
    if (values == nullptr) throw std::bad_alloc();
    std::fill_n(values.get(), floats, 1.0f);
    return [=, next = std::size_t{0}]() mutable {
      const std::size_t count = std::min(piece, floats - next);
      unused_result.store(sum(values.get() + next, count), std::memory_order_relaxed);
      next = next + count < floats ? next + count : 0;
      return double(count * sizeof(float));
    };
  });
}

double arithmetic_rate(unsigned threads, const Effort& effort, MultiplyAdds (*multiply_add)(std::size_t)) {
  return best_rate(threads, effort, [=] {
    return [=] {
      const MultiplyAdds done = multiply_add(10'000);
      unused_result.store(done.result, std::memory_order_relaxed);
      return done.flops;
    };
  });
}

/// [bytes] that threads read together so that the L3 serves them: well above all their L2, within half of the
/// L3. Where the L2 are so large that this cannot be, they and half of the L3, which then holds what they do
/// not.
std::size_t l3_working_set(const Caches& caches, unsigned threads) {
  const std::size_t l2 = caches.l2.capacity(threads), half_l3 = caches.l3.capacity(threads) / 2;
  return half_l3 >= 2 * l2 ? std::min(half_l3, 8 * l2) : l2 + half_l3;
}

/// [bytes] that no cache holds: four times the largest, but no more than a quarter of the memory there is.
std::size_t memory_working_set(const Caches& caches) {
  const std::size_t cached =
      std::max(caches.l2.bytes * caches.l2.instances, caches.l3.bytes * caches.l3.instances);
  return std::min(std::max(4 * cached, 256 * mebibyte), available_memory() / 4);
}

ThreadLimits measure_threads(const MachineLimits& machine, unsigned threads, const Effort& effort) {
  const Caches& caches = machine.caches;
  ThreadLimits limits;
  limits.l2_bandwidth = read_bandwidth(threads, caches.l2.capacity(threads) / 2, effort);
  if (caches.l3.bytes > 0)
    limits.l3_bandwidth = read_bandwidth(threads, l3_working_set(caches, threads), effort);
  limits.memory_bandwidth = read_bandwidth(threads, machine.memory_read, effort);
  limits.float_rate = arithmetic_rate(threads, effort, multiply_add_floats);
  limits.double_rate = arithmetic_rate(threads, effort, multiply_add_doubles);
  return limits;
}

}  // namespace

MachineLimits measure_machine(const std::vector<unsigned>& thread_counts, const Effort& effort) {
  MachineLimits machine;
  machine.caches = find_caches();
  machine.memory_read = memory_working_set(machine.caches);
  for (unsigned threads : thread_counts)
    machine.of_threads[threads] = measure_threads(machine, threads, effort);
  return machine;
}

}  // namespace hooke::bench
