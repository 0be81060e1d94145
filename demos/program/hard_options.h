#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace hooke::program {

/// What the user asks of `hooke hard`.
struct HardOptions {
  bool quick = false;
  std::vector<int> cases;            ///< numbers; empty: all
  std::vector<std::string> methods;  ///< names; empty: all
  std::filesystem::path json;        ///< file for the verdicts; empty: none
  std::filesystem::path markdown;    ///< file for the page; empty: none
  std::filesystem::path expect;      ///< verdicts of an earlier run to compare with; empty: none
  std::filesystem::path scenes;      ///< folder to write the scenes to, instead of running them; empty: none
};

void add_hard_options(CLI::App& command, HardOptions& options);

}  // namespace hooke::program
