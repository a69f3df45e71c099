// resolve_materials: values by rule and typical values are put into the tree before it is read.
//
//   [masonry] unit_strength = "15 MPa"           what tests say
//   [material.unit] tensile_strength = "rule"  ─► "0.6 MPa", and a line of `origin` with the rule
//
// So the reader finds plain values, a setting (--set, a study) changes the inputs of rules, and
// model.used.toml can be run again without rules or library. A value is searched in this order: the table
// itself, [masonry], `use` of the table, `use` of [masonry]. A value is derived only if the file asks for it.
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "core/elementary.h"
#include "core/number.h"
#include "core/text.h"
#include "io/model/office.h"
#include "io/text/magnitude.h"
#include "io/text/stated_units.h"
#include "io/text/toml_reader.h"
#include "materials/library.h"
#include "materials/origin.h"
#include "units/quantity_error.h"
#include "wythe/parts/units.h"

namespace wythe::io {
namespace {

using materials::Datum;
using materials::Entry;
using materials::kind_word;
using materials::Origin;
using materials::origin_of;
using materials::Role;
using materials::Rule;
using materials::to_text;

constexpr const char* kEnergyPerPressure =
    "mode_2_energy_per_pressure";  // a law that does without has none: 0

using Keys = std::map<std::string, Key, std::less<>>;

// Collects the quantities and numbers of a described struct.
class KeyCollector {
 public:
  explicit KeyCollector(Keys& out) : out_(out) {}
  void quantity(const char* name, const double&, const Key& key) { out_[name] = key; }
  void number(const char* name, const double&, const Key& key) { out_[name] = key; }
  void texts(const char*, const std::vector<std::string>&, const Key&) {}
  template <class E, std::size_t N>
  void choice(const char*, const E&, const Word<E> (&)[N], const Key&) {}

 private:
  Keys& out_;
};

template <class T>
const Keys& keys_of() {
  static const Keys keys = [] {
    Keys out;
    KeyCollector collector(out);
    T described;
    describe(collector, described);
    return out;
  }();
  return keys;
}

std::string shown_value(double value, const Key& key) {
  return *key.unit ? format_quantity(value, key.unit, key.shown) : fmt::format("{}", value);
}

// Six digits are more than any rule or test has. Angles keep fifteen, because
// a residual angle must not be rounded to a larger value than its peak.
double rounded(double value, const Key& key) {
  if (!std::isfinite(value)) return value;
  const int digits = std::string_view(key.unit) == "rad" ? 15 : 6;
  if (!*key.unit) return *parse_number(fmt::format("{:.{}g}", value, digits));
  const double shown = value / unit_factor(key.shown, key.unit);
  return parse_quantity(fmt::format("{:.{}g} {}", shown, digits, key.shown), key.unit);
}

// The value of a rule; an input that it passes on is not rounded.
double value_by(const Rule& rule, const materials::Inputs& inputs, const Key& key) {
  const double value = rule.value(inputs);
  const auto& in = inputs.value;
  return std::find(in.begin(), in.end(), value) != in.end() ? value : rounded(value, key);
}

// A value for a message: four digits are enough.
std::string brief(double value, const Key& key) {
  if (!std::isfinite(value)) return "unlimited";
  if (!*key.unit) return fmt::format("{:.4g}", value);
  return fmt::format("{:.4g} {}", value / unit_factor(key.shown, key.unit), key.shown);
}

bool asks_for_rule(const toml::node* node) {
  const auto* text = node ? node->as_string() : nullptr;
  return text && (text->get() == "rule" || text->get().starts_with("rule:"));
}

// A value and its origin in words.
struct Found {
  double value = kUnset;
  std::string from;      // " (typical of clay_brick_old)", "" where given
  bool spoiled = false;  // its own fault is reported elsewhere
  [[nodiscard]] bool known() const { return !std::isnan(value); }
};

// One table being processed: [masonry] or [material.<name>].
struct Table {
  std::string path;
  toml::table* toml = nullptr;
  Role role = Role::kMasonry;
  const Keys* keys = nullptr;
  const Entry* use = nullptr;
  bool missing = false;  // fill every missing key by its rule
  std::map<std::string, Found, std::less<>> done = {};
  std::set<std::string, std::less<>> under_way = {};
  std::vector<std::string> origin = {};
};

class Resolver {
 public:
  Resolver(ReadContext& context, toml::table& root) : context_(context), root_(root) {}

