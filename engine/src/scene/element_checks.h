#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <hooke/scene.h>

namespace hooke {

/// Checks the values of one element and adds a fault for each bad one. Good values, of which a scene has
/// millions, cost a comparison: text is made only for faults.
class ElementChecks {
 public:
  static constexpr std::size_t unnumbered = std::numeric_limits<std::size_t>::max();

  /// The element is called "`kind` `number`", or just `kind`, whose characters must outlive this.
  ElementChecks(std::vector<Fault>& faults, std::string_view kind, std::size_t number = unnumbered)
      : faults_(faults), kind_(kind), number_(number) {}

  void finite(std::string_view name, double value, std::string_view unit) const {
    if (!std::isfinite(value)) bad_value(name, value, unit, "give a finite value");
  }
  void positive(std::string_view name, double value, std::string_view unit) const {
    if (!(std::isfinite(value) && value > 0.0)) bad_value(name, value, unit, "give a finite value > 0");
  }
  void not_negative(std::string_view name, double value, std::string_view unit) const {
    if (!(std::isfinite(value) && value >= 0.0)) bad_value(name, value, unit, "give a finite value >= 0");
  }
  void finite(std::string_view name, const Vec3& value, std::string_view unit) const {
    if (!value.allFinite()) bad_value(name, value, unit, "give finite values");
  }
  /// A vector whose length does not matter, as long as there is one.
  void direction(std::string_view name, const Vec3& value) const {
    if (!value.allFinite() || (value.array() == 0.0).all()) {
      bad_value(name, value, "", "give finite values that are not all zero");
    }
  }
  /// A keyframe's: finite, and after those before it, of which `latest` keeps the last; -infinity at first.
  void later_time(std::string_view name, double time, double& latest) const;
  void at_least(std::string_view name, std::size_t value, std::size_t least) const {
    if (value < least) too_few(name, value, least);
  }
  void at_most(std::string_view name, std::uint64_t value, std::uint64_t most) const {
    if (value > most) too_many(name, value, most);
  }
  /// `index` counts into `count` of what `plural` says, such as "particles".
  void in_range(std::string_view name, Index index, std::size_t count, std::string_view plural) const {
    if (index >= count) out_of_range(name, index, count, plural);
  }

  void add(std::string problem, std::string remedy) const;

 private:
  void bad_value(std::string_view name, double value, std::string_view unit, std::string_view remedy) const;
  void bad_value(std::string_view name, const Vec3& value, std::string_view unit,
                 std::string_view remedy) const;
  void too_few(std::string_view name, std::size_t value, std::size_t least) const;
  void too_many(std::string_view name, std::uint64_t value, std::uint64_t most) const;
  void out_of_range(std::string_view name, Index index, std::size_t count, std::string_view plural) const;

  std::vector<Fault>& faults_;
  std::string_view kind_;
  std::size_t number_;
};

/// Throws SceneError with all of `faults`, if there are any.
void throw_if_any(std::vector<Fault> faults);

}  // namespace hooke
