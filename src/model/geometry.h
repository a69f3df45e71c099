// Operations that differ between walls in the plane and in space while a model is compiled: one table for each.
// src/reading/readers.h has the same for reading a state.
#pragma once

#include <utility>

#include "wythe/parts/model.h"

namespace wythe {

struct Geometry {
  int dimension;                                        // of places
  Vec3 (*centroid)(const Model& model, BlockId block);  // at the start [m]
  Vec3 (*normal)(const Model& model, JointId joint);    // at the start, from a to b
  std::pair<double, double> (*heights)(const Model& model, BlockId block);  // lowest, highest [m]
  double (*first_period)(const Model& model, Vec3 along);                   // [s]
  double (*dashpot_rate)(const Model& model, const Dashpots& dashpots);
};
[[nodiscard]] const Geometry& geometry_of(const Model& model);

}  // namespace wythe
