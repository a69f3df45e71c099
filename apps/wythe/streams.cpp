// Standard output and error write through a function of our own. It remembers the first failure of the output, so
// that this is reported once, at the end.
#include "streams.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <iostream>

namespace wythe::app {
namespace {

constexpr int kEnvironmentError = 4;
int failed =
    0;  // errno of the first failed write on standard output; streams have no other place for it

// Writes as much as possible, and reports success to stdio in any case.
ssize_t write_or_drop(void* stream, const char* bytes, std::size_t size) {
  const int number = stream == &failed ? STDOUT_FILENO : STDERR_FILENO;
  for (std::size_t done = 0; done < size;) {
    const ssize_t now = write(number, bytes + done, size - done);
    if (now < 0 && errno == EINTR) continue;
    if (now < 0) {
      if (number == STDOUT_FILENO && failed == 0) failed = errno;
      break;
    }
    done += static_cast<std::size_t>(now);
  }
  return static_cast<ssize_t>(size);
}

std::FILE* stream_of(void* cookie, int buffering) {
  std::FILE* stream = fopencookie(
      cookie, "w", {.read = nullptr, .write = write_or_drop, .seek = nullptr, .close = nullptr});
  if (stream != nullptr) std::setvbuf(stream, nullptr, buffering, BUFSIZ);
  return stream;
}

}  // namespace

void make_streams_safe() {
  // from `ulimit -f`, or a reader that has left: the write fails and is reported. Child processes get the default.
  for (const int number : {SIGXFSZ, SIGPIPE}) std::signal(number, [](int) {});
  for (int number = 0; number <= STDERR_FILENO; ++number) {
    if (isatty(number) != 0 || errno != EBADF) continue;
    std::FILE* nothing = std::fopen("/dev/null", "r+");  // takes the lowest number that is free
    if (nothing == nullptr || fileno(nothing) != number) _exit(kEnvironmentError);
  }
  if (std::FILE* out = stream_of(&failed, isatty(STDOUT_FILENO) != 0 ? _IOLBF : _IOFBF))
    stdout = out;
  if (std::FILE* err = stream_of(nullptr, _IONBF)) stderr = err;
}

int ended_with(int code) {
  std::fflush(stdout);
  std::cout.flush();
  if (failed == 0 && std::cout.good()) return code;
  if (failed == EPIPE) {  // normal for `| head`, when the work is done
    std::signal(SIGPIPE, SIG_DFL);
    std::raise(SIGPIPE);
  }
  fmt::print(
      stderr,
      "standard output: not all could be written ({}); make room, or name another place for it\n",
      failed != 0 ? std::strerror(failed) : "its stream failed");
  return code == 0 ? kEnvironmentError : code;
}

}  // namespace wythe::app