  void run() {
    toml::node* masonry = root_.get("masonry");
    masonry_ = Table{"masonry", masonry ? masonry->as_table() : nullptr, Role::kMasonry,
                     &keys_of<MasonrySpec>()};
    if (masonry_.toml) parse_recipes(masonry_);
    if (masonry_.toml)
      office_ = parse_office(context_, *masonry_.toml, masonry_.use, use_is_wrong_);
    use_is_wrong_ = use_is_wrong_ || lacks_typology();
    std::vector<Table> laws;
    toml::node* materials = root_.get("material");
    if (materials && materials->is_table())
      for (auto&& [name, node] : *materials->as_table())
        if (toml::table* table = node.as_table()) laws.push_back(law_table(name.str(), *table));
    for (Table& law : laws) parse_recipes(law);
    for (const Table& law : laws) refuse_undivided(law);
    for (const Table& law : laws)
      if (law.toml->contains("head_joint_bond") && !has_beds_of(root_, name_of(law)))
        fault(law, "head_joint_bond", "has no effect: no bed joints are of this material",
              "name the material as joint of the wall, a storey or a region, or leave this out");
    state_confidence_factor();
    for (Table& law : laws) fill(law);
    fill_densities();
    if (masonry_.toml) fill_masonry();
    tell_undivided();
    for (Table& law : laws) confirm(law);
    if (masonry_.toml) confirm(masonry_);
    refuse_idle_level();
    refuse_outside();
    refuse_idle_overrides();
  }

 private:
  Table law_table(std::string_view name, toml::table& table) const {
    const Role role = is_unit_joint(root_, name) ? Role::kUnit : Role::kJoint;
    return {"material." + std::string(name), &table, role, &keys_of<JointMaterial>()};
  }

  static std::string name_of(const Table& law) {
    return law.path.substr(std::string("material.").size());
  }

  void fault(const Table& table, const std::string& key, const std::string& problem,
             const std::string& cure) {
    const toml::node* node = table.toml ? table.toml->get(key) : nullptr;
    const int line =
        node && line_of(*node) ? line_of(*node) : (table.toml ? line_of(*table.toml) : 0);
    context_.fault(under(table.path, key), line, node ? shown(*node) : "", problem, cure);
  }

  // --- use, missing, tangents --------------------------------------------------------------------

  void parse_recipes(Table& table) {
    if (const toml::node* use = table.toml->get("use")) {
      table.use = entry_named(table, *use);
      use_is_wrong_ = use_is_wrong_ || !table.use;
      table.toml->erase("use");  // its fault is reported above
    }
    if (table.role == Role::kMasonry) return;
    if (const toml::node* missing = table.toml->get("missing")) {
      const auto* word = missing->as_string();
      table.missing = word && word->get() == "rule";
      if (!table.missing) fault(table, "missing", "must be \"rule\"", "write missing = \"rule\"");
      table.missing = true;  // intended: else each value by rule would be reported as missing
      table.toml->erase("missing");
    }
    for (const char* key : {"friction", "residual_friction"}) parse_tangent(table, key);
  }

  const Entry* entry_named(const Table& table, const toml::node& use) {
    const auto* name = use.as_string();
    const Entry* entry = name ? materials::entry_of(name->get()) : nullptr;
    if (entry) return entry;
    std::vector<std::string> names, alike;
    for (const Entry& known : materials::library()) {
      names.emplace_back(known.name);
      if (name && !name->get().empty() && names.back().find(name->get()) != std::string::npos)
        alike.push_back(names.back());
    }
    const bool ambiguous = alike.size() > 1;
    fault(table, "use", ambiguous ? "is the name of several materials" : "no such material",
          ambiguous      ? "write one of: " + joined(alike, ", ")
          : alike.size() ? fmt::format("did you mean {}?", alike.front())
          : name         ? name_advice(name->get(), names)
                         : "write e.g. use = \"circolare_brick_lime\"");
    return nullptr;
  }

  static bool is_angle(const toml::node& node) {
    try {
      return node.is_string() && std::isfinite(parse_quantity(node.as_string()->get(), "rad"));
    } catch (const std::invalid_argument&) {
      return false;
    }
  }

  void parse_tangent(Table& table, const std::string& stem) {
    const std::string tangent = stem + "_tan", angle = stem + "_angle";
    const toml::node* node = table.toml->get(tangent);
    if (!node) return;
    const auto value = node->is_number() ? node->value<double>() : std::nullopt;
    if (table.toml->contains(angle)) {
      fault(table, tangent, fmt::format("stands beside {}", angle),
            "leave one of the two: a tangent, or an angle");
    } else if (!value || !std::isfinite(*value) || *value < 0) {
      fault(table, tangent, "must be a number, at least 0, without quotes",
            is_angle(*node) ? fmt::format("write {} = \"{}\"", angle, shown(*node))
                            : fmt::format("write e.g. {} = 0.6", tangent));
      spoiled_.insert(under(table.path, angle));
      context_.follow_ups.insert(under(table.path, angle));
    } else {
      put(table, angle, rounded(elementary::atan(*value), table.keys->at(angle)), Origin::kGiven,
          fmt::format("as {} {}", tangent, *value));
    }
    table.toml->erase(tangent);
  }

  // --- a knowledge level ---------------------------------------------------------------------------

  // Refuses a second typology beside a knowledge level, because its values would not be divided.
  void refuse_undivided(const Table& law) {
    if (!office_.is_asked() || !law.use || law.use == masonry_.use) return;
    fault(
        law, "use",
        fmt::format("stands undivided beside masonry.knowledge_level {}", office_.word()),
        fmt::format("give this material its values: wythe materials {} prints them for each level",
                    law.use->name));
  }

