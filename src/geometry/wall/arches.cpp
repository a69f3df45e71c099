// Checks the keys of an arch, lays its voussoirs and cuts the masonry to them (docs/theory/conventions.md, "The lattice
// of a wall"). The right half mirrors the left, and the end joints meet the jambs to the bit. Slivers join a neighbour
// in rounds: all neighbours are chosen before any of them grows, so both sides are treated alike.
#include "geometry/wall/arches.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"
#include "core/to_int.h"
#include "geometry/text.h"
#include "geometry/wall/clip.h"
#include "geometry/wall/joints.h"

namespace wythe::geometry {
namespace {

constexpr double kThinnestVoussoir = 0.1;  // of a course: least width of a voussoir
constexpr double kNothing = 1e-10;         // [m^2]
constexpr int kFewest = 3;                 // voussoirs where their number is not stated

std::string key_of(int index, const char* key) {
  return opening_path(index, std::string("arch.") + key);
}

// One key of an arch that its kind requires, or does not use.
struct KindKey {
  const char* name;
  double value;
  bool is_needed;
  const char *unit, *example;
  const char* why;  // why another kind does not use it
};

bool check_keys(const ArchSpec& arch, int index, FaultList& faults) {
  bool good = is_positive({key_of(index, "depth"), arch.depth, "m", "250 mm"}, faults);
  const KindKey keys[] = {{"rise", arch.rise, arch.kind == ArchKind::kSegmental, "m", "150 mm",
                           arch.kind == ArchKind::kRound ? "a round arch rises by half its span"
                                                         : "the soffit of a flat arch is level"},
                          {"skewback", arch.skewback, arch.kind == ArchKind::kFlat, "rad", "15 deg",
                           "its end joints run to the centre of its circle"}};
  for (const KindKey& key : keys) {
    if (key.is_needed) {
      good &= is_positive({key_of(index, key.name), key.value, key.unit, key.example}, faults);
    } else if (!std::isnan(key.value)) {
      add_fault(faults, key_of(index, key.name), "", key.why, "leave it out");
      good = false;
    }
  }
  return good;
}

bool check_number(const ArchSpec& arch, int index, FaultList& faults) {
  if (arch.voussoirs == 0 || arch.voussoirs >= 2) return true;
  add_fault(faults, key_of(index, "voussoirs"), std::to_string(arch.voussoirs),
            "an arch has two voussoirs at least: one stone is a lintel",
            "write voussoirs = 9, say, or leave it out");
  return false;
}

void check_body(const Shape& shape, int index, FaultList& faults) {
  const std::string& material = shape.wall.opening[index].arch.material;
  if (material.empty()) return;
  const auto found = shape.material.find(material);
  if (found == shape.material.end()) {
    add_fault(faults, key_of(index, "material"), "\"" + material + "\"",
              "there is no such material", "add [material." + material + "] with its density");
    return;
  }
  (void)is_positive({"material." + material + ".density", found->second, "kg/m^3", "2000 kg/m^3"},
                    faults);
}

// The centre of an arch's joints, and the angle that its voussoirs divide.
struct Circle {
  double half_span = 0, rise = 0;
  Vec2 centre;
  double radius = 0;      // of the intrados
  double half_angle = 0;  // between crown and end joint [rad]
};

Circle circle_of(const ArchSpec& arch, const Rect& hole) {
  Circle c;
  c.half_span = (hole.x1 - hole.x0) / 2;
  // a span that was moved to joint lines turns a stated half span into a round arch
  c.rise = arch.kind == ArchKind::kRound ? c.half_span : std::min(arch.rise, c.half_span);
  c.radius = (c.half_span * c.half_span + c.rise * c.rise) / (2 * c.rise);
  c.centre = {(hole.x0 + hole.x1) / 2, hole.y1 + c.rise - c.radius};
  c.half_angle = elementary::atan2(c.half_span, c.radius - c.rise);
  return c;
}

// Length of the intrados [m].
double length_of(const ArchSpec& arch, const Rect& hole) {
  if (arch.kind == ArchKind::kFlat) return hole.x1 - hole.x0;
  const Circle c = circle_of(arch, hole);
  return 2 * c.half_angle * c.radius;
}

// Number of bricks on edge, each as wide as a course is high; odd, so that there is a keystone.
int number_of(const ArchSpec& arch, const Rect& hole, double course) {
  if (arch.voussoirs > 0) return arch.voussoirs;
  const double fit = length_of(arch, hole) / course;
  return std::max(kFewest, 2 * to_int(std::floor(fit / 2)) + 1);
}

struct Corner {
  Vec2 intrados, extrados;
};

// The joint of a flat arch at the share `u` of the way from the crown (0) to the left end (1).
Corner flat_joint(const ArchSpec& arch, const Rect& hole, double u) {
  const double half = (hole.x1 - hole.x0) / 2, middle = (hole.x0 + hole.x1) / 2;
  const double wider = half + arch.depth * elementary::tan(arch.skewback);
  return {{middle - u * half, hole.y1}, {middle - u * wider, hole.y1 + arch.depth}};
}

Corner round_joint(const ArchSpec& arch, const Circle& c, double u) {
  const double sine = elementary::sin(u * c.half_angle), cosine = elementary::cos(u * c.half_angle);
  const double outer = c.radius + arch.depth;
  return {{c.centre.x - c.radius * sine, c.centre.y + c.radius * cosine},
          {c.centre.x - outer * sine, c.centre.y + outer * cosine}};
}

// The end joints meet the jambs to the bit; those of a round arch start at the springing line.
Corner end_joint(const ArchSpec& arch, const Rect& hole) {
  const bool is_flat = arch.kind == ArchKind::kFlat;
  Corner end = is_flat ? flat_joint(arch, hole, 1) : round_joint(arch, circle_of(arch, hole), 1);
  end.intrados = {hole.x0, hole.y1};
  if (!is_flat && circle_of(arch, hole).rise == (hole.x1 - hole.x0) / 2) {
    end.extrados = {hole.x0 - arch.depth, hole.y1};
  }
  return end;
}

// Lays the left half and mirrors it.
PlacedArch lay_voussoirs(const ArchSpec& arch, const Rect& hole, int n) {
  const std::size_t last = n;
  PlacedArch laid{std::vector<Vec2>(last + 1), std::vector<Vec2>(last + 1)};
  const double twice = hole.x0 + hole.x1;
  const auto mirror = [&](Vec2 p) { return Vec2{twice - p.x, p.y}; };
  for (std::size_t k = 0; 2 * k <= last; ++k) {
    const double u = 1 - 2 * static_cast<double>(k) / n;
    const Corner joint = k == 0 ? end_joint(arch, hole)
                         : arch.kind == ArchKind::kFlat
                             ? flat_joint(arch, hole, u)
                             : round_joint(arch, circle_of(arch, hole), u);
    laid.intrados[k] = joint.intrados;
    laid.extrados[k] = joint.extrados;
    if (2 * k == last) continue;
    laid.intrados[last - k] = mirror(joint.intrados);
    laid.extrados[last - k] = mirror(joint.extrados);
  }
  laid.intrados[last].x = hole.x1;
  return laid;
}

bool rises_no_more_than_half(const ArchSpec& arch, const PlacedOpening& opening,
                             FaultList& faults) {
  const double half = (opening.hole.x1 - opening.hole.x0) / 2;
  if (arch.kind != ArchKind::kSegmental || arch.rise <= half * (1 + kFitTolerance)) return true;
  add_fault(
      faults, key_of(opening.index, "rise"), millimetres(arch.rise),
      "the arch of " + opening.called + " rises by more than half its span of " + metres(2 * half),
      "write rise = \"" + millimetres(half / 2) + "\", say, or kind = \"round\"");
  return false;
}

bool are_wide_enough(const ArchSpec& arch, int n, double course, const PlacedOpening& opening,
                     FaultList& faults) {
  const double length = length_of(arch, opening.hole);
  const int most = to_int(std::floor(length / (kThinnestVoussoir * course)));
  if (n <= most) return true;
  add_fault(faults, key_of(opening.index, "voussoirs"), std::to_string(n),
            "would make voussoirs of " + millimetres(length / n) + " in " + opening.called +
                ", thinner than a tenth of a course",
            most >= 2 ? "write at most voussoirs = " + std::to_string(most) + ", or leave it out"
                      : "lay smaller units, or leave the arch out");
  return false;
}

// Rounded up to whole millimetres [m].
double to_millimetre(double length) { return 1e-3 * std::ceil(1e3 * length - 1e-6); }

bool has_room(const PlacedArch& laid, const Storey& storey, const PlacedOpening& opening,
              FaultList& faults) {
  const Rect box = bounds(outline_of(laid));
  const Axis &columns = storey.lattice.columns, &courses = storey.lattice.courses;
  const double top = courses.end(), least = kSliver * columns.step;
  bool fits = true;
  if (box.y1 > top * (1 + 1e-12)) {
    add_fault(faults, key_of(opening.index, "depth"), "",
              "the arch of " + opening.called + " reaches to " + metres(to_millimetre(box.y1)) +
                  (storey.index < 0 ? ", above the wall's top at "
                                    : ", above the top of " + storey.called() + " at ") +
                  metres(top),
              "lower the springing (opening height) by " + metres(to_millimetre(box.y1 - top)) +
                  ", or its rise and depth by as much");
    fits = false;
  }
  if (box.x0 < least || box.x1 > columns.extent - least) {
    add_fault(faults, opening_path(opening.index, "arch"), "",
              "the arch of " + opening.called + " spans " + metres(box.x0) + " to " +
                  metres(box.x1) + ": no masonry of the wall (0 m to " + metres(columns.extent) +
                  ") takes its thrust",
              "leave a quarter unit (" + millimetres(least) +
                  ") or more beside it: move the opening, or make the arch less deep");
    fits = false;
  }
  return fits;
}

// --- cutting -----------------------------------------------------------------------------------------

double least_area(const Block& block, const std::vector<Storey>& storeys) {
  const Lattice& lattice = storeys[std::max(0, block.storey)].lattice;
  return kSliver * lattice.columns.step * lattice.courses.step;
}

// Whether a piece is smaller than the shortest piece laid, or too thin to lay.
bool is_sliver(const Block& block, const std::vector<Storey>& storeys) {
  const Lattice& lattice = storeys[std::max(0, block.storey)].lattice;
  const Rect box = bounds(block.outline);
  return moments(block.outline).area < least_area(block, storeys) * (1 - 1e-6) ||
         box.x1 - box.x0 < kThinnestVoussoir * lattice.columns.step ||
         box.y1 - box.y0 < kThinnestVoussoir * lattice.courses.step;
}

// Blocks that the arch cuts, removed from `blocks`; the others stay there.
std::vector<Block> take_cut(const Polygon& free, std::vector<Block>& blocks) {
  const Rect box = bounds(free);
  std::vector<Block> kept, cut;
  for (Block& block : blocks) {
    const bool is_near = block.opening < 0 && overlaps(bounds(block.outline), box, 0);
    const double before = is_near ? overlap_area(block.outline, free) : 0;
    if (before <= kNothing) {
      kept.push_back(std::move(block));
      continue;
    }
    int number = 0;
    for (Polygon& part : difference(block.outline, free)) {
      cut.push_back(block);
      cut.back().outline = std::move(part);
      if (++number > 1) cut.back().id += "_" + std::to_string(number);
    }
  }
  blocks = std::move(kept);
  return cut;
}

// A neighbour that may absorb a sliver: first of its own unit, then with the longest contact, then the upper one.
struct Host {
  std::size_t block = 0;
  bool same_unit = false;
  double contact = 0, height = 0;
};

bool is_better(const Host& a, const Host& b) {
  if (a.same_unit != b.same_unit) return a.same_unit;
  if (std::abs(a.contact - b.contact) > 1e-9) return a.contact > b.contact;
  return a.height > b.height + 1e-9;
}

// Index of the block that absorbs the sliver; blocks.size() where there is none.
std::size_t host_of(const std::vector<Block>& blocks, const Block& sliver) {
  Host best;
  best.block = blocks.size();
  const Rect box = bounds(sliver.outline);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const Block& block = blocks[b];
    if (block.opening >= 0 || block.storey != sliver.storey ||
        !overlaps(bounds(block.outline), box, -1e-9))
      continue;
    Host host{b, block.unit >= 0 && block.unit == sliver.unit, 0,
              moments(block.outline).centroid.y};
    for (const Contact& contact : find_contacts({sliver, block}).contacts)
      host.contact += length(contact.p1 - contact.p0);
    if (host.contact > 0 && (best.block == blocks.size() || is_better(host, best))) best = host;
  }
  return best.block;
}

// Unites `part` with the host; false where the result is not a single outline.
bool take_in(Block& host, const Block& part) {
  Polygon whole = joined_outline(host.outline, part.outline);
  if (whole.empty()) return false;
  host.outline = std::move(whole);
  return true;
}

}  // namespace

