// Floor slabs as rigid bodies: their places, and the pockets that they cut into walls.
//
//   [[slab]] ──► outline (between walls, or as given) ──► level on a bed joint ──► convex parts ──► walls cut
//
// Equations and limits: docs/theory/builder.md, "Floor slabs".
#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "core/text.h"
#include "geometry/blocks_file.h"
#include "geometry/bodies/convex_parts.h"
#include "geometry/bodies/polygon_in_space.h"
#include "geometry/bodies/solid_cut.h"
#include "geometry/builder/builder.h"
#include "geometry/text.h"

namespace wythe::geometry {
namespace {

constexpr double kSameHeight = 1e-3;  // difference of beds of two walls under one slab [m]
constexpr double kNearBed = 0.01;     // distance of the stated level from a bed joint [m]
constexpr double kSquare = 1e-6;      // sine between walls of a rectangle
constexpr double kSlabMargin = 1e-6;  // [m]
constexpr double kLeastRest = 0.25;   // of a unit: smaller loose ends are omitted
constexpr double kBesideEnds = 0.25;  // of the clear length: range of walls beside a slab

double top_of(const StraightWall& wall) {
  return wall.base + wall.storeys.front().lattice.courses.end();
}

// Outline of the masonry in plan.
Convex footprint(const StraightWall& wall) {
  const double half = 0.5 * wall.thickness;
  Convex corners;
  for (const auto& [s, t] : {std::pair(0.0, -half), {1.0, -half}, {1.0, half}, {0.0, half}}) {
    const double along = wall.begin() + s * wall.wall.length;
    corners.push_back({wall.from.x + along * wall.along.x + t * wall.across.x,
                       wall.from.y + along * wall.along.y + t * wall.across.y});
  }
  return corners;
}

struct Range {
  double low = 0, high = 0;
};
Range range_along(const Convex& corners, Vec2 direction) {
  Range range{1e300, -1e300};
  for (const Vec2 p : corners) {
    range.low = std::fmin(range.low, dot(p, direction));
    range.high = std::fmax(range.high, dot(p, direction));
  }
  return range;
}
double middle(Range r) { return 0.5 * (r.low + r.high); }

bool is_anticlockwise(const Convex& polygon) {
  double twice = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k)
    twice += cross(polygon[k], polygon[(k + 1) % polygon.size()]);
  return twice > 0;
}

// A slab with its place, before it cuts walls.
struct Placed {
  std::vector<Convex> parts;            // of its outline in plan
  std::vector<const StraightWall*> on;  // walls that carry it
  double level = 0;
  std::vector<Polyhedron> solid;
};

class SlabBuilder {
 public:
  SlabBuilder(const Site& site, const std::vector<StraightWall>& walls, int index,
              std::vector<Message>& notes, FaultList& faults)
      : site_(site),
        walls_(walls),
        spec_(site.spec.slab[index]),
        path_("slab." + std::to_string(index)),
        notes_(notes),
        faults_(faults) {}

  void build(std::vector<BuiltBody>& bodies) {
    const std::size_t before = faults_.all().size();
    check_numbers();
    if (faults_.all().size() != before) return;
    Placed slab;
    spec_.walls.empty() ? take_outline(slab) : between_walls(slab);
    if (faults_.all().size() != before) return;
    find_level(slab);
    if (faults_.all().size() != before) return;
    const PlanAxes axes{site_.z_up()};
    for (const Convex& part : slab.parts) {
      std::vector<Vec3> low, high;
      for (const Vec2 p : part) {
        low.push_back(axes.place(p, slab.level));
        high.push_back(axes.place(p, slab.level + spec_.thickness));
      }
      slab.solid.push_back(solid_between(low, high));
    }
    check_regions(slab, bodies);
    if (faults_.all().size() != before) return;
    cut_pockets(slab, bodies);
    BuiltBody own;
    own.body.id = spec_.name;
    own.body.material = spec_.material;
    own.body.role = "slab";
    own.body.part = slab.solid;
    tell(slab, own.body);
    bodies.push_back(std::move(own));
  }

 private:
  void refuse(const std::string& key, const std::string& value, const std::string& problem,
              const std::string& cure) {
    add_fault(faults_, path_ + "." + key, value, problem, cure);
  }

