// The door to HDF5: tables of `wythe export --hdf5`, one group a table, one dataset a column.
//
//   /curves/reaction_kN     float64 (n_row), attributes "unit" and "meaning"
//   /samples/status         UTF-8 text (n_row)
//
// Nothing in the file depends on the moment at which it is written: equal results give equal bytes.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "io/export/export_samples.h"

namespace wythe::io {

class Hdf5File {
 public:
  // Makes the file. Throws IoError here and later where it cannot be written.
  explicit Hdf5File(const std::string& path);
  ~Hdf5File();
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;

  // A new table; its number.
  int add_table(const std::string& name, const std::vector<ExportColumn>& columns);
  // Cells as in the CSV tables: a number, "" for none, or a text with its quotes.
  void add_row(int table, const std::vector<std::string>& cells);
  // Writes what is left. Nothing may be added after it.
  void close();

 private:
  struct Table;
  void flush(Table& table);
  std::string path_;
  std::int64_t file_ = -1;  // hid_t
  std::vector<std::unique_ptr<Table>> tables_;
};

}  // namespace wythe::io
