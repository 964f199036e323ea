#include "core/package/zstd_encode.h"

#include <zstd.h>

#include <algorithm>
#include <memory>
#include <new>

#include "core/base/error.h"

namespace bosk {
namespace {

constexpr int kLevel = 19;
constexpr std::size_t kChunkBytes = 1 << 15;

std::size_t checked(std::size_t result) {
  if (ZSTD_isError(result))
    throw Error("zstd: " + std::string(ZSTD_getErrorName(result)), ErrorKind::resource);
  return result;
}

}  // namespace

std::vector<std::byte> zstd_compress(std::span<const std::byte> raw, const Progress& progress) {
  const std::unique_ptr<ZSTD_CCtx, std::size_t (*)(ZSTD_CCtx*)> context(ZSTD_createCCtx(),
                                                                        ZSTD_freeCCtx);
  if (!context) throw std::bad_alloc();
  checked(ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, kLevel));
  checked(ZSTD_CCtx_setPledgedSrcSize(context.get(), raw.size()));
  std::vector<std::byte> packed(ZSTD_compressBound(raw.size()));
  ZSTD_outBuffer out{packed.data(), packed.size(), 0};
  for (std::size_t left = 1; left != 0;) {
    progress.check();
    const std::size_t taken = std::min(kChunkBytes, raw.size());
    const auto mode = taken == raw.size() ? ZSTD_e_end : ZSTD_e_continue;
    ZSTD_inBuffer in{raw.data(), taken, 0};
    const std::size_t rest = checked(ZSTD_compressStream2(context.get(), &out, &in, mode));
    raw = raw.subspan(in.pos);
    left = mode == ZSTD_e_end ? rest : 1;
  }
  packed.resize(out.pos);
  return packed;
}

}  // namespace bosk
