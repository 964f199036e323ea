#include "ui/workstation/calibrate/point_colours.h"

#include <cstdint>
#include <iterator>

namespace bosk {
namespace {

struct NamedColour {
  const char* word;
  glm::vec3 srgb;
};
constexpr NamedColour kNamed[] = {
    {"red", {0.95f, 0.25f, 0.20f}},       {"orange", {1.00f, 0.58f, 0.10f}},
    {"yellow", {0.97f, 0.90f, 0.20f}},    {"lime", {0.65f, 0.95f, 0.25f}},
    {"green", {0.20f, 0.80f, 0.30f}},     {"cyan", {0.20f, 0.90f, 0.90f}},
    {"turquoise", {0.20f, 0.85f, 0.75f}}, {"blue", {0.30f, 0.50f, 1.00f}},
    {"violet", {0.62f, 0.40f, 1.00f}},    {"purple", {0.70f, 0.35f, 0.85f}},
    {"magenta", {1.00f, 0.30f, 0.85f}},   {"pink", {1.00f, 0.60f, 0.75f}},
    {"brown", {0.65f, 0.42f, 0.25f}},     {"white", {1.00f, 1.00f, 1.00f}},
};
// Okabe and Ito's (2008), but for black.
constexpr glm::vec3 kPalette[] = {
    {0.90f, 0.62f, 0.00f}, {0.34f, 0.71f, 0.91f}, {0.00f, 0.75f, 0.55f}, {0.94f, 0.89f, 0.26f},
    {0.35f, 0.60f, 0.90f}, {0.95f, 0.45f, 0.18f}, {0.80f, 0.47f, 0.65f}};

constexpr float kLighter = 0.4f, kDarker = 0.65f;

bool has_word(const std::string& name, const std::string& word) {
  const auto at = name.find(word);
  if (at == std::string::npos) return false;
  const auto end = at + word.size();
  return (at == 0 || name[at - 1] == ' ') && (end == name.size() || name[end] == ' ');
}

// FNV-1a: the standard library's hash may differ from one to another.
std::uint32_t number_of(const std::string& name) {
  std::uint32_t hash = 2166136261u;
  for (const char letter : name) hash = (hash ^ std::uint8_t(letter)) * 16777619u;
  return hash;
}

}  // namespace

glm::vec3 colour_of_point(const std::string& name) {
  for (const NamedColour& colour : kNamed) {
    if (!has_word(name, colour.word)) continue;
    if (has_word(name, "light")) return glm::mix(colour.srgb, glm::vec3(1.0f), kLighter);
    if (has_word(name, "dark")) return kDarker * colour.srgb;
    return colour.srgb;
  }
  return kPalette[number_of(name) % std::size(kPalette)];
}

}  // namespace bosk
