// Compares limit loads and mechanisms with the curves of runs: peaks, post-peak branches, bounds.
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "core/elementary.h"
#include "limit/limit_loads.h"
#include "wythe/parts/limit.h"
#include "wythe/parts/reading.h"

namespace wythe {
namespace {

// Crack planes inside units whose strength a dry limit load takes away, as that of joints.
int planes_without_strength(const Model& model, const SecondOpinion& opinion) {
  const auto is_dry = [](const NamedLimit& limit) {
    return limit.answer.options.strength == JointStrength::kDry;
  };
  if (std::none_of(opinion.limits.begin(), opinion.limits.end(), is_dry)) return 0;
  int planes = 0;
  for (JointId j = 0; j < model.n_joint; ++j) {
    const double ft = model.materials[model.joint_material[j]].tensile_strength;
    planes += ft > 0 && std::isfinite(ft) && is_unit_plane(model, j) ? 1 : 0;
  }
  return planes;
}

// Percentile of sorted values, interpolated linearly between order statistics.
double at_share(const std::vector<double>& sorted, double share) {
  const double at = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], at - static_cast<double>(below));
}

std::size_t peak_row(const std::vector<CurveRow>& curve) {
  const auto peak = std::max_element(
      curve.begin(), curve.end(),
      [](const CurveRow& a, const CurveRow& b) { return a.reaction < b.reaction; });
  return static_cast<std::size_t>(peak - curve.begin());
}

double force_of(const std::vector<CurveRow>& curve, double displacement) {
  const auto after = std::find_if(curve.begin(), curve.end(), [&](const CurveRow& row) {
    return row.displacement >= displacement;
  });
  if (after == curve.begin()) return after->reaction;
  const CurveRow& a = *(after - 1);
  const double share = (displacement - a.displacement) / (after->displacement - a.displacement);
  return a.reaction + share * (after->reaction - a.reaction);
}

double peak_of(const ComparedRun& run) {
  if (run.load_factor > 0) return run.load_factor;
  if (run.capacity && std::isfinite(*run.capacity)) return *run.capacity;
  return run.curve.empty() ? 0 : run.curve[peak_row(run.curve)].reaction;
}

// Why a peak below its bound proves nothing: by the run's own verdict it is not the peak of a slow push.
Message why_no_evidence(const ComparedRun& run) {
  if (run.capacity && !std::isfinite(*run.capacity)) return {"evidence.no_balance"};
  if (run.judgement.empty() || run.judgement == "no push" || run.judgement == "slow enough")
    return {};
  return {"evidence.own_verdict", {{"verdict", run.rate_verdict}}};
}

void add_bounds(const ComparedRun& run, std::vector<BoundVerdict>& bounds) {
  const bool is_force = run.load_factor <= 0;
  // where the push is not horizontal, the reaction also carries loads on the driven blocks
  const double peak = peak_of(run) - (is_force ? run.weight_on_push : 0);
  const Message why = why_no_evidence(run);
  if (peak > 0 && run.bound >= 0)
    bounds.push_back({.run = run.name,
                      .peak = peak,
                      .bound = run.bound,
                      .is_force = is_force,
                      .no_evidence = why});
  const double back = run.peak_back + run.weight_on_push;
  if (back > 0 && run.bound_back >= 0)
    bounds.push_back({.run = run.name + ", backwards",
                      .peak = back,
                      .bound = run.bound_back,
                      .is_force = is_force,
                      .no_evidence = why});
}

std::vector<const Mechanism*> mechanisms_of(const ComparedRun& run,
                                            const std::vector<Mechanism>& mechanisms) {
  std::vector<const Mechanism*> own, all;
  for (const Mechanism& m : mechanisms) {
    all.push_back(&m);
    if (m.mode == run.mode) own.push_back(&m);
  }
  return own.empty() ? all : own;
}

// Means over the runs of one mode, for each mechanism.
std::vector<GroupVerdict> groups_of(const Comparison& c) {
  std::map<std::pair<std::string, std::string>, GroupVerdict> groups;
  std::map<std::string, double> peak;
  for (const ComparedRun& run : c.runs) peak[run.name] = peak_of(run);
  for (const CurveVerdict& v : c.curves) {
    GroupVerdict& g = groups[{v.mode, v.mechanism}];
    g.mode = v.mode;
    g.mechanism = v.mechanism;
    ++g.runs;
    g.mean_peak += peak.at(v.run);
    g.peak_ratio += v.peak_ratio;
    g.gap += v.gap;
    g.gap_share += v.gap_share;
  }
  std::vector<GroupVerdict> out;
  for (auto& [key, g] : groups) {
    for (double* mean : {&g.mean_peak, &g.peak_ratio, &g.gap, &g.gap_share}) *mean /= g.runs;
    out.push_back(g);
  }
  return out;
}

