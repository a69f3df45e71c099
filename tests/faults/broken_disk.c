// Preloaded by tests/cli/broken_disk_test.py: the call number BROKEN_DISK_AT that changes something below the folder
// BROKEN_DISK_UNDER does not succeed. BROKEN_DISK_HOW says how: EIO or ENOSPC, once; FULL: ENOSPC from there on, after
// half of what was to be written; KILL: the process ends before the call. POWER: so does the machine: of what was written
// and not synchronised since, nothing (calls with an even number) or about half of the pieces is on the disk; names of
// files are. The number of calls goes to BROKEN_DISK_COUNT.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

enum { kFiles = 4096 };
static _Atomic char watched[kFiles];
static _Atomic long calls;
static char under[4096];
static size_t length;
static long at = -1;
static enum { kIo, kSpace, kFull, kKill, kPower } how;

__attribute__((constructor)) static void begin(void) {
  const char* folder = getenv("BROKEN_DISK_UNDER");
  const char* number = getenv("BROKEN_DISK_AT");
  const char* word = getenv("BROKEN_DISK_HOW");
  if (folder != NULL) length = (size_t)snprintf(under, sizeof under, "%s", folder);
  if (number != NULL) at = atol(number);
  if (word != NULL)
    how = !strcmp(word, "KILL") ? kKill : !strcmp(word, "POWER") ? kPower : !strcmp(word, "FULL") ? kFull : !strcmp(word, "ENOSPC") ? kSpace : kIo;
}

__attribute__((destructor)) static void end(void) {
  const char* file = getenv("BROKEN_DISK_COUNT");
  if (file == NULL) return;
  char text[32];
  const int size = snprintf(text, sizeof text, "%ld\n", atomic_load(&calls));
  const int to = (int)syscall(SYS_openat, AT_FDCWD, file, O_WRONLY | O_CREAT | O_TRUNC, 0644);
  syscall(SYS_write, to, text, (size_t)size);
  syscall(SYS_close, to);
}

static int concerns(const char* path) { return length > 0 && strncmp(path, under, length) == 0; }
static int is_watched(int file) { return file >= 0 && file < kFiles && atomic_load(&watched[file]); }

// --- what a loss of power takes ---------------------------------------------------------------------

// A piece that was written and not synchronised yet.
struct Piece {
  struct Piece* before;
  dev_t device;
  ino_t node;
  int file;  // of door_to
  off_t where, size_before;
  size_t had, has;  // bytes before and after
  char* bytes;      // first those that it had
};
static struct Piece* pieces;
static pthread_mutex_t pieces_mutex = PTHREAD_MUTEX_INITIALIZER;

// A descriptor of our own, so that a file can be mended after it was closed.
static int door_to(int file, const struct stat* is) {
  static struct { dev_t device; ino_t node; int file; } known[256];
  static int count;
  for (int i = 0; i < count; ++i)
    if (known[i].device == is->st_dev && known[i].node == is->st_ino) return known[i].file;
  char link[64];
  snprintf(link, sizeof link, "/proc/self/fd/%d", file);
  const int door = (int)syscall(SYS_openat, AT_FDCWD, link, O_RDWR);
  if (count < 256) {
    known[count].device = is->st_dev, known[count].node = is->st_ino, known[count].file = door;
    ++count;
  }
  return door;
}

static void note(int file, const void* data, size_t size, off_t where) {
  struct stat is;
  if (how != kPower || fstat(file, &is) != 0) return;
  if (where < 0) where = lseek(file, 0, SEEK_CUR);
  struct Piece* piece = calloc(1, sizeof *piece);
  piece->device = is.st_dev, piece->node = is.st_ino, piece->where = where, piece->size_before = is.st_size;
  pthread_mutex_lock(&pieces_mutex);
  piece->file = door_to(file, &is);
  piece->bytes = malloc(2 * size + 1);
  const ssize_t got = pread(piece->file, piece->bytes, size, where);
  piece->had = got > 0 ? (size_t)got : 0;
  piece->has = size;
  memcpy(piece->bytes + piece->had, data, size);
  piece->before = pieces;
  pieces = piece;
  pthread_mutex_unlock(&pieces_mutex);
}

static void forget(int file) {
  struct stat is;
  if (how != kPower || fstat(file, &is) != 0) return;
  pthread_mutex_lock(&pieces_mutex);
  for (struct Piece** at_piece = &pieces; *at_piece != NULL;) {
    struct Piece* piece = *at_piece;
    if (piece->device != is.st_dev || piece->node != is.st_ino) {
      at_piece = &piece->before;
      continue;
    }
    *at_piece = piece->before;
    free(piece->bytes);
    free(piece);
  }
  pthread_mutex_unlock(&pieces_mutex);
}

static void redo(struct Piece* piece, long number, unsigned* state) {
  if (piece == NULL) return;
  redo(piece->before, number, state);
  *state = *state * 1103515245U + 12345U;
  if (number % 2 != 0 && (*state >> 16) % 2 != 0)
    syscall(SYS_pwrite64, piece->file, piece->bytes + piece->had, piece->has, piece->where);
}

static void lose_power(long number) {
  pthread_mutex_lock(&pieces_mutex);
  for (struct Piece* piece = pieces; piece != NULL; piece = piece->before) {
    syscall(SYS_pwrite64, piece->file, piece->bytes, piece->had, piece->where);
    syscall(SYS_ftruncate, piece->file, piece->size_before);
  }
  unsigned state = (unsigned)number;
  redo(pieces, number, &state);
  raise(SIGKILL);
}

