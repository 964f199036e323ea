#include "tests/ui/workstation/finished_project.h"

#include "core/project/run.h"
#include "tests/base/scratch_folder.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;

const fs::path& first_finished() {
  static const ScratchFolder scratch;
  static const fs::path folder = [] {
    const Project project = make_tiny_project(scratch.path());
    Progress quiet;
    run_stages(project, gather_capture(project), stages_up_to("pack"), quiet);
    return scratch.path();
  }();
  return folder;
}

}  // namespace

Project finished_project(const fs::path& folder) {
  for (const char* part : {"capture", "tree"}) {
    fs::copy(first_finished() / part, folder / part, fs::copy_options::recursive);
  }
  return read_project(folder / "tree");
}

}  // namespace bosk
