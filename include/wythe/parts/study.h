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

// Sampling methods. Their numbers enter the seeds of every column, so they never change.
enum class Design { kLatinHypercube = 0, kMonteCarlo = 1, kSobol = 2 };
inline constexpr Word<Design> kDesignWords[] = {{"latin_hypercube", Design::kLatinHypercube},
                                                {"monte_carlo", Design::kMonteCarlo},
                                                {"sobol", Design::kSobol}};
// An input: a quantity of the model, or a number of the study only, with its shown unit.
struct InputSpec {
  std::string name;     // as in the study file: [variable.<name>], [dependent.<name>]
  std::string path;     // key of the model that it sets; "": for formulas only
  std::string si_unit;  // "Pa", "rad", "1"
  std::string unit;     // shown, e.g. "MPa", "deg", "1"
};

// A random input. Parameters that are not given are kUnset; docs/reference/study.md lists those of each kind.
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

// An input that follows from others by `formula` over names of variables and dependents.
struct DependentSpec : InputSpec {
  std::string formula;  // "1.5 * ft_j", "0.029 mm * ft_j"
};

// Correlation of two variables: of the Gaussian copula, or Spearman's rank correlation.
struct CorrelationSpec {
  std::string a, b;
  double value = 0;
  bool rank = false;
};

// A field of the base model (field.h). A variable of the same name is its mean.
struct StudyField {
  std::string name, path;
  bool follows = false;  // by a formula; else each sample draws it anew
};

// Measure of the intensity of a record: of the first component, as applied.
enum class IntensityMeasure { kPga, kPgv, kSa };
inline constexpr Word<IntensityMeasure> kIntensityMeasureWords[] = {{"pga", IntensityMeasure::kPga},
                                                                    {"pgv", IntensityMeasure::kPgv},
                                                                    {"sa", IntensityMeasure::kSa}};

// How samples meet records: each sample each record, or sample i record i, in turn.
enum class Pairing { kEach, kInTurn };
inline constexpr Word<Pairing> kPairingWords[] = {{"each", Pairing::kEach},
                                                  {"in_turn", Pairing::kInTurn}};

// One [[record]]: an earthquake that replaces the one of the base model.
struct StudyRecord {
  std::string name;
  std::string motion;          // components as TOML, as in `stage.<name>.record`
  std::vector<double> levels;  // its own intensities [SI]; empty: those of all
};

// One [[limit_state]]: reached where any of its limits is exceeded, and by every wall that collapses.
struct LimitStateSpec {
  std::string name;
  double peak_drift = kUnset, residual_drift = kUnset;                // of the control point [-]
  double peak_displacement = kUnset, residual_displacement = kUnset;  // of the control point [m]
  double uplift = kUnset, slip = kUnset;  // largest opening and slip of any joint [m]
  bool collapse = false;                  // only a fall or an overturning counts
};

// [shaking]: every sample is shaken by the records at several intensities (docs/theory/fragility.md).
struct ShakingSpec {
  std::string stage;  // stage of the base model that gets the records; "": no shakes
  IntensityMeasure measure = IntensityMeasure::kPga;
  double period = kUnset, damping = kUnset;  // for sa: period [s], share of critical damping [-]
  std::vector<double> levels;                // intensities of every record [m/s^2] or [m/s]; or
  double first = kUnset, step = kUnset,
         most = kUnset;  // rising until collapse or `most`, and then
  int halvings = 0;      // bisections between stood and fell
  Pairing pairing = Pairing::kEach;
  std::vector<StudyRecord> record;
  std::vector<LimitStateSpec> limit_state;
  [[nodiscard]] bool is_asked() const { return !stage.empty(); }
  [[nodiscard]] bool climbs() const { return most == most; }  // not NaN
};

struct VariantSpec;

struct StudySpec {
  std::string name, note;
  std::string file;         // path of the study file, for messages
  std::string model_file;   // path of the base model, for messages and relative paths
  std::string model_text;   // the base model, as TOML
  std::string blocks_text;  // content of its blocks file, as JSON; "" without one
  std::map<std::string, std::string> record_text;  // content of record files, by name
  std::vector<std::string> settings;  // "path=value", applied before those of the samples
  std::vector<VariableSpec> variable;
  std::vector<DependentSpec> dependent;
  std::vector<CorrelationSpec> correlation;
  std::vector<StudyField> field;
  ShakingSpec shaking;
  Design design = Design::kLatinHypercube;
  std::vector<int> batch;  // sizes of designs drawn one after another; usually one
  std::uint64_t seed = 0;
  std::vector<double> states;          // displacements at which damage states are stored [m]
  std::vector<double> fractions;       // shares of the peak whose displacements are read
  double read_modes_at = kUnset;       // displacement at which failure modes are named [m]
  std::string until;                   // stop rule, "" none
  std::vector<std::string> fragility;  // events: "peak_reaction > 150 kN"
  std::string variant;                 // name of an option or of its base; else ""
  int variant_place = 0;               // of an option: 1 is the first in the file
  std::vector<VariantSpec> option;     // [[variant]]: the same samples with a changed model
};

