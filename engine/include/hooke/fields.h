#pragma once

#include <concepts>
#include <cstdint>
#include <functional>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <hooke/index.h>
#include <hooke/vec3.h>

/// Vectors that depend on place and time: forces, accelerations or velocities of the air, as the effect says
/// that has one. A field is a shape in space times an envelope in time.

namespace hooke {

/// The same everywhere.
struct UniformField {
  Vec3 value{0.0, 0.0, 0.0};

  static constexpr std::string_view name = "uniform";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("value", self.value);
  }
};

/// Away from a centre: strength r^exponent at the distance r = sqrt(d^2 + softening^2), along d / r. A
/// negative strength pulls to the centre; exponent -2 is a mass or a charge, 1 a spring to the centre. Where
/// r is 0 there is no direction, and the field is 0.
struct RadialField {
  Vec3 centre{0.0, 0.0, 0.0};  ///< [m]
  double strength = 0.0;       ///< at a distance of 1 m
  double exponent = -2.0;      ///< [1]
  double softening = 0.0;      ///< [m], >= 0: keeps the centre finite

  static constexpr std::string_view name = "radial";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("centre", self.centre);
    visit("strength", self.strength);
    visit("exponent", self.exponent);
    visit("softening", self.softening);
  }
};

/// Around an axis: rate n x (x - centre) up to the core's radius, falling off as 1 / distance outside
/// (Rankine's vortex).
struct VortexField {
  Vec3 centre{0.0, 0.0, 0.0};  ///< [m]
  Vec3 axis{0.0, 1.0, 0.0};    ///< n, any length but zero
  double rate = 0.0;           ///< right-handed [1/s of the field's unit over m]
  double core_radius = 0.0;    ///< [m], >= 0; 0: there is no outside

  static constexpr std::string_view name = "vortex";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("centre", self.centre);
    visit("axis", self.axis);
    visit("rate", self.rate);
    visit("core_radius", self.core_radius);
  }
};

/// A mean and the curl of seeded noise (Bridson, Houriham, Nordenstam 2007): it has no sources, and eddies of
/// the given length and, for each further octave, of half the length and half the amplitude.
struct TurbulenceField {
  Vec3 mean{0.0, 0.0, 0.0};   ///< that the eddies are added to
  double amplitude = 1.0;     ///< root mean square of the first octave's magnitude, >= 0
  double length = 1.0;        ///< of eddies [m], > 0
  double duration = 1.0;      ///< of eddies [s], > 0; a half in each further octave
  Vec3 drift{0.0, 0.0, 0.0};  ///< [m/s] that the pattern moves with
  std::uint64_t octaves = 3;  ///< 1 to 8
  std::uint64_t seed = 1;

  static constexpr std::string_view name = "turbulence";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("mean", self.mean);
    visit("amplitude", self.amplitude);
    visit("length", self.length);
    visit("duration", self.duration);
    visit("drift", self.drift);
    visit("octaves", self.octaves);
    visit("seed", self.seed);
  }
};

/// A table of values at the corners of a grid, interpolated linearly along each axis; outside, the value at
/// the nearest place of the grid.
struct GridField {
  Vec3 origin{0.0, 0.0, 0.0};     ///< of the first value [m]
  Vec3 spacing{1.0, 1.0, 1.0};    ///< [m], > 0
  Index nx = 1, ny = 1, nz = 1;   ///< values along each axis, >= 1
  std::vector<Vec3> values = {};  ///< nx ny nz of them: x runs fastest, then y, then z

  static constexpr std::string_view name = "grid";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("origin", self.origin);
    visit("spacing", self.spacing);
    visit("nx", self.nx);
    visit("ny", self.ny);
    visit("nz", self.nz);
    visit("values", self.values);
  }
};

/// A function of the user's, of a position [m] and a time [s]. It is called from several threads at once, so
/// it must not change shared data; the same arguments must give the same value if runs are to be
/// reproducible. It cannot be written in a scene file.
struct CallbackField {
  std::function<Vec3(const Vec3& position, double time)> function = nullptr;

  CallbackField() = default;
  template <std::invocable<const Vec3&, double> Function>
  CallbackField(Function f) : function(std::move(f)) {}  // so that a lambda alone is a field

  static constexpr std::string_view name = "callback";
  static constexpr bool in_files = false;
  template <class Self, class Visit>
  static void fields(Self&, Visit&&) {}
};

using FieldShape =
    std::variant<UniformField, RadialField, VortexField, TurbulenceField, GridField, CallbackField>;

/// 1 at all times.
struct SteadyEnvelope {
  static constexpr std::string_view name = "steady";
  template <class Self, class Visit>
  static void fields(Self&, Visit&&) {}
};

/// From one value to another along a straight line, held before and after.
struct RampEnvelope {
  double start = 0.0;  ///< [s]
  double end = 1.0;    ///< [s], > start
  double from = 0.0;   ///< [1]
  double to = 1.0;     ///< [1]

  static constexpr std::string_view name = "ramp";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("start", self.start);
    visit("end", self.end);
    visit("from", self.from);
    visit("to", self.to);
  }
};

/// mean + amplitude sin(2 pi frequency t + phase).
struct SineEnvelope {
  double mean = 0.0;           ///< [1]
  double amplitude = 1.0;      ///< [1]
  double frequency = 1.0;      ///< [Hz], >= 0
  double phase_degrees = 0.0;  ///< [deg]

  static constexpr std::string_view name = "sine";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("mean", self.mean);
    visit("amplitude", self.amplitude);
    visit("frequency", self.frequency);
    visit("phase_degrees", self.phase_degrees);
  }
};

/// Gusts over a calm value: in each period one, that begins at a random time, swells and dies down as
/// sin^2, and is 0.5 to 1.5 times as strong as said.
struct GustEnvelope {
  double calm = 0.5;      ///< [1]
  double strength = 1.0;  ///< added to it at the height of a gust [1]
  double period = 4.0;    ///< [s], > 0
  double duration = 1.5;  ///< of a gust [s], > 0 and at most the period
  std::uint64_t seed = 1;

  static constexpr std::string_view name = "gust";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("calm", self.calm);
    visit("strength", self.strength);
    visit("period", self.period);
    visit("duration", self.duration);
    visit("seed", self.seed);
  }
};

using Envelope = std::variant<SteadyEnvelope, RampEnvelope, SineEnvelope, GustEnvelope>;

/// The value of a field at a place [m] and a time [s]: for tests, tools and drawing. Throws
/// std::invalid_argument where a callback is not set.
Vec3 value_at(const FieldShape& shape, const Envelope& envelope, const Vec3& position, double time);

/// The factor of an envelope at a time [s].
double factor_at(const Envelope& envelope, double time);

}  // namespace hooke
