#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <vector>

#include <Eigen/Geometry>

#include "collide/box_tree.h"
#include "collide/close_pairs.h"
#include "collide/closest_points.h"
#include "collide/contact_sweeps.h"
#include "collide/impact_zones.h"
#include "collide/narrow_phase.h"
#include "collide/swept_test.h"

using namespace hooke;

namespace {

class Random {
 public:
  explicit Random(unsigned seed) : random_(seed) {}
  double unit() { return double(random_()) / 4294967296.0; }
  Vec3 vector() {
    const double x = unit(), y = unit(), z = unit();
    return {2.0 * x - 1.0, 2.0 * y - 1.0, 2.0 * z - 1.0};
  }
  PairPlaces places() { return {vector(), vector(), vector(), vector()}; }

 private:
  std::mt19937 random_;
};

/// The distance of two pieces by looking at a fine grid of points on both.
double sampled_distance(PairKind kind, const PairPlaces& x) {
  constexpr int n = 120;
  double nearest = INFINITY;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      const double u = double(i) / n, v = double(j) / n;
      if (kind == PairKind::edge_edge)
        nearest = std::min(nearest, (x[0] + u * (x[1] - x[0]) - x[2] - v * (x[3] - x[2])).norm());
      else if (i + j <= n)
        nearest = std::min(nearest, (x[0] - x[1] - u * (x[2] - x[1]) - v * (x[3] - x[1])).norm());
    }
  }
  return nearest;
}

using FourParticles = std::array<Index, 4>;
using Pair = std::pair<PairKind, FourParticles>;

/// All pairs without a common particle that are within reach of each other.
std::set<Pair> pairs_by_looking_at_all(const Surface& surface, const Places& x, double reach) {
  std::set<Pair> pairs;
  const auto add = [&](PairKind kind, const FourParticles& p) {
    for (std::size_t a = 0; a < 4; ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        if (p[a] == p[b]) return;
      }
    }
    if (closest_points(kind, {x[p[0]], x[p[1]], x[p[2]], x[p[3]]}).distance() <= reach)
      pairs.emplace(kind, p);
  };
  for (const Index corner : surface.corners) {
    for (const auto& [a, b, c] : surface.triangles) add(PairKind::corner_triangle, {corner, a, b, c});
  }
  for (std::size_t e = 0; e < surface.edges.size(); ++e) {
    for (std::size_t f = e + 1; f < surface.edges.size(); ++f)
      add(PairKind::edge_edge,
          {surface.edges[e].first, surface.edges[e].second, surface.edges[f].first, surface.edges[f].second});
  }
  return pairs;
}

}  // namespace

TEST_CASE("self-collision: the closest points are as near as the nearest of many") {
  Random random(1);
  for (const PairKind kind : {PairKind::corner_triangle, PairKind::edge_edge}) {
    for (int i = 0; i < 60; ++i) {
      PairPlaces x = random.places();
      if (i % 10 == 7) x[3] = x[2];                                  // degenerate
      if (i % 10 == 8) x[1] = x[0] + 2.0 * (x[3] - x[2]);            // parallel
      if (i % 10 == 9) x[3] = x[1] + random.unit() * (x[2] - x[1]);  // in a line
      const ClosestPoints points = closest_points(kind, x);
      const double sampled = sampled_distance(kind, x);
      CHECK(points.distance() <= sampled + 1e-12);
      CHECK(points.distance() >= sampled - 0.03);
      Vec3 sum = Vec3::Zero();
      double first = 0.0, second = 0.0;
      for (std::size_t k = 0; k < 4; ++k) {
        sum += points.weights[k] * x[k];
        const bool in_first = k < (kind == PairKind::corner_triangle ? 1u : 2u);
        (in_first ? first : second) += points.weights[k];
        CHECK((in_first ? points.weights[k] : -points.weights[k]) >= -1e-12);
      }
      CHECK((sum - points.between).norm() < 1e-12);
      CHECK(first == doctest::Approx(1.0));
      CHECK(second == doctest::Approx(-1.0));
    }
  }
}