  // Whether [masonry] has a knowledge level without its typology. This is reported, and values that depend on it are no further fault.
  [[nodiscard]] bool lacks_typology() const {
    return masonry_.toml && !masonry_.use && context_.has_fault_at("masonry.knowledge_level");
  }

  // Values given beside a level stay as they are: a line of origin and a note give the value that the level would take.
  void tell_undivided() {
    if (!masonry_.toml || !masonry_.use || !office_.is_asked()) return;
    for (const Datum& datum : masonry_.use->data) {
      if (datum.role != Role::kMasonry ||
          context_.derived.contains(under(masonry_.path, datum.key)))
        continue;
      const Found found = given(masonry_, datum.key);
      const std::string way = office_.taken(*masonry_.use, datum).way;
      const bool is_changed =
          way.find(" / ") != std::string::npos || way.find(" x ") != std::string::npos;
      if (found.known() && is_changed)
        masonry_.origin.push_back(to_text(
            {datum.key, shown_value(found.value, masonry_.keys->at(datum.key)), Origin::kGiven,
             materials::kBesideLevel + office_.word() + materials::kNot + way}));
    }
  }

  void state_confidence_factor() {
    toml::node* node = root_.get("assessment");
    toml::table* table = node ? node->as_table() : nullptr;
    if (!office_.is_asked() || !table) return;
    const double factor = materials::confidence_factor(office_.level);
    const toml::node* stated = table->get("confidence_factor");
    if (!stated) {
      table->insert("confidence_factor", factor);
      context_.derived["assessment.confidence_factor"] = {"of masonry.knowledge_level",
                                                          line_of(*table)};
    } else if (stated->value<double>() != factor) {
      context_.fault(
          "assessment.confidence_factor", line_of(*stated), shown(*stated),
          fmt::format("masonry.knowledge_level {} divides by {:.2f}", office_.word(), factor),
          "leave it out: the program takes that of the level");
    }
  }

  // `density = "rule"` of units takes the density of the masonry.
  void fill_densities() {
    std::vector<std::pair<std::string, toml::table*>> parts;
    if (toml::table* wall = root_["wall"].as_table()) parts.emplace_back("wall", wall);
    for (const char* list : {"storey", "plan_wall"})
      if (toml::array* array = root_[list].as_array())
        for (std::size_t i = 0; i < array->size(); ++i)
          if (toml::table* part = array->get(i)->as_table())
            parts.emplace_back(fmt::format("{}.{}", list, i), part);
    for (auto& [path, part] : parts) {
      toml::table* unit = part->contains("unit") ? part->get("unit")->as_table() : nullptr;
      toml::node* node = unit ? unit->get("density") : nullptr;
      if (!asks_for_rule(node)) continue;
      Found found{kUnset, "", true};
      const bool has_weight = masonry_.toml && (masonry_.toml->contains("density") ||
                                                input(masonry_, "weight").known());
      if (has_weight) {
        if (!masonry_.toml->contains("density")) masonry_.toml->insert("density", "rule");
        context_.asked.insert("density");
        found = value_of(masonry_, "density");
      } else if (!use_is_wrong_) {
        context_.fault(
            path + ".unit.density", line_of(*node), "rule", "needs the weight of the masonry",
            "give the density, or weight, density or use = \"circolare_...\" under [masonry]");
      }
      // a valid text, because the fault is reported
      *node->as_string() = format_quantity(found.known() ? found.value : 1000, "kg/m^3", "kg/m^3");
    }
  }

  // --- values ------------------------------------------------------------------------------------

  void put(Table& table, const std::string& key, double value, Origin::Kind kind,
           const std::string& by) {
    const Key& known = table.keys->at(key);
    const std::string text = shown_value(value, known);
    toml::node* node = table.toml->get(key);
    if (auto* old = node ? node->as_string() : nullptr; old && *known.unit)
      *old = text;  // keeps the line of the key
    else if (*known.unit)
      table.toml->insert_or_assign(key, text);
    else
      table.toml->insert_or_assign(key, value);
    const Origin origin{key, text, kind, by};
    table.origin.push_back(to_text(origin));
    context_.derived[under(table.path, key)] = {kind_word(kind) + " " + by, line_of(*table.toml)};
  }

  // The value in the table; none where the table asks for a rule or has no value.
  Found given(const Table& table, const std::string& key) {
    Found out;
    const toml::node* node = table.toml ? table.toml->get(key) : nullptr;
    if (!node || asks_for_rule(node)) return out;
    const Key& known = table.keys->at(key);
    const auto* text = node->as_string();
    try {
      if (!*known.unit && node->is_number())
        out.value = *node->value<double>();
      else if (text && known.may_be_unlimited && trimmed(text->get()) == "unlimited")
        out.value = kUnlimited;
      else if (text)
        out.value = parse_quantity(text->get(), known.unit);
    } catch (const std::invalid_argument&) {
    }
    out.spoiled = !out.known() || !known.range.holds(out.value) ||
                  (std::isfinite(out.value) && !magnitude_problem(out.value, known.unit).empty());
    return out;
  }

