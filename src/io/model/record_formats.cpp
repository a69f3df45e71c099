// Tries ESM, K-NET, COSMOS and AT2 in turn, then names known formats that are not supported. A reader declines a file
// without its marks, and refuses a broken file that has them. The header states how many numbers follow. A wrong unit
// would scale the record, so a stated unit must be known, and AT2 headers may not have a factor beside it.
#include "io/model/record_formats.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <regex>
#include <utility>

#include <fmt/format.h>

#include "core/ascii.h"
#include "core/limits.h"
#include "core/number.h"
#include "core/text.h"
#include "io/text/csv.h"
#include "io/text/table.h"
#include "wythe/parts/error.h"
#include "wythe/parts/text.h"
#include "wythe/parts/units.h"

namespace wythe::io {
namespace {

// The lines of a text by their numbers, including blank ones.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
  }
  bool next() {
    if (rest_.empty()) return false;
    const std::size_t end = rest_.find('\n');
    text_ = trimmed(rest_.substr(0, end));
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    ++line_;
    return true;
  }
  [[nodiscard]] std::string_view text() const { return text_; }
  [[nodiscard]] int line() const { return line_; }

 private:
  std::string_view rest_, text_;
  int line_ = 0;
};

struct HeadLine {
  std::string text, small;
  int line = 0;
};

std::vector<HeadLine> head_of(std::string_view text) {
  std::vector<HeadLine> head;
  Lines lines(text);
  while (lines.line() < kMostHeadLines && lines.next()) {
    constexpr std::size_t kLongestHead = 1000;  // of what tells a format
    const std::string line(lines.text().substr(0, kLongestHead));
    head.push_back({line, small_letters(line), lines.line()});
  }
  return head;
}

[[noreturn]] void refuse(const std::string& file, int line, std::string value, std::string problem,
                         std::string cure) {
  throw InputError({{file, "", std::move(value), std::move(problem), std::move(cure), line}});
}

// The line with that word; null where there is none.
const HeadLine* line_with(const std::vector<HeadLine>& head, std::string_view word) {
  for (const HeadLine& line : head)
    if (line.small.find(word) != std::string::npos) return &line;
  return nullptr;
}

// The position of a separate word.
std::size_t word_at(std::string_view line, std::string_view word) {
  for (std::size_t at = line.find(word); at != std::string_view::npos;
       at = line.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !is_ascii_letter(line[at - 1])) &&
        (end == line.size() || !is_ascii_letter(line[end])))
      return at;
  }
  return std::string_view::npos;
}

// The numbers of a text, with any separators.
std::vector<double> numbers_in(std::string_view text) {
  std::vector<double> numbers;
  std::string cell;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    const char c = i < text.size() ? text[i] : ' ';
    const bool is_exponent =
        !cell.empty() && (c == 'e' || c == 'd' || ((c == '-' || c == '+') && cell.back() == 'e'));
    if (is_digit(c) || c == '.' || is_exponent || (c == '-' && cell.empty())) {
      cell += c == 'd' ? 'e' : c;  // of Fortran: 5.0D-02
      continue;
    }
    while (cell.ends_with('e') || cell.ends_with('-') || cell.ends_with('+')) cell.pop_back();
    if (const double value = number_in(cell); !std::isnan(value)) numbers.push_back(value);
    cell.clear();
  }
  return numbers;
}

// Fortran writes numbers of full width without a blank between them: "-.123-4.56". Each
// number has its point, so the sign of an exponent, 1.5-101, does not separate numbers.
std::vector<std::string_view> touching_numbers(std::string_view cell) {
  std::vector<std::string_view> parts;
  for (std::size_t at = 1; at < cell.size(); ++at) {
    const bool is_sign = cell[at] == '-' || cell[at] == '+';
    const std::string_view before = cell.substr(0, at), behind = cell.substr(at + 1);
    const bool has_points =
        before.find('.') != std::string_view::npos &&
        behind.substr(0, behind.find_first_of("+-")).find('.') != std::string_view::npos;
    if (!is_sign || !has_points || is_ascii_letter(cell[at - 1])) continue;
    parts.push_back(before);
    cell.remove_prefix(at);
    at = 0;
  }
  parts.push_back(cell);
  return parts;
}

