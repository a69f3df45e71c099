// Protects the program from stores of unknown origin: each value is read by its type, and no
// cell may be larger than memory allows. Reading creates or removes no file beside the store
// (open_mode). The files are checked before and after opening; if another program changed
// them, the mode is chosen again. A new file gets its final name only when it is complete.
#include "campaign/store/database.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sqlite3.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <thread>

#include "campaign/store/read_only_vfs.h"
#include "core/bits.h"
#include "core/files.h"
#include "core/hash.h"
#include "core/limits.h"
#include "model/size.h"
#include "wythe/parts/error.h"

namespace wythe::study {
namespace {

constexpr int kPatience = 2000;  // for another program's lock [ms]

// Text and cure for an SQLite result code.
std::string advice(int code) {
  switch (code & 0xff) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return "is locked by another program that writes to it; end that program (fuser names it) "
             "and "
             "repeat the command";
    case SQLITE_NOTADB:
      return std::string("is not a campaign store, or its first bytes are damaged; ") +
             kCureOfDamage;
    case SQLITE_CORRUPT: return std::string("is damaged; ") + kCureOfDamage;
    case SQLITE_FULL:
      return "the disk is full; every sample stored so far is kept: free some space and go on with "
             "--resume";
    case SQLITE_READONLY:
    case SQLITE_PERM:
    case SQLITE_CANTOPEN:
      return "cannot be opened for writing or reading; check that the folder exists and is yours";
    case SQLITE_IOERR:
      return "the disk refused to read or write (full, over quota, or gone); every sample stored "
             "so "
             "far is kept: mend it and go on with --resume";
    default: return "the store refused";
  }
}

bool is_of_disk(int code) {
  switch (code & 0xff) {
    case SQLITE_FULL:
    case SQLITE_IOERR:
    case SQLITE_READONLY:
    case SQLITE_PERM:
    case SQLITE_CANTOPEN:
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
    case SQLITE_NOMEM: return true;
    default: return false;
  }
}

std::string address(const std::string& file, const std::string& how) {
  std::string escaped;
  for (const char c : std::filesystem::absolute(file).string()) {
    if (c == '?' || c == '#' || c == '%')
      escaped += fmt::format("%{:02x}", static_cast<unsigned char>(c));
    else
      escaped += c;
  }
  return "file://" + escaped + how;  // with an empty host, because //tmp/x would name one
}

std::int64_t size_of(const std::string& file) {  // [bytes]; -1 for none
  struct stat found {};
  return ::stat(file.c_str(), &found) == 0 ? found.st_size : -1;
}
bool is_there(const std::string& file) { return size_of(file) > 0; }

// How to open a store so that no file beside it is created, recovered or removed:
//   no -wal        without locks. A -shm that lies there alone is of a writer that ended and could not remove it: whoever has the
//                  store open makes the -wal first and removes it last
//   -wal and -shm  with the locks of the writer; if the writer was killed, the index is made in memory. Where SQLite
//                  cannot do that (SQLITE_PROTOCOL: only the head of the journal was written), as without -shm
//   -wal alone     no program has it open: without locks, the index in memory
std::string open_mode(const std::string& file, bool index_is_good = true) {
  const std::int64_t journal = size_of(file + "-wal");
  if (journal < 0 || (journal == 0 && !is_there(file + "-shm"))) return "?immutable=1";
  if (is_there(file + "-shm") && index_is_good)
    return std::string("?mode=ro&readonly_shm=1&vfs=") + read_only_vfs();
  return std::string("?mode=ro&vfs=") + read_only_vfs_without_locks();
}

// A journal means that a program writes, or was stopped while it wrote, so
// the file itself may be half written. An emptied journal begins with zeros.
bool has_rollback_journal(const std::string& file) {
  const int opened = ::open((file + "-journal").c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  char first = 0;
  const bool has_begun = opened >= 0 && ::read(opened, &first, 1) == 1 && first != 0;
  if (opened >= 0) ::close(opened);
  return has_begun;
}

}  // namespace

void Statement::Finalize::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
// If a reader has the store open, SQLite does not empty the journal when the last writer
// ends. So the data are first written into the file, which then contains the whole campaign.
void Database::Close::operator()(sqlite3* handle) const {
  if (sqlite3_db_readonly(handle, "main") == 0) {
    sqlite3_busy_timeout(handle, kPatience);
    sqlite3_wal_checkpoint_v2(handle, "main", SQLITE_CHECKPOINT_FULL, nullptr, nullptr);
  }
  sqlite3_close_v2(handle);
}

Statement::Statement(Database& database, const std::string& sql) : database_(database) {
  if (const auto from = sql.find(" FROM "); from != std::string::npos)
    table_ = sql.substr(from + 6, sql.find_first_of(" )", from + 6) - from - 6);
  sqlite3_stmt* statement = nullptr;
  check(sqlite3_prepare_v2(database.handle(), sql.c_str(), -1, &statement, nullptr));
  statement_.reset(statement);
}

void Statement::check(int code) const {
  if (code != SQLITE_OK && code != SQLITE_ROW && code != SQLITE_DONE) database_.refuse(code);
}

void Statement::bind(double value) {
  check(sqlite3_bind_double(statement_.get(), ++parameter_, value));
}
void Statement::bind(std::int64_t value) {
  check(sqlite3_bind_int64(statement_.get(), ++parameter_, value));
}
void Statement::bind(std::string_view text) {
  check(sqlite3_bind_text(statement_.get(), ++parameter_, text.data() ? text.data() : "",
                          static_cast<int>(text.size()), SQLITE_TRANSIENT));
}
void Statement::bind(Bytes bytes) {
  check(sqlite3_bind_blob(statement_.get(), ++parameter_, bytes.data.data(),
                          static_cast<int>(bytes.data.size()), SQLITE_TRANSIENT));
}
void Statement::bind_null() { check(sqlite3_bind_null(statement_.get(), ++parameter_)); }

void Statement::bind_row(Statement& row) {
  for (int at = 0; at < row.columns(); ++at)
    check(sqlite3_bind_value(statement_.get(), ++parameter_,
                             sqlite3_column_value(row.statement_.get(), at)));
}

int Statement::columns() const { return sqlite3_column_count(statement_.get()); }

bool Statement::step() {
  column_ = 0;
  const int code = sqlite3_step(statement_.get());
  check(code);
  return code == SQLITE_ROW;
}

void Statement::reset() {
  sqlite3_reset(statement_.get());
  parameter_ = 0;
}

// Advances to the next column and returns its position, if its value has one of these types or is NULL.
int Statement::take(const std::string& wanted, int type, int other_type) {
  const int at = column_++, found = sqlite3_column_type(statement_.get(), at);
  if (found != SQLITE_NULL && found != type && found != other_type)
    damaged(fmt::format("{} is not {}", sqlite3_column_name(statement_.get(), at), wanted));
  return at;
}

void Statement::damaged(const std::string& what) {
  sqlite3_stmt* row = statement_.get();
  std::string where = table_.empty() ? "" : "table " + table_ + ", ";
  const char* first = sqlite3_column_name(row, 0);
  if (first != nullptr && std::string_view(first) == "sample")
    if (const auto* sample = reinterpret_cast<const char*>(sqlite3_column_text(row, 0)))
      where += fmt::format("sample {}: ", sample);
  database_.damaged(where + what);
}

double Statement::number() {
  const int at = take("a number", SQLITE_FLOAT, SQLITE_INTEGER);
  if (sqlite3_column_type(statement_.get(), at) == SQLITE_NULL)
    return std::numeric_limits<double>::quiet_NaN();
  return sqlite3_column_double(statement_.get(), at);
}
double Statement::finite() {
  const double value = number();
  if (!std::isfinite(value))
    damaged(fmt::format("{} is not a finite number",
                        sqlite3_column_name(statement_.get(), column_ - 1)));
  return value;
}
std::int64_t Statement::integer() {
  return sqlite3_column_int64(statement_.get(), take("a whole number", SQLITE_INTEGER));
}
std::int64_t Statement::integer(std::int64_t least, std::int64_t most) {
  const bool none = sqlite3_column_type(statement_.get(), column_) == SQLITE_NULL;
  const std::int64_t value = integer();
  if (none || value < least || value > most)
    damaged(fmt::format("{} is {}, which must be from {} to {}",
                        sqlite3_column_name(statement_.get(), column_ - 1),
                        none ? "missing" : std::to_string(value), least, most));
  return value;
}
std::string Statement::text() {
  const int at = take("text", SQLITE_TEXT);
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), at));
  const int size = sqlite3_column_bytes(statement_.get(), at);
  return text == nullptr ? std::string() : std::string(text, static_cast<std::size_t>(size));
}
std::string_view Statement::bytes() {
  const int at = take("packed bytes", SQLITE_BLOB);
  const auto* data = static_cast<const char*>(sqlite3_column_blob(statement_.get(), at));
  const int size = sqlite3_column_bytes(statement_.get(), at);
  return {data, static_cast<std::size_t>(size)};
}

