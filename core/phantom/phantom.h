#pragma once

#include <filesystem>
#include <glm/gtc/type_precision.hpp>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/image/image.h"
#include "core/phantom/density.h"
#include "core/phantom/phantom_options.h"
#include "core/phantom/scene.h"
#include "core/photo/camera.h"
#include "core/photo/photo.h"

namespace bosk {

// One picture of a phantom, in its lens's distorted pixels.
struct PhantomView {
  Camera camera;  // named 000, 001, ...
  Image<glm::u8vec3> photograph;
  Image<glm::u8vec4> matte;            // straight sRGB and alpha of the tree alone: the truth
  Image<std::uint8_t> in_front;        // where markers hide what is behind
  double exposure = 1.0;               // in photograph and matte
  std::vector<glm::dvec2> marker_px;   // true pixel of each marker's centre
  std::vector<double> marker_visible;  // share of its disc that shows
};

struct Phantom {
  PhantomOptions options;
  std::vector<PhantomView> photos;
  std::vector<PhantomView> held_out;  // at rest, exposure 1, no noise
  std::vector<Marker> markers;
  std::vector<PhantomView> board_photos;
  Board board;
  TreeDensity density;  // of the tree at rest
  std::size_t leaves = 0;
};

// Grows, lights and photographs a tree. The same to the bit for the same options at any number of
// threads.
Phantom make_phantom(const PhantomOptions& options, Progress& progress);

// Lays a phantom out as a capture with truth:
//   photos/000.jpg ...         the photographs, JPEG quality 95, 4:4:4
//   transforms.json            their true cameras
//   mattes/000.png ...         RGBA, straight alpha
//   heldout/000.png ...        RGBA of the held-out views; transforms_heldout.json: their cameras
//   scribbles/000.png ...      strokes: white foreground, black background, grey unknown
//   board/000.jpg ...          chessboard photos, where asked for; transforms_board.json
//   density.npy                float32 [z][y][x], extinction per metre of the tree at rest
//   truth.json                 options, markers, where they show, the density's box
// Error when the folder can't be written.
void write_phantom(const std::filesystem::path& folder, const Phantom& phantom, Progress& progress);

// Photos as the stages after import take them. The phantom must have been made with distortion 0.
Photos pinhole_photos(const Phantom& phantom);
// A view's matte in floating point: straight sRGB colour and alpha, 0 to 1.
Image<glm::vec4> straight_matte(const PhantomView& view);

}  // namespace bosk
