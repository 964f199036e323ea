#include "ui/workstation/stage_run.h"

#include "ui/workstation/workspace.h"

namespace bosk {

std::string title_of_stage(const std::string& stage) { return stage_named(stage).title; }

RunWatchers watchers_of(Workspace& workspace) {
  workspace.volume.watch = std::make_shared<VolumeWatch>();
  return volume_watchers(workspace.volume.watch, [jobs = &workspace.jobs] { jobs->wake(); });
}

void apply_what_was_used(Workspace& workspace, const Recipe& asked, const Recipe& used) {
  for (const std::string option : {"opacity.stop_after", "radiance.stop_after"}) {
    const std::string text = option_text(used, option);
    if (text != option_text(asked, option)) {
      edit(workspace, option_edit(workspace.project(), option, text));
    }
  }
}

}  // namespace bosk
