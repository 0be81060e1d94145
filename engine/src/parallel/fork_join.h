#pragma once

#ifdef HOOKE_SANITIZES_THREADS
#include <sanitizer/tsan_interface.h>
#endif

namespace hooke {

/// What a parallel loop guarantees, said to the thread sanitizer: the body sees all that was written before
/// the loop, and after the loop all that the body wrote is seen. oneTBB keeps this promise, but the system's
/// oneTBB is not built with the sanitizer, which cannot see how. Two bodies of one loop stay unordered, so a
/// race between them is still found. In other builds this is nothing.
class ForkJoin {
 public:
#ifdef HOOKE_SANITIZES_THREADS
  ForkJoin() {
    __tsan_release(&fork_);
  }
  ~ForkJoin() {
    __tsan_acquire(&join_);
  }
#endif

  /// Lives as long as a call of the body, however that ends.
  class Body {
   public:
#ifdef HOOKE_SANITIZES_THREADS
    explicit Body(ForkJoin& loop) : loop_(loop) {
      __tsan_acquire(&loop_.fork_);
    }
    ~Body() {
      __tsan_release(&loop_.join_);
    }

   private:
    ForkJoin& loop_;
#else
    explicit Body(ForkJoin&) {}
#endif
  };

 private:
  [[maybe_unused]] char fork_ = 0, join_ = 0;  // only their addresses are used
};

}  // namespace hooke
