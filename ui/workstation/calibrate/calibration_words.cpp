#include "ui/workstation/calibrate/calibration_words.h"

#include <cmath>
#include <cstdio>

#include "core/project/calibration_figures.h"

namespace bosk {
namespace {

template <class... Numbers>
std::string formatted(const char* format, Numbers... numbers) {
  char text[128];
  std::snprintf(text, sizeof text, format, numbers...);
  return text;
}

std::string counted(std::size_t count, const std::string& thing) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

const SolvedPoint* point_named(const Calibration& calibration, const std::string& name) {
  for (const SolvedPoint& point : calibration.points) {
    if (point.name == name) return &point;
  }
  return nullptr;
}

std::string measured_words(double solved_m, double measured_m, double sigma_m) {
  const double off_m = solved_m - measured_m;
  const double off_mm = std::round(1e4 * off_m) / 10.0 + 0.0;  // never "-0.0"
  return formatted("solved %.3f m, %+.1f mm (%.1f sigma)", solved_m, off_mm,
                   std::abs(off_m) / sigma_m);
}

}  // namespace

Tone tone_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::good:
      return Tone::good;
    case Verdict::usable:
      return Tone::note;
    case Verdict::refused:
      break;
  }
  return Tone::bad;
}

Tone tone_of(PhotoFate fate) {
  switch (fate) {
    case PhotoFate::placed:
      return Tone::good;
    case PhotoFate::uncertain:
      return Tone::note;
    case PhotoFate::refused:
      break;
  }
  return Tone::bad;
}

std::string troubled_photos(const Calibration& calibration, PhotoFate fate) {
  std::string names;
  std::size_t count = 0;
  for (const PhotoFinding& photo : calibration.photos) {
    if (photo.fate != fate) continue;
    names += (count++ == 0 ? "" : ", ") + photo.photo;
  }
  if (count == 0) return {};
  return counted(count, "photo") + (count == 1 ? " is " : " are ") + fate_words(fate) + ": " +
         names;
}

std::string obstacle_to_tape(const Tape& tape) {
  if (tape.from.empty() || tape.to.empty()) return "choose the points at both ends";
  if (tape.from == tape.to) return "choose two different points";
  return tape.length_m > 0.0 ? "" : "type the length in metres";
}

std::optional<std::string> tape_words(const Calibration& calibration, const Tape& tape) {
  const SolvedPoint* from = point_named(calibration, tape.from);
  const SolvedPoint* to = point_named(calibration, tape.to);
  if (!from || !to || !calibration.scale_known) return std::nullopt;
  return measured_words(glm::distance(from->in_world, to->in_world), tape.length_m, tape.sigma_m);
}

std::optional<std::string> height_words(const Calibration& calibration, const Height& height) {
  const SolvedPoint* point = point_named(calibration, height.point);
  if (!point || !calibration.scale_known) return std::nullopt;
  return measured_words(point->in_world.z, height.height_m, height.sigma_m);
}

}  // namespace bosk
