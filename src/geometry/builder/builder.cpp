// Builds the tables in a fixed order: plan walls, slabs, arches, domes (docs/theory/builder.md). Names are checked
// first, since bodies get their names from them. Slabs cut pockets into walls, so they are built only while there is no
// fault.
#include "geometry/builder/builder.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include <fmt/format.h>

#include "geometry/blocks_file.h"
#include "geometry/bodies/polyhedron.h"
#include "geometry/text.h"
#include "geometry/wall/cut_out.h"

namespace wythe::geometry {
namespace {

template <class Table>
void name_all(const std::vector<Table>& tables, const char* key, std::set<std::string>& seen,
              FaultList& faults) {
  for (std::size_t i = 0; i < tables.size(); ++i) {
    const std::string& name = tables[i].name;
    const std::string path = key + ("." + std::to_string(i)) + ".name";
    if (name.empty())
      add_fault(faults, path, "", "is missing: blocks are named after it",
                "write e.g. name = \"front\"");
    else if (name.find_first_of("*. ") != std::string::npos)
      add_fault(faults, path, "\"" + name + "\"", "holds a point, a star or a blank",
                "use letters, digits, - and _; stages select blocks as \"NAME.c03*\"");
    else if (!seen.insert(name).second)
      add_fault(faults, path, "\"" + name + "\"", "another table has this name",
                "give each its own: blocks are named after it");
  }
}

// Refuses two members of one name: --set and a study find a member by name, and would take the first.
template <class Table>
void refuse_same_names(const std::vector<Table>& tables, const std::string& path,
                       FaultList& faults) {
  std::set<std::string> seen;
  for (std::size_t i = 0; i < tables.size(); ++i)
    if (const std::string& name = tables[i].name; !name.empty() && !seen.insert(name).second)
      add_fault(faults, fmt::format("{}.{}.name", path, i), "\"" + name + "\"",
                "another table has this name", "give each its own");
}

}  // namespace

void Site::check_material(const std::string& path, const std::string& name,
                          FaultList& faults) const {
  if (!name.empty()) (void)is_material(Shape(model), path, name, faults);
  const auto found = model.material.find(name);
  const bool weighs = found != model.material.end() && !std::isnan(found->second.density);
  if (weighs || !std::isnan(model.wall.unit.density)) return;
  if (name.empty())
    return (void)is_positive({"wall.unit.density", kUnset, "kg/m^3", "1800 kg/m^3"}, faults);
  add_fault(faults, path, "\"" + name + "\"", "has no density, nor has wall.unit",
            "add [material." + name + "] with its density");
}

std::vector<BuiltBody> build_bodies(const Site& site, std::vector<Message>& notes,
                                    FaultList& faults, std::vector<FrameSpec>* frames) {
  std::set<std::string> names;
  name_all(site.spec.plan_wall, "plan_wall", names, faults);
  name_all(site.spec.slab, "slab", names, faults);
  name_all(site.spec.arch, "arch", names, faults);
  name_all(site.spec.dome, "dome", names, faults);
  std::vector<BuiltBody> bodies;
  const auto take = [&](std::vector<BuiltBody> built) {
    std::move(built.begin(), built.end(), std::back_inserter(bodies));
  };
  for (std::size_t i = 0; i < site.spec.plan_wall.size(); ++i) {
    const PlanWallSpec& wall = site.spec.plan_wall[i];
    const std::string table = "plan_wall." + std::to_string(i);
    for (const auto& [key, name] :
         {std::pair(".material", wall.material), {".core_material", wall.core_material}})
      if (!name.empty()) (void)is_material(Shape(site.model), table + key, name, faults);
    refuse_same_names(wall.opening, table + ".opening", faults);
    refuse_same_names(wall.region, table + ".region", faults);
    for (std::size_t k = 0; k < wall.region.size(); ++k)
      if (!wall.region[k].material.empty())
        (void)is_material(Shape(site.model), fmt::format("{}.region.{}.material", table, k),
                          wall.region[k].material, faults);
    for (std::size_t k = 0; k < wall.opening.size(); ++k) {
      const OpeningSpec& opening = wall.opening[k];
      const std::string path = table + ".opening." + std::to_string(k) + ".cut";
      (void)find_cut_stage(site.model.stage, path, opening.cut, faults);
      if (!opening.cut.empty() && opening.arch.kind != ArchKind::kNone)
        add_fault(faults, path, "\"" + opening.cut + "\"",
                  "an arch cannot be laid into standing masonry",
                  "give the opening a lintel, or leave cut out");
    }
  }
  std::vector<StraightWall> walls;
  if (!site.spec.plan_wall.empty()) take(build_plan_walls(site, walls, notes, faults));
  if (frames != nullptr && faults.empty()) *frames = frames_in_walls(site, walls, faults);
  if (faults.empty()) build_slabs(site, walls, bodies, notes, faults);
  for (std::size_t i = 0; i < site.spec.arch.size(); ++i)
    take(build_arch(site, static_cast<int>(i), faults));
  for (std::size_t i = 0; i < site.spec.dome.size(); ++i)
    take(build_dome(site, static_cast<int>(i), faults));
  return bodies;
}

Polyhedron solid_between(const std::vector<Vec3>& bottom, const std::vector<Vec3>& top) {
  Polyhedron solid;
  const auto n = static_cast<std::int32_t>(bottom.size());
  solid.vertex = bottom;
  solid.vertex.insert(solid.vertex.end(), top.begin(), top.end());
  std::vector<std::int32_t> low, high;
  for (std::int32_t k = 0; k < n; ++k) {
    low.push_back(n - 1 - k);
    high.push_back(n + k);
    solid.face.push_back({k, (k + 1) % n, n + (k + 1) % n, n + k});
  }
  solid.face.push_back(low);
  solid.face.push_back(high);
  if (solid_moments(solid).volume < 0)
    for (std::vector<std::int32_t>& face : solid.face) std::reverse(face.begin(), face.end());
  return solid;
}

int StraightWall::rows() const {
  return storeys.empty() ? 0 : storeys.front().lattice.courses.count;
}

bool StraightWall::goes_through(int e, int row) const { return (row + phase) % 2 == end[e].passes; }

namespace {

// Refuses keys of [wall] that only affect a wall in the plane, or a file.
void refuse_idle_keys(const ModelSpec& spec, FaultList& faults) {
  const WallSpec& wall = spec.wall;
  const auto refuse = [&](const char* path, bool stated, const char* problem, const char* cure) {
    if (stated) faults.add({"", path, "", problem, cure, 0});
  };
  refuse("wall.length", !std::isnan(wall.length),
         "has no meaning here: lines in plan have their own length", "leave it out");
  refuse("wall.blocks", !wall.blocks.empty() && spec.body.empty(),
         "stands beside tables of the builder",
         "keep one of them: a run of the builder's model writes blocks.json, to which blocks can "
         "be added");
  refuse("wall.up", !wall.up.empty() && wall.up != "y" && wall.up != "z", "must be \"y\" or \"z\"",
         "write up = \"z\"");
}

}  // namespace
}  // namespace wythe::geometry

