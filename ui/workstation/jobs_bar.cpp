#include <imgui.h>

#include <algorithm>

#include "core/base/remaining_time.h"
#include "ui/widgets/landmarks.h"
#include "ui/widgets/theme.h"
#include "ui/workstation/stage_run.h"
#include "ui/workstation/workspace.h"
#include "ui/workstation/workstation.h"

namespace bosk {
namespace {

constexpr float kBarEms = 14.0f;

std::string time_text(const JobView& job) {
  std::string text = minutes_text(job.spent_s);
  if (job.left_s) text += ", about " + minutes_text(*job.left_s) + " left";
  return text;
}

void draw_job(Workspace& workspace, const JobView& job) {
  const std::string id = std::to_string(job.id);
  if (button("job/stop", "Stop##" + id, "stop this job; what was finished before is kept",
             job.stopping ? "it is stopping" : "")) {
    workspace.jobs.cancel(job.id);
  }
  ImGui::SameLine();
  if (job.running) {
    ImGui::ProgressBar(float(job.fraction), {kBarEms * ImGui::GetFontSize(), 0});
    ImGui::SameLine();
    ImGui::TextUnformatted(
        ((job.phrase.empty() ? job.title : job.phrase) + "  " + time_text(job)).c_str());
  } else {
    ImGui::TextDisabled("%s waits", job.title.c_str());
  }
}

// What begins when the job at work is done.
void draw_waiting(Workspace& workspace) {
  const std::string title = title_of_stage(workspace.waiting_stage);
  const bool dropped =
      button("job/drop", "Drop##waiting", "what waits is not begun; what is at work goes on");
  ImGui::SameLine();
  ImGui::TextDisabled("%s waits for it", title.c_str());
  if (dropped) workspace.waiting_stage.clear();
}

void draw_record(const JobRecord& record) {
  switch (record.end) {
    case JobRecord::End::done:
      badge(Tone::good, record.title + ": done in " + minutes_text(record.spent_s));
      break;
    case JobRecord::End::cancelled:
      badge(Tone::muted, record.title + ": stopped");
      break;
    case JobRecord::End::failed:
      badge(Tone::bad, record.title + ": failed");
      paragraph(record.message);
      break;
  }
  for (const std::string& warning : record.warnings) paragraph(Tone::note, warning);
}

}  // namespace

void draw_jobs_bar(Workspace& workspace) {
  ImGui::Separator();
  bool any = false;
  for (const JobView& job : workspace.jobs.now()) {
    if (job.lane == Lane::interactive) continue;
    draw_job(workspace, job);
    any = true;
  }
  if (!workspace.waiting_stage.empty()) draw_waiting(workspace);
  mark("jobs", ImGui::GetWindowPos(),
       {ImGui::GetWindowPos().x + ImGui::GetWindowWidth(),
        ImGui::GetWindowPos().y + ImGui::GetWindowHeight()});
  const auto& records = workspace.jobs.records();
  if (!any && records.empty()) ImGui::TextDisabled("No jobs. What runs is shown here.");
  for (std::size_t i = records.size(); i-- > 0;) draw_record(records[i]);
}

}  // namespace bosk
