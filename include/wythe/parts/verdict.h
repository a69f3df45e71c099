// The verdict on a wall from many walls of one model. Each is pushed in several ways: in both directions, and by the
// load patterns that a code requires.
//
//   model.toml ──assess_study()──► a study: one way of pushing each [[variant]] ──► a campaign each
//   campaign ──judge_walls()──► WayOfPushing ─┐
//   campaign ──judge_walls()──► WayOfPushing ─┴─verdict_of()──► WallsVerdict ──► assessment.json, page
//
// All ways push the same walls: wall 3 has the same random values in each of them. Rules and reasons:
// docs/theory/assessment.md, "The verdict from many walls". SI units; NaN means not known.
#pragma once

#include <string>
#include <vector>

#include "wythe/parts/assessment.h"
#include "wythe/parts/campaign.h"
#include "wythe/parts/limit.h"
#include "wythe/parts/local_check.h"
#include "wythe/parts/message.h"
#include "wythe/parts/statistics.h"

namespace wythe {

// Request of `wythe assess`; assess_study() (io.h) turns it into a study.
struct AskedWalls {
  std::string model_file;
  std::vector<std::string> overrides = {};  // --set
  int walls = 8;                            // pushed in each way
  int seed = 0;
  // Coefficient of variation of the mean strength from wall to wall, lognormal [-]: one factor for all strengths and
  // energies of joints and units. NaN: the means of the file hold in every wall.
  double between = kUnset;
};
// Name of that factor among the variables of the study.
inline constexpr const char* kBetweenWalls = "strength_of_wall";

// One wall pushed in one way.
struct JudgedWall {
  int wall = 0;                  // 1-based; the same wall in every way
  int seed = 0;                  // of its random fields
  Message lost;                  // why it has no answer; empty where it has one
  CodeAssessment assessment;     // as for a single run
  std::string mode, state_hash;  // failure mode
  double peak = kUnset;          // largest force [N]
  bool is_in_plane = true;       // false: in space, without an in-plane failure mode
  [[nodiscard]] bool is_lost() const { return !lost.empty(); }
  [[nodiscard]] AssessmentVerdict verdict(LimitState state) const;
  // PGA of a limit state [m/s^2]. A lower bound where the push ended too early; NaN for a lost wall.
  [[nodiscard]] Reading capacity(LimitState state) const;
};

// Number of walls that meet a limit state.
struct WallCounts {
  int walls = 0, met = 0, not_met = 0, not_shown = 0, lost = 0;
  // Of these, walls that meet it, or do not, at every drift of tested walls at which their force may drop.
  int met_anyhow = 0, fails_anyhow = 0;
  // Share of walls that do not meet it, among the known ones. The interval is that of Clopper and Pearson, widened by
  // unknown walls: all of them meet it at the lower end, none at the upper end.
  [[nodiscard]] Estimate probability() const;
  // The same interval; walls whose answer depends on the drift count as unknown.
  [[nodiscard]] Interval with_tests() const;
};
// PGA capacity [m/s^2]: median and its interval by order statistics. The median is that of the answered walls;
// in the interval a lost wall may have any value.
struct WallCapacity {
  Estimate median;
  bool at_least = false;  // too many pushes ended early: the median is a lower bound
  // The interval from the least to the largest drift of tested walls; equal to the other one without tests.
  Interval with_tests;
};

// A rule that may end a limit state, in the weaker direction of each wall.
struct RuleOfWalls {
  Message words;
  int walls = 0, decides = 0;  // walls with this rule; walls that it ends
  double displacement =
      kUnset;  // median of the control point; a push that ended before counts with its end [m]
};

// The label of a way of pushing.
struct PushLabel {
  std::string direction;    // "+x", "[1, 0, -1]"
  std::string pattern;      // word of Pattern, or "at": at the place that the file names
  bool is_several = false;  // other ways have other patterns

