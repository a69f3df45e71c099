// The verdict from many walls: each wall judged as a run of it, the worse direction of each wall, the pattern
// that decides, and how sure the share of walls is (docs/theory/assessment.md, "The verdict from many walls").
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

#include "judge/assessment/assessment_parts.h"
#include "judge/modes/mode_names.h"
#include "statistics/intervals.h"
#include "wythe/verdict.h"

namespace wythe {
namespace {

constexpr double kHalf =
    0.5;  // of the walls: codes judge one wall of mean strengths, the one in the middle

bool is_in_plane(const Model& model, const std::string& mode) {
  return !model.in_space() || mode.starts_with("in-plane");
}

// What is known of a wall's capacity: it lies from low to high, and `seen` is what its pushes showed of it.
struct Range {
  Reading seen;
  double low = 0, high = std::numeric_limits<double>::infinity();
};

Range range_of(const Reading& seen) {
  Range out{.seen = seen};
  if (!seen.is_known()) return out;
  out.low = seen.value;
  if (!seen.censored) out.high = seen.value;
  return out;
}

Range lesser(const Range& a, const Range& b) {
  const bool is_first = !b.seen.is_known() ||
                        (a.seen.is_known() && (a.seen.value < b.seen.value ||
                                               (a.seen.value == b.seen.value && !a.seen.censored)));
  return {is_first ? a.seen : b.seen, std::fmin(a.low, b.low), std::fmin(a.high, b.high)};
}

WallCapacity capacity_of(const std::vector<Range>& ranges) {
  std::vector<Reading> seen, low, high;
  for (const Range& r : ranges) {
    seen.push_back(r.seen);
    low.push_back({r.low, false});
    high.push_back({std::isinf(r.high) ? r.low : r.high, std::isinf(r.high)});
  }
  const OfWalls known = of_walls(seen);
  WallCapacity out;
  out.at_least = std::isinf(known.median.value);
  out.median.value = out.at_least ? known.at_least : known.median.value;
  out.median.interval = {of_walls(low).median.interval.low, of_walls(high).median.interval.high};
  return out;
}

// What one wall is under one pattern: by its worst way. One that is lost in a way counts as lost, for that way
// may be the worst, unless another way shows already that the limit state is not met.
struct WorstWay {
  std::size_t way = 0;
  AssessmentVerdict verdict = AssessmentVerdict::kNotKnown;
};

int severity(AssessmentVerdict verdict) {
  switch (verdict) {
    case AssessmentVerdict::kFails: return 3;
    case AssessmentVerdict::kNotKnown: return 2;
    case AssessmentVerdict::kNotShown: return 1;
    default: return 0;
  }
}

void count(AssessmentVerdict verdict, WallCounts& counts) {
  ++counts.walls;
  switch (verdict) {
    case AssessmentVerdict::kHolds: ++counts.met; break;
    case AssessmentVerdict::kFails: ++counts.not_met; break;
    case AssessmentVerdict::kNotShown: ++counts.not_shown; break;
    default: ++counts.lost; break;
  }
}

// One pattern, all its directions.
struct PatternVerdict {
  std::string pattern;
  std::vector<std::size_t> ways;
  std::vector<WorstWay> walls;
  WallCounts counts;
  WallCapacity capacity;
  AssessmentVerdict verdict = AssessmentVerdict::kNotKnown;
};

AssessmentVerdict verdict_by(const WallCounts& counts) {
  if (counts.met + counts.not_met + counts.not_shown == 0) return AssessmentVerdict::kNotKnown;
  const Interval interval = counts.probability().interval;
  if (interval.low > kHalf) return AssessmentVerdict::kFails;
  return interval.high < kHalf ? AssessmentVerdict::kHolds : AssessmentVerdict::kNotShown;
}

PatternVerdict judge_pattern(const std::string& pattern, const std::vector<WayOfPushing>& ways) {
  PatternVerdict out;
  out.pattern = pattern;
  for (std::size_t k = 0; k < ways.size(); ++k)
    if (ways[k].pattern == pattern) out.ways.push_back(k);
  const std::size_t n = ways[out.ways.front()].walls.size();
  std::vector<Range> capacities;
  for (std::size_t w = 0; w < n; ++w) {
    WorstWay worst{.way = out.ways.front()};
    Range capacity;
    for (const std::size_t k : out.ways) {
      const JudgedWall &now = ways[k].walls[w], &before = ways[worst.way].walls[w];
      const int is = severity(now.verdict()), was = severity(before.verdict());
      if (is > was || (is == was && now.capacity().value < before.capacity().value)) worst.way = k;
      const Range of_way = range_of(now.capacity());
      capacity = k == out.ways.front() ? of_way : lesser(capacity, of_way);
    }
    worst.verdict = ways[worst.way].walls[w].verdict();
    count(worst.verdict, out.counts);
    out.walls.push_back(worst);
    capacities.push_back(capacity);
  }
  out.capacity = capacity_of(capacities);
  out.verdict = verdict_by(out.counts);
  return out;
}

// The worse verdict; then fewer walls that meet it; then less capacity. What is not known goes last.
bool is_worse(const PatternVerdict& a, const PatternVerdict& b) {
  if (a.verdict != b.verdict) return severity(a.verdict) > severity(b.verdict);
  const double pa = a.counts.probability().value, pb = b.counts.probability().value;
  if (pa > pb || pb > pa) return pa > pb;
  return a.capacity.median.value < b.capacity.median.value;
}

class Verdict {
 public:
  Verdict(const AssessmentSpec& spec, std::vector<WayOfPushing> ways, int asked,
          std::vector<Message> cautions, std::vector<Message> notes)
      : asked_(asked) {
    out_.spec = spec;
    out_.spectrum = spectrum_of(spec.spectrum);
    out_.ways = std::move(ways);
    out_.cautions = std::move(cautions);
    out_.notes = std::move(notes);
  }

