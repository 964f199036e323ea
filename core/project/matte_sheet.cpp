#include "core/project/matte_sheet.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>

#include "core/base/atomic_file.h"
#include "core/base/number_text.h"
#include "core/image/area_mean.h"
#include "core/image/image_io.h"
#include "core/project/html.h"

namespace bosk {
namespace {

constexpr int kPictureWidthPx = 280;
constexpr int kJpegQuality = 82;
constexpr glm::vec3 kBlack{0.0f}, kMagenta{1.0f, 0.0f, 1.0f};  // sRGB

constexpr const char* kStyle =
    "section{margin:0 0 1.5em}section img{width:24%;margin-right:.5%}.look{color:#c77700}";

std::string picture(const Image<glm::vec3>& srgb, const std::string& words) {
  return "<img alt=\"" + html_text(words) + "\" title=\"" + html_text(words) + "\" src=\"" +
         data_url("jpeg", jpeg_bytes(rgb8_from_srgb(srgb), kJpegQuality)) + "\">";
}

Image<glm::vec3> grey_of(const Image<glm::vec4>& straight) {
  Image<glm::vec3> grey(straight.width(), straight.height());
  std::transform(straight.pixels().begin(), straight.pixels().end(), grey.pixels().begin(),
                 [](const glm::vec4& pixel) { return glm::vec3(pixel.a); });
  return grey;
}

std::string row_of(const Photo& photo, const Matte& matte) {
  const int width = std::min(kPictureWidthPx, photo.srgb.width());
  const int height = std::max(1, int(double(photo.srgb.height()) * width / photo.srgb.width()));
  const Image<glm::vec4> small = area_mean_straight(matte.rgba, width, height);
  return picture(area_mean_srgb(photo.srgb, width, height), photo.name) +
         picture(grey_of(small), photo.name + ": matte") +
         picture(over_colour(small, kBlack), photo.name + ": on black") +
         picture(over_colour(small, kMagenta), photo.name + ": on magenta");
}

std::string heading(const MatteDoubt& doubt, double median) {
  const bool look = stands_out(doubt, median);
  std::string words = html_text(doubt.photo);
  if (look) words += " <span class=\"look\">look here</span>";
  if (look && !doubt.reason.empty()) words += ": " + html_text(doubt.reason);
  return "<h3>" + words + "</h3>\n";
}

// Those that stand out by their doubt, then the others as they come.
std::vector<std::size_t> order_of(const std::vector<MatteDoubt>& doubts, double median) {
  std::vector<std::size_t> order(doubts.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto rank = [&](std::size_t i) {
    return stands_out(doubts[i], median) ? doubts[i].doubt : 0.0;
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return rank(a) > rank(b); });
  return order;
}

}  // namespace

void write_matte_sheet(const std::filesystem::path& path, const std::string& title,
                       const Photos& photos, const Mattes& mattes,
                       const std::vector<MatteDoubt>& doubts, Progress& progress) {
  progress.begin("drawing the contact sheet", mattes.size());
  std::vector<std::string> rows(mattes.size());
  tbb::parallel_for(std::size_t(0), mattes.size(), [&](std::size_t i) {
    rows[i] = row_of(photos[i], mattes[i]);
    progress.advance();
  });
  const std::string name = html_text(title);
  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + name +
      ": mattes</title><style>" + kHtmlStyle + kStyle + "</style></head><body>\n<h1>" + name +
      ": mattes</h1>\n<p>Photo, matte, the tree over black and over magenta. Those first that are "
      "least like the others; correct them with a few strokes.</p>\n";
  const double median = median_doubt(doubts);
  for (const std::size_t i : order_of(doubts, median)) {
    page += "<section>" + heading(doubts[i], median) + rows[i] + "</section>\n";
  }
  page += "<p>Made by bosk " BOSK_VERSION ".</p>\n</body></html>\n";
  write_file_atomically(path, page);
}

}  // namespace bosk
