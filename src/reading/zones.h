// Values of deformable blocks in a state beyond their zones: energy, exceeded limits, deflection of a lintel.
// Called by dynamics/meters/residual.cpp and recorder.cpp.
#pragma once

#include <vector>

#include "wythe/parts/reading.h"

namespace wythe::reading {

// Strain energy of all zones [J].
[[nodiscard]] double strain_energy(const Model& model, const State& state);
// A place where a zone's mean principal stress exceeds the limits of its body.
struct BeyondLimit {
  const std::string* body;  // its id
  bool tension;
  double stress, limit;  // magnitudes [Pa]
  Vec3 where;            // [m]
};
[[nodiscard]] std::vector<BeyondLimit> beyond_limits(const Model& model, const State& state);

// Measures of the first lintel of zones; zero without one.
struct LintelMeasures {
  double deflection = 0;    // of the middle below the mean of the ends, at mid-depth [m]
  double end_rotation = 0;  // right end against left end, anticlockwise + [rad]
  double axial = 0;         // force at mid-span, tension + [N]
};
[[nodiscard]] const SolidBody* first_lintel(const Model& model);
[[nodiscard]] LintelMeasures lintel_measures(const Model& model, const State& state);

}  // namespace wythe::reading
