#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <hooke/contact_effects.h>
#include <hooke/fields.h>
#include <hooke/index.h>
#include <hooke/keyframe.h>
#include <hooke/vec3.h>

/// The effects that a scene can name, one struct of plain data each. An effect that a scene does not name is
/// not in the plan: no memory, no pass, no branch.
///
/// Every struct carries its `name` and a list of its `fields`: scene files, their schema and user interfaces
/// read this one list, so the code and the file say the same words.

namespace hooke {

/// Uniform gravity: F = m g on every particle.
struct Gravity {
  Vec3 acceleration{0.0, -9.81, 0.0};  ///< g [m/s^2]

  static constexpr std::string_view name = "gravity";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("acceleration", self.acceleration);
  }
};

/// Linear viscous drag of every particle against still air: F = -c v (Provot 1995).
struct Drag {
  double coefficient = 0.0;  ///< c [N s/m], >= 0

  static constexpr std::string_view name = "drag";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("coefficient", self.coefficient);
  }
};

/// A force that depends on place and time on every particle: F = f(x, t), or m f(x, t) where `per_mass`.
struct Field {
  FieldShape shape = UniformField{};  ///< [N], or [m/s^2] where `per_mass`
  Envelope envelope = SteadyEnvelope{};
  bool per_mass = false;

  static constexpr std::string_view name = "field";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("shape", self.shape);
    visit("envelope", self.envelope);
    visit("per_mass", self.per_mass);
  }
};

/// The simplest wind: every particle is dragged along by the air, F = c (u(x, t) - v).
struct ParticleWind {
  double coefficient = 0.0;              ///< c [N s/m], >= 0
  FieldShape velocity = UniformField{};  ///< u of the air [m/s]
  Envelope envelope = SteadyEnvelope{};  ///< of it

  static constexpr std::string_view name = "particle_wind";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("coefficient", self.coefficient);
    visit("velocity", self.velocity);
    visit("envelope", self.envelope);
  }
};

/// Wind on the scene's triangles. With w the velocity of the air against a triangle of area A, and n its unit
/// normal on the side with n.w >= 0,
///   F = 1/2 rho A (n.w) (drag w + lift (|w| n - (n.w) w / |w|)),
/// a third of it on each corner. The triangle is as it lies now, its velocity and the air's are the means of
/// those at its corners; a triangle without an area has no force. It depends on positions and velocities
/// alone, and so not on the step.
///
/// The limit on the step counts the wind at its strongest, as far as that is known (of a callback: as it is
/// at the start), and the scene's fastest particle at the start; cloth that moves faster against the air is
/// held more stiffly than that limit says.
struct Wind {
  FieldShape velocity = UniformField{};  ///< of the air [m/s]
  Envelope envelope = SteadyEnvelope{};  ///< of it
  double air_density = 1.2;              ///< rho [kg/m^3], >= 0
  double drag = 1.0;                     ///< coefficient [1], >= 0
  double lift = 0.2;                     ///< coefficient [1], >= 0

  static constexpr std::string_view name = "wind";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("velocity", self.velocity);
    visit("envelope", self.envelope);
    visit("air_density", self.air_density);
    visit("drag", self.drag);
    visit("lift", self.lift);
  }
};

/// The same force, that follows straight lines between keyframes, on each of some particles; none before the
/// first keyframe and after the last. Times must increase.
struct ForceScript {
  std::vector<Index> particles = {};
  std::vector<ForceKeyframe> keyframes = {};

  static constexpr std::string_view name = "force_script";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("particles", self.particles);
    visit("keyframes", self.keyframes);
  }
};

/// A plane that pushes back on what sinks below it, as a one-sided spring and damper (penalty):
/// with depth d = height - n.x > 0, F = max(0, k d - c n.v) n. It never pulls.
struct GroundPlane {
  Vec3 normal{0.0, 1.0, 0.0};  ///< n, points out of the ground; any length but zero
  double height = 0.0;         ///< [m] along the unit normal
  double stiffness = 1e3;      ///< k [N/m] for each particle, >= 0
  double damping = 0.0;        ///< c [N s/m] for each particle, >= 0

  static constexpr std::string_view name = "ground_plane";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("normal", self.normal);
    visit("height", self.height);
    visit("stiffness", self.stiffness);
    visit("damping", self.damping);
  }
};

/// Bending at the edges that two of the scene's triangles share, for sheets of any mesh (Bridson, Marino,
/// Fedkiw 2003; Grinspun, Hirani, Desbrun, Schroeder 2003):
///   E = sum over edges of D/2 |e|^2 / (A1 + A2) (theta - theta0)^2
/// with theta the angle between the normals, and theta - theta0 from -pi to pi; |e| and the areas are those
/// of the start. An edge of more than two triangles is a hinge for each pair. Converges to a sheet of bending
/// stiffness D under refinement where the triangles are nearly equilateral; on others it is stiffer in some
/// directions than in others (docs/bending.md). A triangle that has no area at a time, but for rounding, has
/// no normal, and its hinges no force then; two that have none at the start have no hinge.
struct HingeBending {
  double stiffness = 0.0;             ///< D [N m], >= 0
  double damping = 0.0;               ///< of the rate of theta, over the stiffness [s], >= 0
  bool flat_at_rest = true;           ///< theta0 = 0; else it is that of the start
  std::vector<Index> triangles = {};  ///< of the scene; none: all of these