// The numbers after the header, any count in a line; `stated` of them.
std::vector<double> values_after(std::string_view text, const std::string& file, int head_lines,
                                 double stated, const char* says_so) {
  std::vector<double> values;
  FaultList faults;
  Lines lines(text);
  while (lines.line() < head_lines && lines.next()) {
  }
  while (!enough(faults) && lines.next()) {
    std::string_view rest = lines.text();
    while (!enough(faults) && !rest.empty()) {  // the whole file may be one line
      const std::string_view cell = rest.substr(0, rest.find_first_of(" \t"));
      rest = trimmed(rest.substr(cell.size()));
      for (const std::string_view one : touching_numbers(cell)) {
        const double value = number_in(one);
        if (std::isnan(value) && !enough(faults))
          faults.add({file, "", std::string(cell), "is no number",
                      "repair the file, or fetch it anew", lines.line()});
        values.push_back(value);
      }
    }
  }
  const auto found = static_cast<double>(values.size());
  if (found != stated && faults.empty())
    faults.add({file, "", fmt::format("{:.0f} numbers", found),
                fmt::format("are not the {:.0f} that {} states: lines are {}", stated, says_so,
                            found < stated ? "missing" : "too many"),
                "fetch the whole file", lines.line()});
  faults.throw_if_any();
  return values;
}

void check_head(const std::string& file, int line, double count, double step, const char* names) {
  if (count >= 1 && count <= kMostRows && step > 0 && std::isfinite(step)) return;
  refuse(file, line, fmt::format("{:g} and {:g} s", count, step), fmt::format("are no {}", names),
         "repair the head, or fetch the file anew");
}

// --- AT2

struct Counts {
  double number = kUnset, step = kUnset;
  std::string unit;  // of the step, where the line states one
};

// The word after a position, without marks: "(MSEC)= 50" -> msec; after a number: "= 50 ms" -> ms.
std::string word_behind(std::string_view rest, bool behind_number) {
  constexpr std::string_view kMarks = " \t_([=:";
  rest.remove_prefix(std::min(rest.size(), rest.find_first_not_of(kMarks)));
  if (behind_number) {
    std::size_t end = 0;
    while (end < rest.size() &&
           (is_digit(rest[end]) || rest[end] == '.' || rest[end] == '-' || rest[end] == '+' ||
            ((rest[end] == 'e' || rest[end] == 'd') && end + 1 < rest.size() &&
             !is_ascii_letter(rest[end + 1]))))
      ++end;
    if (end == 0) return "";
    rest.remove_prefix(end);
    rest.remove_prefix(std::min(rest.size(), rest.find_first_not_of(" \t([")));
  }
  std::size_t end = 0;
  while (end < rest.size() && is_ascii_letter(rest[end])) ++end;
  return std::string(rest.substr(0, end));
}

// Seconds of a unit as headers spell it; NaN for other words.
double seconds_of(const std::string& unit) {
  if (unit == "sec" || unit == "secs") return 1;
  if (unit == "msec" || unit == "msecs" || unit == "millisec") return 1e-3;
  if (unit == "usec") return 1e-6;
  const std::string spelt = spelt_unit(unit, "s");
  return spelt.empty() ? kUnset : unit_factor(spelt, "s");
}

// "npts=  4000, dt=   .0050 sec", in any order, or "4000   .0050   npts, dt".
Counts counts_in(std::string_view line) {
  const std::size_t npts = word_at(line, "npts"), dt = word_at(line, "dt");
  if (npts == std::string_view::npos || dt == std::string_view::npos) return {};
  const auto behind = [&](std::size_t at, std::size_t length) {
    std::string_view rest = trimmed(line.substr(at + length));
    if (const std::string unit = word_behind(rest, false); !std::isnan(seconds_of(unit))) {
      rest.remove_prefix(rest.find(unit) + unit.size());
      rest.remove_prefix(std::min(rest.size(), rest.find_first_not_of(" \t)]")));
    }
    if (!rest.starts_with('=') && !rest.starts_with(':')) return kUnset;
    const std::size_t other = npts < dt ? dt : npts;
    const std::vector<double> numbers =
        numbers_in(line.substr(at + length, at < other ? other - at - length : line.size()));
    return numbers.empty() ? kUnset : numbers.front();
  };
  const std::string_view rest = line.substr(dt + 2);
  const std::string beside = word_behind(rest, false);
  Counts out{behind(npts, 4), behind(dt, 2),
             std::isnan(seconds_of(beside)) ? word_behind(rest, true) : beside};
  if (!std::isnan(out.number) && !std::isnan(out.step)) return out;
  const std::vector<double> numbers = numbers_in(line);
  if (numbers.size() < 2) return {};
  return npts < dt ? Counts{numbers[0], numbers[1], out.unit}
                   : Counts{numbers[1], numbers[0], out.unit};
}

