// What the builder lays in space: walls along plan lines, arches, domes (docs/theory/builder.md).
//
//   model file ──► BuilderSpec ──► lay_bodies() ──► ModelSpec::body, when the file is read
#pragma once

#include <array>
#include <string>
#include <vector>

#include "wythe/parts/wall_spec.h"

namespace wythe {

// How walls meet at corners and where one ends on another: courses pass through by turns, or a plane joint stands
// between them.
enum class Meeting { kToothed, kButted };
inline constexpr Word<Meeting> kMeetingWords[] = {{"toothed", Meeting::kToothed},
                                                  {"butted", Meeting::kButted}};

// A wall along a line in plan. What it leaves unset is the wall's.
struct PlanWallSpec {
  std::string name;
  std::vector<std::array<double, 2>>
      line;                   // of its middle plane, with a corner at each inner point [m]
  double base = 0;            // height of its foot; above 0 it stands on what lies there [m]
  double height = kUnset;     // [m]
  double thickness = kUnset;  // [m]
  std::string bond;           // word of Bond
  std::string fit;            // word of Fit
  UnitSpec unit;
  int wythes = 1;
  double core = kUnset;             // thickness of the middle one of three [m]
  int through_courses = 0;          // through-stones in each of so many courses; 0: none
  double through_spacing = kUnset;  // of these along their course [m]
  double gable = 0;                 // height of its top above `height` [m]
  Meeting meets = Meeting::kToothed;
  std::string material;       // of its blocks, for [[contact]] and a density; "": masonry
  std::string core_material;  // of the middle one of three wythes; "": material
  std::vector<OpeningSpec> opening;
};

// An arch or, with several units along its width, a barrel vault: part of a circle between two springers.
struct StandingArchSpec {
  std::string name;
  double x = 0, y = 0, z = 0;  // middle of its springing [m]
  double turn = 0;             // of the span in plan, from x [rad]
  double span = kUnset;        // clear [m]
  double rise = kUnset;        // of the intrados [m]; unset: half the span
  double depth = kUnset;       // of the voussoirs, from intrados to extrados [m]
  double width = kUnset;       // across the span [m]
  int voussoirs = 0;           // along the span
  int units = 1;               // along the width
  std::string bond;            // of these, word of Bond: running or stack
  std::string material;        // of the voussoirs; "": masonry
  bool springers = true;       // fixed ones; else it stands on what is there
};

// A dome of voussoirs: part of a sphere on a ring of springers.
struct DomeSpec {
  std::string name;
  double x = 0, y = 0, z = 0;  // middle of its springing [m]
  double span = kUnset;        // clear diameter there [m]
  double rise = kUnset;        // of the intrados [m]; unset: half the span
  double depth = kUnset;       // from intrados to extrados [m]
  int courses = 0;
  int units = 0;         // in each course
  double oculus = 0;     // clear diameter of an eye at the crown [m]; 0: a keystone
  std::string bond;      // word of Bond: running or stack
  std::string material;  // "": masonry
  bool springers = true;
};

// A floor slab that moves as one rigid body. It lies on walls' tops and in pockets cut into them, by joints.
//
//        |w|  gap    |w|       bearing: how far it reaches into a wall, from the wall's near face
//     ___| |_______ _| |
//    |_______________|         level: height of its underside
//        |w|       | |
//
struct SlabSpec {
  std::string name;
  std::vector<std::string> walls;              // that it rests on: two parallel ones, or up to four
  std::vector<std::array<double, 2>> outline;  // or its corners in plan [m]
  double level = kUnset;  // height of its underside [m]; unset: the top of the walls it rests on
  double thickness = kUnset;  // [m]
  double bearing = kUnset;    // into each of `walls` [m]
  double gap = 0;             // to walls beside it that it does not rest on [m]
  std::string material;       // its density, and what [[contact]] calls it
  std::string joint;          // joint material between it and masonry; "": as masonry's own
  double load = 0;            // on all of it, downwards [Pa]
  double mass = 0;            // that moves with it as inertia [kg/m^2]
};

struct BuilderSpec {
  std::vector<PlanWallSpec> plan_wall;
  std::vector<SlabSpec> slab;
  std::vector<StandingArchSpec> arch;
  std::vector<DomeSpec> dome;
  [[nodiscard]] bool empty() const {
    return plan_wall.empty() && slab.empty() && arch.empty() && dome.empty();
  }
};

// Adds what is built to a spec: blocks, the rules for their contacts, floors of slabs, notes. Walls of the builder inherit
// what they leave unset from spec.wall, but not the split of units, which always has a value. Throws InputError with every
// fault.
void lay_bodies(const BuilderSpec& built, ModelSpec& spec);

}  // namespace wythe
