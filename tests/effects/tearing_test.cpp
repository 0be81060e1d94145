#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include <hooke/hooke.h>

#include "effects/tearing_scenes.h"
#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

namespace {

Pieces pieces_by_springs(const Scene& scene) {
  Pieces pieces(scene.particles.size());
  for (std::size_t s = 0; s < scene.springs.size(); ++s)
    pieces.join(scene.springs.first[s], scene.springs.second[s]);
  return pieces;
}

double mass_of(const Scene& scene) {
  return std::accumulate(scene.particles.mass.begin(), scene.particles.mass.end(), 0.0);
}

double area_of(const Scene& scene) {
  const std::vector<Vec3>& x = scene.particles.position;
  double area = 0.0;
  for (const auto& [a, b, c] : scene.triangles) area += 0.5 * (x[b] - x[a]).cross(x[c] - x[a]).norm();
  return area;
}

/// A rope along x between two pins, one of which goes away at 0.5 m/s. The spring behind a particle is weak.
Scene pulled_rope(Index weak, double bend = 0.0) {
  Scene scene;
  const RopeParticles rope = add(scene, Rope{.particles = 21, .stretch = 1e3, .bend = bend, .damping = 0.1});
  for (std::size_t s = 0; s < scene.springs.size(); ++s) {
    if (scene.springs.first[s] == weak && scene.springs.second[s] == weak + 1)
      scene.springs.stiffness[s] = 500.0;
  }
  scene.pin(rope.at(0));
  scene.pin(rope.at(20), pull({1, 0, 0}, 2.0));
  scene.effects = {Tearing{.strain = 0.2}};
  return scene;
}

/// No spring joins two pieces of the triangles.
void check_no_bridges(const Scene& scene) {
  const Pieces pieces = pieces_by_triangles(scene);
  std::size_t bridges = 0;
  for (std::size_t s = 0; s < scene.springs.size(); ++s)
    bridges += pieces.of(scene.springs.first[s]) != pieces.of(scene.springs.second[s]) ? 1 : 0;
  CHECK(bridges == 0);
}

std::string fault_of(const Scene& scene) {
  const std::vector<Fault> faults = validate(scene);
  return faults.empty() ? "" : faults[0].message();
}

}  // namespace

TEST_CASE("tearing: a rope parts at its weak place, and mass and momentum are kept") {
  for (const double bend : {0.0, 20.0}) {
    CAPTURE(bend);
    const Scene scene = pulled_rope(7, bend);
    Simulation<double> rope(scene, {.step = 2e-3});
    Report report;
    while (report.particles_split == 0 && rope.steps() < 1000) {
      const Vec3 before = rope.momentum();
      report = rope.step();
      REQUIRE(report.ok());
      // Pins push by at most what a spring pulls with.
      CHECK((rope.momentum() - before).norm() < 2 * 2e-3 * 0.25 * 0.05 * 1e3);
    }
    REQUIRE(report.particles_split == 1);
    const auto torn = rope.snapshot().torn;
    REQUIRE(torn);
    CHECK(rope.particle_count() == 22);
    CHECK((rope.origin(21) == 7 || rope.origin(21) == 8));
    CHECK(rope.origin(5) == 5);
    CHECK_THROWS_AS(rope.origin(22), std::out_of_range);
    const Pieces pieces = pieces_by_springs(*torn);
    CHECK(pieces.count() == 2);
    CHECK(pieces.of(0) != pieces.of(20));
    CHECK(mass_of(*torn) == doctest::Approx(mass_of(scene)).epsilon(1e-15));
    CHECK(torn->particles.mass[21] == 0.5 * scene.particles.mass[rope.origin(21)]);
    REQUIRE(rope.step(500).ok());
    CHECK(pieces_by_springs(*rope.snapshot().torn).count() == 2);
  }
}

