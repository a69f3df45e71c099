// Blocks in space: what a file or a builder gives of them.
//
//   file or builder ──► BodySpec ──► geometry (mass, inertia, joint faces) ──► Model::space
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "wythe/parts/vector.h"
#include "wythe/parts/zone_spec.h"

namespace wythe {

// A convex solid with flat faces.
struct Polyhedron {
  std::vector<Vec3> vertex;                     // [m], in the wall's axes: y up
  std::vector<std::vector<std::int32_t>> face;  // corners, anticlockwise seen from outside
};

// One block: one convex part, or several that move as one (their inner faces touch).
struct BodySpec {
  std::string id;
  std::vector<Polyhedron> part;
  std::string material = "masonry";  // names a material with a density, else wall.unit.density
  bool fixed = false;                // a support: never moves but by a stage that drives it
  ZoneSpec zone = {};                // deformable where zone.zones > 0: one part, a hexahedron
  std::string role;      // word of BlockRole (model.h); "": masonry, or as its id and material say
  std::string cut = {};  // name of the stage that cuts it out; "": it stays
  std::string put_in = {};  // name of the stage that puts it in; "": it stands from the first on
};

}  // namespace wythe
