// Limit analysis of walls in space: loads, yield surfaces and both programmes (docs/theory/limit_analysis.md).
//
// Called by limit_load.cpp. A point of a face has compression p and shear (s1, s2) in the axes of the face:
//
//   sliding   |s| <= c A w + mu p   a circle, which the interior-point solver handles
//   tension   p >= -ft A w          crushing   p <= fc A w            w: the point's share of the face
#pragma once

#include <vector>

#include "limit/plane/programmes.h"
#include "wythe/parts/limit.h"
#include "wythe/parts/model.h"

namespace wythe::limit {

struct BodyForce {
  Vec3 force, moment;  // on a centroid [N], [N m]
};

// Dead loads, and growing loads per unit of the load.
struct SpaceLoads {
  std::vector<BodyForce> dead, growing;  // (n_block)
  const Stage* stage = nullptr;
  Vec3 push;  // unit vector of a push
  bool is_force = true;
  bool together = false;  // driven blocks share one velocity; their forces sum to the load
};
// Throws InputError when no stage grows, and when the growing one moves a support. `secant`, `loads_are_masses`: limit_loads().
[[nodiscard]] SpaceLoads space_loads(const Model& model, double secant = 1,
                                     bool loads_are_masses = false);

struct SpaceYield {
  std::vector<JointYield> joint;  // (n_joint); half_length is not used
  std::vector<LinkYield> link;    // (n_link)
};
[[nodiscard]] SpaceYield space_yield(const Model& model, const LimitOptions& options,
                                     double times = 1);
[[nodiscard]] Units units_of(const Model& model, const SpaceLoads& loads);

struct SpaceKinematicSolution {
  ProgrammeStatus status = ProgrammeStatus::kFailed;
  double load = 0, dissipation = 0, accuracy = 0;
  std::vector<Vec3> velocity, spin;  // (n_block), per unit velocity of the load [-], [1/m]
};
[[nodiscard]] SpaceKinematicSolution solve_kinematic(const Model& model, const SpaceLoads& loads,
                                                     const SpaceYield& yield, const Units& units,
                                                     const Monitor& monitor = {});

struct SpaceStaticSolution : CommonStaticSolution<SpaceKinematicSolution> {
  std::vector<double> compression, shear_1, shear_2;  // (n_point) [N]
  double friction_excess = 0;  // largest relative excess of a shear over its circle
};
[[nodiscard]] SpaceStaticSolution solve_static(const Model& model, const SpaceLoads& loads,
                                               const SpaceYield& yield, const Units& units,
                                               const Monitor& monitor = {},
                                               const Tolerance& tolerance = kExact);

// Whether forces without the growing load balance every block.
[[nodiscard]] ProgrammeStatus find_rest(const Model& model, const SpaceLoads& loads,
                                        const SpaceYield& yield, const Units& units,
                                        const Monitor& monitor);

[[nodiscard]] Unbalanced find_unbalanced(const Model& model, const SpaceLoads& loads,
                                         const SpaceYield& yield, const Units& units,
                                         const Monitor& monitor = {});

}  // namespace wythe::limit
