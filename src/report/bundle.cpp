#include "report/bundle.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "wythe/error.h"

namespace wythe::report {
namespace {

static_assert(std::endian::native == std::endian::little, "arrays are stored as they lie");

constexpr char kMark[8] = {'W', 'Y', 'T', 'H', 'E', 0, 0, 1};  // the last byte is the version
constexpr std::size_t kHead = sizeof kMark + sizeof(std::uint32_t);
constexpr std::size_t kAlign = 8;

[[noreturn]] void refuse(const std::string& what) {
  throw IoError("the data of a report " + what + "; run the model again to write them anew");
}

std::string deflated(const std::string& bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string out(size, '\0');
  const int code = compress2(reinterpret_cast<Bytef*>(out.data()), &size,
                             reinterpret_cast<const Bytef*>(bytes.data()),
                             static_cast<uLong>(bytes.size()), Z_BEST_COMPRESSION);
  if (code != Z_OK) throw IoError("out of memory while packing the report's data");
  out.resize(size);
  return out;
}

std::string inflated(std::string_view packed) {
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK) throw IoError("out of memory while reading the report's data");
  std::string out, chunk(1 << 18, '\0');
  // zlib takes the input as const in effect only
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  int code = Z_OK;
  while (code == Z_OK) {
    stream.next_out = reinterpret_cast<Bytef*>(chunk.data());
    stream.avail_out = static_cast<uInt>(chunk.size());
    code = inflate(&stream, Z_NO_FLUSH);
    out.append(chunk.data(), chunk.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  if (code != Z_STREAM_END) refuse("are damaged");
  return out;
}

}  // namespace

void Bundle::place(const std::string& name, const char* type, std::size_t count,
                   std::span<const std::byte> bytes) {
  table_[name] = {{"type", type}, {"at", arrays_.size()}, {"count", count}};
  arrays_.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  arrays_.resize((arrays_.size() + kAlign - 1) / kAlign * kAlign, '\0');
}

void Bundle::add(const std::string& name, std::span<const float> values) {
  place(name, "float32", values.size(), std::as_bytes(values));
}

void Bundle::add(const std::string& name, std::span<const std::int32_t> values) {
  place(name, "int32", values.size(), std::as_bytes(values));
}

void Bundle::add(const std::string& name, std::span<const std::uint8_t> values) {
  place(name, "uint8", values.size(), std::as_bytes(values));
}

void Bundle::add_rounded(const std::string& name, std::span<const double> values) {
  constexpr double kMost = 32767;
  double largest = 0;
  for (double v : values)
    if (std::isfinite(v)) largest = std::max(largest, std::fabs(v));
  const double step = largest > 0 ? largest / kMost : 1;
  std::vector<std::int16_t> rounded;
  rounded.reserve(values.size());
  for (double v : values)
    rounded.push_back(std::isfinite(v) ? static_cast<std::int16_t>(std::lround(v / step)) : 0);
  place(name, "int16", rounded.size(), std::as_bytes(std::span(rounded)));
  table_[name]["step"] = step;
}

std::string Bundle::packed() const {
  Json whole = header;
  whole["arrays"] = table_;
  // replace: a name that is not UTF-8 must not lose the page
  std::string text = whole.dump(-1, ' ', false, Json::error_handler_t::replace);
  text.append((kAlign - (kHead + text.size()) % kAlign) % kAlign, ' ');
  const auto length = static_cast<std::uint32_t>(text.size());
  std::string bytes(kMark, sizeof kMark);
  bytes.append(reinterpret_cast<const char*>(&length), sizeof length);
  return deflated(bytes + text + arrays_);
}

std::uint8_t share_byte(double share) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
}

Json header_of(std::string_view packed) {
  const std::string bytes = inflated(packed);
  if (bytes.size() < kHead || std::memcmp(bytes.data(), kMark, 5) != 0) refuse("are damaged");
  if (std::memcmp(bytes.data(), kMark, sizeof kMark) != 0)
    refuse("were written by another version of wythe");
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data() + sizeof kMark, sizeof length);
  if (bytes.size() < kHead + length) refuse("are damaged");
  Json header = Json::parse(bytes.substr(kHead, length), nullptr, false);
  if (!header.is_object() || !header.contains("kind")) refuse("are damaged");
  return header;
}

}  // namespace wythe::report
