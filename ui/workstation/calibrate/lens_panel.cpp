#include <imgui.h>

#include <cstdio>
#include <numbers>

#include "core/base/system_error.h"
#include "core/project/calibration_figures.h"
#include "ui/widgets/landmarks.h"
#include "ui/workstation/calibrate/calibrate_panels.h"
#include "ui/workstation/calibrate/calibration_words.h"
#include "ui/workstation/options_panel.h"
#include "ui/workstation/path_field.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;

// A file or folder that the lens is known from, with the way to take another or none.
void draw_source(Workspace& workspace, FileKind which, const PathField& field, std::string& typed,
                 const fs::path& now) {
  const auto take = [&](const fs::path& path) {
    edit_or_tell(workspace, files_edit(workspace.project(), which, path));
  };
  if (now.empty()) {
    if (const auto path = draw_path_field(field, typed)) take(workspace.project().relative(*path));
    return;
  }
  ImGui::TextUnformatted(printable(now.string()).c_str());
  ImGui::SameLine();
  if (button(field.button + "/none", "Forget", "undo brings it back")) take({});
}

std::string lens_words(const LensCalibration& boards) {
  const Lens& lens = boards.profile.lens;
  char text[160];
  std::snprintf(text, sizeof text,
                "%d boards, %d corners, %.2f px; focal length %.1f px to %.2g %%",
                boards.profile.boards, boards.profile.corners, boards.profile.rms_px,
                lens.focal_px.x, 100.0 * boards.focal_sigma);
  return text;
}

void draw_picture(const char* words, const std::string& name, const Texture& texture) {
  ImGui::BeginGroup();
  ImGui::TextUnformatted(words);
  if (texture) {
    ImGui::Image(texture.id, {float(texture.size_px.x), float(texture.size_px.y)});
    mark(name);
  }
  ImGui::EndGroup();
}

void save_profile(Workspace& workspace, const fs::path& place) {
  workspace.jobs.start(
      "Saving the lens",
      [finds = workspace.calibrate.solved.finds, place](Progress& progress) {
        progress.begin("saving the lens", 1);
        save_lens_profile(place, finds->boards->profile);
        return place;
      },
      [&workspace](const fs::path& saved) {
        workspace.calibrate.said = {
            {Tone::good, "Saved the lens to " + printable(saved.string()) +
                             "; other projects take it under Lens, as a profile."}};
      },
      Lane::interactive, "calibrate/save_profile");
}

void draw_saving(Workspace& workspace, const LensCalibration& boards) {
  const bool refused = boards.verdict == Verdict::refused;
  const PathField field{"calibrate/profile_place",
                        "where to keep the lens: a file name, .json",
                        "calibrate/save_profile",
                        "Save lens",
                        "for other captures with this camera at this focal length",
                        refused ? "these boards determine no lens" : ""};
  if (const auto path = draw_path_field(field, workspace.calibrate.typed_profile_place)) {
    save_profile(workspace, *path);
  }
}

void draw_boards(const LensCalibration& boards) {
  if (!ImGui::BeginTable("boards", 5, ImGuiTableFlags_RowBg | ImGuiTableFlags_NoSavedSettings)) {
    return;
  }
  for (const char* name : {"Board photo", "Corners", "px", "Tilt", "Why not"}) {
    ImGui::TableSetupColumn(name);
  }
  ImGui::TableHeadersRow();
  for (const BoardFinding& board : boards.boards) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(board.photo.c_str());
    ImGui::TableNextColumn();
    ImGui::Text("%d", board.corners);
    ImGui::TableNextColumn();
    ImGui::Text("%.2f", board.rms_px);
    ImGui::TableNextColumn();
    ImGui::Text("%.0f deg", board.tilt * 180.0 / std::numbers::pi);
    ImGui::TableNextColumn();
    if (!board.used) paragraph(Tone::note, board.reason);
  }
  ImGui::EndTable();
}

}  // namespace

const std::vector<std::string>& lens_option_names() {
  static const std::vector<std::string> names = {"lens",
                                                 "lens_model",
                                                 "board",
                                                 "board_columns",
                                                 "board_rows",
                                                 "board_square_m",
                                                 "board_dictionary",
                                                 "board_marker_share",
                                                 "board_warp",
                                                 "board_at_tree"};
  return names;
}

void draw_lens_sources(Workspace& workspace) {
  CalibrateStepState& state = workspace.calibrate;
  const CalibrationInputs inputs = workspace.project().calibration;
  draw_source(workspace, FileKind::lens,
              {"calibrate/profile", "a lens profile", "calibrate/take_profile", "Use",
               "the lens is then known: of the same camera at the same focal length", ""},
              state.typed_profile, inputs.lens);
  draw_source(workspace, FileKind::boards,
              {"calibrate/boards", "folder with photos of a board", "calibrate/take_boards", "Use",
               "the lens is then calibrated from a board that the same camera saw", ""},
              state.typed_boards, inputs.boards);
  draw_stage_options(workspace, "calibrate", lens_option_names());
}

void draw_lens_view(Workspace& workspace) {
  const SolvedCameras& solved = workspace.calibrate.solved;
  if (!solved.finds || !solved.finds->boards) {
    return paragraph(Tone::muted,
                     "No photos of a board. With some (10 to 40, near and far, tilted, out to the "
                     "corners) the lens is known before the cameras are solved, and markers come "
                     "out several times as exact.");
  }
  const LensCalibration& boards = *solved.finds->boards;
  badge(tone_of(boards.verdict), verdict_words(boards.verdict));
  paragraph(lens_words(boards) + ".");
  for (const std::string& sentence : boards.sentences) paragraph(Tone::note, sentence);
  draw_saving(workspace, boards);
  draw_picture("Where corners lie (green: no error, red: three sigma)", "calibrate/coverage",
               workspace.pictures.show("calibrate/coverage", solved.revision,
                                       [&] { return solved.lens_look->coverage; }));
  ImGui::SameLine();
  char words[64];
  std::snprintf(words, sizeof words, "Uncertainty of the lens (blue: 0 px, red: %g px)",
                kFullUncertaintyPx);
  draw_picture(words, "calibrate/uncertainty",
               workspace.pictures.show("calibrate/uncertainty", solved.revision,
                                       [&] { return solved.lens_look->uncertainty; }));
  draw_boards(boards);
}

}  // namespace bosk
