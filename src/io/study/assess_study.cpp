// The study of `wythe assess`: walls of one model as samples, and each way of pushing them as a variant.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/files.h"
#include "io/text/toml_reader.h"
#include "io/text/toml_writer.h"
#include "wythe/assessment.h"
#include "wythe/error.h"
#include "wythe/io.h"
#include "wythe/verdict.h"

namespace wythe {
namespace {

bool scatters(const ModelSpec& spec) {
  return std::any_of(spec.field.begin(), spec.field.end(),
                     [](const auto& field) { return field.second.formula.empty(); });
}

// "plus x, uniform": the name of a way makes that of its folder, which has no signs.
std::string name_of(const PushWay& way, bool is_own) {
  std::string direction = is_own ? "forth" : "back";
  if (way.direction.starts_with('+')) direction = "plus " + way.direction.substr(1);
  if (way.direction.starts_with('-')) direction = "minus " + way.direction.substr(1);
  return direction + ", " + way.pattern;
}

// What the mean strength of a wall carries with it: one factor for all of these.
constexpr std::pair<const char*, double JointMaterial::*> kOfStrength[] = {
    {"tensile_strength", &JointMaterial::tensile_strength},
    {"cohesion", &JointMaterial::cohesion},
    {"residual_cohesion", &JointMaterial::residual_cohesion},
    {"mode_1_energy", &JointMaterial::mode_1_energy},
    {"mode_2_energy", &JointMaterial::mode_2_energy},
    {"compressive_strength", &JointMaterial::compressive_strength},
    {"compressive_energy", &JointMaterial::compressive_energy}};

// The factor as a variable, and every strength as the file's times it.
std::string between_walls(const ModelSpec& spec, double cov) {
  std::string text =
      fmt::format("[variable.{}]\ndistribution = \"lognormal\"\nmean = 1.0\ncov = {:.17g}\n",
                  kBetweenWalls, cov);
  for (const auto& [role, name] :
       {std::pair("joint", spec.scatter.joint), std::pair("unit", spec.scatter.unit)}) {
    const auto found = spec.material.find(name);
    if (found == spec.material.end()) continue;
    for (const auto& [key, member] : kOfStrength) {
      const double mean = found->second.*member;
      if (!(mean > 0) || !std::isfinite(mean)) continue;
      const char* unit = std::string_view(key).ends_with("energy") ? "N/m" : "Pa";
      text += fmt::format(
          "[dependent.{0}_of_{5}]\npath = \"material.{1}.{0}\"\nformula = \"{2} * {3:.17g} {4}\"\n",
          key, name, kBetweenWalls, mean, unit, role);
    }
  }
  return text;
}

// The study's text, after its faults with their lines.
std::string text_of_study(const AskedWalls& asked) {
  const std::string& file = asked.model_file;
  const std::string text = io::read_input(file, "model.toml");
  const ModelSpec spec = parse_model(text, file, asked.overrides);
  const Model model = compile_model(spec, text, file, asked.overrides);
  PushWays ways;
  try {
    if (!scatters(spec) && std::isnan(asked.between))
      throw InputError(
          {{.file = "",
            .path = "scatter",
            .value = "",
            .problem = "is missing: nothing scatters within this wall, so all walls would be one",
            .cure = "write [scatter] and under it use = \"clay_brick\", or add --set "
                    "scatter.use=clay_brick"}});
    ways = ways_of(spec, model);
  } catch (const InputError& error) {
    throw_with_lines(error, spec, text, file, asked.overrides);
  }
  std::string study = fmt::format(
      "[study]\nname = {}\nmodel = {}\nsamples = {}\nseed = {}\ndesign = \"monte_carlo\"\n",
      io::quoted(file), io::quoted(std::filesystem::absolute(file).string()), asked.walls,
      asked.seed);
  if (!std::isnan(asked.between)) study += between_walls(spec, asked.between);
  const PushWay& own = ways.ways.front();
  for (std::size_t k = 1; k < ways.ways.size(); ++k) {
    const PushWay& way = ways.ways[k];
    study += fmt::format("[[variant]]\nname = {}\nset = [",
                         io::quoted(name_of(way, way.direction == own.direction)));
    for (const std::string& setting : way.settings) study += io::quoted(setting) + ", ";
    study += "]\n";
  }
  return study;
}

}  // namespace

StudySpec assess_study(const AskedWalls& asked) {
  const std::filesystem::path model = std::filesystem::absolute(asked.model_file);
  return parse_study(text_of_study(asked), (model.parent_path() / "walls of the model").string(),
                     asked.overrides);
}

}  // namespace wythe
