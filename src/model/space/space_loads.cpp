// Loads at points and along lines in space; floors are lines of load (docs/theory/space.md, "Loads").
//
//        from o-----------------o to         each face below, directed against the load, carries its part of
//      +----+--|--+----+----+---|+           the line at the middle of that part. The distance of the line from
//      |    |     |    |    |    |           the middle of the wall is the eccentricity of the load
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "geometry/bodies/polyhedron.h"
#include "model/parts.h"
#include "model/space/space_places.h"

namespace wythe {
namespace {

using geometry::Facet;
using geometry::SpaceAssembly;

constexpr double kReachOfLoad = 0.01;  // distance of a line from the face that carries it [m]
constexpr double kFewMicrons = 5e-6;   // a gap due to rounded input [m]

struct Stretch {
  std::size_t body;
  double from, to;
};

// The part of a line over a face, from 0 to its length; `away`: largest distance from the face's plane.
struct Over {
  double from, to, away;
};
Over over(const Facet& face, Vec3 start, Vec3 along, double length) {
  Over o{0, length, 0};
  for (std::size_t k = 0; k < face.corner.size(); ++k) {
    const Vec3 side = face.corner[(k + 1) % face.corner.size()] - face.corner[k];
    const Vec3 in = geometry::unit(cross(face.normal, side));
    const double d0 = dot(start - face.corner[k], in), rate = dot(along, in);
    if (std::fabs(rate) < 1e-9) {
      if (d0 < -kFewMicrons) return {0, 0, 0};
    } else if (rate > 0) {
      o.from = std::fmax(o.from, -d0 / rate);
    } else {
      o.to = std::fmin(o.to, -d0 / rate);
    }
  }
  for (const double t : {o.from, o.to})
    o.away = std::fmax(o.away, std::fabs(dot(start + t * along - face.centre, face.normal)));
  return o;
}

class LineUnder {
 public:
  LineUnder(const SpaceAssembly& assembly, Vec3 from, Vec3 to, Vec3 load)
      : start_(from), length_(length(to - from)), along_((to - from) / length_) {
    for (std::size_t k = 0; k < assembly.body.size(); ++k)
      if (!assembly.body[k].fixed) look(assembly.body[k], k, load);
  }

  [[nodiscard]] double length_of_line() const { return length_; }
  [[nodiscard]] double nearest() const { return nearest_; }

  // Bodies below the line at t, each once.
  [[nodiscard]] std::vector<std::size_t> under(double t) const {
    std::vector<std::size_t> bodies;
    for (const Stretch& s : stretch_)
      if (t >= s.from - kFewMicrons && t <= s.to + kFewMicrons &&
          std::find(bodies.begin(), bodies.end(), s.body) == bodies.end())
        bodies.push_back(s.body);
    return bodies;
  }

  // Places at which the bodies below the line change.
  [[nodiscard]] std::vector<double> cuts() const {
    std::vector<double> at{0, length_}, out;
    for (const Stretch& s : stretch_) at.push_back(s.from), at.push_back(s.to);
    std::sort(at.begin(), at.end());
    for (const double t : at)
      if (out.empty() || t - out.back() > kFewMicrons) out.push_back(t);
    out.back() = length_;
    return out;
  }

 private:
  void look(const BodySpec& body, std::size_t k, Vec3 load) {
    for (const Polyhedron& part : body.part)
      for (const auto& corners : part.face) {
        const Facet face = geometry::facet_of(part, corners);
        if (-dot(face.normal, load) < kFacing) continue;
        const Over o = over(face, start_, along_, length_);
        if (o.to - o.from <= kFewMicrons) continue;
        nearest_ = std::fmin(nearest_, o.away);
        if (o.away <= kReachOfLoad) stretch_.push_back({k, o.from, o.to});
      }
  }

