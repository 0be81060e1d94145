#include "program/hard_options.h"

#include <charconv>

#include <CLI/CLI.hpp>

#include "program/choices.h"
#include "scenes/hard/hard_case.h"

namespace hooke::program {
namespace {

CLI::Validator case_number() {
  return CLI::Validator(
      [](const std::string& text) {
        int value = 0;
        const char* const end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data(), end, value);
        std::string numbers;
        for (const hard::HardCase& one : hard::hard_cases()) {
          if (error == std::errc{} && stop == end && one.number == value) return std::string();
          numbers += (numbers.empty() ? "" : ", ") + std::to_string(one.number);
        }
        return "there is no case " + text + "; give one of " + numbers;
      },
      "");
}

CLI::Validator known_method() {
  return CLI::Validator(
      [](const std::string& text) {
        return method_named(text)
                   ? std::string()
                   : text + " is not known; give one of " + CLI::detail::join(method_names(), ", ");
      },
      "");
}

}  // namespace

void add_hard_options(CLI::App& command, HardOptions& options) {
  command.add_flag("--quick", options.quick, "Smaller scenes, shorter runs and fewer seeds");
  command.add_option("--case", options.cases, "Run only this case; may be given again for more")
      ->check(case_number())
      ->allow_extra_args(false)
      ->type_name("NUMBER");
  command.add_option("--method", options.methods, "Run only this method; may be given again for more")
      ->check(known_method())
      ->allow_extra_args(false)
      ->type_name("NAME");
  command
      .add_option("--json", options.json,
                  "File for an array of {case, name, method, outcome, figure, limit, reason}")
      ->type_name("FILE.json");
  command
      .add_option("--markdown", options.markdown,
                  "File for a page with the table, the cases and their criteria")
      ->type_name("FILE.md");
  command
      .add_option("--expect", options.expect,
                  "A file that --json wrote: fail if what passed there does not pass now")
      ->check(CLI::ExistingFile)
      ->type_name("FILE.json");
  command.add_option("--write", options.scenes, "Write the scenes as files to this folder, and run nothing")
      ->type_name("DIR");
}

}  // namespace hooke::program
