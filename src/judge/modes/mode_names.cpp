// Two piers and one opening: with s the truth of "the spandrel is sheared", p and q of "the left,
// right pier is sheared", r of "both piers rock", c of "a connection has cracked", f of "a pier's
// foot has cracked" (each 0 to 1, see truths_of), the scores are
//
//   FM-1  F (p + q - 2 p q)               one pier            FM-3  s (1 - l) (p + q - p q)
//   FM-2  F p q                           both piers          FM-4  s f (1 - p) (1 - q)
//   FM-5  (1 - s) c r (1 - p) (1 - q)     neither
//
// with F = (1 - s) c + s l, where l is the truth that a pier sheared before the spandrel.
// Each is times (1 - S), beside shares of S for "base sliding", "top sliding", "bed sliding".
// S is the truth that joints along the whole wall slid by more than half of its displacement.
// The highest gives the name if it leads by kClear. Sheared: a diagonal crack, or sliding.
//
// An arch alone is a mechanism by four hinges, which open in turn at its intrados and extrados.
#include "judge/modes/mode_names.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/text.h"
#include "judge/modes/mechanism.h"

namespace wythe::study {
namespace {

// Codes of messages: for a name, and for the sentence about it ("" where there is none).
struct Words {
  const char *name, *code, *sentence;
};
constexpr const char* kPartOff = "part breaking away";
constexpr const char* kArchHinges = "arch hinges";
constexpr Words kWords[] = {{"FM-1", "", "mode.fm_1"},
                            {"FM-2", "", "mode.fm_2"},
                            {"FM-3", "", "mode.fm_3"},
                            {"FM-4", "", "mode.fm_4"},
                            {"FM-5", "", "mode.fm_5"},
                            {"base sliding", "damage.base_sliding", "mode.base_sliding"},
                            {"bed sliding", "damage.bed_sliding", "mode.bed_sliding"},
                            {"pier sliding", "damage.pier_sliding", "mode.pier_sliding"},
                            {"top sliding", "damage.top_sliding", "mode.top_sliding"},
                            {"pier shear", "damage.pier_shear", ""},
                            {"spandrel shear", "damage.spandrel_shear", ""},
                            {"pier rocking", "damage.pier_rocking", ""},
                            {kPartOff, "damage.breaking_away", ""},
                            {kArchHinges, "damage.arch_hinges", ""},
                            {"flexural cracks", "damage.flexural_cracks", ""},
                            {"shear", "damage.shear", ""},
                            {"sliding at the top", "damage.sliding_at_top", ""},
                            {kDiagonal, "sign.diagonal", ""},
                            {kSliding, "sign.sliding", ""},
                            {kBaseSliding, "sign.base_sliding", ""},
                            {kRocking, "sign.rocking", ""},
                            {kCrushing, "sign.crushing", ""},
                            {kFlexural, "sign.flexural", ""},
                            {kBreaking, "sign.breaking_away", ""},
                            {"unclear", "damage.unclear", ""},
                            {kWholeWall, "part.whole_wall", ""},
                            {kTopJoint, "part.top_joint", ""}};

// A name in words for a reader: a kind of damage, a sign, or a joint of the whole wall; else unchanged. "shear + rocking" by parts.
Message words_of(const std::string& name) {
  constexpr std::string_view kAnd = " + ";
  if (const std::size_t at = name.find(kAnd); at != std::string::npos)
    return {"damage.several",
            {{"kinds", std::vector<Message>{words_of(name.substr(0, at)),
                                            words_of(name.substr(at + kAnd.size()))}}}};
  for (const Words& w : kWords)
    if (name == w.name && *w.code != '\0') return {w.code};
  return as_text(name);
}

// The sentence about a mode.
Message sentence_of(const std::string& name) {
  for (const Words& w : kWords)
    if (name == w.name && *w.sentence != '\0') return {w.sentence};
  return {"mode.none"};
}

// Kinds of damage of all other walls, with and without openings, in the order of Namer::rank_plainly.
constexpr const char* kGravestFirst[] = {kArchHinges,
                                         "pier shear",
                                         "shear",
                                         "spandrel shear",
                                         "pier sliding",
                                         "sliding",
                                         "bed sliding",
                                         "base sliding",
                                         "sliding at the base",
                                         "top sliding",
                                         "sliding at the top",
                                         "pier rocking",
                                         "rocking",
                                         kPartOff,
                                         "toe crushing",
                                         "flexural cracks"};

using Kinds = std::vector<std::string>;
using RankedKinds =
    std::vector<std::pair<std::string, double>>;  // with the truth of each, gravest first

// The two most severe kinds whose truth reaches `least`. Minor damage counts only if there is no other.
Kinds composed(const RankedKinds& ranked, double least) {
  Kinds kinds;
  for (const auto& [kind, sure] : ranked) {
    const bool is_lesser = kind == kPartOff || kind == "toe crushing" || kind == "flexural cracks";
    if (sure >= least && kinds.size() < 2 && !(is_lesser && !kinds.empty())) kinds.push_back(kind);
  }
  return kinds;
}

Message words_of(const Kinds& kinds) {
  std::vector<Message> list;
  for (const std::string& kind : kinds) list.push_back(words_of(kind));
  return {"damage.several", {{"kinds", std::move(list)}}};
}

class Namer {
 public:
  Namer(const WallParts& parts, const WallMotion& motion, const ModeRules& rules,
        double spandrel_later)
      : parts_(parts),
        motion_(motion),
        rules_(rules),
        later_(spandrel_later),
        elements_(element_states(parts, motion, rules)),
        truths_(truths_of(parts, motion, rules)) {
    for (const BlockMotion& b : motion.blocks) way_ = std::max(way_, std::fabs(b.moved.x));
  }

