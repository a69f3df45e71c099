// A study: a base model, its uncertain inputs, and the samples drawn from them.
//
//   study.toml --read_study()--> StudySpec --draw_samples()--> SampleTable --settings_of(i)--> model i
//
// A sample is the base model with settings ("material.joint.tensile_strength = 143215.2 Pa"), written
// as for `wythe run --set`. So each sample can be run alone from two texts, with equal bits.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "wythe/parts/error.h"
#include "wythe/parts/message.h"
#include "wythe/parts/wall_spec.h"
#include "wythe/parts/words.h"

namespace wythe {

// How samples are drawn. The numbers enter the seeds of every column: they never change.
enum class Design { kLatinHypercube = 0, kMonteCarlo = 1, kSobol = 2 };
inline constexpr Word<Design> kDesignWords[] = {{"latin_hypercube", Design::kLatinHypercube},
                                                {"monte_carlo", Design::kMonteCarlo},
                                                {"sobol", Design::kSobol}};
// A quantity of the model, or a number of the study's own, with the unit it is shown in.
struct InputSpec {
  std::string name;     // as in the study file: [variable.<name>], [dependent.<name>]
  std::string path;     // key of the model it sets; "": only used in formulas
  std::string si_unit;  // "Pa", "rad", "1"
  std::string unit;     // shown, e.g. "MPa", "deg", "1"
};

// A random input. Parameters not given are kUnset; which ones a kind takes: docs/reference/study.md.
struct VariableSpec : InputSpec {
  DistributionKind distribution = DistributionKind::kNormal;
  double mean = kUnset, cov = kUnset, standard_deviation = kUnset;  // [SI], [-], [SI]
  double low = kUnset, high = kUnset, mode = kUnset;                // uniform, triangular, beta
  double median = kUnset, log_standard_deviation = kUnset;          // lognormal [SI], [-]
  double shape = kUnset, scale = kUnset, location = kUnset;         // Weibull [-], [SI], [SI]
  double alpha = kUnset, beta = kUnset;                             // beta [-]
  double lower = kUnset, upper = kUnset;                            // truncation [SI]
  std::string file, column;                                         // empirical: CSV and its column
  std::vector<double> values;  // empirical, read from the file [SI]
};

// A quantity that follows from others: `formula` over names of variables and dependents.
struct DependentSpec : InputSpec {
  std::string formula;  // "1.5 * ft_j", "0.029 mm * ft_j"
};

// Correlation of a pair of variables: of the Gaussian copula, or Spearman's rank correlation.
struct CorrelationSpec {
  std::string a, b;
  double value = 0;
  bool rank = false;
};

// A field of the base model (field.h). A variable of its name is its mean.
struct StudyField {
  std::string name, path;
  bool follows = false;  // a formula; else each sample draws it anew
};

// What the strength of a record is measured by: of the first component, as it is applied.
enum class IntensityMeasure { kPga, kPgv, kSa };
inline constexpr Word<IntensityMeasure> kIntensityMeasureWords[] = {{"pga", IntensityMeasure::kPga},
                                                                    {"pgv", IntensityMeasure::kPgv},
                                                                    {"sa", IntensityMeasure::kSa}};

// Which samples meet which records: each sample each record, or sample i record i, in turn.
enum class Pairing { kEach, kInTurn };
inline constexpr Word<Pairing> kPairingWords[] = {{"each", Pairing::kEach},
                                                  {"in_turn", Pairing::kInTurn}};

// One [[record]]: an earthquake that takes the place of the base model's.
struct StudyRecord {
  std::string name;
  std::string motion;          // its components as TOML, as `stage.<name>.record` takes them
  std::vector<double> levels;  // where it has levels of its own [SI]; empty: those of all
};

// One [[limit_state]]: reached where any of its limits is, and by every wall that collapses.
struct LimitStateSpec {
  std::string name;
  double peak_drift = kUnset, residual_drift = kUnset;                // of the control point [-]
  double peak_displacement = kUnset, residual_displacement = kUnset;  // of the control point [m]
  double uplift = kUnset, slip = kUnset;  // largest opening and slip of any joint [m]
  bool collapse = false;                  // a fall or an overturning alone
};

// [shaking]: every sample under the records, each at several intensities (docs/theory/fragility.md).
struct ShakingSpec {
  std::string stage;  // of the base model, which takes the records; "": the study does not ask
  IntensityMeasure measure = IntensityMeasure::kPga;
  double period = kUnset, damping = kUnset;  // of sa [s], of critical
  std::vector<double> levels;                // each record at each of them [m/s^2] or [m/s]; or
  double first = kUnset, step = kUnset,
         most = kUnset;  // upwards until collapse or `most`, and then
  int halvings = 0;      // halving the way between stood and fell
  Pairing pairing = Pairing::kEach;
  std::vector<StudyRecord> record;
  std::vector<LimitStateSpec> limit_state;
  [[nodiscard]] bool is_asked() const { return !stage.empty(); }
  [[nodiscard]] bool climbs() const { return most == most; }  // not NaN
};

struct VariantSpec;

struct StudySpec {
  std::string name, note;
  std::string file;         // the study file, for messages
  std::string model_file;   // the base model's file, for messages and relative paths
  std::string model_text;   // the base model, as TOML
  std::string blocks_text;  // what its blocks file holds, as JSON; "" without one
  std::map<std::string, std::string> record_text;  // what record files hold, by their name there
  std::vector<std::string> settings;  // of the base model, before the samples' own: "path=value"
  std::vector<VariableSpec> variable;
  std::vector<DependentSpec> dependent;
  std::vector<CorrelationSpec> correlation;
  std::vector<StudyField> field;
  ShakingSpec shaking;
  Design design = Design::kLatinHypercube;
  std::vector<int> batch;  // sizes of the designs drawn one after another; usually one
  std::uint64_t seed = 0;
  std::vector<double> states;          // displacements at which damage states are stored [m]
  std::vector<double> fractions;       // of the peak, after it, at which displacements are read
  double read_modes_at = kUnset;       // displacement at which failure modes are named [m]
  std::string until;                   // stop rule, "" none
  std::vector<std::string> fragility;  // events asked for: "peak_reaction > 150 kN"
  std::string variant;              // its name, where it is an option or the base of some; else ""
  int variant_place = 0;            // of an option: 1 is the first in the file
  std::vector<VariantSpec> option;  // [[variant]]: the same samples under another choice
};

// One [[variant]]: what it says, and the study that follows from it, whose samples are those of its base.
struct VariantSpec {
  std::string name;
  std::string folder;                   // of its store, beside that of the base
  std::vector<std::string> set;         // "path=value"
  std::string model;                    // another base model, as the file writes it; "": the same
  std::string model_text, blocks_text;  // given with the text of that model; usually ""
  StudySpec study;
};
// The folder and name of what the options of a study are compared with.
inline constexpr const char* kBaseFolder = "base";

// One column of the samples' inputs: the variables in their order, then the dependents.
struct InputColumn {
  std::string name, path, si_unit, unit;
  double to_unit = 1, offset = 0;  // shown = SI * to_unit + offset
  bool is_random = true;
};

struct SampleTable {
  std::vector<InputColumn> column;
  std::vector<std::vector<double>> value;  // (n_sample, n_column) [SI]
  std::vector<double> cut_off;             // probability cut by truncation (n_variable)
  // What fields and records add to the settings of a sample: seeds and what follows them; its record, at its
  // first intensity (n_sample; or empty).
  std::vector<std::vector<std::string>> more_setting;
  [[nodiscard]] int n_sample() const { return static_cast<int>(value.size()); }
};

// Every fault of a study alone, without its base model: parameters a distribution lacks or does
// not take, cycles and mismatched units in formulas, a correlation matrix that is not positive
// definite, ... Faults name the key, not the line; parse_study (io.h) adds that.
[[nodiscard]] std::vector<Fault> check_study(const StudySpec& study);

// Displacements that the study asks for and the push of its base model does not reach; states and
// failure modes are then read where the push ends. In words.
[[nodiscard]] std::vector<Message> notes_of(const StudySpec& study, const ModelSpec& base);

// Draws every sample of the study. Sample i of a batch depends only on (seed, i, n, design, batch) and
// on the variables, never on threads or later batches. Without correlation the set of values of a
// variable does not depend on other variables. In a Latin hypercube their order does: it depends on
// the variables before it, because chance correlations between them are removed. Throws InputError
// with every fault of check_study().
[[nodiscard]] SampleTable draw_samples(const StudySpec& study);

// The seed of the fields of sample i (0-based): of the study's seed and i alone, and each its own.
[[nodiscard]] int field_seed_of(const StudySpec& study, int sample);
// Fills more_setting from the values, which draw_samples() has drawn or a store has kept.
void set_more(const StudySpec& study, SampleTable& samples);

// The wall and the record of a sample, all 0-based: with records a sample is a drawn wall under one record,
// the records of a wall one after the other. record = -1: of the base model.
struct SampleCase {
  int wall = 0, record = -1;
};
[[nodiscard]] SampleCase case_of(const StudySpec& study, int sample);
// How many samples there are; without records the sum of `batch`.
[[nodiscard]] int count_samples(const StudySpec& study);
// Settings that put the stage's record to this intensity [SI].
[[nodiscard]] std::string intensity_setting(const ShakingSpec& shaking, double intensity);
// "m/s" of pgv, else "m/s^2".
[[nodiscard]] const char* unit_of(IntensityMeasure measure);

// Draws the model's fields at every place of its wall, from each field's seed and name alone. Reading
// a model does it (io.h). A wall that can't be built is left undrawn: compile() says why. Throws InputError
// with every fault of the fields.
void draw_fields(ModelSpec& spec);

// "path=value unit" texts of one sample (0-based), 17 digits in SI units: exact.
[[nodiscard]] std::vector<std::string> settings_of(const SampleTable& samples, int sample);

// Makes the ModelSpec of the base model with settings; io.h has the one that reads TOML.
using ModelBuilder = std::function<ModelSpec(const std::vector<std::string>& settings)>;

// None when the model with these settings compiles, otherwise why not: a strength below zero,
// snap-back, an inadmissible friction angle, a value that is not finite, ...
[[nodiscard]] std::vector<Fault> refusal_of(const std::vector<std::string>& settings,
                                            const ModelBuilder& build);
// The same of a drawn sample (0-based); an input that is not finite is named by its formula's name.
[[nodiscard]] std::vector<Fault> refusal_of(const SampleTable& samples, int sample,
                                            const ModelBuilder& build);
// The same of each drawn sample. Samples of one shape share an assembly, as in a campaign.
[[nodiscard]] std::vector<std::vector<Fault>> refusals_of(const SampleTable& samples,
                                                          const ModelBuilder& build);
// A refusal in one line: the first fault, its numbers to six digits, and how many more; "" of none.
[[nodiscard]] std::string in_one_line(const std::vector<Fault>& refusal);

}  // namespace wythe
