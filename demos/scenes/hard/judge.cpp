#include "scenes/hard/judge.h"

#include <algorithm>
#include <sstream>
#include <utility>

namespace hooke::hard {
namespace {

void append(std::string& text, const std::string& part) {
  text += (text.empty() ? "" : "; ") + part;
}

std::string short_text(double value) {
  std::ostringstream text;
  text.precision(3);
  text << value;
  return text.str();
}

}  // namespace

std::string_view to_string(Outcome outcome) {
  switch (outcome) {
    case Outcome::pass:
      return "pass";
    case Outcome::fail:
      return "fail";
    case Outcome::refused:
      return "refused";
  }
  return "";
}

void Judge::at_most(std::string figure_of, double figure, double limit) {
  figures_.push_back({std::move(figure_of) + ", at most", figure, limit, figure <= limit});
}

void Judge::at_least(std::string figure_of, double figure, double limit) {
  figures_.push_back({std::move(figure_of) + ", at least", figure, limit, figure >= limit});
}

void Judge::wrong(std::string reason) {
  wrongs_.push_back(std::move(reason));
}

void Judge::flag(std::string remark) {
  remarks_.push_back(std::move(remark));
}

Result Judge::result() const {
  Result result;
  const auto missed = [](const Figure& figure) { return !figure.met; };
  auto shown = std::find_if(figures_.begin(), figures_.end(), missed);
  const bool passed = wrongs_.empty() && shown == figures_.end() && !figures_.empty();
  result.outcome = passed ? Outcome::pass : Outcome::fail;
  if (passed) shown = figures_.begin();
  if (shown != figures_.end()) {
    result.figure = shown->value;
    result.limit = shown->limit;
    result.figure_of = shown->of;
  }
  for (const std::string& wrong : wrongs_) append(result.reason, wrong);
  for (const Figure& figure : figures_) {
    if (!figure.met)
      append(result.reason, figure.of + " " + short_text(figure.limit) + ": is " + short_text(figure.value));
  }
  for (const std::string& remark : remarks_) append(result.reason, remark);
  return result;
}

Result refused(std::string reason) {
  Result result;
  result.outcome = Outcome::refused;
  result.reason = std::move(reason);
  return result;
}

}  // namespace hooke::hard
