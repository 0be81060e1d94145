#pragma once

#include <cstddef>
#include <memory>

#include <hooke/executor.h>

namespace hooke::test {

/// Cuts every loop into single elements, whatever grain the engine asks for: so that small scenes, too, run
/// on several threads at once.
class FineExecutor final : public Executor {
 public:
  explicit FineExecutor(unsigned threads) : threads_(make_tbb_executor(threads)) {}

  unsigned threads() const override { return threads_->threads(); }
  void parallel_for(std::size_t count, std::size_t, RangeFunction body) override {
    threads_->parallel_for(count, 1, body);
  }

 private:
  std::shared_ptr<Executor> threads_;
};

}  // namespace hooke::test
