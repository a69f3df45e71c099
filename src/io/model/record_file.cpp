// Records of accelerations -> RecordSpec::read_times, read_accelerations: tables of numbers, and formats of the
// field (record_formats.h). The key or the head names the column of a table; it is never guessed.
#include "io/model/record_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include "core/files.h"
#include "core/limits.h"
#include "core/text.h"
#include "io/model/record_formats.h"
#include "io/model/record_heads.h"
#include "io/text/table.h"
#include "model/shaking.h"
#include "wythe/parts/text.h"
#include "wythe/parts/units.h"

namespace wythe::io {
namespace {

class TableRecord {
 public:
  TableRecord(const RecordSpec& record, const std::string& path, const std::string& file)
      : record_(record), path_(path), file_(file) {}

  RecordNumbers read(const std::string& text) {
    NumberTable table(text, file_, HeadRule::kMayLack);
    if (table.is_empty())
      refuse("file", "", "is empty", "give a record: time_s,acceleration and one row a time");
    for (const std::string& head : table.head()) columns_.push_back(column_of(head));
    if (columns_.empty()) columns_.resize(table.width());
    has_head_ = !table.head().empty();
    head_line_ = table.head_line();
    choose_times();
    if (!has_head_ && record_.column.empty() && tells_of_other_motion(comments_before(text)))
      refuse("column", "",
             fmt::format("is missing: the comments of {} speak of velocities or displacements, and "
                         "not of accelerations",
                         file_),
             fmt::format("write {}.column = 2, or whichever holds accelerations", path_));
    choose_accelerations();
    check_heads();
    check_comments(text);
    parse_rows(table);
    check_times();
    check_stated();
    RecordNumbers n = std::move(numbers_);
    n.column = has_head_ ? columns_[column_].head.whole : fmt::format("{}", column_ + 1);
    return n;
  }

 private:
  static constexpr std::size_t kNone = -1;
  static constexpr double kCoarsest = 0.5;  // in a record: the coarsest in use have 0.02 s [s]

  [[noreturn]] void refuse(const char* key, std::string value, std::string problem,
                           std::string cure, int line = 0) const {
    throw InputError({{line > 0 || std::string_view(key) == "file" ? file_ : "", path_ + '.' + key,
                       std::move(value), std::move(problem), std::move(cure), line}});
  }

  // The comments before the numbers, with their comment marks.
  static std::string comments_before(std::string_view text) {
    std::string all;
    for (; !text.empty(); text.remove_prefix(std::min(text.size(), text.find('\n')) +
                                             (text.find('\n') == std::string_view::npos ? 0 : 1))) {
      const std::string_view line = trimmed(text.substr(0, text.find('\n')));
      if (!line.empty() && !comment_in(line)) break;
      all += std::string(line.substr(0, 1000)) + '\n';
    }
    return all;
  }

  // "time_s, ns, ew", or the column numbers.
  [[nodiscard]] std::string names() const {
    std::vector<std::string> all;
    for (const Column& column : columns_) all.push_back(column.head.whole);
    return has_head_ ? joined(all, ", ") : fmt::format("1 to {}", columns_.size());
  }
  [[nodiscard]] std::vector<std::size_t> of_kind(ColumnKind kind) const {
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < columns_.size(); ++k)
      if (columns_[k].kind == kind && k != time_) found.push_back(k);
    return found;
  }

  void choose_times() {
    const std::vector<std::size_t> named = of_kind(ColumnKind::kTime);
    if (named.size() > 1)
      refuse("file", names(), "has several columns of times", "leave one of them", head_line_);
    if (!named.empty()) {
      time_ = named.front();
      return;
    }
    // without a name: the first of two, or the first column without a header
    const std::vector<std::size_t> motions = of_kind(ColumnKind::kAcceleration);
    const std::vector<std::size_t> rows = of_kind(ColumnKind::kIndex);
    const std::size_t width = columns_.size() - rows.size();
    const bool is_told = has_head_ ? width == 2 && motions.size() < 2 : width > 1;
    if (!is_told || (!has_head_ && width > 2 && !std::isnan(record_.step))) return;
    for (std::size_t k = 0; k < columns_.size() && time_ == kNone; ++k)
      if (columns_[k].kind == ColumnKind::kUnknown && !columns_[k].is_component) time_ = k;
    if (time_ == kNone && std::isnan(record_.step))
      refuse("file", names(), "has no column of times",
             "name it time_s where it is one, or write step = \"0.005 s\"", head_line_);
  }

