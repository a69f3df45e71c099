// Whether a run may be believed: how walls that failed like it compare with their tests, and in what it
// differs from all of them.
//
//   Model + Result --compare_with_tests()--> kind of failure, bias and scatter of its tests, reasons
//
// The table behind it (src/judge/modes/tested_walls.h) is written by tools/validation from the tests
// themselves; the page is docs/evidence/validation.md.
#pragma once

#include <string>
#include <vector>

#include "wythe/parts/failure_mode.h"
#include "wythe/parts/message.h"
#include "wythe/parts/model.h"
#include "wythe/parts/result.h"

namespace wythe {

// What tests say of the drift up to which walls of a kind keep 80 % of their peak [-], and how the program's own drift
// compares with the tests of that kind.
struct TestedDrift {
  bool stone = false;                                   // stone walls; else brick and block
  int walls = 0;                                        // 0: nothing is known of the kind
  double median = kUnset, low = kUnset, high = kUnset;  // nine walls of ten lie between
  int own_walls = 0;                                    // 0: never compared
  double own_ratio = kUnset,
         own_factor = kUnset;  // predicted over measured: middle, and exp(sd of ln)
};

struct TestedRange {
  std::string kind;  // "shear", "sliding", "rocking"; "" where the run has no peak or no such kind
  int walls = 0;     // tested walls of that kind
  // Predicted over measured peak: bias with its 95 % interval, relative scatter of the model about it.
  double bias = kUnset, bias_low = kUnset, bias_high = kUnset, scatter = kUnset;
  // In what the run leaves the range of the tests, or why their bias is no good news; empty: it is inside.
  std::vector<Message> notes;
  TestedDrift drift;
};

// All notes as one; empty where there is none.
[[nodiscard]] Message note_of(const TestedRange& range);
// What the drift of this run is worth; empty where nothing is known.
[[nodiscard]] Message drift_note_of(const TestedRange& range);
[[nodiscard]] TestedRange compare_with_tests(const Model& model, const Result& result);

// The kind of a failure mode's name, "shear + rocking" is shear; "" for a name of none.
[[nodiscard]] std::string kind_of_mode(const std::string& name);

}  // namespace wythe
