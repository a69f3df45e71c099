// read_study, parse_study: text -> tree -> overrides -> head, base model, inputs -> StudySpec.
//
// The order matters. A variable's unit is that of the key which it sets, so the base model is read first and
// its keys are listed. check_study, which compares the parts, comes last, and its faults get their lines.
#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "core/ascii.h"
#include "core/files.h"
#include "core/number.h"
#include "core/text.h"
#include "io/bodies/blocks_json.h"
#include "io/keys/describe.h"
#include "io/keys/describe_records.h"
#include "io/keys/describe_study.h"
#include "io/keys/meant_names.h"
#include "io/keys/model_key.h"
#include "io/study/shaking_file.h"
#include "io/study/study_file.h"
#include "io/study/variants.h"
#include "io/text/magnitude.h"
#include "io/text/toml_reader.h"
#include "io/text/value_column.h"
#include "model/size.h"
#include "units/dimension.h"
#include "units/quantity_error.h"
#include "wythe/parts/io.h"
#include "wythe/parts/units.h"

namespace wythe {
namespace io {
namespace {

constexpr const char* kParts[] = {"study",   "variable", "dependent", "correlation", "field",
                                  "variant", "shaking",  "record",    "limit_state", "record_text"};

using Shape = KnownName::Shape;

KnownName value_named(const char* name) { return {name, Shape::kValue, false, nullptr}; }

template <class T>
std::vector<KnownName> names_of_table(T&& described, std::initializer_list<const char*> more) {
  std::vector<KnownName> out;
  NameCollector collector(out);
  describe(collector, described);
  for (const char* name : more) out.push_back(value_named(name));
  return out;
}

const std::vector<KnownName>& names_of_head() {
  static const std::vector<KnownName> names = [] {
    StudySpec spec;
    return names_of_table(StudyHead{spec, ""}, {"samples", "seed", "fractions"});
  }();
  return names;
}

const std::vector<KnownName>& names_of_variable() {
  static const std::vector<KnownName> names = [] {
    VariableSpec spec;
    spec.si_unit = spec.unit = "Pa";  // any unit, as names of amounts do not depend on it
    const VariableKeys keys{{}, {}, ""};
    return names_of_table(VariableTable{spec, keys}, {"values"});
  }();
  return names;
}

const std::vector<KnownName>& names_of_dependent() {
  static const std::vector<KnownName> names = [] {
    DependentSpec spec;
    return names_of_table(DependentTable{spec}, {});
  }();
  return names;
}

const std::vector<KnownName>& names_of_record() {
  static const std::vector<KnownName> names =
      names_of_table(RecordSpec{}, {"name", "levels", "component"});
  return names;
}

const std::vector<KnownName>& names_of_study() {
  static const std::vector<KnownName> names = {
      {"study", Shape::kTable, false, &names_of_head},
      {"variable", Shape::kMap, false, &names_of_variable},
      {"dependent", Shape::kMap, false, &names_of_dependent},
      {"correlation", Shape::kList, false, &known_names<PairTable>},
      {"field", Shape::kMap, false, &known_names<FieldSpec>},
      {"variant", Shape::kList, false, &known_names<VariantSpec>},
      {"shaking", Shape::kTable, false, &known_names<ShakingSpec>},
      {"record", Shape::kList, false, &names_of_record},
      {"limit_state", Shape::kList, false, &known_names<LimitStateSpec>},
      value_named("record_text")};
  return names;
}

Range with_ends(Range range) {
  range.low_open = range.high_open = false;
  return range;
}

// SI unit of a unit the study names itself: "Pa" for "MPa", "rad" for "deg", "1" for "1".
std::string si_unit_of(const std::string& unit) {
  const Dimension dimension = dimension_of(unit);
  const bool angle = dimension.is_number() && unit_definition(unit).ends_with("rad");
  return angle ? "rad" : dimension.unit();
}

class StudyReader {
 public:
  StudyReader(ReadContext& context, const toml::table& root, std::vector<std::string> settings,
              StudyText from)
      : context_(context), root_(root), given_settings_(std::move(settings)), from_(from) {
    study_.file = context.file;
  }

