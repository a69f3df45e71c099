// A folder for results that may not come.
#pragma once

#include <filesystem>
#include <string>
#include <utility>

namespace wythe {

// Removes the folder at the end where it was not there at the beginning and nothing came into it.
class NewFolder {
 public:
  explicit NewFolder(std::string path) : path_(std::move(path)) {
    std::error_code error;
    is_new_ = !std::filesystem::exists(std::filesystem::symlink_status(path_, error));
  }
  ~NewFolder() {
    std::error_code error;
    if (is_new_) std::filesystem::remove(path_, error);  // which fails where something is in it
  }
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;

 private:
  std::string path_;
  bool is_new_ = false;
};

}  // namespace wythe