  void choose_accelerations() {
    if (!record_.column.empty()) return choose_named();
    const std::vector<std::size_t> motions = of_kind(ColumnKind::kAcceleration);
    const std::vector<std::size_t> unknown = of_kind(ColumnKind::kUnknown);
    const std::vector<std::size_t> others = of_kind(ColumnKind::kOther);
    is_named_ = motions.size() == 1;
    if (is_named_)
      column_ = motions.front();
    else if (motions.empty() && unknown.size() == 1 && others.empty() &&
             (!has_head_ || columns_[unknown.front()].is_component))
      column_ = unknown.front();
    else if (motions.empty() && unknown.empty() && others.size() == 1 &&
             columns_[others.front()].is_certain)
      refuse("file", names(), "is no column of accelerations",
             "give the accelerations of this record", head_line_);
    else
      refuse("column", "",
             fmt::format("is missing: {} has the columns {}, and {} is named as an acceleration",
                         file_, names(), motions.empty() ? "none of them" : "more than one"),
             has_head_ ? fmt::format("write {}.column = \"NAME\" with one of them", path_)
                       : fmt::format("write {}.column = 2, or whichever holds the accelerations; "
                                     "of numbers without columns write one a line",
                                     path_));
  }

  void choose_named() {
    const double number = number_in(record_.column);
    std::vector<std::size_t> found;
    if (number >= 1 && number <= static_cast<double>(columns_.size())) {
      found = {static_cast<std::size_t>(number) - 1};
    } else {
      for (std::size_t k = 0; k < columns_.size(); ++k) {
        const std::string asked = small_letters(record_.column);
        const ColumnHead& head = columns_[k].head;
        if (has_head_ && (small_letters(head.whole) == asked || small_letters(head.name) == asked))
          found.push_back(k);
      }
    }
    if (found.size() > 1)
      refuse("column", record_.column, "is the name of several columns of " + file_,
             fmt::format("write a number from 1 to {}", columns_.size()));
    if (found.empty() || found.front() == time_ ||
        columns_[found.front()].kind == ColumnKind::kTime)
      refuse("column", record_.column, "is no column of accelerations in " + file_,
             (has_head_ ? "write one of: " : "write a number from ") + names());
    column_ = found.front();
    is_named_ = true;
  }

  // Checks the units in the headers of the two columns.
  void check_heads() {
    if (time_ != kNone) {
      const ColumnHead& head = columns_[time_].head;
      const std::string unit = spelt_unit(head.unit, "s");
      if (!head.unit.empty() && (unit.empty() || unit_factor(unit, "s") != 1))
        refuse("file", head.whole, "has times that are not in seconds",
               "write the times in seconds, under time_s", head_line_);
    }
    const Column& chosen = columns_[column_];
    if (chosen.kind == ColumnKind::kOther && chosen.is_certain)
      refuse("file", chosen.head.whole, "is no column of accelerations",
             "give the accelerations of this record", head_line_);
    if (!chosen.strange.empty())
      refuse(
          "file", chosen.head.whole,
          fmt::format("may be in a unit that is not known here: {} may change it", chosen.strange),
          "write the numbers in g, m/s2 or cm/s2, and the head as acc [g]", head_line_);
    if (chosen.head.unit.empty() && !chosen.head.in_brackets) return;
    numbers_.unit = stated_unit(chosen.head.unit);
    numbers_.stated = chosen.head.whole;
    numbers_.line = head_line_;
    if (numbers_.unit == RecordUnit::kNone)
      refuse("file", chosen.head.whole, "is in a unit that is not known here",
             "write it in g, m/s2 or cm/s2", head_line_);
  }

  // Compares a unit in comment lines with the units of header and model.
  void check_comments(std::string_view text) {
    const std::string all = comments_before(text);
    int number = 0;
    for (std::string_view rest = all; !rest.empty(); ++number) {
      std::string_view line = rest.substr(0, rest.find('\n'));
      rest.remove_prefix(line.size() + 1);
      line = comment_in(line).value_or(line);
      const StatedData stated_here = stated_in(std::string(line));
      if (!stated_here.factor.empty())
        refuse("file", stated_here.factor, "may be a factor of the numbers below",
               "apply it, and take this comment out of the file", number + 1);
      if (!std::isnan(stated_here.step)) stated_ = {stated_here.step, stated_.count, ""};
      if (!std::isnan(stated_here.count)) stated_ = {stated_.step, stated_here.count, ""};
      const std::string unit = unit_in_words(std::string(trimmed(line)));
      if (unit.empty()) continue;
      const RecordUnit stated = stated_unit(unit);
      const RecordUnit other = numbers_.unit != RecordUnit::kNone ? numbers_.unit : record_.unit;
      if (stated == RecordUnit::kNone)
        refuse("file", unit, "is in a unit that is not known here",
               "write the numbers in g, m/s2 or cm/s2", number + 1);
      if (other != RecordUnit::kNone && other != stated)
        refuse("file", unit,
               fmt::format("is what a comment says, and {} says {}",
                           numbers_.unit != RecordUnit::kNone ? "the head" : "the model",
                           word_of(kRecordUnitWords, other)),
               "make them agree", number + 1);
    }
  }

