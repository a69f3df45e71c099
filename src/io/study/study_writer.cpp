// write_study: a study as one text that needs no other file, with the base
// model and measured values included; parse_study(write_study(s), s.file) == s.

#include <fmt/format.h>

#include "core/text.h"
#include "io/keys/describe_study.h"
#include "io/study/shaking_file.h"
#include "io/text/toml_writer.h"
#include "wythe/parts/io.h"
#include "wythe/parts/units.h"

namespace wythe {
namespace io {
namespace {

template <class Number>
std::string numbers_text(const std::vector<Number>& numbers) {
  return fmt::format("[{}]", fmt::join(numbers, ", "));
}

std::string values_text(const VariableSpec& variable) {
  std::vector<std::string> texts;
  for (const double value : variable.values)
    texts.push_back(variable.si_unit == "1"
                        ? fmt::format("{}", value)
                        : quoted(format_quantity(value, variable.si_unit, variable.unit)));
  return "[" + joined(texts, ", ") + "]";
}

std::string head_text(StudySpec& study) {
  Writer writer("study");
  StudyHead head{study, study.model_file};
  describe(writer, head);
  constexpr std::uint64_t kMostOfToml = 0x7fffffffffffffffULL;
  const std::string seed = fmt::format("{}", study.seed);
  std::string out = "[study]\n" + writer.text();
  out +=
      "samples = " +
      (study.batch.size() == 1 ? std::to_string(study.batch.front()) : numbers_text(study.batch)) +
      '\n';
  out += "seed = " + (study.seed > kMostOfToml ? quoted(seed) : seed) + '\n';
  if (!study.fractions.empty()) out += "fractions = " + numbers_text(study.fractions) + '\n';
  return out;
}

template <class Table>
std::string table_text(const std::string& title, Table table) {
  Writer writer("");
  describe(writer, table);
  return '\n' + title + '\n' + writer.text();
}

std::string variant_text(VariantSpec& variant) {
  Writer writer("");
  describe(writer, variant);
  return writer.text();
}

}  // namespace
}  // namespace io

std::string write_study(const StudySpec& spec) {
  StudySpec study = spec;  // one description serves readers and writers, so it takes T&
  std::string out = io::head_text(study);
  for (VariableSpec& variable : study.variable) {
    out += io::table_text(fmt::format("[variable.{}]", io::key_text(variable.name)),
                          io::VariableTable{variable, io::VariableKeys{}});
    if (!variable.values.empty()) out += "values = " + io::values_text(variable) + '\n';
  }
  for (DependentSpec& dependent : study.dependent)
    out += io::table_text(fmt::format("[dependent.{}]", io::key_text(dependent.name)),
                          io::DependentTable{dependent});
  for (const CorrelationSpec& pair : study.correlation)
    out += io::table_text("[[correlation]]",
                          io::PairTable{.between = {pair.a, pair.b},
                                        .rank = pair.rank ? pair.value : kUnset,
                                        .gaussian = pair.rank ? kUnset : pair.value});
  out += io::shaking_text(study);
  for (const VariantSpec& option : study.option) {
    VariantSpec whole = option;
    if (!whole.model.empty()) whole.model_text = whole.study.model_text;
    if (!whole.model.empty()) whole.blocks_text = whole.study.blocks_text;
    out += '\n' + std::string("[[variant]]\n") + io::variant_text(whole);
  }
  return out;
}

}  // namespace wythe
