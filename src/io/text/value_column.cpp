// Finds the column by its header, takes its unit from header or study, and converts each cell to SI. Doubtful
// data are refused with a cure: row numbers, marks of missing values, magnitudes that no wall has, and decimals
// that may be thousands. Cells go through parse_quantity(), so 0.15 MPa has the same bits as in a model.
#include "io/text/value_column.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/ascii.h"
#include "core/files.h"
#include "core/limits.h"
#include "core/text.h"
#include "io/text/magnitude.h"
#include "io/text/table.h"
#include "units/dimension.h"
#include "units/quantity_error.h"
#include "wythe/parts/error.h"
#include "wythe/parts/units.h"

namespace wythe::io {
namespace {

class ColumnReader {
 public:
  ColumnReader(const ColumnRequest& request, FaultList& faults)
      : request_(request), faults_(faults) {}

  std::vector<double> read(const std::string& text) try {
    std::vector<double> values;
    NumberTable table(text, request_.file, HeadRule::kNeeded);
    if (!table.is_empty() && !parse_head(table)) return {};
    while (!enough(faults_) && !table.is_empty() && table.next()) parse_row(table, values);
    if (values.empty() && good_)
      refuse("", 0, table.is_empty() ? "is empty" : "has no values",
             "write a head such as ft_MPa and one value a line");
    if (good_ && !doubtful_.empty() && !tells_decimals_)
      refuse(doubtful_, doubtful_line_, "may have three decimals or marks of thousands",
             fmt::format("write {} where it is thousands, or one more decimal, {}0",
                         without_mark(doubtful_), doubtful_));
    if (good_) refuse_marks();
    if (good_ && are_row_numbers(shown_))
      refuse(head_.whole, line_, "holds row numbers, and no measured values",
             "name the column of the values; if these are some, name it after what they are, with "
             "its unit");
    return good_ ? values : std::vector<double>();
  } catch (const InputError& error) {
    for (const Fault& fault : error.faults()) add(fault);
    return {};
  }

 private:
  void add(Fault fault) {
    good_ = false;
    fault.path = request_.column;
    faults_.add(std::move(fault));
  }
  void refuse(const std::string& value, int line, const std::string& problem,
              const std::string& cure) {
    add({request_.file, "", value, problem, cure, line});
  }

  bool parse_head(const NumberTable& table) {
    std::vector<std::string> names;  // without row numbers
    std::vector<std::size_t> meant;
    for (std::size_t k = 0; k < table.width(); ++k) {
      const ColumnHead head = column_head(table.head()[k], {request_.si_unit});
      if (head.whole.empty()) continue;  // row numbers in the form of pandas and R
      if (!is_index_name(head.whole)) names.push_back(head.whole);
      if (request_.column.empty() || head.whole == request_.column || head.name == request_.column)
        meant.push_back(k);
    }
    line_ = table.head_line();
    columns_ = table.width();
    if (meant.size() == 1) {
      index_ = meant.front();
      head_ = column_head(table.head()[index_], {request_.si_unit});
      return parse_unit();
    }
    if (meant.empty())
      refuse("", line_, "no such column in the head", name_advice(request_.column, names));
    else if (request_.column.empty())
      refuse(joined(table.head(), ", "), line_, "has several columns", column_advice(names));
    else
      refuse(joined(table.head(), ", "), line_, "has several columns of this name",
             "give each a name of its own");
    return false;
  }

  // The advice which column to name, if only one is possible.
  [[nodiscard]] std::string column_advice(const std::vector<std::string>& names) const {
    std::vector<std::string> with_unit;
    for (const std::string& name : names)
      if (!column_head(name, {request_.si_unit}).unit.empty()) with_unit.push_back(name);
    const std::vector<std::string>& best = with_unit.empty() ? names : with_unit;
    if (best.size() == 1) return "name one: column = \"" + best.front() + '"';
    return "name one: column = \"NAME\"" + (best.empty() ? "" : ", of " + joined(best, ", "));
  }

  // A mark of missing data differs strongly from the other values.
  void refuse_marks() {
    double most = 0;
    for (const double value : shown_)
      if (!is_missing_mark(value)) most = std::max(most, std::fabs(value));
    for (const double value : shown_)
      if (is_missing_mark(value) && std::fabs(value) > 2 * most && most > 0)
        return refuse(
            fmt::format("{:g}", value), line_,
            fmt::format("looks like a mark of a missing value: all others are below {:.4g}", most),
            "leave that row out");
  }

  // Whether the values are row numbers: integers under such a name, or 0, 1, 2, ... or 1, 2, 3, ... under another name without a unit.
  [[nodiscard]] bool are_row_numbers(const std::vector<double>& shown) const {
    constexpr std::size_t kFew = 5;
    const auto is_whole = [](double value) { return value == std::round(value); };
    const bool are_whole = std::all_of(shown.begin(), shown.end(), is_whole);
    if (is_index_name(head_.whole)) return are_whole && !shown.empty();
    if (!head_.unit.empty() || !are_whole || shown.size() < kFew || shown.front() > 1 ||
        shown.front() < 0)
      return false;
    for (std::size_t k = 1; k < shown.size(); ++k)
      if (shown[k] != shown[k - 1] + 1) return false;
    return true;
  }

