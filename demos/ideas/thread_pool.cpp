// thread_pool: a host's own threads, through hooke::Executor. A skirt is whirled by them and by oneTBB's, to
// the same bits.
#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdio>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include <hooke/hooke.h>
#include "ideas/account/account.h"
#include "ideas/account/show.h"
#include "ideas/props/skirt.h"

namespace {

/// A thread pool as a game may have one: workers sleep until there is a loop, and take pieces of it by turns.
class Pool final : public hooke::Executor {
 public:
  explicit Pool(unsigned threads) {
    for (unsigned i = 1; i < threads; ++i) workers_.emplace_back([this] { work(); });
  }
  ~Pool() override {
    {
      const std::lock_guard lock(mutex_);
      ends_ = true;
    }
    wake_.notify_all();
    for (std::thread& worker : workers_) worker.join();
  }

  unsigned threads() const override { return unsigned(workers_.size()) + 1; }

  void parallel_for(std::size_t count, std::size_t grain, hooke::RangeFunction body) override {
    if (count <= grain || workers_.empty()) return body(0, count);
    {
      const std::lock_guard lock(mutex_);
      loop_.emplace(Loop{count, std::max<std::size_t>(grain, 1), body, {}});
      next_ = 0, busy_ = workers_.size(), ++loops_;
    }
    wake_.notify_all();
    take_pieces();
    std::unique_lock lock(mutex_);
    done_.wait(lock, [&] { return busy_ == 0; });
    if (loop_->fault) std::rethrow_exception(loop_->fault);
  }

 private:
  struct Loop {
    std::size_t count, grain;
    hooke::RangeFunction body;
    std::exception_ptr fault;
  };

  void take_pieces() {
    for (std::size_t begin; (begin = next_.fetch_add(loop_->grain)) < loop_->count;) {
      try {
        loop_->body(begin, std::min(begin + loop_->grain, loop_->count));
      } catch (...) {
        const std::lock_guard lock(mutex_);
        loop_->fault = std::current_exception();
      }
    }
  }

  void work() {
    for (std::uint64_t seen = 0;;) {
      {
        std::unique_lock lock(mutex_);
        wake_.wait(lock, [&] { return ends_ || loops_ != seen; });
        if (ends_) return;
        seen = loops_;
      }
      take_pieces();
      const std::lock_guard lock(mutex_);
      if (--busy_ == 0) done_.notify_one();
    }
  }

  std::vector<std::thread> workers_;
  std::mutex mutex_;
  std::condition_variable wake_, done_;
  std::optional<Loop> loop_;
  std::atomic<std::size_t> next_ = 0;
  std::size_t busy_ = 0;
  std::uint64_t loops_ = 0;
  bool ends_ = false;
};

}  // namespace

void thread_pool(hooke::ideas::Account& account) {
  const hooke::Scene scene = hooke::ideas::make_skirt();
  const unsigned threads = std::max(2u, std::thread::hardware_concurrency());
  hooke::Simulation ours(scene, {.step = 2e-4, .executor = std::make_shared<Pool>(threads)});
  hooke::Simulation tbb(scene, {.step = 2e-4, .executor = hooke::make_tbb_executor(threads)});
  const auto steps = std::max<std::uint64_t>(1, std::uint64_t(account.seconds(2.5) / 2e-4));
  const hooke::program::Stopwatch watch;
  if (const hooke::Report report = tbb.step(steps); !report.ok()) throw std::runtime_error(report.message());
  std::printf("  %.3f ms a step by oneTBB", 1e3 * watch.seconds() / double(steps));
  account.measure([&] { return ours.step(steps); });
  std::printf(", %.3f ms by a pool of its own, with %u threads each\n", account.milliseconds_a_step(),
              threads);
  account.claim(ours.state_hash() == tbb.state_hash(), "the same bits: %016llx",
                static_cast<unsigned long long>(ours.state_hash()));
  account.print_cost(ours);
  hooke::ideas::show(account.picture(), {hooke::ideas::moment(scene, ours)},
                     {.azimuth = 0.4, .elevation = 0.25});
}

int main(int argc, char** argv) {
  return hooke::ideas::give_account(argc, argv, "thread_pool: a skirt whirled by a host's own threads",
                                    thread_pool);
}
