// Collects rows by column and writes them in chunks of 16384, with compressed numbers. A Handle holds an object of the
// file and closes it; an error of HDF5 throws IoError. Times of objects are not stored, so equal results give equal bytes.
#include "io/text/hdf5_tables.h"

#include <hdf5.h>

#include <limits>

#include "io/text/csv.h"
#include "wythe/parts/error.h"

namespace wythe::io {
namespace {

constexpr hsize_t kChunk = 16384;  // rows that are written and compressed together
constexpr unsigned kDeflate = 4;

static_assert(sizeof(hid_t) == sizeof(std::int64_t));

// A handle of HDF5, closed with its own function; negative ones are errors.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle(hid_t id, Close close, const std::string& path) : id_(id), close_(close) {
    if (id < 0) throw IoError(path + ": cannot be written as HDF5; is the disk full?");
  }
  ~Handle() { close_(id_); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  Close close_;
};

void check(herr_t answer, const std::string& path) {
  if (answer < 0) throw IoError(path + ": cannot be written as HDF5; is the disk full?");
}

}  // namespace

struct Hdf5File::Table {
  std::string name;
  std::vector<ExportColumn> columns;
  std::vector<std::vector<double>> numbers;     // of each column, not yet written
  std::vector<std::vector<std::string>> texts;  // the same
  hsize_t waiting = 0, written = 0;             // rows
};

Hdf5File::Hdf5File(const std::string& path) : path_(path) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // wythe reports errors itself
  file_ = H5Fcreate(path.c_str(), H5F_ACC_EXCL, H5P_DEFAULT, H5P_DEFAULT);
  if (file_ < 0) throw IoError(path + ": cannot be made");
}

Hdf5File::~Hdf5File() {
  if (file_ >= 0) H5Fclose(file_);
}

namespace {

hid_t text_type() {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, H5T_VARIABLE);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return type;
}

void write_attribute(hid_t dataset, const char* name, const std::string& text,
                     const std::string& path) {
  if (text.empty()) return;
  const Handle type(text_type(), H5Tclose, path);
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, path);
  const Handle attribute(H5Acreate2(dataset, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                         path);
  const char* content = text.c_str();
  check(H5Awrite(attribute, type, &content), path);
}

void make_dataset(hid_t group, const ExportColumn& column, const std::string& path) {
  const hsize_t none = 0, any = H5S_UNLIMITED;
  const Handle space(H5Screate_simple(1, &none, &any), H5Sclose, path);
  const Handle how(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, path);
  check(H5Pset_chunk(how, 1, &kChunk), path);
  check(H5Pset_obj_track_times(how, false), path);
  if (!column.is_text) check(H5Pset_shuffle(how), path), check(H5Pset_deflate(how, kDeflate), path);
  const Handle text(text_type(), H5Tclose, path);
  const hid_t type = column.is_text ? hid_t{text} : H5T_IEEE_F64LE;
  const Handle dataset(
      H5Dcreate2(group, column.name.c_str(), type, space, H5P_DEFAULT, how, H5P_DEFAULT), H5Dclose,
      path);
  write_attribute(dataset, "unit", column.unit, path);
  write_attribute(dataset, "meaning", column.meaning, path);
}

}  // namespace

int Hdf5File::add_table(const std::string& name, const std::vector<ExportColumn>& columns) {
  const Handle how(H5Pcreate(H5P_GROUP_CREATE), H5Pclose, path_);
  check(H5Pset_obj_track_times(how, false), path_);
  // columns keep the order of their creation
  check(H5Pset_link_creation_order(how, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED), path_);
  const Handle group(H5Gcreate2(file_, name.c_str(), H5P_DEFAULT, how, H5P_DEFAULT), H5Gclose,
                     path_);
  auto table = std::make_unique<Table>();
  table->name = name;
  table->columns = columns;
  table->numbers.resize(columns.size());
  table->texts.resize(columns.size());
  for (const ExportColumn& column : columns) make_dataset(group, column, path_);
  tables_.push_back(std::move(table));
  return static_cast<int>(tables_.size()) - 1;
}

void Hdf5File::add_row(int number, const std::vector<std::string>& cells) {
  Table& table = *tables_[number];
  for (std::size_t c = 0; c < table.columns.size(); ++c)
    if (table.columns[c].is_text)
      table.texts[c].push_back(text_of_cell(cells[c]));
    else
      table.numbers[c].push_back(cells[c].empty() ? std::numeric_limits<double>::quiet_NaN()
                                                  : number_in(cells[c]));
  if (++table.waiting == kChunk) flush(table);
}

void Hdf5File::flush(Table& table) {
  if (table.waiting == 0) return;
  const hsize_t all = table.written + table.waiting;
  const Handle memory(H5Screate_simple(1, &table.waiting, nullptr), H5Sclose, path_);
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const std::string name = "/" + table.name + "/" + table.columns[c].name;
    const Handle dataset(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose, path_);
    check(H5Dset_extent(dataset, &all), path_);
    const Handle space(H5Dget_space(dataset), H5Sclose, path_);
    check(H5Sselect_hyperslab(space, H5S_SELECT_SET, &table.written, nullptr, &table.waiting,
                              nullptr),
          path_);
    if (table.columns[c].is_text) {
      const Handle type(text_type(), H5Tclose, path_);
      std::vector<const char*> texts;
      for (const std::string& text : table.texts[c]) texts.push_back(text.c_str());
      check(H5Dwrite(dataset, type, memory, space, H5P_DEFAULT, texts.data()), path_);
      table.texts[c].clear();
    } else {
      check(
          H5Dwrite(dataset, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, table.numbers[c].data()),
          path_);
      table.numbers[c].clear();
    }
  }
  table.written = all;
  table.waiting = 0;
}

void Hdf5File::close() {
  for (const std::unique_ptr<Table>& table : tables_) flush(*table);
  const hid_t file = file_;
  file_ = -1;
  check(H5Fclose(file), path_);
}

}  // namespace wythe::io
