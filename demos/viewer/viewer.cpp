#include "viewer/viewer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include <epoxy/gl.h>
#include <imgui.h>

#include "viewer/column.h"
#include "viewer/interface.h"
#include "viewer/mouse.h"
#include "viewer/saved_picture.h"
#include "viewer/shortcuts.h"
#include "viewer/state.h"
#include "viewer/study_control.h"
#include "viewer/window.h"

namespace hooke::viewer {
namespace {

double wall_time() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string title_of(const Scene& scene) {
  return scene.name.empty() ? "hooke" : "hooke: " + scene.name;
}

}  // namespace

struct Viewer::Parts {
  explicit Parts(ViewSettings& settings)
      : window(settings.width, settings.height, title_of(settings.scene), settings.debug),
        interface(window),
        state{settings.scene,
              {settings.scene, settings.settings, settings.precision},
              SceneView(settings.scene),
              {settings.settings, settings.scene.effects}} {
    state.study.budget = settings.study_budget;
    state.study.seconds = std::min(settings.seconds, state.study.seconds);
    state.view.take(state.moment());
    state.energies.add(state.moment().measurements);
  }

  void take_newest();
  void wait();
  void draw_scene(float left);
  void draw();

  Window window;
  Interface interface;
  State state;
  Mouse mouse;
  bool list_open = false;                    // such as that of the methods
  picture::Image* wanted_picture = nullptr;  // of the next frame
  double last_frame = wall_time();           // [s]
  double awake_until = last_frame + 1.0;     // [s]
};

void Viewer::Parts::take_newest() {
  if (!state.simulation.fetch()) return;
  state.view.take(state.moment());
  state.view.take(state.moment().in_force->setup.effects);
  state.energies.add(state.moment().measurements);
  awake_until = std::max(awake_until, wall_time() + 0.1);
}

/// Until the next frame is due: 60 a second where something moves, and where nothing does only as often as
/// a state could come. Where the display waits for itself, this does not.
void Viewer::Parts::wait() {
  constexpr double between_frames = 1.0 / 63.0, asleep = 1.0 / 20.0;
  if (window.take_activity()) awake_until = wall_time() + 0.5;
  const bool awake = wall_time() < awake_until || state.view.camera().moves() || mouse.drags();
  const bool hidden = window.width() == 0;  // minimised: nothing is drawn
  const double due = hidden ? wall_time() + asleep : last_frame + (awake ? between_frames : asleep);
  do {
    window.poll(std::max(0.0, due - wall_time()));
  } while (awake && wall_time() < due);
}

void Viewer::Parts::draw_scene(float left) {
  const double pixels = window.pixels_per_unit();
  const double first = std::round(left * pixels);
  const Viewport viewport{std::max(1.0, window.width() - first), std::max(1.0, double(window.height()))};
  const double now = wall_time();
  state.view.draw(viewport, int(first), 0, now - std::exchange(last_frame, now));
}

void Viewer::Parts::draw() {
  interface.begin_frame();
  state.controls.begin_frame();
  const float left = column(state, interface);
  overlays(state, left);
  list_open = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
  const double pixels = window.pixels_per_unit();
  const Eigen::Vector2d origin(std::round(left * pixels) / pixels, 0.0);
  draw_scene(left);
  mouse.act(state, origin, pixels, interface.scale());
  mouse.draw(state, origin, pixels, interface.scale());
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, window.width(), window.height());
  interface.end_frame();
}

Viewer::Viewer(ViewSettings settings) : parts_(std::make_unique<Parts>(settings)) {}
Viewer::~Viewer() = default;

bool Viewer::frame() {
  Parts& p = *parts_;
  p.wait();
  p.take_newest();
  const std::vector<KeyPress> keys = p.window.take_keys();
  const bool others_keys = ImGui::GetIO().WantTextInput || p.list_open;
  if (!others_keys) obey(keys, p.state);
  tend_study(p.state);
  if (p.window.width() > 0 && p.window.height() > 0) {
    p.draw();
    if (std::exchange(p.state.save_picture, false)) p.state.notice = save_picture(p.state);
    if (p.wanted_picture != nullptr) *std::exchange(p.wanted_picture, nullptr) = p.window.image();
    p.window.check();
    p.window.swap();
  }
  return !p.window.closing() && !p.state.closing;
}

picture::Image Viewer::picture() {
  picture::Image image;
  parts_->wanted_picture = &image;
  frame();
  return image;
}

void Viewer::set_running(bool running) {
  parts_->state.simulation.send(SetRunning{running});
}

void Viewer::start_study() {
  open_study(parts_->state);
}

const Moment& Viewer::moment() const {
  return parts_->state.moment();
}

const ControlMap& Viewer::controls() const {
  return parts_->state.controls;
}

std::optional<std::array<double, 2>> Viewer::place_of(Index particle) const {
  const std::optional<Eigen::Vector2d> pixel = parts_->state.view.place_of(particle);
  if (!pixel) return std::nullopt;
  const double pixels = parts_->window.pixels_per_unit();
  const double left = parts_->window.width() - parts_->state.view.viewport().width;
  return std::array{(pixel->x() + left) / pixels, pixel->y() / pixels};
}

bool Viewer::studies() const {
  const StudyState& study = parts_->state.study;
  return study.running && !study.running->done();
}

const std::vector<std::string>& Viewer::complaints() const {
  return parts_->window.complaints();
}

}  // namespace hooke::viewer