  static double value_of_datum(const Datum& datum, const Key& key) {
    const double factor = *datum.unit ? unit_factor(datum.unit, key.unit) : 1;
    return rounded(datum.value * factor, key);
  }

  Found typical(const Table& table, const Entry* entry, Role role, const std::string& key) const {
    const Datum* datum = entry ? materials::datum_of(*entry, role, key) : nullptr;
    if (!datum) return {};
    const Key& known = table.keys->at(key);
    if (role == Role::kMasonry && entry == masonry_.use && office_.is_asked())
      return {value_of_datum({.role = role,
                              .key = datum->key,
                              .unit = datum->unit,
                              .value = office_.taken(*entry, *datum).value},
                             known),
              fmt::format(" (typical of {} at {})", entry->name, office_.word())};
    return {value_of_datum(*datum, known), fmt::format(" (typical of {})", entry->name)};
  }

  // A value of [masonry] for `table`.
  Found masonry(Table& table, const std::string& key) {
    context_.asked.insert(key);
    Found out = masonry_.toml ? value_of(masonry_, key) : Found{};
    if (!out.known() && !out.spoiled) out = from_wall(table, key);
    if (out.known() || out.spoiled) return out;
    out = typical(masonry_, table.use, Role::kMasonry, key);
    return out.known() ? out : typical(masonry_, masonry_.use, Role::kMasonry, key);
  }

  // Sizes of units in the storeys with this material.
  Found from_wall(const Table& table, const std::string& key) {
    const bool is_law = table.role != Role::kMasonry;
    const std::vector<StatedSize> sizes = stated_sizes(root_, is_law ? name_of(table) : "", key);
    if (sizes.empty()) return {};
    if (sizes.size() == 1)
      return {sizes[0].value, fmt::format(" ({})", sizes[0].path), !kLength.holds(sizes[0].value)};
    const Key& known = masonry_.keys->at(key);
    context_.fault(
        table.path, table.toml ? line_of(*table.toml) : 0, "",
        fmt::format("its rules ask for {}, and storeys that have it differ: {} in {}, {} "
                    "in {}",
                    key, brief(sizes[0].value, known), sizes[0].path, brief(sizes[1].value, known),
                    sizes[1].path),
        fmt::format("give each storey joints of its own (storey.joint), or {} under "
                    "[masonry]",
                    key));
    return {kUnset, "", true};
  }

  // Whether the reader will refuse unit_type.
  [[nodiscard]] bool has_wrong_unit_type() const {
    const toml::node* node = masonry_.toml ? masonry_.toml->get("unit_type") : nullptr;
    const auto word = node ? node->value<std::string>() : std::nullopt;
    return node && std::none_of(std::begin(kUnitTypeWords), std::end(kUnitTypeWords),
                                [&](const auto& known) { return word == known.word; });
  }

  UnitType unit_type(const Table& table) {
    context_.asked.insert("unit_type");
    return type_of(table);
  }
  [[nodiscard]] UnitType type_of(const Table& table) const {
    if (masonry_.toml)
      if (const auto word = (*masonry_.toml)["unit_type"].value<std::string>())
        for (const auto& known : kUnitTypeWords)
          if (known.word == *word) return known.value;
    if (table.use) return table.use->unit_type;
    return masonry_.use ? masonry_.use->unit_type : UnitType::kUnstated;
  }

  // A key of the table; derived first where the table asks for that.
  Found value_of(Table& table, const std::string& key) {
    if (const auto known = table.done.find(key); known != table.done.end()) return known->second;
    if (spoiled_.contains(under(table.path, key))) return {kUnset, "", true};
    const toml::node* node = table.toml->get(key);
    Found found;
    if (asks_for_rule(node)) {
      found = by_rule(table, key, *node);
    } else if (node) {
      found = given(table, key);
    } else if (table.role != Role::kMasonry) {
      found = unstated(table, key);
    }
    table.done[key] = found;
    return found;
  }

  // A key that a law does not give: typical, or by definition from typical values, or by rule.
  Found unstated(Table& table, const std::string& key) {
    if (!is_law_key(key)) return {};
    Found found = typical(table, table.use, table.role, key);
    if (found.known()) {
      put(table, key, found.value, Origin::kTypical, described(*table.use, table.role, key));
      return found;
    }
    const Rule* rule = materials::rule_for(table.role, key);
    const bool definition = rule && rule->cov == 0 && rule->inputs.size() == 1;
    if (rule && rule->on_request) return {};
    if (key == "compressive_energy" && std::isinf(value_of(table, "compressive_strength").value))
      return {};  // a joint that never crushes needs none
    if (key == "head_joint_bond" && !has_heads_of_beds(root_, name_of(table))) return {};
    if (rule && key == kEnergyPerPressure && !takes_energy_per_pressure(table, *rule)) return {};
    if (rule && (table.missing || (table.use && definition && can_follow(table, *rule))))
      return follow(table, key, *rule);
    return {};
  }

