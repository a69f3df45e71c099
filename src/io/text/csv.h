// Lines of a CSV text, one after the other, as cells: the one place that cuts them (core/limits.h).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace wythe::io {

class CsvLines {
 public:
  // `text` and `file` outlive it.
  CsvLines(std::string_view text, const std::string& file);

  // To the next line that says something: neither blank nor a comment (#). False at the end. Throws
  // InputError at a line of more than kMostColumns cells, and at the line beyond kMostRows.
  bool next();
  [[nodiscard]] const std::vector<std::string>& cells() const { return cells_; }  // trimmed
  [[nodiscard]] const std::string& text() const { return text_of_line_; }         // trimmed
  [[nodiscard]] int line() const { return line_; }                                // from 1

 private:
  [[noreturn]] void refuse(int most, const char* what) const;
  void cut();

  std::string_view rest_;
  const std::string& file_;
  std::string text_of_line_;
  std::vector<std::string> cells_;
  int line_ = 0, rows_ = 0;
};

// Text as one cell (RFC 4180): quoted where it holds what would end it. A spreadsheet runs a cell that begins
// with = + - @ as a formula: such a text gets a ' in front, and so does one that begins with ' itself.
[[nodiscard]] std::string csv_cell(const std::string& text);
// The text of such a cell.
[[nodiscard]] std::string text_of_cell(std::string_view cell);
// The shortest digits that read back as the same number; "" for NaN.
[[nodiscard]] std::string csv_cell(double value);

// A whole cell as a finite number, a leading + allowed; NaN for anything else.
[[nodiscard]] double number_in(std::string_view cell);

}  // namespace wythe::io
