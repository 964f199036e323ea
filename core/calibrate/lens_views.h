#pragma once

#include <span>
#include <vector>

#include "core/calibrate/lens_solve.h"

namespace bosk {

// The numbers of the views that can be solved together: of one size and camera, with at least 6
// corners. `findings` gets an entry for every view, with the reason where it can't.
std::vector<std::size_t> views_that_match(std::span<const BoardView> views, const BoardShape& shape,
                                          std::vector<BoardFinding>& findings);

}  // namespace bosk
