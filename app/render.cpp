#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/stage_options.h"
#include "core/base/system_error.h"
#include "core/image/image_io.h"
#include "core/package/reader.h"
#include "core/photo/camera_files.h"
#include "core/render/reference.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;

struct RenderArguments {
  std::string package, cameras, output;
  OptionTexts options;
};

void make_folder(const fs::path& folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) throw system_error(folder, "created", failure.value());
}

ExitStatus render_views(const RenderArguments& arguments, Console& console) {
  RenderOptions options;
  set_options(arguments.options, describe(options));
  const TreeModel model = load_tree(arguments.package);
  const PreparedTree tree(model);
  const std::vector<Camera> cameras = read_cameras(arguments.cameras);
  make_folder(arguments.output);
  std::vector<std::string> pictures;
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    console.progress().scope(double(i) / double(cameras.size()),
                             double(i + 1) / double(cameras.size()));
    const Image<glm::vec4> view = render_tree(tree, cameras[i], options, console.progress());
    const fs::path picture = fs::path(arguments.output) / (cameras[i].name + ".png");
    write_png(picture, rgba8_from_straight(view));
    pictures.push_back(picture.string());
  }
  console.result(printable(arguments.output) + ": " + std::to_string(cameras.size()) + " pictures",
                 {{"pictures", pictures}});
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
  RenderOptions defaults;
  add_options(command, describe(defaults), "", "How to draw", arguments->options);
  command.callback([arguments, &request] {
    request.run = [arguments](Console& console) { return render_views(*arguments, console); };
  });
}

}  // namespace bosk
