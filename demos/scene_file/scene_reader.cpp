#include "scene_file/scene_reader.h"

#include <array>
#include <string>
#include <utility>

#include "scene_file/builder_reader.h"
#include "scene_file/fault_place.h"
#include "scene_file/network_reader.h"
#include "scene_file/pin_reader.h"

namespace hooke {
namespace {

void refuse_unknown_keys(JsonReader& reader, const Json& root) {
  std::vector<std::string_view> known{"$schema",      "name",
                                      "description",  "particles",
                                      "springs",      "pins",
                                      "triangles",    "effects",
                                      "method",       "step",
                                      "seconds",      "unstable_step",
                                      "accumulation", "max_steps_per_advance",
                                      "on_trouble",   "fps"};
  for_each_alternative<Builder>([&]<class T>(const T&) { known.push_back(T::name); });
  reader.refuse_unknown_keys(root, known);
}

/// Effects by name, each one object or a list of them. Objects have no order in JSON, so within one the
/// effects come in the order of the engine's own list.
void read_effects_object(JsonReader& reader, const Json& value, std::vector<Effect>& effects,
                         std::vector<std::string>& places) {
  if (!reader.expect_object(value)) return;
  std::vector<std::string_view> known;
  for_each_alternative<Effect>([&]<class T>(const T&) {
    known.push_back(T::name);
    const auto found = value.find(T::name);
    if (found == value.end()) return;
    const JsonReader::At at(reader, T::name);
    if constexpr (!in_files<T>) {
      reader.fault("is a function, which cannot be written in a file", "use the library, or leave it out");
    } else {
      reader.for_each_entry(*found, [&](const Json& entry) {
        T& effect = std::get<T>(effects.emplace_back(T{}));
        reader.read(entry, effect);
        places.push_back(reader.place());
      });
    }
  });
  reader.refuse_unknown_keys(value, known);
}

/// An object of effects, or, where their order matters, a list of such objects.
void read_effects(JsonReader& reader, const Json& root, std::vector<Effect>& effects,
                  std::vector<std::string>& places) {
  const auto found = root.find("effects");
  if (found == root.end()) return;
  const JsonReader::At at(reader, "effects");
  reader.for_each_entry(*found,
                        [&](const Json& entry) { read_effects_object(reader, entry, effects, places); });
}

/// {"symplectic_euler": {}}
void read_method(JsonReader& reader, const Json& root, Method& method) {
  const auto found = root.find("method");
  if (found == root.end()) return;
  const JsonReader::At at(reader, "method");
  reader.read(*found, method);
}

/// One of `choices`, by its name.
template <class Choices, class Choice>
void read_choice(JsonReader& reader, const Json& root, const char* key, const Choices& choices, Choice& out) {
  std::string word(to_string(out));
  reader.read_optional(root, key, word);
  std::vector<std::string_view> known;
  for (const auto choice : choices) {
    known.push_back(to_string(choice));
    if (word != known.back()) continue;
    out = choice;
    return;
  }
  reader.fault_at(key, "is \"" + printable(word) + "\"", spelling_remedy(word, known));
}

/// A number that says how long or how often, so that the count of frames and steps stays one that can be
/// counted.
void read_positive(JsonReader& reader, const Json& root, std::string_view key, double largest, double& out) {
  reader.read_optional(root, key, out);
  if (out > 0.0 && out <= largest) return;
  const JsonReader::At at(reader, key);
  reader.fault("is " + Json(out).dump(), "give a number above 0 and up to " + Json(largest).dump());
}

void read_settings(JsonReader& reader, const Json& root, SceneFile& file) {
  reader.read_optional(root, "name", file.scene.name);
  reader.read_optional(root, "description", file.description);
  reader.read_required(
      root, "step", file.settings.step,
      "give the length of a step [s]: a stiff scene needs a short one, a thousandth or less");
  reader.read_optional(root, "max_steps_per_advance", file.settings.max_steps_per_advance);
  read_method(reader, root, file.settings.method);
  read_choice(reader, root, "unstable_step", unstable_steps, file.settings.unstable_step);
  if (root.contains("on_trouble")) {
    read_choice(reader, root, "on_trouble", troubles, file.settings.on_trouble.emplace());
  }
  read_choice(reader, root, "accumulation", accumulations, file.settings.accumulation);
  read_positive(reader, root, "seconds", 1e9, file.seconds);
  read_positive(reader, root, "fps", 1e6, file.fps);
}

void report(JsonReader& reader, std::vector<Fault> faults, const ListedElements& listed) {
  for (Fault& found : faults) {
    Fault fault = in_file(std::move(found), listed);
    reader.fault_at(std::move(fault.element), std::move(fault.problem), std::move(fault.remedy));
  }
}

/// Effects and settings can be judged even where the rest of the scene is not known.
std::vector<Fault> faults_without_scene(const SceneFile& file) {
  Scene particle_alone;
  particle_alone.add_particle(1.0, Vec3::Zero());
  particle_alone.effects = file.scene.effects;
  return validate(particle_alone, file.settings);
}

}  // namespace

SceneFile read_scene(JsonReader& reader, const Json& root, const std::filesystem::path& folder,
                     const SceneFileOptions& options) {
  SceneFile file;
  if (!reader.expect_object(root)) return file;
  Scene& scene = file.scene;
  ListedElements listed;

  refuse_unknown_keys(reader, root);
  read_settings(reader, root, file);
  read_effects(reader, root, scene.effects, listed.effects);
  read_particles(reader, root, options.max_particles, scene.particles);
  listed.particles = scene.particles.size();
  const Parts parts = read_builders(reader, root, folder, options, scene);

  // Pins and springs that name particles which could not be made would only repeat the faults above.
  if (reader.faults() == 0) {
    listed.first_spring = scene.springs.size();
    listed.first_triangle = scene.triangles.size();
    read_pins(reader, root, parts, options.max_particles, scene);
    read_springs(reader, root, scene);
    read_triangles(reader, root, scene);
  }
  report(reader, reader.faults() == 0 ? validate(scene, file.settings) : faults_without_scene(file), listed);
  return file;
}

}  // namespace hooke
