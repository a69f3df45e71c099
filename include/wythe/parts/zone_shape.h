// A zone of a deformable block as the step sees it. The kernels of the step include no other part of the model,
// so that a new key or column does not recompile them.
#pragma once

namespace wythe {

// Data that zones of one shape and material share (src/solids). A triangle is a zone whose
// last two corners are one node.
struct ZoneShape {
  double x[4] = {}, y[4] = {};            // corners seen from their mean, anticlockwise [m]
  double grad_x[4] = {}, grad_y[4] = {};  // of each corner's shape function, in the middle [1/m]
  double stiffness[8][8] = {};            // corner forces per displacement, with thickness [N/m];
                                          // order x1 y1 x2 y2 ...
  double elasticity[3][3] = {};           // mean stresses x, y, xy per strain [Pa]
  double share[4] = {};                   // of the mass, at each corner [-]
  double area = 0;                        // [m^2]
  double thickness = 0;                   // [m]
  double omega_squared = 0;  // highest circular frequency of one free zone, squared [1/s^2]
  double mass = 0;           // [kg]
  bool operator==(const ZoneShape&) const = default;
};

}  // namespace wythe