TEST_CASE("self-collision: a swept pair stops before it touches, and only where it comes near") {
  Random random(2);
  for (const PairKind kind : {PairKind::corner_triangle, PairKind::edge_edge}) {
    int near = 0;
    for (int i = 0; i < 200; ++i) {
      const PairPlaces start = random.places(), end = random.places();
      const double bound = approach_bound(kind, start, end);
      const double stop = 0.1 * closest_points(kind, start).distance();
      const double time = first_time_near(kind, start, end, stop, bound);
      double nearest_before = INFINITY;
      for (int k = 0; k <= 400; ++k) {
        const PairPlaces x = places_at(start, end, time * k / 400.0);
        nearest_before = std::min(nearest_before, closest_points(kind, x).distance());
      }
      CHECK(nearest_before >= 0.5 * stop - 1e-12);
      CHECK(closest_points(kind, start).distance() - nearest_before <= bound + 1e-12);
      if (time == 1.0) continue;
      ++near;
      CHECK(closest_points(kind, places_at(start, end, time)).distance() <= stop);
    }
    CHECK(near > 10);
  }
}

TEST_CASE("self-collision: the grid finds the pairs that looking at all finds, in 100 random states") {
  const auto executor = make_tbb_executor(2);
  std::size_t found_in_all = 0;
  for (unsigned state = 0; state < 100; ++state) {
    Random random(state);
    Places x;
    std::vector<Triangle> triangles;
    const bool flat = state % 3 == 0;
    for (Index i = 0; i < 45; ++i) {
      x.push_back(random.vector());
      if (flat) x.back().y() = 0.7;
    }
    for (Index i = 0; i + 2 < 45; i += 2) triangles.push_back({i, i + 1, i + 2});
    const Surface surface(triangles);
    ClosePairs close(surface, x, 0.05);
    const double reach = 0.02 + 0.2 * random.unit();
    std::set<Pair> found;
    for (const ClosePair& pair : close.find(x, x, reach, *executor)) {
      CHECK(found.emplace(pair.kind, pair.particles).second);
      CHECK(pair.thickness <= 0.05);
      CHECK(pair.thickness <= pair.distance);  // here places are those of the start
    }
    CHECK(found == pairs_by_looking_at_all(surface, x, reach));
    found_in_all += found.size();
  }
  CHECK(found_in_all > 1000);
}

TEST_CASE("self-collision: pairs are found along their ways, too") {
  const Surface surface({{0, 1, 2}, {3, 4, 5}});
  const Places start{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0.2, 50, 0.2}, {0.4, 50, 0.2}, {0.2, 50, 0.4}};
  Places end = start;
  for (Index i = 3; i < 6; ++i) end[i].y() = -60.0;
  ClosePairs close(surface, start, 0.01);
  const auto executor = make_tbb_executor(1);
  CHECK(close.find(end, end, 0.02, *executor).empty());
  CHECK(close.find(start, end, 0.02, *executor).size() >= 6);
}

TEST_CASE("self-collision: what would pass goes back to where it came near, and a fifth of what it lacks") {
  constexpr double thickness = 0.01;
  const Places start{{0.3, 0.05, 0.3}, {0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
  Places end = start;
  end[0].y() = -1.0;
  const std::vector<double> inverse_mass{1.0, 0.0, 0.0, 0.0};
  const auto executor = make_tbb_executor(1);
  NarrowPhase narrow_phase(thickness, 0.0, true);
  const std::vector<ClosePair> pairs{{{0, 1, 2, 3}, PairKind::corner_triangle, 0, thickness, 1.0}};
  const auto& contacts =
      narrow_phase.contacts_of(pairs, {start, end, inverse_mass, 2.0, 2.0, 0.01}, *executor);
  REQUIRE(contacts.size() == 1);
  CHECK(narrow_phase.passed());
  CHECK(std::abs(contacts[0].normal.y()) == doctest::Approx(1.0));
  CHECK(contacts[0].gap(start) > 0.0);
  CHECK(contacts[0].least >= 0.4 * thickness);
  CHECK(contacts[0].least <= 0.6 * thickness);
}

/// Particles and contacts at random, each of which shares particles with the next ones.
struct RandomContacts {
  std::vector<double> inverse_mass;
  std::vector<Vec3> values;
  std::vector<SurfaceContact> contacts;

  explicit RandomContacts(double friction) {
    Random random(4);
    for (int i = 0; i < 200; ++i) {
      inverse_mass.push_back(1.0 / (0.5 + random.unit()));
      values.push_back(random.vector());
    }
    for (Index i = 0; i + 3 < 200; ++i) {
      const double a = random.unit(), b = random.unit() * (1.0 - a);
      contacts.push_back({{i, i + 1, i + 2, i + 3},
                          {1.0, -a, -b, -(1.0 - a - b)},
                          random.vector().normalized(),
                          0.0,
                          Vec3::Zero(),
                          friction});
    }
  }
  double energy() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) sum += 0.5 * values[i].squaredNorm() / inverse_mass[i];
    return sum;
  }
  Vec3 momentum() const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < values.size(); ++i) sum += values[i] / inverse_mass[i];
    return sum;
  }
};

