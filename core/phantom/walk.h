#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/phantom/phantom_options.h"
#include "core/phantom/scene.h"
#include "core/photo/camera.h"

namespace bosk {

// The photographer's walk round a tree whose points are given: photographs on a jittered ring at
// eye height, looking at the crown; held-out views in between, every second one 10 to 35 degrees
// up.
struct Walk {
  std::vector<Camera> photos, held_out;
};

Lens phantom_lens(const PhantomOptions& options);
Walk walk_round(const std::vector<glm::vec3>& tree_points, const PhantomOptions& options);

// Views of a board from near by, at many angles, the board filling much of the picture.
std::vector<Camera> board_views(const Board& board, const PhantomOptions& options);

}  // namespace bosk
