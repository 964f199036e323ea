#include "core/render/level_switch.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/image/pyramid.h"
#include "core/render/reference.h"

namespace bosk {
namespace {

constexpr int kSmallestTree_px = 2;
constexpr int kLargestTree_px = 1024;  // of the truth; a drawing to judge is at most half of it
constexpr double kSmallestCell_px = 0.125;
constexpr float kSpeckPx =
    1.0f;  // a tree within one pixel is one billboard, whatever it looks like
constexpr double kBestPsnr_db = 99.0;

std::vector<glm::dvec3> eyes_of(const TreeModel& model, const std::vector<Camera>& cameras,
                                int most) {
  const glm::dvec3 centre = model.origin + 0.5 * model.size_m;
  const double nearest_m = 1.5 * model.size_m;
  if (cameras.empty()) return {centre - glm::dvec3(0.0, 3.0 * model.size_m, 0.0)};
  std::vector<glm::dvec3> eyes;
  const std::size_t count = std::min(cameras.size(), std::size_t(std::max(most, 1)));
  for (std::size_t i = 0; i < count; ++i) {
    glm::dvec3 from_centre = cameras[i * cameras.size() / count].centre_in_world() - centre;
    if (!(glm::length(from_centre) > 1e-6 * model.size_m)) from_centre = {0.0, -1.0, 0.0};
    const double distance_m = std::max(glm::length(from_centre), nearest_m);
    eyes.push_back(centre + distance_m * glm::normalize(from_centre));
  }
  return eyes;
}

// A pinhole at `eye` towards the middle of the cube, which is `tree_px` wide in its picture.
Camera framing_camera(const TreeModel& model, const glm::dvec3& eye, int tree_px) {
  const glm::dvec3 centre = model.origin + 0.5 * model.size_m;
  const glm::dvec3 z = glm::normalize(centre - eye);
  const glm::dvec3 side = std::abs(z.z) < 0.999 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
  const glm::dvec3 x = glm::normalize(glm::cross(z, side));
  Camera camera;
  camera.name = "a tree of " + std::to_string(tree_px) + " px";
  camera.lens.width_px = camera.lens.height_px = tree_px / 2 * 3;
  camera.lens.focal_px = glm::dvec2(tree_px * glm::distance(centre, eye) / model.size_m);
  camera.lens.principal_px = glm::dvec2(0.5 * camera.lens.width_px - 0.5);
  camera.camera_from_world.rotation = glm::transpose(glm::dmat3(x, glm::cross(z, x), z));
  camera.camera_from_world.translation = -(camera.camera_from_world.rotation * eye);
  return camera;
}

Image<glm::vec4> draw_level(const PreparedTree& tree, const glm::dvec3& eye, int tree_px,
                            std::size_t slot, Progress& progress) {
  RenderOptions options;
  options.level = tree.model().levels[slot].level;
  progress.check();
  Progress quiet;
  return render_tree_premultiplied(tree, framing_camera(tree.model(), eye, tree_px), options,
                                   quiet);
}

struct SquaredError {
  double sum = 0.0;
  std::size_t values = 0;
  double psnr_db() const {
    if (!(sum > 0.0)) return kBestPsnr_db;
    return std::min(kBestPsnr_db, 10.0 * std::log10(double(values) / sum));
  }
};

void add_error(const Image<glm::vec4>& truth, const Image<glm::vec4>& drawn, SquaredError& error) {
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const glm::vec4& a = truth.pixels()[i];
    const glm::vec4& b = drawn.pixels()[i];
    if (std::max(a.a, b.a) < 1.0f / 255.0f) continue;
    const glm::dvec3 over_white = glm::dvec3(a) - glm::dvec3(b) - double(a.a - b.a);
    error.sum += glm::dot(over_white, over_white);
    error.values += 3;
  }
}

// About two pixels for a finest cell: beyond that the picture holds nothing new.
int truth_width_px(const TreeModel& model) {
  const int cells = 1 << std::clamp(model.levels.back().level, 0, 20);
  return std::clamp(2 * cells, 32 * kSmallestTree_px, kLargestTree_px);
}

double cell_px(const TreeModel& model, std::size_t slot, int tree_px) {
  return std::ldexp(double(tree_px), -model.levels[slot].level);
}

using ErrorTable = std::map<int, std::vector<SquaredError>>;  // by tree_px, then slot

void add_errors_of_eye(const PreparedTree& tree, const glm::dvec3& eye, ErrorTable& table,
                       Progress& progress) {
  const TreeModel& model = tree.model();
  int tree_px = truth_width_px(model);
  Image<glm::vec4> truth = draw_level(tree, eye, tree_px, model.levels.size() - 1, progress);
  for (tree_px /= 2; tree_px >= kSmallestTree_px; tree_px /= 2) {
    truth = half_size(truth);
    std::vector<SquaredError>& errors = table[tree_px];
    errors.resize(model.levels.size());
    for (std::size_t slot = 0; slot < model.levels.size(); ++slot) {
      if (cell_px(model, slot, tree_px) >= kSmallestCell_px)
        add_error(truth, draw_level(tree, eye, tree_px, slot, progress), errors[slot]);
    }
    progress.advance();
  }
}

std::size_t scale_count(const TreeModel& model) {
  std::size_t count = 0;
  for (int px = truth_width_px(model) / 2; px >= kSmallestTree_px; px /= 2) ++count;
  return count;
}

// Errors of one slot from small to large, each with by how much it is good enough (in dB; negative:
// not).
struct Margin {
  double cell_px = 0.0, margin_db = 0.0;
};

std::vector<Margin> margins_of(const std::vector<LevelError>& errors, std::size_t slot,
                               const LevelSwitchOptions& options) {
  std::map<int, double> best_db;  // by size
  for (const LevelError& error : errors)
    best_db[error.tree_px] = std::max(best_db[error.tree_px], error.psnr_db);
  std::vector<Margin> margins;
  for (const LevelError& error : errors) {
    if (error.level_slot != slot) continue;
    const double least_db =
        std::min(options.least_psnr_db, best_db[error.tree_px] - options.slack_db);
    margins.push_back({error.cell_px, error.psnr_db - least_db});
  }
  return margins;
}

// Up to where the margin is not below 0; linear in the logarithm of the size. Below that it may
// well be: finer levels pile up opacity where their cells are far below a pixel, so a coarser one,
// which comes first, is the better one there.
double largest_good_px(const std::vector<Margin>& margins) {
  const auto good = std::find_if(margins.rbegin(), margins.rend(),
                                 [](const Margin& margin) { return margin.margin_db >= 0.0; });
  if (good == margins.rend()) return 0.0;
  if (good == margins.rbegin()) return good->cell_px;
  const Margin& bad = *std::prev(good);
  const double part = good->margin_db / (good->margin_db - bad.margin_db);
  return good->cell_px * std::pow(bad.cell_px / good->cell_px, part);
}

}  // namespace

