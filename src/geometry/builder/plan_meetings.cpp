// Finds where walls along plan lines meet, and which courses go through at each meeting.
#include <algorithm>
#include <cmath>
#include <set>

#include "core/elementary.h"
#include "core/text.h"
#include "geometry/builder/builder.h"
#include "geometry/text.h"
#include "geometry/wall/bond.h"

namespace wythe::geometry {
namespace {

constexpr double kSamePlace = 1e-4;    // distance of two points that count as one [m]
constexpr double kRightAngle = 1e-6;   // cosine of the angle between two walls at right angles
constexpr double kLeastSine = 0.7071;  // sine of the smallest angle between two walls: 45 degrees
constexpr double kNearMiss = 0.5;      // of the thinner wall's thickness: a gap that seems unmeant
constexpr double kLeastLap = 0.25;     // of a half unit: least lap of a tooth beyond the other wall

template <class E, std::size_t N>
void take_word(const std::string& stated, const Word<E> (&words)[N], const std::string& path,
               E& value, FaultList& faults) {
  if (stated.empty()) return;
  std::vector<std::string> known;
  for (const Word<E>& word : words) {
    if (word.word == stated) {
      value = word.value;
      return;
    }
    known.emplace_back(word.word);
  }
  add_fault(faults, path, "\"" + stated + "\"", "must be one of " + joined(known, ", "),
            name_advice(stated, known));
}

void take(double own, double& value) {
  if (!std::isnan(own)) value = own;
}

// The values of [wall], replaced by those that the plan_wall states.
WallSpec inherited(const Site& site, const PlanWallSpec& spec, const std::string& path,
                   FaultList& faults) {
  WallSpec wall = site.model.wall;
  wall.length = kUnset;
  wall.opening = spec.opening;
  take(spec.height, wall.height);
  take(spec.thickness, wall.thickness);
  take_word(spec.bond, kBondWords, path + ".bond", wall.bond, faults);
  take_word(spec.fit, kFitWords, path + ".fit", wall.fit, faults);
  take(spec.unit.length, wall.unit.length);
  take(spec.unit.height, wall.unit.height);
  take(spec.unit.width, wall.unit.width);
  const auto material = site.model.material.find(spec.material);
  if (material != site.model.material.end()) take(material->second.density, wall.unit.density);
  take(spec.unit.mortar.bed, wall.unit.mortar.bed);
  take(spec.unit.mortar.head, wall.unit.mortar.head);
  wall.unit.split = spec.unit.split;
  if (spec.ring_beam) {
    wall.unit.height = wall.height;
    wall.unit.mortar = {};
    wall.unit.split = Split::kNone;
    wall.bond = Bond::kStack;
    wall.fit = Fit::kCut;
  }
  return wall;
}

std::string shown(Vec2 p) { return "[" + metres(p.x) + ", " + metres(p.y) + "]"; }

bool check_sizes(const PlanWallSpec& spec, const WallSpec& wall, const std::string& path,
                 FaultList& faults) {
  const auto own = [&](const char* key, double value) {
    return std::isnan(value) ? "wall." + std::string(key) : path + "." + key;
  };
  bool good =
      is_positive({own("thickness", spec.thickness), wall.thickness, "m", "0.25 m"}, faults);
  good &= is_positive({own("height", spec.height), wall.height, "m", "2.4 m"}, faults);
  if (spec.wythes < 1 || spec.wythes > 3)
    add_fault(faults, path + ".wythes", std::to_string(spec.wythes), "must be 1, 2 or 3",
              "write wythes = 2; more are parts of one unit here");
  if (spec.through_courses > 0 && spec.wythes == 1)
    add_fault(faults, path + ".through_courses", std::to_string(spec.through_courses),
              "is for two or three wythes, and this wall has one",
              "leave it out, or write wythes = 2");
  if (!std::isnan(spec.through_spacing) && spec.through_courses < 1)
    add_fault(faults, path + ".through_spacing", metres(spec.through_spacing),
              "says how far apart through-stones are, and no course has any",
              "add through_courses = 3, or leave it out");
  if (!std::isnan(spec.core) && (spec.wythes != 3 || !(spec.core < wall.thickness)))
    add_fault(faults, path + ".core", metres(spec.core),
              "is for three wythes, and thinner than the wall",
              "write wythes = 3, and a core thinner than " + metres(wall.thickness));
  return good;
}

// Refuses what a ring beam cannot have, because it is one course of whole segments.
void check_ring_beam(const PlanWallSpec& spec, const std::string& path, FaultList& faults) {
  if (!spec.ring_beam) return;
  const auto refuse = [&](const char* key, bool stated) {
    if (stated)
      add_fault(faults, path + "." + key, "", "is of masonry, and this wall is a ring beam",
                "leave it out");
  };
  if (std::isnan(spec.height))
    add_fault(faults, path + ".height", "", "is missing: a ring beam has a height of its own",
              "write e.g. height = \"250 mm\"");
  if (spec.material.empty())
    add_fault(faults, path + ".material", "", "is missing: a ring beam is of no masonry",
              "name the [material.*] table with its density and moduli");
  refuse("opening", !spec.opening.empty());
  refuse("region", !spec.region.empty());
  refuse("gable", spec.gable > 0);
  refuse("wythes", spec.wythes > 1);
  refuse("bond", !spec.bond.empty());
  refuse("fit", !spec.fit.empty());
  refuse("unit.height", !std::isnan(spec.unit.height));
}

// Adds one straight wall for each segment of a table's line.
void add_sides(const Site& site, int index, std::vector<StraightWall>& walls, FaultList& faults) {
  const PlanWallSpec& spec = site.spec.plan_wall[index];
  const std::string path = "plan_wall." + std::to_string(index);
  check_ring_beam(spec, path, faults);
  const WallSpec wall = inherited(site, spec, path, faults);
  const bool sized = check_sizes(spec, wall, path, faults);
  if (!std::isnan(spec.unit.density))
    add_fault(faults, path + ".unit.density", "", "is a material's where walls differ in it",
              "write material = \"stone\" here, and density under [material.stone]");
  if (!std::isnan(spec.unit.real.length) || !std::isnan(spec.unit.real.height))
    add_fault(faults, path + ".unit.real", "", "is said once, of the units of all walls",
              "write it as wall.unit.real");
  const RealUnitSpec& real = site.model.wall.unit.real;
  const bool has_own = !std::isnan(spec.unit.length) || !std::isnan(spec.unit.height);
  if (has_own && (!std::isnan(real.length) || !std::isnan(real.height)))
    add_fault(faults, path + ".unit", "",
              "has sizes of its own, and wall.unit.real is of units of one size",
              "draw all walls with the sizes of [wall.unit], or leave wall.unit.real out");
  if (spec.line.size() < 2)
    return add_fault(faults, path + ".line", "", "needs two points or more",
                     "write e.g. line = [[\"0 m\", \"0 m\"], [\"4 m\", \"0 m\"]]");
  if (spec.line.size() > 2 && !spec.opening.empty())
    add_fault(faults, path + ".opening", "",
              "the line has corners, so x along it is not one wall's",
              "make a [[plan_wall]] of each straight part, and give its openings to it");
  if (spec.line.size() > 2 && !spec.region.empty())
    add_fault(faults, path + ".region", "", "the line has corners, so x along it is not one wall's",
              "make a [[plan_wall]] of each straight part, and give its regions to it");
  if (!(spec.base >= 0 && std::isfinite(spec.base)))
    return add_fault(faults, path + ".base", metres(spec.base),
                     "must be 0 or a height above the ground",
                     "leave it out for a wall on the ground");
  if (!sized) return;
  for (std::size_t k = 0; k + 1 < spec.line.size(); ++k) {
    StraightWall side;
    side.index = index;
    side.path = path;
    side.name = spec.name + (spec.line.size() > 2 ? "." + std::to_string(k + 1) : "");
    side.from = {spec.line[k][0], spec.line[k][1]};
    const Vec2 way = Vec2{spec.line[k + 1][0], spec.line[k + 1][1]} - side.from;
    side.line = elementary::hypot(way.x, way.y);
    if (!(side.line > wall.thickness)) {
      add_fault(faults, path + ".line", metres(side.line),
                "is no longer than the wall is thick (" + metres(wall.thickness) + ")",
                "write a longer line; points are corners of the middle plane");
      continue;
    }
    side.along = {way.x / side.line, way.y / side.line};
    side.across = {-side.along.y, side.along.x};
    side.base = spec.base;
    side.thickness = wall.thickness;
    side.wall = wall;
    walls.push_back(side);
  }
}

Vec2 point(const StraightWall& wall, int e) {
  const double s = e == 0 ? 0 : wall.line;
  return {wall.from.x + s * wall.along.x, wall.from.y + s * wall.along.y};
}

Vec2 back(Vec2 v) { return {-v.x, -v.y}; }

struct Foot {
  double along, off;  // coordinates of a point along the line and across it [m]
};
Foot foot_of(const StraightWall& wall, Vec2 p) {
  const Vec2 d = p - wall.from;
  return {dot(d, wall.along), dot(d, wall.across)};
}

class Meetings {
 public:
  Meetings(std::vector<StraightWall>& walls, const BuilderSpec& spec, FaultList& faults)
      : walls_(walls), spec_(spec), faults_(faults) {}

