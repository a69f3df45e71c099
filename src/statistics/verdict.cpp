// The verdict from many walls. Assesses each wall like a single run, in its worse direction. Then finds the deciding
// pattern and the certainty of the share of walls (docs/theory/assessment.md, "The verdict from many walls").
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "judge/assessment/assessment_parts.h"
#include "judge/modes/in_space.h"
#include "judge/modes/mode_names.h"
#include "statistics/intervals.h"
#include "statistics/one_push.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/verdict.h"

namespace wythe {
namespace {

constexpr double kHalf =
    0.5;  // of the walls: codes judge one wall of mean strengths, which is the median one

// Standard deviation of ln(peak) of tested walls of one masonry, size and pressure (docs/theory/assessment.md). A
// hundred equal walls show no more than one. Walls count as equal if they scatter by a tenth of the tests or less.
constexpr double kTestedScatter = 0.085, kAlike = 0.1;

bool is_in_plane(const Model& model, const std::string& mode) {
  return dimension_of(model) == 2 || study::stays_in_plane(mode);
}

// Bounds of a wall's capacity: `low` to `high` by its own curve, `least` to `most` if its
// force falls at any drift of tested walls. `seen` is the capacity that its pushes showed.
struct Range {
  Reading seen;
  double low = 0, high = kInfinity, least = 0, most = kInfinity;
};

Range range_of(const JudgedWall& wall, LimitState state) {
  Range out{.seen = wall.capacity(state)};
  if (!out.seen.is_known()) return out;
  const LimitStateCheck& check = *wall.assessment.at(state);
  out.low = out.seen.value;
  if (!out.seen.censored) out.high = out.seen.value;
  out.least = std::fmin(out.low, check.tested_low);  // fmin ignores a NaN
  out.most = std::fmax(out.high, check.tested_high);
  return out;
}

Range lesser(const Range& a, const Range& b) {
  const bool is_first = !b.seen.is_known() ||
                        (a.seen.is_known() && (a.seen.value < b.seen.value ||
                                               (a.seen.value == b.seen.value && !a.seen.censored)));
  return {is_first ? a.seen : b.seen, std::fmin(a.low, b.low), std::fmin(a.high, b.high),
          std::fmin(a.least, b.least), std::fmin(a.most, b.most)};
}

// The interval of a median of values that lie anywhere from `low` to `high`.
Interval median_between(const std::vector<Range>& ranges, double Range::*low, double Range::*high) {
  std::vector<Reading> from, to;
  for (const Range& r : ranges) {
    from.push_back({r.*low, false});
    to.push_back({std::isinf(r.*high) ? r.*low : r.*high, std::isinf(r.*high)});
  }
  return {of_walls(from).median.interval.low, of_walls(to).median.interval.high};
}

WallCapacity capacity_of(const std::vector<Range>& ranges) {
  std::vector<Reading> seen;
  for (const Range& r : ranges) seen.push_back(r.seen);
  const OfWalls known = of_walls(seen);
  WallCapacity out;
  out.at_least = std::isinf(known.median.value);
  out.median.value = out.at_least ? known.at_least : known.median.value;
  out.median.interval = median_between(ranges, &Range::low, &Range::high);
  out.with_tests = median_between(ranges, &Range::least, &Range::most);
  return out;
}

int severity(AssessmentVerdict verdict) {
  switch (verdict) {
    case AssessmentVerdict::kFails: return 3;
    case AssessmentVerdict::kNotKnown: return 2;
    case AssessmentVerdict::kNotShown: return 1;
    default: return 0;
  }
}

void count(AssessmentVerdict verdict, const Range& range, double demand, WallCounts& counts) {
  ++counts.walls;
  switch (verdict) {
    case AssessmentVerdict::kHolds: ++counts.met; break;
    case AssessmentVerdict::kFails: ++counts.not_met; break;
    case AssessmentVerdict::kNotShown: ++counts.not_shown; break;
    default: ++counts.lost; break;
  }
  if (verdict == AssessmentVerdict::kHolds && range.least >= demand) ++counts.met_anyhow;
  if (verdict == AssessmentVerdict::kFails && range.most < demand) ++counts.fails_anyhow;
}

AssessmentVerdict verdict_by(const Interval& share) {
  if (share.low > kHalf) return AssessmentVerdict::kFails;
  return share.high < kHalf ? AssessmentVerdict::kHolds : AssessmentVerdict::kNotShown;
}
AssessmentVerdict verdict_by(const WallCounts& counts) {
  if (counts.met + counts.not_met + counts.not_shown == 0) return AssessmentVerdict::kNotKnown;
  return verdict_by(counts.with_tests());
}

double demand_of_state(const AssessmentSpec& spec, LimitState state) {
  const ElasticSpectrum spectrum = spectrum_of(spectrum_for(spec, state));
  return spectrum.is_given() ? spectrum.peak_ground_acceleration() : kUnset;
}

// A rule of a code in words that are the same for all walls.
Message words_of_rule(const Criterion& criterion) {
  if (criterion.words.code != "assessment.q_limit") return criterion.words;
  return {"verdict.q_limit", {{"limit", criterion.value}}};
}

// One limit state of one pattern, with all its directions. A wall that is lost in one direction
// counts as lost, because that one may be the worst, unless another direction already fails.
class OfPattern {
 public:
  OfPattern(const AssessmentSpec& spec, const std::vector<WayOfPushing>& ways,
            const std::string& pattern, LimitState state)
      : ways_(ways) {
    out_.state = state;
    out_.pattern = pattern;
    out_.is_checked = is_checked(spec, state);
    if (out_.is_checked) out_.demand = demand_of_state(spec, state);
    for (std::size_t k = 0; k < ways.size(); ++k)
      if (ways[k].pattern == pattern) of_pattern_.push_back(k);
  }

