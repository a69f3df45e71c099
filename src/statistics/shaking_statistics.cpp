// shaking_statistics: limit states and responses of samples under records.
//
//   shakes ──► brackets of each limit state ──► lognormal fit, intervals, scatter
//          └─► response at each intensity
//
// All sums run in the order of record names and of walls, so the order of records in the study changes no
// bit. Shakes that do not count (ShakeResult::counts) are listed, but neither as survived nor as collapsed.
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <tuple>

#include "statistics/bootstrap.h"
#include "statistics/intervals.h"
#include "statistics/lognormal_fit.h"
#include "statistics/scatter.h"
#include "wythe/parts/statistics.h"

namespace wythe {
namespace study {
namespace {

constexpr int kShakenCurvePoints = 41;
constexpr double kMostLostReplicates = 0.05;  // of a bootstrap, without a fit
constexpr std::uint64_t kSeedOfShakes = 0x46524147u;

// A sample with shakes, in the order of the sums.
struct Shaken {
  const SampleRecord* sample;
  SampleCase of;
  int record_rank = 0;                     // by name; equal motions have the rank of the first
  std::vector<const ShakeResult*> shakes;  // by intensity
};

// Joins records that are one motion under several names: a wall ends in the same state to the last bit at one intensity.
void join_equal_records(std::vector<Shaken>& samples) {
  using Key = std::tuple<int, double, std::string>;  // wall, intensity, state
  std::map<Key, int> seen;
  std::map<int, int> first;  // for equal ranks
  for (const Shaken& sample : samples)
    for (const ShakeResult* shake : sample.shakes) {
      if (shake->state_hash.empty()) continue;
      const auto [place, is_new] = seen.emplace(
          Key{sample.of.wall, shake->intensity, shake->state_hash}, sample.record_rank);
      if (!is_new && place->second != sample.record_rank)
        first.emplace(sample.record_rank, place->second);
    }
  for (Shaken& sample : samples)
    for (auto same = first.find(sample.record_rank); same != first.end();
         same = first.find(sample.record_rank))
      sample.record_rank = same->second;
}

std::vector<Shaken> shaken_of(const Campaign& campaign) {
  const std::vector<StudyRecord>& records = campaign.study.shaking.record;
  std::vector<int> order(records.size()), rank(records.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return records[a].name < records[b].name; });
  for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = static_cast<int>(i);
  std::vector<Shaken> out;
  for (const SampleRecord& sample : campaign.records) {
    if (sample.shakes.empty()) continue;
    Shaken one{&sample, case_of(campaign.study, sample.sample - 1), 0, {}};
    if (one.of.record >= 0) one.record_rank = rank[one.of.record];
    for (const ShakeResult& shake : sample.shakes) one.shakes.push_back(&shake);
    std::stable_sort(one.shakes.begin(), one.shakes.end(),
                     [](const auto* a, const auto* b) { return a->intensity < b->intensity; });
    out.push_back(std::move(one));
  }
  std::stable_sort(out.begin(), out.end(), [](const Shaken& a, const Shaken& b) {
    return a.record_rank != b.record_rank ? a.record_rank < b.record_rank : a.of.wall < b.of.wall;
  });
  join_equal_records(out);
  return out;
}

// A bracket, and its ends if the lost shakes had reached the limit state, or had not.
struct Found {
  Bracket bracket;
  double if_reached = kInfinity, if_not = 0;
};

Found bracket_of(const LimitStateSpec& limit, const Shaken& sample) {
  Found found;
  Bracket& b = found.bracket;
  b.sample = sample.sample->sample;
  b.wall = sample.of.wall, b.record = std::max(0, sample.of.record);
  b.high = kInfinity;
  for (const ShakeResult* shake : sample.shakes)
    if (shake->counts() && reaches(limit, *shake)) b.high = std::min(b.high, shake->intensity);
  for (const ShakeResult* shake : sample.shakes) {
    if (!shake->counts() || reaches(limit, *shake)) continue;
    if (shake->intensity < b.high)
      b.low = std::max(b.low, shake->intensity);
    else
      b.came_back = true;
  }
  found.if_not = b.low;
  if (std::isfinite(b.high)) return found;
  for (const ShakeResult* shake : sample.shakes)
    if (!shake->counts() && shake->intensity > b.low) {
      b.is_known = false;
      found.if_reached = std::min(found.if_reached, shake->intensity);
      found.if_not = std::max(found.if_not, shake->intensity);
    }
  return found;
}

// Intensities that all samples share: the levels of the study and its records, or the steps upwards.
std::vector<double> grid_of(const ShakingSpec& s) {
  std::set<double> grid;
  if (s.climbs())
    for (int k = 0; s.first + k * s.step <= s.most * (1 + 1e-9); ++k)
      grid.insert(s.first + k * s.step);
  for (const StudyRecord& record : s.record) {
    const std::vector<double>& levels = record.levels.empty() ? s.levels : record.levels;
    grid.insert(levels.begin(), levels.end());
  }
  return {grid.begin(), grid.end()};
}

const ShakeResult* shake_at(const Shaken& sample, double intensity) {
  for (const ShakeResult* shake : sample.shakes)
    if (shake->intensity == intensity) return shake;
  return nullptr;
}

// Whether the sample collapsed below this intensity, so that it was not tested any more.
bool fell_below(const Shaken& sample, double intensity) {
  return std::any_of(sample.shakes.begin(), sample.shakes.end(), [&](const ShakeResult* shake) {
    return shake->counts() && shake->collapsed && shake->intensity < intensity;
  });
}

std::vector<LimitStateCount> counts_of(const ShakingSpec& shaking, const LimitStateSpec& limit,
                                       const std::vector<Shaken>& samples) {
  std::vector<LimitStateCount> out;
  for (const double intensity : grid_of(shaking)) {
    LimitStateCount count{.intensity = intensity, .share = {}};
    for (const Shaken& sample : samples) {
      const ShakeResult* shake = shake_at(sample, intensity);
      const bool after = shaking.climbs() && fell_below(sample, intensity);
      if (shake == nullptr && !after) continue;
      const bool counts = after || shake->counts();
      count.n += counts ? 1 : 0;
      count.lost += counts ? 0 : 1;
      count.reached += counts && (after || reaches(limit, *shake)) ? 1 : 0;
    }
    count.share = share_estimate(count.reached, count.n);
    out.push_back(count);
  }
  return out;
}

std::vector<Between> betweens(const std::vector<Found>& found) {
  std::vector<Between> data;
  for (const Found& f : found)
    if (f.bracket.is_known) data.push_back({f.bracket.low, f.bracket.high});
  return data;
}

// The median if the lost shakes reached the limit state, or did not.
double median_if(const std::vector<Found>& found, bool reached) {
  std::vector<Between> data = betweens(found);
  for (const Found& f : found)
    if (!f.bracket.is_known)
      data.push_back(reached ? Between{f.bracket.low, f.if_reached} : Between{f.if_not, kInfinity});
  return LognormalFit(data).median();
}

// Replicates of records, and of walls if there are several. Each kind is drawn separately, and a sample counts as
// often as its record or wall. Their variances add up, with Student's t (docs/theory/fragility.md, "How sure it is").
class Replicates {
 public:
  Replicates(const std::vector<Found>& found, const std::vector<Shaken>& samples, bool crossed,
             const LognormalFit& best)
      : best_{std::log(best.median()), std::log(best.beta())} {
    std::map<int, int> record, wall;
    for (std::size_t i = 0; i < found.size(); ++i)
      record.emplace(samples[i].record_rank, 1), wall.emplace(found[i].bracket.wall, 1);
    RandomBits bits(kSeedOfShakes);
    add(
        bits, record, [&](std::size_t i) { return record[samples[i].record_rank]; }, found);
    if (crossed && wall.size() > 1)
      add(
          bits, wall, [&](std::size_t i) { return wall[found[i].bracket.wall]; }, found);
  }
  [[nodiscard]] bool hold() const {
    return std::all_of(kinds_.begin(), kinds_.end(), [](const Kind& kind) {
      return static_cast<double>(kind.fits.size()) >= (1 - kMostLostReplicates) * kReplicates;
    });
  }
  [[nodiscard]] Interval median() const {
    const Interval i = around([](const Pair& fit) { return fit.first; }, 0);
    return {std::exp(i.low), std::exp(i.high)};
  }
  // The variance from few records or walls is too small by about 1 / (degrees + 1) of it, so it is corrected.
  [[nodiscard]] Interval beta() const {
    const double degrees = spread([](const Pair& fit) { return fit.first; }).degrees;
    const Interval i =
        around([](const Pair& fit) { return fit.second; }, -0.5 * std::log(1 - 1 / (degrees + 1)));
    return {std::exp(i.low), std::exp(i.high)};
  }
  // Interval of the curve: the smallest and largest value from the intervals of median and dispersion.
  [[nodiscard]] Interval at(double x) const {
    const Interval m = median(), b = beta();
    Interval p{1, 0};
    for (const double theta : {m.low, m.high})
      for (const double dispersion : {b.low, b.high}) {
        const double share = normal_cdf(std::log(x / theta) / dispersion);
        p = {std::min(p.low, share), std::max(p.high, share)};
      }
    return p;
  }

