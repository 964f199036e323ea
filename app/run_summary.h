#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/project/run.h"

namespace bosk {

// "; opacity 12.1 s, radiance 40.0 s": of the stages that were computed, empty when none was.
std::string times_text(const std::vector<StageTime>& times);
nlohmann::json times_json(const std::vector<StageTime>& times);

}  // namespace bosk
