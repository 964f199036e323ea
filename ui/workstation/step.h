#pragma once

#include <array>
#include <string>

namespace bosk {

// The way from photographs to package, in order.
enum class Step { photos, calibrate, matte, volume, textures, codebook, preview, export_tree };

inline constexpr std::array kSteps = {Step::photos,   Step::calibrate, Step::matte,
                                      Step::volume,   Step::textures,  Step::codebook,
                                      Step::preview,  Step::export_tree};

struct StepText {
  const char* name;     // on the screen
  const char* id;       // in landmarks
  const char* purpose;  // one line
};
const StepText& text_of(Step step);

}  // namespace bosk
