#include "effects/strain_sweeps.h"

#include "effects/named_springs.h"
#include "model/spring_colours.h"

namespace hooke {
namespace {

/// How far the ends of a spring that is too long are moved, times the way to where it is short enough: hung
/// sheets of 8 and 16 particles a side need two thirds and a third of the sweeps that they need with 1.
constexpr double over_relaxation = 1.8;

/// What is too long is made this much shorter than need be, times its rest length: sweeps then end within the
/// limit after a few, and not closer and closer beyond it.
constexpr double margin = 1e-3;

/// Springs that one thread takes at a time: some microseconds of work.
constexpr std::size_t springs_at_once = 256;

}  // namespace

StrainSweeps::StrainSweeps(const StrainLimit& limit, const Scene& scene, const Order& order)
    : most_sweeps_(limit.sweeps) {
  const Springs& all = scene.springs;
  SpringColours colours = colour_springs(all, order, chosen_springs(limit.springs, all));
  for (const Index s : colours.springs) {
    const double rest = all.rest_length[s];
    springs_.push_back(
        {order.engine(all.first[s]), order.engine(all.second[s]), rest, rest * (1.0 + limit.limit)});
  }
  colour_begin_ = std::move(colours.begin);
  sums_.resize((springs_.size() + springs_in_run - 1) / springs_in_run);
}

StrainExcess StrainSweeps::run(std::vector<Particle>& particles, std::uint64_t& sweeps, Vec3* pulled,
                               Executor& executor) {
  const auto position = [&](std::size_t i) { return particles[i].position; };
  StrainExcess left;
  for (sweeps = 0; sweeps < most_sweeps_;) {
    sweep(particles, pulled, executor);
    ++sweeps;
    left = excess<double>(position, executor);
    if (left.springs == 0) break;
  }
  return left;
}

void StrainSweeps::sweep(std::vector<Particle>& particles, Vec3* pulled, Executor& executor) {
  for (std::size_t colour = 0; colour < colours(); ++colour) {
    const std::size_t first = colour_begin_[colour];
    executor.parallel_for(colour_begin_[colour + 1] - first, springs_at_once,
                          [&](std::size_t begin, std::size_t end) {
                            for (std::size_t s = first + begin; s < first + end; ++s)
                              project(springs_[s], particles, pulled);
                          });
  }
}

void StrainSweeps::project(const Spring& spring, std::vector<Particle>& particles, Vec3* pulled) {
  Particle &a = particles[spring.first], &b = particles[spring.second];
  const double inverse_masses = a.inverse_mass + b.inverse_mass;
  const Vec3 apart = b.position - a.position;
  const double length = apart.norm(), excess = length - spring.longest;
  if (!(excess > 0.0) || inverse_masses == 0.0) return;
  const Vec3 pull = (over_relaxation * (excess + margin * spring.rest) / (inverse_masses * length)) * apart;
  a.position += a.inverse_mass * pull;
  b.position -= b.inverse_mass * pull;
  if (pulled == nullptr) return;
  if (a.inverse_mass == 0.0) pulled[spring.first] += pull;
  if (b.inverse_mass == 0.0) pulled[spring.second] -= pull;
}

}  // namespace hooke
