#pragma once

#include <cstddef>
#include <string>

/// Loops that do nothing but load, or nothing but multiply and add, in the widest vectors that this machine
/// has: what it can do at most. Which instructions are used is decided when the program runs.

namespace hooke::bench {

/// What a run of multiply-adds did.
struct MultiplyAdds {
  double flops;   ///< a multiply-add is two
  double result;  ///< of the arithmetic; to be used, so that it cannot be left out
};

/// Reads `count` floats, a multiple of 1024 and aligned to a cache line, and returns their sum.
double sum(const float* values, std::size_t count);

/// Rounds of independent multiply-adds, enough of them at once to hide their latency.
MultiplyAdds multiply_add_floats(std::size_t rounds);
MultiplyAdds multiply_add_doubles(std::size_t rounds);

/// The instruction set in use, such as AVX3.
std::string vector_instructions();

}  // namespace hooke::bench