// One [[variant]]: its content and the study that follows from it; both studies have the same samples.
struct VariantSpec {
  std::string name;
  std::string folder;                   // of its store, beside that of the base
  std::vector<std::string> set;         // "path=value"
  std::string model;                    // another base model, as written in the file; "": the same
  std::string model_text, blocks_text;  // set where that model is given as a text; usually ""
  StudySpec study;
};
// Folder and name of the base with which the options of a study are compared.
inline constexpr const char* kBaseFolder = "base";
// File name of a study that a command made of one model. Its options are ways of pushing that model, not variants of it.
inline constexpr const char* kStudyOfModel = "walls of the model";

// One column of the inputs: variables in order, then dependents.
struct InputColumn {
  std::string name, path, si_unit, unit;
  double to_unit = 1, offset = 0;  // shown = SI * to_unit + offset
  bool is_random = true;
};

struct SampleTable {
  std::vector<InputColumn> column;
  std::vector<std::vector<double>> value;  // (n_sample, n_column) [SI]
  std::vector<double> cut_off;             // probability cut by truncation (n_variable)
  // Additional settings of a sample: seeds of fields and what follows from them, and its record at its first
  // intensity (n_sample; or empty).
  std::vector<std::vector<std::string>> more_setting;
  [[nodiscard]] int n_sample() const { return static_cast<int>(value.size()); }
};

// Every fault of a study apart from its base model: missing or superfluous parameters of a
// distribution, cycles and mismatched units in formulas, a correlation matrix that is not positive
// definite, ... Faults name the key; parse_study (io.h) adds the line.
[[nodiscard]] std::vector<Fault> check_study(const StudySpec& study);

// Displacements that the study requests and the push of its base model does not reach; states and
// failure modes are then read where the push ends.
[[nodiscard]] std::vector<Message> notes_of(const StudySpec& study, const ModelSpec& base);

// Draws every sample of the study. Sample i of a batch depends only on (seed, i, n, design, batch) and
// on the variables, never on threads or later batches. Without correlation the set of a variable's
// values does not depend on other variables. In a Latin hypercube their order depends on the
// previous variables, since chance correlations with these are removed. Throws InputError
// with every fault of check_study().
[[nodiscard]] SampleTable draw_samples(const StudySpec& study);

// The seed of the fields of sample i (0-based). It depends on the study's seed and i alone, and differs for each i.
[[nodiscard]] int field_seed_of(const StudySpec& study, int sample);
// Sets more_setting from the values that draw_samples() drew or a store kept.
void set_more(const StudySpec& study, SampleTable& samples);

// The wall and the record of a sample, all 0-based: with records, a sample is a drawn wall under one record. The
// records of a wall follow each other. record = -1: that of the base model.
struct SampleCase {
  int wall = 0, record = -1;
};
[[nodiscard]] SampleCase case_of(const StudySpec& study, int sample);
// Number of samples; without records the sum of `batch`.
[[nodiscard]] int count_samples(const StudySpec& study);
// Settings that scale the stage's record to this intensity [SI].
[[nodiscard]] std::string intensity_setting(const ShakingSpec& shaking, double intensity);
// "m/s" for pgv, else "m/s^2".
[[nodiscard]] const char* unit_of(IntensityMeasure measure);

// Draws the model's fields at every place of its wall; each depends on its seed and name alone. Reading
// a model calls it (io.h). For a wall that can't be built it draws nothing; compile() says why. Throws InputError
// with every fault of the fields.
void draw_fields(ModelSpec& spec);

// Settings "path=value unit" of one sample (0-based), with 17 digits in SI units: exact.
[[nodiscard]] std::vector<std::string> settings_of(const SampleTable& samples, int sample);

// Makes the ModelSpec of a base model with settings; model_builder() (io.h) reads TOML.
using ModelBuilder = std::function<ModelSpec(const std::vector<std::string>& settings)>;

// Faults of the model with these settings, empty where it compiles: a strength below zero,
// snap-back, an inadmissible friction angle, a value that is not finite, ...
[[nodiscard]] std::vector<Fault> refusal_of(const std::vector<std::string>& settings,
                                            const ModelBuilder& build);
// The same for a drawn sample (0-based); an input that is not finite is reported with its formula's name.
[[nodiscard]] std::vector<Fault> refusal_of(const SampleTable& samples, int sample,
                                            const ModelBuilder& build);
// The same for each drawn sample. Samples of one shape share an assembly, as in a campaign.
[[nodiscard]] std::vector<std::vector<Fault>> refusals_of(const SampleTable& samples,
                                                          const ModelBuilder& build);
// A refusal in one line: the first fault with numbers of six digits, and the count of others; "" for none.
[[nodiscard]] std::string in_one_line(const std::vector<Fault>& refusal);

}  // namespace wythe
