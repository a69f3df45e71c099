// Free contacts: where blocks meet that no joint holds together (docs/theory/contacts.md).
//
//   joint face    found once, at the start; bonded, then damaged; stays with its two faces
//   free contact  found as blocks move; dry friction; comes and goes
//
// Bodies are the blocks, then what stands still: n_block + k is fixed body k.
#pragma once

#include <cstdint>
#include <vector>

#include "wythe/parts/words.h"

namespace wythe {

// Which contacts a wall has.
enum class Contacts { kJoints, kFree };
inline constexpr Word<Contacts> kContactsWords[] = {{"joints", Contacts::kJoints},
                                                    {"free", Contacts::kFree}};

// Shapes that free contacts see: convex parts with bevelled corners; empty where none are looked for.
//
//      __________
//     /          \     corners are cut off by `bevel` along both edges, so that blocks that share a
//    |            |    corner at the start have room, and corner against corner has a normal
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
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;   // what blocks may not leave [m]
  double z0 = 0, z1 = 0;                   // in space
  [[nodiscard]] bool any() const { return !material.empty(); }
};

// What a free contact remembers of two parts.
struct FreeContact {
  std::int32_t a = 0, b = 0;            // bodies, a < b
  std::int32_t part_a = 0, part_b = 0;  // of them
  std::int32_t feature = 0;             // edge or facet e of a that faces b, or -1 - e of b
  double rest = 0;                      // overlap of crushed material, which presses no more [m]
  double area = 0;                      // in the last step [m^2]
  double slip_x = 0, slip_y = 0, slip_z = 0;  // elastic part of the slip of b on a [m]
  // Of its Maxwell element, where the stage has such: along the normal, tension +, and as the slip [N].
  double maxwell_n = 0, maxwell_x = 0, maxwell_y = 0, maxwell_z = 0;
  bool operator==(const FreeContact&) const = default;
};

// What is left of the difference between the joints of a pair and the free contact that took their
// place: a force and a moment between both that fade as the contact unloads or slips.
struct HandOver {
  std::int32_t a = 0, b = 0;
  double share = 0;                              // of what follows, 1 at the hand-over, never grows
  double pressed = 0;                            // normal force of the free contact then [N]
  double force_x = 0, force_y = 0, force_z = 0;  // on a, in axes that turn with it [N]
  double moment_x = 0, moment_y = 0, moment_z = 0;  // on a about its centroid [N m]
  bool operator==(const HandOver&) const = default;
};

// What has fallen: blocks whose centroid is lower than at the start by more than half their height.
struct Debris {
  std::int64_t blocks = 0;
  double volume = 0;  // [m^3]
  double mass = 0;    // [kg]
  double reach = 0;   // how far fallen blocks lie outside the wall's outline in plan [m]
  double load = 0;    // dead load that lay on blocks and has slid off as they fell [N]
};

}  // namespace wythe
