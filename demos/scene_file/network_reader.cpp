#include "scene_file/network_reader.h"

#include <utility>

namespace hooke {
namespace {

void expect_length(JsonReader& reader, std::string_view key, std::size_t length, std::size_t expected) {
  if (length == expected) return;
  const JsonReader::At at(reader, key);
  reader.fault("has " + std::to_string(length) + " entries where the others have " + std::to_string(expected),
               "give all lists one length");
}

void append(Springs& to, const Springs& more) {
  const std::size_t before = to.size();
  to.first.insert(to.first.end(), more.first.begin(), more.first.end());
  to.second.insert(to.second.end(), more.second.begin(), more.second.end());
  to.stiffness.insert(to.stiffness.end(), more.stiffness.begin(), more.stiffness.end());
  to.rest_length.insert(to.rest_length.end(), more.rest_length.begin(), more.rest_length.end());
  if (to.damping.empty() && more.damping.empty()) return;
  to.damping.resize(before, 0.0);
  to.damping.insert(to.damping.end(), more.damping.begin(), more.damping.end());
  to.damping.resize(to.size(), 0.0);
}

}  // namespace

void read_particles(JsonReader& reader, const Json& root, std::size_t max_particles, Particles& particles) {
  const auto found = root.find("particles");
  if (found == root.end()) return;
  const JsonReader::At at(reader, "particles");
  if (!reader.expect_object(*found)) return;
  reader.refuse_unknown_keys(*found, {"mass", "position", "velocity"});

  const std::size_t before = reader.faults();
  reader.read_required(*found, "mass", particles.mass, "give the mass of each particle [kg]");
  reader.read_required(*found, "position", particles.position, "give the position of each particle [m]");
  reader.read_optional(*found, "velocity", particles.velocity);
  if (reader.faults() == before) {
    expect_length(reader, "mass", particles.mass.size(), particles.size());
    if (found->contains("velocity"))
      expect_length(reader, "velocity", particles.velocity.size(), particles.size());
    if (particles.size() > max_particles)
      reader.fault("lists " + std::to_string(particles.size()) + " particles",
                   "list at most " + std::to_string(max_particles));
  }
  // Builders add to these arrays, and need them to be of one length.
  if (reader.faults() != before) particles = {};
}

void read_springs(JsonReader& reader, const Json& root, Scene& scene) {
  const auto found = root.find("springs");
  if (found == root.end()) return;
  const JsonReader::At at(reader, "springs");
  if (!reader.expect_object(*found)) return;
  reader.refuse_unknown_keys(*found, {"first", "second", "stiffness", "rest_length", "damping"});

  Springs springs;
  const std::size_t before = reader.faults();
  reader.read_required(*found, "first", springs.first, "give one particle of each spring");
  reader.read_required(*found, "second", springs.second, "give the other particle of each spring");
  reader.read_required(*found, "stiffness", springs.stiffness, "give the stiffness of each spring [N/m]");
  reader.read_required(*found, "rest_length", springs.rest_length, "give the rest length of each spring [m]");
  reader.read_optional(*found, "damping", springs.damping);
  if (reader.faults() != before) return;

  expect_length(reader, "second", springs.second.size(), springs.size());
  expect_length(reader, "stiffness", springs.stiffness.size(), springs.size());
  expect_length(reader, "rest_length", springs.rest_length.size(), springs.size());
  if (found->contains("damping")) expect_length(reader, "damping", springs.damping.size(), springs.size());
  if (reader.faults() == before) append(scene.springs, springs);
}

void read_triangles(JsonReader& reader, const Json& root, Scene& scene) {
  std::vector<Triangle> triangles;
  reader.read_optional(root, "triangles", triangles);
  scene.triangles.insert(scene.triangles.end(), triangles.begin(), triangles.end());
}

}  // namespace hooke
