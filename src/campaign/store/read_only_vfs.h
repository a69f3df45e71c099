// File functions for SQLite that can't write, create or remove a store, nor the files beside it.
#pragma once

namespace wythe::study {

// With the system's locks, for a store that another program may write to; the name of the VFS.
[[nodiscard]] const char* read_only_vfs();
// Without locks, for one that nobody has open.
[[nodiscard]] const char* read_only_vfs_without_locks();

}  // namespace wythe::study
