#pragma once

#include <imgui.h>

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace bosk {

struct PlotAxis {
  std::string label;         // with its unit
  bool logarithmic = false;  // values must then be positive; others are left out
  // Ends; equal: those of the values, grown a little.
  double least = 0.0, most = 0.0;
};

struct PlotLine {
  std::string name;  // beside its end and in the tooltip
  std::vector<glm::dvec2> points;
  bool right_axis = false;  // measured by the second axis
};

// A chart of lines, told apart by colour, dash and name.
struct Plot {
  PlotAxis x, y;
  std::optional<PlotAxis> right;
  std::vector<PlotLine> lines;
  std::optional<double> mark_x;  // an upright line with a handle
};

// Draws it in an item of `area` (0: all that is left), marked as landmark `name`. Returns the x
// value under the mouse while the left button drags in the chart; the caller decides what that
// moves. Values that aren't finite are left out.
std::optional<double> draw_plot(const std::string& name, const Plot& plot, ImVec2 area = {0, 0});

// About `count` round values (1, 2, 5 times a power of ten; powers of two or ten on a logarithmic
// axis) within the axis.
std::vector<double> ticks(const PlotAxis& axis, int count);

}  // namespace bosk
