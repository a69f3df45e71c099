// Edit distance with swaps (optimal string alignment), computed row by row.
#include "core/text.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "core/limits.h"
#include "wythe/parts/text.h"

namespace wythe {
namespace {

constexpr std::ptrdiff_t kMostShown = 60;  // names listed in one sentence
}  // namespace

std::string small_letters(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return out;
}

int edit_distance(std::string_view a, std::string_view b) {
  const std::size_t n = b.size();
  std::vector<int> before(n + 1), above(n + 1), row(n + 1);
  for (std::size_t j = 0; j <= n; ++j) above[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= n; ++j) {
      const int change = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, change});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before.swap(above);
    above.swap(row);
  }
  return above[n];
}

std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates) {
  if (name.size() > kLongestName || candidates.size() > kMostCandidates) return "";
  const std::string wanted = small_letters(name);
  int best = std::max(1, static_cast<int>(name.size()) / 3) + 1;
  std::string nearest;
  bool nearest_begins = false;
  for (const std::string& candidate : candidates) {
    if (candidate.size() > 2 * kLongestName) continue;
    // lower bound of the distance: the difference of the lengths
    const auto more = static_cast<int>(candidate.size()) - static_cast<int>(wanted.size());
    if (std::abs(more) > best) continue;
    const std::string known = small_letters(candidate);
    const int distance = edit_distance(wanted, known);
    // no letter in common is no match; of equally near names one that begins like the other wins
    if (distance >= static_cast<int>(std::max(wanted.size(), known.size()))) continue;
    const bool begins = known.starts_with(wanted) || wanted.starts_with(known);
    if (distance < best || (distance == best && !nearest.empty() && begins && !nearest_begins)) {
      nearest_begins = begins;
      best = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string name_advice(std::string_view name, const std::vector<std::string>& candidates) {
  const std::string nearest = nearest_name(name, candidates);
  if (!nearest.empty()) return "did you mean " + nearest + "?";
  if (candidates.empty()) return "";
  if (candidates.size() <= kMostShown) return "known here: " + joined(candidates, ", ");
  return "known here: " + joined({candidates.begin(), candidates.begin() + kMostShown}, ", ") +
         " and " + std::to_string(candidates.size() - kMostShown) + " more";
}

std::string meant_name(std::string_view word, const std::vector<std::string>& names) {
  return name_advice(word, names);
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

std::string joined(const std::vector<std::string>& parts, std::string_view between) {
  std::string out;
  for (const std::string& part : parts) {
    if (!out.empty()) out += between;
    out += part;
  }
  return out;
}

namespace {
constexpr std::string_view kDigit =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
}  // namespace

std::size_t utf8_size(std::string_view text, std::size_t i) {
  const auto byte = [&](std::size_t k) {
    return k < text.size() ? static_cast<unsigned char>(text[k]) : 0U;
  };
  const unsigned first = byte(i), second = byte(i + 1);
  if (first < 0x80) return first != 0 ? 1 : 0;
  if (first < 0xc2 || first > 0xf4) return 0;
  const std::size_t size = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  for (std::size_t k = 1; k < size; ++k)
    if ((byte(i + k) & 0xc0) != 0x80) return 0;
  // an overlong encoding, half of a UTF-16 pair, or a number beyond the last character
  if ((first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f) ||
      (first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f))
    return 0;
  return size;
}

bool is_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t size = utf8_size(text, i);
    if (size == 0) return false;
    i += size;
  }
  return true;
}

std::string base64(std::span<const std::uint8_t> bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = bytes.size() - i;
    std::uint32_t group = static_cast<std::uint32_t>(bytes[i]) << 16;
    if (left > 1) group |= static_cast<std::uint32_t>(bytes[i + 1]) << 8;
    if (left > 2) group |= bytes[i + 2];
    text += kDigit[group >> 18];
    text += kDigit[(group >> 12) & 63];
    text += left > 1 ? kDigit[(group >> 6) & 63] : '=';
    text += left > 2 ? kDigit[group & 63] : '=';
  }
  return text;
}

std::string bytes_of_base64(std::string_view text) {
  std::array<int, 256> value;
  value.fill(-1);
  for (std::size_t d = 0; d < kDigit.size(); ++d)
    value[static_cast<unsigned char>(kDigit[d])] = static_cast<int>(d);
  std::size_t padding = 0;
  for (; padding < 2 && text.ends_with('='); ++padding) text.remove_suffix(1);
  if ((text.size() + padding) % 4 != 0) return "";
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t group = 0;
  int bits = 0;
  for (const char c : text) {
    const int digit = value[static_cast<unsigned char>(c)];
    if (digit < 0) return "";
    group = group << 6 | static_cast<std::uint32_t>(digit);
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(group >> bits & 255U);
  }
  return bytes;
}

}  // namespace wythe