  [[nodiscard]] std::string text()
      const;                            // "-x", or "-x, uniform" where there are several patterns
  [[nodiscard]] Message words() const;  // "-x", or "-x with forces by mass"
};

// Verdict for a limit state: by its worst pattern, with each wall in its weaker direction.
struct StateVerdict {
  LimitState state = LimitState::kLifeSafety;
  bool is_checked = false;  // it has a spectrum of its own
  AssessmentVerdict verdict = AssessmentVerdict::kNotKnown;
  double demand = kUnset;          // PGA of its spectrum [m/s^2]
  std::string pattern, direction;  // the direction is that of most walls
  std::vector<std::size_t> worst;  // index of the decisive way, for each wall
  WallCounts counts;
  WallCapacity capacity;
  std::vector<RuleOfWalls> rules;
};

struct WayOfPushing {
  std::string direction;  // "+x", "-x"; along [1, 0, 1]
  std::string pattern;    // word of Pattern, or "at": at the place that the file names
  std::string folder;     // of its campaign
  std::vector<JudgedWall> walls = {};
  WallCounts counts = {};
  WallCapacity capacity = {};
};

// Parts of the wall that may fall out of plane (local_check.h), of the base model: mean values, no scatter. The model file
// names some, with what holds them; rules find others, without holds.
struct PartsOutOfPlane {
  std::vector<LocalCheck> checked;  // each with its verdict, or without an answer
  std::vector<Refusal> refused;     // that could not be checked, and why
  Message not_looked_at = {};       // why there are none; empty: there are, or not requested
  [[nodiscard]] bool are_any_named() const;
  [[nodiscard]] bool are_any_found() const;
};

// The file's own name of a part, or that of a part which rules found.
[[nodiscard]] Message words_of_part(const LocalCheck& part);

struct WallsVerdict {
  // The worse of `of_pushes` and the verdict on parts out of plane.
  AssessmentVerdict verdict = AssessmentVerdict::kNotKnown;
  AssessmentVerdict of_pushes = AssessmentVerdict::kNotKnown;  // in the walls' plane
  bool may_be_signed = false;
  std::vector<Message> cautions;  // why not to rely on it; precede the verdict
  Message reason;                 // why there is no verdict; empty where there is one
  Message sentence;               // cautions and verdict, for a reader
  std::vector<Message> notes;
  std::string program;  // version that ran the walls
  AssessmentSpec spec;
  std::vector<WayOfPushing> ways;
  std::vector<StateVerdict> limit_states;
  StateVerdict worst;        // the decisive one of those checked
  ElasticSpectrum spectrum;  // its own
  std::string mode;          // the most frequent failure mode in it
  int mode_count = 0;
  PartsOutOfPlane parts;
  // The decisive part: one that fails, else the one with the least reserve. Null where no part has a result.
  [[nodiscard]] const LocalCheck* least_part() const;
  // Whether parts, not pushes, determine the verdict.
  [[nodiscard]] bool part_decides() const;
  // The decisive limit state, of pushes or of a part.
  [[nodiscard]] LimitState state() const;
  // The decisive way of pushing.
  [[nodiscard]] PushLabel decides() const;
};

// Judges every wall of a campaign as a single run; `model` is that of `base`, the base model of the study.
[[nodiscard]] std::vector<JudgedWall> judge_walls(const Campaign& campaign, const ModelSpec& base,
                                                  const Model& model);
// The verdict where `asked` walls were to be pushed in each way. `cautions` and `notes` are those of the model, such as
// patterns that it does not allow, or values that do not scatter.
[[nodiscard]] WallsVerdict verdict_of(const AssessmentSpec& spec, std::vector<WayOfPushing> ways,
                                      int asked, std::vector<Message> cautions = {},
                                      std::vector<Message> notes = {}, PartsOutOfPlane parts = {});

// --- how many walls (docs/theory/assessment.md, "How many walls")

// Number of walls that makes the interval of any share narrower than `width`.
[[nodiscard]] int most_walls(double width);
// Number of walls that would show on which side of one half the share lies, if present shares stayed. The present number
// where it shows this already; 0: more than kMostToDecide, or unknown walls hide it whatever the number.
inline constexpr int kMostToDecide = 1000;
[[nodiscard]] int walls_to_decide(const WallCounts& counts);
// Number of walls to continue with, where the interval of the share is wider than `width`; 0: it is not, or no number
// below most_walls() would narrow it.
[[nodiscard]] int next_walls(const WallCounts& counts, double width);

}  // namespace wythe
