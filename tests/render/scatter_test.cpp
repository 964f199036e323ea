#include "core/render/scatter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/render/positions_csv.h"
#include "tests/render/toy_trees.h"

namespace bosk {
namespace {

using testing::HasSubstr;

const std::vector<double> kCrowns = {2.0, 5.0};

// Smallest distance between two trunks over the sum of their crowns' radii, by plain loops over
// trees sorted by x.
double closest(std::vector<TreeInstance> trees, const std::vector<double>& crowns) {
  std::sort(trees.begin(), trees.end(),
            [](const TreeInstance& a, const TreeInstance& b) { return a.place.x < b.place.x; });
  double least = INFINITY;
  for (std::size_t i = 0; i < trees.size(); ++i) {
    for (std::size_t j = i + 1; j < trees.size(); ++j) {
      if (trees[j].place.x - trees[i].place.x > 40.0) break;
      const double radii =
          trees[i].scale * crowns[trees[i].tree] + trees[j].scale * crowns[trees[j].tree];
      least = std::min(least, glm::distance(trees[i].place, trees[j].place) / radii);
    }
  }
  return least;
}

double widest(const std::vector<TreeInstance>& trees) {
  double width = 0.0;
  for (const TreeInstance& tree : trees) {
    width = std::max({width, std::abs(tree.place.x), std::abs(tree.place.y)});
  }
  return 2.0 * width;
}

TEST(ScatterTrees, KeepsCrownsApartAndUsesEveryKindScaleAndTurn) {
  ScatterOptions options;
  options.trees = 2000;
  const auto trees = scatter_trees(kCrowns, {}, options);
  ASSERT_EQ(trees.size(), 2000u);
  EXPECT_GE(closest(trees, kCrowns), 1.0 - 1e-9);  // rounding
  int small = 0;
  double turns = 0.0;
  for (const TreeInstance& tree : trees) {
    EXPECT_GE(tree.scale, 0.8);
    EXPECT_LE(tree.scale, 1.2);
    EXPECT_EQ(tree.place.z, 0.0);
    EXPECT_NEAR(tree.tint.g, 1.0, 0.0601);
    small += tree.tree == 0 ? 1 : 0;
    turns += tree.turn / 2000.0;
  }
  EXPECT_GT(small, 900);  // small crowns find gaps more easily
  EXPECT_LT(small, 1800);
  EXPECT_NEAR(turns, 3.14, 0.2);  // 5 standard deviations of the mean
}

TEST(ScatterTrees, SpacingIsInSumsOfCrownRadii) {
  ScatterOptions options;
  options.trees = 300;
  for (const double spacing : {0.5, 2.0}) {
    options.spacing = spacing;
    const double least = closest(scatter_trees(kCrowns, {}, options), kCrowns);
    EXPECT_GE(least, spacing - 1e-9);
    EXPECT_LT(least, 1.1 * spacing);  // packed: some pair nearly touches
  }
}

TEST(ScatterTrees, SpreadsFewTreesAllOverAGivenArea) {
  ScatterOptions options;
  options.trees = 200;
  options.area_m = 1000.0;
  const auto trees = scatter_trees(kCrowns, {}, options);
  ASSERT_EQ(trees.size(), 200u);
  int quadrants[4] = {};
  for (const TreeInstance& tree : trees) {
    ++quadrants[(tree.place.x > 0.0 ? 1 : 0) + (tree.place.y > 0.0 ? 2 : 0)];
  }
  for (const int count : quadrants) EXPECT_NEAR(count, 50, 20);
  EXPECT_LE(widest(trees), 1000.0);
  EXPECT_GT(closest(trees, kCrowns), 1.5);  // far more room than the crowns ask for
}

TEST(ScatterTrees, TellsHowManyFitIntoAnAreaThatIsTooSmall) {
  ScatterOptions options;
  options.trees = 1000;
  options.area_m = 50.0;
  try {
    scatter_trees(kCrowns, {}, options);
    FAIL() << "took 1000 trees";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("of 1000 trees fit into the area: give more area_m"));
  }
}

TEST(ScatterTrees, GivesTheSameForASeedAndAnotherForAnother) {
  ScatterOptions options;
  options.trees = 50;
  const auto once = scatter_trees(kCrowns, {}, options);
  const auto again = scatter_trees(kCrowns, {}, options);
  options.seed = 2;
  const auto other = scatter_trees(kCrowns, {}, options);
  ASSERT_EQ(once.size(), again.size());
  for (std::size_t i = 0; i < once.size(); ++i) {
    EXPECT_EQ(once[i].place, again[i].place);
    EXPECT_EQ(once[i].turn, again[i].turn);
  }
  EXPECT_NE(once[10].place, other[10].place);
}

TEST(ScatterTrees, TakesOneAndAHundredThousand) {
  ScatterOptions options;
  options.trees = 1;
  EXPECT_EQ(scatter_trees(kCrowns, {}, options).size(), 1u);
  options.trees = 100000;
  const auto many = scatter_trees(kCrowns, {}, options);
  EXPECT_EQ(many.size(), 100000u);
  EXPECT_GE(closest(many, kCrowns), 1.0 - 1e-9);
}

TEST(ScatterTrees, TakesTreesWithoutACrown) {
  ScatterOptions options;
  options.trees = 20;
  EXPECT_EQ(scatter_trees(std::vector<double>{0.0}, {}, options).size(), 20u);
}

// West half 0.25, east half 0.75; the northern third black.
Image<float> two_fields() {
  Image<float> density(60, 60, 0.25f);
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 60; ++x) {
      if (x >= 30) density(x, y) = 0.75f;
      if (y < 20) density(x, y) = 0.0f;
    }
  }
  return density;
}

