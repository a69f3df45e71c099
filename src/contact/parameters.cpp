// Checks of a joint material and its constants; see parameters.h and docs/theory/joint_law.md.
#include "contact/parameters.h"

#include <fmt/core.h>

#include <cmath>
#include <numbers>

#include "contact/crushing.h"
#include "contact/law.h"
#include "core/elementary.h"
#include "wythe/parts/error.h"

namespace wythe {
namespace {

constexpr double kHardeningDrop =
    2.0 / 3.0;  // share of fc that hardening adds: crushing begins at fc/3
constexpr double kHardeningArea =
    1.0 - kHardeningDrop / 3.0;  // mean strength while it hardens, of fc
constexpr double kHuge = 1e300;  // "unlimited", where products with it must stay finite

double drop_of(const JointMaterial& m, double sn) {
  const double t0 = m.cohesion + sn * elementary::tan(m.friction_angle);
  const double tr = m.residual_cohesion + sn * elementary::tan(m.residual_friction_angle);
  return t0 - tr;
}

// Largest compression at which the shear drop is examined: crushing, or 10 MPa where crushing is
// unlimited, more than masonry in a wall experiences.
double greatest_compression(const JointMaterial& m) {
  return std::isfinite(m.compressive_strength) ? m.compressive_strength : 10e6;
}

}  // namespace

namespace contact {

double Tangents::of(double angle) {
  for (const Known& one : known_)
    if (one.angle == angle) return one.tangent;
  Known& one = known_[oldest_++ % known_.size()];
  one = {angle, elementary::tan(angle)};
  return one.tangent;
}

const LawConstants<double>& Laws::of(std::int32_t material) {
  if (material != last_) law_ = constants_of(materials_[material], tangents_);
  last_ = material;
  return law_;
}
double greatest_drop(const JointMaterial& m) {
  return std::max(drop_of(m, 0.0), drop_of(m, greatest_compression(m)));
}
double greatest_rise(const JointMaterial& m) {
  return choice_of(m).rising ? m.mode_2_energy_per_pressure * greatest_compression(m) : 0.0;
}

JointMaterial head_joint_law(const JointMaterial& bed) {
  constexpr double kMargin = 1.05;  // of (9.1)
  const double share = bed.head_joint_bond;
  JointMaterial head = bed;
  head.head_joint_bond = kUnset;
  for (auto part : {&JointMaterial::tensile_strength, &JointMaterial::cohesion,
                    &JointMaterial::residual_cohesion, &JointMaterial::mode_1_energy,
                    &JointMaterial::mode_2_energy})
    head.*part *= share;
  // the drop of friction does not decrease with the bond, and no path follows a branch steeper than ks (3.13)
  const double slope = steepest_slope(bed.softening) / bed.shear_stiffness;
  const double unpressed = std::max(0.0, drop_of(head, 0.0)), pressed = greatest_drop(head);
  const double least =
      std::max(slope * unpressed * unpressed, slope * pressed * pressed - greatest_rise(head));
  if (head.mode_2_energy < kMargin * least)
    head.mode_2_energy = std::min(bed.mode_2_energy, kMargin * least);
  return head;
}

double crushing_stiffness(const JointMaterial& m) {
  if (!(m.compression_cap > 0)) return m.normal_stiffness;
  return std::fmin(m.normal_stiffness, m.compression_cap * m.shear_stiffness);
}
double hardening_energy(const JointMaterial& m) {
  if (!(m.hardening_displacement > 0)) return 0;
  return kHardeningArea * m.hardening_displacement * m.compressive_strength;
}
}  // namespace contact

namespace {

using contact::crushing_stiffness;
using contact::greatest_drop;
using contact::greatest_rise;
using contact::hardening_energy;

class Checker {
 public:
  explicit Checker(const JointMaterial& material) : m_(material) {}

  std::vector<MaterialFault> run() {
    require_all();
    if (!faults_.empty()) return std::move(faults_);
    check_tension();
    check_shear();
    check_cap();
    check_compression();
    return std::move(faults_);
  }

 private:
  void fault(const char* key, std::string value, std::string problem, std::string cure) {
    faults_.push_back({key, std::move(value), std::move(problem), std::move(cure)});
  }

  static std::string degrees(double angle) {
    return fmt::format("{:g} deg", angle * 180 / std::numbers::pi);
  }

