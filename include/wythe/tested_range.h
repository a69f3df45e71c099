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

#include "wythe/failure_mode.h"
#include "wythe/message.h"
#include "wythe/model.h"
#include "wythe/result.h"

namespace wythe {

struct TestedRange {
  std::string kind;  // "shear", "sliding", "rocking"; "" where the run has no peak or no such kind
  int walls = 0;     // tested walls of that kind
  // Predicted over measured peak: bias with its 95 % interval, relative scatter of the model about it.
  double bias = kUnset, bias_low = kUnset, bias_high = kUnset, scatter = kUnset;
  // In what the run leaves the range of the tests, or why their bias is no good news; empty: it is inside.
  std::vector<Message> notes;
};

// All notes as one; empty where there is none.
[[nodiscard]] Message note_of(const TestedRange& range);
[[nodiscard]] TestedRange compare_with_tests(const Model& model, const Result& result);

// The kind of a failure mode's name, "shear + rocking" is shear; "" for a name of none.
[[nodiscard]] std::string kind_of_mode(const std::string& name);

}  // namespace wythe
