#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace hooke::program {

using TableRow = std::vector<std::string>;

/// Prints rows of equally many cells in columns as wide as they need: the first `left_aligned` from the left,
/// the others from the right.
void print_table(const std::vector<TableRow>& rows, std::size_t left_aligned, std::ostream& out);

}  // namespace hooke::program
