// What crushing requires of a material's energy (docs/theory/joint_law.md, "Snap-back").
#pragma once

#include "wythe/parts/contact_law.h"

namespace wythe::contact {

// Stiffness that unloads while a joint crushes; with a cap it includes shear [Pa/m].
[[nodiscard]] double crushing_stiffness(const JointMaterial& material);
// Energy up to the compressive strength; 0 without hardening [N/m].
[[nodiscard]] double hardening_energy(const JointMaterial& material);

}  // namespace wythe::contact
