// Parses the complete header of an acceleration: a name, a unit, and words that are known not to change the
// unit. Any other word may be a factor or another unit. It is refused, because a guess could give wrong numbers.
#include "io/model/record_heads.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <regex>
#include <string_view>
#include <utility>
#include <vector>

#include "core/ascii.h"
#include "core/elementary.h"
#include "core/text.h"
#include "io/model/record_formats.h"
#include "io/text/csv.h"
#include "wythe/parts/text.h"

namespace wythe::io {
namespace {

using Words = std::initializer_list<std::string_view>;

bool is_one_of(std::string_view word, Words words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool is_alnum(char c) { return is_ascii_letter(c) || is_digit(c); }
bool is_ascii(char c) { return static_cast<unsigned char>(c) < 0x80; }
// Whether a word of the name begins with `start`: "ground acc" with acc.
bool has_word(const std::string& name, std::string_view start) {
  for (std::size_t at = name.find(start); at != std::string::npos; at = name.find(start, at + 1))
    if (at == 0 || !is_alnum(name[at - 1])) return true;
  return false;
}

// A separate letter, or a letter before a mark, a digit or an axis: a, a_x, ax, a1.
bool is_letter(const std::string& name, char letter) {
  return !name.empty() && name[0] == letter &&
         (name.size() == 1 || !is_ascii_letter(name[1]) ||
          (name.size() == 2 && std::string("xyzgh").find(name[1]) != std::string::npos));
}

// The letters of ASCII alone: "Lfd. Nr." -> lfdnr.
std::string letters_of(const std::string& small) {
  std::string out;
  for (const char c : small)
    if (is_ascii_letter(c)) out += c;
  return out;
}

// --- times

bool is_seconds(std::string_view word) {
  return is_one_of(word, {"s", "sec", "secs", "second", "seconds", "secondi", "secondes",
                          "segundos", "sek", "sekunden"});
}

// The unit of time in a header, also in forms like timeMs, millis; "" where there is none.
std::string time_unit(const ColumnHead& head) {
  if (!head.unit.empty() || head.in_brackets) return head.unit;
  const std::string small = small_letters(head.whole), letters = letters_of(small);
  if (small == "s") return "s";
  if (has_word(small, "millis")) return "ms";
  if (has_word(small, "micros")) return "us";
  if (has_word(small, "nanos")) return "ns";
  if (has_word(small, "minutes")) return "min";
  if (has_word(small, "hours")) return "h";
  if (has_word(small, "seconds")) return "s";
  for (const std::string_view start :
       {"timestamp", "time", "tempo", "temps", "zeit", "tiempo", "t", ""}) {
    if (!letters.starts_with(start)) continue;
    const std::string_view rest = std::string_view(letters).substr(start.size());
    if (rest != "s" && is_seconds(rest)) return "s";
    if (is_one_of(rest, {"msec", "msecs"}) || rest.starts_with("millis") || rest == "ms")
      return "ms";
    if (is_one_of(rest, {"usec", "us"}) || rest.starts_with("micros")) return "us";
  }
  return "";
}

// The rest of a word after the name of a time: "timesec" -> sec, "tempi" nothing.
std::string_view behind_time(std::string_view word) {
  for (const std::string_view name :
       {"timestamps", "timestamp", "times", "time", "tempo", "tempi", "temps", "zeiten", "zeit",
        "tiempos", "tiempo", "tempos", "tijd", "czas", "t"})
    if (word.starts_with(name)) return word.substr(name.size());
  return word;
}

bool is_of_times(std::string_view word) {
  const std::string_view rest = behind_time(word);
  return rest.empty() || is_seconds(rest) || (word.size() == 1 && is_ascii(word[0])) ||
         is_one_of(word,
                   {"when",   "elapsed", "relative", "rel",       "absolute", "abs",    "from",
                    "since",  "start",   "begin",    "origin",    "trigger",  "of",     "the",
                    "in",     "event",   "record",   "recording", "signal",   "axis",   "history",
                    "series", "vector",  "base",     "local",     "utc",      "stamp",  "unit",
                    "units",  "data",    "value",    "values",    "rec",      "motion", "input",
                    "output", "di",      "de",       "der",       "la",       "le",     "el"});
}

// "time_s", "Zeit (sec)", "seconds", but not "frame_s" or "time x 0.05 s".
bool states_seconds(const std::string& small) {
  if (small == "times" || small == "ts" || std::any_of(small.begin(), small.end(), is_digit))
    return false;
  const std::string letters = letters_of(small);
  for (const std::string_view start :
       {"time", "tempo", "temps", "zeit", "tiempo", "t", "elapsed", "elapsedtime", "timein", ""})
    if (letters.starts_with(start) && is_seconds(std::string_view(letters).substr(start.size())))
      return true;
  return false;
}

// --- accelerations

// Words beside the name that do not affect the unit.
bool is_direction(std::string_view word) {
  return is_one_of(word, {"ns",       "ew",           "ud",   "sn",         "we",         "du",
                          "north",    "south",        "east", "west",       "up",         "down",
                          "vertical", "vert",         "ver",  "horizontal", "horiz",      "hor",
                          "long",     "longitudinal", "lon",  "trans",      "transverse", "tran",
                          "radial",   "fn",           "fp"});
}
bool is_harmless(std::string_view word) {
  return word.empty() || (word.size() == 1 && is_ascii(word[0])) || is_direction(word) ||
         is_one_of(word,
                   {"xx",       "yy",      "zz",         "comp",     "component", "channel",
                    "chan",     "ch",      "corrected",  "corr",     "cor",       "uncorrected",
                    "filtered", "filt",    "unfiltered", "raw",      "processed", "proc",
                    "baseline", "ground",  "base",       "table",    "input",     "motion",
                    "record",   "rec",     "signal",     "data",     "time",      "history",
                    "series",   "abs",     "absolute",   "rel",      "relative",  "total",
                    "soil",     "rock",    "surface",    "top",      "bottom",    "value",
                    "values",   "seismic", "of",         "the",      "in",        "at",
                    "hne",      "hnn",     "hnz",        "corretta", "filtrata"});
}

// The rest of a word after "acc": "accelerations" nothing, "accx" x.
std::string_view behind_name(std::string_view word) {
  for (const std::string_view name : {"accelerations",
                                      "acceleration",
                                      "accelerograms",
                                      "accelerogram",
                                      "accelerazione",
                                      "accelerazioni",
                                      "acceleraciones",
                                      "acceleracion",
                                      "aceleraciones",
                                      "aceleracion",
                                      "accelero",
                                      "acceler",
                                      "accels",
                                      "accel",
                                      "accn",
                                      "acc",
                                      "acel",
                                      "beschleunigungen",
                                      "beschleunigung",
                                      "beschl",
                                      "a"})
    if (word.starts_with(name)) return word.substr(name.size());
  return word;
}

// The first word or mark of a header, without its unit, that may change the unit; "" where there is
// none. `is_known` accepts words. If the header states a unit in brackets, all words are allowed.
std::string strange_in(const std::string& rest,
                       const std::function<bool(std::string_view)>& is_known) {
  const std::string small = small_letters(rest);
  if (small.starts_with('|')) return "|";  // |acc|
  for (const std::string_view mark :
       {"%", "‰", "^", "*", "×", "·", "⋅", "pct", "percent", "prozent"})
    if (small.find(mark) != std::string::npos) return std::string(mark);
  for (std::size_t at = 0; at < small.size();) {
    if (!is_alnum(small[at]) && is_ascii(small[at])) {
      ++at;
      continue;
    }
    // a number, with point and exponent; or letters
    const bool number = is_digit(small[at]);
    std::size_t end = at;
    while (end < small.size() &&
           (number ? is_digit(small[end]) || small[end] == '.' || small[end] == ','
                   : !is_ascii(small[end]) || (is_alnum(small[end]) && !is_digit(small[end]))))
      ++end;
    const std::string word = small.substr(at, end - at);
    const bool is_times = at > 0 && small[at - 1] == 'x' && (at < 2 || !is_alnum(small[at - 2]));
    if (number) {
      const double value = number_in(word);
      const double power = elementary::log10(value);
      const bool is_power = value >= 10 && power == std::floor(power);
      const bool has_exponent =
          end + 1 < small.size() && small[end] == 'e' &&
          (is_digit(small[end + 1]) || small[end + 1] == '-' || small[end + 1] == '+');
      const bool is_divided = at > 0 && small[at - 1] == '/';
      if (is_divided || std::isnan(value) || value != std::floor(value) || value == 0 || is_power ||
          has_exponent || (is_times && value > 9))
        return word;
    } else {
      const bool is_scale =
          is_one_of(word, {"milli", "micro", "kilo", "centi", "millig", "mg", "ug", "mgal",
                           "milligal", "kgal", "permille", "times"});
      if (is_scale) return word;
      if (!is_known(word)) return word;
    }
    at = end;
  }
  return "";
}

bool is_any(std::string_view) { return true; }

bool is_of_accelerations(std::string_view word) {
  // accélération, but not acc²
  const bool is_accented = (word.starts_with("acc") || word.starts_with("acel")) &&
                           is_ascii(word.back()) &&
                           !std::all_of(word.begin(), word.end(), is_ascii);
  return is_accented || is_harmless(word) || is_harmless(behind_name(word));
}

// Replaces other brackets by [ ], closes one at the end, and removes the argument of a(t).
std::string with_plain_brackets(std::string text) {
  for (const std::string_view argument : {"(t)", "(T)", "(time)"})
    if (const std::size_t at = text.find(argument); at != std::string::npos && at > 0)
      text.erase(at, argument.size());
  int open = 0;
  for (char& c : text) {
    if (c == '{' || c == '<') c = '[';
    if (c == '}' || c == '>') c = ']';
    if (c == '[' || c == '(') ++open;
    if ((c == ']' || c == ')') && --open < 0) {
      c = ' ';
      open = 0;
    }
  }
  return open > 0 ? text + ']' : text;
}

struct AccelerationHead {
  ColumnHead head;
  std::string strange;
};

// A header with its unit, including g and gal; elsewhere the unit g is only the gram.
AccelerationHead acceleration_head(const std::string& whole) {
  constexpr std::size_t kLongestHead = 100, kLongestUnit = 24;
  const std::string text = with_plain_brackets(whole);
  ColumnHead head = column_head(text, {"m/s^2", "m/s", "m"});
  head.whole = whole;
  if (head.in_brackets && head.unit.empty()) head.in_brackets = false;
  if (head.in_brackets) {
    const std::size_t close = text.find_last_of("])");
    return {head, strange_in(head.name + ' ' + text.substr(close + 1), is_any)};
  }
  if (text.size() > kLongestHead) return {head, ""};
  const std::string small = small_letters(text);
  if (stated_unit(text) != RecordUnit::kNone ||
      is_one_of(small, {"%g", "mg", "m/s", "cm/s", "mm/s", "in/s2", "ft/s2"}))
    return {{whole, "", text}, ""};
  // a unit between marks: the longest one that ends last
  std::vector<std::size_t> marks;
  for (std::size_t at = 0; at < text.size(); ++at)
    if (is_ascii(text[at]) && !is_alnum(text[at]) &&
        std::string_view("^*%").find(text[at]) == std::string_view::npos)
      marks.push_back(at);
  marks.push_back(text.size());
  for (std::size_t last = marks.size(); last-- > 1;)
    for (std::size_t first = 0; first < last; ++first) {
      const std::size_t from = marks[first] + 1;
      if (marks[last] - from > kLongestUnit || marks[last] <= from) continue;
      const std::string unit = text.substr(from, marks[last] - from);
      if (acceleration_unit(unit).empty()) continue;
      const std::string before = text.substr(0, marks[first]), after = text.substr(marks[last]);
      std::string strange = strange_in(before + ' ' + after, is_of_accelerations);
      const bool is_beside =
          (!before.empty() && is_digit(before.back())) || (after.size() > 1 && is_digit(after[1]));
      if (strange.empty() && is_beside) strange = "the number beside " + unit;
      return {{whole, before, unit}, strange};
    }
  if (const std::string_view unit = behind_name(small); unit.size() < small.size() &&
                                                        !unit.empty() && small.starts_with("acc") &&
                                                        !acceleration_unit(unit).empty())
    return {{whole, small.substr(0, small.size() - unit.size()), std::string(unit)}, ""};
  return {head, head.unit.empty() ? strange_in(text, is_of_accelerations) : ""};
}

}  // namespace

bool tells_of_other_motion(const std::string& words) {
  const std::string small = small_letters(words);
  const auto has = [&](std::string_view start) { return has_word(small, start); };
  return (has("vel") || has("disp") || has("spost") || has("geschw")) && !has("acc") &&
         !has("beschl") && !has("acel");
}

StatedData stated_in(const std::string& comment) {
  const std::string small = small_letters(comment);
  StatedData stated;
  std::smatch found;
  static const std::regex step(
      R"((?:\bdt|sampl\w*\s+(?:interval|step|period)|time\s+(?:step|interval))\s*(?:[(\[]\s*m?s(?:ec)?\s*[)\]])?\s*[:=]?\s*([\d.]+(?:e[-+]?\d+)?)\s*(m?s(?:ec\w*)?\b)?)");
  static const std::regex rate(
      R"(sampl\w*\s+(?:rate|freq\w*)\D{0,20}?([\d.]+)\s*(?:hz|sps|samples))");
  static const std::regex count(R"((?:\bnpts|number of (?:points|samples|data))\s*[:=]?\s*(\d+))");
  static const std::regex factor(
      R"(multipl\w*|(?:scale|scaling|conversion|calibration)\s*factor|scaled\s+by|\bfactor\s*[:=])");
  constexpr std::size_t kLongestLine = 300;
  if (small.size() > kLongestLine) return stated;
  if (std::regex_search(small, found, step)) {
    const bool is_ms = found[0].str().find("ms") != std::string::npos;
    stated.step = number_in(found[1].str()) * (is_ms ? 1e-3 : 1);
  } else if (std::regex_search(small, found, rate)) {
    stated.step = 1 / number_in(found[1].str());
  }
  if (std::regex_search(small, found, count)) stated.count = number_in(found[1].str());
  static const std::regex one(R"(\D{0,20}1(?:\.0*)?\s*$)");
  if (std::regex_search(small, found, factor) && !std::regex_match(found.suffix().str(), one))
    stated.factor = comment;
  return stated;
}

std::string strange_in_times(const ColumnHead& head) {
  const std::size_t slash = head.unit.empty() ? head.whole.find('/') : std::string::npos;
  if (slash != std::string::npos) return head.whole.substr(slash);  // t/T1
  if (!head.in_brackets) return strange_in(head.unit.empty() ? head.whole : head.name, is_of_times);
  const std::size_t close = head.whole.find_last_of("])}");
  return strange_in(head.name + ' ' + head.whole.substr(close + 1), is_any);
}

Column column_of(const std::string& text) {
  Column column;
  ColumnHead time = column_head(text, {"s"});
  const std::string name = small_letters(time.name), whole = small_letters(text);
  const std::string unit_of_time = time_unit(time);
  const bool is_time =
      is_one_of(name, {"t", "s", "sec", "secs", "tempo", "temps", "zeit", "tiempo"});
  if (unit_of_time.empty() && is_index_name(whole)) return {ColumnKind::kIndex, time};
  if (is_time || whole.starts_with("time") ||
      (time.unit.empty() && !unit_of_time.empty() && !time.in_brackets)) {
    time.unit = unit_of_time;
    return {ColumnKind::kTime, time, states_seconds(whole)};
  }
  AccelerationHead read = acceleration_head(text);
  column.head = std::move(read.head);
  const std::string bare = small_letters(column.head.name);
  const std::string& unit = column.head.unit;
  const bool is_moved = !unit.empty() && acceleration_unit(unit).empty() &&
                        (!spelt_unit(unit, "m/s").empty() || !spelt_unit(unit, "m").empty());
  const bool is_spectral = is_one_of(bare, {"sa", "psa", "sv", "psv", "sd", "pga", "pgv"}) ||
                           has_word(bare, "freq") || has_word(bare, "period");
  if (is_spectral || has_word(bare, "vel") || has_word(bare, "disp") || has_word(bare, "spost") ||
      is_moved) {
    column.kind = ColumnKind::kOther;
  } else if (has_word(bare, "acc") || has_word(bare, "acel") || has_word(bare, "beschl") ||
             is_letter(bare, 'a') || (!unit.empty() && !acceleration_unit(unit).empty())) {
    column.kind = ColumnKind::kAcceleration;
    column.strange = std::move(read.strange);
  } else if (is_direction(letters_of(bare))) {
    column.is_component = true;
    if (!unit.empty()) column.strange = std::move(read.strange);
  } else if (bare.starts_with('v') || bare.starts_with('d') || bare.starts_with('u')) {
    column.kind = ColumnKind::kOther;
    column.is_certain = false;
  } else if (time.unit.ends_with('s') || time.unit.ends_with("sec")) {
    return {ColumnKind::kTime, time, states_seconds(whole)};
  }
  return column;
}

}  // namespace wythe::io