  static constexpr std::string_view name = "hinge_bending";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("stiffness", self.stiffness);
    visit("damping", self.damping);
    visit("flat_at_rest", self.flat_at_rest);
    visit("triangles", self.triangles);
  }
};

/// Bending along lines of evenly spaced particles, in grids and ropes: for three behind one another
///   E = k/2 |x_first - 2 x_middle + x_last|^2.
/// k = D b / a^3 for a sheet of bending stiffness D [N m] whose lines are b apart and whose particles a; EI /
/// a^3 for a rope. See bending_of().
struct LaplacianBending {
  std::vector<Index> first = {}, middle = {}, last = {};
  std::vector<double> stiffness = {};  ///< k [N/m], >= 0

  static constexpr std::string_view name = "laplacian_bending";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("first", self.first);
    visit("middle", self.middle);
    visit("last", self.last);
    visit("stiffness", self.stiffness);
  }
};

/// An elastic sheet of triangles of any shape: tensile biquadratic springs along their edges and the
/// couplings of these (Delingette 2008), which are the finite elements of St. Venant and Kirchhoff. With l an
/// edge's length, L that of the start, a the angle opposite and A the area of the start, of each triangle
///   E = sum over edges of k_i/4 (l_i^2 - L_i^2)^2 + sum over pairs of c_ij/2 (l_i^2 - L_i^2)(l_j^2 - L_j^2),
///   k_i = (2 p cot^2 a_i + m) / 16A, c_ij = (2 p cot a_i cot a_j - m) / 16A,
/// where p = E / (1 - nu^2), m = E / (1 + nu). Triangles are at rest as they lie at the start.
struct TensileTriangles {
  double modulus = 0.0;               ///< E of the sheet: Young's modulus times thickness [N/m], >= 0
  double poisson_ratio = 0.3;         ///< nu [1], > -1 and < 1
  double damping = 0.0;               ///< of the rate of strain, over the stiffness [s], >= 0
  std::vector<Index> triangles = {};  ///< of the scene, with an area at the start; none: all of these

  static constexpr std::string_view name = "tensile_triangles";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("modulus", self.modulus);
    visit("poisson_ratio", self.poisson_ratio);
    visit("damping", self.damping);
    visit("triangles", self.triangles);
  }
};

/// Springs that pull and never push. They are springs of the scene; while they are named here, the scene's
/// law for them holds only where they are longer than at rest: with k, c and l0 of the spring
///   T = max(0, k (l - l0) + c dl/dt) where l > l0, else 0.
struct Cables {
  std::vector<Index> springs = {};

  static constexpr std::string_view name = "cables";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("springs", self.springs);
  }
};

/// Springs that stiffen: to the scene's force k l0 s of a spring, s = (l - l0) / l0, is added
///   k l0 (quadratic |s| s + cubic s^3),
/// whose energy is k l0^2 (quadratic |s|^3 / 3 + cubic s^4 / 4). Steps are judged for strains up to a
/// quarter, or those of the start where these are larger.
struct StiffeningSprings {
  double quadratic = 0.0;           ///< [1], >= 0
  double cubic = 0.0;               ///< [1], >= 0
  std::vector<Index> springs = {};  ///< of the scene, with rest lengths > 0; none: all of these

  static constexpr std::string_view name = "stiffening_springs";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("quadratic", self.quadratic);
    visit("cubic", self.cubic);
    visit("springs", self.springs);
  }
};

/// Springs whose rest length creeps where they are strained beyond a yield strain (Bingham):
///   d(l0)/dt = rate (|e| - yield) sign(e) l0(0)
/// with e = (l - l0(t)) / l0(0) the elastic strain, up to a largest change. A spring that is held at one
/// length relaxes as exp(-rate t); one under a constant force creeps evenly.
struct Plasticity {
  double yield = 0.1;               ///< strain [1], >= 0
  double rate = 0.0;                ///< [1/s], >= 0
  double largest = 0.5;             ///< of |l0(t) - l0(0)| / l0(0) [1], >= 0 and < 1
  std::vector<Index> springs = {};  ///< of the scene, with rest lengths > 0; none: all of these

  static constexpr std::string_view name = "plasticity";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("yield", self.yield);
    visit("rate", self.rate);
    visit("largest", self.largest);
    visit("springs", self.springs);
  }
};