  void parse_rows(NumberTable& table) {
    FaultList faults;
    Fault thousands;  // the first value that may contain thousands
    std::vector<int> lines;
    bool tells_decimals = false;
    const auto number = [&](std::size_t column) {
      const double value = table.number(column);
      if (std::isnan(value) && has_head_ && table.cell(column) == columns_[column].head.whole)
        refuse("file", table.cell(column), "is the head a second time: two records in one file",
               "give each a file of its own", table.line());
      if (std::isnan(value)) {
        Fault fault = table.no_number(column);
        fault.path = path_ + ".file";
        faults.add(std::move(fault));
      }
      return value;
    };
    while (!enough(faults) && table.next()) {
      const double a = number(column_), t = time_ == kNone ? 0 : number(time_);
      if (std::isnan(a) || std::isnan(t)) continue;
      tells_decimals = tells_decimals || table.tells_decimals(column_);
      if (thousands.value.empty() && table.may_be_thousands(column_))
        thousands = {file_,
                     path_ + ".file",
                     table.cell(column_),
                     "may have three decimals or marks of thousands",
                     "write each value with a point, and with more or fewer than three decimals",
                     table.line()};
      note_unchosen(table);
      if (time_ != kNone) numbers_.time.push_back(t);
      numbers_.acceleration.push_back(a);
      lines.push_back(table.line());
    }
    look_for_falls(lines, faults);
    if (!thousands.value.empty() && !tells_decimals) faults.add(std::move(thousands));
    faults.throw_if_any();
    if (!is_named_ && rises_evenly(numbers_.acceleration))
      refuse("column", fmt::format("column {}", column_ + 1),
             "rises evenly, as row numbers and times do: no acceleration",
             fmt::format("write {}.column = \"NAME\" or its number; columns: {}", path_, names()));
    check_unchosen();
  }

  // Refuses times that do not increase: rounded, in another column, backwards, or unordered at one place.
  void look_for_falls(const std::vector<int>& lines, FaultList& faults) const {
    const std::vector<double>& time = numbers_.time;
    std::size_t falls = 0, equals = 0, first = 0;
    for (std::size_t k = 1; k < time.size(); ++k) {
      if (time[k] > time[k - 1]) continue;
      ++(time[k] < time[k - 1] ? falls : equals);
      if (first == 0) first = k;
    }
    if (first == 0) return;
    const bool backwards = falls + 1 == time.size();
    const bool others_rise =
        std::is_sorted(numbers_.acceleration.begin(), numbers_.acceleration.end()) &&
        numbers_.acceleration.front() < numbers_.acceleration.back();
    std::string problem = "times do not rise", cure = "sort the rows, and give each time once";
    if (others_rise && falls > 0) {
      problem = "times do not rise, and the accelerations do: the two columns are exchanged";
      cure = has_head_ ? "exchange their heads" : "put the times first";
    } else if (falls == 0 && equals > 1) {
      problem = fmt::format("times are rounded: {} rows have the time of the row before", equals);
      cure = "write them with more decimals; or leave them out, and write step = \"0.005 s\"";
    } else if (backwards) {
      problem = "times fall from row to row", cure = "turn the rows round";
    } else if (4 * falls > time.size()) {
      problem = fmt::format("are no times: they fall {} times in {} rows", falls, time.size());
      cure = "name the column of times time_s; or leave it out, and write step = \"0.005 s\"";
    }
    faults.add({file_, path_ + ".file",
                fmt::format("{:g} s after {:g} s", time[first], time[first - 1]),
                std::move(problem), std::move(cure), lines[first]});
  }

  // Collects other columns that may be times, where the model gives the step.
  void note_unchosen(const NumberTable& table) {
    if (time_ != kNone || std::isnan(record_.step)) return;
    unchosen_.resize(columns_.size());
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      if (k == column_ || columns_[k].kind == ColumnKind::kIndex) continue;
      std::string cell = table.cell(k);
      std::replace(cell.begin(), cell.end(), ',', '.');
      unchosen_[k].push_back(number_in(cell));
    }
  }

