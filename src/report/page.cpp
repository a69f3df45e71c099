// run_report(): the sections in the order a reader asks: what, how, why, can I trust it, what went in.
#include <fmt/format.h>

#include "report/html.h"
#include "report/sections.h"
#include "report/style.h"
#include "wythe/provenance.h"
#include "wythe/report.h"

namespace wythe {

std::string run_report(const ModelSpec& spec, const Model& model, const Result& result) {
  using namespace report;
  const std::string name = escaped(spec.name.empty() ? "Wall" : spec.name);
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{}: wythe</title>\n<style>{}{}</style>\n</head>\n<body>\n<main>\n",
      name, picture_style(), page_style());
  page += fmt::format(
      "<header>\n<p class=\"kind\">Discrete rigid block analysis</p>\n<h1>{}</h1>\n{}{}</header>\n",
      name, headline(model, result), warning(result));
  page += key_numbers(result) + curve_section(result) + pictures_section(model, result);
  page += failure_section(result.failure_mode);
  page += quasi_static_section(result.quasi_static) + energy_section(result.energy);
  page += stages_section(result) + inputs_section(spec, model) + provenance_section(model, result);
  page += fmt::format(
      "<footer>wythe {}. The numbers are in summary.json and "
      "force_displacement.csv, the states in run.pvd for ParaView, the model as "
      "understood in model.used.toml.</footer>\n",
      provenance().version);
  return page + "</main>\n</body>\n</html>\n";
}

}  // namespace wythe
