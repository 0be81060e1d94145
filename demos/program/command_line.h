#pragma once

#include <string>

namespace hooke::program {

/// The words of a command as a shell would take them.
std::string command_line(int argc, const char* const* argv);

}  // namespace hooke::program
