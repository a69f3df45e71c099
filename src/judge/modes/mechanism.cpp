// Weights each storey's piers by width and the spandrels by length, and scores the shares that are sheared or rock. The
// scores follow (5.6) of docs/theory/failure_modes.md. The highest score gives the mechanism if it leads by kClear. If
// not, the mechanism is "unclear" and its sentence gives the two highest. A sheared pier does not count as rocking.
#include "judge/modes/mechanism.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace wythe::study {
namespace {

constexpr double kHalfMoves = 0.5;
constexpr double kMostMoves = 2.0 / 3;  // of the failed width: then the name is "the piers"

// The damage of the failed piers, and the sentence for it.
struct How {
  const char *name, *code;
};
constexpr How kShear{"piers in shear", "mechanism.shear"};
constexpr How kBoth{"piers in shear and rocking", "mechanism.shear_and_rocking"};
constexpr How kRock{"rocking piers", "mechanism.rocking"};
constexpr const char* kWeak = "weak spandrels";
constexpr const char* kNone = "none";
constexpr const char* kPartial = "partial";

struct Storey {
  double width = 0, sheared = 0, rocks = 0, failed = 0;  // of its piers [m]
  [[nodiscard]] double share() const { return width > 0 ? failed / width : 0.0; }
};

class Reader {
 public:
  explicit Reader(const WallSigns& wall)
      : wall_(wall), storeys_(static_cast<std::size_t>(wall.parts.storeys)) {
    for (const Pier& p : wall.parts.piers) {
      Storey& storey = storeys_[p.storey - 1];
      const double width = p.box.width(), sheared = truth_of(p, true), rocks = sure(p, kRocking);
      storey.width += width;
      storey.sheared += width * sheared;
      storey.rocks += width * rocks * (1 - sheared);  // a sheared pier does not count as rocking
      storey.failed += width * std::max(sheared, rocks);
    }
    for (std::size_t k = 0; k < storeys_.size(); ++k)
      if (ramp(storeys_[k].share(), kHalfMoves, wall.rules) > kHalfMoves)
        failed_.push_back(static_cast<int>(k) + 1);
  }

  [[nodiscard]] std::map<std::string, double> scores() const {
    const double rest = 1 - wall_.slips.truth, weak = weakness();
    double moves = 0;
    for (const Storey& s : storeys_)
      moves = std::max(moves, ramp(s.share(), kHalfMoves, wall_.rules));
    double sheared = 0, rocks = 0;
    for (const Storey& s : storeys_)
      if (moves > 0 && ramp(s.share(), kHalfMoves, wall_.rules) >= std::min(moves, kHalfMoves))
        sheared += s.sheared, rocks += s.rocks;
    const double share = sheared + rocks > 0 ? sheared / (sheared + rocks) : 0.0;
    const double shear = ramp(share, kMostMoves, wall_.rules),
                 rock = ramp(1 - share, kMostMoves, wall_.rules);
    std::map<std::string, double> scores;
    const auto add = [&](const How& how, double sure) {
      scores[how.name] += rest * (1 - weak) * moves * sure;
      scores[std::string(kWeak) + ", " + how.name] += rest * weak * moves * sure;
    };
    add(kShear, shear);
    add(kBoth, std::max(0.0, 1 - shear - rock));
    add(kRock, rock);
    scores[kWeak] += rest * weak * (1 - moves);
    const double none = rest * (1 - weak) * (1 - moves), some = surest_part();
    scores[kPartial] += none * some;
    scores[kNone] += none * (1 - some);
    add_slips(scores);
    std::erase_if(scores, [](const auto& s) { return s.second <= 0; });
    return scores;
  }
  void add_slips(std::map<std::string, double>& scores) const {
    const Slips& s = wall_.slips;
    if (!(s.all() > 0)) return;
    scores["base sliding"] += s.truth * s.base / s.all();
    scores["bed sliding"] += s.truth * s.bed / s.all();
    scores["top sliding"] += s.truth * s.top / s.all();
  }

  // The truth that a pier or spandrel has failed at all, or that a piece of the wall came off.
  [[nodiscard]] double surest_part() const {
    double most = truth(wall_.elements, wall_.truths, kWholeWall, kBreaking);
    for (const Pier& p : wall_.parts.piers)
      most = std::max({most, truth_of(p, true), sure(p, kRocking)});
    for (const Spandrel& s : wall_.parts.spandrels)
      if (!s.is_sill) most = std::max(most, truth_of(s, false));
    return most;
  }
  // Storeys are given for walls that have several and fail by their piers.
  [[nodiscard]] std::vector<int> storeys_in(const std::string& name) const {
    return of_piers(name) != nullptr && storeys_.size() > 1 ? failed_ : std::vector<int>{};
  }

