// Numbers such as "1.900" and "12.000 kg", which may mean thousands or three decimals.
#pragma once

#include <string>
#include <string_view>

namespace wythe::io {

// Whether a number may mean thousands as well as three decimals: "1.900", "-12,500", but not "0.900".
[[nodiscard]] bool may_be_thousands(std::string_view number);

// "12000 kg" for "12.000 kg": a quantity read as thousands, where thousandths of its unit
// do not matter in a wall. "" where three decimals are plausible: "2.400 m", "1.125 kN".
[[nodiscard]] std::string as_thousands(std::string_view quantity);

}  // namespace wythe::io