  StateVerdict all() {
    std::vector<Range> capacities;
    for (std::size_t w = 0; w < ways_[of_pattern_.front()].walls.size(); ++w)
      capacities.push_back(judge_wall(w));
    out_.capacity = capacity_of(capacities);
    out_.verdict = out_.is_checked ? verdict_by(out_.counts) : AssessmentVerdict::kNoDemand;
    name_direction();
    collect_rules();
    return std::move(out_);
  }

 private:
  Range judge_wall(std::size_t w) {
    std::size_t worst = of_pattern_.front();
    Range capacity;
    for (const std::size_t k : of_pattern_) {
      const JudgedWall &now = ways_[k].walls[w], &before = ways_[worst].walls[w];
      const int is = severity(now.verdict(out_.state)), was = severity(before.verdict(out_.state));
      if (is > was ||
          (is == was && now.capacity(out_.state).value < before.capacity(out_.state).value))
        worst = k;
      const Range of_way = range_of(now, out_.state);
      capacity = k == of_pattern_.front() ? of_way : lesser(capacity, of_way);
    }
    out_.worst.push_back(worst);
    if (out_.is_checked)
      count(ways_[worst].walls[w].verdict(out_.state), capacity, out_.demand, out_.counts);
    return capacity;
  }

  // The direction that is worse for most walls.
  void name_direction() {
    std::map<std::size_t, int> walls;
    for (const std::size_t way : out_.worst) ++walls[way];
    std::size_t most = of_pattern_.front();
    for (const std::size_t k : of_pattern_)
      if (walls[k] > walls[most]) most = k;
    out_.direction = ways_[most].direction;
  }

  // Collects the rules that may end the limit state: the fall of the force, the drift of each pier.
  void collect_rules() {
    std::vector<std::vector<double>> at;
    for (std::size_t w = 0; w < out_.worst.size(); ++w) {
      const JudgedWall& wall = ways_[out_.worst[w]].walls[w];
      const LimitStateCheck* check = wall.is_lost() ? nullptr : wall.assessment.at(out_.state);
      if (check == nullptr) continue;
      for (const Criterion& c : check->criteria) {
        std::size_t k = 0;
        const Message words = words_of_rule(c);
        while (k < out_.rules.size() && !(out_.rules[k].words == words)) ++k;
        if (k == out_.rules.size()) out_.rules.push_back({.words = words}), at.emplace_back();
        ++out_.rules[k].walls;
        out_.rules[k].decides += c.name == check->governing ? 1 : 0;
        at[k].push_back(c.displacement);
      }
    }
    for (std::size_t k = 0; k < at.size(); ++k) {
      std::sort(at[k].begin(), at[k].end());
      out_.rules[k].displacement = study::quantile_of(at[k], kHalf);
    }
    std::stable_sort(
        out_.rules.begin(), out_.rules.end(),
        [](const RuleOfWalls& a, const RuleOfWalls& b) { return a.decides > b.decides; });
  }