  void find() {
    for (std::size_t i = 0; i < walls_.size(); ++i)
      for (std::size_t k = 0; k < walls_.size(); ++k)
        if (i != k) meet(static_cast<int>(i), static_cast<int>(k));
    for (StraightWall& wall : walls_) {
      wall.wall.length = wall.line + wall.end[0].reach + wall.end[1].reach;
      check_tees(wall);
    }
  }

  // Notes a free end that stops short of another wall: two walls that seem to meet, and stand free of each other.
  void note_near_misses(std::vector<Message>& notes) const {
    std::set<std::pair<const StraightWall*, const StraightWall*>> told;
    for (const StraightWall& a : walls_)
      for (int e = 0; e < 2; ++e) {
        if (a.end[e].kind != EndKind::kFree) continue;
        for (const StraightWall& b : walls_) {
          if (&a == &b || !lie_beside(a, b) || are_joined(a, b)) continue;
          const double gap = gap_before(a, e, b);
          if (!(gap > kSamePlace) || told.contains({&b, &a})) continue;
          told.insert({&a, &b});
          const Vec2 p = point(a, e), meets = common_point(a, e, b);
          notes.push_back({"plan_wall.near_miss",
                           {{"wall", a.name},
                            {"other", b.name},
                            {"gap_mm", 1e3 * gap},
                            {"place", shown(p)},
                            {"meets", shown(meets)}}});
        }
      }
  }

