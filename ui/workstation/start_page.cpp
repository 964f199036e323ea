#include "ui/workstation/start_page.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include "core/base/error.h"
#include "core/base/system_error.h"
#include "ui/widgets/landmarks.h"
#include "ui/widgets/theme.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;

// A folder with a project that has nothing in it yet.
void make_empty_project(const fs::path& folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) throw system_error(folder, "created", failure.value());
  Project project;
  project.folder = folder;
  project.recipe.pack.name = project.name();
  save_project(project);
}

void try_to_open(Workspace& workspace, const fs::path& folder) {
  try {
    open_project(workspace, folder);
    workspace.start_page = {};
  } catch (const Error& error) {
    workspace.start_page.trouble = error.what();
  }
}

void try_to_make(Workspace& workspace, const fs::path& folder) {
  try {
    make_empty_project(folder);
  } catch (const Error& error) {
    workspace.start_page.trouble = error.what();
    return;
  }
  try_to_open(workspace, folder);
}

void draw_choice(Workspace& workspace) {
  StartPageState& state = workspace.start_page;
  paragraph("A project is a folder. Type or paste its path, or drop it on this window:");
  ImGui::SetNextItemWidth(-1.0f);
  const bool entered =
      ImGui::InputText("##folder", &state.folder, ImGuiInputTextFlags_EnterReturnsTrue);
  mark("start/folder");
  const bool exists = !state.folder.empty() && holds_project(state.folder);
  const std::string missing = state.folder.empty() ? "type a folder first" : "";
  const bool open = button("start/open", "Open", "open the project in this folder",
                           exists            ? ""
                           : missing.empty() ? "no project is there yet"
                                             : missing);
  ImGui::SameLine();
  const bool make = button("start/make", "Make a new project",
                           "makes the folder where it is missing; photographs stay where they are",
                           exists ? "this folder holds a project: open it" : missing);
  if (exists && (open || entered)) try_to_open(workspace, state.folder);
  if (!exists && missing.empty() && (make || entered)) try_to_make(workspace, state.folder);
  if (!state.trouble.empty()) paragraph(Tone::bad, state.trouble);
}

void draw_recent(Workspace& workspace) {
  if (workspace.settings.recent.empty()) return;
  ImGui::Separator();
  title("Opened lately");
  std::string wanted;
  int number = 0;
  for (const fs::path& project : workspace.settings.recent) {
    const std::string path = project.string();
    const std::string name = "start/recent/" + std::to_string(++number);
    if (button(name, project.filename().string(), path,
               holds_project(project) ? "" : path + ": there is no project any more")) {
      wanted = path;
    }
    ImGui::SameLine();
    ImGui::TextDisabled("%s", path.c_str());
  }
  if (!wanted.empty()) try_to_open(workspace, wanted);
}

}  // namespace

void draw_start_page(Workspace& workspace) {
  for (const fs::path& path : workspace.input.dropped) workspace.start_page.folder = path.string();
  title("Bosk");
  paragraph(
      Tone::muted,
      "About 24 photographs of a tree become a small package that draws like that very tree.");
  ImGui::Separator();
  draw_choice(workspace);
  draw_recent(workspace);
  ImGui::Separator();
  if (button("shortcuts", "Keys (F1)", "the list of keys")) workspace.shortcuts_shown = true;
}

}  // namespace bosk