bool Statement::equals(Statement& other, int at) {
  sqlite3_stmt *a = statement_.get(), *b = other.statement_.get();
  const int type = sqlite3_column_type(a, at);
  if (type != sqlite3_column_type(b, at)) return false;
  if (type == SQLITE_NULL) return true;
  if (type == SQLITE_INTEGER) return sqlite3_column_int64(a, at) == sqlite3_column_int64(b, at);
  if (type == SQLITE_FLOAT)
    return bits_as<std::uint64_t>(sqlite3_column_double(a, at)) ==
           bits_as<std::uint64_t>(sqlite3_column_double(b, at));
  const void *here = sqlite3_column_blob(a, at), *there = sqlite3_column_blob(b, at);
  const int size = sqlite3_column_bytes(a, at);
  return size == sqlite3_column_bytes(b, at) &&
         (size == 0 || std::memcmp(here, there, static_cast<std::size_t>(size)) == 0);
}

std::string Statement::column(int at) const { return sqlite3_column_name(statement_.get(), at); }

std::string Statement::shown(int at) {
  sqlite3_stmt* row = statement_.get();
  const int type = sqlite3_column_type(row, at);
  if (type == SQLITE_NULL) return "nothing";
  if (type == SQLITE_FLOAT) return fmt::format("{}", sqlite3_column_double(row, at));
  if (type == SQLITE_BLOB)
    return fmt::format("other numbers in {} bytes", sqlite3_column_bytes(row, at));
  const std::string text = reinterpret_cast<const char*>(sqlite3_column_text(row, at));
  return type == SQLITE_TEXT ? "\"" + text + "\"" : text;
}