bool check_arch(const Shape& shape, int index, FaultList& faults) {
  const OpeningSpec& opening = shape.wall.opening[index];
  if (opening.arch.kind == ArchKind::kNone) return false;
  if (!opening.lintel.kind.empty())
    add_fault(faults, opening_path(index, "arch"), "",
              opening_name(index, opening.name) + " has a lintel and an arch",
              "leave one of them out");
  check_body(shape, index, faults);
  bool good = check_keys(opening.arch, index, faults);
  good &= check_number(opening.arch, index, faults);
  return good;
}

void place_arch(const ArchSpec& arch, const Storey& storey, PlacedOpening& opening,
                std::vector<Message>& notes, FaultList& faults) {
  const double course = storey.lattice.courses.step;
  if (!rises_no_more_than_half(arch, opening, faults)) return;
  const int n = number_of(arch, opening.hole, course);
  if (!are_wide_enough(arch, n, course, opening, faults)) return;
  PlacedArch laid = lay_voussoirs(arch, opening.hole, n);
  if (!has_room(laid, storey, opening, faults)) return;
  notes.push_back({"arch.laid",
                   {{"opening", opening.words},
                    {"voussoirs", n},
                    {"width_mm", 1e3 * length(laid.intrados[1] - laid.intrados[0])}}});
  opening.arch = std::move(laid);
}

