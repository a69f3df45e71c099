// Packs bytes in the format of zlib (RFC 1950), and unpacks them piece by piece. The program uses
// zlib; the engine for browsers stores the bytes unpacked in that format (src/wasm/stored.cpp).
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace wythe::report {

[[nodiscard]] std::string deflated(const std::string& bytes);

// Uses `packed` as long as it lives; the caller keeps the bytes.
class Inflater {
 public:
  explicit Inflater(std::string_view packed);
  ~Inflater();
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  // Fills `to` with the next bytes. Returns their number, less than its size where the data end or are damaged.
  std::size_t read(std::string& to);
  // Whether the data are at their end, with a correct checksum.
  [[nodiscard]] bool ended() const;

 private:
  struct Stream;
  std::unique_ptr<Stream> stream_;
};

}  // namespace wythe::report
