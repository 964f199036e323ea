#pragma once

#include "core/package/tree_model.h"

namespace bosk {

// Throws Error when a promise of tree_model.h or a published limit of format.h does not hold. The
// reader asks after decoding, the writer before encoding, so both mean the same by a valid tree.
void check_tree_model(const TreeModel& tree);

// The parts of it that decoding itself relies on.
void check_scene(const TreeModel& tree);  // origin, size, view positions
void check_atlas_size(int width_px, int height_px);
void check_level_frame(const TreeLevel& level, const TreeModel& tree);  // all but cells and indices

bool is_clean_text(
    const std::string& text);  // UTF-8 without control characters but tab and newline

}  // namespace bosk
