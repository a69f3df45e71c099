// Finds the separator of cells from the first rows with numbers: a mark that all of them have, blanks between
// numbers, or a comma. The first number with a decimal mark fixes that mark for the file. One line before the numbers
// is the header, and a comment with as many names may be one. More lines, and rows of another width, are refused.
#include "io/text/table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <regex>
#include <utility>

#include <fmt/format.h>

#include "core/limits.h"
#include "core/text.h"
#include "io/text/thousands.h"
#include "units/quantity_error.h"
#include "wythe/parts/text.h"
#include "wythe/parts/units.h"

namespace wythe::io {
namespace {

std::string unquoted(const std::string& cell) { return std::string(trimmed(text_of_cell(cell))); }

// Whether a number has a decimal comma: "0,05".
bool has_decimal_comma(std::string_view cell) {
  const std::size_t comma = cell.find(',');
  return comma != std::string_view::npos && comma > 0 && comma + 1 < cell.size() &&
         is_digit(cell[comma - 1]) && is_digit(cell[comma + 1]) &&
         cell.find_first_of(",.", comma + 1) == std::string_view::npos &&
         cell.substr(0, comma).find('.') == std::string_view::npos;
}

// Also accepts the exponent of Fortran, 1.5D-03, and the minus sign of text programs, U+2212.
double number_with_mark(std::string cell, char mark) {
  constexpr std::string_view kMinus = "\u2212";
  for (std::size_t at = cell.find(kMinus); at != std::string::npos; at = cell.find(kMinus))
    cell.replace(at, kMinus.size(), "-");
  const std::size_t exponent = cell.find_first_of("dD");
  if (exponent != std::string::npos && exponent > 0) cell[exponent] = 'e';
  if (mark == ',') cell[cell.find(',')] = '.';
  return number_in(cell);
}

bool is_number(const std::string& cell) {
  return !std::isnan(number_with_mark(cell, has_decimal_comma(cell) ? ',' : '.'));
}

bool are_numbers(const std::vector<std::string>& cells) {
  return std::all_of(cells.begin(), cells.end(),
                     [](const std::string& cell) { return is_number(unquoted(cell)); });
}

bool has_number(const std::vector<std::string>& cells) {
  return std::any_of(cells.begin(), cells.end(),
                     [](const std::string& cell) { return is_number(unquoted(cell)); });
}

// The first lines with numbers, or any first lines if there are none, because a header may contain any mark.
std::vector<std::string> sampled_rows(std::string_view text, const std::string& file) {
  std::vector<std::string> all, rows;
  CsvLines lines(text, file, kWholeLine);
  while (static_cast<int>(all.size()) <= kMostSampledRows && lines.next()) {
    all.push_back(lines.text());
    std::string marks = lines.text();
    std::replace_if(
        marks.begin(), marks.end(), [](char c) { return c == ';' || c == ',' || c == '|'; }, ' ');
    if (has_number(cells_of(marks, kBlanks, kMostColumns))) rows.push_back(lines.text());
  }
  return rows.empty() ? all : rows;
}

std::string unquoted_part(const std::string& line) {
  std::string out;
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (!quoted) out += c;
  }
  return out;
}

// A comma separates cells unless another mark does, or blanks separate numbers.
char delimiter_of(std::string_view text, const std::string& file) {
  const std::vector<std::string> rows = sampled_rows(text, file);
  const auto in_all = [&](const auto& holds) {
    return !rows.empty() && std::all_of(rows.begin(), rows.end(), holds);
  };
  for (const char mark : {';', '\t', '|'}) {
    const auto is_there = [&](const std::string& row) {
      const std::string marks = unquoted_part(row);
      return marks.find(mark) != std::string::npos &&
             (mark != '\t' || marks.find(",\t") == std::string::npos);
    };
    if (in_all(is_there)) return mark;
  }
  const auto is_parted_by_blanks = [](const std::string& row) {
    const std::vector<std::string> cells = cells_of(row, kBlanks, kMostColumns);
    return cells.size() > 1 && are_numbers(cells);
  };
  return in_all(is_parted_by_blanks) ? kBlanks : ',';
}

// Blanks separate names of a header too, but not a name from the brackets after it.
std::vector<std::string> with_brackets(std::vector<std::string> cells) {
  std::vector<std::string> out;
  bool open = false;
  for (std::string& cell : cells) {
    if (!out.empty() && (open || cell.starts_with('[') || cell.starts_with('(')))
      out.back() += ' ' + cell;
    else
      out.push_back(cell);
    open = out.back().find_first_of("[(") != std::string::npos &&
           out.back().find_first_of("])") == std::string::npos;
  }
  return out;
}

}  // namespace

