#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <hooke/clock.h>
#include <hooke/executor.h>
#include <hooke/methods.h>
#include <hooke/pair_memory.h>
#include <hooke/report.h>
#include <hooke/rigid_pose.h>
#include <hooke/scene.h>
#include <hooke/stability.h>

namespace hooke {

/// How spring forces are summed. The three give the same answer up to round-off.
enum class Accumulation {
  gather,    ///< each particle sums its own springs in a fixed order: same bits on any number of threads; the
             ///< default
  coloured,  ///< batches of springs; those that share no particle at once, one colour after the other: same
             ///< bits on any number of threads
  atomic,    ///< all batches at once, with atomic adds where they share particles: not reproducible
};

inline constexpr std::array accumulations{Accumulation::gather, Accumulation::coloured, Accumulation::atomic};

std::string_view to_string(Accumulation accumulation);

/// Whether the method can run on forces that are summed so: methods that solve equations gather only.
constexpr bool can_accumulate(const Method& method, Accumulation accumulation) {
  return !solves_equations(method) || accumulation == Accumulation::gather;
}

/// What becomes of a step that is longer than the method surely bears (see largest_stable_step()).
enum class UnstableStep {
  divide,  ///< it is taken in equal substeps of at most 0.9 of what the method bears, where 100,000 suffice,
           ///< as is one above 0.9 of that: the default
  refuse,  ///< it is a fault of the settings
  take,    ///< it is taken as it is: for those who know the scene better than the bound does
};

inline constexpr std::array unstable_steps{UnstableStep::divide, UnstableStep::refuse, UnstableStep::take};

std::string_view to_string(UnstableStep choice);

/// What becomes of a run of fixed explicit steps that goes wrong: energy grows beyond what was put in, or a
/// value is not finite. See docs/stability.md.
enum class OnTrouble {
  stop,   ///< the last good state is restored, and the report says why
  halve,  ///< likewise, and the run goes on with steps in twice as many parts, up to ten times; then it stops
  tell,   ///< the report says so and the run goes on; a value that is not finite stops it
  ignore,  ///< energy is not watched: nothing is measured or kept; a value that is not finite stops it
};

inline constexpr std::array troubles{OnTrouble::stop, OnTrouble::halve, OnTrouble::tell, OnTrouble::ignore};

std::string_view to_string(OnTrouble choice);

/// How a scene is simulated.
struct Settings {
  Method method = SymplecticEuler{};
  double step = 1.0 / 60.0;  ///< [s], > 0; a method with error control takes shorter ones inside
  UnstableStep unstable_step = UnstableStep::divide;
  /// None: stop; but who takes unstable steps as they are has nothing watched, nor has a scene of more than
  /// 500,000 particles, where the memory of one more state counts.
  std::optional<OnTrouble> on_trouble = {};
  /// Asked on trouble, where given, with the report of it; its answer takes the place of `on_trouble`.
  std::function<OnTrouble(const Report&)> decide_on_trouble = {};
  Accumulation accumulation = Accumulation::gather;
  unsigned threads = 0;                     ///< at most this many; 0: as many as the machine has
  std::uint64_t max_steps_per_advance = 8;  ///< cap of one advance(), >= 1
  std::shared_ptr<Executor> executor =
      {};  ///< the host's threads; none: oneTBB's. Then `threads` is not used.
};

/// Faults of settings and scene together.
std::vector<Fault> validate(const Scene& scene, const Settings& settings);

/// Positions and velocities in the engine's order, as arrays of particle_count() values. Valid until the next
/// call that changes the simulation.
template <class Real>
struct StateView {
  std::span<const Real> x, y, z;     ///< [m]
  std::span<const Real> vx, vy, vz;  ///< [m/s]
};

/// What a method carries from one step to the next beside the state. It is of use only with the positions and
/// velocities that it was taken with: where those have been changed, or this is empty, a restored run begins
/// afresh from them.
template <class Real>
struct MethodMemory {
  std::uint64_t state = 0;       ///< a hash of these positions and velocities
  std::vector<Real> velocities;  ///< like a snapshot's, but without the kick that is pending; empty: none is
  double pending_kick = 0.0;     ///< [s] of acceleration that these velocities lack
  double next_step = 0.0;        ///< [s] that error control will try next; 0: it starts afresh
  double last_error = 1.0;       ///< that it found last
  std::uint64_t substeps = 0;    ///< that steps were taken in, where they were halved on trouble; else 0
  /// Like a snapshot's, of the state one step before, by a method that reads two; empty: it starts afresh.
  std::vector<Real> positions_before, velocities_before;
};

/// A spring beside a tear: until it has relaxed, Tearing lets it get this long.
struct RelaxingSpring {
  Index spring = 0;     ///< of the torn scene
  double length = 0.0;  ///< [m]

