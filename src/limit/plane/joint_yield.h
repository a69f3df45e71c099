// The yield surface of a joint for limit analysis.
//
//   p_k   compression on point k, at centre + xi_k e      s   shear on block b along t
//   N = sum p_k      M = sum p_k xi_k l/2
//
//   sliding     |s| <= c A + mu N
//   tension     p_k >= -ft A w_k                        w_k: share of the point, sums to 1
//   crushing    p_k <= fc A w_k                         (points)
//               |M| <= l/2 (N + T)(C - N)/(C + T)       (stress block; T = ft A, C = fc A), convex,
//               replaced by tangents where a solution violates it: `Tangent`
//
// Without crushing two end points are equivalent to any number, so only kPoints uses the model's points.
#pragma once

#include <vector>

#include "wythe/parts/limit.h"
#include "wythe/parts/model.h"

namespace wythe::limit {

struct JointYield {
  double cohesion = 0;     // c A [N], infinite where the joint cannot slide
  double friction = 0;     // mu [-]
  double tension = 0;      // T [N], may be infinite
  double compression = 0;  // C [N], may be infinite
  double half_length = 0;  // l/2 [m]
};

// sign * M <= moment + slope (N - normal), i.e. sign M - slope N <= capacity.
struct Tangent {
  int joint = 0;
  double sign = 1, slope = 0, capacity = 0;  // [-], [m], [N m]
};

// Limit forces of a tie, diaphragm or spring, in tension and compression [N]; may be infinite.
struct LinkYield {
  double tension = 0, compression = 0;
};

struct YieldModel {
  std::vector<double> xi, weight;  // of the points in use
  std::vector<JointYield> joint;   // (n_joint)
  std::vector<LinkYield> link;     // (n_link)
  std::vector<Tangent> tangent;    // added while stress blocks are approximated
  bool stress_block = false;
  [[nodiscard]] std::size_t points() const { return xi.size(); }
};

// A material without tensile strength counts as fully damaged: its residual values apply. Leaves half_length 0.
[[nodiscard]] JointYield yield_of_joint(const JointMaterial& material, double area,
                                        const LimitOptions& options);
// Yield surfaces of all joints. `times`: factor on every strength but friction (limit_load.cpp, tilts).
[[nodiscard]] YieldModel yield_of(const Model& model, const LimitOptions& options,
                                  double times = 1);
// Adds tangents where N, M of a joint lie outside its stress block; returns their number.
int cut_stress_blocks(YieldModel& yield, const std::vector<double>& point_force);
// Keeps only tangents that the solution touches. The others have no effect, and many nearly parallel ones
// would cost the kinematic programme its accuracy.
void drop_idle_tangents(YieldModel& yield, const std::vector<double>& point_force);

}  // namespace wythe::limit