TEST(ScatterTrees, DensityIsTheShareOfTreesThatStay) {
  ScatterOptions options;
  options.trees = 4000;
  const auto trees = scatter_trees(kCrowns, two_fields(), options);
  ASSERT_EQ(trees.size(), 4000u);
  EXPECT_GE(closest(trees, kCrowns), 1.0 - 1e-9);
  const double width = widest(trees);
  int east = 0;
  for (const TreeInstance& tree : trees) {
    EXPECT_LT(tree.place.y, width / 6.0 + 1.0);  // the top row is north, black and clear
    east += tree.place.x > 0.0 ? 1 : 0;
  }
  EXPECT_NEAR(east / 4000.0, 0.75, 0.03);  // 4 standard deviations of a random share
}

TEST(ScatterTrees, RefusesADensityThatLeavesNoRoom) {
  ScatterOptions options;
  options.trees = 10;
  EXPECT_THROW(scatter_trees(kCrowns, Image<float>(8, 8, 0.0f), options), Error);
  Image<float> nearly(4000, 4000, 0.0f);
  nearly(7, 7) = 1.0f;
  EXPECT_THROW(scatter_trees(kCrowns, nearly, options), Error);
}

TEST(LineUp, PutsOneTreeAtTheOriginAndSeveralApart) {
  EXPECT_EQ(line_up(std::vector<double>{3.0}).at(0).place, glm::dvec3(0.0));
  const auto row = line_up(kCrowns);
  ASSERT_EQ(row.size(), 2u);
  EXPECT_EQ(row[1].tree, 1u);
  EXPECT_GT(row[1].place.x - row[0].place.x, 7.0);
}

TEST(CrownRadius, IsThatOfABallOfCells) {
  EXPECT_NEAR(crown_radius(toy::random_ball(3)), 0.83, 0.06);  // ball of 0.9: nearly all inside
  EXPECT_EQ(crown_radius(TreeModel{}), 0.0);
}

TEST(Terrain, IsFlatOrWithinItsReliefAndSmooth) {
  EXPECT_EQ(height_at({}, 3.0, 4.0), 0.0);
  const Terrain hills{10.0, 50.0, 3};
  double lowest = INFINITY, highest = -INFINITY;
  for (double x = -500.0; x < 500.0; x += 7.3) {
    const double height = height_at(hills, x, 0.7 * x), next = height_at(hills, x + 0.01, 0.7 * x);
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
    EXPECT_LT(std::abs(next - height), 0.02);  // slopes stay below 2
  }
  EXPECT_LT(highest, 5.0);
  EXPECT_GT(lowest, -5.0);
  EXPECT_GT(highest - lowest, 3.0);
  const glm::dvec3 up = normal_at(hills, 12.0, 5.0);
  EXPECT_NEAR(glm::length(up), 1.0, 1e-12);
  EXPECT_NEAR(-up.x / up.z, (height_at(hills, 12.1, 5.0) - height_at(hills, 11.9, 5.0)) / 0.2,
              0.01);
}

TEST(Terrain, PlaneThroughPointsIsTheirs) {
  const auto on_plane = [](double x, double y) {
    return glm::dvec3(x, y, 400.0 + 0.1 * x - 0.2 * y);
  };
  const std::vector<glm::dvec3> points = {on_plane(100, 200), on_plane(130, 210), on_plane(90, 260),
                                          on_plane(150, 280)};
  const Terrain plane = plane_through(points);
  for (const glm::dvec3& point : points) {
    EXPECT_NEAR(height_at(plane, point.x, point.y), point.z, 1e-5);
  }
  EXPECT_NEAR(plane.slope.x, 0.1, 1e-6);
  EXPECT_NEAR(normal_at(plane, 0.0, 0.0).z, 1.0 / std::sqrt(1.05), 1e-6);
}

