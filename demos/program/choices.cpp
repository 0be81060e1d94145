#include "program/choices.h"

#include <array>

namespace hooke::program {
namespace {

constexpr std::array precisions{Precision::single, Precision::twofold};

template <class Choices, class Name>
std::vector<std::string> names(const Choices& choices, Name name) {
  std::vector<std::string> result;
  for (const auto& choice : choices) result.emplace_back(name(choice));
  return result;
}

template <class Choices, class Name>
auto find(const Choices& choices, Name name, std::string_view wanted) {
  std::optional<typename Choices::value_type> found;
  for (const auto& choice : choices) {
    if (name(choice) == wanted) found = choice;
  }
  return found;
}

const auto method_name = [](const Method& method) { return to_string(method); };
const auto unstable_step_name = [](UnstableStep choice) { return to_string(choice); };
const auto on_trouble_name = [](OnTrouble choice) { return to_string(choice); };
const auto accumulation_name = [](Accumulation accumulation) { return to_string(accumulation); };
const auto precision_name = [](Precision precision) { return name_of(precision); };

}  // namespace

std::string_view name_of(Precision precision) {
  return precision == Precision::single ? "float" : "double";
}

std::vector<std::string> method_names() {
  return names(all_methods, method_name);
}
std::vector<std::string> accumulation_names() {
  return names(accumulations, accumulation_name);
}
std::vector<std::string> unstable_step_names() {
  return names(unstable_steps, unstable_step_name);
}
std::vector<std::string> on_trouble_names() {
  return names(troubles, on_trouble_name);
}
std::vector<std::string> precision_names() {
  return names(precisions, precision_name);
}

std::optional<Method> method_named(std::string_view name) {
  return find(all_methods, method_name, name);
}

std::optional<Accumulation> accumulation_named(std::string_view name) {
  return find(accumulations, accumulation_name, name);
}

std::optional<UnstableStep> unstable_step_named(std::string_view name) {
  return find(unstable_steps, unstable_step_name, name);
}

std::optional<OnTrouble> on_trouble_named(std::string_view name) {
  return find(troubles, on_trouble_name, name);
}

std::optional<Precision> precision_named(std::string_view name) {
  return find(precisions, precision_name, name);
}

}  // namespace hooke::program