  const std::vector<WayOfPushing>& ways_;
  std::vector<std::size_t> of_pattern_;
  StateVerdict out_;
};

// The worse verdict comes first, then fewer walls that meet it, then less capacity over demand. Unknown ones come last.
bool is_worse(const StateVerdict& a, const StateVerdict& b) {
  if (a.verdict != b.verdict) return severity(a.verdict) > severity(b.verdict);
  const double pa = a.counts.probability().value, pb = b.counts.probability().value;
  if (pa > pb || pb > pa) return pa > pb;
  const auto index = [](const StateVerdict& v) {
    return v.capacity.median.value / (std::isnan(v.demand) ? 1 : v.demand);
  };
  return index(a) < index(b);
}

// --- parts that fall on their face

bool is_found(const Refusal& part) { return part.what.code == "local.part_found"; }
bool fails(const LocalCheck& part) { return part.verdict == AssessmentVerdict::kFails; }

// Whether a check counts for a part. If rules found the part, and
// a caution forbids signing the check, it counts only if it fails.
bool is_counted(const LocalCheck& part) {
  if (fails(part)) return true;
  return part.verdict == AssessmentVerdict::kHolds && (!part.is_found() || part.may_be_signed);
}

// The effect of parts on the verdict. A part that the file names, with its holds, counts fully. A
// part found by rules may be held in ways not known, so a failure only turns a pass into "not shown".
AssessmentVerdict worth_of(const PartsOutOfPlane& parts) {
  AssessmentVerdict worst = AssessmentVerdict::kHolds;
  const auto take = [&](AssessmentVerdict verdict) {
    if (severity(verdict) > severity(worst)) worst = verdict;
  };
  for (const LocalCheck& part : parts.checked) {
    if (fails(part))
      take(part.is_found() ? AssessmentVerdict::kNotShown : AssessmentVerdict::kFails);
    else if (!part.is_found() && part.verdict != AssessmentVerdict::kHolds)
      take(AssessmentVerdict::kNotShown);
  }
  for (const Refusal& part : parts.refused)
    if (!is_found(part)) take(AssessmentVerdict::kNotShown);
  return worst;
}

// The file's own name of a part, or that of a part which rules found.
Message words_of(const std::string& name, bool is_found) {
  if (is_found && name == "wall") return {"local.wall"};
  if (is_found && name == "parapet") return {"local.parapet"};
  return as_text(name);
}
// "gable" of "local mechanism: gable".
Message name_of(const Refusal& part) {
  for (const Argument& argument : part.what.arguments)
    if (const auto* name = std::get_if<std::string>(&argument.value))
      return words_of(*name, is_found(part));
  return part.what;
}
std::vector<Message> names_of(const PartsOutOfPlane& parts, const auto& is_meant) {
  std::vector<Message> names;
  for (const LocalCheck& part : parts.checked)
    if (is_meant(part)) names.push_back(words_of_part(part));
  return names;
}
std::vector<Message> names_without_answer(const PartsOutOfPlane& parts) {
  std::vector<Message> names =
      names_of(parts, [](const LocalCheck& part) { return !is_counted(part); });
  for (const Refusal& part : parts.refused) names.push_back(name_of(part));
  return names;
}

class Verdict {
 public:
  Verdict(const AssessmentSpec& spec, std::vector<WayOfPushing> ways, int asked,
          std::vector<Message> cautions, std::vector<Message> notes, PartsOutOfPlane parts)
      : asked_(asked) {
    out_.parts = std::move(parts);
    out_.spec = spec;
    out_.spectrum = spectrum_of(spec.spectrum);
    out_.ways = std::move(ways);
    out_.cautions = std::move(cautions);
    out_.notes = std::move(notes);
    out_.worst.state =
        value_of(kLimitStateWords, spec.limit_state).value_or(LimitState::kLifeSafety);
  }

  WallsVerdict all() {
    out_.reason = refusal();
    if (out_.reason.empty()) judge();
    for (WayOfPushing& way : out_.ways) sum_up(way);
    conclude();
    return std::move(out_);
  }

 private:
  void sum_up(WayOfPushing& way) const {
    std::vector<Range> capacities;
    const StateVerdict& of = out_.worst;
    for (const JudgedWall& wall : way.walls) {
      capacities.push_back(range_of(wall, of.state));
      count(wall.verdict(of.state), capacities.back(), of.demand, way.counts);
    }
    way.capacity = capacity_of(capacities);
  }

