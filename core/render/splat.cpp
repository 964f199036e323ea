#include "core/render/splat.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/render/draw_list.h"

namespace bosk {
namespace {

constexpr int kMostRows = 64;  // a texture's rows after splitting them, see split_rows

struct PixelRange {
  int first = 0, last = -1;
};

// Pixels of 0 .. size - 1 that an interval of half width `half` around `centre` touches.
PixelRange pixels_touched(float centre, float half, int size) {
  const float low = std::max(centre - half - 0.5f, -1.0f);
  const float high = std::min(centre + half + 0.5f, float(size));
  return {std::max(0, int(std::ceil(low))), std::min(size - 1, int(std::floor(high)))};
}

// A premultiplied colour whose opacity is that of its share while levels dissolve
// (DrawRange::fade).
Float4 faded(Float4 colour, float fade) {
  if (fade >= 1.0f || !(colour[3] > 0.0f)) return colour;
  const float clear = 1.0f - colour[3] * (1.0f - kFadeSlack * (1.0f - fade));
  return colour * ((1.0f - std::pow(std::max(clear, 0.0f), fade)) / colour[3]);
}

Float4 splat4(float value) { return Float4{value, value, value, value}; }

Float4 clamp4(Float4 x, float low, float high) {
  x = x < low ? splat4(low) : x;
  return x > high ? splat4(high) : x;
}

// Interpolation between `count` samples at 0.5, 1.5 ... on [0, count] is a sum of hats, the outer
// two flat towards the edge. cumulative() holds the integrals of four hats from 0 to a position.
class Hats {
 public:
  Hats() = default;
  Hats(int group, int count) : limit_(float(count)) {
    const float first = float(4 * group) + 0.5f;
    centre_ = Float4{first, first + 1.0f, first + 2.0f, first + 3.0f};
    rise_ = splat4(0.5f);
    fall_ = splat4(-0.5f);
    if (group == 0) rise_[0] = 0.0f;
    if (4 * group + 4 == count) fall_[3] = 0.0f;
  }
  Float4 cumulative(float position) const {
    const float inside = std::clamp(position, 0.0f, limit_);
    const Float4 t = clamp4(splat4(inside) - centre_, -1.0f, 1.0f);
    return 0.5f + t + (t < Float4{} ? rise_ : fall_) * t * t;
  }

 private:
  float limit_;
  Float4 centre_, rise_, fall_;
};

// The splat with texture and axes exchanged where needed, so that the texture's rows run along x
// rather than y, and its map split into the two passes:
//   x = centre.x + column_px * (u - texels / 2) + shift_px * (v - rows / 2)
//   y = centre.y + slope * (x - centre.x) + row_px * (v - rows / 2)
struct Passes {
  glm::vec2 centre{0.0f};
  float column_px = 1, shift_px = 0, slope = 0, row_px = 1;
  int texels = 4, rows = 4;
  float half_width = 0;
  bool degenerate = false;
};

Passes passes_of(const Splat& splat, int texels, bool exchanged, const Tile& tile) {
  glm::vec2 across = splat.across_px, down = splat.down_px;
  if (exchanged) std::swap(across, down);
  Passes passes;
  passes.centre = splat.centre_px - glm::vec2(float(tile.left_px), float(tile.top_px));
  passes.texels = texels;
  // Split the rows until one shifts against the next by less than half a pixel
  passes.rows = texels;
  float shift_px = 2.0f * down.x / float(texels);
  while (std::abs(shift_px) > 0.5f && passes.rows < kMostRows) {
    passes.rows *= 2;
    shift_px *= 0.5f;
  }
  passes.column_px = 2.0f * across.x / float(texels);
  passes.shift_px = shift_px;
  passes.slope = across.y / across.x;
  passes.row_px = 2.0f * (down.y - down.x * passes.slope) / float(passes.rows);
  passes.half_width = std::abs(across.x) + std::abs(down.x);
  passes.degenerate = !(std::abs(across.x) > 1e-12f) || !std::isfinite(passes.row_px);
  return passes;
}

struct Texture {
  Float4 texels[kMostRows * kMostTexels];  // row by row
};

// Rows interpolated to a power of two times as many; keeps the interpolated texture and its
// integral.
void split_rows(const Float4* texture, int texels, int rows, bool exchanged, Texture& split) {
  const int step_across = exchanged ? texels : 1, step_down = exchanged ? 1 : texels;
  for (int row = 0; row < rows; ++row) {
    const float v = (float(row) + 0.5f) * float(texels) / float(rows) - 0.5f;
    const float inside = std::clamp(v, 0.0f, float(texels - 1));
    const int above = std::min(int(inside), texels - 2);
    const float part = inside - float(above);
    for (int i = 0; i < texels; ++i) {
      const Float4 a = texture[above * step_down + i * step_across];
      const Float4 b = texture[(above + 1) * step_down + i * step_across];
      split.texels[row * texels + i] = a + part * (b - a);
    }
  }
}

// First pass, one column of pixels after the other: the mean of every texture row over the column's
// width.
template <int kGroups>
class AlongX {
 public:
  AlongX(const Passes& passes, const Float4* texture, int first_x)
      : passes_(passes), texture_(texture), texel_per_px_(1.0f / passes.column_px) {
    for (int group = 0; group < kGroups; ++group) hats_[group] = Hats(group, passes.texels);
    for (int row = 0; row < passes.rows; ++row)
      for (int group = 0; group < kGroups; ++group)
        before_[row][group] = hats_[group].cumulative(texel_at(float(first_x) - 0.5f, row));
  }

