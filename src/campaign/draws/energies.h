// Formulas of the energies that go with drawn strengths and never make a joint snap back (docs/theory/fields.md,
// "Scatter of a masonry"): each is `proportional`, or 1.05 times the least that the law can follow. Strengths are
// formulas too; `m` holds the means that they scatter about.
#pragma once

#include <string>

#include "wythe/parts/contact_law.h"

namespace wythe::study {

[[nodiscard]] std::string tension_energy(const std::string& proportional, const std::string& ft,
                                         const JointMaterial& m);
// Without pressure, and under that at which the drop from peak to residual shear is greatest. `crushing`: factor on
// the compressive strength, which bounds that pressure; "": it does not scatter.
[[nodiscard]] std::string slip_energy(const std::string& proportional, const std::string& c,
                                      const JointMaterial& m, const std::string& crushing = "");
[[nodiscard]] std::string crushing_energy(const std::string& proportional, const std::string& fc,
                                          const JointMaterial& m);

}  // namespace wythe::study
