#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <hooke/scene.h>

namespace hooke {

/// What went wrong in a step, as bits.
enum Flag : std::uint32_t {
  flag_none = 0,
  flag_not_finite = 1,     ///< a position or velocity became infinite or not a number; the step was not taken
  flag_steps_dropped = 2,  ///< a frame asked for more steps than the cap; time was dropped
  flag_step_too_small = 4,  ///< error control needs a shorter step than it may take; the step was not taken
  flag_not_converged = 8,   ///< a step was taken whose equations were not solved to the tolerance
  flag_energy_grew = 16,    ///< there was more energy than was put in: an explosion
  flag_restored = 32,       ///< the run was stopped on trouble, and the last good state restored
  flag_step_halved = 64,    ///< steps are taken in twice as many parts from the last good state on
  flag_oscillations_grow = 128,  ///< the method lets undamped oscillations grow at any step; not seen to yet
  flag_limit_not_met = 256,      ///< springs were longer than their strain limit allows after its last sweep
  flag_contacts_left = 512,      ///< cloth came too near to cloth, or through it, in spite of self_collision
};

/// Time that a sweep of the plan took, summed over the steps of one call.
struct SweepTime {
  std::string_view sweep;
  double seconds = 0.0;  ///< [s]
};

/// What one call of step() or advance() did.
struct Report {
  static constexpr Index none = ~Index{0};

  std::uint32_t flags = flag_none;
  std::uint64_t steps_taken = 0;        ///< good steps in this call
  std::uint64_t force_evaluations = 0;  ///< of all particles, in good steps and in those that led to them
  std::uint64_t rejected_steps = 0;     ///< that error control took again with a shorter step
  std::uint64_t solver_iterations = 0;  ///< of methods that solve equations, in all steps of this call
  std::uint64_t linear_iterations = 0;  ///< of the linear solver within those
  double residual = 0.0;       ///< largest change of positions in the last iteration of a step, RMS over the
                               ///< scene's size [1]
  std::uint64_t step = 0;      ///< number of the last step tried, counted from 1 since the start
  double time = 0.0;           ///< [s] of the newest good state
  double interpolation = 1.0;  ///< see Tick; 1 after step()
  double dropped_seconds = 0.0;  ///< [s] see Tick
  /// Lowest number, in the user's numbering, with a value that is not finite; or, where energy grew, of the
  /// particle with the most of it.
  Index first_bad_particle = none;
  /// On trouble the ends, in the user's numbering, of the spring that held the most energy; none of a scene
  /// without springs.
  std::array<Index, 2> strained_spring{none, none};
  double kinetic_energy = 0.0;           ///< where energy grew, of the state in which that was found [J]
  double energy_put_in = 0.0;            ///< and what all sources have put in, at most [J]
  std::uint64_t limit_sweeps = 0;        ///< the most that a strain limit needed in a step
  std::uint64_t springs_over_limit = 0;  ///< where a strain limit was not met, in the last such step
  double largest_strain = 0.0;           ///< of them [1]
  std::uint64_t contact_sweeps = 0;      ///< the most that self-collision needed in a step
  /// Where self-collision did not suffice, in the last such step: pairs nearer than half their thickness, or
  /// that pass through one another.
  std::uint64_t contacts_left = 0;
  std::uint64_t impact_zone_particles = 0;  ///< the most that self-collision moved as one piece in a step
  std::uint64_t crossings = 0;  ///< of an edge and a triangle, after the last step, where they are untangled
  std::uint64_t particles_split = 0;   ///< by tearing; so many are there more than before
  std::uint64_t particles_asleep = 0;  ///< after the last step, of a scene that names Sleep
  std::uint64_t steps_undone = 0;      ///< steps before this call that were taken back with the good state
  std::span<const SweepTime> sweeps;   ///< time of each sweep; valid until the next call on the simulation

  bool ok() const { return (flags & (flag_not_finite | flag_step_too_small | flag_restored)) == 0; }

  /// One sentence that says what happened and what to do; empty when nothing did.
  std::string message() const;
};

/// One stage of the plan. Stages with the same sweep are fused: they run on a block of particles while it is
/// in cache.
struct Stage {
  std::string name;
  std::string sweep;
  std::vector<std::string> reads, writes;
  std::size_t bytes = 0;  ///< that this stage alone makes the simulation hold
};

/// What a simulation runs each step, in order, and the memory that it holds.
struct Plan {
  std::vector<Stage> stages;
  std::size_t state_bytes = 0;  ///< positions and velocities: now, before, and being computed
  std::size_t model_bytes = 0;  ///< the maps between the user's numbering and the engine's
  std::string order;            ///< how particles are numbered inside, and why
  std::string springs;          ///< how springs are laid out; empty where there are none
  std::string tiles;            ///< how particles are cut into tiles, and how many steps run on one at once
  std::uint64_t substeps = 1;   ///< equal parts that each step is taken in, so that the method bears them

  std::size_t bytes() const;  ///< everything: state, model and stages
};

/// Energies of a state [J]. Pinned particles have no kinetic and no gravitational energy here.
struct Energy {
  double kinetic = 0.0;
  double elastic = 0.0;   ///< in springs
  double external = 0.0;  ///< of effects that have a potential: gravity, ground plane
  double total() const { return kinetic + elastic + external; }
};

}  // namespace hooke