  [[nodiscard]] Message refusal() const {
    if (out_.ways.empty()) return {"verdict.nothing_pushed"};
    if (!(demand_of_state(out_.spec, out_.worst.state) > 0)) return {"verdict.without_spectrum"};
    for (const WayOfPushing& way : out_.ways)
      if (static_cast<int>(way.walls.size()) != asked_)
        return {"verdict.walls_missing",
                {{"direction", way.direction},
                 {"pattern", words_of_pattern(way.pattern)},
                 {"run", way.walls.size()},
                 {"asked", asked_}}};
    for (const WayOfPushing& way : out_.ways)
      if (std::all_of(way.walls.begin(), way.walls.end(),
                      [](const JudgedWall& wall) { return wall.is_lost(); }))
        return {"verdict.all_lost",
                {{"direction", way.direction},
                 {"pattern", words_of_pattern(way.pattern)},
                 {"walls", asked_},
                 {"why", way.walls.empty() ? Message{} : way.walls.front().lost}}};
    return {};
  }

  void judge() {
    std::vector<std::string> patterns;
    for (const WayOfPushing& way : out_.ways)
      if (std::find(patterns.begin(), patterns.end(), way.pattern) == patterns.end())
        patterns.push_back(way.pattern);
    const StateVerdict* decides = nullptr;
    out_.limit_states.reserve(std::size(kLimitStateWords));
    for (std::size_t s = 0; s < std::size(kLimitStateWords); ++s) {
      const auto state = static_cast<LimitState>(s);
      if (!is_looked_at(state)) continue;
      StateVerdict worst = OfPattern(out_.spec, out_.ways, patterns.front(), state).all();
      for (std::size_t k = 1; k < patterns.size(); ++k) {
        StateVerdict other = OfPattern(out_.spec, out_.ways, patterns[k], state).all();
        if (is_worse(other, worst)) worst = std::move(other);
      }
      out_.limit_states.push_back(std::move(worst));
      const StateVerdict& of = out_.limit_states.back();
      if (of.is_checked && (decides == nullptr || is_worse(of, *decides))) decides = &of;
    }
    if (decides == nullptr) return;
    out_.worst = *decides;
    out_.of_pushes = decides->verdict;
    out_.spectrum = spectrum_of(spectrum_for(out_.spec, decides->state));
    name_mode();
  }

  [[nodiscard]] bool is_looked_at(LimitState state) const {
    for (const WayOfPushing& way : out_.ways)
      for (const JudgedWall& wall : way.walls)
        if (!wall.is_lost() && wall.assessment.at(state) != nullptr) return true;
    return false;
  }

  // The failure most often seen in the worst direction of each wall; of equals, the first by name.
  void name_mode() {
    std::map<std::string, int> modes;
    for (std::size_t w = 0; w < out_.worst.worst.size(); ++w) {
      const JudgedWall& wall = out_.ways[out_.worst.worst[w]].walls[w];
      if (!wall.is_lost()) ++modes[wall.mode];
    }
    for (const auto& [mode, walls] : modes)
      if (walls > out_.mode_count) out_.mode = mode, out_.mode_count = walls;
  }

  // --- cautions and notes -----------------------------------------------------------------------------

  // Cautions of single pushes: each kind once, with the number of pushes.
  void caution_of_pushes() {
    struct Kind {
      int pushes = 0;
      Message first;
    };
    std::vector<std::pair<std::string, Kind>> kinds;
    const auto add = [&](const Message& caution) {
      auto known = std::find_if(kinds.begin(), kinds.end(),
                                [&](const auto& kind) { return kind.first == caution.code; });
      if (known == kinds.end()) known = kinds.insert(kinds.end(), {caution.code, {0, caution}});
      ++known->second.pushes;
    };
    int all = 0;
    for (const WayOfPushing& way : out_.ways)
      for (const JudgedWall& wall : way.walls) {
        ++all;
        if (wall.is_lost()) continue;
        for (const Message& caution : wall.assessment.cautions)
          // a bound beyond the demand is enough, and one below it counts as not shown
          if (caution.code != "assessment.caution.bound") add(caution);
        if (!wall.is_in_plane)
          add({"verdict.not_in_plane", {{"mode", study::words_of_mode(wall.mode)}}});
      }
    for (auto& [code, kind] : kinds)
      out_.cautions.push_back({"verdict.caution.pushes",
                               {{"pushes", kind.pushes}, {"all", all}, {"what", kind.first}}});
  }

