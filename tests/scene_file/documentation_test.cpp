#include <doctest/doctest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "scene_file/builder_reader.h"
#include "scene_file/scene_file.h"

using namespace hooke;

namespace {

std::string scenes_page() {
  std::ifstream page(std::string(HOOKE_DOCS) + "/scenes.md");
  return {std::istreambuf_iterator<char>(page), {}};
}

std::vector<std::string> json_blocks(const std::string& page) {
  std::vector<std::string> blocks;
  const std::string open = "```json\n";
  for (std::size_t at = page.find(open); at != page.npos; at = page.find(open, at)) {
    at += open.size();
    const std::size_t end = page.find("```", at);
    blocks.push_back(page.substr(at, end - at));
    at = end;
  }
  return blocks;
}

}  // namespace

TEST_CASE("every example of docs/scenes.md is a scene") {
  const std::vector<std::string> blocks = json_blocks(scenes_page());
  CHECK(blocks.size() == 10);
  for (const std::string& block : blocks) {
    CAPTURE(block);
    CHECK_NOTHROW(parse_scene(block));
  }
}

TEST_CASE("docs/scenes.md says the last particle of its first example") {
  const auto blocks = json_blocks(scenes_page());
  REQUIRE(!blocks.empty());
  CHECK(parse_scene(blocks[0]).scene.particles.size() == 385);
}

TEST_CASE("docs/scenes.md names every key of builders, effects and methods") {
  const std::string page = scenes_page();
  const auto check = [&]<class T>(T described) {
    CAPTURE(T::name);
    CHECK(page.find("`" + std::string(T::name) + "`") != page.npos);
    T::fields(described, [&](std::string_view key, const auto&) {
      CAPTURE(key);
      CHECK(page.find("`" + std::string(key) + "`") != page.npos);
    });
  };
  for_each_alternative<Builder>(check);
  for_each_alternative<Effect>(check);
  for_each_alternative<Method>(check);
  for_each_alternative<SheetLaw>(check);
  check(Placement{});
}
