// Decides by the unit whether "12.000" can have three decimals: a gram of a mass in kg does not matter, a millimetre
// of a length in m does. Where both are possible, zeros at the end decide. Callers warn; no value is changed.
#include "io/text/thousands.h"

#include <initializer_list>
#include <stdexcept>

#include "core/text.h"
#include "wythe/parts/units.h"

namespace wythe::io {
namespace {

constexpr const char* kDigits = "0123456789";

// The number of these units in one SI unit; 0 for another quantity.
double factor_of(const std::string& unit, const char* si_unit) {
  try {
    return unit_factor(unit, si_unit);
  } catch (const std::invalid_argument&) {
    return 0;
  }
}

// How many final zeros in three decimals show that decimals were not meant. A gram in a mass
// in kg does not matter, a millimetre in a length in m does. 4 means that no zeros show it.
std::size_t zeros_that_tell(const std::string& unit) {
  for (const char* fine : {"N", "kg", "Pa", "kg/m", "kg/m^2", "kg/m^3", "N/m^3"})
    if (const double factor = factor_of(unit, fine); factor > 0) return factor <= 1 ? 0 : 3;
  constexpr double kCentimetre = 0.01;
  for (const char* length : {"m", "m/s"})
    if (const double factor = factor_of(unit, length); factor > 0)
      return factor <= kCentimetre ? 1 : 4;
  if (const double factor = factor_of(unit, "N/m"); factor > 0) return factor <= 1 ? 1 : 3;
  return factor_of(unit, "Pa/m") > 0 ? 3 : 4;
}

}  // namespace

bool may_be_thousands(std::string_view number) {
  const std::size_t begin = number.find_first_of("123456789"), mark = number.find_first_of(".,");
  return mark != std::string_view::npos && begin == number.find_first_of(kDigits) && mark > begin &&
         mark - begin <= 3 &&
         number.find_first_not_of(kDigits, mark + 1) == std::string_view::npos &&
         number.size() == mark + 4;
}

std::string as_thousands(std::string_view quantity) {
  const std::string_view text = trimmed(quantity);
  const std::size_t end = text.find_first_not_of("+-.0123456789");
  if (end == std::string_view::npos || !may_be_thousands(text.substr(0, end))) return "";
  const std::string unit(trimmed(text.substr(end)));
  std::string number(text.substr(0, end));
  const std::size_t zeros = number.size() - 1 - number.find_last_not_of('0');
  if (zeros < zeros_that_tell(unit)) return "";
  return number.erase(number.find('.'), 1) + ' ' + unit;
}

}  // namespace wythe::io
