#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/project/evaluation.h"
#include "core/project/project.h"

namespace bosk {

// All figures of an evaluation: scores of each view, mean and worst, size, levels and times.
std::string figures_text(const Evaluation& evaluation);
nlohmann::ordered_json figures_json(const Evaluation& evaluation);

// Writes contact-sheet.png, figures.txt, figures.json, and report.html, which shows them all by
// itself.
void write_report(const std::filesystem::path& folder, const Evaluation& evaluation,
                  const Project& project);

}  // namespace bosk