  // Row numbers increase by one, and times by the step in s, ms or us.
  void check_unchosen() const {
    constexpr double kSame = 1e-3;
    for (std::size_t k = 0; k < unchosen_.size(); ++k) {
      const std::vector<double>& values = unchosen_[k];
      if (!rises_evenly(values)) continue;
      const double rise = (values.back() - values.front()) / static_cast<double>(values.size() - 1);
      const auto is_step = [&](double unit) {
        return std::fabs(rise * unit - record_.step) <= kSame * record_.step;
      };
      if (std::fabs(rise - 1) <= kSame || is_step(1) || is_step(1e-3) || is_step(1e-6)) continue;
      refuse(
          "step", fmt::format("{:g} s", record_.step),
          fmt::format("is not the step of column {} of {}, which rises by {:g} a row",
                      has_head_ ? columns_[k].head.whole : fmt::format("{}", k + 1), file_, rise),
          "leave step out where these are the times; else take the column out of the file");
    }
  }

  // Compares comments about step and length with the data.
  void check_stated() {
    const std::vector<double>& time = numbers_.time;
    const auto count = static_cast<double>(numbers_.acceleration.size());
    if (!std::isnan(stated_.count) && stated_.count != count)
      refuse("file", fmt::format("{:.0f} numbers", count),
             fmt::format("are not the {:.0f} that a comment states", stated_.count),
             "fetch the whole file, or correct the comment");
    if (!(stated_.step > 0)) return;
    constexpr double kSame = 1e-3;
    const double step = time.empty() ? record_.step : (time.back() - time.front()) / (count - 1);
    if (!std::isnan(step) && std::fabs(step - stated_.step) > kSame * stated_.step)
      refuse(
          time.empty() ? "step" : "file", fmt::format("{:g} s", step),
          fmt::format("is not the step that a comment of {} states, {:g} s", file_, stated_.step),
          "make them agree");
  }

  // Row numbers, and times in another unit, increase by more than any step of a record. Only a
  // header can say that they are seconds; else the model's step is used if rows are evenly spaced.
  void check_times() {
    const std::vector<double>& time = numbers_.time;
    if (time.size() < 2 || columns_[time_].states_seconds) return;
    double least = time[1] - time[0], most = least;
    bool are_whole = true;
    for (std::size_t k = 0; k < time.size(); ++k) {
      are_whole = are_whole && time[k] == std::floor(time[k]);
      if (k == 0) continue;
      least = std::min(least, time[k] - time[k - 1]);
      most = std::max(most, time[k] - time[k - 1]);
    }
    const std::string column =
        has_head_ ? columns_[time_].head.whole : fmt::format("{}", time_ + 1);
    if (!(least > kCoarsest)) {
      const std::string strange = strange_in_times(columns_[time_].head);
      if (!strange.empty() && std::isnan(record_.step))
        refuse("file", column, fmt::format("may be in another unit than seconds: {}", strange),
               "write the head time_s where they are seconds, and step = \"0.005 s\" where not",
               head_line_);
      return;
    }
    const bool is_even = are_whole ? least == most : most - least <= 1e-3 * most;
    if (!is_even)
      refuse(
          "file", fmt::format("column {}", column),
          fmt::format("rises by {:g} or more a row, in no unit that is stated: no record is that "
                      "coarse in seconds",
                      least),
          "write the head time_s where they are seconds", head_line_);
    numbers_.no_times = column;
    numbers_.rise = least;
    numbers_.time.clear();
  }

  static bool rises_evenly(const std::vector<double>& values) {
    constexpr double kOff = 1e-3;  // of a step: allows for truncated decimals
    if (values.size() < 5 || values[1] == values[0]) return false;
    const double step = (values.back() - values.front()) / static_cast<double>(values.size() - 1);
    for (std::size_t k = 1; k < values.size(); ++k)
      if (!(std::fabs(values[k] - values[k - 1] - step) <= kOff * std::fabs(step))) return false;
    return step > 0;
  }

  StatedData stated_;  // from comments
  const RecordSpec& record_;
  const std::string &path_, &file_;
  RecordNumbers numbers_;
  std::vector<Column> columns_;
  std::vector<std::vector<double>> unchosen_;  // (n_column, n_row), where the model gives the step
  std::size_t time_ = kNone, column_ = kNone;
  int head_line_ = 0;
  bool has_head_ = false, is_named_ = false;
};

