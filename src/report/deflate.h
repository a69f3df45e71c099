// Bytes packed as zlib does (RFC 1950), and unpacked bit by bit. The program has zlib for it; the engine for browsers stores the
// bytes unpacked in that format (src/wasm/stored.cpp).
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace wythe::report {

[[nodiscard]] std::string deflated(const std::string& bytes);

// Takes `packed` as long as it lives; the caller keeps the bytes.
class Inflater {
 public:
  explicit Inflater(std::string_view packed);
  ~Inflater();
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  // Fills `to` with the next bytes; how many, fewer than its size where the data end or are damaged.
  std::size_t read(std::string& to);
  // Whether the data came to their end, with the right sum of control.
  [[nodiscard]] bool ended() const;

 private:
  struct Stream;
  std::unique_ptr<Stream> stream_;
};

}  // namespace wythe::report