  StudySpec read() {
    refuse_other_tables();
    study_.record_text = given_records(context_, root_);
    parse_head();
    if (!study_.model_text.empty()) list_model_keys();
    parse_shaking(context_, root_, base_, study_);
    for (const auto& [name, table] : in_file_order(context_, root_.get("variable"), "variable"))
      if (!enough(context_.faults)) parse_variable(name, *table);
    for (const auto& [name, table] : in_file_order(context_, root_.get("dependent"), "dependent"))
      if (!enough(context_.faults)) parse_dependent(name, *table);
    parse_correlations();
    check_settings();
    check_parts();
    throw_all();
    check_records(study_, root_);
    return std::move(study_);
  }

 private:
  void refuse_other_tables() {
    const std::vector<std::string> known(std::begin(kParts), std::end(kParts));
    for (const auto& [name, node] : root_) {
      const std::string word(name.str());
      if (std::find(known.begin(), known.end(), word) == known.end())
        context_.fault(word, line_of(node), shown(node), fmt::format("no such key {}", word),
                       name_advice(word, known));
    }
  }

  // --- [study] -----------------------------------------------------------------------------------

  void parse_head() {
    const toml::node* node = root_.get("study");
    const toml::table* table = node ? node->as_table() : nullptr;
    if (!table && context_.has_fault_at("study")) return;
    if (!table) {
      context_.fault("study", node ? line_of(*node) : 0, "", "is missing or no table",
                     "write [study] and under it model, samples, seed");
      return;
    }
    TableReader reader(context_, *table, "study");
    StudyHead head{study_, ""};
    describe(reader, head);
    parse_samples(reader);
    parse_seed(reader);
    parse_fractions(reader);
    reader.refuse_unknown();
    read_model_text(reader, head.model);
    own_settings_ = study_.settings.size();
    parse_fields();
    study_.settings.insert(study_.settings.end(), given_settings_.begin(), given_settings_.end());
  }

  // A number, or the sizes of successive batches.
  void parse_samples(TableReader& reader) {
    const toml::node* node = reader.find("samples", {.range = {.low = 2}, .example = "250"});
    if (!node) {
      reader.miss("samples", "is missing");
      return;
    }
    toml::array sizes;
    if (const toml::array* list = node->as_array())
      sizes = *list;
    else
      node->visit([&](const auto& one) { sizes.push_back(one); });
    for (const toml::node& size : sizes) {
      const auto* whole = size.as_integer();
      if (!whole || whole->get() > 10'000'000 || whole->get() < 0) {
        reader.refuse("samples", "must be a whole number without quotes, or a list of them",
                      "write e.g. samples = 250");
        return;
      }
      study_.batch.push_back(static_cast<int>(whole->get()));
    }
  }

  // Up to 2^63 - 1 as a TOML integer, up to 2^64 - 1 as a text.
  void parse_seed(TableReader& reader) {
    const toml::node* node = reader.find("seed", {.example = "2026"});
    if (!node) {
      reader.miss("seed", "is missing; without it the samples could not be drawn again");
      return;
    }
    const std::string text = shown(*node);
    const auto seed = parse_number<std::uint64_t>(text);
    if (seed && (node->is_integer() || node->is_string()))
      study_.seed = *seed;
    else
      reader.refuse("seed", "must be a whole number from 0", "write e.g. seed = 2026");
  }

  void parse_fractions(TableReader& reader) {
    const toml::node* node = reader.find("fractions", {.example = "[0.8, 0.5]"});
    if (!node) return;
    const toml::array* list = node->as_array();
    const bool good = list && std::all_of(list->begin(), list->end(),
                                          [](const toml::node& item) { return item.is_number(); });
    if (!good) {
      reader.refuse("fractions", "must be a list of numbers", "write e.g. fractions = [0.8, 0.5]");
      return;
    }
    for (const toml::node& item : *list) study_.fractions.push_back(*item.value<double>());
  }