  void caution_of_walls() {
    int lost = 0, all = 0;
    Message first;
    for (const WayOfPushing& way : out_.ways)
      for (const JudgedWall& wall : way.walls) {
        ++all;
        if (!wall.is_lost()) continue;
        if (++lost == 1)
          first = {"verdict.lost_wall",
                   {{"wall", wall.wall},
                    {"direction", way.direction},
                    {"pattern", words_of_pattern(way.pattern)},
                    {"why", wall.lost}}};
      }
    if (lost > 0)
      out_.cautions.push_back(
          {"verdict.caution.lost", {{"lost", lost}, {"all", all}, {"first", first}}});
    if (out_.worst.counts.not_shown > 0)
      out_.cautions.push_back({"verdict.caution.not_shown",
                               {{"not_shown", out_.worst.counts.not_shown}, {"walls", asked_}}});
    if (out_.of_pushes != AssessmentVerdict::kNotShown) return;
    const bool walls_tell =
        verdict_by(out_.worst.counts.probability().interval) != AssessmentVerdict::kNotShown;
    const Interval& tests = out_.worst.capacity.with_tests;
    if (!walls_tell)
      caution_of_few(out_.worst.counts);
    else if (std::isinf(tests.high))
      out_.cautions.push_back(
          {"verdict.caution.drift_open", {{"low_g", tests.low / kStandardGravity}}});
    else
      out_.cautions.push_back(
          {"verdict.caution.drift",
           {{"low_g", tests.low / kStandardGravity}, {"high_g", tests.high / kStandardGravity}}});
  }

  // How many walls would decide. None if the share is near one half, or if too many walls are not known.
  void caution_of_few(const WallCounts& counts) {
    const int enough = walls_to_decide(counts);
    if (enough > 0)
      out_.cautions.push_back({"verdict.caution.undecided", {{"walls", enough}}});
    else if (counts.not_shown + counts.lost > 0)
      out_.cautions.push_back({"verdict.caution.hidden"});
    else
      out_.cautions.push_back({"verdict.caution.close", {{"walls", kMostToDecide}}});
  }

  // Walls that are nearly equal count as one wall that is repeated.
  void caution_of_alike() {
    for (const WayOfPushing& way : out_.ways) {
      if (way.pattern != out_.worst.pattern || way.direction != out_.worst.direction) continue;
      study::Moments logs;
      for (const JudgedWall& wall : way.walls)
        if (!wall.is_lost() && wall.peak > 0) logs.add(std::log(wall.peak));
      const double scatter = logs.standard_deviation();
      if (!(scatter < kAlike * kTestedScatter)) continue;
      out_.cautions.push_back({"verdict.caution.alike",
                               {{"walls", logs.n()},
                                {"percent", 100 * scatter},
                                {"tested_percent", 100 * kTestedScatter}}});
    }
  }

  // Cautions about parts out of plane: each kind once, with its parts.
  void caution_of_parts() {
    const PartsOutOfPlane& parts = out_.parts;
    std::vector<Message> falls =
        names_of(parts, [](const LocalCheck& part) { return part.is_found() && fails(part); });
    if (!falls.empty())
      out_.cautions.push_back({"verdict.caution.part_found", {{"parts", std::move(falls)}}});
    std::vector<std::pair<Message, std::vector<Message>>> kinds;  // the first, and names of parts
    for (const LocalCheck& part : parts.checked)
      for (const Message& caution : part.cautions) {
        if (part.is_found()) continue;
        auto known = std::find_if(kinds.begin(), kinds.end(), [&](const auto& kind) {
          return kind.first.code == caution.code;
        });
        if (known == kinds.end())
          known = kinds.insert(kinds.end(), {caution, std::vector<Message>{}});
        known->second.push_back(words_of_part(part));
      }
    for (auto& [caution, names] : kinds)
      out_.cautions.push_back(
          {"verdict.caution.parts", {{"parts", std::move(names)}, {"what", caution}}});
    // Data left out must not give the better verdict: a part that could not be checked for want of them, or that rules
    // found and that was checked without a confidence factor or with holds that nobody knows.
    std::vector<Message> names = names_of(parts, [](const LocalCheck& part) {
      if (!part.is_found()) return !is_counted(part);
      return std::any_of(part.cautions.begin(), part.cautions.end(), [](const Message& caution) {
        return caution.code == "local.caution.factor" || caution.code == "local.caution.not_known";
      });
    });
    for (const Refusal& part : parts.refused) names.push_back(name_of(part));
    if (!names.empty())
      out_.cautions.push_back({"verdict.caution.part_unchecked", {{"parts", std::move(names)}}});
  }

