#pragma once

#include <array>
#include <string>

namespace bosk {

// The way from photographs to package, in order.
enum class WorkStep { photos, calibrate, matte, volume, textures, codebook, preview, export_tree };

inline constexpr std::array kSteps = {WorkStep::photos,  WorkStep::calibrate,  WorkStep::matte,
                                      WorkStep::volume,  WorkStep::textures,   WorkStep::codebook,
                                      WorkStep::preview, WorkStep::export_tree};

struct StepText {
  const char* name;     // on the screen
  const char* id;       // in landmarks
  const char* purpose;  // one line
};
const StepText& text_of(WorkStep step);

}  // namespace bosk
