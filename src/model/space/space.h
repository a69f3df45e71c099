// Walls in space: bodies and joint faces -> the arrays of a Model (as parts.h for plane walls).
#pragma once

#include "geometry/bodies/joint_faces.h"
#include "wythe/parts/error.h"
#include "wythe/parts/model.h"

namespace wythe {

// Joint faces of spec.body; throws nothing, faults are added.
[[nodiscard]] geometry::SpaceAssembly assemble_space(const ModelSpec& spec, FaultList& faults);
// The model of a spec whose assembly stands; throws InputError as compile() does.
[[nodiscard]] Model compile_space(const ModelSpec& spec, const geometry::SpaceAssembly& assembly);

// --- pieces

// Stages with loads and driven bodies; `id` gives each body of the assembly its number: blocks first, then
// supports.
void compile_space_stages(const ModelSpec& spec, const geometry::SpaceAssembly& assembly,
                          const std::vector<BlockId>& id, const std::vector<PointLoad>& floors,
                          Model& model, FaultList& faults);
// Sections between the segments of frames; needs blocks.
void compile_space_frames(const ModelSpec& spec, const geometry::SpaceAssembly& assembly,
                          const std::vector<BlockId>& id, Model& model, FaultList& faults);
// Stages that drive supports under feet that the ground holds.
void check_space_frames(const Model& model, FaultList& faults);
// What stands when, where stages cut blocks out and put them in; needs blocks.
void compile_space_standing(const ModelSpec& spec, const geometry::SpaceAssembly& assembly,
                            const std::vector<BlockId>& id, Model& model, FaultList& faults);
// Ties, diaphragms and springs between bodies (links.cpp).
void compile_links(const ModelSpec& spec, const geometry::SpaceAssembly& assembly,
                   const std::vector<BlockId>& id, Model& model, FaultList& faults);
// omega_max and stiffest_block: twice the largest eigenvalue of each block's own 6 x 6 stiffness over its inertia
// (docs/theory/space.md, "The longest step").
void bound_space_step(Model& model);

// First period of the elastic wall along a direction [s], every joint closed; NaN where it has none, and for walls with links,
// zones or more than 5000 blocks.
[[nodiscard]] double first_period_in_space(const Model& model, Vec3 along);

// Principal moments of a symmetric matrix xx yy zz xy xz yz, and its axes: right-handed, in the order of the
// sweeps of Jacobi's method, so that the bits are the same everywhere; a diagonal matrix keeps the axes.
struct PrincipalAxes {
  Vec3 moment, axis_1, axis_2, axis_3;
};
[[nodiscard]] PrincipalAxes principal_axes(const std::array<double, 6>& inertia);

}  // namespace wythe
