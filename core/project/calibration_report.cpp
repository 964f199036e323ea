#include "core/project/calibration_report.h"

#include <algorithm>
#include <glm/gtc/constants.hpp>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/calibrate/lens_pictures.h"
#include "core/image/area_mean.h"
#include "core/image/image_io.h"
#include "core/project/calibration_figures.h"
#include "core/project/camera_wheel.h"
#include "core/project/each_photo.h"
#include "core/project/html.h"
#include "core/project/reshoot.h"
#include "core/project/svg_labels.h"

namespace bosk {
namespace {

using Rows = std::vector<std::vector<std::string>>;

constexpr int kPictureWidthPx = 480;
constexpr int kJpegQuality = 80;
constexpr int kMapWidthPx = 420;
constexpr double kResidualEnlarged = 20.0;

constexpr const char* kStyle =
    ".good{color:#1b7f3b}.usable{color:#c77700}.refused{color:#c4161c}"
    "figure{display:inline-block;margin:.5em;vertical-align:top}figcaption{max-width:480px}"
    "svg text{font-family:system-ui,sans-serif}";

const char* css_class(Verdict verdict) {
  if (verdict == Verdict::good) return "good";
  return verdict == Verdict::usable ? "usable" : "refused";
}

std::string list(const std::vector<std::string>& items) {
  std::string text = "<ul>\n";
  for (const std::string& item : items) text += "<li>" + html_text(item) + "</li>\n";
  return text + "</ul>\n";
}

std::string length_text(double length, const Calibration& calibration) {
  return calibration.scale_known ? number_text(1000.0 * length, 1) + " mm" : number_text(length, 4);
}

std::string photo_table(const Calibration& calibration) {
  Rows rows = {{"photo", "", "points", "outliers", "rms px", "at the crown px", "place", "why"}};
  for (const PhotoFinding& photo : calibration.photos) {
    const bool placed = photo.fate != PhotoFate::refused;
    rows.push_back(
        {photo.photo, fate_words(photo.fate), std::to_string(photo.sightings),
         placed ? std::to_string(photo.outliers) : "", placed ? number_text(photo.rms_px, 2) : "",
         placed ? number_text(photo.crown_sigma_px, 2) : "",
         placed ? length_text(spread(photo.centre_covariance_m2), calibration) : "", photo.reason});
  }
  return html_table(rows);
}

std::string marker_table(const Calibration& calibration) {
  Rows rows = {{"marker", "photos", "rms px", "x", "y", "z", "error, one sigma"}};
  for (const SolvedPoint& point : calibration.points) {
    if (is_feature(point.name)) continue;
    const glm::dvec3& place = point.in_world;
    rows.push_back({point.name, std::to_string(point.photos), number_text(point.rms_px, 2),
                    number_text(place.x, 3), number_text(place.y, 3), number_text(place.z, 3),
                    length_text(spread(point.covariance_m2), calibration)});
  }
  return html_table(rows);
}

std::string lens_table(const Calibration& calibration) {
  const Lens& lens = calibration.lens;
  std::string distortion;
  for (const double term : lens.distortion) {
    distortion += (distortion.empty() ? "" : ", ") + number_text(term, 5);
  }
  return html_table(
      {{"lens", calibration.lens_was_known ? "known beforehand" : "found with the cameras"},
       {"frame", std::to_string(lens.width_px) + " x " + std::to_string(lens.height_px) + " px"},
       {"focal length",
        number_text(lens.focal_px.x, 2) + ", " + number_text(lens.focal_px.y, 2) + " px"},
       {"principal point",
        number_text(lens.principal_px.x, 2) + ", " + number_text(lens.principal_px.y, 2) + " px"},
       {"distortion k1 k2 p1 p2 k3 k4 k5 k6", distortion}});
}

std::string figure(const std::string& content, const std::string& caption) {
  return "<figure>" + content + "<figcaption>" + html_text(caption) + "</figcaption></figure>\n";
}

std::string map_figure(const Image<glm::u8vec3>& map, const std::string& caption) {
  if (map.empty()) return "";
  return figure(
      "<img alt=\"" + html_text(caption) + "\" src=\"" + data_url("png", png_bytes(map)) + "\">",
      caption);
}

std::string board_section(const LensCalibration& boards) {
  Rows rows = {{"board photo", "used", "corners", "outliers", "rms px", "tilt, degrees", "why"}};
  for (const BoardFinding& board : boards.boards) {
    rows.push_back({board.photo, board.used ? "yes" : "no", std::to_string(board.corners),
                    std::to_string(board.outliers), number_text(board.rms_px, 3),
                    number_text(board.tilt * 180.0 / glm::pi<double>(), 0), board.reason});
  }
  Rows trials = {{"lens model", "rms px", "on boards held out, px", ""}};
  for (const LensTrial& trial : boards.trials) {
    trials.push_back({trial.model, number_text(trial.rms_px, 3),
                      number_text(trial.held_out_rms_px, 3), trial.chosen ? "chosen" : ""});
  }
  return "<h2>Boards</h2>\n<p class=\"" + std::string(css_class(boards.verdict)) + "\">" +
         verdict_words(boards.verdict) + "</p>\n" + list(boards.sentences) +
         map_figure(
             coverage_picture(boards, kMapWidthPx),
             "Where corners were seen: red has none; dots from green to red by their error") +
         map_figure(uncertainty_picture(boards.profile, kMapWidthPx, 1.0),
                    "How sure the lens is of each place: blue 0, red 1 px and more") +
         html_table(trials) + html_table(rows);
}

// A photo small enough for a page; empty where it can't be read.
std::vector<std::byte> small_jpeg(const SourceFile& file, PhotoDecoder& decoder,
                                  const Progress& progress) {
  try {
    const Image<glm::vec3> srgb = srgb_of(decoder.decode(file.path, progress));
    const int width = std::min(kPictureWidthPx, srgb.width());
    const int height = std::max(1, int(double(srgb.height()) * width / srgb.width()));
    return jpeg_bytes(rgb8_from_srgb(area_mean_srgb(srgb, width, height)), kJpegQuality);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::bad_input) throw;
    return {};
  }
}

std::vector<std::vector<std::byte>> small_jpegs(const CalibrationSources& sources,
                                                Progress& progress) {
  progress.begin("drawing the report", sources.photos.size());
  std::vector<std::vector<std::byte>> all(sources.photos.size());
  for_each_photo(all.size(), sources.limits, progress, [&](std::size_t i, PhotoDecoder& decoder) {
    all[i] = small_jpeg(sources.photos[i], decoder, progress);
  });
  return all;
}

const char* colour_of(const SightingResidual& residual) {
  return residual.outlier ? "#ff2020" : "#ffee00";
}

// A circle where the point is seen, and a line to where it is predicted, enlarged.
std::string residual_svg(const SightingResidual& residual, double px) {
  const glm::dvec2 seen = residual.pixel;
  const glm::dvec2 end = seen + kResidualEnlarged * residual.error_px;
  const std::string stroke = "stroke=\"" + std::string(colour_of(residual)) + "\" stroke-width=\"" +
                             number_text(2.0 * px, 2) + "\"";
  const double radius = (is_feature(residual.point) ? 2.0 : 7.0) * px;
  return "<line x1=\"" + number_text(seen.x, 1) + "\" y1=\"" + number_text(seen.y, 1) + "\" x2=\"" +
         number_text(end.x, 1) + "\" y2=\"" + number_text(end.y, 1) + "\" " + stroke +
         "/><circle cx=\"" + number_text(seen.x, 1) + "\" cy=\"" + number_text(seen.y, 1) +
         "\" r=\"" + number_text(radius, 1) + "\" fill=\"none\" " + stroke + "/>";
}

// Where not all have room: what was left out first, feet last, since they stand under their balls.
std::string names_svg(std::vector<SightingResidual> residuals, const glm::dvec2& size, double px) {
  const auto rank = [](const SightingResidual& one) {
    return one.outlier ? 0 : is_foot(one.point) ? 2 : 1;
  };
  std::stable_sort(residuals.begin(), residuals.end(),
                   [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  std::vector<SvgLabel> labels;
  for (const SightingResidual& each : residuals) {
    if (!is_feature(each.point))
      labels.push_back({each.pixel, each.point, colour_of(each), each.outlier});
  }
  return svg_labels(labels, 14.0 * px, 9.0 * px, glm::dvec2(-0.5), size - 0.5);
}

std::string photo_figure(const PhotoFinding& photo, const Calibration& calibration,
                         const std::vector<std::byte>& jpeg) {
  const Lens& lens = calibration.lens;
  const int width = std::max(1, lens.width_px), height = std::max(1, lens.height_px);
  const double px = double(width) / kPictureWidthPx;
  const std::string size =
      "width=\"" + std::to_string(width) + "\" height=\"" + std::to_string(height) + "\"";
  std::string svg = "<svg viewBox=\"-0.5 -0.5 " + std::to_string(width) + " " +
                    std::to_string(height) + "\" style=\"width:" + std::to_string(kPictureWidthPx) +
                    "px\">";
  if (!jpeg.empty()) {
    svg += "<image x=\"-0.5\" y=\"-0.5\" " + size + " href=\"" + data_url("jpeg", jpeg) + "\"/>";
  }
  std::vector<SightingResidual> residuals;
  for (const SightingResidual& residual : calibration.residuals) {
    if (residual.photo == photo.photo) residuals.push_back(residual);
  }
  for (const SightingResidual& residual : residuals) svg += residual_svg(residual, px);
  svg += names_svg(std::move(residuals), {width, height}, px);
  return figure(svg + "</svg>", photo.photo + ": " + fate_words(photo.fate) +
                                    (photo.reason.empty() ? "" : ", " + photo.reason));
}

std::string photo_figures(const CalibrationSources& sources, const Calibration& calibration,
                          Progress& progress) {
  const auto jpegs = small_jpegs(sources, progress);
  std::string text;
  for (const PhotoFinding& photo : calibration.photos) {
    const auto file = std::find_if(sources.photos.begin(), sources.photos.end(),
                                   [&](const SourceFile& one) { return one.name == photo.photo; });
    if (file == sources.photos.end()) continue;
    text += photo_figure(photo, calibration, jpegs[std::size_t(file - sources.photos.begin())]);
  }
  return text;
}

std::string reshoot_list(const Calibration& calibration) {
  std::vector<std::string> items;
  for (const ReshootPlace& place : reshoot_places(calibration)) items.push_back(place.why);
  return items.empty() ? "" : "<p>Re-shoot:</p>\n" + list(items);
}

}  // namespace

void write_calibration_report(const std::filesystem::path& path, const std::string& title,
                              const CalibrationSources& sources, const Calibration& calibration,
                              const std::optional<LensCalibration>& boards, Progress& progress) {
  const std::string name = html_text(title);
  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + name +
      ": cameras</title><style>" + kHtmlStyle + kStyle + "</style></head><body>\n<h1>" + name +
      ": cameras</h1>\n<p class=\"" + css_class(calibration.verdict) + "\"><b>" +
      verdict_words(calibration.verdict) + "</b>: " + html_text(summary_words(calibration)) +
      "</p>\n" + list(calibration.sentences);
  if (!calibration.cameras.empty()) {
    page += "<h2>The walk, from above</h2>\n" + camera_wheel_svg(calibration) +
            reshoot_list(calibration);
  }
  page += "<h2>Photos</h2>\n" + photo_table(calibration) + "<h2>Markers</h2>\n" +
          marker_table(calibration) + "<h2>Lens</h2>\n" + lens_table(calibration);
  if (boards) page += board_section(*boards);
  page +=
      "<h2>Sightings</h2>\n<p>Circles: where a point is seen. Lines: from there to where the "
      "solution puts it, enlarged " +
      number_text(kResidualEnlarged, 0) +
      " times; red ones were left out. Names stand where they fit.</p>\n" +
      photo_figures(sources, calibration, progress) +
      "<p>Made by bosk " BOSK_VERSION ".</p>\n</body></html>\n";
  write_file_atomically(path, page);
}

}  // namespace bosk
