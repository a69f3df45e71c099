// A scanner, a recursive-descent parser over its tokens, and the vocabulary as two sorted maps. The first use builds the maps.
#include "units/unit_parser.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>
#include <utility>

#include "core/ascii.h"
#include "core/number.h"
#include "core/text.h"
#include "units/unit_table.h"

namespace wythe {
namespace {

// Longer or deeper texts are not units, and a deep one would overflow the stack.
constexpr std::size_t kLongestText = 1000;
constexpr int kDeepest = 20;
constexpr int kLargestPower = 255;
constexpr int kLargestExponent = 10'000;  // of ten or of a base, so that no int overflows

struct Prefix {
  std::string_view name, symbol;
  int ten;  // exponent
};
// clang-format off
constexpr Prefix kPrefixes[] = {  // da before d
    {"yotta", "Y", 24}, {"zetta", "Z", 21}, {"exa", "E", 18}, {"peta", "P", 15}, {"tera", "T", 12}, {"giga", "G", 9},
    {"mega", "M", 6}, {"kilo", "k", 3}, {"hecto", "h", 2}, {"deka", "da", 1}, {"deci", "d", -1}, {"centi", "c", -2},
    {"milli", "m", -3}, {"micro", "u", -6}, {"micro", "\u00b5", -6}, {"micro", "\u03bc", -6}, {"nano", "n", -9},
    {"pico", "p", -12}, {"femto", "f", -15}, {"atto", "a", -18}, {"zepto", "z", -21}, {"yocto", "y", -24}};
// clang-format on

constexpr std::string_view kSuperscripts[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
constexpr std::string_view kNoBreak = "\u00a0";

std::string in_capitals(std::string_view name) {
  std::string out(name);
  std::transform(out.begin(), out.end(), out.begin(), ascii_capital);
  return out;
}

bool starts_in_any_case(std::string_view text, std::string_view word) {
  return text.size() >= word.size() &&
         std::equal(word.begin(), word.end(), text.begin(),
                    [](char a, char b) { return ascii_capital(a) == ascii_capital(b); });
}

// --- tokens

struct Integer {
  int value = 0;
  std::size_t size = 0;  // in bytes; 0 where there is none
};

// "+2", "-12" at the beginning of a text
Integer integer_in(std::string_view text) {
  const std::size_t plus = text.starts_with('+') && !text.starts_with("+-") ? 1 : 0;
  const auto found = leading_number<int>(text.substr(plus));
  return found ? Integer{found->value, text.size() - found->rest.size()} : Integer();
}

// "⁻²"
Integer superscript_in(std::string_view text) {
  const bool negative = text.starts_with("⁻");
  const std::size_t begin = negative || text.starts_with("⁺") ? 3 : 0;
  Integer out{0, begin};
  for (int digit = 0; digit < 10; ++digit)
    if (text.substr(out.size).starts_with(kSuperscripts[digit])) {
      out.value = std::min(10 * out.value + digit, kLargestPower + 1);
      out.size += kSuperscripts[digit].size();
      digit = -1;  // restarts the search for the next digit
    }
  if (negative) out.value = -out.value;
  return out.size > begin ? out : Integer();
}

// Length of a decimal number such as "-1.5e3" at the beginning of a text.
std::size_t decimal_size(std::string_view text) {
  const std::size_t sign = text.starts_with('+') || text.starts_with('-') ? 1 : 0;
  if (text.size() == sign || (!is_digit(text[sign]) && text[sign] != '.')) return 0;
  const auto found = leading_number(text.substr(sign));
  return found ? text.size() - found->rest.size() : 0;
}

bool is_blank(char c) { return is_ascii_space(c) && c != '\n'; }

struct Token {
  enum class Kind {
    kEnd,
    kName,
    kInteger,
    kDecimal,
    kPower,
    kTimes,
    kOver,
    kOpen,
    kClose,
    kStrange
  };
  Kind kind = Kind::kEnd;
  std::string_view text = {};
  int power = 0;  // of kInteger and kPower
};
using Kind = Token::Kind;

// Cuts a unit's text into the longest tokens. No name or decimal number follows a name directly: "m.5" is m times 5.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : rest_(text) {}

  Token next() {
    if (rest_.empty()) return {};
    const std::size_t blanks = blanks_at(0), name = behind_name_ ? 0 : name_size();
    const std::string_view mark = rest_.substr(blanks);
    const std::size_t over = mark.starts_with('/') ? 1 : starts_in_any_case(mark, "per") ? 3 : 0;
    const std::size_t over_end = blanks + over + blanks_at(blanks + over);
    if (over > 0 && over_end >= name) return cut(Kind::kOver, over_end);
    if (blanks > 0) return cut(Kind::kTimes, blanks);
    if (name > 0) return cut(Kind::kName, name);
    const Integer integer = integer_in(rest_), superscript = superscript_in(rest_);
    const std::size_t decimal = behind_name_ ? 0 : decimal_size(rest_);
    if (decimal > integer.size) return cut(Kind::kDecimal, decimal);
    if (integer.size > 0) return cut(Kind::kInteger, integer.size, integer.value);
    if (superscript.size > 0) return cut(Kind::kPower, superscript.size, superscript.value);
    const std::size_t raise = rest_.starts_with("**") ? 2 : rest_.starts_with('^') ? 1 : 0;
    const Integer power = integer_in(rest_.substr(raise));
    if (raise > 0 && power.size > 0) return cut(Kind::kPower, raise + power.size, power.value);
    if (rest_.starts_with("·")) return cut(Kind::kTimes, 2);
    constexpr std::string_view kTimes = ".*-";
    const char sign = rest_[0];
    return cut(kTimes.find(sign) != std::string_view::npos ? Kind::kTimes
               : sign == '('                               ? Kind::kOpen
               : sign == ')'                               ? Kind::kClose
                                                           : Kind::kStrange,
               1);
  }

 private:
  Token cut(Kind kind, std::size_t size, int power = 0) {
    const Token out{kind, rest_.substr(0, size), power};
    rest_.remove_prefix(size);
    // "m^2s" is refused, "m²s" is accepted
    const bool keeps = kind == Kind::kPower && (out.text[0] == '^' || out.text[0] == '*');
    behind_name_ = keeps ? behind_name_ : kind == Kind::kName;
    return out;
  }

  [[nodiscard]] std::size_t blanks_at(std::size_t begin) const {
    std::size_t end = begin;
    while (end < rest_.size() && is_blank(rest_[end])) ++end;
    return end - begin;
  }

  // A name begins and ends with a letter and may contain digits: "H2O". Beyond ASCII all characters but · and superscripts are letters.
  [[nodiscard]] std::size_t name_size() const {
    if (rest_[0] == '%' || rest_[0] == '\'' || rest_[0] == '"') return 1;
    std::size_t end = 0;
    for (std::size_t i = 0; i < rest_.size(); ++i) {
      const std::string_view left = rest_.substr(i);
      const bool foreign = static_cast<unsigned char>(left[0]) >= 0x80 && !left.starts_with("·") &&
                           superscript_in(left).size == 0;
      if (is_ascii_letter(left[0]) || left[0] == '_' || foreign)
        end = i + 1;
      else if (i == 0 || !is_digit(left[0]))
        break;
    }
    return end;
  }

  std::string_view rest_;
  bool behind_name_ = false;
};

// --- units

// a b^power, where it is a unit. The product has no offset of its own: W/m^2/degC is per kelvin.
std::optional<Unit> product(const Unit& a, const Unit& b, int power) {
  if (a.logarithm || b.logarithm || power < -kLargestPower || power > kLargestPower)
    return std::nullopt;
  Unit out;
  out.factor = a.factor.times(b.factor.power(power));
  bool fits = std::abs(out.factor.ten) <= kLargestExponent;
  for (std::size_t i = 0; i < out.exponent.size(); ++i) {
    out.exponent[i] = a.exponent[i] + power * b.exponent[i];
    fits = fits && std::abs(out.exponent[i]) <= kLargestExponent;
  }
  return fits ? std::optional(out) : std::nullopt;
}

std::string plural_of(const std::string& name) {
  const auto ends_in_one_of = [&](std::initializer_list<const char*> ends) {
    return std::any_of(ends.begin(), ends.end(),
                       [&](const char* end) { return name.ends_with(end); });
  };
  if (name.ends_with('y') && !ends_in_one_of({"ay", "ey", "iy", "oy", "uy"}))
    return name.substr(0, name.size() - 1) + "ies";
  return name + (ends_in_one_of({"s", "x", "z", "ch", "sh"}) ? "es" : "s");
}

// Cuts off the part before the mark, without blanks; the whole text where the mark is missing.
std::string_view cut_at(std::string_view& text, char mark) {
  const std::size_t end = std::min(text.find(mark), text.size());
  const std::string_view out = trimmed(text.substr(0, end));
  text.remove_prefix(std::min(end + 1, text.size()));
  return out;
}

class Vocabulary {
 public:
  Vocabulary() {
    for (std::string_view lines = kUnitLines; !lines.empty();)
      if (std::string_view line = cut_at(lines, '\n'); !line.empty() && line[0] != '#') add(line);
  }