  void conclude() {
    const bool is_known = out_.of_pushes != AssessmentVerdict::kNotKnown;
    out_.verdict = out_.of_pushes;
    if (is_known) {
      caution_of_pushes();
      caution_of_walls();
      caution_of_alike();
      caution_of_parts();
      const AssessmentVerdict of_parts = worth_of(out_.parts);
      if (severity(of_parts) > severity(out_.of_pushes)) out_.verdict = of_parts;
    }
    if (!is_known && out_.reason.empty()) out_.reason = {"verdict.no_wall_answers"};
    out_.may_be_signed = is_known && out_.cautions.empty();
    const Message said = is_known ? with_parts(verdict_in_words())
                                  : Message{"assessment.not_known", {{"why", out_.reason}}};
    out_.sentence =
        out_.cautions.empty() || !is_known
            ? said
            : Message{"assessment.unsigned", {{"cautions", out_.cautions}, {"verdict", said}}};
    add_notes();
  }

  // The verdict of the pushes, after that of the parts if theirs is worse.
  [[nodiscard]] Message with_parts(Message of_pushes) const {
    const LocalCheck* least = out_.least_part();
    const bool falls = least != nullptr && fails(*least);
    const LocalStateCheck* of_part = least != nullptr ? least->deciding() : nullptr;
    if (falls || out_.part_decides()) {
      if (!falls)
        return {"verdict.parts_unchecked",
                {{"state", study::words_of_state(out_.worst.state)},
                 {"parts", names_without_answer(out_.parts)},
                 {"pushes", std::move(of_pushes)}}};
      return {
          least->is_found() ? "verdict.part_may_fall" : "verdict.part_fails",
          {{"state", study::words_of_state(of_part != nullptr ? of_part->state : out_.worst.state)},
           {"part", words_of_part(*least)},
           {"ratio", least->reserve()},
           {"pushes", std::move(of_pushes)}}};
    }
    if (least == nullptr) return of_pushes;
    return {"verdict.part_stands",
            {{"part", words_of_part(*least)},
             {"ratio", least->reserve()},
             {"pushes", std::move(of_pushes)}}};
  }

  [[nodiscard]] bool tests_widen() const {
    const Interval &walls = out_.worst.capacity.median.interval,
                   &tests = out_.worst.capacity.with_tests;
    return tests.low < walls.low || tests.high > walls.high;
  }

  [[nodiscard]] Message capacity_in_words() const {
    constexpr double kToG = 1 / kStandardGravity;
    const WallCapacity& capacity = out_.worst.capacity;
    const Interval& interval = capacity.with_tests;
    const char* code = tests_widen() ? "verdict.capacity_tested" : "verdict.capacity";
    if (capacity.at_least)
      code = tests_widen() ? "verdict.capacity_at_least_tested" : "verdict.capacity_at_least";
    else if (std::isnan(interval.low))
      code = "verdict.capacity_alone";
    else if (std::isinf(interval.high))
      code = tests_widen() ? "verdict.capacity_open_tested" : "verdict.capacity_open";
    return {code,
            {{"median_g", capacity.median.value * kToG},
             {"low_g", interval.low * kToG},
             {"high_g", interval.high * kToG}}};
  }

  [[nodiscard]] Message verdict_in_words() const {
    const WallCounts& counts = out_.worst.counts;
    const Interval share = counts.with_tests();
    const char* code = "verdict.undecided";
    if (out_.of_pushes == AssessmentVerdict::kFails) code = "verdict.fails";
    if (out_.of_pushes == AssessmentVerdict::kHolds) code = "verdict.holds";
    return {code,
            {{"state", study::words_of_state(out_.worst.state)},
             {"capacity", capacity_in_words()},
             {"demand_g", out_.worst.demand / kStandardGravity},
             {"met", counts.met},
             {"not_met", counts.not_met},
             {"walls", counts.met + counts.not_met},
             {"from", 100 * share.low},
             {"to", 100 * share.high},
             {"decides", out_.decides().words()},
             {"mode", study::words_of_mode(out_.mode)},
             {"modes", out_.mode_count}}};
  }

