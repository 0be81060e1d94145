#include "effects/effect_list.h"

#include <algorithm>
#include <span>

#include "effects/effect_functions.h"

namespace hooke {
namespace {

/// sum += factor (part).
template <class Real>
void add_scaled(std::size_t lanes, Real factor, const StripBlocks<Real>& part, StripBlocks<Real>& sum) {
  for (std::size_t i = 0; i < lanes; ++i) {
    sum.xx[i] += factor * part.xx[i];
    sum.xy[i] += factor * part.xy[i];
    sum.xz[i] += factor * part.xz[i];
    sum.yy[i] += factor * part.yy[i];
    sum.yz[i] += factor * part.yz[i];
    sum.zz[i] += factor * part.zz[i];
  }
}

}  // namespace

template <class Real>
EffectList<Real>::EffectList(const Scene& scene, const Model<Real>& model) {
  for (const Effect& effect : scene.effects) {
    const EffectContext<Real> context{scene, model, effects_.size()};
    std::visit([&](const auto& data) { effects_.push_back(compile_effect<Real>(data, context)); }, effect);
  }
  forces_ = with(has_force);
  uncoupled_ = with(has_force, is_coupled);
  coupled_ = with(is_coupled);
  prepared_ = with(needs_preparation);
  uncoupled_derived_ = with(has_own_derivative, is_coupled);
  for (CompiledEffect<Real>* effect : coupled_) {
    if ((effect->parts() & has_own_derivative) != 0) coupled_derived_.push_back(effect);
  }
  strip_correctors_ = with(hooke::corrects_strips);
  correctors_ = with(corrects_everything);
  std::stable_sort(correctors_.begin(), correctors_.end(),
                   [](const auto* a, const auto* b) { return a->correction_rank() < b->correction_rank(); });
  carriers_ = with(carries_forces);
  pair_keepers_ = with(remembers_pairs);
  for (std::size_t list = 0; list < pair_keepers_.size(); ++list) pair_keepers_[list]->begin_pairs(list);
  share_out_memory();
}

template <class Real>
void EffectList<Real>::share_out_memory() {
  std::size_t size = 0;
  for (const EffectPointer<Real>& effect : effects_) size += effect->memory_size();
  initial_memory_.resize(size);
  std::size_t first = 0;
  for (const EffectPointer<Real>& effect : effects_) {
    const std::size_t own = effect->memory_size();
    if (own > 0) effect->begin_memory(first, std::span(initial_memory_).subspan(first, own));
    first += own;
  }
}

template <class Real>
auto EffectList<Real>::with(unsigned parts, unsigned without) const -> Some {
  Some some;
  for (const EffectPointer<Real>& effect : effects_) {
    const unsigned own = effect->parts();
    if ((own & parts) != 0 && (own & without) == 0) some.push_back(effect.get());
  }
  return some;
}

template <class Real>
bool EffectList<Real>::calls_user() const {
  return std::any_of(effects_.begin(), effects_.end(),
                     [](const auto& effect) { return effect->calls_user(); });
}

template <class Real>
bool EffectList<Real>::leads(Index particle) const {
  return std::any_of(effects_.begin(), effects_.end(),
                     [&](const auto& effect) { return effect->leads(particle); });
}

template <class Real>
std::size_t EffectList<Real>::reach() const {
  std::size_t most = 0;
  for (const CompiledEffect<Real>* effect : coupled_) most = std::max(most, effect->reach());
  return most;
}

template <class Real>
void EffectList<Real>::add_coupled_majorants(const Strip<Real>& strip, double time,
                                             const DerivativeWeights<Real>& weights,
                                             StripBlocks<Real>& blocks) const {
  for (const CompiledEffect<Real>* effect : coupled_derived_) {
    StripBlocks<Real> own{};
    effect->add_derivative(strip, time, weights, own);
    add_scaled(strip.lanes, Real(effect->coupling()), own, blocks);
  }
}

template <class Real>
double EffectList<Real>::energy(const Strip<Real>& strip) const {
  double sum = 0.0;
  for (const EffectPointer<Real>& effect : effects_) sum += effect->energy(strip);
  return sum;
}

template <class Real>
std::vector<Stage> EffectList<Real>::strip_stages() const {
  std::vector<Stage> stages;
  for (const EffectPointer<Real>& effect : effects_) {
    if ((effect->parts() & (has_force | hooke::corrects_strips)) != 0) stages.push_back(effect->stage());
  }
  return stages;
}

template <class Real>
std::vector<Stage> EffectList<Real>::preparation_stages() const {
  std::vector<Stage> stages;
  for (const CompiledEffect<Real>* effect : prepared_) stages.push_back(effect->preparation_stage());
  return stages;
}

template <class Real>
std::vector<Stage> EffectList<Real>::correction_stages() const {
  std::vector<Stage> stages;
  for (const CompiledEffect<Real>* effect : correctors_) {
    stages.push_back(effect->stage());
    if ((effect->parts() & (has_force | hooke::corrects_strips)) == 0) continue;
    stages.back().name += " (correction)";
    stages.back().bytes = 0;  // they are counted with the force
  }
  return stages;
}

bool does_unknown_work_in(const Scene& scene) {
  return std::any_of(scene.effects.begin(), scene.effects.end(), [](const Effect& effect) {
    // What crosses is drawn apart against its springs.
    const auto* collision = std::get_if<SelfCollision>(&effect);
    if (collision != nullptr && collision->untangle) return true;
    return std::visit([]<class Data>(const Data&) { return does_unknown_work<Data>; }, effect);
  });
}

template class EffectList<float>;
template class EffectList<double>;

}  // namespace hooke