// --- calls ------------------------------------------------------------------------------------------

// Whether this call fails; errno is set then.
static int fails(void) {
  const long number = atomic_fetch_add(&calls, 1) + 1;
  if (at < 0 || (how == kFull ? number < at : number != at)) return 0;
  if (how == kPower) lose_power(number);
  if (how == kKill) raise(SIGKILL);
  errno = how == kIo ? EIO : ENOSPC;
  return 1;
}

#define REAL(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))
#define OPEN(name)                                                              \
  int name(const char* path, int flags, ...) {                                  \
    va_list more;                                                               \
    va_start(more, flags);                                                      \
    const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) ? va_arg(more, mode_t) : 0; \
    va_end(more);                                                               \
    const int ours = concerns(path) && (flags & (O_WRONLY | O_RDWR)) != 0;      \
    if (ours && (flags & O_CREAT) && fails()) return -1;                        \
    const int file = REAL(name)(path, flags, mode);                             \
    if (file >= 0 && file < kFiles) atomic_store(&watched[file], (char)ours);   \
    return file;                                                                \
  }
OPEN(open)
OPEN(open64)

#define OPENAT(name)                                                            \
  int name(int folder, const char* path, int flags, ...) {                      \
    va_list more;                                                               \
    va_start(more, flags);                                                      \
    const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) ? va_arg(more, mode_t) : 0; \
    va_end(more);                                                               \
    const int ours = concerns(path) && (flags & (O_WRONLY | O_RDWR)) != 0;      \
    if (ours && (flags & O_CREAT) && fails()) return -1;                        \
    const int file = REAL(name)(folder, path, flags, mode);                     \
    if (file >= 0 && file < kFiles) atomic_store(&watched[file], (char)ours);   \
    return file;                                                                \
  }
OPENAT(openat)
OPENAT(openat64)

FILE* fopen(const char* path, const char* mode) {
  if (concerns(path) && mode[0] != 'r' && fails()) return NULL;
  FILE* file = REAL(fopen)(path, mode);
  if (file != NULL) atomic_store(&watched[fileno(file)], (char)(concerns(path) && mode[0] != 'r'));
  return file;
}
FILE* fopen64(const char* path, const char* mode) { return fopen(path, mode); }

ssize_t write(int file, const void* data, size_t size) {
  if (is_watched(file) && fails()) {
    if (how != kFull || size < 2) return -1;
    return REAL(write)(file, data, size / 2);
  }
  if (is_watched(file)) note(file, data, size, -1);
  return REAL(write)(file, data, size);
}
ssize_t writev(int file, const struct iovec* parts, int count) {
  if (is_watched(file) && fails()) return -1;
  off_t where = is_watched(file) ? lseek(file, 0, SEEK_CUR) : 0;
  for (int i = 0; is_watched(file) && i < count; where += (off_t)parts[i++].iov_len)
    note(file, parts[i].iov_base, parts[i].iov_len, where);
  return REAL(writev)(file, parts, count);
}

#define PWRITE(name, offset_type)                                               \
  ssize_t name(int file, const void* data, size_t size, offset_type where) {    \
    if (is_watched(file) && fails()) {                                          \
      if (how != kFull || size < 2) return -1;                                  \
      return REAL(name)(file, data, size / 2, where);                           \
    }                                                                           \
    if (is_watched(file)) note(file, data, size, where);                        \
    return REAL(name)(file, data, size, where);                                 \
  }
PWRITE(pwrite, off_t)
PWRITE(pwrite64, off64_t)

#define OF_FILE(name, parameters, arguments) \
  int name parameters {                      \
    if (is_watched(file) && fails()) return -1; \
    return REAL(name) arguments;             \
  }
#define SYNCHRONISE(name)                         \
  int name(int file) {                            \
    if (is_watched(file) && fails()) return -1;   \
    if (is_watched(file)) forget(file);           \
    return REAL(name)(file);                      \
  }
SYNCHRONISE(fsync)
SYNCHRONISE(fdatasync)
OF_FILE(ftruncate, (int file, off_t size), (file, size))
OF_FILE(ftruncate64, (int file, off64_t size), (file, size))

#define OF_PATH(name, parameters, arguments) \
  int name parameters {                      \
    if (concerns(path) && fails()) return -1; \
    return REAL(name) arguments;             \
  }
OF_PATH(rename, (const char* path, const char* to), (path, to))
OF_PATH(renameat, (int a, const char* path, int b, const char* to), (a, path, b, to))
OF_PATH(renameat2, (int a, const char* path, int b, const char* to, unsigned flags), (a, path, b, to, flags))
OF_PATH(unlink, (const char* path), (path))
OF_PATH(unlinkat, (int a, const char* path, int flags), (a, path, flags))
OF_PATH(remove, (const char* path), (path))
OF_PATH(rmdir, (const char* path), (path))
OF_PATH(mkdir, (const char* path, mode_t mode), (path, mode))
OF_PATH(mkdirat, (int a, const char* path, mode_t mode), (a, path, mode))
OF_PATH(chmod, (const char* path, mode_t mode), (path, mode))

int close(int file) {
  if (file >= 0 && file < kFiles) atomic_store(&watched[file], 0);
  return REAL(close)(file);
}
