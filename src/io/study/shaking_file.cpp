// The study's tables of records: TOML -> ShakingSpec. A record becomes a setting of the base model,
// as TOML. The text of its file is stored with it, so that a stored study needs no other file.
#include "io/study/shaking_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>

#include "core/files.h"
#include "core/text.h"
#include "io/keys/describe_records.h"
#include "io/model/record_file.h"
#include "io/text/toml_writer.h"
#include "model/compiler.h"
#include "wythe/parts/io.h"
#include "wythe/parts/units.h"

namespace wythe::io {
namespace {

namespace fs = std::filesystem;

constexpr double kMostLevels = 200;  // of a record: each is a run

std::string inline_text(const toml::node& node);

std::string inline_table(const toml::table& table) {
  std::vector<std::string> parts;
  for (const auto& [key, value] : table)
    parts.push_back(key_text(std::string(key.str())) + " = " + inline_text(value));
  return "{ " + joined(parts, ", ") + " }";
}

// A node on one line, which TOML reads again to the bit.
std::string inline_text(const toml::node& node) {
  if (const toml::table* table = node.as_table()) return inline_table(*table);
  if (const auto* text = node.as_string()) return quoted(text->get());
  if (const auto* number = node.as_floating_point()) {
    const std::string digits = fmt::format("{}", number->get());
    return digits.find_first_of(".en") == std::string::npos ? digits + ".0" : digits;
  }
  if (const auto* number = node.as_integer()) return fmt::format("{}", number->get());
  if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
  std::vector<std::string> parts;
  if (const toml::array* list = node.as_array())
    for (const toml::node& item : *list) parts.push_back(inline_text(item));
  return "[" + joined(parts, ", ") + "]";
}

// The path of a file beside the study, relative to the base model.
std::string from_model(const StudySpec& study, const std::string& file) {
  const fs::path path(file);
  if (path.is_absolute()) return file;
  const fs::path found =
      (fs::path(study.file).parent_path() / path)
          .lexically_normal()
          .lexically_relative(fs::path(study.model_file).parent_path().lexically_normal() / "");
  return found.empty() ? file : found.generic_string();
}

class ShakingReader {
 public:
  ShakingReader(ReadContext& context, const toml::table& root, const ModelSpec& base,
                StudySpec& study)
      : context_(context), root_(root), base_(base), study_(study), out_(study.shaking) {}

  void run() {
    const toml::node* node = root_.get("shaking");
    const toml::table* table = node != nullptr ? node->as_table() : nullptr;
    if (table == nullptr) return refuse_alone(node);
    if (refuse_other_measure(*table)) return;
    TableReader reader(context_, *table, "shaking");
    describe(reader, out_);
    reader.refuse_unknown();
    if (!reader.has("measure"))
      reader.miss("measure", "is missing, intensities mean nothing without it",
                  "write measure = \"pga\", \"pgv\" or \"sa\"");
    check_measure(reader);
    check_levels(reader);
    find_stage(reader);
    parse_records();
    parse_limit_states();
    if (out_.stage.empty()) out_.stage = "?";  // requested, but with faults
  }

 private:
  // Refuses intensities that all have another measure than the named one, as one mistake.
  bool refuse_other_measure(const toml::table& table) {
    const auto named = table["measure"].value<std::string>().value_or("");
    const bool of_velocity = named == "pgv";
    if (!of_velocity && named != "pga" && named != "sa") return false;
    std::vector<std::string> texts;
    for (const char* key : {"from", "step", "most"})
      if (const auto text = table[key].value<std::string>()) texts.push_back(*text);
    if (const toml::array* list = table["levels"].as_array())
      for (const toml::node& item : *list) texts.push_back(shown(item));
    const auto is_other = [&](const std::string& text) {
      try {
        (void)parse_quantity(text, of_velocity ? "m/s^2" : "m/s");
        return true;
      } catch (const std::invalid_argument&) {
        return false;
      }
    };
    if (texts.empty() || !std::all_of(texts.begin(), texts.end(), is_other)) return false;
    context_.fault("shaking.measure", line_of(*table.get("measure")), named,
                   fmt::format("is {}, and the intensities are {}",
                               of_velocity ? "a velocity" : "an acceleration",
                               of_velocity ? "accelerations" : "velocities"),
                   of_velocity ? "write measure = \"pga\", or the intensities in m/s"
                               : "write measure = \"pgv\", or the intensities in m/s^2");
    out_.stage = "?";  // requested, but with faults
    return true;
  }