 private:
  StraightWall& at(int i) { return walls_[i]; }

  [[nodiscard]] bool are_joined(const StraightWall& a, const StraightWall& b) const {
    const auto meets = [&](const StraightWall& from, const StraightWall& to) {
      return std::any_of(std::begin(from.end), std::end(from.end), [&](const WallEnd& end) {
        return end.kind != EndKind::kFree && &walls_[end.other] == &to;
      });
    };
    return meets(a, b) || meets(b, a);
  }

  // Distance from the end face of `a` to `b`, as far as it lies before that face, or at its corner where the walls are not
  // parallel: leaves side by side miss nothing. NaN where nothing is within half a thickness.
  [[nodiscard]] static double gap_before(const StraightWall& a, int e, const StraightWall& b) {
    const Vec2 out = e == 0 ? back(a.along) : a.along, p = point(a, e);
    const double room = kNearMiss * std::min(a.thickness, b.thickness), half = 0.5 * a.thickness;
    // `b` in the axes of the end: x away from the wall, y across it
    Polygon other;
    for (const auto& [s, side] : {std::pair(-b.end[0].reach, -0.5),
                                  {b.line + b.end[1].reach, -0.5},
                                  {b.line + b.end[1].reach, 0.5},
                                  {-b.end[0].reach, 0.5}}) {
      const double t = side * b.thickness;
      const Vec2 d{b.from.x + s * b.along.x + t * b.across.x - p.x,
                   b.from.y + s * b.along.y + t * b.across.y - p.y};
      other.push_back({dot(d, out), cross(out, d)});
    }
    double gap = kUnset;
    for (const Vec2& q : part_inside(other, {{0, -half}, {room, -half}, {room, half}, {0, half}}))
      gap = std::fmin(gap, q.x);
    if (std::fabs(cross(a.along, b.along)) < kRightAngle) return gap;
    const double wide = half + room;
    for (const Vec2& q : part_inside(other, {{0, -wide}, {room, -wide}, {room, wide}, {0, wide}}))
      gap = std::fmin(gap, elementary::hypot(q.x, std::max(0.0, std::fabs(q.y) - half)));
    return gap;
  }

