#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/console.h"
#include "app/stage_options.h"
#include "core/project/capture.h"
#include "core/project/lock.h"
#include "core/project/project.h"
#include "core/project/run.h"

namespace bosk {

// One project as a subcommand works on it: read, perhaps changed by options, and its stages run
// under the project's lock, with remarks told once.
class ProjectWork {
 public:
  ProjectWork(const std::string& folder, const StageChoices& choices, Console& console);
  ProjectWork(Project project, Console& console);

  const Project& project() const { return project_; }
  const Capture& capture() const { return capture_; }

  bool is_finished(const std::string& stage) const;
  Run run(const std::vector<std::string>& wanted) { return run(capture_, wanted); }
  // On other inputs than the project's own, with photos left out, as a share of the job.
  Run run(const Capture& capture, const std::vector<std::string>& wanted, Share share = {});

 private:
  void lock();
  // Cameras for a project without a camera file, found now unless they were before.
  void find_cameras();

  Project project_;
  Capture capture_;
  Console& console_;
  std::optional<ProjectLock> lock_;
  double done_ = 0.0;  // share of the job that finding cameras took
};

}  // namespace bosk
