// Checks the moduli of a deformable block, and inverts its compliances to D (docs/theory/zones.md, "The material").
// A block is orthotropic where youngs_modulus_across is stated. Plane strain eliminates the third direction from the
// compliances first. G enters D as stated; in an isotropic block it must agree with E and nu within 1 %.
#include "solids/elasticity.h"

#include <fmt/core.h>

#include <cmath>

namespace wythe::solids {
namespace {

bool is_orthotropic(const JointMaterial& body) { return !std::isnan(body.youngs_modulus_across); }

double across(const JointMaterial& body) {
  return is_orthotropic(body) ? body.youngs_modulus_across : body.youngs_modulus;
}

class Checker {
 public:
  explicit Checker(const JointMaterial& body) : m_(body) {}

  std::vector<MaterialFault> run() {
    require("density", m_.density, "\"500 kg/m^3\"");
    require("youngs_modulus", m_.youngs_modulus, "\"10 GPa\"");
    require("shear_modulus", m_.shear_modulus, "\"0.6 GPa\"");
    if (is_orthotropic(m_))
      require("youngs_modulus_across", m_.youngs_modulus_across, "\"0.4 GPa\"");
    if (!faults_.empty()) return std::move(faults_);
    if (is_orthotropic(m_))
      check_orthotropic();
    else
      check_isotropic();
    return std::move(faults_);
  }

 private:
  void fault(const char* key, std::string value, std::string problem, std::string cure) {
    faults_.push_back({key, std::move(value), std::move(problem), std::move(cure)});
  }

  void require(const char* key, double value, const char* example) {
    if (std::isnan(value))
      fault(key, "", "is missing; a block of zones needs it",
            fmt::format("add e.g. {} = {}", key, example));
    else if (!(value > 0 && std::isfinite(value)))
      fault(key, fmt::format("{:g}", value), "must be more than 0",
            fmt::format("write e.g. {} = {}", key, example));
  }

  void check_isotropic() {
    constexpr double kAgree = 0.01;  // E, G and nu are three numbers for two constants
    const double derived = m_.youngs_modulus / (2 * m_.shear_modulus) - 1;
    const double nu = poisson_ratio_of(m_);
    if (!std::isnan(m_.poisson_ratio) &&
        std::fabs(m_.youngs_modulus / (2 * (1 + nu)) / m_.shear_modulus - 1) > kAgree)
      return fault("poisson_ratio", fmt::format("{:g}", nu),
                   fmt::format("differs from the {:.3g} that E = {:g} GPa and G = {:g} GPa make",
                               derived, m_.youngs_modulus * 1e-9, m_.shear_modulus * 1e-9),
                   "leave it out, or state youngs_modulus_across for timber");
    if (nu >= 0 && nu < 0.5) return;
    fault(
        std::isnan(m_.poisson_ratio) ? "shear_modulus" : "poisson_ratio", "",
        fmt::format("makes the Poisson ratio E/2G - 1 = {:.3g}; an isotropic block needs one from "
                    "0 to below 0.5",
                    nu),
        fmt::format("write shear_modulus between {:.3g} and {:.3g} GPa, or state "
                    "youngs_modulus_across and poisson_ratio for timber",
                    m_.youngs_modulus * 1e-9 / 3, m_.youngs_modulus * 1e-9 / 2));
  }

  void check_orthotropic() {
    const double nu = m_.poisson_ratio;
    if (std::isnan(nu))
      return fault("poisson_ratio", "", "is missing beside youngs_modulus_across",
                   "add e.g. poisson_ratio = 0.4");
    if (nu < 0 || nu >= 0.5)
      return fault("poisson_ratio", fmt::format("{:g}", nu), "must be from 0 to below 0.5",
                   "write e.g. poisson_ratio = 0.4");
    // the stiffness in space is positive definite where 1 - nu - 2 nu^2 E2/E1 > 0, with nu across = nu
    const double ratio = across(m_) / m_.youngs_modulus;
    if (1 - nu - 2 * nu * nu * ratio <= 0)
      fault(
          "youngs_modulus_across", fmt::format("{:g} GPa", m_.youngs_modulus_across * 1e-9),
          fmt::format("is {:g} times youngs_modulus: with poisson_ratio {:g} the stiffness is not "
                      "positive",
                      ratio, nu),
          fmt::format("write less than {:.3g} GPa",
                      (1 - nu) / (2 * nu * nu) * m_.youngs_modulus * 1e-9));
  }

  const JointMaterial& m_;
  std::vector<MaterialFault> faults_;
};

}  // namespace

std::vector<MaterialFault> check_elasticity(const JointMaterial& body) {
  return Checker(body).run();
}

double poisson_ratio_of(const JointMaterial& body) {
  if (!std::isnan(body.poisson_ratio)) return body.poisson_ratio;
  return body.youngs_modulus / (2 * body.shear_modulus) - 1;
}

Elasticity elasticity_of(const JointMaterial& body, Plane plane) {
  const double e1 = body.youngs_modulus, e2 = across(body), nu = poisson_ratio_of(body);
  // compliances; the third direction is across the grain too
  double s11 = 1 / e1, s12 = -nu / e1, s22 = 1 / e2;
  if (plane == Plane::kStrain) {
    const double s13 = -nu / e1, s23 = -nu / e2, s33 = 1 / e2;
    s11 -= s13 * s13 / s33;
    s12 -= s13 * s23 / s33;
    s22 -= s23 * s23 / s33;
  }
  const double det = s11 * s22 - s12 * s12;
  Elasticity d{};
  d[0] = {s22 / det, -s12 / det, 0};
  d[1] = {-s12 / det, s11 / det, 0};
  d[2] = {0, 0, body.shear_modulus};
  return d;
}

}  // namespace wythe::solids
