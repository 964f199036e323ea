#include "core/render/draw_list.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "core/geometry/box.h"
#include "tests/render/toy_trees.h"

namespace bosk {
namespace {

DrawOptions everything() {
  DrawOptions options;
  options.half_angle = std::numbers::pi;
  return options;
}

// Back to front, as a renderer without a GPU draws it.
std::vector<DrawItem> list_of(const TreeModel& model, const Viewpoint& viewpoint,
                              const DrawOptions& options) {
  const PreparedTree tree(model);
  return draw_items(tree, make_draw_list(tree, viewpoint, options), viewpoint.eye,
                    BlendRule::fading);
}

// Levels replace each other at once, so that each cell is drawn once.
DrawOptions at_once() {
  DrawOptions options = everything();
  options.dissolve = 1.0;
  return options;
}

Box cell_box(const TreeModel& model, const DrawItem& item) {
  const TreeLevel& level = model.levels[item.level_slot];
  const glm::dvec3 centre = cell_centre_in_world(model, level.level, level.cells[item.cell]);
  const double half = 0.5 * cell_size_m(model, level.level);
  return {centre - half, centre + half};
}

// Number of drawn cells that hold each finest cell.
std::vector<int> times_drawn(const TreeModel& model, const std::vector<DrawItem>& list) {
  const TreeLevel& finest = model.levels.back();
  std::vector<int> times(finest.cells.size(), 0);
  for (const DrawItem& item : list) {
    const TreeLevel& level = model.levels[item.level_slot];
    const int shift = 3 * (finest.level - level.level);
    for (std::size_t i = 0; i < finest.cells.size(); ++i)
      times[i] += (finest.cells[i] >> shift) == level.cells[item.cell];
  }
  return times;
}

TEST(Morton, UndoesTheInterleavingOfBits) {
  std::mt19937 random(1);
  for (int i = 0; i < 1000; ++i) {
    const glm::uvec3 cell(random() >> 11, random() >> 11, random() >> 11);
    ASSERT_EQ(cell_from_morton(toy::morton(cell)), cell);
  }
}

TEST(BillboardAxes, FollowTheContractAlsoStraightUpAndDown) {
  const BillboardAxes level = billboard_axes({0, 5, 1}, {0, 0, 1});  // looking along +y
  EXPECT_NEAR(glm::distance(level.right, glm::dvec3(1, 0, 0)), 0.0, 1e-12);
  EXPECT_NEAR(glm::distance(level.up, glm::dvec3(0, 0, 1)), 0.0, 1e-12);
  const BillboardAxes down = billboard_axes({0, 0, 0}, {0, 0, 7});
  EXPECT_EQ(down.right, glm::dvec3(1, 0, 0));
  EXPECT_EQ(down.up, glm::dvec3(0, 1, 0));
  const BillboardAxes tilted = billboard_axes({1, 2, 3}, {-4, 1, 9});
  const glm::dvec3 forward = glm::normalize(glm::dvec3(5, 1, -6));
  EXPECT_NEAR(glm::length(tilted.right), 1.0, 1e-12);
  EXPECT_NEAR(glm::distance(tilted.right, glm::normalize(glm::cross(forward, {0, 0, 1}))), 0,
              1e-12);
  EXPECT_NEAR(glm::distance(tilted.up, glm::cross(tilted.right, forward)), 0, 1e-12);
}

// Whether a ray from the eye may meet `front` before `back`: along no axis in which the two lie
// apart is the eye on the side of `back`.
bool may_hide(const Box& front, const Box& back, const glm::dvec3& eye) {
  for (int axis = 0; axis < 3; ++axis) {
    if (back.upper[axis] <= front.lower[axis] && eye[axis] <= front.lower[axis]) return false;
    if (back.lower[axis] >= front.upper[axis] && eye[axis] >= front.upper[axis]) return false;
  }
  return true;
}

glm::dvec3 random_eye(std::mt19937& random, int trial) {
  std::normal_distribution<double> normal;
  const double reach = trial % 3 == 0 ? 3.0 : 0.5;
  glm::dvec3 eye(normal(random), normal(random), normal(random));
  eye = glm::dvec3(0, 0, 1) + reach * eye;
  if (trial % 5 == 0) eye = glm::round(eye * 16.0) / 16.0;  // in the planes between cells
  return eye;
}

// The slow truth: every pair of cells, parted by the planes between them.
TEST(DrawList, DrawsFarCellsFirstFromTenThousandEyes) {
  TreeModel model = toy::sparse_ball(3);
  model.levels[0].max_cell_px = 20;
  model.levels[1].max_cell_px = 30;
  const PreparedTree tree(model);
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  std::size_t hidden = 0;
  for (int trial = 0; trial < 10000; ++trial) {
    Viewpoint viewpoint;
    viewpoint.eye = random_eye(random, trial);
    viewpoint.forward = glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
    viewpoint.focal_px = 300;
    const std::vector<DrawRange> ranges = make_draw_list(tree, viewpoint, at_once());
    std::vector<Box> boxes;
    for (const DrawItem& item : draw_items(tree, ranges, viewpoint.eye, BlendRule::fading))
      boxes.push_back(cell_box(model, item));
    for (std::size_t late = 0; late < boxes.size(); ++late) {
      for (std::size_t early = 0; early < late; ++early) {
        ASSERT_FALSE(may_hide(boxes[early], boxes[late], viewpoint.eye)) << "trial " << trial;
        hidden += may_hide(boxes[late], boxes[early], viewpoint.eye) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(hidden, 1000000u);
}

TEST(DrawList, NeedsNoMoreThanAHandfulOfRangesFromAfar) {
  TreeModel model = toy::random_ball(12);
  const PreparedTree tree(model);
  const auto ranges = [&](const glm::dvec3& eye) {
    return make_draw_list(tree, {eye, glm::normalize(glm::dvec3(0, 0, 1) - eye), 100}, everything())
        .size();
  };
  EXPECT_EQ(ranges({30, 40, 50}), 1u);  // beyond all planes: one order of octants
  EXPECT_LE(ranges({30, 40, 1.0}),
            12u);  // level with the crown: its nodes at that height in halves
}

TEST(DrawList, DissolvesEachLevelIntoTheNext) {
  TreeModel model = toy::random_ball(13);
  model.levels[0].max_cell_px = model.levels[1].max_cell_px = 6.0f;
  const PreparedTree tree(model);
  DrawOptions options = everything();
  options.dissolve = 1.5;
  const double cell_m = cell_size_m(model, 4);
  const double whole_m = 100.0 * cell_m / 6.0;  // depth at which level 4 stands alone
  double last_fade = 1.0;
  for (const double nearer : {1.0, 0.9, 0.8, 0.7}) {
    // A tree so far off, drawn so much larger, that all of it lies at one depth
    const double far = 1000.0, focal_px = 100.0 * far / (whole_m * nearer);
    const auto ranges = make_draw_list(tree, {{0, -far, 1}, {0, 1, 0}, focal_px}, options);
    double coarse = 0.0, fine = 0.0;
    for (const DrawRange& range : ranges) {
      (range.cut == 1 ? coarse : fine) = range.fade;
      EXPECT_NE(range.cut, 0);
    }
    if (nearer == 1.0) {
      EXPECT_LT(fine, 1e-4);  // the near side of the tree, a thousandth nearer
    } else {
      EXPECT_NEAR(coarse + fine, 1.0, 1e-6);
      EXPECT_LT(coarse, last_fade);
    }
    last_fade = coarse;
  }
}

TEST(DrawList, CoversEveryFinestCellOnceAtEveryMixOfLevels) {
  TreeModel model = toy::fine_ball(5);
  std::set<std::size_t> mixes;
  for (const float limit : {0.0f, 1.8f, 2.4f, 3.5f, 1000.0f}) {
    model.levels[0].max_cell_px = limit;
    model.levels[1].max_cell_px = 0.6f * limit;
    Viewpoint viewpoint{{0.3, -3.0, 1.2}, {0, 1, 0}, 120.0};
    const std::vector<DrawItem> list = list_of(model, viewpoint, at_once());
    const std::vector<int> times = times_drawn(model, list);
    EXPECT_TRUE(std::all_of(times.begin(), times.end(), [](int n) { return n == 1; }));
    std::set<std::uint32_t> slots;
    for (const DrawItem& item : list) slots.insert(item.level_slot);
    mixes.insert(slots.size());
  }
  EXPECT_EQ(mixes, (std::set<std::size_t>{1, 2, 3}));  // the limits above do mix levels
}

TEST(DrawList, CoversEveryFinestCellWhenLevelsLackCellsOrAreSkipped) {
  TreeModel model = toy::random_ball(6);
  std::mt19937 random(6);
  for (std::size_t slot = 0; slot < 2; ++slot) {
    std::vector<std::uint64_t> kept;
    for (const std::uint64_t cell : model.levels[slot].cells)
      if (random() % 2) kept.push_back(cell);
    model.levels[slot] = toy::make_level(model.levels[slot].level, 4, 1.3f, kept, 8,
                                         [](auto...) { return std::uint16_t(1); });
    model.levels[slot].max_cell_px = 1000;
  }
  const Viewpoint viewpoint{{0.3, -3.0, 1.2}, {0, 1, 0}, 120.0};
  for (int skipped = 0; skipped < 2; ++skipped) {
    if (skipped) model.levels.erase(model.levels.begin() + 1);  // a level between is absent
    const std::vector<int> times = times_drawn(model, list_of(model, viewpoint, at_once()));
    EXPECT_TRUE(std::all_of(times.begin(), times.end(), [](int n) { return n == 1; }));
  }
}

TEST(DrawList, DrawsACoarseCellThatHasNothingFinerBelow) {
  TreeModel model = toy::random_ball(7);
  for (std::size_t slot = 1; slot < 3; ++slot)
    model.levels[slot] = toy::make_level(model.levels[slot].level, 4, 1.3f, {}, 8,
                                         [](auto...) { return std::uint16_t(1); });
  const std::vector<DrawItem> list = list_of(model, {{0, -3, 1}, {0, 1, 0}, 120.0}, everything());
  EXPECT_EQ(list.size(), model.levels[0].cells.size());
}

TEST(DrawList, RefinesUntilTheCellsAreSmallEnoughOnScreen) {
  TreeModel model = toy::fine_ball(8);
  model.levels[0].max_cell_px = model.levels[1].max_cell_px = 6.0f;
  const Viewpoint viewpoint{{0, -4, 1}, {0, 1, 0}, 100.0};
  for (const DrawItem& item : list_of(model, viewpoint, everything())) {
    const glm::dvec3 centre = cell_box(model, item).centre();
    const double px =
        100.0 * cell_size_m(model, model.levels[item.level_slot].level) / (centre.y + 4);
    if (item.level_slot < 2) {
      EXPECT_LE(px, 6.0);
    }
    if (item.level_slot > 0) {
      EXPECT_GT(px * 2.0, 6.0 * 0.9);  // its parent, up to their depths' ratio
    }
  }
}

TEST(DrawList, DrawsOneLevelAloneWhenAsked) {
  const TreeModel model = toy::random_ball(9);
  DrawOptions options = everything();
  options.only_level = 4;
  const std::vector<DrawItem> list = list_of(model, {{0, -4, 1}, {0, 1, 0}, 1e6}, options);
  EXPECT_EQ(list.size(), model.levels[1].cells.size());
  for (const DrawItem& item : list) ASSERT_EQ(item.level_slot, 1u);
  options.only_level = 9;
  EXPECT_TRUE(list_of(model, {{0, -4, 1}, {0, 1, 0}, 1e6}, options).empty());
}

TEST(DrawList, LeavesOutOnlyWhatLiesBehindTheEye) {
  const TreeModel model = toy::random_ball_of(10, 4, 2, 7, 8);
  const Viewpoint viewpoint{{0.1, 0.05, 1.0}, {0, 1, 0}, 300.0};
  const std::vector<DrawItem> all = list_of(model, viewpoint, everything());
  const std::vector<DrawItem> ahead = list_of(model, viewpoint, DrawOptions{});
  EXPECT_LT(ahead.size(), all.size() * 3 / 4);
  std::size_t in_front = 0, kept = 0;
  for (const DrawItem& item : all) in_front += cell_box(model, item).centre().y > 0.05;
  for (const DrawItem& item : ahead) kept += cell_box(model, item).centre().y > 0.05;
  EXPECT_EQ(kept, in_front);
}

TEST(DrawList, LeavesOutTheCellThatHoldsTheEye) {
  const TreeModel model = toy::one_billboard();
  EXPECT_TRUE(list_of(model, {{0, -0.99, 1}, {0, 1, 0}, 100}, everything()).empty());
  EXPECT_EQ(list_of(model, {{0, -1.01, 1}, {0, 1, 0}, 100}, everything()).size(), 1u);
  EXPECT_TRUE(list_of(model, {{0, 0, 1}, {0, 1, 0}, 100}, everything()).empty());
}

TEST(DrawList, IsEmptyForATreeWithoutLevelsCellsOrViews) {
  TreeModel model;
  EXPECT_TRUE(list_of(model, {{0, -4, 1}, {0, 1, 0}, 100}, everything()).empty());
  model.levels.resize(1);
  EXPECT_TRUE(list_of(model, {{0, -4, 1}, {0, 1, 0}, 100}, everything()).empty());
  model.levels[0].cells = {0};
  EXPECT_TRUE(list_of(model, {{0, -4, 1}, {0, 1, 0}, 100}, everything()).empty());
}

TEST(DrawList, SkipsPrunedBillboardsAndLetsTheVisibleViewStandAlone) {
  TreeModel model = toy::one_billboard();
  model.view_positions = toy::ring(4, 10, 1);  // at 0, 90, 180 and 270 degrees
  for (int pruned = 0; pruned < 4; ++pruned) {
    model.levels = {toy::make_level(0, 4, 1.0f, {0}, 4, [&](std::size_t, std::uint32_t view, int) {
      return (pruned >> view) & 1 ? kPruned : std::uint16_t(0);
    })};
    // Between view 0 and view 1, nearer to view 0
    const std::vector<DrawItem> list = list_of(model, {{9, 5, 1}, {-1, 0, 0}, 100}, everything());
    if (pruned == 3) {
      EXPECT_TRUE(list.empty());
      continue;
    }
    ASSERT_EQ(list.size(), 1u);
    if (pruned == 0) {
      EXPECT_GT(list[0].weight_b, 0.1f);
      continue;
    }
    EXPECT_EQ(list[0].weight_b, 0.0f);
    EXPECT_EQ(list[0].view_a, pruned == 1 ? 1u : 0u);
  }
}

TEST(DrawList, CountsAViewAsPrunedOnlyWhenAllItsBlocksAre) {
  const TreeLevel level =
      toy::make_level(0, 8, 1.0f, {0, 1}, 2, [](std::size_t cell, std::uint32_t view, int block) {
        return cell == 1 && (view == 1 || block < 3) ? kPruned : std::uint16_t(0);
      });
  EXPECT_FALSE(is_pruned(level, 0, 0));
  EXPECT_FALSE(is_pruned(level, 0, 1));
  EXPECT_FALSE(is_pruned(level, 1, 0));
  EXPECT_TRUE(is_pruned(level, 1, 1));
}

}  // namespace
}  // namespace bosk