  void read_model_text(TableReader& reader, const std::string& model) {
    if (model.empty()) {
      if (!context_.has_fault_at("study.model")) reader.miss("model", "is missing");
      return;
    }
    const bool inside = !study_.model_text.empty();
    study_.model_file = inside ? model : beside(context_.file, model);
    if (inside) return;
    try {
      study_.model_text = read_text(study_.model_file, kMostToml);
    } catch (const std::runtime_error& error) {
      const std::string near = nearest_file(study_.model_file);
      reader.refuse("model", error.what(),
                    near.empty() ? "name the base model, relative to the study file"
                                 : fmt::format("did you mean {}?", beside(model, near)));
    }
  }

  // --- [field.<name>] ----------------------------------------------------------------------------

  // They are settings of the base model. A field with the name of a variable scatters what the variable sets.
  void parse_fields() {
    for (const auto& [name, table] : in_file_order(context_, root_.get("field"), "field")) {
      const toml::node* variable = node_at("variable." + name + ".path");
      if (!table->contains("path") && variable && variable->is_string())
        study_.settings.push_back(fmt::format("field.{}.path={}", name, shown(*variable)));
      list_settings(*table, "field." + name, study_.settings);
    }
  }

  // --- base model --------------------------------------------------------------------------------

  void list_model_keys() {
    try {
      ModelSpec base = parse_model(study_.model_text, study_.model_file, study_.settings,
                                   study_.blocks_text, study_.record_text);
      base_.stage = base.stage;
      base_.folder = base.folder;
      check_batch(base);
      for (const auto& [name, field] : base.field)
        study_.field.push_back({name, field.path, !field.formula.empty()});
      if (!base.block.empty() || !base.body.empty()) study_.blocks_text = blocks_text(base, true);
      keys_ = SettableKeys(study_.model_text, study_.model_file, study_.settings, base);
    } catch (const InputError& error) {
      for (Fault fault : error.faults()) model_faults_.push_back(placed(std::move(fault)));
    }
  }

  // The records of all samples are read together, so they must fit in memory; checked before any sample is drawn.
  void check_batch(const ModelSpec& base) {
    double samples = 0;
    for (const int size : study_.batch) samples += size;
    const SizeProblem found = check_samples(base, samples);
    if (!found.problem.empty())
      context_.fault("study.samples", line_at("study.samples"), fmt::format("{:.0f}", samples),
                     found.problem, found.cure);
  }

  // Sets file and line of a fault whose setting is in the study file, not on the command line.
  [[nodiscard]] Fault placed(Fault fault) const {
    if (fault.path.starts_with("field.") && node_at(part_of(fault.path)) != nullptr) {
      fault.file = context_.file;
      fault.line = line_at(fault.path);
    }
    for (std::size_t i = 0; i < own_settings_ && fault.file == "--set"; ++i) {
      const std::string& text = study_.settings[i];
      if (trimmed(text.substr(0, text.find('='))) != fault.path) continue;
      fault.file = context_.file;
      fault.line = line_at("study.set");
      fault.path = "study.set: " + fault.path;
    }
    return fault;
  }

  // --- inputs ------------------------------------------------------------------------------------