  FailureMode name() {
    if (is_two_pier_wall(parts_))
      name_two_piers();
    else
      name_plainly();
    give_evidence();
    mode_.elements = elements_;
    return mode_;
  }

  // The mechanism of the wall just named.
  [[nodiscard]] WallMechanism mechanism() const {
    if (parts_.is_arch) return {.name = mode_.name, .sentence = mode_.sentence};
    const WallSigns signs{parts_, elements_, truths_, motion_, rules_, slips()};
    return is_two_pier_wall(parts_) ? mechanism_of_portal(mode_, signs) : mechanism_of(signs);
  }

 private:
  [[nodiscard]] double sure(const std::string& element, const char* state) const {
    return truth(elements_, truths_, element, state);
  }
  [[nodiscard]] double sheared(const std::string& element) const {
    return std::max(sure(element, kDiagonal), sure(element, kSliding));
  }
  // The largest truth of a sign among the elements of a kind.
  [[nodiscard]] double surest(const char* kind, const char* state) const {
    double most = 0;
    for (const ElementState& e : elements_)
      if (e.kind == kind) most = std::max(most, sure(e.element, state));
    return most;
  }

  // The slip along a joint through the whole wall, if it counts as sliding [m].
  [[nodiscard]] double slip(const char* element, const char* state) const {
    constexpr double kPerMillimetre = 1e-3;
    for (const ElementState& e : elements_)
      for (const ElementSign& s : e.signs)
        if (e.element == element && s.state == state)
          return sure(element, state) * kPerMillimetre * s.value;
    return 0;
  }
  // Truth that this slip is most of the wall's displacement.
  [[nodiscard]] double is_most(double slip) const {
    return way_ > 0 ? ramp(slip / way_, 0.5, rules_) : 0.0;
  }

  [[nodiscard]] Slips slips() const {
    const std::string through = parts_.openings == 0 ? parts_.piers.front().name : kWholeWall;
    Slips s{slip(through.c_str(), kBaseSliding), slip(through.c_str(), kSliding),
            slip(kTopJoint, kSliding)};
    s.truth = is_most(s.all());
    return s;
  }