 private:
  using Pair = std::pair<double, double>;  // ln median, ln beta
  struct Kind {
    int drawn = 0;  // records, or walls
    std::vector<Pair> fits;
  };
  struct Spread {
    double variance = 0, degrees = 0;
  };

  template <class Weight>
  void add(RandomBits& bits, std::map<int, int>& count, const Weight& weight,
           const std::vector<Found>& found) {
    Kind& kind = kinds_.emplace_back();
    kind.drawn = static_cast<int>(count.size());
    for (int k = 0; k < kReplicates; ++k) {
      draw(bits, count);
      std::vector<Between> data;
      for (std::size_t i = 0; i < found.size(); ++i) {
        const Bracket& b = found[i].bracket;
        if (b.is_known && weight(i) > 0)
          data.push_back({b.low, b.high, static_cast<double>(weight(i))});
      }
      const LognormalFit fit(data);
      if (fit.is_told()) kind.fits.emplace_back(std::log(fit.median()), std::log(fit.beta()));
    }
  }
  static void draw(RandomBits& bits, std::map<int, int>& count) {
    std::vector<int*> place;
    for (auto& [key, number] : count) number = 0, place.push_back(&number);
    for (std::size_t i = 0; i < place.size(); ++i)
      ++*place[bits.below(static_cast<int>(place.size()))];
  }
  // Sum of the variances by records and by walls, each for a sample, and its degrees of freedom (Satterthwaite).
  template <class Of>
  [[nodiscard]] Spread spread(const Of& of) const {
    Spread sum;
    double squares = 0;
    for (const Kind& kind : kinds_) {
      Moments moments;
      for (const Pair& fit : kind.fits) moments.add(of(fit));
      const double degrees = kind.drawn - 1;
      const double variance =
          std::pow(moments.standard_deviation(), 2) * kind.drawn / std::max(1.0, degrees);
      sum.variance += variance;
      squares += variance * variance / std::max(1.0, degrees);
    }
    sum.degrees = squares > 0 ? std::max(1.0, sum.variance * sum.variance / squares) : 1;
    return sum;
  }
  template <class Of>
  [[nodiscard]] Interval around(const Of& of, double shift) const {
    const Spread s = spread(of);
    const double middle = of(best_) + shift, half = student_97(s.degrees) * std::sqrt(s.variance);
    return {middle - half, middle + half};
  }