TEST_CASE("tearing: a tear changes neither momentum nor places, and adds no energy") {
  PulledCloth cloth = pulled_cloth();
  cloth.scene.pins.clear();
  for (Vec3& x : cloth.scene.particles.position) x.x() *= 1.5;
  for (std::size_t i = 0; i < cloth.scene.particles.size(); ++i)
    cloth.scene.particles.velocity.push_back(Vec3(0.1 * double(i % 3), 1.0, 0.2));
  Simulation<double> whole(cloth.scene, {.step = 1e-4});
  const Vec3 momentum = whole.momentum();
  REQUIRE(whole.step().particles_split > 0);
  CHECK((whole.momentum() - momentum).norm() < 1e-12);
  const Snapshot<double> after = whole.snapshot();
  for (Index i = 0; i < whole.particle_count(); ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(after.positions[3 * i + k] == after.positions[3 * whole.origin(i) + k]);
  }
  Scene uncut = cloth.scene;
  uncut.effects = {};
  Simulation<double> same(uncut, {.step = 1e-4});
  REQUIRE(same.step().ok());
  CHECK(whole.energy().kinetic == doctest::Approx(same.energy().kinetic).epsilon(1e-12));
  CHECK(whole.energy().elastic <= same.energy().elastic);
}

TEST_CASE("tearing: a cloth that is pulled apart comes to two pieces that no spring joins") {
  PulledCloth cloth = pulled_cloth();
  cloth.scene.effects.push_back(HingeBending{.stiffness = 1e-4});
  cloth.scene.effects.push_back(bending_of(cloth.grid, 0.1, 1e-3));
  Simulation<double> simulation(cloth.scene, {.step = 5e-3});
  CHECK(simulation.triangles().size() == cloth.scene.triangles.size());
  REQUIRE(tear_apart(simulation, 200));
  const Scene torn = *simulation.snapshot().torn;
  CHECK(torn.triangles.size() == cloth.scene.triangles.size());
  CHECK(std::ranges::equal(simulation.triangles(), torn.triangles));
  CHECK(area_of(torn) == doctest::Approx(area_of(cloth.scene)).epsilon(1e-14));
  CHECK(mass_of(torn) == doctest::Approx(mass_of(cloth.scene)).epsilon(1e-14));
  CHECK(*std::ranges::min_element(torn.particles.mass) > 0.0);
  const Pieces pieces = pieces_by_triangles(torn);
  CHECK(pieces.of(cloth.grid.at(0, 0)) != pieces.of(cloth.grid.at(9, 0)));
  check_no_bridges(torn);
  const auto& lines = std::get<LaplacianBending>(torn.effects[2]);
  CHECK(lines.stiffness.size() < std::get<LaplacianBending>(cloth.scene.effects[2]).stiffness.size());
  for (std::size_t line = 0; line < lines.stiffness.size(); ++line) {
    CHECK(pieces.of(lines.first[line]) == pieces.of(lines.middle[line]));
    CHECK(pieces.of(lines.last[line]) == pieces.of(lines.middle[line]));
  }
  // And they part: the pulled border goes on alone.
  const std::size_t particles = simulation.particle_count();
  REQUIRE(simulation.step(40).ok());
  CHECK(simulation.particle_count() >= particles);
  check_no_bridges(*simulation.snapshot().torn);
}

TEST_CASE("tearing: by force, and only the springs that are named") {
  for (const bool named : {true, false}) {
    Scene scene = pulled_rope(7);
    scene.effects = {Tearing{.force = 15.0, .springs = {named ? Index(7) : Index(15)}}};
    Simulation<double> rope(scene, {.step = 1e-3});
    Report report;
    while (report.particles_split == 0 && rope.steps() < 1900) report = rope.step();
    REQUIRE(report.particles_split == 1);
    const Index from = rope.origin(21);
    CHECK((named ? from == 7 || from == 8 : from == 15 || from == 16));
    const auto& tearing = std::get<Tearing>(rope.snapshot().torn->effects[0]);
    CHECK(tearing.springs.size() == 1);
  }
}