  // b belongs to a GII from its first rule; any other GII holds for the pressures of its tests. It comes from
  // mortar on clay. Where `missing` asks for b and only GII is against it, a line of origin and a note say so.
  bool takes_energy_per_pressure(Table& table, const Rule& rule) {
    const std::string other = energy_otherwise(table);
    if (!other.empty() && !table.missing) return false;
    const bool holds =
        materials::holds_for(rule, other.empty() ? unit_type(table) : type_of(table)) &&
        value_of(table, "cohesion").value > 0;
    if (holds && !other.empty())
      table.origin.push_back(
          to_text({kEnergyPerPressure, shown_value(0, table.keys->at(kEnergyPerPressure)),
                   Origin::kGiven, materials::kAsEnergyIs + other}));
    return holds && other.empty();
  }

  // The origin of GII where it is not its first rule; else "". Its own value is searched before b.
  std::string energy_otherwise(const Table& table) const {
    const std::string key = "mode_2_energy";
    const toml::node* node = table.toml->get(key);
    if (!node)
      return typical(table, table.use, table.role, key).known()
                 ? materials::kTypicalOf + std::string(table.use->name)
                 : "";
    if (asks_for_rule(node)) {
      const Rule* asked = rule_asked(table, key, *node);
      if (asked == materials::rule_for(table.role, key)) return "";
      return materials::kBy + std::string(asked ? asked->name : "");
    }
    for (const std::string& line : table.origin)
      if (const auto origin = origin_of(line); origin && origin->key == key)
        return (origin->kind == Origin::kTypical ? materials::kTypicalOf : materials::kBy) +
               name_in(*origin);
    return "stated";
  }

  bool can_follow(Table& table, const Rule& rule) {
    return std::all_of(rule.inputs.begin(), rule.inputs.end(),
                       [&](const char* name) { return input(table, name).known(); });
  }

  std::string described(const Entry& entry, Role role, const std::string& key) const {
    if (role == Role::kMasonry && &entry == masonry_.use && office_.is_asked())
      return fmt::format("of {} at {} ({}): {}", entry.name, office_.word(), entry.source,
                         office_.taken(entry, *materials::datum_of(entry, role, key)).way);
    const double cov = materials::cov_of(*materials::datum_of(entry, role, key));
    return fmt::format("of {} ({}{})", entry.name, entry.source,
                       std::isnan(cov) ? "" : fmt::format(", CoV {:.2f}", cov));
  }

  // --- rules -------------------------------------------------------------------------------------

  // The rule asked for by "rule" or "rule: NAME"; null where there is none.
  static const Rule* rule_asked(const Table& table, const std::string& key,
                                const toml::node& node) {
    const std::string text = node.as_string()->get();
    const std::string name(trimmed(text == "rule" ? "" : std::string_view(text).substr(5)));
    return materials::rule_for(table.role, key, name);
  }

  Found by_rule(Table& table, const std::string& key, const toml::node& node) {
    const Rule* rule = rule_asked(table, key, node);
    if (rule) return follow(table, key, *rule);
    std::vector<std::string> names;
    for (const Rule& other : materials::rules())
      if (other.role == table.role && key == other.gives) names.emplace_back(other.name);
    if (names.empty())
      fault(table, key, "there is no rule for it", "give the value");
    else
      fault(table, key, "no such rule for it",
            "write \"rule\", or one of: rule: " + joined(names, ", rule: "));
    is_follow_up(table, key);
    return {kUnset, "", true};
  }

  // An input of a rule: a key of the law itself, or of [masonry].
  Found input(Table& table, const std::string& name) {
    const bool own = table.role == Role::kMasonry || is_law_key(name);
    if (!own) return masonry(table, name);
    if (table.under_way.contains(name)) return {kUnset, "", true};
    if (table.role != Role::kMasonry) {
      Found found = value_of(table, name);
      if (name == kEnergyPerPressure && !found.known() && !found.spoiled) found.value = 0;
      return found;
    }
    context_.asked.insert(name);
    Found found = value_of(table, name);
    if (!found.known() && !found.spoiled) found = from_wall(table, name);
    if (found.known() || found.spoiled) return found;
    return typical(masonry_, masonry_.use, Role::kMasonry, name);
  }

