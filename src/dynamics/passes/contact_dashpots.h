// Dashpots and Maxwell elements of free contacts (docs/theory/dynamics.md, 14.11). Each contact has one of
// each at its centre of pressure, along the normal and along the slip, in proportion to its present stiffness.
//
//   dashpot           c = beta K + 2 xi sqrt(K m),   f = c v / (1 + c dt / 2m')      with the mean velocity v of a step
//   Maxwell element   as at joints (dashpots.h); K falls: the force falls with it; K grows: the force stays
//
// m = m_a m_b / (m_a + m_b), m' the mass that feels the force there, rotation included.
#pragma once

#include "core/rotation.h"
#include "dynamics/passes/dashpots.h"
#include "wythe/parts/free_contacts.h"

namespace wythe::dynamics {

// The data of a contact that its dashpots need: forces of its springs alone, and its motion in the step.
struct ContactMotion {
  double normal_stiffness, shear_stiffness;  // now [N/m]
  double pressed;                            // [N]
  Vector<double> held;                       // friction, along the slip [N]
  double opened;                             // in the step [m]
  Vector<double> slid;                       //
  double mass, mobility;                     // m [kg], 1/m' [1/kg]
  double area_before;                        // [m^2]
};
// Force against the motion: normal part, positive in tension, and part along the slip [N].
struct ViscousForce {
  double normal = 0;
  Vector<double> shear{0, 0, 0};
};

[[nodiscard]] inline double length_of(const Vector<double>& v) { return square_root(dot(v, v)); }

[[nodiscard]] inline ViscousForce damp_contact(const ContactMotion& c, const Dashpots& dashpots,
                                               double friction, double dt, FreeContact& memory) {
  const double closed =
      share_of_first_step(rebounds(dashpots), -c.pressed / c.normal_stiffness, c.opened);
  const auto resistance = [&](double stiffness) {
    const double full = closed * (dashpots.proportional * stiffness +
                                  2 * dashpots.impact * square_root(stiffness * c.mass));
    return full / (1 + 0.5 * full * dt * c.mobility);
  };
  const double c_n = resistance(c.normal_stiffness), c_s = resistance(c.shear_stiffness);
  const MaxwellStep<double> maxwell = maxwell_step(dashpots, dt);
  const double left = memory.area < c.area_before ? memory.area / c.area_before : 1.0;
  const Vector<double> bore{memory.maxwell_x, memory.maxwell_y, memory.maxwell_z};
  const double spring_n = maxwell.of(left * memory.maxwell_n, c.normal_stiffness, c.opened);
  const Vector<double> spring_s =
      (maxwell.kept * left) * bore + (maxwell.gain * c.shear_stiffness) * c.slid;

  ViscousForce f;
  f.normal = minimum(c_n * c.opened / dt + spring_n, c.pressed);  // a contact only presses
  const Vector<double> wanted = (c_s / dt) * c.slid + spring_s;
  const double size = length_of(wanted);
  const double room = friction * (c.pressed - f.normal) - length_of(c.held);
  const double share = size > 0 ? clip(room / size, 0.0, 1.0) : 0.0;
  f.shear = share * wanted;
  memory.maxwell_n = minimum(spring_n, c.pressed);
  memory.maxwell_x = share * spring_s.x;
  memory.maxwell_y = share * spring_s.y;
  memory.maxwell_z = share * spring_s.z;
  return f;
}

}  // namespace wythe::dynamics