Polygon outline_of(const PlacedArch& arch) {
  Polygon outline{arch.intrados.front(), arch.intrados.back()};
  outline.insert(outline.end(), arch.extrados.rbegin(), arch.extrados.rend());
  return outline;
}

Polygon voussoir(const PlacedArch& arch, std::size_t k) {
  return {arch.intrados[k], arch.intrados[k + 1], arch.extrados[k + 1], arch.extrados[k]};
}

int cut_masonry(const PlacedArch& arch, const std::vector<Storey>& storeys,
                std::vector<Block>& blocks) {
  std::vector<Block> slivers;
  for (Block& block : take_cut(outline_of(arch), blocks))
    (is_sliver(block, storeys) ? slivers : blocks).push_back(std::move(block));
  const std::size_t before = slivers.size();
  // rounds: hosts are chosen before any of them grows, so that left and right are treated alike
  for (std::size_t waiting = 0; waiting != slivers.size();) {
    waiting = slivers.size();
    std::vector<std::size_t> hosts;
    for (const Block& sliver : slivers) hosts.push_back(host_of(blocks, sliver));
    std::vector<Block> left;
    for (std::size_t k = 0; k < slivers.size(); ++k) {
      if (hosts[k] < blocks.size() && take_in(blocks[hosts[k]], slivers[k])) continue;
      left.push_back(std::move(slivers[k]));
    }
    slivers = std::move(left);
  }
  const std::size_t joined = before - slivers.size();
  for (Block& block : slivers) blocks.push_back(std::move(block));
  return static_cast<int>(joined);
}

}  // namespace wythe::geometry
