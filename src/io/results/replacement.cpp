// Replacement: a folder has the old results or the new ones, never a mixture.
//
//   DIR/.wythe_new     the results being written; the old results stay unchanged
//   DIR/.wythe_ready   the same, complete (by one rename): from now on the new results are valid
//   1  the files named in its .replaced are removed from DIR, then .replaced
//   2  every file is moved to DIR, then the empty folder is removed
//
// A program killed at 1 or 2 leaves a part of one set of results in DIR, and all missing
// files of the new one in .wythe_ready. finish_replacement() then continues with 1 or 2.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <system_error>

#include "core/files.h"
#include "core/limits.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"

namespace wythe {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNew = ".wythe_new";
constexpr const char* kReady = ".wythe_ready";
constexpr const char* kReplaced = ".replaced";

void check(const std::string& folder, const std::error_code& error) {
  if (error)
    throw IoError(
        fmt::format("{}: the results cannot be put in place: {}", folder, error.message()));
}

// The lock of a folder: its descriptor, -1 if another program holds it. The system frees it when that program ends.
int locked(const std::string& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0)
    throw IoError(fmt::format("{}: cannot be opened: {}", folder, std::strerror(errno)));
  if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK)
    return descriptor;  // on a file system without locks there is nothing to wait for
  ::close(descriptor);
  return -1;
}

// Whether that hidden folder exists and is no link, which could lead to other files.
bool is_there(const fs::path& hidden) {
  std::error_code error;
  const fs::file_type type = fs::symlink_status(hidden, error).type();
  if (type == fs::file_type::directory || type == fs::file_type::not_found)
    return type == fs::file_type::directory;
  if (type == fs::file_type::none)
    throw IoError(fmt::format("{}: cannot be looked at: {}", hidden.string(), error.message()));
  throw InputError({{.file = hidden.string(),
                     .problem = "is no folder, and new results are kept in one of that name",
                     .cure = "remove it, or name another place"}});
}

// The folder's name, if no file that results would replace is a link, folder, pipe or device.
const std::string& checked(const std::string& folder, const Replacement::Names& is_replaced) {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (is_replaced(entry.path().filename().string())) check_output(entry.path().string());
  static_cast<void>(is_there(fs::path(folder) / kNew));
  return folder;
}

void bring(const fs::path& folder, const std::function<void(const char*)>& at) {
  const fs::path ready = folder / kReady, list = ready / kReplaced;
  std::error_code error;
  if (!is_there(ready)) return;
  if (fs::exists(list, error)) {
    std::istringstream names(read_file(list.string(), kMostToml));
    for (std::string name; std::getline(names, name);)
      if (name.find('/') == std::string::npos &&
          fs::is_regular_file(fs::symlink_status(folder / name, error)))
        fs::remove(folder / name, error), check(folder, error);
    at("results removed");
    fs::remove(list, error), check(folder, error);
  }
  for (const fs::directory_entry& entry : fs::directory_iterator(ready)) {
    fs::rename(entry.path(), folder / entry.path().filename(), error), check(folder, error);
    at("results moving");
  }
  fs::remove(ready, error), check(folder, error);
}

}  // namespace

Replacement::Replacement(std::string folder, Names is_replaced)
    : folder_(std::move(folder)),
      path_((fs::path(folder_) / kNew).string()),
      is_replaced_(std::move(is_replaced)),
      lock_(locked(checked(folder_, is_replaced_))) {
  if (lock_ < 0)
    throw IoError(
        folder_ +
        ": another wythe is writing its results there; wait for it, or name another folder");
  bring(folder_, [](const char*) {});
  std::error_code error;
  fs::remove_all(path_, error);  // left over from a killed program
  fs::create_directory(path_, error), check(folder_, error);
}

Replacement::~Replacement() {
  std::error_code error;
  fs::remove_all(path_, error);
  ::close(lock_);
}

void Replacement::commit(const std::function<void(const char*)>& point) {
  const auto at = [&](const char* name) {
    if (point) point(name);
  };
  std::string names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_))
    if (const std::string name = entry.path().filename().string(); is_replaced_(name))
      names += name + '\n';
  write_file((fs::path(path_) / kReplaced).string(), names);
  at("results written");
  std::error_code error;
  fs::rename(path_, fs::path(folder_) / kReady, error), check(folder_, error);
  ::fsync(
      lock_);  // the folder itself; if this fails, the file system still keeps the order of renames
  at("results ready");
  bring(folder_, at);
}

void Replacement::put(const std::string& name, const std::string& bytes,
                      const std::function<void(const char*)>& at) {
  const fs::path whole = fs::path(path_) / name;
  write_file(whole.string(), bytes);
  if (at) at("ready");
  std::error_code error;
  fs::rename(whole, fs::path(folder_) / name, error), check(folder_, error);
  ::fsync(lock_);
  if (at) at("written");
}

void finish_replacement(const std::string& folder) {
  if (!is_there(fs::path(folder) / kReady)) return;
  const int lock = locked(folder);
  if (lock < 0) return;  // another program is finishing the replacement
  try {
    bring(folder, [](const char*) {});
  } catch (...) {
    ::close(lock);
    throw;
  }
  ::close(lock);
}

}  // namespace wythe
