// The description of a study file, for the same visitors as describe.h: TableReader, Writer.
//
//   describe(v, StudyHead)         [study], but for samples and seed (study_file.cpp)
//   describe(v, VariableTable)     [variable.<name>], but for values
//   describe(v, DependentTable)    [dependent.<name>]
//   describe(v, PairTable)         [[correlation]]
//   describe(v, VariantSpec)       [[variant]]
//
// The unit of a variable's mean is that of the key which it sets. So amounts are
// described with the unit that was found for the variable before (VariableKeys).
#pragma once

#include <string>
#include <vector>

#include "campaign/draws/distribution.h"
#include "io/keys/key.h"
#include "wythe/parts/study.h"

namespace wythe::io {

struct StudyHead {
  StudySpec& spec;
  std::string model;  // as the file writes it, relative to the study file
};

// How the amounts of one variable are written. Must live longer than the visitor.
struct VariableKeys {
  Range typical;  // of a mean or a median: the key's own
  Range bounds;   // of ends and cuts: the same, ends included
  std::string example;
};
struct VariableTable {
  VariableSpec& spec;
  const VariableKeys& keys;
};
struct DependentTable {
  DependentSpec& spec;
};
struct PairTable {
  std::vector<std::string> between;
  double rank = kUnset, gaussian = kUnset;
};

// A quantity in the variable's unit, or a plain number. Where the
// unit is not known because of another fault, the key is skipped.
template <class Visitor>
void amount(Visitor& v, const char* name, double& value, const InputSpec& input, const Range& range,
            const std::string& example) {
  const Key key{.unit = input.si_unit.c_str(),
                .shown = input.unit.c_str(),
                .range = range,
                .fallback = "none",
                .example = example.c_str()};
  if (input.si_unit.empty()) {
    if constexpr (requires { v.find(name, key); }) v.find(name, key);
  } else if (input.si_unit == "1") {
    v.number(name, value, {.range = range, .fallback = "none", .example = "0.5"});
  } else {
    v.quantity(name, value, key);
  }
}

// clang-format off

template <class Visitor>
void describe(Visitor& v, StudyHead& h) {
  StudySpec& s = h.spec;
  v.text("name", s.name, {.fallback = "none", .example = "tuff wall, Table 2",
         .doc = "Title of the report."});
  v.text("note", s.note, {.fallback = "none", .example = "Table 2 of the paper",
         .doc = "Remarks."});
  v.text("model", h.model, {.fallback = "required", .example = "model.toml",
         .doc = "The base model, relative to the study file."});
  v.text("model_text", s.model_text, {.fallback = "none",
         .doc = "The base model itself; then `model` is only its name."});
  v.text("blocks_text", s.blocks_text, {.fallback = "none",
         .doc = "What its blocks file holds, as JSON; then that file is not read."});
  v.texts("set", s.settings, {.fallback = "none", .example = "[\"stage.push.velocity=5 mm/s\"]",
          .doc = "Settings of the base model, as for --set."});
  v.choice("design", s.design, kDesignWords, {.example = "latin_hypercube",
           .doc = "How samples are drawn."});
  v.quantities("states", s.states, {.unit = "m", .shown = "mm", .fallback = "none",
               .example = "[\"10 mm\", \"40 mm\"]",
               .doc = "Displacements at which the state of each sample is stored."});
  v.quantity("read_modes_at", s.read_modes_at, {.unit = "m", .shown = "mm", .fallback = "40 mm",
             .example = "40 mm", .doc = "Displacement at which failure modes are named."});
  v.text("until", s.until, {.fallback = "none", .example = "relative_interval(peak_reaction) < 1 %",
         .doc = "Rule that ends the campaign before all samples have run."});
  v.texts("fragility", s.fragility, {.fallback = "none", .example = "[\"peak_reaction > 150 kN\"]",
          .doc = "Events whose probability is told given each input, beside those chosen by the program."});
}

template <class Visitor>
void describe_input(Visitor& v, InputSpec& s) {
  v.text("path", s.path, {.fallback = "none", .example = "material.joint.tensile_strength",
         .doc = "Key of the model it sets, as for --set; without it only formulas use it."});
  v.text("unit", s.unit, {.fallback = "the key's", .example = "MPa",
         .doc = "Unit it is shown in."});
}

template <class Visitor>
void describe(Visitor& v, VariableTable& t) {
  VariableSpec& s = t.spec;
  const VariableKeys& k = t.keys;
  describe_input(v, s);
  v.choice("distribution", s.distribution, kDistributionWords, {.example = "lognormal"});
  for (const study::VariableParameter& p : study::kVariableParameters) {
    double& value = s.*p.value;
    switch (p.is) {
      case study::ParameterIs::kNumber:
        v.number(p.name, value, {.range = kPositive, .fallback = "none", .example = p.example});
        break;
      case study::ParameterIs::kSpread: amount(v, p.name, value, s, kPositive, k.example); break;
      case study::ParameterIs::kMiddle: amount(v, p.name, value, s, k.typical, k.example); break;
      case study::ParameterIs::kBound:
      case study::ParameterIs::kCut: amount(v, p.name, value, s, k.bounds, k.example); break;
    }
  }
  v.text("file", s.file, {.fallback = "none", .example = "tests.csv"});
  v.text("column", s.column, {.fallback = "none", .example = "ft_MPa"});
}

template <class Visitor>
void describe(Visitor& v, DependentTable& t) {
  describe_input(v, t.spec);
  v.text("formula", t.spec.formula, {.fallback = "required", .example = "1.5 * ft_j"});
}

template <class Visitor>
void describe(Visitor& v, PairTable& p) {
  v.texts("between", p.between, {.count = 2, .fallback = "required",
          .example = "[\"ft_j\", \"fc\"]"});
  v.number("rank", p.rank, {.fallback = "none", .example = "0.3"});
  v.number("gaussian", p.gaussian, {.fallback = "none", .example = "0.3"});
}

template <class Visitor>
void describe(Visitor& v, VariantSpec& s) {
  v.text("name", s.name, {.fallback = "required", .example = "steel lintel",
         .doc = "What the option is called; its store lies in a folder of this name."});
  v.texts("set", s.set, {.fallback = "none", .example = "[\"wall.opening.door.lintel.depth=200 mm\"]",
          .doc = "Settings of the base model, as for --set; dependent.<name>.formula too."});
  v.text("model", s.model, {.fallback = "the base's", .example = "with_tie.toml",
         .doc = "Another base model, relative to the study file."});
  v.text("model_text", s.model_text, {.fallback = "none",
         .doc = "That model itself; then `model` is only its name."});
  v.text("blocks_text", s.blocks_text, {.fallback = "none",
         .doc = "What its blocks file holds, as JSON."});
}

// clang-format on

}  // namespace wythe::io
