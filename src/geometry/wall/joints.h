// Finds where blocks touch: collinear, anti-parallel, overlapping edges of different blocks.
//
//        +----------+            the edge of b runs opposite to that of a; their common part is one
//        |    b     |            contact p0-p1, with the normal from a to b on its left
//   +----p0=====p1--+
//   |    a      |                a is the lower block, or the left one where the normal is level
//   +-----------+
//
// Candidate pairs come from a uniform grid of cells, so the cost grows with the number of blocks.
// Called by assembly.cpp; does not depend on roles and materials.
#pragma once

#include <limits>
#include <vector>

#include "geometry/assembly.h"
#include "geometry/polygon.h"

namespace wythe::geometry {

struct Contact {
  int a = 0, b = 0;  // blocks
  Vec2 p0, p1;
};

// Facing edges without a contact: the overlap is too short, or the gap too wide.
struct LostContact {
  int a = 0, b = 0;
  double overlap = 0;  // [m]
  double gap = 0;      // largest distance across the overlap [m], 0 when only the overlap is short
};

struct ContactSearch {
  std::vector<Contact> contacts;  // by height of their centre, then from left to right
  std::vector<LostContact> lost;
};

inline constexpr double kContactTolerance = 1e-6;  // of the assembly's size: collinear within
inline constexpr double kShortestContact = 1e-3;   // of the shorter edge: a shorter overlap is lost
inline constexpr double kWidestGap = 1e-2;         // of the shorter edge: a wider gap is intended

// The tolerance in metres: kContactTolerance times the larger side of the assembly.
[[nodiscard]] double contact_tolerance(const std::vector<Block>& blocks);

// Pairs (i < j) of blocks whose bounds, widened by `margin`, meet, without pairs of supports; the search
// ends after `most` pairs.
[[nodiscard]] std::vector<std::pair<int, int>> near_pairs(
    const std::vector<Block>& blocks, double margin,
    std::size_t most = std::numeric_limits<std::size_t>::max());

[[nodiscard]] ContactSearch find_contacts(const std::vector<Block>& blocks);

// Contacts of bottom edges with the level line `ground`, from left to right; a is kGround.
[[nodiscard]] std::vector<Contact> find_ground_contacts(const std::vector<Block>& blocks,
                                                        double ground);

// Sorts contacts by the height of their centres (equal within the tolerance), then by x.
void sort_contacts(std::vector<Contact>& contacts, double tolerance);

}  // namespace wythe::geometry