TEST_CASE("tearing: a spring with nothing to be split at its ends is gone, and is not looked at again") {
  Scene scene;
  scene.add_particle(1.0, Vec3::Zero());
  scene.add_particle(2.0, Vec3(0.5, 0, 0));
  scene.add_spring(0, 1, 100.0, 0.5);
  scene.pin(0);
  scene.effects = {Gravity{}, Tearing{.strain = 0.1, .springs = {0}}};
  Simulation<double> hung(scene, {.step = 1e-2});
  const Report report = hung.step(100);
  CHECK(report.ok());
  CHECK(report.particles_split == 0);
  CHECK(hung.spring_count() == 0);
  CHECK(hung.particle_count() == 2);
  // It falls freely from then on.
  const Vec3 before = velocity(hung, 1);
  REQUIRE(hung.step(10).ok());
  CHECK(velocity(hung, 1).y() - before.y() == doctest::Approx(-0.981).epsilon(1e-12));
}

TEST_CASE("tearing: a triangle keeps its edges however they are strained") {
  Scene scene;
  for (const Vec3& x : {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 1, 0)}) scene.add_particle(1.0, x);
  scene.add_spring(0, 1, 10.0, 1.0);
  scene.add_spring(1, 2, 10.0, 1.0);
  scene.add_spring(2, 0, 10.0, 1.0);
  scene.triangles = {{0, 1, 2}};
  scene.effects = {Tearing{.strain = 0.1}};
  Simulation<double> simulation(scene, {.step = 1e-2});
  const Report report = simulation.step(200);
  CHECK(report.ok());
  CHECK(report.particles_split == 0);
  CHECK(simulation.spring_count() == 3);
  CHECK(simulation.snapshot().torn == nullptr);
}

TEST_CASE("tearing: what is held is torn off, and the part that comes off is free") {
  PulledCloth cloth = pulled_cloth(6);
  // The next column is held too: the springs between the two are what is torn.
  std::vector<Index> column;
  for (Index row = 0; row < 6; ++row) column.push_back(cloth.grid.at(4, row));
  cloth.scene.effects.push_back(FrameAttachment{.particles = column});
  Simulation<double> simulation(cloth.scene, {.step = 5e-3});
  REQUIRE(tear_apart(simulation, 200));
  const Scene torn = *simulation.snapshot().torn;
  CHECK(torn.pins.size() == cloth.scene.pins.size());
  CHECK(std::get<FrameAttachment>(torn.effects[1]).particles == column);
  check_no_bridges(torn);
  const Pieces pieces = pieces_by_triangles(torn);
  CHECK(pieces.of(cloth.grid.at(5, 2)) != pieces.of(cloth.grid.at(4, 2)));
  CHECK(simulation.carried_force(1).force.norm() > 0.0);
}

