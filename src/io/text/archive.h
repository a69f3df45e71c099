// Writes values one after the other, and reads them back in the same order. A type
// needs one description of its parts for both directions (`archive(part)` for each).
//
// Input is not trusted: a count is compared with the remaining bytes
// before it is used, and a list grows only as values are read.
#pragma once

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace wythe::io {

// The fault of the bytes, in one clause.
class Damaged : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

template <class T>
concept Plain =
    std::is_trivially_copyable_v<T> && !std::is_same_v<T, bool> && !std::is_pointer_v<T>;

class ArchiveOut {
 public:
  static constexpr bool kReads = false;

  template <Plain T>
  void operator()(const T& value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void operator()(bool value) { (*this)(static_cast<std::uint8_t>(value)); }
  void operator()(const std::string& text) {
    (*this)(static_cast<std::uint64_t>(text.size()));
    bytes_ += text;
  }
  template <class T, class Each>
  void list(const std::vector<T>& items, const Each& each) {
    (*this)(static_cast<std::uint64_t>(items.size()));
    for (const T& item : items) each(item);
  }
  // A list of so many items.
  template <Plain T>
  void array(const std::vector<T>& items, std::size_t count) {
    if (items.size() != count)
      throw std::logic_error("an array of another length than its model's");
    bytes_.append(reinterpret_cast<const char*>(items.data()), count * sizeof(T));
  }
  void require(bool /*holds*/, const char* /*otherwise*/) {}

  [[nodiscard]] std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

class ArchiveIn {
 public:
  static constexpr bool kReads = true;
  explicit ArchiveIn(std::string_view bytes) : left_(bytes) {}

  template <Plain T>
  void operator()(T& value) {
    std::memcpy(&value, taken(sizeof value).data(), sizeof value);
  }
  void operator()(bool& value) {
    std::uint8_t byte = 0;
    (*this)(byte);
    require(byte <= 1, "a yes or no is neither");
    value = byte == 1;
  }
  void operator()(std::string& text) { text = taken(count()); }
  template <class T, class Each>
  void list(std::vector<T>& items, const Each& each) {
    items.clear();
    for (std::uint64_t more = count(); more > 0; --more) each(items.emplace_back());
  }
  template <Plain T>
  void array(std::vector<T>& items, std::size_t count) {
    require(count <= left_.size() / sizeof(T), "it ends within an array");
    items.resize(count);
    if (count > 0) std::memcpy(items.data(), taken(count * sizeof(T)).data(), count * sizeof(T));
  }
  void require(bool holds, const char* otherwise) {
    if (!holds) throw Damaged(otherwise);
  }
  [[nodiscard]] bool at_end() const { return left_.empty(); }

 private:
  std::string_view taken(std::size_t size) {
    require(size <= left_.size(), "it ends within a value");
    const std::string_view piece = left_.substr(0, size);
    left_.remove_prefix(size);
    return piece;
  }
  // Each item takes at least one byte.
  std::uint64_t count() {
    std::uint64_t items = 0;
    (*this)(items);
    require(items <= left_.size(), "it says to hold more than there is");
    return items;
  }

  std::string_view left_;
};

}  // namespace wythe::io