  // Where both lines have to go for a meeting.
  [[nodiscard]] static Vec2 common_point(const StraightWall& a, int e, const StraightWall& b) {
    const Vec2 p = point(a, e);
    const double turn = cross(a.along, b.along);
    if (std::fabs(turn) < kLeastSine) {  // one after the other, or too near to it for a meeting
      const Vec2 first = point(b, 0), last = point(b, 1);
      return length(first - p) < length(last - p) ? first : last;
    }
    const double s = cross(b.from - a.from, b.along) / turn;
    return {a.from.x + s * a.along.x, a.from.y + s * a.along.y};
  }

  void refuse(const StraightWall& wall, Vec2 p, const std::string& problem,
              const std::string& cure) {
    add_fault(faults_, wall.path + ".line", shown(p), problem, cure);
  }

  bool is_toothed(const StraightWall& a, const StraightWall& b) const {
    const auto has_teeth = [&](const StraightWall& wall) {
      const PlanWallSpec& own = spec_.plan_wall[wall.index];
      return own.meets == Meeting::kToothed && !own.ring_beam;
    };
    return has_teeth(a) && has_teeth(b);
  }

  // Whether the heights of two walls overlap: a wall above another meets it in no course.
  [[nodiscard]] bool lie_beside(const StraightWall& a, const StraightWall& b) const {
    const auto top = [&](const StraightWall& wall) {
      return wall.base + wall.wall.height + spec_.plan_wall[wall.index].gable;
    };
    return a.base < top(b) - kSamePlace && b.base < top(a) - kSamePlace;
  }

  bool is_level(int i, int k, Vec2 p) {
    if (std::fabs(at(i).base - at(k).base) < kSamePlace) return true;
    refuse(at(k), p,
           "meets " + at(i).name + " there, and their feet are at different heights, " +
               metres(at(k).base) + " and " + metres(at(i).base),
           "give both one base, or end the line beside the other wall's face");
    return false;
  }

  // Tests both ends of wall i against wall k. The earlier wall of a corner handles it, so each corner is handled once.
  void meet(int i, int k) {
    StraightWall &a = at(i), &b = at(k);
    if (!lie_beside(a, b)) return;
    for (int e = 0; e < 2; ++e) {
      const Vec2 p = point(a, e);
      for (int f = 0; f < 2; ++f)
        if (length(p - point(b, f)) < kSamePlace) {
          if (i < k) corner(i, e, k, f);
          return;
        }
      const Foot foot = foot_of(b, p);
      if (foot.along < 0 || foot.along > b.line) continue;
      if (std::fabs(foot.off) < kSamePlace)
        tee(i, e, k, foot.along);
      else if (std::fabs(foot.off) < 0.5 * b.thickness + kSamePlace)
        refuse(a, p,
               "ends " + millimetres(std::fabs(foot.off)) + " off the middle plane of " + b.name,
               "let lines of walls that meet end on each other's line: " +
                   shown({b.from.x + foot.along * b.along.x, b.from.y + foot.along * b.along.y}));
    }
    if (i < k) refuse_crossing(a, b);
  }

