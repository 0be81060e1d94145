// What cannot be drawn is refused in words, and positions that are not finite harm nothing.

#include <functional>
#include <limits>
#include <string>

#include "drawing.h"

using namespace hooke;
using namespace hooke::picture;
using namespace hooke::test;

namespace {

const float bad = std::numeric_limits<float>::quiet_NaN();
const float infinite = std::numeric_limits<float>::infinity();

Surface square() {
  return sheet(5, 5, [](double u, double v) { return Vec3(u, v, 0.0); });
}

/// A square with everything that can be drawn of it.
Subject busy() {
  Subject subject = subject_of(square());
  for (Index k = 0; k + 1 < 25; ++k) subject.springs.push_back({k, k + 1});
  subject.rest_lengths.assign(subject.springs.size(), 0.25f);
  subject.pins = {0, 24};
  return subject;
}

const Look everything;

std::string message_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const PictureError& error) {
    return error.what();
  }
  return "no error";
}

bool says(const std::string& message, const std::string& part) {
  return message.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a picture without a size, or too large a one, is refused with the sizes that there are") {
  if (!can_draw()) return;
  for (const int pixels : {0, -5, 1'000'000}) {
    const std::string wide = message_of([&] { Painter(busy(), pixels, 100); });
    CHECK_MESSAGE(says(wide, "width of a picture is " + std::to_string(pixels) + " pixels: give 1 to "),
                  wide);
    const std::string high = message_of([&] { Painter(busy(), 100, pixels); });
    CHECK_MESSAGE(says(high, "height of a picture is " + std::to_string(pixels)), high);
  }
}

TEST_CASE("a picture may be one pixel") {
  if (!can_draw()) return;
  const Image image = Painter(busy(), 1, 1).paint(square().positions, {}, everything);
  CHECK(image.rgb.size() == 3);
}

TEST_CASE("positions of another number of particles are refused") {
  if (!can_draw()) return;
  Painter painter(busy(), width, height);
  for (const std::size_t count : {0u, 3u, 74u, 78u}) {
    const std::string message = message_of([&] { painter.paint(std::vector<float>(count), {}, everything); });
    CHECK_MESSAGE(says(message, std::to_string(count) + " coordinates for 25 particles"), message);
  }
  CHECK(painter.paint(square().positions, {}, everything).width == width);  // and it can go on
}

TEST_CASE("a subject that names particles that it does not have is refused") {
  if (!can_draw()) return;
  Subject subject = busy();
  subject.triangles.push_back({0, 1, 25});
  CHECK(says(message_of([&] { Painter(subject, width, height); }), "triangle 32 has a corner 25"));
  subject = busy();
  subject.springs[3] = {1, 99};
  CHECK(says(message_of([&] { Painter(subject, width, height); }), "spring 3 has an end 99"));
  subject = busy();
  subject.pins = {77};
  CHECK(says(message_of([&] { Painter(subject, width, height); }), "pin 0 is of particle 77"));
  subject = busy();
  subject.rest_lengths.pop_back();
  CHECK(says(message_of([&] { Painter(subject, width, height); }), "23 rest lengths for 24 springs"));
}

TEST_CASE("what is not finite is left out, and the rest is drawn") {
  if (!can_draw()) return;
  const Surface whole = square();
  const Camera camera = fitted({}, whole.positions, aspect);
  Look surface_alone = nothing;
  surface_alone.surface = true;
  Painter painter(busy(), width, height);
  const Image good = painter.paint(whole.positions, camera, surface_alone);
  const Image empty = painter.paint(whole.positions, camera, nothing);
  for (const float value : {bad, infinite, -infinite}) {
    for (const std::size_t coordinate : {0u, 37u, 74u}) {
      Surface part = whole;
      part.positions[coordinate] = value;
      painter.paint(part.positions, camera, everything);
      const Image image = painter.paint(part.positions, camera, surface_alone);
      const auto corner = Index(coordinate / 3);
      std::erase_if(part.triangles,
                    [&](const Triangle& t) { return std::count(t.begin(), t.end(), corner) > 0; });
      part.positions[coordinate] = 0.0f;  // of no triangle any more
      const double expected = count(covered(part, camera));
      CHECK(count(difference(image, empty)) == doctest::Approx(expected).epsilon(0.05));
    }
  }
  CHECK(painter.paint(whole.positions, camera, surface_alone).rgb == good.rgb);
}

TEST_CASE("where nothing is finite the ground is drawn, or what is behind everything") {
  if (!can_draw()) return;
  Painter painter(busy(), width, height);
  const std::vector<float> none(75, bad);
  CHECK(painter.paint(none, {}, nothing).rgb == painter.paint(square().positions, {}, nothing).rgb);
  painter.paint(none, {}, everything);
}

TEST_CASE("positions far beyond what a float can square are no harm") {
  if (!can_draw()) return;
  Painter painter(busy(), width, height);
  painter.paint(std::vector<float>(75, std::numeric_limits<float>::max()), {}, everything);
  std::vector<float> huge = square().positions;
  huge[5] = -3e38f;
  huge[9] = 3e38f;
  painter.paint(huge, {}, everything);
  std::vector<float> tiny = square().positions;
  for (float& value : tiny) value *= 1e-20f;
  painter.paint(tiny, fitted({}, tiny, aspect), everything);
}

TEST_CASE("a subject without particles is drawn as ground alone") {
  if (!can_draw()) return;
  Painter painter(Subject{}, width, height);
  CHECK(painter.paint({}, {}, everything).rgb.size() == 3u * width * height);
}
