// Elastic spectra of EN 1998-1 and NTC 2018, or of a table, and the demand of N2.
//
// docs/theory/assessment.md, equations (A.1) to (A.12). Called by assessment.cpp and
// the reader of [assessment.spectrum].
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "judge/assessment/assessment_parts.h"
#include "wythe/parts/assessment.h"

namespace wythe {
namespace {

struct Ground {
  double S, TB, TC, TD;  // [-], [s]
};
// EN 1998-1, Tables 3.2 and 3.3: ground types A to E.
constexpr Ground kType1[] = {{1.0, 0.15, 0.4, 2.0},
                             {1.2, 0.15, 0.5, 2.0},
                             {1.15, 0.2, 0.6, 2.0},
                             {1.35, 0.2, 0.8, 2.0},
                             {1.4, 0.15, 0.5, 2.0}};
constexpr Ground kType2[] = {{1.0, 0.05, 0.25, 1.2},
                             {1.35, 0.05, 0.25, 1.2},
                             {1.5, 0.1, 0.25, 1.2},
                             {1.8, 0.1, 0.3, 1.2},
                             {1.6, 0.05, 0.25, 1.2}};

// NTC 2018, Table 3.2.IV: SS = first - second F0 ag / g, within low and high; CC = factor TC*^power.
struct Category {
  double low, first, second, high, factor, power;
};
constexpr Category kCategories[] = {{1.0, 1.0, 0.0, 1.0, 1.0, 0.0},
                                    {1.0, 1.4, 0.4, 1.2, 1.1, -0.20},
                                    {1.0, 1.7, 0.6, 1.5, 1.05, -0.33},
                                    {0.9, 2.4, 1.5, 1.8, 1.25, -0.50},
                                    {1.0, 2.0, 1.1, 1.6, 1.15, -0.40}};

double interpolated(const std::vector<double>& x, const std::vector<double>& y, double at) {
  if (x.empty() || !(at >= x.front()) || at > x.back()) return kUnset;
  const auto next = std::upper_bound(x.begin(), x.end(), at);
  if (next == x.end()) return y.back();
  const std::size_t i = next - x.begin();
  const double share = (at - x[i - 1]) / (x[i] - x[i - 1]);
  return y[i - 1] + share * (y[i] - y[i - 1]);
}

class SpectrumFaults {
 public:
  explicit SpectrumFaults(const SpectrumSpec& spec) : s_(spec) {}
  std::vector<Fault> all() {
    if (s_.kind == SpectrumKind::kNone) return {};
    if (!value_of(kGroundTypeWords, s_.ground))
      add("ground", s_.ground, "must be A, B, C, D or E", "write e.g. ground = \"B\"");
    if (s_.kind == SpectrumKind::kTable) {
      check_table();
      return faults_;
    }
    need(s_.ground_acceleration, "ground_acceleration",
         "write e.g. ground_acceleration = \"1.5 m/s^2\"");
    if (s_.kind == SpectrumKind::kEn1998 && s_.shape != "1" && s_.shape != "2")
      add("shape", s_.shape, "must be \"1\" or \"2\"",
          "write \"1\" for strong and distant earthquakes, \"2\" for magnitudes up to 5.5");
    if (s_.kind == SpectrumKind::kNtc2018) {
      need(s_.amplification, "amplification", "write F0 of the site, e.g. amplification = 2.45");
      if (s_.amplification > 0 && s_.amplification < 1)
        add("amplification", fmt::format("{:g}", s_.amplification),
            "is below 1: the plateau would lie under the ground's own acceleration",
            "write F0 of the site, e.g. amplification = 2.45");
      need(s_.corner_period, "corner_period",
           "write TC* of the site, e.g. corner_period = \"0.32 s\"");
      if (const ElasticSpectrum out = spectrum_of(s_); faults_.empty() && !(out.TC < out.TD))
        add("corner_period", fmt::format("{:g} s", s_.corner_period),
            fmt::format("puts TC, {:.2f} s, beyond TD, {:.2f} s", out.TC, out.TD),
            "write TC* of the site in seconds, e.g. corner_period = \"0.32 s\"");
    }
    return faults_;
  }

