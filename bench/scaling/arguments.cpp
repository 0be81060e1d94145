#include "scaling/arguments.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <thread>

#include <CLI/CLI.hpp>

#include "scaling/scene_list.h"

namespace hooke::bench {
namespace {

constexpr const char* nothing = "none";

/// Accepts a whole number in [least, most], and `none` where a list may be empty. An error says what to give.
CLI::Validator whole_number(unsigned least, unsigned most, bool or_none = false) {
  return CLI::Validator(
      [=](const std::string& text) {
        unsigned value = 0;
        const char* const end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data(), end, value);
        const bool usable = error == std::errc{} && stop == end && value >= least && value <= most;
        if (usable || (or_none && text == nothing)) return std::string();
        return text + " cannot be used; give whole numbers from " + std::to_string(least) + " to " +
               std::to_string(most) + (or_none ? ", or none" : "");
      },
      "");
}

CLI::Validator one_of(const std::vector<std::string>& names) {
  return CLI::Validator(
      [names](const std::string& text) {
        if (std::find(names.begin(), names.end(), text) != names.end()) return std::string();
        return text + " is not known; give some of " + CLI::detail::join(names, ", ");
      },
      "");
}

/// An option that takes a list of words, with commas or spaces between them, and reads each once.
template <class Value, class Read>
CLI::Option* add_list(CLI::App& app, const std::string& name, const std::string& description,
                      std::vector<Value>& values, Read read) {
  const auto take = [&values, read](const std::vector<std::string>& words) {
    values.clear();
    for (const std::string& word : words) {
      if (word == nothing) continue;
      const Value value = read(word);
      if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
    }
  };
  return app.add_option_function<std::vector<std::string>>(name, take, description)
      ->delimiter(',')
      ->type_name("LIST");
}

/// 1, 2, 4 and so on, and as many as the machine has.
std::vector<unsigned> powers_of_two_and_all() {
  const unsigned all = std::max(1u, std::thread::hardware_concurrency());
  std::vector<unsigned> counts;
  for (unsigned count = 1; count < all; count *= 2) counts.push_back(count);
  counts.push_back(all);
  return counts;
}

/// The smallest scenes, few and short repetitions: seconds in all, to see that the program works.
void make_quick(Arguments& arguments) {
  arguments.sizes = {32, 64};
  arguments.meshes = {"jittered10K"};
  const std::vector<unsigned> counts = powers_of_two_and_all();
  arguments.threads = {counts.front()};
  if (counts.size() > 1) arguments.threads.push_back(counts.back());
  arguments.repeats = 2;
  arguments.seconds = 0.01;
  arguments.machine = {.seconds = 0.02, .repeats = 2};
}

}  // namespace

Arguments all_arguments() {
  Arguments all;
  all.meshes = mesh_names();
  all.threads = powers_of_two_and_all();
  for (const std::string& name : program::accumulation_names())
    all.modes.push_back(*program::accumulation_named(name));
  for (const std::string& name : program::precision_names())
    all.precisions.push_back(*program::precision_named(name));
  return all;
}

void add_options(CLI::App& app, Arguments& arguments) {
  const auto number = [](const std::string& word) { return unsigned(std::stoul(word)); };
  CLI::Option* const quick = app.add_flag_callback(
      "--quick", [&] { make_quick(arguments); },
      "The smallest scenes, few and short repetitions: some seconds");
  add_list(app, "--sizes", "n of square cloths of n x n particles, or none; 32, 64 to 4096, if not given",
           arguments.sizes, number)
      ->check(whole_number(2, 16384, true))
      ->excludes(quick);
  std::vector<std::string> meshes = mesh_names();
  meshes.push_back(nothing);
  add_list(app, "--meshes",
           "Irregular meshes: " + CLI::detail::join(meshes, ", ") + "; all of them, if not given",
           arguments.meshes, [](const std::string& word) { return word; })
      ->check(one_of(meshes))
      ->excludes(quick);
  add_list(app, "--threads", "Numbers of threads; powers of two and all of the machine's, if not given",
           arguments.threads, number)
      ->check(whole_number(1, 1024))
      ->excludes(quick);
  add_list(app, "--modes",
           "How spring forces are summed: " + CLI::detail::join(program::accumulation_names(), ", ") +
               "; all, if not given",
           arguments.modes, [](const std::string& word) { return *program::accumulation_named(word); })
      ->check(one_of(program::accumulation_names()));
  add_list(app, "--precisions",
           CLI::detail::join(program::precision_names(), " or ") + "; both, if not given",
           arguments.precisions, [](const std::string& word) { return *program::precision_named(word); })
      ->check(one_of(program::precision_names()));
  app.add_option("--repeats", arguments.repeats, "Repetitions of each measurement; 5, if not given")
      ->check(whole_number(1, 1000))
      ->excludes(quick)
      ->type_name("COUNT");
  app.add_option("--csv", arguments.csv,
                 "File for the figures; the machine's facts go beside it, to one that ends in .machine.txt")
      ->type_name("FILE.csv");
}

}  // namespace hooke::bench
