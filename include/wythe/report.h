// report.html: one self-contained page for a run, or for a campaign.
#pragma once

#include <string>
#include <vector>

#include "wythe/campaign.h"
#include "wythe/limit.h"
#include "wythe/model.h"
#include "wythe/result.h"
#include "wythe/statistics.h"
#include "wythe/wall_spec.h"

namespace wythe {

// Deformed, cracked wall at a snapshot as an SVG document; `scale` magnifies displacements.
[[nodiscard]] std::string wall_svg(const Model& model, const State& state, double scale);
// States of one wall side by side with their displacements, as an SVG document; `scale` 0: fitting.
[[nodiscard]] std::string states_svg(const Model& model, const std::vector<Snapshot>& states,
                                     double scale, const std::string& title);
[[nodiscard]] std::string run_report(const ModelSpec& spec, const Model& model,
                                     const Result& result);
// report.html of a campaign; whatever it holds, nothing included.
[[nodiscard]] std::string campaign_report(const Campaign& campaign, const Statistics& statistics);
// A mechanism before and after: bodies, hinges, load, as an SVG document.
[[nodiscard]] std::string mechanism_svg(const Model& model, const Mechanism& mechanism);
// What `wythe limit` found, as a part of a page, and as a page of its own.
[[nodiscard]] std::string limit_section(const Model& model, const SecondOpinion& opinion);
[[nodiscard]] std::string limit_report(const ModelSpec& spec, const Model& model,
                                       const SecondOpinion& opinion);

}  // namespace wythe
