// compile(): spec -> assembly -> flat arrays. Called once a run; throws InputError with all faults.
// A Compiler keeps the assembly and repeats the second step only.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/coarse_units.h"
#include "model/compiler.h"
#include "model/densities.h"
#include "model/field_places.h"
#include "model/fields.h"
#include "model/idle_inputs.h"
#include "model/parts.h"
#include "model/plane/step_bound.h"
#include "model/quadrature.h"
#include "model/shaking.h"
#include "model/size.h"
#include "model/space/space.h"

namespace wythe {
namespace {

using geometry::Assembly;
using geometry::Role;

BlockRole role_of(Role role) {
  switch (role) {
    case Role::kLintel: return BlockRole::kLintel;
    case Role::kRingBeam: return BlockRole::kRingBeam;
    case Role::kSill: return BlockRole::kSill;
    case Role::kPlate: return BlockRole::kPlate;
    case Role::kBeam: return BlockRole::kBeam;
    case Role::kFrame: return BlockRole::kFrame;
    case Role::kMasonry:
    case Role::kSupport: break;
  }
  return BlockRole::kMasonry;
}

// A massless beam needs inertia to move: it gets the density of masonry.
double inertial_density(double density) {
  constexpr double kStandIn = 2000.0;  // [kg/m^3]
  return density > 0 ? density : kStandIn;
}

double height_of(const geometry::Block& block) {
  const auto [low, high] = std::minmax_element(block.outline.begin(), block.outline.end(),
                                               [](auto& a, auto& b) { return a.y < b.y; });
  return high->y - low->y;
}

void copy_report(const Assembly& assembly, Anatomy& anatomy) {
  for (const geometry::Pier& pier : assembly.piers) {
    anatomy.pier_x0.push_back(pier.x0);
    anatomy.pier_x1.push_back(pier.x1);
    anatomy.pier_height.push_back(pier.height);
  }
  for (const geometry::StoreyBand& storey : assembly.storeys) {
    anatomy.storey_name.push_back(storey.name);
    anatomy.storey_top.push_back(storey.top);
  }
  anatomy.length = assembly.length;
  anatomy.height = assembly.height;
  anatomy.thickness = assembly.thickness;
  anatomy.half_unit = assembly.report.half_unit;
  anatomy.course_height = assembly.report.course;
  anatomy.courses = assembly.report.courses;
  anatomy.masonry_blocks_before_lintels = assembly.report.masonry_blocks_before_lintels;
  anatomy.lost_joints = assembly.report.lost_joints;
  anatomy.notes = assembly.report.notes;
}

// Checks before any geometry; a fault of the size is reported alone.
void check_settings(const ModelSpec& spec, FaultList& faults) {
  check_size(spec, faults);
  faults.throw_if_any();
  const SolveSpec& solve = spec.solve;
  const auto fault = [&](const char* path, double value, const char* problem, const char* cure) {
    faults.add({"", path, std::to_string(value), problem, cure, 0});
  };
  check_points(solve, faults);
  if (!(solve.step_fraction > 0 && solve.step_fraction <= 1))
    fault("solve.step_fraction", solve.step_fraction, "must be more than 0 and up to 1",
          "write step_fraction = 0.95");
  if (!(solve.gravity >= 0))
    fault("solve.gravity", solve.gravity, "must not be negative", "write gravity = \"9.81 m/s^2\"");
}

}  // namespace

BlockMap compile_blocks(const ModelSpec& spec, const Assembly& assembly, const FieldValues& fields,
                        Model& model, FaultList& faults) {
  const geometry::Shape shape(spec);
  BlockMap map;
  Anatomy& anatomy = model.anatomy;
  anatomy.support_begin.push_back(0);
  anatomy.outline_begin.push_back(0);
  constexpr double kNone = std::numeric_limits<double>::infinity();
  double smallest = kNone, smallest_of_all = kNone;  // heights of masonry, of whatever moves
  int bodies = 0;
  for (const geometry::Block& block : assembly.blocks) {
    if (block.role == Role::kSupport) {
      map.push_back(kGroundBlock);
      for (const Vec2& v : block.outline) {
        anatomy.support_x.push_back(v.x);
        anatomy.support_y.push_back(v.y);
      }
      anatomy.support_begin.push_back(static_cast<int>(anatomy.support_x.size()));
      continue;
    }
    if (block.zone.zones > 0) {
      map.push_back(solid_id(bodies++));
      continue;
    }
    map.push_back(model.n_block++);
    const geometry::PolygonMoments moments = geometry::moments(block.outline);
    const double density =
        fields.density_of(static_cast<int>(map.size()) - 1, geometry::density_of(shape, block));
    if (!(density >= 0))
      faults.add({"", "wall.blocks." + block.id, fmt::format("{:g} kg/m^3", density),
                  "has a density below 0, drawn from its field",
                  "write a smaller cov, lower = 0.1, or a lognormal field", 0});
    const double mass = inertial_density(density) * moments.area * block.thickness;
    const bool weighs = block.role != Role::kPlate && density > 0;
    model.mass.push_back(mass);
    model.gravity_mass.push_back(weighs ? mass : 0.0);
    model.inertia.push_back(mass * moments.polar / moments.area);
    const bool held = block.role == Role::kBeam && spec.wall.beam.rotation == Freedom::kBlocked;
    model.turn_freedom.push_back(held ? 0.0 : 1.0);
    model.centroid_x.push_back(moments.centroid.x);
    model.centroid_y.push_back(moments.centroid.y);
    anatomy.block_id.push_back(block.id);
    anatomy.block_role.push_back(block.cut_from >= 0 ? BlockRole::kCutOut : role_of(block.role));
    anatomy.block_course.push_back(block.course);
    anatomy.block_thickness.push_back(block.thickness);
    for (const Vec2& v : block.outline) {
      anatomy.outline_x.push_back(v.x);
      anatomy.outline_y.push_back(v.y);
    }
    anatomy.outline_begin.push_back(static_cast<int>(anatomy.outline_x.size()));
    smallest_of_all = std::min(smallest_of_all, height_of(block));
    if (block.role == Role::kMasonry) smallest = std::min(smallest, height_of(block));
  }
  if (std::isnan(model.solve.collapse_displacement))
    model.solve.collapse_displacement = spec.solve.contacts == Contacts::kFree ? kNone
                                        : std::isfinite(smallest)              ? smallest
                                                                               : smallest_of_all;
  return map;
}

namespace {

// Notes records whose samples are too far apart for this wall.
void note_coarse_records(Model& model) {
  constexpr double kFewest = 5;  // samples in a period
  for (const Stage& stage : model.stages)
    for (const GroundMotion& motion : stage.base) {
      const double step = motion.duration() / static_cast<double>(motion.time.size() - 1);
      const double period = first_period(model, motion.along.x, motion.along.y);
      if (!(step * kFewest > period) || motion.time.size() < 3) continue;
      model.anatomy.notes.push_back({"shake.coarse",
                                     {{"stage", stage.spec.name},
                                      {"record", motion.source},
                                      {"step_ms", 1e3 * step},
                                      {"period_ms", 1e3 * period}}});
    }
}

Assembly build(const ModelSpec& spec) {
  FaultList faults;
  check_settings(spec, faults);
  Assembly assembly = geometry::build_assembly(spec, faults);
  faults.throw_if_any();
  return assembly;
}

// Fills the model from a spec with sound settings and a complete assembly.
Model fill(const ModelSpec& spec, const Assembly& assembly) {
  FaultList faults;
  Model model;
  model.solve = spec.solve;
  model.output = spec.output;
  copy_report(assembly, model.anatomy);
  compile_solids(spec, assembly, model, faults);
  faults.throw_if_any();
  const FieldValues fields(spec, assembly, faults);
  faults.throw_if_any();
  const BlockMap map = compile_blocks(spec, assembly, fields, model, faults);
  if (model.n_block == 0 && !model.solids.bodies.empty())
    faults.add({"", "wall.blocks", "", "every moving block is cut into zones",
                "leave at least one rigid block: loads and pushes act on those", 0});
  faults.throw_if_any();
  compile_joints(spec, assembly, map, fields, model, faults);
  compile_free(spec, assembly, model, faults);
  const std::vector<double> bare = model.mass;
  const std::vector<PointLoad> floors = compile_floors(spec, assembly, map, model, faults);
  compile_links(spec, assembly, map, model, faults);
  compile_frames(spec, assembly, map, model, faults);
  compile_layers(spec, assembly, map, model, faults);
  compile_standing(spec, assembly, map, model, faults);
  compile_stages(spec, assembly, map, floors, model, faults);
  check_standing(model, faults);
  faults.throw_if_any();
  carry_floors(bare, model);
  fields.describe(spec, assembly, map, model);
  bound_step(model);
  set_dashpots(model);
  note_coarse_records(model);
  note_storeys_without_top(model);
  note_idle_inputs(spec, model);
  note_densities(spec, model);
  note_coarse_units(spec, model);
  set_push_ramps(model);
  for (std::size_t i = 0; i < model.gravity_mass.size(); ++i)  // cut-out masonry has no weight
    if (model.anatomy.block_role[i] != BlockRole::kCutOut)
      model.weight += model.gravity_mass[i] * model.solve.gravity;
  for (const double mass : model.solids.node_gravity_mass)
    model.weight += mass * model.solve.gravity;
  model.topology = topology_of(model);
  return model;
}

}  // namespace

[[nodiscard]] static geometry::SpaceAssembly build_in_space(const ModelSpec& spec) {
  FaultList faults;
  geometry::SpaceAssembly assembly = assemble_space(spec, faults);
  faults.throw_if_any();
  return assembly;
}

namespace {

// Takes over the notes of reading. A note that "1.800 kg/m^3" is unusual goes where a note of reading names the cause.
Model with_text_notes(const ModelSpec& spec, Model model) {
  std::vector<Message>& notes = model.anatomy.notes;
  for (const Message& note : spec.text_notes) {
    std::erase_if(notes, [&](const Message& other) {
      return (other.code == "value.odd" || other.code == "density.odd") &&
             other.arguments.front() == note.arguments.front();
    });
    notes.push_back(note);
  }
  return model;
}

// Does the work; its faults get the places of their keys, where the spec was read from a file.
template <class Work>
auto placing_faults(const ModelSpec& spec, const Work& work) {
  try {
    return work();
  } catch (const InputError& error) {
    if (spec.places == nullptr) throw;
    throw InputError(spec.places->placed(error.faults()));
  }
}

}  // namespace

Model compile(const ModelSpec& spec) {
  return placing_faults(spec, [&] {
    return with_text_notes(spec, spec.body.empty() ? fill(spec, build(spec))
                                                   : compile_space(spec, build_in_space(spec)));
  });
}

Compiler::Compiler(const ModelSpec& spec) : shape_(geometry::shape_key(spec)) {
  placing_faults(spec, [&] {
    if (spec.body.empty())
      assembly_ = build(spec);
    else
      in_space_ = build_in_space(spec);
  });
}

Model Compiler::compile(const ModelSpec& spec) const {
  if (geometry::shape_key(spec) != shape_) return wythe::compile(spec);
  return placing_faults(spec, [&] {
    if (!spec.body.empty()) return with_text_notes(spec, compile_space(spec, in_space_));
    FaultList faults;
    check_settings(spec, faults);
    faults.throw_if_any();
    return with_text_notes(spec, fill(spec, assembly_));
  });
}

}  // namespace wythe