  Found follow(Table& table, const std::string& key, const Rule& rule) {
    table.under_way.insert(key);
    materials::Inputs inputs{{}, rule.by_unit_type ? unit_type(table) : UnitType::kUnstated};
    std::vector<std::string> lacking, from;
    bool spoiled = false;
    for (const char* name : rule.inputs) {
      const Found found = input(table, name);
      spoiled = spoiled || found.spoiled;
      if (!found.known() && !found.spoiled) lacking.emplace_back(name);
      inputs.value.push_back(found.value);
      from.push_back(fmt::format("{} {}{}", name, shown_value(found.value, key_named(table, name)),
                                 found.from));
    }
    table.under_way.erase(key);
    if (rule.by_unit_type && has_wrong_unit_type())
      spoiled = true;
    else if (rule.by_unit_type && inputs.unit_type == UnitType::kUnstated)
      lacking.emplace_back("unit_type");
    if (!lacking.empty()) {
      refuse_lacking(table, key, rule, lacking);
      return {kUnset, "", true};
    }
    if (spoiled) {
      is_follow_up(table, key);
      return {kUnset, "", true};
    }
    if (!holds(table, key, rule, inputs)) return {kUnset, "", true};
    if (rule.by_unit_type)
      from.push_back(fmt::format("unit_type {}", word_of(kUnitTypeWords, inputs.unit_type)));
    const std::string by = from.empty() ? "" : " from " + joined(from, ", ");
    const double value = value_by(rule, inputs, table.keys->at(key));
    put(table, key, value, Origin::kDerived, fmt::format("by {}{}", rule.name, by));
    return {value, fmt::format(" (by {})", rule.name)};
  }

  const Key& key_named(const Table& table, const std::string& name) const {
    const bool own = table.role == Role::kMasonry || is_law_key(name);
    return own ? table.keys->at(name) : masonry_.keys->at(name);
  }

  // Marks a key whose fault is reported elsewhere, so that no further fault follows.
  void is_follow_up(Table& table, const std::string& key) {
    context_.follow_ups.insert(under(table.path, key));
    table.toml->erase(key);  // its reader would report that "rule" is no number
  }

  void refuse_lacking(Table& table, const std::string& key, const Rule& rule,
                      const std::vector<std::string>& lacking) {
    if (use_is_wrong_) {  // the typology would have given them: one message for one mistake
      table.toml->erase(key);
      return;
    }
    std::vector<std::string> masonry, own;
    bool has_news = false;
    for (const std::string& name : lacking) {
      const bool is_of_masonry =
          name == "unit_type" || !is_law_key(name) || table.role == Role::kMasonry;
      (is_of_masonry ? masonry : own).push_back(name);
      has_news |= told_lacking_.insert(is_of_masonry ? name : under(table.path, name)).second;
    }
    if (!has_news) return is_follow_up(table, key);
    const auto has_rule = [](const std::string& name) {
      return materials::rule_for(Role::kMasonry, name) != nullptr;
    };
    std::string cure;
    if (!masonry.empty())
      cure = fmt::format("give {} under [masonry]{}", joined(masonry, ", "),
                         std::any_of(masonry.begin(), masonry.end(), has_rule)
                             ? " (\"rule\" where a rule shall give it too)"
                             : "");
    if (!own.empty())
      cure += fmt::format("{}give {} here", cure.empty() ? "" : " and ", joined(own, ", "));
    fault(table, key, fmt::format("the rule {} needs {}", rule.name, joined(lacking, ", ")),
          cure + fmt::format(", give {} itself, or a typology by use = \"...\"", key));
    table.toml->erase(key);  // its reader would report that "rule" is no number
  }

  bool holds(Table& table, const std::string& key, const Rule& rule, const materials::Inputs& in) {
    if (!materials::holds_for(rule, in.unit_type)) {
      fault(table, key,
            fmt::format("the rule {} was not tested for units of {}", rule.name,
                        word_of(kUnitTypeWords, in.unit_type)),
            fmt::format("give {} itself", key));
      is_follow_up(table, key);
      return false;
    }
    const auto at = [&](const char* name) {
      const auto found = std::find_if(rule.inputs.begin(), rule.inputs.end(), [&](const char* one) {
        return std::string_view(one) == name;
      });
      return in.value[found - rule.inputs.begin()];
    };
    for (const materials::Bound& bound : rule.range) {
      const bool ratio = *bound.per != '\0';
      const double value = ratio ? at(bound.input) / at(bound.per) : at(bound.input);
      if (value >= bound.low && value <= bound.high) continue;
      const Key plain{};
      const Key& shown_as = ratio ? plain : key_named(table, bound.input);
      const std::string what = ratio ? fmt::format("{} / {}", bound.input, bound.per) : bound.input;
      const toml::node* node = table.toml->get(key);
      outside_.push_back({.path = under(table.path, key),
                          .key = key,
                          .line = node && line_of(*node) ? line_of(*node) : line_of(*table.toml),
                          .value = node ? shown(*node) : "",
                          .input = what,
                          .rule = rule.name,
                          .holds = fmt::format("from {} to {}", brief(bound.low, shown_as),
                                               brief(bound.high, shown_as)),
                          .here = brief(value, shown_as)});
      is_follow_up(table, key);
      return false;
    }
    return true;
  }