  [[nodiscard]] Message sentence_of(const std::string& name) const {
    if (name == "base sliding") return {"mode.base_sliding"};
    if (name == "bed sliding") return {"mode.bed_sliding"};
    if (name == "top sliding") return {"mode.top_sliding"};
    if (name == "one pier in shear") return {"mechanism.one_pier"};
    if (name == kWeak) return {"mechanism.spandrels"};
    if (name == kPartial) return partial();
    const How* how = of_piers(name);
    if (how == nullptr)
      return is_damaged() ? Message{"mechanism.cracks"} : Message{"mechanism.none"};
    if (wall_.parts.openings == 0)
      return how->code == kRock.code ? Message{"mechanism.wall_rocks"}
                                     : Message{"mechanism.wall_shears"};
    Message words = where(*how);
    if (name.starts_with(kWeak)) words = {"mechanism.spandrels_and", {{"how", words}}};
    return words;
  }

 private:
  [[nodiscard]] double sure(const Part& part, const char* state) const {
    return truth(wall_.elements, wall_.truths, part.name, state);
  }
  [[nodiscard]] double truth_of(const Part& part, bool with_base) const {
    const double above = std::max(sure(part, kDiagonal), sure(part, kSliding));
    return with_base ? std::max(above, sure(part, kBaseSliding)) : above;
  }

  // The truth that more than half of the spandrels' length is sheared.
  [[nodiscard]] double weakness() const {
    double length = 0, sheared = 0;
    for (const Spandrel& s : wall_.parts.spandrels) {
      if (s.is_sill) continue;
      length += s.box.width();
      sheared += s.box.width() * truth_of(s, false);
    }
    return length > 0 ? ramp(sheared / length, kHalfMoves, wall_.rules) : 0.0;
  }

  [[nodiscard]] Message partial() const {
    std::vector<Message> failed = parts_with([&](const Part& part, bool is_pier) {
      return std::max(truth_of(part, is_pier), is_pier ? sure(part, kRocking) : 0.0);
    });
    if (!failed.empty()) return {"mechanism.partial", {{"parts", std::move(failed)}}};
    return broken_off(wall_.motion, wall_.rules).empty() ? Message{"mechanism.cracks"}
                                                         : broken_pieces();
  }
  // The pieces that broke off: mass, distance, and the piers, spandrels and nodes in them.
  [[nodiscard]] Message broken_pieces() const {
    const std::vector<BlockMotion>& blocks = wall_.motion.blocks;
    std::set<std::size_t> off;
    double share = 0, way = 0;
    for (const PieceOff& piece : broken_off(wall_.motion, wall_.rules)) {
      off.insert(piece.blocks.begin(), piece.blocks.end());
      share += piece.share;
      way = std::max(way, piece.way);
    }
    const auto share_off = [&](const Part& part) {
      double all = 0, gone = 0;
      for (std::size_t b = 0; b < blocks.size(); ++b) {
        if (!part.box.holds(blocks[b].at.x, blocks[b].at.y)) continue;
        all += blocks[b].mass;
        if (off.contains(b)) gone += blocks[b].mass;
      }
      return all > 0 ? gone / all : 0.0;
    };
    std::vector<Message> with = parts_with([&](const Part& part, bool) { return share_off(part); });
    Message words{with.empty() ? "mechanism.breaks_away" : "mechanism.breaks_away_with",
                  {{"percent", 100 * share}, {"mm", 1e3 * way}}};
    if (!with.empty()) words.arguments.emplace_back("parts", std::move(with));
    return words;
  }
  // Names of the piers and spandrels with a measure above a half, the first few.
  template <class Measure>
  [[nodiscard]] std::vector<Message> parts_with(const Measure& measure) const {
    constexpr std::size_t kListed = 4;
    std::vector<Message> names;
    std::size_t more = 0;
    const auto add = [&](const Part& part, bool is_pier) {
      if (measure(part, is_pier) <= kHalfMoves) return;
      if (names.size() < kListed)
        names.push_back(wall_.parts.words.at(part.name));
      else
        ++more;
    };
    for (const Pier& p : wall_.parts.piers) add(p, true);
    for (const Spandrel& s : wall_.parts.spandrels)
      if (!s.is_sill) add(s, false);
    if (more > 0) names.push_back({"mechanism.more_parts", {{"number", more}}});
    return names;
  }