  void require(const char* key, double value, double low, bool strict, const char* cure) {
    if (std::isnan(value)) {
      fault(key, "", "is missing; a physical parameter has no default",
            fmt::format("add {} = {}", key, cure));
    } else if (strict ? value <= low : value < low) {
      fault(key, fmt::format("{:g}", value),
            fmt::format("must be {} {:g}", strict ? "more than" : "at least", low),
            fmt::format("write e.g. {} = {}", key, cure));
    }
  }

  void require_all() {
    require("normal_stiffness", m_.normal_stiffness, 0, true, "\"20 GPa/m\"");
    require("shear_stiffness", m_.shear_stiffness, 0, true, "\"8 GPa/m\"");
    require("tensile_strength", m_.tensile_strength, 0, false, "\"0.15 MPa\" (0 for a dry joint)");
    require("cohesion", m_.cohesion, 0, false, "\"0.15 MPa\" (0 for a dry joint)");
    require("friction_angle", m_.friction_angle, 0, false, "\"16.2 deg\"");
    require("residual_friction_angle", m_.residual_friction_angle, 0, false, "\"14.6 deg\"");
    require("residual_cohesion", m_.residual_cohesion, 0, false, "\"0 MPa\"");
    require("compressive_strength", m_.compressive_strength, 0, true,
            "\"3.96 MPa\" or \"unlimited\"");
    check_angle("friction_angle", m_.friction_angle);
    check_angle("residual_friction_angle", m_.residual_friction_angle);
    if (!std::isnan(m_.head_joint_bond) && !(m_.head_joint_bond >= 0 && m_.head_joint_bond <= 1))
      fault("head_joint_bond", fmt::format("{:g}", m_.head_joint_bond), "must be from 0 to 1",
            "write e.g. head_joint_bond = 0.25, or leave it out: as the beds");
  }

  void check_angle(const char* key, double angle) {
    if (angle >= std::numbers::pi / 2)
      fault(key, degrees(angle), "must be less than 90 deg",
            fmt::format("write e.g. {} = \"30 deg\"", key));
  }

  // Requires an energy only where it acts, and a branch no steeper than the elastic one. `already_spent` is not
  // available for softening; a negative value adds to the energy.
  void check_energy(const char* key, double energy, double strength, double stiffness,
                    double steepest, const std::string& what, const char* example,
                    double already_spent = 0) {
    const double least = already_spent + steepest * strength * strength / stiffness;
    if (std::isnan(energy)) {
      fault(key, "", fmt::format("is missing while {} is {:g} MPa", what, strength * 1e-6),
            fmt::format("add {} = {}", key, example));
    } else if (energy <= least) {
      fault(key, fmt::format("{:g} N/m", energy),
            fmt::format("gives snap-back: with {} {:g} MPa and stiffness {:g} GPa/m the softening "
                        "branch is steeper than the elastic one and no displacement path can "
                        "follow it",
                        what, strength * 1e-6, stiffness * 1e-9),
            fmt::format("raise {} above {:g} N/m or lower the strength", key, least));
    }
  }

  void check_tension() {
    if (m_.tensile_strength > 0)
      check_energy("mode_1_energy", m_.mode_1_energy, m_.tensile_strength, m_.normal_stiffness,
                   contact::steepest_slope(m_.softening), "tensile_strength", "\"4.3 N/m\"");
  }

  void check_shear() {
    const double rise = m_.mode_2_energy_per_pressure;
    if (!std::isnan(rise) && !(rise >= 0 && std::isfinite(rise)))
      fault("mode_2_energy_per_pressure", fmt::format("{:g} mm", 1e3 * rise), "must be at least 0",
            "write e.g. \"0.1 mm\", or leave it out");
    else if (m_.tensile_strength > 0 && greatest_drop(m_) > 0)
      check_slip_energy();
    if (m_.residual_friction_angle > m_.friction_angle)
      fault("residual_friction_angle", degrees(m_.residual_friction_angle),
            "is above friction_angle " + degrees(m_.friction_angle),
            "write a residual no greater than the peak");
    if (m_.residual_cohesion > m_.cohesion)
      fault("residual_cohesion", fmt::format("{:g} MPa", m_.residual_cohesion * 1e-6),
            fmt::format("is above cohesion {:g} MPa", m_.cohesion * 1e-6),
            "write a residual no greater than the peak");
  }

