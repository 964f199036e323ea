#include "ui/workstation/work_step.h"

namespace bosk {

const StepText& text_of(WorkStep step) {
  static constexpr StepText kTexts[] = {
      {"Photos", "photos", "The photographs, and whether each can be used."},
      {"Calibrate", "calibrate", "Where each photograph was taken from, and with what lens."},
      {"Matte", "matte", "What in each photograph is the tree."},
      {"Volume", "volume", "How opaque and how coloured every place of the crown is."},
      {"Textures", "textures", "Billboards at every level of detail, towards many viewpoints."},
      {"Codebook", "codebook", "How much may be saved before it shows."},
      {"Preview", "preview", "The finished tree, alone, in a forest, and beside its photographs."},
      {"Export", "export", "The package, pictures and a report."},
  };
  return kTexts[int(step)];
}

}  // namespace bosk
