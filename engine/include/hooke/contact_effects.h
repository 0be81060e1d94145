#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include <hooke/index.h>
#include <hooke/keyframe.h>
#include <hooke/shapes.h>
#include <hooke/vec3.h>

/// The effects that keep things apart, hold them together, or let them tear. See effects.h for the others.

namespace hooke {

/// A solid that particles do not get into. What a step would bring nearer to its surface than `thickness` is
/// put back on it, along the normal. Of the velocity against the surface, what goes into it is turned back,
/// times `restitution`; what goes along it loses at most `friction` times what the normal one was changed by
/// (Coulomb's law, for the step: so what may stick does not creep). A particle that flies through within a
/// step is stopped where it comes in. All takes no shorter steps; energy is only lost where the solid rests.
///
/// It is particles that are kept out: between those of a cloth an edge or a corner of a solid may come
/// through, which a thickness hides.
///
/// With a stiffness it is a penalty instead, a one-sided spring and damper: with d the depth below the
/// thickness, n the normal, u and w the normal and tangential velocity against the solid,
///   F_n = max(0, k d - c u),  F_t = -min(c |w|, mu F_n) w / |w|,
/// which does not stop what is fast, and lets creep what should stick, but is a force: methods that solve
/// equations solve for it, and steps are divided for its stiffness.
struct Collider {
  ColliderShape shape = PlaneShape{};
  double thickness = 0.0;    ///< [m], >= 0
  double friction = 0.0;     ///< mu [1], >= 0
  double restitution = 0.0;  ///< e [1], from 0 to 1; 0 with a stiffness
  double stiffness = 0.0;    ///< k [N/m] for each particle, >= 0; 0: particles are put back on the surface
  double damping = 0.0;      ///< c [N s/m] for each particle, >= 0; 0 without a stiffness
  Vec3 axis{0.0, 1.0, 0.0};  ///< that its path turns about; any length but zero
  /// Straight lines and even turns between; held before and after. Without one it stays, until the host moves
  /// it: see Simulation::move_frame().
  std::vector<RigidKeyframe> path = {};

  static constexpr std::string_view name = "collider";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("shape", self.shape);
    visit("thickness", self.thickness);
    visit("friction", self.friction);
    visit("restitution", self.restitution);
    visit("stiffness", self.stiffness);
    visit("damping", self.damping);
    visit("axis", self.axis);
    visit("path", self.path);
  }
};

/// Holds particles to a frame, where they are in it at the start of the scene. The frame stays, or follows
/// its path, or goes where the host puts it (Simulation::move_frame), which is told the force that the frame
/// carries for it (Simulation::carried_force). Methods that solve equations, and stages of others, see these
/// particles on the frame; the stitches and limits of a scene take them for immovable.
struct FrameAttachment {
  std::vector<Index> particles = {};
  Vec3 origin = Vec3::Zero();            ///< of the frame: what it turns about, and torques are about [m]
  Vec3 axis{0.0, 1.0, 0.0};              ///< that its path turns about; any length but zero
  std::vector<RigidKeyframe> path = {};  ///< straight lines and even turns between; held before and after

  static constexpr std::string_view name = "frame_attachment";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("particles", self.particles);
    visit("origin", self.origin);
    visit("axis", self.axis);
    visit("path", self.path);
  }
};

/// Sews pairs of particles together: the seam closes evenly over a time, and is closed then. Pairs that lead
/// from one to the next are one knot, however many particles it joins. After each step the particles of a
/// closed knot are put on their centre of mass, with the mean of their velocities by mass; those of one that
/// is closing are drawn together until its pairs are no further apart than they may be by then, but for the
/// last pairs of rings. Momentum is kept. A knot may hold one particle that is pinned, attached or scripted:
/// the others are drawn to it.
struct Stitch {
  std::vector<Index> first = {}, second = {};
  double closing_time = 0.0;  ///< [s], >= 0; 0: pairs are together at the start

  static constexpr std::string_view name = "stitch";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("first", self.first);
    visit("second", self.second);
    visit("closing_time", self.closing_time);
  }
};

