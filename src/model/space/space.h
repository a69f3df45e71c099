// Walls in space: bodies and joint faces -> arrays of a Model (as parts.h for walls in the plane).
#pragma once

#include "geometry/bodies/joint_faces.h"
#include "wythe/parts/error.h"
#include "wythe/parts/model.h"

namespace wythe {

// Finds the joint faces of spec.body; adds faults and throws nothing.
[[nodiscard]] geometry::SpaceAssembly assemble_space(const ModelSpec& spec, FaultList& faults);
// Compiles a spec with its complete assembly; throws InputError as compile() does.
[[nodiscard]] Model compile_space(const ModelSpec& spec, const geometry::SpaceAssembly& assembly);

// --- pieces

// Compiles stages with loads and driven bodies; `id` is the number of each body of the assembly: blocks first, then
// supports.
void compile_space_stages(const ModelSpec& spec, const geometry::SpaceAssembly& assembly,
                          const std::vector<BlockId>& id, const std::vector<PointLoad>& floors,
                          Model& model, FaultList& faults);
// Compiles sections between segments of frames; needs blocks.
void compile_space_frames(const ModelSpec& spec, const geometry::SpaceAssembly& assembly,
                          const std::vector<BlockId>& id, Model& model, FaultList& faults);
// Refuses stages that drive supports below feet that the ground holds.
void check_space_frames(const Model& model, FaultList& faults);
// Compiles which blocks stand in which stage, where stages cut or insert blocks; needs blocks.
void compile_space_standing(const ModelSpec& spec, const geometry::SpaceAssembly& assembly,
                            const std::vector<BlockId>& id, Model& model, FaultList& faults);
// Compiles ties, diaphragms and springs between bodies (links.cpp).
void compile_links(const ModelSpec& spec, const geometry::SpaceAssembly& assembly,
                   const std::vector<BlockId>& id, Model& model, FaultList& faults);
// Sets omega_max and stiffest_block, from twice the largest eigenvalue of each block's 6 x 6 stiffness over its inertia
// (docs/theory/space.md, "The longest step").
void bound_space_step(Model& model);

// First period of the elastic wall along a direction [s], with all joints closed. NaN where it has none, and for walls with
// links, zones or more than 5000 blocks.
[[nodiscard]] double first_period_in_space(const Model& model, Vec3 along);

// Principal moments of a symmetric matrix xx yy zz xy xz yz, and its right-handed axes. The order is that of the sweeps of
// Jacobi's method, so that bits are the same everywhere. A diagonal matrix keeps its axes.
struct PrincipalAxes {
  Vec3 moment, axis_1, axis_2, axis_3;
};
[[nodiscard]] PrincipalAxes principal_axes(const std::array<double, 6>& inertia);

}  // namespace wythe
