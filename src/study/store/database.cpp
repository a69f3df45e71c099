#include "study/store/database.h"

#include <fmt/format.h>
#include <sqlite3.h>
#include <unistd.h>

#include <cmath>
#include <limits>

#include "core/files.h"
#include "core/hash.h"
#include "core/limits.h"
#include "model/size.h"
#include "wythe/error.h"

namespace wythe::study {
namespace {

constexpr int kPatience = 2000;  // for another program's lock [ms]

constexpr const char* kCure =
    "restore it from a copy, save what can be read with sqlite3 FILE \".recover\", or begin the "
    "campaign in another folder";

// What to say and what to do about an SQLite result code.
std::string advice(int code) {
  switch (code & 0xff) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return "is locked by another program that writes to it; end that program (fuser names it) "
             "and "
             "repeat the command";
    case SQLITE_NOTADB:
      return "is not a campaign store, or its first bytes are damaged; restore it from a copy, or "
             "begin the campaign in another folder";
    case SQLITE_CORRUPT: return std::string("is damaged; ") + kCure;
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

// A store in a folder that may not be written is read as it lies there.
std::string address(const std::filesystem::path& file, bool lies_still) {
  std::string escaped;
  for (const char c : std::filesystem::absolute(file).string()) {
    if (c == '?' || c == '#' || c == '%')
      escaped += fmt::format("%{:02x}", static_cast<unsigned char>(c));
    else
      escaped += c;
  }
  return "file:" + escaped + (lies_still ? "?immutable=1" : "");
}

}  // namespace

void Statement::Finalize::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
void Database::Close::operator()(sqlite3* handle) const { sqlite3_close_v2(handle); }

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

// The next column's position, once its value is of one of these types or NULL.
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
  const std::string folder = file.parent_path().empty() ? "." : file.parent_path().string();
  const bool writable = ::access(folder.c_str(), W_OK) == 0 && ::access(name_.c_str(), W_OK) == 0;
  // A reader that may write takes the journal away when it is the last to close the file.
  const bool only_reads = reads && !writable;
  const bool lies_still = only_reads && !std::filesystem::exists(name_ + "-wal");
  // nobody uses one connection from two threads at once: its lock took a tenth of a merge
  int flags = SQLITE_OPEN_URI | SQLITE_OPEN_NOMUTEX;
  flags |= only_reads ? SQLITE_OPEN_READONLY : SQLITE_OPEN_READWRITE;
  if (!reads) flags |= SQLITE_OPEN_CREATE;
  sqlite3* handle = nullptr;
  const int code = sqlite3_open_v2(address(file, lies_still).c_str(), &handle, flags, nullptr);
  handle_.reset(handle);
  if (code != SQLITE_OK) refuse(code);
  sqlite3_busy_timeout(handle, kPatience);
  // a store may come from anybody: no cell beyond what memory takes, no function called by its schema
  sqlite3_limit(handle, SQLITE_LIMIT_LENGTH, kMostPacked);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  if (reads) execute("PRAGMA query_only = 1");
}

void Database::attach(const std::filesystem::path& file, const std::string& as) {
  for (const char* of_sqlite : {"", "-wal", "-shm"}) check_input(file.string() + of_sqlite);
  const std::string folder = file.parent_path().empty() ? "." : file.parent_path().string();
  const bool writable = ::access(folder.c_str(), W_OK) == 0 && ::access(file.c_str(), W_OK) == 0;
  const bool lies_still = !writable && !std::filesystem::exists(file.string() + "-wal");
  try {
    Statement(*this, "ATTACH DATABASE ? AS " + as).run(address(file, lies_still));
  } catch (const IoError&) {
    throw IoError(fmt::format("{}: {} (SQLite: {})", file.string(),
                              advice(sqlite3_extended_errcode(handle_.get())),
                              sqlite3_errmsg(handle_.get())));
  }
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
  throw IoError(fmt::format("{}: is damaged: {}; {}", name_, what, kCure));
}

void Database::refuse(int code) {
  throw IoError(fmt::format("{}: {} (SQLite: {})", name_, advice(code),
                            handle_ ? sqlite3_errmsg(handle_.get()) : sqlite3_errstr(code)));
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

}  // namespace wythe::study