  // Refuses a knowledge level with no effect. It divides values of its table, so it has none where all values are given.
  void refuse_idle_level() {
    if (!masonry_.toml || !office_.is_asked() || !context_.faults.empty()) return;
    const auto is_from_it = [](const auto& derived) {
      return derived.first.starts_with("material.");
    };
    if (std::any_of(context_.derived.begin(), context_.derived.end(), is_from_it)) return;
    fault(masonry_, "knowledge_level",
          "has no effect: no material takes a value from the table, so none is divided",
          "ask for rules in [material.NAME], missing = \"rule\"; or leave it out and state "
          "confidence_factor where the values are divided already");
  }

  // One message for all rules of which one value is out of range.
  void refuse_outside() {
    for (std::size_t i = 0; i < outside_.size(); ++i) {
      const Outside& first = outside_[i];
      const auto is_same = [&](const Outside& other) {
        return other.input == first.input && other.here == first.here;
      };
      if (std::find_if(outside_.begin(), outside_.end(), is_same) !=
          outside_.begin() + static_cast<std::ptrdiff_t>(i))
        continue;
      std::string rules;
      std::vector<std::string> keys;
      for (const Outside& one : outside_) {
        if (!is_same(one)) continue;
        rules += keys.empty()
                     ? fmt::format("the rule {} holds for {} {}", one.rule, one.input, one.holds)
                     : fmt::format(", {} (for {}) {}", one.rule, one.key, one.holds);
        keys.push_back(one.key);
      }
      context_.fault(first.path, first.line, first.value,
                     fmt::format("{}, here it is {}", rules, first.here),
                     fmt::format("check {}, or give {} {}", first.input, joined(keys, ", "),
                                 keys.size() > 1 ? "themselves" : "itself"));
    }
  }

  // --- whole tables ------------------------------------------------------------------------------

  void fill(Table& law) {
    for (const auto& [name, key] : *law.keys) {
      const bool asked = asks_for_rule(law.toml->get(name));
      if (asked && !is_law_key(name))
        (void)by_rule(law, name, *law.toml->get(name));
      else if (asked || law.use || law.missing)
        (void)value_of(law, name);
    }
    const auto is_there = [&](const auto& key) {
      return is_law_key(key.first) && law.toml->contains(key.first);
    };
    if (law.use && std::none_of(law.keys->begin(), law.keys->end(), is_there))
      fault(law, "use", fmt::format("{} says nothing of this", law.use->name),
            "give the values, ask for rules, or use another typology");
  }

  // Fills values that [masonry] asks for, and values that its typology adds to the given ones.
  void fill_masonry() {
    for (const auto& [name, key] : *masonry_.keys) {
      if (asks_for_rule(masonry_.toml->get(name))) (void)value_of(masonry_, name);
      if (!masonry_.use || masonry_.toml->contains(name)) continue;
      const Found found = typical(masonry_, masonry_.use, Role::kMasonry, name);
      if (found.known())
        put(masonry_, name, found.value, Origin::kTypical,
            described(*masonry_.use, Role::kMasonry, name));
    }
    if (!masonry_.use || masonry_.toml->contains("unit_type")) return;
    const std::string word(word_of(kUnitTypeWords, masonry_.use->unit_type));
    masonry_.toml->insert("unit_type", word);
    masonry_.origin.push_back(
        to_text({"unit_type", word, Origin::kTypical,
                 fmt::format("of {} ({})", masonry_.use->name, masonry_.use->source)}));
  }

  // --- origin ------------------------------------------------------------------------------------

  // Lines of an earlier run stay valid while the value is unchanged. A rule must also
  // give the same value from the present inputs, or an input was changed without effect.
  void confirm(Table& table) {
    const toml::node* node = table.toml->get("origin");
    const toml::array* old = node ? node->as_array() : nullptr;
    const bool texts = old && (old->empty() || old->is_homogeneous<std::string>());
    if (node && !texts) return;  // its reader reports it
    for (std::size_t i = 0; old && i < old->size(); ++i) {
      const auto origin = origin_of(old->get(i)->as_string()->get());
      const toml::node* value = origin ? table.toml->get(origin->key) : nullptr;
      if (origin && origin->by.starts_with(materials::kAsEnergyIs)) {
        if (!value && is_left_out_still(table, *origin)) table.origin.push_back(to_text(*origin));
        continue;
      }
      if (!value || shown(*value) != origin->value ||
          context_.derived.contains(under(table.path, origin->key)))
        continue;
      if (origin->kind == Origin::kDerived && !gives_again(table, *origin)) continue;
      if (origin->kind == Origin::kTypical && !is_typical(table, *origin)) continue;
      table.origin.push_back(to_text(*origin));
    }
    if (!node && table.origin.empty()) return;
    std::sort(table.origin.begin(), table.origin.end());
    toml::array lines;
    for (const std::string& line : table.origin) lines.push_back(line);
    table.toml->insert_or_assign("origin", std::move(lines));
  }