std::string unit_spelling(std::string_view text) {
  std::string unit(trimmed(text));
  const auto replace = [&](std::string_view from, std::string_view to) {
    for (std::size_t at = unit.find(from); at != std::string::npos; at = unit.find(from, at + 1))
      unit.replace(at, from.size(), to);
  };
  replace("_per_", "/");
  replace(" per ", "/");
  replace("**", "^");
  replace("_", "/");
  return unit;
}

std::string spelt_unit(std::string_view text, std::string_view si_unit) {
  const std::string unit = unit_spelling(text);
  for (const std::string& spelling : {unit, small_letters(unit)}) try {
      (void)unit_factor(spelling, si_unit);
      return spelling;
    } catch (const QuantityError&) {  // tries the next spelling
    }
  return "";
}

ColumnHead column_head(std::string_view cell, std::initializer_list<std::string_view> si_units) {
  constexpr std::string_view kMarks = "_ ,/";
  constexpr std::size_t kLongestHead = 100;  // of a header whose unit is not in brackets
  const std::string whole(trimmed(cell));
  const std::size_t open = whole.find_last_of("[({"), close = whole.find_last_of("])}");
  if (open != std::string::npos && close != std::string::npos && open < close) {
    std::string_view name = trimmed(std::string_view(whole).substr(0, open));
    while (name.ends_with('_') || name.ends_with(' ')) name.remove_suffix(1);
    return {whole, std::string(name),
            std::string(trimmed(std::string_view(whole).substr(open + 1, close - open - 1))), true};
  }
  if (whole.size() > kLongestHead) return {whole, whole, ""};
  for (std::size_t at = whole.find_first_of(kMarks); at != std::string::npos;
       at = whole.find_first_of(kMarks, at + 1))
    for (const std::string_view si_unit : si_units) {
      const std::string unit = spelt_unit(whole.substr(at + 1), si_unit);
      if (!unit.empty()) return {whole, whole.substr(0, at), unit};
    }
  return {whole, whole, ""};
}

void check_line_ends(std::string_view text, const std::string& file) {
  std::size_t alone = 0, ends = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n') ++ends;
    if (text[i] == '\r' && (i + 1 == text.size() || text[i + 1] != '\n')) ++alone;
  }
  if (alone > 1 && alone > ends)
    throw InputError({{file, "", "", "has line ends of old Macs, CR alone, and is one line here",
                       "save it with line ends of today, LF or CR LF", 0}});
}

bool is_index_name(std::string_view head) {
  const std::string small = small_letters(trimmed(head));
  if (small.empty() || small == "#" || small.starts_with("unnamed")) return true;
  std::string letters;
  for (const char c : small)
    if (c >= 'a' && c <= 'z') letters += c;
  if (letters.starts_with("time")) letters.erase(0, 4);
  for (const std::string_view known :
       {"n",      "no",     "nr",     "i",       "k",        "id",           "idx",
        "index",  "row",    "rows",   "rowname", "rownames", "rownumber",    "rownum",
        "num",    "number", "sample", "samples", "nsample",  "samplenumber", "point",
        "points", "step",   "steps",  "frame",   "count",    "counter",      "lfdnr"})
    if (letters == known) return true;
  return false;
}