bool is_velocity(const std::string& unit) {
  return acceleration_unit(unit).empty() && !spelt_unit(unit, "m/s").empty();
}
bool is_length(const std::string& unit) {
  return acceleration_unit(unit).empty() && !spelt_unit(unit, "m").empty();
}

// The unit in a line that states one: "units of g", "the units are (cm/sec**2)", "in units: m/s2".
std::string unit_text(const HeadLine& line) {
  std::size_t at = word_at(line.small, "units");
  if (at == std::string::npos) at = word_at(line.small, "unit");
  if (at == std::string::
                npos) {  // "ACCELERATION (CM/S2)", "ACCELERATION, CM/S2", "ACCELERATION IN CM/S2"
    const ColumnHead head = column_head(line.text, {"m/s^2"});
    if (line.small.find("accel") == std::string::npos) return "";
    if (head.in_brackets && !acceleration_unit(head.unit).empty()) return head.unit;
    const std::size_t blank = line.text.find_last_of(" ,");
    const std::string last = blank == std::string::npos ? "" : line.text.substr(blank + 1);
    return acceleration_unit(last).empty() ? "" : last;
  }
  std::string_view rest = std::string_view(line.text).substr(at);
  rest.remove_prefix(std::min(rest.size(), rest.find_first_of(" :=\t")));
  for (bool again = true; again;) {
    again = false;
    rest = trimmed(rest);
    for (const std::string_view word : {"of ", "are ", "is ", "in ", ":", "=", "(", "["})
      if (small_letters(rest.substr(0, word.size())) == word) {
        rest.remove_prefix(word.size());
        again = true;
      }
  }
  // alone, or before other words: "G. FILTER POINTS: HP=0.1 Hz"
  const auto without_stop = [](std::string_view text) {
    while (text.ends_with('.') || text.ends_with(':')) text.remove_suffix(1);
    return std::string(text);
  };
  const std::string whole = without_stop(trimmed(rest.substr(0, rest.find_first_of(")],;"))));
  if (!acceleration_unit(whole).empty() || is_velocity(whole)) return whole;
  const std::size_t end = std::min(whole.size(), whole.find_first_of(" \t"));
  const std::string_view next = trimmed(std::string_view(whole).substr(end));
  // "G X 10": other words may follow, but no factor
  const bool is_scaled =
      !next.empty() &&
      (std::string_view("0123456789*/^%").find(next[0]) != std::string_view::npos ||
       word_at(small_letters(std::string(next.substr(0, 3))), "x") == 0);
  return is_scaled ? whole : without_stop(whole.substr(0, end));
}

// A factor beside a unit: "in units of g, scaled by 10", "(g x 100)", "(cm/s2) * 10".
bool tells_of_factor(const std::string& small) {
  static const std::regex factor(
      R"(multipl|scaled|scale factor|[^*]\*\s*\d|\bx\s*\d|[)\]]\s*/\s*\d|%\s*(of\s*)?g\b)");
  return std::regex_search(small, factor);
}

// A spectrum is not a motion, but a motion matched to a spectrum is.
bool tells_of_spectrum(const std::string& small) {
  const auto has = [&](std::string_view word) { return small.find(word) != std::string::npos; };
  return (has("spectr") || has("fourier") || has("pseudo")) && !has("match") && !has("compatib") &&
         !has("time") && !has("record") && !has("accelerogram");
}

