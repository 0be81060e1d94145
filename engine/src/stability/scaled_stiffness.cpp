#include "stability/scaled_stiffness.h"

#include <algorithm>
#include <cmath>

#include "model/slot_springs.h"

namespace hooke {
namespace {

constexpr std::size_t blocks_at_a_time = 64;

Vec3 at(std::span<const double> vector, std::size_t particle) {
  return Eigen::Map<const Vec3>(vector.data() + 3 * particle);
}

void add(std::span<double> vector, std::size_t particle, const Vec3& value) {
  Eigen::Map<Vec3>(vector.data() + 3 * particle) += value;
}

/// The force with which a spring answers when its ends, `apart` [m], are moved apart by `moved`:
/// k n (n.q) + (k - k l0 / l) (q - n (n.q)).
Vec3 answer(const SlotSpring& spring, const Vec3& apart, const Vec3& moved) {
  const double length = apart.norm();
  // Without a direction a spring has no force, and one of no rest length always the same stiffness.
  if (length == 0.0) return spring.pull == 0.0 ? Vec3(spring.stiffness * moved) : Vec3::Zero();
  const Vec3 along = apart / length;
  const double across = spring.stiffness - spring.pull / length;
  return across * moved + (spring.stiffness - across) * along.dot(moved) * along;
}

}  // namespace

template <class Real>
ScaledStiffness<Real>::ScaledStiffness(const Model<Real>& model, std::span<const GroundPlane> grounds,
                                       EffectList<Real>& effects, const State<Real>& state,
                                       Executor& executor)
    : model_(model), grounds_(grounds), effects_(effects), state_(state), executor_(executor) {
  if (effects.coupled()) {
    search_.emplace(state);
    effects.prepare(state, state.time, executor);
  }
  inverse_roots_.reserve(3 * model.particles());
  for (std::size_t i = 0; i < model.particles(); ++i) {
    inverse_roots_.insert(inverse_roots_.end(), 3, std::sqrt(double(model.inverse_mass_awake()[i])));
  }
}

template <class Real>
Vec3 ScaledStiffness<Real>::ground_product(std::size_t particle, const Vec3& moved) const {
  Vec3 sum = Vec3::Zero();
  for (const GroundPlane& ground : grounds_) {
    const Vec3 normal = ground.normal.stableNormalized();
    const double depth = ground.height - normal.dot(state_.position(particle).template cast<double>());
    if (depth > 0.0) sum += ground.stiffness * normal.dot(moved) * normal;
  }
  return sum;
}

template <class Real>
void ScaledStiffness<Real>::multiply_block(std::size_t block, std::span<const double> in,
                                           std::span<double> out) const {
  const Slots<Real>* const slots = slots_of(model_);
  const auto moved = [&](std::size_t i) { return Vec3(inverse_roots_[3 * i] * at(in, i)); };
  if (slots != nullptr) {
    for_each_spring(
        *slots, state_.size(), block, [&](std::size_t own, std::size_t other, const SlotSpring& spring) {
          const Vec3 apart =
              (state_.position(own).template cast<double>() - state_.position(other).template cast<double>());
          const Vec3 force = answer(spring, apart, moved(own) - moved(other));
          add(out, own, inverse_roots_[3 * own] * force);
          if (slots->ends == SpringEnds::one) add(out, other, -inverse_roots_[3 * other] * force);
        });
  }
  if (grounds_.empty()) return;
  const std::size_t first = block * block_size;
  for (std::size_t i = first; i < std::min(first + block_size, state_.size()); ++i) {
    add(out, i, inverse_roots_[3 * i] * ground_product(i, moved(i)));
  }
}

template <class Real>
void ScaledStiffness<Real>::multiply(std::span<const double> in, std::span<double> out) {
  std::fill(out.begin(), out.end(), 0.0);
  const Slots<Real>* const slots = slots_of(model_);
  const std::size_t blocks = block_count(state_.size());
  const auto multiply_blocks = [&](std::size_t begin, std::size_t end) {
    for (std::size_t block = begin; block < end; ++block) multiply_block(block, in, out);
  };
  // Where a spring is known to one end only it adds to others' blocks: one after the other then.
  if (slots != nullptr && slots->ends == SpringEnds::one) {
    multiply_blocks(0, blocks);
  } else {
    executor_.parallel_for(blocks, blocks_at_a_time, multiply_blocks);
  }
  if (search_) add_coupled(in, out);
}

template <class Real>
void ScaledStiffness<Real>::add_coupled(std::span<const double> in, std::span<double> out) {
  State<Real>& search = *search_;
  for (std::size_t i = 0; i < search.size(); ++i)
    search.set_velocity(i, (inverse_roots_[3 * i] * at(in, i)).template cast<Real>());
  effects_.prepare_products(search, executor_);
  const auto add_strip = [&](std::size_t begin, std::size_t end) {
    const Strip<Real> strip(search, begin, end);
    StripForce<Real> product{};
    effects_.add_products(strip, {Real(1), Real(0)}, Curvature::exact, product);
    for (std::size_t lane = 0; lane < strip.particles; ++lane) {
      const std::size_t i = strip.first + lane;
      add(out, i, inverse_roots_[3 * i] * Vec3(product.x[lane], product.y[lane], product.z[lane]));
    }
  };
  executor_.parallel_for(block_count(search.size()), blocks_at_a_time,
                         [&](std::size_t begin, std::size_t end) { for_each_strip(begin, end, add_strip); });
}

template class ScaledStiffness<float>;
template class ScaledStiffness<double>;

}  // namespace hooke