  void name_two_piers() {
    const auto spandrel = std::find_if(parts_.spandrels.begin(), parts_.spandrels.end(),
                                       [](const Spandrel& s) { return !s.is_sill; });
    const std::string &left = parts_.piers[0].name, &right = parts_.piers[1].name;
    const double s = sheared(spandrel->name), p = sheared(left), q = sheared(right);
    const double r = std::min(sure(left, kRocking), sure(right, kRocking));
    const double c = surest("connection", kFlexural), f = surest("pier", kFlexural);
    const double neither = (1 - p) * (1 - q);
    // the piers come first: the spandrel is sound with cracks at its ends, or shears later
    const double first = (1 - s) * c + s * later_;
    mode_.scores = {{"FM-1", first * (p + q - 2 * p * q)},
                    {"FM-2", first * p * q},
                    {"FM-3", s * (1 - later_) * (1 - neither)},
                    {"FM-4", s * f * neither},
                    {"FM-5", (1 - s) * c * r * neither}};
    const bool by_piers = std::min(sure(left, kSliding), sure(right, kSliding)) > 0.5;
    const Slips slid = slips();
    const std::pair<const char*, double> kinds[] = {
        {"base sliding", slid.base},
        {by_piers ? "pier sliding" : "bed sliding", slid.bed},
        {"top sliding", slid.top}};
    for (auto& [name, score] : mode_.scores) score *= 1 - slid.truth;
    for (const auto& [name, slip] : kinds)
      if (slid.truth * slip > 0) mode_.scores[name] = slid.truth * slip / slid.all();
    name_highest_score();
  }

  void name_highest_score() {
    std::vector<std::pair<double, std::string>> ranked;
    for (const auto& [name, score] : mode_.scores) ranked.emplace_back(-score, name);
    std::sort(ranked.begin(), ranked.end());
    const auto& [first, first_name] = ranked[0];
    const auto& [second, second_name] = ranked[1];
    if (-first < kClear) {
      rank_plainly();
      const Kinds shown = composed(ranked_, 0.5 + 0.5 * kClear);
      if (!shown.empty())
        mode_.sentence = {"mode.parts_only",
                          {{"kinds", words_of(shown)}, {"parts", parts_that_show()}}};
      else if (-first > 0)
        mode_.sentence = about_two("mode.none_nearest", first_name, second_name);
      else
        mode_.sentence = {"mode.none_here"};
    } else if (second - first < kClear) {
      mode_.sentence = about_two("mode.between_modes", first_name, second_name);
    } else {
      give_name(first_name, words_of(first_name));
      mode_.sentence = sentence_of(first_name);
      if (slides_instead()) {
        if (first_name == "FM-1") mode_.sentence = {"mode.fm_1_slides"};
        if (first_name == "FM-2") mode_.sentence = {"mode.fm_2_slides"};
        if (first_name == "FM-3") mode_.sentence = {"mode.fm_3_slides"};
      }
      if (later_ > 0.5 && (first_name == "FM-1" || first_name == "FM-2"))
        mode_.sentence = {"mode.spandrel_later", {{"what", mode_.sentence}}};
    }
  }

  // Whether piers slide on their beds, and none cracks diagonally.
  [[nodiscard]] bool slides_instead() const {
    return surest("pier", kSliding) > 0.5 && surest("pier", kDiagonal) <= 0.5;
  }

  void give_name(const std::string& name, Message words) {
    mode_.name = name;
    mode_.words = std::move(words);
  }
  static Message about_two(const char* code, const std::string& first, const std::string& second) {
    return {code,
            {{"first", words_of(first)},
             {"first_means", sentence_of(first)},
             {"second", words_of(second)},
             {"second_means", sentence_of(second)}}};
  }

  // Number of hinges of an arch: joints along it that turn the same way, one after the other, are one hinge. Each must open
  // its face by `crack` at the edge.
  [[nodiscard]] int arch_hinges(double crack) const {
    const double middle = 0.5 * (parts_.wall.x0 + parts_.wall.x1), foot = parts_.wall.y0;
    const auto angle = [&](double x, double y) { return std::atan2(y - foot, x - middle); };
    const auto of_block = [&](BlockId block, double x) {
      constexpr double kBeyond = 4;  // the ground lies beyond both ends
      if (block == kGroundBlock) return x < middle ? kBeyond : -kBeyond;
      return angle(motion_.blocks[block].at.x, motion_.blocks[block].at.y);
    };
    std::vector<std::pair<double, double>> turns;  // angle of the joint, turn of its face
    for (const JointMotion& j : motion_.joints) {
      const double a = j.a == kGroundBlock ? 0 : motion_.blocks[j.a].turn.z;
      const double b = motion_.blocks[j.b].turn.z;
      const double way = of_block(j.a, j.x) > of_block(j.b, j.x) ? 1 : -1;
      const double opened = way * (b - a) * 2 * std::hypot(j.reach_x, j.reach_y);
      if (std::fabs(opened) >= crack) turns.emplace_back(angle(j.x, j.y), opened);
    }
    std::sort(turns.begin(), turns.end());
    int hinges = 0;
    for (std::size_t k = 0; k < turns.size(); ++k)
      if (k == 0 || (turns[k].second > 0) != (turns[k - 1].second > 0)) ++hinges;
    return hinges;
  }

