// Division of a deformable block into zones, in the plane or in space.
#pragma once

#include "wythe/parts/contact_law.h"
#include "wythe/parts/words.h"

namespace wythe {

// Zones of a quadrilateral: both pairs of its constant-strain triangles are superposed with half
// the weight each. kMixed gives them one common volumetric strain.
enum class ZoneKind { kMixed, kCst };
inline constexpr Word<ZoneKind> kZoneKindWords[] = {{"mixed", ZoneKind::kMixed},
                                                    {"cst", ZoneKind::kCst}};
enum class Plane { kStress, kStrain };
inline constexpr Word<Plane> kPlaneWords[] = {{"stress", Plane::kStress},
                                              {"strain", Plane::kStrain}};

// Division of a deformable block into zones; `kind` and the plane condition apply to blocks in the plane.
struct ZoneSpec {
  int zones = 0;           // number over the depth, in space over the height; 0: rigid
  double length = kUnset;  // of a zone [m]; unset: as long as deep
  ZoneKind kind = ZoneKind::kMixed;
  Plane plane = Plane::kStress;
};

}  // namespace wythe
