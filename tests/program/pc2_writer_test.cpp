#include "writers/pc2_writer.h"

#include <cstring>

#include <doctest/doctest.h>

#include "program/files.h"
#include "program/sample_scenes.h"

namespace hooke {
namespace {

using test::count;
using test::names_in;
using test::read_file;
using test::TemporaryFolder;

template <class T>
T value_at(const std::string& bytes, std::size_t offset) {
  T value{};
  REQUIRE(offset + sizeof value <= bytes.size());
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

TEST_CASE("a PC2 file has its header, then the positions of each frame") {
  const TemporaryFolder folder;
  const Scene scene = test::two_triangles();
  Pc2Writer writer(scene, {folder.path(), "cloth", NumberType::float64});
  constexpr int frames = 3;
  for (int frame = 0; frame < frames; ++frame) {
    std::vector<Vec3> positions = scene.particles.position;
    for (Vec3& position : positions) position.x() += frame;
    writer.write({0.1 * frame, positions, {}});
    CHECK(names_in(folder) == std::set<std::string>{"cloth.obj", "cloth.pc2.partial"});
  }
  writer.finish();
  CHECK(names_in(folder) == std::set<std::string>{"cloth.obj", "cloth.pc2"});

  const std::string bytes = read_file(folder / "cloth.pc2");
  REQUIRE(bytes.size() == 32 + frames * 4 * 3 * sizeof(float));
  CHECK(bytes.substr(0, 12) == std::string("POINTCACHE2\0", 12));
  CHECK(value_at<std::int32_t>(bytes, 12) == 1);       // version
  CHECK(value_at<std::int32_t>(bytes, 16) == 4);       // points
  CHECK(value_at<float>(bytes, 20) == 0.0F);           // start frame
  CHECK(value_at<float>(bytes, 24) == 1.0F);           // frames for each sample
  CHECK(value_at<std::int32_t>(bytes, 28) == frames);  // samples
  std::size_t offset = 32;
  for (int frame = 0; frame < frames; ++frame) {
    for (const Vec3& position : scene.particles.position) {
      CHECK(value_at<float>(bytes, offset) == static_cast<float>(position.x() + frame));
      CHECK(value_at<float>(bytes, offset + 4) == static_cast<float>(position.y()));
      CHECK(value_at<float>(bytes, offset + 8) == static_cast<float>(position.z()));
      offset += 12;
    }
  }
}

TEST_CASE("beside a PC2 file lies the mesh of its first frame, with as many vertices") {
  const TemporaryFolder folder;
  const Scene scene = test::two_triangles();
  Pc2Writer writer(scene, {folder.path(), "cloth", NumberType::float32});
  writer.write({0.0, scene.particles.position, {}});
  writer.finish();
  const std::string mesh = read_file(folder / "cloth.obj");
  CHECK(count(mesh, "v ") == 4);
  CHECK(count(mesh, "f ") == 2);
  CHECK(mesh.substr(0, 13) == "v 0 0.25 0.5\n");
  CHECK(writer.files().size() == 2);
}

TEST_CASE("a PC2 file that is never finished leaves no file of that name") {
  const TemporaryFolder folder;
  const Scene scene = test::two_triangles();
  {
    Pc2Writer writer(scene, {folder.path(), "cloth", NumberType::float32});
    writer.write({0.0, scene.particles.position, {}});
  }
  CHECK(names_in(folder) == std::set<std::string>{"cloth.obj"});
}

TEST_CASE("a PC2 file of a scene that tears is refused, as it has one number of points") {
  const TemporaryFolder folder;
  const Scene whole = test::two_triangles(), torn = test::torn_triangles();
  Pc2Writer writer(whole, {folder.path(), "cloth", NumberType::float32});
  writer.write({0.0, whole.particles.position, {}});
  CHECK_THROWS_WITH_AS(writer.write({1.0, torn.particles.position, {}, &torn}),
                       doctest::Contains("to 6 particles from 4; use --format vtp or obj"), WriteError);
}

}  // namespace
}  // namespace hooke
