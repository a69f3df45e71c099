// Rolled sections by name: cross-section values for bending about the strong axis.
//
//        |<- b ->|            nominal sizes h, b, tw, tf, r give area, second moment and plastic modulus
//   ---  =========  tf        by closed forms (docs/theory/frames.md, 20.10). Channels have tapered flanges, so
//    |       |                their values are tabulated. The shear area is that of the web, tw (h - tf)
//    h       | tw
//    |       |
//   ---  =========
//
// Sizes: EN 10365 (IPE, HEA, HEB, UPN), EN 10210-2 (square tubes, hot finished), recalled from memory.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "wythe/parts/wall_spec.h"

namespace wythe::geometry {

// Values of one or more pieces side by side, for all together.
struct Section {
  double height = 0, width = 0;                   // in the wall's plane, across it [m]
  double area = 0, shear_area = 0;                // [m^2]
  double second_moment = 0, plastic_modulus = 0;  // [m^4], [m^3]
  double mass = 0;                                // [kg/m]
  // about the other axis of each single piece, and in torsion [m^4], [m^2]; NaN where not stated
  double weak_second_moment = kUnset, torsion_constant = kUnset, weak_shear_area = kUnset;
};

// "IPE 240", "heb200", "HE 200 B", "UPN 160", "SHS 100x5"; nothing for an unknown profile.
[[nodiscard]] std::optional<Section> profile_named(const std::string& name);
// Names as in the table.
[[nodiscard]] std::vector<std::string> profile_names();
// What to write for a profile that is not in the table: the sizes that its series has there, or the name that is meant.
[[nodiscard]] std::string profile_advice(const std::string& name);

}  // namespace wythe::geometry