  // A slab needs a density of its own: that of masonry would give a wrong weight.
  void check_density() {
    const std::string path = path_ + ".material";
    if (spec_.material == "masonry") return site_.check_material(path, spec_.material, faults_);
    const auto own = site_.model.material.find(spec_.material);
    if (is_material(Shape(site_.model), path, spec_.material, faults_) &&
        (own == site_.model.material.end() || std::isnan(own->second.density)))
      add_fault(faults_, "material." + spec_.material + ".density", "",
                "is missing: slab " + spec_.name + " weighs what it says",
                "write e.g. density = \"2500 kg/m^3\"");
  }

  void check_numbers() {
    for (const FloorSpec& floor : site_.model.floor)
      if (floor.name == spec_.name && (spec_.load > 0 || spec_.mass > 0))
        refuse("name", "\"" + spec_.name + "\"",
               "is a [[floor]]'s too, and the slab's load becomes one",
               "give one of them another name");
    (void)is_positive({path_ + ".thickness", spec_.thickness, "m", "0.2 m"}, faults_);
    if (spec_.material.empty())
      refuse("material", "", "is missing: it gives the slab its density",
             "write e.g. material = \"concrete\", with density under [material.concrete]");
    else
      check_density();
    if (!spec_.joint.empty() && !site_.model.material.contains(spec_.joint))
      refuse("joint", "\"" + spec_.joint + "\"", "there is no such material",
             "add [material." + spec_.joint + "], or name another");
    if (spec_.walls.empty() == spec_.outline.empty())
      return spec_.walls.empty()
                 ? refuse("walls", "", "is missing: nothing says where the slab lies",
                          "name the walls it rests on, or give its outline")
                 : refuse("outline", "", "and walls are both given", "leave one out");
    if (spec_.walls.empty()) {
      if (!std::isnan(spec_.bearing))
        refuse("bearing", metres(spec_.bearing),
               "goes with walls; an outline says itself how far it reaches", "leave it out");
      if (spec_.gap > 0)
        refuse("gap", metres(spec_.gap), "goes with walls; an outline says itself where it ends",
               "leave it out");
      if (std::isnan(spec_.level))
        refuse("level", "", "is missing, and an outline names no wall whose top it could be",
               "write the height of its underside, e.g. level = \"2.7 m\"");
      return;
    }
    (void)is_positive({path_ + ".bearing", spec_.bearing, "m", "0.15 m"}, faults_);
  }

  // --- outline ---

  void take_outline(Placed& slab) {
    Convex outline;
    for (const auto& p : spec_.outline) outline.push_back({p[0], p[1]});
    if (outline.size() < 3)
      return refuse(
          "outline", std::to_string(outline.size()), "needs three corners or more",
          "write e.g. outline = [[\"0 m\", \"0 m\"], [\"4 m\", \"0 m\"], [\"4 m\", \"3 m\"]]");
    if (!is_simple(outline))
      return refuse("outline", "", "crosses or touches itself", "list its corners in turn");
    if (!is_anticlockwise(outline)) std::reverse(outline.begin(), outline.end());
    slab.parts = convex_parts(outline);
    for (const StraightWall& wall : walls_)
      for (const Convex& part : slab.parts)
        if (covers(part, wall) && spec_.level > wall.base + kNearBed &&
            spec_.level < top_of(wall) + kNearBed) {
          slab.on.push_back(&wall);
          break;
        }
  }

  static bool covers(const Convex& part, const StraightWall& wall) {
    const Convex both = common_part(part, oriented(footprint(wall)), kSlabMargin);
    return both.size() >= 3 && area_of(both) > kSlabMargin;
  }
  static Convex oriented(Convex polygon) {
    if (!is_anticlockwise(polygon)) std::reverse(polygon.begin(), polygon.end());
    return polygon;
  }

  // --- between walls ---

