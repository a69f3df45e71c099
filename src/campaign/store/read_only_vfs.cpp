// Copies of the system's file functions with two changes: open neither writes
// nor creates, and delete removes nothing. This applies only to the store and
// its journals. Other files, such as temporary ones, are opened as requested.
#include "campaign/store/read_only_vfs.h"

#include <sqlite3.h>

namespace wythe::study {
namespace {

// SQLite opens the journal of a store for writing, and creates it, even if the store itself is only read.
constexpr int kOfStore = SQLITE_OPEN_MAIN_DB | SQLITE_OPEN_MAIN_JOURNAL | SQLITE_OPEN_WAL;
constexpr int kToWrite =
    SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_DELETEONCLOSE | SQLITE_OPEN_EXCLUSIVE;

// One of the system's VFS with these two changes.
struct Shut {
  sqlite3_vfs vfs{};
  sqlite3_vfs* system = nullptr;

  Shut(const char* name, const char* of_system) : system(sqlite3_vfs_find(of_system)) {
    if (system == nullptr) return;
    vfs = *system;
    vfs.zName = name;
    vfs.pNext = nullptr;
    vfs.xOpen = open;
    vfs.xDelete = [](sqlite3_vfs*, const char*, int) { return SQLITE_OK; };  // nothing is removed
    sqlite3_vfs_register(&vfs, 0);
  }
  static int open(sqlite3_vfs* self, const char* file, sqlite3_file* opened, int flags, int* out) {
    if ((flags & kOfStore) != 0) flags = (flags & ~kToWrite) | SQLITE_OPEN_READONLY;
    sqlite3_vfs* system = reinterpret_cast<Shut*>(self)->system;  // vfs is its first member
    return system->xOpen(system, file, opened, flags, out);
  }
};

}  // namespace

const char* read_only_vfs() {
  static const Shut kShut("wythe-reads", "unix");
  return kShut.vfs.zName;
}

const char* read_only_vfs_without_locks() {
  static const Shut kShut("wythe-reads-alone", "unix-none");
  return kShut.vfs.zName;
}

}  // namespace wythe::study