 private:
  void add(const char* key, std::string value, std::string problem, std::string cure) {
    faults_.push_back({"", key, std::move(value), std::move(problem), std::move(cure), 0});
  }
  void need(double value, const char* key, const char* cure) {
    if (!std::isfinite(value) || !(value > 0))
      add(key, std::isnan(value) ? "" : fmt::format("{:g}", value), "a positive value is needed",
          cure);
  }
  void check_table() {
    need(s_.corner_period, "corner_period",
         "write TC, which parts short periods from long ones, e.g. corner_period = \"0.5 s\"");
    const std::vector<double>&T = s_.periods, &a = s_.accelerations;
    if (T.size() < 2 || T.size() != a.size()) {
      add("periods", fmt::format("{} values", T.size()),
          fmt::format(
              "a table needs as many periods as accelerations, two at least; {} and {} are given",
              T.size(), a.size()),
          "write e.g. periods = [\"0 s\", \"0.2 s\", \"2 s\"] and accelerations = [\"2 m/s^2\", "
          "\"5 m/s^2\", \"0.5 m/s^2\"]");
      return;
    }
    if (T.front() != 0)
      add("periods", fmt::format("{:g} s", T.front()),
          "must begin at 0 s: there stands the ground's "
          "own acceleration",
          "write the peak ground acceleration as the first value");
    for (std::size_t i = 1; i < T.size(); ++i)
      if (!(T[i] > T[i - 1])) {
        add("periods", fmt::format("{:g} s after {:g} s", T[i], T[i - 1]), "must grow",
            "sort the table by period, each period once");
        break;
      }
    for (const double value : a)
      if (!(value > 0)) {
        add("accelerations", fmt::format("{:g} m/s^2", value), "must be positive",
            "end the table before the spectrum is nil");
        break;
      }
  }

