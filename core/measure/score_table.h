#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/measure/image_quality.h"

namespace bosk {

struct NamedScore {
  std::string name;  // of the view
  ViewScore score;
};

// `worst` takes each measure from the view where it is worst.
struct ScoreTable {
  std::vector<NamedScore> views;
  ViewScore mean, worst;
};
// At least one view.
ScoreTable tabulate(std::vector<NamedScore> views);

// Columns with four decimals, a line a view, then mean and worst.
std::string table_text(const ScoreTable& table);
// {"views": {NAME: {"psnr": ...}}, "mean": {...}, "worst": {...}}; null where a measure is not
// finite.
nlohmann::ordered_json table_json(const ScoreTable& table);

}  // namespace bosk