  std::vector<const StraightWall*> named_walls() {
    std::vector<const StraightWall*> found;
    std::vector<std::string> names;
    for (const StraightWall& wall : walls_) names.push_back(wall.name);
    for (std::size_t k = 0; k < spec_.walls.size(); ++k) {
      const std::string& name = spec_.walls[k];
      const std::size_t before = found.size();
      for (const StraightWall& wall : walls_)
        if ((wall.name == name || site_.spec.plan_wall[wall.index].name == name) &&
            std::find(found.begin(), found.end(), &wall) == found.end())
          found.push_back(&wall);
      if (found.size() == before)
        refuse(fmt::format("walls.{}", k), "\"" + name + "\"",
               "is no plan wall, or stands in the list twice", name_advice(name, names));
    }
    return found;
  }

  // The two carrying walls farthest apart across `direction`, the lower one first.
  struct Sides {
    const StraightWall *low = nullptr, *high = nullptr;
  };
  static double place_of(const StraightWall& wall, Vec2 across) { return dot(wall.from, across); }

  void between_walls(Placed& slab) {
    slab.on = named_walls();
    if (slab.on.size() < spec_.walls.size()) return;  // reported above
    if (slab.on.size() != 2 && slab.on.size() != 3 && slab.on.size() != 4)
      return refuse("walls", std::to_string(slab.on.size()) + " walls",
                    "a slab rests on two parallel walls, or on three or four sides of a rectangle",
                    "name these, or give its outline");
    for (const StraightWall* wall : slab.on)
      if (spec_.bearing > wall->thickness + kSlabMargin)
        refuse("bearing", metres(spec_.bearing),
               "is more than the wall " + wall->name + " is thick",
               "write " + metres(wall->thickness) + " or less");
    // u is the direction of the first wall with a parallel one
    for (const StraightWall* first : slab.on) {
      std::vector<const StraightWall*> along, across;
      for (const StraightWall* wall : slab.on) {
        const double sine = std::fabs(cross(first->along, wall->along));
        if (sine < kSquare) along.push_back(wall);
        if (std::fabs(dot(first->along, wall->along)) < kSquare) across.push_back(wall);
      }
      if (along.size() != 2 || along.size() + across.size() != slab.on.size() || across.size() > 2)
        continue;
      return lay_rectangle(slab, along, across);
    }
    refuse("walls", "", "are not two parallel walls, nor three or four sides of a rectangle",
           "give the slab's outline");
  }

  void lay_rectangle(Placed& slab, const std::vector<const StraightWall*>& along,
                     const std::vector<const StraightWall*>& across) {
    const Vec2 u = along.front()->along, v = along.front()->across;
    const auto inner = [&](const std::vector<const StraightWall*>& walls, Vec2 d) {
      Sides sides{walls[0], walls[1]};
      if (place_of(*sides.low, d) > place_of(*sides.high, d)) std::swap(sides.low, sides.high);
      return Range{place_of(*sides.low, d) + 0.5 * sides.low->thickness - spec_.bearing,
                   place_of(*sides.high, d) - 0.5 * sides.high->thickness + spec_.bearing};
    };
    const Range across_range = inner(along, v);
    const Range a = range_along(footprint(*along[0]), u), b = range_along(footprint(*along[1]), u);
    Range length{std::fmax(a.low, b.low), std::fmin(a.high, b.high)};
    const Range clear = across_range;
    if (!(length.high - length.low > kSlabMargin) || !(clear.high - clear.low > 2 * spec_.bearing))
      return refuse("walls", "", "do not lie opposite each other", "give the slab's outline");
    if (across.size() == 2) {
      length = inner(across, u);
    } else {
      end_at_walls(slab, u, v, clear, length);
      for (const StraightWall* wall : across) {
        const double place = place_of(*wall, u);
        if (place < middle(length))
          length.low = place + 0.5 * wall->thickness - spec_.bearing;
        else
          length.high = place - 0.5 * wall->thickness + spec_.bearing;
      }
    }
    Convex outline;
    for (const auto& [s, t] : {std::pair(length.low, across_range.low),
                               {length.high, across_range.low},
                               {length.high, across_range.high},
                               {length.low, across_range.high}})
      outline.push_back({s * u.x + t * v.x, s * u.y + t * v.y});
    slab.parts = {oriented(std::move(outline))};
  }

