// What an assessment reads of the states of a pushed wall. A sample of a campaign keeps this in place of its
// states (docs/theory/assessment.md). SI units.
//
//   KeptStates::readings ──read_pushed_wall()──► PushedWall ──► store ──► assessment
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace wythe {

struct DriftPoint {
  double displacement = 0;  // of the curve [m]
  double drift = 0;         // largest of all storeys, or that of a pier [-]
  double shear = std::numeric_limits<double>::quiet_NaN();  // of a pier, along the push [N]
};

// Drift over one pier's clear height during the push, and its mechanism.
struct PierDrift {
  std::string mark;                // "P2"
  std::string mechanism;           // at the end: "shear", "flexure", "": not known
  std::vector<DriftPoint> drifts;  // ascending by displacement
  std::string element = {};        // "pier 2 of storey 1", as in FailureMode::elements
  int storey = 0;
  // Displacement of the first state with each mechanism [m]. Infinite: no state has it. Both NaN: the time is not known,
  // and `mechanism` counts from the start.
  double shear_from = std::numeric_limits<double>::quiet_NaN();
  double flexure_from = std::numeric_limits<double>::quiet_NaN();
};

// Moments of the displacements u_i of the masses m_i along the push in one state.
struct MovedMass {
  double displacement = 0;  // of the curve [m]
  double first = 0;         // sum m u [kg m]
  double second = 0;        // sum m u^2 [kg m^2]
  double mixed = 0;         // sum m u u', with u' of the previous state, 0 at first [kg m^2]
};

struct PushedWall {
  double blocks = 0, loads = 0, added = 0;  // masses by their source [kg]
  std::vector<MovedMass> moved;             // ascending by displacement; empty: not known
  std::vector<DriftPoint> storeys;          // largest drift of all storeys; empty: no levels
  std::vector<PierDrift> piers;             // their mechanisms are not set here
  [[nodiscard]] bool is_read() const { return !moved.empty(); }
};

}  // namespace wythe