  // Finds path and unit, which all amounts depend on. `range` becomes the range of the key.
  void resolve(const toml::table& table, const std::string& place, InputSpec& input, Range& range) {
    const auto path = table["path"].value<std::string>();
    const auto unit = table["unit"].value<std::string>();
    const auto refuse = [&](const char* key, const std::string& value, const std::string& problem,
                            const std::string& cure) {
      context_.fault(under(place, key), line_of(*table.get(key)), value, problem, cure);
    };
    if (table.contains("path") && (!path || path->empty())) return;  // its reader reports it
    if (path && keys_.empty()) return;                               // the model has faults
    try {
      if (path) {
        const ModelKey* key = keys_.find(*path);
        if (!key) return refuse("path", *path, "no such number in the model", keys_.advice(*path));
        if (const auto [problem, cure] = keys_.idle(key->path); !problem.empty())
          return refuse("path", *path, problem, cure);
        path_[place] = key->path;
        range = key->range;
        check_unit(*key, unit.value_or(key->unit));
        input.si_unit = key->si_unit;
        input.unit = unit.value_or(key->unit);
      } else if (unit) {
        input.si_unit = si_unit_of(*unit);
        if (input.si_unit == "1" && *unit != "1")
          throw QuantityError(fmt::format("{} is a plain number", *unit), "write unit = \"1\"");
        input.unit = *unit;
      } else if (const char* amount = amount_with_unit(table); *amount != '\0') {
        context_.fault(
            under(place, "path"), line_of(table), "",
            fmt::format("is missing, and {} = {} has a unit", amount, shown(*table.get(amount))),
            "write the key that this varies, e.g. path = "
            "\"material.joint.tensile_strength\"; or unit = \"MPa\" of a value for "
            "formulas alone");
        input.si_unit.clear();
      } else {
        input.si_unit = input.unit = "1";
      }
    } catch (const QuantityError& error) {
      input.si_unit.clear();
      refuse("unit", unit.value_or(""), error.problem(), error.cure());
    }
  }

  // The first amount with a unit; null if all are numbers.
  static const char* amount_with_unit(const toml::table& table) {
    for (const study::VariableParameter& p : study::kVariableParameters) {
      const toml::node* node = table.get(p.name);
      if (node && node->is_string() && p.is != study::ParameterIs::kNumber) return p.name;
    }
    return "";
  }

  static void check_unit(const ModelKey& key, const std::string& unit) {
    if (key.si_unit == "1" && unit != "1")
      throw QuantityError(fmt::format("{} is a plain number, without unit", key.path),
                          "leave unit out");
    if (key.si_unit != "1") (void)unit_factor(unit, key.si_unit);
  }

  void parse_variable(const std::string& name, const toml::table& table) {
    const std::string place = under("variable", name);
    VariableSpec& variable = study_.variable.emplace_back();
    variable.name = name;
    Range range;
    resolve(table, place, variable, range);
    if (variable.si_unit.empty()) spoiled_.push_back(place);  // its amounts can't be read
    const VariableKeys keys{range, with_ends(range), "1 " + variable.unit};
    const std::string unit = variable.unit;
    TableReader reader(context_, table, place);
    VariableTable described{variable, keys};
    describe(reader, described);
    settle(variable, place, unit);
    if (!reader.has("distribution"))
      reader.miss("distribution", "is missing", "write e.g. distribution = \"lognormal\"");
    parse_values(reader, variable);
    reader.refuse_unknown();
  }

  // After the texts are read: sets the canonical path and the unit used.
  void settle(InputSpec& input, const std::string& place, const std::string& unit) {
    if (const auto found = path_.find(place); found != path_.end()) input.path = found->second;
    if (input.unit.empty()) input.unit = unit;
  }

  void parse_values(TableReader& reader, VariableSpec& variable) {
    const toml::node* node = reader.find("values", {});
    const bool empirical = variable.distribution == DistributionKind::kEmpirical;
    for (const char* name : {"file", "column", "values"})
      if (!empirical && reader.has(name))
        reader.refuse(name, "belongs to an empirical distribution",
                      "write distribution = \"empirical\", or leave it out");
    if (!empirical || variable.si_unit.empty()) return;
    if (node)
      parse_listed_values(reader, *node, variable);
    else if (!variable.file.empty())
      parse_measured_values(reader, variable);
  }

