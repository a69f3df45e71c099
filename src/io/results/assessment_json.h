// `assessment` and `project` of summary.json (docs/reference/results.md).
#pragma once

#include <nlohmann/json.hpp>

#include "wythe/parts/local_check.h"
#include "wythe/parts/statistics.h"

namespace wythe::io {

[[nodiscard]] nlohmann::ordered_json assessment_json(const CodeAssessment& assessment);
[[nodiscard]] nlohmann::ordered_json bilinear_json(const Bilinear& bilinear);
[[nodiscard]] nlohmann::ordered_json spectrum_json(const ElasticSpectrum& spectrum);
// `assessment` of statistics.json (docs/reference/statistics.md).
[[nodiscard]] nlohmann::ordered_json assessment_json(const CampaignAssessment& assessment);
// An entry of `local` of mechanisms.json and of `parts` of assessment.json (docs/reference/limit.md).
[[nodiscard]] nlohmann::ordered_json local_json(const LocalCheck& check);
// Adds the project's data; nothing if there are none.
void add_project(nlohmann::ordered_json& json, const ProjectSpec& project);

}  // namespace wythe::io
