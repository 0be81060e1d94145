#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "scenes/hard/suite.h"

/// How the verdicts of `hooke hard` are said: as text, as JSON, and as a page.

namespace hooke::program {

using hard::Verdict;

/// A reason, and the methods that it holds for.
struct SharedReason {
  std::vector<std::string> methods;
  hard::Outcome outcome;
  std::string reason;
};

/// A verdict in a few letters: pass, refused, or fail with the figure that failed; with a * where the library
/// recommends the method.
std::string verdict_text(const Verdict& verdict);

/// The methods of the verdicts, in order.
std::vector<std::string> methods_of(const std::vector<Verdict>& verdicts);

/// The cases of the verdicts, in order.
std::vector<const hard::HardCase*> cases_of(const std::vector<Verdict>& verdicts);

/// Nothing where there is no such verdict.
const Verdict* find_verdict(const std::vector<Verdict>& verdicts, int case_number, const std::string& method);

/// Why methods failed a case or were refused, and what must be known of those that passed; methods with the
/// same reason together, with METHOD where each is told its own name.
std::vector<SharedReason> reasons_of(const std::vector<Verdict>& verdicts, const hard::HardCase& of);

/// Tables of cases by methods, and the reasons below.
void print_verdicts(const std::vector<Verdict>& verdicts, std::ostream& out);

}  // namespace hooke::program
