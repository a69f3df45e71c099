// report.html: one self-contained page of a run, a campaign or a limit analysis; also SVG pictures.
//
//   Result, Campaign, ... --*_data()--> bytes --report_page()--> report.html
//
// The bytes hold all that the page shows (a JSON header and arrays, compressed), without words of any
// language. A run stores them as report.data beside its files, so that its page can be made again.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "wythe/parts/campaign.h"
#include "wythe/parts/limit.h"
#include "wythe/parts/model.h"
#include "wythe/parts/result.h"
#include "wythe/parts/statistics.h"
#include "wythe/parts/wall_spec.h"

namespace wythe {

struct PairedComparison;  // comparison.h
struct WallsVerdict;      // verdict.h

// A snapshot of the deformed, cracked wall as an SVG document; `scale` magnifies displacements.
[[nodiscard]] std::string wall_svg(const Model& model, const State& state, double scale);
// States of one wall side by side with their displacements, as an SVG document; `scale` 0: chosen to fit.
[[nodiscard]] std::string states_svg(const Model& model, const std::vector<Snapshot>& states,
                                     double scale, const std::string& title);
// A mechanism before and after its motion, with hinges and load, as an SVG document.
[[nodiscard]] std::string mechanism_svg(const Model& model, const Mechanism& mechanism);

// Data of a run's page: snapshots and frames, curve, numbers and inputs.
[[nodiscard]] std::string run_data(const ModelSpec& spec, const Model& model, const Result& result);

// Functions that draw the walls of a campaign's samples; without them the page has no walls.
struct SampleWalls {
  ModelBuilder build;  // of the study
  // Stored states of a sample (1-based), with its model.
  std::function<std::vector<Snapshot>(int, const Model&)> states;
};
// Data of a campaign's page; the campaign may be empty. Cost: one compilation of a model for each sample's wall.
[[nodiscard]] std::string campaign_data(const Campaign& campaign, const Statistics& statistics,
                                        const SampleWalls& walls = {});

// Data of the page of a limit analysis; `mechanisms_json` is the text of its mechanisms.json.
[[nodiscard]] std::string limit_data(const ModelSpec& spec, const Model& model,
                                     const std::string& mechanisms_json);

// Data of the page of a comparison.
[[nodiscard]] std::string comparison_data(const PairedComparison& comparison);

// The page of `wythe assess`: one A4 sheet for the signature, then the tables behind it.
[[nodiscard]] std::string verdict_page(const WallsVerdict& verdict, const ModelSpec& spec,
                                       const Model& model, const std::string& language = "en");

// Makes the page from these bytes. Throws IoError where they are damaged or of another version, InputError
// where the language is not one of report_languages().
[[nodiscard]] std::string report_page(const std::string& data, const std::string& language = "en");
[[nodiscard]] std::vector<std::string> report_languages();  // codes such as "en" and "de"

}  // namespace wythe