  Vec3 start_;
  double length_;
  Vec3 along_;
  double nearest_ = 1e300;
  std::vector<Stretch> stretch_;
};

std::string metres(Vec3 p) { return fmt::format("({:g}, {:g}, {:g}) m", p.x, p.y, p.z); }

struct Line {
  Vec3 from, to;
};
// The two ends of a line; adds a fault where one is missing.
std::optional<Line> line_of(const PlaceSpec& from, const PlaceSpec& to, const SpacePlaces& places,
                            const std::string& path, FaultList& faults) {
  const std::optional<Vec3> a = places.point_of(from), b = places.point_of(to);
  for (const auto& [end, key] : {std::pair(a, ".from"), {b, ".to"}})
    if (!end)
      faults.add({"", path + key, "", "must be a point with all three coordinates",
                  fmt::format("write e.g. {} = {{ x = \"0 m\", y = \"2.7 m\", z = \"0 m\" }}",
                              std::string(key).substr(1)),
                  0});
  if (!a || !b) return std::nullopt;
  if (length(*b - *a) < kReachOfLoad) {
    faults.add({"", path + ".to", metres(places.in_file(*b)), "is where the line begins",
                "write two places apart from each other", 0});
    return std::nullopt;
  }
  return Line{*a, *b};
}

// Unit vector of a load: `along`, or downwards.
std::optional<Vec3> direction_of(const LoadStage& s, const SpacePlaces& places) {
  if (s.along.empty()) return Vec3{0, -1, 0};
  if (s.along.size() != 3) return std::nullopt;  // reported with the stage
  const Vec3 d = geometry::unit({s.along[0], s.along[1], s.along[2]});
  return dot(d, d) > 0 ? std::optional(places.in_wall(d)) : std::nullopt;
}

PointLoad load_at(BlockId block, Vec3 where, Vec3 centroid, Vec3 force) {
  const Vec3 arm = where - centroid;
  return {block, arm.x, arm.y, force.x, force.y, arm.z, force.z};
}

}  // namespace

std::vector<LinePiece> pieces_under(const SpaceAssembly& assembly, Vec3 from, Vec3 to, Vec3 load,
                                    const std::string& path, FaultList& faults) {
  const LineUnder line(assembly, from, to, load);
  const std::vector<double> cuts = line.cuts();
  std::vector<LinePiece> pieces;
  for (std::size_t k = 1; k < cuts.size(); ++k) {
    const std::vector<std::size_t> bodies = line.under(0.5 * (cuts[k - 1] + cuts[k]));
    if (bodies.empty()) {
      const bool near = line.nearest() < 1e299;
      faults.add(
          {"", path, "",
           fmt::format("lies on nothing from {:.3f} to {:.3f} m along its line: an opening is "
                       "there, or no face looks against the load there{}",
                       cuts[k - 1], cuts[k],
                       near && line.nearest() > kReachOfLoad
                           ? fmt::format("; the nearest is {:.3f} m off", line.nearest())
                           : ""),
           "end it beside the gap, write two, or move the line onto the faces (within 10 mm)", 0});
      return {};
    }
    for (const std::size_t body : bodies)
      pieces.push_back({body, cuts[k - 1], cuts[k], 1.0 / static_cast<double>(bodies.size())});
  }
  return pieces;
}

std::vector<PointLoad> stated_loads(const LoadStage& s, const SpacePlaces& places,
                                    const SpaceAssembly& assembly, const std::vector<BlockId>& id,
                                    const std::string& path, FaultList& faults) {
  const std::optional<Vec3> d = direction_of(s, places);
  if (!d) return {};
  const auto centroid = [&](std::size_t k) { return assembly.moments[k].centroid; };
  std::vector<PointLoad> loads;
  if (std::isfinite(s.line_load)) {
    const std::optional<Line> line = line_of(s.from, s.to, places, path, faults);
    if (!line) return {};
    const Vec3 along = geometry::unit(line->to - line->from);
    for (const LinePiece& p : pieces_under(assembly, line->from, line->to, *d, path, faults))
      loads.push_back(load_at(id[p.body], line->from + 0.5 * (p.from + p.to) * along,
                              centroid(p.body), s.line_load * (p.to - p.from) * p.share * *d));
    return loads;
  }
  const auto fault = [&](std::string value, std::string problem, std::string cure) {
    faults.add({"", path + ".at", std::move(value), std::move(problem), std::move(cure), 0});
  };
  const std::optional<Vec3> point = places.point_of(s.at);
  std::optional<std::size_t> body;
  if (point && s.at.block.empty()) {
    body = places.body_at(*point, false);
    if (!body)
      fault(metres(places.in_file(*point)), "lies on no block that moves, and a force needs one",
            "move it onto a block (within 10 mm)");
  } else {
    const std::vector<std::size_t> found =
        s.at.block.empty() ? std::vector<std::size_t>{} : places.find(s.at);
    if (found.size() == 1 && !assembly.body[found.front()].fixed) {
      body = found.front();
    } else {
      fault(s.at.block, "must be one point of a block, or one block that moves",
            "write e.g. at = { x = \"1 m\", y = \"2.7 m\", z = \"0 m\" }; for many blocks write a "
            "pressure or a line_load");
    }
  }
  if (!body) return {};
  const Vec3 where = point && s.at.block.empty() ? *point : centroid(*body);
  return {load_at(id[*body], where, centroid(*body), s.force * *d)};
}

namespace {

class SpaceFloors {
 public:
  SpaceFloors(const ModelSpec& spec, const SpaceAssembly& assembly, const std::vector<BlockId>& id,
              Model& model, FaultList& faults)
      : spec_(spec),
        assembly_(assembly),
        id_(id),
        model_(model),
        faults_(faults),
        places_(spec, assembly) {}

  std::vector<PointLoad> run() {
    for (std::size_t k = 0; k < spec_.floor.size(); ++k) {
      path_ = fmt::format("floor.{}", k);
      const FloorSpec& f = spec_.floor[k];
      const std::size_t before = faults_.all().size();
      refuse_plane_keys(f);
      const std::optional<Line> line = line_of(f.from, f.to, places_, path_, faults_);
      if (!(f.load > 0) && !(f.mass > 0))
        fault("", "", "does nothing to the wall", "write e.g. load = \"12 kN/m\"");
      if (line && faults_.all().size() == before) lay(f, *line);
    }
    return std::move(loads_);
  }

