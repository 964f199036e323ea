#pragma once

namespace bosk {

struct Workspace;

// Draws the whole window and acts on what was heard: between ImGui::NewFrame and ImGui::Render.
// Knows neither window system nor OpenGL, so that tests drive it without either.
void draw_workstation(Workspace& workspace);

// Parts of it, each in its own file.
void draw_steps_bar(Workspace& workspace);  // the steps at the left
void draw_jobs_bar(Workspace& workspace);   // what runs, at the bottom
void draw_shortcuts(Workspace& workspace);  // the list of keys, where it is wanted
void hear_shortcuts(Workspace& workspace);  // keys that work everywhere

}  // namespace bosk
