#include "core/measure/contact_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "core/measure/cv_view.h"
#include "core/measure/image_quality.h"

namespace bosk {
namespace {

constexpr int kGap_px = 10, kLine_px = 22;
constexpr int kMargin_px = 8;  // of the pictures, around what they show
constexpr double kLetterScale = 0.45;
constexpr double kGain = 3.0;
const char* const kHeadings[] = {"photo", "Bosk", "difference x 3"};

std::uint8_t byte_from_unit(double value) {
  return std::uint8_t(std::lround(255.0 * std::clamp(value, 0.0, 1.0)));
}

Image<glm::u8vec3> picture_over_white(const Image<glm::u8vec4>& rgba) {
  const Image<glm::dvec3> composite = over_white(rgba);
  Image<glm::u8vec3> picture(rgba.width(), rgba.height());
  for (std::size_t i = 0; i < picture.size(); ++i) {
    const glm::dvec3& pixel = composite.pixels()[i];
    picture.pixels()[i] = {byte_from_unit(pixel.r), byte_from_unit(pixel.g),
                           byte_from_unit(pixel.b)};
  }
  return picture;
}

// What either picture shows, and a margin: empty surroundings would only make the tree smaller. The
// whole where both are clear.
cv::Rect shown_part(const SheetRow& row) {
  const int width = row.truth.width(), height = row.truth.height();
  int left = width, top = height, right = -1, bottom = -1;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (row.truth(x, y).a == 0 && row.rendered(x, y).a == 0) continue;
      left = std::min(left, x), right = std::max(right, x);
      top = std::min(top, y), bottom = std::max(bottom, y);
    }
  }
  const cv::Rect whole(0, 0, width, height);
  if (right < 0) return whole;
  return cv::Rect({left - kMargin_px, top - kMargin_px},
                  cv::Point{right + 1 + kMargin_px, bottom + 1 + kMargin_px}) &
         whole;
}

cv::Size cell_size(const cv::Rect& part, int cell_px) {
  const double scale = std::min(1.0, double(cell_px) / std::max({1, part.width, part.height}));
  return {std::max(1, int(std::lround(scale * part.width))),
          std::max(1, int(std::lround(scale * part.height)))};
}

void write_line(cv::Mat& sheet, const std::string& text, int left, int top) {
  cv::putText(sheet, text, {left, top + kLine_px - 7}, cv::FONT_HERSHEY_SIMPLEX, kLetterScale,
              cv::Scalar::all(40), 1, cv::LINE_AA);
}

void draw_row(cv::Mat& sheet, const SheetRow& row, const cv::Rect& part, const cv::Size& cell,
              int column_px, int top) {
  const std::array<Image<glm::u8vec3>, 3> pictures{picture_over_white(row.truth),
                                                   picture_over_white(row.rendered),
                                                   difference_picture(row.rendered, row.truth)};
  int left = kGap_px;
  for (const auto& picture : pictures) {
    cv::Mat target = sheet(cv::Rect({left, top}, cell));
    cv::resize(cv_view(picture)(part), target, cell, 0.0, 0.0, cv::INTER_AREA);
    left += column_px + kGap_px;
  }
  write_line(sheet, row.caption, kGap_px, top + cell.height);
}

void check_row(const SheetRow& row) {
  if (row.truth.empty() || row.truth.width() != row.rendered.width() ||
      row.truth.height() != row.rendered.height()) {
    throw Error(row.caption +
                ": photo and rendered view differ in size; render at the photo's size");
  }
}

}  // namespace

Image<glm::u8vec3> difference_picture(const Image<glm::u8vec4>& rendered,
                                      const Image<glm::u8vec4>& truth) {
  const Image<glm::dvec3> a = over_white(rendered), b = over_white(truth);
  Image<glm::u8vec3> picture(truth.width(), truth.height());
  for (std::size_t i = 0; i < picture.size(); ++i) {
    const glm::dvec3 difference = kGain * glm::abs(a.pixels()[i] - b.pixels()[i]);
    picture.pixels()[i] = {byte_from_unit(difference.r), byte_from_unit(difference.g),
                           byte_from_unit(difference.b)};
  }
  return picture;
}

Image<glm::u8vec3> contact_sheet(const std::vector<SheetRow>& rows, int cell_px) {
  int column_px = 120, height_px = kGap_px + kLine_px;
  std::vector<cv::Rect> parts;
  std::vector<cv::Size> cells;
  for (const SheetRow& row : rows) {
    check_row(row);
    parts.push_back(shown_part(row));
    cells.push_back(cell_size(parts.back(), cell_px));
    column_px = std::max(column_px, cells.back().width);
    height_px += cells.back().height + kLine_px + kGap_px;
  }
  Image<glm::u8vec3> sheet(kGap_px + 3 * (column_px + kGap_px), height_px, glm::u8vec3(255));
  cv::Mat drawing = cv_view(sheet);
  for (int column = 0; column < 3; ++column) {
    write_line(drawing, kHeadings[column], kGap_px + column * (column_px + kGap_px), kGap_px / 2);
  }
  int top = kGap_px + kLine_px;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    draw_row(drawing, rows[i], parts[i], cells[i], column_px, top);
    top += cells[i].height + kLine_px + kGap_px;
  }
  return sheet;
}

}  // namespace bosk
