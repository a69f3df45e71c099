// Uses wythe as an installed library: a small wall is built. CMakeLists.txt compiles every public header.
#include <cstdlib>
#include <iostream>

#include "wythe/contact_law.h"
#include "wythe/error.h"
#include "wythe/io.h"
#include "wythe/model.h"
#include "wythe/provenance.h"
#include "wythe/report.h"
#include "wythe/result.h"
#include "wythe/solve.h"
#include "wythe/units.h"
#include "wythe/wall_spec.h"

namespace {

wythe::JointMaterial dry_joint() {
  wythe::JointMaterial joint;
  joint.normal_stiffness = 20e9;
  joint.shear_stiffness = 8e9;
  joint.tensile_strength = 0;
  joint.cohesion = 0;
  joint.friction_angle = 0.5;
  joint.residual_friction_angle = 0.5;
  joint.residual_cohesion = 0;
  joint.mode_1_energy = 1;
  joint.mode_2_energy = 1;
  joint.compressive_strength = wythe::kUnlimited;
  joint.compressive_energy = 1;
  return joint;
}

// Four courses of two units, dry, under their own weight.
wythe::ModelSpec small_wall() {
  wythe::ModelSpec spec;
  spec.name = "consumer";
  spec.wall.length = 0.4;
  spec.wall.height = 0.4;
  spec.wall.thickness = 0.1;
  spec.wall.unit.length = 0.2;
  spec.wall.unit.height = 0.1;
  spec.wall.unit.density = 1800;
  for (const char* name : {"joint", "unit", "foundation"}) spec.material[name] = dry_joint();
  wythe::StageSpec gravity;
  gravity.name = "gravity";
  spec.stage = {gravity};
  return spec;
}

}  // namespace

int main() {
  try {
    const wythe::Model model = wythe::compile(small_wall());
    const wythe::State state = wythe::initial_state(model);
    std::cout << "wythe " << wythe::provenance().version << ": " << model.n_block << " blocks, "
              << model.n_joint << " joints, weight " << model.weight << " N, state "
              << wythe::state_hash(state) << "\n";
    // 0.4 m x 0.4 m x 0.1 m at 1800 kg/m^3 and 9.81 m/s^2: 282.528 N, to round-off
    const double error = model.weight / 282.528 - 1;
    return error < 1e-9 && error > -1e-9 ? EXIT_SUCCESS : EXIT_FAILURE;
  } catch (const wythe::InputError& error) {
    std::cerr << error.what() << "\n";
    return 2;
  }
}
