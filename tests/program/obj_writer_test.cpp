#include "writers/obj_writer.h"

#include <sstream>

#include <doctest/doctest.h>

#include "program/files.h"
#include "program/sample_scenes.h"

namespace hooke {
namespace {

using test::names_in;
using test::read_file;
using test::TemporaryFolder;

std::string write_and_read(const Scene& scene, NumberType numbers) {
  const TemporaryFolder folder;
  ObjWriter writer(scene, {folder.path(), "cloth", numbers});
  writer.write({0.0, scene.particles.position, {}});
  return read_file(folder / "cloth_0000.obj");
}

std::vector<std::string> lines(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> result;
  for (std::string line; std::getline(in, line);) result.push_back(line);
  return result;
}

TEST_CASE("an OBJ file has a vertex for each particle and the triangles, counted from 1") {
  CHECK(lines(write_and_read(test::two_triangles(), NumberType::float32)) ==
        std::vector<std::string>{"v 0 0.25 0.5", "v 1 0.125 -0.5", "v 0.75 2 0.0625", "v -1.5 1.75 3",
                                 "f 1 2 3", "f 1 3 4"});
}

TEST_CASE("an OBJ file has lines for springs, or points, where there are no triangles") {
  Scene scene = test::two_triangles();
  scene.triangles.clear();
  CHECK(lines(write_and_read(scene, NumberType::float32)).back() == "l 4 1");
  scene.springs = {};
  CHECK(lines(write_and_read(scene, NumberType::float32)).back() == "p 4");
}

TEST_CASE("numbers in an OBJ file read back as they were") {
  Scene scene;
  const double third = 1.0 / 3.0;
  scene.add_particle(1.0, {third, -third * 1e-9, third * 1e9});
  for (const NumberType type : {NumberType::float32, NumberType::float64}) {
    std::istringstream in(write_and_read(scene, type));
    std::string keyword;
    double x = 0.0, y = 0.0, z = 0.0;
    in >> keyword >> x >> y >> z;
    if (type == NumberType::float64) {
      CHECK(Vec3(x, y, z) == scene.particles.position[0]);
    } else {
      CHECK(Vec3(x, y, z).cast<float>() == scene.particles.position[0].cast<float>());
    }
  }
}

TEST_CASE("frames get one OBJ file each") {
  const TemporaryFolder folder;
  const Scene scene = test::two_triangles();
  ObjWriter writer(scene, {folder.path(), "cloth", NumberType::float32});
  for (int i = 0; i < 3; ++i) writer.write({0.0, scene.particles.position, {}});
  writer.finish();
  CHECK(names_in(folder) == std::set<std::string>{"cloth_0000.obj", "cloth_0001.obj", "cloth_0002.obj"});
  CHECK(writer.files().size() == 3);
  CHECK(writer.entry() == folder / "cloth_0000.obj");
}

}  // namespace
}  // namespace hooke
