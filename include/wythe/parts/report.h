// report.html: one self-contained page for a run, a campaign or a limit analysis; and SVG pictures.
//
//   Result, Campaign, ... --*_data()--> bytes --report_page()--> report.html
//
// The bytes hold all the page shows (a JSON header and arrays, compressed) and no words of a
// language; a run keeps them beside its files as report.data, so that its page can be made again.
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

// Deformed, cracked wall at a snapshot as an SVG document; `scale` magnifies displacements.
[[nodiscard]] std::string wall_svg(const Model& model, const State& state, double scale);
// States of one wall side by side with their displacements, as an SVG document; `scale` 0: fitting.
[[nodiscard]] std::string states_svg(const Model& model, const std::vector<Snapshot>& states,
                                     double scale, const std::string& title);
// A mechanism before and after: bodies, hinges, load, as an SVG document.
[[nodiscard]] std::string mechanism_svg(const Model& model, const Mechanism& mechanism);

// Snapshots and frames, curve, numbers and inputs of a run.
[[nodiscard]] std::string run_data(const ModelSpec& spec, const Model& model, const Result& result);

// How the walls of a campaign's samples are drawn; without them its page has no walls.
struct SampleWalls {
  ModelBuilder build;  // of the study
  // Stored states of a sample (1-based), with its model.
  std::function<std::vector<Snapshot>(int, const Model&)> states;
};
// Data of any campaign, an empty one too. Cost: compiles one model for each sample's wall.
[[nodiscard]] std::string campaign_data(const Campaign& campaign, const Statistics& statistics,
                                        const SampleWalls& walls = {});

// Of a limit analysis; `mechanisms_json` is the text of its mechanisms.json.
[[nodiscard]] std::string limit_data(const ModelSpec& spec, const Model& model,
                                     const std::string& mechanisms_json);

// Options side by side.
[[nodiscard]] std::string comparison_data(const PairedComparison& comparison);

// The page of `wythe assess`: one sheet of A4 for who signs, then the tables it rests on.
[[nodiscard]] std::string verdict_page(const WallsVerdict& verdict, const ModelSpec& spec,
                                       const Model& model, const std::string& language = "en");

// The page made from these bytes. Throws IoError where they are damaged or of another version, InputError
// where the language is none of report_languages().
[[nodiscard]] std::string report_page(const std::string& data, const std::string& language = "en");
[[nodiscard]] std::vector<std::string> report_languages();

}  // namespace wythe
