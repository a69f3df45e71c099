// What the states of a pushed wall say to those who judge it later: a sample of a campaign keeps this, as it
// keeps no states (docs/theory/assessment.md). SI units.
//
//   Result::readings ──read_pushed_wall()──► PushedWall ──► store ──► assessment
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace wythe {

struct DriftPoint {
  double displacement = 0;  // of the curve [m]
  double drift = 0;         // largest of the storeys, or of a pier [-]
  double shear = std::numeric_limits<double>::quiet_NaN();  // of a pier, along the push [N]
};

// Drift across one pier's clear height while the wall was pushed, and how it fails.
struct PierDrift {
  std::string mark;                // "P2"
  std::string mechanism;           // in the end: "shear", "flexure", "": not known
  std::vector<DriftPoint> drifts;  // ascending by displacement
  std::string element = {};        // "pier 2 of storey 1", as in FailureMode::elements
  int storey = 0;
  // Displacement of the first state that shows each kind, infinite: none does; both NaN: it is not known when,
  // and `mechanism` holds from the start [m].
  double shear_from = std::numeric_limits<double>::quiet_NaN();
  double flexure_from = std::numeric_limits<double>::quiet_NaN();
};

// How far the masses of an assessment had gone along the push at one state; u_i of mass m_i.
struct MovedMass {
  double displacement = 0;  // of the curve [m]
  double first = 0;         // sum m u [kg m]
  double second = 0;        // sum m u^2 [kg m^2]
  double mixed = 0;         // sum m u u', u' at the state before, 0 at the first [kg m^2]
};

struct PushedWall {
  double blocks = 0, loads = 0, added = 0;  // the masses, by where they come from [kg]
  std::vector<MovedMass> moved;             // ascending by displacement; empty: nothing is known
  std::vector<DriftPoint> storeys;          // empty: no levels
  std::vector<PierDrift> piers;             // their mechanisms are not set here
  [[nodiscard]] bool is_read() const { return !moved.empty(); }
};

}  // namespace wythe
