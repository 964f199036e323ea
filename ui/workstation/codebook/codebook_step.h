#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/package/codebook_curve.h"
#include "core/project/stages.h"
#include "ui/widgets/image_view.h"
#include "ui/workstation/mailbox.h"

namespace bosk {

struct Workspace;

// What the step remembers between frames.
struct CodebookStepState {
  // The curve as far as it is known, of which billboards; null: none yet.
  std::shared_ptr<const std::vector<CodebookPoint>> curve;
  std::shared_ptr<const Billboards> curve_of;
  std::shared_ptr<Mailbox<std::vector<CodebookPoint>>> growing;
  int curve_job = 0;
  bool of_colours = true;             // else of alphas: which codewords are chosen and shown
  std::optional<int> codewords_held;  // under the hand, not yet an edit

  int level = -1;       // as TexturesStepState::level
  int view = 0;         // of the sheets of textures
  bool as_gpu = false;  // codewords as BC3 gives them
  // The atlas as BC3 gives it, of which textures.
  std::shared_ptr<const std::vector<glm::u8vec4>> bc3_atlas;
  std::shared_ptr<const CodedTextures> bc3_of;
  ImageView codewords_view, textures_view;
};

void draw_codebook_step(Workspace& workspace);

// The codebooks' codewords, and textures beside what they give: codebook_views.cpp.
void draw_codebook_views(Workspace& workspace);

}  // namespace bosk
