#pragma once

#include "core/phantom/phantom.h"

namespace bosk {

// Nine photos of a chessboard beside a few of a small tree.
inline PhantomOptions small_board_photos(int photos) {
  PhantomOptions options = tiny_phantom();
  options.photos = photos;
  options.held_out = 0;
  options.board_photos = 9;
  options.width_px = 400;
  options.height_px = 300;
  options.samples = 2;
  return options;
}

}  // namespace bosk