  Pair best_;
  std::vector<Kind> kinds_;
};

// Whether each record occurs in one bracket only, so that brackets are independent.
bool are_independent(const std::vector<Found>& found, const std::vector<Shaken>& samples) {
  std::set<int> records;
  for (std::size_t i = 0; i < found.size(); ++i)
    if (found[i].bracket.is_known && !records.insert(samples[i].record_rank).second) return false;
  return true;
}

int records_known(const std::vector<Found>& found, const std::vector<Shaken>& samples) {
  std::set<int> records;
  for (std::size_t i = 0; i < found.size(); ++i)
    if (found[i].bracket.is_known) records.insert(samples[i].record_rank);
  return static_cast<int>(records.size());
}

void fit(const ShakingSpec& shaking, const std::vector<Found>& found,
         const std::vector<Shaken>& samples, LimitStateFragility& out) {
  const LognormalFit best(betweens(found));
  out.verdict = best.verdict();
  if (records_known(found, samples) < kFewestRecords) out.verdict = LimitStateVerdict::kFewRecords;
  if (out.verdict != LimitStateVerdict::kTold) return;
  out.median.value = best.median();
  out.beta.value = best.beta();
  out.log_likelihood = best.log_likelihood();
  out.by_bootstrap = !are_independent(found, samples);
  std::optional<Replicates> replicates;
  if (out.by_bootstrap) {
    replicates.emplace(found, samples, shaking.pairing == Pairing::kEach, best);
    if (replicates->hold()) {
      out.median.interval = replicates->median();
      out.beta.interval = replicates->beta();
    }
  } else {
    out.median.interval = best.profile_median();
    out.beta.interval = best.profile_beta();
  }
  if (out.lost > 0) {
    out.median_if_reached = median_if(found, true);
    out.median_if_not = median_if(found, false);
  }
  const double low = out.count.empty() ? best.median() : out.count.front().intensity;
  const double high = out.count.empty() ? best.median() : out.count.back().intensity;
  for (int k = 0; k < kShakenCurvePoints && high > low; ++k) {
    const double x = low * std::pow(high / low, static_cast<double>(k) / (kShakenCurvePoints - 1));
    Estimate p = best.at(x);
    if (out.by_bootstrap) p.interval = replicates->hold() ? replicates->at(x) : Interval{};
    out.curve.push_back({x, p});
  }
}

// Fit to the counts of stripes alone, with each shake as a sample of its own (Baker 2015, eq. 11).
void fit_counts(LimitStateFragility& out) {
  std::vector<Between> data;
  for (const LimitStateCount& c : out.count) {
    data.push_back({0, c.intensity, static_cast<double>(c.reached)});
    data.push_back({c.intensity, kInfinity, static_cast<double>(c.n - c.reached)});
  }
  const LognormalFit fit(data);
  out.count_median = fit.median();
  out.count_beta = fit.beta();
}

Scatter scatter_of_brackets(const std::vector<Found>& found, const std::vector<Shaken>& samples) {
  std::vector<Cell> cells;
  double squares = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Bracket& b = found[i].bracket;
    const bool has = b.is_known && b.low > 0 && std::isfinite(b.high);
    const double width = has ? std::log(b.high / b.low) : 0;
    squares += width * width / 12 / static_cast<double>(found.size());
    cells.push_back({samples[i].record_rank, b.wall,
                     has ? 0.5 * (std::log(b.low) + std::log(b.high)) : kUnset});
  }
  return scatter_of(cells, std::sqrt(squares));
}

LimitStateFragility fragility_of(const ShakingSpec& shaking, const LimitStateSpec& limit,
                                 const std::vector<Shaken>& samples) {
  LimitStateFragility out;
  out.limit_state = limit;
  std::vector<Found> found;
  for (const Shaken& sample : samples) found.push_back(bracket_of(limit, sample));
  for (const Found& f : found) {
    out.bracket.push_back(f.bracket);
    out.n += f.bracket.is_known ? 1 : 0;
    out.lost += f.bracket.is_known ? 0 : 1;
    out.reached += f.bracket.is_known && std::isfinite(f.bracket.high) ? 1 : 0;
    out.came_back += f.bracket.came_back ? 1 : 0;
  }
  std::sort(out.bracket.begin(), out.bracket.end(),
            [](const Bracket& a, const Bracket& b) { return a.sample < b.sample; });
  out.count = counts_of(shaking, limit, samples);
  fit(shaking, found, samples, out);
  if (!shaking.climbs() && out.verdict == LimitStateVerdict::kTold) fit_counts(out);
  out.scatter = scatter_of_brackets(found, samples);
  return out;
}

// The drift of a collapsed wall counts as infinite.
IntensitySummary intensity_summary(const ShakingSpec& shaking, double intensity,
                                   const std::vector<Shaken>& samples) {
  IntensitySummary out;
  out.intensity = intensity;
  std::vector<double> drift;
  std::vector<Cell> cells;
  for (const Shaken& sample : samples) {
    const ShakeResult* shake = shake_at(sample, intensity);
    const bool after = shaking.climbs() && fell_below(sample, intensity);
    if (shake == nullptr && !after) continue;
    const bool counts = after || shake->counts();
    const bool fell = after || (counts && shake->collapsed);
    out.lost += counts ? 0 : 1;
    out.collapsed += fell ? 1 : 0;
    if (counts) drift.push_back(fell ? kInfinity : shake->peak_drift);
    cells.push_back(
        {sample.record_rank, sample.of.wall,
         counts && !fell && shake->peak_drift > 0 ? std::log(shake->peak_drift) : kUnset});
  }
  out.n = static_cast<int>(drift.size());
  std::sort(drift.begin(), drift.end());
  // there is no mean of a number and infinity
  const auto share = [&](double p) {
    if (drift.empty()) return static_cast<double>(kUnset);
    const auto above =
        static_cast<std::size_t>(std::ceil(p * static_cast<double>(drift.size() - 1)));
    return std::isinf(drift[above]) ? kInfinity : quantile_of(drift, p);
  };
  out.drift_16 = share(0.16), out.drift_50 = share(0.5), out.drift_84 = share(0.84);
  out.scatter = scatter_of(cells, 0);
  return out;
}

}  // namespace
}  // namespace study