// A unit in a line of the header. A line about accelerations comes first, because titles may contain any words.
void find_unit(const std::vector<HeadLine>& head, int last, const std::string& file,
               RecordNumbers& out) {
  const HeadLine* told = nullptr;
  for (const HeadLine& line : head) {
    if (line.line > last) break;
    const std::string unit = unit_text(line);
    const bool speaks = line.small.find("accel") != std::string::npos;
    if (unit.empty() || (!speaks && acceleration_unit(unit).empty() && !is_velocity(unit)))
      continue;
    const RecordUnit now = stated_unit(unit);
    if (told != nullptr && now != RecordUnit::kNone && stated_unit(unit_text(*told)) != now)
      refuse(file, line.line, unit,
             fmt::format("is another unit than {} in line {}", unit_text(*told), told->line),
             "leave the one that holds");
    if (told == nullptr || speaks) told = &line;
  }
  if (told == nullptr) return;
  const std::string unit = unit_text(*told);
  if (is_velocity(unit))
    refuse(file, told->line, unit, "is a unit of velocities",
           "give the accelerations of this record");
  out.unit = stated_unit(unit);
  out.stated = unit;
  out.line = told->line;
  if (out.unit == RecordUnit::kNone)
    refuse(file, told->line, unit, "is no unit of accelerations that is known here",
           "write the file's numbers as a CSV in g, m/s2 or cm/s2");
}

void refuse_factors(const std::vector<HeadLine>& head, int last, const std::string& file) {
  for (const HeadLine& line : head) {
    if (line.line > last) break;
    const bool speaks = line.small.find("accel") != std::string::npos || !unit_text(line).empty();
    if (speaks && tells_of_factor(line.small))
      refuse(file, line.line, line.text, "may be in a unit that is not known here: it has a factor",
             "multiply the numbers, and write the head in units of g, m/s2 or cm/s2");
  }
}

// The kind of series is named in the header; titles before it may contain any words.
void check_series(const std::vector<HeadLine>& head, int last, const std::string& file) {
  const HeadLine* moved = nullptr;
  bool accelerates = false;
  for (const HeadLine& line : head) {
    if (line.line > last) break;
    const auto has = [&](std::string_view word) {
      return line.small.find(word) != std::string::npos;
    };
    const auto is_there = [&](std::string_view word) {
      return word_at(line.small, word) != std::string::npos;
    };
    if (tells_of_spectrum(line.small) &&
        (has("accel") || has("amplitude") || !unit_text(line).empty()))
      refuse(file, line.line, line.text, "is the head of a spectrum, and no motion",
             "give the accelerations of this record");
    if (has("accel") || is_there("acc")) {
      accelerates = true;
    } else if (has("veloc") || has("displ") || is_there("vel") || is_there("disp")) {
      const bool is_series =
          has("time series") || has("time hist") || is_there("units") || is_there("cm");
      if (moved == nullptr || is_series) moved = &line;
      if (is_series) {
        accelerates = false;
        break;
      }
    } else if (const std::string unit = unit_text(line); !unit.empty() && is_length(unit)) {
      moved = &line;
    }
  }
  if (moved != nullptr && !accelerates)
    refuse(file, moved->line, moved->text, "is no head of accelerations",
           "give the accelerations of this record");
  const std::string ending = small_letters(std::filesystem::path(file).extension().string());
  if (!accelerates && (ending == ".vt2" || ending == ".dt2"))
    refuse(file, last, "", fmt::format("has the ending {} of velocities or displacements", ending),
           "give the accelerations of this record");
}

}  // namespace

std::string unit_in_words(const std::string& words) {
  const HeadLine line{words, small_letters(words), 0};
  static const std::regex share(R"(%\s*(of\s+)?g\b)");
  if (std::regex_search(line.small, share)) return "% of g";
  const std::string unit = unit_text(line);
  return acceleration_unit(unit).empty() ? "" : unit;
}