/// Sweeps over all of these, which end after so many.
ContactSweeps swept(RandomContacts& random, std::uint64_t most) {
  const auto executor = make_tbb_executor(2);
  ContactSweeps sweeps(random.inverse_mass);
  sweeps.find_particles(random.contacts);
  sweeps.set(random.contacts, *executor);
  sweeps.run(random.values, {0.0, 0.0, 0.0}, most, *executor);
  return sweeps;
}

TEST_CASE("self-collision: however early sweeps over velocities end, they keep momentum and add no energy") {
  for (const double friction : {0.0, 0.1, 0.4, 2.0}) {
    const RandomContacts first(friction);
    double before = first.energy();
    for (std::uint64_t most = 1; most <= 50; ++most) {
      RandomContacts after = first;
      swept(after, most);
      CHECK(after.energy() <= first.energy() * (1.0 + 1e-14));
      if (friction == 0.0) CHECK(after.energy() <= before * (1.0 + 1e-14));
      before = after.energy();
      CHECK((after.momentum() - first.momentum()).norm() < 1e-12 * double(first.values.size()));
    }
    CHECK(before < 0.95 * first.energy());
  }
}

TEST_CASE("self-collision: sweeps lead to the nearest state that keeps all contacts, and not beyond it") {
  RandomContacts random(0.0);
  double worst = 0.0;
  for (const SurfaceContact& contact : random.contacts) worst = std::min(worst, contact.gap(random.values));
  CHECK(worst < -0.5);
  const ContactSweeps sweeps = swept(random, 2000);
  std::size_t pushing = 0;
  for (std::size_t c = 0; c < random.contacts.size(); ++c) {
    CHECK(random.contacts[c].gap(random.values) > -1e-9);
    if (!sweeps.pushed(c)) continue;
    ++pushing;
    CHECK(random.contacts[c].gap(random.values) < 1e-9);
  }
  CHECK(pushing > random.contacts.size() / 4);
}

TEST_CASE("self-collision: sweeps that begin from pushes known before end sooner, and add no energy either") {
  for (const double friction : {0.0, 0.4}) {
    const RandomContacts first(friction);
    RandomContacts solved = first;
    const ContactSweeps sweeps = swept(solved, 2000);
    RandomContacts known = first;
    for (std::size_t c = 0; c < known.contacts.size(); ++c) sweeps.tell_push(c, 0.7, known.contacts[c]);
    const auto distance = [&](const RandomContacts& random) {
      double sum = 0.0;
      for (std::size_t i = 0; i < random.values.size(); ++i)
        sum += (random.values[i] - solved.values[i]).squaredNorm();
      return std::sqrt(sum);
    };
    RandomContacts from_nothing = first;
    swept(from_nothing, 1);
    swept(known, 1);
    CHECK(distance(known) < distance(from_nothing));
    if (friction == 0.0) CHECK(distance(known) < 1e-9);

    Random random(5);
    RandomContacts wrong = first;
    for (SurfaceContact& contact : wrong.contacts) {
      contact.pushed = 10.0 * random.unit();
      contact.held_back =
          friction * contact.pushed * contact.normal.cross(random.vector().normalized()).normalized();
    }
    for (std::uint64_t most = 1; most <= 50; ++most) {
      RandomContacts after = wrong;
      swept(after, most);
      CHECK(after.energy() <= first.energy() * (1.0 + 1e-14));
      CHECK((after.momentum() - first.momentum()).norm() < 1e-12 * double(first.values.size()));
    }
  }
}

namespace {

/// Two flat grids of triangles, one a thickness over the other and moved against it by so much.
struct TwoSheets {
  static constexpr Index side = 6;
  static constexpr double thickness = 0.1;
  Places places;
  std::vector<Triangle> triangles;

