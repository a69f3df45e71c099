// Records in common formats, recognised by their headers, not by file names.
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
  std::string column;  // of a table: its header or number
  std::string
      no_times;  // of a table: a column of row numbers, or one of times with an unknown unit
  double rise = kUnset;  // of that column, from row to row
};

// The unit of acceleration in a text: "g", "gal", "m/s^2", "in/s2", "%g"; "" where it is none.
[[nodiscard]] std::string acceleration_unit(std::string_view text);
// The same if records may have it; kNone for others, including %g and in/s2.
[[nodiscard]] RecordUnit stated_unit(std::string_view text);

// The unit of acceleration in a line of words, whether it is supported or
// not: "accelerations in g", "unit: mm/s2", "% of g"; "" where there is none.
[[nodiscard]] std::string unit_in_words(const std::string& words);

// Refuses binary files, with the format's name if it is known. Bytes that may be a text pass.
void check_is_text(std::string_view bytes, const std::string& file);

// The record in a text; none where it has none of these formats. Throws InputError where it is broken, or of a
// known format that is not supported. Faults have no path, because the caller adds the key that names the file.
[[nodiscard]] std::optional<RecordNumbers> parse_record_format(const std::string& text,
                                                               const std::string& file);

}  // namespace wythe::io
