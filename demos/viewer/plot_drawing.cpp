#include "viewer/plot_drawing.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "viewer/quantity.h"
#include "viewer/style.h"

namespace hooke::viewer {
namespace {

/// Where a plot's values lie on the screen.
class Area {
 public:
  Area(const Plot& plot, ImVec2 low, ImVec2 high) : plot_(plot), low_(low), high_(high) {}

  ImVec2 left_top() const { return low_; }
  ImVec2 right_bottom() const { return high_; }
  float x(double value) const { return low_.x + float(plot_.x.place(value)) * (high_.x - low_.x); }
  float y(double value) const { return high_.y - float(plot_.y.place(value)) * (high_.y - low_.y); }

 private:
  const Plot& plot_;
  ImVec2 low_, high_;
};

/// Text is smaller in plots than around them.
float text_size() {
  return 0.86f * ImGui::GetFontSize();
}

ImVec2 size_of(const std::string& text) {
  return ImGui::GetFont()->CalcTextSizeA(text_size(), 1e9f, 0.0f, text.c_str());
}

void write(ImVec2 at, const std::string& text, const Colour& colour = palette::faint) {
  ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), text_size(), at, ink(colour), text.c_str());
}

/// Powers of ten are told as such where their zeros would have to be counted.
std::string tick_text(const Axis& axis, double value) {
  const double power = std::round(std::log10(std::abs(value)));
  if (!axis.logarithmic || std::abs(power) <= 3.0) return number(value);
  return "1e" + number(power);
}

/// Upwards along the left edge: ImGui has no turned text, so its corners are turned after it is drawn.
void write_upwards(ImVec2 centre, const std::string& text) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 size = size_of(text);
  const int begin = list.VtxBuffer.Size;
  const ImVec2 at(std::floor(centre.x - 0.5f * size.x), std::floor(centre.y - 0.5f * size.y));
  const ImVec2 clip_low = list.GetClipRectMin(), clip_high = list.GetClipRectMax();
  list.PushClipRectFullScreen();  // where it stands before it is turned may be hidden
  write(at, text);
  list.CmdBuffer.back().ClipRect = {clip_low.x, clip_low.y, clip_high.x, clip_high.y};
  list.PopClipRect();
  const ImVec2 middle(std::floor(centre.x), std::floor(centre.y));
  for (int i = begin; i < list.VtxBuffer.Size; ++i) {
    ImVec2& corner = list.VtxBuffer[i].pos;
    corner = ImVec2(middle.x + (corner.y - middle.y), middle.y - (corner.x - middle.x));
  }
}

void draw_x_ticks(const Plot& plot, const Area& area) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float width = area.right_bottom().x - area.left_top().x;
  const int most = std::max(2, int(width / (4.2f * text_size())));
  for (const double value : ticks(plot.x, most)) {
    const float x = std::floor(area.x(value)) + 0.5f;
    list.AddLine({x, area.left_top().y}, {x, area.right_bottom().y}, ink(palette::grid));
    const std::string text = tick_text(plot.x, value);
    write({x - 0.5f * size_of(text).x, area.right_bottom().y + 3.0f}, text);
  }
}

void draw_y_ticks(const Plot& plot, const Area& area, const std::vector<double>& values) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const double value : values) {
    const float y = std::floor(area.y(value)) + 0.5f;
    list.AddLine({area.left_top().x, y}, {area.right_bottom().x, y}, ink(palette::grid));
    const std::string text = tick_text(plot.y, value);
    const ImVec2 size = size_of(text);
    write({area.left_top().x - size.x - 5.0f, y - 0.55f * size.y}, text);
  }
}

/// The markers, for a size of 1.
void draw_marker(ImDrawList& list, Marker marker, ImVec2 at, float size, ImU32 colour) {
  const float s = size, thick = 0.45f * size;
  switch (marker) {
    case Marker::none:
      return;
    case Marker::circle:
      return list.AddCircleFilled(at, s, colour);
    case Marker::ring:
      return list.AddCircle(at, s, colour, 0, thick);
    case Marker::square:
      return list.AddRectFilled({at.x - 0.9f * s, at.y - 0.9f * s}, {at.x + 0.9f * s, at.y + 0.9f * s},
                                colour);
    case Marker::diamond:
      return list.AddNgonFilled(at, 1.3f * s, colour, 4);
    case Marker::triangle:
      return list.AddTriangleFilled({at.x, at.y - 1.2f * s}, {at.x + 1.1f * s, at.y + 0.8f * s},
                                    {at.x - 1.1f * s, at.y + 0.8f * s}, colour);
    case Marker::nabla:
      return list.AddTriangleFilled({at.x, at.y + 1.2f * s}, {at.x - 1.1f * s, at.y - 0.8f * s},
                                    {at.x + 1.1f * s, at.y - 0.8f * s}, colour);
    case Marker::cross:
      list.AddLine({at.x - s, at.y - s}, {at.x + s, at.y + s}, colour, thick);
      return list.AddLine({at.x - s, at.y + s}, {at.x + s, at.y - s}, colour, thick);
    case Marker::plus:
      list.AddLine({at.x - 1.2f * s, at.y}, {at.x + 1.2f * s, at.y}, colour, thick);
      return list.AddLine({at.x, at.y - 1.2f * s}, {at.x, at.y + 1.2f * s}, colour, thick);
  }
}