  const SpectrumSpec& s_;
  std::vector<Fault> faults_;
};

const SpectrumSpec& own_spectrum(const AssessmentSpec& spec, LimitState state) {
  switch (state) {
    case LimitState::kOperational: return spec.spectra.operational;
    case LimitState::kDamageLimitation: return spec.spectra.damage_limitation;
    case LimitState::kLifeSafety: return spec.spectra.life_safety;
    case LimitState::kNearCollapse: break;
  }
  return spec.spectra.near_collapse;
}
}  // namespace

double study::eta_of(double damping) {
  return std::fmax(std::sqrt(10 / (5 + 100 * damping)), 0.55);
}

std::vector<Fault> faults_of(const SpectrumSpec& spec) { return SpectrumFaults(spec).all(); }

std::vector<Fault> faults_of(const AssessmentSpec& spec) {
  std::vector<Fault> faults;
  if (!value_of(kAssessmentCodeWords, spec.code))
    faults.push_back({"", "code", spec.code, "a code is needed",
                      "write code = \"circolare_2019\" or \"en1998_3\"", 0});
  if (!value_of(kLimitStateWords, spec.limit_state))
    faults.push_back({"", "limit_state", spec.limit_state, "is no limit state",
                      "write operational, damage_limitation, life_safety or near_collapse", 0});
  for (std::size_t k = 0; k < spec.part.size(); ++k)
    for (std::size_t i = 0; i < k; ++i)
      if (!spec.part[k].name.empty() && spec.part[k].name == spec.part[i].name) {
        faults.push_back({"", "part", spec.part[k].name, "two parts have this name",
                          "give each its own: findings are named after it", 0});
        i = k;
      }
  if (std::isfinite(spec.added_height) && !(spec.added_mass > 0))
    faults.push_back({"", "added_height", "", "there is no added mass to act there",
                      "write added_mass too, or leave it out", 0});
  const auto state = value_of(kLimitStateWords, spec.limit_state);
  if (state && spec.spectrum.kind != SpectrumKind::kNone &&
      own_spectrum(spec, *state).kind != SpectrumKind::kNone)
    faults.push_back({"", "spectrum", "", "there is another in spectra, of the same limit state",
                      "leave one of them out: spectrum is that of limit_state", 0});
  const bool asks_operational =
      state == LimitState::kOperational || spec.spectra.operational.kind != SpectrumKind::kNone;
  if (asks_operational && value_of(kAssessmentCodeWords, spec.code) == AssessmentCode::kEn1998)
    faults.push_back({"", state == LimitState::kOperational ? "limit_state" : "spectra",
                      "operational", "EN 1998-3 has no such limit state",
                      "leave it out, or assess by circolare_2019", 0});
  return faults;
}

const SpectrumSpec& spectrum_for(const AssessmentSpec& spec, LimitState state) {
  const SpectrumSpec& own = own_spectrum(spec, state);
  if (own.kind != SpectrumKind::kNone || spec.spectrum.kind != SpectrumKind::kNone)
    return own.kind != SpectrumKind::kNone ? own : spec.spectrum;
  const auto asked = value_of(kLimitStateWords, spec.limit_state);
  return asked ? own_spectrum(spec, *asked) : own;
}

bool is_checked(const AssessmentSpec& spec, LimitState state) {
  const bool is_asked = value_of(kLimitStateWords, spec.limit_state) == state;
  return own_spectrum(spec, state).kind != SpectrumKind::kNone ||
         (is_asked && spec.spectrum.kind != SpectrumKind::kNone);
}

ElasticSpectrum spectrum_of(const SpectrumSpec& spec) {
  ElasticSpectrum out;
  out.kind = spec.kind;
  if (spec.kind == SpectrumKind::kNone) return out;
  const auto ground =
      static_cast<std::size_t>(value_of(kGroundTypeWords, spec.ground).value_or(GroundType::kA));
  if (spec.kind == SpectrumKind::kTable) {
    out.periods = spec.periods, out.accelerations = spec.accelerations;
    out.TC = spec.corner_period;
    if (!spec.accelerations.empty()) out.ground_acceleration = spec.accelerations.front();
    return out;
  }
  out.ground_acceleration = spec.ground_acceleration;
  out.topography = spec.topography;
  out.eta = study::eta_of(spec.damping);
  if (spec.kind == SpectrumKind::kEn1998) {
    const Ground& g = spec.shape == "2" ? kType2[ground] : kType1[ground];
    out.soil = g.S, out.TB = g.TB, out.TC = g.TC, out.TD = g.TD;
    return out;
  }
  const Category& c = kCategories[ground];  // (A.4), (A.5)
  const double ag = spec.ground_acceleration / kStandardGravity, F0 = spec.amplification;
  out.amplification = F0;
  out.soil = std::fmin(std::fmax(c.first - c.second * F0 * ag, c.low), c.high);
  out.TC = c.factor * std::pow(spec.corner_period, c.power) * spec.corner_period;
  out.TB = out.TC / 3;
  out.TD = 4 * ag + 1.6;
  return out;
}

double ElasticSpectrum::peak_ground_acceleration() const {
  return kind == SpectrumKind::kTable ? ground_acceleration
                                      : ground_acceleration * soil * topography;
}

// (A.1), (A.2). A table is linear between its periods.
double ElasticSpectrum::acceleration(double T) const {
  if (kind == SpectrumKind::kNone || !(T >= 0)) return kUnset;
  if (kind == SpectrumKind::kTable) return interpolated(periods, accelerations, T);
  const double pga = peak_ground_acceleration(), plateau = pga * eta * amplification;
  if (T < TB) return pga + T / TB * (plateau - pga);
  if (T <= TC) return plateau;
  if (T <= TD) return plateau * TC / T;
  return plateau * TC * TD / (T * T);
}

double ElasticSpectrum::displacement(double T) const {
  return acceleration(T) * (T / (2 * std::numbers::pi)) * (T / (2 * std::numbers::pi));
}

double EquivalentSystem::period() const {
  return 2 * std::numbers::pi * std::sqrt(mass / stiffness);
}

// (A.9) to (A.11). Se m* / Fy* equals Sde / dy*, because T* comes from the same m* and k*.
SpectralDemand demand_of(const EquivalentSystem& system, const ElasticSpectrum& spectrum,
                         double scale) {
  const double T = system.period(), dy = system.yield();
  SpectralDemand demand;
  demand.elastic = scale * spectrum.displacement(T);
  demand.q = demand.elastic / dy;
  const bool is_short = T < spectrum.TC;
  demand.displacement =
      !is_short || demand.q <= 1 ? demand.elastic : dy * (1 + (demand.q - 1) * spectrum.TC / T);
  return demand;
}

// (A.12)
double scale_for(const EquivalentSystem& system, const ElasticSpectrum& spectrum,
                 double displacement) {
  const double T = system.period(), dy = system.yield(), elastic = spectrum.displacement(T);
  if (T >= spectrum.TC || displacement <= dy) return displacement / elastic;
  return (1 + (displacement / dy - 1) * T / spectrum.TC) * dy / elastic;
}

double scale_for_q(const EquivalentSystem& system, const ElasticSpectrum& spectrum, double q) {
  return q * system.yield() / spectrum.displacement(system.period());
}

}  // namespace wythe