  bool operator==(const RelaxingSpring&) const = default;
};

/// A copy of everything that changes while a simulation runs. Restores only into simulations of the same
/// scene, torn or not.
template <class Real>
struct Snapshot {
  std::vector<Real> positions;   ///< x, y, z of each particle in the user's numbering [m]
  std::vector<Real> velocities;  ///< likewise [m/s]
  double time = 0.0;             ///< [s]
  std::uint64_t step = 0;
  double remainder = 0.0;  ///< [s] of the clock
  MethodMemory<Real> method;
  std::vector<Real> effects;  ///< what effects remember, such as how far springs have yielded; mostly nothing
  /// What effects remember of pairs of particles that come and go; mostly nothing. One list for each effect
  /// that does, in their order in the scene.
  std::vector<std::vector<PairMemory<Real>>> pairs;
  /// The scene as it has torn; null where it has not.
  std::shared_ptr<const Scene> torn;
  std::vector<Index> torn_from;          ///< Simulation::origin() of each particle that tearing has added
  std::vector<RelaxingSpring> relaxing;  ///< in ascending order
  /// Of a scene that names Sleep, for each island in the order of their lowest particles: the steps in a row
  /// in which it was at rest; the largest number where it sleeps. Empty: all have just woken.
  std::vector<std::uint32_t> resting;
  /// Of the frames that the host may move, in the order of their effects; empty where it never moved one. A
  /// pose that was given for the next step is not in it.
  std::vector<RigidPose> frames;
};

/// A scene, compiled and running. Real is float or double.
template <class Real = float>
class Simulation {
 public:
  /// Compiles `scene`; it is not needed afterwards. Throws SceneError with every fault, std::length_error for
  /// more than 2^29 particles with springs.
  explicit Simulation(const Scene& scene, Settings settings = {});
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  /// Takes `count` steps, fewer if one goes bad: then the report says which and why, and the last good state
  /// stays.
  Report step(std::uint64_t count = 1);

  /// Takes the fixed steps that fit into `frame_seconds` [s] of wall-clock time (see Clock). Throws
  /// std::invalid_argument for a time that is negative or not finite.
  Report advance(double frame_seconds);

  double time() const;          ///< [s] of the newest state
  std::uint64_t steps() const;  ///< good steps since the start
  std::size_t particle_count() const;
  std::size_t spring_count() const;
  unsigned threads() const;  ///< that the executor may use
  const Settings& settings() const;

  StateView<Real> state() const;
  /// For each of the user's particles, its place in state().
  Index engine_index(Index particle) const;

  /// The triangles of a scene that names Tearing, as they are now, in the user's numbering; empty of others,
  /// whose triangles stay as they are in the scene. Valid until the next call that changes the simulation.
  std::span<const Triangle> triangles() const;
  /// The particle of the scene that this one is, or has been split from by Tearing. Throws std::out_of_range
  /// where there is no such particle.
  Index origin(Index particle) const;

  /// Writes x, y, z of each particle [m], in the user's numbering: the first at `first`, each `stride_bytes`
  /// after the one before, as a vertex buffer wants it. `interpolation` goes from the previous state (0) to
  /// the newest (1).
  void copy_positions(float* first, std::size_t stride_bytes, double interpolation = 1.0) const;
  void copy_positions(double* first, std::size_t stride_bytes, double interpolation = 1.0) const;
  /// Likewise the newest velocities [m/s].
  void copy_velocities(float* first, std::size_t stride_bytes) const;
  void copy_velocities(double* first, std::size_t stride_bytes) const;

