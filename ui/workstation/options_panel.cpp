#include "ui/workstation/options_panel.h"

#include <imgui.h>

#include <algorithm>

#include "core/project/presets.h"
#include "ui/widgets/landmarks.h"
#include "ui/widgets/option_widget.h"
#include "ui/widgets/theme.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

std::string default_text(const std::string& name) { return option_text(Recipe(), name); }

// The value goes back to the default by a right click.
void offer_default(Workspace& workspace, const std::string& name) {
  if (!ImGui::BeginPopupContextItem(name.c_str())) return;
  const std::string standard = default_text(name);
  if (ImGui::MenuItem(("Back to the default, " + standard).c_str())) {
    edit(workspace, option_edit(workspace.project(), name, standard));
  }
  ImGui::EndPopup();
}

void draw_one(Workspace& workspace, const std::string& name, const Option& option) {
  const std::string before = value_text(option);
  // What is under the hand right now is not yet an edit
  OptionInHand& in_hand = workspace.option_in_hand;
  if (in_hand.name == name) set_value(option, in_hand.text);
  const bool changed = draw_option(option);
  const bool let_go = ImGui::IsItemDeactivated();
  const bool held = ImGui::IsItemActive();
  mark("options/" + name);
  offer_default(workspace, name);
  const std::string now = value_text(option);
  if (held && changed) in_hand = {name, now};
  const bool at_once = changed && !held;  // a check box, a choice
  if (!at_once && !(let_go && in_hand.name == name)) return;
  in_hand = {};
  if (now != before) edit(workspace, option_edit(workspace.project(), name, now));
}

}  // namespace

void draw_stage_options(Workspace& workspace, const std::string& stage,
                        const std::vector<std::string>& names) {
  Recipe recipe = workspace.project().recipe;
  ImGui::PushItemWidth(0.5f * ImGui::GetContentRegionAvail().x);
  for (const OptionGroup& group : option_groups(recipe)) {
    if (group.stage != stage) continue;
    for (const Option& option : group.options) {
      const bool wanted =
          names.empty() || std::find(names.begin(), names.end(), option.name) != names.end();
      if (wanted) draw_one(workspace, stage + "." + option.name, option);
    }
  }
  ImGui::PopItemWidth();
}

void draw_preset_choice(Workspace& workspace) {
  for (const Preset& preset : presets()) {
    if (&preset != &presets().front()) ImGui::SameLine();
    const bool pressed = button("preset/" + preset.name, preset.name, preset.help);
    if (!pressed) continue;
    Recipe recipe = workspace.project().recipe;
    apply_preset(recipe, preset.name);
    SetOptions change = recipe_edit(workspace.project(), "preset " + preset.name, recipe);
    if (!change.options.empty()) edit(workspace, std::move(change));
  }
}

}  // namespace bosk
