// Free contacts: contacts between blocks that no joint connects (docs/theory/contacts.md).
//
//   joint face    found once, at the start; bonded, then damaged; stays with its two faces
//   free contact  found while blocks move; dry friction; appears and vanishes
//
// Bodies are the blocks, then the fixed bodies: n_block + k is fixed body k.
#pragma once

#include <cstdint>
#include <vector>

#include "wythe/parts/words.h"

namespace wythe {

// Which contacts a wall has.
enum class Contacts { kJoints, kFree };
inline constexpr Word<Contacts> kContactsWords[] = {{"joints", Contacts::kJoints},
                                                    {"free", Contacts::kFree}};

// Shapes for free contacts: convex parts with bevelled corners; empty without free contacts.
//
//      __________
//     /          \     each corner is cut by `bevel` along both edges: blocks that share a corner
//    |            |    at the start do not overlap, and a contact of two corners has a normal
//     \__________/
struct FreeShapes {
  int n_fixed = 0;
  double bevel = 0;                        // [m]
  std::vector<std::int32_t> part_begin;    // CSR (n_block + n_fixed + 1) into parts
  std::vector<std::int32_t> corner_begin;  // CSR (parts + 1) into corners, anticlockwise
  std::vector<double> corner_x, corner_y;  // seen from the centroid; of fixed bodies in the wall's
                                           // axes [m]
  std::vector<double> thickness;           // of each body [m]
  std::vector<std::int32_t> material;      // of each body, into Model::materials
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;   // bounds for all blocks [m]
  double z0 = 0, z1 = 0;                   // in space
  [[nodiscard]] bool any() const { return !material.empty(); }
};

// State of the free contact of two parts.
struct FreeContact {
  std::int32_t a = 0, b = 0;            // bodies, a < b
  std::int32_t part_a = 0, part_b = 0;  // of them
  std::int32_t feature = 0;             // edge or facet e of a that faces b, or -1 - e of b
  double rest = 0;                      // overlap of crushed material, which carries no force [m]
  double area = 0;                      // in the last step [m^2]
  double slip_x = 0, slip_y = 0, slip_z = 0;  // elastic part of the slip of b on a [m]
  // Forces of its Maxwell element, where the stage has such: normal (tension +), and along the slip [N].
  double maxwell_n = 0, maxwell_x = 0, maxwell_y = 0, maxwell_z = 0;
  bool operator==(const FreeContact&) const = default;
};

// A force and a moment that continue those of released joints where a free contact takes their place. Both
// fade as that contact unloads or slips, so that no force jumps.
struct HandOver {
  std::int32_t a = 0, b = 0;
  double share = 0;                              // factor of both, 1 at the hand-over, never grows
  double pressed = 0;                            // normal force of the free contact then [N]
  double force_x = 0, force_y = 0, force_z = 0;  // on a, in axes that turn with it [N]
  double moment_x = 0, moment_y = 0, moment_z = 0;  // on a about its centroid [N m]
  bool operator==(const HandOver&) const = default;
};

// Fallen material: blocks whose centroid has sunk by more than half their height.
struct Debris {
  std::int64_t blocks = 0;
  double volume = 0;  // [m^3]
  double mass = 0;    // [kg]
  double reach = 0;   // how far fallen blocks lie outside the wall's outline in plan [m]
  double load = 0;    // dead load of fallen blocks, which slid off them [N]
};

}  // namespace wythe