  WallsVerdict all() {
    for (WayOfPushing& way : out_.ways) sum_up(way);
    out_.reason = refusal();
    if (out_.reason.empty()) judge();
    conclude();
    return std::move(out_);
  }

 private:
  static void sum_up(WayOfPushing& way) {
    std::vector<Range> capacities;
    for (const JudgedWall& wall : way.walls) {
      count(wall.verdict(), way.counts);
      capacities.push_back(range_of(wall.capacity()));
    }
    way.capacity = capacity_of(capacities);
  }

  [[nodiscard]] Message refusal() const {
    if (out_.ways.empty()) return {"verdict.nothing_pushed"};
    if (!out_.spectrum.is_given()) return {"verdict.without_spectrum"};
    for (const WayOfPushing& way : out_.ways)
      if (static_cast<int>(way.walls.size()) != asked_)
        return {"verdict.walls_missing",
                {{"direction", way.direction},
                 {"pattern", words_of_pattern(way.pattern)},
                 {"run", way.walls.size()},
                 {"asked", asked_}}};
    for (const WayOfPushing& way : out_.ways)
      if (way.counts.lost == way.counts.walls)
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
    PatternVerdict worst = judge_pattern(patterns.front(), out_.ways);
    for (std::size_t k = 1; k < patterns.size(); ++k)
      if (PatternVerdict other = judge_pattern(patterns[k], out_.ways); is_worse(other, worst))
        worst = std::move(other);
    out_.pattern = worst.pattern;
    out_.counts = worst.counts;
    out_.capacity = worst.capacity;
    out_.verdict = worst.verdict;
    name_direction(worst);
    name_mode(worst);
    for (std::size_t s = 0; s < std::size(kLimitStateWords); ++s)
      out_.limit_states.push_back(capacity_at(static_cast<LimitState>(s), worst));
  }

  // The direction that is the worse one for most walls.
  void name_direction(const PatternVerdict& worst) {
    std::map<std::size_t, int> walls;
    for (const WorstWay& wall : worst.walls) ++walls[wall.way];
    std::size_t most = worst.ways.front();
    for (const std::size_t k : worst.ways)
      if (walls[k] > walls[most]) most = k;
    out_.direction = out_.ways[most].direction;
  }

  // The failure most often seen where each wall does worst; of equals the first by name.
  void name_mode(const PatternVerdict& worst) {
    std::map<std::string, int> modes;
    for (std::size_t w = 0; w < worst.walls.size(); ++w) {
      const JudgedWall& wall = out_.ways[worst.walls[w].way].walls[w];
      if (!wall.is_lost()) ++modes[wall.mode];
    }
    for (const auto& [mode, walls] : modes)
      if (walls > out_.mode_count) out_.mode = mode, out_.mode_count = walls;
  }

  // Of any limit state, each wall by its least acceleration over the directions.
  [[nodiscard]] WallCapacity capacity_at(LimitState state, const PatternVerdict& worst) const {
    std::vector<Range> capacities;
    for (std::size_t w = 0; w < worst.walls.size(); ++w) {
      Range least;
      for (const std::size_t k : worst.ways) {
        Reading of_way;
        for (const LimitStateCheck& check : out_.ways[k].walls[w].assessment.limit_states)
          if (check.state == state) of_way = {check.acceleration, check.at_least};
        least = k == worst.ways.front() ? range_of(of_way) : lesser(least, range_of(of_way));
      }
      capacities.push_back(least);
    }
    return capacity_of(capacities);
  }

