#include <string>
#include <utility>

#include "scene_file/json_reader.h"
#include "scene_file/json_text.h"
#include "scene_file/scene_file.h"

namespace hooke {
namespace {

Json json_of(double value) {
  return value;
}

Json json_of(std::uint64_t value) {
  return value;
}

Json json_of(bool value) {
  return value;
}

Json json_of(Index value) {
  return value;
}

Json json_of(const Vec3& value) {
  return {value.x(), value.y(), value.z()};
}

template <class... T>
Json json_of(const std::variant<T...>& value);
template <class T>
Json json_of(const std::vector<T>& values);

template <Described T>
Json json_of(const T& value) {
  Json object = Json::object();
  T::fields(value,
            [&](std::string_view key, const auto& field) { object[std::string(key)] = json_of(field); });
  return object;
}

/// The alternative that a variant holds, under its name.
template <class... T>
Json json_of(const std::variant<T...>& value) {
  return std::visit([](const auto& held) { return Json{{std::string(held.name), json_of(held)}}; }, value);
}

Json json_of(const Triangle& triangle) {
  return triangle;
}

Json json_of(const Pin& pin);

template <class T>
Json json_of(const std::vector<T>& values) {
  Json list = Json::array();
  for (const T& value : values) list.push_back(json_of(value));
  return list;
}

Json json_of(const Pin& pin) {
  Json entry{{"particle", pin.particle}};
  if (!pin.path.empty()) entry["path"] = json_of(pin.path);
  return entry;
}

Json json_of(const Particles& particles) {
  Json lists{{"mass", particles.mass}, {"position", json_of(particles.position)}};
  if (!particles.velocity.empty()) lists["velocity"] = json_of(particles.velocity);
  return lists;
}

Json json_of(const Springs& springs) {
  Json lists{{"first", springs.first},
             {"second", springs.second},
             {"stiffness", springs.stiffness},
             {"rest_length", springs.rest_length}};
  if (!springs.damping.empty()) lists["damping"] = springs.damping;
  return lists;
}

/// Whether a value, its fields and what it holds can be written in a file.
template <class T>
bool can_be_written(const T&) {
  return in_files<T>;
}

template <class... T>
bool can_be_written(const std::variant<T...>& value);

template <Described T>
bool can_be_written(const T& value) {
  bool can = in_files<T>;
  T::fields(value, [&](std::string_view, const auto& field) { can = can && can_be_written(field); });
  return can;
}

template <class... T>
bool can_be_written(const std::variant<T...>& value) {
  return std::visit([](const auto& held) { return can_be_written(held); }, value);
}

void refuse_what_no_file_can_say(const SceneFile& file) {
  std::vector<Fault> faults = validate(file.scene, file.settings);
  for (std::size_t i = 0; i < file.scene.effects.size(); ++i) {
    const Effect& effect = file.scene.effects[i];
    if (can_be_written(effect)) continue;
    const auto name = std::visit([](const auto& one) { return std::string(one.name); }, effect);
    faults.push_back({"effects[" + std::to_string(i) + "] (" + name + ")",
                      "holds a function, which cannot be written in a file", "leave it out"});
  }
  if (!faults.empty()) throw SceneFileError("scene", std::move(faults));
}

/// Each part of the scene on a line of its own: one line for each number would be a very long file.
std::string text_of(const std::vector<std::pair<std::string, Json>>& entries) {
  std::string text = "{";
  for (const auto& [key, value] : entries) {
    text += (text.size() == 1 ? "\n  \"" : ",\n  \"") + key + "\": " + value.dump();
  }
  return text + "\n}\n";
}

}  // namespace

std::string write_scene(const SceneFile& file) {
  refuse_what_no_file_can_say(file);
  const auto& [scene, settings, seconds, fps, description] = file;
  std::vector<std::pair<std::string, Json>> entries{{"name", scene.name},
                                                    {"description", description},
                                                    {"step", settings.step},
                                                    {"seconds", seconds},
                                                    {"fps", fps},
                                                    {"method", json_of(settings.method)},
                                                    {"unstable_step", to_string(settings.unstable_step)},
                                                    {"accumulation", to_string(settings.accumulation)},
                                                    {"max_steps_per_advance", settings.max_steps_per_advance},
                                                    {"effects", json_of(scene.effects)},
                                                    {"pins", json_of(scene.pins)},
                                                    {"particles", json_of(scene.particles)}};
  if (settings.on_trouble) entries.emplace_back("on_trouble", to_string(*settings.on_trouble));
  if (scene.springs.size() > 0) entries.emplace_back("springs", json_of(scene.springs));
  if (!scene.triangles.empty()) entries.emplace_back("triangles", json_of(scene.triangles));
  try {
    return text_of(entries);
  } catch (const Json::exception&) {  // the one thing left that JSON cannot say
    throw SceneFileError("scene", {{"name or description", "is not UTF-8 text", "write it in UTF-8"}});
  }
}

}  // namespace hooke
