#include "core/project/calibration_run.h"

#include <algorithm>
#include <chrono>

#include "core/base/error.h"
#include "core/base/system_error.h"
#include "core/project/binary_items.h"
#include "core/project/calibration_store.h"
#include "core/project/left_out.h"

namespace bosk {
namespace {

constexpr const char* kEntry = "calibrate";
constexpr const char* kRefined = "calibrate-refined";
constexpr int kEntriesKept = 8;        // clicks come and go by undo
constexpr std::size_t kMostAlike = 3;  // sentences on features

bool is_within(const glm::dvec2& pixel, const PhotoSightings& photo) {
  return pixel.x >= -0.5 && pixel.y >= -0.5 && pixel.x <= photo.width_px - 0.5 &&
         pixel.y <= photo.height_px - 0.5;
}

void tell(const std::map<std::string, HandSighting>& told, PhotoSightings& photo,
          std::vector<std::string>& sentences) {
  std::erase_if(photo.sightings,
                [&](const Sighting& found) { return told.count(found.point) > 0; });
  for (const auto& [point, said] : told) {
    if (!said.there) continue;
    if (is_within(said.pixel, photo)) {
      photo.sightings.push_back({point, said.pixel, Sighting().sigma_px, SightedBy::click});
    } else {
      sentences.push_back("the click on " + printable(point) + " in " + printable(photo.photo) +
                          " is not used: it lies outside the photo; click it again");
    }
  }
}

void add_unread(const std::vector<UnreadPhoto>& unread, Calibration& calibration) {
  for (const UnreadPhoto& photo : unread) {
    PhotoFinding finding;
    finding.photo = photo.photo;
    finding.fate = PhotoFate::refused;
    finding.reason = photo.reason;
    calibration.photos.push_back(finding);
  }
  std::sort(calibration.photos.begin(), calibration.photos.end(),
            [](const auto& a, const auto& b) { return a.photo < b.photo; });
}

void append(const std::vector<std::string>& more, std::vector<std::string>& all) {
  all.insert(all.end(), more.begin(), more.end());
}

// The first few, and how many there are more.
std::vector<std::string> shortened(std::vector<std::string> sentences) {
  if (sentences.size() <= kMostAlike) return sentences;
  const std::size_t more = sentences.size() - kMostAlike;
  sentences.resize(kMostAlike);
  sentences.back() += " (and " + std::to_string(more) + " more such)";
  return sentences;
}

std::optional<Calibration> loaded(const char* entry_name, const ContentHash& key,
                                  const Cache& cache) {
  const auto entry = cache.load(entry_name, key);
  if (!entry) return std::nullopt;
  try {
    return read_all<Calibration>(entry->result, read_calibration);
  } catch (const Error&) {
    return std::nullopt;
  }
}

void keep(const char* entry_name, const ContentHash& key, const Calibration& calibration,
          double seconds, const Cache& cache) {
  BinaryWriter writer;
  write(writer, calibration);
  cache.store(entry_name, key, writer.bytes(), seconds);
  cache.forget_old(entry_name, key, kEntriesKept);
}

ContentHash refinement_key(const CalibrationSources& sources) {
  const ContentHash solved = calibration_key(sources);
  ContentHasher hasher;
  hasher.text(kRefined).text(sources.options.refine).value(solved.high).value(solved.low);
  return hasher.finish();
}

}  // namespace

std::vector<PhotoSightings> told_sightings(const CalibrationFinds& finds,
                                           const CalibrationSources& sources,
                                           std::vector<std::string>& sentences) {
  std::vector<PhotoSightings> photos = finds.photos;
  for (PhotoSightings& photo : photos) {
    const auto left_out = sources.left_out.find(photo.photo);
    if (left_out != sources.left_out.end()) leave_out(left_out->second, photo);
    const auto said = sources.sightings.find(photo.photo);
    if (said != sources.sightings.end()) tell(said->second, photo, sentences);
  }
  return photos;
}

Calibration solve_calibration(const CalibrationFinds& finds, const CalibrationSources& sources,
                              Progress& progress) {
  std::vector<std::string> sentences = finds.sentences;
  const auto photos = told_sightings(finds, sources, sentences);
  Survey survey = survey_of(sources.measurements);
  survey.bodies = finds.bodies;
  SolveOptions options;
  options.uncertain_crown_px = sources.options.uncertain_crown_px;
  options.first_poses = finds.first_poses;
  Calibration calibration = solve_cameras(photos, survey, finds.lens, options, progress);
  append(sentences, calibration.sentences);
  if (calibration.verdict != Verdict::good) {
    append(shortened(finds.feature_sentences), calibration.sentences);
  }
  append(sources.remarks, calibration.sentences);
  add_unread(finds.unread, calibration);
  return calibration;
}

std::optional<Calibration> stored_refinement(const CalibrationSources& sources,
                                             const Cache& cache) {
  return loaded(kRefined, refinement_key(sources), cache);
}

void store_refinement(const CalibrationSources& sources, const Calibration& calibration,
                      double seconds, const Cache& cache) {
  keep(kRefined, refinement_key(sources), calibration, seconds, cache);
}

std::optional<Calibration> stored_calibration(const CalibrationSources& sources,
                                              const Cache& cache) {
  const bool refined = sources.options.refine != "none";
  auto refinement = refined ? stored_refinement(sources, cache) : std::nullopt;
  return refinement ? refinement : loaded(kEntry, calibration_key(sources), cache);
}

void store_calibration(const CalibrationSources& sources, const Calibration& calibration,
                       double seconds, const Cache& cache) {
  keep(kEntry, calibration_key(sources), calibration, seconds, cache);
}

Calibration run_calibration(const CalibrationSources& sources, const Cache& cache,
                            Progress& progress) {
  if (auto stored = stored_calibration(sources, cache)) return *std::move(stored);
  const auto start = std::chrono::steady_clock::now();
  CalibrationFinds finds;
  {
    const ProgressPart part(progress, 0.0, 0.8);
    finds = find_for_calibration(sources, cache, progress);
  }
  const ProgressPart part(progress, 0.8, 1.0);
  Calibration calibration = solve_calibration(finds, sources, progress);
  progress.check();
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  store_calibration(sources, calibration, spent.count(), cache);
  return calibration;
}

std::string refusal_of(const Calibration& calibration) {
  const std::string why = calibration.sentences.empty() ? "" : ": " + calibration.sentences.front();
  return "no cameras could be found for the photos" + why;
}

void require_cameras(const Calibration& calibration) {
  if (calibration.verdict == Verdict::refused) throw Error(refusal_of(calibration));
}

}  // namespace bosk
