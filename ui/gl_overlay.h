#pragma once

namespace bosk {

// What draws Dear ImGui's panels in the present OpenGL context. One context of Dear ImGui at a
// time.
void start_gl_overlay();
void stop_gl_overlay();
// After fonts changed; not within a frame. Started anew as a whole: the packaged backend (1.86)
// forgets that its vertex buffers went when it is told to make its font again, and then draws
// nothing more.
void restart_gl_overlay();

void begin_gl_overlay();  // before ImGui::NewFrame
void draw_gl_overlay();   // what ImGui::Render made, into the framebuffer that is bound

}  // namespace bosk
