#include "program/hard_page.h"

#include <sstream>

#include "program/hard_report.h"
#include "program/rounded.h"

namespace hooke::program {
namespace {

void write_table(const std::vector<Verdict>& verdicts, std::ostream& out) {
  const std::vector<std::string> methods = methods_of(verdicts);
  out << "| | case |";
  for (const std::string& method : methods) out << ' ' << method << " |";
  out << "\n|---|---|";
  for (std::size_t i = 0; i < methods.size(); ++i) out << "---|";
  for (const hard::HardCase* one : cases_of(verdicts)) {
    out << "\n| " << one->number << " | [" << one->name << "](#" << one->number << "-" << one->name << ") |";
    for (const std::string& method : methods) {
      const Verdict* verdict = find_verdict(verdicts, one->number, method);
      out << ' ' << (verdict ? verdict_text(*verdict) : "-") << " |";
    }
  }
  out << "\n";
}

/// A sentence of the program in a list: nothing in it is to be taken for markup.
std::string plain(const std::string& text) {
  std::string result;
  for (const char c : text)
    result += c == '\n' ? std::string(" ") : c == '<' ? std::string("&lt;") : std::string(1, c);
  return result;
}

void write_figures(const std::vector<Verdict>& verdicts, const hard::HardCase& one, std::ostream& out) {
  bool begun = false;
  for (const Verdict& verdict : verdicts) {
    if (verdict.hard_case->number != one.number || verdict.result.outcome != hard::Outcome::pass) continue;
    if (!begun)
      out << "- passed, " << plain(verdict.result.figure_of) << ' ' << rounded(verdict.result.limit) << ": ";
    out << (begun ? ", " : "") << verdict.method << ' ' << rounded(verdict.result.figure);
    begun = true;
  }
  if (begun) out << "\n";
}

void write_case(const std::vector<Verdict>& verdicts, const hard::HardCase& one, std::ostream& out) {
  out << "\n### " << one.number << " " << one.name << "\n"
      << one.scene << "\n\n**Passes** " << one.criterion << "\n";
  if (one.chaotic)
    out << "\n**Chaotic:** another instruction set, in other last bits, may lead to other verdicts.\n";
  if (!one.not_asked.empty()) out << "\n**Not asked:** " << one.not_asked << "\n";
  out << "\n";
  write_figures(verdicts, one, out);
  for (const SharedReason& reason : reasons_of(verdicts, one)) {
    out << "- " << to_string(reason.outcome) << ": ";
    for (std::size_t i = 0; i < reason.methods.size(); ++i) out << (i ? ", " : "") << reason.methods[i];
    out << ": " << plain(reason.reason) << "\n";
  }
}

}  // namespace

std::string hard_page(const std::vector<Verdict>& verdicts, const std::string& command) {
  std::ostringstream out;
  out << "# Hard cases\n\n"
         "Scenes that break simulators, each with every method. This page is written by the program, never "
         "by "
         "hand:\n```sh\n"
      << command
      << "\n```\n"
         "Each method is asked with the library's own choices, in double precision, mostly for steps of 1/60 "
         "s: a "
         "step that is longer than it surely\nbears is divided by the library. A method that bears no step "
         "at all "
         "on a scene, because it lets undamped oscillations grow,\nis asked to refuse it, and is shown as "
         "refused.\n\n"
         "- **pass**: all criteria were met. Nothing else is marked so.\n"
         "- **fail**: with the first figure that missed its limit; all of them are below.\n"
         "- **refused**: the library says before the first step that it cannot do this, in the words "
         "below.\n"
         "- **\\***: the method that `recommended_method()` names for this scene and step.\n\n"
         "In every case: "
      << hard::common_criteria() << "\n\n";
  write_table(verdicts, out);
  out << "\n## The cases\n";
  for (const hard::HardCase* one : cases_of(verdicts)) write_case(verdicts, *one, out);
  return out.str();
}

}  // namespace hooke::program
