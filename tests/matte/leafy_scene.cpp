#include "leafy_scene.h"

#include <algorithm>
#include <cmath>

#include "core/image/colour.h"

namespace bosk {
namespace {

class Numbers {
 public:
  explicit Numbers(std::uint32_t seed) : state_(seed * 2654435761u + 1u) {}
  float unit() {  // 0 to 1
    state_ = state_ * 1664525u + 1013904223u;
    return float(state_ >> 8) / float(1u << 24);
  }

 private:
  std::uint32_t state_;
};

struct Leaf {
  glm::vec2 centre{0.0f};
  float radius = 1.0f;
  glm::vec3 linear{0.0f};
};

std::vector<Leaf> leaves_of(const LeafyOptions& options) {
  Numbers numbers(options.leaf_seed);
  const glm::vec2 size(options.width, options.height);
  std::vector<Leaf> leaves;
  while (leaves.size() < 420) {
    const glm::vec2 offset(2.0f * numbers.unit() - 1.0f, 2.0f * numbers.unit() - 1.0f);
    if (glm::dot(offset, offset) > 1.0f) continue;
    const float shade = 0.5f + numbers.unit();
    leaves.push_back({size * glm::vec2(0.5f, 0.42f) + offset * glm::vec2(0.33f, 0.33f) * size.y,
                      size.y * (0.012f + 0.012f * numbers.unit()),
                      shade * glm::vec3(0.05f, 0.11f, 0.02f)});
  }
  return leaves;
}

glm::vec3 background_at(const LeafyOptions& options, int y) {
  const float down = float(y) / float(options.height);
  if (down > 0.8f) return {0.24f, 0.20f, 0.07f};
  return options.sky * glm::mix(glm::vec3(0.25f, 0.45f, 1.0f), glm::vec3(0.8f, 0.9f, 1.0f), down);
}

void paint(LeafyScene& scene, const Leaf& leaf) {
  const int reach = int(std::ceil(leaf.radius)) + 1;
  for (int y = int(leaf.centre.y) - reach; y <= int(leaf.centre.y) + reach; ++y) {
    for (int x = int(leaf.centre.x) - reach; x <= int(leaf.centre.x) + reach; ++x) {
      if (x < 0 || y < 0 || x >= scene.alpha.width() || y >= scene.alpha.height()) continue;
      const float cover =
          std::clamp(leaf.radius + 0.5f - glm::distance(leaf.centre, glm::vec2(x, y)), 0.0f, 1.0f);
      if (cover <= 0.0f) continue;
      float& alpha = scene.alpha(x, y);
      const float behind = alpha * (1.0f - cover);
      scene.front_linear(x, y) =
          (cover * leaf.linear + behind * scene.front_linear(x, y)) / (cover + behind);
      alpha = cover + behind;
    }
  }
}

void paint_trunk(LeafyScene& scene) {
  const int width = scene.alpha.width(), height = scene.alpha.height();
  for (int y = height / 2; y < height * 9 / 10; ++y) {
    for (int x = width * 48 / 100; x < width * 52 / 100; ++x) {
      scene.alpha(x, y) = 1.0f;
      scene.front_linear(x, y) = {0.06f, 0.04f, 0.025f};
    }
  }
}

void expose(LeafyScene& scene, const LeafyOptions& options) {
  Numbers numbers(77);
  for (int y = 0; y < options.height; ++y) {
    for (int x = 0; x < options.width; ++x) {
      const glm::vec3 light =
          glm::mix(background_at(options, y), scene.front_linear(x, y), scene.alpha(x, y));
      const glm::vec3 srgb = srgb_from_linear(glm::clamp(light * options.gain, 0.0f, 1.0f));
      const glm::vec3 noise(numbers.unit() - 0.5f, numbers.unit() - 0.5f, numbers.unit() - 0.5f);
      scene.photo.srgb(x, y) =
          glm::clamp(glm::round(srgb * 255.0f + 3.0f * noise) / 255.0f, 0.0f, 1.0f);
    }
  }
}

// A user is careful enough to keep foreground strokes off the gaps he sees.
void scribble(LeafyScene& scene) {
  const int width = scene.alpha.width(), height = scene.alpha.height();
  const auto mark = [&](int x, int y) {
    const float alpha = scene.alpha(x, y);
    if (alpha > 0.97f) scene.strokes(x, y) = 255;
    if (alpha == 0.0f && (y < height / 10 || y > height * 85 / 100)) scene.strokes(x, y) = 0;
  };
  for (int row = 0; row < 3; ++row) {
    for (int x = 0; x < width; ++x) {
      mark(x, height / 20 + row);
      mark(x, height * 4 / 10 + row);
      mark(x, height * 92 / 100 + row);
    }
    for (int y = height * 3 / 10; y < height * 85 / 100; ++y) mark(width / 2 + row, y);
  }
}

}  // namespace

LeafyScene leafy_scene(const LeafyOptions& options) {
  LeafyScene scene;
  scene.photo.name = "tree";
  scene.photo.srgb = Image<glm::vec3>(options.width, options.height);
  scene.photo.camera.lens = {LensModel::pinhole,
                             options.width,
                             options.height,
                             glm::dvec2(options.width),
                             0.5 * glm::dvec2(options.width - 1, options.height - 1),
                             {}};
  scene.photo.original_camera = scene.photo.camera;
  scene.alpha = Image<float>(options.width, options.height);
  scene.front_linear = Image<glm::vec3>(options.width, options.height);
  scene.strokes = Image<std::uint8_t>(options.width, options.height, 128);
  for (const Leaf& leaf : leaves_of(options)) paint(scene, leaf);
  paint_trunk(scene);
  expose(scene, options);
  scribble(scene);
  return scene;
}

double mean_absolute_error(const Image<float>& alpha, const Image<float>& truth) {
  double sum = 0.0;
  for (std::size_t i = 0; i < alpha.size(); ++i) sum += std::abs(alpha.data()[i] - truth.data()[i]);
  return sum / double(alpha.size());
}

Image<float> alpha_of(const Image<glm::vec4>& rgba) {
  Image<float> alpha(rgba.width(), rgba.height());
  std::transform(rgba.pixels().begin(), rgba.pixels().end(), alpha.pixels().begin(),
                 [](const glm::vec4& pixel) { return pixel.a; });
  return alpha;
}

}  // namespace bosk
