#include "core/render/level_switch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "tests/render/toy_trees.h"

namespace bosk {
namespace {

// A cube of half-transparent cells, a fine chequer at level 5; level 4 has its mean and the opacity
// of two cells in a row, level 3 of what `coarse` says.
TreeModel chequered(const glm::u8vec4& coarse) {
  TreeModel model = toy::random_ball(21, 4, 4);
  model.atlas =
      toy::plain_atlas({{60, 120, 30, 100}, {100, 160, 70, 100}, {80, 140, 50, 161}, coarse});
  std::vector<std::uint64_t> cells;
  for (std::uint64_t code = 0; code < std::uint64_t(32) * 32 * 32; ++code) {
    const glm::uvec3 cell = cell_from_morton(code);
    if (cell.x / 8 % 3 && cell.y / 8 % 3 && cell.z / 8 % 3) cells.push_back(code);
  }
  const auto colour = [&](int level, std::uint64_t code) {
    const glm::uvec3 cell = cell_from_morton(code);
    return std::uint16_t(level == 5 ? (cell.x + cell.y + cell.z) % 2 : unsigned(6 - level));
  };
  for (int level = 5; level >= 3; --level) {
    model.levels[std::size_t(level - 3)] =
        toy::make_level(level, 4, 1.2f, cells, 4,
                        [&](std::size_t cell, auto...) { return colour(level, cells[cell]); });
    for (std::uint64_t& cell : cells) cell >>= 3;
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  }
  return model;
}

std::vector<Camera> three_cameras() {
  std::vector<Camera> cameras;
  for (const glm::dvec3 eye : {glm::dvec3(0, -5, 1.5), {5, 1, 2}, {-3, 4, 3}})
    cameras.push_back(toy::look_at(eye, {0, 0, 1}, 500, 100, 100));
  return cameras;
}

TEST(LevelSwitch, GivesALevelTheSizesWhereItLooksLikeTheFinest) {
  TreeModel model = chequered({80, 140, 50, 220});
  Progress quiet;
  set_level_switches(model, three_cameras(), quiet);
  const float switch_px = model.levels[1].max_cell_px;
  EXPECT_GT(switch_px, 0.3f);
  EXPECT_LT(switch_px, 4.0f);  // a chequer of 2 px would show
  EXPECT_EQ(model.levels[2].max_cell_px, 0.0f);
  // Up to there it is as good as asked: 31 dB, or within 1 dB of what the best level manages
  std::map<double, double> best_db, level_db;  // by size of a level-4 cell
  for (const LevelError& error : measure_level_errors(model, three_cameras(), {}, quiet)) {
    double& best = best_db[error.tree_px / 16.0];
    best = std::max(best, error.psnr_db);
    if (error.level_slot == 1) level_db[error.cell_px] = error.psnr_db;
  }
  const auto above = level_db.upper_bound(double(switch_px));
  const auto is_good = [&](const auto& size) {
    return size.second >= std::min(31.0, best_db.at(size.first) - 1.0);
  };
  ASSERT_NE(above, level_db.begin());
  EXPECT_TRUE(is_good(*std::prev(above)));  // the largest size at which it is drawn
  EXPECT_TRUE(std::none_of(above, level_db.end(), is_good));
}

TEST(LevelSwitch, NeverChoosesALevelOfTheWrongColour) {
  TreeModel model = chequered({255, 0, 255, 220});
  model.levels[0].max_cell_px = 5.0f;
  Progress quiet;
  set_level_switches(model, three_cameras(), quiet);
  EXPECT_EQ(model.levels[0].max_cell_px, 0.0f);
  EXPECT_GT(model.levels[1].max_cell_px, 0.0f);
}

TEST(LevelSwitch, MeasuresLevelsAtSizesThatShowTheirCellsAndNoErrorOfAnEmptyTree) {
  TreeModel model = toy::random_ball(22);
  Progress quiet;
  const std::vector<LevelError> errors = measure_level_errors(model, {}, {}, quiet);
  // Cubes of 2 to 32 px (half of two pixels a finest cell); level 4 from 2 px on, level 5 from 4 px
  EXPECT_EQ(errors.size(), 5u + 5u + 4u);
  EXPECT_DOUBLE_EQ(errors.front().cell_px, 0.25);
  EXPECT_EQ(errors.front().tree_px, 2);
  TreeModel empty;
  set_level_switches(empty, {}, quiet);
  EXPECT_TRUE(measure_level_errors(empty, {}, {}, quiet).empty());
}

TEST(LevelSwitch, StandsCamerasInsideTheTreeOrRightAboveIt) {
  TreeModel model = toy::random_ball(23);
  Camera inside = toy::look_at({0, 0, 1}, {0, 3, 1}, 500, 100, 100);
  Camera above = toy::look_at({0, 1e-9, 9}, {0, 0, 1}, 500, 100, 100);
  Progress quiet;
  for (const LevelError& error : measure_level_errors(model, {inside, above}, {}, quiet))
    EXPECT_TRUE(std::isfinite(error.psnr_db));
}

}  // namespace
}  // namespace bosk
