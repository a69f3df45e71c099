// From a kind of masonry to fields: strengths scatter, and energies and residual cohesions
// follow them by formulas. Sources of the coefficients of variation: docs/theory/fields.md,
// "Scatter of a masonry". Fields that the model defines are kept. A lognormal strength stays
// between 0.2 and 2.5 times its mean, and a cohesion below the limit of a compression cap.
#include "campaign/draws/scatter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <tuple>

#include "campaign/draws/energies.h"
#include "contact/parameters.h"
#include "core/text.h"
#include "wythe/parts/error.h"
#include "wythe/parts/reading.h"

namespace wythe::study {
namespace {

// Coefficients of variation from unit to unit within a wall. Sources
// and their weak points: docs/theory/fields.md, "Scatter of a masonry".
struct ScatterKind {
  const char* name;
  double joint_tension, joint_cohesion, unit_tension;
};
constexpr ScatterKind kKinds[] = {{"clay_brick", 0.30, 0.25, 0.20},
                                  {"calcium_silicate", 0.30, 0.25, 0.18},
                                  {"stone", 0.40, 0.30, 0.25},
                                  {"tuff", 0.30, 0.25, 0.22}};
constexpr double kTie = 0.7;    // correlation of a joint's cohesion and its tensile strength
constexpr double kLower = 0.2;  // of a lognormal, times the mean
constexpr double kUpper = 2.5;
constexpr double kUnitEnergy = 0.7;  // GI of units goes with ft^0.7 (docs/theory/material_rules.md)
constexpr double kLeastRoom = 1.05;  // limit of the cap over the mean, from which cohesion scatters
constexpr double kBelowCap = 0.95;   // of the largest cohesion that a compression cap allows

class Scatter {
 public:
  Scatter(ModelSpec& spec, const std::function<bool(const std::string&)>& has_places,
          FaultList& faults)
      : spec_(spec), s_(spec.scatter), has_places_(has_places), faults_(faults) {}

  void add() {
    ScatterKind kind{"", 0, 0, 0};
    if (!s_.use.empty()) {
      const auto* found = std::find_if(std::begin(kKinds), std::end(kKinds),
                                       [&](const ScatterKind& k) { return s_.use == k.name; });
      if (found == std::end(kKinds)) return refuse_kind();
      kind = *found;
    }
    if (s_.by == FieldBy::kPlace || s_.by == FieldBy::kCourse)
      return refuse(
          "by", std::string(word_of(kFieldByWords, s_.by)),
          "needs lengths, or courses for joints at beams too, which [scatter] does not have",
          "write by = \"unit\" or \"joint\", or a [field.<name>] of its own");
    for (const auto& [key, name, usual] :
         {std::tuple("joint", s_.joint, "joint"), {"unit", s_.unit, "unit"}})
      if (name != usual && material(name) == nullptr) {
        std::vector<std::string> names;
        for (const auto& [known, law] : spec_.material) names.push_back(known);
        return refuse(key, name, "is no material of the model", name_advice(name, names));
      }
    const auto or_own = [](double own, double of_kind) { return std::isnan(own) ? of_kind : own; };
    add_joints(or_own(s_.joint_tension, kind.joint_tension),
               or_own(s_.joint_cohesion, kind.joint_cohesion));
    add_units(or_own(s_.unit_tension, kind.unit_tension));
    if (added_ == 0)
      refuse("", "", "changes nothing: no joint of this wall has a strength that scatters",
             fmt::format(
                 "give material.{} a tensile strength or a cohesion, name the joints' material as "
                 "scatter.joint, or leave [scatter] out",
                 s_.joint));
  }

 private:
  void refuse(const std::string& key, const std::string& value, const std::string& problem,
              const std::string& cure) {
    faults_.add({"", key.empty() ? "scatter" : "scatter." + key, value, problem, cure, 0});
  }
  void refuse_kind() {
    std::vector<std::string> names;
    for (const ScatterKind& kind : kKinds) names.emplace_back(kind.name);
    refuse("use", s_.use, "is no kind of masonry whose scatter is known",
           name_advice(s_.use, names));
  }

  [[nodiscard]] const JointMaterial* material(const std::string& name) const {
    const auto found = spec_.material.find(name);
    return found == spec_.material.end() ? nullptr : &found->second;
  }
  [[nodiscard]] static bool scatters(double mean) { return mean > 0 && std::isfinite(mean); }

  // Whether another field sets the key; it then takes precedence.
  [[nodiscard]] bool has_own(const std::string& name, const std::string& path) const {
    return std::any_of(spec_.field.begin(), spec_.field.end(), [&](const auto& field) {
      return field.first != name && field.second.path == path;
    });
  }

