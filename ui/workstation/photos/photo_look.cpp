#include "ui/workstation/photos/photo_look.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "core/base/error.h"
#include "ui/workstation/photos/decoder_pool.h"
#include "ui/workstation/photos/shelf_cache.h"

namespace bosk {
namespace fs = std::filesystem;
namespace {

constexpr int kMostAtOnce = 8;     // beyond that the disk is the limit
constexpr int kStoredBeside = 64;  // entries kept beside two for each photo

struct NewFile {
  fs::path file;
  FileStamp stamp;
  ContentHash key;
};

ShelvedPhoto read_one(const LookRequest& request, const NewFile& wanted, const Progress& progress) {
  const DecodeLimits limits = decode_limits(request.options);
  return request.decoders->with_decoder(limits, [&](PhotoDecoder& decoder) {
    ShelvedPhoto photo;
    photo.stamp = wanted.stamp;
    photo.facts = look_through(wanted.file, decoder, progress);
    if (photo.facts.trouble.empty()) {
      photo.thumbnail = std::make_shared<const Image<glm::u8vec4>>(
          shown_photo(photo.facts.decoded, kThumbnailPx));
    }
    photo.facts.decoded.pixels = {};
    return photo;
  });
}

// Files that neither the window nor the cache knows; what the cache knows goes into `look`.
std::vector<NewFile> new_files(const LookRequest& request, const Cache& cache, Look& look) {
  std::vector<NewFile> news;
  for (const auto& [name, file] : request.photos) {
    const auto stamp = stamp_of(file);
    const auto known = request.known.find(file);
    if (!stamp) {
      look.missing.insert(file);
    } else if (known == request.known.end() || known->second != *stamp) {
      const ContentHash key = shelf_key(name, *stamp, request.options);
      if (auto stored = load_shelved(cache, key, file, *stamp)) {
        look.read[file] = std::move(*stored);
      } else {
        news.push_back({file, *stamp, key});
      }
    }
  }
  return news;
}

void store(const Cache& cache, const std::vector<NewFile>& files,
           const std::vector<ShelvedPhoto>& photos, int kept, Progress& progress) {
  if (photos.empty()) return;
  try {
    for (std::size_t i = 0; i < photos.size(); ++i) store_shelved(cache, files[i].key, photos[i]);
    forget_shelved(cache, files.front().key, kept);
  } catch (const Error& error) {
    progress.warn(error.what());  // they are only read again when the project is opened again
  }
}

// Tells of the photo that is read now, of all.
void begin(Progress& progress, std::size_t all, std::size_t left, std::size_t now) {
  const std::size_t done = all - left;
  const double share = 1.0 / double(std::max<std::size_t>(1, all));
  progress.begin("photo " + std::to_string(std::min(done + 1, all)) + " of " + std::to_string(all),
                 std::max<std::size_t>(1, now), share * double(done), share * double(done + now));
}

}  // namespace

Look look_through(const LookRequest& request, Progress& progress) {
  const Cache cache(request.cache_folder);
  const std::size_t all = request.photos.size();
  Look look;
  const std::vector<NewFile> news = new_files(request, cache, look);
  const int at_once = std::clamp(tbb::this_task_arena::max_concurrency(), 2, kMostAtOnce);
  const std::size_t now = std::min(news.size(), std::size_t(at_once));
  look.left = news.size() - now;
  begin(progress, all, news.size(), now);
  std::vector<ShelvedPhoto> read(now);
  tbb::parallel_for(std::size_t(0), now, [&](std::size_t i) {
    tbb::this_task_arena::isolate([&] { read[i] = read_one(request, news[i], progress); });
    progress.advance();
  });
  store(cache, news, read, int(2 * all) + kStoredBeside, progress);
  for (std::size_t i = 0; i < now; ++i) look.read[news[i].file] = std::move(read[i]);
  return look;
}

}  // namespace bosk
