// Bytes in the format of zlib without compression (stored blocks of RFC 1951). So browsers can
// unpack the page's data as usual, and no library is needed. Only such blocks can be read back.
#include <algorithm>
#include <cstdint>
#include <cstring>

#include "report/deflate.h"

namespace wythe::report {
namespace {

constexpr std::size_t kMostInBlock = 65535;

std::uint32_t adler32(std::string_view bytes, std::uint32_t sum = 1) {
  std::uint32_t a = sum & 0xffff, b = sum >> 16;
  for (const char byte : bytes) {
    a = (a + static_cast<unsigned char>(byte)) % 65521;
    b = (b + a) % 65521;
  }
  return (b << 16) | a;
}

void append(std::string& to, std::uint32_t bits, int bytes) {
  for (int k = 0; k < bytes; ++k) to.push_back(static_cast<char>(bits >> (8 * k)));
}

}  // namespace

std::string deflated(const std::string& bytes) {
  std::string out = "\x78\x01";
  std::size_t at = 0;
  do {
    const std::size_t count = std::min(kMostInBlock, bytes.size() - at);
    out.push_back(at + count == bytes.size() ? 1 : 0);
    append(out, static_cast<std::uint32_t>(count), 2);
    append(out, ~static_cast<std::uint32_t>(count), 2);
    out.append(bytes, at, count);
    at += count;
  } while (at < bytes.size());
  const std::uint32_t sum = adler32(bytes);
  for (int k = 3; k >= 0; --k) out.push_back(static_cast<char>(sum >> (8 * k)));
  return out;
}

struct Inflater::Stream {
  std::string_view rest;
  std::size_t left = 0;  // in the present block
  bool is_last = false, ended = false;
  std::uint32_t sum = 1;

  [[nodiscard]] std::uint32_t byte(std::size_t k) const {
    return static_cast<unsigned char>(rest[k]);
  }
  // Moves to a block that has bytes; false at the end or where a block is not stored.
  bool begin_block() {
    while (left == 0) {
      if (is_last) {
        ended = rest.size() >= 4 &&
                sum == ((byte(0) << 24) | (byte(1) << 16) | (byte(2) << 8) | byte(3));
        return false;
      }
      if (rest.size() < 5 || byte(0) > 1) return false;
      is_last = byte(0) == 1;
      left = byte(1) | (byte(2) << 8);
      rest.remove_prefix(5);
    }
    return true;
  }
};

Inflater::Inflater(std::string_view packed) : stream_(std::make_unique<Stream>()) {
  if (packed.size() > 2) stream_->rest = packed.substr(2);
}

Inflater::~Inflater() = default;

std::size_t Inflater::read(std::string& to) {
  Stream& s = *stream_;
  std::size_t done = 0;
  while (done < to.size() && s.begin_block()) {
    const std::size_t count = std::min({to.size() - done, s.left, s.rest.size()});
    if (count == 0) break;
    std::memcpy(to.data() + done, s.rest.data(), count);
    s.sum = adler32(s.rest.substr(0, count), s.sum);
    s.rest.remove_prefix(count), s.left -= count, done += count;
  }
  return done;
}

bool Inflater::ended() const { return stream_->ended; }

}  // namespace wythe::report
