// Numbers with a point while it stands, in this thread alone: what a host program's locale says of a decimal comma is set
// aside. For nlohmann's JSON, which asks the locale and takes one byte of a mark for all of it.
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
