// Each array is one zstd frame with a checksum. The size in the head of the frame is checked before memory is
// allocated, because the origin of a store is unknown. packed_content() unpacks in parts and keeps none of them.
#include "campaign/store/packing.h"

#include <zstd.h>

#include <bit>
#include <memory>

#include "campaign/store/database.h"
#include "core/hash.h"
#include "wythe/parts/error.h"

namespace wythe::study {
namespace {

static_assert(std::endian::native == std::endian::little, "packed arrays are little-endian");

// zstd's own default: 2 ms for a sample of the tuff wall with four states, to a quarter of its size.
constexpr int kLevel = 3;

struct FreeContext {
  void operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
};

std::string compressed(const void* bytes, std::size_t count) {
  const std::unique_ptr<ZSTD_CCtx, FreeContext> context(ZSTD_createCCtx());
  if (!context) throw std::bad_alloc();
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, kLevel);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 1);
  std::string out(ZSTD_compressBound(count), '\0');
  const std::size_t size = ZSTD_compress2(context.get(), out.data(), out.size(), bytes, count);
  if (ZSTD_isError(size) != 0) throw IoError(ZSTD_getErrorName(size));
  out.resize(size);
  return out;
}

[[noreturn]] void refuse(const std::string& what, const std::string& problem) {
  throw IoError(what + " is damaged in the store: " + problem + "; " + kCureOfDamage);
}

template <class Number>
std::vector<Number> decompressed(std::string_view bytes, std::size_t count,
                                 const std::string& what) {
  const std::size_t wanted = count * sizeof(Number);
  if (ZSTD_getFrameContentSize(bytes.data(), bytes.size()) != wanted)
    refuse(what, "it does not hold " + std::to_string(count) + " numbers");
  std::vector<Number> numbers(count);
  const std::size_t size = ZSTD_decompress(numbers.data(), wanted, bytes.data(), bytes.size());
  if (ZSTD_isError(size) != 0) refuse(what, "its bytes are not what was packed");
  if (size != wanted) refuse(what, "it ends early");
  return numbers;
}

}  // namespace

std::string pack_doubles(std::span<const double> numbers) {
  return compressed(numbers.data(), numbers.size_bytes());
}

std::string pack_floats(std::span<const double> numbers) {
  std::vector<float> narrow;
  narrow.reserve(numbers.size());
  for (const double number : numbers) narrow.push_back(static_cast<float>(number));
  return compressed(narrow.data(), narrow.size() * sizeof(float));
}

std::vector<double> unpack_doubles(std::string_view bytes, std::size_t count,
                                   const std::string& what) {
  return decompressed<double>(bytes, count, what);
}

std::vector<double> unpack_floats(std::string_view bytes, std::size_t count,
                                  const std::string& what) {
  const std::vector<float> narrow = decompressed<float>(bytes, count, what);
  return {narrow.begin(), narrow.end()};
}

PackedContent packed_content(std::string_view bytes, const std::string& what) {
  Hash hash;
  std::uint64_t total = 0;
  struct FreeStream {
    void operator()(ZSTD_DStream* stream) const { ZSTD_freeDStream(stream); }
  };
  const std::unique_ptr<ZSTD_DStream, FreeStream> stream(ZSTD_createDStream());
  if (!stream) throw std::bad_alloc();
  std::vector<char> part(ZSTD_DStreamOutSize());
  ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
  std::size_t left = 1;
  while (left != 0 && in.pos < in.size) {
    ZSTD_outBuffer out{part.data(), part.size(), 0};
    left = ZSTD_decompressStream(stream.get(), &out, &in);
    if (ZSTD_isError(left) != 0) refuse(what, ZSTD_getErrorName(left));
    hash.add(part.data(), out.pos);
    total += out.pos;
  }
  if (left != 0) refuse(what, "it ends early");
  return {hash.value(), total};
}

}  // namespace wythe::study
