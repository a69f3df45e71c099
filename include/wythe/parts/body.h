// Blocks in space as a file or the builder describes them.
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

// One block of one convex part, or of several that move as one; their inner faces touch.
struct BodySpec {
  std::string id;
  std::vector<Polyhedron> part;
  std::string material = "masonry";  // names a material with a density, else wall.unit.density
  bool fixed = false;                // a support: only a stage that drives it can move it
  ZoneSpec zone = {};                // deformable where zone.zones > 0: a single hexahedron
  std::string role;         // word of BlockRole (model.h); "": masonry, or by id and material
  std::string cut = {};     // name of the stage that removes it; "": it stays
  std::string put_in = {};  // name of the stage that inserts it; "": it stands from the start
};

}  // namespace wythe
