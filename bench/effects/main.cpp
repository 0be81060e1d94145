// What each effect costs, in time and memory, where a scene names it; and that it costs nothing where it does
// not.
//
//   bench_effects [--quick]
//
// Prints docs/effects.md. Each effect is timed beside the same scene without it, by turns, on one thread. The
// scene without it is also timed beside itself, which must give the same bits: the rest is noise.

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "effects/paired_times.h"
#include "effects/price_of_colliders.h"
#include "effects/price_of_contact.h"
#include "effects/price_of_sleep.h"
#include "effects/priced_effects.h"
#include "program/machine.h"

namespace hooke::bench {
namespace {

struct Effort {
  Index columns;
  std::uint64_t steps;
  int turns, turns_unnamed;
  Index cloths_asleep;
};

constexpr Effort full{128, 40, 31, 301, 20}, quick{16, 4, 3, 3, 2};

Settings settings() {
  return {.step = 1e-5, .unstable_step = UnstableStep::take, .on_trouble = OnTrouble::ignore, .threads = 1};
}

bool belongs_to(const Stage& stage, const std::string& name) {
  return stage.name == name || stage.name.starts_with(name + " (");
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

/// The effect's own stages, put together.
struct Share {
  std::size_t bytes = 0;
  std::vector<std::string> reads, writes, sweeps;
};

void add_new(std::vector<std::string>& words, const std::string& word) {
  if (std::find(words.begin(), words.end(), word) == words.end()) words.push_back(word);
}

Share share_of(const Plan& plan, const std::string& name) {
  Share share;
  for (const Stage& stage : plan.stages) {
    if (!belongs_to(stage, name)) continue;
    share.bytes += stage.bytes;
    for (const std::string& word : stage.reads) add_new(share.reads, word);
    for (const std::string& word : stage.writes) add_new(share.writes, word);
    add_new(share.sweeps, stage.sweep);
  }
  return share;
}

/// In the one sweep over particles alone, or with sweeps of its own too.
std::string fusion(const Share& share) {
  if (share.sweeps == std::vector<std::string>{"particles"}) return "yes";
  std::string text = "no: ";
  for (const std::string& sweep : share.sweeps) {
    if (sweep != "particles") text += (text == "no: " ? "" : ", ") + sweep;
  }
  return text;
}

/// The median ratio of times of two scenes that do not name the effect. Throws where they differ in anything
/// else.
double time_unnamed(const PricedEffect& priced, Simulation<float>& bare, const Effort& effort) {
  Simulation<float> again(priced.bare, settings());
  const double ratio = paired_times(bare, again, effort.steps, effort.turns_unnamed).ratio;
  if (again.state_hash() != bare.state_hash())
    throw std::runtime_error(priced.name + ": two runs of the scene without it differ");
  return ratio;
}

/// Returns time_unnamed().
double print_row(const PricedEffect& priced, const Effort& effort) {
  Scene with_it = priced.bare;
  with_it.effects.push_back(priced.effect);
  Simulation<float> bare(priced.bare, settings()), with(with_it, settings());
  const double unnamed = time_unnamed(priced, bare, effort);
  const PairedTimes times = paired_times(bare, with, effort.steps, effort.turns);
  const std::string name(std::visit([](const auto& data) { return data.name; }, priced.effect));
  const Share share = share_of(with.plan(), name);
  if (share.sweeps.empty()) throw std::runtime_error(priced.name + ": the plan has no stage of it");
  const double nanoseconds = 1e9 * (times.second - times.first) / priced.elements;
  std::printf("| %s | %s | %.2f | %.2f | %.3f | %.1f | %s | %s | %s |\n", priced.name.c_str(),
              priced.element.c_str(), nanoseconds, times.ratio, unnamed,
              double(share.bytes) / priced.elements, joined(share.reads).c_str(),
              joined(share.writes).c_str(), fusion(share).c_str());
  std::fflush(stdout);
  return unnamed;
}

void print_page(const Effort& effort) {
  std::printf(R"(# What each effect costs

Written by `build/release/bin/bench_effects`, on %s, %s; `hooke plan` says the same of a scene of yours. An effect is in a scene's
plan, takes memory and takes time only where the scene names it.

Each row takes a scene without the effect and the same scene with it: a hung cloth of %u x %u particles, or where a closed surface is
needed a block of as many; float, symplectic Euler, one thread. Both take %llu steps by turns, %d times, the one first and then the other.

- **ns**: what the effect adds to a step [ns] for each of its elements; a difference of medians. What changes how the rest of a step
  runs, such as a sweep more, is in it.
- **step**: a step with it over a step without it, median of the ratios of the turns.
- **not named**: the same for two scenes that do not name it, by %d turns. They must end in the same bits.
- **bytes**: what its stages hold, for each element.
- **fused**: whether it runs in the sweep over particles that does all the rest of a step; else the sweeps that it adds.

| effect | element | ns | step | not named | bytes | reads | writes | fused |
|---|---|---|---|---|---|---|---|---|
)",
              program::processor_name().c_str(), program::compiler_name().c_str(), effort.columns,
              effort.columns, static_cast<unsigned long long>(effort.steps), effort.turns,
              effort.turns_unnamed);
  std::vector<double> unnamed;
  for (const PricedEffect& priced : priced_effects(effort.columns))
    unnamed.push_back(print_row(priced, effort));
  std::sort(unnamed.begin(), unnamed.end());
  std::printf(
      "\nTwo scenes that do not name an effect take %.3f to %.3f times the time of each other, in the median "
      "%.3f: so much "
      "is noise.\n",
      unnamed.front(), unnamed.back(), unnamed[unnamed.size() / 2]);
  print_price_of_colliders(2 * effort.columns, effort.turns);
  print_price_of_contact(effort.columns);
  print_price_of_sleep(effort.cloths_asleep, effort.columns / 4, effort.turns);
}

}  // namespace
}  // namespace hooke::bench

int main(int argc, char** argv) {
  const bool is_quick = argc == 2 && std::strcmp(argv[1], "--quick") == 0;
  if (argc > 1 && !is_quick) {
    std::fprintf(stderr, "usage: bench_effects [--quick]\n");
    return 2;
  }
  try {
    hooke::bench::print_page(is_quick ? hooke::bench::quick : hooke::bench::full);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_effects: %s\n", error.what());
    return 1;
  }
}