  // Whether a line that explains b = 0 is still valid: GII is given and no rule derives it again.
  [[nodiscard]] bool is_left_out_still(const Table& table, const Origin& origin) const {
    const std::string line = to_text(origin);
    return origin.key == kEnergyPerPressure && table.toml->contains("mode_2_energy") &&
           !context_.derived.contains(under(table.path, "mode_2_energy")) &&
           std::find(table.origin.begin(), table.origin.end(), line) == table.origin.end();
  }

  // "by NAME from ...", "of NAME (source)".
  static std::string name_in(const Origin& origin) {
    return origin.by.substr(3, origin.by.find(' ', 3) - 3);
  }

  // The typology entry that gave an input of a rule in the earlier run: "... from NAME 0.2 MPa (typical of ENTRY), ...".
  static const Entry* entry_in(const std::string& by, const std::string& name) {
    constexpr std::string_view kTypicalOf = "(typical of ";
    const std::size_t from = by.find(name + ' '), end = std::min(by.find(", ", from), by.size());
    const std::size_t at = from == std::string::npos ? from : by.find(kTypicalOf, from);
    if (at >= end) return nullptr;
    const std::size_t begin = at + kTypicalOf.size();
    return materials::entry_of(std::string_view(by).substr(begin, by.find(')', begin) - begin));
  }
  [[nodiscard]] double typical_input(const std::string& by, const char* name) const {
    const Entry* entry = entry_in(by, name);
    return entry ? typical(masonry_, entry, Role::kMasonry, name).value : kUnset;
  }
  static UnitType typical_type(const std::string& by) {
    const std::size_t at = by.find("unit_type ");
    if (at != std::string::npos)
      for (const auto& known : kUnitTypeWords)
        if (by.substr(at + 10) == known.word) return known.value;
    return UnitType::kUnstated;
  }

  bool gives_again(Table& table, const Origin& origin) {
    const std::string name = name_in(origin);
    const Rule* rule = materials::rule_for(table.role, origin.key, name);
    if (!rule) return false;
    materials::Inputs inputs{{}, rule->by_unit_type ? unit_type(table) : UnitType::kUnstated};
    if (rule->by_unit_type && inputs.unit_type == UnitType::kUnstated)
      inputs.unit_type = typical_type(origin.by);
    for (const char* wanted : rule->inputs) {
      const Found found = input(table, wanted);
      inputs.value.push_back(found.known() ? found.value : typical_input(origin.by, wanted));
    }
    const bool known = std::none_of(inputs.value.begin(), inputs.value.end(),
                                    [](double value) { return std::isnan(value); });
    if (!known || !materials::holds_for(*rule, inputs.unit_type)) return false;
    const Key& key = table.keys->at(origin.key);
    const std::string now = shown_value(value_by(*rule, inputs, key), key);
    if (now == origin.value) return true;
    fault(
        table, origin.key,
        fmt::format("its origin says {} {}, which now gives {}", kind_word(origin.kind), origin.by,
                    now),
        fmt::format("write {} = \"rule: {}\" to follow, or remove its line from origin to keep it",
                    origin.key, name));
    return false;
  }

  // Whether the library still gives this value: as a typical
  // value, or as the table value of a knowledge level.
  static bool is_typical(const Table& table, const Origin& origin) {
    const std::string name = name_in(origin);
    const Entry* entry = materials::entry_of(name);
    const Datum* datum = entry ? materials::datum_of(*entry, table.role, origin.key) : nullptr;
    if (!datum) return entry && origin.key == "unit_type";
    const std::size_t way = origin.by.find("): ");
    if (way !=
        std::string::
            npos)  // a knowledge level, whose inputs are gone: this line contains its arithmetic
      return materials::begins_with_table(std::string_view(origin.by).substr(way + 3), *datum);
    const Key& key = table.keys->at(origin.key);
    return shown_value(value_of_datum(*datum, key), key) == origin.value;
  }

  void refuse_idle_overrides() {
    for (const Override& set : context_.overrides) {
      if (!set.path.starts_with("masonry.")) continue;
      const std::string key = set.path.substr(8);
      const bool known = masonry_.keys->contains(key) || key == "unit_type" || key == "use";
      if (!known || (key == "use" ? !context_.asked.empty() : context_.asked.contains(key)))
        continue;
      context_.fault(set.path, 0, "", "has no effect: no rule of this model asks for it",
                     "let a material ask for a rule that does, e.g. tensile_strength = \"rule\"");
    }
  }

  ReadContext& context_;
  toml::table& root_;
  Table masonry_;
  std::set<std::string, std::less<>> spoiled_;  // paths with a reported fault
  OfficeMasonry office_;                        // requests of [masonry] to Circolare 7/2019
  bool use_is_wrong_ = false;                   // reported already
  std::set<std::string> told_lacking_;          // inputs of rules
  struct Outside {
    std::string path, key;
    int line = 0;
    std::string value, input, rule, holds, here;
  };
  std::vector<Outside> outside_;  // values that no rule allows
};

}  // namespace

void resolve_materials(ReadContext& context, toml::table& root) { Resolver(context, root).run(); }

}  // namespace wythe::io
