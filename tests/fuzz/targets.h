// Readers called with arbitrary bytes. Each must succeed, or refuse with
// an InputError or IoError in our own words. Everything else is a finding.
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

// Throws std::logic_error where the reader's refusal contains words of a library; other exceptions pass through.
void feed(const Target& target, const std::string& bytes);

// A folder of this process that is removed with it; in memory if the system has such a place.
[[nodiscard]] const std::filesystem::path& scratch();
// Writes a file there; returns its path.
std::string put(const std::string& name, const std::string& bytes);

// of text_targets.cpp, solid_targets.cpp, result_targets.cpp
[[nodiscard]] std::vector<Target> text_targets();
[[nodiscard]] std::vector<Target> solid_targets();
[[nodiscard]] std::vector<Target> result_targets();

}  // namespace wythe::fuzz
