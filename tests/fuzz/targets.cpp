#include "fuzz/targets.h"

#include <unistd.h>

#include <cctype>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "wythe/parts/error.h"

namespace wythe::fuzz {
namespace {

namespace fs = std::filesystem;

struct Scratch {
  fs::path path;
  Scratch() {
    const fs::path memory = "/dev/shm";
    std::error_code error;
    const fs::path above =
        ::access(memory.c_str(), W_OK) == 0 ? memory : fs::temp_directory_path(error);
    path = above / ("wythe_fuzz_" + std::to_string(::getpid()));
    fs::create_directories(path);
    ::setenv("WYTHE_MEMORY", "64 MB", 1);  // what a reader may ask for: small walls alone
  }
  ~Scratch() {
    std::error_code error;
    fs::remove_all(path, error);
  }
};

// In small letters: a reader that takes both repeats its input in them.
std::string letters_of(const std::string& text) {
  std::string letters;
  for (const char c : text)
    if (std::isalpha(static_cast<unsigned char>(c)) != 0)
      letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return letters;
}

// Without the bytes that a refusal writes out. "\x1bad_alloc" is a byte before "ad_alloc", and what looks written out
// may stand in the input as it is: a library's word is there with these bytes and without them.
std::string without_bytes(const std::string& said) {
  std::string left;
  for (std::size_t i = 0; i < said.size(); ++i)
    if (said.compare(i, 2, "\\x") == 0)
      i += 3;
    else
      left += said[i];
  return left;
}

// Not those that the reader repeats from its input, where it may leave other characters out.
void check_words(const std::string& message, const std::string& bytes) {
  const std::string said = without_bytes(message);
  for (const char* raw : {"json.exception", "_M_range", "std::", "basic_string", "bad_alloc",
                          "filesystem error", "stoul", "stod"})
    if (message.find(raw) != std::string::npos && said.find(raw) != std::string::npos &&
        letters_of(bytes).find(letters_of(raw)) == std::string::npos)
      throw std::logic_error("a library's words in a refusal: " + message);
}

}  // namespace

const std::vector<Target>& targets() {
  static const std::vector<Target> kAll = [] {
    std::vector<Target> all = text_targets();
    for (const Target& target : solid_targets()) all.push_back(target);
    for (const Target& target : result_targets()) all.push_back(target);
    return all;
  }();
  return kAll;
}

void feed(const Target& target, const std::string& bytes) {
  static_cast<void>(scratch());
  try {
    target.read(bytes);
  } catch (const InputError& error) {
    check_words(error.what(), bytes);
  } catch (const IoError& error) {
    check_words(error.what(), bytes);
  }
}

const fs::path& scratch() {
  static const Scratch kOne;
  return kOne.path;
}

std::string put(const std::string& name, const std::string& bytes) {
  const std::string path = (scratch() / name).string();
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

}  // namespace wythe::fuzz
