// The only access to files. Each file is read whole and written whole.
//
// Only regular files up to a stated size are read. A folder, pipe, device or socket is refused with its kind,
// without waiting for it. A written file appears whole or not at all, and never through a link.
#pragma once

#include <string>
#include <string_view>

namespace wythe {

// Returns the content of a file of at most `most` bytes; links are followed. Throws InputError with place and cure where it
// is no regular file or a larger one, IoError where the system refuses (no such file, no permission).
[[nodiscard]] std::string read_file(const std::string& path, std::size_t most);
// As read_file() for a text. Throws InputError also for bytes that are not UTF-8 (with line) and for foreign kinds (file_kinds.h).
[[nodiscard]] std::string read_text(const std::string& path, std::size_t most);

// Writes a file whole or not at all: into a temporary file in the same folder, every call checked, then renamed. A reader
// never sees half a file, and a full disk leaves the previous version in place. Throws as check_output(), and IoError
// with the path and the system's reason.
void write_file(const std::string& path, std::string_view text);

// A file that is written piece by piece, for content larger than memory. A reader may see half of it, so it is
// written only into a folder of results that is not in place yet. Throws IoError.
class GrowingFile {
 public:
  explicit GrowingFile(const std::string& path);  // the file must not exist yet
  ~GrowingFile();
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;
  void add(std::string_view text);
  void close();  // flushes the data to the disk

 private:
  std::string path_, waiting_;
  int descriptor_ = -1;
};

// Throws InputError where `path` is a link or holds anything but a regular file. A path that does not exist is accepted.
void check_output(const std::string& path);
// As check_output() for a file that is only read: a link may lead to it.
void check_input(const std::string& path);

}  // namespace wythe
