// Whether a run is credible: how predictions for walls with its kind of failure compare with tests, and how it
// differs from all tested walls.
//
//   Model + Result --compare_with_tests()--> kind of failure, bias and scatter of its tests, reasons
//
// tools/validation writes the table behind it (src/judge/modes/tested_walls.h) from the tests;
// docs/evidence/validation.md describes it.
#pragma once

#include <string>
#include <vector>

#include "wythe/parts/failure_mode.h"
#include "wythe/parts/message.h"
#include "wythe/parts/model.h"
#include "wythe/parts/result.h"

namespace wythe {

// Drift up to which tested walls of a kind keep 80 % of their peak [-], and how the program's own drifts compare with
// these tests.
struct TestedDrift {
  bool stone = false;                                   // stone walls; else brick and block
  int walls = 0;                                        // 0: no tests of this kind
  double median = kUnset, low = kUnset, high = kUnset;  // nine walls of ten are in low to high
  int own_walls = 0;                                    // compared with the program; 0: none
  double own_ratio = kUnset,
         own_factor = kUnset;  // predicted over measured: middle, and exp(sd of ln) [-]
};

struct TestedRange {
  std::string kind;  // "shear", "sliding", "rocking"; "": no peak or another kind
  int walls = 0;     // tested walls of that kind
  // Predicted over measured peak: bias with its 95 % interval, and relative scatter of the model about it [-].
  double bias = kUnset, bias_low = kUnset, bias_high = kUnset, scatter = kUnset;
  // Where the run leaves the range of the tests, or why their bias does not reassure; empty: it is inside.
  std::vector<Message> notes;
  TestedDrift drift;
};

// All notes as one message; empty where there is none.
[[nodiscard]] Message note_of(const TestedRange& range);
// How reliable the drift of this run is; empty where nothing is known.
[[nodiscard]] Message drift_note_of(const TestedRange& range);
[[nodiscard]] TestedRange compare_with_tests(const Model& model, const Result& result);

// The kind of failure in a mode's name: "shear + rocking" gives "shear"; "" where there is none.
[[nodiscard]] std::string kind_of_mode(const std::string& name);

}  // namespace wythe
