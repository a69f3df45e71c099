// Lines of a text, one after the other, as cells: the one place that splits them (core/limits.h).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wythe::io {

// Between cells: a mark, or any number of blanks and tabs; of a whole line there is one cell.
constexpr char kBlanks = ' ', kWholeLine = '\n';

class CsvLines {
 public:
  // `text` and `file` outlive it. A mark within quotes is a part of its cell.
  CsvLines(std::string_view text, const std::string& file, char delimiter = ',');

  // To the next line that says something: neither blank nor a comment. False at the end. Throws
  // InputError at a line of more than kMostColumns cells, and at the line beyond kMostRows.
  bool next();
  [[nodiscard]] const std::vector<std::string>& cells() const { return cells_; }  // trimmed
  [[nodiscard]] const std::string& text() const { return text_of_line_; }         // trimmed
  [[nodiscard]] int line() const { return line_; }                                // from 1
  // The last comment before the line, without its mark.
  [[nodiscard]] const std::string& comment() const { return comment_; }

 private:
  [[noreturn]] void refuse(int most, const char* what) const;
  void cut();

  std::string_view rest_;
  const std::string& file_;
  char delimiter_;
  std::string text_of_line_, comment_;
  std::vector<std::string> cells_;
  int line_ = 0, rows_ = 0;
};

// The words of a comment, of a line that begins with # or with the mark of another program: % (MATLAB), ! (Fortran), //.
[[nodiscard]] std::optional<std::string_view> comment_in(std::string_view line);

// A line in cells, trimmed; `most` and one more at most.
[[nodiscard]] std::vector<std::string> cells_of(std::string_view line, char delimiter,
                                                std::size_t most);

// Text as one cell (RFC 4180): quoted where it holds what would end it. A spreadsheet runs a cell that begins
// with = + - @ as a formula: such a text gets a ' in front, and so does one that begins with ' itself.
[[nodiscard]] std::string csv_cell(const std::string& text);
// The text of such a cell.
[[nodiscard]] std::string text_of_cell(std::string_view cell);
// The shortest digits that read back as the same number; "" for NaN.
[[nodiscard]] std::string csv_cell(double value);
[[nodiscard]] std::string short_cell(double value);  // ten digits

// A whole cell as a finite number, a leading + allowed; NaN for anything else.
[[nodiscard]] double number_in(std::string_view cell);

}  // namespace wythe::io
