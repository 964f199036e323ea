#include "core/calibrate/colour_words.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "core/calibrate/ball_colour.h"
#include "core/image/colour.h"

namespace bosk {
namespace {

struct ColourWord {
  const char* word;
  glm::vec3 srgb;  // 0 to 255
};

constexpr std::array<ColourWord, 14> kWords{{{"red", {214, 24, 24}},
                                             {"orange", {246, 120, 10}},
                                             {"yellow", {244, 214, 10}},
                                             {"lime", {160, 220, 20}},
                                             {"green", {20, 150, 50}},
                                             {"turquoise", {20, 190, 150}},
                                             {"cyan", {10, 196, 214}},
                                             {"light blue", {80, 150, 240}},
                                             {"blue", {22, 60, 214}},
                                             {"violet", {110, 30, 200}},
                                             {"magenta", {222, 24, 170}},
                                             {"pink", {250, 120, 170}},
                                             {"brown", {120, 70, 30}},
                                             {"purple", {110, 20, 110}}}};

struct Match {
  const char* word = "";
  glm::vec3 reference{0.0f};
  float distance = 0.0f;
};

// Lightness counts little: it follows the exposure.
float difference(const glm::vec3& a, const glm::vec3& b) {
  return glm::length((a - b) * glm::vec3(1.0f, 1.0f, 0.4f));
}

Match nearest_word(const glm::vec3& colour) {
  Match best;
  for (const ColourWord& word : kWords) {
    const glm::vec3 reference = saturation_from_lab(lab_from_srgb(word.srgb / 255.0f));
    const float distance = difference(colour, reference);
    if (*best.word == '\0' || distance < best.distance) best = {word.word, reference, distance};
  }
  return best;
}

std::string free_name(const Match& match, const glm::vec3& colour,
                      const std::vector<std::string>& taken) {
  const auto is_free = [&](const std::string& name) {
    return std::find(taken.begin(), taken.end(), name) == taken.end();
  };
  if (is_free(match.word)) return match.word;
  const std::string shaded =
      (colour.z < match.reference.z ? "dark " : "bright ") + std::string(match.word);
  if (is_free(shaded)) return shaded;
  for (int number = 2;; ++number) {
    const std::string numbered = std::string(match.word) + " " + std::to_string(number);
    if (is_free(numbered)) return numbered;
  }
}

}  // namespace

std::vector<std::string> colour_words(std::span<const glm::vec3> colours) {
  std::vector<Match> matches;
  for (const glm::vec3& colour : colours) matches.push_back(nearest_word(colour));
  std::vector<std::size_t> order(colours.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return matches[a].distance < matches[b].distance;
  });
  std::vector<std::string> names(colours.size()), taken;
  for (const std::size_t index : order) {
    names[index] = free_name(matches[index], colours[index], taken);
    taken.push_back(names[index]);
  }
  return names;
}

}  // namespace bosk
