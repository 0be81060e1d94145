#include <CLI/CLI.hpp>

#include "program/view.h"

namespace hooke::program {

void add_view_options(CLI::App& command, ViewOptions& options) {
  CLI::Option* const screenshot =
      command
          .add_option("--screenshot", options.screenshot, "Save a picture of the whole window, then close it")
          ->type_name("FILE.png");
  command.add_option("--after", options.after, "Simulated time before the screenshot [s]; 2, if not given")
      ->check(CLI::NonNegativeNumber)
      ->needs(screenshot)
      ->type_name("SECONDS");
  command.add_flag("--study", options.study,
                   "Show at once what more accuracy would cost; a screenshot waits for it");
}

}  // namespace hooke::program
