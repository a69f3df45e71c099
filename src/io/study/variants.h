// [[variant]] of a study file: the settings of each option, and the resulting tree of the study.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "io/text/toml_reader.h"
#include "wythe/parts/study.h"

namespace wythe::io {

struct VariantTables {
  std::vector<VariantSpec> option;  // without their studies
  std::string base;                 // name of the base
  std::map<std::string, int> line;  // of each option and of its settings, by name
  std::vector<Fault> faults;
  // Adds faults from an option's study, at the place that the user wrote.
  void add_faults(const std::string& file, const VariantSpec& of, const InputError& error);
  void throw_if_any();
};

// Removes the variants from the tree. Their own faults go into `context`; those of a tree read later into `faults`.
[[nodiscard]] VariantTables take_variants(ReadContext& context, toml::table& root);

// A study file as given: `own` overrides change its tree, `settings` change its base model.
struct StudySource {
  const std::string& text;
  const std::string& file;
  const std::vector<std::string>& own;
  const std::vector<std::string>& settings;
};
using ReadTree =
    std::function<StudySpec(ReadContext&, const toml::table&, std::vector<std::string>)>;
// Parses the study of every option. Throws InputError with the faults of all.
void parse_options(StudySpec& study, VariantTables variants, const StudySource& source,
                   const ReadTree& read);

}  // namespace wythe::io