  // GII less the value for snap-back is concave in the pressure, so the worse end of its range decides (joint_law.md, 3.13).
  void check_slip_energy() {
    const double steepest = contact::steepest_slope(m_.softening), rise = greatest_rise(m_);
    const double least = std::max(0.0, drop_of(m_, 0.0)), most = greatest_drop(m_);
    const bool pressed = steepest * (most * most - least * least) >= rise * m_.shear_stiffness;
    std::string what = "the drop from peak to residual shear";
    if (pressed && rise > 0)
      what += fmt::format(", for {:g} N/m more by mode_2_energy_per_pressure,", rise);
    check_energy("mode_2_energy", m_.mode_2_energy, pressed ? most : least, m_.shear_stiffness,
                 steepest, what, "\"125 N/m\"", pressed ? -rise : 0);
  }

  void check_compression() {
    if (!std::isfinite(m_.compressive_strength)) return;
    if (hardening_energy(m_) >= m_.compressive_energy) return refuse_hardening();
    check_energy("compressive_energy", m_.compressive_energy, m_.compressive_strength,
                 crushing_stiffness(m_), 0.5, "compressive_strength", "\"12800 N/m\"",
                 hardening_energy(m_));
  }

  void refuse_hardening() {
    fault("hardening_displacement", fmt::format("{:g} mm", m_.hardening_displacement * 1e3),
          fmt::format("makes hardening alone take {:g} N/m, and compressive_energy is {:g} N/m",
                      hardening_energy(m_), m_.compressive_energy),
          fmt::format(
              "write less than {:g} mm or raise compressive_energy",
              m_.hardening_displacement * 1e3 * m_.compressive_energy / hardening_energy(m_)));
  }

  void check_cap() {
    const auto positive = [&](const char* key, double value, const char* cure) {
      if (!std::isnan(value) && !(value > 0 && std::isfinite(value)))
        fault(key, fmt::format("{:g}", value), "must be more than 0", cure);
    };
    positive("compression_cap", m_.compression_cap,
             "write e.g. compression_cap = 9, or leave it out for no cap");
    positive("hardening_displacement", m_.hardening_displacement,
             "write e.g. \"0.09 mm\", or leave it out");
    positive("dilatancy_slip", m_.dilatancy_slip, "write e.g. \"1 mm\", or leave it out");
    positive("dilatancy_pressure", m_.dilatancy_pressure, "write e.g. \"1 MPa\", or leave it out");
    if (!faults_.empty()) return;
    for (const auto& [key, value] :
         {std::pair{"compression_cap", m_.compression_cap},
          std::pair{"hardening_displacement", m_.hardening_displacement}})
      if (value > 0 && !std::isfinite(m_.compressive_strength))
        fault(key, fmt::format("{:g}", value),
              "has no meaning where compressive_strength is unlimited",
              fmt::format("give compressive_strength, or leave {} out", key));
    const double elastic_step = m_.compressive_strength / std::sqrt(m_.compression_cap);
    if (m_.compression_cap > 0 && m_.cohesion >= elastic_step)
      fault("compression_cap", fmt::format("{:g}", m_.compression_cap),
            fmt::format("allows a shear stress of {:g} MPa without pressure, and cohesion is {:g} "
                        "MPa, so that cap and friction never meet",
                        elastic_step * 1e-6, m_.cohesion * 1e-6),
            fmt::format("write less than {:g} or a smaller cohesion",
                        elementary::pow(m_.compressive_strength / m_.cohesion, 2)));
    check_dilatancy();
  }

  void check_dilatancy() {
    const bool fades = m_.dilatancy_slip > 0 || m_.dilatancy_pressure > 0;
    if (std::isnan(m_.dilatancy_angle)) {
      if (fades)
        fault("dilatancy_angle", "",
              "is missing, and dilatancy_slip or dilatancy_pressure is given",
              "add dilatancy_angle = \"5 deg\", or leave the others out");
    } else if (m_.dilatancy_angle < 0 || m_.dilatancy_angle > m_.residual_friction_angle) {
      fault("dilatancy_angle", degrees(m_.dilatancy_angle),
            fmt::format("must be from 0 to residual_friction_angle {}: beyond it sliding would "
                        "make energy",
                        degrees(m_.residual_friction_angle)),
            "write a smaller angle");
    }
  }

