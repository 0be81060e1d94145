#pragma once

#include <cstdint>
#include <vector>

#include <hooke/simulation.h>

namespace hooke {

/// How many equal substeps each step is taken in, by the settings' choice. One for a method that bears no
/// step at all: shorter ones would not help it. The scene and the settings have no faults.
std::uint64_t substeps_of(const Scene& scene, const Settings& settings);

/// Adds a fault where the settings refuse a step that is too long, or where it would need too many substeps.
/// The scene has no faults, and the settings no others.
void check_stability(std::vector<Fault>& faults, const Scene& scene, const Settings& settings);

}  // namespace hooke
