// A zone of a deformable block in space, as the step sees it (zone_shape.h in the plane).
#pragma once

namespace wythe {

// Data shared by zones of one shape and material (src/solids). Corners are numbered as in VTK: the four of the lower third
// coordinate anticlockwise seen from above, then the four above them.
struct HexahedronShape {
  double place[8][3] = {};        // corners seen from their mean [m]
  double gradient[8][3] = {};     // of each corner's shape function, mean over the zone [1/m]
  double stiffness[24][24] = {};  // corner forces per displacement [N/m]; order x1 y1 z1 x2 ...
  double elasticity[6][6] = {};   // mean stresses x, y, z, xy, yz, zx per strain [Pa]
  double share[8] = {};           // of the mass, at each corner [-]
  double volume = 0;              // [m^3]
  double omega_squared = 0;       // highest circular frequency of one free zone, squared [1/s^2]
  double mass = 0;                // [kg]
  bool operator==(const HexahedronShape&) const = default;
};

}  // namespace wythe
