// The lock is flock() on the file; its text only tells others who holds it and with how many workers. The
// holder removes the file at the end. So a process with a lock checks that the path still leads to its
// file, and else tries again. A reader asks for a shared lock: if that is refused, another process writes.
#include "campaign/store/folder_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "core/files.h"
#include "core/number.h"
#include "core/text.h"
#include "wythe/parts/error.h"

namespace wythe::study {
namespace {

constexpr const char* kLockName = "campaign.lock";

std::string host_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "this machine";
}

// "process 17 on node3", then, below, "8 workers".
std::string content(int descriptor) {
  std::array<char, 512> text{};
  const ssize_t size = ::pread(descriptor, text.data(), text.size() - 1, 0);
  return size > 0 ? text.data() : "";
}

std::string holder(int descriptor) {
  const std::string text = content(descriptor), line = text.substr(0, text.find('\n'));
  return line.empty() ? "unknown" : std::string(trimmed(line));
}

// Whether `path` is still the opened file; its last holder may have removed it.
bool is_current(const std::string& path, int descriptor) {
  struct stat at_path {
  }, opened{};
  return ::stat(path.c_str(), &at_path) == 0 && ::fstat(descriptor, &opened) == 0 &&
         at_path.st_ino == opened.st_ino;
}

}  // namespace

FolderLock::FolderLock(const std::string& folder)
    : path_((std::filesystem::path(folder) / kLockName).string()) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw IoError(folder + ": cannot be made: " + error.message());
  while (descriptor_ < 0) {
    check_output(path_);
    const int opened = ::open(path_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (opened < 0)
      throw IoError(fmt::format("{}: cannot be written: {}", folder, std::strerror(errno)));
    if (::flock(opened, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      const std::string who = holder(opened);
      ::close(opened);
      throw IoError(
          fmt::format("{}: another campaign is writing there ({}); wait for it or stop it, "
                      "then go on with --resume",
                      folder, who));
    }
    if (is_current(path_, opened))
      descriptor_ = opened;
    else
      ::close(opened);
  }
  const std::string who = fmt::format("process {} on {}\n", ::getpid(), host_name());
  if (::ftruncate(descriptor_, 0) != 0 || ::pwrite(descriptor_, who.data(), who.size(), 0) < 0) {
    // the text is only information, and a full disk is reported elsewhere
  }
}

FolderLock::~FolderLock() {
  ::unlink(path_.c_str());
  ::close(descriptor_);
}

void FolderLock::tell_workers(int workers) {
  const std::string line = fmt::format("{} workers\n", workers);
  const off_t end = ::lseek(descriptor_, 0, SEEK_END);
  if (::pwrite(descriptor_, line.data(), line.size(), end) < 0) {
    // only information, too
  }
}

namespace {

// The text of a lock that is held; empty if none is.
template <class Read>
auto of_held(const std::string& folder, const Read& read) {
  const std::string path = (std::filesystem::path(folder) / kLockName).string();
  const int opened = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  decltype(read(opened)) said{};
  if (opened < 0) return said;
  if (::flock(opened, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK) said = read(opened);
  ::close(opened);
  return said;
}

}  // namespace

std::string lock_holder(const std::string& folder) { return of_held(folder, holder); }

int lock_workers(const std::string& folder) {
  return of_held(folder, [](int descriptor) {
    const std::string text = content(descriptor);
    const std::size_t line = text.find('\n');
    if (line == std::string::npos) return 0;
    const auto workers = leading_number<int>(std::string_view(text).substr(line + 1));
    return workers ? std::clamp(workers->value, 0, 1 << 16) : 0;
  });
}

}  // namespace wythe::study