float marker_size() {
  return 0.28f * ImGui::GetFontSize();
}

void draw_curve(const Curve& curve, const Area& area) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 colour = ink(curve.colour);
  const float width = 0.11f * ImGui::GetFontSize();
  const auto flush = [&] { list.PathStroke(colour, ImDrawFlags_None, width); };
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    if (std::isfinite(curve.y[i])) {
      list.PathLineTo({area.x(curve.x[i]), area.y(curve.y[i])});
    } else {
      flush();
    }
  }
  flush();
  const auto mark = [&](double x, double y) {
    draw_marker(list, curve.marker, {area.x(x), area.y(y)}, marker_size(), colour);
  };
  for (std::size_t i = 0; i < curve.x.size(); ++i) mark(curve.x[i], curve.y[i]);
  for (std::size_t i = 0; i < curve.single_x.size(); ++i) mark(curve.single_x[i], curve.single_y[i]);
}

void draw_marks(const Plot& plot, const Area& area) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const Mark& mark : plot.marks) {
    const float x = std::floor(area.x(mark.x)) + 0.5f;
    list.AddLine({x, area.left_top().y}, {x, area.right_bottom().y}, ink(palette::faint, 0.75f));
    const float width = size_of(mark.label).x;
    const float left = std::min(x - 0.5f * width, area.right_bottom().x - width);
    write({left, area.left_top().y - 1.3f * text_size()}, mark.label);
  }
}

}  // namespace

void draw_plot(const Plot& plot, float height) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, height);
  ImGui::Dummy(size);
  const float line = 1.25f * text_size();
  const std::vector<double> y_values = ticks(plot.y, std::max(2, int(height / (2.2f * line))));
  float widest = 0.0f;
  for (const double value : y_values) widest = std::max(widest, size_of(tick_text(plot.y, value)).x);
  const float above = plot.marks.empty() ? 4.0f : line + 4.0f;
  const Area area(plot, {at.x + line + widest + 8.0f, at.y + above},
                  {at.x + size.x - 0.8f * text_size(), at.y + size.y - 2.0f * line - 4.0f});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(area.left_top(), area.right_bottom(), ink(palette::plot_ground), 3.0f);
  draw_x_ticks(plot, area);
  draw_y_ticks(plot, area, y_values);
  draw_marks(plot, area);
  const float reach = 2.0f * marker_size();  // markers on the edge are shown whole
  list.PushClipRect({area.left_top().x - reach, area.left_top().y - reach},
                    {area.right_bottom().x + reach, area.right_bottom().y + reach}, true);
  for (const Curve& curve : plot.curves) draw_curve(curve, area);
  list.PopClipRect();
  const float middle_x = 0.5f * (area.left_top().x + area.right_bottom().x);
  write({middle_x - 0.5f * size_of(plot.x.label).x, at.y + size.y - line}, plot.x.label);
  write_upwards({at.x + 0.5f * line, 0.5f * (area.left_top().y + area.right_bottom().y)}, plot.y.label);
}

void draw_legend(const Plot& plot) {
  const float font = ImGui::GetFontSize(), sample = 1.5f * font, line = 1.3f * text_size();
  const ImVec2 start = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImVec2 at = start;
  for (const Curve& curve : plot.curves) {
    const float cell = sample + size_of(curve.label).x;
    if (at.x > start.x && at.x + cell > start.x + width) at = {start.x, at.y + line};
    const float y = at.y + 0.5f * line;
    list.AddLine({at.x, y}, {at.x + 1.2f * font, y}, ink(curve.colour), 0.13f * font);
    draw_marker(list, curve.marker, {at.x + 0.6f * font, y}, marker_size(), ink(curve.colour));
    write({at.x + sample, at.y}, curve.label, palette::text);
    at.x += cell + 0.9f * font;
  }
  ImGui::Dummy({width, at.y + line - start.y});
}

}  // namespace hooke::viewer
