// The vocabulary and the parser of units against UDUNITS-2, from which both come: every word of
// its XML files with every prefix, a list of expressions, and random ones, valid and invalid.
#include <gtest/gtest.h>
#include <udunits2.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/text.h"
#include "units/dimension.h"
#include "units/unit_parser.h"
#include "wythe/parts/units.h"

extern "C" const char* ut_form_plural(
    const char* singular);  // in the library, and in no header of it

namespace wythe::udunits_test {
namespace {

// The meaning of a text: "" for no unit, "shifted" and "logarithm" if no factor converts it, else its product of SI base units.
struct Meaning {
  std::string what;
  double factor = 1;
};

struct FreeUnit {
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
using UtUnit = std::unique_ptr<ut_unit, FreeUnit>;

class Library {
 public:
  Library() {
    ut_set_error_message_handler(ut_ignore);
    system_ = ut_read_xml(nullptr);
    const UtUnit degree(ut_get_unit_by_name(system_, "degree"));
    ut_map_symbol_to_unit("deg", UT_ASCII, degree.get());  // the one symbol of our own
  }
  ~Library() { ut_free_system(system_); }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;

  [[nodiscard]] Meaning meaning(const std::string& text) const {
    const std::string whole = text.starts_with('/') ? "1" + text : text;
    const UtUnit unit(ut_parse(system_, whole.c_str(), UT_UTF8));
    if (!unit) return {};
    std::vector<char> buffer(1000);
    if (ut_format(unit.get(), buffer.data(), buffer.size() - 1, UT_ASCII | UT_DEFINITION) < 0)
      return {};
    std::string definition = buffer.data();
    if (definition.find("lg(") != std::string::npos) return {"logarithm", 1};
    if (definition.find('@') != std::string::npos) return {"shifted", 1};
    if (const auto blank = definition.find(' '); blank != std::string::npos)
      definition = definition.substr(blank + 1);
    const UtUnit product(ut_parse(system_, definition.c_str(), UT_UTF8));
    cv_converter* converter = ut_get_converter(unit.get(), product.get());
    if (converter == nullptr) return {};  // its scale is no finite number
    const double factor = cv_convert_double(converter, 1);
    cv_free(converter);
    return {definition, factor};
  }

