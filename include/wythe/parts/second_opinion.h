// Limit analysis of a model: each requested mechanism and limit load is answered or refused with its reason.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "wythe/parts/limit.h"
#include "wythe/parts/message.h"
#include "wythe/parts/model.h"

namespace wythe {

struct OpinionAsked {
  std::vector<std::string>
      only;  // "infinite", "macro_block_1", "macro_block_2", "lp", "parts"; empty: all
  bool assessment = false;  // of each mechanism, after Circolare 7/2019
  bool quick = false;       // the first limit load alone, to kQuickError (quick_limit.h)
  bool parts =
      false;  // the caller adds checks of parts (local_check.h), so other analyses may fail
};
// Throws InputError where `only` holds an unknown word; the fault names `option`.
void check_asked(const OpinionAsked& asked, const std::string& option = "--only");

// Whether checks of parts out of plane are requested.
[[nodiscard]] bool asks_for_parts(const OpinionAsked& asked);

// Number of limit loads, and their time on a usual machine [s].
struct OpinionCost {
  int limit_loads = 0;
  double seconds = 0;
};
[[nodiscard]] OpinionCost cost_of(const Model& model, const OpinionAsked& asked);

// Runs the analyses. `progress` gets the current one and the share done of all limit loads [0, 1] a few times a second.
// Once `stop` is set, the remaining analyses are refused in these words. Throws InputError with all reasons where no
// analysis succeeded, LimitStopped where it was stopped before the first result.
[[nodiscard]] SecondOpinion second_opinion(
    const Model& model, const OpinionAsked& asked = {}, const std::atomic<bool>* stop = nullptr,
    const std::function<void(const Message& what, double share)>& progress = {});

}  // namespace wythe
