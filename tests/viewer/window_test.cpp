// A window on an X server without a screen, operated by real X events.

#include <doctest/doctest.h>

#include <chrono>
#include <cstdlib>
#include <functional>
#include <memory>

#include "optional.h"
#include "picture/png_file.h"
#include "scenes.h"
#include "viewer/hands.h"
#include "viewer/loaded_libraries.h"
#include "viewer/viewer.h"
#include "viewer/virtual_display.h"
#include "viewer/window_error.h"

namespace hooke::viewer {
namespace {

constexpr Index columns = 12, rows = 12;

Scene small_scene() {
  Scene scene = test::hung_cloth(columns, rows, 1e-4);
  scene.name = "small cloth";
  return scene;
}

ViewSettings small_view(double study_budget) {
  ViewSettings settings;
  settings.scene = small_scene();
  settings.settings.step = 5e-4;
  settings.settings.threads = 2;
  settings.seconds = 0.5;
  settings.study_budget = study_budget;
  settings.width = 1000;
  settings.height = 760;
  settings.debug = true;
  return settings;
}

/// A viewer and somebody who uses it.
struct Session {
  explicit Session(double study_budget = 1.0) {
    hands.emplace();
    viewer.emplace(small_view(study_budget));
    test::keep_loaded_libraries();
    REQUIRE(until([&] { return viewer->controls().find("pause").has_value(); }));
    hands->find_window();
    hands->move(990, 750);  // where it points at nothing
    frames(2);
  }
  ~Session() { CHECK(viewer->complaints() == std::vector<std::string>{}); }

  /// Draws frames until it is so; false where it is not within a minute, or the window closes.
  bool until(const std::function<bool()>& is_so) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (std::chrono::steady_clock::now() < end) {
      if (!viewer->frame()) return false;
      if (is_so()) return true;
    }
    return false;
  }

  void frames(int count) {
    for (int i = 0; i < count; ++i) viewer->frame();
  }

  void press_and_release(double x, double y) {
    hands->move(x, y);
    frames(2);
    hands->press(1);
    frames(2);
    hands->release(1);
    frames(2);
  }

  void click(const std::string& control) {
    CAPTURE(control);
    const std::optional<Rectangle> place = viewer->controls().find(control);
    REQUIRE(place);
    press_and_release(0.5 * (place->left + place->right), 0.5 * (place->top + place->bottom));
  }

  void type(const std::string& key, bool shift = false) {
    hands->type(key, shift);
    frames(2);
  }

  const Moment& moment() const { return viewer->moment(); }

  std::optional<test::Hands> hands;
  std::optional<Viewer> viewer;
};

/// The display of all tests; they are skipped, saying so, where there is none.
bool has_display() {
  static const test::VirtualDisplay display(1280, 1024);
  if (display.there()) return true;
  test::skip(display.reason());
  return false;
}

Vec3 position(const Moment& moment, Index particle) {
  const float* const at = moment.positions.data() + 3 * std::size_t(particle);
  return {at[0], at[1], at[2]};
}

}  // namespace

TEST_CASE("without a display there is a message that says what to do") {
  unsetenv("DISPLAY");
  unsetenv("WAYLAND_DISPLAY");
  try {
    Viewer viewer(small_view(1.0));
    FAIL("a window was opened");
  } catch (const WindowError& error) {
    const std::string message = error.what();
    CHECK(message.find("there is no display") != std::string::npos);
    CHECK(message.find("hooke run --picture") != std::string::npos);
  }
}

TEST_CASE("buttons run, pause, step and reset") {
  if (!has_display()) return;
  Session session;
  CHECK_FALSE(session.moment().running);
  session.click("pause");
  CHECK(session.until([&] { return session.moment().running && session.moment().time > 0.02; }));
  session.click("pause");
  REQUIRE(session.until([&] { return !session.moment().running; }));
  const std::uint64_t steps = session.moment().steps;
  session.click("step");
  CHECK(session.until([&] { return session.moment().steps == steps + 1; }));
  session.click("reset");
  CHECK(session.until([&] { return session.moment().steps == 0; }));
}

