// campaign_data(): the data for the page of a campaign. Statistics are those of statistics.json.
//
// Of more than kMostShown samples the page shows this number one by one, evenly
// spaced; its statistics use all. Curves are in single precision. Walls are the
// stored states of each sample, within kMostWallNumbers. The last state of every
// sample comes before further states of any. Each sample has its own fields.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "campaign/draws/margin.h"
#include "core/decimal_point.h"
#include "report/bundle.h"
#include "report/model_inputs.h"
#include "report/translation.h"
#include "report/wall_arrays.h"
#include "wythe/parts/error.h"
#include "wythe/parts/failure_mode.h"
#include "wythe/parts/io.h"
#include "wythe/parts/report.h"

namespace wythe {
namespace {

using namespace report;

constexpr int kDensityPoints = 121;
constexpr double kMostWallNumbers = 4e6;  // about 5 MB of the page
constexpr std::size_t kMostShown =
    2000;  // curves of a picture, rows of a table, samples with a wall

using Shown = std::vector<const SampleRecord*>;

// All samples, or kMostShown evenly spaced ones and the first one of each failure mode that none of them has.
Shown shown_of(const std::vector<SampleRecord>& records) {
  Shown shown(std::min(records.size(), kMostShown));
  std::set<std::string> modes;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    shown[i] = &records[i * records.size() / shown.size()];
    if (is_answered(*shown[i])) modes.insert(shown[i]->failure_mode.name);
  }
  if (shown.size() == records.size()) return shown;
  for (const SampleRecord& r : records)
    if (is_answered(r) && modes.insert(r.failure_mode.name).second) shown.push_back(&r);
  std::sort(shown.begin(), shown.end());  // ascending, because they are in one array
  return shown;
}

// --- inputs --------------------------------------------------------------------------------------

double shown(const InputColumn& column, double si) { return si * column.to_unit + column.offset; }

// Density over the range of the samples, in the displayed unit.
Json density_of(const Campaign& campaign, std::size_t k) {
  const InputColumn& column = campaign.samples.column[k];
  if (k >= campaign.study.variable.size() || campaign.samples.value.empty()) return nullptr;
  const VariableSpec& variable = campaign.study.variable[k];
  if (variable.distribution == DistributionKind::kEmpirical) return nullptr;
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const auto& row : campaign.samples.value)
    low = std::min(low, row[k]), high = std::max(high, row[k]);
  const Margin margin(variable);
  Json x = Json::array(), y = Json::array();
  for (int i = 0; i < kDensityPoints; ++i) {
    const double at = low + (high - low) * i / (kDensityPoints - 1);
    x.push_back(shown(column, at));
    y.push_back(margin.density(at) / std::fabs(column.to_unit));
  }
  return {{"x", x}, {"y", y}};
}

void add_inputs(Bundle& bundle, const Campaign& campaign) {
  // a wall under several records is drawn once
  std::vector<std::size_t> walls;
  for (std::size_t i = 0; i < campaign.samples.value.size(); ++i)
    if (case_of(campaign.study, static_cast<int>(i)).wall == static_cast<int>(walls.size()))
      walls.push_back(i);
  Json list = Json::array();
  std::vector<float> values;
  for (std::size_t k = 0; k < campaign.samples.column.size(); ++k) {
    const InputColumn& column = campaign.samples.column[k];
    const auto& variables = campaign.study.variable;
    const auto& dependents = campaign.study.dependent;
    Json input = {{"name", column.name},
                  {"title", column_title(column)},
                  {"unit", column.unit == "1" ? "" : column.unit},
                  {"path", column.path},
                  {"random", column.is_random}};
    if (k < variables.size())
      input["distribution"] = word_of(kDistributionWords, variables[k].distribution);
    else if (k - variables.size() < dependents.size())
      input["formula"] = dependents[k - variables.size()].formula;
    input["density"] = density_of(campaign, k);
    list.push_back(input);
    for (const std::size_t i : walls)
      values.push_back(static_cast<float>(shown(column, campaign.samples.value[i][k])));
  }
  bundle.header["inputs"] = list;
  bundle.header["drawn"] = walls.size();
  bundle.add("input", values);  // (n_column, n_sample)
}