std::vector<LevelError> measure_level_errors(const TreeModel& model,
                                             const std::vector<Camera>& cameras,
                                             const LevelSwitchOptions& options,
                                             Progress& progress) {
  if (model.levels.empty()) return {};
  const std::vector<glm::dvec3> eyes = eyes_of(model, cameras, options.most_cameras);
  progress.begin("Comparing levels of detail", eyes.size() * scale_count(model));
  ErrorTable table;
  const PreparedTree tree(model);
  for (const glm::dvec3& eye : eyes) add_errors_of_eye(tree, eye, table, progress);
  std::vector<LevelError> errors;
  for (std::size_t slot = 0; slot < model.levels.size(); ++slot) {
    for (const auto& [tree_px, of_slots] : table) {
      const double size_px = cell_px(model, slot, tree_px);
      if (size_px >= kSmallestCell_px)
        errors.push_back({slot, tree_px, size_px, of_slots[slot].psnr_db()});
    }
  }
  return errors;
}

void set_level_switches(TreeModel& model, const std::vector<Camera>& cameras, Progress& progress,
                        const LevelSwitchOptions& options) {
  if (model.levels.empty()) return;
  const std::vector<LevelError> errors = measure_level_errors(model, cameras, options, progress);
  const std::size_t finest = model.levels.size() - 1;
  for (std::size_t slot = 0; slot < finest; ++slot)
    model.levels[slot].max_cell_px = float(largest_good_px(margins_of(errors, slot, options)));
  model.levels[finest].max_cell_px = 0.0f;
  TreeLevel& coarsest = model.levels.front();
  if (finest > 0 && coarsest.level == 0)
    coarsest.max_cell_px = std::max(coarsest.max_cell_px, kSpeckPx);
}

}  // namespace bosk
