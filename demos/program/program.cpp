#include "program/program.h"

#include <exception>
#include <iostream>
#include <new>

#include <CLI/CLI.hpp>

#include "program/accuracy.h"
#include "program/arguments.h"
#include "program/check.h"
#include "program/command_line.h"
#include "program/exit_code.h"
#include "program/hard.h"
#include "program/plan.h"
#include "program/run.h"
#include "program/view.h"

namespace hooke::program {
namespace {

constexpr const char* exit_codes =
    "Exit codes: 0 done; 1 the simulation went bad (the last good state is kept), or a hard case that passed "
    "does not\n"
    "any more; 2 an argument, the scene or an output file cannot be used; 130 interrupted by Ctrl-C (what "
    "was "
    "written is kept).\n";

/// Ends a parse that leaves nothing to run. Returns the exit code.
int end_parse(const CLI::App& app, const CLI::ParseError& error) {
  const bool asked_for_text = error.get_exit_code() == 0;  // --help and --version
  if (asked_for_text) {
    app.exit(error, std::cout, std::cerr);
    return exit_ok;
  }
  std::cerr << "hooke: " << error.what()
            << "\nRun hooke --help, or hooke COMMAND --help, to see what can be given.\n";
  return exit_bad_input;
}

int parse_and_run(int argc, const char* const* argv) {
  Arguments arguments;
  CLI::App app("Hooke simulates particles and springs: cloth, ropes and soft bodies, from a scene file.",
               "hooke");
  app.set_version_flag("--version", "hooke " HOOKE_VERSION);
  app.footer(std::string("\n`hooke COMMAND --help` says what a command takes.\n") + exit_codes);
  app.require_subcommand(0, 1);  // that there is one is checked after words that are none

  CLI::App& run_command = *app.add_subcommand(
      "run", "Simulate a scene, write its frames where --out says, and print a summary of the run.");
  add_scene_options(run_command, arguments);
  add_run_options(run_command, arguments);
  run_command.footer(
      std::string("\nExample: hooke run curtain.json --seconds 2 --out frames --format vtp\n") + exit_codes);

  ViewOptions view_options;
  CLI::App& view_command = *app.add_subcommand(
      "view", "Show a scene in a window while it is simulated: drag its particles, change how it is done.");
  add_scene_options(view_command, arguments);
  add_view_options(view_command, view_options);

  CLI::App& plan_command = *app.add_subcommand(
      "plan", "List the stages that each step of a scene runs: what each reads, writes and holds in memory.");
  add_scene_options(plan_command, arguments);

  CLI::App& check_command = *app.add_subcommand(
      "check", "Say whether a scene can be simulated; if not, every fault, and what to do about it.");
  add_scene_options(check_command, arguments);

  CLI::App& accuracy_command = *app.add_subcommand(
      "accuracy",
      "Show what accuracy costs in time on a scene: every method at many steps, against a reference.");
  add_file_options(accuracy_command, arguments);
  add_parallel_options(accuracy_command, arguments);
  add_accuracy_options(accuracy_command, arguments);
  accuracy_command.footer(
      std::string("\nExample: hooke accuracy curtain.json --tolerance 0.01 --horizon 1 --budget 2min\n") +
      exit_codes);

  HardOptions hard_options;
  CLI::App& hard_command = *app.add_subcommand(
      "hard", "Run scenes that break simulators with every method, and say what came of each.");
  add_hard_options(hard_command, hard_options);
  hard_command.footer(std::string("\nExample: hooke hard --quick --case 5 --method verlet\n") + exit_codes);

  try {
    app.parse(argc, argv);
    if (app.get_subcommands().empty())
      throw CLI::RequiredError("give a command: run, view, plan, check, accuracy or hard",
                               CLI::ExitCodes::RequiredError);
  } catch (const CLI::ParseError& error) {
    return end_parse(app, error);
  }
  arguments.command = command_line(argc, argv);
  if (accuracy_command.parsed()) return accuracy(arguments, std::cout, std::cerr);
  if (hard_command.parsed()) return run_hard_cases(hard_options, arguments.command, std::cout, std::cerr);
  if (run_command.parsed()) return run(arguments, std::cout, std::cerr);
  if (view_command.parsed()) return view(arguments, view_options, std::cout, std::cerr);
  if (plan_command.parsed()) return plan(arguments, std::cout);
  return check(arguments, std::cout, std::cerr);
}

}  // namespace

int run_program(int argc, const char* const* argv) {
  try {
    return parse_and_run(argc, argv);
  } catch (const std::bad_alloc&) {
    std::cerr << "hooke: not enough memory for this scene; give a smaller one\n";
  } catch (const std::exception& error) {
    std::cerr << "hooke: " << error.what() << '\n';
  }
  return exit_bad_input;
}

}  // namespace hooke::program
