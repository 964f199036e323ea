#include "ui/workstation_window.h"

#include <imgui.h>

#include <algorithm>
#include <atomic>
#include <sstream>

#include "core/base/atomic_file.h"
#include "ui/gl_pictures.h"
#include "ui/gl_tree_pictures.h"
#include "ui/window.h"
#include "ui/workstation/workspace.h"
#include "ui/workstation/workstation.h"

namespace bosk {
namespace {

constexpr double kLongestWait = 0.25;  // seconds: a signal to stop is heard within it
constexpr int kFramesAfterEvent = 3;   // Dear ImGui settles its windows within so many
// Seconds of rest before project.json is written anew: more than the journal takes to be on disk,
// so that the file never names a place beyond its end, whatever the power does.
constexpr double kSaveAfter = 2.0;

std::string landmarks_text(const Landmarks& landmarks) {
  std::ostringstream text;
  for (const auto& [name, mark] : landmarks) {
    text << name << ' ' << int(mark.least.x) << ' ' << int(mark.least.y) << ' ' << int(mark.most.x)
         << ' ' << int(mark.most.y) << ' ' << int(mark.enabled) << '\n';
  }
  return text.str();
}

class WorkstationLoop {
 public:
  explicit WorkstationLoop(const WorkstationStart& start)
      : start_(start),
        window_("Bosk", start.size, "use Bosk's commands, see `bosk --help`"),
        workspace_(
            gl_picture_device(), [this] { wake(); }, settings_folder()) {
    workspace_.tree_pictures = gl_tree_pictures(window_.driver());
    workspace_.screen_scale = window_.content_scale();
    const float scale = scale_of(workspace_);
    window_.set_theme(scale);
    if (scale > 1.0f) window_.resize(glm::ivec2(glm::vec2(start.size) * scale));
    if (start.project) open_project(workspace_, *start.project);
  }

  void run(const Progress& progress) {
    int frames_due = kFramesAfterEvent;
    while (!window_.close_asked() && !workspace_.close_wanted) {
      progress.check();
      const bool at_once = frames_due > 0 || workspace_.next_frame == NextFrame::at_once;
      const bool heard = window_.wait(at_once ? 0.0 : kLongestWait);
      if (heard || woken_.exchange(false)) frames_due = kFramesAfterEvent;
      save_at_rest();
      workspace_.input.at_rest = !at_once && !heard;
      if (frames_due == 0 && workspace_.next_frame == NextFrame::when_heard) continue;
      frames_due = std::max(frames_due, 1);
      --frames_due;
      frame();
    }
  }

 private:
  void wake() {
    woken_ = true;
    Window::wake();
  }

  void frame() {
    const glm::ivec2 size = window_.size_px();
    if (size.x < 1 || size.y < 1) {
      workspace_.next_frame = NextFrame::when_heard;
      return refresh(workspace_);
    }
    take_input();
    if (workspace_.scale_wanted) rescale();
    window_.begin_overlay();
    draw_workstation(workspace_);
    window_.draw_overlay();
    window_.present();
    tell_landmarks();
  }

  void take_input() {
    workspace_.input.keys = window_.take_typed_keys();
    const Window::Modifiers held = window_.take_typed_modifiers();
    workspace_.input.ctrl = held.ctrl;
    workspace_.input.shift = held.shift;
    workspace_.input.alt = held.alt;
    workspace_.input.dropped = window_.take_dropped();
    workspace_.input.focus_lost = window_.take_focus_loss();
    const Window::LeftButton left = window_.take_left_button();
    workspace_.input.pressed_at = left.down;
    workspace_.input.released_at = left.up;
    for (const glm::vec2& place : window_.take_mouse_path()) {
      workspace_.input.mouse_path.emplace_back(place.x, place.y);
    }
  }

  void rescale() {
    workspace_.settings.scale = double(*workspace_.scale_wanted);
    window_.set_theme(*workspace_.scale_wanted);
    workspace_.scale_wanted.reset();
    save_settings(workspace_.settings, workspace_.settings_place);
  }

  // The journal has every edit already; this keeps what has to be replayed short.
  void save_at_rest() {
    if (!workspace_.session) return;
    const std::uint64_t revision = workspace_.session->revision();
    const double now = window_.seconds();
    if (revision != last_revision_) {
      last_revision_ = revision;
      last_edit_ = now;
    }
    if (workspace_.session->is_saved() || saved_revision_ == revision) return;
    if (now - last_edit_ < kSaveAfter) return;
    saved_revision_ = revision;
    workspace_.jobs.start(
        "Saving",
        [project = workspace_.project()](Progress&) {
          save_project(project);
          return project.journal;
        },
        [this, folder = workspace_.project().folder](const JournalPlace& place) {
          const bool same = workspace_.session && workspace_.project().folder == folder;
          if (same) workspace_.session->note_saved(place);
        },
        Lane::interactive, "save");
  }

  void tell_landmarks() {
    if (start_.landmarks.empty()) return;
    const std::string text = landmarks_text(workspace_.landmarks);
    if (text == told_landmarks_) return;
    told_landmarks_ = text;
    write_file_atomically(start_.landmarks, text);
  }

  const WorkstationStart& start_;
  Window window_;
  std::atomic<bool> woken_{false};
  std::uint64_t last_revision_ = 0, saved_revision_ = ~std::uint64_t(0);
  double last_edit_ = 0.0;
  std::string told_landmarks_;
  Workspace workspace_;  // last: its textures and workers go before the window
};

}  // namespace

void run_workstation(const WorkstationStart& start, const Progress& progress) {
  WorkstationLoop(start).run(progress);
}

}  // namespace bosk
