#pragma once

#include <array>
#include <atomic>

namespace hooke::viewer {

/// Hands the newest of many values from one thread to another; neither ever waits. The writer fills back()
/// and publishes it; the reader fetches what was published last and reads front(). What was published in
/// between is passed over.
template <class T>
class TripleBuffer {
 public:
  /// For the writer: holds what was published two or three times ago, so that its memory is used again.
  T& back() { return values_[back_]; }

  void publish() { back_ = between_.exchange(back_ | fresh, std::memory_order_acq_rel) & place; }

  /// Makes front() the newest value; false where nothing was published since the last time.
  bool fetch() {
    if ((between_.load(std::memory_order_relaxed) & fresh) == 0) return false;
    front_ = between_.exchange(front_, std::memory_order_acq_rel) & place;
    return true;
  }

  const T& front() const { return values_[front_]; }

 private:
  static constexpr unsigned place = 3, fresh = 4;

  std::array<T, 3> values_{};
  unsigned back_ = 0;                 // the writer's
  unsigned front_ = 1;                // the reader's
  std::atomic<unsigned> between_{2};  // the third place, and whether the reader has not seen it
};

}  // namespace hooke::viewer
