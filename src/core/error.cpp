// Text of faults, and InputError, which carries all faults of an input.
#include "wythe/parts/error.h"

#include <algorithm>

#include "core/limits.h"
#include "core/text.h"
#include "wythe/parts/text.h"

namespace wythe {
namespace {

// Whether two faults differ only in their values and lines.
bool are_alike(const Fault& a, const Fault& b) {
  return a.line > 0 && b.line > 0 && a.file == b.file && a.path == b.path &&
         a.problem == b.problem && a.cure == b.cure;
}

std::string without_digits(std::string text) {
  std::erase_if(text, [](char c) { return c >= '0' && c <= '9'; });
  return text;
}

// Whether the same value was refused for the same reason in another member of a list, such as an unknown name.
bool are_the_same(const Fault& a, const Fault& b) {
  return a.line > 0 && b.line > 0 && !a.value.empty() && a.value == b.value && a.file == b.file &&
         a.problem == b.problem && a.cure == b.cure && a.path != b.path &&
         without_digits(a.path) == without_digits(b.path);
}

// "; the same in lines 88, 97 and 106"
std::string same_in(const std::vector<int>& lines) {
  std::string out = lines.size() == 1 ? "; the same in line " : "; the same in lines ";
  for (std::size_t i = 0; i < lines.size(); ++i)
    out += (i == 0 ? "" : i + 1 == lines.size() ? " and " : ", ") + std::to_string(lines[i]);
  return out;
}

// One line a fault. Of more than three similar ones in a row it shows the first and counts the others.
std::string listed(const std::vector<Fault>& faults) {
  constexpr std::size_t kFew = 3;
  std::string out;
  const std::size_t most = std::min(faults.size(), kMostFaults);
  std::vector<bool> told(most, false);
  const auto tell = [&](std::size_t i) {
    std::vector<int> others;
    for (std::size_t k = i + 1; k < most; ++k)
      if (!told[k] && are_the_same(faults[i], faults[k])) {
        told[k] = true;
        others.push_back(faults[k].line);
      }
    out += (out.empty() ? "" : "\n") + to_string(faults[i]);
    if (!others.empty()) out += same_in(others);
  };
  for (std::size_t i = 0; i < most;) {
    std::size_t end = i + 1;
    while (end < most && are_alike(faults[i], faults[end])) ++end;
    const std::size_t alike = end - i;
    for (const std::size_t shown = alike > kFew ? i + 1 : end; i < shown; ++i)
      if (!told[i]) tell(i);
    if (alike > kFew)
      out += "; so in " + std::to_string(alike - 1) + " lines more, to line " +
             std::to_string(faults[end - 1].line);
    i = end;
  }
  if (most < faults.size()) out += "\nand more like these; mend these first";
  return out;
}

constexpr std::size_t kLongName = 300, kLongValue = 120, kLongSentence = 4000;

// Number of bytes at `i` that must not reach a terminal, 0 where there are none. They are C0, DEL, C1 (U+0080 to U+009F), the
// marks that change the direction of text (U+200E to U+200F, U+202A to U+202E, U+2066 to U+2069), and any byte
// that is not valid UTF-8.
std::size_t unreadable_at(const std::string& text, std::size_t i) {
  const auto byte = [&](std::size_t k) {
    return k < text.size() ? static_cast<unsigned char>(text[k]) : 0U;
  };
  if (byte(i) < 0x20 || byte(i) == 0x7f || utf8_size(text, i) == 0) return 1;
  if (byte(i) == 0xc2 && byte(i + 1) >= 0x80 && byte(i + 1) <= 0x9f) return 2;
  if (byte(i) != 0xe2) return 0;
  const unsigned last = byte(i + 2);
  const bool turns =
      (byte(i + 1) == 0x80 && ((last >= 0x8e && last <= 0x8f) || (last >= 0xaa && last <= 0xae))) ||
      (byte(i + 1) == 0x81 && last >= 0xa6 && last <= 0xa9);
  return turns ? 3 : 0;
}

}  // namespace

std::string readable_lines(const std::string& text) {
  std::string out;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    out += (begin > 0 ? "\n" : "") + readable(text.substr(begin, end - begin), kLongSentence);
    begin = end + 1;
  }
  return out;
}

std::string readable(const std::string& text, std::size_t most) {
  constexpr char kDigit[] = "0123456789abcdef";
  std::string out;
  std::size_t i = 0;
  while (i < text.size() && out.size() < most) {
    const std::size_t hidden = unreadable_at(text, i);
    if (text[i] == '\n' || text[i] == '\t') {
      out += text[i] == '\n' ? "\\n" : "\\t";
      ++i;
      continue;
    }
    for (std::size_t k = 0; k < hidden; ++k, ++i) {
      const auto byte = static_cast<unsigned char>(text[i]);
      out += {'\\', 'x', kDigit[byte >> 4], kDigit[byte & 15]};
    }
    if (hidden > 0) continue;
    const std::size_t size = utf8_size(text, i);
    out.append(text, i, size);
    i += size;
  }
  if (i == text.size()) return out;
  return out + "... (" + std::to_string(text.size()) + " characters)";
}

std::string to_string(const Fault& fault) {
  std::string out = readable(fault.file, kLongName);
  if (fault.line > 0) out += ':' + std::to_string(fault.line);
  if (!out.empty()) out += ": ";
  out += readable(fault.path, kLongName);
  if (!fault.value.empty())
    out += (fault.path.empty() ? "" : " = ") + readable(fault.value, kLongValue);
  if (!fault.path.empty() || !fault.value.empty()) out += ": ";
  out += readable_lines(fault.problem);
  if (!fault.cure.empty()) out += "; " + readable_lines(fault.cure);
  return out;
}

namespace {

constexpr std::string_view kOfBlocks = "wall.blocks.";

// "wall.blocks.front.c03u05a" becomes a path of plan_wall.front if the builder made that block; else it is unchanged.
std::string built_path(const std::string& path, const KeyPlaces& places) {
  if (!path.starts_with(kOfBlocks)) return path;
  const std::string id = path.substr(kOfBlocks.size()), name = id.substr(0, id.find('.'));
  for (const char* table : {"plan_wall.", "slab.", "arch.", "dome."})
    if (places.key.contains(table + name)) return table + id;
  return path;
}

Fault placed_by_key(Fault fault, const std::map<std::string, KeyPlace>& places) {
  for (std::string path = fault.path;; path.resize(path.find_last_of('.'))) {
    const auto found = places.find(path);
    if (found != places.end()) {
      const KeyPlace& place = found->second;
      fault.file = place.file;
      fault.line = place.line;
      if (!place.given.empty()) fault.path = place.given + fault.path.substr(path.size());
      return fault;
    }
    if (path.find('.') == std::string::npos) break;
  }
  if (const auto file = places.find(""); file != places.end()) fault.file = file->second.file;
  return fault;
}

}  // namespace

std::vector<Fault> KeyPlaces::placed(const std::vector<Fault>& faults) const {
  std::vector<Fault> out;
  for (Fault fault : faults) {
    fault.path = built_path(fault.path, *this);
    if (!blocks.empty() && fault.path.starts_with(kOfBlocks)) fault.file = blocks;
    out.push_back(fault.file.empty() ? placed_by_key(std::move(fault), key) : std::move(fault));
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const Fault& a, const Fault& b) { return a.line < b.line; });
  return out;
}

InputError::InputError(std::vector<Fault> faults)
    : std::runtime_error(listed(faults)), faults_(std::move(faults)) {}

void FaultList::throw_if_any() const {
  if (!faults_.empty()) throw InputError(faults_);
}

}  // namespace wythe
