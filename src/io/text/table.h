// Tables of numbers from other programs, with a header or without: the only reader of records, measured
// values and paths. It finds the separator of cells and the decimal mark, and refuses ambiguous text.
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

// Name and unit in a header: "acc [cm/s^2]" -> acc, cm/s^2.
struct ColumnHead {
  std::string whole, name, unit;
  bool in_brackets = false;  // the unit is in brackets; any text in brackets counts as a unit
};
// Without brackets the unit is the end of the header, after a _ or a blank, if it
// is a unit of one of these quantities: "acc_m_per_s2" -> acc, m/s2 for {"m/s^2"}.
[[nodiscard]] ColumnHead column_head(std::string_view cell,
                                     std::initializer_list<std::string_view> si_units);
// The part of a header, beside its unit, that may change the numbers: "x100" of "ft x100 [MPa]", "/10", "log", "CoV"; else "".
[[nodiscard]] std::string factor_in_head(const std::string& head);
// Whether a value stands for a missing one: 999, -9999.99 and the like.
[[nodiscard]] bool is_missing_mark(double value);
// "cm/sec^2" for spellings in headers: "cm/sec**2", "cm per sec^2", "cm_sec^2".
[[nodiscard]] std::string unit_spelling(std::string_view text);
// The standard spelling of a unit in a header, "cm/sec**2", "m_per_s2"; "" where it is no unit of `si_unit`.
[[nodiscard]] std::string spelt_unit(std::string_view text, std::string_view si_unit);

// Whether the name is one of row numbers, "nr" or "#", and not of a measured value.
[[nodiscard]] bool is_index_name(std::string_view head);

enum class HeadRule { kNeeded, kMayLack };  // kMayLack: a first line with a number is a row

// Refuses a text with line ends of CR alone, as old Macs wrote them, because it would be one line.
void check_line_ends(std::string_view text, const std::string& file);

class NumberTable {
 public:
  // `text` and `file` must outlive it. Throws InputError where the separator of
  // cells is not clear, or where several lines come before the first number.
  NumberTable(std::string_view text, const std::string& file, HeadRule rule);

  [[nodiscard]] bool is_empty() const { return is_empty_; }
  // The names of the columns, without quotes; empty where there is no header.
  [[nodiscard]] const std::vector<std::string>& head() const { return head_; }
  [[nodiscard]] int head_line() const { return head_line_; }
  [[nodiscard]] std::size_t width() const { return width_; }

  // Moves to the next row. Throws InputError where it has another number of cells than the header.
  bool next();
  [[nodiscard]] std::string cell(std::size_t column) const;  // of the row, without quotes
  // A number of the row; NaN for a cell that is not a finite number, or has another decimal mark than earlier ones.
  [[nodiscard]] double number(std::size_t column);
  [[nodiscard]] Fault no_number(std::size_t column) const;  // what is wrong with it
  // Whether the cell, a number, may mean thousands as well as three decimals: "1.900", "1,900".
  [[nodiscard]] bool may_be_thousands(std::size_t column) const;
  // Whether the cell settles this: it has decimals that cannot be thousands.
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
