#include "hostile/watchdog.h"

#include <cstdio>
#include <cstdlib>
#include <utility>

namespace hooke::test {

Watchdog::Watchdog(std::chrono::seconds limit) : limit_(limit), thread_([this] { watch(); }) {}

Watchdog::~Watchdog() {
  {
    const std::lock_guard lock(mutex_);
    done_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void Watchdog::begin(std::string work) {
  const std::lock_guard lock(mutex_);
  work_ = std::move(work);
  began_ = std::chrono::steady_clock::now();
}

void Watchdog::watch() {
  std::unique_lock lock(mutex_);
  while (!changed_.wait_until(lock, began_ + limit_, [this] { return done_; })) {
    if (std::chrono::steady_clock::now() - began_ < limit_) continue;
    std::fprintf(stderr, "no end after %lld s: %s\n", static_cast<long long>(limit_.count()), work_.c_str());
    std::_Exit(EXIT_FAILURE);
  }
}

}  // namespace hooke::test
