// Runs the corpus of every fuzz target, with the findings of the fuzzer, through the targets without the fuzzer.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "fuzz/targets.h"
#include "scenes/places.h"

namespace wythe::fuzz {
namespace {

namespace fs = std::filesystem;

class Corpus : public testing::TestWithParam<Target> {};

TEST_P(Corpus, is_answered_or_refused_in_our_own_words) {
  const fs::path folder = fs::path(source_dir()) / "tests/fuzz/corpus" / GetParam().name;
  int files = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    std::ifstream file(entry.path(), std::ios::binary);
    const std::string bytes(std::istreambuf_iterator<char>(file), {});
    EXPECT_NO_THROW(feed(GetParam(), bytes)) << entry.path();
    EXPECT_NO_THROW(feed(GetParam(), bytes.substr(0, bytes.size() / 2))) << entry.path();
    ++files;
  }
  EXPECT_GT(files, 0) << folder;
}

// A reader that refuses all of its corpus would be fed in vain: what lies behind the refusal is never reached.
TEST_P(Corpus, holds_what_is_answered) {
  const fs::path folder = fs::path(source_dir()) / "tests/fuzz/corpus" / GetParam().name;
  static_cast<void>(scratch());
  int answered = 0;
  std::string refusal;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    std::ifstream file(entry.path(), std::ios::binary);
    const std::string bytes(std::istreambuf_iterator<char>(file), {});
    try {
      GetParam().read(bytes);
      ++answered;
    } catch (const std::exception& error) {
      refusal = error.what();
    }
  }
  EXPECT_GT(answered, 0) << refusal;
}

INSTANTIATE_TEST_SUITE_P(Targets, Corpus, testing::ValuesIn(targets()),
                         [](const auto& of) { return std::string(of.param.name); });

}  // namespace
}  // namespace wythe::fuzz
