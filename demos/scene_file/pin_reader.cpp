#include "scene_file/pin_reader.h"

#include <algorithm>
#include <string>

namespace hooke {
namespace {

class PinReader {
 public:
  PinReader(JsonReader& reader, const Parts& parts, std::size_t max_keyframes, Scene& scene)
      : reader_(reader),
        parts_(parts),
        keyframes_left_(max_keyframes),
        scene_(scene),
        pinned_(scene.particles.size(), false) {
    for (const auto& [kind, of_kind] : parts) kinds_.push_back(kind);
  }

  void read(const Json& entry) {
    if (!reader_.expect_object(entry)) return;
    const std::size_t before = reader_.faults();
    const std::vector<Index> particles = selected(entry);
    const std::vector<Keyframe> path = read_path(entry);
    if (reader_.faults() == before) pin(particles, path);
  }

 private:
  /// The particles that an entry means, in whichever of the ways it says so.
  std::vector<Index> selected(const Json& entry) {
    std::vector<std::string_view> ways{"particle", "furthest_along"};
    ways.insert(ways.end(), kinds_.begin(), kinds_.end());
    std::vector<std::string_view> given;
    for (const std::string_view way : ways) {
      if (entry.contains(way)) given.push_back(way);
    }
    if (given.size() != 1) {
      std::vector<std::string_view> known = ways;
      known.insert(known.end(), {"at", "within", "of", "path"});
      reader_.refuse_unknown_keys(entry, known);
      reader_.fault(given.empty() ? "does not say which particle"
                                  : "says twice which particle: " + std::string(given[0]) + " and " +
                                        std::string(given[1]),
                    "give one of: particle, cloth_grid, rope or block with at, furthest_along");
      return {};
    }
    if (given[0] == "particle") return one_particle(entry);
    if (given[0] == "furthest_along") return furthest(entry);
    return of_grid(entry, given[0]);
  }

  std::vector<Index> one_particle(const Json& entry) {
    reader_.refuse_unknown_keys(entry, {"particle", "path"});
    const std::size_t before = reader_.faults();
    Index particle = 0;
    reader_.read_optional(entry, "particle", particle);
    const JsonReader::At at(reader_, "particle");
    if (reader_.faults() == before) expect_below(particle, scene_.particles.size());
    return {particle};
  }

  /// A particle of a grid, a rope or a block, by its place in it.
  std::vector<Index> of_grid(const Json& entry, std::string_view kind) {
    reader_.refuse_unknown_keys(entry, {kind, "at", "path"});
    const Part* part = read_part(entry, kind);
    if (part == nullptr) return {};
    if (!part->has_grid()) {
      reader_.fault("counts along a mesh", "give particle, or furthest_along with of");
      return {};
    }
    std::vector<Index> place;
    read_grid_place(entry, place);
    const JsonReader::At at(reader_, "at");
    if (place.size() != part->shape.size()) {
      if (entry.contains("at"))
        reader_.fault("has " + std::to_string(place.size()) + " numbers",
                      "give " + std::to_string(part->shape.size()));
      return {};
    }
    Index particle = 0;
    for (std::size_t d = place.size(); d-- > 0;) {
      const JsonReader::At direction(reader_, d);
      expect_below(place[d], part->shape[d]);
      particle = particle * part->shape[d] + place[d];
    }
    return {part->first + particle};
  }

  /// A rope needs one number; the brackets around it may be left out.
  void read_grid_place(const Json& entry, std::vector<Index>& place) {
    const auto found = entry.find("at");
    if (found == entry.end() || found->is_array())
      return reader_.read_required(entry, "at", place, "give the place of the particle in it");
    reader_.read_optional(entry, "at", place.emplace_back());
  }

  std::vector<Index> furthest(const Json& entry) {
    reader_.refuse_unknown_keys(entry, {"furthest_along", "within", "of", "path"});
    const std::size_t before = reader_.faults();
    Vec3 direction = Vec3::Zero();
    double within = 0.0;
    reader_.read_optional(entry, "furthest_along", direction);
    reader_.read_optional(entry, "within", within);
    Part part{0, static_cast<Index>(scene_.particles.size()), {}};
    if (const auto found = entry.find("of"); found != entry.end()) {
      if (const Part* named = read_named_part(*found)) part = *named;
    }
    if (reader_.faults() == before) check_direction(direction, within);
    if (reader_.faults() != before) return {};
    return furthest_along(scene_, part.first, part.count, direction, within);
  }

