#pragma once

#include <cstddef>

/// Of the whole process, since operator new and delete are replaced in a program that has this.

namespace hooke::test {

std::size_t allocations();  ///< so far
std::size_t held_bytes();   ///< now, as they were asked for

}  // namespace hooke::test