  // Shortens the slab to end `gap` before the faces of walls beside it that do not carry it.
  void end_at_walls(const Placed& slab, Vec2 u, Vec2 v, Range clear, Range& length) {
    const Range whole = length;
    for (const StraightWall& wall : walls_) {
      if (std::find(slab.on.begin(), slab.on.end(), &wall) != slab.on.end()) continue;
      const Range own = range_along(footprint(wall), v), at_u = range_along(footprint(wall), u);
      const double level = level_wanted(slab);
      if (own.high < clear.low + kSlabMargin || own.low > clear.high - kSlabMargin) continue;
      if (at_u.high < whole.low + kSlabMargin || at_u.low > whole.high - kSlabMargin) continue;
      if (level > top_of(wall) - kSlabMargin || level + spec_.thickness < wall.base + kSlabMargin)
        continue;
      const double place = (middle(at_u) - whole.low) / (whole.high - whole.low);
      if (place < kBesideEnds)
        length.low = std::fmax(length.low, at_u.high + spec_.gap);
      else if (place > 1 - kBesideEnds)
        length.high = std::fmin(length.high, at_u.low - spec_.gap);
      else
        refuse("walls", wall.name, "stands across the middle of the slab",
               "name it among the walls that the slab rests on, or give the slab's outline");
    }
  }

  // --- level ---

  [[nodiscard]] double level_wanted(const Placed& slab) const {
    return std::isnan(spec_.level) ? top_of(*slab.on.front()) : spec_.level;
  }

  void find_level(Placed& slab) {
    if (std::isnan(spec_.level))
      for (const StraightWall* wall : slab.on) {
        if (site_.spec.plan_wall[wall->index].gable > 0)
          return refuse("level", "", "is missing, and the wall " + wall->name + " has a gable",
                        "write the height of the slab's underside");
        if (std::fabs(top_of(*wall) - top_of(*slab.on.front())) > kSameHeight)
          return refuse("level", "",
                        "is missing, and the walls end at different heights: " +
                            slab.on.front()->name + " at " + metres(top_of(*slab.on.front())) +
                            ", " + wall->name + " at " + metres(top_of(*wall)),
                        "write the height of the slab's underside");
      }
    slab.level = level_wanted(slab);
    if (slab.on.empty()) return;  // on an arch or on single blocks
    const double stated = slab.level;
    slab.level = nearest_bed(*slab.on.front(), stated);
    for (const StraightWall* wall : slab.on) {
      const double bed = nearest_bed(*wall, stated);
      if (std::fabs(bed - stated) > kNearBed)
        return refuse(
            "level", metres(stated),
            "is at no bed joint of the wall " + wall->name + ", the nearest is at " + metres(bed),
            "write that height; a slab lies on a course");
      if (std::fabs(bed - slab.level) > kSameHeight)
        return refuse("level", metres(stated),
                      "the bed joints of " + slab.on.front()->name + " and " + wall->name +
                          " lie there at different heights, " + metres(slab.level) + " and " +
                          metres(bed),
                      "give both walls courses of one height");
    }
    if (std::fabs(slab.level - stated) > kSlabMargin)
      notes_.push_back({"slab.moved",
                        {{"slab", spec_.name},
                         {"from_m", stated},
                         {"to_m", slab.level},
                         {"wall", slab.on.front()->name}}});
  }

  static double nearest_bed(const StraightWall& wall, double level) {
    const Axis& courses = wall.storeys.front().lattice.courses;
    double best = 1e300;
    for (int row = 1; row <= courses.count; ++row)
      if (const double bed = wall.base + courses.line(row);
          std::fabs(bed - level) < std::fabs(best - level))
        best = bed;
    return best;
  }

  // Refuses a region of another depth where the slab lies on its wall: the bearing counts from the wall's faces.
  void check_regions(const Placed& slab, const std::vector<BuiltBody>& bodies) {
    for (const BuiltBody& body : bodies) {
      const auto wall = std::find_if(slab.on.begin(), slab.on.end(),
                                     [&](const StraightWall* on) { return on->name == body.wall; });
      if (body.region.empty() || wall == slab.on.end()) continue;
      const Box3 box = box_of(body.body);
      if (box.high.y < slab.level - kSlabMargin ||
          box.low.y > slab.level + spec_.thickness + kSlabMargin)
        continue;
      Convex corners;
      for (const Vec3& p : body.body.part.front().vertex)
        corners.push_back({p.x, site_.z_up() ? -p.z : p.z});
      const Range own = range_along(corners, (*wall)->along);
      for (const Convex& part : slab.parts)
        if (const Range there = range_along(part, (*wall)->along);
            own.low < there.high - kSlabMargin && own.high > there.low + kSlabMargin)
          return refuse(spec_.walls.empty() ? "outline" : "walls", body.wall,
                        "the slab lies there on " + body.region + ", which has a depth of its own",
                        "end the region below the slab or above it, or beside it");
    }
  }

