// The study of `wythe assess`: walls of one model as samples, and each way of pushing them as a variant.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/files.h"
#include "io/text/toml_reader.h"
#include "wythe/assessment.h"
#include "wythe/error.h"
#include "wythe/io.h"

namespace wythe {
namespace {

// A basic string of TOML.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

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

// The model's ways of pushing, its faults with their lines.
PushWays ways_in(const std::string& file, const std::vector<std::string>& overrides) {
  const std::string text = io::read_input(file, "model.toml");
  const ModelSpec spec = parse_model(text, file, overrides);
  const Model model = compile_model(spec, text, file, overrides);
  try {
    if (!scatters(spec))
      throw InputError(
          {{.file = "",
            .path = "scatter",
            .value = "",
            .problem = "is missing: nothing scatters within this wall, so all walls would be one",
            .cure = "write [scatter] and under it use = \"clay_brick\", or add --set "
                    "scatter.use=clay_brick"}});
    return ways_of(spec, model);
  } catch (const InputError& error) {
    throw_with_lines(error, spec, text, file, overrides);
  }
}

}  // namespace

StudySpec assess_study(const std::string& model_file, int walls, int seed,
                       const std::vector<std::string>& overrides) {
  const PushWays ways = ways_in(model_file, overrides);
  const std::filesystem::path model = std::filesystem::absolute(model_file);
  std::string text = fmt::format(
      "[study]\nname = {}\nmodel = {}\nsamples = {}\nseed = {}\ndesign = \"monte_carlo\"\n",
      quoted(model_file), quoted(model.string()), walls, seed);
  for (std::size_t k = 1; k < ways.ways.size(); ++k) {
    const PushWay& way = ways.ways[k];
    text += fmt::format("[[variant]]\nname = {}\nset = [",
                        quoted(name_of(way, way.direction == ways.ways.front().direction)));
    for (const std::string& setting : way.settings) text += quoted(setting) + ", ";
    text += "]\n";
  }
  return parse_study(text, (model.parent_path() / "walls of the model").string(), overrides);
}

}  // namespace wythe