  void refuse_crossing(const StraightWall& a, const StraightWall& b) {
    const double turn = cross(a.along, b.along);
    if (std::fabs(turn) < kRightAngle) return;
    const Vec2 d = b.from - a.from;
    const double s = cross(d, b.along) / turn, t = cross(d, a.along) / turn;
    if (s < kSamePlace || s > a.line - kSamePlace || t < kSamePlace || t > b.line - kSamePlace)
      return;
    refuse(b, {a.from.x + s * a.along.x, a.from.y + s * a.along.y},
           "crosses the wall " + a.name + " there", "let one go through, and end two walls on it");
  }

  bool is_taken(int i, int e, Vec2 p) {
    if (at(i).end[e].kind == EndKind::kFree) return false;
    refuse(at(i), p, "more than two walls meet there",
           "let one wall go through, and end the others on it, apart from each other");
    return true;
  }

  // Whether the angle is allowed: 90 degrees, or at least 45 degrees for butted walls.
  bool may_meet(int i, int k, Vec2 p) {
    const double sine = std::fabs(cross(at(i).along, at(k).along));
    if (is_square(i, k)) return true;
    if (sine < kRightAngle)
      refuse(at(k), p, "goes straight on from " + at(i).name + ", or back over it",
             "make them one line");
    else if (is_toothed(at(i), at(k)))
      refuse(at(k), p,
             "meets " + at(i).name + " at another angle than 90 degrees, where teeth do not fit",
             "write meets = \"butted\" for one of them, or draw the corner at a right angle");
    else if (sine < kLeastSine)
      refuse(at(k), p, "meets " + at(i).name + " at an angle of less than 45 degrees",
             "draw it steeper, or end the line beside the other wall's face");
    else
      return true;
    return false;
  }
  bool is_square(int i, int k) { return std::fabs(dot(at(i).along, at(k).along)) < kRightAngle; }
  // Direction from end e into wall i.
  Vec2 into(int i, int e) { return e == 0 ? at(i).along : back(at(i).along); }

  // End e of wall i stands against the face of wall k, whose plane cuts its units. The axis of i reaches this plane t/2s from the
  // line of k, one edge |c| T/2s before (t, T: thicknesses of k and i; c, s: cosine and sine of the angle between them).
  void stand_against(int i, int e, int k) {
    const Vec2 d = into(i, e), p = point(at(i), e);
    const double sine = std::fabs(cross(d, at(k).along)), cosine = std::fabs(dot(d, at(k).along));
    const double t = at(k).thickness;
    WallEnd& end = at(i).end[e];
    end.reach = -0.5 * t;
    if (is_square(i, k)) return;
    end.reach = -0.5 * (t - at(i).thickness * cosine) / sine;
    end.face = dot(d, at(k).across) > 0 ? at(k).across : back(at(k).across);
    end.face_at = dot(end.face, p) + 0.5 * t;
  }

  void corner(int i, int e, int k, int f) {
    const Vec2 p = point(at(i), e);
    if (is_taken(i, e, p) || is_taken(k, f, p) || !may_meet(i, k, p) || !is_level(i, k, p)) return;
    const bool toothed = is_toothed(at(i), at(k));
    at(i).end[e] = {.kind = EndKind::kCorner, .other = k, .other_end = f, .toothed = toothed};
    at(k).end[f] = {.kind = EndKind::kCorner, .other = i, .other_end = e, .toothed = toothed};
    // wall i ends where the end of k stands against its face
    const Vec2 d = into(k, f);
    const double sine = std::fabs(cross(d, at(i).along)), out = -dot(d, into(i, e));
    at(i).end[e].reach = is_square(i, k)
                             ? 0.5 * at(k).thickness
                             : std::fmax(0, 0.5 * (at(i).thickness * out + at(k).thickness) / sine);
    if (toothed)
      at(k).end[f].reach = 0.5 * at(i).thickness;
    else
      stand_against(k, f, i);
  }

