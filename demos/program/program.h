#pragma once

namespace hooke::program {

/// The hooke program: reads the arguments, does what they ask for and returns the exit code. Never throws.
int run_program(int argc, const char* const* argv);

}  // namespace hooke::program
