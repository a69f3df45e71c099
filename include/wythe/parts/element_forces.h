// Internal forces and distortion of each pier and spandrel during a push.
//
//        | N                 Force of the masonry beyond an end on the element, about the middle of that end
//     V  v   M               as built, in the axes of the wall:
//   -----+-----  head, 2       pier      beyond: above. N compression +, V towards +x +, M anticlockwise +
//    |       |                 spandrel  beyond: on the right. N compression +, V upwards +, M anticlockwise +
//    | pier  |               Both ends have the same sense. So V is equal at both, and M at the foot is
//   -----+-----  foot, 1     M at the head less V times the height, up to weight and inertia between them.
//
// A pier ends where its clear height does, free on both sides: at the higher sill and the lower head beside
// it. So V of the piers of a storey sums to the storey shear, and N to the
// weight above. A spandrel ends at the jambs of its opening.
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
  double turn = 0;    // rotation of the masonry beyond it, anticlockwise [rad]
};

struct ElementForces {
  std::string element, kind, mark;  // "pier 2 of storey 1", "pier" or "spandrel", "P2"
  int storey = 0;
  double length = 0;  // between its ends [m]
  Vec3 along = {1, 0,
                0};  // to the right of a viewer of the wall: direction of a pier's drift and V
  struct Row {
    double displacement = 0;        // of the push [m]
    std::array<ElementEnd, 2> end;  // foot and head of a pier, left and right end of a spandrel
    double drift = 0;               // displacement of end 2 against end 1 over the length [-]
    double distortion = 0;          // drift less the mean rotation of both ends [-]: 0 where the
                                    // element moved as one rigid body with the masonry beyond
  };
  std::vector<Row> rows = {};  // at the start of the push, then of each of KeptStates::readings
};

// Piers, then spandrels, in the order of FailureMode::elements.
[[nodiscard]] std::vector<ElementForces> read_element_forces(const Model& model,
                                                             const Result& result);
// The same at chosen states.
[[nodiscard]] std::vector<ElementForces> read_element_forces(
    const Model& model, const std::vector<const Snapshot*>& states);

// Columns of elements.csv, with the unit in the name.
[[nodiscard]] std::string element_forces_csv(const std::vector<ElementForces>& elements);

}  // namespace wythe