  void parse_listed_values(TableReader& reader, const toml::node& node, VariableSpec& variable) {
    const bool plain = variable.si_unit == "1";
    const std::string cure = plain ? "write e.g. values = [0.4, 0.5]"
                                   : fmt::format("write e.g. values = [\"1 {}\"]", variable.unit);
    const toml::array* list = node.as_array();
    if (!list) return reader.refuse("values", "must be a list", cure);
    for (const toml::node& item : *list) try {
        if (plain ? !item.is_number() : !item.is_string())
          throw QuantityError(fmt::format("{} is not {}", shown(item),
                                          plain ? "a number" : "a quantity with its unit"),
                              cure);
        const double value = plain ? *item.value<double>()
                                   : parse_quantity(item.as_string()->get(), variable.si_unit);
        if (const std::string problem = magnitude_problem(value, variable.si_unit);
            !problem.empty())
          throw QuantityError(fmt::format("{} {}", shown(item), problem), cure);
        variable.values.push_back(value);
      } catch (const QuantityError& error) {
        reader.refuse("values", error.problem(), error.cure());
      }
  }

  void parse_measured_values(TableReader& reader, VariableSpec& variable) {
    FaultList faults;
    const ColumnRequest request{
        .file = beside(context_.file, variable.file),
        .column = variable.column,
        .si_unit = variable.si_unit,
        .unit = reader.has("unit") && variable.unit != "1" ? variable.unit : ""};
    try {
      variable.values = parse_value_column(request, faults);
    } catch (const std::runtime_error& error) {
      reader.refuse("file", error.what(), "name a CSV file, relative to the study file");
    }
    for (const Fault& fault : faults.all()) model_faults_.push_back(fault);
    if (!faults.empty()) spoiled_.push_back(under("variable", variable.name));
  }

  void parse_dependent(const std::string& name, const toml::table& table) {
    const std::string place = under("dependent", name);
    DependentSpec& dependent = study_.dependent.emplace_back();
    dependent.name = name;
    Range range;
    if (table.contains("path") || table.contains("unit")) resolve(table, place, dependent, range);
    const std::string unit = dependent.unit;
    TableReader reader(context_, table, place);
    DependentTable described{dependent};
    describe(reader, described);
    settle(dependent, place, unit);
    if (!reader.has("formula")) reader.miss("formula", "is missing");
    reader.refuse_unknown();
  }

  // Refuses settings of keys that an input, a formula or the sample's number sets too, because they have no effect; whole tables as well.
  void check_settings() {
    const auto refuse = [&](const std::string& path, const std::string& key,
                            const std::string& setter, const std::string& cure) {
      const bool whole = key.size() > path.size() && key.starts_with(path);
      model_faults_.push_back(placed(
          {.file = "--set",
           .path = path,
           .problem = fmt::format("{}has no effect, it is set by {}",
                                  whole ? "its " + key.substr(path.size() + 1) + " " : "", setter),
           .cure = cure}));
    };
    for (const std::string& text : study_.settings) {
      const std::string path(trimmed(text.substr(0, text.find('='))));
      for (const StudyField& field : study_.field)
        if (!field.follows && path == "field." + field.name + ".seed")
          refuse(path, path, "study.seed and the number of each sample",
                 "leave it out, or change study.seed");
      const ModelKey* key = keys_.find(path);
      const std::string full = key == nullptr ? path : key->path;
      const std::string leave = key == nullptr ? "set its other keys one by one" : "leave it out";
      for (const StudyField& field : study_.field)
        if (keys_.has_formula(field.path) && lies_in(field.path, angle_path(full)))
          refuse(path, field.path, "field." + field.name + ".formula",
                 leave + ", or change the formula");
      if (from_ == StudyText::kMade) continue;
      for (const auto& [place, sets] : path_)
        if (lies_in(sets, full))
          refuse(path, sets, place,
                 fmt::format("{0}, or change {1} instead, e.g. --set {1}{2}", leave, place,
                             place.starts_with("variable") ? ".mean=..." : ".formula=\"...\""));
    }
  }

  // --- correlation -------------------------------------------------------------------------------

  void parse_correlations() {
    const toml::node* node = root_.get("correlation");
    if (!node) return;
    const toml::array* list = node->as_array();
    const bool good = list && std::all_of(list->begin(), list->end(),
                                          [](const toml::node& item) { return item.is_table(); });
    if (!good) {
      context_.fault("correlation", line_of(*node), shown(*node), "must be a list of tables",
                     "write each under [[correlation]], with two brackets");
      return;
    }
    for (std::size_t i = 0; i < list->size() && !enough(context_.faults); ++i)
      parse_correlation(*list->get(i)->as_table(), under("correlation", std::to_string(i)));
  }

