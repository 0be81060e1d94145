#pragma once

#include <string>

namespace hooke::program {

/// What the machine says of its processor, in words; "unknown" where it does not.
std::string processor_name();

/// The value that /proc/cpuinfo has for the first processor under this key; "unknown" where it has none.
std::string processor_entry(const std::string& key);

/// What built this program.
std::string compiler_name();

}  // namespace hooke::program
