// The parameters that define a random variable, one in each line. The study file, the store
// and the checks use this list. margin.cpp says how a kind of distribution uses them.
#pragma once

#include <string>
#include <vector>

#include "wythe/parts/study.h"

namespace wythe::study {

// kMiddle, kBound and kCut are values of the variable, kSpread is a difference of two
// values, kNumber has no unit. The last two must be positive. kCut truncates any kind.
enum class ParameterIs { kMiddle, kBound, kSpread, kNumber, kCut };

struct VariableParameter {
  const char* name;  // in study file and store
  double VariableSpec::*value;
  ParameterIs is;
  const char* example = "";  // of a kNumber
  [[nodiscard]] bool must_be_positive() const {
    return is == ParameterIs::kSpread || is == ParameterIs::kNumber;
  }
};

inline constexpr VariableParameter kVariableParameters[] = {
    {"mean", &VariableSpec::mean, ParameterIs::kMiddle},
    {"cov", &VariableSpec::cov, ParameterIs::kNumber, "0.3"},
    {"standard_deviation", &VariableSpec::standard_deviation, ParameterIs::kSpread},
    {"median", &VariableSpec::median, ParameterIs::kMiddle},
    {"log_standard_deviation", &VariableSpec::log_standard_deviation, ParameterIs::kNumber, "0.3"},
    {"low", &VariableSpec::low, ParameterIs::kBound},
    {"mode", &VariableSpec::mode, ParameterIs::kBound},
    {"high", &VariableSpec::high, ParameterIs::kBound},
    {"alpha", &VariableSpec::alpha, ParameterIs::kNumber, "2"},
    {"beta", &VariableSpec::beta, ParameterIs::kNumber, "3"},
    {"shape", &VariableSpec::shape, ParameterIs::kNumber, "4"},
    {"scale", &VariableSpec::scale, ParameterIs::kSpread},
    {"location", &VariableSpec::location, ParameterIs::kBound},
    {"lower", &VariableSpec::lower, ParameterIs::kCut},
    {"upper", &VariableSpec::upper, ParameterIs::kCut}};

// The sets of parameters that define a kind; one of them must
// be given. "spread" stands for cov or standard_deviation.
struct DistributionForms {
  const char* words;  // "a normal"
  std::vector<std::vector<std::string>> forms;
  std::vector<std::string> optional = {};
};
[[nodiscard]] const DistributionForms& forms_of(DistributionKind kind);

}  // namespace wythe::study
