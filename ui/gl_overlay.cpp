#include "ui/gl_overlay.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

namespace bosk {

void start_gl_overlay() { ImGui_ImplOpenGL3_Init("#version 450"); }

void stop_gl_overlay() { ImGui_ImplOpenGL3_Shutdown(); }

void restart_gl_overlay() {
  stop_gl_overlay();
  start_gl_overlay();
}

void begin_gl_overlay() { ImGui_ImplOpenGL3_NewFrame(); }

void draw_gl_overlay() { ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData()); }

}  // namespace bosk
