#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <optional>

#include <hooke/executor.h>

#include "parallel/fork_join.h"

namespace hooke {
namespace {

namespace tbb = oneapi::tbb;

class TbbExecutor final : public Executor {
 public:
  explicit TbbExecutor(unsigned threads)
      : threads_(threads > 0 ? threads : machine_threads()), arena_(int(threads_)) {
    // oneTBB makes no more workers than the machine has cores unless it is told; who asks for more gets more.
    if (threads_ > machine_threads())
      more_workers_.emplace(tbb::global_control::max_allowed_parallelism, threads_);
  }

  unsigned threads() const override { return threads_; }

  void parallel_for(std::size_t count, std::size_t grain, RangeFunction body) override {
    if (count == 0) return;
    if (threads_ == 1 || count <= grain) {
      body(0, count);
      return;
    }
    ForkJoin loop;
    arena_.execute([&] {
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain), [&](const auto& range) {
        const ForkJoin::Body inside(loop);
        body(range.begin(), range.end());
      });
    });
  }

 private:
  static unsigned machine_threads() { return unsigned(std::max(1, tbb::info::default_concurrency())); }

  unsigned threads_;
  std::optional<tbb::global_control> more_workers_;
  tbb::task_arena arena_;
};

}  // namespace

std::shared_ptr<Executor> make_tbb_executor(unsigned threads) {
  return std::make_shared<TbbExecutor>(threads);
}

}  // namespace hooke
