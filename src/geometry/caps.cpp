// Puts plates on the piers, or one beam over the length, on the bounding box of the masonry. A plate is half a course
// high, or a twentieth of the wall where a blocks file has no courses. A wall has plates or a beam, not both.
#include "geometry/caps.h"

#include <algorithm>
#include <cmath>

#include "geometry/text.h"

namespace wythe::geometry {
namespace {

// Height of plates: half a course, or a twentieth of the wall's height in a blocks file [m].
double plate_height(const Assembly& assembly) {
  return assembly.report.course > 0 ? assembly.report.course / 2 : assembly.height / 20;
}

Block cap(const std::string& id, const Rect& body, Role role, double thickness) {
  Block block;
  block.id = id;
  block.outline = outline_of(body);
  block.material = role == Role::kBeam ? "beam" : "plate";
  block.thickness = thickness;
  block.role = role;
  return block;
}

void add_plates(const Rect& extent, Assembly& assembly) {
  const double top = extent.y1 + plate_height(assembly);
  for (std::size_t i = 0; i < assembly.piers.size(); ++i) {
    const Pier& pier = assembly.piers[i];
    Block plate = cap("plate" + std::to_string(i), {pier.x0, extent.y1, pier.x1, top}, Role::kPlate,
                      assembly.top_thickness);
    assembly.blocks.push_back(plate);
  }
}

void add_beam(const BeamSpec& beam, const Rect& extent, Assembly& assembly, FaultList& faults) {
  bool given = is_positive({"wall.beam.height", beam.height, "m", "0.20 m"}, faults);
  given &= is_not_negative({"wall.beam.density", beam.density, "kg/m^3", "2500 kg/m^3"}, faults);
  if (!given) return;
  Block block = cap("beam", {extent.x0, extent.y1, extent.x1, extent.y1 + beam.height}, Role::kBeam,
                    assembly.top_thickness);
  assembly.blocks.push_back(block);
}

void refuse_two_joints(const Shape& shape, FaultList& faults) {
  const std::string first = plate_joint(shape);
  for (const PlateStage& stage : shape.plates) {
    if (stage.joint == first) continue;
    add_fault(faults, "stage." + stage.name + ".plate_joint", "\"" + stage.joint + "\"",
              "the plates lie on one joint, and an earlier stage names \"" + first + "\"",
              "name the same joint material in every stage");
  }
}

void refuse_clashes(const Shape& shape, const Assembly& assembly, FaultList& faults) {
  const bool has_file_beam = std::any_of(assembly.blocks.begin(), assembly.blocks.end(),
                                         [](const Block& b) { return b.role == Role::kBeam; });
  const bool has_beam = std::isfinite(shape.wall.beam.height);
  if (!shape.plates.empty() && (has_beam || has_file_beam)) {
    add_fault(faults, "stage." + shape.plates.front().name + ".as", "\"plate\"",
              "plates and a beam can't both lie on the wall's top",
              "leave out [wall.beam], or write as = \"pressure\"");
  }
  if (!shape.plates.empty() && assembly.piers.empty()) {
    add_fault(faults, "stage." + shape.plates.front().name + ".pier_load", "",
              "the openings leave no pier to load", "load the wall's top: pressure = ...");
  }
  if (has_beam && has_file_beam) {
    add_fault(faults, "wall.beam.height", metres(shape.wall.beam.height),
              "the blocks file already has a beam", "leave out [wall.beam]");
  }
}

}  // namespace

std::string plate_joint(const Shape& shape) {
  return shape.plates.empty() ? "" : shape.plates.front().joint;
}

void add_caps(const Shape& shape, const Rect& extent, Assembly& assembly, FaultList& faults) {
  const std::size_t before = faults.all().size();
  refuse_clashes(shape, assembly, faults);
  refuse_two_joints(shape, faults);
  if (faults.all().size() > before) return;
  if (!shape.plates.empty()) add_plates(extent, assembly);
  if (!std::isnan(shape.wall.beam.height)) add_beam(shape.wall.beam, extent, assembly, faults);
}

}  // namespace wythe::geometry
