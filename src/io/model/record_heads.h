// What the head of a column says in a record of accelerations: what the column holds, and in which unit.
#pragma once

#include <string>

#include "io/text/table.h"
#include "wythe/parts/contact_law.h"

namespace wythe::io {

enum class ColumnKind { kTime, kIndex, kAcceleration, kOther, kUnknown };

struct Column {
  ColumnKind kind = ColumnKind::kUnknown;
  ColumnHead head;              // kTime: its unit is "" where none is stated
  bool states_seconds = false;  // kTime: its head is a time in seconds and nothing else
  bool is_certain = true;       // kOther: its name or its unit says so, not its first letter alone
  bool is_component = false;    // kUnknown: a direction alone, north or ew
  std::string strange = {};  // of an acceleration: words beside the unit that may change it, "pct"
};

// Whether words before the numbers speak of velocities or displacements, and not of accelerations.
[[nodiscard]] bool tells_of_other_motion(const std::string& words);

// What a comment says of the numbers below it.
struct Told {
  double step = kUnset;   // [s]
  double count = kUnset;  // of numbers
  std::string factor;     // words of one that is not 1: "multiply by 9.81"
};
[[nodiscard]] Told told_in(const std::string& comment);

// The first word or number of the head of times that may change seconds: "minuti", "1000" of "time/1000 [s]"; "" where
// there is none.
[[nodiscard]] std::string strange_in_times(const ColumnHead& head);

[[nodiscard]] Column column_of(const std::string& text);

}  // namespace wythe::io
