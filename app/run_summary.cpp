#include "app/run_summary.h"

#include <nlohmann/json.hpp>

#include "core/base/number_text.h"

namespace bosk {

std::string times_text(const std::vector<StageTime>& times) {
  std::string text;
  for (const StageTime& time : times) {
    if (time.from_cache) continue;
    text += (text.empty() ? "; " : ", ") + time.stage + " " + number_text(time.seconds, 1) + " s";
  }
  return text;
}

nlohmann::json times_json(const std::vector<StageTime>& times) {
  nlohmann::json all = nlohmann::json::array();
  for (const StageTime& time : times) {
    all.push_back(
        {{"stage", time.stage}, {"seconds", time.seconds}, {"from_cache", time.from_cache}});
  }
  return all;
}

}  // namespace bosk