  // Refuses tables about shakes that are not requested.
  void refuse_alone(const toml::node* node) {
    if (node != nullptr)
      return context_.fault("shaking", line_of(*node), shown(*node), "must be a table",
                            "write [shaking] and under it measure and levels");
    for (const char* part : {"record", "limit_state"})
      if (const toml::node* other = root_.get(part))
        context_.fault(part, line_of(*other), "", "stands without [shaking]",
                       "write [shaking] and under it measure and levels");
  }

  void check_measure(TableReader& reader) {
    const bool of_sa = out_.measure == IntensityMeasure::kSa;
    for (const auto& [key, value] : {std::pair("period", out_.period), {"damping", out_.damping}}) {
      if (of_sa && !reader.has(key))
        reader.miss(key, "is missing, a spectral acceleration needs it",
                    "write e.g. period = \"0.3 s\" and damping = 0.05");
      if (!of_sa && reader.has(key))
        reader.refuse(key, "belongs to measure = \"sa\"", "leave it out");
    }
  }

  void check_rising(const std::string& path, int line, const std::vector<double>& levels) {
    for (std::size_t i = 1; i < levels.size(); ++i)
      if (!(levels[i] > levels[i - 1]))
        return context_.fault(path, line, fmt::format("{:g} after {:g}", levels[i], levels[i - 1]),
                              "do not rise", "sort them, and write each once");
    if (static_cast<double>(levels.size()) > kMostLevels)
      context_.fault(path, line, fmt::format("{}", levels.size()),
                     fmt::format("are too many, at most {:g}", kMostLevels), "write fewer");
  }

  void check_levels(TableReader& reader) {
    const bool listed = reader.has("levels");
    const bool climbs = reader.has("from") || reader.has("step") || reader.has("most");
    if (listed && climbs)
      return reader.refuse("levels", "stands beside from, step, most",
                           "leave one of the two ways out");
    if (listed) {
      if (context_.has_fault_in("shaking.levels")) return;
      if (out_.levels.empty())
        reader.refuse("levels", "is empty", "write e.g. levels = [\"1 m/s^2\", \"2 m/s^2\"]");
      check_rising("shaking.levels", line_of(*root_["shaking"]["levels"].node()), out_.levels);
    }
    if (reader.has("halvings") && !climbs)
      reader.refuse("halvings", "belongs to from, step, most", "leave it out");
    if (!climbs) return;
    bool whole = true;
    for (const char* key : {"from", "step", "most"})
      if (!reader.has(key)) {
        whole = false;
        reader.miss(key, "is missing: intensities rise from `from` by `step` up to `most`");
      }
    if (!whole || !is_set(out_.first) || !is_set(out_.step) || !is_set(out_.most)) return;
    if (!(out_.most >= out_.first))
      return reader.refuse("most", "is less than from", "write a higher one");
    if ((out_.most - out_.first) / out_.step > kMostLevels)
      reader.refuse("step", fmt::format("makes more than {:g} intensities", kMostLevels),
                    "write a larger one");
  }

  void find_stage(TableReader& reader) {
    if (base_.stage.empty()) return;  // the model has faults
    std::vector<std::string> shakes;
    for (const StageSpec& stage : base_.stage) {
      if (stage.kind() == StageKind::kShake) shakes.push_back(stage.name);
      if (stage.kind() == StageKind::kPush || stage.kind() == StageKind::kTilt)
        reader.refuse_table(
            fmt::format("asks for shakes of a model whose stage {} pushes or tilts", stage.name),
            "leave that stage out: a study with records tells of shakes alone");
    }
    if (shakes.empty())
      return reader.refuse_table("needs a stage of the base model with a record",
                                 "give the model a stage with record = { ... }");
    if (out_.stage.empty() && shakes.size() == 1) out_.stage = shakes.front();
    if (out_.stage.empty())
      return reader.miss("stage", "is missing, the base model shakes in " + joined(shakes, ", "),
                         "name one of them");
    if (out_.stage.find_first_of(".=") != std::string::npos)
      return reader.refuse_table("exchanges the record of a stage whose name has a . or =",
                                 "give the stage a name without them");
    if (std::find(shakes.begin(), shakes.end(), out_.stage) == shakes.end())
      return reader.refuse("stage", "is no stage of the base model with a record",
                           "write " + joined(shakes, " or "));
    for (const StageSpec& stage : base_.stage)
      if (const auto records = records_of(stage); stage.name == out_.stage && !records.empty())
        direction_ = word_of(kDirectionWords, records.front().direction);
  }

