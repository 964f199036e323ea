#pragma once

#include <imgui.h>

#include <string>

namespace bosk {

// What a colour says; always beside a word, never alone. The colours are those of Okabe and Ito
// (2008, "Color universal design"), which people with any colour vision tell apart.
enum class Tone {
  good,     // bluish green: done, usable
  busy,     // sky blue: at work
  note,     // yellow: worth a look, out of date
  bad,      // vermilion: failed, unusable
  muted,    // grey: not yet
  neutral,  // the text's own
};
ImVec4 colour_of(Tone tone);
ImU32 colour_u32(Tone tone, float alpha = 1.0f);

// Colours, spacing and font for a scale of 1 to 3. Before a frame. Throws nothing: without the
// packaged font Dear ImGui's own is taken.
void apply_theme(float scale);
inline constexpr float kLeastScale = 1.0f, kLargestScale = 3.0f;

// A line in larger letters.
void title(const std::string& text);

// A word in its tone's colour with a mark of its own shape in front.
void badge(Tone tone, const std::string& word);

// Text that breaks at the window's edge.
void paragraph(const std::string& text);
void paragraph(Tone tone, const std::string& text);

// A button that says in its tooltip what it does or, when `obstacle` isn't empty, why it is
// disabled. Marked as landmark `name`. True when pressed.
bool button(const std::string& name, const std::string& label, const std::string& tooltip,
            const std::string& obstacle = {});

// The tooltip of the item drawn last, also of a disabled one.
void tooltip(const std::string& text);

}  // namespace bosk