  // The field for one key, "scatter_joint_tensile_strength"; null where the model has its own field.
  FieldSpec* field(const std::string& role, const std::string& name, const char* key) {
    const std::string own = fmt::format("{}{}_{}", kScatterPrefix, role, key);
    const std::string path = fmt::format("material.{}.{}", name, key);
    if (has_own(own, path) || !has_places_(path)) return nullptr;
    FieldSpec& f = spec_.field[own];
    if (f.path.empty()) f.path = path;
    ++added_;
    return &f;
  }
  std::string scattered(const std::string& role, const std::string& name, const char* key,
                        double cov, DistributionKind distribution, double upper) {
    if (!(cov > 0)) return "";
    FieldSpec* f = field(role, name, key);
    if (f == nullptr || !f->formula.empty()) return "";  // the model's own formula is kept
    const bool says_scatter = !std::isnan(f->cov);       // the model changes this field
    if (!says_scatter) {
      f->cov = cov;
      f->distribution = distribution;
    }
    if (f->by == FieldBy::kPlace && std::isnan(f->along) && std::isnan(f->across)) f->by = s_.by;
    const bool lognormal = f->distribution == DistributionKind::kLognormal;
    if (lognormal && std::isnan(f->lower) && std::isnan(f->upper))
      f->lower = kLower, f->upper = upper;
    if (f->seed == 0) f->seed = s_.seed;
    return fmt::format("{}{}_{}", kScatterPrefix, role, key);
  }
  void follows(const std::string& role, const std::string& name, const char* key,
               const std::string& formula) {
    FieldSpec* f = field(role, name, key);
    if (f != nullptr && f->formula.empty() && std::isnan(f->cov)) f->formula = formula;
  }

  void add_joints(double tension, double cohesion) {
    const JointMaterial* found = material(s_.joint);
    if (found == nullptr) return;
    const JointMaterial m = *found;
    std::string ft, c;
    if (scatters(m.tensile_strength))
      ft = scattered("joint", s_.joint, "tensile_strength", tension, DistributionKind::kWeibull,
                     kUnset);
    if (scatters(m.cohesion) && most_cohesion(m) > kLeastRoom)
      c = scattered("joint", s_.joint, "cohesion", cohesion, DistributionKind::kLognormal,
                    most_cohesion(m));
    if (!ft.empty() && !c.empty() && spec_.field[c].correlation.empty() &&
        spec_.field[ft].correlation.empty())
      spec_.field[c].correlation[ft].gaussian = kTie;
    if (!ft.empty() && scatters(m.mode_1_energy))
      follows("joint", s_.joint, "mode_1_energy",
              tension_energy(
                  fmt::format("{:.17g} m * {}", m.mode_1_energy / m.tensile_strength, ft), ft, m));
    if (!c.empty())
      follow_cohesion("joint", s_.joint, m, c,
                      fmt::format("{:.17g} m * {}", m.mode_2_energy / m.cohesion, c));
  }

  // Makes GII and the residual cohesion follow the cohesion field `c`.
  void follow_cohesion(const std::string& role, const std::string& name, const JointMaterial& m,
                       const std::string& c, const std::string& proportional) {
    if (scatters(m.residual_cohesion))
      follows(role, name, "residual_cohesion",
              fmt::format("{:.17g} * {}", m.residual_cohesion / m.cohesion, c));
    if (scatters(m.mode_2_energy) && contact::greatest_drop(m) > 0)
      follows(role, name, "mode_2_energy", slip_energy(proportional, c, m));
  }

  // The largest cohesion under a compression cap, as a multiple of its mean.
  static double most_cohesion(const JointMaterial& m) {
    if (!(m.compression_cap > 0)) return kUpper;
    const double most =
        kBelowCap * m.compressive_strength / std::sqrt(m.compression_cap) / m.cohesion;
    return std::min(kUpper, most);
  }

  void add_units(double tension) {
    const JointMaterial* found = material(s_.unit);
    if (found == nullptr || !scatters(found->tensile_strength)) return;
    const JointMaterial m = *found;
    const std::string ft = scattered("unit", s_.unit, "tensile_strength", tension,
                                     DistributionKind::kLognormal, kUpper);
    if (ft.empty()) return;
    const std::string power =
        fmt::format("({} / {:.17g} Pa) ^ {:g}", ft, m.tensile_strength, kUnitEnergy);
    if (scatters(m.mode_1_energy))
      follows("unit", s_.unit, "mode_1_energy",
              tension_energy(fmt::format("{:.17g} N/m * {}", m.mode_1_energy, power), ft, m));
    if (!scatters(m.cohesion)) return;
    std::string c = fmt::format("{:.17g} * {}", m.cohesion / m.tensile_strength, ft);
    if (m.compression_cap > 0)
      c = fmt::format("min({}, {:.17g} Pa)", c, most_cohesion(m) * m.cohesion);
    follows("unit", s_.unit, "cohesion", c);
    follow_cohesion("unit", s_.unit, m, "(" + c + ")",
                    fmt::format("{:.17g} N/m * {}", m.mode_2_energy, power));
  }

