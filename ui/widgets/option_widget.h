#pragma once

#include "core/base/options.h"

namespace bosk {

// The widget that edits one option: its range, unit and help are the description's. A double range
// that spans more than a factor of 100 is logarithmic. Returns whether the value changed.
bool draw_option(const Option& option);

}  // namespace bosk
