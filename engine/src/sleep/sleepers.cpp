#include "sleep/sleepers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "sleep/changes_between.h"
#include "sleep/joined_parts.h"

namespace hooke {
namespace {

/// So much of a place may be rounding.
template <class Real>
constexpr double rounding = 4.0 * double(std::numeric_limits<Real>::epsilon());

/// Particles in a piece: some microseconds of work.
constexpr std::size_t most_in_piece = 4096;

/// In a snapshot: what is added to the group of an island that sleeps.
constexpr std::uint32_t asleep = 1u << 31;

template <class Real>
double square(const Eigen::Matrix<Real, 3, 1>& vector) {
  return vector.template cast<double>().squaredNorm();
}

/// As many steps as a time is [s], one at least.
std::uint32_t steps_in(double time, double step) {
  return std::uint32_t(std::clamp(std::ceil(time / step), 1.0, double(asleep - 1)));
}

std::vector<Index> all_below(std::size_t count) {
  std::vector<Index> all(count);
  std::iota(all.begin(), all.end(), Index{0});
  return all;
}

}  // namespace

template <class Real>
Sleepers<Real>::Sleepers(const Sleep& sleep, const Model<Real>& model, double step)
    : model_(model),
      islands_(*model.islands),
      square_speed_(sleep.speed * sleep.speed),
      step_(step),
      enough_(steps_in(sleep.time, step)),
      members_(islands_, model.order, all_below(model.particles())),
      steps_at_rest_(islands_.size(), 0),
      group_(islands_.size(), 0),
      around_(islands_.size()),
      chosen_(islands_.size(), 0),
      never_(islands_.size(), 0),
      disturbed_(islands_.size(), 0) {
  for (Index island = 0; island < islands_.size(); ++island) {
    const std::span<const Index> members = members_.of(island);
    for (std::size_t first = 0; first < members.size(); first += most_in_piece)
      pieces_.push_back({island, members.subspan(first, std::min(most_in_piece, members.size() - first))});
  }
  for (const HeldParticle& held : model.held_between(0, model.particles()))
    never_[islands_.of(model.order.user(held.particle))] = 1;
}

template <class Real>
void Sleepers<Real>::begin_step(double from, double to, const EffectList<Real>& effects) {
  all_disturbed_ = false;
  std::fill(disturbed_.begin(), disturbed_.end(), char{0});
  boxes_.clear();
  islands_.forget_touches();
  effects.disturb(from, to, *this);
  disturb_moved_pins(from, to);
  if (islands_.asleep() == 0) return;
  for (Index island = 0; island < islands_.size(); ++island) {
    if (islands_.sleeps(island) && is_disturbed(island, around_[island])) choose_group_of(island);
  }
  wake_chosen();
}

template <class Real>
void Sleepers<Real>::disturb_moved_pins(double from, double to) {
  for (const MovingPin& pin : model_.moving_pins) {
    if (changes_between(pin.path, from, to, &Keyframe::displacement)) particle(pin.particle);
  }
}

template <class Real>
bool Sleepers<Real>::is_disturbed(Index island, const AxisBox& around) const {
  return all_disturbed_ || disturbed_[island] != 0 ||
         std::ranges::any_of(boxes_, [&](const AxisBox& box) { return box.meets(around); });
}

template <class Real>
void Sleepers<Real>::end_step(StateRing<Real>& states, Executor& executor) {
  executor.parallel_for(pieces_.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      if (!islands_.sleeps(pieces_[p].island)) look(pieces_[p], states);
    }
  });
  count_steps_at_rest();
  wake_touched();
  const auto tired = [&](Index island) {
    return !islands_.sleeps(island) && steps_at_rest_[island] >= enough_;
  };
  for (Index island = 0; island < islands_.size(); ++island) {
    if (!tired(island)) continue;
    put_to_sleep(groups_of_touching(), states);
    return;
  }
}

/// Whether a particle was faster than may be, by its velocity and by its way: what something holds up at the
/// end of each step may have a velocity that leads nowhere, and rounding moves what lies still far from the
/// origin.
template <class Real>
bool Sleepers<Real>::moves(Index i, const StateRing<Real>& states) const {
  const State<Real>& now = states.now();
  if (!(square(now.velocity(i)) > square_speed_)) return false;
  const Eigen::Matrix<Real, 3, 1> way = now.position(i) - states.before().position(i);
  return square(way) >
         square_speed_ * step_ * step_ + rounding<Real> * rounding<Real> * square(now.position(i));
}

template <class Real>
void Sleepers<Real>::look(Piece& piece, const StateRing<Real>& states) const {
  const std::size_t count = piece.particles.size();
  for (std::size_t n = 0; n < count; ++n) {
    const std::size_t place = (piece.witness + n) % count;
    if (!moves(piece.particles[place], states)) continue;
    piece.witness = place;
    piece.at_rest = false;
    return;
  }
  piece.at_rest = true;
}

template <class Real>
void Sleepers<Real>::count_steps_at_rest() {
  for (std::uint32_t& steps : steps_at_rest_) steps = std::min(steps + 1, enough_);
  for (const Piece& piece : pieces_) {
    const Index island = piece.island;
    if (!piece.at_rest || never_[island] != 0 || all_disturbed_ || disturbed_[island] != 0)
      steps_at_rest_[island] = 0;
  }
}