namespace {

std::optional<RecordNumbers> parse_at2(const std::string& text, const std::string& file,
                                       const std::vector<HeadLine>& head) {
  Counts counts;
  int last = 0;
  for (const HeadLine& line : head) {
    if (last > 0) break;
    counts = counts_in(line.small);
    if (!std::isnan(counts.number)) last = line.line;
  }
  if (last == 0) return std::nullopt;
  const double seconds = counts.unit.empty() ? kUnset : seconds_of(counts.unit);
  constexpr double kCoarsest = 0.5;  // [s]: no record of a motion is coarser
  if (counts.unit.starts_with("hz") || counts.unit.starts_with("sps"))
    refuse(file, last, counts.unit, "is no unit of a step", "write DT in seconds, DT= .0050 SEC");
  if (!std::isnan(seconds)) counts.step *= seconds;
  if (std::isnan(seconds) && counts.step > kCoarsest)
    refuse(file, last, fmt::format("DT {:g}", counts.step),
           "is no step of a record in seconds, and its unit is not stated",
           "write it in seconds, with its unit: DT= .0050 SEC");
  check_head(file, last, counts.number, counts.step, "NPTS and DT");
  RecordNumbers out;
  find_unit(head, last, file, out);
  refuse_factors(head, last, file);
  check_series(head, last, file);
  out.step = counts.step;
  out.acceleration = values_after(text, file, last, counts.number, "NPTS");
  return out;
}

// --- ESM

std::optional<RecordNumbers> parse_esm(const std::string& text, const std::string& file,
                                       const std::vector<HeadLine>& head) {
  const auto value_of = [&](std::string_view key) {
    const HeadLine* line = line_with(head, key);
    const std::size_t colon = line == nullptr ? std::string::npos : line->text.find(':');
    return colon == std::string::npos ? std::string()
                                      : std::string(trimmed(line->text.substr(colon + 1)));
  };
  const HeadLine* step = line_with(head, "sampling_interval_s:");
  if (step == nullptr) return std::nullopt;
  const HeadLine* unit = line_with(head, "units:");
  const std::string kind = small_letters(value_of("data_type:"));
  if (!kind.empty() && kind != "acceleration")
    refuse(file, line_with(head, "data_type:")->line, kind, "is no column of accelerations",
           "give the accelerations of this record");
  int last = 0;
  for (const HeadLine& line : head)
    if (line.text.find(':') != std::string::npos) last = line.line;
  RecordNumbers out;
  out.step = number_in(value_of("sampling_interval_s:"));
  const double count = number_in(value_of("ndata:"));
  check_head(file, step->line, count, out.step, "NDATA and SAMPLING_INTERVAL_S");
  if (unit != nullptr) {
    out.stated = value_of("units:");
    out.line = unit->line;
    out.unit = stated_unit(out.stated);
    if (out.unit == RecordUnit::kNone)
      refuse(file, unit->line, out.stated, "is no unit of accelerations that is known here",
             "write the file's numbers as a CSV in g, m/s2 or cm/s2");
  }
  out.acceleration = values_after(text, file, last, count, "NDATA");
  return out;
}

// --- K-NET

std::optional<RecordNumbers> parse_knet(const std::string& text, const std::string& file,
                                        const std::vector<HeadLine>& head) {
  const HeadLine* scale = line_with(head, "scale factor");
  const HeadLine* rate = line_with(head, "sampling freq");
  const HeadLine* memo = line_with(head, "memo");
  if (scale == nullptr || rate == nullptr || memo == nullptr) return std::nullopt;
  const auto numbers_of = [](const HeadLine& line, std::string_view label) {
    return numbers_in(std::string_view(line.small).substr(label.size()));
  };
  // "Scale Factor      3920(gal)/6182761"
  const std::vector<double> parts = numbers_of(*scale, "scale factor");
  if (parts.size() != 2 || !(parts[0] > 0 && parts[1] > 0) ||
      scale->small.find("(gal)/") == std::string::npos)
    refuse(file, scale->line, scale->text, "is no scale of K-NET",
           "write it as Scale Factor 3920(gal)/6182761");
  const std::vector<double> frequency = numbers_of(*rate, "sampling freq(hz)");
  if (frequency.empty() || !(frequency.front() > 0))
    refuse(file, rate->line, rate->text, "states no frequency",
           "write it as Sampling Freq(Hz) 100Hz");
  RecordNumbers out;
  out.step = 1 / frequency.front();
  out.unit = RecordUnit::kCentimetres;
  out.stated = scale->text;
  out.line = scale->line;
  const HeadLine* duration = line_with(head, "duration time");
  std::size_t numbers = 0;  // without a stated duration, all that follow
  Lines lines(text);
  while (lines.next())
    if (lines.line() > memo->line) numbers += cells_of(lines.text(), kBlanks, kMostColumns).size();
  double stated = static_cast<double>(numbers);
  if (duration != nullptr)
    if (const std::vector<double> seconds = numbers_of(*duration, "duration time(s)");
        !seconds.empty())
      stated = std::round(seconds.front() * frequency.front());
  check_head(file, rate->line, stated, out.step, "duration and frequency");
  out.acceleration = values_after(text, file, memo->line, stated, "Duration Time");
  for (double& a : out.acceleration) a *= parts[0] / parts[1];
  return out;
}

// --- COSMOS, volumes 1 and 2: channels in order, each with headers that give the layout of its numbers
//
//    100 Real-header values follow on  20 lines, Format= (5F15.6)
//   26219 acceleration pts, approx  131 secs, units=cm/sec2(04),Format=(8F10.5)

// "(8F10.5)": count and width of the numbers in a line; they may touch.
struct Fixed {
  std::size_t many = 0, wide = 0;
};
std::size_t whole_in(const std::smatch& found, std::size_t k) {
  return parse_number<std::size_t>(found[k].str()).value_or(0);
}
Fixed fixed_in(const std::smatch& found, std::size_t at) {
  const auto number = [&](std::size_t k) {
    return found[k].length() == 0 ? 1 : whole_in(found, k);
  };
  return {number(at), number(at + 1)};
}

// Adds up to `most` numbers of a line; false after a cell that is not a number.
bool add_fixed(std::string_view line, Fixed fixed, std::size_t most, std::vector<double>& out) {
  for (std::size_t k = 0; k < fixed.many && out.size() < most; ++k) {
    if (k * fixed.wide >= line.size()) return true;
    const std::string_view cell = trimmed(line.substr(k * fixed.wide, fixed.wide));
    if (cell.empty()) continue;
    out.push_back(number_in(cell));
    if (std::isnan(out.back())) return false;
  }
  return true;
}

struct CosmosChannel {
  int line = 0;                   // line of the words before its numbers
  std::string words, unit;        // as they stand
  double count = 0, seconds = 0;  // stated
  std::vector<double> head, value;
};

// The lines of a text, with the blanks before their first number.
std::vector<std::string_view> whole_lines(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    lines.push_back(line);
    text.remove_prefix(std::min(text.size(), end + 1));
  }
  return lines;
}