std::string_view Statement::packed_at(int at) {
  sqlite3_stmt* row = statement_.get();
  if (sqlite3_column_type(row, at) != SQLITE_BLOB) return {};
  const auto* data = static_cast<const char*>(sqlite3_column_blob(row, at));
  return {data, static_cast<std::size_t>(sqlite3_column_bytes(row, at))};
}

void Statement::add_row(Hash& hash) {
  sqlite3_stmt* row = statement_.get();
  for (int at = 0; at < sqlite3_column_count(row); ++at) {
    const int type = sqlite3_column_type(row, at);
    hash.add(&type, sizeof type);
    if (type == SQLITE_INTEGER) {
      const std::int64_t value = sqlite3_column_int64(row, at);
      hash.add(&value, sizeof value);
    } else if (type == SQLITE_FLOAT) {
      const double value = sqlite3_column_double(row, at);
      hash.add(&value, sizeof value);
    } else if (type != SQLITE_NULL) {
      const void* bytes = sqlite3_column_blob(row, at);
      const std::int64_t size = sqlite3_column_bytes(row, at);
      hash.add(&size, sizeof size);
      hash.add(bytes, static_cast<std::size_t>(size));
    }
  }
}

Database::Database(const std::filesystem::path& file, Access access) : name_(file.string()) {
  const bool reads = access == Access::kRead;
  for (const char* of_sqlite : {"", "-wal", "-shm", "-journal"})
    (reads ? check_input : check_output)(name_ + of_sqlite);
  if (reads) {
    open_to_read();
    return;
  }
  // two threads never use one connection at once, and its lock took a tenth of a merge
  if (const int code = open("", SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE); code != SQLITE_OK)
    refuse(code);
}

