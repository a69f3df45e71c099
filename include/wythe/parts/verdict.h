// The verdict on a wall, from many walls of one model, each pushed in several ways: both directions, and the
// patterns of forces that a code asks for.
//
//   model.toml ──assess_study()──► a study: one way of pushing each [[variant]] ──► a campaign each
//   campaign ──judge_walls()──► WayOfPushing ─┐
//   campaign ──judge_walls()──► WayOfPushing ─┴─verdict_of()──► WallsVerdict ──► assessment.json, page
//
// All ways push the same walls: wall 3 is the same heap of units in each of them. Rules and reasons:
// docs/theory/assessment.md, "The verdict from many walls". SI units; NaN: not known.
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

// What `wythe assess` is asked for; assess_study() (io.h) makes a study of it.
struct AskedWalls {
  std::string model_file;
  std::vector<std::string> overrides = {};  // --set
  int walls = 8;                            // in each way of pushing
  int seed = 0;
  // Coefficient of variation of the mean strength from wall to wall, lognormal: one factor for all strengths and
  // energies of joints and units. NaN: the means of the file hold in every wall [-].
  double between = kUnset;
};
// The name of that factor among the study's variables.
inline constexpr const char* kBetweenWalls = "strength_of_wall";

// One wall pushed one way.
struct JudgedWall {
  int wall = 0;                  // 1-based; the same wall in every way
  int seed = 0;                  // of what scatters within it
  Message lost;                  // why it has no answer; empty: it has
  CodeAssessment assessment;     // as a single run of it would have
  std::string mode, state_hash;  // name of its failure
  double peak = kUnset;          // of its force [N]
  bool is_in_plane = true;  // false: in space, and its failure is not named as one in its plane
  [[nodiscard]] bool is_lost() const { return !lost.empty(); }
  [[nodiscard]] AssessmentVerdict verdict(LimitState state) const;
  // PGA of a limit state, a lower bound where the push ended before the wall; NaN of a lost wall.
  [[nodiscard]] Reading capacity(LimitState state) const;
};

// How many walls meet a limit state.
struct WallCounts {
  int walls = 0, met = 0, not_met = 0, not_shown = 0, lost = 0;
  // Of them those that meet it, and do not, at whichever drift of tested walls their force falls.
  int met_anyhow = 0, fails_anyhow = 0;
  // Share of walls that do not meet it, of those that are known. The interval is that of Clopper and Pearson;
  // those not known stand on its two sides: all met at its lower end, none at its upper end.
  [[nodiscard]] Estimate probability() const;
  // The same, with those on its two sides whose answer hangs on the drift.
  [[nodiscard]] Interval with_tests() const;
};
// PGA of walls [m/s^2]: a median and its interval by order statistics. The median is of the walls that answered;
// in the interval a lost wall may stand anywhere.
struct WallCapacity {
  Estimate median;
  bool at_least = false;  // too many walls went beyond their push: the median is a lower bound
  // That interval, from the least drift of tested walls to the largest; the same where tests say nothing.
  Interval with_tests;
};

// A rule that may end a limit state, in the worse direction of each wall.
struct RuleOfWalls {
  Message words;
  int walls = 0, decides = 0;  // that have the rule; that it ends
  double displacement =
      kUnset;  // median of the control point; where a push ended before, its end [m]
};

// A way of pushing among others.
struct PushLabel {
  std::string direction;    // "+x", "[1, 0, -1]"
  std::string pattern;      // word of Pattern, or "at": at the place that the file names
  bool is_several = false;  // the others have other patterns

  [[nodiscard]] std::string text()
      const;                            // "-x", or "-x, uniform" where there are several patterns
  [[nodiscard]] Message words() const;  // "-x", or "-x with forces by mass"
};

// A limit state, by the pattern that is worst for it, each wall by its worse direction.
struct StateVerdict {
  LimitState state = LimitState::kLifeSafety;
  bool is_checked = false;  // it has a spectrum of its own
  AssessmentVerdict verdict = AssessmentVerdict::kNotKnown;
  double demand = kUnset;          // PGA of its spectrum [m/s^2]
  std::string pattern, direction;  // of most walls, the direction
  std::vector<std::size_t> worst;  // the way that is worst for each wall
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

// Parts of the wall that may fall on their face (local_check.h), of the base model: its means, no scatter.
struct PartsOutOfPlane {
  bool are_named = false;  // by the model file; else found by rules, with nothing that holds them
  std::vector<LocalCheck> checked;  // each with its verdict, or without an answer
  std::vector<Refusal> refused;     // that could not be checked, and why
  Message not_looked_at = {};       // why there are none; empty: there are, or nobody asked
  // Its name for a reader: the file's own, or a word of the program for what rules found.
  [[nodiscard]] Message words_of(const std::string& name) const;
};

struct WallsVerdict {
  // The worse of `of_pushes` and what parts out of plane are worth.
  AssessmentVerdict verdict = AssessmentVerdict::kNotKnown;
  AssessmentVerdict of_pushes = AssessmentVerdict::kNotKnown;  // in the walls' plane
  bool may_be_signed = false;
  std::vector<Message> cautions;  // why not; said before the verdict
  Message reason;                 // why there is no verdict; empty: there is
  Message sentence;               // cautions and verdict, for a reader
  std::vector<Message> notes;
  std::string program;  // that ran the walls
  AssessmentSpec spec;
  std::vector<WayOfPushing> ways;
  std::vector<StateVerdict> limit_states;
  StateVerdict worst;        // of those checked, the one that decides
  ElasticSpectrum spectrum;  // its own
  std::string mode;          // the name most often given there
  int mode_count = 0;
  PartsOutOfPlane parts;
  // Of the parts that say something: one that fails, else the one with the least reserve; null: none does.
  [[nodiscard]] const LocalCheck* least_part() const;
  // Whether parts, and not the pushes, make the verdict what it is.
  [[nodiscard]] bool part_decides() const;
  // The limit state that decides, of pushes or of a part.
  [[nodiscard]] LimitState state() const;
  // The way that decides.
  [[nodiscard]] PushLabel decides() const;
};

// Every wall of a campaign, as a run of it would be judged; `model` is that of `base`, the study's base model.
[[nodiscard]] std::vector<JudgedWall> judge_walls(const Campaign& campaign, const ModelSpec& base,
                                                  const Model& model);
// `asked` walls were to be pushed in each way. `cautions` and `notes` are those of the model: patterns that it
// does not allow, what does not scatter.
[[nodiscard]] WallsVerdict verdict_of(const AssessmentSpec& spec, std::vector<WayOfPushing> ways,
                                      int asked, std::vector<Message> cautions = {},
                                      std::vector<Message> notes = {}, PartsOutOfPlane parts = {});

// --- how many walls (docs/theory/assessment.md, "How many walls")

// Walls after which the interval of any share is narrower than `width`.
[[nodiscard]] int most_walls(double width);
// Walls that would tell on which side half of all lie if the shares of those that meet it and do not stayed: as many as
// there are where they tell; 0: more than kMostToDecide, or those not known hide it however many there are.
inline constexpr int kMostToDecide = 1000;
[[nodiscard]] int walls_to_decide(const WallCounts& counts);
// How many walls to go on with, where the interval of this share is wider than `width`; 0: it is not, or no number
// below most_walls() makes it so.
[[nodiscard]] int next_walls(const WallCounts& counts, double width);

}  // namespace wythe
