#include "scene_file/mesh_file.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "scene_text.h"

using namespace hooke;

namespace {

MeshFile read(const std::string& obj, std::size_t max_vertices = 1000) {
  std::istringstream stream(obj);
  return read_mesh(stream, max_vertices);
}

std::string fault(const std::string& obj, std::size_t max_vertices = 1000) {
  try {
    read(obj, max_vertices);
  } catch (const FileFault& found) {
    return found.problem;
  }
  return {};
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\n";

}  // namespace

TEST_CASE("vertices and triangles are read; all else in an OBJ file is passed over") {
  const MeshFile mesh = read("# a comment\nmtllib none.mtl\no thing\ng\nvn 0 1 0\nvt 0 0\n" + square +
                             "usemtl none\ns off\nf 1/1/1 2/1/1 3/1/1\nf 1//1 3//1 4//1\nl 1 2\n");
  REQUIRE(mesh.vertices.size() == 4);
  CHECK(mesh.vertices[2] == Vec3(1, 0, 1));
  CHECK(mesh.triangles == std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}});
}

TEST_CASE("faces of more than three corners become a fan") {
  CHECK(read(square + "f 1 2 3 4\n").triangles == std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}});
}

TEST_CASE("negative numbers count back, and a face may come before its vertices") {
  CHECK(read(square + "f -4 -3 -2\n").triangles == std::vector<Triangle>{{0, 1, 2}});
  CHECK(read("f 1 2 3\n" + square).triangles == std::vector<Triangle>{{0, 1, 2}});
}

TEST_CASE("meshes that cannot be are refused") {
  CHECK(fault("") == "has no faces (and 0 vertices)");
  CHECK(fault(square) == "has no faces (and 4 vertices)");
  CHECK(fault(square + "f 1 2 5\n") == "face 1 names vertex 5, but there are 4");
  CHECK(fault(square + "f 1 2 3\nf 0 1 2\n") == "face 2 names vertex 0");
  CHECK(fault(square + "f 1 2 -5\n") == "face 1 names vertex -5");
  CHECK(fault(square + "f 1 2 -2147483648\n") == "face 1 names vertex -2147483648");
  CHECK(fault(square + "f 1 2 2147483647\n") == "face 1 names vertex 2147483647, but there are 4");
  CHECK(fault(square + "f 1 2\n") == "face 1 has 2 corners");
  CHECK(fault("v 1e999 0 0\n" + square + "f 1 2 3\n") == "vertex 1 is not finite");
  CHECK(fault(square + "f 1 2 3\n", 3) == "has more than 3 vertices");
}

TEST_CASE("a face of very many corners takes no longer than its line") {
  std::string obj = square + "f";
  for (int i = 0; i < 200'000; ++i) obj += " " + std::to_string(i % 4 + 1);
  CHECK(read(obj).triangles.size() == 199'998);
}

TEST_CASE("a scene file names its mesh, and the options may name another") {
  const auto folder = std::filesystem::temp_directory_path() / "hooke_mesh_file_test";
  std::filesystem::create_directory(folder);
  std::ofstream(folder / "square.obj") << square << "f 1 2 3 4\n";
  const std::string scene = R"({"step": 0.001, "cloth_mesh": {"file": "square.obj"}})";
  CHECK(parse_scene(scene, folder).scene.particles.size() == 4);
  CHECK(parse_scene(R"({"step": 0.001, "cloth_mesh": [{"file": "none.obj"}, {}]})", {},
                    {.mesh = folder / "square.obj"})
            .scene.particles.size() == 8);
  CHECK_THROWS_WITH_AS(parse_scene(R"({"step": 0.001, "cloth_mesh": {"file": "none.obj"}})", folder),
                       doctest::Contains("--mesh FILE.obj"), SceneFileError);
  CHECK_THROWS_WITH_AS(
      parse_scene(R"({"step": 0.001, "cloth_mesh": {}})", folder),
      doctest::Contains("cloth_mesh.file: is missing; name an OBJ file here, or with --mesh"),
      SceneFileError);
  CHECK_THROWS_WITH_AS(parse_scene(R"({"step": 0.001, "cloth_mesh": {"file": "."}})", folder),
                       doctest::Contains("is a folder"), SceneFileError);
  CHECK_THROWS_WITH_AS(parse_scene(scene, folder, {.max_particles = 3}),
                       doctest::Contains("more than 3 vertices"), SceneFileError);
  std::filesystem::remove_all(folder);
}

TEST_CASE("a collider's mesh may be a file") {
  const auto folder = std::filesystem::temp_directory_path() / "hooke_mesh_collider_test";
  std::filesystem::create_directory(folder);
  std::ofstream(folder / "tetrahedron.obj")
      << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  const auto scene = [](const std::string& mesh) {
    return R"({"step": 0.001, "particles": {"mass": [1], "position": [[5, 5, 5]]},
               "effects": {"collider": {"shape": {"mesh": )" +
           mesh + "}}}}";
  };
  const Scene read = parse_scene(scene(R"({"file": "tetrahedron.obj", "scale": 0.5})"), folder).scene;
  const auto& mesh = std::get<MeshShape>(std::get<Collider>(read.effects.at(0)).shape);
  CHECK(mesh.vertices.at(3) == Vec3(0, 0, 1));
  CHECK(mesh.triangles.at(2) == Triangle{1, 2, 3});
  CHECK(mesh.scale == 0.5);
  for (const auto& [text, expected] :
       {std::pair(R"({"file": "none.obj"})", "effects.collider.shape.mesh.file: mesh "),
        std::pair(R"({"file": "tetrahedron.obj", "vertices": []})", "is given beside vertices or triangles"),
        std::pair(R"({"file": 3})", "effects.collider.shape.mesh.file"),
        std::pair(R"({"vertices": [[0, 0, 0]], "triangles": [[0, 0, 9]]})", "the number of vertices is 1")})
    CHECK_THROWS_WITH_AS(parse_scene(scene(text), folder), doctest::Contains(expected), SceneFileError);
  std::filesystem::remove_all(folder);
}
