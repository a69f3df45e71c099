// report.html: one self-contained page for a run.
#pragma once

#include <string>

#include "wythe/model.h"
#include "wythe/result.h"
#include "wythe/wall_spec.h"

namespace wythe {

// Deformed, cracked wall at a snapshot as an SVG document; `scale` magnifies displacements.
[[nodiscard]] std::string wall_svg(const Model& model, const State& state, double scale);
[[nodiscard]] std::string run_report(const ModelSpec& spec, const Model& model,
                                     const Result& result);

}  // namespace wythe
