#include "solve/supernodes.h"

namespace hooke {
namespace {

/// Columns [first, end), with so many zeros stored for their being together.
struct Range {
  std::size_t first, end, zeros;
};

/// A merged node may hold this share of zeros; small ones may hold more, as it is their number that costs.
constexpr double most_zeros = 0.15, most_zeros_of_small = 0.5;
constexpr std::size_t small_columns = 8;

class Columns {
 public:
  explicit Columns(const Eigen::SparseMatrix<double>& factor) : factor_(factor) {}

  std::size_t size() const { return std::size_t(factor_.cols()); }

  /// Rows below the diagonal.
  std::size_t rows_below(std::size_t column) const { return end(column) - begin(column); }
  const int* begin(std::size_t column) const {
    return factor_.innerIndexPtr() + factor_.outerIndexPtr()[column] + 1;
  }
  const int* end(std::size_t column) const {
    return factor_.innerIndexPtr() + factor_.outerIndexPtr()[column + 1];
  }

  /// The first column that this one's elimination changes, its parent in the elimination tree; size() for
  /// none.
  std::size_t parent(std::size_t column) const {
    return rows_below(column) == 0 ? size() : std::size_t(*begin(column));
  }

 private:
  const Eigen::SparseMatrix<double>& factor_;
};

/// Values of a node, zeros included.
std::size_t values_of(const Columns& columns, const Range& range) {
  const std::size_t width = range.end - range.first;
  return width * (width + 1) / 2 + width * columns.rows_below(range.end - 1);
}

/// Merges `upper`, which comes right behind `lower`, into it where that is worth its zeros.
bool merge(const Columns& columns, Range& lower, const Range& upper) {
  const std::size_t parent = columns.parent(lower.end - 1);
  if (parent >= upper.end) return false;
  const std::size_t rows_together = upper.end - upper.first + columns.rows_below(upper.end - 1);
  const std::size_t added = (lower.end - lower.first) * (rows_together - columns.rows_below(lower.end - 1));
  const Range merged{lower.first, upper.end, lower.zeros + upper.zeros + added};
  const bool small = merged.end - merged.first <= small_columns;
  const double most = small ? most_zeros_of_small : most_zeros;
  if (double(merged.zeros) > most * double(values_of(columns, merged))) return false;
  lower = merged;
  return true;
}

std::vector<Range> ranges_of(const Columns& columns) {
  std::vector<Range> ranges;
  for (std::size_t column = 0; column < columns.size(); ++column) {
    Range last{column, column + 1, 0};
    while (!ranges.empty()) {
      Range merged = ranges.back();
      if (!merge(columns, merged, last)) break;
      last = merged;
      ranges.pop_back();
    }
    ranges.push_back(last);
  }
  return ranges;
}

}  // namespace

Supernodes find_supernodes(const Eigen::SparseMatrix<double>& factor) {
  const Columns columns(factor);
  Supernodes result;
  for (const Range& range : ranges_of(columns)) {
    const std::size_t width = range.end - range.first, last = range.end - 1;
    result.nodes.push_back({std::uint32_t(range.first), std::uint32_t(width),
                            std::uint32_t(result.rows.size()), std::uint32_t(columns.rows_below(last)),
                            result.values});
    result.rows.insert(result.rows.end(), columns.begin(last), columns.end(last));
    result.values += width * (width + columns.rows_below(last));
  }
  return result;
}

}  // namespace hooke
