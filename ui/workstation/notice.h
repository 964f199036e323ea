#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "ui/widgets/theme.h"

namespace bosk {

// What a step tells of the last thing that was asked of it.
struct Notice {
  Tone tone = Tone::neutral;
  std::string text;
};
using Notices = std::vector<Notice>;

inline void draw_notices(const Notices& notices) {
  for (const Notice& notice : notices) paragraph(notice.tone, notice.text);
}

// Runs `step`; what it can't do is told.
template <class Step>
bool done_or_told(Notices& notices, const Step& step) {
  try {
    step();
    return true;
  } catch (const Error& error) {
    notices.push_back({Tone::bad, error.what()});
    return false;
  }
}

}  // namespace bosk
