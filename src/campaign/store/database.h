// The only access to SQLite: a connection, prepared statements, transactions.
// Every failure is an IoError that names the file, the fault and the cure.
#pragma once

#include <concepts>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "wythe/parts/error.h"

struct sqlite3;
struct sqlite3_stmt;

namespace wythe {
class Hash;
}

namespace wythe::study {

// A failure of the disk or a conflict with another program; the data of the file may be valid.
class DiskError : public IoError {
 public:
  DiskError(std::string reason, const std::string& what)
      : IoError(what), reason_(std::move(reason)) {}
  [[nodiscard]] const std::string& reason() const { return reason_; }  // as SQLite says it

 private:
  std::string reason_;
};

// The cure for a store that is damaged.
inline constexpr const char* kCureOfDamage =
    "restore it from a copy, or remove it and start the same campaign (or this one shard) again: "
    "it draws the same samples";

struct Bytes {
  std::string_view data;
};

class Database;

class Statement {
 public:
  Statement(Database& database, const std::string& sql);

  // Binds the next parameter; a NaN is stored as NULL.
  void bind(double value);
  void bind(std::int64_t value);
  void bind(std::string_view text);
  void bind(Bytes bytes);
  void bind_null();
  // Binds a whole row of another statement, value by value.
  void bind_row(Statement& row);
  template <std::integral I>
  void bind(I value) {
    bind(static_cast<std::int64_t>(value));
  }
  void bind(const char* text) { bind(std::string_view(text)); }
  void bind(const std::string& text) { bind(std::string_view(text)); }

  // Runs to the next row: false when there is none.
  bool step();
  // Resets the statement for the next binds.
  void reset();
  template <class... Values>
  void run(const Values&... values) {
    (bind(values), ...);
    while (step()) continue;
    reset();
  }

  [[nodiscard]] int columns() const;
  // The next column of the row; NULL gives NaN, 0 or "". A value of another type is damage.
  [[nodiscard]] double number();
  [[nodiscard]] std::int64_t integer();
  [[nodiscard]] std::string text();
  [[nodiscard]] std::string_view bytes();  // until the next step
  // An integer within these bounds, with NULL as damage; and a finite number, with NULL as damage.
  [[nodiscard]] std::int64_t integer(std::int64_t least, std::int64_t most);
  [[nodiscard]] double finite();
  // Accessors by column position: equality to the bit with another row, the
  // name, the value for a message, and packed bytes (empty for another type).
  [[nodiscard]] bool equals(Statement& other, int at);
  [[nodiscard]] std::string column(int at) const;
  [[nodiscard]] std::string shown(int at);
  [[nodiscard]] std::string_view packed_at(int at);
  // Adds the whole row to a hash: each value with its type and all its bits.
  void add_row(Hash& hash);
  // Reports another fault of the row: throws IoError with file, table and sample.
  [[noreturn]] void damaged(const std::string& what);

 private:
  int take(const std::string& wanted, int type, int other_type = 0);
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  void check(int code) const;

  Database& database_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
  std::string table_;  // for messages
  int parameter_ = 0, column_ = 0;
};

class Database {
 public:
  // A reader creates, recovers and removes nothing, neither the file nor the files beside it (-wal,
  // -shm). It sees all committed data, also while a campaign writes there or after it was killed.
  enum class Access { kRead, kWrite };
  Database(const std::filesystem::path& file, Access access);

  void execute(const std::string& sql);
  [[nodiscard]] std::int64_t integer(const std::string& sql);
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] sqlite3* handle() { return handle_.get(); }
  // Counts bytes that are about to be unpacked from this file; throws if all of them exceed the memory.
  void take(double bytes);
  // For a reader that stays open: whether another program has written data that this connection may not see.
  [[nodiscard]] bool is_outdated() const;
  // The bytes counted so far are free again.
  void give_back() { taken_ = 0; }
  // Throws the last failure of SQLite as an IoError.
  [[noreturn]] void refuse(int code);
  // Throws an IoError: the file contains impossible data, so it is damaged.
  [[noreturn]] void damaged(const std::string& what) const;

 private:
  struct Close {
    void operator()(sqlite3* handle) const;
  };
  int open(const std::string& how, int flags);
  void open_to_read();
  [[nodiscard]] std::int64_t last_written() const;  // changes with each change of the file
  void refuse_if_written() const;

  std::string name_;
  bool is_immutable_ = false;  // opened without locks
  std::int64_t written_ = 0;
  double taken_ = 0;                                        // bytes
  double most_ = std::numeric_limits<double>::quiet_NaN();  // the largest allowed number; set once
  std::unique_ptr<sqlite3, Close> handle_;
};

// A transaction: rolled back unless commit() is called.
class Transaction {
 public:
  explicit Transaction(Database& database);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  Database& database_;
  bool open_ = true;
};

// A database that is created beside its place as FILE.new, and moved there when complete. A stopped program leaves none.
class NewDatabase {
 public:
  // Throws like a Database that is opened for writing.
  explicit NewDatabase(const std::filesystem::path& file);
  ~NewDatabase();
  NewDatabase(const NewDatabase&) = delete;
  NewDatabase& operator=(const NewDatabase&) = delete;
  [[nodiscard]] Database& database() { return *database_; }
  // Call once, at the end. Throws DiskError.
  void put_in_place();
  // Throws a DiskError about the file in its place.
  [[noreturn]] void refuse(const std::string& reason) const;

 private:
  void remove_leftovers() const;

  std::string name_, fresh_;
  std::optional<Database> database_;
};

}  // namespace wythe::study