NumberTable::NumberTable(std::string_view text, const std::string& file, HeadRule rule)
    : file_(file), delimiter_(delimiter_of(text, file)), lines_(text, file, delimiter_) {
  check_line_ends(text, file);
  if (!lines_.next()) {
    is_empty_ = true;
    return;
  }
  look_for_lines_before_the_numbers(text);
  const bool begins_with_number = has_number(lines_.cells());
  width_ = lines_.cells().size();
  const std::vector<std::string> names = names_in_comment();
  const bool may_be_head = width_ > 1 && names.size() == width_;
  if (rule == HeadRule::kNeeded && begins_with_number && may_be_head) {
    is_at_row_ = true;
    parse_head(names);
    return;
  }
  if (rule == HeadRule::kNeeded && begins_with_number)
    refuse(lines_.line(), lines_.text(), "a number stands where the names of the columns belong",
           "write a first line with their names, e.g. ft_MPa, or opening_mm,slip_mm of a path");
  if (!begins_with_number) {
    parse_head(lines_.cells());
    width_ = head_.size();
    return;
  }
  is_at_row_ = true;
  const bool tells_times = std::any_of(names.begin(), names.end(), [](const std::string& name) {
    const std::string word = small_letters(name);
    return word == "t" || word.starts_with("time") || word.starts_with("t_") ||
           word.starts_with("t [") || word.starts_with("t (");
  });
  if (may_be_head && tells_times) parse_head(names);
}

// NumPy writes the names of the columns after a #, others after % or !.
std::vector<std::string> NumberTable::names_in_comment() const {
  return with_brackets(cells_of(lines_.comment(), delimiter_, kMostColumns));
}

void NumberTable::parse_head(std::vector<std::string> cells) {
  if (delimiter_ == kBlanks) cells = with_brackets(std::move(cells));
  head_line_ = lines_.line();
  for (const std::string& cell : cells) head_.push_back(unquoted(cell));
}

void NumberTable::look_for_lines_before_the_numbers(std::string_view text) const {
  CsvLines lines(text, file_, delimiter_);
  const auto is_of_words = [&] {
    const auto& cells = lines.cells();
    return !has_number(cells) && std::find(cells.begin(), cells.end(), "") == cells.end();
  };
  int before = 0;
  while (before <= kMostHeadLines && lines.next() && (before == 0 || is_of_words())) {
    if (has_number(lines.cells())) return;
    ++before;
  }
  if (before > 1 && has_number(lines.cells()))
    refuse(lines.line(), "", fmt::format("has {} lines before its first number", before),
           "leave one line with the names of the columns, and begin the others with #");
}

std::string factor_in_head(const std::string& head) {
  std::string small = small_letters(head);
  const std::size_t open = small.find_first_of("[("), close = small.find_first_of("])", open);
  if (open != std::string::npos && close != std::string::npos) small.erase(open, close - open + 1);
  static const std::regex factor(
      R"((^|[\s_])x\s*\d[\d.e]*|(^|[^*])\*\s*\d+|\b\d+\s*\*|×|/\s*10*\b|\b1\s*/|\blog|\bln\b|\bcov of\b|\bstd\b|\bst\.?\s?dev\.?|standard deviation|\bvariance\b)");
  std::smatch found;
  return std::regex_search(small, found, factor) ? std::string(trimmed(found.str())) : "";
}

bool is_missing_mark(double value) {
  const std::string digits = fmt::format("{:g}", std::fabs(value));
  return std::count(digits.begin(), digits.end(), '9') >= 3 &&
         digits.find_first_not_of("9.") == std::string::npos;
}