TEST_CASE("keys do the same") {
  if (!has_display()) return;
  Session session;
  session.type("space");
  CHECK(session.until([&] { return session.moment().running; }));
  session.type("space");
  REQUIRE(session.until([&] { return !session.moment().running; }));
  const std::uint64_t steps = session.moment().steps;
  session.type("s");
  CHECK(session.until([&] { return session.moment().steps == steps + 1; }));
  session.type("Right");
  CHECK(session.until([&] { return session.moment().steps == steps + 2; }));
  session.type("plus", true);
  CHECK(session.until([&] { return session.moment().speed == 2.0; }));
  session.type("minus");
  CHECK(session.until([&] { return session.moment().speed == 1.0; }));
  session.type("r");
  CHECK(session.until([&] { return session.moment().steps == 0; }));
}

TEST_CASE("another method is chosen from the list while it runs, and state and time go on") {
  if (!has_display()) return;
  Session session;
  session.type("space");
  REQUIRE(session.until([&] { return session.moment().time > 0.05; }));
  const double time = session.moment().time;
  session.click("method");
  session.click("method/verlet");
  CHECK(
      session.until([&] { return to_string(session.moment().in_force->setup.settings.method) == "verlet"; }));
  CHECK(session.moment().time > time);
  CHECK(session.moment().running);
  session.click("accumulation");
  session.click("accumulation/coloured");
  CHECK(session.until(
      [&] { return session.moment().in_force->setup.settings.accumulation == Accumulation::coloured; }));
}

TEST_CASE("a coefficient is changed by dragging its number") {
  if (!has_display()) return;
  Session session;
  const auto drag = [&] {
    return std::get<hooke::Drag>(session.moment().in_force->setup.effects[1]).coefficient;
  };
  REQUIRE(drag() == 1e-4);
  const std::optional<Rectangle> place = session.viewer->controls().find("drag/coefficient");
  REQUIRE(place);
  const double x = 0.5 * (place->left + place->right), y = 0.5 * (place->top + place->bottom);
  session.hands->move(x, y);
  session.frames(2);
  session.hands->press(1);
  for (int i = 1; i <= 10; ++i) {
    session.hands->move(x + 5 * i, y);
    session.frames(1);
  }
  session.hands->release(1);
  CHECK(session.until([&] { return drag() > 1.2e-4; }));
}

TEST_CASE("a particle is dragged with the mouse") {
  if (!has_display()) return;
  Session session;
  const Index particle = columns * (rows - 1) + columns / 2;  // in the middle of the lowest row
  const auto place = session.viewer->place_of(particle);
  REQUIRE(place);
  const Vec3 before = position(session.moment(), particle);
  session.hands->move((*place)[0], (*place)[1]);
  session.frames(2);
  session.hands->press(1);
  session.frames(2);
  session.type("space");
  session.hands->move((*place)[0], (*place)[1] - 150.0);
  CHECK(session.until([&] { return (position(session.moment(), particle) - before).y() > 0.02; }));
  session.hands->release(1);
  CHECK(session.until([&] { return (position(session.moment(), particle) - before).y() < 0.0; }));
}

TEST_CASE("beside the particles the mouse turns the view, and F shows all again") {
  if (!has_display()) return;
  Session session;
  const Index corner = columns * rows - 1;
  const auto start = session.viewer->place_of(corner);
  session.hands->move(960, 720);
  session.frames(2);
  session.hands->press(1);
  session.frames(2);
  session.hands->move(860, 700);
  session.frames(2);
  session.hands->release(1);
  const auto moved = [&] {
    const auto place = session.viewer->place_of(corner);
    return place && std::abs((*place)[0] - (*start)[0]) > 20.0;
  };
  CHECK(session.until(moved));
  session.hands->press(4);  // the wheel: nearer
  session.hands->release(4);
  session.frames(30);
  const auto near = session.viewer->place_of(corner);
  session.type("f");
  CHECK(session.until([&] {
    const auto place = session.viewer->place_of(corner);
    return place && std::abs((*place)[0] - (*near)[0]) > 5.0;
  }));
}

