// The wall that stands when the growing load begins, where stages cut openings and insert parts.
// Called by limit_load().
#pragma once

#include <vector>

#include "wythe/parts/limit.h"
#include "wythe/parts/model.h"
#include "wythe/parts/reading.h"

namespace wythe::limit {

class StandingWall {
 public:
  explicit StandingWall(const Model& whole);
  // Expands results of this wall to lists of the whole one; what does not stand has no force and no motion.
  void spread_out(LimitResult& answer) const;

  Model model;

 private:
  void take_out();

  std::vector<int> block_, joint_, link_, point_;  // new numbers, -1: left out
  std::vector<bool> stays_;                        // of points
};

}  // namespace wythe::limit