  void parse_correlation(const toml::table& table, const std::string& place) {
    TableReader reader(context_, table, place);
    PairTable pair;
    describe(reader, pair);
    reader.refuse_unknown();
    if (!reader.has("between"))
      reader.miss("between", "is missing", "write e.g. between = [\"ft_j\", \"fc\"]");
    const bool rank = reader.has("rank");
    if (rank == reader.has("gaussian") && (rank || !reader.has_unknown()))
      reader.refuse_table(rank ? "has both rank and gaussian" : "needs rank or gaussian",
                          "write rank = 0.3 (Spearman) or gaussian = 0.3");
    pair.between.resize(2);
    study_.correlation.push_back({.a = pair.between[0],
                                  .b = pair.between[1],
                                  .value = rank ? pair.rank : pair.gaussian,
                                  .rank = rank});
  }

  // --- the whole ---------------------------------------------------------------------------------

  // Checks between the parts; a part with its own faults is not checked further.
  void check_parts() {
    read_faults_ = context_.faults.all();
    std::set<std::string> told;  // names that do not exist
    for (const Fault& fault : check_study(study_)) {
      const std::string part = part_of(fault.path);
      if (fault.path.ends_with(".formula") && follows_from_fault(part)) continue;
      const std::string name = unknown_input(fault);
      if (!name.empty() && !told.insert(name).second) continue;
      const bool half_read =
          has_fault_in(part) || std::find(spoiled_.begin(), spoiled_.end(), part) != spoiled_.end();
      const bool matrix = fault.path == "correlation" && has_fault_in("correlation");
      const bool of_shakes = fault.path == "record" && has_fault_in("shaking");
      if (half_read || matrix || of_shakes || context_.has_fault_at(fault.path)) continue;
      const toml::node* node = node_at(fault.path);
      const bool is_value = node && node->is_value();
      context_.fault(fault.path, line_at(fault.path), is_value ? shown(*node) : fault.value,
                     fault.problem, fault.cure);
    }
  }

  // The name in a fault about an input that does not exist; "" for other faults.
  static std::string unknown_input(const Fault& fault) {
    if (fault.problem == "is not a variable") return fault.value;
    if (!fault.problem.starts_with("there is no variable or dependent ")) return "";
    return fault.problem.substr(fault.problem.rfind(' ') + 1);
  }

  // Whether the formula of a table names an input that could not be read.
  [[nodiscard]] bool follows_from_fault(const std::string& part) const {
    const toml::node* formula = node_at(part + ".formula");
    const std::string text = formula && formula->is_string() ? shown(*formula) : "";
    const auto names = [&](const std::string& name) {
      const auto is_letter = [&](std::size_t i) {
        return i < text.size() &&
               ((is_ascii_letter(text[i]) || is_digit(text[i])) || text[i] == '_');
      };
      for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1))
        if (!is_letter(at + name.size()) && !(at > 0 && is_letter(at - 1))) return true;
      return false;
    };
    return std::any_of(spoiled_.begin(), spoiled_.end(), [&](const std::string& place) {
      return names(place.substr(place.find('.') + 1));
    });
  }

  // "variable.ft_j.cov" -> "variable.ft_j"; keys of [study] stand for themselves.
  static std::string part_of(const std::string& path) {
    if (path.starts_with("study")) return path;
    if (path.starts_with("shaking.")) return "shaking";
    return path.substr(0, path.find('.', path.find('.') + 1));
  }

  [[nodiscard]] bool has_fault_in(const std::string& part) const {
    if (part.find('.') == std::string::npos && part != "correlation" && part != "shaking")
      return false;
    return std::any_of(read_faults_.begin(), read_faults_.end(), [&](const Fault& fault) {
      return fault.path == part || fault.path.starts_with(part + '.');
    });
  }

