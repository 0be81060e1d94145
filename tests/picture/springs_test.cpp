// Springs: their colours say how they are strained, and they can be seen, few or many.

#include "drawing.h"

using namespace hooke;
using namespace hooke::picture;
using namespace hooke::test;

namespace {

constexpr Look springs_alone{
    .surface = false, .springs = true, .particles = false, .pins = false, .ground = false, .shadow = false};

/// One spring of 1 m along x, with this rest length.
struct One {
  explicit One(float rest_length) {
    subject.particles = 2;
    subject.springs = {{0, 1}};
    subject.rest_lengths = {rest_length};
  }
  Image paint(const Look& look) const {
    return Painter(subject, width, height).paint(positions, camera, look);
  }

  Subject subject;
  std::vector<float> positions = {0, 0, 0, 1, 0, 0};
  Camera camera = fitted({.azimuth = 0.0, .elevation = 0.0}, positions, aspect);
  Vec3 middle = Vec3(0.5, 0, 0);
};

/// The colour of a spring of 1 m, in its middle.
std::array<int, 3> colour(float rest_length, double full_strain = 0.1) {
  const One one(rest_length);
  Look look = springs_alone;
  look.full_strain = full_strain;
  const Image image = one.paint(look);
  const std::uint8_t* const pixel = pixel_at(image, one.camera, one.middle);
  return {pixel[0], pixel[1], pixel[2]};
}

}  // namespace

TEST_CASE("springs are blue where pressed, grey at rest and red where stretched") {
  if (!can_draw()) return;
  const auto pressed = colour(1.2f), rest = colour(1.0f), stretched = colour(0.9f);
  CHECK(pressed[2] > pressed[0] + 80);
  CHECK(std::abs(rest[0] - rest[2]) < 25);
  CHECK(stretched[0] > stretched[2] + 80);
}

TEST_CASE("the colour grows with strain, and is full at the strain that is asked for") {
  if (!can_draw()) return;
  const auto redness = [](const std::array<int, 3>& c) { return c[0] - c[2]; };
  const int quarter = redness(colour(1.0f / 1.025f)), half = redness(colour(1.0f / 1.05f));
  const int full = redness(colour(1.0f / 1.1f)), beyond = redness(colour(1.0f / 1.5f));
  CHECK(quarter > redness(colour(1.0f)) + 10);
  CHECK(half > quarter + 10);
  CHECK(full > half + 10);
  CHECK(beyond == full);
  CHECK(colour(1.0f / 1.1f) == colour(1.0f / 1.05f, 0.05));
}

TEST_CASE("a spring without a rest length has no strain") {
  if (!can_draw()) return;
  const auto unstrained = colour(0.0f);
  CHECK(std::abs(unstrained[0] - unstrained[2]) < 25);
}

TEST_CASE("a spring is a line that can be seen, from end to end") {
  if (!can_draw()) return;
  const One one(1.0f);
  const Image image = one.paint(springs_alone), empty = one.paint(nothing);
  const Mask differs = difference(image, empty);
  for (double x = 0.01; x < 1.0; x += 0.02) {
    CHECK(pixel_at(image, one.camera, Vec3(x, 0, 0)) != pixel_at(empty, one.camera, Vec3(x, 0, 0)));
    const Vec3 place = one.camera.project(Vec3(x, 0, 0), aspect);
    const int column = int((place.x() + 1) / 2 * width);
    int thick = 0;
    for (int row = 0; row < height; ++row) thick += differs[std::size_t(row) * width + std::size_t(column)];
    CHECK(thick >= 2);
    CHECK(thick <= 8);
  }
}

TEST_CASE("of a net of 4,000 springs each shows, and there is room between them") {
  if (!can_draw()) return;
  constexpr Index n = 45;
  Subject net;
  net.particles = n * n;
  std::vector<float> positions;
  for (Index j = 0; j < n; ++j) {
    for (Index i = 0; i < n; ++i) {
      positions.insert(positions.end(), {float(i), float(j), 0.0f});
      if (i + 1 < n) net.springs.push_back({j * n + i, j * n + i + 1});
      if (j + 1 < n) net.springs.push_back({j * n + i, j * n + i + n});
    }
  }
  net.rest_lengths.assign(net.springs.size(), 1.0f);
  const Camera camera = fitted({.azimuth = 0.0, .elevation = 0.0}, positions, 960.0 / 540.0);
  Painter painter(net, 960, 540);
  const Image image = painter.paint(positions, camera, springs_alone);
  const Mask differs = difference(image, painter.paint(positions, camera, nothing), 10);
  std::size_t seen = 0;
  for (const auto& [first, second] : net.springs) {
    const Vec3 middle = 0.5 * Vec3(positions[3 * first] + positions[3 * second],
                                   positions[3 * first + 1] + positions[3 * second + 1], 0.0);
    const Vec3 place = camera.project(middle, 960.0 / 540.0);
    const int column = int((place.x() + 1) / 2 * 960), row = int((1 - place.y()) / 2 * 540);
    // The line may lie on the border of two pixels.
    const auto at = [&](int c, int r) { return differs[std::size_t(r) * 960 + std::size_t(c)]; };
    seen += at(column, row) || at(column - 1, row) || at(column, row - 1);
  }
  CHECK(seen == net.springs.size());
  const double side = 44.0 / 45.0 * 0.88 * 540;
  CHECK(count(differs) < 0.6 * side * side);
}

TEST_CASE("a spring whose ends lie in one point is not drawn, and harms nothing") {
  if (!can_draw()) return;
  One one(1.0f);
  one.positions = {0, 0, 0, 0, 0, 0};
  CHECK(one.paint(springs_alone).rgb == one.paint(nothing).rgb);
}
