// How a deformable block is divided into zones, in its plane or in space.
#pragma once

#include "wythe/parts/contact_law.h"
#include "wythe/parts/words.h"

namespace wythe {

// Zones: both pairs of constant-strain triangles of a quadrilateral laid over each other, with half
// the weight each; mixed gives them one common volumetric strain.
enum class ZoneKind { kMixed, kCst };
inline constexpr Word<ZoneKind> kZoneKindWords[] = {{"mixed", ZoneKind::kMixed},
                                                    {"cst", ZoneKind::kCst}};
enum class Plane { kStress, kStrain };
inline constexpr Word<Plane> kPlaneWords[] = {{"stress", Plane::kStress},
                                              {"strain", Plane::kStrain}};

// How a deformable block is divided into zones; kind and plane condition are those of blocks in their plane.
struct ZoneSpec {
  int zones = 0;           // through the depth, in space the height; 0: the block is rigid
  double length = kUnset;  // of a zone [m]; unset: as long as deep
  ZoneKind kind = ZoneKind::kMixed;
  Plane plane = Plane::kStress;
};

}  // namespace wythe
