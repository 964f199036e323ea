#include "app/run_summary.h"

#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>

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

std::string size_text(std::size_t bytes) {
  const double size = double(bytes);
  if (size < 1024.0 * 1024.0) return number_text(size / 1024.0, 1) + " KiB";
  return number_text(size / (1024.0 * 1024.0), 2) + " MiB";
}

std::string number_text(double number, int digits) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", digits, number);
  return text.data();
}

}  // namespace bosk
