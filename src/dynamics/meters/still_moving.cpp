// Compares the kinetic energy of the last tenth of the rows with the largest energy since the records ended.
// Energy is measured by how high it lifts the whole wall, over the wall's height. The first watched point
// still moves if its displacement is the largest so far, grew by 5 % in that tenth, and some energy is left.
#include "dynamics/meters/still_moving.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/elementary.h"

namespace wythe::dynamics {

bool is_still_moving(const Model& model, const Result& result) {
  constexpr double kLifted = 1e-4, kGrown = 1.05;
  const std::vector<ShakeRow>& row = result.history.row;
  double free = 0;  // seconds after the last record
  for (const Stage& stage : model.stages)
    if (const auto* shake = std::get_if<ShakeStage>(&stage.spec.action))
      free = shake->free_vibration;
  if (row.empty()) return false;
  const std::size_t tail = row.size() - std::max<std::size_t>(1, row.size() / 10);
  double before = 0, last = 0, largest = 0;
  const auto way = [&](std::size_t k) {
    const PointMotion& u = result.history.motion[k * result.history.point.size()];
    return elementary::hypot(u[0], u[2]);
  };
  const bool is_watched = !result.history.point.empty();
  for (std::size_t k = 0; k < row.size(); ++k) {
    if (k >= tail)
      last = std::max(last, row[k].kinetic);
    else if (row[k].time > row.back().time - free)
      before = std::max(before, row[k].kinetic);
    if (is_watched && k + 1 < row.size()) largest = std::max(largest, way(k));
  }
  const double lift = last / (model.weight * model.anatomy.height);
  const bool still_goes = is_watched &&
                          way(row.size() - 1) > std::max(largest, kGrown * way(tail)) &&
                          lift > 1e-2 * kLifted;
  return still_goes || (lift > kLifted && last > kGrown * before);
}

}  // namespace wythe::dynamics
