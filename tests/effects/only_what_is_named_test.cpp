#include <doctest/doctest.h>

#include <random>
#include <set>
#include <string>

#include <hooke/hooke.h>

#include "effects/all_effects.h"
#include "sanitized.h"

using namespace hooke;
using namespace hooke::test;

namespace {

/// Whether the stage is one of this effect's.
bool belongs_to(const Stage& stage, const NamedEffect& effect) {
  return stage.name == effect.stage || stage.name.starts_with(effect.stage + " (");
}

/// The bytes of an effect's stages; and counts these.
std::size_t bytes_of(const Plan& plan, const NamedEffect& effect, std::size_t& stages) {
  std::size_t bytes = 0;
  for (const Stage& stage : plan.stages) {
    if (!belongs_to(stage, effect)) continue;
    ++stages;
    bytes += stage.bytes;
  }
  return bytes;
}

Settings settings_of_test() {
  return {.method = SymplecticEuler{}, .step = 2e-4, .on_trouble = OnTrouble::ignore, .threads = 1};
}

}  // namespace

TEST_CASE("there is one of each effect to be named") {
  const auto all = one_of_each_effect();
  REQUIRE(all.size() == std::variant_size_v<Effect>);
  for (std::size_t i = 0; i < all.size(); ++i) CHECK(all[i].effect.index() == i);
}

TEST_CASE("the plans of random subsets of effects have their stages and their bytes, and no others") {
  const auto all = one_of_each_effect();
  const Simulation<float> bare(ball_for_effects(), settings_of_test());
  std::mt19937 random(7);
  for (int round = 0; round < (sanitized ? 50 : 500); ++round) {
    const Subset named = random_subset(all, random, std::size_t(random()) % all.size());
    const Simulation<float> simulation(scene_with(all, named), settings_of_test());
    const Plan& plan = simulation.plan();
    std::size_t stages = 0, bytes = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      std::size_t own = 0;
      bytes += bytes_of(plan, all[i], own);
      CAPTURE(all[i].stage);
      CHECK((own > 0) == named[i]);
      stages += own;
    }
    // Springs and the method; and springs only where not all are cables.
    CHECK(plan.stages.size() == stages + 2);
    const std::size_t springs_of_bare = bare.plan().stages[0].bytes;
    std::size_t springs = 0;
    for (const Stage& stage : plan.stages) springs += stage.name == "springs (gather)" ? stage.bytes : 0;
    const std::size_t rest = plan.bytes() - bytes - springs - plan.state_bytes;
    CHECK(rest == bare.plan().bytes() - springs_of_bare - bare.plan().state_bytes);
    // One state less where steps cannot run ahead of each other.
    const bool remembers = named[12] || named[20] || named[21];  // plasticity, and what is carried
    if (!remembers) CHECK(plan.state_bytes <= bare.plan().state_bytes);
  }
}

TEST_CASE("an effect with its coefficient at zero gives the same bits as one that is not named") {
  for (const NamedEffect& one : one_of_each_effect()) {
    CAPTURE(one.stage);
    if (!one.zero) continue;
    Scene with = ball_for_effects();
    with.effects = {Gravity{}, *one.zero};
    Scene without = ball_for_effects();
    without.effects = {Gravity{}};
    for (const Method& method : {Method(SymplecticEuler{}), Method(RungeKutta4{}), Method(BackwardEuler{})}) {
      CAPTURE(to_string(method));
      Settings settings = settings_of_test();
      settings.method = method;
      Simulation<float> a(without, settings), b(with, settings);
      REQUIRE(a.step(20).ok());
      REQUIRE(b.step(20).ok());
      CHECK(a.state_hash() == b.state_hash());
    }
  }
}

TEST_CASE("an effect that is removed and named again leaves no trace") {
  const auto all = one_of_each_effect();
  std::mt19937 random(11);
  for (std::size_t changed = 0; changed < all.size(); ++changed) {
    CAPTURE(all[changed].stage);
    Subset named = random_subset(all, random, changed);
    const Scene scene = scene_with(all, named);
    named[changed] = false;
    const Scene fewer = scene_with(all, named);

    Simulation<float> never(scene, settings_of_test()), first(scene, settings_of_test());
    REQUIRE(never.step(10).ok());
    REQUIRE(first.step(5).ok());
    const Snapshot<float> middle = first.snapshot();
    Simulation<float> removed(fewer, settings_of_test());
    REQUIRE(removed.step(5).ok());
    Simulation<float> again(scene, settings_of_test());
    again.restore(middle);
    REQUIRE(again.step(5).ok());
    CHECK(again.state_hash() == never.state_hash());
    // What moves does not sleep.
    const bool acts = !std::holds_alternative<Sleep>(all[changed].effect);
    CHECK((removed.state_hash() != first.state_hash()) == acts);
  }
}
