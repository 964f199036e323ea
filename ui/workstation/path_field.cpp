#include "ui/workstation/path_field.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include "ui/widgets/landmarks.h"
#include "ui/widgets/theme.h"
#include "ui/workstation/path_kinds.h"

namespace bosk {

std::optional<std::filesystem::path> draw_path_field(const PathField& field, std::string& typed) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float button_width = ImGui::CalcTextSize(field.label.c_str()).x +
                             2.0f * style.FramePadding.x + style.ItemSpacing.x;
  ImGui::SetNextItemWidth(-button_width);
  const bool entered = ImGui::InputTextWithHint(("##" + field.name).c_str(), field.hint.c_str(),
                                                &typed, ImGuiInputTextFlags_EnterReturnsTrue);
  mark(field.name);
  ImGui::SameLine();
  const std::string obstacle =
      field.obstacle.empty() && typed.empty() ? "type a path first" : field.obstacle;
  const bool pressed = button(field.button, field.label, field.help, obstacle);
  if (!(entered || pressed) || !obstacle.empty()) return std::nullopt;
  const std::filesystem::path path = path_of_text(typed);
  typed.clear();
  if (path.empty()) return std::nullopt;  // blanks alone
  return path;
}

}  // namespace bosk
