// Text for the reader: lengths as text, and faults that all parts of geometry report.
//
// Called by the other files of src/geometry.
#pragma once

#include <string>

#include "wythe/parts/error.h"
#include "wythe/parts/message.h"

namespace wythe::geometry {

[[nodiscard]] std::string metres(double length);              // "1.7 m"
[[nodiscard]] std::string millimetres(double length);         // "154.545 mm"
[[nodiscard]] std::string percent(double share);              // 0.0123 -> "+1.2 %"
[[nodiscard]] std::string times(double factor);               // 30.96 -> "31"
[[nodiscard]] std::string last_key(const std::string& path);  // "wall.unit.length" -> "length"
[[nodiscard]] std::string opening_path(int index,
                                       const std::string& key);            // "wall.opening.0.width"
[[nodiscard]] std::string storey_path(int index, const std::string& key);  // "storey.0.height"

[[nodiscard]] std::string opening_name(int index, const std::string& name);  // "opening 0 (door)"
[[nodiscard]] Message opening_words(int index, const std::string& name);

void add_fault(FaultList& faults, std::string path, std::string value, std::string problem,
               std::string cure);

// One physical number that the builder requires.
struct Needed {
  std::string path;
  double value;
  std::string unit;     // of the value as stored, "m"
  std::string example;  // "5.10 m"
};
// Adds a fault and returns false when the number is missing, infinite, zero or negative.
bool is_positive(const Needed& number, FaultList& faults);
// As is_positive(), but zero is allowed.
bool is_not_negative(const Needed& number, FaultList& faults);

}  // namespace wythe::geometry
