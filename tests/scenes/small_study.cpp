#include "scenes/small_study.h"

#include <stdlib.h>  // mkdtemp

#include <stdexcept>

#include "wythe/parts/io.h"

namespace wythe::scenes {
namespace {

const std::string kModel = R"([wall]
length = "0.8 m"
height = "0.8 m"
thickness = "0.2 m"
bond = "running"
[wall.unit]
length = "200 mm"
height = "100 mm"
density = "2000 kg/m^3"
[material.joint]
normal_stiffness = "20 GPa/m"
shear_stiffness = "8 GPa/m"
tensile_strength = "0.15 MPa"
cohesion = "0.15 MPa"
friction_angle = "30 deg"
residual_friction_angle = "30 deg"
residual_cohesion = "0 MPa"
mode_1_energy = "4.3 N/m"
mode_2_energy = "125 N/m"
compressive_strength = "4 MPa"
compressive_energy = "12800 N/m"
[material.unit]
normal_stiffness = "20 GPa/m"
shear_stiffness = "8 GPa/m"
tensile_strength = "0.5 MPa"
cohesion = "0.75 MPa"
friction_angle = "38 deg"
residual_friction_angle = "38 deg"
residual_cohesion = "0 MPa"
mode_1_energy = "20 N/m"
mode_2_energy = "550 N/m"
compressive_strength = "4 MPa"
compressive_energy = "12800 N/m"
[[stage]]
name = "gravity"
[[stage]]
name = "push"
at = { x = "0 m", y = "0.75 m" }
direction = "+x"
velocity = "4 mm/s"
damping = 0.2
until = "0.5 mm"
)";

const std::string kUsual = "distribution = \"normal\"\nmean = \"0.15 MPa\"\ncov = 0.2\n";

}  // namespace

StudySpec small_study(int samples, const std::string& distribution) {
  const std::string text =
      "[study]\nname = \"small\"\nmodel = \"small.toml\"\nmodel_text = '''\n" + kModel +
      "'''\nsamples = " + std::to_string(samples) +
      "\nseed = 7\nstates = [\"0.2 mm\", \"0.4 mm\"]\nread_modes_at = \"0.4 mm\"\n"
      "[variable.ft]\npath = \"material.joint.tensile_strength\"\nunit = \"MPa\"\n" +
      (distribution.empty() ? kUsual : distribution) +
      "[dependent.c]\npath = \"material.joint.cohesion\"\nunit = \"MPa\"\nformula = \"1.5 * ft\"\n";
  return parse_study(text, "small_study.toml");
}

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "wythe_XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace wythe::scenes
