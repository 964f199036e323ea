#include "ui/widgets/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "ui/widgets/landmarks.h"
#include "ui/widgets/theme.h"

namespace bosk {
namespace {

constexpr double kGrowth = 0.05;  // of the values' range, left free at both ends
constexpr std::array kTones = {Tone::busy, Tone::good, Tone::note, Tone::bad, Tone::neutral};

double place_on(const PlotAxis& axis, double value) {
  const auto bent = [&](double x) { return axis.logarithmic ? std::log(x) : x; };
  return (bent(value) - bent(axis.least)) / (bent(axis.most) - bent(axis.least));
}

double value_at(const PlotAxis& axis, double place) {
  if (!axis.logarithmic) return axis.least + place * (axis.most - axis.least);
  return axis.least * std::pow(axis.most / axis.least, place);
}

bool is_shown(const PlotAxis& axis, double value) {
  return std::isfinite(value) && (!axis.logarithmic || value > 0.0);
}

// The axis with its ends, from the values where it has none.
PlotAxis with_ends(PlotAxis axis, const std::vector<double>& values) {
  if (axis.most > axis.least) return axis;
  double least = INFINITY, most = -INFINITY;
  for (const double value : values) {
    if (!is_shown(axis, value)) continue;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  if (!(least <= most)) least = 1.0, most = 2.0;
  if (axis.logarithmic) {
    const double growth = std::max(std::pow(most / least, kGrowth), 1.05);
    return {axis.label, true, least / growth, most * growth};
  }
  const double growth = most > least ? kGrowth * (most - least) : 0.5;
  return {axis.label, false, least - growth, most + growth};
}

std::vector<double> values_of(const Plot& plot, int coordinate, std::optional<bool> right_axis) {
  std::vector<double> values;
  for (const PlotLine& line : plot.lines) {
    if (right_axis && line.right_axis != *right_axis) continue;
    for (const glm::dvec2& point : line.points) values.push_back(point[coordinate]);
  }
  return values;
}

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", value);
  return text.data();
}

// The chart on the screen: its frame without the axes' numbers.
struct Frame {
  ImVec2 least, most;
  PlotAxis x, y, right;

  float at_x(double value) const {
    return least.x + float(place_on(x, value)) * (most.x - least.x);
  }
  float at_y(const PlotAxis& axis, double value) const {
    return most.y - float(place_on(axis, value)) * (most.y - least.y);
  }
};

void draw_axes(const Frame& frame, bool has_right) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImU32 grid = colour_u32(Tone::muted, 0.25f), text = colour_u32(Tone::muted);
  const float em = ImGui::GetFontSize();
  draw.AddRect(frame.least, frame.most, colour_u32(Tone::muted, 0.6f));
  const int columns = std::max(2, int((frame.most.x - frame.least.x) / (5.0f * em)));
  for (const double value : ticks(frame.x, columns)) {
    const float x = frame.at_x(value);
    draw.AddLine({x, frame.least.y}, {x, frame.most.y}, grid);
    const std::string label = number(value);
    draw.AddText({x - 0.5f * ImGui::CalcTextSize(label.c_str()).x, frame.most.y}, text,
                 label.c_str());
  }
  const int rows = std::max(2, int((frame.most.y - frame.least.y) / (2.5f * em)));
  for (const double value : ticks(frame.y, rows)) {
    const float y = frame.at_y(frame.y, value);
    draw.AddLine({frame.least.x, y}, {frame.most.x, y}, grid);
    const std::string label = number(value);
    draw.AddText({frame.least.x - ImGui::CalcTextSize(label.c_str()).x - 0.3f * em, y - 0.5f * em},
                 text, label.c_str());
  }
  for (const double value : has_right ? ticks(frame.right, rows) : std::vector<double>()) {
    draw.AddText({frame.most.x + 0.3f * em, frame.at_y(frame.right, value) - 0.5f * em}, text,
                 number(value).c_str());
  }
  draw.AddText({frame.least.x, frame.least.y - 1.2f * em}, text, frame.y.label.c_str());
  const float wide = ImGui::CalcTextSize(frame.x.label.c_str()).x;
  draw.AddText({frame.most.x - wide, frame.most.y + em}, text, frame.x.label.c_str());
  if (!has_right) return;
  const float right_wide = ImGui::CalcTextSize(frame.right.label.c_str()).x;
  draw.AddText({frame.most.x - right_wide, frame.least.y - 1.2f * em}, text,
               frame.right.label.c_str());
}

void draw_line(const Frame& frame, const PlotLine& line, Tone tone) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const PlotAxis& axis = line.right_axis ? frame.right : frame.y;
  std::vector<ImVec2> points;
  for (const glm::dvec2& point : line.points) {
    if (!is_shown(frame.x, point.x) || !is_shown(axis, point.y)) continue;
    points.emplace_back(frame.at_x(point.x), frame.at_y(axis, point.y));
  }
  const ImU32 colour = colour_u32(tone);
  const float em = ImGui::GetFontSize();
  draw.AddPolyline(points.data(), int(points.size()), colour, 0, 0.12f * em);
  for (const ImVec2& point : points) {
    if (line.right_axis) {
      draw.AddRectFilled({point.x - 0.18f * em, point.y - 0.18f * em},
                         {point.x + 0.18f * em, point.y + 0.18f * em}, colour);
    } else {
      draw.AddCircleFilled(point, 0.2f * em, colour);
    }
  }
  if (points.empty()) return;
  const float wide = ImGui::CalcTextSize(line.name.c_str()).x;
  const ImVec2 end = points.back();
  draw.AddText({std::max(frame.least.x, std::min(end.x, frame.most.x - wide - 0.3f * em)),
                std::max(frame.least.y, end.y - 1.4f * em)},
               colour, line.name.c_str());
}