  // A unit with its prefixes, at most one of which is a symbol: "kilometer", "kmeter", "km", but not "mkm".
  [[nodiscard]] std::optional<Unit> find(std::string_view text) const {
    std::string name(text);
    for (std::size_t i = name.find(kNoBreak); i != std::string::npos; i = name.find(kNoBreak))
      name.replace(i, kNoBreak.size(), "_");
    int ten = 0;
    bool symbol_seen = false;
    for (std::string_view rest = name; !rest.empty();) {
      if (const Unit* unit = whole(rest)) {
        Unit out = *unit;
        out.factor.ten += ten;
        return out;
      }
      const Prefix* prefix = nullptr;
      std::size_t size = 0;
      for (const Prefix& p : kPrefixes)
        if (!prefix && starts_in_any_case(rest, p.name)) prefix = &p, size = p.name.size();
      if (!prefix && !std::exchange(symbol_seen, true))
        for (const Prefix& p : kPrefixes)
          if (!prefix && rest.starts_with(p.symbol)) prefix = &p, size = p.symbol.size();
      if (!prefix) return std::nullopt;
      ten += prefix->ten;
      rest.remove_prefix(size);
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] const Unit* whole(std::string_view word) const {
    if (const auto found = names_.find(in_capitals(word)); found != names_.end())
      return &found->second;
    const auto found = symbols_.find(word);
    return found == symbols_.end() ? nullptr : &found->second;
  }

  void add(std::string_view line);

  std::map<std::string, Unit, std::less<>> names_;  // in capital letters
  std::map<std::string, Unit, std::less<>> symbols_;
  std::size_t bases_ = 0;
};

class Parser {
 public:
  Parser(const Vocabulary& vocabulary, std::string_view text)
      : vocabulary_(vocabulary), scanner_(text), token_(scanner_.next()) {}

