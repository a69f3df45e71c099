// What limit analysis says of a model: mechanisms and limit loads, each answered or refused with its reason.
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
      false;  // the caller adds checks of parts (local_check.h), so nothing else need answer
};
// Throws InputError where `only` holds another word; `option` names it there.
void check_asked(const OpinionAsked& asked, const std::string& option = "--only");

// Whether parts that fall on their face are asked for.
[[nodiscard]] bool asks_for_parts(const OpinionAsked& asked);

// How many limit loads there will be, and how long they take on a usual machine [s].
struct OpinionCost {
  int limit_loads = 0;
  double seconds = 0;
};
[[nodiscard]] OpinionCost cost_of(const Model& model, const OpinionAsked& asked);

// `progress` is called a few times a second with what is computed and the share done of all limit loads [0, 1].
// Once `stop` is set, what is left is refused in these words. Throws InputError with every reason where
// nothing could be answered, LimitStopped where it was stopped before the first answer.
[[nodiscard]] SecondOpinion second_opinion(
    const Model& model, const OpinionAsked& asked = {}, const std::atomic<bool>* stop = nullptr,
    const std::function<void(const Message& what, double share)>& progress = {});

}  // namespace wythe