std::vector<CosmosChannel> cosmos_channels(std::string_view text, const std::string& file) {
  static const std::regex kHead(
      R"(\s*(\d{1,6})\s+real-header values follow on\s+(\d{1,6})\s+lines\s*,\s*format\s*=\s*\((\d{0,3})f(\d{1,2})\..*)",
      std::regex::icase);
  static const std::regex kData(
      R"(\s*(\d{1,8})\s+acc\w*\.?\s+(?:pts|points)\b.*?approx\s+([\d.]{1,12})\s+secs?,\s*units\s*=\s*([^,(]+?)\s*(?:\(\s*\d+\s*\))?\s*,\s*format\s*=\s*\((\d{0,3})[feidg](\d{1,2})(?:\..*|\).*))",
      std::regex::icase);
  constexpr std::size_t kLongestLine = 300;  // of a line of words
  const std::vector<std::string_view> lines = whole_lines(text);
  std::vector<CosmosChannel> out;
  std::vector<double> head;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].size() > kLongestLine || lines[i].find('=') == std::string_view::npos) continue;
    const std::string line(lines[i]);
    std::smatch found;
    if (std::regex_match(line, found, kHead)) {
      head.clear();
      const std::size_t count = whole_in(found, 1), rows = whole_in(found, 2);
      for (std::size_t k = i + 1; k < std::min(lines.size(), i + 1 + rows); ++k)
        if (!add_fixed(lines[k], fixed_in(found, 3), count, head))
          refuse(file, static_cast<int>(k) + 1, std::string(trimmed(lines[k])),
                 "is no line of a COSMOS head", "repair the file, or fetch it anew");
    } else if (std::regex_match(line, found, kData)) {
      CosmosChannel channel{.line = static_cast<int>(i) + 1,
                            .words = std::string(trimmed(line)),
                            .unit = found[3].str(),
                            .count = number_in(found[1].str()),
                            .seconds = number_in(found[2].str()),
                            .head = std::move(head),
                            .value = {}};
      head.clear();
      const Fixed fixed = fixed_in(found, 4);
      for (std::size_t k = i + 1;
           k < lines.size() && static_cast<double>(channel.value.size()) < channel.count; ++k)
        if (!add_fixed(lines[k], fixed, static_cast<std::size_t>(channel.count), channel.value))
          refuse(file, static_cast<int>(k) + 1, std::string(trimmed(lines[k])),
                 fmt::format("is no line of numbers, and {} of {:.0f} have been read",
                             channel.value.size() - 1, channel.count),
                 "fetch the whole file");
      out.push_back(std::move(channel));
    }
  }
  return out;
}

