#include "model/model.h"

#include <algorithm>

#include "effects/named_springs.h"
#include "model/tiles.h"

namespace hooke {
namespace {

template <class Real>
BlockRows<Real> inverse_masses(const Scene& scene, const Order& order, const Frames* like_pins) {
  std::vector<bool> pinned(order.size(), false);
  for (const Pin& pin : scene.pins) pinned[pin.particle] = true;
  if (like_pins != nullptr) {
    for (const HeldParticle& held : like_pins->held()) pinned[order.user(held.particle)] = true;
  }
  return BlockRows<Real>(order.size(), [&](std::size_t i) {
    const Index particle = order.user(i);
    return pinned[particle] ? Real(0) : Real(1.0 / scene.particles.mass[particle]);
  });
}

template <class Real>
typename Model<Real>::SpringLayout lay_out_springs(const Springs& springs, const Adjacency& adjacency,
                                                   const Order& order, Accumulation accumulation,
                                                   Executor& executor) {
  if (adjacency.spring_count() == 0) return std::monostate{};
  switch (accumulation) {
    case Accumulation::gather:
      return make_slots<Real>(springs, adjacency, order, executor);
    case Accumulation::coloured: {
      Slots<Real> slots = make_slots<Real>(springs, adjacency, order, executor, SpringEnds::one);
      const std::size_t batch_blocks = coloured_batch_blocks(slots);
      return colour_batches(std::move(slots), batch_blocks);
    }
    case Accumulation::atomic:
      return share_batches(make_slots<Real>(springs, adjacency, order, executor, SpringEnds::one),
                           atomic_batch_blocks(block_count(order.size()), executor.threads()));
  }
  return std::monostate{};
}

template <class Real>
typename Model<Real>::SpringLayout lay_out_linear_springs(const Scene& scene, const Adjacency& adjacency,
                                                          const Order& order, Accumulation accumulation,
                                                          Executor& executor) {
  const std::vector<bool> cables = cable_mask(scene);
  if (cables.empty()) return lay_out_springs<Real>(scene.springs, adjacency, order, accumulation, executor);
  const Adjacency linear(scene.springs, order.size(), [&](std::size_t s) { return !cables[s]; });
  return lay_out_springs<Real>(scene.springs, linear, order, accumulation, executor);
}

std::size_t count_cables(const Scene& scene) {
  const std::vector<bool> cables = cable_mask(scene);
  return std::size_t(std::count(cables.begin(), cables.end(), true));
}

template <class Real>
Model<Real> model_in_chosen_order(const Scene& scene, Accumulation accumulation, Executor& executor,
                                  bool holds_like_pins, std::shared_ptr<PreparedMeshes> meshes) {
  const std::size_t count = scene.particles.size();
  const Adjacency adjacency(scene.springs, count);
  return {scene,
          adjacency,
          choose_order(scene.springs, adjacency, count),
          accumulation,
          executor,
          holds_like_pins,
          std::move(meshes)};
}

}  // namespace

template <class Real>
Model<Real>::Model(const Scene& scene, Accumulation accumulation, Executor& executor, bool like_pins,
                   std::shared_ptr<PreparedMeshes> given)
    : Model(model_in_chosen_order<Real>(scene, accumulation, executor, like_pins, std::move(given))) {}

template <class Real>
Model<Real>::Model(const Scene& scene, const Adjacency& adjacency, Order chosen, Accumulation accumulation,
                   Executor& executor, bool like_pins, std::shared_ptr<PreparedMeshes> given)
    : order(std::move(chosen)),
      frames(frames_of(scene, order)),
      springs(scene.springs.size()),
      linear_springs(springs - count_cables(scene)),
      spring_reach(hooke::spring_reach(scene.springs, order)),
      inverse_mass(inverse_masses<Real>(scene, order, like_pins ? frames.get() : nullptr)),
      spring_layout(lay_out_linear_springs<Real>(scene, adjacency, order, accumulation, executor)),
      moving_pins(hooke::moving_pins(scene, order)),
      holds_like_pins(like_pins),
      meshes(std::move(given)),
      islands(islands_of(scene)) {
  if (islands != nullptr) inverse_mass_awake_ = inverse_mass;
}

template <class Real>
void Model<Real>::share_islands(const Model& other) {
  islands = other.islands;
}

template <class Real>
bool Model<Real>::follow_islands() {
  if (!islands_changed(changes_followed_)) return false;
  inverse_mass = BlockRows<Real>(particles(),
                                 [&](std::size_t i) { return sleeps(i) ? Real(0) : inverse_mass_awake_[i]; });
  awake.choose(block_count(particles()), [&](std::size_t block) {
    const std::size_t first = block * block_size, last = std::min(first + block_size, particles());
    for (std::size_t i = first; i < last; ++i) {
      if (!sleeps(i)) return true;
    }
    return false;
  });
  return true;
}

template <class Real>
const Slots<Real>* slots_of(const Model<Real>& model) {
  const auto* batches = std::get_if<SpringBatches<Real>>(&model.spring_layout);
  return batches != nullptr ? &batches->slots : std::get_if<Slots<Real>>(&model.spring_layout);
}

template <class Real>
Packed packed_for(const Model<Real>& model) {
  const Slots<Real>* slots = slots_of(model);
  if (slots == nullptr || !slots->any_indexed()) return Packed::none;
  return slots->damped ? Packed::positions_and_velocities : Packed::positions;
}

template <class Real>
State<Real> initial_state(const Scene& scene, const Model<Real>& model) {
  State<Real> state(model.particles(), packed_for(model));
  for (std::size_t i = 0; i < model.particles(); ++i) {
    const Index e = model.order.engine(i);
    state.set_position(e, scene.particles.position[i].cast<Real>());
    if (!model.pinned(e)) state.set_velocity(e, scene.particles.velocity_of(i).cast<Real>());
  }
  move_pins(std::span(model.moving_pins), state.time, state);
  hold(model.held_between(0, model.particles()), state.time, state);
  return state;
}

template struct Model<float>;
template struct Model<double>;
template const Slots<float>* slots_of(const Model<float>&);
template const Slots<double>* slots_of(const Model<double>&);
template Packed packed_for(const Model<float>&);
template Packed packed_for(const Model<double>&);
template State<float> initial_state(const Scene&, const Model<float>&);
template State<double> initial_state(const Scene&, const Model<double>&);

}  // namespace hooke
