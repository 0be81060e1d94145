#include "writers/vtp_writer.h"

#include <doctest/doctest.h>

#include "program/files.h"
#include "program/sample_scenes.h"
#include "program/vtp_file.h"
#include "writers/atomic_file.h"

namespace hooke {
namespace {

using test::names_in;
using test::read_pvd;
using test::read_vtp;
using test::TemporaryFolder;
using test::VtpFile;

VtpFile write_and_read(const Scene& scene, NumberType numbers) {
  const TemporaryFolder folder;
  VtpWriter writer(scene, {folder.path(), "cloth", numbers});
  const std::vector<Vec3> velocities = scene.particles.size() == 4
                                           ? test::two_triangles_velocities()
                                           : std::vector<Vec3>(scene.particles.size(), Vec3::Zero());
  writer.write({0.25, scene.particles.position, velocities});
  writer.finish();
  return read_vtp(folder / "cloth_0000.vtp");
}

std::vector<double> flat(const std::vector<Vec3>& vectors) {
  std::vector<double> values;
  for (const Vec3& vector : vectors) values.insert(values.end(), vector.begin(), vector.end());
  return values;
}

TEST_CASE("a VTP file has points, velocity and strain of each particle and the triangles") {
  const Scene scene = test::two_triangles();
  const VtpFile file = write_and_read(scene, NumberType::float64);
  CHECK(
      file.xml.find("type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\"") !=
      std::string::npos);
  CHECK(file.time == 0.25);
  CHECK(file.piece("NumberOfPoints") == 4);
  CHECK(file.piece("NumberOfPolys") == 2);
  CHECK(file.piece("NumberOfLines") == 0);
  CHECK(file.piece("NumberOfVerts") == 0);
  CHECK(file.arrays.size() == 5);
  CHECK(file.arrays.at("Points").components == 3);
  CHECK(file.arrays.at("Points").values == flat(scene.particles.position));
  CHECK(file.arrays.at("velocity").components == 3);
  CHECK(file.arrays.at("velocity").values == flat(test::two_triangles_velocities()));
  CHECK(file.arrays.at("strain").components == 1);
  StrainField field(scene);
  const auto strain = field.at(scene.particles.position);
  CHECK(file.arrays.at("strain").values == std::vector<double>(strain.begin(), strain.end()));
  CHECK(file.arrays.at("connectivity").values == std::vector<double>{0, 1, 2, 0, 2, 3});
  CHECK(file.arrays.at("offsets").values == std::vector<double>{3, 6});
}

TEST_CASE("VTP files follow a scene that tears") {
  const TemporaryFolder folder;
  const Scene whole = test::two_triangles(), torn = test::torn_triangles();
  VtpWriter writer(whole, {folder.path(), "cloth", NumberType::float64});
  writer.write({0.0, whole.particles.position, test::two_triangles_velocities()});
  writer.write({1.0, torn.particles.position, std::vector<Vec3>(6, Vec3::Zero()), &torn});
  writer.finish();
  CHECK(read_vtp(folder / "cloth_0000.vtp").piece("NumberOfPoints") == 4);
  const VtpFile file = read_vtp(folder / "cloth_0001.vtp");
  CHECK(file.piece("NumberOfPoints") == 6);
  CHECK(file.arrays.at("connectivity").values == std::vector<double>{0, 1, 2, 4, 5, 3});
  StrainField field(torn);
  const auto strain = field.at(torn.particles.position);
  CHECK(file.arrays.at("strain").values == std::vector<double>(strain.begin(), strain.end()));
}

TEST_CASE("the type of a VTP file's numbers follows the precision") {
  const VtpFile wide = write_and_read(test::two_triangles(), NumberType::float64);
  const VtpFile narrow = write_and_read(test::two_triangles(), NumberType::float32);
  for (const char* name : {"Points", "velocity", "strain"}) {
    CHECK(wide.arrays.at(name).type == "Float64");
    CHECK(narrow.arrays.at(name).type == "Float32");
  }
  for (std::size_t i = 0; i < 12; ++i) {
    const auto expected = static_cast<float>(wide.arrays.at("velocity").values[i]);
    CHECK(narrow.arrays.at("velocity").values[i] == static_cast<double>(expected));
  }
}

TEST_CASE("without triangles the springs are drawn, and without springs the particles") {
  Scene scene = test::two_triangles();
  scene.triangles.clear();
  const VtpFile lines = write_and_read(scene, NumberType::float32);
  CHECK(lines.piece("NumberOfLines") == 5);
  CHECK(lines.piece("NumberOfPolys") == 0);
  CHECK(lines.arrays.at("connectivity").values == std::vector<double>{0, 1, 1, 2, 2, 0, 2, 3, 3, 0});
  CHECK(lines.arrays.at("offsets").values == std::vector<double>{2, 4, 6, 8, 10});
  scene.springs = {};
  const VtpFile points = write_and_read(scene, NumberType::float32);
  CHECK(points.piece("NumberOfVerts") == 4);
  CHECK(points.arrays.at("connectivity").values == std::vector<double>{0, 1, 2, 3});
  CHECK(points.arrays.at("offsets").values == std::vector<double>{1, 2, 3, 4});
}

TEST_CASE("arrays longer than a piece of the writer's buffer are whole") {
  Scene scene;
  for (int i = 0; i < 10'000; ++i) scene.add_particle(1.0, {1.0 * i, -2.0 * i, 0.5 * i});
  const VtpFile file = write_and_read(scene, NumberType::float64);
  CHECK(file.arrays.at("Points").values == flat(scene.particles.position));
}

TEST_CASE("numbers beyond a file's range become its largest, not infinite") {
  Scene scene;
  scene.add_particle(1.0, {1e300, -1e300, 0.0});
  const VtpFile file = write_and_read(scene, NumberType::float32);
  const double largest = std::numeric_limits<float>::max();
  CHECK(file.arrays.at("Points").values == std::vector<double>{largest, -largest, 0.0});
}

TEST_CASE("a collection lists every frame with its time, and only files that are there") {
  const TemporaryFolder folder;
  const Scene scene = test::two_triangles();
  VtpWriter writer(scene, {folder.path(), "a<b>&\"c\"", NumberType::float32});
  constexpr std::size_t frames = 40;
  for (std::size_t i = 0; i < frames; ++i) {
    writer.write({0.1 * static_cast<double>(i), scene.particles.position, test::two_triangles_velocities()});
    const auto listed = read_pvd(writer.entry());
    CHECK(listed.size() <= i + 1);
    CHECK(listed.size() * 17 >= (i + 1) * 16);  // a killed run loses a sixteenth at most
  }
  writer.finish();
  const std::string name = "a&lt;b&gt;&amp;&quot;c&quot;_0039.vtp";
  const auto listed = read_pvd(writer.entry());
  REQUIRE(listed.size() == frames);
  CHECK(listed.back().file == name);
  CHECK(listed.back().time == 0.1 * 39);
  CHECK(writer.files().size() == frames + 1);
  std::set<std::string> written;
  for (const auto& file : writer.files()) written.insert(file.filename().string());
  CHECK(written == names_in(folder));
}

TEST_CASE("frames that cannot be written are an error that names the file") {
  const TemporaryFolder folder;
  const Scene scene = test::two_triangles();
  for (const FileFormat format : {FileFormat::vtp, FileFormat::obj, FileFormat::pc2}) {
    const auto writer = make_frame_writer(format, scene, {folder / "gone", "cloth", NumberType::float32});
    const Frame frame{0.0, scene.particles.position, scene.particles.position};
    try {
      writer->write(frame);
      FAIL("no error");
    } catch (const WriteError& error) {
      CHECK(std::string(error.what()).find((folder / "gone/cloth").string()) != std::string::npos);
    }
    CHECK(writer->files().empty());
  }
}

}  // namespace
}  // namespace hooke