Frame frame_of(const Plot& plot, const ImVec2& least, const ImVec2& most) {
  const float em = ImGui::GetFontSize();
  Frame frame;
  frame.least = {least.x + 4.0f * em, least.y + 1.4f * em};
  frame.most = {most.x - (plot.right ? 4.0f : 0.8f) * em, most.y - 2.2f * em};
  frame.most.x = std::max(frame.most.x, frame.least.x + 1.0f);
  frame.most.y = std::max(frame.most.y, frame.least.y + 1.0f);
  frame.x = with_ends(plot.x, values_of(plot, 0, std::nullopt));
  frame.y = with_ends(plot.y, values_of(plot, 1, false));
  if (plot.right) frame.right = with_ends(*plot.right, values_of(plot, 1, true));
  return frame;
}

}  // namespace

std::vector<double> ticks(const PlotAxis& axis, int count) {
  std::vector<double> values;
  if (!(axis.most > axis.least) || (axis.logarithmic && axis.least <= 0.0)) return values;
  if (axis.logarithmic) {
    const double base = axis.most / axis.least > 1e3 ? 10.0 : 2.0;
    const double first = std::ceil(std::log(axis.least) / std::log(base) - 1e-9);
    for (double value = std::pow(base, first); value <= axis.most; value *= base) {
      values.push_back(value);
    }
    return values;
  }
  const double rough = (axis.most - axis.least) / std::max(1, count);
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10.0 * power;
  for (const double part : {5.0, 2.0, 1.0}) {
    if (part * power >= rough) step = part * power;
  }
  for (double i = std::ceil(axis.least / step); i * step <= axis.most; ++i) {
    values.push_back(i * step);
  }
  return values;
}

std::optional<double> draw_plot(const std::string& name, const Plot& plot, ImVec2 area) {
  const ImVec2 left = ImGui::GetContentRegionAvail();
  if (area.x <= 0.0f) area.x = std::max(1.0f, left.x);
  if (area.y <= 0.0f) area.y = std::max(1.0f, left.y);
  const ImVec2 least = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton(name.c_str(), area);
  const bool dragged = ImGui::IsItemActive();
  mark(name);
  const Frame frame = frame_of(plot, least, {least.x + area.x, least.y + area.y});
  draw_axes(frame, plot.right.has_value());
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.PushClipRect(frame.least, frame.most, true);
  for (std::size_t i = 0; i < plot.lines.size(); ++i) {
    draw_line(frame, plot.lines[i], kTones[i % kTones.size()]);
  }
  if (plot.mark_x && is_shown(frame.x, *plot.mark_x)) {
    const float x = frame.at_x(*plot.mark_x), em = ImGui::GetFontSize();
    draw.AddLine({x, frame.least.y}, {x, frame.most.y}, colour_u32(Tone::neutral), 0.15f * em);
    draw.AddCircleFilled({x, frame.most.y - 0.6f * em}, 0.5f * em, colour_u32(Tone::neutral));
  }
  draw.PopClipRect();
  if (!dragged) return std::nullopt;
  const float share = (ImGui::GetIO().MousePos.x - frame.least.x) / (frame.most.x - frame.least.x);
  return value_at(frame.x, std::clamp(double(share), 0.0, 1.0));
}

}  // namespace bosk
