#include "viewer/mouse.h"

#include <imgui.h>

#include "viewer/picking.h"
#include "viewer/style.h"

namespace hooke::viewer {
namespace {

constexpr double pick_radius = 12.0;  // [units of the mouse], for a scale of 1

bool inside(const Eigen::Vector2d& pixel, const Viewport& viewport) {
  return pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() < viewport.width && pixel.y() < viewport.height;
}

}  // namespace

void Mouse::act(State& state, const Eigen::Vector2d& origin, double pixels_per_unit, double scale) {
  const ImGuiIO& io = ImGui::GetIO();
  last_ = pixel_;
  pixel_ = pixels_per_unit * (Eigen::Vector2d(io.MousePos.x, io.MousePos.y) - origin);
  const double radius = pick_radius * scale * pixels_per_unit;
  if (doing_ != Doing::nothing) {
    if (ImGui::IsAnyMouseDown()) return move(state);
    return release(state);
  }
  const bool free = !io.WantCaptureMouse && inside(pixel_, state.view.viewport());
  hovered_.reset();
  if (!free) return;
  if (io.MouseWheel != 0.0f) state.view.camera().zoom(io.MouseWheel, pixel_, state.view.viewport());
  press(state, radius);
  if (doing_ == Doing::nothing) hover(state, radius);
}

void Mouse::press(State& state, double radius) {
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Middle) || ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
    doing_ = Doing::pan;
  } else if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    doing_ = io.KeyShift ? Doing::pan : Doing::orbit;
    if (io.KeyShift || io.KeyCtrl) return;
    dragged_ = state.view.particle_at(pixel_, radius);
    if (dragged_) {
      doing_ = Doing::drag;
      depth_ = depth_of(state.view.camera().camera(), state.view.position(*dragged_));
      move(state);
    } else if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
      state.view.fit();
    }
  }
}

void Mouse::move(State& state) {
  const Viewport& viewport = state.view.viewport();
  const Eigen::Vector2d moved = pixel_ - last_;
  if (doing_ == Doing::drag) {
    state.simulation.send(
        Pull{*dragged_, point_under(state.view.camera().camera(), viewport, pixel_, depth_)});
  } else if (moved.isZero()) {
    return;
  } else if (doing_ == Doing::orbit) {
    state.view.camera().orbit(moved, viewport);
  } else {
    state.view.camera().pan(moved, viewport);
  }
}

void Mouse::release(State& state) {
  if (doing_ == Doing::drag) state.simulation.send(Release{});
  dragged_.reset();
  doing_ = Doing::nothing;
}

/// Marks the particle that a click would take, while the mouse is looking for one.
void Mouse::hover(State& state, double radius) {
  constexpr double lasts = 1.5;          // [s]
  constexpr std::size_t most = 200'000;  // more take too long to look through in every frame
  const double now = ImGui::GetTime();
  const ImVec2 moved = ImGui::GetIO().MouseDelta;
  if (moved.x != 0.0f || moved.y != 0.0f) moved_at_ = now;
  if (now - moved_at_ < lasts && state.scene.particles.size() <= most)
    hovered_ = state.view.particle_at(pixel_, radius);
}

void Mouse::draw(const State& state, const Eigen::Vector2d& origin, double pixels_per_unit,
                 double scale) const {
  const std::optional<Index> particle = dragged_ ? dragged_ : hovered_;
  if (!particle) return;
  const std::optional<Eigen::Vector2d> place = state.view.place_of(*particle);
  if (!place) return;
  const auto on_screen = [&](const Eigen::Vector2d& pixel) {
    const Eigen::Vector2d at = origin + pixel / pixels_per_unit;
    return ImVec2(float(at.x()), float(at.y()));
  };
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImVec2 from = on_screen(*place);
  const float unit = float(scale);
  if (dragged_) {
    const ImVec2 to = on_screen(pixel_);
    list.AddLine(from, to, IM_COL32(20, 22, 28, 160), 4.0f * unit);
    list.AddLine(from, to, ink(palette::warning), 2.0f * unit);
    list.AddCircleFilled(to, 3.5f * unit, ink(palette::warning));
  }
  list.AddCircle(from, 7.0f * unit, IM_COL32(20, 22, 28, 160), 0, 4.0f * unit);
  list.AddCircle(from, 7.0f * unit, ink(palette::warning), 0, 2.0f * unit);
}

}  // namespace hooke::viewer
