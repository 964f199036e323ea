#pragma once

#include <imgui.h>

#include <string>
#include <vector>

#include "core/calibrate/calibration.h"
#include "ui/workstation/calibrate/frusta.h"

namespace bosk {

// Words beside a place of the view.
struct SceneLabel {
  ImVec2 at{0, 0};
  ImU32 colour = 0;
  std::string words;
  bool needed = false;  // rather over a point than not at all
};

// The view of the cameras on the screen.
struct FrustaScene {
  Camera eye;  // a pinhole, in pixels from `least`
  ImVec2 least{0, 0}, most{0, 0};
  ImDrawList* draw = nullptr;
  std::vector<SceneLabel>* labels = nullptr;  // over all else; the first choose first

  ImVec2 on_screen(const glm::dvec2& pixel) const {
    return {least.x + float(pixel.x + 0.5), least.y + float(pixel.y + 0.5)};
  }
  void line(const glm::dvec3& from, const glm::dvec3& to, ImU32 colour, float width) const;
  void text(const glm::dvec3& at, ImU32 colour, const std::string& words,
            bool needed = false) const;
  bool shows(const ImVec2& place) const {
    return place.x > least.x && place.x < most.x && place.y > least.y && place.y < most.y;
  }
};

// The scene's labels where they cover neither each other nor a point; those without room are
// left out.
void draw_labels(const FrustaScene& scene);

// Solved points with their names, and ellipsoids of one sigma around points and camera centres,
// exaggerated so that the median one of the cameras is about `wanted_m` large; the corner says how
// much. Uncertain photos are named beside their cameras.
void draw_error_bars(const FrustaScene& scene, const Calibration& calibration, double wanted_m);

}  // namespace bosk
