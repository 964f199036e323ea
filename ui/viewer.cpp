#include "ui/viewer.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "core/base/error.h"
#include "core/image/image_io.h"
#include "ui/forest_picture.h"
#include "ui/picture_pace.h"
#include "ui/view_marks.h"
#include "ui/viewer_input.h"
#include "ui/viewer_state.h"
#include "ui/window.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;

constexpr double kLongestWait = 0.25;  // seconds: a signal to stop is heard within it
constexpr double kMessageTime = 5.0;   // seconds that a message is shown
constexpr int kFramesAfterEvent = 3;   // Dear ImGui settles its windows within so many

// bosk-0001.png, the first that is free.
fs::path free_picture_name(const fs::path& folder) {
  for (int number = 1;; ++number) {
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), "bosk-%04d.png", number);
    if (!fs::exists(folder / name.data())) return folder / name.data();
  }
}

class Viewer {
 public:
  Viewer(const ForestScene& scene, const ViewerStart& start,
         const std::function<void(const std::string&)>& say)
      : scene_(scene),
        start_(start),
        say_(say),
        window_(start.title, start.size, "use --screenshot or --turntable, which need no display"),
        picture_(scene, window_.driver(), OffscreenTarget::Precision::bits_16) {
    state_.options = start.options;
    state_.camera = start.camera;
    // Drivers finish shaders when they are first used: not on the first picture's account
    const glm::ivec2 tiny(16, 16);
    picture_.draw(camera_of(state_.camera, tiny, view_angle(state_.options)), state_.options,
                  kLeastBudget, 0.0);
  }

  void run(const Progress& progress) {
    int frames_due = kFramesAfterEvent;
    while (!window_.close_asked() && !state_.close_wanted) {
      progress.check();
      const bool at_once = frames_due > 0 || is_animated();
      if (window_.wait(at_once ? 0.0 : kLongestWait) || forget_old_message()) {
        frames_due = kFramesAfterEvent;
      } else if (!at_once && refine()) {
        frames_due = 1;
      }
      if (frames_due == 0 && !is_animated()) continue;
      frames_due = std::max(0, frames_due - 1);
      frame();
    }
  }

 private:
  // Whether another frame follows without an event.
  bool is_animated() const { return (moving_ || state_.options.wind_m > 0.0) && !is_hidden(); }

  bool is_hidden() const {
    const glm::ivec2 size = window_.size_px();
    return size.x < 1 || size.y < 1;
  }

  bool forget_old_message() {
    if (state_.message.empty() || window_.seconds() < message_end_) return false;
    state_.message.clear();
    return true;
  }

  void frame() {
    if (is_hidden()) return;
    const glm::ivec2 size = window_.size_px();
    window_.begin_overlay();
    const double now = window_.seconds();
    moving_ = apply_input(state_, scene_, size, window_.take_pressed_keys(), now - last_frame_);
    last_frame_ = now;
    draw_panels(size);
    draw_picture(size, now);
    if (state_.picture_wanted) save_picture(size);
    picture_.show(0);
    window_.draw_overlay();
    window_.present();
  }

  void draw_panels(const glm::ivec2& size) {
    if (state_.options.cameras) {
      draw_marks(scene_, camera_of(state_.camera, size, view_angle(state_.options)), state_);
    }
    if (state_.panel) {
      draw_figures_panel(state_);
      draw_look_panel(state_);
    }
    if (state_.keys) draw_keys_panel(state_);
    draw_message();
  }

  void draw_message() {
    if (state_.message.empty()) return;
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5f * size.x, size.y - 8}, ImGuiCond_Always, {0.5f, 1.0f});
    ImGui::Begin("message", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::TextUnformatted(state_.message.c_str());
    ImGui::End();
  }

  void draw_picture(const glm::ivec2& size, double now) {
    draw_when_changed(
        pace_, picture_key(state_.camera, size, state_.options, now), state_.options,
        [this](const PictureKey& key, std::uint64_t budget) { return draw_with(key, budget); });
    state_.figures = pace_.figures;
  }

  bool refine() {
    if (is_hidden()) return false;
    const bool refined = refine_at_rest(
        pace_, state_.options,
        [this](const PictureKey& key, std::uint64_t budget) { return draw_with(key, budget); });
    state_.figures = pace_.figures;
    return refined;
  }

  FrameFigures draw_with(const PictureKey& key, std::uint64_t budget) {
    const Camera camera = camera_of(key.camera, key.size_px, view_angle(state_.options));
    return picture_.draw(camera, state_.options, budget, key.wind_time_s);
  }

  void save_picture(const glm::ivec2& size) {
    state_.picture_wanted = false;
    message_end_ = window_.seconds() + kMessageTime;
    try {
      Image<glm::u8vec3> picture = picture_.read();
      const Camera camera = camera_of(state_.camera, size, view_angle(state_.options));
      if (state_.options.cameras) {
        paint_marks(picture, view_marks(scene_, camera, target_of(state_.camera)));
      }
      const fs::path path = free_picture_name(start_.pictures);
      write_png(path, picture);
      state_.message = path.lexically_normal().string();
    } catch (const Error& error) {
      state_.message = error.what();
    }
    say_(state_.message);
  }

  const ForestScene& scene_;
  const ViewerStart& start_;
  const std::function<void(const std::string&)>& say_;
  Window window_;
  ForestPicture picture_;
  ViewerState state_;
  PicturePace pace_;
  bool moving_ = false;
  double last_frame_ = 0.0, message_end_ = 0.0;
};

}  // namespace

void run_viewer(const ForestScene& scene, const ViewerStart& start, const Progress& progress,
                const std::function<void(const std::string&)>& say) {
  Viewer(scene, start, say).run(progress);
}

}  // namespace bosk
