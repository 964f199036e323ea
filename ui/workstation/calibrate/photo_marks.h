#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/calibrate/calibration.h"
#include "core/project/calibration_finds.h"
#include "core/project/calibration_inputs.h"
#include "core/project/edit.h"

namespace bosk {

// A point of the scene on one photo, as it is drawn there. Pixels are of the photo as delivered.
struct PhotoMark {
  enum class Kind : std::uint8_t {
    found,     // by itself
    by_hand,   // placed or moved by a person
    removed,   // found, but a person said that it isn't there
    expected,  // seen elsewhere; here is where the solve says that it must be
  } kind = Kind::found;
  std::string point;
  glm::dvec2 pixel{0.0};
  bool is_feature = false;  // one of many on trunk and ground, without a name to show
  std::optional<glm::dvec2> error_px =
      std::nullopt;      // predicted minus seen; none where this place wasn't solved
  bool outlier = false;  // the solve leaves it out
};

// Of the photo: what was found with a person's say over it, then points that the solve expects
// within the picture. `finds` and `solved` may be null.
std::vector<PhotoMark> marks_of(const std::string& photo, const CalibrationFinds* finds,
                                const HandSightings& told, const Calibration* solved);
// The nearest mark that a hand can take, at most `reach_px` away; null: none.
const PhotoMark* mark_at(std::span<const PhotoMark> marks, const glm::dvec2& pixel,
                         double reach_px);
// "red, by hand, left out: 12.3 px off".
std::string words_of(const PhotoMark& mark);

// A point that has a name of its own, over all photos.
struct PointRow {
  std::string name;
  int photos = 0;                 // that it is seen in now
  std::optional<double> rms_px;   // of the newest solve; none where it has no place there
  std::optional<double> sigma_m;  // of its place there: one sigma over all three axes
};
// By name: points that are seen or measured, but no features. `finds` and `solved` may be null.
std::vector<PointRow> points_of(const CalibrationFinds* finds, const CalibrationInputs& told,
                                const Calibration* solved);

// Edits by a person; what was found by itself stays underneath.

// So that the point isn't seen in the photo, also where it is found there again.
SetSighting removal_edit(const Project& project, const CalibrationFinds* finds,
                         const std::string& photo, const std::string& point);
// So that the point called `from` is called `to` in these photos; where a photo has both, they
// change places. Empty where no photo has it.
SetSightings renaming_edit(const Project& project, const CalibrationFinds* finds,
                           std::span<const std::string> photos, const std::string& from,
                           const std::string& to);
// Why a point can't be called so; empty when it can.
std::string obstacle_to_name(const std::string& name);
// Tapes, heights and surveyed points with the name changed.
Measurements renamed(Measurements measurements, const std::string& from, const std::string& to);

}  // namespace bosk