// Value 62, in ms, is the step of this series. Value 34, in s, is that of the recorder, which may differ.
double cosmos_step(const CosmosChannel& channel) {
  constexpr std::size_t kOfSeries = 62, kOfRecorder = 34;
  const auto at = [&](std::size_t number) {
    return number <= channel.head.size() ? channel.head[number - 1] : kUnset;
  };
  if (at(kOfSeries) > 0) return 1e-3 * at(kOfSeries);
  return at(kOfRecorder) > 0 ? at(kOfRecorder) : kUnset;
}

std::optional<RecordNumbers> parse_cosmos(const std::string& text, const std::string& file) {
  const std::vector<CosmosChannel> channels = cosmos_channels(text, file);
  if (channels.empty()) return std::nullopt;
  const CosmosChannel& channel = channels.front();
  if (channels.size() > 1)
    refuse(file, channels[1].line, channels[1].words,
           fmt::format("is the second of {} accelerations in this COSMOS file", channels.size()),
           "keep one channel, from its first line to its End-of-data");
  RecordNumbers out;
  out.stated = channel.unit;
  out.line = channel.line;
  out.unit = stated_unit(channel.unit);
  if (out.unit == RecordUnit::kNone)
    refuse(file, channel.line, channel.unit,
           "is no unit of accelerations that is known here (COSMOS)",
           "fetch the processed record, in cm/s2 or g");
  out.step = cosmos_step(channel);
  if (std::isnan(out.step))
    refuse(file, channel.line, channel.words,
           "has no step: a COSMOS file states it among its Real-header values",
           "fetch the whole file");
  check_head(file, channel.line, channel.count, out.step, "points and step of COSMOS");
  // stated in whole seconds, rounded or truncated
  const double seconds = channel.count * out.step;
  if (!(std::fabs(seconds - channel.seconds) <= 1 + 1e-9))
    refuse(file, channel.line, channel.words,
           fmt::format("has {:.0f} points, one each {:g} s, which last {:g} s", channel.count,
                       out.step, seconds),
           "fetch the file anew");
  if (static_cast<double>(channel.value.size()) != channel.count)
    refuse(file, channel.line, fmt::format("{} numbers", channel.value.size()),
           fmt::format("are not the {:.0f} that the line states: lines are missing", channel.count),
           "fetch the whole file");
  out.acceleration = channel.value;
  return out;
}

// --- known formats that are not supported

struct Foreign {
  std::string_view word, also, name;
};
constexpr Foreign kForeign[] = {
    {"corrected accelerogram", "", "CSMIP, COSMOS or SMC"},
    {"uncorrected accelerogram", "", "CSMIP, COSMOS or SMC"},
    {"points of accel data", "", "CSMIP or COSMOS"},
    {"acceleration pts", "", "COSMOS"},
    {"strong-motion data", "fmt", "COSMOS"},
    {"timeseries ", "samples", "MiniSEED as text (ObsPy, IRIS)"},
    {"raw accel", "", "COSMOS"},
    {"geonet", "", "GeoNet"},
    {"sampling interval", "number of data", "AFAD"},
    {"intervalo de muestreo", "", "Base Mexicana de Datos de Sismos Fuertes (Mexico)"},
    {"sampling interval [s]", "units", "ITACA before ESM"},
};