template <class Real>
bool Sleepers<Real>::wake_touched() {
  for (const auto& [a, b] : islands_.touches()) {
    if (islands_.sleeps(a) != islands_.sleeps(b)) choose_group_of(islands_.sleeps(a) ? a : b);
  }
  const bool any = any_chosen_;
  wake_chosen();
  return any;
}

/// For each island the lowest of those that touch it, or that touch one that does.
template <class Real>
std::vector<Index> Sleepers<Real>::groups_of_touching() const {
  JoinedParts parts(islands_.size());
  for (const auto& [a, b] : islands_.touches()) parts.join(a, b);
  std::vector<Index> groups(islands_.size());
  for (Index island = 0; island < islands_.size(); ++island) groups[island] = parts.lowest(island);
  return groups;
}

template <class Real>
void Sleepers<Real>::put_to_sleep(const std::vector<Index>& groups, StateRing<Real>& states) {
  std::vector<char> stays_awake(islands_.size(), 0);
  for (Index island = 0; island < islands_.size(); ++island) {
    if (!islands_.sleeps(island) && steps_at_rest_[island] < enough_) stays_awake[groups[island]] = 1;
  }
  for (Index island = 0; island < islands_.size(); ++island) {
    if (islands_.sleeps(island) || stays_awake[groups[island]] != 0) continue;
    around_[island] = around(island, states.now());
    if (is_disturbed(island, around_[island])) stays_awake[groups[island]] = 1;
  }
  for (Index island = 0; island < islands_.size(); ++island) {
    if (islands_.sleeps(island) || stays_awake[groups[island]] != 0) continue;
    islands_.set(island, true);
    group_[island] = groups[island];
    stop(island, states);
  }
}

/// As it is in the newest state, so in all.
template <class Real>
void Sleepers<Real>::stop(Index island, StateRing<Real>& states) const {
  for (const Index i : members_.of(island)) {
    const Eigen::Matrix<Real, 3, 1> place = states.now().position(i);
    for (State<Real>& state : states.all()) {
      state.set_position(i, place);
      state.set_velocity(i, Eigen::Matrix<Real, 3, 1>::Zero());
    }
  }
}

/// As far as what holds an island up may seem to be away from it, by rounding and by the way that its
/// particles may still go.
template <class Real>
AxisBox Sleepers<Real>::around(Index island, const State<Real>& state) const {
  AxisBox box;
  for (const Index i : members_.of(island)) box.widen(Vec3(state.position(i).template cast<double>()));
  const double furthest = box.low.cwiseAbs().cwiseMax(box.high.cwiseAbs()).maxCoeff();
  box.grow(std::sqrt(square_speed_) * step_ + rounding<Real> * furthest);
  return box;
}

template <class Real>
void Sleepers<Real>::wake(std::span<const Index> particles) {
  for (const Index particle : particles) {
    const Index island = islands_.of(particle);
    steps_at_rest_[island] = 0;
    if (islands_.sleeps(island)) choose_group_of(island);
  }
  wake_chosen();
}

template <class Real>
void Sleepers<Real>::wake_chosen() {
  if (!any_chosen_) return;
  for (Index island = 0; island < islands_.size(); ++island) {
    if (!islands_.sleeps(island) || chosen_[group_[island]] == 0) continue;
    islands_.set(island, false);
    steps_at_rest_[island] = 0;
  }
  std::fill(chosen_.begin(), chosen_.end(), char{0});
  any_chosen_ = false;
}

template <class Real>
void Sleepers<Real>::wake_all() {
  for (Index island = 0; island < islands_.size(); ++island) islands_.set(island, false);
  std::fill(steps_at_rest_.begin(), steps_at_rest_.end(), 0u);
}

template <class Real>
std::vector<std::uint32_t> Sleepers<Real>::resting() const {
  std::vector<std::uint32_t> found = steps_at_rest_;
  for (Index island = 0; island < islands_.size(); ++island) {
    if (islands_.sleeps(island)) found[island] = asleep + group_[island];
  }
  return found;
}

template <class Real>
void Sleepers<Real>::restore(std::span<const std::uint32_t> resting, StateRing<Real>& states) {
  wake_all();
  for (Index island = 0; island < resting.size(); ++island) {
    if (resting[island] < asleep) {
      steps_at_rest_[island] = std::min(resting[island], enough_);
      continue;
    }
    islands_.set(island, true);
    group_[island] = std::min(Index(resting[island] - asleep), island);
    around_[island] = around(island, states.now());
    stop(island, states);
  }
}

template <class Real>
std::size_t Sleepers<Real>::particles_asleep() const {
  std::size_t found = 0;
  for (Index island = 0; island < islands_.size(); ++island)
    found += islands_.sleeps(island) ? members_.of(island).size() : 0;
  return found;
}

template <class Real>
std::size_t Sleepers<Real>::bytes() const {
  return members_.bytes() + pieces_.capacity() * sizeof(Piece) +
         islands_.size() * (sizeof(std::uint32_t) + sizeof(Index) + sizeof(AxisBox) + 3);
}

template class Sleepers<float>;
template class Sleepers<double>;

}  // namespace hooke