bool NumberTable::next() {
  const auto is_blank = [&] {  // a row of delimiters only, as spreadsheets leave it
    const std::vector<std::string>& cells = lines_.cells();
    return cells.size() > 1 && std::all_of(cells.begin(), cells.end(), [](const std::string& cell) {
             return cell.find_first_not_of(" \t") == std::string::npos;
           });
  };
  if (is_at_row_)
    is_at_row_ = false;
  else if (!lines_.next())
    return false;
  if (is_blank()) {
    const int first = line();
    while (is_blank())
      if (!lines_.next()) return false;
    refuse(first, "", "is an empty row, and rows of numbers follow it",
           "complete the row, or delete it");
  }
  const std::size_t cells = lines_.cells().size();
  const bool ends_with_mark = cells == width_ + 1 && lines_.cells().back().empty();
  if (cells == width_ || ends_with_mark) return true;
  const std::string problem =
      fmt::format("has {} {}, {} has {}", cells, cells == 1 ? "cell" : "cells",
                  head_.empty() ? "the first row" : "the head", width_);
  // R writes no name for its row numbers; a point after one shows that commas separate cells
  const std::vector<std::string>& row = lines_.cells();
  const bool is_of_r = row.front().find_first_not_of("\"0123456789") == std::string::npos &&
                       std::any_of(row.begin() + 1, row.end(), [](const std::string& cell) {
                         return cell.find('.') != std::string::npos;
                       });
  if (cells == width_ + 1 && !head_.empty() && (delimiter_ != ',' || is_of_r))
    refuse(line(), lines_.text(), problem, "give each column a name, that of row numbers too");
  refuse(line(), lines_.text(), problem,
         delimiter_ == ',' ? "separate cells by commas and decimals by a point, or cells by "
                             "semicolons and decimals by a comma"
                           : "give each row a cell for each column");
}

std::string NumberTable::cell(std::size_t column) const { return unquoted(lines_.cells()[column]); }

double NumberTable::number(std::size_t column) {
  const std::string cell = this->cell(column);
  const bool comma = has_decimal_comma(cell);
  const char mark = comma ? ',' : cell.find('.') != std::string::npos ? '.' : '\0';
  // "0,0936" split at its comma
  const bool are_decimals = delimiter_ == ',' && cell.size() > 1 && cell[0] == '0' &&
                            cell.find_first_not_of("0123456789") == std::string::npos;
  if (are_decimals)
    refuse(line(), lines_.text(), "looks like decimals behind a comma",
           "write decimals behind a point, or separate cells by semicolons");
  if (mark != '\0' && decimal_mark_ != '\0' && mark != decimal_mark_)
    return std::numeric_limits<double>::quiet_NaN();
  const double value = number_with_mark(cell, comma ? ',' : '.');
  if (mark != '\0' && !std::isnan(value)) decimal_mark_ = mark;
  return value;
}

bool NumberTable::may_be_thousands(std::size_t column) const {
  return io::may_be_thousands(this->cell(column));
}

bool NumberTable::tells_decimals(std::size_t column) const {
  return this->cell(column).find_first_of(".,eEdD") != std::string::npos &&
         !may_be_thousands(column);
}

Fault NumberTable::no_number(std::size_t column) const {
  const std::string cell = this->cell(column);
  if (cell.empty())
    return {file_,
            "",
            lines_.text(),
            fmt::format("has no number in column {}", column + 1),
            "write the number that belongs there",
            line()};
  if (is_number(cell))
    return {file_,
            "",
            cell,
            "has another decimal mark than the numbers before it",
            "write decimals in one way: behind a point, or behind a comma with semicolons between "
            "cells",
            line()};
  return {file_,
          "",
          cell,
          "must be a finite number",
          "write it as 0.05 or 1.5e-3, without a unit or marks of thousands",
          line()};
}

void NumberTable::refuse(int line, std::string value, std::string problem, std::string cure) const {
  throw InputError({{file_, "", std::move(value), std::move(problem), std::move(cure), line}});
}

}  // namespace wythe::io
