#pragma once

#include <vector>

#include <hooke/scene.h>

#include "model/adjacency.h"
#include "model/order.h"

namespace hooke {

/// For each spring the end that holds it where only one does, in the user's numbering.
///
/// In the user's own order, where springs join particles a few distances apart, that is the lower end:
/// springs of one kind have one shift then. In any other order particles near one another hold about half of
/// their springs each, so that the lanes of a block hold equally many and few stay empty. Springs that lead
/// further than that are held by their lower end.
std::vector<Index> spring_holders(const Springs& springs, const Adjacency& adjacency, const Order& order);

}  // namespace hooke
