#pragma once

#include <memory>
#include <vector>

#include "peer.h"

namespace hooke::bench {

/// The engine with its default accumulation, in float and double, on one thread and on all.
std::vector<Peer> hooke_peers(const std::shared_ptr<const CheckedScene>& scene);

}  // namespace hooke::bench
