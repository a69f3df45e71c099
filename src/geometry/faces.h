// From contacts to faces: what kind of joint each is and which joint material it takes.
//
//   two halves of one unit            kSplit        unit
//   masonry on or beside masonry      kBed, kHead   joint (blocks files: the first matching rule)
//   lintel segment to its neighbour   kLintelChain  the lintel's own material
//   lintel to masonry                 kLintelBond   lintel.bond
//   under a plate, under the beam     kPlate, kBeam stage.plate_joint, beam.joint
//   on the ground or on a support     kFoundation   foundation, or joint where there is none
//
// Called by assembly.cpp after find_contacts().
#pragma once

#include <string>
#include <vector>

#include "geometry/assembly.h"
#include "geometry/joints.h"

namespace wythe::geometry {

[[nodiscard]] bool uses_blocks_file(const Shape& shape);

// Faces in the contacts' order; contacts between two supports are dropped.
[[nodiscard]] std::vector<Face> name_faces(const Shape& shape, const std::vector<Block>& blocks,
                                           const std::vector<Contact>& contacts);

// Adds a fault for each material that the built faces take and the spec lacks.
void check_materials(const Shape& shape, const std::vector<Face>& faces, FaultList& faults);

// The same from the spec alone, for a wall that other faults keep from being built.
void check_stated_materials(const Shape& shape, FaultList& faults);

}  // namespace wythe::geometry
