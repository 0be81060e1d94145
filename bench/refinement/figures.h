#pragma once

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "refinement/sheets.h"

namespace hooke::bench {

/// One figure of the study.
struct Figure {
  std::string quantity;
  Pattern pattern;
  Mode mode;
  double angle;  ///< [deg]
  Index cells;
  double value;
};

/// All that the study measured.
class Figures {
 public:
  void add(Figure figure) { all_.push_back(std::move(figure)); }

  /// Largest over smallest, less 1, of those that agree with all that is asked for.
  template <class Wanted>
  double spread(const Wanted& wanted) const {
    double least = HUGE_VAL, most = -HUGE_VAL;
    for (const Figure& figure : all_) {
      if (!wanted(figure)) continue;
      least = std::min(least, figure.value);
      most = std::max(most, figure.value);
    }
    return most / least - 1.0;
  }

  void write_csv(std::ostream& out) const;

  /// A row for each pattern and mode that has the quantity at 0 degrees, a column for each fineness.
  void write_refinement(std::ostream& out, const std::string& quantity) const;

  /// A row for each pattern and mode, a column for each angle, at one fineness; and the spreads over angles.
  void write_rotation(std::ostream& out, const std::string& quantity, Index cells) const;

 private:
  std::vector<Figure> all_;
};

}  // namespace hooke::bench