// Rounds to a millimetre, since walls are compared by these numbers as they are shown.
double to_millimetre(double length) { return std::round(1e3 * length) * 1e-3 + 0.0; }

double to_digits(double value, int digits) {
  if (value == 0 || !std::isfinite(value)) return value;
  const double scale =
      elementary::pow(10.0, digits - 1 - std::floor(elementary::log10(std::fabs(value))));
  return std::round(value * scale) / scale;
}

constexpr Word<Hypothesis> kHypothesisCodes[] = {
    {"hypothesis.infinite", Hypothesis::kInfinite},
    {"hypothesis.macro_block_1", Hypothesis::kMacroBlock1},
    {"hypothesis.macro_block_2", Hypothesis::kMacroBlock2}};
static_assert(names_all(kHypothesisCodes));

}  // namespace

// Means over displacement by the trapezoidal rule on the run's own rows.
CurveVerdict compare(const ComparedRun& run, const Mechanism& mechanism) {
  CurveVerdict v{.run = run.name, .mode = run.mode, .mechanism = mechanism.file_name()};
  if (run.curve.size() < 2) return v;
  const std::size_t peak = peak_row(run.curve);
  v.peak_ratio = run.curve[peak].reaction / mechanism.curve.states.front().force;
  const auto gap_at = [&](std::size_t i) {
    const CurveRow& row = run.curve[i];
    return std::fabs(row.reaction - mechanism.curve.force_at(row.displacement));
  };
  double area = 0;
  for (std::size_t i = peak + 1; i < run.curve.size(); ++i)
    area += 0.5 * (gap_at(i) + gap_at(i - 1)) *
            (run.curve[i].displacement - run.curve[i - 1].displacement);
  const double length = run.curve.back().displacement - run.curve[peak].displacement;
  v.gap = length > 0 ? area / length : gap_at(peak);
  const double highest = run.curve[peak].reaction;
  v.gap_share = highest > 0 ? v.gap / highest : 0;
  return v;
}

Comparison compare(std::string with, std::vector<ComparedRun> runs,
                   const std::vector<Mechanism>& mechanisms) {
  Comparison c;
  c.with = std::move(with);
  c.runs = std::move(runs);
  for (const ComparedRun& run : c.runs) {
    add_bounds(run, c.bounds);
    if (run.curve.size() < 2 || run.load_factor > 0) continue;
    for (const Mechanism* m : mechanisms_of(run, mechanisms)) c.curves.push_back(compare(run, *m));
  }
  c.groups = groups_of(c);
  return c;
}

std::vector<EnvelopePoint> envelope(const std::vector<ComparedRun>& runs, const std::string& mode) {
  std::vector<const ComparedRun*> of_mode;
  double farthest = 0;
  for (const ComparedRun& run : runs) {
    if (run.mode != mode || run.curve.size() < 2) continue;
    of_mode.push_back(&run);
    farthest = std::max(farthest, run.curve.back().displacement);
  }
  constexpr int kPoints = 250;
  std::vector<EnvelopePoint> points;
  for (int i = 0; i <= kPoints; ++i) {
    EnvelopePoint p{.displacement = farthest * i / kPoints};
    std::vector<double> forces;
    for (const ComparedRun* run : of_mode)
      if (run->curve.back().displacement >= p.displacement)
        forces.push_back(force_of(run->curve, p.displacement));
    if (2 * forces.size() < of_mode.size() || forces.empty()) break;
    std::sort(forces.begin(), forces.end());
    p.runs = static_cast<int>(forces.size());
    p.low = forces.front(), p.high = forces.back();
    p.mean = std::accumulate(forces.begin(), forces.end(), 0.0) / p.runs;
    p.percentile_5 = at_share(forces, 0.05), p.percentile_95 = at_share(forces, 0.95);
    points.push_back(p);
  }
  return points;
}