  // The tables under [[name]].
  std::vector<const toml::table*> tables(const char* name, const char* cure) {
    std::vector<const toml::table*> out;
    const toml::node* node = root_.get(name);
    if (node == nullptr) return out;
    const toml::array* list = node->as_array();
    if (list == nullptr || !std::all_of(list->begin(), list->end(),
                                        [](const toml::node& item) { return item.is_table(); })) {
      context_.fault(name, line_of(*node), shown(*node), "must be a list of tables", cure);
      return out;
    }
    for (const toml::node& item : *list) out.push_back(item.as_table());
    return out;
  }

  void parse_records() {
    const auto found = tables("record", "write each under [[record]], with two brackets");
    if (found.empty() && !context_.has_fault_at("record"))
      context_.fault("record", line_of(*root_.get("shaking")), "", "is missing",
                     "write [[record]] and under it name, file and unit, for each record");
    std::set<std::string> names;
    for (std::size_t i = 0; i < found.size() && !enough(context_.faults); ++i) {
      const std::string path = under("record", std::to_string(i));
      parse_record(*found[i], path);
      const std::string& name = out_.record.back().name;
      if (!name.empty() && !names.insert(name).second)
        context_.fault(under(path, "name"), line_of(*found[i]), name, "stands there twice",
                       "give each record a name of its own");
    }
  }

  void parse_record(const toml::table& table, const std::string& path) {
    StudyRecord& record = out_.record.emplace_back();
    // the stage's record reads its keys, so only the study's own are parsed here
    TableReader reader(context_, table, path);
    reader.text("name", record.name, {});
    if (record.name.empty() && !context_.has_fault_at(under(path, "name")))
      reader.miss("name", "is missing", "write e.g. name = \"Aigio\"");
    check_name(reader, record.name);
    const char* const unit = unit_of(out_.measure);
    reader.quantities(
        "levels", record.levels,
        {.unit = unit,
         .shown = unit,
         .range = kPositive,
         .example = out_.measure == IntensityMeasure::kPgv ? R"(["0.2 m/s", "0.4 m/s"])"
                                                           : R"(["1 m/s^2", "2 m/s^2"])"});
    if (table.contains("levels") && !context_.has_fault_in(under(path, "levels")))
      check_rising(under(path, "levels"), line_of(table), record.levels);
    if (record.levels.empty() && out_.levels.empty() && !out_.climbs() &&
        !context_.has_fault_in("shaking") && !context_.has_fault_in(under(path, "levels")))
      reader.refuse_table("has no intensities",
                          "write levels under [shaking] or here, or from, step and most there");
    if (!record.levels.empty() && out_.climbs())
      reader.refuse("levels", "stands beside from, step, most of [shaking]",
                    "leave one of the two ways out");
    record.motion = motion_of(table, path);
  }

  static void check_name(TableReader& reader, const std::string& name) {
    if (std::any_of(name.begin(), name.end(), [](unsigned char c) { return c < ' '; }))
      reader.refuse("name", "has a character that cannot be shown", "write it on one line");
  }