  // For the column after the last one asked for.
  void means(int x, Float4* means) {
    for (int row = 0; row < passes_.rows; ++row) {
      const float right_edge = texel_at(float(x) + 0.5f, row);
      Float4 mean{};
      for (int group = 0; group < kGroups; ++group) {
        const Float4 after = hats_[group].cumulative(right_edge);
        const Float4 weight = passes_.column_px * (after - before_[row][group]);
        before_[row][group] = after;
        const Float4* texel = texture_ + std::ptrdiff_t(4) * (row * kGroups + group);
        for (int i = 0; i < 4; ++i) mean += weight[i] * texel[i];
      }
      means[row] = mean;
    }
  }

 private:
  float texel_at(float x, int row) const {
    const float shift = passes_.shift_px * (float(row) + 0.5f - 0.5f * float(passes_.rows));
    return (x - passes_.centre.x - shift) * texel_per_px_ + 0.5f * float(passes_.texels);
  }

  const Passes& passes_;
  const Float4* texture_;
  float texel_per_px_;
  Hats hats_[kGroups];
  Float4 before_[kMostRows][kGroups];  // cumulative hats at the column's left edge
};

// Second pass: down the column, each pixel's mean composited over it.
void filter_along_y(const Passes& passes, const Hats* hats, const Float4* means, int x, float fade,
                    Tile& tile) {
  const float row_per_px = 1.0f / passes.row_px;
  const float middle = 0.5f * float(passes.rows);
  const float centre = passes.centre.y + passes.slope * (float(x) - passes.centre.x);
  const int groups = passes.rows / 4;
  const PixelRange range = pixels_touched(centre, std::abs(passes.row_px) * middle, tile.height_px);
  Float4 before[kMostRows / 4];  // cumulative hats at the pixel's upper edge
  for (int group = 0; group < groups; ++group)
    before[group] =
        hats[group].cumulative((float(range.first) - 0.5f - centre) * row_per_px + middle);
  for (int y = range.first; y <= range.last; ++y) {
    const float lower_edge = (float(y) + 0.5f - centre) * row_per_px + middle;
    Float4 mean{};
    for (int group = 0; group < groups; ++group) {
      const Float4 after = hats[group].cumulative(lower_edge);
      const Float4 weight = passes.row_px * (after - before[group]);
      before[group] = after;
      for (int i = 0; i < 4; ++i) mean += weight[i] * means[4 * group + i];
    }
    mean = faded(mean, fade);
    Float4& pixel = tile.pixels[y * kTile_px + x];
    pixel = mean + (1.0f - mean[3]) * pixel;
  }
}

template <int kGroups>
void composite(const Passes& passes, const Float4* texture, float fade, Tile& tile) {
  Hats row_hats[kMostRows / 4];
  for (int group = 0; group < passes.rows / 4; ++group) row_hats[group] = Hats(group, passes.rows);
  const PixelRange range = pixels_touched(passes.centre.x, passes.half_width, tile.width_px);
  AlongX<kGroups> along_x(passes, texture, range.first);
  Float4 means[kMostRows];
  for (int x = range.first; x <= range.last; ++x) {
    along_x.means(x, means);
    filter_along_y(passes, row_hats, means, x, fade, tile);
  }
}

}  // namespace

void composite_splat(const Splat& splat, const Float4* texture, int texels, float fade,
                     Tile& tile) {
  const bool exchanged = std::abs(splat.across_px.x) < std::abs(splat.down_px.x);
  const Passes passes = passes_of(splat, texels, exchanged, tile);
  if (passes.degenerate) return;
  Texture split;
  if (exchanged || passes.rows != texels) {
    split_rows(texture, texels, passes.rows, exchanged, split);
    texture = split.texels;
  }
  if (texels == 4)
    composite<1>(passes, texture, fade, tile);
  else
    composite<2>(passes, texture, fade, tile);
}

}  // namespace bosk
