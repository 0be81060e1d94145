#pragma once

#include <memory>

#include "peer.h"

namespace hooke::bench {

/// Bullet's soft body: counted for each projection of a link.
Peer bullet_peer(const std::shared_ptr<const CheckedScene>& scene);

}  // namespace hooke::bench
