#pragma once

#include <vector>

#include "scaling/arguments.h"
#include "scaling/row.h"
#include "scaling/scene_list.h"

namespace hooke::bench {

/// Measures a scene in every configuration that is asked for; rows in the order of mode, precision and
/// threads. Repetitions of all configurations that are held at once run in random order, so that what slows
/// the machine for a while falls on all of them. All are held at once where memory allows it. None, and a
/// message on standard error, where memory does not even allow one.
std::vector<Row> measure_scene(const ListedScene& listed, const Arguments& arguments,
                               const MachineLimits& machine);

}  // namespace hooke::bench
