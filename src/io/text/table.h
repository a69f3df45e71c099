// Tables of numbers from other programs, with one head or none: the one reader of records, measured values and
// paths. It finds the separator of cells and the decimal mark, and refuses what can be read in two ways.
//
//   time_s,acc_cm_s2      "time";"acc (g)"      t [s]   acc [cm/s^2]      # time acc
//   0.00,1.5              0,00;0,12             0.00    1.5               0.00 1.5
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "io/text/csv.h"
#include "wythe/parts/error.h"

namespace wythe::io {

// What a head says of its column: "acc [cm/s^2]" -> acc, cm/s^2.
struct ColumnHead {
  std::string whole, name, unit;
  bool in_brackets = false;  // the unit: whatever stands in brackets is one
};
// Without brackets the unit is the end of the head, behind a _ or a blank, where that is one of these quantities:
// "acc_m_per_s2" -> acc, m/s2 for {"m/s^2"}.
[[nodiscard]] ColumnHead column_head(std::string_view cell,
                                     std::initializer_list<std::string_view> si_units);
// What of a head beside its unit may change the numbers, "" where nothing does: "x100" of "ft x100 [MPa]", "/10", "log", "CoV".
[[nodiscard]] std::string factor_in_head(const std::string& head);
// 999, -9999.99 and the like, which stand for a value that is missing.
[[nodiscard]] bool is_missing_mark(double value);
// "cm/sec^2" for what heads write: "cm/sec**2", "cm per sec^2", "cm_sec^2".
[[nodiscard]] std::string unit_spelling(std::string_view text);
// A unit as heads spell it, "cm/sec**2", "m_per_s2", as units are spelt here; "" where it is none of `si_unit`.
[[nodiscard]] std::string spelt_unit(std::string_view text, std::string_view si_unit);

// Whether the name is one of row numbers, "nr" or "#", and of no measured value.
[[nodiscard]] bool is_index_name(std::string_view head);

enum class HeadRule { kNeeded, kMayLack };  // kMayLack: a first line with a number is a row

// Refuses a text whose lines end with CR alone, as old Macs wrote them: it would be one line.
void check_line_ends(std::string_view text, const std::string& file);

class NumberTable {
 public:
  // `text` and `file` outlive it. Throws InputError where it can't tell what stands between cells, or where
  // several lines stand before the first number.
  NumberTable(std::string_view text, const std::string& file, HeadRule rule);

  [[nodiscard]] bool is_empty() const { return is_empty_; }
  // The names of the columns, without quotes; empty where there is no head.
  [[nodiscard]] const std::vector<std::string>& head() const { return head_; }
  [[nodiscard]] int head_line() const { return head_line_; }
  [[nodiscard]] std::size_t width() const { return width_; }

  // To the next row. Throws InputError where its cells are not as many as the head's.
  bool next();
  [[nodiscard]] std::string cell(std::size_t column) const;  // of the row, without quotes
  // Of a row; NaN for what is no finite number, or one with the other decimal mark than those before.
  [[nodiscard]] double number(std::size_t column);
  [[nodiscard]] Fault no_number(std::size_t column) const;  // what is wrong with it
  // Whether the cell, a number, may have thousands as well as three decimals: "1.900", "1,900".
  [[nodiscard]] bool may_be_thousands(std::size_t column) const;
  // Whether the cell tells which: it has decimals that are no thousands.
  [[nodiscard]] bool tells_decimals(std::size_t column) const;
  [[nodiscard]] int line() const { return lines_.line(); }

 private:
  void look_for_lines_before_the_numbers(std::string_view text) const;
  [[nodiscard]] std::vector<std::string> names_in_comment() const;
  void parse_head(std::vector<std::string> cells);
  [[noreturn]] void refuse(int line, std::string value, std::string problem,
                           std::string cure) const;

  const std::string& file_;
  char delimiter_;
  CsvLines lines_;
  std::vector<std::string> head_;
  std::size_t width_ = 0;
  int head_line_ = 0;
  bool is_empty_ = false, is_at_row_ = false;
  char decimal_mark_ = '\0';  // '\0': none seen yet
};

}  // namespace wythe::io
