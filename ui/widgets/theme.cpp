#include "ui/widgets/theme.h"

#include <filesystem>

#include "ui/widgets/landmarks.h"

namespace bosk {
namespace {

constexpr float kFontPx = 16.0f, kTitlePx = 24.0f;
constexpr float kTooltipEms = 28.0f;  // a tooltip's longest line

// Latin with its extensions, Greek, Cyrillic, punctuation, arrows and the signs of units.
const ImWchar kGlyphs[] = {0x0020, 0x024f, 0x0370, 0x052f, 0x2010, 0x2044, 0x2190,
                           0x2193, 0x2200, 0x2265, 0x25a0, 0x25ff, 0};

void load_font(float size_px) {
  ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
  std::error_code none;
  if (std::filesystem::exists(BOSK_FONT_FILE, none)) {
    fonts.AddFontFromFileTTF(BOSK_FONT_FILE, size_px, nullptr, kGlyphs);
    return;
  }
  ImFontConfig config;
  config.SizePixels = size_px;
  fonts.AddFontDefault(&config);
}

// The first is the text's, the second that of titles.
void load_fonts(float scale) {
  ImGui::GetIO().Fonts->Clear();
  load_font(kFontPx * scale);
  load_font(kTitlePx * scale);
}

void set_colours(ImGuiStyle& style) {
  ImGui::StyleColorsDark(&style);
  style.Colors[ImGuiCol_WindowBg] = {0.11f, 0.12f, 0.13f, 1.0f};
  style.Colors[ImGuiCol_ChildBg] = {0.14f, 0.15f, 0.16f, 1.0f};
  style.Colors[ImGuiCol_Text] = {0.93f, 0.94f, 0.93f, 1.0f};
  // 4.9 : 1 on the windows' ground
  style.Colors[ImGuiCol_TextDisabled] = {0.58f, 0.60f, 0.60f, 1.0f};
  style.Colors[ImGuiCol_Header] = {0.20f, 0.33f, 0.42f, 1.0f};
  style.Colors[ImGuiCol_HeaderHovered] = {0.17f, 0.26f, 0.32f, 1.0f};
  style.Colors[ImGuiCol_HeaderActive] = {0.22f, 0.38f, 0.50f, 1.0f};
  style.Colors[ImGuiCol_Border] = {0.28f, 0.30f, 0.31f, 1.0f};
}

// A shape for each tone, so that no colour need be told apart: disc, ring, triangle, cross, dot.
void draw_mark(Tone tone, const ImVec2& middle, float radius) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImU32 colour = colour_u32(tone);
  const float line = 0.35f * radius;
  switch (tone) {
    case Tone::good:
      draw.AddCircleFilled(middle, radius, colour);
      break;
    case Tone::busy:
      draw.AddCircle(middle, radius - 0.5f * line, colour, 0, line);
      break;
    case Tone::note:
      draw.AddTriangleFilled({middle.x, middle.y - radius}, {middle.x + radius, middle.y + radius},
                             {middle.x - radius, middle.y + radius}, colour);
      break;
    case Tone::bad:
      draw.AddLine({middle.x - radius, middle.y - radius}, {middle.x + radius, middle.y + radius},
                   colour, line);
      draw.AddLine({middle.x - radius, middle.y + radius}, {middle.x + radius, middle.y - radius},
                   colour, line);
      break;
    case Tone::muted:
    case Tone::neutral:
      draw.AddCircleFilled(middle, 0.4f * radius, colour);
      break;
  }
}

}  // namespace

ImVec4 colour_of(Tone tone) {
  switch (tone) {
    case Tone::good:
      return {0.15f, 0.75f, 0.58f, 1.0f};
    case Tone::busy:
      return {0.34f, 0.71f, 0.91f, 1.0f};
    case Tone::note:
      return {0.94f, 0.89f, 0.26f, 1.0f};
    case Tone::bad:
      return {0.95f, 0.45f, 0.18f, 1.0f};
    case Tone::muted:
      return ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled);
    case Tone::neutral:
      break;
  }
  return ImGui::GetStyleColorVec4(ImGuiCol_Text);
}

ImU32 colour_u32(Tone tone, float alpha) {
  ImVec4 colour = colour_of(tone);
  colour.w *= alpha;
  return ImGui::ColorConvertFloat4ToU32(colour);
}

void apply_theme(float scale) {
  ImGuiStyle style;
  set_colours(style);
  style.FrameRounding = style.GrabRounding = style.ChildRounding = 3.0f;
  style.FramePadding = {7.0f, 4.0f};
  style.ItemSpacing = {8.0f, 6.0f};
  style.WindowPadding = {10.0f, 8.0f};
  style.ScrollbarSize = 14.0f;
  style.WindowRounding = 0.0f;
  style.ScaleAllSizes(scale);
  ImGui::GetStyle() = style;
  load_fonts(scale);
}

void title(const std::string& text) {
  const auto& fonts = ImGui::GetIO().Fonts->Fonts;
  ImGui::PushFont(fonts[fonts.Size > 1 ? 1 : 0]);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopFont();
}

void badge(Tone tone, const std::string& word) {
  const float height = ImGui::GetTextLineHeight();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_mark(tone, {at.x + 0.4f * height, at.y + 0.5f * height}, 0.28f * height);
  ImGui::SetCursorScreenPos({at.x + height, at.y});
  ImGui::TextColored(colour_of(tone), "%s", word.c_str());
}

void paragraph(const std::string& text) { paragraph(Tone::neutral, text); }

void paragraph(Tone tone, const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, colour_of(tone));
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

bool button(const std::string& name, const std::string& label, const std::string& tooltip_text,
            const std::string& obstacle) {
  ImGui::BeginDisabled(!obstacle.empty());
  const bool pressed = ImGui::Button((label + "###" + name).c_str());
  ImGui::EndDisabled();
  mark(name, obstacle.empty());
  tooltip(obstacle.empty() ? tooltip_text : obstacle);
  return pressed;
}

void tooltip(const std::string& text) {
  if (text.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(kTooltipEms * ImGui::GetFontSize());
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

}  // namespace bosk
