#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

#include "scene_file/json_reader.h"
#include "scene_text.h"
#include "text.h"

using namespace hooke;
using test::contains;
using test::fault_of;
using test::faults_of;
using test::with;

TEST_CASE("text that is not JSON is refused with its line and column") {
  CHECK(fault_of("{\n  \"step\": 0.1,\n  oops\n}").starts_with("line 3, column 3: JSON syntax error"));
  CHECK(fault_of("").starts_with("file: is empty"));
  CHECK(fault_of(" \n\t").starts_with("file: is empty"));
  CHECK(contains(fault_of("{\"step\": 0.1"), "line 1, column 13"));
  CHECK(contains(fault_of("{\"name\": \"\xff\"}"), "JSON syntax error"));
  CHECK(!contains(fault_of("{\"name\": \"\xff\"}"), "\xff"));
  CHECK(contains(fault_of(with("\"seconds\": 1e999")), "1e999"));
  CHECK(contains(fault_of(with("\"seconds\": NaN")), "JSON syntax error"));
  CHECK(fault_of("[1, 2]").starts_with("file: is a list of 2; give an object"));
}

TEST_CASE("nesting without end is refused") {
  CHECK(contains(fault_of(std::string(1'000'000, '[')), "nests values more than 32 deep"));
  std::string objects;
  for (int i = 0; i < 100'000; ++i) objects += "{\"a\":";
  CHECK(contains(fault_of(objects), "nests values more than 32 deep"));
}

TEST_CASE("a key that is given twice is refused") {
  CHECK(fault_of(with("\"effects\": {\"drag\": {\"coefficient\": 1, \"coefficient\": 2}}")) ==
        "effects.drag.coefficient: is given more than once; keep one of them");
  CHECK(fault_of(with("\"pins\": [{\"particle\": 0}], \"pins\": []")) ==
        "pins: is given more than once; keep one of them");
  CHECK(contains(fault_of(with("\"effects\": [{}, {\"drag\": {}, \"drag\": {}}]")),
                 "effects[1].drag: is given"));
}

TEST_CASE("an unknown key is refused and the nearest known one is suggested") {
  CHECK(fault_of(with("\"efects\": {}")) ==
        "efects: is not a key that is known here; did you mean \"effects\"?");
  CHECK(contains(fault_of(with("\"effects\": {\"drag\": {\"coeficient\": 1}}")),
                 "effects.drag.coeficient: is not a key that is known here; did you mean \"coefficient\"?"));
  CHECK(contains(fault_of(with("\"cloth_grid\": [{}, {\"Collumns\": 3}]")), "cloth_grid[1].Collumns"));
  CHECK(contains(fault_of(with("\"cloth_grid\": {\"Collumns\": 3}")), "\"columns\""));
  CHECK(contains(fault_of(with("\"rope\": {\"zzzzzzzzzz\": 3}")), "use one of: particles, start, end"));
  CHECK(contains(fault_of(with("\"method\": {\"euler\": {}}")), "method.euler"));
  CHECK(contains(fault_of(with("\"method\": {\"explicit_euler\": {\"order\": 2}}")), "remove it"));
  CHECK(contains(fault_of(with("\"accumulation\": \"scatter\"")), "use one of: gather, coloured, atomic"));
  CHECK(contains(fault_of(with("\"accumulation\": \"colored\"")), "did you mean \"coloured\"?"));
}

TEST_CASE("the nearest word") {
  const std::vector<std::string_view> words{"stretch", "shear", "bend"};
  CHECK(nearest("strech", words) == "stretch");
  CHECK(nearest("SHEAR", words) == "shear");
  CHECK(nearest("bond", words) == "bend");
  CHECK(nearest("temperature", words).empty());
  CHECK(nearest(std::string(1'000'000, 'a'), words).empty());
}

TEST_CASE("a value of the wrong type is refused") {
  CHECK(fault_of(with("\"seconds\": \"two\"")) == "seconds: is the text \"two\"; give a number");
  CHECK(fault_of(with("\"seconds\": null")) == "seconds: is null; give a number");
  CHECK(fault_of(with("\"name\": 3")) == "name: is 3; give a text in quotes");
  CHECK(fault_of(with("\"cloth_grid\": {\"columns\": 3.0}")) ==
        "cloth_grid.columns: is 3.0; give a whole number from 0 to 4294967295");
  CHECK(contains(fault_of(with("\"cloth_grid\": {\"columns\": -3}")), "cloth_grid.columns: is -3"));
  CHECK(contains(fault_of(with("\"cloth_grid\": {\"columns\": 4294967296}")), "is 4294967296"));
  CHECK(contains(fault_of(with("\"cloth_grid\": {\"columns\": true}")), "is true"));
  CHECK(contains(fault_of(with("\"cloth_grid\": 5")), "cloth_grid: is 5; give an object"));
  CHECK(contains(fault_of(with("\"effects\": {\"gravity\": {\"acceleration\": [0, 1]}}")),
                 "effects.gravity.acceleration: is a list of 2; give three numbers"));
  CHECK(contains(fault_of(with("\"effects\": {\"gravity\": {\"acceleration\": [0, 1, []]}}")),
                 "effects.gravity.acceleration[2]: is a list of 0; give a number"));
  CHECK(contains(fault_of(with("\"effects\": {\"gravity\": true}")), "effects.gravity: is true"));
  CHECK(contains(fault_of(with("\"pins\": {}")), "pins: is an object; give a list"));
  CHECK(contains(fault_of(with("\"triangles\": [[0, 0]]")), "triangles[0]: is a list of 2"));
  CHECK(contains(fault_of(with("\"method\": \"explicit_euler\"")), "method: is the text"));
}

TEST_CASE("a value out of range is refused at its place in the file") {
  CHECK(fault_of(with("\"effects\": {\"drag\": {\"coefficient\": -2}}")) ==
        "effects.drag.coefficient: is -2 N s/m; give a finite value >= 0");
  CHECK(contains(fault_of(with("\"effects\": {\"drag\": [{}, {\"coefficient\": -2}]}")),
                 "effects.drag[1].coefficient: is -2"));
  CHECK(contains(fault_of(with("\"rope\": [{}, {\"linear_density\": 0}]")),
                 "rope[1].linear_density: is 0 kg/m"));
  CHECK(contains(fault_of(with("\"cloth_grid\": {\"placement\": {\"scale\": 0}}")),
                 "cloth_grid.placement.scale: is 0"));
  CHECK(contains(fault_of(with("\"seconds\": 0")), "seconds: is 0"));
  CHECK(contains(fault_of(with("\"fps\": -1")), "fps: is -1"));
  CHECK(contains(fault_of(with("\"max_steps_per_advance\": 0")), "max_steps_per_advance: is 0"));
  CHECK(contains(fault_of(R"({"particles": {"mass": [1], "position": [[0,0,0]]}, "step": 0})"),
                 "step: is 0 s"));
}

TEST_CASE("the step is required") {
  const std::string fault = fault_of(R"({"particles": {"mass": [1], "position": [[0, 0, 0]]}})");
  CHECK(fault.starts_with("step: is missing; give the length of a step [s]"));
}

TEST_CASE("a scene of nothing is refused") {
  CHECK(contains(fault_of("{\"step\": 1}"), "has no particles"));
}

TEST_CASE("a function cannot be in a file") {
  CHECK(contains(
      fault_of(with("\"effects\": {\"field\": {\"shape\": {\"callback\": {}}}}")),
      "effects.field.shape.callback: is a function, which cannot be written in a file; use the library"));
}

TEST_CASE("a file has exactly one method") {
  CHECK(contains(fault_of(with("\"method\": {}")), "method: names 0 of these"));
  CHECK(contains(fault_of(with("\"method\": {\"explicit_euler\": {}, \"symplectic_euler\": {}}")),
                 "names 2 of these"));
}

TEST_CASE("lists of one particle or spring each must have one length") {
  CHECK(contains(fault_of(R"({"particles": {"mass": [1, 2], "position": [[0,0,0]]}, "step": 1})"),
                 "particles.mass: has 2 entries where the others have 1"));
  CHECK(
      contains(fault_of(R"({"particles": {"mass": [1], "position": [[0,0,0]], "velocity": []}, "step": 1})"),
               "particles.velocity: has 0 entries"));
  CHECK(contains(
      fault_of(with(R"("springs": {"first": [0], "second": [0], "stiffness": [], "rest_length": [1]})")),
      "springs.stiffness: has 0 entries"));
  CHECK(contains(fault_of(with(R"("springs": {"first": [0], "second": [0], "stiffness": [1]})")),
                 "springs.rest_length: is missing"));
}

TEST_CASE("springs and triangles of the file are named by their place in it, not in the scene") {
  const std::string rope = R"("rope": {"particles": 3}, )";
  CHECK(contains(
      fault_of(
          with(rope + R"("springs": {"first": [0], "second": [9], "stiffness": [1], "rest_length": [1]})")),
      "springs.second[0]: is 9"));
  CHECK(contains(
      fault_of(
          with(rope + R"("springs": {"first": [0], "second": [2], "stiffness": [-1], "rest_length": [1]})")),
      "springs.stiffness[0]: is -1 N/m"));
  CHECK(contains(
      fault_of(
          with(rope + R"("springs": {"first": [2], "second": [2], "stiffness": [1], "rest_length": [1]})")),
      "springs[0]: joins particle 2 to itself"));
  CHECK(contains(fault_of(with(rope + R"("triangles": [[0, 1, 7]])")), "triangles[0]: corner 2 is 7"));
  CHECK(contains(fault_of(R"({"particles": {"mass": [1, -2], "position": [[0,0,0],[1,0,0]]}, "step": 1})"),
                 "particles.mass[1]: is -2 kg"));
}

TEST_CASE("all faults of a file are found at once") {
  const auto faults = faults_of(R"({
    "colour": "red",
    "seconds": -1,
    "accumulation": "fast",
    "particles": {"mass": "heavy"},
    "cloth_grid": {"columns": 1, "spacing": -1, "strech": 3},
    "cloth_mesh": {"file": "no such file.obj"},
    "effects": {"drag": {"coefficient": -1}, "field": {"shape": {"callback": {}}}, "winds": {}},
    "method": {"leapfrog": {}}
  })");
  std::string text;
  for (const Fault& fault : faults) text += fault.element + "\n";
  for (const std::string_view place :
       {"colour", "seconds", "accumulation", "particles.mass", "particles.position", "cloth_grid.columns",
        "cloth_grid.spacing", "cloth_grid.strech", "cloth_mesh.file", "effects.drag.coefficient",
        "effects.field.shape.callback", "effects.winds", "method.leapfrog", "step"}) {
    CAPTURE(place);
    CHECK(contains("\n" + text, "\n" + std::string(place) + "\n"));
  }
  CHECK(faults.size() == 14);
}