  TwoSheets(double right, double forward) {
    for (Index sheet = 0; sheet < 2; ++sheet) {
      const Index first = sheet * side * side;
      for (Index i = 0; i < side * side; ++i)
        places.push_back({i % side + sheet * right, 0.99 * thickness * sheet, i / side + sheet * forward});
      for (Index row = 0; row + 1 < side; ++row) {
        for (Index column = 0; column + 1 < side; ++column) {
          const Index a = first + row * side + column;
          triangles.push_back({a, a + 1, a + side});
          triangles.push_back({a + 1, a + side + 1, a + side});
        }
      }
    }
  }

  std::vector<SurfaceContact> contacts() const {
    const auto executor = make_tbb_executor(2);
    const Surface surface(triangles);
    Places apart = places;
    for (std::size_t i = side * side; i < apart.size(); ++i) apart[i].y() += 1.0;
    ClosePairs close(surface, apart, thickness);
    NarrowPhase narrow_phase(thickness, 0.0, true);
    const std::vector<double> inverse_mass(places.size(), 1.0);
    return narrow_phase.contacts_of(close.find(places, places, 2.0 * thickness, *executor),
                                    {places, places, inverse_mass, 0.0, 0.0, 0.01}, *executor);
  }
};

bool is_of_corner(const SurfaceContact& contact) {
  return contact.weights[0] == 1.0 && contact.weights[1] <= 0.0;
}

std::size_t corner_contacts(const std::vector<SurfaceContact>& contacts) {
  return std::size_t(std::count_if(contacts.begin(), contacts.end(), is_of_corner));
}

}  // namespace

TEST_CASE("self-collision: a corner has one contact with a surface, with what it is nearest to") {
  // Near sides, so that triangles beside the nearest one are near enough for contacts of their own.
  for (const auto& [right, forward] : {std::pair(0.02, 0.3), std::pair(0.5, 0.49), std::pair(0.01, 0.01)}) {
    CAPTURE(right);
    const std::vector<SurfaceContact> contacts = TwoSheets(right, forward).contacts();
    std::set<Index> corners;
    for (const SurfaceContact& contact : contacts) {
      CHECK(std::abs(contact.normal.y()) > 0.9);
      if (is_of_corner(contact)) CHECK(corners.insert(contact.particles[0]).second);
    }
    CHECK(corners.size() >= 2 * (TwoSheets::side - 1) * (TwoSheets::side - 1));
  }
}

TEST_CASE("self-collision: two corners over one another have one contact, and their edges none") {
  const std::vector<SurfaceContact> contacts = TwoSheets(0.0, 0.0).contacts();
  CHECK(contacts.size() == TwoSheets::side * TwoSheets::side);
  CHECK(corner_contacts(contacts) == contacts.size());
  // So little beside one another that the edges' contacts would say the same as those of corners.
  const std::vector<SurfaceContact> beside = TwoSheets(5e-4, 3e-4).contacts();
  CHECK(beside.size() <= 2 * corner_contacts(beside));
}

TEST_CASE("self-collision: a zone moves as one piece with its momentum, or with what is held in it") {
  const std::vector<double> inverse_mass{1.0, 0.5, 1.0, 1.0, 1.0, 1.0, 0.0, 1.0, 1.0};
  const std::vector<Vec3> start(9, Vec3::Zero());
  std::vector<Vec3> end(9, Vec3(1, 0, 0)), velocity(9, Vec3(0, 3, 0));
  end[1] = {4, 0, 0}, velocity[1] = {0, 0, 6};
  end[6] = {7, 0, 0}, velocity[6] = {8, 0, 0};
  ImpactZones zones(inverse_mass);
  zones.join({0, 1, 2, 3});
  zones.join({4, 5, 6, 7});
  zones.move(start, end, velocity);
  CHECK(zones.particles().size() == 8);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(end[i].isApprox(Vec3(11.0 / 5.0, 0, 0)));
    CHECK(velocity[i].isApprox(Vec3(0, 9.0 / 5.0, 12.0 / 5.0)));
  }
  for (std::size_t i = 4; i < 8; ++i) CHECK(end[i].isApprox(Vec3(7, 0, 0)));
  CHECK(end[8] == Vec3(1, 0, 0));
}
