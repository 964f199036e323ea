#include "core/project/each_photo.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

namespace bosk {
namespace {

// A decoded photo takes 16 bytes a pixel: more at once would take memory, not time.
constexpr int kMaxPhotosAtOnce = 8;

}  // namespace

void for_each_photo(std::size_t count, const DecodeLimits& limits, Progress& progress,
                    const std::function<void(std::size_t, PhotoDecoder&)>& work) {
  tbb::enumerable_thread_specific<PhotoDecoder> decoders(limits);
  const int at_once = std::min(kMaxPhotosAtOnce, tbb::this_task_arena::max_concurrency());
  tbb::task_arena arena(std::max(1, at_once));
  arena.execute([&] {
    tbb::parallel_for(std::size_t(0), count, [&](std::size_t i) {
      // Isolated, so that a thread that waits for a part of one photo doesn't begin another
      tbb::this_task_arena::isolate([&] { work(i, decoders.local()); });
      progress.advance();
    });
  });
}

}  // namespace bosk
