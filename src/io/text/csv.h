// Lines of a text in order, as cells: the only place that splits them (core/limits.h).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wythe::io {

// Delimiters: a character, or any number of blanks and tabs; kWholeLine gives one cell for each line.
constexpr char kBlanks = ' ', kWholeLine = '\n';

class CsvLines {
 public:
  // `text` and `file` must outlive it. A delimiter within quotes is part of its cell.
  CsvLines(std::string_view text, const std::string& file, char delimiter = ',');

  // Moves to the next line that is neither blank nor a comment; false at the end. Throws
  // InputError at a line with more than kMostColumns cells, and at the line beyond kMostRows.
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

// The words of a comment: a line that begins with # or with the mark of another program: % (MATLAB), ! (Fortran), //.
[[nodiscard]] std::optional<std::string_view> comment_in(std::string_view line);

// The trimmed cells of a line, at most `most` + 1.
[[nodiscard]] std::vector<std::string> cells_of(std::string_view line, char delimiter,
                                                std::size_t most);

// A text as one cell (RFC 4180), in quotes where it has characters that end a cell. A spreadsheet runs a cell
// that begins with = + - @ as a formula. So such a text gets a ' in front, and so does one that begins with '.
[[nodiscard]] std::string csv_cell(const std::string& text);
// The text of such a cell; the inverse.
[[nodiscard]] std::string text_of_cell(std::string_view cell);
// The shortest digits that read back as the same number; "" for NaN.
[[nodiscard]] std::string csv_cell(double value);
[[nodiscard]] std::string short_cell(double value);  // ten digits

// A whole cell as a finite number, with a leading + allowed; NaN for other cells.
[[nodiscard]] double number_in(std::string_view cell);

}  // namespace wythe::io
