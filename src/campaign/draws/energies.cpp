// Writes each energy as the text of a formula: max(proportional, 1.05 G s^2 / k + spent). s is the drop of stress and G
// the steepest slope of the softening (docs/theory/joint_law.md, 3.13). Slip has two such bounds where GII rises with
// pressure: without pressure and at the greatest drop. Numbers have 17 digits, so they read back to the same bits.
#include "campaign/draws/energies.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/crushing.h"
#include "contact/parameters.h"
#include "contact/softening.h"

namespace wythe::study {
namespace {

constexpr double kAbove = 1.05;  // of the least energy without snap-back

// "max(GI0/ft0 ft, 1.05 G ft^2/kn + spent)", with G the steepest slope of the branch. `spent`
// is a formula of the energy lost before the branch begins, or gained (below 0) [N/m].
std::string above_least(const std::string& proportional, const std::string& drop, double stiffness,
                        double steepest, const std::string& spent = "") {
  return fmt::format("max({}, {:.17g} * ({}) ^ 2 / {:.17g} Pa/m{})", proportional,
                     kAbove * steepest, drop, stiffness, spent);
}

// The drop from peak to residual shear, with cohesion `c` instead of the mean, of which friction is a share.
std::string drop_of(const std::string& c, const JointMaterial& m, const std::string& friction) {
  const double kept = m.cohesion > 0 ? m.residual_cohesion / m.cohesion : 0;
  return fmt::format("{:.17g} * {} + {}", 1 - kept, c, friction);
}

}  // namespace

std::string tension_energy(const std::string& proportional, const std::string& ft,
                           const JointMaterial& m) {
  return above_least(proportional, ft, m.normal_stiffness, contact::steepest_slope(m.softening));
}

std::string slip_energy(const std::string& proportional, const std::string& c,
                        const JointMaterial& m, const std::string& crushing) {
  const std::string times =
      crushing.empty() || !std::isfinite(m.compressive_strength) ? "" : " * " + crushing;
  const double friction =
      std::max(0.0, contact::greatest_drop(m) - (m.cohesion - m.residual_cohesion));
  const double rise = contact::greatest_rise(m), ks = m.shear_stiffness,
               steepest = contact::steepest_slope(m.softening);
  std::string out = proportional, gained;
  if (rise > 0) {
    out = above_least(out, drop_of(c, m, "0 Pa"), ks, steepest);
    gained = fmt::format(" - {:.17g} N/m{}", rise, times);
  }
  return above_least(out, drop_of(c, m, fmt::format("{:.17g} Pa{}", friction, times)), ks, steepest,
                     gained);
}

std::string crushing_energy(const std::string& proportional, const std::string& fc,
                            const JointMaterial& m) {
  constexpr double kStraight = 0.5;  // G of a linear branch
  const double hardening = contact::hardening_energy(m) / m.compressive_strength;
  return above_least(proportional, fc, contact::crushing_stiffness(m), kStraight,
                     hardening > 0 ? fmt::format(" + {:.17g} m * ({})", hardening, fc) : "");
}

}  // namespace wythe::study