namespace wythe {

void lay_bodies(const BuilderSpec& built, ModelSpec& spec) {
  using namespace geometry;
  FaultList faults;
  refuse_idle_keys(spec, faults);
  std::vector<Message> notes;
  const Site site{built, spec};
  std::vector<FrameSpec> frames;
  std::vector<BuiltBody> bodies = build_bodies(site, notes, faults, &frames);
  faults.throw_if_any();
  std::vector<ContactRule> rules = contacts_of_slabs(site, bodies, faults);
  std::vector<FloorSpec> floors = floors_of_slabs(site, bodies);
  faults.throw_if_any();
  std::move(rules.begin(), rules.end(), std::back_inserter(spec.contact));
  std::move(floors.begin(), floors.end(), std::back_inserter(spec.floor));
  for (BuiltBody& body : bodies) spec.body.push_back(std::move(body.body));
  spec.frame = std::move(frames);
  spec.wall.blocks = "blocks.json";  // in the folder of the run
  if (spec.wall.up.empty()) spec.wall.up = "y";
  spec.built = std::move(notes);
  for (const PlanWallSpec& wall : built.plan_wall) {
    if (wall.ring_beam) continue;
    UnitSpec& unit = spec.built_unit.emplace_back(spec.wall.unit);
    if (!std::isnan(wall.unit.length)) unit.length = wall.unit.length;
    if (!std::isnan(wall.unit.height)) unit.height = wall.unit.height;
  }
}

}  // namespace wythe