  // The standard spelling of the unit; "" where it is no unit of the quantity, which is reported.
  std::string known_unit(const std::string& stated) {
    const bool is_angle =
        stated.find("deg") != std::string::npos || stated.find("°") != std::string::npos;
    if (request_.si_unit == "1" && is_angle) {
      refuse(head_.whole, line_, stated + " is of angles, and this is a number without unit",
             "write the number: of a friction angle its tangent");
      return "";
    }
    std::string unit = spelt_unit(stated, request_.si_unit);
    if (unit.empty()) try {
        (void)unit_factor(unit_spelling(stated), request_.si_unit);
      } catch (const QuantityError& error) {
        refuse(head_.whole, line_, error.problem(), error.cure());
      }
    return unit;
  }

  // "rho_kN_m3" or "rho_ton_m3" for a density: a header whose end looks like a unit, but is not supported.
  [[nodiscard]] std::string foreign_unit() const {
    constexpr std::string_view kMarks = "_ ,";
    const std::string& whole = head_.whole;
    for (std::size_t at = whole.find_first_of(kMarks); at != std::string::npos;
         at = whole.find_first_of(kMarks, at + 1)) {
      const std::string end = unit_spelling(whole.substr(at + 1));
      const std::size_t slash = end.find('/');
      if (slash != std::string::npos && slash + 1 < end.size() && is_ascii_letter(end[slash + 1]) &&
          is_digit(end.back()) && !unit_definition(end).empty())
        return end;
    }
    return "";
  }

  bool parse_unit() {
    if (const std::string factor = factor_in_head(head_.whole); !factor.empty()) {
      refuse(head_.whole, line_, fmt::format("may not be the value itself: {} changes it", factor),
             "write the values under their name and unit alone, e.g. ft [MPa]");
      return false;
    }
    if (head_.unit.empty())
      if (const std::string foreign = foreign_unit();
          !foreign.empty() && known_unit(foreign).empty())
        return false;
    if (request_.si_unit == "1" && head_.unit.empty() && request_.unit.empty()) return true;
    if (head_.unit.empty() && request_.unit.empty()) {
      refuse(head_.whole, line_, "the unit of this column is not known",
             fmt::format("write it in the head, e.g. {}_{}, or as unit = \"{}\" in the study",
                         head_.name, request_.si_unit, request_.si_unit));
      return false;
    }
    std::string of_head, of_study;
    if (!head_.unit.empty() && (of_head = known_unit(head_.unit)).empty()) return false;
    if (!request_.unit.empty() && (of_study = known_unit(request_.unit)).empty()) return false;
    unit_ = of_head.empty() ? of_study : of_head;
    if (of_head.empty() || of_study.empty()) return true;
    constexpr double kRounding = 1e-12;
    const double ratio =
        unit_factor(of_head, request_.si_unit) / unit_factor(of_study, request_.si_unit);
    if (std::fabs(ratio - 1) <= kRounding) return true;
    refuse(head_.whole, line_,
           fmt::format("{} is not the unit of the study, {}", head_.unit, request_.unit),
           "leave unit out of the study, or correct the head");
    return false;
  }

  static std::string without_mark(std::string cell) {
    std::erase_if(cell, [](char c) { return c == '.' || c == ','; });
    return cell;
  }

  // "1.900" is ambiguous if no other value settles it, and
  // a thousand times the value is possible for a wall.
  void look_for_thousands(const NumberTable& table, double as_thousands) {
    tells_decimals_ = tells_decimals_ || table.tells_decimals(index_);
    if (!doubtful_.empty() || !table.may_be_thousands(index_) ||
        !magnitude_problem(as_thousands, request_.si_unit).empty())
      return;
    doubtful_ = table.cell(index_);
    doubtful_line_ = table.line();
  }

  void parse_row(NumberTable& table, std::vector<double>& values) {
    if (columns_ > 1 && table.cell(index_).empty()) return;  // only another column continues here
    const double number = table.number(index_);
    if (std::isnan(number)) return add(table.no_number(index_));
    const std::string cell = table.cell(index_);
    // parsed like every quantity: 0.15 MPa has the same bits here and in a model
    try {
      const double value =
          unit_.empty() ? number
                        : parse_quantity(fmt::format("{} {}", number, unit_), request_.si_unit);
      if (const std::string problem = magnitude_problem(value, request_.si_unit); !problem.empty())
        return refuse(cell, table.line(), problem, "check the unit of its column");
      look_for_thousands(table, 1e3 * value);
      values.push_back(value);
      shown_.push_back(number);
    } catch (const QuantityError& error) {  // 1e308 GPa
      refuse(cell, table.line(), error.problem(), error.cure());
    }
  }

  const ColumnRequest& request_;
  FaultList& faults_;
  bool good_ = true;
  int line_ = 0;
  std::size_t index_ = 0, columns_ = 0;
  ColumnHead head_;
  std::string doubtful_;  // the first value that may be thousands
  int doubtful_line_ = 0;
  bool tells_decimals_ = false;
  std::vector<double> shown_;  // as written in the file
  std::string unit_;           // "" for plain numbers
};

}  // namespace

std::vector<double> parse_value_column(const ColumnRequest& request, FaultList& faults) {
  return ColumnReader(request, faults).read(read_text(request.file, kMostCsv));
}

}  // namespace wythe::io
