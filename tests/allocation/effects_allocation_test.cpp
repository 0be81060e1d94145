#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "allocation/counted_memory.h"
#include "effects/all_effects.h"

using namespace hooke;
using namespace hooke::test;

namespace {

Settings settings() {
  return {.step = 2e-4, .on_trouble = OnTrouble::ignore, .threads = 1};
}

/// What a simulation with these effects holds beside its states [B]: the allocator's count.
double held_by(const std::vector<NamedEffect>& all, const Subset& named) {
  const Scene scene = scene_with(all, named);
  const std::size_t before = held_bytes();
  double held = 0.0;
  {
    const Simulation<float> simulation(scene, settings());
    held = double(held_bytes() - before) - double(simulation.plan().state_bytes);
  }
  CHECK(held_bytes() == before);
  return held;
}

template <class Data>
std::size_t place_of(const std::vector<NamedEffect>& all) {
  const auto is_it = [](const NamedEffect& one) { return std::holds_alternative<Data>(one.effect); };
  return std::size_t(std::ranges::find_if(all, is_it) - all.begin());
}

Subset only(std::size_t effect, std::size_t count) {
  Subset named(count);
  named[effect] = true;
  return named;
}

}  // namespace

TEST_CASE("random subsets of effects hold what each of theirs holds alone, by the allocator's count") {
  const auto all = one_of_each_effect();
  Simulation<float>(ball_for_effects(), settings());  // what the first of all sets up stays
  const double bare = held_by(all, Subset(all.size()));
  std::vector<double> of_each;
  for (std::size_t i = 0; i < all.size(); ++i) of_each.push_back(held_by(all, only(i, all.size())) - bare);

  // Self-collision has a copy of the part of its surface that is awake, where parts may sleep.
  const std::size_t sleep = place_of<Sleep>(all), collision = place_of<SelfCollision>(all);
  Subset two = only(sleep, all.size());
  two[collision] = true;
  const double together = held_by(all, two) - bare - of_each[sleep] - of_each[collision];
  CHECK(together > 0.0);

  // Lists of effects and of stages grow in leaps, so they hold more or less room that is not used.
  constexpr double leap = 256.0;
  std::mt19937 random(17);
  for (int round = 0; round < 500; ++round) {
    const Subset named = random_subset(all, random, std::size_t(random()) % all.size());
    double expected = bare, leaps = leap;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!named[i]) continue;
      expected += of_each[i];
      leaps += leap;
    }
    if (named[sleep] && named[collision]) expected += together;
    CHECK(std::abs(held_by(all, named) - expected) < leaps);
  }
  CHECK(held_by(all, Subset(all.size())) == bare);
}
