// What each effect costs, in time and memory, where a scene names it; and that it costs nothing where it does
// not.
//
//   bench_effects [--quick]
//
// Prints the tables of docs/effects.md. Each effect is timed beside the same scene without it, by turns, on
// one thread. The scene without it is also timed beside itself: so much is noise.

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <exception>
#include <string>
#include <vector>

#include "effects/paired_times.h"
#include "effects/priced_effects.h"

namespace hooke::bench {
namespace {

struct Effort {
  Index columns;
  std::uint64_t steps;
  int turns;
};

constexpr Effort full{128, 40, 31}, quick{16, 4, 3};

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

void print_row(const PricedEffect& priced, const Effort& effort) {
  Scene with_it = priced.bare;
  with_it.effects.push_back(priced.effect);
  Simulation<float> bare(priced.bare, settings()), again(priced.bare, settings()), with(with_it, settings());
  const PairedTimes noise = paired_times(bare, again, effort.steps, effort.turns);
  const PairedTimes times = paired_times(bare, with, effort.steps, effort.turns);
  const std::string name(std::visit([](const auto& data) { return data.name; }, priced.effect));
  const Share share = share_of(with.plan(), name);
  const double nanoseconds = 1e9 * (times.second - times.first) / priced.elements;
  std::printf("| %s | %s | %.2f | %.2f | %.3f | %.1f | %s | %s | %s |\n", priced.name.c_str(),
              priced.element.c_str(), nanoseconds, times.ratio, noise.ratio,
              double(share.bytes) / priced.elements, joined(share.reads).c_str(),
              joined(share.writes).c_str(), fusion(share).c_str());
  std::fflush(stdout);
}

void print_table(const Effort& effort) {
  std::printf(
      "| effect | element | ns for each in a step | step, over the step without it | two scenes without "
      "it | bytes for each | reads | writes | fused |\n|---|---|---|---|---|---|---|---|---|\n");
  for (const PricedEffect& priced : priced_effects(effort.columns)) print_row(priced, effort);
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
    hooke::bench::print_table(is_quick ? hooke::bench::quick : hooke::bench::full);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_effects: %s\n", error.what());
    return 1;
  }
}
