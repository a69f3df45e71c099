// POSIX calls rather than streams: they say why they failed.
#include "io/write_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "wythe/error.h"

namespace wythe::io {
namespace {

[[noreturn]] void refuse(const std::string& path, int cause) {
  throw IoError(path + ": cannot be written: " + std::strerror(cause));
}

// 0, or errno. The data reach the disk before the rename, so that a crash leaves old or new.
int fill(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  // EINVAL and EROFS: a device or pipe that has nothing to flush
  if (::fsync(descriptor) != 0 && errno != EINVAL && errno != EROFS) return errno;
  return 0;
}

}  // namespace

void write_file(const std::string& path, std::string_view text) {
  const std::string temporary = path + ".part" + std::to_string(::getpid());
  const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) refuse(path, errno);
  int cause = fill(descriptor, text);
  if (::close(descriptor) != 0 && cause == 0) cause = errno;
  if (cause == 0 && std::rename(temporary.c_str(), path.c_str()) != 0) cause = errno;
  if (cause != 0) {
    ::unlink(temporary.c_str());
    refuse(path, cause);
  }
}

}  // namespace wythe::io
