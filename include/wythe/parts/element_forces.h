// What each pier and spandrel carried and how far it was distorted, while the wall was pushed.
//
//        | N                 The force of what lies beyond an end on the element, about the middle of the end
//     V  v   M               as it was built, in the wall's axes:
//   -----+-----  head, 2       pier      beyond: above. N pressed +, V + towards +x, M anticlockwise +
//    |       |                 spandrel  beyond: on the right. N pressed +, V + upwards, M anticlockwise +
//    | pier  |               Both ends have the same sense, so that V is the same at both and M at the foot is
//   -----+-----  foot, 1     that at the head less V times the height, but for weight and inertia between.
//
// The ends of a pier are those of its clear height, where nothing holds it on either side: the higher
// sill and the lower head beside it. Hence the V of a storey's piers sum to its shear, and their N to the
// weight above. The ends of a spandrel are the jambs of its opening.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "wythe/parts/model.h"
#include "wythe/parts/result.h"
#include "wythe/parts/vector.h"

namespace wythe {

struct ElementEnd {
  double axial = 0;   // compression [N]
  double shear = 0;   // [N]
  double moment = 0;  // [N m]
  double turn = 0;    // of the masonry beyond it, anticlockwise [rad]
};

struct ElementForces {
  std::string element, kind, mark;  // "pier 2 of storey 1", "pier" or "spandrel", "P2"
  int storey = 0;
  double length = 0;  // between its ends [m]
  Vec3 along = {1, 0,
                0};  // to the right of who looks at its wall: drift and V of a pier are along it
  struct Row {
    double displacement = 0;        // of the push [m]
    std::array<ElementEnd, 2> end;  // foot and head of a pier, left and right end of a spandrel
    double drift = 0;               // across the element, of end 2 against end 1, over its length
    double distortion = 0;          // the drift less what its ends turned, in the mean: 0 where it
                                    // moved as one rigid piece with what lies beyond
  };
  std::vector<Row> rows = {};  // the start of the push and Result::readings, in that order
};

// Piers, then spandrels, in the order of FailureMode::elements.
[[nodiscard]] std::vector<ElementForces> read_element_forces(const Model& model,
                                                             const Result& result);

// Columns of elements.csv, with the unit in the name.
[[nodiscard]] std::string element_forces_csv(const std::vector<ElementForces>& elements);

}  // namespace wythe
