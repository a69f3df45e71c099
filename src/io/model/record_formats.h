// Records in the formats of the field, recognised by their heads, not by the names of files.
//
//   AT2     PEER and others: a line names NPTS and DT, in any order, up to kMostHeadLines from the top
//   ESM     "KEY: value" lines with SAMPLING_INTERVAL_S, NDATA, UNITS (also ITACA)
//   K-NET   17 lines with "Sampling Freq(Hz)" and "Scale Factor": counts times gal (also KiK-net)
//   COSMOS  "N acceleration pts, approx S secs, units=cm/sec2(04),Format=(8F10.5)" (volumes 1 and 2; also CESMD's V2c)
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "wythe/parts/wall_spec.h"

namespace wythe::io {

struct RecordNumbers {
  std::vector<double> time, acceleration;  // times empty: every step
  double step = kUnset;                    // that the file states [s]
  RecordUnit unit = RecordUnit::kNone;     // that the file states
  std::string stated;                      // where it does so
  int line = 0;
  std::string column;  // of a table: its head or number
  std::string
      no_times;  // of a table: the column that counts rows, or whose unit of time is not known
  double rise = kUnset;  // of that column, from row to row
};

// The unit of accelerations that a text spells, "" where it is none: "g", "gal", "m/s^2", "in/s2", "%g".
[[nodiscard]] std::string acceleration_unit(std::string_view text);
// The one that records may have; kNone for others, %g and in/s2 too.
[[nodiscard]] RecordUnit stated_unit(std::string_view text);

// The unit of accelerations that a line of words states, known here or not: "accelerations in g", "unit: mm/s2", "% of g"; "" where it
// states none.
[[nodiscard]] std::string unit_in_words(const std::string& words);

// Refuses bytes of a known binary format, or of any, by its name; what may be a text passes.
void check_is_text(std::string_view bytes, const std::string& file);

// Nothing where the text is of none of these formats. Throws InputError where it is broken, or of a format that is
// known but not read. Faults have no path: it is that of the key that names the file.
[[nodiscard]] std::optional<RecordNumbers> parse_record_format(const std::string& text,
                                                               const std::string& file);

}  // namespace wythe::io
