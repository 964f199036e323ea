#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/compress/level_statistics.h"
#include "core/project/stages.h"
#include "ui/widgets/image_view.h"

namespace bosk {

struct Workspace;

// A level's row of the table.
struct LevelRow {
  LevelStatistics statistics;
  std::size_t fullest = 0;       // the cell to begin with
  std::size_t packed_bytes = 0;  // in the package; 0: there is none of these textures
};

// What the step remembers between frames.
struct TexturesStepState {
  std::vector<LevelRow> rows;  // of the billboards and the package below
  std::shared_ptr<const Billboards> counted;
  std::shared_ptr<const std::vector<std::byte>> counted_package;
  int level = -1;  // place among the billboards' levels; -1: the finest with several views
  int cell = -1;   // place among the level's cells; -1: its fullest
  int view = 0;    // of the sheet that cells are picked from
  ImageView sheet_view, cell_view;
};

void draw_textures_step(Workspace& workspace);
// The sheet that cells are picked from and the cell's textures: textures_views.cpp.
void draw_textures_views(Workspace& workspace);

// Brings the rows up to date with the results; once a frame.
void follow_rows(Workspace& workspace);

// The finest level with several views, or the finest of all.
int chosen_level(const Billboards& billboards);
// Rows for the table. `package` may be null.
std::vector<LevelRow> level_rows(const Billboards& billboards,
                                 const std::vector<std::byte>* package);
// The codebooks that stand for the billboards shown; null where there are none.
std::shared_ptr<const CodedTextures> codebooks_of_shown(const Workspace& workspace);
// As draw_image_view, over a light ground: textures are mostly clear.
ImagePlace draw_sheet_view(const std::string& name, ImageView& view, const Texture& texture,
                           const glm::dvec2& size_px, const ImVec2& area);
// Which results pictures of textures are made from: changes with either of them.
std::uint64_t textures_revision(const Workspace& workspace);

}  // namespace bosk
