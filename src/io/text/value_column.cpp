#include "io/text/value_column.h"

#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "core/files.h"
#include "core/limits.h"
#include "core/text.h"
#include "io/text/csv.h"
#include "io/text/magnitude.h"
#include "units/quantity_error.h"
#include "wythe/units.h"

namespace wythe::io {
namespace {

struct Head {
  std::string whole, name, unit;  // "ft_MPa": ft, MPa
};

bool is_unit_of(const std::string& unit, const std::string& si_unit) {
  try {
    (void)unit_factor(unit, si_unit);
    return true;
  } catch (const QuantityError&) {
    return false;
  }
}

// The unit is what stands in brackets, or after the last _ where that is a unit of the right kind.
Head head_of(const std::string& written, const std::string& si_unit) {
  const std::string cell = text_of_cell(written);
  if (cell.empty()) return {};
  const std::size_t bracket = cell.find_first_of("[(");
  if (bracket != std::string::npos && (cell.back() == ']' || cell.back() == ')'))
    return {cell, std::string(trimmed(cell.substr(0, bracket))),
            cell.substr(bracket + 1, cell.size() - bracket - 2)};
  const std::size_t bar = cell.rfind('_');
  if (bar != std::string::npos && is_unit_of(cell.substr(bar + 1), si_unit))
    return {cell, cell.substr(0, bar), cell.substr(bar + 1)};
  return {cell, cell, ""};
}

class ColumnReader {
 public:
  ColumnReader(const ColumnRequest& request, FaultList& faults)
      : request_(request), faults_(faults) {}

  std::vector<double> read(const std::string& text) {
    std::vector<double> values;
    CsvLines lines(text, request_.file);
    const bool has_head = lines.next();
    if (has_head && !read_head(lines)) return {};
    while (!enough(faults_) && lines.next()) read_row(lines, values);
    if (values.empty() && good_)
      refuse("", 0, has_head ? "has no values" : "is empty",
             "write a head such as ft_MPa and one value a line");
    return good_ ? values : std::vector<double>();
  }

 private:
  void refuse(const std::string& value, int line, const std::string& problem,
              const std::string& cure) {
    good_ = false;
    faults_.add({.file = request_.file,
                 .path = request_.column,
                 .value = value,
                 .problem = problem,
                 .cure = cure,
                 .line = line});
  }

  bool read_head(const CsvLines& lines) {
    std::vector<std::string> names;
    std::optional<Head> found;
    line_ = lines.line();
    for (const std::string& cell : lines.cells()) {
      const Head head = head_of(cell, request_.si_unit);
      if (head.whole == request_.column || head.name == request_.column) {
        found = head;
        index_ = names.size();
      }
      names.push_back(head.whole);
    }
    if (!found && request_.column.empty() && names.size() == 1)
      found = head_of(names.front(), request_.si_unit);
    columns_ = names.size();
    if (found) return read_unit(*found);
    if (request_.column.empty())
      refuse("", line_, "has several columns", "name one: column = \"" + names.front() + '"');
    else
      refuse("", line_, "no such column in the head", name_advice(request_.column, names));
    return false;
  }

  bool read_unit(const Head& head) {
    const std::string unit = head.unit.empty() ? request_.unit : head.unit;
    if (request_.si_unit == "1" && unit.empty()) return true;
    if (unit.empty()) {
      refuse(head.whole, line_, "the unit of this column is not known",
             fmt::format("write it in the head, e.g. {}_{}, or as unit = \"{}\" in the study",
                         head.name, request_.si_unit, request_.si_unit));
      return false;
    }
    if (!is_unit_of(unit, request_.si_unit)) {
      refuse(head.whole, line_, fmt::format("{} is not a unit of [{}]", unit, request_.si_unit),
             fmt::format("write it in {} or a multiple of it", request_.si_unit));
      return false;
    }
    unit_ = unit;
    return true;
  }

  void read_row(const CsvLines& lines, std::vector<double>& values) {
    const std::vector<std::string>& cells = lines.cells();
    line_ = lines.line();
    if (cells.size() != columns_)
      return refuse(lines.text(), line_,
                    fmt::format("has {} cells, the head has {}", cells.size(), columns_),
                    "separate the cells by commas, decimals by a point");
    const std::string& cell = cells[index_];
    if (cell.empty() && columns_ > 1) return;  // another column goes on here
    const double number = number_in(cell);
    if (std::isnan(number))
      return refuse(cell, line_, "must be a finite number", "write it with a point, e.g. 0.15");
    // the quantity's own door: 0.15 MPa has the same bits here and in a model
    try {
      const double value =
          unit_.empty() ? number : parse_quantity(cell + ' ' + unit_, request_.si_unit);
      if (const std::string problem = magnitude_problem(value, request_.si_unit); !problem.empty())
        return refuse(cell, line_, problem, "check the unit of its column");
      values.push_back(value);
    } catch (const QuantityError& error) {  // 1e308 GPa
      refuse(cell, line_, error.problem(), error.cure());
    }
  }

  const ColumnRequest& request_;
  FaultList& faults_;
  bool good_ = true;
  int line_ = 0;
  std::size_t index_ = 0, columns_ = 0;
  std::string unit_;  // "" for plain numbers
};

}  // namespace

std::vector<double> read_value_column(const ColumnRequest& request, FaultList& faults) {
  return ColumnReader(request, faults).read(read_text(request.file, kMostCsv));
}

}  // namespace wythe::io
