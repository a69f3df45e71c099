// What crushing asks of a material's energy (docs/theory/joint_law.md, "Snap-back").
#pragma once

#include "wythe/parts/contact_law.h"

namespace wythe::contact {

// Of what unloads as a joint crushes: with a cap the shear too [Pa/m].
[[nodiscard]] double crushing_stiffness(const JointMaterial& material);
// What it takes until its strength is reached; 0 without hardening [N/m].
[[nodiscard]] double hardening_energy(const JointMaterial& material);

}  // namespace wythe::contact
