// Input of the builder in space: walls along plan lines, arches, domes, slabs (docs/theory/builder.md).
//
//   model file ──► BuilderSpec ──► lay_bodies() ──► ModelSpec::body, when the file is read
#pragma once

#include <array>
#include <string>
#include <vector>

#include "wythe/parts/wall_spec.h"

namespace wythe {

// How walls meet at corners and where one ends on another. Toothed: courses of both pass through alternately. Butted:
// a plane joint stands between them.
enum class Meeting { kToothed, kButted };
inline constexpr Word<Meeting> kMeetingWords[] = {{"toothed", Meeting::kToothed},
                                                  {"butted", Meeting::kButted}};

// A part of a plan wall with another material or thickness.
struct PlanRegionSpec {
  std::string name;
  RegionPlace place = {};     // without a storey; x counts as that of openings
  std::string material;       // of its blocks; "": the wall's
  double thickness = kUnset;  // [m]; unset: the wall's
  double offset = 0;          // of its middle plane from the wall's, across the line [m]
};

// A wall along a line in plan. Values left unset are those of [wall].
struct PlanWallSpec {
  std::string name;
  std::vector<std::array<double, 2>>
      line;                   // its middle plane in plan, one corner for each bend [m]
  double base = 0;            // height of its foot; above 0 it stands on what is below [m]
  double height = kUnset;     // [m]
  double thickness = kUnset;  // [m]
  std::string bond;           // word of Bond
  std::string fit;            // word of Fit
  UnitSpec unit;
  int wythes = 1;
  double core = kUnset;             // thickness of the core of a three-wythe wall [m]
  int through_courses = 0;          // through-stones stand in every n-th course; 0: none
  double through_spacing = kUnset;  // spacing of through-stones along the course [m]
  double gable = 0;                 // height of the gable above `height` [m]
  Meeting meets = Meeting::kToothed;
  std::string material;       // of its blocks, for [[contact]] and density; "": masonry
  std::string core_material;  // of the core of three wythes; "": material
  bool ring_beam = false;     // one course of segments that bend as a chain (theory/ring_beams.md)
  std::vector<OpeningSpec> opening;
  std::vector<PlanRegionSpec> region;
};

// An arch, or a barrel vault where `units` > 1: part of a circle between two springers.
struct StandingArchSpec {
  std::string name;
  double x = 0, y = 0, z = 0;  // middle of its springing [m]
  double turn = 0;             // of the span in plan, from x [rad]
  double span = kUnset;        // clear [m]
  double rise = kUnset;        // of the intrados [m]; unset: half the span
  double depth = kUnset;       // of the voussoirs, from intrados to extrados [m]
  double width = kUnset;       // across the span [m]
  int voussoirs = 0;           // number along the span
  int units = 1;               // number along the width
  std::string bond;            // bond along the width, word of Bond: running or stack
  std::string material;        // of the voussoirs; "": masonry
  bool springers = true;       // fixed springers; else it stands on the blocks below
};

// A dome of voussoirs: part of a sphere that stands on a ring of springers.
struct DomeSpec {
  std::string name;
  double x = 0, y = 0, z = 0;  // middle of its springing [m]
  double span = kUnset;        // clear diameter there [m]
  double rise = kUnset;        // of the intrados [m]; unset: half the span
  double depth = kUnset;       // from intrados to extrados [m]
  int courses = 0;
  int units = 0;         // in each course
  double oculus = 0;     // clear diameter of the opening at the crown [m]; 0: a keystone
  std::string bond;      // word of Bond: running or stack
  std::string material;  // "": masonry
  bool springers = true;
};

// A floor slab: one rigid body that lies, through joints, on tops of walls and in pockets cut into them.
//
//        |w|  gap    |w|       bearing: depth to which it reaches into a wall, from the wall's near face
//     ___| |_______ _| |
//    |_______________|         level: height of its underside
//        |w|       | |
//
struct SlabSpec {
  std::string name;
  std::vector<std::string> walls;              // that carry it: two parallel ones, or up to four
  std::vector<std::array<double, 2>> outline;  // or its corners in plan [m]
  double level = kUnset;      // height of its underside [m]; unset: the top of its walls
  double thickness = kUnset;  // [m]
  double bearing = kUnset;    // into each of `walls` [m]
  double gap = 0;             // to walls beside it that do not carry it [m]
  std::string material;       // for its density and for [[contact]]
  std::string joint;          // joint material between slab and masonry; "": as in masonry
  double load = 0;            // pressure on its whole area, downwards [Pa]
  double mass = 0;            // additional mass, inertia alone [kg/m^2]
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

// Adds the built parts to `spec`: blocks, rules for their contacts, floors of slabs, notes. Walls of the builder inherit
// unset values from spec.wall, except the split of units, which always has a value. Throws InputError with every
// fault.
void lay_bodies(const BuilderSpec& built, ModelSpec& spec);

}  // namespace wythe
