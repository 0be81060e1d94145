#include "program/text_table.h"

#include <algorithm>
#include <iomanip>
#include <ostream>

namespace hooke::program {

void print_table(const std::vector<TableRow>& rows, std::size_t left_aligned, std::ostream& out) {
  constexpr std::size_t gap = 2;
  std::vector<std::size_t> widths;
  for (const TableRow& row : rows) {
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  }
  for (const TableRow& row : rows) {
    for (std::size_t c = 0; c < row.size(); ++c) {
      const bool left = c < left_aligned;
      out << std::string(c == 0 ? 0 : gap, ' ') << (left ? std::left : std::right)
          << std::setw(static_cast<int>(widths[c])) << row[c];
    }
    out << std::right << '\n';
  }
}

}  // namespace hooke::program
