// File functions for SQLite that cannot write, create or remove a store or the files beside it.
#pragma once

namespace wythe::study {

// The name of the VFS with the system's locks, for a store that another program may write to.
[[nodiscard]] const char* read_only_vfs();
// The name of the VFS without locks, for a store that no program has open.
[[nodiscard]] const char* read_only_vfs_without_locks();

}  // namespace wythe::study
