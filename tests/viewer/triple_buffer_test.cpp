#include "viewer/live/triple_buffer.h"

#include <doctest/doctest.h>

#include <array>
#include <thread>

namespace hooke::viewer {

TEST_CASE("a triple buffer gives the newest value, once") {
  TripleBuffer<int> buffer;
  CHECK_FALSE(buffer.fetch());
  buffer.back() = 1;
  buffer.publish();
  buffer.back() = 2;
  buffer.publish();
  REQUIRE(buffer.fetch());
  CHECK(buffer.front() == 2);
  CHECK_FALSE(buffer.fetch());
  CHECK(buffer.front() == 2);
}

TEST_CASE("between threads, values come whole and in their order, and the last one comes") {
  TripleBuffer<std::array<int, 64>> buffer;
  constexpr int last = 20000;
  std::thread writer([&] {
    for (int i = 1; i <= last; ++i) {
      buffer.back().fill(i);
      buffer.publish();
    }
  });
  int newest = 0, torn = 0, backwards = 0;
  while (newest < last) {
    if (!buffer.fetch()) continue;
    const std::array<int, 64>& value = buffer.front();
    for (const int one : value) torn += one != value[0] ? 1 : 0;
    backwards += value[0] <= newest ? 1 : 0;
    newest = value[0];
  }
  writer.join();
  CHECK(torn == 0);
  CHECK(backwards == 0);
}

}  // namespace hooke::viewer