  ModelSpec& spec_;
  const ScatterSpec& s_;
  const std::function<bool(const std::string&)>& has_places_;
  FaultList& faults_;
  int added_ = 0;
};

}  // namespace

void add_scatter(ModelSpec& spec, const std::function<bool(const std::string& path)>& has_places,
                 FaultList& faults) {
  if (spec.scatter.is_asked()) Scatter(spec, has_places, faults).add();
}

std::vector<Message> notes_of_scatter(const ModelSpec& spec) {
  std::vector<Message> notes;
  const auto has_field = [&](const std::string& path) {
    return std::any_of(spec.field.begin(), spec.field.end(),
                       [&](const auto& field) { return field.second.path == path; });
  };
  using Followers = std::vector<std::pair<const char*, double JointMaterial::*>>;
  using M = JointMaterial;
  const ScatterSpec& s = spec.scatter;
  const auto look = [&](const std::string& role, const std::string& strength, double cov,
                        const Followers& followers) {
    const bool is_drawn = std::isnan(cov) ? !s.use.empty() : cov > 0;
    if (!is_drawn) return;
    const std::string& material = role == "joint" ? s.joint : s.unit;
    const auto law = spec.material.find(material);
    if (law == spec.material.end()) return;
    const std::string own = kScatterPrefix + role + '_' + strength,
                      table = "material." + material + '.';
    for (const auto& [name, field] : spec.field) {
      if (field.path != table + strength || (name == own && field.formula.empty())) continue;
      std::vector<std::string> alone;
      for (const auto& [key, value] : followers)
        if (law->second.*value > 0 && !has_field(table + key)) alone.push_back(table + key);
      if (!alone.empty())
        notes.push_back(
            {"field.alone", {{"field", name}, {"keys", joined(alone, ", ")}, {"name", own}}});
    }
  };
  look("joint", "tensile_strength", s.joint_tension, {{"mode_1_energy", &M::mode_1_energy}});
  look("joint", "cohesion", s.joint_cohesion,
       {{"mode_2_energy", &M::mode_2_energy}, {"residual_cohesion", &M::residual_cohesion}});
  look("unit", "tensile_strength", s.unit_tension,
       {{"mode_1_energy", &M::mode_1_energy},
        {"cohesion", &M::cohesion},
        {"mode_2_energy", &M::mode_2_energy},
        {"residual_cohesion", &M::residual_cohesion}});
  return notes;
}

namespace {

constexpr double kFewer = 0.5, kMore = 2.5;  // times the scatter of tests: limits of "unusual"

// Coefficient of variation within a wall that the model gives for a key.
double stated_scatter(const ModelSpec& spec, const std::string& path) {
  for (const auto& [name, field] : spec.field) {
    if (field.path != path) continue;
    if (!std::isnan(field.cov)) return field.cov;
    double sum = 0, squares = 0;  // for a formula or between bounds, from the values drawn
    for (const double x : field.drawn) sum += x, squares += x * x;
    const double n = static_cast<double>(field.drawn.size()), mean = sum / n;
    return mean > 0 ? std::sqrt(std::fmax(0, squares / n - mean * mean)) / mean : 0;
  }
  return 0;
}

}  // namespace

std::vector<OddScatter> odd_scatter(const ModelSpec& spec, const Model& model, double between) {
  std::vector<OddScatter> out;
  const double b = std::isnan(between) ? 0 : between;
  const auto look = [&](const char* words, const std::string& material, const char* key,
                        double JointMaterial::*mean, double ScatterKind::*tested) {
    const auto found = spec.material.find(material);
    if (found == spec.material.end() || !(found->second.*mean > 0) ||
        std::isinf(found->second.*mean))
      return;
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (const ScatterKind& kind : kKinds) {
      if (!spec.scatter.use.empty() && spec.scatter.use != kind.name) continue;
      least = std::fmin(least, kind.*tested), most = std::fmax(most, kind.*tested);
    }
    const double w = stated_scatter(spec, fmt::format("material.{}.{}", material, key));
    const double total = std::sqrt((1 + w * w) * (1 + b * b) - 1);
    if (total < kFewer * least)
      out.push_back({words, total, least});
    else if (w > kMore * most)
      out.push_back({words, total, most});
  };
  look("verdict.scatter.joint_tension", spec.scatter.joint, "tensile_strength",
       &JointMaterial::tensile_strength, &ScatterKind::joint_tension);
  look("verdict.scatter.joint_cohesion", spec.scatter.joint, "cohesion", &JointMaterial::cohesion,
       &ScatterKind::joint_cohesion);
  if (has_unit_planes(model))
    look("verdict.scatter.unit_tension", spec.scatter.unit, "tensile_strength",
         &JointMaterial::tensile_strength, &ScatterKind::unit_tension);
  return out;
}

}  // namespace wythe::study
