#pragma once

#include <memory>
#include <span>
#include <variant>
#include <vector>

#include <hooke/simulation.h>

#include "collide/prepared_meshes.h"
#include "frames/frames.h"
#include "model/adjacency.h"
#include "model/colouring.h"
#include "model/order.h"
#include "model/pins.h"
#include "model/row_store.h"
#include "model/slots.h"
#include "state.h"

namespace hooke {

/// What a scene is compiled to: all that stays constant while it runs, but for its effects.
template <class Real>
struct Model {
  /// Springs in the one layout that the accumulation mode reads; none where the scene has no springs.
  using SpringLayout = std::variant<std::monostate, Slots<Real>, SpringBatches<Real>>;

  Order order;
  std::shared_ptr<Frames> frames;  ///< null of a scene without
  std::size_t springs = 0;
  std::size_t linear_springs = 0;  ///< of them those in the layout: cables are an effect's
  std::size_t spring_reach = 0;    ///< the most blocks that a spring reaches over
  BlockRows<Real> inverse_mass;    ///< [1/kg]; 0 where pinned, and in the padding
  SpringLayout spring_layout;
  std::vector<MovingPin> moving_pins;
  /// Whether particles that attachments hold are pins to the method: to those that solve equations. Others
  /// move them as if they were free, and are corrected.
  bool holds_like_pins = false;
  std::shared_ptr<PreparedMeshes> meshes;  ///< of colliders; more are added when effects are compiled

  /// With the meshes of a simulation that goes on in this one, where there is one.
  Model(const Scene& scene, Accumulation accumulation, Executor& executor, bool holds_like_pins = false,
        std::shared_ptr<PreparedMeshes> meshes = std::make_shared<PreparedMeshes>());

  /// With its particles in an order that the caller chose.
  Model(const Scene& scene, const Adjacency& adjacency, Order order, Accumulation accumulation,
        Executor& executor, bool holds_like_pins = false,
        std::shared_ptr<PreparedMeshes> meshes = std::make_shared<PreparedMeshes>());

  std::size_t particles() const { return order.size(); }
  bool pinned(std::size_t particle) const { return inverse_mass[particle] == Real(0); }  ///< engine's order

  /// The particles in [first, last) that attachments hold.
  std::span<const HeldParticle> held_between(std::size_t first, std::size_t last) const {
    return frames == nullptr ? std::span<const HeldParticle>{} : frames->held_between(first, last);
  }
};

/// The slots of the model's springs, in whichever layout they are; null where there are none.
template <class Real>
const Slots<Real>* slots_of(const Model<Real>& model);

/// The packed copies of the state that its springs are read from.
template <class Real>
Packed packed_for(const Model<Real>& model);

/// The scene's positions and velocities at time zero. Pinned particles are at rest, or on their paths.
template <class Real>
State<Real> initial_state(const Scene& scene, const Model<Real>& model);

}  // namespace hooke