  // --- what is said -----------------------------------------------------------------------------------

  // What stands against single pushes: each kind once, with how many pushes it concerns.
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
          // a bound that is beyond the demand is an answer; one below it is counted as not shown
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
    if (out_.counts.not_shown > 0)
      out_.cautions.push_back(
          {"verdict.caution.not_shown", {{"not_shown", out_.counts.not_shown}, {"walls", asked_}}});
    if (out_.verdict == AssessmentVerdict::kNotShown)
      out_.cautions.push_back({"verdict.caution.undecided"});
  }

  void conclude() {
    const bool is_known = out_.verdict != AssessmentVerdict::kNotKnown;
    if (is_known) {
      caution_of_pushes();
      caution_of_walls();
    }
    if (!is_known && out_.reason.empty()) out_.reason = {"verdict.no_wall_answers"};
    out_.may_be_signed = is_known && out_.cautions.empty();
    const Message said =
        is_known ? verdict_in_words() : Message{"assessment.not_known", {{"why", out_.reason}}};
    out_.sentence =
        out_.cautions.empty() || !is_known
            ? said
            : Message{"assessment.unsigned", {{"cautions", out_.cautions}, {"verdict", said}}};
    add_notes();
  }

  [[nodiscard]] Message capacity_in_words() const {
    constexpr double kToG = 1 / kStandardGravity;
    const Estimate& median = out_.capacity.median;
    const Interval& interval = median.interval;
    const char* code = "verdict.capacity";
    if (out_.capacity.at_least)
      code = "verdict.capacity_at_least";
    else if (std::isnan(interval.low))
      code = "verdict.capacity_alone";
    else if (std::isinf(interval.high))
      code = "verdict.capacity_open";
    return {code,
            {{"median_g", median.value * kToG},
             {"low_g", interval.low * kToG},
             {"high_g", interval.high * kToG}}};
  }

  [[nodiscard]] Message verdict_in_words() const {
    const Estimate share = out_.counts.probability();
    const char* code = "verdict.undecided";
    if (out_.verdict == AssessmentVerdict::kFails) code = "verdict.fails";
    if (out_.verdict == AssessmentVerdict::kHolds) code = "verdict.holds";
    return {code,
            {{"state", study::words_of_state(*value_of(kLimitStateWords, out_.spec.limit_state))},
             {"capacity", capacity_in_words()},
             {"demand_g", out_.spectrum.peak_ground_acceleration() / kStandardGravity},
             {"met", out_.counts.met},
             {"not_met", out_.counts.not_met},
             {"walls", out_.counts.met + out_.counts.not_met},
             {"from", 100 * share.interval.low},
             {"to", 100 * share.interval.high},
             {"decides", decides_in_words()},
             {"mode", study::words_of_mode(out_.mode)},
             {"modes", out_.mode_count}}};
  }
  [[nodiscard]] Message decides_in_words() const {
    if (out_.decides() == out_.direction) return as_text(out_.direction);
    return {"verdict.decides",
            {{"direction", out_.direction}, {"pattern", words_of_pattern(out_.pattern)}}};
  }

  // What was assumed of every wall, once; not what the many walls and ways answer.
  void add_notes() {
    for (const WayOfPushing& way : out_.ways)
      for (const JudgedWall& wall : way.walls)
        for (const Message& note : wall.assessment.notes)
          if (note.code != "assessment.note.one_pattern" &&
              std::find(out_.notes.begin(), out_.notes.end(), note) == out_.notes.end())
            out_.notes.push_back(note);
  }

  int asked_;
  WallsVerdict out_;
};

}  // namespace

Reading JudgedWall::capacity() const {
  const LimitStateCheck* check = is_lost() ? nullptr : assessment.asked();
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

std::string WallsVerdict::decides() const {
  const bool several = std::any_of(ways.begin(), ways.end(),
                                   [&](const WayOfPushing& way) { return way.pattern != pattern; });
  return several ? direction + ", " + pattern : direction;
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
    wall.is_in_plane = is_in_plane(model, wall.mode);
    wall.assessment = assess_sample(record, base, model);
    if (wall.assessment.limit_states.empty())
      wall.lost = wall.assessment.reason;
    else if (!is_answered(record))
      wall.lost = record.reason;
    else
      continue;
    if (wall.lost.empty()) wall.lost = as_text(record.status);
  }
  return out;
}

WallsVerdict verdict_of(const AssessmentSpec& spec, std::vector<WayOfPushing> ways, int asked,
                        std::vector<Message> cautions, std::vector<Message> notes) {
  return Verdict(spec, std::move(ways), asked, std::move(cautions), std::move(notes)).all();
}

}  // namespace wythe