  [[nodiscard]] const toml::node* node_at(const std::string& path) const {
    const toml::node* node = &root_;
    for (std::size_t begin = 0; node && begin <= path.size();) {
      const std::size_t dot = std::min(path.find('.', begin), path.size());
      const std::string step = path.substr(begin, dot - begin);
      begin = dot + 1;
      const bool index = step.find_first_not_of("0123456789") == std::string::npos;
      if (const toml::table* table = node->as_table())
        node = table->get(step);
      else if (const toml::array* list = node->as_array())
        node = index && !step.empty() && step.size() < 9
                   ? list->get(*parse_number<std::size_t>(step))
                   : nullptr;
      else
        node = nullptr;
    }
    return node;
  }

  // Line of the key, or of the nearest table above it in the file.
  [[nodiscard]] int line_at(std::string path) const {
    while (true) {
      if (const toml::node* node = node_at(path)) return line_of(*node);
      const std::size_t dot = path.rfind('.');
      if (dot == std::string::npos) return 0;
      path.resize(dot);
    }
  }

  // Throws the study's faults by line, then those of other files.
  void throw_all() const {
    std::vector<Fault> all = context_.faults.all();
    std::stable_sort(all.begin(), all.end(),
                     [](const Fault& a, const Fault& b) { return a.line < b.line; });
    all.insert(all.end(), model_faults_.begin(), model_faults_.end());
    if (!all.empty()) throw InputError(std::move(all));
  }

  ReadContext& context_;
  const toml::table& root_;
  std::vector<std::string> given_settings_;  // --set of the base model
  StudyText from_;
  ModelSpec base_;  // only its stages and folder
  StudySpec study_;
  std::size_t own_settings_ = 0;             // of study.set
  SettableKeys keys_;                        // of the base model; empty when it has faults
  std::map<std::string, std::string> path_;  // table -> canonical path
  std::vector<Fault> read_faults_;           // those of single keys
  std::vector<Fault> model_faults_;          // from the base model and from CSV files
  std::vector<std::string> spoiled_;         // tables that could not be read in full
};

bool is_of_study(const std::string& override_text) {
  return std::any_of(std::begin(kParts), std::end(kParts), [&](const char* part) {
    return trimmed(override_text).starts_with(std::string(part) + '.');
  });
}

}  // namespace

StudySpec parse_study_text(const std::string& toml_text, const std::string& file_name,
                           const std::vector<std::string>& overrides, StudyText from) {
  toml::table root = parse_toml(toml_text, file_name);
  refuse_model(root, file_name);
  ReadContext context{file_name};
  std::vector<std::string> own, settings;
  for (const std::string& text : overrides) (is_of_study(text) ? own : settings).push_back(text);
  apply_overrides(context, root, own);
  read_names_as_meant(context, root, names_of_study());
  VariantTables variants = take_variants(context, root);
  StudySpec study = StudyReader(context, root, settings, from).read();
  if (study.shaking.is_asked() && !variants.option.empty())
    throw InputError({{.file = file_name,
                       .path = "variant",
                       .value = variants.option.front().name,
                       .problem = "stands beside [shaking]: options are compared by their pushes",
                       .cure = "run one study of shakes for each option"}});
  parse_options(study, std::move(variants), {toml_text, file_name, own, settings},
                [&](auto& c, auto& t, auto s) { return StudyReader(c, t, s, from).read(); });
  return study;
}

}  // namespace io

StudySpec parse_study(const std::string& toml_text, const std::string& file_name,
                      const std::vector<std::string>& overrides) {
  return io::parse_study_text(toml_text, file_name, overrides, io::StudyText::kWritten);
}

StudySpec read_study(const std::string& path, const std::vector<std::string>& overrides) {
  return parse_study(io::read_input(path, "study.toml"), path, overrides);
}

bool is_study(const std::string& path) {
  return io::has_study(io::parse_toml(io::read_input(path, "model.toml"), path));
}

}  // namespace wythe
