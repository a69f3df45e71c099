// Compares units as drawn with units as built in every storey, and reports on the least reliable storey. Where the real size
// is not stated, units larger than any that is made of their material are not those of the wall either.
// Tested walls for comparison exist only in running bond with equal multiples in both directions (kCoarseWalls). Any other
// wall is reported as untested. docs/theory/assessment.md, "Units drawn larger".
#include "model/coarse_units.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "geometry/wall/storeys.h"
#include "materials/library.h"
#include "materials/origin.h"

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

// The largest units of fired clay, joints included [m]. Solid: bricks of 440 mm by the Romans, and of 113 mm in the German
// format 2 DF. Perforated: blocks of 560 x 274 mm and of 500 x 314 mm are on sale in France. Cut stone, tuff and concrete are
// laid in any size.
struct LargestMade {
  UnitType type;
  double length, height;
  const char* words;  // code of a message
};
constexpr LargestMade kLargestMade[] = {
    {UnitType::kClay, 0.45, 0.125, "unit.kind.clay"},
    {UnitType::kClayPerforated, 0.58, 0.33, "unit.kind.clay_perforated"},
    {UnitType::kClayLightPerforated, 0.58, 0.33, "unit.kind.clay_perforated"}};

// The kind of unit that the file states, or that follows from its typical values or the kind of its scatter. Unstated where
// its materials are of several kinds.
UnitType kind_of_units(const ModelSpec& spec) {
  if (spec.masonry.unit_type != UnitType::kUnstated) return spec.masonry.unit_type;
  UnitType found = UnitType::kUnstated;
  for (const auto& [name, material] : spec.material)
    for (const std::string& line : material.origin) {
      const auto origin = materials::origin_of(line);
      if (!origin || origin->kind != materials::Origin::kTypical || !origin->by.starts_with("of "))
        continue;
      const materials::Entry* entry =
          materials::entry_of(origin->by.substr(3, origin->by.find(' ', 3) - 3));
      if (entry == nullptr || entry->unit_type == UnitType::kUnstated) continue;
      if (found != UnitType::kUnstated && found != entry->unit_type) return UnitType::kUnstated;
      found = entry->unit_type;
    }
  if (found != UnitType::kUnstated) return found;
  if (spec.scatter.use != "clay_brick") return UnitType::kUnstated;
  constexpr double kSolid = 1600;  // masonry of perforated bricks has 1500 kg/m^3 at most
  return spec.wall.unit.density >= kSolid ? UnitType::kClay : UnitType::kClayPerforated;
}

// Units without a real size that are larger than any made; nothing where there are none.
Message larger_than_made(const ModelSpec& spec, const char* code) {
  std::vector<UnitSpec> units = spec.built_unit;  // of the builder in space, else of the storeys
  if (units.empty())
    for (const geometry::Storey& storey : geometry::stated_storeys(spec.wall, spec.storey))
      units.push_back(storey.unit);
  const UnitType type = kind_of_units(spec);
  for (const LargestMade& made : kLargestMade) {
    if (made.type != type) continue;
    for (const UnitSpec& unit : units) {
      constexpr double kRounding = 1 + 1e-9;
      const bool is_long = std::isnan(unit.real.length) && unit.length > made.length * kRounding;
      const bool is_high = std::isnan(unit.real.height) && unit.height > made.height * kRounding;
      if (is_long || is_high)
        return {code,
                {{"length_mm", 1e3 * unit.length},
                 {"height_mm", 1e3 * unit.height},
                 {"kind", Message{made.words}},
                 {"most_length_mm", 1e3 * made.length},
                 {"most_height_mm", 1e3 * made.height}}};
    }
  }
  return {};
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

// Codes of a message: for comparable walls, for no such walls, for no such walls in space, and without a real size.
struct Words {
  const char *compared, *untested, *in_space, *larger;
};

Message words_of_units(const ModelSpec& spec, const Words& words) {
  if (spec.body.empty() && !spec.wall.blocks.empty()) return {};  // files of blocks have no units
  const Drawn drawn = drawn_units(spec);
  if (!drawn.is_coarse) return larger_than_made(spec, words.larger);
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
                                       .in_space = "unit.coarse_in_space",
                                       .larger = "unit.larger_than_made"});
  if (!note.empty()) model.anatomy.notes.push_back(std::move(note));
}

Message caution_of_units(const ModelSpec& spec) {
  return words_of_units(spec, {.compared = "assessment.caution.coarse",
                               .untested = "assessment.caution.coarse_untested",
                               .in_space = "assessment.caution.coarse_in_space",
                               .larger = "assessment.caution.larger_than_made"});
}

}  // namespace wythe
