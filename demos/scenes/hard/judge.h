#pragma once

#include <string>
#include <vector>

#include "scenes/hard/hard_case.h"

namespace hooke::hard {

/// Collects the figures of a run, each with its limit, and decides. A figure that is not a number meets no
/// limit.
class Judge {
 public:
  void at_most(std::string figure_of, double figure, double limit);
  void at_least(std::string figure_of, double figure, double limit);

  /// Something that went wrong and has no figure, such as a step that was not taken.
  void wrong(std::string reason);

  /// What a reader must know of a run that passed.
  void flag(std::string remark);

  /// Passed where nothing was wrong and every figure met its limit; then it shows the first of them, which is
  /// the case's own, else the first that did not.
  Result result() const;

 private:
  struct Figure {
    std::string of;
    double value, limit;
    bool met;
  };
  std::vector<Figure> figures_;
  std::vector<std::string> wrongs_, remarks_;
};

Result refused(std::string reason);

}  // namespace hooke::hard
