#include "program/machine.h"

#include <fstream>

namespace hooke::program {

std::string processor_entry(const std::string& key) {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);) {
    if (line.rfind(key, 0) != 0 || line.find_first_not_of(" \t:", key.size()) == std::string::npos) continue;
    if (line.find_first_of("\t:", key.size()) != key.size()) continue;  // a longer key
    return line.substr(line.find_first_not_of(" \t:", key.size()));
  }
  return "unknown";
}

std::string processor_name() {
  return processor_entry("model name");
}

std::string compiler_name() {
#if defined(__clang__)
  return "Clang " __clang_version__;
#elif defined(__GNUC__)
  return "GCC " __VERSION__;
#else
  return "unknown";
#endif
}

}  // namespace hooke::program
