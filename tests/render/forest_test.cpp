#include "core/render/forest.h"

#include <gtest/gtest.h>

#include <random>

#include "core/base/error.h"
#include "tests/render/toy_trees.h"

namespace bosk {
namespace {

std::shared_ptr<const PreparedTree> prepared(const TreeModel& model) {
  return std::make_shared<const PreparedTree>(model);
}

std::vector<TreeInstance> random_instances(std::size_t count, double side_m, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> along(-0.5 * side_m, 0.5 * side_m);
  std::vector<TreeInstance> instances(count);
  for (TreeInstance& instance : instances) {
    instance.place = {along(random), along(random), 0.0};
    instance.turn = along(random);
    instance.scale = 0.5 + 0.01 * double(random() % 100);
  }
  return instances;
}

DrawOptions all_round() {
  DrawOptions options;
  options.half_angle = std::numbers::pi;
  return options;
}

ForestDrawList list_of(const Forest& forest, const Viewpoint& viewpoint, const DrawOptions& options,
                       std::uint64_t budget = 0) {
  ForestDrawList list;
  forest.draw_list(viewpoint, options, budget, list);
  return list;
}

TEST(TreeInstance, GoesToTheWorldAndBack) {
  const TreeInstance instance{0, {3, -2, 1}, 0.5 * std::numbers::pi, 2.0, glm::vec3(1)};
  const glm::dvec3 world = world_from_tree(instance, {1, 0, 1});
  EXPECT_NEAR(glm::distance(world, glm::dvec3(3, 0, 3)), 0.0, 1e-12);  // +x turned to +y, doubled
  EXPECT_NEAR(glm::distance(tree_from_world(instance, world), glm::dvec3(1, 0, 1)), 0.0, 1e-12);
}

TEST(Forest, DrawsAnInstanceAsItsTreeSeesTheEye) {
  const TreeModel model = toy::random_ball(21);
  const auto tree = prepared(model);
  const TreeInstance instance{0, {5, 7, 2}, 0.7, 1.5, glm::vec3(1)};
  const Forest forest({tree}, {instance});
  const Viewpoint viewpoint{{0, 0, 3}, glm::normalize(glm::dvec3(5, 7, 0)), 500};
  Viewpoint in_tree = viewpoint;
  in_tree.eye = tree_from_world(instance, viewpoint.eye);
  TreeInstance turn_alone;
  turn_alone.turn = instance.turn;
  in_tree.forward = tree_from_world(turn_alone, viewpoint.forward);
  EXPECT_EQ(list_of(forest, viewpoint, {}).ranges, make_draw_list(*tree, in_tree, {}));
}

// A disc as the eye, outside of it, sees it.
struct Disc {
  double distance = 0.0, radius = 0.0, angle = 0.0;
  double half() const { return std::asin(radius / distance); }
  // Where a line at an angle that meets the disc enters it.
  double entered_at(double direction) const {
    const double off = distance * std::sin(direction - angle);
    return distance * std::cos(direction - angle) - std::sqrt(radius * radius - off * off);
  }
};

Disc disc_seen(const TreeInstance& tree, const glm::dvec2& eye) {
  const glm::dvec2 away = glm::dvec2(tree.place) - eye;
  return {glm::length(away), tree.scale, std::atan2(away.y, away.x)};  // the toy's radius is 1
}

// Whether a line from the eye meets `front` before `back`; one of all that meet both tells, since
// the discs are apart.
bool hides(const Disc& front, Disc back) {
  back.angle = front.angle + std::remainder(back.angle - front.angle, 2.0 * std::numbers::pi);
  const double low = std::max(front.angle - front.half(), back.angle - back.half());
  const double high = std::min(front.angle + front.half(), back.angle + back.half());
  if (!(low < high)) return false;
  const double between = 0.5 * (low + high);
  return front.entered_at(between) < back.entered_at(between);
}

// Small and large crowns that do not meet, seen from between them.
TEST(Forest, DrawsFarTreesFirst) {
  const TreeModel model = toy::one_billboard();
  std::vector<TreeInstance> instances;
  for (const TreeInstance& instance : random_instances(2000, 120.0, 5)) {
    const bool apart = std::all_of(instances.begin(), instances.end(), [&](const auto& other) {
      return glm::distance(other.place, instance.place) > other.scale + instance.scale;
    });
    if (apart) instances.push_back(instance);
  }
  ASSERT_GT(instances.size(), 500u);
  const Forest forest({prepared(model)}, instances);
  std::mt19937 random(6);
  std::uniform_real_distribution<double> along(-70.0, 70.0);
  std::size_t hidden = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const glm::dvec2 eye(along(random), along(random));
    const auto inside = [&](const TreeInstance& tree) {
      return glm::distance(glm::dvec2(tree.place), eye) < tree.scale;
    };
    if (std::any_of(instances.begin(), instances.end(), inside)) continue;
    const ForestDrawList list = list_of(forest, {{eye, 1.7}, {0, 1, 0}, 100}, all_round());
    ASSERT_EQ(list.instances.size(), instances.size());
    std::vector<Disc> discs;
    for (const std::uint32_t i : list.instances) discs.push_back(disc_seen(instances[i], eye));
    for (std::size_t late = 0; late < discs.size(); ++late) {
      for (std::size_t early = 0; early < late; ++early) {
        ASSERT_FALSE(hides(discs[early], discs[late])) << "trial " << trial;
        hidden += hides(discs[late], discs[early]) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(hidden, 10000u);
}

TEST(Forest, LeavesOutTreesOutsideTheCone) {
  const TreeModel model = toy::random_ball(22);
  const Forest forest({prepared(model)}, random_instances(400, 200.0, 7));
  DrawOptions narrow;
  narrow.half_angle = 0.3;
  const Viewpoint viewpoint{{0, -150, 2}, {0, 1, 0}, 500};
  const ForestDrawList all = list_of(forest, viewpoint, all_round());
  const ForestDrawList seen = list_of(forest, viewpoint, narrow);
  EXPECT_EQ(all.instances.size(), 400u);
  for (const std::uint32_t i : all.instances) {
    const glm::dvec3 from_eye = forest.instances()[i].place - viewpoint.eye;
    const bool ahead = std::atan2(std::abs(from_eye.x), from_eye.y) < 0.3;
    const bool drawn = std::count(seen.instances.begin(), seen.instances.end(), i) == 1;
    if (ahead) {
      EXPECT_TRUE(drawn) << i;
    }
  }
  EXPECT_LT(seen.instances.size(), 250u);
}

TEST(Forest, KeepsToItsBudgetByLoweringDetail) {
  TreeModel model = toy::random_ball(23);
  model.levels[0].max_cell_px = model.levels[1].max_cell_px = 2.0f;
  const Forest forest({prepared(model)}, random_instances(200, 400.0, 8));
  const Viewpoint viewpoint{{0, -300, 2}, {0, 1, 0}, 2000};
  const ForestDrawList free = list_of(forest, viewpoint, all_round());
  EXPECT_EQ(free.detail, 1.0);
  const std::uint64_t least = list_of(forest, viewpoint, all_round(), 1).billboards;
  ASSERT_LT(least, free.billboards / 3);  // all at the coarsest level
  std::uint64_t last = free.billboards;
  for (const double share : {0.5, 0.25}) {
    const auto budget = std::uint64_t(share * double(free.billboards));
    const ForestDrawList list = list_of(forest, viewpoint, all_round(), budget);
    EXPECT_LE(double(list.billboards), std::max(1.1 * double(budget), double(least)));
    EXPECT_GT(double(list.billboards), 0.5 * double(budget));
    EXPECT_LT(list.billboards, last);
    EXPECT_LT(list.detail, 1.0);
    last = list.billboards;
  }
  EXPECT_EQ(list_of(forest, viewpoint, all_round(), free.billboards * 2).detail, 1.0);
  // Fewer than the coarsest levels have: drawn at these, not left out
  EXPECT_EQ(list_of(forest, viewpoint, all_round(), 1).instances.size(), 200u);
}

TEST(Forest, CountsBillboardsByLevel) {
  TreeModel model = toy::random_ball(24);
  const Forest forest({prepared(model)}, random_instances(50, 100.0, 9));
  const ForestDrawList list = list_of(forest, {{0, -300, 2}, {0, 1, 0}, 500}, all_round());
  ASSERT_EQ(list.by_level.size(), 6u);
  EXPECT_EQ(list.by_level[5], list.billboards);  // no level but the finest may be drawn
  EXPECT_EQ(list.billboards, 50u * model.levels[2].cells.size());
}

TEST(Forest, TakesNoTreesOneTreeAndManyInOnePlace) {
  const TreeModel model = toy::one_billboard();
  EXPECT_TRUE(list_of(Forest({}, {}), {}, {}).ranges.empty());
  EXPECT_TRUE(list_of(Forest({prepared(model)}, {}), {}, {}).ranges.empty());
  const Viewpoint viewpoint{{0, -20, 1}, {0, 1, 0}, 100};
  EXPECT_EQ(list_of(Forest({prepared(model)}, {TreeInstance{}}), viewpoint, {}).billboards, 1u);
  const Forest heap({prepared(model)}, std::vector<TreeInstance>(1000));
  EXPECT_EQ(list_of(heap, viewpoint, {}).billboards, 1000u);
}

TEST(Forest, RefusesUnknownKindsAndImpossibleScales) {
  const TreeModel model = toy::one_billboard();
  TreeInstance unknown, flat, nowhere;
  unknown.tree = 1;
  flat.scale = 0.0;
  nowhere.place.x = std::numeric_limits<double>::quiet_NaN();
  for (const TreeInstance& instance : {unknown, flat, nowhere})
    EXPECT_THROW(Forest({prepared(model)}, {instance}), Error);
}

}  // namespace
}  // namespace bosk
