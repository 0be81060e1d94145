#pragma once

#include <hooke/index.h>

namespace hooke::bench {

/// Prints a table: what a hundred spheres and a plane cost, beside a cloth of `columns` x `columns` particles
/// and under it, by method.
void print_price_of_colliders(Index columns, int turns);

}  // namespace hooke::bench
