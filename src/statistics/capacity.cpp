// Force and drift: mean curves (Fig. 21), drift capacities against the code, exceedance curves.
#include <algorithm>
#include <cmath>

#include "statistics/intervals.h"
#include "statistics/statistics_parts.h"
#include "statistics/survival.h"

namespace wythe::study {
namespace {

constexpr int kGrid = 100;  // steps of a mean curve

// Rows that go farther than all earlier rows: the reaction as a function of displacement.
std::vector<CurveRow> forward_rows(const std::vector<CurveRow>& curve) {
  std::vector<CurveRow> rows;
  for (const CurveRow& row : curve)
    if (rows.empty() || row.displacement > rows.back().displacement) rows.push_back(row);
  return rows;
}

// Linear between rows; NaN beyond the last row.
double reaction_at(const std::vector<CurveRow>& rows, double displacement) {
  const auto above =
      std::lower_bound(rows.begin(), rows.end(), displacement,
                       [](const CurveRow& row, double d) { return row.displacement < d; });
  if (above == rows.end()) return kUnset;
  if (above == rows.begin()) return above->reaction;
  const CurveRow &a = *(above - 1), &b = *above;
  const double share = (displacement - a.displacement) / (b.displacement - a.displacement);
  return a.reaction + share * (b.reaction - a.reaction);
}

struct SampleCurve {
  double height = 0;  // of the load [m]
  std::vector<CurveRow> rows;
};

CurvePoint point_at(const std::vector<SampleCurve>& curves, double displacement) {
  std::vector<double> reactions;
  Moments moments, drifts;
  for (const SampleCurve& curve : curves) {
    const double reaction = reaction_at(curve.rows, displacement);
    if (std::isnan(reaction)) continue;
    reactions.push_back(reaction);
    moments.add(reaction);
    drifts.add(curve.height > 0 ? displacement / curve.height : kUnset);
  }
  std::sort(reactions.begin(), reactions.end());
  CurvePoint point{.displacement = displacement, .n = moments.n(), .mean = moments.mean()};
  point.drift = drifts.mean();
  point.standard_deviation = moments.standard_deviation();
  point.low = quantile_of(reactions, 0.05), point.high = quantile_of(reactions, 0.95);
  return point;
}

struct CodeLimit {
  const char *element, *mechanism, *label;
  double near_collapse;
};
// Drift limits of elements: near collapse, and three quarters of it for life safety.
constexpr CodeLimit kCodeLimits[] = {
    {"pier", "shear", "pier, shear", 0.005},
    {"pier", "rocking or flexure", "pier, rocking", 0.010},
    {"spandrel without a tension member", "rocking or flexure", "spandrel, rocking", 0.015},
    {"spandrel with a tension member", "rocking or flexure", "spandrel, rocking", 0.020}};
constexpr double kLifeSafety = 0.75;
constexpr const char* kClause = "Circolare 21 January 2019 n. 7, C8.7.1.3.1.1";

DriftLimit limit_against(DriftLimit limit, const std::vector<Reading>& drifts) {
  for (const Reading& drift : drifts)
    if (drift.value < limit.limit) ++(drift.censored ? limit.unknown : limit.below);
  limit.share = share_before(drifts, limit.limit);
  limit.is_lower_bound = limit.unknown > 0 && !(drifts.back().value >= limit.limit);
  return limit;
}

}  // namespace

double height_of(const SampleRecord& record, double base_height) {
  const double own = record.responses.load_height;
  return own > 0 ? own : base_height;
}

MeanCurve mean_curve_of(const Group& group, double base_height) {
  MeanCurve out{group.name, static_cast<int>(group.record.size()), {}};
  std::vector<SampleCurve> curves;
  double farthest = 0;
  for (const SampleRecord* record : group.record) {
    curves.push_back({height_of(*record, base_height), forward_rows(backbone_of(record->curve))});
    farthest = std::max(farthest, curves.back().rows.back().displacement);
  }
  if (curves.empty()) return out;
  for (int i = 0; i <= kGrid; ++i)
    out.point.push_back(point_at(curves, i == kGrid ? farthest : farthest * i / kGrid));
  return out;
}

std::vector<DriftLimit> drift_limits(const Answered& samples) {
  if (samples.n() == 0) return {};
  const Quantity& quantity = quantity_named("displacement_at_80_percent");
  const Group known = with_value(all_of(samples), quantity);
  std::vector<Reading> drifts = readings_of(known, quantity);
  for (std::size_t i = 0; i < drifts.size(); ++i) {
    const double height = height_of(*known.record[i], samples.campaign.load_height);
    if (!(height > 0)) return {};
    drifts[i].value /= height;
  }
  if (drifts.empty()) return {};
  drifts = in_order(std::move(drifts));
  std::vector<DriftLimit> out;
  for (const CodeLimit& code : kCodeLimits) {
    for (const bool collapse : {false, true}) {
      DriftLimit limit;
      limit.element = code.element, limit.mechanism = code.mechanism, limit.label = code.label;
      limit.state = collapse ? "near collapse" : "life safety", limit.clause = kClause;
      limit.limit = code.near_collapse * (collapse ? 1 : kLifeSafety);
      out.push_back(limit_against(limit, drifts));
    }
  }
  return out;
}

std::vector<Exceedance> exceedances(const Answered& samples) {
  if (samples.n() == 0) return {};
  std::vector<Exceedance> out;
  for (const char* name :
       {"peak_reaction", "displacement_at_80_percent", "displacement_at_50_percent",
        "displacement_max", "collapse_displacement"})
    out.push_back(exceedance_of(name, readings_of(all_of(samples), quantity_named(name))));
  return out;
}

}  // namespace wythe::study
