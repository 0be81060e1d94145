#include "solve/coloured_groups.h"

#include <algorithm>

#include "effects/named_springs.h"
#include "model/slots.h"
#include "model/spring_colours.h"

namespace hooke {
namespace {

/// Groups that one thread takes at a time: some microseconds of work.
constexpr std::size_t groups_at_once = 32;

SpringColours colours_of(const Scene& scene, const Order& engine) {
  const Springs& springs = scene.springs;
  const std::vector<bool> cables = cable_mask(scene);
  if (cables.empty()) return colour_springs(springs, engine);
  std::vector<Index> chosen;
  for (std::size_t s = 0; s < springs.size(); ++s) {
    if (!cables[s] && (springs.stiffness[s] > 0.0 || springs.damping_of(s) > 0.0)) chosen.push_back(Index(s));
  }
  return colour_springs(springs, engine, std::move(chosen));
}

}  // namespace

template <class Real>
ColouredGroups<Real>::ColouredGroups(const Scene& scene, const Order& engine) {
  const Springs& springs = scene.springs;
  const SpringColours colours = colours_of(scene, engine);
  for (std::size_t colour = 0; colour < colours.colours(); ++colour) {
    for (std::size_t s = colours.begin[colour]; s < colours.begin[colour + 1]; ++s)
      add(springs, engine, colours.springs[s]);
    fill_group(engine);
    colour_begin_.push_back(size());
  }
}

template <class Real>
void ColouredGroups<Real>::add(const Springs& springs, const Order& engine, Index spring) {
  const auto offset = [&](Index end) { return std::int32_t(engine.engine(end)) * offsets_of_particle<Real>; };
  groups_.first.push_back(offset(springs.first[spring]));
  groups_.second.push_back(offset(springs.second[spring]));
  groups_.stiffness.push_back(Real(springs.stiffness[spring]));
  groups_.rest_length.push_back(Real(springs.rest_length[spring]));
  if (!springs.damping.empty()) groups_.damping.push_back(Real(springs.damping[spring]));
}

/// Empty places lead to one more particle, behind the last.
template <class Real>
void ColouredGroups<Real>::fill_group(const Order& engine) {
  while (groups_.first.size() % block_size != 0) {
    const std::int32_t behind = std::int32_t(engine.size()) * offsets_of_particle<Real>;
    groups_.first.push_back(behind);
    groups_.second.push_back(behind);
    groups_.stiffness.push_back(Real(0));
    groups_.rest_length.push_back(Real(0));
    if (!groups_.damping.empty()) groups_.damping.push_back(Real(0));
  }
}

template <class Real>
void ColouredGroups<Real>::follow_islands(const Model<Real>& model) {
  if (!model.islands_changed(islands_seen_)) return;
  const auto sleeps = [&](std::int32_t offset) {
    const std::size_t particle = std::size_t(offset / offsets_of_particle<Real>);
    return particle == model.particles() || model.sleeps(particle);
  };
  awake_.choose(size(), [&](std::size_t group) {
    const auto first = groups_.first.begin() + std::ptrdiff_t(group * block_size);
    return !std::all_of(first, first + block_size, sleeps);
  });
}

template <class Real>
void ColouredGroups<Real>::project(Real h, const ProjectedParticles<Real>& particles, Real* multipliers,
                                   Executor& executor) const {
  for (std::size_t colour = 0; colour < colours(); ++colour) {
    const std::size_t first = colour_begin_[colour];
    executor.parallel_for(
        colour_begin_[colour + 1] - first, groups_at_once, [&](std::size_t begin, std::size_t end) {
          awake_.for_each_run(first + begin, first + end, [&](std::size_t b, std::size_t e) {
            project_springs(groups_, b, e, h, particles, multipliers);
          });
        });
  }
}

template class ColouredGroups<float>;
template class ColouredGroups<double>;

}  // namespace hooke