// --- results -------------------------------------------------------------------------------------

Json sample_of(const SampleRecord& r, double read_modes_at) {
  Json json = {{"sample", r.sample},
               {"status", r.status},
               {"reason", translated(r.reason)},
               {"answered", is_answered(r)},
               {"rows", backbone_of(r.curve).size()}};
  if (!is_answered(r)) return json;
  json["mode"] = r.failure_mode.name;
  json["sentence"] = translated(shortened(r.failure_mode.sentence));
  json["read_at_mm"] = r.failure_mode.read_at * 1e3;
  json["read_early"] = is_read_early(r.failure_mode.read_at, read_modes_at);
  json["still_rising"] = is_still_rising(r);
  for (const Quantity& q : quantities()) {
    const Reading reading = q.read(r.responses);
    json["response"].push_back(reading.value * q.to_unit);
    json["censored"].push_back(reading.censored);
  }
  json["verdict"] = translated(r.quasi_static.verdict);
  json["judgement"] = r.quasi_static.judgement;
  json["state_hash"] = r.state_hash;
  return json;
}

void add_samples(Bundle& bundle, const Shown& shown, double read_modes_at) {
  Json list = Json::array();
  std::vector<float> displacement, reaction;
  for (const SampleRecord* r : shown) {
    list.push_back(sample_of(*r, read_modes_at));
    for (const CurveRow& row : backbone_of(r->curve)) {
      displacement.push_back(static_cast<float>(row.displacement * 1e3));
      reaction.push_back(static_cast<float>(row.reaction * 1e-3));
    }
  }
  bundle.header["samples"] = list;
  bundle.add("curve.displacement_mm", displacement);
  bundle.add("curve.reaction_kN", reaction);
}

// Every shake that counts, for the figure of response over intensity.
void add_shakes(Bundle& bundle, const Campaign& campaign) {
  Json list = Json::array();
  for (const SampleRecord& r : campaign.records) {
    const SampleCase of = case_of(campaign.study, r.sample - 1);
    for (const ShakeResult& shake : r.shakes)
      if (shake.counts())
        list.push_back({{"sample", r.sample},
                        {"wall", of.wall + 1},
                        {"record", of.record + 1},
                        {"intensity", shake.intensity},
                        {"drift_percent", 1e2 * shake.peak_drift},
                        {"residual_percent", 1e2 * shake.residual_drift},
                        {"collapsed", shake.collapsed}});
  }
  bundle.header["shakes"] = list;
  Json names = Json::array();
  for (const StudyRecord& record : campaign.study.shaking.record) names.push_back(record.name);
  bundle.header["records"] = names;
}

Json quantities_json() {
  Json list = Json::array();
  for (const Quantity& q : quantities())
    list.push_back({{"name", q.name},
                    {"key", key_of(q)},
                    {"unit", q.unit},
                    {"can_be_censored", q.can_be_censored}});
  return list;
}

// --- walls ---------------------------------------------------------------------------------------

struct SampleWall {
  ModelSpec spec;
  Model model;
};
SampleWall wall_of(const Campaign& campaign, const SampleWalls& walls, int sample) {
  try {
    ModelSpec spec = walls.build(settings_of(campaign.samples, sample - 1));
    Model model = compile(spec);
    return {std::move(spec), std::move(model)};
  } catch (const InputError& error) {
    throw IoError(fmt::format(
        "sample {}: it has run, but what the store holds of its inputs makes no wall: {}", sample,
        error.what()));
  }
}

bool same_shape(const Model& a, const Model& b) {
  const auto same_corners = [](const BodySpec& one, const BodySpec& other) {
    const auto same_part = [](const Polyhedron& p, const Polyhedron& q) {
      return p.face == q.face && std::ranges::equal(p.vertex, q.vertex, [](Vec3 v, Vec3 w) {
               return v.x == w.x && v.y == w.y && v.z == w.z;
             });
    };
    return std::ranges::equal(one.part, other.part, same_part);
  };
  return a.joint_a == b.joint_a && a.joint_b == b.joint_b &&
         std::ranges::equal(a.space.body, b.space.body, same_corners) &&
         a.anatomy.outline_x == b.anatomy.outline_x && a.anatomy.outline_y == b.anatomy.outline_y;
}