void look_for_gaps(ReadContext& context, const std::string& file, const std::string& path,
                   const std::vector<double>& time) {
  for (const auto& [k, usual] : gaps_of(time)) {
    if (enough(context.faults)) return;
    context.faults.add({file, path + ".file", fmt::format("{:g} s to {:g} s", time[k], time[k + 1]),
                        fmt::format("lines are missing: elsewhere one follows each {:g} s", usual),
                        "complete the record; where it should be a straight line, write its points",
                        0});
  }
}

// Refuses a mark of missing data, 999 or -9999.99, that differs strongly from its neighbours.
void look_for_marks(ReadContext& context, const std::string& file, const std::string& path,
                    const RecordNumbers& n) {
  double most = 0;  // of values that are no marks
  for (const double a : n.acceleration)
    if (!is_missing_mark(a)) most = std::max(most, std::fabs(a));
  for (std::size_t k = 0; k < n.acceleration.size(); ++k)
    if (const double a = n.acceleration[k]; is_missing_mark(a) && std::fabs(a) > 2 * most)
      return context.faults.add(
          {file, path + ".file", fmt::format("{:g}", a),
           fmt::format(
               "is acceleration {} of {}, and looks like a mark of missing data: all others "
               "are below {:.3g}",
               k + 1, n.acceleration.size(), most),
           "complete the record", 0});
}

void check_sources(ReadContext& context, const RecordSpec& r, const std::string& path) {
  const bool has_pulse = r.pulse != PulseShape::kNone, has_list = !r.accelerations.empty();
  const int ways = (r.file.empty() ? 0 : 1) + (has_pulse ? 1 : 0) + (has_list ? 1 : 0);
  if (ways != 1)
    context.fault(path, 0, "", ways == 0 ? "says nothing of the motion" : "says it in several ways",
                  "write one of: file, accelerations, pulse");
  // keys of another of the three ways to give a record are refused
  const bool has_file = !r.file.empty();
  const struct {
    const char* key;
    bool stated, fits;
    const char* of;
  } keys[] = {
      {"column", !r.column.empty(), has_file, "a file"},
      {"step", !std::isnan(r.step), has_file || has_list, "a file, or of accelerations"},
      {"times", !r.times.empty(), has_list, "accelerations that stand in the model"},
      {"unit", r.unit != RecordUnit::kNone, has_file || has_list, "a file, or of accelerations"},
      {"amplitude", !std::isnan(r.amplitude), has_pulse, "a pulse"},
      {"period", !std::isnan(r.period), has_pulse, "a pulse"}};
  for (const auto& key : keys)
    if (ways == 1 && key.stated && !key.fits)
      context.fault(under(path, key.key), 0, "", fmt::format("has no effect: it is of {}", key.of),
                    has_file   ? "leave it out, or the file"
                    : has_list ? "leave it out, or the accelerations"
                               : "leave it out, or the pulse");
  if (ways == 1 && has_list && !r.times.empty() && !std::isnan(r.step))
    context.fault(under(path, "step"), 0, "", "stands beside times, which say when",
                  "leave one of the two out");
  if (ways == 1 && has_list && r.unit == RecordUnit::kNone && !context.has_fault_at(path + ".unit"))
    context.fault(path + ".unit", 0, "", "is missing: no acceleration without its unit",
                  "write unit = \"g\", \"m/s2\" or \"cm/s2\"");
}

double in_metres(const RecordSpec& r, double gravity) {
  return r.unit == RecordUnit::kGravity ? gravity : r.unit == RecordUnit::kCentimetres ? 1e-2 : 1;
}

RecordNumbers numbers_of(ReadContext& context, const std::string& file, const std::string& path,
                         const RecordSpec& r) {
  const bool given = context.records != nullptr && context.records->contains(r.file);
  if (!given) check_is_text(read_file(file, kMostCsv), file);
  const std::string text = given ? context.records->at(r.file) : read_text(file, kMostCsv);
  if (std::optional<RecordNumbers> known = parse_record_format(text, file)) {
    if (!r.column.empty())
      throw InputError({{"", path + ".column", r.column, "has no meaning: " + file + " is no table",
                         "leave it out", 0}});
    return std::move(*known);
  }
  return TableRecord(r, path, file).read(text);
}

