#include "core/project/stages.h"

#include <algorithm>
#include <optional>
#include <set>
#include <stdexcept>
#include <type_traits>

#include "core/base/error.h"
#include "core/matte/first_guess.h"
#include "core/package/assemble.h"
#include "core/package/writer.h"
#include "core/project/imported_mattes.h"
#include "core/project/stored_images.h"
#include "core/project/stroke_text.h"
#include "core/render/level_switch.h"

namespace bosk {
namespace {

using Bytes = std::vector<std::byte>;

Stage stage_of(const std::string& name, const std::string& title, double share,
               const std::vector<std::string>& inputs) {
  Stage stage;
  stage.name = name;
  stage.title = title;
  stage.share = share;
  stage.inputs = inputs;
  return stage;
}

// The four functions of a stage that concern how its result is held and stored, of one member.
template <class T>
void hold(Stage& stage, std::shared_ptr<const T> Results::*member,
          void (*write_result)(BinaryWriter&, const T&), T (*read_result)(BinaryReader&)) {
  stage.is_held = [member](const Results& results) { return results.*member != nullptr; };
  stage.let_go = [member](Results& results) { (results.*member).reset(); };
  stage.write = [=](BinaryWriter& writer, const Results& results) {
    write_result(writer, *(results.*member));
  };
  stage.read = [=](BinaryReader& reader, Results& results) {
    results.*member = std::make_shared<const T>(read_result(reader));
  };
}

template <class T>
std::shared_ptr<const T> shared(T result) {
  return std::make_shared<const T>(std::move(result));
}

void write_bytes(BinaryWriter& writer, const Bytes& bytes) { writer.array(bytes); }
Bytes read_bytes(BinaryReader& reader) { return reader.array<std::byte>(); }

void hash_strokes(ContentHasher& hasher, const std::vector<Stroke>& strokes) {
  hasher.value(std::uint64_t(strokes.size()));
  for (const Stroke& stroke : strokes) {
    hasher.text(kind_text(stroke.kind)).value(stroke.radius_px).array(stroke.points_px);
  }
}

// Adds nothing where there are none, so that captures without strokes keep the keys they had.
void hash_strokes(ContentHasher& hasher, const Capture& capture) {
  if (!capture.mattes.empty()) return;
  for (const auto& [name, strokes] : capture.strokes) {
    if (capture.left_out.count(name) > 0) continue;
    hasher.text(name);
    hash_strokes(hasher, strokes);
  }
}

Photos kept(const Photos& photos, const std::set<std::string>& left_out, bool with_pixels) {
  Photos chosen;
  for (const Photo& photo : photos) {
    if (left_out.count(photo.name) > 0) continue;
    chosen.push_back({photo.name, photo.camera, photo.original_camera,
                      with_pixels ? photo.srgb : Image<glm::vec3>()});
  }
  return chosen;
}

std::vector<SourceFile> kept(const std::vector<SourceFile>& files,
                             const std::set<std::string>& left_out) {
  std::vector<SourceFile> chosen;
  for (const SourceFile& file : files) {
    if (left_out.count(file.name) == 0) chosen.push_back(file);
  }
  return chosen;
}

std::vector<Camera> cameras_of(const Photos& views) {
  std::vector<Camera> cameras;
  for (const Photo& view : views) cameras.push_back(view.camera);
  return cameras;
}

void hash_left_out(ContentHasher& hasher, const Capture& capture) {
  hasher.value(std::uint64_t(capture.left_out.size()));
  for (const std::string& name : capture.left_out) hasher.text(name);
}

Stage photo_stage() {
  Stage stage = stage_of("photo", "Photos", 4, {});
  stage.options = [](Recipe& recipe) { return describe(recipe.photo); };
  stage.hash_sources = [](ContentHasher& hasher, const Capture& capture) {
    hash_files(hasher, capture.photos);
    for (const Camera& camera : capture.cameras) hash_camera(hasher, camera);
  };
  stage.compute = [](const Capture& capture, const Recipe& recipe, Results& results,
                     Progress& progress, const RunWatchers&) {
    std::vector<std::filesystem::path> files;
    for (const SourceFile& photo : capture.photos) files.push_back(photo.path);
    PhotoImport imported = import_photos(files, capture.cameras, recipe.photo, progress);
    results.imported =
        shared(ImportedPhotos{std::move(imported.photos), std::move(imported.verdicts)});
  };
  hold<ImportedPhotos>(stage, &Results::imported, write_stored, read_stored_import);
  return stage;
}

Stage view_stage() {
  Stage stage = stage_of("view", "Views", 0.1, {"photo"});
  stage.hash_sources = hash_left_out;
  stage.compute = [](const Capture& capture, const Recipe&, Results& results, Progress&,
                     const RunWatchers&) {
    results.views = shared(kept(results.imported->photos, capture.left_out, false));
  };
  hold<Photos>(stage, &Results::views, write_stored, read_stored_photos);
  return stage;
}

Mattes made_mattes(const Capture& capture, const Recipe& recipe, const Photos& photos,
                   Progress& progress) {
  const DecodeLimits limits = decode_limits(recipe.photo);
  if (!capture.mattes.empty()) return import_mattes(capture.mattes, photos, limits, progress);
  Scribbles drawn = import_scribbles(capture.scribbles, capture.strokes, photos, limits, progress);
  return matte_photos(photos, guess_where_none(std::move(drawn), photos, progress), recipe.matte,
                      progress);
}

Stage matte_stage() {
  Stage stage = stage_of("matte", "Mattes", 6, {"photo"});
  stage.version = 4;
  stage.options = [](Recipe& recipe) { return describe(recipe.matte); };
  stage.hash_sources = [](ContentHasher& hasher, const Capture& capture) {
    hash_left_out(hasher, capture);
    hash_files(hasher, kept(capture.mattes, capture.left_out));
    hash_files(hasher, kept(capture.scribbles, capture.left_out));
    hash_strokes(hasher, capture);
  };
  stage.compute = [](const Capture& capture, const Recipe& recipe, Results& results,
                     Progress& progress, const RunWatchers&) {
    const Photos& all = results.imported->photos;
    const Photos some = capture.left_out.empty() ? Photos() : kept(all, capture.left_out, true);
    const Photos& photos = capture.left_out.empty() ? all : some;
    results.mattes = shared(made_mattes(capture, recipe, photos, progress));
  };
  hold<Mattes>(stage, &Results::mattes, write_stored, read_stored_mattes);
  return stage;
}

Stage opacity_stage() {
  Stage stage = stage_of("opacity", "Opacity", 8, {"view", "matte"});
  stage.version = 2;
  stage.options = [](Recipe& recipe) { return describe(recipe.opacity); };
  stage.compute = [](const Capture&, const Recipe& recipe, Results& results, Progress& progress,
                     const RunWatchers& watchers) {
    results.opacity = shared(estimate_opacity(*results.views, *results.mattes, recipe.opacity,
                                              progress, watchers.opacity));
  };
  hold<OpacityTree>(stage, &Results::opacity, write, read_opacity_tree);
  return stage;
}

Stage radiance_stage() {
  Stage stage = stage_of("radiance", "Radiance", 58, {"view", "matte", "opacity"});
  stage.version = 2;
  stage.options = [](Recipe& recipe) { return describe(recipe.radiance); };
  stage.compute = [](const Capture&, const Recipe& recipe, Results& results, Progress& progress,
                     const RunWatchers& watchers) {
    results.radiance = shared(refine_radiance(*results.views, *results.mattes, *results.opacity,
                                              recipe.radiance, progress, watchers.radiance));
  };
  hold<RadianceVolume>(stage, &Results::radiance, write, read_radiance_volume);
  return stage;
}

Stage texture_stage() {
  Stage stage = stage_of("texture", "Textures", 6, {"view", "radiance"});
  stage.version = 3;
  stage.options = [](Recipe& recipe) { return describe(recipe.texture); };
  stage.compute = [](const Capture&, const Recipe& recipe, Results& results, Progress& progress,
                     const RunWatchers&) {
    results.billboards = shared(
        bake_billboards(*results.radiance, cameras_of(*results.views), recipe.texture, progress));
  };
  hold<Billboards>(stage, &Results::billboards, write, read_billboards);
  return stage;
}

Stage compress_stage() {
  Stage stage = stage_of("compress", "Codebooks", 18, {"texture"});
  stage.options = [](Recipe& recipe) { return describe(recipe.compress); };
  stage.compute = [](const Capture&, const Recipe& recipe, Results& results, Progress& progress,
                     const RunWatchers& watchers) {
    results.textures = shared(
        compress_billboards(*results.billboards, recipe.compress, progress, watchers.compress));
  };
  hold<CodedTextures>(stage, &Results::textures, write, read_coded_textures);
  return stage;
}

TreeMetadata metadata_of(const PackOptions& options, std::size_t photos) {
  TreeMetadata metadata;
  metadata.name = options.name;
  metadata.licence = options.licence;
  metadata.credit = options.credit;
  metadata.generator = "bosk " BOSK_VERSION;
  metadata.photo_count = std::uint32_t(photos);
  return metadata;
}

Stage pack_stage() {
  Stage stage = stage_of("pack", "Package", 4, {"view", "texture", "compress"});
  stage.version = 3;
  stage.options = [](Recipe& recipe) { return describe(recipe.pack); };
  stage.compute = [](const Capture&, const Recipe& recipe, Results& results, Progress& progress,
                     const RunWatchers&) {
    const TreeMetadata metadata = metadata_of(recipe.pack, results.views->size());
    TreeModel tree = assemble_tree(*results.billboards, *results.textures, metadata);
    std::optional<ProgressPart> part(std::in_place, progress, 0.0, 0.7);
    set_level_switches(tree, cameras_of(*results.views), progress);
    part.emplace(progress, 0.7, 1.0);
    results.package = shared(package_bytes(tree, progress));
  };
  hold<Bytes>(stage, &Results::package, write_bytes, read_bytes);
  return stage;
}

std::vector<Stage> all_stages() {
  return {photo_stage(),    view_stage(),    matte_stage(),    opacity_stage(),
          radiance_stage(), texture_stage(), compress_stage(), pack_stage()};
}

void add_inputs(const std::string& name, std::set<std::string>& names) {
  if (!names.insert(name).second) return;
  for (const std::string& input : stage_named(name).inputs) add_inputs(input, names);
}

}  // namespace

const std::vector<Stage>& stages() {
  static const std::vector<Stage> all = all_stages();
  return all;
}

const Stage& stage_named(const std::string& name) {
  const auto& all = stages();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Stage& stage) { return stage.name == name; });
  if (found == all.end()) throw std::logic_error("there is no stage " + name);
  return *found;
}

std::vector<std::string> stages_up_to(const std::string& name) {
  std::set<std::string> needed;
  add_inputs(name, needed);
  std::vector<std::string> ordered;
  for (const Stage& stage : stages()) {
    if (needed.count(stage.name) > 0) ordered.push_back(stage.name);
  }
  return ordered;
}

}  // namespace bosk
