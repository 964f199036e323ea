#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/stage_options.h"
#include "core/base/system_error.h"
#include "core/package/reader.h"
#include "core/photo/camera_files.h"
#include "core/render/gl/forest_renderer.h"
#include "core/render/gl/headless_context.h"
#include "core/render/gl/offscreen_target.h"
#include "core/render/picture_files.h"
#include "core/render/reference.h"

namespace bosk {
namespace {

struct RenderArguments {
  std::string package, cameras, output;
  bool gl = false;
  OptionTexts options;
};

CameraPainter cpu_painter(const std::shared_ptr<const PreparedTree>& tree,
                          const RenderOptions& options, Progress& progress) {
  return [=, &progress](const Camera& camera) {
    return render_tree(*tree, camera, options, progress);
  };
}

// A forest of one tree, drawn without a window.
struct GlStand {
  GlStand(std::shared_ptr<const PreparedTree> tree, AtlasTexels atlas)
      : forest({std::move(tree)}, {{}}), renderer(forest, {.atlas = atlas}) {}

  Image<glm::vec4> draw(const Camera& camera, const RenderOptions& options) {
    const OffscreenTarget target(camera.lens.width_px, camera.lens.height_px,
                                 OffscreenTarget::Precision::bits_32);
    target.bind();
    target.clear(glm::vec4(0.0f));
    forest.draw_list(viewpoint_of(camera), draw_options(options), 0, list);
    renderer.draw(list, camera, {.blend = blend_rule(options.blend)});
    return straight_from_premultiplied(target.read());
  }

  HeadlessContext context;
  Forest forest;
  ForestRenderer renderer;
  ForestDrawList list;
};

CameraPainter gl_painter(std::shared_ptr<const PreparedTree> tree, const RenderOptions& options) {
  const auto stand = std::make_shared<GlStand>(
      std::move(tree), options.gpu_texels ? AtlasTexels::bc3 : AtlasTexels::automatic);
  return [=](const Camera& camera) { return stand->draw(camera, options); };
}

ExitStatus render_views(const RenderArguments& arguments, Console& console) {
  RenderOptions options;
  set_options(arguments.options, describe(options));
  const TreeModel model = load_tree(arguments.package);
  const auto tree = std::make_shared<PreparedTree>(model);
  const std::vector<Camera> cameras = read_cameras(arguments.cameras);
  const CameraPainter paint =
      arguments.gl ? gl_painter(tree, options) : cpu_painter(tree, options, console.progress());
  std::vector<std::string> pictures;
  std::vector<double> milliseconds;
  for (const PictureFile& file :
       write_pictures(cameras, paint, arguments.output, console.progress())) {
    pictures.push_back(file.path.string());
    milliseconds.push_back(std::round(10.0 * file.draw_ms) / 10.0);
  }
  console.result(printable(arguments.output) + ": " + std::to_string(cameras.size()) + " pictures",
                 {{"pictures", pictures}, {"milliseconds", milliseconds}});
  return ExitStatus::done;
}

}  // namespace

void add_render_command(CLI::App& app, Request& request) {
  CLI::App& command =
      add_command(app, request, "render",
                  "draw a package as given cameras see it: RGBA PNGs with straight alpha, in each "
                  "camera's lens and size",
                  "bosk render oak.bosk --cameras transforms.json -o pictures");
  auto arguments = std::make_shared<RenderArguments>();
  command.add_option("TREE.bosk", arguments->package, "the package")->required();
  command
      .add_option("--cameras", arguments->cameras,
                  "a COLMAP model's folder, a transforms.json, a .cameramodel or a folder of them; "
                  "pictures are named as their photos")
      ->required()
      ->type_name("FILE|DIR");
  command
      .add_option("-o,--output", arguments->output, "folder for the pictures, made when missing")
      ->required()
      ->type_name("DIR");
  command.add_flag(
      "--gl", arguments->gl,
      "draw through OpenGL 4.5, without a window: the same pictures with the BC3 texels "
      "that a GPU reads");
  RenderOptions defaults;
  add_options(command, describe(defaults), "", "How to draw", arguments->options);
  command.callback([arguments, &request] {
    request.run = [arguments](Console& console) { return render_views(*arguments, console); };
  });
}

}  // namespace bosk