  /// Changes the velocity of a particle by `impulse` [N s] over its mass, at once; one that is pinned stays
  /// as it is. Costs an evaluation of forces where reading velocities does (see Verlet). Throws
  /// std::out_of_range where there is no such particle and std::invalid_argument where the impulse, or the
  /// velocity that it would give, is not finite; then nothing changes.
  void apply_impulse(Index particle, const Vec3& impulse);

  /// The frame of an effect of the scene (Collider, FrameAttachment), by its number, will have this pose at
  /// the end of the next step, against its pose in the scene: the frame goes there evenly, and stays there in
  /// the steps after it. What it meets or holds gets its velocity, (pose after - pose before) / step. Throws
  /// std::out_of_range where there is no such effect, std::invalid_argument where it has no frame or a path,
  /// and for a pose that is not finite or a rotation that is not of unit length; then nothing changes.
  void move_frame(std::size_t effect, const RigidPose& pose);

  /// What the frame of a FrameAttachment had to carry on the mean of the last call of step() or advance():
  /// the forces on its particles, less what moved these with it. The momentum that particles lose to the
  /// frame is this times the time, to round-off; by methods that solve equations to what these leave
  /// unsolved. By methods that leave a kick pending (Verlet, BlanesMoan) momentum is that without it. What a
  /// StrainLimit and a Stitch pull with is in it. The torque is about the origin of the frame, with forces
  /// where particles are at the start of each step. Zero before the first step. Throws std::out_of_range
  /// where there is no such effect, std::invalid_argument where it is no attachment.
  FrameLoad carried_force(std::size_t effect) const;

  /// The force that acts now on the particles of a FrameAttachment, without the inertia of these: a body that
  /// takes it should add their masses to its own, and moves as one with them. Costs an evaluation of forces.
  /// Throws like carried_force().
  FrameLoad pull_on_frame(std::size_t effect) const;

  /// The forces [N] with which the pairs of a Stitch hold their `first` particles, on the mean of the last
  /// call of step() or advance(); `second` is held by the opposite. Of pairs that close a ring the last has
  /// none. Throws like carried_force().
  std::vector<Vec3> stitch_forces(std::size_t effect) const;

  /// Moves everything, or some particles, elsewhere without a shock: positions are turned about the world's
  /// origin and displaced, velocities turned, in the state before too; nothing gets a velocity from it. The
  /// run goes on as one that starts there. Frames of attachments go with their particles, which must all be
  /// named; colliders stay. Throws std::out_of_range where there is no such particle, std::invalid_argument
  /// for one that is named twice or follows a path, a pose that is not finite or a rotation that is not of
  /// unit length, or what it would lead to is not finite; then nothing changes.
  void teleport(const RigidPose& transform);
  void teleport(std::span<const Index> particles, const RigidPose& transform);

  /// Whether the island of a particle sleeps, in a scene that names Sleep. Throws std::out_of_range where
  /// there is no such particle.
  bool is_asleep(Index particle) const;
  /// Wakes the island of a particle, which starts to count its time at rest anew. Throws like is_asleep().
  void wake(Index particle);

  Snapshot<Real> snapshot() const;
  /// Throws std::invalid_argument, and changes nothing, if the snapshot is of another number of particles, of
  /// a scene that cannot have come from this one by tearing, or not finite.
  void restore(const Snapshot<Real>& snapshot);

  const Plan& plan() const;
  Energy energy() const;  ///< of the newest state, summed in double in a fixed order
  Vec3 momentum() const;  ///< [kg m/s] of the particles that are not pinned
  /// Largest (l - l0) / l0 [1] of the springs with stiffness and l0 > 0 that are not cables; 0 of none.
  double max_strain() const;

  /// What is guaranteed of the scene, and the highest frequency in the newest state: some 50 products with
  /// the derivative of the forces, each of which takes about as long as energy(). Springs, ground planes and
  /// effects that join particles, such as bending, are counted; a Field is not.
  Stability stability() const;

  /// A hash of the bits of time, positions and velocities in the user's numbering: equal if and (nearly) only
  /// if they are.
  std::uint64_t state_hash() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

extern template class Simulation<float>;
extern template class Simulation<double>;

}  // namespace hooke