  const JointMaterial& m_;
  std::vector<MaterialFault> faults_;
};

// Largest step of a path that resolves every branch of the law (drive_contact's substeps).
double resolving_step(const JointMaterial& m) {
  double step = 1e-6;
  if (m.tensile_strength > 0)
    step = std::min({step, m.tensile_strength / m.normal_stiffness / 50,
                     m.mode_1_energy / m.tensile_strength / 500});
  const double drop = greatest_drop(m);
  if (m.tensile_strength > 0 && drop > 0)
    // GII over its drop changes monotonically with the pressure
    step = std::min({step, drop / m.shear_stiffness / 50, m.mode_2_energy / drop_of(m, 0.0) / 500,
                     (m.mode_2_energy + greatest_rise(m)) / drop / 500});
  return step;
}

// One joint on a path.
//
// The energies of the law hold for short steps. In a long step that opens a joint completely, the
// area under the falling branch would grow with the step. A wall never takes such steps (below
// 100 m/s it moves a fraction of a millimetre in one), but a row of a path may ask for metres.
// So a substep grows only while two halves of it dissipate as much as the whole, or none does.
template <class V>
class PathDriver {
 public:
  explicit PathDriver(const JointMaterial& material)
      : m_(contact::constants_of(material)), finest_(resolving_step(material)) {}

  // Goes straight to `to`; false where that is impossible: too many substeps, or NaN.
  bool go_to(const ContactPathRow& to) {
    const ContactPathRow from = at_;
    const double length =
        std::max(std::fabs(to.opening - from.opening), std::fabs(to.slip - from.slip));
    const double finest = length > finest_ ? 1.0 / std::ceil(length / finest_) : 1.0;
    const auto point = [&](double share) {
      return ContactPathRow{from.opening + share * (to.opening - from.opening),
                            from.slip + share * (to.slip - from.slip)};
    };
    double done = 0, share = finest;
    for (int k = 0; done < 1; ++k) {
      if (k == kMostSubsteps) return false;
      share = std::min(share, 1 - done);
      const double next = 1 - done - share < 1e-9 * finest ? 1.0 : done + share;
      const Point whole = step(point_, next < 1 ? point(next) : to);
      const Point half = step(point_, point(0.5 * (done + next)));
      const Point halves = step(half, next < 1 ? point(next) : to);
      const bool agree =
          is_smooth(point_, half, halves) &&
          std::fabs(whole.dissipated - halves.dissipated) <= kAgreement * halves.dissipated;
      if (!agree && share > finest) {
        share = finest;
        continue;
      }
      point_ = halves;
      done = next;
      if (agree) share *= 2;
    }
    at_ = to;
    return std::isfinite(point_.now.sigma) && std::isfinite(point_.now.tau) &&
           std::isfinite(point_.dissipated);
  }

  [[nodiscard]] ContactAnswer answer() const {
    const contact::LawUpdate<double>& now = point_.now;
    const double crushed = contact::crushed_share(m_, point_.history);
    return {now.sigma,  now.tau, now.tension_damage, point_.history.shear_damage,
            now.damage, crushed, point_.dissipated};
  }

 private:
  static constexpr double kAgreement = 1e-7;       // of the dissipation so far
  static constexpr int kMostSubsteps = 4'000'000;  // about a second

  struct Point {
    contact::History<double> history{};
    contact::LawUpdate<double> now{};
    double dissipated = 0;  // [N/m]
  };

  // Whether no branch begins or ends between these points: a whole branch could lie within one half.
  static bool is_smooth(const Point& from, const Point& half, const Point& to) {
    return (half.dissipated > from.dissipated) == (to.dissipated > half.dissipated);
  }

  Point step(Point point, const ContactPathRow& to) const {
    point.now = contact::update<V>(m_, to.opening, to.slip, point.history);
    point.dissipated += point.now.friction + point.now.fracture + point.now.crushing;
    return point;
  }

