// Templates list the keys of a study, its variables, shaking and records. RowWriter and RowReader visit
// them, so writing and reading agree. Models are compared without comments and blank lines, and settings
// by their effect on the model. A new key counts as a change of the study unless may_change() names it.
#include "campaign/store/study_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string_view>

#include "campaign/draws/distribution.h"
#include "core/hash.h"
#include "core/number.h"
#include "core/text.h"
#include "wythe/parts/error.h"

namespace wythe::study {
namespace {

constexpr std::size_t kLinesShown = 12;  // of a model that changed

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

[[noreturn]] void refuse(const std::string& key, const std::string& value, const char* wanted) {
  throw IoError(fmt::format("{}: \"{}\" is not {}", key, value, wanted));
}

// "0.15 Pa" -> 0.15; "" is not set.
template <class Number>
Number number_in(const std::string& key, const std::string& text) {
  const auto number = leading_number<Number>(text);
  if (!number || (!number->rest.empty() && number->rest.front() != ' '))
    refuse(key, text, "a number");
  return number->value;
}

// Writes members as rows; a member that is not set has no row.
class RowWriter {
 public:
  RowWriter(Rows& rows, std::string above) : rows_(rows), above_(std::move(above)) {}
  void text(const char* key, const std::string& value) {
    if (!value.empty()) rows_.emplace_back(above_ + key, value);
  }
  void number(const char* key, double value, const std::string& unit = "1") {
    if (std::isnan(value)) return;
    text(key, unit == "1" ? fmt::format("{}", value) : fmt::format("{} {}", value, unit));
  }
  template <class E, std::size_t N>
  void word(const char* key, E value, const Word<E> (&words)[N]) {
    text(key, word_of(words, value));
  }
  void texts(const char* key, const std::vector<std::string>& values) {
    text(key, joined(values, "\n"));
  }
  template <class Number>
  void numbers(const char* key, const std::vector<Number>& values) {
    text(key, fmt::format("{}", fmt::join(values, "\n")));
  }
  void flag(const char* key, bool value) { text(key, value ? "true" : ""); }
  void integer(const char* key, int value) { text(key, value == 0 ? "" : std::to_string(value)); }

 private:
  Rows& rows_;
  std::string above_;
};

class RowReader {
 public:
  RowReader(const std::map<std::string, std::string>& rows, std::string above)
      : rows_(rows), above_(std::move(above)) {}
  void text(const char* key, std::string& value) { value = found(key); }
  void number(const char* key, double& value, const std::string& = "1") {
    const std::string text = found(key);
    value = text.empty() ? kUnset : number_in<double>(above_ + key, text);
  }
  template <class E, std::size_t N>
  void word(const char* key, E& value, const Word<E> (&words)[N]) {
    const std::string text = found(key);
    const std::optional<E> known = wythe::value_of(words, text);
    if (!known) refuse(above_ + key, text, "a word that it can be");
    value = *known;
  }
  void texts(const char* key, std::vector<std::string>& values) { values = lines_of(found(key)); }
  template <class Number>
  void numbers(const char* key, std::vector<Number>& values) {
    for (const std::string& line : lines_of(found(key)))
      values.push_back(number_in<Number>(above_ + key, line));
  }
  void flag(const char* key, bool& value) { value = found(key) == "true"; }
  void integer(const char* key, int& value) {
    const std::string text = found(key);
    value = text.empty() ? 0 : number_in<int>(above_ + key, text);
  }

