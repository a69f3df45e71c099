// Deformable blocks alone, without rigid ones: stepped by a Rig or solved directly.
#pragma once

#include <functional>
#include <vector>

#include "solids/mesh.h"
#include "wythe/parts/model.h"

namespace wythe::scenes {

// Isotropic body whose key `poisson_ratio` has its default E/2G - 1.
[[nodiscard]] JointMaterial elastic_body(double youngs_modulus, double poisson_ratio,
                                         double density);
// Spruce: stiff along x.
[[nodiscard]] JointMaterial timber_body();

[[nodiscard]] solids::ZoneMaterial zone_material(const JointMaterial& body, double thickness,
                                                 Plane plane = Plane::kStress);

// A model without rigid blocks that contains these zones.
[[nodiscard]] Model free_solids(Solids solids);
[[nodiscard]] Model free_grid(const solids::Grid& grid, ZoneKind kind, const JointMaterial& body,
                              double thickness, Plane plane = Plane::kStress);

// One vector for each node [m] or [N].
struct NodeVectors {
  std::vector<double> x, y;
  explicit NodeVectors(const Solids& s)
      : x(static_cast<std::size_t>(s.n_node)), y(static_cast<std::size_t>(s.n_node)) {}
};
using Field = std::function<double(double x, double y)>;
[[nodiscard]] NodeVectors field(const Solids& s, const Field& ux, const Field& uy);

// Forces of the zones on their nodes, computed by the kernel.
[[nodiscard]] NodeVectors forces_of_zones(const Solids& s, const NodeVectors& u);
[[nodiscard]] double energy_of_zones(const Solids& s, const NodeVectors& u);
// Small displacements of the free nodes under `load`, from a sparse
// factorisation of the zones' stiffnesses, independent of the step.
[[nodiscard]] NodeVectors solved(const Solids& s, const NodeVectors& load);
[[nodiscard]] double work(const NodeVectors& force, const NodeVectors& u);

// The small wall with a lintel of 0.3 GPa over its window, 110 mm deep.
[[nodiscard]] ModelSpec lintel_wall(LintelModel kind, double until = 2e-3);

}  // namespace wythe::scenes
