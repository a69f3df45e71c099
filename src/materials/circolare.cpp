// The figures come from a transcription of the printed pages 257 to 262 of the Circolare (docs/theory/material_rules.md).
#include "materials/circolare.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/elementary.h"

namespace wythe::materials {
namespace {

// f, tau0, fv0, or both E and G.
enum class Parameter { kCompression, kDiagonalShear, kSlidingShear, kModulus };

std::optional<Parameter> parameter_of(std::string_view key) {
  if (key == "masonry_strength") return Parameter::kCompression;
  if (key == "diagonal_shear_strength") return Parameter::kDiagonalShear;
  if (key == "initial_shear_strength") return Parameter::kSlidingShear;
  if (key == "youngs_modulus" || key == "shear_modulus") return Parameter::kModulus;
  return std::nullopt;
}

enum Column { kMortar, kCourses, kTransverse, kInjections, kPlaster, kRepointing, kColumns };
constexpr double kByMortar = -1;  // fm^0.35 of the mortar, if fm exceeds 2 MPa

// A row of Table C8.5.II; 0 stands for a dash.
struct Row {
  const char* name;
  double factor[kColumns];
  double most;  // upper limit of the whole product
};
// clang-format off
constexpr Row kRows[] = {
  {"circolare_rubble",                  {1.5, 1.3, 1.5, 2.0, 2.5, 1.6}, 3.5},
  {"circolare_rough_blocks",            {1.4, 1.2, 1.5, 1.7, 2.0, 1.5}, 3.0},
  {"circolare_split_stone",             {1.3, 1.1, 1.3, 1.5, 1.5, 1.4}, 2.4},
  {"circolare_soft_stone_irregular",    {1.5, 1.2, 1.3, 1.4, 1.7, 1.1}, 2.0},
  {"circolare_soft_stone_regular",      {1.6, 0,   1.2, 1.2, 1.5, 1.2}, 1.8},
  {"circolare_squared_stone",           {1.2, 0,   1.2, 1.2, 1.2, 0},   1.4},
  {"circolare_brick_lime",              {kByMortar, 0, 1.3, 1.2, 1.5, 1.2}, 1.8},
  {"circolare_perforated_brick_cement", {1.2, 0,   0,   0,   1.3, 0},   1.3}};
// clang-format on

const Row* row_of(std::string_view name) {
  for (const Row& row : kRows)
    if (row.name == name) return &row;
  return nullptr;
}

constexpr Correction kCorrections[] = {
    {"good_mortar", Correction::kState, "mortar of good quality; of bricks one above 2 MPa"},
    {"courses", Correction::kState, "levelling courses of brick or squared stone"},
    {"transverse_connection", Correction::kState, "systematic through stones between the leaves"},
    {"injections", Correction::kWork, "injected with binder"},
    {"reinforced_plaster", Correction::kWork, "reinforced plaster, connected through the wall"},
    {"reinforced_repointing", Correction::kWork, "reinforced repointing, leaves connected"},
    {"artificial_headers", Correction::kWork, "artificial through stones, stiff in shear"},
    {"leaf_ties", Correction::kWork, "thin ties through the wall: compression alone"},
    {"poor_mortar", Correction::kFootnote, "mortar below 0.7 MPa: 0.7 on strengths, 0.8 on moduli"},
    {"thick_joints", Correction::kFootnote,
     "bricks with joints above 13 mm: 0.7 on strengths, 0.8 on moduli"},
    {"deep_wedges", Correction::kFootnote,
     "rough blocks with deep stone wedges: 1.2 on strengths"}};

bool is_named(const Correction& c, std::string_view key) { return c.key == key; }

// The value for this parameter of a factor on strengths.
double acting(const Applied& a, Parameter parameter) {
  const std::string_view key = a.correction->key;
  const bool modulus = parameter == Parameter::kModulus;
  if (key == "courses") {
    const bool acts =
        parameter == Parameter::kCompression || parameter == Parameter::kDiagonalShear;
    return acts ? a.factor : 1;
  }
  if (key == "leaf_ties") return parameter == Parameter::kCompression ? a.factor : 1;
  if (key == "transverse_connection" || key == "artificial_headers" || key == "deep_wedges")
    return modulus ? 1 : a.factor;
  if (key == "reinforced_repointing") return modulus ? 1 + (a.factor - 1) / 2 : a.factor;
  if (key == "poor_mortar" || key == "thick_joints") return modulus ? 0.8 : a.factor;
  return a.factor;  // good mortar, injections, plaster: on all parameters
}

struct Product {
  double factor = 1;
  std::string words;
};

// Product of the active factors of one kind, in the order of the table.
Product product_of(std::span<const Applied> applied, Correction::Kind kind, Parameter parameter) {
  Product out;
  for (const Applied& a : applied) {
    const double factor = acting(a, parameter);
    if (a.correction->kind != kind || factor == 1) continue;
    out.factor *= factor;
    out.words += fmt::format(" x {:.4g} {}", factor, a.correction->key);
  }
  return out;
}

// Drops factors that C8.5.3.1 does not allow together.
std::vector<Applied> acting_together(std::span<const Applied> applied, std::string& left_out) {
  std::vector<Applied> out(applied.begin(), applied.end());
  const auto has = [&](std::string_view key) {
    return std::any_of(out.begin(), out.end(),
                       [&](const Applied& a) { return is_named(*a.correction, key); });
  };
  const auto drop = [&](std::string_view key, std::string_view reason) {
    const auto end = std::remove_if(out.begin(), out.end(),
                                    [&](const Applied& a) { return is_named(*a.correction, key); });
    if (end == out.end()) return;
    out.erase(end, out.end());
    left_out += fmt::format(", not {}: {}", key, reason);
  };
  if (has("reinforced_plaster"))
    for (const char* key :
         {"transverse_connection", "reinforced_repointing", "artificial_headers", "leaf_ties"})
      drop(key, "does not act beside reinforced_plaster");
  for (const char* first : {"transverse_connection", "artificial_headers"})
    if (has(first))
      for (const char* second : {"artificial_headers", "leaf_ties"})
        if (std::string_view(first) != second)
          drop(second, fmt::format("the coefficient of {} counts once", first));
  std::vector<const Applied*> states;
  for (const Applied& a : out)
    if (a.correction->kind == Correction::kState) states.push_back(&a);
  if (states.size() > 2) {
    const auto least =
        *std::min_element(states.begin(), states.end(),
                          [](const auto* a, const auto* b) { return a->factor < b->factor; });
    drop(least->correction->key, "the two largest act");
  }
  return out;
}

std::string with_unit(double value, const char* unit) {
  return fmt::format("{:.6g}{}{}", value, *unit ? " " : "", unit);
}

std::string base_words(const Datum& datum, bool is_least) {
  const bool is_interval = datum.high > datum.low;
  return fmt::format("{} {}", is_least && is_interval ? "minimum" : "mean",
                     with_unit(is_least && is_interval ? datum.low : datum.value, datum.unit));
}

struct Method {
  const char* name;
  const char* key;
  double kappa;
};
// Table C8.5.III.
constexpr Method kMethods[] = {{"compression", "youngs_modulus", 1.5},
                               {"compression", "masonry_strength", 1},
                               {"double_flat_jack", "youngs_modulus", 1.5},
                               {"double_flat_jack", "masonry_strength", 2},
                               {"shear_compression", "shear_modulus", 1.5},
                               {"shear_compression", "diagonal_shear_strength", 1},
                               {"shear_compression", "initial_shear_strength", 1},
                               {"diagonal_compression", "shear_modulus", 1.5},
                               {"diagonal_compression", "diagonal_shear_strength", 1},
                               {"joint_shear", "initial_shear_strength", 2},
                               {"constituents", "masonry_strength", 2}};

}  // namespace

double confidence_factor(KnowledgeLevel level) {
  return level == KnowledgeLevel::kLc1 ? 1.35 : level == KnowledgeLevel::kLc2 ? 1.2 : 1.0;
}

std::span<const Correction> corrections() { return kCorrections; }
bool is_in_table(const Entry& entry) { return row_of(entry.name) != nullptr; }

double allowed(const Entry& entry, const Correction& correction, double mortar) {
  const Row* row = row_of(entry.name);
  if (!row) return 0;
  const std::string_view name = entry.name, key = correction.key;
  const bool is_brick = name == "circolare_brick_lime";
  if (key == "good_mortar") {
    if (row->factor[kMortar] != kByMortar) return row->factor[kMortar];
    return mortar > 2e6 ? elementary::pow(mortar / 1e6, 0.35) : std::nan("");
  }
  if (key == "courses") return row->factor[kCourses];
  if (key == "injections") return row->factor[kInjections];
  if (key == "reinforced_plaster") return row->factor[kPlaster];
  if (key == "reinforced_repointing") return row->factor[kRepointing];
  if (key == "poor_mortar") return name == "circolare_perforated_brick_cement" ? 0 : 0.7;
  if (key == "thick_joints") return is_brick ? 0.7 : 0;
  if (key == "deep_wedges") return name == "circolare_rough_blocks" ? 1.2 : 0;
  return row->factor[kTransverse];  // found, or made by artificial headers or ties
}

std::optional<double> kappa_of(std::string_view method, std::string_view key) {
  for (const Method& known : kMethods)
    if (known.name == method && known.key == key) return known.kappa;
  return std::nullopt;
}

std::vector<std::string> methods_of(std::string_view key) {
  std::vector<std::string> out;
  for (const Method& known : kMethods)
    if (known.key == key) out.emplace_back(known.name);
  return out;
}

Taken take(const Entry& entry, const Datum& datum, KnowledgeLevel level,
           std::span<const Applied> applied, const Tests* tests) {
  const auto parameter = parameter_of(datum.key);
  if (!parameter) return {datum.value, base_words(datum, false)};
  const bool is_strength = *parameter != Parameter::kModulus;
  const bool is_least = is_strength && level == KnowledgeLevel::kLc1;
  std::string left_out;
  const std::vector<Applied> together = acting_together(applied, left_out);
  const Product state = product_of(together, Correction::kState, *parameter);
  const Product work = product_of(together, Correction::kWork, *parameter);
  const Product notes = product_of(together, Correction::kFootnote, *parameter);
  // The largest product is listed with the works: it limits state and works together, but not the state alone.
  const double most = row_of(entry.name)->most;
  const double whole = std::max(state.factor, std::min(state.factor * work.factor, most));

  // the existing wall first, then its tests, then the works
  const double base = is_least && datum.high > datum.low ? datum.low : datum.value;
  Taken out{base * notes.factor * state.factor, base_words(datum, is_least)};
  out.way += notes.words + state.words;
  if (tests != nullptr) {
    const double n = tests->number, prior = out.value;
    out.value = (n * tests->mean + tests->kappa * prior) / (n + tests->kappa);
    out.way += fmt::format("; {} tests ({}) of mean {}, kappa {:.4g}: {}", tests->number,
                           tests->method, with_unit(tests->mean, datum.unit), tests->kappa,
                           with_unit(out.value, datum.unit));
  }
  out.value *= whole / state.factor;
  out.way += work.words;
  if (whole < state.factor * work.factor)
    out.way += whole > most ? fmt::format(" (works add nothing beyond {:.4g})", most)
                            : fmt::format(" (together not more than {:.4g})", most);
  if (is_strength) {
    const bool is_tested = level == KnowledgeLevel::kLc3 && tests != nullptr;
    // for LC3 the factor 1.00 holds only for values that were tested
    const double factor = level == KnowledgeLevel::kLc3 && !is_tested
                              ? confidence_factor(KnowledgeLevel::kLc2)
                              : confidence_factor(level);
    out.value /= factor;
    out.way += fmt::format(" / {:.2f}", factor);
    if (level == KnowledgeLevel::kLc3 && !is_tested) out.way += " (not tested)";
  }
  out.way += left_out;
  return out;
}

bool begins_with_table(std::string_view way, const Datum& datum) {
  return way.starts_with(base_words(datum, true)) || way.starts_with(base_words(datum, false));
}

}  // namespace wythe::materials
