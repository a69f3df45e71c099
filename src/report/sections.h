// The parts of report.html, each a piece of markup; page.cpp puts them in order.
#pragma once

#include <string>

#include "wythe/model.h"
#include "wythe/result.h"
#include "wythe/wall_spec.h"

namespace wythe::report {

// results (sections.cpp)
[[nodiscard]] std::string headline(const Model& model, const Result& result);
[[nodiscard]] std::string warning(const Result& result);  // "" when all went well
[[nodiscard]] std::string key_numbers(const Result& result);
[[nodiscard]] std::string curve_section(const Result& result);
[[nodiscard]] std::string pictures_section(const Model& model, const Result& result);
[[nodiscard]] std::string failure_section(const FailureMode& mode);
// trust (evidence.cpp)
[[nodiscard]] std::string energy_section(const EnergyLedger& energy);
[[nodiscard]] std::string quasi_static_section(const QuasiStatic& meter);
[[nodiscard]] std::string stages_section(const Result& result);
[[nodiscard]] std::string provenance_section(const Model& model, const Result& result);
// what went in (inputs.cpp)
[[nodiscard]] std::string inputs_section(const ModelSpec& spec, const Model& model);

}  // namespace wythe::report
