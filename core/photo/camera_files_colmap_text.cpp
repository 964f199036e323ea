#include <algorithm>

#include "core/base/atomic_file.h"
#include "core/photo/camera_files_colmap.h"

// COLMAP's text model, one entry a line, '#' begins a comment line:
//   cameras.txt  id model width height parameters...
//   images.txt   id qw qx qy qz tx ty tz camera_id name       (camera_from_world)
//                x y point_id ...                             (a line of its own, often empty; not
//                used)
namespace bosk::camera_files {
namespace {

constexpr std::uint64_t kMaxBytes = std::uint64_t(1) << 31;

struct Line {
  std::string_view text;
  std::size_t number = 0;  // from 1
};

// The lines without line ends and leading blanks.
std::vector<Line> lines_of(std::string_view text) {
  std::vector<Line> lines;
  for (std::size_t begin = 0, number = 1; begin < text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string_view line = text.substr(begin, end - begin);
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ' || line.back() == '\t'))
      line.remove_suffix(1);
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    lines.push_back({line, number});
    begin = end + 1;
  }
  return lines;
}

// Cuts the next word off the front of `rest`; empty at its end.
std::string_view next_word(std::string_view& rest) {
  const std::size_t end = std::min(rest.find_first_of(" \t"), rest.size());
  const std::string_view word = rest.substr(0, end);
  rest.remove_prefix(std::min(rest.find_first_not_of(" \t", end), rest.size()));
  return word;
}

bool is_comment(const Line& line) { return line.text.starts_with('#'); }

// Whether the line holds the image's points (triples of numbers, or nothing), not another image,
// whose name makes it a text. Files made by hand tend to leave the points' line out.
bool is_points_line(const Line& line) {
  std::string_view rest = line.text;
  int words = 0;
  for (; !rest.empty(); ++words)
    if (next_word(rest).find_first_not_of("0123456789.+-eE") != std::string_view::npos)
      return false;
  return words % 3 == 0;
}

void read_lens(ColmapLenses& lenses, const Line& line, const std::string& place) {
  std::string_view rest = line.text;
  const std::uint64_t id = whole_number_from(next_word(rest), place);
  const ColmapModel& model = colmap_model(next_word(rest), place);
  Lens lens;
  const double width = number_from(next_word(rest), place);
  set_size(lens, width, number_from(next_word(rest), place), place);
  std::vector<double> parameters;
  while (!rest.empty()) parameters.push_back(number_from(next_word(rest), place));
  if (parameters.size() != std::size_t(model.parameters()))
    refuse(place, std::string(model.name) + " has " + std::to_string(model.parameters()) +
                      " parameters, not " + std::to_string(parameters.size()) +
                      "; correct the line");
  set_parameters(lens, model, parameters);
  add_lens(lenses, id, lens, place);
}

void read_image(CameraFile& result, const ColmapLenses& lenses, const Line& line,
                const std::string& place) {
  std::string_view rest = line.text;
  whole_number_from(next_word(rest), place);
  double pose[7];
  for (double& value : pose) value = number_from(next_word(rest), place);
  const std::uint64_t camera_id = whole_number_from(next_word(rest), place);
  add_image(result, lenses, camera_id, {pose[0], pose[1], pose[2], pose[3]},
            {pose[4], pose[5], pose[6]}, rest, place);
}

std::string place_of(const std::filesystem::path& file, const Line& line) {
  return file.string() + ", line " + std::to_string(line.number);
}

ColmapLenses read_lenses(const std::filesystem::path& file) {
  const std::string text = read_text(file, kMaxBytes);
  ColmapLenses lenses;
  for (const Line& line : lines_of(text))
    if (!line.text.empty() && !is_comment(line)) read_lens(lenses, line, place_of(file, line));
  return lenses;
}

}  // namespace

CameraFile read_colmap_text(const std::filesystem::path& folder) {
  const ColmapLenses lenses = read_lenses(folder / "cameras.txt");
  const std::filesystem::path file = folder / "images.txt";
  const std::string text = read_text(file, kMaxBytes);
  const std::vector<Line> lines = lines_of(text);
  CameraFile result;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].text.empty() || is_comment(lines[i])) continue;
    read_image(result, lenses, lines[i], place_of(file, lines[i]));
    if (i + 1 < lines.size() && is_points_line(lines[i + 1])) ++i;
  }
  check_set(result.cameras, file.string());
  return result;
}

void write_colmap_text(std::span<const Camera> cameras, const std::filesystem::path& folder,
                       Images images) {
  const SharedLenses shared = shared_lenses(cameras);
  std::string lens_text = "# camera_id model width height parameters\n";
  for (std::size_t i = 0; i < shared.lenses.size(); ++i) {
    const Lens& lens = shared.lenses[i];
    const ColmapModel& model = colmap_model_of(lens);
    lens_text += std::to_string(i + 1) + " " + std::string(model.name) + " " +
                 std::to_string(lens.width_px) + " " + std::to_string(lens.height_px);
    for (const double parameter : parameters_of(lens, model))
      lens_text += " " + text_from(parameter);
    lens_text += "\n";
  }
  std::string image_text =
      "# image_id qw qx qy qz tx ty tz camera_id name, then a line of points\n";
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    const RigidTransform& pose = cameras[i].camera_from_world;
    const glm::dvec4 wxyz = wxyz_from_rotation(pose.rotation);
    image_text += std::to_string(i + 1);
    for (int k = 0; k < 4; ++k) image_text += " " + text_from(wxyz[k]);
    for (int k = 0; k < 3; ++k) image_text += " " + text_from(pose.translation[k]);
    image_text +=
        " " + std::to_string(shared.of_camera[i] + 1) + " " + images[i].generic_string() + "\n\n";
  }
  write_file_atomically(folder / "cameras.txt", lens_text);
  write_file_atomically(folder / "images.txt", image_text);
  write_file_atomically(folder / "points3D.txt", "# point_id x y z r g b error track\n");
}

}  // namespace bosk::camera_files