TEST(Terrain, PlaneThroughFewPointsIsLevelAcrossThem) {
  EXPECT_EQ(height_at(plane_through({}), 5.0, 5.0), 0.0);
  const std::vector<glm::dvec3> one = {{3.0, 4.0, 50.0}};
  EXPECT_NEAR(height_at(plane_through(one), 30.0, 4.0), 50.0, 1e-9);
  const std::vector<glm::dvec3> line = {{0.0, 0.0, 0.0}, {10.0, 0.0, 1.0}, {20.0, 0.0, 2.0}};
  EXPECT_NEAR(height_at(plane_through(line), 10.0, 0.0), 1.0, 1e-6);
  EXPECT_NEAR(height_at(plane_through(line), 10.0, 70.0), 1.0, 1e-3);
}

TEST(StandOn, PutsTrunksOnTheGround) {
  const Terrain hills{10.0, 50.0, 3};
  std::vector<TreeInstance> trees(1);
  trees[0].place = {17.0, -4.0, 99.0};
  stand_on(hills, trees);
  EXPECT_EQ(trees[0].place.z, height_at(hills, 17.0, -4.0));
}

// --- positions from a table ---

const std::vector<std::string> kNames = {"oak", "spruce"};
const Terrain kHills{10.0, 50.0, 3};

std::vector<TreeInstance> parsed(const std::string& text) {
  return parse_positions(text, "places.csv", kNames, kHills);
}

TEST(Positions, ReadAllColumnsInAnyOrderAndPassOverOthers) {
  const auto trees = parsed(
      "\xef\xbb\xbftree,y,x,note,turn_deg,scale,z\r\n"
      "# a comment\r\n"
      "spruce, 2.5, 1e1, \"by the gate, \"\"old\"\"\", 90, 0.5, 3\r\n"
      "\r\n"
      "1,+4,-5,,,,\r\n");
  ASSERT_EQ(trees.size(), 2u);
  EXPECT_EQ(trees[0].tree, 1u);
  EXPECT_EQ(trees[0].place, glm::dvec3(10.0, 2.5, 3.0));
  EXPECT_NEAR(trees[0].turn, 1.5707963, 1e-6);
  EXPECT_EQ(trees[0].scale, 0.5);
  EXPECT_EQ(trees[1].tree, 0u);
  EXPECT_EQ(trees[1].scale, 1.0);
  EXPECT_EQ(trees[1].place, glm::dvec3(-5.0, 4.0, height_at(kHills, -5.0, 4.0)));
}

TEST(Positions, TakeAHundredThousandLines) {
  std::string text = "x,y\n";
  for (int i = 0; i < 100000; ++i) text += std::to_string(i) + ".5," + std::to_string(-i) + "\n";
  const auto trees = parsed(text);
  ASSERT_EQ(trees.size(), 100000u);
  EXPECT_EQ(trees.back().place.x, 99999.5);
}

TEST(Positions, RefuseBrokenTablesByLineAndRemedy) {
  const std::pair<std::string, std::string> broken[] = {
      {"", "places.csv: holds no tree"},
      {"x,y\n", "places.csv: holds no tree"},
      {"1,2\n3,4\n", "places.csv, line 1: no columns x and y"},
      {"x,z\n1,2\n", "places.csv, line 1: no columns x and y"},
      {"x,y,x\n1,2,3\n", "line 1: two columns are named x"},
      {"x,y\n1,2\n\n3\n", "line 4: has 1 fields where the first line names 2 columns"},
      {"x,y\n1,2,3\n", "line 2: has 3 fields"},
      {"x,y\n1,two\n", "line 2: y is \"two\": give a number"},
      {"x,y\n1;2\n", "line 2: has 1 fields"},
      {"x,y\n1,\n", "line 2: y is empty"},
      {"x,y\n1,nan\n", "line 2: y is \"nan\""},
      {"x,y\n1,2e99\n", "subtract a common offset"},
      {"x,y,scale\n1,2,0\n", "line 2: scale is 0: give a number from 0.001"},
      {"x,y,tree\n1,2,3\n",
       "line 2: tree is \"3\": give a number from 1 to 2, or one of oak, spruce"},
      {"x,y,tree\n1,2,ash\n", "line 2: tree is \"ash\""},
      {"x,y,note\n1,2,\"open\n", "line 2: a double quote is not closed"},
  };
  for (const auto& [text, message] : broken) {
    try {
      parsed(text);
      ADD_FAILURE() << "took " << text;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr(message));
    }
  }
}

TEST(Positions, NameAFileThatIsMissing) {
  try {
    read_positions("/nowhere/places.csv", kNames, {});
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("/nowhere/places.csv"));
  }
}

}  // namespace
}  // namespace bosk