int Database::open(const std::string& how, int flags) {
  constexpr std::size_t kLongestPath = 500;  // SQLite allows 512, with the suffix of a journal
  if (const std::size_t length = std::filesystem::absolute(name_).string().size();
      length > kLongestPath)
    throw IoError(
        fmt::format("{}: its path has {} characters, and a store takes {} at most; choose a "
                    "shorter folder",
                    name_, length, kLongestPath));
  sqlite3* handle = nullptr;
  const int code = sqlite3_open_v2(address(name_, how).c_str(), &handle,
                                   flags | SQLITE_OPEN_URI | SQLITE_OPEN_NOMUTEX, nullptr);
  handle_.reset(handle);
  if (code != SQLITE_OK) return code;
  sqlite3_busy_timeout(handle, kPatience);
  // the origin of a store is unknown: limits the size of cells, and forbids functions in its schema
  sqlite3_limit(handle, SQLITE_LIMIT_LENGTH, kMostPacked);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  return code;
}

// Another program may start or end between two checks of the files; then the mode is chosen again.
void Database::open_to_read() {
  constexpr int kTries = 50, kJournalTries = 10;
  constexpr std::chrono::milliseconds kPause(20);
  bool index_is_good = true;
  for (int tries = 1;; ++tries) {
    if (has_rollback_journal(name_)) {
      if (tries >= kJournalTries)
        throw IoError(fmt::format(
            "{}: another program is writing to it, or was stopped while it did ({}-journal is "
            "there), and reading alone can't tell what holds; when no program has it open any "
            "more, sqlite3 {} .tables puts it back to what was stored",
            name_, name_, name_));
      std::this_thread::sleep_for(kPause);
      continue;
    }
    written_ = last_written();
    const std::string way = open_mode(name_, index_is_good);
    is_immutable_ = way == "?immutable=1";
    int code = open(way, SQLITE_OPEN_READONLY);
    if (code == SQLITE_OK && way.ends_with(read_only_vfs_without_locks()))
      code =
          sqlite3_exec(handle_.get(), "PRAGMA locking_mode = EXCLUSIVE", nullptr, nullptr, nullptr);
    if (code == SQLITE_OK)
      code =
          sqlite3_exec(handle_.get(), "PRAGMA query_only = 1; SELECT count(*) FROM sqlite_schema",
                       nullptr, nullptr, nullptr);
    const bool is_as_it_was =
        way == open_mode(name_, index_is_good) && (!is_immutable_ || written_ == last_written());
    const int kind = code & 0xff;
    if (code == SQLITE_OK && is_as_it_was) return;
    const bool may_pass = !is_as_it_was || kind == SQLITE_CANTOPEN || kind == SQLITE_READONLY ||
                          (kind == SQLITE_PROTOCOL && index_is_good);
    if (kind == SQLITE_PROTOCOL) index_is_good = false;
    if (code != SQLITE_OK && (!may_pass || tries == kTries || !std::filesystem::exists(name_)))
      refuse(code);
    if (tries == kTries) return;
    std::this_thread::sleep_for(kPause);
  }
}

