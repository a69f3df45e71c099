// The study of `wythe assess`: walls of one model as samples, and each way of pushing them as a variant.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

#include "campaign/draws/energies.h"
#include "core/files.h"
#include "core/text.h"
#include "io/study/study_file.h"
#include "io/text/toml_reader.h"
#include "io/text/toml_writer.h"
#include "wythe/parts/assessment.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"
#include "wythe/parts/verdict.h"

namespace wythe {
namespace {

// "plus x, uniform": the name of a way of pushing. Its folder is named after it, so it has no signs.
std::string name_of(const PushWay& way, bool is_own) {
  std::string direction = is_own ? "forth" : "back";
  if (way.direction.starts_with('+')) direction = "plus " + way.direction.substr(1);
  if (way.direction.starts_with('-')) direction = "minus " + way.direction.substr(1);
  return direction + ", " + way.pattern;
}

// Keys of a material with values for a wall whose means are all multiplied by `k`. Strengths
// and energies follow it, and energies stay above the least that a stronger joint needs.
std::vector<std::pair<const char*, std::string>> with_factor(const std::string& k,
                                                             const JointMaterial& m) {
  std::vector<std::pair<const char*, std::string>> out;
  const auto scatters = [](double mean) { return mean > 0 && std::isfinite(mean); };
  const auto times = [&](double mean, const char* unit) {
    return fmt::format("{} * {:.17g} {}", k, mean, unit);
  };
  const auto strength = [&](const char* key, double mean) {
    if (scatters(mean)) out.emplace_back(key, times(mean, "Pa"));
  };
  const auto energy = [&](const char* key, double mean, bool acts, const auto& following) {
    if (!scatters(mean)) return;
    const std::string proportional = times(mean, "N/m");
    out.emplace_back(key, acts ? following(proportional) : proportional);
  };
  strength("tensile_strength", m.tensile_strength);
  strength("cohesion", m.cohesion);
  strength("residual_cohesion", m.residual_cohesion);
  energy("mode_1_energy", m.mode_1_energy, scatters(m.tensile_strength),
         [&](const std::string& proportional) {
           return study::tension_energy(proportional, times(m.tensile_strength, "Pa"), m);
         });
  energy("mode_2_energy", m.mode_2_energy, std::isfinite(m.cohesion),
         [&](const std::string& proportional) {
           return study::slip_energy(proportional, times(m.cohesion, "Pa"), m, k);
         });
  // b belongs to the mean GII; a model that gives only GII has none
  if (m.mode_2_energy_per_pressure > 0)
    out.emplace_back("mode_2_energy_per_pressure",
                     fmt::format("{:.17g} m", m.mode_2_energy_per_pressure));
  strength("compressive_strength", m.compressive_strength);
  energy("compressive_energy", m.compressive_energy, scatters(m.compressive_strength),
         [&](const std::string& proportional) {
           return study::crushing_energy(proportional, times(m.compressive_strength, "Pa"), m);
         });
  return out;
}

// The factor as a variable, and every strength and energy as the file's value times it.
std::string between_walls(const ModelSpec& spec, double cov) {
  std::string text =
      fmt::format("[variable.{}]\ndistribution = \"lognormal\"\nmean = 1.0\ncov = {:.17g}\n",
                  kBetweenWalls, cov);
  for (const auto& [role, name] :
       {std::pair("joint", spec.scatter.joint), std::pair("unit", spec.scatter.unit)}) {
    const auto found = spec.material.find(name);
    if (found == spec.material.end()) continue;
    for (const auto& [key, formula] : with_factor(kBetweenWalls, found->second))
      text +=
          fmt::format("[dependent.{0}_of_{1}]\npath = \"material.{2}.{0}\"\nformula = \"{3}\"\n",
                      key, role, name, formula);
  }
  return text;
}

// The text of the study, after its faults are reported with their lines.
std::string text_of_study(const AskedWalls& asked) {
  const std::string& file = asked.model_file;
  const ModelSpec spec = read_model(file, asked.overrides);
  const Model model = compile(spec);
  PushWays ways;
  try {
    if (!spec.draws_fields() && std::isnan(asked.between))
      throw InputError(
          {{.path = "scatter",
            .problem = "is missing: nothing scatters within this wall, so all walls would be one",
            .cure = "write [scatter] and under it use = \"clay_brick\", or add --set "
                    "scatter.use=clay_brick"}});
    ways = ways_of(spec, model);
  } catch (const InputError& error) {
    throw InputError(spec.places->placed(error.faults()));
  }
  return io::text_of_ways({.model_file = file, .walls = asked.walls, .seed = asked.seed}, ways.ways,
                          std::isnan(asked.between) ? "" : between_walls(spec, asked.between));
}

}  // namespace

std::string io::text_of_ways(const AskedWalls& asked, const std::vector<PushWay>& ways,
                             const std::string& tables) {
  const std::string whole = std::filesystem::absolute(asked.model_file).string();
  if (!is_utf8(whole))  // a study names its model in TOML
    throw InputError(
        {{.file = asked.model_file,
          .problem = "has a name, or lies in a folder of a name, that is no UTF-8 text",
          .cure = "rename it, or copy the model to another folder"}});
  std::string study = fmt::format(
      "[study]\nname = {}\nmodel = {}\nsamples = {}\nseed = {}\ndesign = \"monte_carlo\"\n",
      io::quoted(asked.model_file), io::quoted(whole), asked.walls, asked.seed);
  study += tables;
  const PushWay& own = ways.front();
  for (std::size_t k = 1; k < ways.size(); ++k) {
    const PushWay& way = ways[k];
    study += fmt::format("[[variant]]\nname = {}\nset = [",
                         io::quoted(name_of(way, way.direction == own.direction)));
    for (const std::string& setting : way.settings) study += io::quoted(setting) + ", ";
    study += "]\n";
  }
  return study;
}

StudySpec assess_study(const AskedWalls& asked) {
  const std::filesystem::path model = std::filesystem::absolute(asked.model_file);
  return io::parse_study_text(text_of_study(asked), (model.parent_path() / kStudyOfModel).string(),
                              asked.overrides, io::StudyText::kMade);
}

}  // namespace wythe
