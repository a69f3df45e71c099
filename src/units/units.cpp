// Converts quantities to SI and back, and describes wrong ones. unit_parser.cpp knows the units.
#include "wythe/parts/units.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "core/ascii.h"
#include "core/number.h"
#include "core/text.h"
#include "units/dimension.h"
#include "units/quantity_error.h"
#include "units/unit_parser.h"

namespace wythe {
namespace {

enum class Verdict { kGood, kUnknown, kOtherDimension };
struct Conversion {
  Verdict verdict = Verdict::kUnknown;
  double value = 0;
};

Conversion conversion(std::string_view unit, std::string_view si_unit) {
  const auto from = parse_unit(unit), to = parse_unit(si_unit);
  if (!from || !to) return {Verdict::kUnknown, 0};
  const double factor = from->factor.times(to->factor.power(-1)).value();
  const bool alike =
      std::equal(from->exponent.begin(), from->exponent.begin() + kRadian, to->exponent.begin());
  if (from->shifted || from->logarithm || !alike || !std::isnormal(factor))
    return {Verdict::kOtherDimension, 0};
  return {Verdict::kGood, factor};
}

}  // namespace

std::string quantity_name(std::string_view si_unit) {
  static const std::map<std::string, std::string, std::less<>> kNames = {
      {"m", "a length"},
      {"Pa", "a stress"},
      {"Pa/m", "a stiffness per area"},
      {"rad", "an angle"},
      {"N/m", "a force per length or an energy per area"},
      {"kg/m^3", "a density"},
      {"N/m^3", "a weight per volume"},
      {"N", "a force"},
      {"s", "a time"},
      {"m/s", "a velocity"},
      {"1/s", "a rate"},
      {"rad/s", "a rate of angle"},
      {"m/s^2", "an acceleration"}};
  const auto found = kNames.find(si_unit);
  return found == kNames.end() ? "" : found->second;
}

std::string unit_definition(std::string_view text) {
  const auto unit = parse_unit(text);
  if (!unit || unit->logarithm) return "";
  std::string bases;
  for (std::size_t i = 0; i < kBaseUnits.size(); ++i) {
    if (unit->exponent[i] == 0) continue;
    bases += fmt::format("{}{}", bases.empty() ? "" : ".", kBaseUnits[i]);
    if (unit->exponent[i] != 1) bases += std::to_string(unit->exponent[i]);
  }
  if (bases.empty()) bases = "1";
  const double factor = unit->factor.value();
  return factor == 1 ? bases : fmt::format("{:.15g} {}", factor, bases);
}

namespace {

std::string dimension_name(std::string_view si_unit) {
  const std::string name = quantity_name(si_unit);
  return fmt::format("{} [{}]", name.empty() ? "a quantity" : name, si_unit);
}

// Multiplies by the factor so that decimal texts keep their bits: 310 mm becomes 310 / 1000 m, the
// double nearest to 0.31, while 310 * 0.001 may differ in the last bit.
double scaled(double number, double factor) {
  const double divisor = std::round(1.0 / factor);
  const bool divides = factor < 1.0 && std::abs(divisor * factor - 1.0) < 1e-14;
  return divides ? number / divisor : number * factor;
}

struct Split {
  double number = 0;
  std::string unit;
};

std::optional<Split> split_quantity(std::string_view text) {
  std::string_view rest = trimmed(text);
  if (rest.starts_with('+') && !rest.starts_with("+-")) rest.remove_prefix(1);
  const auto found = leading_number(rest);
  if (!found) return std::nullopt;
  // "infinite" is a word, not inf and a unit "inite"
  const bool is_word = !std::isfinite(found->value) && !found->rest.empty();
  if (is_word && is_ascii_letter(found->rest[0])) return std::nullopt;
  return Split{found->value, std::string(trimmed(found->rest))};
}

// Whether the unit contains a number. "1 200 mm" would be 1 x 200 mm, "1.0.5 m" 0.5 m and "10-20 mm" -200 mm: typing errors, not
// units.
bool holds_number(std::string_view unit) {
  const bool is_signed = unit.size() > 1 && (unit[0] == '-' || unit[0] == '+');
  const auto begins_number = [&](std::size_t i) {
    return i < unit.size() && is_digit(unit[i]) && !unit.substr(i).starts_with("1/");
  };
  // After a blank or a mark of arithmetic: "MPa/10", "MPa×10". Beyond ASCII the last byte counts: of · × ′ ″ °, and of superscripts.
  constexpr std::string_view kMarks = " /.('\"\x97\xb0\xb2\xb3\xb7\xb9";
  bool found = begins_number(is_signed ? 1 : 0);
  for (std::size_t i = 1; i < unit.size(); ++i) {
    const bool is_times = unit[i - 1] == '*' && (i < 2 || unit[i - 2] != '*');
    const bool is_mark = is_times || kMarks.find(unit[i - 1]) != std::string_view::npos;
    found = found || (is_mark && begins_number(i));
  }
  return found;
}

// Suggests "1234.5 N" for "1.234,5 N", and both possible readings of "150,000 N".
std::string without_commas(std::string_view text) {
  const std::string whole(trimmed(text));
  const std::size_t end = std::min(whole.size(), whole.find_first_not_of("+-.,0123456789"));
  std::string number = whole.substr(0, end);
  const std::string unit(trimmed(std::string_view(whole).substr(end)));
  const std::size_t comma = number.find(','), last = number.find_last_of(".,");
  const auto plain = [](std::string digits) {
    std::erase_if(digits, [](char c) { return c == ',' || c == '.'; });
    return digits;
  };
  const std::string thousands = plain(number);
  const std::string decimals = plain(number.substr(0, last)) + '.' + plain(number.substr(last));
  const bool many = std::count(number.begin(), number.end(), number[last]) > 1;
  const bool may_be_thousands = number.size() - last == 4 &&
                                number.find('.') == std::string::npos && comma != 0 &&
                                number[0] != '0';
  if (many) return fmt::format("write \"{} {}\"", thousands, unit);
  if (may_be_thousands)
    return fmt::format("write \"{1} {0}\" for thousands, \"{2} {0}\" for decimals", unit, thousands,
                       decimals);
  return fmt::format("write \"{} {}\"", decimals, unit);
}

void refuse_second_number(std::string_view text, std::string_view unit) {
  if (unit.starts_with(',')) throw QuantityError("has a decimal comma", without_commas(text));
  if (holds_number(unit))
    throw QuantityError(fmt::format("'{}' is more than one number", text),
                        "write one number without blanks, then its unit");
}

constexpr double kStandardGravity = 9.80665;  // [m/s^2]

// Words that UDUNITS knows as American units but masonry engineers mean otherwise: a ton is the short ton of 2000 lb there,
// gr the grain of 65 mg.
struct DoubtfulWord {
  std::string_view word, meaning, cure;
};
constexpr DoubtfulWord kDoubtful[] = {
    {"ton", "2000 lb in UDUNITS, 1000 kg to most", "write t (1000 kg) or 2000 lb"},
    {"tons", "2000 lb in UDUNITS, 1000 kg to most", "write t (1000 kg) or 2000 lb"},
    {"gr", "a grain of 65 mg in UDUNITS, a gram to most", "write g"},
    {"ton_force", "of 2000 lb in UDUNITS, of 1000 kg to most",
     "write 9.80665 kN for each (1000 kg) or 2000 lbf"},
    {"ton_forces", "of 2000 lb in UDUNITS, of 1000 kg to most",
     "write 9.80665 kN for each (1000 kg) or 2000 lbf"}};

bool is_multiple(std::string_view word, std::string_view of) {
  if (!word.ends_with(of)) return false;
  const std::string_view prefix = word.substr(0, word.size() - of.size());
  for (const std::string_view known : {"k", "kilo", "M", "mega", "c", "centi", "m", "milli"})
    if (prefix == known) return true;
  return false;
}

void refuse_doubtful_words(std::string_view unit, std::string_view si_unit) {
  const auto is_letter = [](char c) { return is_ascii_letter(c) || c == '_'; };
  for (std::size_t i = 0; i < unit.size();) {
    std::size_t end = i;
    while (end < unit.size() && is_letter(unit[end])) ++end;
    const std::string_view word = unit.substr(i, end - i);
    for (const DoubtfulWord& known : kDoubtful)
      if (word == known.word || is_multiple(word, known.word))
        throw QuantityError(fmt::format("{} is {}: {}", word, known.meaning, known.cure),
                            fmt::format("write it in {} or a multiple of it", si_unit));
    i = std::max(end, i + 1);
  }
}

bool has_one_of(const std::string& unit, std::initializer_list<const char*> words) {
  return std::any_of(words.begin(), words.end(),
                     [&](const char* word) { return unit.find(word) != std::string::npos; });
}

// Refuses slopes as angles: an angle has no dimension, so a slope would pass unnoticed.
void refuse_slopes(const std::string& unit, std::string_view si_unit) {
  if (si_unit == "rad" && !has_one_of(unit, {"rad", "deg", "°", "arc", "angular", "gon", "grad",
                                             "turn", "circle", "cycle", "revolution", "rotation"}))
    throw QuantityError(
        fmt::format("a share in {} is a slope, no angle (of friction, the tangent goes to "
                    "friction_tan)",
                    unit),
        "write it in deg");
}

double checked_factor(const std::string& unit, std::string_view si_unit) {
  refuse_doubtful_words(unit, si_unit);
  if (unit == "g" && si_unit == "m/s^2") return kStandardGravity;  // no gram where only this fits
  const Conversion factor = conversion(unit, si_unit);
  const std::string cure = fmt::format("write it in {} or a multiple of it", si_unit);
  if (factor.verdict == Verdict::kUnknown)
    throw QuantityError(fmt::format("the unit {} is not known", unit), cure);
  if (factor.verdict == Verdict::kOtherDimension)
    throw QuantityError(fmt::format("{} is not the unit of {}", unit, dimension_name(si_unit)),
                        cure);
  refuse_slopes(unit, si_unit);
  return factor.value;
}

}  // namespace

double unit_factor(std::string_view unit, std::string_view si_unit) {
  if (unit != "1" && holds_number(unit))  // "1": of what has no unit
    throw QuantityError(fmt::format("the unit {} has a number in it", unit),
                        fmt::format("write a unit alone, e.g. {}", si_unit));
  return checked_factor(std::string(unit), si_unit);
}

double parse_quantity(std::string_view text, std::string_view si_unit) {
  const auto split = split_quantity(text);
  if (!split)
    throw QuantityError(fmt::format("'{}' is not a number with a unit", text),
                        fmt::format("write e.g. \"1 {}\"", si_unit));
  if (!std::isfinite(split->number))
    throw QuantityError("is not a finite number", fmt::format("write e.g. \"1 {}\"", si_unit));
  if (split->unit.empty())
    throw QuantityError("has no unit", fmt::format("write it with its unit, e.g. \"{} {}\"",
                                                   trimmed(text), si_unit));
  refuse_second_number(text, split->unit);
  const double value = scaled(split->number, checked_factor(split->unit, si_unit));
  if (!std::isfinite(value))
    throw QuantityError("is not a finite number", fmt::format("write e.g. \"1 {}\"", si_unit));
  return value;
}

std::string format_quantity(double value, std::string_view si_unit, std::string_view shown_unit) {
  if (std::isinf(value) && value > 0) return "unlimited";
  if (!std::isfinite(value)) return fmt::format("{} {}", value, si_unit);
  const double factor = unit_factor(shown_unit, si_unit);
  const double shown = value / factor;
  for (const int digits : {15, 16, 17}) {
    const std::string text = fmt::format("{:.{}g} {}", shown, digits, shown_unit);
    const auto read = split_quantity(text);
    const double back = read ? scaled(read->number, factor) : std::nan("");
    if (back == value && std::signbit(back) == std::signbit(value)) return text;
  }
  return fmt::format("{} {}", value, si_unit == "1" ? "m/m" : si_unit);  // "0.3 1" is two numbers
}

}  // namespace wythe
