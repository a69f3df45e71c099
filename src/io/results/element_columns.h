// Columns of blocks, joints and zones in a state, one in each line. They are cells
// of VTU files, and columns of `wythe export` with unit and meaning (columns.json).
// Displacements (displacement_mm) and constant values are written separately.
#pragma once

#include "wythe/parts/reading.h"

namespace wythe::io {

template <class Reading>
struct ElementColumn {
  const char *name, *unit, *meaning;
  double (*shown)(const Reading&);  // in this unit
};

// clang-format off
inline constexpr ElementColumn<BlockReading> kBlockColumns[] = {
  {"rotation_mrad", "mrad", "how far it turned, anticlockwise +", [](const BlockReading& b) { return 1e3 * b.turned.by.z; }},
};

// rotation_mrad means the same as in the plane: its part about z.
inline constexpr ElementColumn<BlockReading> kSpaceBlockColumns[] = {
  {"rotation_mrad", "mrad", "how far it turned about z alone, anticlockwise +", [](const BlockReading& b) { return 1e3 * b.turned.by.z; }},
  {"rotation_x_mrad", "mrad", "how far it turned: part along x of the rotation vector", [](const BlockReading& b) { return 1e3 * b.turned.by.x; }},
  {"rotation_y_mrad", "mrad", "part along y of the rotation vector", [](const BlockReading& b) { return 1e3 * b.turned.by.y; }},
  {"rotation_z_mrad", "mrad", "part along z of the rotation vector, as rotation_mrad", [](const BlockReading& b) { return 1e3 * b.turned.by.z; }},
  {"rotation_total_mrad", "mrad", "length of the rotation vector: the angle it turned", [](const BlockReading& b) { return 1e3 * length(b.turned.by); }},
};

inline constexpr ElementColumn<JointReading> kJointColumns[] = {
  {"opening_mm", "mm", "opening at its wider end; negative where it is closed", [](const JointReading& j) { return j.opening * 1e3; }},
  {"slip_mm", "mm", "slip along the joint, of its points that of largest magnitude", [](const JointReading& j) { return j.slip * 1e3; }},
  {"damage", "–", "largest damage of its points: 0 sound, 1 fully cracked", [](const JointReading& j) { return j.damage; }},
  {"damage_tension", "–", "the same, in tension", [](const JointReading& j) { return j.damage_tension; }},
  {"damage_shear", "–", "the same, in shear", [](const JointReading& j) { return j.damage_shear; }},
  {"normal_stress_MPa", "MPa", "mean normal stress, tension +", [](const JointReading& j) { return j.normal_stress * 1e-6; }},
  {"shear_stress_MPa", "MPa", "mean shear stress", [](const JointReading& j) { return j.shear_stress * 1e-6; }},
  {"crushing", "–", "largest crushing of its points: 0 sound, 1 fully crushed", [](const JointReading& j) { return j.crushing; }},
};

inline constexpr ElementColumn<ZoneReading> kZoneColumns[] = {
  {"stress_x_MPa", "MPa", "mean horizontal stress, tension +", [](const ZoneReading& z) { return z.sigma_x * 1e-6; }},
  {"stress_y_MPa", "MPa", "mean vertical stress, tension +", [](const ZoneReading& z) { return z.sigma_y * 1e-6; }},
  {"stress_xy_MPa", "MPa", "mean shear stress", [](const ZoneReading& z) { return z.tau * 1e-6; }},
  {"principal_1_MPa", "MPa", "greater principal stress, tension +", [](const ZoneReading& z) { return principal_stresses(z).first * 1e-6; }},
  {"principal_2_MPa", "MPa", "smaller principal stress, tension +", [](const ZoneReading& z) { return principal_stresses(z).second * 1e-6; }},
};

inline constexpr ElementColumn<SpaceZoneReading> kSpaceZoneColumns[] = {
  {"stress_x_MPa", "MPa", "mean stress along x, tension +", [](const SpaceZoneReading& z) { return z.stress[0] * 1e-6; }},
  {"stress_y_MPa", "MPa", "mean vertical stress, tension +", [](const SpaceZoneReading& z) { return z.stress[1] * 1e-6; }},
  {"stress_z_MPa", "MPa", "mean stress along z, tension +", [](const SpaceZoneReading& z) { return z.stress[2] * 1e-6; }},
  {"stress_xy_MPa", "MPa", "mean shear stress", [](const SpaceZoneReading& z) { return z.stress[3] * 1e-6; }},
  {"stress_yz_MPa", "MPa", "mean shear stress", [](const SpaceZoneReading& z) { return z.stress[4] * 1e-6; }},
  {"stress_zx_MPa", "MPa", "mean shear stress", [](const SpaceZoneReading& z) { return z.stress[5] * 1e-6; }},
  {"principal_1_MPa", "MPa", "greatest principal stress, tension +", [](const SpaceZoneReading& z) { return z.principal[0] * 1e-6; }},
  {"principal_2_MPa", "MPa", "middle principal stress, tension +", [](const SpaceZoneReading& z) { return z.principal[1] * 1e-6; }},
  {"principal_3_MPa", "MPa", "smallest principal stress, tension +", [](const SpaceZoneReading& z) { return z.principal[2] * 1e-6; }},
};
// clang-format on

}  // namespace wythe::io
