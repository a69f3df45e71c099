// Rolled sections by name: numbers of their cross-section in bending about the strong axis.
//
//        |<- b ->|            area, second and plastic moment follow from the nominal sizes h, b, tw, tf, r
//   ---  =========  tf        by closed forms (docs/theory/frames.md, 20.10); channels, whose flanges taper, have
//    |       |                them as listed. The shear area is that of the web, tw (h - tf)
//    h       | tw
//    |       |
//   ---  =========
//
// Sizes: EN 10365 (IPE, HEA, HEB, UPN), EN 10210-2 (square tubes, hot finished), recalled.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "wythe/parts/wall_spec.h"

namespace wythe::geometry {

// Of one or more pieces side by side, all together.
struct Section {
  double height = 0, width = 0;                   // in the wall's plane, across it [m]
  double area = 0, shear_area = 0;                // [m^2]
  double second_moment = 0, plastic_modulus = 0;  // [m^4], [m^3]
  double mass = 0;                                // [kg/m]
  // about the other axis, of each piece by itself, and in torsion [m^4], [m^2]; NaN where not stated
  double weak_second_moment = kUnset, torsion_constant = kUnset, weak_shear_area = kUnset;
};

// "IPE 240", "heb200", "HE 200 B", "UPN 160", "SHS 100x5"; nothing where nobody rolls it.
[[nodiscard]] std::optional<Section> profile_named(const std::string& name);
// As the table writes them.
[[nodiscard]] std::vector<std::string> profile_names();

}  // namespace wythe::geometry
