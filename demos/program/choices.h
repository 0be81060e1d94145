#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <hooke/methods.h>
#include <hooke/simulation.h>

/// The words by which arguments and reports name methods and the like. They come from the engine's own types,
/// so a new method can be asked for as soon as it exists.

namespace hooke::program {

/// The type of the numbers that a simulation runs on.
enum class Precision { single, twofold };

std::string_view name_of(Precision precision);

std::vector<std::string> method_names();
std::vector<std::string> accumulation_names();
std::vector<std::string> unstable_step_names();
std::vector<std::string> on_trouble_names();
std::vector<std::string> precision_names();

/// What a name stands for; nothing where it is none of those above.
std::optional<Method> method_named(std::string_view name);
std::optional<Accumulation> accumulation_named(std::string_view name);
std::optional<UnstableStep> unstable_step_named(std::string_view name);
std::optional<OnTrouble> on_trouble_named(std::string_view name);
std::optional<Precision> precision_named(std::string_view name);

}  // namespace hooke::program