/// Cloth that does not pass through cloth: corners and triangles, and edges and edges, of the scene's surface
/// are kept apart by `thickness`, measured between the surfaces in the middle of the cloth. What a step would
/// bring nearer is moved apart, the lighter more, pinned particles not at all; what approaches there loses
/// that speed, and what slides loses at most `friction` times it (Coulomb's law for the step: what may stick
/// does not creep). Momentum is kept and kinetic energy never gained. Takes no shorter steps. Colliders that
/// cloth lies on carry the layers above it.
///
/// Pairs that share a particle are left out. Pairs that are nearer than the thickness at the start are kept
/// as far apart as they are then: triangles may be smaller than the thickness. See docs/contact.md.
struct SelfCollision {
  double thickness = 1e-3;  ///< [m], > 0
  double friction = 0.0;    ///< mu [1], >= 0
  /// Follows particles on straight lines through the step, so that nothing fast passes between its ends. What
  /// sweeps do not keep from passing is moved as one piece then, with its mean velocity (impact zones).
  bool swept = true;
  std::uint64_t sweeps = 60;  ///< over the contacts of a step, at most, >= 1
  /// What crosses, at the start or by what sweeps could not keep, is drawn apart (Baraff, Witkin, Kass 2003),
  /// and is not held in where it is meanwhile. Costs a look for crossings in each step.
  bool untangle = false;
  std::vector<Index> triangles = {};  ///< of the scene; none: all of these

  static constexpr std::string_view name = "self_collision";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("thickness", self.thickness);
    visit("friction", self.friction);
    visit("swept", self.swept);
    visit("sweeps", self.sweeps);
    visit("untangle", self.untangle);
    visit("triangles", self.triangles);
  }
};

/// Grains: spheres around particles, that press on each other and rub (Cundall, Strack 1979). For two whose
/// centres are nearer than the sum of their radii by d, with n the unit vector from one to the other, and v
/// the velocity of the one against the other,
///   F_n = k d - c n.v,  F_t = -(k_t s + c_t v_t) as far as |F_t| <= mu max(0, F_n),
/// with s the way that they have slid along each other since they touched, as far as friction held it.
/// Spheres do not turn, and those that springs join do not touch.
///
/// Two of mass m hit each other for t = pi / sqrt(k / m* - (c / 2m*)^2), with m* = m / 2, and part with
/// exp(-pi z / sqrt(1 - z^2)) of their speed, z = c / (2 sqrt(k m*)): steps should be a twentieth of t.
struct ParticleContact {
  std::vector<double> radius = {};    ///< [m], > 0: one for all, or one for each of `particles`
  double stiffness = 1e3;             ///< k [N/m], >= 0
  double damping = 0.0;               ///< c [N s/m], >= 0
  double shear_stiffness = 0.0;       ///< k_t [N/m], >= 0; often 2/7 to 1 of k
  double shear_damping = 0.0;         ///< c_t [N s/m], >= 0
  double friction = 0.0;              ///< mu [1], >= 0
  std::vector<Index> particles = {};  ///< none: all of the scene

  static constexpr std::string_view name = "particle_contact";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("radius", self.radius);
    visit("stiffness", self.stiffness);
    visit("damping", self.damping);
    visit("shear_stiffness", self.shear_stiffness);
    visit("shear_damping", self.shear_damping);
    visit("friction", self.friction);
    visit("particles", self.particles);
  }
};

/// Springs that are strained too much, or pull too hard, tear what they are part of: one of the two particles
/// of each is split in two, across the spring, and what was joined to it is shared out between the two:
/// triangles and springs on either side stay whole, an edge of triangles on both sides becomes two springs,
/// and nothing is lost but springs that would bridge the tear. Where neither end has anything on its other
/// side, the spring itself is lost, or stays where it is an edge of a triangle. New particles have the next
/// numbers, and the scene's triangles are those of Simulation::triangles() then. Mass and momentum are kept.
/// Looked at after each step, not after its substeps. See docs/tearing.md.
struct Tearing {
  double strain = 0.0;              ///< (l - l0) / l0 [1] above which a spring tears; 0: strain tears none
  double force = 0.0;               ///< k (l - l0) [N] above which a spring tears; 0: force tears none
  std::vector<Index> springs = {};  ///< of the scene, with rest lengths > 0; none: all of these

  static constexpr std::string_view name = "tearing";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("strain", self.strain);
    visit("force", self.force);
    visit("springs", self.springs);
  }
};

/// What has come to rest is not simulated until something changes for it. An island is what springs,
/// triangles, stitches, tethers and closed surfaces join; it sleeps when each of its particles has been
/// slower than `speed` for `time`, and so have all islands that it touches. Its velocities are zero then, and
/// that is all that changes: m v^2 / 2 a particle is lost. It wakes, as it is, when it is touched by what is
/// awake, or by a solid that moves, when a path, a frame or an effect that changes with time gets to work on
/// it, and when the host pushes, moves or wakes it (Simulation::wake). While a custom effect is named nothing
/// sleeps.
struct Sleep {
  double speed = 1e-3;  ///< [m/s], > 0
  double time = 0.5;    ///< [s], >= 0

  static constexpr std::string_view name = "sleep";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("speed", self.speed);
    visit("time", self.time);
  }
};

}  // namespace hooke
