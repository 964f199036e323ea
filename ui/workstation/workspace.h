#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/project/capture.h"
#include "core/project/run.h"
#include "core/project/session.h"
#include "core/project/stages.h"
#include "ui/widgets/landmarks.h"
#include "ui/widgets/pictures.h"
#include "ui/workstation/calibrate/calibrate_step.h"
#include "ui/workstation/codebook/codebook_step.h"
#include "ui/workstation/export/export_step.h"
#include "ui/workstation/jobs.h"
#include "ui/workstation/matte/matte_step.h"
#include "ui/workstation/photos/photos_step.h"
#include "ui/workstation/preview/preview_step.h"
#include "ui/workstation/preview/tree_pictures.h"
#include "ui/workstation/start_page.h"
#include "ui/workstation/textures/textures_step.h"
#include "ui/workstation/user_settings.h"
#include "ui/workstation/volume/volume_step.h"
#include "ui/workstation/work_step.h"

namespace bosk {

// What the window heard since the last frame, beside what Dear ImGui keeps.
struct WindowInput {
  // Keys pressed, also those released again, which Dear ImGui 1.86 forgets in a slow frame; repeats
  // of a key held down count again.
  std::vector<int> keys;
  // Held with any of them, though perhaps let go by now; Dear ImGui's own say what is held now.
  bool ctrl = false, shift = false, alt = false;
  std::vector<std::filesystem::path> dropped;  // files and folders
  // Where the mouse was since the last frame, oldest first, in Dear ImGui's coordinates; may be
  // empty. A slow frame otherwise sees only its last place.
  std::vector<ImVec2> mouse_path;
  // Which place of the path the left button went down or up at, the last time; none: it didn't.
  std::optional<std::size_t> pressed_at, released_at;
  bool focus_lost = false;
  bool at_rest = false;  // nothing was heard for about a quarter of a second

  bool pressed(int key) const;
  // The places that belong to a stroke of the left button, from where it went down, when the stroke
  // began in this frame, to where it went up; the mouse's where a beginning was not heard.
  std::vector<ImVec2> stroke_places(bool began) const;
  bool ends_stroke(bool began) const;  // in this frame
};

// When the window draws another frame, beside what it hears.
enum class NextFrame { when_heard, at_rest, at_once };

// The option that is being dragged or typed, with its value as text; empty: none.
struct OptionInHand {
  std::string name, text;
};

// How a stage's newest result stands to the project as it is now.
enum class StageState {
  missing,   // never made, or not from anything like this
  stored,    // made from just this, on disk, not loaded yet
  outdated,  // shown, but made from something else
  current,   // shown, and made from just this
};

// All that the window knows: one capture session. The interface thread owns it; workers get values.
struct Workspace {
  // `device` makes textures, `wake` asks for a frame from any thread, settings are kept in
  // `settings_place` (empty: nowhere).
  Workspace(PictureDevice device, std::function<void()> wake, std::filesystem::path settings_place);
  ~Workspace();
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  const Project& project() const { return session->project(); }

  Pictures pictures;
  Landmarks landmarks;
  UserSettings settings;
  std::filesystem::path settings_place;
  WindowInput input;
  WorkStep step = WorkStep::photos;
  OptionInHand option_in_hand;
  bool shortcuts_shown = false, close_wanted = false;
  float screen_scale = 1.0f;          // what the screen asks for where the person chose none
  std::optional<float> scale_wanted;  // the window applies it before the next frame
  NextFrame next_frame = NextFrame::when_heard;  // as the newest frame wants it
  TreePictures tree_pictures;                    // given by the window; empty: none

  std::unique_ptr<Session> session;  // null: the start page is shown
  // What stages start from, as the project's files were read last; null with the reason beside it.
  std::shared_ptr<const Capture> capture;
  std::string capture_obstacle;
  Results results;                          // the newest that is loaded or was made
  std::map<std::string, ContentHash> made;  // the key of each stage's result in `results`
  // And the keys of all stages when that result was made.
  std::map<std::string, std::map<std::string, ContentHash>> made_with;
  std::map<std::string, ContentHash> wanted;  // the keys that the project asks for now
  std::map<std::string, bool> stored;         // whether the cache holds the wanted result
  std::string running_stage;                  // that the running job was asked for
  ContentHash running_key;                    // of that stage when the job began
  int running_job = 0;
  std::string waiting_stage;  // asked for meanwhile, begins when that job is done; empty: none

  StartPageState start_page;
  PhotosStepState photos;
  CalibrateStepState calibrate;
  MatteStepState matte;
  VolumeStepState volume;
  TexturesStepState textures;
  CodebookStepState codebook;
  PreviewStepState preview;
  ExportStepState export_tree;

  // The session's revision when the keys were made; none: make them again.
  std::optional<std::uint64_t> seen_revision;
  std::uint64_t seen_files = 0;  // which files the capture was read from
  Jobs jobs;                     // last: its workers must end before what they wake goes
};

// Opens a project in place of the present one, which is saved. Throws Error as Session does; the
// present project then stays open.
void open_project(Workspace& workspace, const std::filesystem::path& folder);
void close_project(Workspace& workspace);

// The one way to change the project: applies the edit, journals it, and brings what depends on it
// up to date.
void edit(Workspace& workspace, Edit change);
void undo(Workspace& workspace);
void redo(Workspace& workspace);

// Follows the project after edits and finished jobs. Once a frame, before anything is drawn.
void refresh(Workspace& workspace);

// The size of everything in the window, and another one from the next frame on, kept within range.
float scale_of(const Workspace& workspace);
void ask_for_scale(Workspace& workspace, float scale);
inline constexpr float kScaleStep = 0.25f;

StageState state_of(const Workspace& workspace, const std::string& stage);
bool is_shown(const Workspace& workspace, const std::string& stage);  // outdated or current
// Whether the results shown of a stage and of one before it belong together.
bool is_made_from(const Workspace& workspace, const std::string& stage, const std::string& input);
// Whether a job is at work, or waits, that makes the stage's result.
bool is_running(const Workspace& workspace, const std::string& stage);
// Whether it is asked for but not begun: it follows the job at work.
bool waits(const Workspace& workspace, const std::string& stage);
// Why no stage can run now; empty when they can.
std::string obstacle_to_stages(const Workspace& workspace);

// Starts a job that makes all stages up to this one; what is finished is loaded instead. Waits for
// the job at work if the project still asks for what that makes, and stops it otherwise; does
// nothing while one is at work on this stage.
void run_to(Workspace& workspace, const std::string& stage);
// Loads the stage's result if the cache holds it and it isn't shown yet.
void load_if_stored(Workspace& workspace, const std::string& stage);

}  // namespace bosk
