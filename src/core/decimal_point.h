// While an object of this class lives, its thread writes and reads numbers with a decimal point, whatever the host program's
// locale is. nlohmann's JSON needs this: it asks the locale for the decimal mark and takes only the mark's first byte.
#pragma once

#include <locale.h>

namespace wythe {

class DecimalPoint {
 public:
  DecimalPoint() : before_(uselocale(plain())) {}
  ~DecimalPoint() { uselocale(before_); }
  DecimalPoint(const DecimalPoint&) = delete;
  DecimalPoint& operator=(const DecimalPoint&) = delete;

 private:
  static locale_t plain() {
    static const locale_t made = newlocale(LC_ALL_MASK, "C", nullptr);
    return made;
  }
  locale_t before_;
};

}  // namespace wythe
