// What the state says about deformable blocks: energies, stresses, and the sag of a lintel.
#pragma once

#include <utility>
#include <vector>

#include "wythe/result.h"

namespace wythe::dynamics {

// Strain energy of all zones [J].
[[nodiscard]] double strain_energy(const Model& model, const State& state);
// The points of the zone contacts, two each, as point_stresses gives those of the joints.
[[nodiscard]] std::vector<PointStress> contact_stresses(const Model& model, const State& state);

// The greater and the smaller principal stress in the plane, tension positive [Pa].
[[nodiscard]] std::pair<double, double> principal_stresses(const ZoneStress& zone);
// Places where a zone's mean principal stress goes beyond its body's limits.
struct BeyondLimit {
  const SolidBody* body;
  bool tension;
  double stress, limit;  // magnitudes [Pa]
  double x, y;           // [m]
};
[[nodiscard]] std::vector<BeyondLimit> beyond_limits(const Model& model, const State& state);

// Of the first lintel of zones; zero without one.
struct LintelMeasures {
  double deflection = 0;    // of the middle below the mean of the ends, at mid-depth [m]
  double end_rotation = 0;  // right end against left end, anticlockwise + [rad]
  double axial = 0;         // force at mid-span, tension + [N]
};
[[nodiscard]] const SolidBody* first_lintel(const Model& model);
[[nodiscard]] LintelMeasures lintel_measures(const Model& model, const State& state);

}  // namespace wythe::dynamics
