// Records of accelerations -> RecordSpec::read_times, read_accelerations.
//
//   CSV   # comments, a head or none, one row a time:       time_s,acceleration
//         of one column: accelerations every `step`
//   AT2   four lines of head (PEER):   ... UNITS OF G
//                                      NPTS=  4000, DT=   .0050 SEC     (older: 4000  .0050  NPTS, DT)
//         then the accelerations, any number a line
#include "io/model/record_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "core/files.h"
#include "core/limits.h"
#include "core/text.h"
#include "io/text/csv.h"
#include "model/shaking.h"
#include "wythe/text.h"

namespace wythe::io {
namespace {

struct Numbers {
  std::vector<double> time, acceleration;  // times empty: every step
  double step = kUnset;                    // that the file states [s]
};

class RecordReader {
 public:
  RecordReader(ReadContext& context, const RecordSpec& record, std::string path, std::string file)
      : context_(context), record_(record), path_(std::move(path)), file_(std::move(file)) {}

  Numbers read(const std::string& text) {
    const bool is_at2 = small_letters(std::filesystem::path(file_).extension().string()) == ".at2";
    return is_at2 ? read_at2(text) : read_csv(text);
  }

 private:
  void fault(int line, std::string value, std::string problem, std::string cure) {
    context_.faults.add(
        {file_, path_ + ".file", std::move(value), std::move(problem), std::move(cure), line});
  }

  // --- CSV
  Numbers read_csv(const std::string& text) {
    Numbers n;
    CsvLines lines(text, file_);
    bool more = lines.next();
    if (!more) {
      fault(0, "", "is empty", "give a record: time_s,acceleration and one row for each time");
      return n;
    }
    std::vector<std::string> head;
    if (std::isnan(number_in(lines.cells().front()))) {
      head = lines.cells();
      more = lines.next();
    }
    const std::size_t width = head.empty() ? lines.cells().size() : head.size();
    if (!choose_columns(head, width)) return n;
    check_head(head);
    for (; more && !enough(context_.faults); more = lines.next()) read_row(lines, n);
    return n;
  }

  bool choose_columns(const std::vector<std::string>& head, std::size_t width) {
    const auto named = [&](const std::string& name) {
      for (std::size_t k = 0; k < head.size(); ++k)
        if (small_letters(head[k]) == small_letters(name)) return static_cast<int>(k);
      return -1;
    };
    for (const char* name : {"time_s", "t_s", "time", "t", "time (s)", "time [s]", "time(s)",
                             "time[s]", "seconds", "sec", "s"})
      if (time_ < 0) time_ = named(name);
    if (time_ < 0 && width > 1 && std::isnan(record_.step)) time_ = 0;
    column_ = width > 1 ? (time_ == 1 ? 0 : 1) : 0;
    if (record_.column.empty()) return true;
    const double number = number_in(record_.column);
    const bool is_number = number >= 1 && number <= kMostColumns;  // else its int is anything
    column_ = is_number ? static_cast<int>(number) - 1 : named(record_.column);
    if (column_ >= 0 && column_ < static_cast<int>(width) && column_ != time_) return true;
    std::string all;
    for (const std::string& name : head) all += (all.empty() ? "" : ", ") + name;
    context_.fault(
        path_ + ".column", 0, record_.column, "is no column of accelerations in " + file_,
        all.empty() ? fmt::format("write a number from 1 to {}", width) : "write one of: " + all);
    return false;
  }

  // Units and quantities that the head names: "time_ms", "acc [m/s2]", "acceleration_g", "velocity_m_s".
  void check_head(const std::vector<std::string>& head) {
    const auto words_of = [&](int column) {
      std::set<std::string> words;
      std::string word;
      for (const char c : small_letters(head[static_cast<std::size_t>(column)]) + ' ') {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0)
          word += c;
        else if (!word.empty())
          words.insert(std::exchange(word, ""));
      }
      return words;
    };
    const auto are_there = [&](int column) {
      return column >= 0 && column < static_cast<int>(head.size());
    };
    if (are_there(time_)) {
      const std::set<std::string> words = words_of(time_);
      for (const char* name : {"ms", "msec", "milliseconds", "min", "minutes"})
        if (words.contains(name))
          fault(1, head[static_cast<std::size_t>(time_)], "has times that are not in seconds",
                "write the times in seconds, under time_s");
    }
    if (!are_there(column_)) return;
    const std::string& name = head[static_cast<std::size_t>(column_)];
    if (!is_of_accelerations(small_letters(name), 1, name)) return;
    const std::set<std::string> words = words_of(column_);
    if (words.contains("mm") || words.contains("mg"))
      fault(1, name, "is in a unit that is not known here", "write it in g, m/s2 or cm/s2");
    else if (words.contains("cm") || words.contains("gal"))
      compare_unit(RecordUnit::kCentimetres, name, 1);
    else if (words.contains("m"))
      compare_unit(RecordUnit::kMetres, name, 1);
    else if (words.contains("g"))
      compare_unit(RecordUnit::kGravity, name, 1);
  }

