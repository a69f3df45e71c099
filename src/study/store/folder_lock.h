// One campaign at a time in a folder: campaign.lock, held while a run or a merge writes there. The
// system lets go of it when the program ends, however it ends.
#pragma once

#include <string>

namespace wythe::study {

class FolderLock {
 public:
  // Throws IoError that says which program holds it.
  explicit FolderLock(const std::string& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  std::string path_;
  int descriptor_ = -1;
};

// "process 17 on node3", which writes there now; "": none.
[[nodiscard]] std::string lock_holder(const std::string& folder);

}  // namespace wythe::study
