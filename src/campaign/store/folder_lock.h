// One campaign at a time in a folder: campaign.lock, held while a run or a merge writes there. The system releases
// it when the program ends, in whatever way.
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
  // Says in the file how many workers run samples, for whoever asks how far the campaign is.
  void tell_workers(int workers);

 private:
  std::string path_;
  int descriptor_ = -1;
};

// "process 17 on node3", which writes there now; "": none.
[[nodiscard]] std::string lock_holder(const std::string& folder);
// How many workers it said; 0: none, or nobody writes there.
[[nodiscard]] int lock_workers(const std::string& folder);

}  // namespace wythe::study
