// The studies of `wythe compare` of models: each model's walls, pushed both ways.
// Differences that make models incomparable are refused here, before a wall is pushed.
//
//   before.toml ─► study: walls 1 ... n, own way and [[variant]] the other way ─┐
//   after.toml  ─► study: the same walls, where the opening leaves them as they were ─┴─► compare_models()
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/files.h"
#include "io/bodies/blocks_json.h"
#include "io/keys/same_spec.h"
#include "io/study/study_file.h"
#include "io/text/toml_reader.h"
#include "io/text/toml_writer.h"
#include "judge/assessment/assessment_parts.h"
#include "wythe/parts/comparison.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"
#include "wythe/parts/reading.h"

namespace wythe {
namespace {

struct ReadModel {
  std::string file;
  ModelSpec spec;
  Model model;
  std::vector<PushWay> way;
};

// Units and joints are drawn by their place, so that an opening does not change the others.
std::string in_place(const ModelSpec& spec) {
  std::string settings;
  for (const auto& [name, field] : spec.field)
    if (field.formula.empty() && field.by != FieldBy::kPlace)
      settings += fmt::format("{}, ", io::quoted(fmt::format("field.{}.in_place=true", name)));
  return settings.empty() ? "" : "set = [" + settings + "]\n";
}

// --- keys that must be equal -----------------------------------------------------------------------------

// Keys that an intervention does not change: size, loading,
// computation and judgement. Names and remarks may differ.
bool must_agree(const std::string& path, bool scatter) {
  if (path.ends_with(".name") || path.ends_with(".note")) return false;
  for (const char* head : {"stage.", "solve.", "scatter.", "assessment."})
    if (path.starts_with(head)) return true;
  for (const char* key : {"wall.length", "wall.height"})
    if (path == key) return true;
  // scatter is drawn unit by unit
  return scatter && (path == "wall.unit.length" || path == "wall.unit.height");
}

// The reason why a key must be equal, by the first part of its path.
std::string reason_of(const std::string& path) {
  if (path.starts_with("stage."))
    return "a wall that is loaded or pushed in another way is no other wall";
  if (path.starts_with("solve.")) return "the difference would be partly that of the computation";
  if (path.starts_with("scatter.")) return "the walls would scatter in another way";
  if (path.starts_with("assessment.")) return "the capacities would be judged by other rules";
  if (path.starts_with("wall.unit."))
    return "walls of other units cannot share what is drawn for each unit";
  return "drifts and forces of another wall are no change of this one";
}

std::map<std::string, std::string> members_of(const ModelSpec& spec, bool scatter) {
  std::map<std::string, std::string> out;
  for (auto& [path, value] : io::flatten(spec))
    if (must_agree(path, scatter)) out[path] = value;
  return out;
}

// The shortest beginning of a path that no key of `others` has: a list's member, a table, or the path itself.
std::string own_part(const std::string& path, const std::map<std::string, std::string>& others) {
  for (std::size_t end = path.find('.'); end != std::string::npos; end = path.find('.', end + 1)) {
    const std::string part = path.substr(0, end + 1);
    const auto next = others.lower_bound(part);
    if (next == others.end() || !next->first.starts_with(part)) return path.substr(0, end);
  }
  return path;
}

// Keys with their values as a file states them, without names, remarks and sizes of lists.
io::Flatten::Members stated_keys(const ModelSpec& spec) {
  io::Flatten::Members out = io::flatten(spec, io::Flatten::kReadable);
  std::erase_if(out, [](const auto& member) {
    const std::string& path = member.first;
    return path == "name" || path.ends_with(".name") || path.ends_with(".note") ||
           path.ends_with(".origin") || path.ends_with(".size");
  });
  return out;
}

// Faults of the second model, at its own keys.
std::vector<Fault> differences(const ReadModel& base, const ReadModel& other) {
  constexpr std::size_t kMost = 8;  // one more stage changes all that follow
  std::vector<Fault> faults;
  const auto add = [&](const std::string& path, const std::string& problem,
                       const std::string& cure) {
    if (faults.size() < kMost) faults.push_back({"", path, "", problem, cure, 0});
  };
  const auto kind = [](const Model& model) {
    return dimension_of(model) == 3 ? "in space" : "in its plane";
  };
  if (dimension_of(base.model) != dimension_of(other.model)) {
    add("wall",
        fmt::format("is a wall {}, and that of {} is one {}", kind(other.model), base.file,
                    kind(base.model)),
        "model both in their plane, or both in space");
    return faults;
  }
  const bool scatter = base.spec.draws_fields();
  if (scatter != other.spec.draws_fields()) {
    add("scatter",
        fmt::format("{} in {} and {} here", scatter ? "is given" : "is missing", base.file,
                    scatter ? "is missing" : "is given"),
        "write the same [scatter] in both, or in none");
    return faults;
  }
  if (base.spec.stage.size() != other.spec.stage.size()) {
    add("stage",
        fmt::format("has {} stages, and {} has {}: {}", other.spec.stage.size(), base.file,
                    base.spec.stage.size(), reason_of("stage.")),
        "write the same stages in both");
    return faults;
  }
  const auto was = members_of(base.spec, scatter), is = members_of(other.spec, scatter);
  for (const auto& [path, value] : is) {
    const auto before = was.find(path);
    if (before != was.end() && before->second == value) continue;
    add(path.ends_with(".size") ? path.substr(0, path.size() - 5) : path,
        fmt::format("is not that of {}: {}", base.file, reason_of(path)),
        "write the same in both files");
  }
  for (const auto& [path, value] : was)
    if (!is.contains(path))
      add(path.substr(0, path.rfind('.')),
          fmt::format("has no {}, which {} has: {}", path.substr(path.rfind('.') + 1), base.file,
                      reason_of(path)),
          "write the same in both files");
  for (const auto& [name, field] : base.spec.field) {
    const auto found = other.spec.field.find(name);
    const bool alike = found != other.spec.field.end() && found->second.cov == field.cov &&
                       found->second.by == field.by &&
                       found->second.distribution == field.distribution;
    if (field.formula.empty() && !alike && !(std::isnan(field.cov)))
      add("field",
          fmt::format("varies {} in another way than {}, or not at all: the walls would scatter in "
                      "another way",
                      field.path, base.file),
          "write the same [scatter] and [field] in both files");
  }
  return faults;
}

ReadModel read_one(const std::string& file, const std::vector<std::string>& overrides) {
  ReadModel out{.file = file, .spec = read_model(file, overrides), .model = {}, .way = {}};
  out.model = compile(out.spec);
  try {
    // for a PGA, each model is pushed as in wythe assess, in two patterns where possible
    out.way = says_pga(out.spec.assessment) ? ways_of(out.spec, out.model).ways
                                            : study::both_directions(out.spec, out.model).ways;
  } catch (const InputError& error) {
    throw InputError(out.spec.places->placed(error.faults()));
  }
  return out;
}

}  // namespace

std::vector<std::string> model_differences(const ModelSpec& base, const ModelSpec& other) {
  const io::Flatten::Members was = stated_keys(base), is = stated_keys(other);
  const std::map<std::string, std::string> before(was.begin(), was.end()),
      after(is.begin(), is.end());
  std::vector<std::string> out;
  const auto add_own = [&](const char* sign, const auto& members, const auto& others) {
    for (const auto& [path, value] : members) {
      if (others.contains(path)) continue;
      const std::string part = own_part(path, others);
      const std::string line =
          fmt::format("{} {}{}", sign, part, part == path ? " = " + value : "");
      if (std::find(out.begin(), out.end(), line) == out.end()) out.push_back(line);
    }
  };
  for (const auto& [path, value] : is) {
    const auto then = before.find(path);
    if (then != before.end() && then->second != value)
      out.push_back(fmt::format("{}: {} → {}", path, then->second, value));
  }
  add_own("+", is, before);
  add_own("−", was, after);
  // files of one name may have other contents
  if (!other.wall.blocks.empty() && io::blocks_text(base) != io::blocks_text(other))
    out.push_back("wall.blocks: other blocks");
  for (std::size_t k = 0; k < std::min(base.stage.size(), other.stage.size()); ++k) {
    const auto values = [](const StageSpec& stage) {
      std::vector<std::vector<double>> all;
      for (const RecordSpec& record : records_of(stage))
        all.insert(all.end(), {record.read_times, record.read_accelerations});
      return all;
    };
    if (values(base.stage[k]) != values(other.stage[k]))
      out.push_back(fmt::format("stage.{}.record: other accelerations", other.stage[k].name));
  }
  return out;
}

std::vector<StudySpec> studies_of_models(const AskedModels& asked) {
  std::vector<Fault> faults;
  std::vector<ReadModel> models;
  const auto collect = [&](const auto& work) {
    try {
      work();
    } catch (const InputError& error) {
      faults.insert(faults.end(), error.faults().begin(), error.faults().end());
    }
  };
  for (const std::string& file : asked.files)
    collect([&] { models.push_back(read_one(file, asked.overrides)); });
  if (!faults.empty()) throw InputError(std::move(faults));
  for (std::size_t k = 1; k < models.size(); ++k)
    collect([&] {
      const ReadModel& other = models[k];
      std::vector<Fault> found = differences(models.front(), other);
      if (!found.empty()) throw InputError(other.spec.places->placed(found));
    });
  if (!faults.empty()) throw InputError(std::move(faults));
  std::vector<StudySpec> studies;
  for (const ReadModel& model : models) {
    const AskedWalls walls{.model_file = model.file,
                           .walls = model.spec.draws_fields() ? asked.walls : 1,
                           .seed = asked.seed};
    const std::filesystem::path file = std::filesystem::absolute(model.file);
    studies.push_back(io::parse_study_text(io::text_of_ways(walls, model.way, in_place(model.spec)),
                                           (file.parent_path() / kStudyOfModel).string(),
                                           asked.overrides, io::StudyText::kMade));
  }
  return studies;
}

}  // namespace wythe