 private:
  ut_system* system_ = nullptr;
};

const Library& library() {
  static const Library one;
  return one;
}

Meaning own_meaning(const std::string& text) {
  const auto unit = parse_unit(text);
  if (!unit) return {};
  if (unit->logarithm) return {"logarithm", 1};
  if (unit->shifted) return {"shifted", 1};
  std::string definition = unit_definition(text);
  if (const auto blank = definition.find(' '); blank != std::string::npos)
    definition = definition.substr(blank + 1);
  return {definition, unit->factor.value()};
}

// Doubles between two of equal sign.
std::int64_t steps_between(double a, double b) {
  std::int64_t x = 0, y = 0;
  std::memcpy(&x, &a, sizeof x);
  std::memcpy(&y, &b, sizeof y);
  return std::abs(x - y);
}

// --- the words of UDUNITS' files

std::string without_entities(std::string text) {
  for (std::size_t at = text.find("&#x"); at != std::string::npos; at = text.find("&#x")) {
    const std::size_t end = text.find(';', at);
    const unsigned code =
        static_cast<unsigned>(std::stoul(text.substr(at + 3, end - at - 3), nullptr, 16));
    std::string bytes;
    if (code < 0x800) {
      bytes = {static_cast<char>(0xc0 | (code >> 6)), static_cast<char>(0x80 | (code & 0x3f))};
    } else {
      bytes = {static_cast<char>(0xe0 | (code >> 12)),
               static_cast<char>(0x80 | ((code >> 6) & 0x3f)),
               static_cast<char>(0x80 | (code & 0x3f))};
    }
    text.replace(at, end + 1 - at, bytes);
  }
  return text;
}

std::string file_text(const std::string& path) {
  std::ifstream file(path);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  for (std::size_t at = text.find("<!--"); at != std::string::npos; at = text.find("<!--"))
    text.erase(at, text.find("-->", at) + 3 - at);
  return text;
}

void take_elements(std::vector<std::string>& out, const std::string& text,
                   const std::string& name) {
  const std::string end_mark = "</" + name + ">";
  for (std::size_t at = text.find("<" + name); at != std::string::npos;
       at = text.find("<" + name, at)) {
    const std::size_t begin = text.find('>', at) + 1, end = text.find(end_mark, begin);
    std::string word = text.substr(begin, end - begin);
    word.erase(0, word.find_first_not_of(" \n\t"));
    word.erase(word.find_last_not_of(" \n\t") + 1);
    out.push_back(without_entities(word));
    at = end;
  }
}

std::string folder_of_library() {
  ut_status status = UT_SUCCESS;
  const std::string path = ut_get_path_xml(nullptr, &status);
  return path.substr(0, path.find_last_of('/') + 1);
}

std::vector<std::string> words_of_library() {
  std::vector<std::string> out;
  for (const char* part : {"base", "derived", "accepted", "common"}) {
    const std::string text = file_text(folder_of_library() + "udunits2-" + part + ".xml");
    std::vector<std::string> names;
    take_elements(names, text, "singular");
    for (const std::string& name : names) {
      out.push_back(name);
      out.emplace_back(ut_form_plural(name.c_str()));
    }
    take_elements(out, text, "plural");
    take_elements(out, text, "symbol");
  }
  return out;
}

std::vector<std::string> prefixes_of_library() {
  const std::string text = file_text(folder_of_library() + "udunits2-prefixes.xml");
  std::vector<std::string> out;
  take_elements(out, text, "name");
  take_elements(out, text, "symbol");
  return out;
}

// What is read otherwise: dates and offsets, logarithms of one's own, words behind a blank that begin with a word of dates
// ("m reflux"), and a bracket at the end that nothing opens, which UDUNITS passes over.
bool is_left_out(const std::string& text) {
  if (text.ends_with(')')) return true;
  for (const char* mark : {"@", "after", "from", "ref", "since", "lg(", "lb(", "ln(", "log("})
    if (text.find(mark) != std::string::npos) return true;
  return false;
}

// Compares what texts are, and factors. UDUNITS rounds after each product, so it may be some doubles away from the nearest
// one: up to 4 for its psi and ksi, up to 21 in the texts at random, of which some are 10th powers.
class Comparison {
 public:
  void add(const std::string& text) {
    const Meaning theirs = library().meaning(text), ours = own_meaning(text);
    if (!std::isnormal(theirs.factor) || !std::isnormal(ours.factor)) return;  // no double
    EXPECT_EQ(ours.what, theirs.what) << '"' << text << '"';
    ++texts;
    if (ours.what.empty() || ours.what != theirs.what) return;
    ++units;
    const std::int64_t apart = steps_between(ours.factor, theirs.factor);
    within_one += apart <= 1;
    EXPECT_LE(apart, 32) << '"' << text << "\" is " << theirs.factor << " there";
  }
  int texts = 0, units = 0, within_one = 0;
};

TEST(UnitsOfUdunits, every_word_with_every_prefix) {
  std::vector<std::string> prefixes = prefixes_of_library();
  ASSERT_EQ(prefixes.size(), 42u);
  prefixes.insert(prefixes.end(), {"", "KILO", "kilokilo", "kkilo", "kk", "dk"});
  Comparison all;
  for (const std::string& word : words_of_library())
    for (const std::string& prefix : prefixes) all.add(prefix + word);
  EXPECT_GT(all.units, 39'000);
  EXPECT_GT(all.within_one, 0.98 * all.units);
}

// Possible text between and after names, with its blanks.
// clang-format off
constexpr const char* kWays[] = {
    "", "1", "/s", "1/s", "1 / s", " /s", "per s", "m", "m2", "m-2", "m+2", "m^2", "m**2", "m^-2", "m**+2", "m ^2",
    "m^ 2", "m ** 2", "m²", "m³", "m²s", "m² s", "m²/s²", "m2s", "m2 s", "m2.s", "m2*s-1", "m^2s", "m^2 s", "m^2.s",
    "m^2-1", "m -2", "m 2", "m.2", "m.5", "m2.5", "m-.5", "m.s", "m·s", "m*s", "m-s", "m s", "m\ts", "m  s",
    "m . s", "m · s", "m * s", "m - s", "m × s", "m×s", "m÷s", "m / s", "m/ s", "m per s", "m PER s", "m  per  s",
    "mper s", "m per(s)", "m persecond", "m/s/s", "m/s per s", "m//s", "m/", "m.", "m ", " m", "m^", "m**", "(m)",
    "( m )", "(m", "()", "m()", "(m)s", "(m)2", "(m)(s)", "m(s)", "2(m)", "(m/s)^2", "(m/s)²", "((m))", "(m.5)",
    "2.5m", "2.m", ".5m", ".m", "1e3m", "1e3 m", "1e m", "1E-3 m", "+3m", "-3m", "-m", "--3m", "5-3", "5 -3",
    "2.5-3", "2.5.5", "2^3", "2³", "0", "0 m", "0.0", "1e400", "1e-400", "m^0", "m0", "m^255", "m^256", "m^-256",
    "m^2^3", "m2 3", "m2^3", "°", "°C", "°C/m", "K/°C", "W/m^2/degC", "1 degC", "degC2", "degC^1", "(degC)",
    "mdegC", "degF", "°F.m", "%", "%%", "%m", "m%", "% m", "'", "''", "\"", "arcsec", "µm", "μm", "um", "µµm",
    "metric_ton", "metric ton", "metric\u00a0ton", "metric\u00a0tons", "\u00a0m", "m\u00a0s", "KILOMETER",
    "kilometre", "Kilometers", "kmeter", "mKilometer", "Pa", "PA", "PASCAL", "pascals", "MPa", "Mpa", "mpa", "kN",
    "KN", "kn", "N/mm^2", "N/mm2", "N mm-2", "N.mm^-2", "N·mm-2", "kN/m", "kN m-1", "GPa/m", "kg/m3", "kg m-3",
    "t/m3", "g/cm^3", "kJ/m^2", "J/m2", "lbf/in^2", "lbf/ft", "psi", "ksi", "psf", "kip/ft2", "kgf/cm2", "kp/cm2",
    "atm", "bar", "mmHg", "mm Hg", "cmH2O", "H2O", "gal", "Gal", "mgal", "g0", "gravity", "standard_free_fall",
    "in", "inch", "inches", "inchs", "feet", "foots", "yd", "gon", "grade", "grad", "turn", "rpm", "rad/s", "deg/s",
    "mdeg", "degs", "min", "h", "hr", "d", "day", "days", "yr", "ppm", "l", "L", "ha", "hectare", "BW", "dBW",
    "BW m", "BW^2", "H2", "h2o", "dam", "dare", "dat", "da", "d", "k", "kilo", "m_", "_m", "_", "m__s", "mé", "é",
    "m\xffs", "€", "m€", "m,s", "m;s", "m:s", "m=s", "m!", "m#", "m$", "m&", "m?", "m[2]", "m{s}", "m|s", "~m"};
// clang-format on

TEST(UnitsOfUdunits, every_way_to_write_a_product) {
  Comparison all;
  for (const char* text : kWays) all.add(text);
  EXPECT_GT(all.texts, 250);
}

TEST(UnitsOfUdunits, what_is_read_beyond_it) {
  for (const auto& [text, same] : {std::pair("m⁻¹", "m^-1"),
                                   {"kg·m⁻³", "kg.m^-3"},
                                   {"N·mm⁻²", "N.mm^-2"},
                                   {"m⁴", "m^4"},
                                   {"m⁺²s", "m^2 s"}}) {
    EXPECT_EQ(own_meaning(text).what, own_meaning(same).what) << text;
    EXPECT_EQ(own_meaning(text).factor, own_meaning(same).factor) << text;
    EXPECT_EQ(library().meaning(text).what, "") << text;
  }
}

// The doubles nearest to the quotients of decimal numbers that the definitions are, computed with fractions in Python.
// clang-format off
constexpr struct {
  const char* unit;
  double value;
} kFactors[] = {
    {"N/mm^2", 1000000.0}, {"MPa", 1000000.0}, {"GPa/m", 1000000000.0}, {"N/mm^3", 1000000000.0},
    {"kN/m^2", 1000.0}, {"kgf/cm^2", 98066.5}, {"g/cm^3", 1000.0}, {"t/m^3", 1000.0}, {"kg/m^3", 1.0},
    {"kN/m^3", 1000.0}, {"lb/ft^3", 16.018463373960138}, {"psi", 6894.757293168362}, {"ksi", 6894757.293168361},
    {"lbf/ft^2", 47.880258980335846}, {"kip/ft^2", 47880.25898033584}, {"lbf/ft", 14.593902937206364},
    {"in", 0.0254}, {"ft", 0.3048}, {"yd", 0.9144}, {"inch^2", 0.00064516}, {"deg", 0.017453292519943295},
    {"rad/s", 1.0}, {"rpm", 0.10471975511965978}, {"arcmin", 0.0002908882086657216},
    {"grade", 0.015707963267948967}, {"gal", 0.01}, {"gravity", 9.80665}, {"atm", 101325.0},
    {"mmHg", 133.322387415}, {"min", 60.0}, {"1/h", 0.0002777777777777778}, {"km/h", 0.2777777777777778},
    {"L", 0.001}, {"cm^4", 1e-08}, {"percent", 0.01}, {"ppm", 1e-06}, {"degree_R", 0.5555555555555556}};
// clang-format on

TEST(UnitFactor, is_the_nearest_double) {
  for (const auto& [unit, value] : kFactors) {
    const auto found = parse_unit(unit);
    ASSERT_TRUE(found.has_value()) << unit;
    EXPECT_EQ(found->factor.value(), value) << unit;
  }
}

// Long texts, deep ones and large powers end, and are no unit.
TEST(UnitText, is_bounded) {
  const auto repeated = [](const std::string& part, int times) {
    std::string out;
    for (int i = 0; i < times; ++i) out += part;
    return out;
  };
  EXPECT_TRUE(parse_unit(repeated("(", 10) + "m" + repeated(")", 10)).has_value());
  for (const std::string& text : std::vector<std::string>{
           repeated("(", 100'000), repeated("(", 400) + "m" + repeated(")", 400),
           repeated("m ", 600) + "m", "(((m^255)^255)^255)^255", "(((km^255)^255)^255)^255",
           std::string("m^2147483648"), std::string("m^-2147483648"), std::string("m⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹"),
           std::string("m\0s", 3), std::string("m\ns")})
    EXPECT_FALSE(parse_unit(text).has_value()) << text.substr(0, 30);
  EXPECT_THROW((void)unit_factor("Ym^14", "m^14"), std::invalid_argument);
  EXPECT_THROW((void)unit_factor("ym^14", "m^14"), std::invalid_argument);
}

// Words, numbers and marks at random, then with a character more, less or another.
TEST(UnitsOfUdunits, texts_at_random) {
  std::vector<std::string> words;
  for (const std::string& word : words_of_library())
    if (const std::string what = library().meaning(word).what; !what.empty() && what != "logarithm")
      words.push_back(word);
  const std::vector<std::string> prefixes = {"",  "",  "",      "",     "k", "M",
                                             "m", "G", "milli", "kilo", "µ", "da"};
  const std::vector<std::string> marks = {"/", ".", "*", " ", "·", " / ", " per ",
                                          "-", "",  "(", ")", "^", "  "};
  const std::vector<std::string> powers = {"",    "",    "",  "2", "-1", "^2",
                                           "^-3", "**2", "²", "³", "^0", "3"};
  const std::vector<std::string> numbers = {"2", "1e3", "-1", "0.5", "7.", ".25", "+3"};
  const std::vector<std::string> letters = {"m", "s", "k", "g", "N", "P", "a", "e",  "2", "-",
                                            "+", ".", "/", "^", "*", "(", ")", " ",  "·", "²",
                                            "°", "µ", "%", "'", "_", "1", "0", "per"};
  std::mt19937 engine(20240229);
  const auto below = [&](std::size_t count) { return engine() % count; };
  const auto one_of = [&](const std::vector<std::string>& list) {
    return list[below(list.size())];
  };
  Comparison all;
  for (int i = 0; i < 40'000; ++i) {
    std::string text;
    for (std::size_t terms = 1 + below(4); terms > 0; --terms) {
      std::string term;  // a draw a statement: operands of + are evaluated in any order
      if (below(8) == 0) {
        term = one_of(numbers);
      } else {
        term = one_of(prefixes);
        term += one_of(words);
        term += one_of(powers);
      }
      text += below(6) == 0 ? "(" + term + ")" + one_of(powers) : term;
      if (terms > 1) text += one_of(marks);
    }
    for (std::size_t slips = i % 2 == 0 ? 0 : 1 + below(3); slips > 0; --slips) {
      std::size_t at = below(text.size() + 1);
      while (at < text.size() && (text[at] & 0xc0) == 0x80) --at;  // to where a character begins
      const std::size_t size = at < text.size() ? std::max<std::size_t>(1, utf8_size(text, at)) : 0;
      const std::size_t replaced = below(2) * size;
      text.replace(at, replaced, below(3) == 0 ? "" : one_of(letters));
    }
    if (!is_left_out(text)) all.add(text);
  }
  EXPECT_GT(all.texts, 35'000);
  EXPECT_GT(all.units, 10'000);
}

}  // namespace
}  // namespace wythe::udunits_test