TEST_CASE("help comes and goes; what is drawn can be chosen; panels can be hidden") {
  if (!has_display()) return;
  Session session;
  const picture::Image plain = session.viewer->picture();
  session.type("question", true);
  session.frames(3);
  CHECK(session.viewer->picture().rgb != plain.rgb);
  session.type("Escape");
  session.frames(3);
  CHECK(session.viewer->picture().rgb == plain.rgb);
  session.type("1");
  session.frames(3);
  CHECK(session.viewer->picture().rgb != plain.rgb);
  session.type("Tab");
  session.frames(3);
  CHECK_FALSE(session.viewer->controls().find("pause"));
  session.type("Tab");
  session.frames(3);
  CHECK(session.viewer->controls().find("pause"));
}

TEST_CASE("a run that goes bad is told in the window, and can be reset there") {
  if (!has_display()) return;
  Session session;
  session.click("method");
  session.click("method/explicit_euler");
  for (int i = 0; i < 6; ++i) session.type("plus", true);
  session.type("space");
  REQUIRE(session.until([&] { return !session.moment().problem.empty(); }));
  session.frames(3);
  session.click("problem/reset");
  CHECK(session.until([&] { return session.moment().problem.empty() && session.moment().steps == 0; }));
}

TEST_CASE("the study of accuracy is run and shown in the window") {
  if (!has_display()) return;
  Session session;
  session.type("space");
  session.click("study");
  REQUIRE(session.until([&] { return session.viewer->controls().find("study/close").has_value(); }));
  CHECK(session.until([&] { return session.moment().running; }));  // it stood still meanwhile
  session.frames(3);
  session.click("study/close");
  CHECK(session.until([&] { return !session.viewer->controls().find("study/close"); }));
}

TEST_CASE("a study is cancelled in the window") {
  if (!has_display()) return;
  Session session(120.0);
  session.type("a");
  REQUIRE(session.until([&] { return session.viewer->controls().find("study/cancel").has_value(); }));
  session.frames(3);
  session.click("study/cancel");
  CHECK(session.until([&] { return !session.viewer->controls().find("study/cancel"); }));
  CHECK_FALSE(session.viewer->studies());
}

TEST_CASE("closing the window ends it at once, in the middle of a run and of a study") {
  if (!has_display()) return;
  std::optional<Session> session(std::in_place, 120.0);
  session->type("space");
  session->type("a");
  REQUIRE(session->until([&] { return session->viewer->studies(); }));
  session->hands->close_window();
  bool open = true;
  for (int i = 0; i < 200 && open; ++i) open = session->viewer->frame();
  CHECK_FALSE(open);
  const auto start = std::chrono::steady_clock::now();
  session.reset();
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(10));
}

TEST_CASE("a change that is refused is told, and what was there goes on") {
  if (!has_display()) return;
  Session session;
  session.hands->hold("Control_L", true);
  session.frames(2);
  session.click("step length");  // with Ctrl, the number can be typed
  session.hands->hold("Control_L", false);
  session.frames(2);
  for (const char* key : {"minus", "3", "Return"}) session.type(key);
  CHECK(session.until([&] { return session.moment().refusal.find("step") != std::string::npos; }));
  CHECK(session.moment().in_force->setup.settings.step == 5e-4);
}

TEST_CASE("Q closes it") {
  if (!has_display()) return;
  Session session;
  session.hands->type("q");
  bool open = true;
  for (int i = 0; i < 200 && open; ++i) open = session.viewer->frame();
  CHECK_FALSE(open);
}

}  // namespace hooke::viewer