  void check_direction(const Vec3& direction, double within) {
    if ((direction.array() == 0.0).all()) {
      const JsonReader::At at(reader_, "furthest_along");
      reader_.fault("is zero", "give a direction, such as [0, 1, 0]");
    }
    if (within < 0.0) {
      const JsonReader::At at(reader_, "within");
      reader_.fault("is " + Json(within).dump() + " m", "give a number >= 0");
    }
  }

  /// {"cloth_mesh": 0}
  const Part* read_named_part(const Json& value) {
    const JsonReader::At at(reader_, "of");
    if (!reader_.expect_object(value)) return nullptr;
    reader_.refuse_unknown_keys(value, kinds_);
    if (value.size() == 1 && parts_.contains(value.begin().key()))
      return read_part(value, parts_.find(value.begin().key())->first);
    reader_.fault("does not name one part of the scene",
                  "give a builder and its number: {\"cloth_grid\": 0}");
    return nullptr;
  }

  /// `kind`: number.
  const Part* read_part(const Json& value, std::string_view kind) {
    const std::size_t before = reader_.faults();
    Index number = 0;
    reader_.read_optional(value, kind, number);
    const JsonReader::At at(reader_, kind);
    const std::vector<Part>& of_kind = parts_.at(kind);
    if (reader_.faults() == before && expect_below(number, of_kind.size())) return &of_kind[number];
    return nullptr;
  }

  std::vector<Keyframe> read_path(const Json& entry) {
    std::vector<Keyframe> path;
    const auto found = entry.find("path");
    if (found == entry.end()) return path;
    const JsonReader::At at(reader_, "path");
    if (!reader_.expect_list(*found)) return path;
    reader_.for_each_entry(*found, [&](const Json& frame) {
      if (!reader_.expect_object(frame)) return;
      reader_.refuse_unknown_keys(frame, {"time", "displacement"});
      Keyframe& keyframe = path.emplace_back();
      reader_.read_required(frame, "time", keyframe.time, "give the time [s]");
      reader_.read_required(frame, "displacement", keyframe.displacement,
                            "give the displacement [x, y, z] [m]");
    });
    const auto later = [](const Keyframe& a, const Keyframe& b) { return a.time >= b.time; };
    if (std::adjacent_find(path.begin(), path.end(), later) != path.end())
      reader_.fault("has times that do not increase",
                    "order its keyframes by time, each later than the one before");
    return path;
  }

  void pin(const std::vector<Index>& particles, const std::vector<Keyframe>& path) {
    if (!path.empty() && particles.size() > keyframes_left_ / path.size()) {
      reader_.fault("gives " + std::to_string(particles.size()) + " particles a path of " +
                        std::to_string(path.size()) + " keyframes",
                    "use shorter paths or fewer pins");
      return;
    }
    keyframes_left_ -= particles.size() * path.size();
    for (const Index particle : particles) {
      if (pinned_[particle]) {
        reader_.fault("pins particle " + std::to_string(particle) + ", which an entry before it pins",
                      "keep one of the two");
        return;
      }
      pinned_[particle] = true;
      scene_.pin(particle, path);
    }
  }

  bool expect_below(Index number, std::size_t count) {
    if (number < count) return true;
    reader_.fault("is " + std::to_string(number),
                  count == 0 ? "there is none in this file"
                             : "give a whole number from 0 to " + std::to_string(count - 1));
    return false;
  }

  JsonReader& reader_;
  const Parts& parts_;
  std::size_t keyframes_left_;
  Scene& scene_;
  std::vector<bool> pinned_;
  std::vector<std::string_view> kinds_;
};

}  // namespace

void read_pins(JsonReader& reader, const Json& root, const Parts& parts, std::size_t max_keyframes,
               Scene& scene) {
  const auto found = root.find("pins");
  if (found == root.end()) return;
  const JsonReader::At at(reader, "pins");
  if (!reader.expect_list(*found)) return;
  PinReader pins(reader, parts, max_keyframes, scene);
  reader.for_each_entry(*found, [&](const Json& entry) { pins.read(entry); });
}

}  // namespace hooke