  // Four hinges are a mechanism. Their truth is the mean over crack widths, as that of signs.
  void rank_arch() {
    constexpr int kOfMechanism = 4;
    constexpr double kWidths[] = {0.5, 0.7, 1, 1.4, 2};  // over the rule's
    double sure = 0, slip = 0;
    for (const double width : kWidths)
      if (arch_hinges(width * rules_.crack) >= kOfMechanism) sure += 1.0 / std::size(kWidths);
    for (const JointMotion& j : motion_.joints) slip = std::max(slip, std::fabs(j.slip));
    ranked_ = {{kArchHinges, sure}, {"sliding", ramp(slip, rules_.sliding, rules_)}};
  }

  // Ranks the kinds of damage of any other wall, the most severe first.
  void rank_plainly() {
    if (parts_.is_arch) return rank_arch();
    const bool bare = parts_.openings == 0;
    const auto add = [&](const char* of_pier, const char* alone, double sure) {
      ranked_.emplace_back(bare ? alone : of_pier, sure);
    };
    const double bed = slips().bed;
    // a wall that mostly slides as a whole has not failed by the cracks of that motion
    const double stays = 1 - slips().truth;
    add("pier shear", "shear", stays * surest("pier", kDiagonal));
    if (!bare)
      add("spandrel shear", "",
          stays * std::max(surest("spandrel", kDiagonal), surest("spandrel", kSliding)));
    add("pier sliding", "sliding", surest("pier", kSliding));
    if (!bare && is_most(bed) > 0)
      add("bed sliding", "", std::min(is_most(bed), 1 - surest("pier", kSliding)));
    add("base sliding", "sliding at the base", surest("pier", kBaseSliding));
    if (has_top_joint()) add("top sliding", "sliding at the top", surest("top joint", kSliding));
    add("pier rocking", "rocking", surest("pier", kRocking));
    if (!bare) add(kPartOff, "", surest("wall", kBreaking));
    add("toe crushing", "toe crushing", surest("toe", kCrushing));
    add("flexural cracks", "flexural cracks",
        std::max({surest("pier", kFlexural), surest("connection", kFlexural),
                  surest("top joint", kFlexural)}));
  }

  // Name of any other wall: its two most severe kinds of damage, "pier shear + pier rocking".
  void name_plainly() {
    rank_plainly();
    for (const auto& [kind, sure] : ranked_) mode_.scores[kind] = sure;
    constexpr double kHalf = 0.5;
    const Kinds strict = composed(ranked_, kHalf + 0.5 * kClear),
                lenient = composed(ranked_, kHalf - 0.5 * kClear);
    if (strict == lenient && !strict.empty()) {
      give_name(joined(strict, " + "), words_of(strict));
      mode_.sentence = {"mode.parts", {{"parts", parts_that_show()}}};
      if (strict.front() == kArchHinges)
        mode_.sentence = {"mode.arch_hinges", {{"hinges", arch_hinges(rules_.crack)}}};
      return;
    }
    const auto or_none = [](const Kinds& kinds) {
      return kinds.empty() ? Message{"damage.none"} : words_of(kinds);
    };
    if (strict == lenient && parts_.is_arch)
      mode_.sentence = {"mode.arch_stands", {{"hinges", arch_hinges(rules_.crack)}}};
    else if (strict == lenient)
      mode_.sentence = {"mode.no_part"};
    else
      mode_.sentence = {"mode.between_kinds",
                        {{"first", or_none(strict)}, {"second", or_none(lenient)}}};
  }