 private:
  void fault(const std::string& key, std::string value, std::string problem, std::string cure) {
    faults_.add({"", path_ + key, std::move(value), std::move(problem), std::move(cure), 0});
  }

  void refuse_plane_keys(const FloorSpec& f) {
    const auto refuse = [&](const char* key, bool is_there, const char* cure) {
      if (is_there) fault(key, "", "is for walls in their plane; this one is in space", cure);
    };
    const char* line = "write from and to, the ends of the line that the floor lies on";
    refuse(".storey", !f.storey.empty(), line);
    refuse(".y", std::isfinite(f.y), line);
    refuse(".x", std::isfinite(f.x), line);
    refuse(".width", std::isfinite(f.width), line);
    refuse(".bearing", std::isfinite(f.bearing),
           "leave it out: in space the line itself says how far from the wall's middle the floor "
           "bears");
    refuse(".thrust", f.thrust != 0, "write a load stage with line_load and along");
  }

  void lay(const FloorSpec& f, const Line& line) {
    const double long_ = length(line.to - line.from);
    const double load = f.load > 0 ? f.load * long_ : 0.0, mass = f.mass * long_;
    if (f.joists.empty()) {
      for (const LinePiece& p :
           pieces_under(assembly_, line.from, line.to, {0, -1, 0}, path_, faults_))
        put(p.body, 0.5 * (p.from + p.to), (p.to - p.from) / long_ * p.share, line, load, mass);
    } else {
      lay_joists(f, line, load, mass);
    }
    const std::string name = f.name.empty() ? path_.substr(path_.find('.') + 1) : f.name;
    model_.anatomy.notes.push_back(
        {"floor.lies_in_space", {{"floor", name}, {"length_m", long_}, {"load_kN", 1e-3 * load}}});
    if (mass > 0)
      model_.anatomy.notes.push_back({"floor.inertia", {{"floor", name}, {"mass_kg", mass}}});
  }

  // Adds joists; one over a head joint lies on both blocks.
  void lay_joists(const FloorSpec& f, const Line& line, double load, double mass) {
    const LineUnder under(assembly_, line.from, line.to, {0, -1, 0});
    const auto n = static_cast<double>(f.joists.size());
    for (std::size_t k = 0; k < f.joists.size(); ++k) {
      const double t = f.joists[k];
      const std::vector<std::size_t> bodies = under.under(t);
      const std::string key = fmt::format(".joists.{}", k);
      if (std::count_if(f.joists.begin(), f.joists.begin() + static_cast<std::ptrdiff_t>(k),
                        [&](double other) { return std::fabs(other - t) < 1e-3; }) > 0)
        fault(key, fmt::format("{:g} m", t), "lies where another joist lies already",
              "list each joist once; one that carries more is a [[floor]] of its own");
      if (bodies.empty())
        fault(key, fmt::format("{:g} m", t),
              t > under.length_of_line() ? "lies beyond the end of the line" : "lies on nothing",
              "write a distance from `from` at which a block ends at the line's height");
      for (const std::size_t body : bodies)
        put(body, t, 1 / (n * static_cast<double>(bodies.size())), line, load, mass);
    }
  }

  void put(std::size_t body, double t, double share, const Line& line, double load, double mass) {
    const Vec3 where = line.from + t * geometry::unit(line.to - line.from);
    if (is_solid(id_[body]))
      return fault("", assembly_.body[body].id,
                   "would lie on a block of zones; loads act on rigid blocks",
                   "end the floor beside it, or leave the block's zones out");
    if (const std::string& stage = assembly_.body[body].cut; !stage.empty())
      return fault("", assembly_.body[body].id,
                   fmt::format("lies {:.3f} m along its line on masonry that stage \"{}\" cuts out",
                               t, stage),
                   "make the opening lower, so that a course over its lintel or frame carries the "
                   "floor, or end the line beside it");
    if (load > 0)
      loads_.push_back(
          load_at(id_[body], where, assembly_.moments[body].centroid, {0, -share * load, 0}));
    model_.mass[id_[body]] += share * mass;
  }

  const ModelSpec& spec_;
  const SpaceAssembly& assembly_;
  const std::vector<BlockId>& id_;
  Model& model_;
  FaultList& faults_;
  SpacePlaces places_;
  std::string path_;
  std::vector<PointLoad> loads_;
};

}  // namespace

std::vector<PointLoad> compile_space_floors(const ModelSpec& spec, const SpaceAssembly& assembly,
                                            const std::vector<BlockId>& id, Model& model,
                                            FaultList& faults) {
  return SpaceFloors(spec, assembly, id, model, faults).run();
}

}  // namespace wythe
