#pragma once

#include <memory>
#include <vector>

#include "peer.h"

namespace hooke::bench {

/// The baselines that run in this program on one thread: the naive loop in double, a structure of arrays in
/// float, and Eigen's matrices in both.
std::vector<Peer> serial_peers(const std::shared_ptr<const CheckedScene>& scene);

}  // namespace hooke::bench
