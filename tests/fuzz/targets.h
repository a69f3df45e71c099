// Readers fed with any bytes. Each answers, or refuses with an InputError or IoError in our own words; whatever else
// happens is a finding.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace wythe::fuzz {

struct Target {
  const char* name;  // also its folder of tests/fuzz/corpus
  void (*read)(const std::string& bytes);
};
[[nodiscard]] const std::vector<Target>& targets();

// Throws std::logic_error where the reader's refusal holds words of a library, and whatever else it threw.
void feed(const Target& target, const std::string& bytes);

// A folder of this process that goes away with it; in memory where the system has such a place.
[[nodiscard]] const std::filesystem::path& scratch();
// Writes a file there; its path.
std::string put(const std::string& name, const std::string& bytes);

// of text_targets.cpp, solid_targets.cpp, result_targets.cpp
[[nodiscard]] std::vector<Target> text_targets();
[[nodiscard]] std::vector<Target> solid_targets();
[[nodiscard]] std::vector<Target> result_targets();

}  // namespace wythe::fuzz