  void tee(int i, int e, int k, double along) {
    const Vec2 p = point(at(i), e);
    if (is_taken(i, e, p) || !may_meet(i, k, p) || !is_level(i, k, p)) return;
    const bool toothed = is_toothed(at(i), at(k));
    at(i).end[e] = {.kind = EndKind::kTee, .other = k, .toothed = toothed};
    if (toothed)
      at(i).end[e].reach = 0.5 * at(k).thickness;
    else
      stand_against(i, e, k);
    at(k).tees.push_back({i, e, along});
  }

  // Refuses two walls that end at one place from both sides: both would go through in the same courses.
  void check_tees(const StraightWall& wall) {
    for (std::size_t p = 0; p < wall.tees.size(); ++p)
      for (std::size_t q = p + 1; q < wall.tees.size(); ++q) {
        const StraightWall &a = at(wall.tees[p].other), &b = at(wall.tees[q].other);
        const double apart = std::fabs(wall.tees[p].at - wall.tees[q].at);
        if (apart > 0.5 * (a.thickness + b.thickness) - kSamePlace) continue;
        refuse(b, point(b, wall.tees[q].end), "ends on " + wall.name + " where " + a.name + " does",
               "move one of them along by " + metres(0.5 * (a.thickness + b.thickness)) +
                   ", or let one of these go through");
      }
  }

  std::vector<StraightWall>& walls_;
  const BuilderSpec& spec_;
  FaultList& faults_;
};

// --- courses that go through ------------------------------------------------------------------------

// Length of the unit at one end of a course, both halves together [m].
double end_unit(const StraightWall& wall, int e, int course) {
  const std::vector<Piece> pieces = lay_course(wall.storeys.front(), course);
  if (pieces.empty()) return 0;
  const int unit = e == 0 ? pieces.front().unit : pieces.back().unit;
  double length = 0;
  for (const Piece& piece : pieces)
    if (piece.unit == unit) length += piece.x1 - piece.x0;
  return length;
}

// Least distance of a course's head joints from a hole centred at `x` [m].
double nearest_joint(const StraightWall& wall, int course, double x) {
  double least = 1e300;
  int before = -1;
  for (const Piece& piece : lay_course(wall.storeys.front(), course)) {
    if (piece.unit != before) least = std::fmin(least, std::fabs(piece.x0 - x));
    before = piece.unit;
  }
  return least;
}

// Phases 0 or 1 of the walls, where the parity of the difference is prescribed for some pairs.
class Phases {
 public:
  explicit Phases(std::size_t n) : above_(n), parity_(n, 0) {
    for (std::size_t i = 0; i < n; ++i) above_[i] = i;
  }
  [[nodiscard]] int of(std::size_t i) const {
    int parity = 0;
    for (; above_[i] != i; i = above_[i]) parity ^= parity_[i];
    return parity;
  }
  // False where the pair already has the other parity.
  bool bind(std::size_t i, std::size_t k, int parity) {
    const std::size_t p = root(i), q = root(k);
    const int between = of(i) ^ of(k);
    if (p == q) return between == parity;
    above_[std::max(p, q)] = std::min(p, q);
    parity_[std::max(p, q)] = between ^ parity;
    return true;
  }

