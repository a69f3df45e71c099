// POSIX calls rather than streams: they report why they failed, and they can refuse to wait or to follow a link.
#include "core/files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

#include "core/file_kinds.h"
#include "core/text.h"
#include "wythe/parts/error.h"

namespace wythe {
namespace {

[[noreturn]] void refuse(const std::string& path, std::string value, std::string problem,
                         std::string cure, int line = 0) {
  throw InputError({{.file = path,
                     .value = std::move(value),
                     .problem = std::move(problem),
                     .cure = std::move(cure),
                     .line = line}});
}

[[noreturn]] void refuse_reading(const std::string& path, int cause) {
  throw IoError(fmt::format("can't read {}: {}", path, std::strerror(cause)));
}

[[noreturn]] void refuse_writing(const std::string& path, int cause) {
  throw IoError(fmt::format("{}: cannot be written: {}", path, std::strerror(cause)));
}

// What a path holds instead of a regular file, "a folder" for example; "" for a regular file.
const char* other_kind(mode_t mode) {
  if (S_ISREG(mode)) return "";
  if (S_ISLNK(mode)) return "a link";
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  return "a device";
}

void check_readable(const std::string& path, const struct stat& there) {
  const std::string kind = other_kind(there.st_mode);
  if (kind.empty()) return;
  refuse(path, "", "is " + kind + ", not a file",
         kind == "a folder" ? "name a file in it"
                            : "write what it gives to a file first, and name that file");
}

std::string megabytes(std::size_t bytes) { return fmt::format("{:.6g} MB", 1e-6 * double(bytes)); }

[[noreturn]] void refuse_size(const std::string& path, std::size_t bytes, std::size_t most) {
  refuse(path, "",
         fmt::format("has {} or more, at most {} are read", megabytes(bytes), megabytes(most)),
         "name the file that is meant, or split it (docs/reference/limits.md)");
}

struct Descriptor {
  int number;
  explicit Descriptor(int opened) : number(opened) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
};

// Reads at most `room` bytes and returns their number, 0 at the end of the file.
std::size_t read_some(int descriptor, char* to, std::size_t room, const std::string& path) {
  while (true) {
    const ssize_t got = ::read(descriptor, to, room);
    if (got >= 0) return static_cast<std::size_t>(got);
    if (errno != EINTR) refuse_reading(path, errno);
  }
}

void check_utf8(const std::string& path, std::string_view text) {
  int line = 1;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t size = utf8_size(text, i);
    if (size == 0)
      refuse(path, fmt::format("byte 0x{:02x}", static_cast<unsigned char>(text[i])),
             "is no part of a UTF-8 text", "save the file as UTF-8 in your editor", line);
    line += text[i] == '\n';
    i += size;
  }
}

// Writes the whole text; returns 0, or errno.
int write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    text.remove_prefix(written);
  }
  return 0;
}

// Writes the whole text and flushes it to the disk before the rename: after a crash the old or the new file is there.
int fill(int descriptor, std::string_view text) {
  if (const int cause = write_all(descriptor, text); cause != 0) return cause;
  // a file system that has nothing to flush answers EINVAL or EROFS
  if (::fsync(descriptor) != 0 && errno != EINVAL && errno != EROFS) return errno;
  return 0;
}

}  // namespace

void check_input(const std::string& path) {
  struct stat there {};
  if (::stat(path.c_str(), &there) == 0) return check_readable(path, there);
  if (::lstat(path.c_str(), &there) != 0) return;  // open() reports the reason afterwards
  std::error_code error;
  refuse(path, "",
         fmt::format("is a link to {}, which can't be reached",
                     std::filesystem::read_symlink(path, error).string()),
         "mend the link, or remove it");
}

void check_output(const std::string& path) {
  struct stat there {};
  if (::lstat(path.c_str(), &there) != 0) return;  // open() reports the reason afterwards
  const std::string kind = other_kind(there.st_mode);
  if (kind.empty()) return;
  std::error_code error;
  const std::string to = std::filesystem::read_symlink(path, error).string();
  refuse(path, "",
         fmt::format("is {}{}{}, and results go to files of their own", kind,
                     to.empty() ? "" : " to ", to),
         "remove it, or name another place");
}

std::string read_file(const std::string& path, std::size_t most) {
  check_input(path);  // before open(): that alone may wait for a pipe or start a device
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  struct stat there {};
  if (file.number < 0 || ::fstat(file.number, &there) != 0) refuse_reading(path, errno);
  check_readable(path, there);
  const std::size_t stated = there.st_size;
  if (stated > most) refuse_size(path, stated, most);
  // one spare byte shows that the file has grown, or that its size was unknown (/proc)
  std::string text(stated + 1, '\0');
  std::size_t size = 0;
  while (const std::size_t got =
             read_some(file.number, text.data() + size, text.size() - size, path)) {
    size += got;
    if (size > most) refuse_size(path, size, most);
    if (size == text.size()) text.resize(std::min(2 * size, most + 1));
  }
  text.resize(size);
  return text;
}

std::string read_text(const std::string& path, std::size_t most) {
  std::string text = read_file(path, most);
  refuse_foreign(path, text);
  check_utf8(path, text);
  return text;
}

void write_file(const std::string& path, std::string_view text) {
  check_output(path);
  const std::string temporary = path + ".part" + std::to_string(::getpid());
  ::unlink(temporary.c_str());  // left by a killed program with the same process number
  const int descriptor =
      ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (descriptor < 0) refuse_writing(path, errno);
  int cause = fill(descriptor, text);
  if (::close(descriptor) != 0 && cause == 0) cause = errno;
  if (cause == 0 && std::rename(temporary.c_str(), path.c_str()) != 0) cause = errno;
  if (cause != 0) {
    ::unlink(temporary.c_str());
    refuse_writing(path, cause);
  }
}

GrowingFile::GrowingFile(const std::string& path)
    : path_(path),
      descriptor_(
          ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666)) {
  if (descriptor_ < 0) refuse_writing(path_, errno);
}

GrowingFile::~GrowingFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void GrowingFile::add(std::string_view text) {
  constexpr std::size_t kAtOnce = 1 << 20;
  waiting_ += text;
  if (waiting_.size() < kAtOnce) return;
  if (const int cause = write_all(descriptor_, waiting_); cause != 0) refuse_writing(path_, cause);
  waiting_.clear();
}

void GrowingFile::close() {
  int cause = fill(descriptor_, waiting_);
  if (::close(std::exchange(descriptor_, -1)) != 0 && cause == 0) cause = errno;
  if (cause != 0) refuse_writing(path_, cause);
}

}  // namespace wythe
