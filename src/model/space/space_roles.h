// What a body in space is, by the names that builders give and the role that a file states.
//
// Called by space.cpp (joints, chains of lintels), field_places.cpp (which joints a field acts on), space_bound.cpp and
// space_places.cpp (selections by role).
#pragma once

#include <optional>
#include <string>

#include "geometry/shape.h"
#include "wythe/parts/body.h"
#include "wythe/parts/model.h"

namespace wythe {

// "front.c03u05" of the pieces "front.c03u05a" and "front.c03u05b", ".w1" and the like kept: a unit in pieces, as the
// builders name them; "" for any other body.
[[nodiscard]] std::string unit_of(const std::string& id);

// 3 of "front.c03u05", "vault.c03u05" and their pieces, as the builders name them; none of any other body.
[[nodiscard]] std::optional<int> course_of(const std::string& id);

// "front.lintel0" of its segments "front.lintel0.s3", as the builders name them; "" for any other body.
[[nodiscard]] std::string chain_of(const std::string& id);

// Both are segments of one lintel that bends.
[[nodiscard]] bool is_chain(const BodySpec& a, const BodySpec& b);

// Name of the material of a joint between two bodies, its normal from a to b: what [[contact]] says of their materials,
// else as a wall's in its plane, level ones, upright ones, crack planes in units.
[[nodiscard]] std::string joint_material_of(const geometry::Shape& shape, const BodySpec& a,
                                            const BodySpec& b, Vec3 normal);

// An upright joint of masonry that takes its material from the beds, and of it head_joint_bond: neither [[contact]] nor
// wall.head_joint names another. Joints between two courses of one wall, arch, vault or dome are beds however they lie.
[[nodiscard]] bool shares_bed(const geometry::Shape& shape, const BodySpec& a, const BodySpec& b,
                              Vec3 normal);

// As it says itself; else a segment of a lintel, or masonry.
[[nodiscard]] BlockRole role_of(const BodySpec& body);

}  // namespace wythe
