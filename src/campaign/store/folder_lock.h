// Only one campaign at a time may write in a folder: a run or a merge holds
// campaign.lock meanwhile. The system releases it when the program ends for any reason.
#pragma once

#include <string>

namespace wythe::study {

class FolderLock {
 public:
  // Throws an IoError that names the program which holds it.
  explicit FolderLock(const std::string& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  // Writes the number of workers into the file, for programs that show the progress of the campaign.
  void tell_workers(int workers);

 private:
  std::string path_;
  int descriptor_ = -1;
};

// The program that writes there now, as in "process 17 on node3"; empty if none.
[[nodiscard]] std::string lock_holder(const std::string& folder);
// The number of workers in that file; 0 if there is none, or nobody writes there.
[[nodiscard]] int lock_workers(const std::string& folder);

}  // namespace wythe::study
