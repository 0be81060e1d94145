#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <hooke/effects.h>
#include <hooke/index.h>
#include <hooke/keyframe.h>
#include <hooke/vec3.h>

/// What a user says: particles, springs, pins, triangles and effects, in the user's own numbering. Plain
/// data: fill the arrays directly or through the small functions that keep them of one length.

namespace hooke {

/// Particles as a structure of arrays. All arrays have the same length, but `velocity` may be empty: all at
/// rest.
struct Particles {
  std::vector<double> mass;    ///< [kg], > 0
  std::vector<Vec3> position;  ///< [m]
  std::vector<Vec3> velocity;  ///< [m/s]

  std::size_t size() const { return position.size(); }
  Vec3 velocity_of(std::size_t particle) const {
    return velocity.empty() ? Vec3::Zero() : velocity[particle];
  }
};

/// Springs as a structure of arrays. All arrays have the same length, but `damping` may be empty: no spring
/// is damped. The force on `first` is (k (l - l0) + c dl/dt) n, with n the unit vector from `first` to
/// `second` and l their distance; `second` gets the opposite. Where l is zero there is no direction, and no
/// force.
struct Springs {
  std::vector<Index> first, second;  ///< the two particles of each spring
  std::vector<double> stiffness;     ///< k [N/m], >= 0
  std::vector<double> rest_length;   ///< l0 [m], >= 0
  std::vector<double> damping;       ///< c [N s/m] along the spring, >= 0

  std::size_t size() const { return first.size(); }
  double damping_of(std::size_t spring) const { return damping.empty() ? 0.0 : damping[spring]; }
};

/// A particle that forces do not move. With an empty path it stays where it starts, at rest; otherwise it
/// follows the path: straight lines between keyframes, the first and last displacement held before and after.
/// Times must increase.
struct Pin {
  Index particle = 0;
  std::vector<Keyframe> path;
};

struct Scene {
  std::string name;
  Particles particles;
  Springs springs;
  std::vector<Pin> pins;
  std::vector<Triangle> triangles;  ///< for drawing, and for effects on surfaces
  std::vector<Effect> effects;      ///< only what is named here is simulated

  /// Adds a particle of `mass` [kg] at `position` [m] with `velocity` [m/s]; returns its number.
  Index add_particle(double mass, const Vec3& position, const Vec3& velocity = Vec3::Zero());

  /// Adds a spring of `stiffness` [N/m], `rest_length` [m] and `damping` [N s/m]; returns its number.
  Index add_spring(Index first, Index second, double stiffness, double rest_length, double damping = 0.0);

  /// Pins a particle where it is, or along a path.
  void pin(Index particle, std::vector<Keyframe> path = {});
};

/// One thing that is wrong with an input: which element, what is wrong with its value, and what to do.
struct Fault {
  std::string element;  ///< such as "spring 3" or "effects[1] (drag)"
  std::string problem;  ///< such as "stiffness is -5 N/m"
  std::string remedy;   ///< such as "give a finite value >= 0"

  std::string message() const;
};

/// Every fault of a scene; empty when it can be simulated.
std::vector<Fault> validate(const Scene& scene);

/// Thrown where a scene or its settings cannot be used. what() lists the first faults and counts the rest.
class SceneError : public std::invalid_argument {
 public:
  explicit SceneError(std::vector<Fault> faults);
  const std::vector<Fault>& faults() const { return faults_; }

 private:
  std::vector<Fault> faults_;
};

}  // namespace hooke