TEST_CASE("a file with very many faults gives a list that can be read") {
  std::string masses = "\"x\"";
  for (int i = 0; i < 20'000; ++i) masses += ",\"x\"";
  const auto faults =
      faults_of("{\"step\": 1, \"particles\": {\"position\": [], \"mass\": [" + masses + "]}}");
  CHECK(faults.size() == 1001);
  CHECK(faults.back().message() == "file: has more faults than these; correct these first");
  const std::string text = SceneFileError("a.json", faults).what();
  CHECK(text.starts_with("a.json: 1001 faults\n  particles.mass[0]: "));
  CHECK(text.ends_with("... and 981 more"));
}

TEST_CASE("sizes are refused before memory is taken") {
  CHECK(contains(fault_of(with(R"("cloth_grid": {"columns": 100000, "rows": 100000})")),
                 "cloth_grid: makes a scene of 10000000001.0 particles; make it of at most 100000000"));
  CHECK(contains(fault_of(with(R"("block": {"nx": 4294967295, "ny": 4294967295, "nz": 4294967295})")),
                 "block: makes"));
  CHECK(contains(fault_of(with(R"("rope": {"particles": 4294967295})")), "rope: makes"));
  const SceneFileOptions small{.max_particles = 10};
  CHECK(contains(fault_of(with(R"("rope": [{"particles": 9}, {"particles": 2}])"), small), "rope[1]: makes"));
  CHECK(fault_of(with(R"("rope": {"particles": 9})"), small) == "0 faults:");
}

TEST_CASE("a path that is no file is refused") {
  const auto folder = std::filesystem::temp_directory_path();
  CHECK_THROWS_WITH_AS(read_scene_file(folder), doctest::Contains("is a folder"), SceneFileError);
  CHECK_THROWS_WITH_AS(read_scene_file(folder / "hooke no such scene.json"),
                       doctest::Contains("does not exist"), SceneFileError);
#ifdef __linux__
  CHECK_THROWS_WITH_AS(read_scene_file("/dev/zero"), doctest::Contains("is not an ordinary file"),
                       SceneFileError);
#endif
  CHECK_THROWS_AS(read_scene_file(std::string(100'000, 'a')), SceneFileError);
}

TEST_CASE("text from a file is made fit for a message") {
  CHECK(printable("caf\xc3\xa9 \xe2\x82\xac") == "caf\xc3\xa9 \xe2\x82\xac");
  CHECK(printable("a\nb\x1b[2J\x7f") == "a?b?[2J?");
  CHECK(printable("\xff\xc3") == "??");
  CHECK(printable(std::string(1000, 'x')) == std::string(160, 'x') + "...");
}