  // Velocities and displacements come in the same kinds of files.
  bool is_of_accelerations(const std::string& head, int line, const std::string& value) {
    for (const char* other : {"velocity", "displacement", "vel_", "disp_"})
      if (head.find(other) != std::string::npos) {
        fault(line, value, "is no column of accelerations",
              "give the accelerations of this record");
        return false;
      }
    return true;
  }
  void compare_unit(RecordUnit unit, const std::string& stated, int line) {
    if (record_.unit != RecordUnit::kNone && unit != record_.unit)
      fault(line, stated, "is the file's unit, and the model file states another",
            fmt::format("write {}.unit = \"{}\"", path_, word_of(kRecordUnitWords, unit)));
  }

  void read_row(const CsvLines& lines, Numbers& n) {
    const auto number = [&](int column) {
      const auto k = static_cast<std::size_t>(column);
      const std::string cell = k < lines.cells().size() ? lines.cells()[k] : "";
      const double value = number_in(cell);
      if (std::isnan(value))
        fault(lines.line(), cell.empty() ? lines.text() : cell,
              cell.empty() ? fmt::format("has no number in column {}", column + 1) : "is no number",
              "write numbers with a decimal point, cells with commas between them");
      return value;
    };
    const double a = number(column_), t = time_ >= 0 ? number(time_) : 0;
    if (std::isnan(a) || std::isnan(t)) return;
    if (time_ >= 0 && !n.time.empty() && !(t > n.time.back()))
      return fault(lines.line(), fmt::format("{:g} s after {:g} s", t, n.time.back()),
                   "times do not rise", "sort the rows, and give each time once");
    if (time_ >= 0) n.time.push_back(t);
    n.acceleration.push_back(a);
  }

  // --- AT2
  Numbers read_at2(const std::string& text) {
    Numbers n;
    std::istringstream lines(text);
    std::string line;
    double stated = kUnset;
    for (int k = 1; k <= 4 && std::getline(lines, line); ++k) {
      const std::string head = small_letters(line);
      if (head.find("units of") != std::string::npos) check_unit(head, k);
      if (head.find("npts") != std::string::npos) read_head(head, stated, n.step);
    }
    if (!(stated > 0) || !(n.step > 0)) {
      fault(4, line, "states no NPTS and DT", "is this an AT2 file of PEER? Else write a CSV");
      return n;
    }
    int at = 4;
    while (std::getline(lines, line) && !enough(context_.faults)) {
      ++at;
      std::istringstream cells(line);
      std::string cell;
      while (!enough(context_.faults) && cells >> cell) {  // a file may be one line
        const double value = number_in(cell);
        if (std::isnan(value)) fault(at, cell, "is no number", "repair the file, or fetch it anew");
        n.acceleration.push_back(value);
      }
    }
    const auto found = static_cast<double>(n.acceleration.size());
    if (found != stated && !enough(context_.faults))
      fault(at, fmt::format("{:.0f} numbers", found),
            fmt::format("are not the {:.0f} that NPTS states: lines are {}", stated,
                        found < stated ? "missing" : "too many"),
            "fetch the whole file");
    return n;
  }

  void check_unit(const std::string& head, int line) {
    constexpr std::string_view kBefore = "units of";
    const std::string_view after =
        std::string_view(head).substr(head.find(kBefore) + kBefore.size());
    const std::string stated(trimmed(after));
    // "g", "gal", "cm/s/s", "m/s**2 ...": the letters in front tell
    const std::string letters =
        stated.substr(0, stated.find_first_not_of("abcdefghijklmnopqrstuvwxyz"));
    const RecordUnit unit = letters == "g"                        ? RecordUnit::kGravity
                            : letters == "gal" || letters == "cm" ? RecordUnit::kCentimetres
                            : letters == "m"                      ? RecordUnit::kMetres
                                                                  : RecordUnit::kNone;
    if (unit == RecordUnit::kNone)
      return fault(line, stated, "is no unit of accelerations that is known here",
                   "write the file's numbers as a CSV in g, m/s2 or cm/s2");
    if (stated == "cm/s" || stated == "m/s" || stated == "cm/sec" || stated == "m/sec")
      return fault(line, stated, "is a unit of velocities",
                   "give the accelerations of this record");
    if (is_of_accelerations(head, line, std::string(trimmed(head))))
      compare_unit(unit, stated, line);
  }

