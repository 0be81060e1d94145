#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>

/// Whose threads the engine uses. By default its own, from oneTBB; a host that has a thread pool gives an
/// Executor.

namespace hooke {

/// A reference to something callable with a range [begin, end); it does not own it, so it never allocates.
class RangeFunction {
 public:
  template <class F, std::enable_if_t<!std::is_same_v<std::remove_cvref_t<F>, RangeFunction>, int> = 0>
  RangeFunction(
      F&& function)  // NOLINT: implicit, so that a lambda can be passed where a RangeFunction is asked for
      : object_(const_cast<void*>(static_cast<const void*>(std::addressof(function)))),
        call_([](void* object, std::size_t begin, std::size_t end) {
          (*static_cast<std::remove_reference_t<F>*>(object))(begin, end);
        }) {}

  void operator()(std::size_t begin, std::size_t end) const { call_(object_, begin, end); }

 private:
  void* object_;
  void (*call_)(void*, std::size_t, std::size_t);
};

/// Runs a loop on threads. The engine's results do not depend on how the range is cut or who runs it.
class Executor {
 public:
  virtual ~Executor() = default;

  /// The most threads that parallel_for uses at once, >= 1.
  virtual unsigned threads() const = 0;

  /// Calls `body` on ranges that together cover [0, count) once, each of at most about `grain` elements where
  /// that helps, and returns when all are done. An exception from `body` must reach the caller. A call of
  /// `body` may wait for others that have begun, never for one that has not: any number of threads will do.
  virtual void parallel_for(std::size_t count, std::size_t grain, RangeFunction body) = 0;
};

/// oneTBB's threads, at most `threads` of them (0: as many as the machine has).
std::shared_ptr<Executor> make_tbb_executor(unsigned threads = 0);

}  // namespace hooke
