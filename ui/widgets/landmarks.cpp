#include "ui/widgets/landmarks.h"

namespace bosk {
namespace {

Landmarks* kept() { return static_cast<Landmarks*>(ImGui::GetIO().UserData); }

}  // namespace

void begin_landmarks(Landmarks& landmarks) {
  landmarks.clear();
  ImGui::GetIO().UserData = &landmarks;
}

void mark(const std::string& name, bool enabled) {
  if (!kept() || !ImGui::IsItemVisible()) return;
  (*kept())[name] = {ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), enabled};
}

void mark(const std::string& name, const ImVec2& least, const ImVec2& most) {
  if (kept()) (*kept())[name] = {least, most, true};
}

}  // namespace bosk