  // --- pockets ---

  void cut_pockets(const Placed& slab, std::vector<BuiltBody>& bodies) {
    std::vector<BuiltBody> kept;
    int lost = 0;
    for (BuiltBody& body : bodies) {
      std::vector<Polyhedron> parts = body.body.part;
      bool is_cut = false;
      for (const Polyhedron& without : slab.solid) {
        std::vector<Polyhedron> rest;
        for (const Polyhedron& part : parts) {
          if (!near(box_of(part.vertex), box_of(without.vertex), 0) ||
              !reaches_into(part, without)) {
            rest.push_back(part);
            continue;
          }
          is_cut = true;
          for (Polyhedron& piece : rest_of(part, without)) rest.push_back(std::move(piece));
        }
        parts = std::move(rest);
      }
      if (!is_cut) {
        kept.push_back(std::move(body));
        continue;
      }
      if (body.course < 0) {
        refuse(spec_.walls.empty() ? "outline" : "walls", body.body.id,
               "lies where the slab reaches, and only masonry is cut for it",
               "move the slab, or shorten its bearing");
        return;
      }
      keep_pieces(std::move(parts), std::move(body), kept, lost);
    }
    bodies = std::move(kept);
    if (lost > 0) notes_.push_back({"slab.ends_left_out", {{"slab", spec_.name}, {"ends", lost}}});
  }

  // Whether both share more than a negligible volume.
  static bool reaches_into(const Polyhedron& part, const Polyhedron& without) {
    Polyhedron inside = part;
    for (const auto& face : without.face) {
      const Facet plane = facet_of(without, face);
      inside = cut(inside, plane.normal, dot(plane.centre, plane.normal)).below;
      if (inside.vertex.empty()) return false;
    }
    return solid_moments(inside).volume > 1e-9;
  }

  // Connected parts stay one block. Loose ends become blocks of their own, or are omitted if small.
  static void keep_pieces(std::vector<Polyhedron> parts, BuiltBody body,
                          std::vector<BuiltBody>& kept, int& lost) {
    const double whole = solid_moments(body.body).volume;
    const std::string id = body.body.id;
    int number = 0;
    for (std::vector<Polyhedron>& group : connected(std::move(parts))) {
      BuiltBody piece = body;
      piece.body.part = std::move(group);
      if (solid_moments(piece.body).volume < kLeastRest * whole && number > 0) {
        ++lost;
        continue;
      }
      if (number++ > 0) piece.body.id = fmt::format("{}.p{}", id, number);
      kept.push_back(std::move(piece));
    }
  }

  // --- words ---

  void tell(const Placed& slab, const BodySpec& body) {
    std::vector<std::string> names;
    for (const StraightWall* wall : slab.on) names.push_back(wall->name);
    const double volume = solid_moments(body).volume;
    const auto own = site_.model.material.find(spec_.material);
    const double density = own != site_.model.material.end() && !std::isnan(own->second.density)
                               ? own->second.density
                               : site_.model.wall.unit.density;
    const bool varies =
        std::any_of(site_.model.field.begin(), site_.model.field.end(), [&](const auto& field) {
          return field.second.path == "material." + spec_.material + ".density" ||
                 (own == site_.model.material.end() && field.second.path == "wall.unit.density");
        });
    notes_.push_back({varies ? "slab.lies_in_field" : "slab.lies",
                      {{"slab", spec_.name},
                       {"level_m", slab.level},
                       {"area_m2", volume / spec_.thickness},
                       {"mass_kg", density * volume},
                       {"walls", names.empty() ? "-" : joined(names, ", ")}}});
  }