TEST_CASE("tearing: the lists of effects go with what they name") {
  PulledCloth cloth = pulled_cloth(8);
  std::vector<Index> all(cloth.scene.springs.size()), particles(cloth.scene.particles.size());
  std::iota(all.begin(), all.end(), 0u);
  std::iota(particles.begin(), particles.end(), 0u);
  cloth.scene.effects = {Tearing{.strain = 0.3},
                         StiffeningSprings{.cubic = 1.0, .springs = {all.begin(), all.begin() + 20}},
                         Plasticity{.yield = 0.01, .rate = 0.5, .springs = {all.begin() + 20, all.end()}},
                         StrainLimit{.limit = 0.5, .springs = all},
                         ForceScript{particles, {{0.0, {0, 0, 1e-3}}, {10.0, {0, 0, 1e-3}}}},
                         TensileTriangles{.modulus = 10.0},
                         SelfCollision{.thickness = 5e-3}};
  Simulation<double> simulation(cloth.scene, {.step = 2e-3});
  Report report;
  Snapshot<double> before;
  while (report.particles_split == 0 && simulation.steps() < 1000) {
    before = simulation.snapshot();
    report = simulation.step();
    REQUIRE(report.ok());
  }
  REQUIRE(report.particles_split > 0);
  const Snapshot<double> after = simulation.snapshot();
  const Scene& torn = *after.torn;
  const std::size_t springs = torn.springs.size();
  const auto& stiffening = std::get<StiffeningSprings>(torn.effects[1]);
  const auto& plasticity = std::get<Plasticity>(torn.effects[2]);
  CHECK(stiffening.springs.size() + plasticity.springs.size() == springs);
  CHECK(std::get<StrainLimit>(torn.effects[3]).springs.size() == springs);
  CHECK(std::get<ForceScript>(torn.effects[4]).particles.size() == simulation.particle_count());
  CHECK(validate(torn).empty());
  // Creep: a step of it lies between the two, and springs between particles that were not split are in both.
  REQUIRE(after.effects.size() == plasticity.springs.size());
  std::map<std::pair<Index, Index>, double> creep;
  const auto& old = std::get<Plasticity>(cloth.scene.effects[2]).springs;
  for (std::size_t i = 0; i < old.size(); ++i)
    creep[{cloth.scene.springs.first[old[i]], cloth.scene.springs.second[old[i]]}] = before.effects[i];
  for (std::size_t i = 0; i < plasticity.springs.size(); ++i) {
    const Index s = plasticity.springs[i];
    const auto found =
        creep.find({simulation.origin(torn.springs.first[s]), simulation.origin(torn.springs.second[s])});
    REQUIRE(found != creep.end());
    CHECK(std::abs(found->second - after.effects[i]) < 2e-3 * 0.5 * 0.5 * 0.15);
  }
  REQUIRE(simulation.step(100).ok());
  check_no_bridges(*simulation.snapshot().torn);
}

TEST_CASE("tearing: values that make no sense are refused with a reason") {
  const auto with = [](const Tearing& tearing) {
    Scene scene = pulled_rope(3);
    scene.effects = {tearing};
    return fault_of(scene);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(with({.strain = 0.1}).empty());
  CHECK(with({.force = 10.0, .springs = {2, 3}}).empty());
  CHECK(with({}).find("strain and force are 0") != std::string::npos);
  CHECK(with({.strain = -0.1}).find("strain is -0.1") != std::string::npos);
  CHECK(with({.strain = nan}).find("strain is nan") != std::string::npos);
  CHECK(with({.strain = 0.1, .force = -2.0}).find("force is -2") != std::string::npos);
  CHECK(with({.force = nan}).find("force is nan") != std::string::npos);
  CHECK(with({.strain = 0.1, .springs = {99}}).find("springs[0] is 99") != std::string::npos);
  CHECK(with({.strain = 0.1, .springs = {1, 1}}).find("twice") != std::string::npos);
  Scene scene = pulled_rope(3);
  scene.springs.rest_length[4] = 0.0;
  CHECK(fault_of(scene).empty());
  scene.effects = {Tearing{.strain = 0.1, .springs = {4}}};
  CHECK(fault_of(scene).find("spring 4 has no rest length") != std::string::npos);
}

TEST_CASE("tearing: surfaces that must stay closed are refused, and others beside them are not") {
  PulledCloth cloth = pulled_cloth(4);
  Scene& scene = cloth.scene;
  const std::size_t springs = scene.springs.size(), triangles = scene.triangles.size();
  const BlockParticles box = add(scene, Block{.nx = 2, .ny = 2, .nz = 2});
  std::vector<Index> surface(scene.triangles.size() - triangles), cloth_springs(springs);
  std::iota(surface.begin(), surface.end(), Index(triangles));
  std::iota(cloth_springs.begin(), cloth_springs.end(), 0u);
  scene.effects = {Tearing{.strain = 0.3, .springs = cloth_springs},
                   Volume{.bulk_modulus = 10.0, .triangles = surface}};
  CHECK(box.first == 16);
  CHECK(fault_of(scene).empty());
  std::get<Tearing>(scene.effects[0]).springs.clear();
  CHECK(fault_of(scene).find("must stay closed") != std::string::npos);
}