std::int64_t Database::last_written() const {
  struct stat of {};
  if (::stat(name_.c_str(), &of) != 0) return 0;
  return of.st_mtim.tv_sec * 1'000'000'000 + of.st_mtim.tv_nsec + of.st_size;
}

bool Database::is_outdated() const {
  return is_immutable_ && (written_ != last_written() || is_there(name_ + "-wal"));
}

// The file was read without a lock, so a mismatch may be caused by another program.
void Database::refuse_if_written() const {
  if (is_immutable_ && written_ != last_written())
    throw IoError(name_ + ": another program wrote to it while it was read; repeat the command");
}

void Database::execute(const std::string& sql) {
  const int code = sqlite3_exec(handle_.get(), sql.c_str(), nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) refuse(code);
}

std::int64_t Database::integer(const std::string& sql) {
  Statement statement(*this, sql);
  return statement.step() ? statement.integer() : 0;
}

void Database::take(double bytes) {
  taken_ += bytes;
  if (taken_ > most_ || std::isnan(most_)) most_ = memory_limit();
  if (taken_ > most_)
    damaged(fmt::format("it unpacks to more than {:.3g} GB, all that may be used", 1e-9 * most_));
}

void Database::damaged(const std::string& what) const {
  refuse_if_written();
  throw IoError(name_ + ": is damaged: " + what + "; " + kCureOfDamage);
}

void Database::refuse(int code) {
  if ((code & 0xff) == SQLITE_CORRUPT) refuse_if_written();
  const std::string reason = handle_ ? sqlite3_errmsg(handle_.get()) : sqlite3_errstr(code);
  const std::string what = fmt::format("{}: {} (SQLite: {})", name_, advice(code), reason);
  if (is_of_disk(code)) throw DiskError(reason, what);
  throw IoError(what);
}

Transaction::Transaction(Database& database) : database_(database) {
  database_.execute("BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
  if (open_) sqlite3_exec(database_.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
}

void Transaction::commit() {
  database_.execute("COMMIT");
  open_ = false;
}

NewDatabase::NewDatabase(const std::filesystem::path& file)
    : name_(file.string()), fresh_(name_ + ".new") {
  for (const char* of_sqlite : {"", "-wal", "-shm", "-journal"}) check_output(name_ + of_sqlite);
  remove_leftovers();
  database_.emplace(fresh_, Database::Access::kWrite);
}

NewDatabase::~NewDatabase() {
  if (!database_) return;
  database_.reset();
  remove_leftovers();
}

void NewDatabase::remove_leftovers() const {
  std::error_code error;
  for (const char* of_sqlite : {"", "-wal", "-shm", "-journal"})
    std::filesystem::remove(fresh_ + of_sqlite, error);
}

void NewDatabase::refuse(const std::string& reason) const {
  throw DiskError(
      reason,
      fmt::format("{}: cannot be made, the disk refused (full, over quota, or gone: {}); nothing "
                  "was stored, start again when it is mended",
                  name_, reason));
}

void NewDatabase::put_in_place() {
  database_.reset();  // writes the journal into the file and to the disk
  const auto refuse_with = [&](const std::string& reason) {
    remove_leftovers();
    refuse(reason);
  };
  if (is_there(fresh_ + "-wal")) refuse_with("its journal could not be closed");
  std::error_code error;
  for (const char* of_sqlite : {"-wal", "-shm", "-journal"})  // left over from an earlier file
    std::filesystem::remove(name_ + of_sqlite, error);
  if (::rename(fresh_.c_str(), name_.c_str()) != 0) refuse_with(std::strerror(errno));
  const std::string folder = std::filesystem::path(name_).parent_path().string();
  const int opened =
      ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (opened < 0) return;
  ::fsync(opened);  // its new name; some file systems cannot do this
  ::close(opened);
}

}  // namespace wythe::study
