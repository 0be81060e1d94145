#pragma once

#include <vector>

#include "model/neighbour_graph.h"

namespace hooke {

/// The user's numbers of the particles in an order that keeps neighbours near: Cuthill and McKee's numbering
/// (1969), but begun from a whole cross-section in the middle of each connected part, and going both ways.
///
/// Begun at one particle, as usual, the levels in a sheet are arcs around a corner of it, and become as long
/// as its diagonal; from a straight cross-section they stay as short as that.
std::vector<Index> middle_out_order(const NeighbourGraph& graph);

}  // namespace hooke
