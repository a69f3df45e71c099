// Role of a body in space, from the names that the builder gives and the role that a file states.
//
// Called by space.cpp (joints, chains of lintels), field_places.cpp (joints of a field), space_bound.cpp and
// space_places.cpp (selections by role).
#pragma once

#include <optional>
#include <string>

#include "geometry/shape.h"
#include "wythe/parts/body.h"
#include "wythe/parts/model.h"

namespace wythe {

// "front.c03u05" for the pieces "front.c03u05a" and "front.c03u05b", with ".w1" and the like: the unit behind pieces, by
// the builder's names; "" for any other body.
[[nodiscard]] std::string unit_of(const std::string& id);

// 3 for "front.c03u05", "vault.c03u05" and their pieces, by the builder's names; none for any other body.
[[nodiscard]] std::optional<int> course_of(const std::string& id);

// "front.lintel0" for its segments "front.lintel0.s3", "ring.beam" for "ring.beam.s3", by the builder's names; "" for any
// other body.
[[nodiscard]] std::string chain_of(const std::string& id);

// Whether both are segments of one lintel that bends, or of ring beams of one material, which are cast together.
[[nodiscard]] bool is_chain(const BodySpec& a, const BodySpec& b);

// Joint material between two bodies with the normal from a to b: by [[contact]], otherwise as in a plane wall
// for level joints, vertical joints, and crack planes in units.
[[nodiscard]] std::string joint_material_of(const geometry::Shape& shape, const BodySpec& a,
                                            const BodySpec& b, Vec3 normal);

// Whether a vertical joint of masonry takes its material from the beds, with head_joint_bond: neither [[contact]] nor
// wall.head_joint names another. Joints between two courses of one wall, arch, vault or dome are beds in any direction.
[[nodiscard]] bool shares_bed(const geometry::Shape& shape, const BodySpec& a, const BodySpec& b,
                              Vec3 normal);

// The stated role; otherwise a segment of a lintel, or masonry.
[[nodiscard]] BlockRole role_of(const BodySpec& body);

}  // namespace wythe