  [[nodiscard]] bool is_damaged() const {
    return std::any_of(wall_.elements.begin(), wall_.elements.end(), [](const ElementState& e) {
      return std::any_of(e.signs.begin(), e.signs.end(),
                         [](const ElementSign& s) { return s.holds(); });
    });
  }

  // The part of a name that describes the piers; nullptr: none.
  static const How* of_piers(const std::string& name) {
    for (const How* how : {&kBoth, &kShear, &kRock})  // the longer name first
      if (name.ends_with(how->name)) return how;
    return nullptr;
  }

  // "soft storey 1: the piers rock", "the piers rock in storeys 1, 2", "the piers rock".
  [[nodiscard]] Message where(const How& how) const {
    const Message words{how.code};
    if (storeys_.size() == 1 || failed_.empty()) return words;
    if (failed_.size() == 1 && takes_the_way(failed_.front()))
      return {"mechanism.soft_storey", {{"storey", failed_.front()}, {"how", words}}};
    std::vector<Message> storeys;
    for (const int storey : failed_) storeys.push_back(as_text(std::to_string(storey)));
    return {"mechanism.in_storeys", {{"how", words}, {"storeys", std::move(storeys)}}};
  }

  // Whether most of the top displacement arises between foot and head of one storey.
  [[nodiscard]] bool takes_the_way(int storey) const {
    const WallParts& parts = wall_.parts;
    double foot = parts.wall.y1, head = parts.wall.y0;
    for (const Pier& p : parts.piers) {
      if (p.storey != storey) continue;
      foot = std::min(foot, p.box.y0), head = std::max(head, p.box.y1);
    }
    const auto moved_at = [&](double y) {
      const double reach = parts.course;
      const RigidMotion m = fitted(wall_.motion.blocks, [&](const BlockMotion& b) {
        return b.role == BlockRole::kMasonry && std::fabs(b.at.y - y) < reach;
      });
      return m.moved.x;
    };
    const double below = foot - parts.wall.y0 < parts.course ? 0.0 : moved_at(foot - parts.course);
    const double top = moved_at(parts.wall.y1 - parts.course);
    const double way = moved_at(head + parts.course) - below;
    return top * way > 0 && ramp(way / top, kHalfMoves, wall_.rules) == 1;
  }

  const WallSigns& wall_;
  std::vector<Storey> storeys_;
  std::vector<int> failed_;  // storeys, from 1
};

WallMechanism highest_of(const std::map<std::string, double>& scores, const Reader& reader) {
  std::vector<std::pair<double, std::string>> ranked;
  for (const auto& [name, score] : scores) ranked.emplace_back(-score, name);
  std::sort(ranked.begin(), ranked.end());
  WallMechanism found;
  found.scores = scores;
  if (ranked.empty()) return found;
  const std::string& first = ranked[0].second;
  const bool is_clear = ranked.size() == 1 || ranked[1].first - ranked[0].first >= kClear;
  if (is_clear) {
    found.name = first;
    found.storeys = reader.storeys_in(first);
    found.sentence = reader.sentence_of(first);
    return found;
  }
  found.name = "unclear";
  found.candidates = {first, ranked[1].second};
  found.sentence = {
      "mechanism.between",
      {{"first", reader.sentence_of(first)}, {"second", reader.sentence_of(ranked[1].second)}}};
  return found;
}

}  // namespace

WallMechanism mechanism_of(const WallSigns& wall) {
  const Reader reader(wall);
  return highest_of(reader.scores(), reader);
}

WallMechanism mechanism_of_portal(const FailureMode& mode, const WallSigns& wall) {
  const Reader reader(wall);
  std::map<std::string, double> scores;
  double most = 0;
  for (const auto& [name, score] : mode.scores) {
    most = std::max(most, score);
    if (name == "FM-1") scores["one pier in shear"] += score;
    if (name == "FM-2") scores[kShear.name] += score;
    if (name == "FM-3") scores[std::string(kWeak) + ", " + kShear.name] += score;
    if (name == "FM-4") scores[std::string(kWeak) + ", " + kRock.name] += score;
    if (name == "FM-5") scores[kRock.name] += score;
  }
  reader.add_slips(scores);
  if (most < kClear) {  // no mode of two piers shows, but one of its parts may have failed
    const double some = reader.surest_part();
    scores = {{kPartial, (1 - most) * some}, {kNone, (1 - most) * (1 - some)}};
  }
  std::erase_if(scores, [](const auto& s) { return s.second <= 0; });
  return highest_of(scores, reader);
}

}  // namespace wythe::study
