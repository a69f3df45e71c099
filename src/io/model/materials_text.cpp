// Output of `wythe materials`: the library and the rules, from the tables that the program itself uses.
#include <cmath>

#include <fmt/format.h>

#include "core/text.h"
#include "io/keys/model_key.h"
#include "materials/circolare.h"
#include "materials/library.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"
#include "wythe/parts/units.h"

namespace wythe {
namespace io {
namespace {

using namespace materials;

std::string number_text(double value) { return fmt::format("{:.6g}", value); }

std::string with_unit(double value, const char* unit) {
  return number_text(value) + (*unit ? fmt::format(" {}", unit) : "");
}

std::string place_of(Role role) {
  if (role == Role::kMasonry) return "masonry";
  return std::string("material.") + (role == Role::kUnit ? "unit" : "joint");
}

std::string list_text() {
  std::string out = "Typical materials: use = \"NAME\" in a material table or in [masonry]\n";
  for (const Entry& entry : library())
    out += fmt::format("  {:<34} {} ({})\n", entry.name, entry.title, entry.source);
  out += "\nRules: KEY = \"rule\" takes the first for a key, KEY = \"rule: NAME\" any\n";
  for (const Rule& rule : rules())
    out += fmt::format("  {:<26} {}.{}: {}\n", rule.name, place_of(rule.role), rule.gives,
                       rule.formula);
  return out + "\nwythe materials NAME explains one of either.\n";
}

// A variable of a study, with the scatter from the source.
std::string variable_text(const Datum& datum) {
  const std::string mean = *datum.unit ? fmt::format("\"{}\"", with_unit(datum.value, datum.unit))
                                       : number_text(datum.value);
  const std::string name =
      datum.role == Role::kUnit ? fmt::format("unit_{}", datum.key) : datum.key;
  return fmt::format(
      "[variable.{}]\npath = \"{}.{}\"\ndistribution = \"lognormal\"\nmean = {}\ncov = {:.2f}\n",
      name, place_of(datum.role), datum.key, mean, cov_of(datum));
}

// The values of a row of Table C8.5.I at each knowledge level, and its coefficients.
std::string levels_text(const Entry& entry) {
  std::string out = fmt::format("\n{:<28} {:>16} {:>16}\n", "by knowledge_level", "LC1", "LC2");
  for (const Datum& datum : entry.data) {
    const auto at = [&](KnowledgeLevel level) {
      return fmt::format("{:.4g}{}{}", take(entry, datum, level, {}, nullptr).value,
                         *datum.unit ? " " : "", datum.unit);
    };
    out += fmt::format("{:<28} {:>16} {:>16}\n", datum.key, at(KnowledgeLevel::kLc1),
                       at(KnowledgeLevel::kLc2));
  }
  out +=
      "strengths divided by 1.35 and 1.20; LC3: the mean updated by [[masonry.test]], 1.00\n"
      "\ncoefficients of Table C8.5.II and its notes\n";
  for (const Correction& c : corrections()) {
    const double mortar = allowed(entry, c, kUnset);
    if (mortar == 0) continue;
    out += fmt::format("{:<28} {:>16}  {}\n", c.key,
                       std::isnan(mortar) ? "fm^0.35" : fmt::format("{:.4g}", mortar), c.meaning);
  }
  return out;
}

std::string entry_text(const Entry& entry) {
  std::string out = fmt::format("{}: {}\nsource: {}\nkind of unit: {}\n", entry.name, entry.title,
                                entry.source, word_of(kUnitTypeWords, entry.unit_type));
  if (*entry.note) out += fmt::format("note: {}\n", entry.note);
  out += fmt::format("\n{:<16} {:<28} {:>16} {:>20} {:>5}\n", "table", "key", "value", "interval",
                     "CoV");
  std::string variables;
  for (const Datum& datum : entry.data) {
    const double cov = cov_of(datum);
    out += fmt::format("{:<16} {:<28} {:>16} {:>20} {:>5}\n", place_of(datum.role), datum.key,
                       with_unit(datum.value, datum.unit),
                       datum.high > datum.low ? fmt::format("{} to {}", number_text(datum.low),
                                                            with_unit(datum.high, datum.unit))
                                              : "",
                       std::isnan(cov) ? "-" : fmt::format("{:.2f}", cov));
    if (cov > 0) variables += (variables.empty() ? "" : "\n") + variable_text(datum);
  }
  if (is_in_table(entry)) out += levels_text(entry);
  if (!variables.empty())
    out +=
        "\nFor a study whose base model holds these (an interval taken as 16 and 84 % "
        "fractiles):\n\n" +
        variables;
  return out;
}

std::string range_text_of(const Bound& bound, const std::vector<ModelKey>& keys) {
  if (*bound.per)
    return fmt::format("{} / {} from {} to {}", bound.input, bound.per, number_text(bound.low),
                       number_text(bound.high));
  for (const ModelKey& key : keys) {
    if (!key.path.ends_with(std::string(".") + bound.input)) continue;
    const double factor = key.si_unit == "1" ? 1 : unit_factor(key.unit, key.si_unit);
    const char* unit = key.unit == "1" ? "" : key.unit.c_str();
    return fmt::format("{} from {} to {}", bound.input, number_text(bound.low / factor),
                       with_unit(bound.high / factor, unit));
  }
  return bound.input;
}

std::string ratios_text() {
  std::string out = fmt::format("\n{:<30} {:>6} {:>6} {:>6} {:>6} {:>6} {:>6}\n", "unit_type", "c2",
                                "CoV", "c1", "K", "alpha", "beta");
  for (const Word<UnitType>& word : kUnitTypeWords)
    if (const auto r = ratios_of(word.value))
      out +=
          fmt::format("{:<30} {:>6.3f} {:>6.2f} {:>6.0f} {:>6.2f} {:>6.2f} {:>6.2f}\n", word.word,
                      r->tension, r->tension_cov, r->stiffness, r->k, r->alpha, r->beta);
  return out;
}

std::string rule_text(const Rule& rule) {
  std::vector<std::string> inputs(rule.inputs.begin(), rule.inputs.end());
  if (rule.by_unit_type) inputs.emplace_back("unit_type");
  std::string out = fmt::format("{}: {}.{}\n{}\nfrom: {}\nsource: {}\n", rule.name,
                                place_of(rule.role), rule.gives, rule.formula,
                                inputs.empty() ? "nothing" : joined(inputs, ", "), rule.source);
  ModelSpec model;
  model.material["joint"] = {};
  const std::vector<ModelKey> keys = number_keys(model);
  for (const Bound& bound : rule.range)
    out += fmt::format("range: {}\n", range_text_of(bound, keys));
  out += rule.cov > 0 ? fmt::format("scatter: CoV {:.2f}\n", rule.cov)
                      : "scatter: none, a definition\n";
  if (rule.by_unit_type && !rule.clay_alone) out += ratios_text();
  return out;
}

}  // namespace
}  // namespace io

std::string materials_text(const std::string& name) {
  if (name.empty()) return io::list_text();
  if (const materials::Entry* entry = materials::entry_of(name)) return io::entry_text(*entry);
  std::vector<std::string> names;
  for (const materials::Rule& rule : materials::rules()) {
    if (rule.name == name) return io::rule_text(rule);
    names.emplace_back(rule.name);
  }
  for (const materials::Entry& entry : materials::library()) names.emplace_back(entry.name);
  const std::string near = nearest_name(name, names);
  throw InputError({{.file = "wythe materials",
                     .value = name,
                     .problem = "no such material or rule",
                     .cure = near.empty() ? "wythe materials lists them"
                                          : fmt::format("did you mean {}?", near)}});
}

}  // namespace wythe
