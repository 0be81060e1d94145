#include <doctest/doctest.h>

#include <fstream>
#include <set>
#include <string>

#include <nlohmann/json.hpp>

#include "scene_file/builder_reader.h"
#include "scene_file/json_reader.h"

using namespace hooke;

namespace {

Json schema() {
  return Json::parse(std::ifstream(std::string(HOOKE_DOCS) + "/scene.schema.json"));
}

std::set<std::string> keys_of(const Json& object) {
  std::set<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.insert(key);
  return keys;
}

Json json_of(double value) {
  return value;
}
Json json_of(Index value) {
  return value;
}
Json json_of(std::uint64_t value) {
  return value;
}
Json json_of(bool value) {
  return value;
}
template <class T>
Json json_of(const std::vector<T>& values) {
  CHECK(values.empty());
  return Json::array();
}
Json json_of(const Vec3& value) {
  return {value.x(), value.y(), value.z()};
}

template <class T>
inline constexpr bool is_choice = false;
template <class... T>
inline constexpr bool is_choice<std::variant<T...>> = true;

/// What a file may name a mesh file for.
template <class T>
inline constexpr bool can_be_a_file = std::is_same_v<T, ClothMesh> || std::is_same_v<T, MeshShape>;

/// The schema says the keys of a struct both ways, and the same defaults.
template <class T>
void check_described(const Json& definitions) {
  CAPTURE(T::name);
  REQUIRE(definitions.contains(T::name));
  const Json& properties = definitions[std::string(T::name)]["properties"];
  std::set<std::string> expected;
  if (can_be_a_file<T>) expected.insert("file");
  T defaults;
  T::fields(defaults, [&](std::string_view key, const auto& field) {
    CAPTURE(key);
    expected.insert(std::string(key));
    using Value = std::decay_t<decltype(field)>;
    if constexpr (is_choice<Value>) {
      for_each_alternative<Value>([&]<class One>(const One&) {
        if constexpr (in_files<One>) check_described<One>(definitions);
      });
    } else if constexpr (!Described<Value>)
      CHECK(properties[std::string(key)].value("default", Json("none")) == json_of(field));
  });
  CHECK(keys_of(properties) == expected);
  CHECK(definitions[std::string(T::name)]["additionalProperties"] == false);
}

}  // namespace

TEST_CASE("the schema and the structs of the library say the same keys and defaults") {
  const Json definitions = schema()["$defs"];
  check_described<Placement>(definitions);
  for_each_alternative<Builder>([&]<class T>(const T&) { check_described<T>(definitions); });
  for_each_alternative<Method>([&]<class T>(const T&) { check_described<T>(definitions); });
  for_each_alternative<Effect>([&]<class T>(const T&) {
    if constexpr (in_files<T>) check_described<T>(definitions);
  });
}

TEST_CASE("the schema and the library name the same builders, effects, methods and modes") {
  const Json whole = schema();
  for_each_alternative<Builder>([&]<class T>(const T&) { CHECK(whole["properties"].contains(T::name)); });
  std::set<std::string> effects, methods;
  for_each_alternative<Effect>([&]<class T>(const T&) {
    if (in_files<T>) effects.insert(std::string(T::name));
  });
  for_each_alternative<Method>([&]<class T>(const T&) { methods.insert(std::string(T::name)); });
  CHECK(keys_of(whole["$defs"]["effects"]["properties"]) == effects);
  CHECK(keys_of(whole["$defs"]["method"]["properties"]) == methods);
  CHECK(whole["properties"]["accumulation"]["enum"] == Json{to_string(Accumulation::gather),
                                                            to_string(Accumulation::coloured),
                                                            to_string(Accumulation::atomic)});
  CHECK(whole["properties"]["unstable_step"]["enum"] == Json{to_string(UnstableStep::divide),
                                                             to_string(UnstableStep::refuse),
                                                             to_string(UnstableStep::take)});
  Json on_trouble = Json::array();
  for (const OnTrouble choice : troubles) on_trouble.push_back(to_string(choice));
  CHECK(whole["properties"]["on_trouble"]["enum"] == on_trouble);
}

TEST_CASE("the reader knows the keys of the schema at the top, and no others") {
  const Json whole = schema();
  const std::string unknown = "zzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzz";
  try {
    parse_scene("{\"" + unknown + "\": 1, \"step\": 1}");
    FAIL("an unknown key was accepted");
  } catch (const SceneFileError& error) {
    const std::string remedy = error.faults()[0].remedy + ",";
    std::size_t listed = 0;
    for (const std::string& key : keys_of(whole["properties"])) {
      CAPTURE(key);
      CHECK(remedy.find(" " + key + ",") != remedy.npos);
      ++listed;
    }
    CHECK(static_cast<std::size_t>(std::count(remedy.begin(), remedy.end(), ',')) == listed);
  }
}