[[noreturn]] void refuse_format(const std::string& file, int line, std::string value,
                                std::string_view format) {
  refuse(file, line, std::move(value),
         fmt::format("is of the format {}, which is not read here", format),
         "write its accelerations as a CSV, time_s,acc_cm_s2 and one row a time");
}

// The format of a binary file, by its first bytes or its name; "" for a text.
std::string_view binary_format(std::string_view bytes, const std::string& file) {
  constexpr std::size_t kSacHead = 632, kSacVersion = 304;
  const std::string ending = small_letters(std::filesystem::path(file).extension().string());
  const bool is_block =
      bytes.size() > 8 &&
      bytes.substr(0, 6).find_first_not_of("0123456789") == std::string_view::npos &&
      std::string_view("DRQM").find(bytes[6]) != std::string_view::npos && bytes[7] == ' ';
  if (is_block || bytes.starts_with("MS\x03") || ending == ".mseed" || ending == ".miniseed")
    return "MiniSEED";
  const auto is_version = [&](std::size_t low) {
    constexpr char kFrom = 4, kTo = 7;
    for (std::size_t k = 0; k < 4; ++k)
      if (const char c = bytes[kSacVersion + k]; k == low ? c < kFrom || c > kTo : c != 0)
        return false;
    return true;
  };
  if (ending == ".sac" || (bytes.size() >= kSacHead && (is_version(0) || is_version(3))))
    return "SAC";
  return bytes.find('\0') == std::string_view::npos ? "" : "of a program, binary";
}

}  // namespace

std::string acceleration_unit(std::string_view text) {
  const std::string small = small_letters(trimmed(text));
  for (const std::string_view known : {"g", "gal", "%g", "% g", "mg", "mgal", "milli-g"})
    if (small == known) return small;
  return spelt_unit(text, "m/s^2");
}

RecordUnit stated_unit(std::string_view text) {
  const std::string unit = acceleration_unit(text);
  if (unit == "g") return RecordUnit::kGravity;
  if (unit == "gal") return RecordUnit::kCentimetres;
  const std::string spelt = spelt_unit(text, "m/s^2");
  if (spelt.empty()) return RecordUnit::kNone;
  const double factor = unit_factor(spelt, "m/s^2");
  constexpr double kSame = 1e-12;
  return std::fabs(factor - 1) < kSame      ? RecordUnit::kMetres
         : std::fabs(factor - 0.01) < kSame ? RecordUnit::kCentimetres
                                            : RecordUnit::kNone;
}

void check_is_text(std::string_view bytes, const std::string& file) {
  constexpr std::string_view kUtf16[] = {"\xFF\xFE", "\xFE\xFF"};  // a text, of another encoding
  if (is_utf8(bytes) || bytes.starts_with(kUtf16[0]) || bytes.starts_with(kUtf16[1])) return;
  if (const std::string_view format = binary_format(bytes, file); !format.empty())
    refuse_format(file, 0, "", format);
}

std::optional<RecordNumbers> parse_record_format(const std::string& text, const std::string& file) {
  check_line_ends(text, file);
  const std::vector<HeadLine> head = head_of(text);
  if (auto esm = parse_esm(text, file, head)) return esm;
  if (auto knet = parse_knet(text, file, head)) return knet;
  if (auto cosmos = parse_cosmos(text, file)) return cosmos;
  if (auto at2 = parse_at2(text, file, head)) return at2;
  if (small_letters(std::filesystem::path(file).extension().string()) == ".at2")
    refuse(file, 0, "",
           fmt::format("has no line in its first {} that names NPTS and DT", kMostHeadLines),
           "is this an AT2 file of PEER? Else write a CSV");
  for (const Foreign& known : kForeign)
    if (const HeadLine* line = line_with(head, known.word);
        line != nullptr && (known.also.empty() || line_with(head, known.also) != nullptr))
      refuse_format(file, line->line, line->text, known.name);
  return std::nullopt;
}

}  // namespace wythe::io