  // The record's only component, or those listed under `component`.
  std::string motion_of(const toml::table& table, const std::string& path) {
    std::vector<std::string> parts;
    const toml::node* listed = table.get("component");
    if (listed == nullptr) {
      toml::table only = table;
      only.erase("name");
      only.erase("levels");
      return "[" + component(std::move(only), path, true) + "]";
    }
    const toml::array* list = listed->as_array();
    const bool good = list != nullptr && !list->empty() &&
                      std::all_of(list->begin(), list->end(),
                                  [](const toml::node& item) { return item.is_table(); });
    if (!good) {
      context_.fault(under(path, "component"), line_of(*listed), shown(*listed),
                     "must be a list of tables",
                     "write component = [{ file = ..., unit = ... }, ...]");
      return "[]";
    }
    for (const auto& [key, value] : table)
      if (key != "name" && key != "levels" && key != "component")
        context_.fault(under(path, std::string(key.str())), line_of(value), shown(value),
                       "stands beside component", "write it inside the component");
    for (std::size_t k = 0; k < list->size(); ++k)
      parts.push_back(
          component(*list->get(k)->as_table(), fmt::format("{}.component.{}", path, k), k == 0));
    return "[" + joined(parts, ", ") + "]";
  }

  std::string component(toml::table table, const std::string& path, bool is_first) {
    if (is_first && !table.contains("direction") && !direction_.empty())
      table.insert("direction", direction_);
    if (const auto* file = table.get_as<std::string>("file")) {
      const std::string given = file->get();
      if (root_["record_text"][given]) return inline_table(table);  // the study has the text
      const std::string name = from_model(study_, given);
      attach(name, (fs::path(context_.file).parent_path() / given).string(), path);
      table.insert_or_assign("file", name);
    }
    return inline_table(table);
  }

  void attach(const std::string& name, const std::string& file, const std::string& path) {
    if (study_.record_text.contains(name)) return;
    try {
      study_.record_text[name] = read_text(file, kMostCsv);
    } catch (const std::runtime_error& error) {
      const std::string near = nearest_file(file);
      context_.fault(under(path, "file"), line_of(*root_.get("record")), file, error.what(),
                     near.empty() ? "the path counts from the folder of the study file"
                                  : fmt::format("did you mean {}?",
                                                (fs::path(file).parent_path() / near).string()));
    }
  }

  void parse_limit_states() {
    const auto found = tables("limit_state", "write each under [[limit_state]], with two brackets");
    std::set<std::string> names;
    for (std::size_t i = 0; i < found.size() && !enough(context_.faults); ++i) {
      const std::string path = under("limit_state", std::to_string(i));
      LimitStateSpec& state = out_.limit_state.emplace_back();
      TableReader reader(context_, *found[i], path);
      describe(reader, state);
      reader.refuse_unknown();
      if (state.name.empty() && !context_.has_fault_at(under(path, "name")))
        reader.miss("name", "is missing", "write e.g. name = \"damage\"");
      else if (!names.insert(state.name).second)
        reader.refuse("name", "stands there twice", "give each limit state a name of its own");
      check_name(reader, state.name);
      const int limits = static_cast<int>(std::count_if(
          reader.entries().begin(), reader.entries().end(),
          [](const auto& e) { return e.node && e.name != "name" && e.name != "collapse"; }));
      if (limits == 0 && !state.collapse)
        reader.refuse_table("has no limit", "write e.g. peak_drift = \"1 %\", or collapse = true");
      if (limits > 0 && state.collapse)
        reader.refuse("collapse", "stands beside other limits, which collapse reaches too",
                      "leave it out, or make it a limit state of its own");
    }
  }

