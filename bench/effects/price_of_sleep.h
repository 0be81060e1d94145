#pragma once

#include <hooke/index.h>

namespace hooke::bench {

/// Prints a table: what cloths that sleep cost beside the same cloths awake, by method. `cloths` of them lie
/// on the floor, each of `columns` x `columns` particles, beside one that is shaken.
void print_price_of_sleep(Index cloths, Index columns, int turns);

}  // namespace hooke::bench
