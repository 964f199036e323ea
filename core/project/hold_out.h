#pragma once

#include <set>
#include <string>

#include "core/project/capture.h"

namespace bosk {

// Every n-th photo, beginning with the n-th, to be left out and judged by. Photos that strokes were
// drawn on are passed over: the others' mattes are made from them. Throws Error when none would be
// held out or fewer than two kept.
std::set<std::string> held_out_names(const Capture& capture, int every);

// The same capture where only the photos of these names are kept.
Capture with_only(const Capture& capture, const std::set<std::string>& names);

}  // namespace bosk
