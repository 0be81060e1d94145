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
#include "sleep/awake_blocks.h"
#include "sleep/islands.h"
#include "state.h"
#include "strip.h"

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
  BlockRows<Real> inverse_mass;    ///< [1/kg]; 0 where pinned or asleep, and in the padding
  SpringLayout spring_layout;
  std::vector<MovingPin> moving_pins;
  /// Whether particles that attachments hold are pins to the method: to those that solve equations. Others
  /// move them as if they were free, and are corrected.
  bool holds_like_pins = false;
  std::shared_ptr<PreparedMeshes> meshes;  ///< of colliders; more are added when effects are compiled
  std::shared_ptr<Islands> islands;        ///< null of a scene that does not name Sleep
  AwakeBlocks awake;                       ///< those that steps work on

  /// With the meshes of a simulation that goes on in this one, where there is one.
  Model(const Scene& scene, Accumulation accumulation, Executor& executor, bool holds_like_pins = false,
        std::shared_ptr<PreparedMeshes> meshes = std::make_shared<PreparedMeshes>());

  /// With its particles in an order that the caller chose.
  Model(const Scene& scene, const Adjacency& adjacency, Order order, Accumulation accumulation,
        Executor& executor, bool holds_like_pins = false,
        std::shared_ptr<PreparedMeshes> meshes = std::make_shared<PreparedMeshes>());

  /// Of the same islands as another one, in an order of its own.
  void share_islands(const Model& other);

  /// Whether islands fell asleep or woke since `seen`, which is then now.
  bool islands_changed(std::uint64_t& seen) const {
    const std::uint64_t before = seen;
    if (islands != nullptr) seen = islands->changes();
    return seen != before;
  }

  /// Takes note of which islands sleep: their particles are pinned, and blocks of which all sleep are
  /// skipped. Whether that has changed since it was called last.
  bool follow_islands();

  /// [1/kg] of what sleeps, too; 0 where pinned, and in the padding.
  const BlockRows<Real>& inverse_mass_awake() const {
    return islands == nullptr ? inverse_mass : inverse_mass_awake_;
  }

  /// Of a particle of the engine's order.
  bool sleeps(std::size_t particle) const {
    return islands != nullptr && islands->particle_sleeps(order.user(Index(particle)));
  }

  /// Calls visit(first, last) for each run of blocks within [begin, end) that are not skipped.
  template <class Visit>
  void for_each_awake_run(std::size_t begin, std::size_t end, const Visit& visit) const {
    awake.for_each_run(begin, end, visit);
  }

  /// Likewise for strips of them.
  template <class Visit>
  void for_each_awake_strip(std::size_t begin, std::size_t end, const Visit& visit) const {
    awake.for_each_run(begin, end,
                       [&](std::size_t first, std::size_t last) { for_each_strip(first, last, visit); });
  }

  std::size_t particles() const { return order.size(); }
  /// Or asleep; in the engine's order.
  bool pinned(std::size_t particle) const { return inverse_mass[particle] == Real(0); }

  /// The particles in [first, last) that attachments hold.
  std::span<const HeldParticle> held_between(std::size_t first, std::size_t last) const {
    return frames == nullptr ? std::span<const HeldParticle>{} : frames->held_between(first, last);
  }

 private:
  BlockRows<Real> inverse_mass_awake_;  ///< where islands may sleep
  std::uint64_t changes_followed_ = 0;
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