bool reaches(const LimitStateSpec& limit, const ShakeResult& shake) {
  return shake.collapsed || shake.peak_drift >= limit.peak_drift ||
         shake.residual_drift >= limit.residual_drift ||
         shake.peak_displacement >= limit.peak_displacement ||
         shake.residual_displacement >= limit.residual_displacement ||
         shake.uplift >= limit.uplift || shake.slip >= limit.slip;
}

ShakingStatistics shaking_statistics(const Campaign& campaign) {
  ShakingStatistics out;
  const ShakingSpec& shaking = campaign.study.shaking;
  out.shaking = shaking;
  const std::vector<study::Shaken> samples = study::shaken_of(campaign);
  std::set<int> records, walls;
  for (const study::Shaken& sample : samples) {
    records.insert(sample.of.record), walls.insert(sample.of.wall);
    for (const ShakeResult* shake : sample.shakes) {
      ++out.shakes;
      if (!shake->counts())
        out.lost.push_back({sample.sample->sample, shake->intensity, shake->status, shake->reason});
      else
        ++(shake->collapsed ? out.collapsed : out.stood);
    }
  }
  std::stable_sort(out.lost.begin(), out.lost.end(),
                   [](const LostShake& a, const LostShake& b) { return a.sample < b.sample; });
  out.samples = static_cast<int>(samples.size());
  out.records = static_cast<int>(records.size());
  out.walls = static_cast<int>(walls.size());
  if (!shaking.is_asked() || samples.empty()) return out;
  for (const double intensity : study::grid_of(shaking))
    out.intensity.push_back(study::intensity_summary(shaking, intensity, samples));
  for (const LimitStateSpec& limit : shaking.limit_state)
    out.fragility.push_back(study::fragility_of(shaking, limit, samples));
  return out;
}

}  // namespace wythe
