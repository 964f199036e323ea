#include <algorithm>
#include <array>
#include <cstring>
#include <nlohmann/json.hpp>
#include <span>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/image/image_io.h"
#include "core/phantom/phantom.h"
#include "core/phantom/scribbles.h"
#include "core/photo/camera_files.h"

namespace bosk {
namespace {

using nlohmann::ordered_json;

void write_jpeg(const std::filesystem::path& path, const Image<glm::u8vec3>& rgb) {
  write_file_atomically(path, jpeg_bytes(rgb, 95));
}

void write_camera_list(const std::filesystem::path& file, const std::vector<PhantomView>& views,
                       const std::string& folder, const std::string& ending) {
  std::vector<Camera> cameras;
  std::vector<std::filesystem::path> images;
  for (const PhantomView& view : views) {
    cameras.push_back(view.camera);
    images.push_back(std::filesystem::path(folder) / (view.camera.name + ending));
  }
  if (!cameras.empty()) write_cameras(cameras, "transforms", file, images);
}

// NumPy's own format, version 1.0: magic, header length, a literal padded to 64 bytes, the numbers.
void write_npy(const std::filesystem::path& path, const std::vector<float>& values, int side) {
  const std::string edge = std::to_string(side);
  std::string header = "{'descr': '<f4', 'fortran_order': False, 'shape': (" + edge + ", " + edge +
                       ", " + edge + "), }";
  header.append((64 - (10 + header.size() + 1) % 64) % 64, ' ');
  header += '\n';
  std::string file = "\x93NUMPY";
  file += '\x01';
  file += '\0';
  file += char(header.size() & 0xff);
  file += char(header.size() >> 8);
  file += header;
  const std::size_t start = file.size();
  file.resize(start + values.size() * sizeof(float));
  std::memcpy(file.data() + start, values.data(), values.size() * sizeof(float));
  write_file_atomically(path, file);
}

ordered_json json_of(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

ordered_json json_of_markers(const Phantom& phantom) {
  ordered_json markers = ordered_json::array();
  for (const Marker& marker : phantom.markers) {
    const glm::ivec3 colour(marker.colour_srgb);
    markers.push_back({{"name", marker.name},
                       {"colour_srgb", {colour.x, colour.y, colour.z}},
                       {"xyz", json_of(marker.centre)},
                       {"diameter_m", 2.0 * marker.radius}});
  }
  return markers;
}

ordered_json json_of_view(const Phantom& phantom, const PhantomView& view) {
  ordered_json markers = ordered_json::array();
  for (std::size_t i = 0; i < phantom.markers.size(); ++i) {
    markers.push_back({{"name", phantom.markers[i].name},
                       {"x", view.marker_px[i].x},
                       {"y", view.marker_px[i].y},
                       {"visible", view.marker_visible[i]}});
  }
  return {{"name", view.camera.name}, {"exposure", view.exposure}, {"markers", markers}};
}

ordered_json json_of_board(const Board& board) {
  const glm::dmat3& turn = board.world_from_board.rotation;
  return {{"columns", board.columns},
          {"rows", board.rows},
          {"square_m", board.square},
          {"first_inner_corner", json_of(board.world_from_board.translation)},
          {"along_columns", json_of(turn[0])},
          {"along_rows", json_of(turn[1])}};
}

std::string truth_text(const Phantom& phantom) {
  PhantomOptions options = phantom.options;
  ordered_json truth;
  truth["frame"] = "metres, z up, origin at the foot of the trunk; pixel (0, 0) is a centre";
  for (const Option& option : describe(options)) truth["options"][option.name] = value_text(option);
  truth["leaves"] = phantom.leaves;
  truth["markers"] = json_of_markers(phantom);
  for (const PhantomView& view : phantom.photos) {
    truth["photos"].push_back(json_of_view(phantom, view));
  }
  if (!phantom.board_photos.empty()) truth["board"] = json_of_board(phantom.board);
  truth["density"] = {{"file", "density.npy"},
                      {"index_order", "[z][y][x]"},
                      {"unit", "extinction per metre"},
                      {"lower_corner", json_of(phantom.density.box.lower)},
                      {"voxel_m", phantom.density.voxel_m()}};
  return truth.dump(1) + "\n";
}

void write_density(const std::filesystem::path& path, const TreeDensity& density) {
  std::vector<float> extinction(density.leaf_area.size());
  for (std::size_t i = 0; i < extinction.size(); ++i) extinction[i] = density.extinction(i);
  write_npy(path, extinction, density.side);
}

void write_scribbles(const std::filesystem::path& folder, const Phantom& phantom) {
  const auto photos = phantom.photos.size();
  const auto wanted = std::min(std::size_t(phantom.options.scribbled_photos), photos);
  for (std::size_t k = 0; k < wanted; ++k) {
    const PhantomView& view = phantom.photos[k * photos / wanted];
    write_png(folder / (view.camera.name + ".png"),
              draw_scribbles(view, std::uint64_t(phantom.options.seed)));
  }
}

}  // namespace

void write_phantom(const std::filesystem::path& folder, const Phantom& phantom,
                   Progress& progress) {
  progress.begin("Writing the capture", phantom.photos.size() + phantom.held_out.size() + 1);
  for (const char* part : {"photos", "mattes", "heldout", "scribbles"}) make_folder(folder / part);
  for (const PhantomView& view : phantom.photos) {
    write_jpeg(folder / "photos" / (view.camera.name + ".jpg"), view.photograph);
    write_png(folder / "mattes" / (view.camera.name + ".png"), view.matte);
    progress.advance();
  }
  for (const PhantomView& view : phantom.held_out) {
    write_png(folder / "heldout" / (view.camera.name + ".png"), view.matte);
    progress.advance();
  }
  if (!phantom.board_photos.empty()) make_folder(folder / "board");
  for (const PhantomView& view : phantom.board_photos) {
    write_jpeg(folder / "board" / (view.camera.name + ".jpg"), view.photograph);
  }
  write_camera_list(folder / "transforms.json", phantom.photos, "photos", ".jpg");
  write_camera_list(folder / "transforms_heldout.json", phantom.held_out, "heldout", ".png");
  write_camera_list(folder / "transforms_board.json", phantom.board_photos, "board", ".jpg");
  write_scribbles(folder / "scribbles", phantom);
  write_density(folder / "density.npy", phantom.density);
  write_file_atomically(folder / "truth.json", truth_text(phantom));
  progress.advance();
}

}  // namespace bosk
