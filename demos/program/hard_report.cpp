#include "program/hard_report.h"

#include <algorithm>
#include <cmath>
#include <ostream>

#include "program/rounded.h"
#include "program/text_table.h"

namespace hooke::program {
namespace {

constexpr std::size_t methods_of_a_table = 5;  // so that a line is not much longer than 100 letters

std::string list(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

/// A reason without the name of the method that it was given to.
std::string general(std::string reason, std::string_view method) {
  for (std::size_t at = 0; (at = reason.find(method, at)) != std::string::npos;)
    reason.replace(at, method.size(), "METHOD");
  return reason;
}

/// A table of some of the methods: `count` from `first` on.
void print_part(const std::vector<Verdict>& verdicts, const std::vector<std::string>& methods,
                std::size_t first, std::size_t count, std::ostream& out) {
  TableRow header{"", "case"};
  header.insert(header.end(), methods.begin() + long(first), methods.begin() + long(first + count));
  std::vector<TableRow> rows{header};
  for (const hard::HardCase* one : cases_of(verdicts)) {
    TableRow row{std::to_string(one->number), std::string(one->name)};
    for (std::size_t m = first; m < first + count; ++m) {
      const Verdict* verdict = find_verdict(verdicts, one->number, methods[m]);
      row.push_back(verdict ? verdict_text(*verdict) : "-");
    }
    rows.push_back(row);
  }
  print_table(rows, 2 + count, out);
}

}  // namespace

std::string verdict_text(const Verdict& verdict) {
  const hard::Result& result = verdict.result;
  std::string text(to_string(result.outcome));
  if (result.outcome == hard::Outcome::fail && !std::isnan(result.figure))
    text += " " + rounded(result.figure);
  return text + (verdict.recommended ? " *" : "");
}

std::vector<std::string> methods_of(const std::vector<Verdict>& verdicts) {
  std::vector<std::string> methods;
  for (const Verdict& verdict : verdicts) {
    if (std::find(methods.begin(), methods.end(), verdict.method) == methods.end())
      methods.emplace_back(verdict.method);
  }
  return methods;
}

std::vector<const hard::HardCase*> cases_of(const std::vector<Verdict>& verdicts) {
  std::vector<const hard::HardCase*> cases;
  for (const Verdict& verdict : verdicts) {
    if (cases.empty() || cases.back() != verdict.hard_case) cases.push_back(verdict.hard_case);
  }
  return cases;
}

const Verdict* find_verdict(const std::vector<Verdict>& verdicts, int case_number,
                            const std::string& method) {
  for (const Verdict& verdict : verdicts) {
    if (verdict.hard_case->number == case_number && verdict.method == method) return &verdict;
  }
  return nullptr;
}

std::vector<SharedReason> reasons_of(const std::vector<Verdict>& verdicts, const hard::HardCase& of) {
  std::vector<SharedReason> reasons;
  for (const Verdict& verdict : verdicts) {
    if (verdict.hard_case->number != of.number || verdict.result.reason.empty()) continue;
    const std::string reason = general(verdict.result.reason, verdict.method);
    const auto same = [&](const SharedReason& one) {
      return one.outcome == verdict.result.outcome && one.reason == reason;
    };
    auto found = std::find_if(reasons.begin(), reasons.end(), same);
    if (found == reasons.end()) found = reasons.insert(found, {{}, verdict.result.outcome, reason});
    found->methods.emplace_back(verdict.method);
  }
  return reasons;
}

void print_verdicts(const std::vector<Verdict>& verdicts, std::ostream& out) {
  const std::vector<std::string> methods = methods_of(verdicts);
  for (std::size_t first = 0; first < methods.size(); first += methods_of_a_table) {
    print_part(verdicts, methods, first, std::min(methods_of_a_table, methods.size() - first), out);
    out << '\n';
  }
  double seconds = 0.0;
  for (const Verdict& verdict : verdicts) seconds += verdict.seconds;
  out << "It took " << rounded(seconds)
      << " s.\n* the library recommends the method for this scene and step\n\n";
  for (const hard::HardCase* one : cases_of(verdicts)) {
    const std::vector<SharedReason> reasons = reasons_of(verdicts, *one);
    if (reasons.empty()) continue;
    out << one->number << ' ' << one->name << '\n';
    for (const SharedReason& reason : reasons)
      out << "  " << to_string(reason.outcome) << ": " << list(reason.methods) << ": " << reason.reason
          << '\n';
  }
}

}  // namespace hooke::program
