#include "study/store/folder_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "core/files.h"
#include "core/text.h"
#include "wythe/error.h"

namespace wythe::study {
namespace {

constexpr const char* kLockName = "campaign.lock";

std::string host_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "this machine";
}

std::string holder(int descriptor) {
  std::array<char, 256> text{};
  const ssize_t size = ::pread(descriptor, text.data(), text.size() - 1, 0);
  return size > 0 ? std::string(trimmed(text.data())) : "unknown";
}

// The file at `path` is still the one that was opened: its last holder may have removed it.
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
    // the name of the holder is a courtesy; a full disk shows where it matters
  }
}

FolderLock::~FolderLock() {
  ::unlink(path_.c_str());
  ::close(descriptor_);
}

std::string lock_holder(const std::string& folder) {
  const std::string path = (std::filesystem::path(folder) / kLockName).string();
  const int opened = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (opened < 0) return "";
  const bool is_held = ::flock(opened, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  std::string who = is_held ? holder(opened) : "";
  ::close(opened);
  return who;
}

}  // namespace wythe::study
