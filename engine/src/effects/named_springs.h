#pragma once

#include <string_view>
#include <vector>

#include "scene/element_checks.h"

namespace hooke {

/// The springs that an effect is for: those that it lists, or where it lists none, all with a rest length.
std::vector<Index> chosen_springs(const std::vector<Index>& listed, const Springs& springs);

/// The springs of Plasticity that can creep, in the order in which it remembers how far they have.
std::vector<Index> creeping_springs(const Plasticity& plasticity, const Springs& springs);

/// For each spring whether it is a cable; empty of a scene that names none.
std::vector<bool> cable_mask(const Scene& scene);

/// Faults of a list of springs: it names one that is not there, or one twice.
void check_spring_list(const std::vector<Index>& listed, const Scene& scene, const ElementChecks& checks);

/// Likewise where a spring without a rest length has no strain.
void check_strained_springs(const std::vector<Index>& listed, const Scene& scene,
                            const ElementChecks& checks);

/// A fault where the scene has, before the effect `data`, another one that changes the law of one of its
/// springs. Cables, StiffeningSprings and Plasticity do.
template <class Data>
void check_only_law(const Data& data, const Scene& scene, const ElementChecks& checks);

}  // namespace hooke
