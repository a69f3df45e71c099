// The door to files: whole ones in, whole ones out.
//
// What is read is a regular file of a stated size at most. A folder, pipe, device or socket is refused by
// its kind, and none is waited for. What is written appears whole or not at all, and never through a link.
#pragma once

#include <string>
#include <string_view>

namespace wythe {

// Content of a file of at most `most` bytes; links are followed. Throws InputError with place and cure where
// that is no regular file or a larger one, IoError where the system refuses (no such file, no permission).
[[nodiscard]] std::string read_file(const std::string& path, std::size_t most);
// The same for a text: what is not UTF-8 is refused with its line, a file of another kind (core/file_kinds.h) by its name.
[[nodiscard]] std::string read_text(const std::string& path, std::size_t most);

// Writes a file whole or not at all: temporary name in the same folder, every call checked, rename. A reader
// never sees half a file, and a full disk leaves the previous version in place. Throws as below, and IoError
// with the path and the system's reason.
void write_file(const std::string& path, std::string_view text);

// A file that is written piece by piece, for what is larger than memory: into a folder of results that are
// not in place yet, since a half of it may be seen. Throws IoError.
class GrowingFile {
 public:
  explicit GrowingFile(const std::string& path);  // must not exist
  ~GrowingFile();
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;
  void add(std::string_view text);
  void close();  // its data are on the disk

 private:
  std::string path_, waiting_;
  int descriptor_ = -1;
};

// Throws InputError where `path` is a link or anything but a regular file; nothing there is fine.
void check_output(const std::string& path);
// The same where a file is opened to be read alone: a link may lead to it.
void check_input(const std::string& path);

}  // namespace wythe
