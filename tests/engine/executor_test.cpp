#include <doctest/doctest.h>

#include <atomic>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include <hooke/hooke.h>

#include "scenes.h"

using namespace hooke;

namespace {

/// A host's own threads: fresh ones for each loop, cut unevenly.
class HostExecutor final : public Executor {
 public:
  unsigned threads() const override { return 3; }

  void parallel_for(std::size_t count, std::size_t, RangeFunction body) override {
    ++loops;
    const std::size_t a = count / 5, b = count / 2;
    std::thread first([&] { body(0, a); }), second([&] { body(a, b); });
    body(b, count);
    first.join();
    second.join();
  }

  std::atomic<int> loops = 0;
};

}  // namespace

TEST_CASE("a loop covers its range once, on as many threads as asked for") {
  for (unsigned threads : {1u, 2u, 3u, 7u}) {
    const auto executor = make_tbb_executor(threads);
    CHECK(executor->threads() == threads);
    for (std::size_t count : {0, 1, 5, 1000, 100'000}) {
      std::vector<std::atomic<int>> visits(count);
      executor->parallel_for(count, 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) ++visits[i];
      });
      bool once = true;
      for (const auto& v : visits) once = once && v == 1;
      CHECK(once);
    }
  }
}

TEST_CASE("more threads than cores really run") {
  const auto executor = make_tbb_executor(7);
  std::atomic<int> arrived = 0;
  // Each of 7 bodies waits for the others: with fewer threads this would never end, so it gives up after a
  // while.
  executor->parallel_for(7, 1, [&](std::size_t begin, std::size_t end) {
    arrived += int(end - begin);
    for (int i = 0; i < 5000 && arrived < 7; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  });
  CHECK(arrived.load() == 7);
}

TEST_CASE("an exception from a loop reaches the caller") {
  const auto executor = make_tbb_executor(2);
  const auto loop = [&] {
    executor->parallel_for(1000, 1, [](std::size_t begin, std::size_t) {
      if (begin == 500) throw std::runtime_error("from the body");
    });
  };
  CHECK_THROWS_WITH(loop(), "from the body");
}

TEST_CASE("a host's threads are used, and give the same bits as the engine's own") {
  const Scene scene = test::hung_cloth(40, 40);
  const auto host = std::make_shared<HostExecutor>();
  Simulation<float> hosted(scene, {.step = 1e-3, .executor = host}), own(scene, {.step = 1e-3});
  CHECK(hosted.threads() == 3);
  for (int i = 0; i < 50; ++i) REQUIRE(hosted.step().ok());
  REQUIRE(own.step(50).ok());
  CHECK(host->loops.load() >= 50);
  CHECK(hosted.state_hash() == own.state_hash());
}
