// Stated levels are taken in order. A climbing intensity rises in equal steps to the first collapse; then the
// interval from the highest that it survived to that of the collapse is halved (docs/theory/fragility.md, "Samples
// and shakes"). A shake that does not count moves neither bound, and between the bounds it ends the sample.
#include "campaign/runner/shakes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/hash.h"
#include "dynamics/meters/still_moving.h"
#include "wythe/parts/error.h"
#include "wythe/parts/ground_motion.h"

namespace wythe {

bool ShakeResult::counts() const {
  const bool stood = status == to_string(SolveStatus::kCompleted) && !collapsed;
  const bool fell = status == to_string(SolveStatus::kCollapsed) && collapsed;
  return (stood || fell) && gap_ratio <= kMostEnergyGap;
}

ShakeCount count_shakes(const StudySpec& study) {
  const ShakingSpec& s = study.shaking;
  const int samples = count_samples(study);
  if (!s.is_asked()) return {samples, samples};
  ShakeCount count;
  for (int i = 0; i < samples; ++i) {
    const StudyRecord& record = s.record[case_of(study, i).record];
    const std::vector<double>& levels = record.levels.empty() ? s.levels : record.levels;
    const int rising =
        s.climbs() ? 1 + static_cast<int>(std::floor((s.most - s.first) / s.step * (1 + 1e-9)))
                   : static_cast<int>(levels.size());
    count.least += s.climbs() ? std::min(rising, 1 + s.halvings) : rising;
    count.most += rising + (s.climbs() ? s.halvings : 0);
  }
  return count;
}

namespace study {

std::optional<double> next_intensity(const ShakingSpec& shaking, const StudyRecord& record,
                                     const std::vector<ShakeResult>& done) {
  if (!shaking.climbs()) {
    const std::vector<double>& levels = record.levels.empty() ? shaking.levels : record.levels;
    if (done.size() < levels.size()) return levels[done.size()];
    return std::nullopt;
  }
  // increasing up to the first collapse, then between the highest survived and the lowest collapsed intensity
  double low = 0, high = std::numeric_limits<double>::infinity();
  int halved = 0;
  for (const ShakeResult& shake : done) {
    const bool halves = std::isfinite(high);
    halved += halves ? 1 : 0;
    if (!shake.counts()) {
      if (halves) return std::nullopt;  // the next one would be the same
      continue;
    }
    (shake.collapsed ? high : low) = shake.intensity;
  }
  if (std::isfinite(high))
    return halved < shaking.halvings ? std::optional(0.5 * (low + high)) : std::nullopt;
  const double next = shaking.first + static_cast<double>(done.size()) * shaking.step;
  return next <= shaking.most * (1 + 1e-9) ? std::optional(next) : std::nullopt;
}

namespace {

// Corrects results that their status does not show. A wall that lost blocks counts as collapsed. Three kinds of result
// count as neither: a wall that fell before the study's shake, still moves, or has joints that slid off their faces.
void judge_end(const ShakingSpec& shaking, const Model& model, const Result& result,
               ShakeResult& out) {
  const auto says_nothing = [&](Message why) {
    out.status = to_string(SolveStatus::kNotSettled);
    out.reason = std::move(why);
    out.collapsed = false;
  };
  const std::string last = result.stages.empty() ? "" : result.stages.back().name;
  if (out.collapsed) {
    if (shaking.is_asked() && last != shaking.stage)
      says_nothing({"shake.fell_before", {{"stage", last}}});
    return;
  }
  if (out.status != to_string(SolveStatus::kCompleted)) return;
  if (result.debris.blocks > 0) {
    out.collapsed = true;
    out.status = to_string(SolveStatus::kCollapsed);
    out.reason = {"shake.shed", {{"blocks", static_cast<double>(result.debris.blocks)}}};
  } else if (!result.validity.holds()) {
    says_nothing({"shake.slid_off", {{"joints", static_cast<double>(result.validity.joints)}}});
  } else if (dynamics::is_still_moving(model, result)) {
    says_nothing({"shake.still_moving"});
  }
}

}  // namespace

ShakeResult shake_answer(const ShakingSpec& shaking, double intensity, const Model& model,
                         const Result& result) {
  const ShakeReadings& r = result.shaking;
  ShakeResult out;
  out.intensity = intensity;
  out.status = to_string(result.status);
  out.reason = result.reason;
  out.collapsed = r.collapsed;
  out.gap_ratio = result.energy.gap_ratio;
  out.steps = result.steps;
  out.time_step = result.time_step;
  if (result.status != SolveStatus::kUnstable) out.state_hash = result.state_hash;
  for (const Stage& stage : model.stages) {
    const bool is_it = shaking.is_asked() ? stage.spec.name == shaking.stage
                                          : stage.spec.kind() == StageKind::kShake;
    if (!is_it) continue;
    const GroundMotion& first = stage.base.empty() ? stage.driven_motion : stage.base.front();
    if (first.empty()) break;
    out.pga = peak_acceleration(first);
    out.pgv = peak_velocity(first);
    if (shaking.measure == IntensityMeasure::kSa && shaking.is_asked())
      out.sa = pseudo_acceleration(first, shaking.period, shaking.damping);
    break;
  }
  judge_end(shaking, model, result, out);
  const bool ended = out.status == to_string(SolveStatus::kCompleted) || out.collapsed;
  if (ended && !(out.gap_ratio <= kMostEnergyGap))
    out.reason = {"rate.energy_missing", {{"gap_percent", 100 * out.gap_ratio}}};
  if (!r.was_shaken || r.motion.empty() || !out.counts()) return out;
  out.peak_drift = r.peak_drift;
  out.residual_drift = r.residual_drift;
  out.peak_displacement = r.motion.front().peak;
  out.residual_displacement = r.motion.front().residual;
  out.uplift = r.largest_opening;
  out.slip = r.largest_slip;
  out.peak_base_shear = r.peak_base_shear;
  if (out.collapsed) out.collapse_time = r.collapse_time;
  return out;
}

void check_control_point(const ShakingSpec& shaking, const Model& model) {
  if (model.watched.empty() || model.watched.front().height > 0) return;
  for (const LimitStateSpec& limit : shaking.limit_state)
    if (std::isfinite(limit.peak_drift) || std::isfinite(limit.residual_drift))
      throw InputError(
          {{.path = "history." + model.watched.front().name,
            .value = fmt::format("{:g} m", model.watched.front().height),
            .problem = fmt::format("is the height of the control point, and limit "
                                   "state {} asks for its drift, which is its way "
                                   "over its height",
                                   limit.name),
            .cure = "let the first [[history]] be a point above the foot of the wall"}});
}

void sum_up(const std::vector<ShakeResult>& shakes, SampleRecord& record) {
  Hash hash;
  const ShakeResult* failed = nullptr;
  const ShakeResult* fell = nullptr;
  for (const ShakeResult& shake : shakes) {
    hash.add(shake.state_hash);
    if (!shake.counts() && failed == nullptr) failed = &shake;
    if (shake.counts() && shake.collapsed && fell == nullptr) fell = &shake;
  }
  record.status = to_string(fell != nullptr ? SolveStatus::kCollapsed : SolveStatus::kCompleted);
  record.reason = fell != nullptr ? fell->reason : shakes.back().reason;
  if (failed != nullptr) {
    record.status = failed->status;
    record.reason = failed->reason;
  }
  record.state_hash = shakes.size() == 1 ? shakes.front().state_hash : hash.text();
}

}  // namespace study
}  // namespace wythe
