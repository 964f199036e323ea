#include "core/project/evaluation.h"

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/base/system_error.h"
#include "core/image/image_io.h"
#include "core/package/reader.h"
#include "core/photo/camera_files.h"
#include "core/photo/decode.h"
#include "core/project/hold_out.h"
#include "core/render/reference.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;

// Of the time that an evaluation takes, roughly.
constexpr Share kTruthShare{0.0, 0.1}, kPackageShare{0.1, 0.95}, kScoreShare{0.95, 1.0};

using Picture = Image<glm::u8vec4>;

struct TrueView {
  Camera camera;
  Picture picture;
};

std::string caption_of(const std::string& name, const ViewScore& score) {
  return name + ": " + number_text(score.psnr, 2) + " dB, SSIM " + number_text(score.ssim, 3);
}

// Draws the package for each view and scores it.
void score_views(Evaluation& evaluation, const std::vector<TrueView>& views, Progress& progress) {
  std::vector<NamedScore> scores;
  const PreparedTree tree(evaluation.tree);
  for (std::size_t i = 0; i < views.size(); ++i) {
    const auto& [camera, truth] = views[i];
    const double width = (kScoreShare.to - kScoreShare.from) / double(views.size());
    progress.scope(kScoreShare.from + width * double(i), kScoreShare.from + width * double(i + 1),
                   "Scores");
    const Picture rendered = rgba8_from_straight(render_tree(tree, camera, {}, progress));
    const ViewScore score = score_view(rendered, truth);
    scores.push_back({camera.name, score});
    evaluation.views.push_back({caption_of(camera.name, score), truth, rendered});
  }
  evaluation.scores = tabulate(std::move(scores));
}

void make_package(Evaluation& evaluation, const EvaluationSource& source, const Capture& capture) {
  const Run run = source.run(capture, {"pack"}, kPackageShare);
  evaluation.package_bytes = run.results.package->size();
  evaluation.tree = read_tree(*run.results.package, source.project.name());
  evaluation.times = times_spent(source.project, capture);
}

std::vector<TrueView> held_out_views(const EvaluationSource& source,
                                     const std::set<std::string>& names) {
  // Imported mattes stand alone; those made from strokes need the photos that strokes were drawn on
  const bool imported = !source.capture.mattes.empty();
  const Run run = source.run(imported ? with_only(source.capture, names) : source.capture,
                             {"view", "matte"}, kTruthShare);
  std::vector<TrueView> views;
  for (std::size_t i = 0; i < run.results.views->size(); ++i) {
    const Photo& view = (*run.results.views)[i];
    if (names.count(view.name) == 0) continue;
    views.push_back({view.camera, rgba8_from_straight((*run.results.mattes)[i].rgba)});
    views.back().camera.name = view.name;
  }
  if (views.empty()) throw Error("none of the photos to hold out could be read");
  return views;
}

fs::path picture_of(const fs::path& folder, const std::string& name) {
  return folder / (name + ".png");
}

Picture read_truth(const fs::path& path, const Camera& camera, PhotoDecoder& decoder,
                   const Progress& progress) {
  const DecodedPhoto photo = decoder.decode(path, progress);
  const Lens& lens = camera.lens;
  if (!photo.has_alpha() || photo.width_px != lens.width_px || photo.height_px != lens.height_px) {
    throw Error(printable(path.string()) + ": must be RGBA of its camera's size, " +
                std::to_string(lens.width_px) + " x " + std::to_string(lens.height_px));
  }
  return rgba8_from_straight(straight_of(photo));
}

std::vector<TrueView> true_views(const fs::path& cameras, const fs::path& folder,
                                 Progress& progress) {
  std::vector<TrueView> views;
  PhotoDecoder decoder;
  for (const Camera& camera : read_cameras(cameras)) {
    const fs::path path = picture_of(folder, camera.name);
    if (fs::exists(path)) {
      views.push_back({camera, read_truth(path, camera, decoder, progress)});
    } else {
      progress.warn("camera " + printable(camera.name) + " is passed over: there is no " +
                    printable(path.string()));
    }
  }
  if (views.empty()) {
    throw Error(printable(folder.string()) +
                ": holds no picture named as one of the cameras, such as " +
                printable(picture_of(folder, read_cameras(cameras).front().name).string()));
  }
  return views;
}

}  // namespace

EvaluationSource evaluation_source(const Project& project, const Capture& capture,
                                   Progress& progress) {
  return {project, capture,
          [project, &progress](const Capture& chosen, const std::vector<std::string>& wanted,
                               Share share) {
            return run_stages(project, chosen, wanted, progress, share);
          }};
}

Evaluation evaluate_held_out(const EvaluationSource& source, int every, Progress& progress) {
  const std::set<std::string> names = held_out_names(source.capture, every);
  const std::vector<TrueView> views = held_out_views(source, names);
  Capture rest = source.capture;
  rest.left_out = names;

  Evaluation evaluation;
  evaluation.title = std::to_string(views.size()) + " of " +
                     std::to_string(source.capture.photos.size()) + " photos held out";
  make_package(evaluation, source, rest);
  score_views(evaluation, views, progress);
  return evaluation;
}

Evaluation evaluate_against(const EvaluationSource& source, const fs::path& cameras,
                            const fs::path& truth_folder, Progress& progress) {
  const std::vector<TrueView> views = true_views(cameras, truth_folder, progress);
  Evaluation evaluation;
  evaluation.title = std::to_string(views.size()) + " views that are not among the " +
                     std::to_string(source.capture.photos.size()) + " photos";
  make_package(evaluation, source, source.capture);
  score_views(evaluation, views, progress);
  return evaluation;
}

}  // namespace bosk
