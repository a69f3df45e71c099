// Numbers such as "1.900" and "12.000 kg", which some write for thousands and others with three decimals.
#pragma once

#include <string>
#include <string_view>

namespace wythe::io {

// Whether a number may have thousands as well as three decimals: "1.900", "-12,500", and not "0.900".
[[nodiscard]] bool may_be_thousands(std::string_view number);

// "12000 kg" for "12.000 kg": a quantity as thousands, where thousandths of its unit mean nothing in a wall. "" where three
// decimals are what a user may write: "2.400 m", "1.125 kN".
[[nodiscard]] std::string as_thousands(std::string_view quantity);

}  // namespace wythe::io
