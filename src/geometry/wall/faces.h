// Turns contacts into faces: the kind of each joint and its joint material.
//
//   two halves of one unit            kSplit        wall.unit_joint, or unit
//   masonry beside masonry            kHead         wall.head_joint, or as a bed joint with its head_joint_bond
//   masonry on masonry                kBed          wall.joint, or joint
//       first of region, storey, wall that states one; blocks files: the first matching contact rule
//   voussoir to voussoir of its arch   kHead        arch.joint, or as a bed joint
//   segment to segment of a lintel,   kLintelChain  its own material
//       sill or ring beam
//   lintel to masonry                 kLintelBond   lintel.bond
//   sill, ring beam to masonry        kBed, kHead   sill.joint, ring_beam.joint, ring_beam.top_joint
//   a frame to what it touches        kFrame        frame.joint
//   under a plate, under the beam     kPlate, kBeam stage.plate_joint, beam.joint
//   on the ground or on a support     kFoundation   foundation, or as a bed joint where there is none
//
// A joint between two regions belongs to the one listed first; that of a region with other masonry to the latter. So a
// region only owns joints between its own blocks. The bed joint between two storeys is that of the upper one.
//
// Called by assembly.cpp after find_contacts().
#pragma once

#include <string>
#include <vector>

#include "geometry/assembly.h"
#include "geometry/wall/joints.h"

namespace wythe::geometry {

[[nodiscard]] bool uses_blocks_file(const Shape& shape);

// Name of the bed joint material for the masonry of this block.
[[nodiscard]] std::string bed_material(const Shape& shape, const Block& block);

// Faces in the order of the contacts; contacts between two supports are dropped.
[[nodiscard]] std::vector<Face> name_faces(const Shape& shape, const std::vector<Block>& blocks,
                                           const std::vector<Contact>& contacts);

// Adds a fault for each material of the faces that the spec lacks.
void check_materials(const Shape& shape, const std::vector<Face>& faces, FaultList& faults);

// As check_materials() from the spec alone, for a wall that other faults prevent from being built.
void check_stated_materials(const Shape& shape, FaultList& faults);

}  // namespace wythe::geometry