  const Site& site_;
  const std::vector<StraightWall>& walls_;
  const SlabSpec& spec_;
  std::string path_;
  std::vector<Message>& notes_;
  FaultList& faults_;
};

// Half of a line inside a level polygon: through its centre, parallel to the longest side, equally long on both sides.
Vec3 half_line(const Facet& face) {
  Vec3 longest;
  for (std::size_t k = 0; k < face.corner.size(); ++k) {
    const Vec3 side = face.corner[(k + 1) % face.corner.size()] - face.corner[k];
    if (dot(side, side) > dot(longest, longest) * (1 + 1e-9)) longest = side;
  }
  const Vec3 along = unit(longest);
  double reach = 1e300;
  for (std::size_t k = 0; k < face.corner.size(); ++k) {
    const Vec3 side = face.corner[(k + 1) % face.corner.size()] - face.corner[k];
    const Vec3 out = unit(cross(side, face.normal));
    const double rate = std::fabs(dot(along, out));
    if (rate > 1e-9) reach = std::fmin(reach, dot(face.corner[k] - face.centre, out) / rate);
  }
  return 0.999 * reach * along;
}

}  // namespace

void build_slabs(const Site& site, const std::vector<StraightWall>& walls,
                 std::vector<BuiltBody>& bodies, std::vector<Message>& notes, FaultList& faults) {
  for (std::size_t k = 0; k < site.spec.slab.size(); ++k)
    SlabBuilder(site, walls, static_cast<int>(k), notes, faults).build(bodies);
}

std::vector<FloorSpec> floors_of_slabs(const Site& site, const std::vector<BuiltBody>& bodies) {
  const auto place = [&](Vec3 p) {
    PlaceSpec point;
    point.x = p.x, point.y = p.y, point.z = p.z;
    if (site.z_up()) point.y = -p.z, point.z = p.y;
    return point;
  };
  std::vector<FloorSpec> floors;
  for (const SlabSpec& slab : site.spec.slab)
    for (const BuiltBody& built : bodies) {
      if (built.body.id != slab.name || (slab.load == 0 && slab.mass == 0)) continue;
      for (std::size_t p = 0; p < built.body.part.size(); ++p) {
        const Polyhedron& part = built.body.part[p];
        for (const auto& corners : part.face) {
          const Facet top = facet_of(part, corners);
          if (top.normal.y < 0.5) continue;
          const Vec3 half = half_line(top);
          FloorSpec floor;
          floor.name = p == 0 ? slab.name : fmt::format("{}.{}", slab.name, p + 1);
          floor.from = place(top.centre - half);
          floor.to = place(top.centre + half);
          floor.load = slab.load * top.area / (2 * norm(half));
          floor.mass = slab.mass * top.area / (2 * norm(half));
          floors.push_back(std::move(floor));
        }
      }
    }
  return floors;
}

std::vector<ContactRule> contacts_of_slabs(const Site& site, const std::vector<BuiltBody>& bodies,
                                           FaultList& faults) {
  std::vector<ContactRule> rules;
  std::set<std::size_t> clash;  // slabs whose material other parts use too
  for (std::size_t k = 0; k < site.spec.slab.size(); ++k) {
    const SlabSpec& slab = site.spec.slab[k];
    for (std::size_t i = 0; i < k; ++i)
      if (site.spec.slab[i].material == slab.material && site.spec.slab[i].joint != slab.joint)
        add_fault(faults, fmt::format("slab.{}.joint", k), "\"" + slab.joint + "\"",
                  "is not that of " + site.spec.slab[i].name + ", which has the same material",
                  "give one of them a material of its own name: joints go by materials");
    if (slab.joint.empty()) continue;
    for (const BuiltBody& other : bodies) {
      const std::string& material = other.body.material;
      if (material == slab.material && other.body.role != "slab" && clash.insert(k).second)
        add_fault(faults, fmt::format("slab.{}.joint", k), "\"" + slab.joint + "\"",
                  "would hold inside the masonry too: " + other.body.id +
                      " has the slab's material, " + material + ", and joints go by materials",
                  "give the slab a material of its own name");
      const auto is_known = [&](const ContactRule& rule) {
        return rule.between == std::vector{slab.material, material};
      };
      if (std::none_of(rules.begin(), rules.end(), is_known))
        rules.push_back({{slab.material, material}, slab.joint});
    }
  }
  return rules;
}

}  // namespace wythe::geometry