  // Drifts of tested walls, and their effect on the interval.
  void note_tests() {
    if (out_.of_pushes == AssessmentVerdict::kNotKnown) return;
    const std::vector<DriftOfTests>* tests = nullptr;
    int silent = 0;
    for (const WayOfPushing& way : out_.ways)
      for (const JudgedWall& wall : way.walls) {
        if (wall.is_lost()) continue;
        if (wall.assessment.tests.empty())
          ++silent;
        else
          tests = &wall.assessment.tests;
      }
    if (silent > 0) out_.notes.push_back({"verdict.note.no_tests", {{"pushes", silent}}});
    if (tests == nullptr) return;
    std::vector<Message> said;
    for (const DriftOfTests& t : *tests)
      said.push_back(
          {t.stone ? "verdict.tests.stone" : "verdict.tests.brick",
           {{"walls", t.walls},
            {"kind", Message{t.mechanism == "shear" ? "range.kind_shear" : "range.kind_rocking"}},
            {"low", 100 * t.low},
            {"high", 100 * t.high}}});
    const Interval& walls = out_.worst.capacity.median.interval;
    out_.notes.push_back({std::isfinite(walls.low) && std::isfinite(walls.high)
                              ? "verdict.note.tests"
                              : "verdict.note.tests_alone",
                          {{"tests", std::move(said)},
                           {"low_g", walls.low / kStandardGravity},
                           {"high_g", walls.high / kStandardGravity}}});
  }

  // Assumptions for every wall, each once, without those that many walls and ways replace.
  void add_notes() {
    note_tests();
    for (const WayOfPushing& way : out_.ways)
      for (const JudgedWall& wall : way.walls)
        for (const Message& note : wall.assessment.notes)
          if (note.code != "assessment.note.one_pattern" &&
              std::find(out_.notes.begin(), out_.notes.end(), note) == out_.notes.end())
            out_.notes.push_back(note);
    note_parts();
  }

  // What was not checked out of plane, instead of the note that nothing was.
  void note_parts() {
    const PartsOutOfPlane& parts = out_.parts;
    if (parts.checked.empty() && parts.refused.empty() && parts.not_looked_at.empty()) return;
    std::erase_if(out_.notes,
                  [](const Message& note) { return note.code == "assessment.note.out_of_plane"; });
    if (!parts.not_looked_at.empty()) out_.notes.push_back(parts.not_looked_at);
    if (out_.least_part() != nullptr)
      out_.notes.push_back({!parts.are_any_found()  ? "verdict.note.parts_named"
                            : parts.are_any_named() ? "verdict.note.parts_named_and_found"
                                                    : "verdict.note.parts_found"});
    std::vector<Message> held = names_of(parts, [](const LocalCheck& part) {
      return std::any_of(part.notes.begin(), part.notes.end(),
                         [](const Message& note) { return note.code == "local.note.head_held"; });
    });
    if (!held.empty())
      out_.notes.push_back({"verdict.note.parts_held", {{"parts", std::move(held)}}});
    if (std::vector<Message> names = names_without_answer(parts); !names.empty())
      out_.notes.push_back({"verdict.note.parts_unchecked", {{"parts", std::move(names)}}});
  }

