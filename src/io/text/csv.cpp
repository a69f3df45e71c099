// Splits lines into cells, where a delimiter in quotes does not separate, and writes cells. A text that a spreadsheet
// would run as a formula gets an apostrophe in front, which text_of_cell() removes again. NaN becomes an empty cell.
#include "io/text/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "core/limits.h"
#include "core/number.h"
#include "core/text.h"
#include "wythe/parts/error.h"

namespace wythe::io {

CsvLines::CsvLines(std::string_view text, const std::string& file, char delimiter)
    : rest_(text), file_(file), delimiter_(delimiter) {
  if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);  // as spreadsheets write it
}

bool CsvLines::next() {
  while (!rest_.empty()) {
    const std::size_t end = rest_.find('\n');
    const std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    ++line_;
    text_of_line_ = trimmed(line);
    if (const auto comment = comment_in(text_of_line_)) {
      comment_ = *comment;
      continue;
    }
    if (text_of_line_.empty()) continue;
    if (++rows_ > kMostRows + 1) refuse(kMostRows, "rows");  // with the header
    // an empty first cell begins with the tab that ends it
    cells_ = cells_of(delimiter_ == '\t' ? line : text_of_line_, delimiter_, kMostColumns);
    if (cells_.size() > kMostColumns) refuse(kMostColumns, "cells in a line");
    return true;
  }
  return false;
}

std::optional<std::string_view> comment_in(std::string_view line) {
  line = trimmed(line);
  const bool is_unit = line.starts_with("%g") || line.starts_with("% g");  // in a header: "%g,%g"
  for (const std::string_view mark : {"#", "%", "!", "//"})
    if (line.starts_with(mark) && !is_unit) {
      while (line.starts_with(mark)) line.remove_prefix(mark.size());
      return trimmed(line);
    }
  return std::nullopt;
}

std::vector<std::string> cells_of(std::string_view line, char delimiter, std::size_t most) {
  std::vector<std::string> cells;
  const auto ends = [&](char c) { return c == delimiter || (delimiter == kBlanks && c == '\t'); };
  std::size_t begin = 0;
  bool quoted = false;
  for (std::size_t i = 0; i <= line.size() && cells.size() <= most; ++i) {
    if (i < line.size() && line[i] == '"') quoted = !quoted;
    if (i < line.size() && (quoted || !ends(line[i]))) continue;
    const std::string_view cell = trimmed(line.substr(begin, i - begin));
    if (delimiter != kBlanks || !cell.empty()) cells.emplace_back(cell);
    begin = i + 1;
  }
  return cells;
}

void CsvLines::refuse(int most, const char* what) const {
  throw InputError({{.file = file_,
                     .problem = fmt::format("has more than {} {}", most, what),
                     .cure = "name the file that is meant, or split it (docs/reference/limits.md)",
                     .line = line_}});
}

namespace {

// Characters that make a cell a formula in some spreadsheets; the wide forms do so in Chinese and Japanese ones.
bool is_formula(std::string_view text) {
  constexpr std::string_view kStarts[] = {"=",  "+",      "-",      "@",      "\t",    "\r",
                                          "\n", "\uFF1D", "\uFF0B", "\uFF0D", "\uFF20"};
  return std::any_of(std::begin(kStarts), std::end(kStarts),
                     [&](std::string_view start) { return text.starts_with(start); });
}

constexpr char kGuard = '\'';

}  // namespace

std::string csv_cell(const std::string& text) {
  const bool guarded = is_formula(text) || text.starts_with(kGuard);
  const std::string guard(guarded ? 1 : 0, kGuard);
  if (text.find_first_of(",\"\r\n") == std::string::npos) return guard + text;
  std::string out = "\"" + guard;
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + "\"";
}

std::string text_of_cell(std::string_view cell) {
  std::string text(cell);
  if (cell.size() > 1 && cell.front() == '"' && cell.back() == '"') {
    text.clear();
    for (std::size_t i = 1; i + 1 < cell.size(); ++i) {
      text += cell[i];
      if (cell[i] == '"') ++i;  // a doubled quote
    }
  }
  return text.starts_with(kGuard) ? text.substr(1) : text;
}

std::string csv_cell(double value) { return std::isnan(value) ? "" : fmt::format("{}", value); }

std::string short_cell(double value) {
  return std::isnan(value) ? "" : fmt::format("{:.10g}", value);
}

double number_in(std::string_view cell) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  constexpr std::size_t kLongestNumber =
      2000;  // every double has fewer digits; 64 MB of them take seconds
  if (cell.size() > kLongestNumber) return kNone;
  if (cell.starts_with('+')) cell.remove_prefix(1);
  const double number = parse_number(cell).value_or(kNone);
  return std::isfinite(number) ? number : kNone;
}

}  // namespace wythe::io
