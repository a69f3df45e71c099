// Valid model and study files, which refer to the one file with fuzzed content.
#pragma once

#include <string>

namespace wythe::fuzz {

inline const std::string kJoint = R"([material.joint]
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
[[stage]]
name = "gravity"
)";

inline const std::string kWall = R"([wall]
length = "0.4 m"
height = "0.3 m"
thickness = "0.2 m"
bond = "running"
[wall.unit]
length = "200 mm"
height = "100 mm"
density = "2000 kg/m^3"
split = "none"
)" + kJoint;

inline const std::string kMeasured = R"([study]
model = "model.toml"
samples = 4
seed = 1
[variable.ft]
distribution = "empirical"
path = "material.joint.tensile_strength"
file = "measured.csv"
unit = "MPa"
)";

// A wall from the blocks in a file; from solids where `unit` is given.
inline std::string wall_of(const std::string& file, const std::string& more) {
  return "[wall]\nblocks = \"" + file + "\"\n" + more + "[wall.unit]\ndensity = \"2000 kg/m^3\"\n" +
         kJoint;
}

}  // namespace wythe::fuzz
