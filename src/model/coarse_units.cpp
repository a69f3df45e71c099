// Compares units as drawn with units as built in every storey, and reports on the least reliable storey.
// Tested walls for comparison exist only in running bond with equal multiples in both directions (kCoarseWalls). Any other
// wall is reported as untested. docs/theory/assessment.md, "Units drawn larger".
#include "model/coarse_units.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/wall/storeys.h"

namespace wythe {
namespace {

// Magnification of units in the least reliable storey.
struct Drawn {
  double times_long = 1, times_high = 1;
  bool is_coarse = false;
  const CoarseWalls* like = nullptr;  // null: no such walls were compared
};

double times(double drawn, double real) { return std::isnan(real) ? 1 : std::round(drawn / real); }

const CoarseWalls* walls_like(const Drawn& drawn, Bond bond) {
  if (drawn.times_long != drawn.times_high || bond != Bond::kRunning) return nullptr;
  for (const CoarseWalls& walls : kCoarseWalls)
    if (walls.times == drawn.times_long) return &walls;
  return nullptr;
}

// A storey without comparable walls is the least reliable, then the one with larger units.
bool is_worse(const Drawn& a, const Drawn& b) {
  if (a.is_coarse != b.is_coarse) return a.is_coarse;
  if ((a.like == nullptr) != (b.like == nullptr)) return a.like == nullptr;
  return a.times_long * a.times_high > b.times_long * b.times_high;
}

Drawn drawn_units(const ModelSpec& spec) {
  Drawn worst;
  for (const geometry::Storey& storey : geometry::stated_storeys(spec.wall, spec.storey)) {
    const UnitSpec& unit = storey.unit;
    Drawn drawn{times(unit.length, unit.real.length), times(unit.height, unit.real.height)};
    drawn.is_coarse = drawn.times_long != 1 || drawn.times_high != 1;
    drawn.like = walls_like(drawn, storey.bond);
    if (is_worse(drawn, worst)) worst = drawn;
  }
  return worst;
}

// Codes of a message: for comparable walls, for no such walls, and for no such walls in space.
struct Words {
  const char *compared, *untested, *in_space;
};

Message words_of_units(const ModelSpec& spec, const Words& words) {
  if (spec.body.empty() && !spec.wall.blocks.empty()) return {};  // files of blocks have no units
  const Drawn drawn = drawn_units(spec);
  if (!drawn.is_coarse) return {};
  if (!spec.body.empty()) return {words.in_space};  // whose walls may have their own units
  if (drawn.like == nullptr)
    return {words.untested, {{"long", drawn.times_long}, {"high", drawn.times_high}}};
  const CoarseWalls& like = *drawn.like;
  // Capacity over demand follows the force at short periods, the displacement at long ones, and a
  // mean of both between them (docs/theory/assessment.md, "Units drawn larger").
  return {words.compared,
          {{"times", like.times},
           {"force_low_percent", 100 * like.force_low},
           {"force_high_percent", 100 * like.force_high},
           {"drift_low_percent", 100 * like.drift_low},
           {"drift_high_percent", 100 * like.drift_high},
           {"low_percent", 100 * std::min(like.force_low, like.drift_low)},
           {"high_percent", 100 * std::max(like.force_high, like.drift_high)},
           {"other", like.other},
           {"walls", like.walls}}};
}

}  // namespace

void note_coarse_units(const ModelSpec& spec, Model& model) {
  Message note = words_of_units(spec, {.compared = "unit.coarse",
                                       .untested = "unit.coarse_untested",
                                       .in_space = "unit.coarse_in_space"});
  if (!note.empty()) model.anatomy.notes.push_back(std::move(note));
}

Message caution_of_units(const ModelSpec& spec) {
  return words_of_units(spec, {.compared = "assessment.caution.coarse",
                               .untested = "assessment.caution.coarse_untested",
                               .in_space = "assessment.caution.coarse_in_space"});
}

}  // namespace wythe
