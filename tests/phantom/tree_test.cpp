#include "core/phantom/tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace bosk {
namespace {

TreeShape small_shape(const std::string& preset) { return tree_shape(preset, 0.03, 3.0); }

TEST(Skeleton, PutsParentsBeforeChildren) {
  Progress progress;
  const auto nodes = grow_skeleton(small_shape("dense"), 1, progress);
  ASSERT_GT(nodes.size(), 100u);
  EXPECT_EQ(nodes[0].parent, -1);
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    EXPECT_GE(nodes[i].parent, 0);
    EXPECT_LT(nodes[i].parent, int(i));
  }
}

TEST(Skeleton, KeepsThePipeModelAtEveryFork) {
  Progress progress;
  TreeShape shape = small_shape("sparse");
  shape.trunk_flare = 0.0;
  const auto nodes = grow_skeleton(shape, 4, progress);
  std::vector<double> pipes(nodes.size(), 0.0);
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    pipes[std::size_t(nodes[i].parent)] += std::pow(nodes[i].radius, shape.pipe_exponent);
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double own = std::pow(nodes[i].radius, shape.pipe_exponent);
    const double tip = std::pow(shape.twig_radius, shape.pipe_exponent);
    EXPECT_NEAR(own / (pipes[i] > 0.0 ? pipes[i] : tip), 1.0, 1e-9);  // rounding of two powers
  }
}

TEST(Skeleton, StaysNearItsEnvelope) {
  Progress progress;
  for (const char* preset : {"dense", "sparse", "conical"}) {
    const TreeShape shape = small_shape(preset);
    const double widest =
        *std::max_element(shape.radius_profile.begin(), shape.radius_profile.end());
    // Lumps push the envelope out by at most 2 x 0.3 x lumps; a branch may overshoot by a step.
    const double reach = widest * (1.0 + 0.6 * shape.envelope_lumps) + 2.0 * shape.step;
    for (const SkeletonNode& node : grow_skeleton(shape, 2, progress)) {
      EXPECT_LT(std::hypot(node.position.x, node.position.y), reach) << preset;
      EXPECT_LT(node.position.z, shape.height + 2.0 * shape.step) << preset;
      EXPECT_GT(node.position.z, -1e-9) << preset;
    }
  }
}

TEST(TreeShape, RefusesAnUnknownPreset) { EXPECT_THROW(tree_shape("palm", 1.0, 0.0), Error); }

TEST(GrowTree, GivesTheSameTreeForASeedAndAnotherForAnother) {
  Progress progress;
  const TreeShape shape = small_shape("dense");
  const Tree first = grow_tree(shape, 1, progress), again = grow_tree(shape, 1, progress);
  EXPECT_EQ(first.vertices, again.vertices);
  EXPECT_EQ(first.triangles, again.triangles);
  EXPECT_NE(first.vertices, grow_tree(shape, 2, progress).vertices);
}

TEST(GrowTree, MakesLeavesOfWholeFacets) {
  Progress progress;
  for (const char* preset : {"dense", "sparse", "conical"}) {
    const Tree tree = grow_tree(small_shape(preset), 3, progress);
    const std::size_t leaf_triangles = tree.triangles.size() - tree.wood_triangles;
    EXPECT_GT(leaf_triangles, 0u) << preset;
    EXPECT_EQ(leaf_triangles % (tree.triangles_per_facet * tree.facets_per_leaf), 0u) << preset;
    EXPECT_EQ(tree.vertex_anchors.size(), tree.vertices.size()) << preset;
    EXPECT_EQ(tree.wood_normals.size(), tree.wood_vertices) << preset;
  }
}

TEST(GrowTree, TurnsTubesAndBladesOneWayRound) {
  Progress progress;
  const Tree tree = grow_tree(small_shape("dense"), 3, progress);
  std::size_t outwards = 0;
  for (std::size_t i = 0; i < tree.wood_triangles; ++i) {
    const glm::uvec3 t = tree.triangles[i];
    const glm::vec3 mean = tree.wood_normals[t.x] + tree.wood_normals[t.y] + tree.wood_normals[t.z];
    outwards += glm::dot(tree.normal(i), mean) > 0.0f ? 1u : 0u;
  }
  // A few triangles turn over where a thick tube bends sharply.
  EXPECT_GT(double(outwards) / double(tree.wood_triangles), 0.98);
  for (std::size_t i = tree.wood_triangles; i < tree.triangles.size(); i += 12) {
    // Both halves of a folded leaf face the same side.
    EXPECT_GT(glm::dot(tree.normal(i + 2), tree.normal(i + 8)), 0.0f);
  }
}

TEST(WindBlown, HoldsTheFootAndMovesTheTopByAboutTheAmplitude) {
  Progress progress;
  const Tree tree = grow_tree(small_shape("dense"), 3, progress);
  const double amplitude = 0.2;
  const auto moved = wind_blown(tree, amplitude, 5);
  double most = 0.0;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const double distance = glm::distance(moved[i], tree.vertices[i]);
    most = std::max(most, distance);
    if (tree.vertex_anchors[i].z < 0.05f * float(tree.shape.height)) {
      EXPECT_LT(distance, 0.1 * amplitude);
    }
  }
  EXPECT_GT(most, 0.2 * amplitude);
  EXPECT_LT(most, 2.5 * amplitude);  // 1.2 (reach) times a lean below 1.5 and a wave below 0.8
  EXPECT_EQ(wind_blown(tree, 0.0, 5), tree.vertices);
}

}  // namespace
}  // namespace bosk