  [[nodiscard]] bool has_top_joint() const {
    return std::any_of(elements_.begin(), elements_.end(),
                       [](const ElementState& e) { return e.element == kTopJoint; });
  }

  // Each part with its signs: "left pier: rocking, flexural crack".
  [[nodiscard]] std::vector<Message> parts_that_show() const {
    std::vector<Message> parts;
    for (const ElementState& e : elements_) {
      std::vector<Message> signs;
      for (const ElementSign& s : e.signs)
        if (s.holds()) signs.push_back(words_of(s.state));
      if (signs.empty()) continue;
      const auto known = parts_.words.find(e.element);
      const Message part = known != parts_.words.end() ? known->second : words_of(e.element);
      parts.push_back({"part.shows", {{"part", part}, {"signs", std::move(signs)}}});
    }
    return parts;
  }

  void give_evidence() {
    for (const ElementState& e : elements_)
      for (const ElementSign& s : e.signs)
        mode_.evidence.push_back(
            {e.element, s.state + ": " + s.measure, s.value, s.threshold, s.unit});
  }

  const WallParts& parts_;
  const WallMotion& motion_;
  const ModeRules& rules_;
  double later_;  // truth that the spandrel sheared after a pier
  ElementStates elements_;
  Truths truths_;
  RankedKinds ranked_;
  double way_ = 0;  // the largest horizontal displacement of a block [m]
  FailureMode mode_;
};

}  // namespace

bool is_two_pier_wall(const WallParts& parts) {
  const auto spandrels = std::count_if(parts.spandrels.begin(), parts.spandrels.end(),
                                       [](const Spandrel& s) { return !s.is_sill; });
  return parts.piers.size() == 2 && parts.openings == 1 && spandrels == 1;
}

FailureMode name_parts(const WallParts& parts, const WallMotion& motion, const ModeRules& rules,
                       double spandrel_later) {
  if (parts.piers.empty() || !(rules.crack > 0)) {
    FailureMode none;
    none.sentence = {"mode.no_piers"};
    return none;
  }
  return Namer(parts, motion, rules, spandrel_later).name();
}

double spandrel_later(const WallParts& parts, const std::vector<ElementReading>& readings,
                      const ModeRules& rules) {
  constexpr double kFarther = 1.3;  // ratio of displacements above which the pier came first
  if (!is_two_pier_wall(parts)) return 0;
  const auto first = [&](const char* kind) {
    for (const ElementReading& r : readings)
      for (const ElementState& e : r.elements)
        for (const ElementSign& s : e.signs)
          if (e.kind == kind && (s.state == kDiagonal || s.state == kSliding) && s.holds())
            return std::fabs(r.displacement);
    return kUnset;
  };
  const double pier = first("pier"), spandrel = first("spandrel");
  return pier > 0 && spandrel > 0 ? ramp(spandrel / pier, kFarther, rules) : 0.0;
}

Named name_wall(const WallParts& parts, const WallMotion& motion, const ModeRules& rules,
                double spandrel_later) {
  if (parts.piers.empty() || !(rules.crack > 0))
    return {name_parts(parts, motion, rules), {.sentence = {"mode.no_piers"}}};
  Namer namer(parts, motion, rules, spandrel_later);
  const FailureMode mode = namer.name();
  return {mode, namer.mechanism()};
}

Message words_of_mode(const std::string& name) { return words_of(name); }

}  // namespace wythe::study

bool wythe::is_firm(const FailureMode& mode) {
  using namespace study;
  if (mode.scores.count("FM-1") > 0) {  // the highest score gives the name, except after a fall
    if (mode.name != "unclear" && mode.scores.count(mode.name) == 0) return true;
    std::vector<double> scores;
    for (const auto& [name, score] : mode.scores) scores.push_back(score);
    std::sort(scores.rbegin(), scores.rend());
    return scores[0] < 0.5 - kClear || scores[0] - scores[1] >= 2 * kClear;
  }
  RankedKinds ranked;
  for (const char* kind : kGravestFirst)
    if (const auto found = mode.scores.find(kind); found != mode.scores.end())
      ranked.emplace_back(*found);
  return composed(ranked, 0.5 + kClear) == composed(ranked, 0.5 - kClear);
}