// Numbers in the page for one sample's fields.
double field_numbers(const Model& model) {
  double numbers = 0;
  for (const DrawnField& field : model.anatomy.fields)
    numbers += static_cast<double>(field.of_joint.size() + field.of_block.size());
  return numbers;
}

void add_walls(Bundle& bundle, const Campaign& campaign, const Shown& shown,
               const SampleWalls& walls) {
  if (!walls.build || !walls.states || shown.empty()) return;
  Json frames = Json::array();
  FrameArrays arrays(false);
  Model first;
  int most = 0;
  bool with_fields = false;  // fields use at most half of the space
  auto waiting = static_cast<int>(
      std::count_if(shown.begin(), shown.end(), [](auto* r) { return is_answered(*r); }));
  for (const SampleRecord* one : shown) {
    const SampleRecord& r = *one;
    if (!is_answered(r)) continue;
    --waiting;
    const auto [spec, model] = wall_of(campaign, walls, r.sample);
    const std::vector<Snapshot> states = walls.states(r.sample, model);
    if (states.empty()) continue;
    if (arrays.count() == 0) {
      first = model;
      add_wall(bundle, first);
      bundle.header["model"] = model_inputs(walls.build({}), first);
      bundle.header["names"] = names_of(first);
      const double of_fields = field_numbers(first) * (waiting + 1);
      with_fields = of_fields > 0 && of_fields <= 0.5 * kMostWallNumbers;
      const double room = kMostWallNumbers - (with_fields ? of_fields : 0);
      most = static_cast<int>(room / state_numbers(first));
    }
    if (arrays.count() >= most) break;  // no space for more
    // a wall of another shape does not fit these frames
    if (!same_shape(first, model)) continue;
    const int stored = static_cast<int>(states.size());
    const int kept = states_kept(stored, most - arrays.count(), waiting);
    if (with_fields && kept > 0) add_fields(bundle, spec, model, r.sample);
    for (int i = stored - kept; i < stored; ++i) {
      const Snapshot& s = states[i];
      arrays.add(model, s.state);
      frames.push_back({{"sample", r.sample},
                        {"label", s.label},
                        {"asked_mm", s.asked * 1e3},
                        {"stored", stored},
                        {"displacement_mm", s.displacement * 1e3},
                        {"reaction_kN", s.reaction * 1e-3}});
    }
  }
  bundle.header["frames"] = frames;
  arrays.write(bundle);
}

}  // namespace

std::string campaign_data(const Campaign& campaign, const Statistics& statistics,
                          const SampleWalls& walls) {
  Bundle bundle;
  bundle.header["kind"] = "campaign";
  bundle.header["title"] = campaign.study.name;
  bundle.header["note"] = campaign.study.note;
  const DecimalPoint point;
  bundle.header["statistics"] = Json::parse(statistics_json(statistics));
  translate_messages(bundle.header["statistics"]);
  bundle.header["quantities"] = quantities_json();
  bundle.header["provenance"] = campaign.provenance;
  bundle.header["model_file"] =  // pages are passed on: no folders of this machine
      std::filesystem::path(campaign.study.model_file).filename().string();
  bundle.header["model_text"] = campaign.study.model_text;
  if (!campaign.study.until.empty()) {
    Message measures;
    const bool met = precise_enough(campaign.study.until, campaign, &measures);
    bundle.header["until"] = {
        {"rule", campaign.study.until}, {"met", met}, {"measures", translated(measures)}};
  }
  if (statistics.shaking.shaking.is_asked()) add_shakes(bundle, campaign);
  add_inputs(bundle, campaign);
  const Shown shown = shown_of(campaign.records);
  if (shown.size() < campaign.records.size())
    bundle.header["thinned"] = {{"n", shown.size()}, {"of", campaign.records.size()}};
  add_samples(bundle, shown, statistics.read_modes_at);
  add_walls(bundle, campaign, shown, walls);
  return bundle.packed();
}

}  // namespace wythe
