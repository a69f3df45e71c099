// The checks of a study by itself, part by part (check_study in study.h).
#pragma once

#include <string>

#include "wythe/parts/error.h"
#include "wythe/parts/study.h"

namespace wythe {

// Parameters of one variable: all its distribution needs, none it does not take, and in range.
void check_variable(const VariableSpec& spec, const std::string& file, FaultList& faults);
// Pairs, ranges, and that the matrix they make is positive definite (copula.cpp).
void check_correlation(const StudySpec& study, FaultList& faults);

// "0.15 MPa", "0.5": a value in the unit an input is shown in.
[[nodiscard]] std::string shown_value(const InputSpec& input, double value);

}  // namespace wythe