/// A limit on the strain of springs, kept after each step (Provot 1995, "Deformation constraints in a
/// mass-spring model to describe rigid cloth behavior"): the ends of what is too long are moved back along
/// the spring, the lighter end more, pinned ones not at all, sweep after sweep until no spring exceeds the
/// limit by more than 1e-6 and what positions are rounded to. What is moved gets up to 0.001 shorter than the
/// limit, and more where sweeps overshoot, so that few suffice.
///
/// Momentum is kept: velocities change by the move over the step, or by the share of it after which there is
/// the least kinetic energy. So a limit never adds kinetic energy, but where pins move: there the whole
/// change is made if the step began within the limit.
struct StrainLimit {
  double limit = 0.1;               ///< of (l - l0) / l0 [1], >= 0
  std::uint64_t sweeps = 1000;      ///< at most, >= 1; a report tells where these did not suffice
  std::vector<Index> springs = {};  ///< of the scene, with rest lengths > 0; none: all of these

  static constexpr std::string_view name = "strain_limit";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("limit", self.limit);
    visit("sweeps", self.sweeps);
    visit("springs", self.springs);
  }
};

/// Long-range attachments (Kim, Chentanez, Mueller 2012): no particle gets further from the pin that is
/// nearest to it along the scene's springs at rest than the way there, times 1 + slack. Kept after each step:
/// what is further is put back on a straight line, and what moves away from its pin there loses that speed.
struct Tethers {
  double slack = 0.0;                 ///< [1], >= 0
  std::vector<Index> particles = {};  ///< that are held; none: all that springs join to a pin

  static constexpr std::string_view name = "tethers";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("slack", self.slack);
    visit("particles", self.particles);
  }
};

/// Moves particles along a path while the path lasts, from its first keyframe to its last, and lets go of
/// them then, with the velocity that they have on it. Forces on them do nothing meanwhile. A particle that is
/// to be held all the time is better pinned, with or without a path.
struct MotionScript {
  std::vector<Index> particles = {};
  std::vector<Keyframe> path = {};  ///< displacements from where a particle is in the scene, as of pins

  static constexpr std::string_view name = "motion_script";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("particles", self.particles);
    visit("path", self.path);
  }
};

/// Gas inside a closed surface of the scene's triangles: its pressure over that outside is
///   p = (ambient + overpressure) (V0 / V)^exponent - ambient
/// with V the volume, V0 that of the start.
struct Pressure {
  double overpressure = 0.0;  ///< at the start [Pa]
  double ambient = 101325.0;  ///< [Pa], >= 0
  double exponent = 1.0;      ///< [1], >= 0: 1 at one temperature, 1.4 for air without exchange of heat
  std::vector<Index> triangles = {};  ///< of the scene, with corners anticlockwise from outside; none: all

  static constexpr std::string_view name = "pressure";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("overpressure", self.overpressure);
    visit("ambient", self.ambient);
    visit("exponent", self.exponent);
    visit("triangles", self.triangles);
  }
};

/// A body that resists changes of the volume inside a closed surface of the scene's triangles:
/// E = bulk_modulus / 2 (V - V0)^2 / V0.
struct Volume {
  double bulk_modulus = 0.0;          ///< [Pa], >= 0
  double ratio = 1.0;                 ///< V0 over the volume of the start [1], > 0
  std::vector<Index> triangles = {};  ///< of the scene, with corners anticlockwise from outside; none: all

  static constexpr std::string_view name = "volume";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("bulk_modulus", self.bulk_modulus);
    visit("ratio", self.ratio);
    visit("triangles", self.triangles);
  }
};

/// What a user's own effect sees: some particles, all spans of one length. Forces are to be added to.
struct ParticleBatch {
  double time;                                  ///< [s]
  std::span<const Index> particle;              ///< the user's numbers
  std::span<const double> x, y, z, vx, vy, vz;  ///< [m], [m/s]
  std::span<const double> mass;                 ///< [kg]; infinite where pinned
  std::span<double> fx, fy, fz;                 ///< [N]
};

/// An effect of the user's own: forces on particles from their positions and velocities. It cannot be written
/// in a scene file.
struct CustomEffect {
  std::string title = "custom";  ///< as the plan shows it
  /// Parallel: gets batches of at most 128 particles, in any order, on several threads at once, so it must
  /// not change shared data. Else it is called once for each evaluation of forces, with all particles in the
  /// user's order.
  std::function<void(const ParticleBatch&)> add_forces = nullptr;
  bool parallel = true;

  static constexpr std::string_view name = "custom";
  static constexpr bool in_files = false;
  template <class Self, class Visit>
  static void fields(Self&, Visit&&) {}
};

using Effect = std::variant<Gravity, Drag, Field, ParticleWind, Wind, ForceScript, GroundPlane, HingeBending,
                            LaplacianBending, TensileTriangles, Cables, StiffeningSprings, Plasticity,
                            Pressure, Volume, CustomEffect, StrainLimit, Tethers, MotionScript, Collider,
                            FrameAttachment, Stitch, SelfCollision, ParticleContact, Tearing, Sleep>;

}  // namespace hooke