 private:
  [[nodiscard]] std::size_t root(std::size_t i) const {
    while (above_[i] != i) i = above_[i];
    return i;
  }
  std::vector<std::size_t> above_;
  std::vector<int> parity_;
};

bool has_courses(const StraightWall& wall) {
  return !wall.storeys.empty() && wall.storeys.front().lattice.courses.count > 0 &&
         wall.storeys.front().lattice.columns.count > 0;
}

// Whether teeth fit: courses must have equal heights, and units must be longer than the other wall is thick.
bool teeth_fit(const StraightWall& a, int e, const StraightWall& b, FaultList& faults) {
  const double step_a = a.storeys.front().lattice.courses.step;
  const double step_b = b.storeys.front().lattice.courses.step;
  if (std::fabs(step_a - step_b) > 1e-6 * step_a) {
    add_fault(faults, a.path + ".height", metres(a.wall.height),
              "its courses of " + millimetres(step_a) + " do not match those of " + b.name + ", " +
                  millimetres(step_b) + ", where they are toothed",
              "give both units of one height and heights of whole courses, or write meets = "
              "\"butted\"");
    return false;
  }
  const double lap = end_unit(a, e, a.end[e].passes) - b.thickness;
  const double least = kLeastLap * a.storeys.front().lattice.columns.step;
  if (lap >= least * (1 - 1e-9)) return true;
  add_fault(faults, a.path + ".unit.length", millimetres(end_unit(a, e, a.end[e].passes)),
            "the unit at its " + std::string(e == 0 ? "first" : "last") + " end does not lap " +
                b.name + ", which is " + millimetres(b.thickness) + " thick",
            "write units longer than " + millimetres(b.thickness + least) +
                ", a length of whole half units, or meets = \"butted\"");
  return false;
}

}  // namespace

std::vector<StraightWall> read_plan(const Site& site, std::vector<Message>& notes,
                                    FaultList& faults) {
  std::vector<StraightWall> walls;
  for (std::size_t i = 0; i < site.spec.plan_wall.size(); ++i)
    add_sides(site, static_cast<int>(i), walls, faults);
  // without all lines, walls would seem to end where none of them should
  const auto has_line = [](const PlanWallSpec& wall) { return wall.line.size() >= 2; };
  if (!std::all_of(site.spec.plan_wall.begin(), site.spec.plan_wall.end(), has_line)) return {};
  Meetings meetings(walls, site.spec, faults);
  meetings.find();
  meetings.note_near_misses(notes);
  return walls;
}

void match_courses(std::vector<StraightWall>& walls, FaultList& faults) {
  Phases phases(walls.size());
  const auto toothed = [&](std::size_t i, int e, EndKind kind) {
    const WallEnd& end = walls[i].end[e];
    return end.kind == kind && end.toothed && has_courses(walls[i]) &&
           has_courses(walls[end.other]);
  };
  for (StraightWall& wall : walls)
    for (int e = 0; e < 2 && has_courses(wall); ++e)
      wall.end[e].passes = end_unit(wall, e, 1) > end_unit(wall, e, 0) + 1e-9 ? 1 : 0;
  for (std::size_t i = 0; i < walls.size(); ++i)
    for (int e = 0; e < 2; ++e) {
      const WallEnd& end = walls[i].end[e];
      const std::size_t k = end.other;
      if (!toothed(i, e, EndKind::kCorner) || !teeth_fit(walls[i], e, walls[k], faults)) continue;
      const int parity = 1 ^ end.passes ^ walls[k].end[end.other_end].passes;
      if (i < k && !phases.bind(i, k, parity))
        add_fault(faults, walls[k].path + ".line", "",
                  "its courses do not match those of " + walls[i].name +
                      " at their corner: both would go through in the same courses",
                  "make one of the walls of this ring longer or shorter by half a unit, or write "
                  "meets = \"butted\"");
    }
  for (std::size_t i = 0; i < walls.size(); ++i)
    for (int e = 0; e < 2; ++e) {
      if (!toothed(i, e, EndKind::kTee)) continue;
      const WallEnd& end = walls[i].end[e];
      const std::size_t k = end.other;
      if (!teeth_fit(walls[i], e, walls[k], faults)) continue;
      const auto& tees = walls[k].tees;
      const auto own = std::find_if(tees.begin(), tees.end(), [&](const Tee& t) {
        return t.other == static_cast<int>(i) && t.end == e;
      });
      const double x = own->at - walls[k].begin();
      // the bridging course is the one whose head joints are farther from the tooth
      const int bridges = nearest_joint(walls[k], 1, x) > nearest_joint(walls[k], 0, x) ? 1 : 0;
      (void)phases.bind(i, k, 1 ^ end.passes ^ bridges);
    }
  for (std::size_t i = 0; i < walls.size(); ++i) walls[i].phase = phases.of(i);
}

}  // namespace wythe::geometry