 private:
  [[nodiscard]] std::string found(const char* key) const {
    const auto at = rows_.find(above_ + key);
    return at == rows_.end() ? std::string() : at->second;
  }
  const std::map<std::string, std::string>& rows_;
  std::string above_;
};

template <class V, class Input>
void each_input(V& v, Input& i) {
  v.text("path", i.path);
  v.text("si_unit", i.si_unit);
  v.text("unit", i.unit);
}

template <class V, class Variable>
void each_variable(V& v, Variable& x) {
  each_input(v, x);
  v.word("distribution", x.distribution, kDistributionWords);
  for (const VariableParameter& p : kVariableParameters)
    v.number(p.name, x.*p.value, p.is == ParameterIs::kNumber ? "1" : x.si_unit);
  v.text("column", x.column);
  v.numbers("values", x.values);
}

template <class V, class Study>
void each_key(V& v, Study& s) {
  v.text("name", s.name);
  v.text("note", s.note);
  v.text("file", s.file);
  v.text("model_file", s.model_file);
  v.text("model", s.model_text);
  v.text("blocks", s.blocks_text);
  v.texts("settings", s.settings);
  v.word("design", s.design, kDesignWords);
  v.numbers("samples", s.batch);
  v.numbers("states_m", s.states);
  v.numbers("fractions", s.fractions);
  v.number("read_modes_at", s.read_modes_at, "m");
  v.text("until", s.until);
  v.texts("fragility", s.fragility);
  v.text("variant", s.variant);
  v.integer("variant_place", s.variant_place);
}

template <class V, class Shaking>
void each_shaking(V& v, Shaking& s) {
  v.text("stage", s.stage);
  v.word("measure", s.measure, kIntensityMeasureWords);
  v.number("period", s.period, "s");
  v.number("damping", s.damping);
  v.numbers("levels", s.levels);
  v.number("from", s.first);
  v.number("step", s.step);
  v.number("most", s.most);
  v.integer("halvings", s.halvings);
  v.word("pairing", s.pairing, kPairingWords);
}

template <class V, class Record>
void each_record(V& v, Record& r) {
  v.text("name", r.name);
  v.text("motion", r.motion);
  v.numbers("levels", r.levels);
}

struct LimitKey {
  const char* name;
  double LimitStateSpec::*value;
};
constexpr LimitKey kLimitKeys[] = {
    {"peak_drift", &LimitStateSpec::peak_drift},
    {"residual_drift", &LimitStateSpec::residual_drift},
    {"peak_displacement", &LimitStateSpec::peak_displacement},
    {"residual_displacement", &LimitStateSpec::residual_displacement},
    {"uplift", &LimitStateSpec::uplift},
    {"slip", &LimitStateSpec::slip}};

// One line for each limit state, because limit states may change on resume: name, then a tab before each limit. Collapse has none.
std::string limit_states_text(const std::vector<LimitStateSpec>& states) {
  std::vector<std::string> lines;
  for (const LimitStateSpec& state : states) {
    std::string& line = lines.emplace_back(state.name);
    for (const LimitKey& key : kLimitKeys)
      if (!std::isnan(state.*key.value)) line += fmt::format("\t{}={}", key.name, state.*key.value);
  }
  return joined(lines, "\n");
}

std::vector<LimitStateSpec> limit_states_of(const std::string& text) {
  std::vector<LimitStateSpec> states;
  for (const std::string& line : lines_of(text)) {
    LimitStateSpec& state = states.emplace_back();
    std::size_t tab = std::min(line.find('\t'), line.size());
    state.name = line.substr(0, tab);
    state.collapse = tab == line.size();
    while (tab < line.size()) {
      const std::size_t next = std::min(line.find('\t', tab + 1), line.size());
      const std::string part = line.substr(tab + 1, next - tab - 1);
      const std::size_t equals = std::min(part.find('='), part.size());
      const auto key =
          std::find_if(std::begin(kLimitKeys), std::end(kLimitKeys),
                       [&](const auto& k) { return part.substr(0, equals) == k.name; });
      if (key == std::end(kLimitKeys)) refuse("limit_states", part, "a limit");
      state.*key->value =
          number_in<double>("limit_states", part.substr(std::min(equals + 1, part.size())));
      tab = next;
    }
  }
  return states;
}

void add_shaking(const StudySpec& spec, Rows& rows) {
  if (spec.shaking.is_asked()) {
    RowWriter writer(rows, "shaking.");
    each_shaking(writer, spec.shaking);
  }
  RowWriter root(rows, "");
  std::vector<std::string> names, files;
  for (const StudyRecord& record : spec.shaking.record) names.push_back(record.name);
  root.texts("records", names);
  for (std::size_t i = 0; i < names.size(); ++i) {
    RowWriter writer(rows, fmt::format("record.{}.", i));
    each_record(writer, spec.shaking.record[i]);
  }
  root.text("limit_states", limit_states_text(spec.shaking.limit_state));
  for (const auto& [name, text] : spec.record_text) files.push_back(name);
  root.texts("record_files", files);
  for (const auto& [name, text] : spec.record_text)
    root.text(("record_text." + name).c_str(), text);
}

void load_shaking(const std::map<std::string, std::string>& known, const Rows& rows,
                  StudySpec& spec) {
  if (known.contains("shaking.stage")) {
    RowReader reader(known, "shaking.");
    each_shaking(reader, spec.shaking);
  }
  const std::size_t records = lines_of(value_of(rows, "records")).size();
  for (std::size_t i = 0; i < records; ++i) {
    RowReader reader(known, fmt::format("record.{}.", i));
    each_record(reader, spec.shaking.record.emplace_back());
  }
  spec.shaking.limit_state = limit_states_of(value_of(rows, "limit_states"));
  for (const std::string& name : lines_of(value_of(rows, "record_files")))
    spec.record_text[name] = value_of(rows, "record_text." + name);
}

template <class Input>
std::vector<std::string> names_of(const std::vector<Input>& inputs) {
  std::vector<std::string> names;
  for (const Input& input : inputs) names.push_back(input.name);
  return names;
}

bool may_change(const std::string& key) {
  static const std::set<std::string> kFree = {
      "name",  "note",      "file",    "model_file",    "samples",
      "until", "fragility", "variant", "variant_place", "limit_states"};
  return kFree.contains(key);
}

// The lines of a model that have a meaning in TOML: without comments, surrounding blanks and empty lines.
std::vector<std::string> meaningful_lines(const std::string& text) {
  std::vector<std::string> lines;
  for (const std::string& line : lines_of(text)) {
    char quote = 0;
    std::size_t end = 0;
    for (; end < line.size() && (quote != 0 || line[end] != '#'); ++end) {
      if (quote == 0 && (line[end] == '"' || line[end] == '\''))
        quote = line[end];
      else if (line[end] == quote)
        quote = 0;
    }
    const std::string kept(trimmed(std::string_view(line).substr(0, end)));
    if (!kept.empty()) lines.push_back(kept);
  }
  return lines;
}

void add_model_changes(const std::string& was, const std::string& is, const std::string& store,
                       const std::string& then, std::vector<Fault>& faults) {
  const std::vector<std::string> before = meaningful_lines(was), now = meaningful_lines(is);
  if (before == now) return;
  std::vector<Fault> found;
  const auto compare = [&](const auto& these, const auto& others, const std::string& problem) {
    for (const std::string& line : these)
      if (std::find(others.begin(), others.end(), line) == others.end())
        found.push_back({.file = store, .path = "model", .value = line, .problem = problem});
  };
  compare(before, now, fmt::format("stood in the model {} and does not now", then));
  compare(now, before, fmt::format("did not stand in the model {}", then));
  if (found.empty())
    found.push_back({.file = store, .path = "model", .problem = "its lines were in another order"});
  if (found.size() > kLinesShown) found.resize(kLinesShown);
  faults.insert(faults.end(), found.begin(), found.end());
}

}  // namespace

std::map<std::string, std::string> in_effect(const std::vector<std::string>& settings) {
  std::map<std::string, std::string> last;
  for (const std::string& line : settings) {
    const std::size_t equals = std::min(line.find('='), line.size());
    const std::string path(trimmed(line.substr(0, equals)));
    // a whole table replaces the settings within it
    std::erase_if(last, [&](const auto& set) { return set.first.starts_with(path + '.'); });
    last[path] = trimmed(line.substr(std::min(equals + 1, line.size())));
  }
  return last;
}

std::string value_of(const Rows& rows, const std::string& key) {
  for (const auto& [name, value] : rows)
    if (name == key) return value;
  return "";
}

Rows rows_of(const StudySpec& spec) {
  Rows rows;
  RowWriter root(rows, "");
  each_key(root, spec);
  root.text("seed", std::to_string(spec.seed));
  root.texts("variables", names_of(spec.variable));
  for (const VariableSpec& variable : spec.variable) {
    RowWriter writer(rows, "variable." + variable.name + ".");
    each_variable(writer, variable);
  }
  root.texts("dependents", names_of(spec.dependent));
  for (const DependentSpec& dependent : spec.dependent) {
    RowWriter writer(rows, "dependent." + dependent.name + ".");
    each_input(writer, dependent);
    writer.text("formula", dependent.formula);
  }
  root.texts("fields", names_of(spec.field));
  for (const StudyField& field : spec.field) {
    RowWriter writer(rows, "field." + field.name + ".");
    writer.text("path", field.path);
    writer.flag("follows", field.follows);
  }
  for (std::size_t i = 0; i < spec.correlation.size(); ++i) {
    const CorrelationSpec& pair = spec.correlation[i];
    RowWriter writer(rows, fmt::format("correlation.{}.", i));
    writer.text("a", pair.a);
    writer.text("b", pair.b);
    writer.number("value", pair.value);
    writer.flag("rank", pair.rank);
  }
  add_shaking(spec, rows);
  return rows;
}

StudySpec study_of(const Rows& rows) {
  const std::map<std::string, std::string> known(rows.begin(), rows.end());
  StudySpec spec;
  RowReader root(known, "");
  each_key(root, spec);
  spec.seed = number_in<std::uint64_t>("seed", value_of(rows, "seed"));
  for (const std::string& name : lines_of(value_of(rows, "variables"))) {
    VariableSpec& variable = spec.variable.emplace_back();
    variable.name = name;
    RowReader reader(known, "variable." + name + ".");
    each_variable(reader, variable);
  }
  for (const std::string& name : lines_of(value_of(rows, "dependents"))) {
    DependentSpec& dependent = spec.dependent.emplace_back();
    dependent.name = name;
    RowReader reader(known, "dependent." + name + ".");
    each_input(reader, dependent);
    reader.text("formula", dependent.formula);
  }
  for (const std::string& name : lines_of(value_of(rows, "fields"))) {
    StudyField& field = spec.field.emplace_back();
    field.name = name;
    RowReader reader(known, "field." + name + ".");
    reader.text("path", field.path);
    reader.flag("follows", field.follows);
  }
  for (std::size_t i = 0; known.contains(fmt::format("correlation.{}.a", i)); ++i) {
    CorrelationSpec& pair = spec.correlation.emplace_back();
    RowReader reader(known, fmt::format("correlation.{}.", i));
    reader.text("a", pair.a);
    reader.text("b", pair.b);
    reader.number("value", pair.value);
    reader.flag("rank", pair.rank);
  }
  load_shaking(known, rows, spec);
  return spec;
}

std::string identity_of(const StudySpec& spec) {
  std::map<std::string, std::string> known;
  for (const auto& [key, value] : rows_of(spec))
    if (!may_change(key) && !value.empty()) known[key] = value;
  Hash hash;
  const auto add = [&](const std::string& text) { hash.add(text.c_str(), text.size() + 1); };
  for (const auto& [key, value] : known) {
    add(key);
    if (key == "settings")
      for (const auto& [path, set] : in_effect(lines_of(value))) add(path), add(set);
    else if (key == "model")
      for (const std::string& line : meaningful_lines(value)) add(line);
    else
      add(value);
  }
  return hash.text();
}

std::vector<Fault> changes(const StudySpec& was, const StudySpec& is, const std::string& store,
                           const std::string& then) {
  const Rows before = rows_of(was), now = rows_of(is);
  std::vector<Fault> faults;
  const auto add = [&](const std::string& key, const std::string& old, const std::string& value) {
    if (may_change(key) || key == "model" || old == value) return;
    if (key == "settings" && in_effect(lines_of(old)) == in_effect(lines_of(value))) return;
    if (key == "blocks") {
      faults.push_back(
          {.file = store, .path = "wall.blocks", .problem = "holds other blocks than " + then});
      return;
    }
    if (key.starts_with("record_text.")) {
      faults.push_back({.file = store,
                        .path = key.substr(key.find('.') + 1),
                        .problem = "holds another record than " + then});
      return;
    }
    const auto shown = [](const std::string& text) {
      return text.empty() ? std::string("not given")
                          : fmt::format("{}", fmt::join(lines_of(text), ", "));
    };
    faults.push_back(
        {.file = store,
         .path = key,
         .problem = fmt::format("was {} {}, is {} now", shown(old), then, shown(value))});
  };
  for (const auto& [key, value] : before) add(key, value, value_of(now, key));
  for (const auto& [key, value] : now)
    if (value_of(before, key).empty()) add(key, "", value);
  add_model_changes(was.model_text, is.model_text, store, then, faults);
  if (!faults.empty())
    faults.back().cure =
        "put it back as it was, or begin another campaign in another folder (nothing stored was "
        "touched)";
  return faults;
}

}  // namespace wythe::study
