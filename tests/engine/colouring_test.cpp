#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "model/colouring.h"
#include "scenes.h"

using namespace hooke;

namespace {

/// No two springs of a batch share a particle, but for the last batch if it is for one thread.
bool batches_are_independent(const SpringList<float>& list, std::size_t particles) {
  const std::size_t parallel = list.batches() - (list.last_batch_serial ? 1 : 0);
  for (std::size_t batch = 0; batch < parallel; ++batch) {
    std::vector<bool> used(particles, false);
    for (std::size_t s = list.batch_begin[batch]; s < list.batch_begin[batch + 1]; ++s) {
      for (Index end : {list.first[s], list.second[s]}) {
        if (used[end]) return false;
        used[end] = true;
      }
    }
  }
  return true;
}

}  // namespace

TEST_CASE("springs of one colour share no particle, and every spring has a colour") {
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    const Scene scene = test::RandomNetwork(seed).make();
    const SpringList<float> list = colour_springs<float>(scene.springs, Order(scene.particles.size(), ""));
    CHECK(list.size() == scene.springs.size());
    CHECK(list.batch_begin.back() == scene.springs.size());
    CHECK(batches_are_independent(list, scene.particles.size()));
    double listed = 0.0, given = 0.0;
    for (float k : list.stiffness) listed += k;
    for (double k : scene.springs.stiffness) given += float(k);
    CHECK(listed == doctest::Approx(given));
  }
}

TEST_CASE("a grid needs few colours") {
  const Scene scene = test::hung_cloth(100, 100);
  const SpringList<float> list = colour_springs<float>(scene.springs, Order(scene.particles.size(), ""));
  CHECK(list.batches() >= 12);  // the largest number of springs at a particle
  CHECK(list.batches() <= 20);
  CHECK_FALSE(list.last_batch_serial);
}

TEST_CASE("a hub of thousands of springs ends in a batch for one thread") {
  Scene star;
  for (int i = 0; i <= 3000; ++i) star.add_particle(1.0, Vec3(i, 1, 0));
  for (Index i = 1; i <= 3000; ++i) star.add_spring(0, i, 1.0, 1.0);
  const SpringList<float> list = colour_springs<float>(star.springs, Order(3001, ""));
  CHECK(list.last_batch_serial);
  CHECK(list.size() == 3000);
  CHECK(batches_are_independent(list, 3001));
}