Message described(const Model& given) {
  const Model model = with_rigid_bodies(with_what_stands(given));
  double weight = 0, x = 0, y = 0, down = 0, at = 0;
  for (std::size_t b = 0; b < model.gravity_mass.size(); ++b) {
    const double w = model.solve.gravity * model.gravity_mass[b];
    weight += w, x += w * model.centroid_x[b], y += w * model.centroid_y[b];
  }
  for (const Stage& stage : model.stages) {
    for (const PointLoad& p : stage.loads) {
      down -= p.fy;
      at -= p.fy * (model.centroid_x[p.block] + p.arm_x);
    }
  }
  std::vector<Message> parts = {{"wall.blocks",
                                 {{"blocks", model.n_block},
                                  {"weight_kN", to_digits(1e-3 * weight, 4)},
                                  {"x_m", to_millimetre(weight > 0 ? x / weight : 0)},
                                  {"y_m", to_millimetre(weight > 0 ? y / weight : 0)}}}};
  if (down > 0)
    parts.push_back(
        {"wall.load", {{"load_kN", to_digits(1e-3 * down, 4)}, {"x_m", to_millimetre(at / down)}}});
  const Stage* grows = limit::growing_stage(model);
  if (grows == nullptr) {
    parts.push_back({"wall.no_push"});
    return {"wall.described", {{"parts", std::move(parts)}}};
  }
  Vec2 push;
  const auto n = static_cast<double>(grows->driven.size());
  for (std::size_t k = 0; k < grows->driven.size(); ++k) {
    const std::size_t b = grows->driven[k];
    push.x += grows->driven_share[k] * model.centroid_x[b] / n;
    push.y += grows->driven_share[k] * model.centroid_y[b] / n;
  }
  if (std::isfinite(grows->drive_arm)) push.y += grows->drive_arm;
  Message pushed{
      grows->driven.empty() ? "wall.loaded" : "wall.pushed",
      {{"drive_x", to_digits(grows->drive_x, 3)}, {"drive_y", to_digits(grows->drive_y, 3)}}};
  if (!grows->driven.empty()) {
    pushed.arguments.emplace_back("x_m", to_millimetre(push.x));
    pushed.arguments.emplace_back("y_m", to_millimetre(push.y));
  }
  parts.push_back(std::move(pushed));
  return {"wall.described", {{"parts", std::move(parts)}}};
}

Message in_words(const std::string& mode, Hypothesis hypothesis) {
  return {"limit.mechanism",
          {{"mode", mode}, {"hypothesis", Message{word_of(kHypothesisCodes, hypothesis)}}}};
}

BracketVerdict bracket_of(const SecondOpinion& opinion) {
  BracketVerdict v;
  std::vector<NamedLimit> limits;  // for a push on blocks only
  for (const NamedLimit& limit : opinion.limits)
    if (!limit.answer.options.loads_are_masses) limits.push_back(limit);
  if (limits.empty()) return v;
  const auto [low, high] = std::minmax_element(
      limits.begin(), limits.end(),
      [](const auto& a, const auto& b) { return a.answer.load < b.answer.load; });
  v.low = low->answer.load;
  v.high = high->answer.load;
  v.is_force = low->answer.is_force;
  for (const ComparedRun& run : opinion.comparison.runs) {
    const double peak = peak_of(run);
    if (!(peak > 0) || v.is_force != (run.load_factor <= 0)) continue;
    v.least_peak = v.runs == 0 ? peak : std::min(v.least_peak, peak);
    v.most_peak = std::max(v.most_peak, peak);
    ++v.runs;
    v.below += peak < v.low;
    v.above += peak > v.high * (1 + kBoundTolerance);
  }
  return v;
}

std::vector<Message> notes_on(const Model& model, const SecondOpinion& opinion) {
  std::vector<Message> notes;
  if (const int planes = planes_without_strength(model, opinion); planes > 0)
    notes.push_back({"limit.cracked_units", {{"planes", planes}}});
  for (const Mechanism& m : opinion.mechanisms) {
    for (const Mechanism& n : opinion.mechanisms) {
      const double infinite = n.curve.states.front().force, own = m.curve.states.front().force;
      if (n.mode != m.mode || n.hypothesis != Hypothesis::kInfinite || own <= infinite) continue;
      notes.push_back({"limit.above_infinite",
                       {{"mechanism", in_words(m.mode, m.hypothesis)},
                        {"force_kN", 1e-3 * own},
                        {"infinite_kN", 1e-3 * infinite}}});
    }
  }
  for (const NamedLimit& limit : opinion.limits)
    if (limit.answer.friction_excess > kFrictionCircle)
      notes.push_back({"limit.friction_circles",
                       {{"case", limit.name}, {"percent", 100 * limit.answer.friction_excess}}});
  const Message here = described(model);
  std::vector<Message> others;
  for (const ComparedRun& run : opinion.comparison.runs)
    if (!run.wall.empty() && run.wall != here &&
        std::find(others.begin(), others.end(), run.wall) == others.end())
      others.push_back(run.wall);
  for (const Message& other : others)
    notes.push_back({"limit.another_wall",
                     {{"with", opinion.comparison.with}, {"other", other}, {"model", here}}});
  return notes;
}

}  // namespace wythe
