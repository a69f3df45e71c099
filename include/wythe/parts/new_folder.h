// A folder for results that may never be written.
#pragma once

#include <filesystem>
#include <string>
#include <utility>

namespace wythe {

// Removes the folder in its destructor, where it did not exist before and is still empty.
class NewFolder {
 public:
  explicit NewFolder(std::string path) : path_(std::move(path)) {
    std::error_code error;
    is_new_ = !std::filesystem::exists(std::filesystem::symlink_status(path_, error));
  }
  ~NewFolder() {
    std::error_code error;
    if (is_new_) std::filesystem::remove(path_, error);  // fails where the folder is not empty
  }
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;

 private:
  std::string path_;
  bool is_new_ = false;
};

}  // namespace wythe
