#include "program/interruption.h"

#include <csignal>
#include <initializer_list>

#include <doctest/doctest.h>

namespace hooke::program {
namespace {

TEST_CASE("the first signal is only noted, and the second would kill") {
  for (const int number : {SIGINT, SIGTERM}) {
    const Interruption interruption;
    CHECK(interruption.signal() == 0);
    std::raise(number);
    CHECK(interruption.signal() == number);
    struct sigaction next = {};
    sigaction(number, nullptr, &next);
    const bool kills = next.sa_handler == SIG_DFL;
    CHECK(kills);
  }
}

TEST_CASE("after an interruption's life the signal does again what it did before") {
  static volatile std::sig_atomic_t seen = 0;
  const auto before = std::signal(SIGINT, [](int) { seen = 1; });
  {
    const Interruption interruption;
    std::raise(SIGINT);
    CHECK(interruption.signal() == SIGINT);
    CHECK(seen == 0);
  }
  std::raise(SIGINT);
  CHECK(seen == 1);
  CHECK(Interruption().signal() == 0);
  std::signal(SIGINT, before);
}

}  // namespace
}  // namespace hooke::program
