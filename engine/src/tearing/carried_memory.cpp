#include "tearing/carried_memory.h"

#include "effects/named_springs.h"

namespace hooke {
namespace {

/// Appends the creep of the springs as they are now.
template <class Real>
void carry_creep(const Real* creep, const Plasticity& before, const Plasticity& now,
                 const Scene& scene_before, const TornScene& torn, std::vector<Real>& carried) {
  std::vector<Real> of_spring(scene_before.springs.size(), Real(0));
  for (const Index s : creeping_springs(before, scene_before.springs)) of_spring[s] = *creep++;
  for (const Index s : creeping_springs(now, torn.scene.springs))
    carried.push_back(of_spring[torn.spring_from[s]]);
}

}  // namespace

template <class Real>
std::vector<Real> carried_memory(const std::vector<Real>& memory, const EffectList<Real>& effects,
                                 const Scene& before, const TornScene& torn) {
  std::vector<Real> carried;
  auto own = memory.begin();
  for (std::size_t i = 0; i < effects.size(); ++i) {
    const auto end = own + std::ptrdiff_t(effects[i].memory_size());
    const auto* const plasticity = std::get_if<Plasticity>(&before.effects[i]);
    const auto* const now = std::get_if<Plasticity>(&torn.scene.effects[i]);
    if (plasticity == nullptr) {
      carried.insert(carried.end(), own, end);
    } else if (now != nullptr) {
      carry_creep(memory.data() + (own - memory.begin()), *plasticity, *now, before, torn, carried);
    }
    own = end;
  }
  return carried;
}

template std::vector<float> carried_memory(const std::vector<float>&, const EffectList<float>&, const Scene&,
                                           const TornScene&);
template std::vector<double> carried_memory(const std::vector<double>&, const EffectList<double>&,
                                            const Scene&, const TornScene&);

}  // namespace hooke
