#include <doctest/doctest.h>

#include <algorithm>
#include <ctime>
#include <map>
#include <numeric>

#include <hooke/hooke.h>

#include "collide/local_shape.h"
#include "effects/solid_meshes.h"
#include "scenes.h"

using namespace hooke;

namespace {

/// Which particles hang together: the lowest of each piece.
class Pieces {
 public:
  explicit Pieces(std::size_t particles) : lowest_(particles) {
    std::iota(lowest_.begin(), lowest_.end(), 0u);
  }

  void join(Index a, Index b) {
    const auto [low, high] = std::minmax({of(a), of(b)});
    lowest_[high] = low;
  }
  Index of(Index particle) const {
    while (lowest_[particle] != particle) particle = lowest_[particle];
    return particle;
  }
  std::size_t count() const {
    std::size_t found = 0;
    for (Index i = 0; i < lowest_.size(); ++i) found += lowest_[i] == i ? 1 : 0;
    return found;
  }

 private:
  std::vector<Index> lowest_;
};

Pieces pieces_by_triangles(const Scene& scene) {
  Pieces pieces(scene.particles.size());
  for (const auto& [a, b, c] : scene.triangles) {
    pieces.join(a, b);
    pieces.join(b, c);
  }
  return pieces;
}

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

std::vector<Keyframe> pull(const Vec3& way, double seconds) {
  return {{0.0, Vec3::Zero()}, {seconds, way}};
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

struct PulledCloth {
  Scene scene;
  GridParticles grid;
};

/// A cloth whose left and right borders are pinned and pulled apart along x. The springs over its middle are
/// weak in its first rows, so that it begins to tear there.
PulledCloth pulled_cloth(Index size = 10) {
  PulledCloth cloth;
  cloth.grid = add(cloth.scene, ClothGrid{.columns = size, .rows = size, .spacing = 0.1, .damping = 0.05});
  for (Index row = 0; row < size; ++row) {
    cloth.scene.pin(cloth.grid.at(0, row));
    cloth.scene.pin(cloth.grid.at(size - 1, row), pull({1, 0, 0}, 1.0));
  }
  Springs& springs = cloth.scene.springs;
  const Index middle = size / 2;
  for (std::size_t s = 0; s < springs.size(); ++s) {
    const Index a = springs.first[s], b = springs.second[s];
    const bool over_line = (a % size < middle) != (b % size < middle);
    if (over_line && a / size < size / 3 && b / size < size / 3) springs.stiffness[s] *= 0.3;
  }
  cloth.scene.effects = {Tearing{.strain = 0.3}};
  return cloth;
}

/// Takes steps until the cloth is in pieces by its triangles; false where it does not come to that.
template <class Real>
bool tear_apart(Simulation<Real>& simulation, std::uint64_t most_steps) {
  for (std::uint64_t i = 0; i < most_steps; ++i) {
    if (!simulation.step().ok()) return false;
    const auto torn = simulation.snapshot().torn;
    if (torn && pieces_by_triangles(*torn).count() > 1) return true;
  }
  return false;
}

/// No spring joins two pieces of the triangles.
void check_no_bridges(const Scene& scene) {
  const Pieces pieces = pieces_by_triangles(scene);
  std::size_t bridges = 0;
  for (std::size_t s = 0; s < scene.springs.size(); ++s)
    bridges += pieces.of(scene.springs.first[s]) != pieces.of(scene.springs.second[s]) ? 1 : 0;
  CHECK(bridges == 0);
}

template <class Real>
void check_same_state(const Simulation<Real>& a, const Simulation<Real>& b) {
  CHECK(a.particle_count() == b.particle_count());
  CHECK(a.spring_count() == b.spring_count());
  CHECK(std::ranges::equal(a.triangles(), b.triangles()));
  CHECK(a.state_hash() == b.state_hash());
  CHECK(a.energy().total() == b.energy().total());
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

TEST_CASE("tearing: the same bits on any number of threads, gathered and coloured") {
  const Scene scene = pulled_cloth().scene;
  for (const Accumulation accumulation : {Accumulation::gather, Accumulation::coloured}) {
    Simulation<float> one(scene, {.step = 5e-3, .accumulation = accumulation, .threads = 1});
    REQUIRE(one.step(120).particles_split > 0);
    for (const unsigned threads : {2u, 4u}) {
      Simulation<float> more(scene, {.step = 5e-3, .accumulation = accumulation, .threads = threads});
      REQUIRE(more.step(120).ok());
      check_same_state(one, more);
    }
  }
}

TEST_CASE("tearing: by every method, and snapshots from before and after tears go on with the same bits") {
  const Scene scene = pulled_cloth(7).scene;
  for (const Method& method : all_methods) {
    CAPTURE(to_string(method));
    const Settings settings{.method = method, .step = 5e-3};
    Simulation<double> whole(scene, settings), restored(scene, settings), torn(scene, settings);
    const Snapshot<double> start = whole.snapshot();
    CHECK_FALSE(start.torn);
    Report report;
    while (report.particles_split == 0 && whole.steps() < 200) report = whole.step();
    REQUIRE(report.particles_split > 0);
    const Snapshot<double> middle = whole.snapshot();
    REQUIRE(middle.torn);
    REQUIRE(whole.step(15).ok());
    CHECK(whole.particle_count() > middle.positions.size() / 3);
    restored.restore(middle);
    REQUIRE(restored.step(15).ok());
    check_same_state(whole, restored);
    restored.restore(start);
    CHECK(restored.particle_count() == scene.particles.size());
    REQUIRE(restored.step(middle.step).ok());
    CHECK(restored.snapshot().positions == middle.positions);
    torn.restore(whole.snapshot());
    check_same_state(whole, torn);
    restored.restore(middle);
    CHECK(restored.snapshot().relaxing == middle.relaxing);
    CHECK(restored.origin(Index(scene.particles.size())) == middle.torn_from[0]);
  }
}

TEST_CASE("tearing: a scene that does not tear has the same bits as one that cannot") {
  for (const Method& method : {Method(SymplecticEuler{}), Method(Verlet{}), Method(Bdf2{})}) {
    CAPTURE(to_string(method));
    Scene with = test::hung_cloth(12, 9), without = with;
    with.effects.push_back(Tearing{.strain = 100.0, .force = 1e9});
    const Settings settings{.method = method, .step = 1e-2};
    Simulation<float> a(with, settings), b(without, settings);
    const Report torn = a.step(50), whole = b.step(50);
    REQUIRE(torn.ok());
    CHECK(torn.steps_taken == 50);
    CHECK(torn.force_evaluations == whole.force_evaluations);
    CHECK(torn.step == whole.step);
    CHECK(a.state_hash() == b.state_hash());
    CHECK(a.snapshot().torn == nullptr);
    CHECK(b.triangles().empty());
    CHECK(b.origin(3) == 3);
    // Nothing of it is in a plan that does not name it.
    CHECK(a.plan().stages.size() == b.plan().stages.size() + 1);
  }
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
  const Vec3 before = test::velocity(hung, 1);
  REQUIRE(hung.step(10).ok());
  CHECK(test::velocity(hung, 1).y() - before.y() == doctest::Approx(-0.981).epsilon(1e-12));
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

TEST_CASE("tearing: new particles are like others to who asks from outside") {
  Simulation<float> cloth(pulled_cloth().scene, {.step = 5e-3});
  while (cloth.step().particles_split == 0) REQUIRE(cloth.steps() < 200);
  const Index added = Index(cloth.particle_count() - 1);
  std::vector<float> before(3 * cloth.particle_count()), now = before;
  cloth.copy_positions(before.data(), 3 * sizeof(float), 0.0);
  cloth.copy_positions(now.data(), 3 * sizeof(float), 1.0);
  CHECK(before != now);
  for (std::size_t k = 0; k < 3; ++k) CHECK(before[3 * added + k] == before[3 * cloth.origin(added) + k]);
  const Vec3 speed = test::velocity(cloth, added);
  cloth.apply_impulse(added, {0, 0, 0.01});
  CHECK(test::velocity(cloth, added).z() > speed.z());
  CHECK_NOTHROW(cloth.stability());
  REQUIRE(cloth.step(20).ok());
  // Nothing is left between a tear and who restores one that is none.
  Snapshot<float> wrong = cloth.snapshot();
  wrong.torn_from.pop_back();
  const std::uint64_t hash = cloth.state_hash();
  CHECK_THROWS_AS(cloth.restore(wrong), std::invalid_argument);
  wrong = cloth.snapshot();
  wrong.torn_from[0] = 1000;
  CHECK_THROWS_AS(cloth.restore(wrong), std::invalid_argument);
  wrong = cloth.snapshot();
  wrong.relaxing = {{100000, 1.0}};
  CHECK_THROWS_AS(cloth.restore(wrong), std::invalid_argument);
  wrong = cloth.snapshot();
  auto broken = std::make_shared<Scene>(*wrong.torn);
  broken->springs.first[0] = 5000;
  wrong.torn = broken;
  CHECK_THROWS_AS(cloth.restore(wrong), std::invalid_argument);
  wrong = cloth.snapshot();
  wrong.positions.pop_back();
  CHECK_THROWS_AS(cloth.restore(wrong), std::invalid_argument);
  CHECK(cloth.state_hash() == hash);
  Scene whole = pulled_cloth().scene;
  whole.effects = {};
  Simulation<float> other(whole, {.step = 5e-3});
  CHECK_THROWS_AS(other.restore(cloth.snapshot()), std::invalid_argument);
}

TEST_CASE("tearing: a run whose steps are not to be divided goes on where lighter particles need it") {
  const Scene scene = pulled_cloth().scene;
  const double longest = largest_stable_step(scene, SymplecticEuler{});
  const Settings settings{.step = 0.99 * longest, .unstable_step = UnstableStep::refuse};
  Simulation<double> simulation(scene, settings);
  const Snapshot<double> start = simulation.snapshot();
  REQUIRE(tear_apart(simulation, 2000));
  CHECK(simulation.settings().unstable_step == UnstableStep::divide);
  simulation.restore(start);
  CHECK(simulation.settings().unstable_step == UnstableStep::refuse);
}

TEST_CASE("tearing: a mesh is prepared once for what has the same reach, and seen by each apart") {
  using Shape = LookedUpShape<MeshDistance<float>>;
  const ColliderShape mesh = test::box_mesh({0.5, 0.3, 0.7});
  PreparedMeshes meshes, others;
  const auto shape = [&](double reach, PreparedMeshes& from) {
    return std::get<Shape>(local_shape<float>(mesh, reach, 1, from));
  };
  const Shape first = shape(0.1, meshes), second = shape(0.1, meshes);
  CHECK(first.distances == second.distances);
  CHECK(first.seen != second.seen);
  CHECK(first.distances != shape(0.2, meshes).distances);
  CHECK(first.distances != shape(0.1, others).distances);
  CHECK(meshes.size() == 2);
}

TEST_CASE("tearing: the torn scene goes on with the meshes that were prepared for the whole one") {
  PulledCloth cloth = pulled_cloth(4);
  MeshShape mesh = test::bumpy_mesh(3);
  for (Vec3& vertex : mesh.vertices) vertex.y() -= 5.0;
  cloth.scene.effects.push_back(Collider{.shape = mesh, .thickness = 0.01});
  const std::clock_t begun = std::clock();
  Simulation<float> simulation(cloth.scene, {.step = 5e-3, .threads = 1});
  const std::clock_t made = std::clock();
  REQUIRE(tear_apart(simulation, 200));
  CHECK(double(std::clock() - made) < 0.5 * double(made - begun));
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
