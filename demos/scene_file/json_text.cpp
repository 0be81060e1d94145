#include "scene_file/json_text.h"

#include <algorithm>
#include <set>

namespace hooke {
namespace {

struct TooDeep {};

/// Follows the parser through the text and knows the place of the value that it reads.
class Guard {
 public:
  explicit Guard(std::vector<Fault>& faults) : faults_(faults) {}

  bool operator()(int, Json::parse_event_t event, Json& parsed) {
    using Event = Json::parse_event_t;
    switch (event) {
      case Event::object_start:
      case Event::array_start:
        next_element();
        if (open_.size() == max_json_depth) throw TooDeep{};
        open_.push_back({.is_object = event == Event::object_start});
        break;
      case Event::object_end:
      case Event::array_end:
        open_.pop_back();
        break;
      case Event::key:
        key(parsed.get_ref<const std::string&>());
        break;
      case Event::value:
        next_element();
        break;
    }
    return true;
  }

 private:
  struct Open {
    bool is_object = false;
    std::set<std::string> keys = {};
    std::string key = {};
    std::size_t elements = 0;
  };

  void next_element() {
    if (!open_.empty()) ++open_.back().elements;
  }

  void key(const std::string& name) {
    Open& object = open_.back();
    object.key = name;
    if (!object.keys.insert(name).second)
      faults_.push_back({place(), "is given more than once", "keep one of them"});
  }

  std::string place() const {
    std::string text;
    for (const Open& open : open_) {
      if (open.is_object)
        text += (text.empty() ? "" : ".") + printable(open.key);
      else
        text += "[" + std::to_string(open.elements - 1) + "]";
    }
    return text;
  }

  std::vector<Fault>& faults_;
  std::vector<Open> open_;
};

std::string line_and_column(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte == 0 ? 0 : byte - 1, text.size()));
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t newline = before.rfind('\n');
  const std::size_t column = newline == before.npos ? before.size() + 1 : before.size() - newline;
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

/// The library's message without its own error number and place.
std::string reason(std::string_view message) {
  for (const std::string_view start : {"syntax error ", "] "}) {
    const std::size_t at = message.find(start);
    if (at != message.npos) return printable(message.substr(at + start.size()));
  }
  return printable(message);
}

bool is_blank(std::string_view text) {
  return text.find_first_not_of(" \t\r\n") == text.npos;
}

/// Bytes of the UTF-8 character at the start of `text`; 0 where there is none that can be printed.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return lead >= 0x20 && lead != 0x7f ? 1 : 0;
  const std::size_t length = lead >= 0xc2 && lead < 0xe0   ? 2
                             : lead >= 0xe0 && lead < 0xf0 ? 3
                             : lead >= 0xf0 && lead < 0xf5 ? 4
                                                           : 0;
  if (length == 0 || length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return 0;
  }
  return length;
}

}  // namespace

std::string printable(std::string_view text) {
  constexpr std::size_t longest = 160;
  std::string out;
  while (!text.empty() && out.size() < longest) {
    const std::size_t length = character_length(text);
    if (length == 0)
      out += '?';
    else
      out += text.substr(0, length);
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  if (!text.empty()) out += "...";
  return out;
}

std::optional<Json> parse_json(std::string_view text, std::vector<Fault>& faults) {
  const std::string remedy = "correct the JSON there";
  if (is_blank(text)) {
    faults.push_back({"file", "is empty", "give a JSON object, such as {\"step\": 0.001, ...}"});
    return std::nullopt;
  }
  try {
    return Json::parse(text.begin(), text.end(), Guard(faults));
  } catch (const Json::parse_error& error) {
    faults.push_back(
        {line_and_column(text, error.byte), "JSON syntax error " + reason(error.what()), remedy});
  } catch (const Json::exception& error) {
    faults.push_back({"file", reason(error.what()), "give a number that a double can hold, below 1.8e308"});
  } catch (const TooDeep&) {
    faults.push_back({"file", "nests values more than " + std::to_string(max_json_depth) + " deep",
                      "a scene needs far fewer levels: look for a bracket too many"});
  }
  return std::nullopt;
}

}  // namespace hooke