// Refuses a step in the model that disagrees with the step or the times of the file.
void check_step(ReadContext& context, const std::string& file, const std::string& path,
                const RecordSpec& r, double step) {
  constexpr double kSame = 1e-3;  // times are written with few digits
  if (std::isnan(r.step) || std::isnan(step) || std::fabs(r.step - step) <= kSame * step) return;
  context.fault(path + ".step", 0, fmt::format("{:g} s", r.step),
                fmt::format("is not the step of {}, {:g} s", file, step),
                "leave it out; to stretch a record in time, change the file");
}

void read_file_of(ReadContext& context, const ModelSpec& spec, const std::string& path,
                  RecordSpec& r) {
  const std::string file = (std::filesystem::path(spec.folder) / r.file).string();
  const std::size_t before = context.faults.all().size();
  RecordNumbers n;
  try {
    n = numbers_of(context, file, path, r);
  } catch (const InputError& error) {
    for (Fault fault : error.faults()) {
      if (fault.path.empty()) fault.path = path + ".file";
      context.faults.add(std::move(fault));
    }
  } catch (const IoError& error) {
    context.fault(path + ".file", 0, r.file, error.what(),
                  "the path counts from the folder of the model file");
  }
  if (r.unit == RecordUnit::kNone) r.unit = n.unit;
  if (context.faults.all().size() == before && r.unit == RecordUnit::kNone)
    return context.fault(path + ".unit", 0, "", "is missing, and " + r.file + " does not state it",
                         "write unit = \"g\", \"m/s2\" or \"cm/s2\"");
  if (n.unit != RecordUnit::kNone && n.unit != r.unit)
    context.faults.add(
        {file, path + ".file", n.stated, "is the file's unit, and the model file states another",
         fmt::format("write {}.unit = \"{}\"", path, word_of(kRecordUnitWords, n.unit)), n.line});
  if (context.faults.all().size() > before) return;
  if (n.time.empty() && std::isnan(n.step) && !(r.step > 0))
    return context.fault(
        path + ".step", 0, "",
        n.no_times.empty()
            ? "is missing: the file has no times"
            : fmt::format(
                  "is missing: column {} of {} rises by {:g} a row and states no seconds, so "
                  "its numbers are no times",
                  n.no_times, r.file, n.rise),
        n.no_times.empty() ? "write step = \"0.005 s\""
                           : "write step = \"0.005 s\", or the head time_s where they are seconds");
  const std::size_t count = n.acceleration.size();
  if (count < 2)
    return context.fault(path + ".file", 0, r.file, "holds fewer than two accelerations",
                         "give the whole record");
  look_for_marks(context, file, path, n);
  const double between = static_cast<double>(count - 1);
  check_step(context, file, path, r,
             n.time.empty() ? n.step : (n.time.back() - n.time.front()) / between);
  const double step = std::isnan(n.step) ? r.step : n.step;
  if (n.time.empty())
    for (std::size_t k = 0; k < count; ++k) n.time.push_back(static_cast<double>(k) * step);
  look_for_gaps(context, file, path, n.time);
  for (double& a : n.acceleration) a *= in_metres(r, spec.solve.gravity);
  const std::string hash = record_hash(n.time, n.acceleration);
  if (!r.hash.empty() && r.hash != hash)
    context.fault(path + ".hash", 0, r.hash,
                  fmt::format("is not that of {}, {}: the record is another", file, hash),
                  "restore the file, or leave hash out");
  r.hash = hash;
  r.column = n.column;
  r.read_times = std::move(n.time);
  r.read_accelerations = std::move(n.acceleration);
}

}  // namespace

void parse_records(ReadContext& context, ModelSpec& spec) {
  for (std::size_t k = 0; k < spec.stage.size(); ++k) {
    auto* shake = std::get_if<ShakeStage>(&spec.stage[k].action);
    for (std::size_t i = 0; shake != nullptr && i < shake->record.size(); ++i) {
      const std::string path = fmt::format("stage.{}.record.{}", k, i);
      RecordSpec& record = shake->record[i];
      check_sources(context, record, path);
      if (!record.file.empty() && !context.has_fault_at(path + ".unit") &&
          !context.has_fault_at(path + ".file") && !context.has_fault_at(path + ".step"))
        read_file_of(context, spec, path, record);
    }
  }
}

std::string record_text(const RecordSpec& record) {
  std::string text = "time_s,acceleration_m_per_s2\n";
  for (std::size_t k = 0; k < record.read_times.size(); ++k)
    text += csv_cell(record.read_times[k]) + "," + csv_cell(record.read_accelerations[k]) + "\n";
  return text;
}

}  // namespace wythe::io
