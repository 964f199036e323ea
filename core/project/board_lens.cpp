#include "core/project/board_lens.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <utility>

#include "core/base/error.h"
#include "core/base/system_error.h"
#include "core/photo/import.h"
#include "core/project/binary_items.h"
#include "core/project/calibration_store.h"

namespace bosk {
namespace {

constexpr int kVersion = 1;  // raised whenever the same board photos give another lens
constexpr const char* kEntry = "boards";
constexpr int kEntriesKept = 4;

ContentHash key_of(const CalibrationSources& sources) {
  ContentHasher hasher;
  hasher.text(kEntry).value(kVersion);
  hash_files(hasher, sources.boards);
  CalibrateOptions options = sources.options;
  for (const Option& option : describe(options)) {
    const bool counts = option.name.rfind("board", 0) == 0 || option.name == "lens_model";
    if (counts) hasher.text(option.name).text(value_text(option));
  }
  return hasher.finish();
}

std::optional<LensCalibration> kept_calibration(const CalibrationSources& sources,
                                                const Cache& cache) {
  const auto entry = cache.load(kEntry, key_of(sources));
  if (!entry) return std::nullopt;
  try {
    return read_all<LensCalibration>(entry->result, read_lens_calibration);
  } catch (const Error&) {
    return std::nullopt;
  }
}

std::vector<BoardView> views_of(const std::vector<PhotoFinds>& photos) {
  std::vector<BoardView> views;
  for (const PhotoFinds& photo : photos) {
    if (!photo.trouble.empty()) continue;
    views.push_back({photo.name, photo.width_px, photo.height_px, photo.taken_with, photo.corners});
  }
  return views;
}

LensCalibration made_calibration(const CalibrationSources& sources, const Cache& cache,
                                 Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  const BoardShape shape = board_of(sources.options);
  std::vector<BoardView> views;
  {
    const ProgressPart part(progress, 0.0, 0.7);
    views =
        views_of(find_in_photos(sources.boards, {{}, {}, shape}, sources.limits, cache, progress));
  }
  const ProgressPart part(progress, 0.7, 1.0);
  LensCalibration calibration = calibrate_lens(views, shape, sources.options.board_lens, progress);
  BinaryWriter writer;
  write(writer, calibration);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  cache.store(kEntry, key_of(sources), writer.bytes(), spent.count());
  cache.forget_old(kEntry, key_of(sources), kEntriesKept);
  return calibration;
}

// A photo of the size that most have; of two as frequent the one that comes first by name.
const PhotoFinds& typical_photo(const std::vector<PhotoFinds>& photos) {
  std::map<std::pair<int, int>, int> counts;
  for (const PhotoFinds& photo : photos) ++counts[{photo.width_px, photo.height_px}];
  return *std::max_element(photos.begin(), photos.end(), [&](const auto& a, const auto& b) {
    return counts[{a.width_px, a.height_px}] < counts[{b.width_px, b.height_px}];
  });
}

// EXIF's focal length that lies in the middle; without any 1.2 times the longer side.
Lens guessed_from_exif(const std::vector<PhotoFinds>& photos, const PhotoFinds& typical) {
  DecodedPhoto size_alone;
  size_alone.width_px = typical.width_px;
  size_alone.height_px = typical.height_px;
  Lens lens = guessed_lens(size_alone);
  std::vector<double> focals;
  for (const PhotoFinds& photo : photos) {
    const bool typical_size =
        photo.width_px == typical.width_px && photo.height_px == typical.height_px;
    if (typical_size && photo.exif_focal_px) focals.push_back(*photo.exif_focal_px);
  }
  if (focals.empty()) return lens;
  const auto middle = focals.begin() + std::ptrdiff_t(focals.size() / 2);
  std::nth_element(focals.begin(), middle, focals.end());
  lens.focal_px = glm::dvec2(*middle);
  return lens;
}

// The profile's lens for the photos; none, with a sentence, where it doesn't fit them.
std::optional<Lens> fitting_lens(const LensProfile& profile, const PhotoFinds& photo,
                                 std::vector<std::string>& sentences) {
  try {
    return lens_for_photo(profile, photo.taken_with, photo.width_px, photo.height_px);
  } catch (const Error& error) {
    sentences.push_back(std::string("the lens of the board photos is not used: ") + error.what());
    return std::nullopt;
  }
}

std::optional<Lens> lens_of_boards(const LensCalibration& boards, const PhotoFinds& photo,
                                   std::vector<std::string>& sentences) {
  if (boards.verdict != Verdict::good) {
    for (const std::string& sentence : boards.sentences) {
      sentences.push_back("board photos: " + sentence);
    }
  }
  if (boards.verdict == Verdict::refused) return std::nullopt;
  return fitting_lens(boards.profile, photo, sentences);
}

std::optional<Lens> calibrated_lens(const CalibrationSources& sources, const PhotoFinds& photo,
                                    LensChoice& choice) {
  if (sources.profile) {
    const LensProfile profile = read_lens_profile(sources.profile->path);
    return lens_for_photo(profile, photo.taken_with, photo.width_px, photo.height_px);
  }
  if (!choice.boards) return std::nullopt;
  return lens_of_boards(*choice.boards, photo, choice.sentences);
}

}  // namespace

LensChoice choose_lens(const CalibrationSources& sources, const std::vector<PhotoFinds>& photos,
                       const Cache& cache, Progress& progress) {
  LensChoice choice;
  if (!sources.boards.empty()) {
    choice.boards = kept_calibration(sources, cache);
    if (!choice.boards) choice.boards = made_calibration(sources, cache, progress);
  }
  const PhotoFinds& typical = typical_photo(photos);
  const auto lens = calibrated_lens(sources, typical, choice);
  choice.knowledge.lens = lens ? *lens : guessed_from_exif(photos, typical);
  choice.knowledge.known = lens.has_value() && sources.options.lens != "free";
  if (sources.options.lens == "known" && !lens) {
    throw Error(
        "the lens is not known: give photos of a board with `bosk calibrate --boards DIR`, or a "
        "profile with --lens, or set calibrate.lens to auto" +
        (choice.sentences.empty() ? "" : "; " + choice.sentences.front()));
  }
  return choice;
}

}  // namespace bosk
