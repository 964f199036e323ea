#include "ui/widgets/option_widget.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

namespace bosk {
namespace {

// "frame ms" of "frame_ms"
std::string label_of(const Option& option) {
  std::string label = option.name;
  std::replace(label.begin(), label.end(), '_', ' ');
  return label;
}

struct Widget {
  const Option& option;
  std::string label = label_of(option);

  bool operator()(bool* value) const { return ImGui::Checkbox(label.c_str(), value); }
  bool operator()(int* value) const {
    return ImGui::DragInt(label.c_str(), value, std::max(1.0f, 0.01f * float(*value)),
                          int(option.minimum), int(option.maximum), "%d",
                          ImGuiSliderFlags_AlwaysClamp);
  }
  bool operator()(double* value) const {
    const bool wide = option.minimum > 0.0 && option.maximum > 100.0 * option.minimum;
    const ImGuiSliderFlags flags =
        ImGuiSliderFlags_AlwaysClamp | (wide ? ImGuiSliderFlags_Logarithmic : 0);
    return ImGui::SliderScalar(label.c_str(), ImGuiDataType_Double, value, &option.minimum,
                               &option.maximum, "%.4g", flags);
  }
  bool operator()(std::string* value) const {
    if (option.choices.empty()) return ImGui::InputText(label.c_str(), value);
    bool changed = false;
    if (!ImGui::BeginCombo(label.c_str(), value->c_str())) return false;
    for (const std::string& choice : option.choices) {
      if (ImGui::Selectable(choice.c_str(), choice == *value)) {
        changed = choice != *value;
        *value = choice;
      }
    }
    ImGui::EndCombo();
    return changed;
  }
};

}  // namespace

bool draw_option(const Option& option) {
  const bool changed = std::visit(Widget{option}, option.value);
  if (ImGui::IsItemHovered()) {
    ImGui::SetTooltip("%s%s", option.help.c_str(),
                      option.unit.empty() ? "" : (" (" + option.unit + ")").c_str());
  }
  return changed;
}

}  // namespace bosk