  std::optional<Unit> parse() {
    if (token_.kind == Kind::kEnd) return Unit();
    const auto out = product_of(token_.text.starts_with('/') ? Unit() : power());
    return token_.kind == Kind::kEnd ? out : std::nullopt;
  }

 private:
  Token take() { return std::exchange(token_, scanner_.next()); }

  // Parses what follows the first power of a product.
  std::optional<Unit> product_of(std::optional<Unit> out) {
    while (out && token_.kind != Kind::kEnd && token_.kind != Kind::kClose) {
      const bool over = token_.kind == Kind::kOver;
      if (over || token_.kind == Kind::kTimes) take();
      const auto factor = power();
      out = factor ? product(*out, *factor, over ? -1 : 1) : std::nullopt;
    }
    return out;
  }

  std::optional<Unit> power() {
    const auto base = basic();
    if (!base || (token_.kind != Kind::kInteger && token_.kind != Kind::kPower)) return base;
    const int exponent = take().power;
    return exponent == 1 ? base : product(Unit(), *base, exponent);
  }

  std::optional<Unit> basic() {
    const Token token = take();
    if (token.kind == Kind::kName) return vocabulary_.find(token.text);
    if (token.kind == Kind::kInteger || token.kind == Kind::kDecimal) {
      Unit out;
      out.factor = ratio_of(token.text);
      return std::isnormal(out.factor.value()) ? std::optional(out) : std::nullopt;
    }
    if (token.kind != Kind::kOpen || ++depth_ > kDeepest) return std::nullopt;
    const auto out = product_of(power());
    --depth_;
    return take().kind == Kind::kClose ? out : std::nullopt;
  }

  const Vocabulary& vocabulary_;
  Scanner scanner_;
  Token token_;
  int depth_ = 0;
};

void Vocabulary::add(std::string_view line) {
  std::string_view definition = cut_at(line, '|');
  std::string_view symbols = cut_at(line, '|'), names = line;
  Unit unit;
  if (definition == "base") {
    unit.exponent[bases_++] = 1;
  } else if (definition == "logarithm") {
    unit.logarithm = true;
  } else {
    constexpr std::string_view kShifted = " shifted";
    const bool shifted = definition.ends_with(kShifted);
    if (shifted) definition.remove_suffix(kShifted.size());
    unit = Parser(*this, definition).parse().value();
    unit.shifted = unit.shifted || shifted;
  }
  while (!symbols.empty()) symbols_[std::string(cut_at(symbols, ' '))] = unit;
  while (!names.empty()) {
    std::string_view plural = cut_at(names, ' ');
    const std::string name(cut_at(plural, '/'));
    if (name.empty()) continue;
    names_[in_capitals(name)] = unit;
    names_[in_capitals(plural.empty() ? plural_of(name) : plural)] = unit;
  }
}

}  // namespace

std::optional<Unit> parse_unit(std::string_view text) {
  static const Vocabulary vocabulary;
  if (text.size() > kLongestText) return std::nullopt;
  return Parser(vocabulary, text).parse();
}

}  // namespace wythe
