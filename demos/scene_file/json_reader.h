#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <hooke/scene.h>

#include "scene_file/json_text.h"

namespace hooke {

/// A struct that says its name and lists its fields, as builders, effects and methods do.
template <class T>
concept Described = requires(T& value) {
  { T::name } -> std::convertible_to<std::string_view>;
  T::fields(value, [](std::string_view, auto&) {});
};

/// Whether a scene file can say it: not what holds a function.
template <class T>
inline constexpr bool in_files = true;
template <class T>
requires requires {
  T::in_files;
}
inline constexpr bool in_files<T> = T::in_files;

/// Calls `visit(Alternative{})` for each alternative of a variant, in order.
template <class Variant, class Visit>
void for_each_alternative(Visit&& visit) {
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (visit(std::variant_alternative_t<I, Variant>{}), ...);
  }
  (std::make_index_sequence<std::variant_size_v<Variant>>{});
}

/// Reads JSON values into C++ values, knows its place in the file and collects faults. A value that cannot be
/// read leaves its target as it was, so that reading goes on and finds the next fault.
class JsonReader {
 public:
  /// Files that are named by a relative path are looked for in `folder`; a mesh may have so many vertices.
  JsonReader(std::vector<Fault>& faults, const std::filesystem::path& folder, std::size_t most_vertices)
      : faults_(faults), folder_(folder), most_vertices_(most_vertices) {}

  /// While it lives, the reader is at this key, or this element, of the place where it was.
  class At {
   public:
    At(JsonReader& reader, std::string_view key) : reader_(reader) { reader_.place_.push_back({key, 0}); }
    At(JsonReader& reader, std::size_t element) : reader_(reader) { reader_.place_.push_back({{}, element}); }
    ~At() { reader_.place_.pop_back(); }
    At(const At&) = delete;
    At& operator=(const At&) = delete;

   private:
    JsonReader& reader_;
  };

  /// The place where the reader is, such as "pins[2].at"; "file" at the top.
  std::string place() const;

  void fault(std::string problem, std::string remedy);
  void fault_at(std::string element, std::string problem, std::string remedy);
  std::size_t faults() const { return faults_.size(); }

  void read(const Json& value, bool& out);
  void read(const Json& value, double& out);
  void read(const Json& value, Index& out);
  void read(const Json& value, std::uint64_t& out);
  void read(const Json& value, std::string& out);
  void read(const Json& value, Vec3& out);
  void read(const Json& value, Triangle& out);
  /// Its vertices and triangles may be those of an OBJ file.
  void read(const Json& value, MeshShape& out);

  template <class T>
  void read(const Json& value, std::vector<T>& out);

  /// Reads the fields of a struct from an object. A key that is neither a field nor one of `others` is a
  /// fault.
  template <Described T>
  void read(const Json& value, T& out, std::initializer_list<std::string_view> others = {});

  /// Reads the one alternative that an object names: {"vortex": {...}}.
  template <class... T>
  void read(const Json& value, std::variant<T...>& out);

  /// Reads `object[key]` where it is given.
  template <class T>
  void read_optional(const Json& object, std::string_view key, T& out);

  /// Likewise; a fault with this remedy where it is not.
  template <class T>
  void read_required(const Json& object, std::string_view key, T& out, std::string_view remedy);

  /// Calls `visit(entry)` for each entry of a list, or for the one entry that stands without a list around
  /// it.
  template <class Visit>
  void for_each_entry(const Json& value, Visit&& visit);

  /// Whether the value is an object, or a list; a fault where it is not.
  bool expect_object(const Json& value);
  bool expect_list(const Json& value);

  /// A fault for every key of the object that is not known, with the nearest one that is.
  void refuse_unknown_keys(const Json& object, const std::vector<std::string_view>& known);

 private:
  struct Step {
    std::string_view key;  ///< empty: an element of a list
    std::size_t element;
  };

  void wrong_type(const Json& value, std::string_view expected);
  std::uint64_t whole_number(const Json& value, std::uint64_t largest, std::uint64_t otherwise);
  bool expect_three(const Json& value, std::string_view expected);

  std::vector<Fault>& faults_;
  const std::filesystem::path& folder_;
  std::size_t most_vertices_;
  std::vector<Step> place_;
};

/// The one of `known` that is spelt most like `word`; empty where none is like it.
std::string_view nearest(std::string_view word, const std::vector<std::string_view>& known);

/// What to do about `word`: use the nearest of `known`, or one of them.
std::string spelling_remedy(std::string_view word, const std::vector<std::string_view>& known);

template <class T>
void JsonReader::read(const Json& value, std::vector<T>& out) {
  if (!expect_list(value)) return;
  out.resize(value.size());
  for (std::size_t i = 0; i < value.size(); ++i) {
    const At element(*this, i);
    read(value[i], out[i]);
  }
}

template <Described T>
void JsonReader::read(const Json& value, T& out, std::initializer_list<std::string_view> others) {
  if (!expect_object(value)) return;
  std::vector<std::string_view> known(others);
  T::fields(out, [&](std::string_view key, auto& field) {
    known.push_back(key);
    read_optional(value, key, field);
  });
  refuse_unknown_keys(value, known);
}

template <class... T>
void JsonReader::read(const Json& value, std::variant<T...>& out) {
  if (!expect_object(value)) return;
  const std::size_t before = faults();
  std::vector<std::string_view> known;
  for_each_alternative<std::variant<T...>>([&]<class One>(One one) {
    if (value.contains(One::name) && !in_files<One>) {
      const At at(*this, One::name);
      fault("is a function, which cannot be written in a file", "use the library, or leave it out");
    } else if (in_files<One>) {
      known.push_back(One::name);
      if (!value.contains(One::name)) return;
      read_optional(value, One::name, one);
      out = std::move(one);
    }
  });
  if (faults() != before) return;
  refuse_unknown_keys(value, known);
  if (value.size() != 1 && faults() == before)
    fault("names " + std::to_string(value.size()) + " of these", spelling_remedy("", known));
}

template <class T>
void JsonReader::read_optional(const Json& object, std::string_view key, T& out) {
  const auto found = object.find(key);
  if (found == object.end()) return;
  const At at(*this, key);
  read(*found, out);
}

template <class T>
void JsonReader::read_required(const Json& object, std::string_view key, T& out, std::string_view remedy) {
  if (object.contains(key)) return read_optional(object, key, out);
  const At at(*this, key);
  fault("is missing", std::string(remedy));
}

template <class Visit>
void JsonReader::for_each_entry(const Json& value, Visit&& visit) {
  if (!value.is_array()) return visit(value);
  for (std::size_t i = 0; i < value.size(); ++i) {
    const At element(*this, i);
    visit(value[i]);
  }
}

}  // namespace hooke
