// The limit load for a page that follows a drawing: within a second for walls of a thousand blocks.
#pragma once

#include "wythe/parts/limit.h"

namespace wythe {

// What a quick load and that of limit_load() may differ by, relative [-].
inline constexpr double kQuickError = 1e-4;

// As limit_load(), by the static programme alone: its dual gives `kinematic` and the mechanism, and whether the wall
// stands without the load is asked with the load left out. A wall without an answer is refused, too. limit_load()
// answers where the error could be larger, and with stress blocks.
[[nodiscard]] LimitResult quick_limit_load(const Model& model, const LimitOptions& options,
                                           const LimitMonitor& monitor = {});

}  // namespace wythe