  contact::LawConstants<double> m_;
  double finest_;      // smallest substep [m]
  Point point_;        // the joint starts closed and unstressed
  ContactPathRow at_;  // [m]
};

template <class V>
std::vector<ContactAnswer> drive(const JointMaterial& material,
                                 const std::vector<ContactPathRow>& path) {
  PathDriver<V> driver(material);
  std::vector<ContactAnswer> answers;
  for (const ContactPathRow& to : path) {
    if (!driver.go_to(to))
      throw InputError(
          {{.path = fmt::format("path.{}", answers.size()),
            .value = fmt::format("opening {:g} mm, slip {:g} mm", 1e3 * to.opening, 1e3 * to.slip),
            .problem = "the law can't be followed there",
            .cure = "go there in several shorter rows"}});
    answers.push_back(driver.answer());
  }
  return answers;
}

}  // namespace

std::vector<MaterialFault> check_joint_material(const JointMaterial& material) {
  return Checker(material).run();
}

std::vector<ContactAnswer> drive_contact(const JointMaterial& material,
                                         const std::vector<ContactPathRow>& path) {
  return contact::with_variant(contact::choice_of(material), [&](auto variant) {
    return drive<decltype(variant)>(material, path);
  });
}

namespace contact {

std::vector<MaterialFault> missing_as_one(std::vector<MaterialFault> faults) {
  constexpr std::string_view kAdd = "add ";
  MaterialFault one{};
  std::vector<MaterialFault> others;
  std::string keys;
  std::size_t count = 0;
  for (const MaterialFault& fault : faults) {
    if (!fault.problem.starts_with("is missing")) {
      others.push_back(fault);
      continue;
    }
    ++count;
    keys += (keys.empty() ? "" : ", ") + fault.key;
    const std::string_view cure = fault.cure;
    if (!one.cure.empty()) one.cure += ", ";
    one.cure += one.cure.empty() || !cure.starts_with(kAdd) ? cure : cure.substr(kAdd.size());
  }
  if (count < 2) return faults;
  one.problem = fmt::format("lacks {}; physical parameters have no default", keys);
  others.insert(others.begin(), std::move(one));
  return others;
}

LawConstants<double> constants_of(const JointMaterial& s) {
  Tangents tangents;
  return constants_of(s, tangents);
}

LawConstants<double> constants_of(const JointMaterial& s, Tangents& tangents) {
  LawConstants<double> m{};
  m.kn = s.normal_stiffness;
  m.ks = s.shear_stiffness;
  m.inv_kn = 1.0 / m.kn;
  m.inv_ks = 1.0 / m.ks;
  m.ft = std::min(s.tensile_strength, kHuge);
  m.w0 = m.ft / m.kn;
  if (m.ft == kHuge) {  // elastic without limit
    m.tension_onset = m.w0;
  } else if (m.ft > 0) {
    m.ft_over_GI = m.ft / s.mode_1_energy;
    m.tension_onset = m.w0;
    m.tension_rate = 1.0 / (2.0 * s.mode_1_energy / m.ft - m.w0);
    m.half_inv_GII = s.mode_2_energy > 0 ? 0.5 / s.mode_2_energy : 0.0;
  } else {  // d_t = 1 from the start, no division
    m.tension_onset = -1.0;
    m.tension_rate = 1.0;
  }
  m.twice_b = choice_of(s).rising ? 2.0 * s.mode_2_energy_per_pressure : 0.0;
  m.c_res = std::min(s.residual_cohesion, kHuge);
  m.c_drop = std::min(s.cohesion, kHuge) - m.c_res;
  m.tan_res = tangents.of(s.residual_friction_angle);
  m.tan_drop = tangents.of(s.friction_angle) - m.tan_res;
  const bool limited = std::isfinite(s.compressive_strength);
  m.fc = limited ? s.compressive_strength : kHuge;
  m.p_full = limited ? 2.0 * s.compressive_energy / m.fc : kHuge;
  m.inv_p_full = limited ? 1.0 / m.p_full : 0.0;
  m.crush_gain = 1.0 / (m.kn - (limited ? m.fc / m.p_full : 0.0));
  m.root_css = s.compression_cap > 0 ? std::sqrt(s.compression_cap) : 0.0;
  m.css_ks = s.compression_cap > 0 ? s.compression_cap * m.ks : 0.0;
  if (s.hardening_displacement > 0) {
    m.harden = s.hardening_displacement;
    m.inv_harden = 1.0 / m.harden;
    m.harden_drop = kHardeningDrop;
    m.p_full += m.harden - 2 * kHardeningArea * m.harden;
    m.inv_p_full = 1.0 / m.p_full;
  }
  m.crush_rate = limited ? 1.0 / (m.p_full - m.harden) : 0.0;
  m.tan_lift = s.dilatancy_angle > 0 ? tangents.of(s.dilatancy_angle) : 0.0;
  m.inv_lift_slip = s.dilatancy_slip > 0 ? 1.0 / s.dilatancy_slip : 0.0;
  m.inv_lift_stress = s.dilatancy_pressure > 0 ? 1.0 / s.dilatancy_pressure : 0.0;
  m.choice = choice_of(s);
  return m;
}

}  // namespace contact
}  // namespace wythe