  // "npts=  4000, dt=   .0050 sec" or "4000   .0050   npts, dt".
  static void read_head(const std::string& head, double& count, double& step) {
    std::vector<double> numbers;
    std::string cell;
    for (const char c : head + ' ') {
      if (std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.' || c == 'e' || c == '-') {
        cell += c;
        continue;
      }
      const double value = cell.empty() ? kUnset : number_in(cell);
      if (!std::isnan(value)) numbers.push_back(value);
      cell.clear();
    }
    if (numbers.size() < 2) return;
    count = numbers[0];
    step = numbers[1];
  }

  ReadContext& context_;
  const RecordSpec& record_;
  std::string path_, file_;
  int time_ = -1, column_ = 0;
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

void check_sources(ReadContext& context, const RecordSpec& r, const std::string& path) {
  const bool has_pulse = r.pulse != PulseShape::kNone, has_list = !r.accelerations.empty();
  const int ways = (r.file.empty() ? 0 : 1) + (has_pulse ? 1 : 0) + (has_list ? 1 : 0);
  if (ways != 1)
    context.fault(path, 0, "", ways == 0 ? "says nothing of the motion" : "says it in several ways",
                  "write one of: file, accelerations, pulse");
  if (ways == 1 && !has_pulse && r.unit == RecordUnit::kNone &&
      !context.has_fault_at(path + ".unit"))
    context.fault(path + ".unit", 0, "", "is missing: no acceleration without its unit",
                  "write unit = \"g\", \"m/s2\" or \"cm/s2\"");
}

double in_metres(const RecordSpec& r, double gravity) {
  return r.unit == RecordUnit::kGravity ? gravity : r.unit == RecordUnit::kCentimetres ? 1e-2 : 1;
}

void read_file_of(ReadContext& context, const std::string& folder, double gravity,
                  const std::string& path, RecordSpec& r) {
  const std::string file = (std::filesystem::path(folder) / r.file).string();
  const std::size_t before = context.faults.all().size();
  Numbers n;
  try {
    const bool given = context.records != nullptr && context.records->contains(r.file);
    n = RecordReader(context, r, path, file)
            .read(given ? context.records->at(r.file) : read_text(file, kMostCsv));
  } catch (const InputError& error) {
    for (Fault fault : error.faults()) {
      if (fault.path.empty()) fault.path = path + ".file";
      context.faults.add(std::move(fault));
    }
  } catch (const IoError& error) {
    context.fault(path + ".file", 0, r.file, error.what(),
                  "the path counts from the folder of the model file");
  }
  if (context.faults.all().size() > before) return;
  const double step = std::isnan(n.step) ? r.step : n.step;
  if (n.time.empty() && !(step > 0))
    return context.fault(path + ".step", 0, "", "is missing: the file has no times",
                         "write step = \"0.005 s\"");
  if (n.time.empty())
    for (std::size_t k = 0; k < n.acceleration.size(); ++k)
      n.time.push_back(static_cast<double>(k) * step);
  if (n.time.size() < 2)
    return context.fault(path + ".file", 0, r.file, "holds fewer than two accelerations",
                         "give the whole record");
  look_for_gaps(context, file, path, n.time);
  for (double& a : n.acceleration) a *= in_metres(r, gravity);
  const std::string hash = record_hash(n.time, n.acceleration);
  if (!r.hash.empty() && r.hash != hash)
    context.fault(path + ".hash", 0, r.hash,
                  fmt::format("is not that of {}, {}: the record is another", file, hash),
                  "restore the file, or leave hash out");
  r.hash = hash;
  r.read_times = std::move(n.time);
  r.read_accelerations = std::move(n.acceleration);
}

}  // namespace

void read_records(ReadContext& context, ModelSpec& spec) {
  for (std::size_t k = 0; k < spec.stage.size(); ++k)
    for (std::size_t i = 0; i < spec.stage[k].record.size(); ++i) {
      const std::string path = fmt::format("stage.{}.record.{}", k, i);
      RecordSpec& record = spec.stage[k].record[i];
      check_sources(context, record, path);
      if (!record.file.empty() && record.unit != RecordUnit::kNone)
        read_file_of(context, spec.folder, spec.solve.gravity, path, record);
    }
}

std::string record_text(const RecordSpec& record) {
  std::string text = "time_s,acceleration_m_per_s2\n";
  for (std::size_t k = 0; k < record.read_times.size(); ++k)
    text += csv_cell(record.read_times[k]) + "," + csv_cell(record.read_accelerations[k]) + "\n";
  return text;
}

}  // namespace wythe::io
