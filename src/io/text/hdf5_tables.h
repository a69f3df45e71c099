// The only access to HDF5: tables of `wythe export --hdf5`, one group for each table, one dataset for each column.
//
//   /curves/reaction_kN     float64 (n_row), attributes "unit" and "meaning"
//   /samples/status         UTF-8 text (n_row)
//
// The file does not depend on the time of writing, so equal results give equal bytes.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "io/export/export_samples.h"

namespace wythe::io {

class Hdf5File {
 public:
  // Creates the file. Throws IoError, also later, where it cannot be written.
  explicit Hdf5File(const std::string& path);
  ~Hdf5File();
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;

  // Adds a table; returns its number.
  int add_table(const std::string& name, const std::vector<ExportColumn>& columns);
  // Cells as in the CSV tables: a number, "" for none, or a text with its quotes.
  void add_row(int table, const std::vector<std::string>& cells);
  // Writes the remaining rows. Nothing may be added afterwards.
  void close();

 private:
  struct Table;
  void flush(Table& table);
  std::string path_;
  std::int64_t file_ = -1;  // hid_t
  std::vector<std::unique_ptr<Table>> tables_;
};

}  // namespace wythe::io