  ReadContext& context_;
  const toml::table& root_;
  const ModelSpec& base_;
  StudySpec& study_;
  ShakingSpec& out_;
  std::string direction_;  // of the record that is exchanged
};

// Rewrites "stage.quake.record.0.unit" of the model as `unit` of the study's record, "stage.1.record.1.unit" as component.1.unit.
void as_in_study(std::string& text) {
  static const std::regex kFirst(R"(stage\.[^\s.]+\.record\.0\.)"),
      kOther(R"(stage\.[^\s.]+\.record\.(\d+)\.)"), kModel("the model file states");
  text = std::regex_replace(text, kFirst, "");
  text = std::regex_replace(text, kOther, "component.$1.");
  text = std::regex_replace(text, kModel, "the record states");
}

// A fault of the setting for a record, placed at the record.
Fault at_record(Fault fault, const StudySpec& study, const std::string& name, int line) {
  for (std::string* text : {&fault.path, &fault.problem, &fault.cure}) as_in_study(*text);
  fault.path = fmt::format("record \"{}\": {}", name, fault.path);
  if (fault.file == "--set" || fault.file.empty() || fault.file == study.model_file) {
    fault.file = study.file;
    fault.line = line;
  }
  return fault;
}

}  // namespace

std::map<std::string, std::string> given_records(ReadContext& context, const toml::table& root) {
  std::map<std::string, std::string> out;
  const toml::node* node = root.get("record_text");
  if (node == nullptr) return out;
  const toml::table* table = node->as_table();
  if (table == nullptr)
    context.fault("record_text", line_of(*node), shown(*node), "must be a table",
                  "leave it out: the program writes it");
  else
    for (const auto& [name, text] : *table)
      if (const auto* value = text.as_string()) out[std::string(name.str())] = value->get();
  return out;
}

void parse_shaking(ReadContext& context, const toml::table& root, const ModelSpec& base,
                   StudySpec& study) {
  for (const StageSpec& stage : base.stage)
    for (const RecordSpec& record : records_of(stage))
      if (!record.file.empty() && !study.record_text.contains(record.file))
        study.record_text[record.file] =
            read_text((fs::path(base.folder) / record.file).string(), kMostCsv);
  ShakingReader(context, root, base, study).run();
}

void check_records(const StudySpec& study, const toml::table& root) {
  const ShakingSpec& shaking = study.shaking;
  if (!shaking.is_asked()) return;
  const auto with = [&](const std::vector<std::string>& settings) {
    return parse_model(study.model_text, study.model_file, settings, study.blocks_text,
                       study.record_text);
  };
  std::unique_ptr<Compiler> compiler;
  try {
    compiler = std::make_unique<Compiler>(with(study.settings));
  } catch (const InputError&) {
    return;  // the base model does not compile, which is reported there
  }
  std::vector<Fault> faults;
  for (std::size_t i = 0; i < shaking.record.size(); ++i) {
    const StudyRecord& record = shaking.record[i];
    const std::vector<double>& levels = record.levels.empty() ? shaking.levels : record.levels;
    std::vector<std::string> settings = study.settings;
    settings.push_back(fmt::format("stage.{}.record={}", shaking.stage, record.motion));
    settings.push_back(intensity_setting(shaking, shaking.climbs() ? shaking.most : levels.back()));
    try {
      static_cast<void>(compiler->compile(with(settings)));
    } catch (const InputError& error) {
      const toml::array* list = root["record"].as_array();
      const int line = list != nullptr ? line_of(*list->get(i)) : 0;
      for (const Fault& fault : error.faults()) {
        Fault own = at_record(fault, study, record.name, line);
        const bool is_told = std::any_of(faults.begin(), faults.end(),
                                         [&](const Fault& told) { return told.path == own.path; });
        if (!is_told) faults.push_back(std::move(own));  // a refused value is also missing
      }
    }
  }
  if (!faults.empty()) throw InputError(std::move(faults));
}

std::string shaking_text(const StudySpec& study) {
  std::string out;
  ShakingSpec shaking = study.shaking;
  if (shaking.is_asked()) {
    Writer writer("");
    describe(writer, shaking);
    out += "\n[shaking]\n" + writer.text();
  }
  for (const StudyRecord& record : shaking.record) {
    out += "\n[[record]]\nname = " + quoted(record.name) + "\n";
    std::vector<std::string> levels;
    for (const double level : record.levels)
      levels.push_back(quoted(fmt::format("{} {}", level, unit_of(shaking.measure))));
    if (!levels.empty()) out += "levels = [" + joined(levels, ", ") + "]\n";
    out += "component = " + record.motion + "\n";
  }
  for (LimitStateSpec& state : shaking.limit_state) {
    Writer writer("");
    describe(writer, state);
    out += "\n[[limit_state]]\n" + writer.text();
  }
  if (!study.record_text.empty()) out += "\n[record_text]\n";
  for (const auto& [name, text] : study.record_text)
    out += key_text(name) + " = " + quoted(text) + "\n";
  return out;
}

}  // namespace wythe::io
