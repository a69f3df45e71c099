// Parses the header of a column in a record of accelerations: the kind of the column and its unit.
#pragma once

#include <string>

#include "io/text/table.h"
#include "wythe/parts/contact_law.h"

namespace wythe::io {

enum class ColumnKind { kTime, kIndex, kAcceleration, kOther, kUnknown };

struct Column {
  ColumnKind kind = ColumnKind::kUnknown;
  ColumnHead head;              // kTime: its unit is "" where none is stated
  bool states_seconds = false;  // kTime: its header states a time in seconds and nothing else
  bool is_certain = true;       // kOther: by its name or unit, not only by its first letter
  bool is_component = false;    // kUnknown: only a direction, north or ew
  std::string strange = {};  // of an acceleration: words beside the unit that may change it, "pct"
};

// Whether words before the numbers are about velocities or displacements, and not about accelerations.
[[nodiscard]] bool tells_of_other_motion(const std::string& words);

// Data from a comment about the numbers below it.
struct StatedData {
  double step = kUnset;   // [s]
  double count = kUnset;  // of numbers
  std::string factor;     // words of a factor other than 1: "multiply by 9.81"
};
[[nodiscard]] StatedData stated_in(const std::string& comment);

// The first word or number in the header of times that may change
// seconds: "minuti", "1000" of "time/1000 [s]"; "" where there is none.
[[nodiscard]] std::string strange_in_times(const ColumnHead& head);

[[nodiscard]] Column column_of(const std::string& text);

}  // namespace wythe::io