  int asked_;
  WallsVerdict out_;
};

}  // namespace

AssessmentVerdict JudgedWall::verdict(LimitState state) const {
  const LimitStateCheck* check = is_lost() ? nullptr : assessment.at(state);
  return check == nullptr ? AssessmentVerdict::kNotKnown : check->verdict;
}

Reading JudgedWall::capacity(LimitState state) const {
  const LimitStateCheck* check = is_lost() ? nullptr : assessment.at(state);
  return check == nullptr ? Reading{} : Reading{check->acceleration, check->at_least};
}

Estimate WallCounts::probability() const {
  const Estimate known = study::exact_share(not_met, met + not_met);
  const int unknown = not_shown + lost;
  if (unknown == 0) return known;
  return {known.value,
          {study::exact_share(not_met, walls).interval.low,
           study::exact_share(not_met + unknown, walls).interval.high}};
}

Interval WallCounts::with_tests() const {
  return {study::exact_share(fails_anyhow, walls).interval.low,
          study::exact_share(walls - met_anyhow, walls).interval.high};
}

std::string PushLabel::text() const { return is_several ? direction + ", " + pattern : direction; }

Message PushLabel::words() const {
  if (!is_several) return as_text(direction);
  return {"verdict.decides", {{"direction", direction}, {"pattern", words_of_pattern(pattern)}}};
}

PushLabel WallsVerdict::decides() const {
  const bool is_several = std::any_of(ways.begin(), ways.end(), [&](const WayOfPushing& way) {
    return way.pattern != worst.pattern;
  });
  return {worst.direction, worst.pattern, is_several};
}

Message words_of_part(const LocalCheck& part) { return words_of(part.name, part.is_found()); }

bool PartsOutOfPlane::are_any_named() const {
  return std::any_of(checked.begin(), checked.end(),
                     [](const LocalCheck& part) { return !part.is_found(); }) ||
         std::any_of(refused.begin(), refused.end(),
                     [](const Refusal& part) { return !is_found(part); });
}

bool PartsOutOfPlane::are_any_found() const {
  return std::any_of(checked.begin(), checked.end(),
                     [](const LocalCheck& part) { return part.is_found(); }) ||
         std::any_of(refused.begin(), refused.end(),
                     [](const Refusal& part) { return is_found(part); });
}

const LocalCheck* WallsVerdict::least_part() const {
  // a named part that falls decides more than one that falls if nothing holds it
  const auto rank = [](const LocalCheck& part) {
    return fails(part) ? (part.is_found() ? 1 : 0) : 2;
  };
  const LocalCheck* least = nullptr;
  for (const LocalCheck& part : parts.checked) {
    if (!is_counted(part)) continue;
    if (least == nullptr || rank(part) < rank(*least) ||
        (rank(part) == rank(*least) && part.reserve() < least->reserve()))
      least = &part;
  }
  return least;
}

bool WallsVerdict::part_decides() const { return severity(verdict) > severity(of_pushes); }

LimitState WallsVerdict::state() const {
  const LocalCheck* least = least_part();
  const LocalStateCheck* of = least != nullptr && part_decides() ? least->deciding() : nullptr;
  return of != nullptr && least->verdict == AssessmentVerdict::kFails ? of->state : worst.state;
}

int most_walls(double width) {
  int n = 2;
  while (!(study::exact_share(n / 2, n).interval.width() < width)) ++n;
  return n;
}

int walls_to_decide(const WallCounts& counts) {
  const auto of = [&](int part, int n) { return static_cast<double>(part) * n / counts.walls; };
  for (int n = counts.walls; n > 0 && n <= kMostToDecide; ++n) {
    // rounded towards one half
    const int least = static_cast<int>(std::floor(of(counts.not_met, n)));
    const int most = static_cast<int>(std::ceil(of(counts.walls - counts.met, n)));
    // an interval contains its share, so only a share beyond one half can decide; the search is slow
    if ((least > kHalf * n && study::exact_share(least, n).interval.low > kHalf) ||
        (most < kHalf * n && study::exact_share(most, n).interval.high < kHalf))
      return n;
  }
  return 0;
}

int next_walls(const WallCounts& counts, double width) {
  const int known = counts.met + counts.not_met, most = most_walls(width);
  if (known == 0 || counts.walls >= most) return 0;
  const Estimate share = study::exact_share(counts.not_met, known);
  if (share.interval.width() < width) return 0;
  // the number that is enough if the share stays
  int n = known + 1;
  const auto width_at = [&](int walls) {
    const int k = static_cast<int>(std::lround(share.value * walls));
    return study::exact_share(k, walls).interval.width();
  };
  while (n < most && !(width_at(n) < width)) ++n;
  // a store grows by at least two samples
  return std::max(counts.walls + 2, std::min(most, counts.walls + n - known));
}

std::vector<JudgedWall> judge_walls(const Campaign& campaign, const ModelSpec& base,
                                    const Model& model) {
  std::vector<JudgedWall> out;
  for (const SampleRecord& record : campaign.records) {
    if (record.status.empty()) continue;
    JudgedWall& wall = out.emplace_back();
    wall.wall = record.sample;
    wall.seed = field_seed_of(campaign.study, record.sample - 1);
    wall.mode = record.failure_mode.name;
    wall.state_hash = record.state_hash;
    wall.peak = record.responses.peak_reaction;
    wall.is_in_plane = is_in_plane(model, wall.mode);
    wall.assessment = assess_sample(record, base, model);
    study::leave_to_the_scatter(model, wall.assessment.cautions);
    if (!is_answered(record))
      wall.lost = record.reason;  // a refused wall has no push to report on
    else if (wall.assessment.limit_states.empty())
      wall.lost = wall.assessment.reason;
    else
      continue;
    if (wall.lost.empty()) wall.lost = as_text(record.status);
  }
  return out;
}

WallsVerdict verdict_of(const AssessmentSpec& spec, std::vector<WayOfPushing> ways, int asked,
                        std::vector<Message> cautions, std::vector<Message> notes,
                        PartsOutOfPlane parts) {
  return Verdict(spec, std::move(ways), asked, std::move(cautions), std::move(notes),
                 std::move(parts))
      .all();
}

}  // namespace wythe
