// Formulas of energies that follow drawn strengths and never make a joint snap back
// (docs/theory/fields.md, "Scatter of a masonry"). Each is `proportional`, or 1.05 times the
// least energy that the law can follow. Strengths are formulas too; `m` holds their means.
#pragma once

#include <string>

#include "wythe/parts/contact_law.h"

namespace wythe::study {

[[nodiscard]] std::string tension_energy(const std::string& proportional, const std::string& ft,
                                         const JointMaterial& m);
// The slip energy for zero pressure, and for the pressure with the greatest drop from peak to residual shear.
// `crushing`: factor on the compressive strength, which limits that pressure; empty: it does not scatter.
[[nodiscard]] std::string slip_energy(const std::string& proportional, const std::string& c,
                                      const JointMaterial& m, const std::string& crushing = "");
[[nodiscard]] std::string crushing_energy(const std::string& proportional, const std::string& fc,
                                          const JointMaterial& m);

}  // namespace wythe::study
