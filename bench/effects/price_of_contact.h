#pragma once

#include <hooke/index.h>

namespace hooke::bench {

/// Prints a table: what self-collision costs where nothing is near, and in ten layers that lie on one
/// another, by method, for a cloth of `columns` x `columns` particles.
void print_price_of_contact(Index columns);

}  // namespace hooke::bench
