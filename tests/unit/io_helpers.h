// A valid model, and helpers that change one line of it and return the message about it.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/text.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"

namespace wythe::io_tests {

using Texts = std::vector<std::string>;

// Line numbers below count from the first line of this text.
inline const std::string kModel = R"([wall]
length = "5.10 m"
height = "3.62 m"
thickness = "0.31 m"
bond = "running"
[wall.unit]
length = "310 mm"
height = "110 mm"
density = "1250 kg/m^3"
[[wall.opening]]
name = "door"
x = "1.70 m"
y = "0 m"
width = "1.70 m"
height = "2.64 m"
lintel = { kind = "timber", depth = "110 mm", bearing = "150 mm", material = "timber" }
[material.joint]
normal_stiffness = "20 GPa/m"
shear_stiffness = "8 GPa/m"
tensile_strength = "0.15 MPa"
cohesion = "0.15 MPa"
friction_angle = "16.2 deg"
residual_friction_angle = "14.6 deg"
residual_cohesion = "0 MPa"
mode_1_energy = "4.3 N/m"
mode_2_energy = "125 N/m"
compressive_strength = "3.96 MPa"
compressive_energy = "12800 N/m"
[material.timber]
density = "600 kg/m^3"
[[stage]]
name = "gravity"
[[stage]]
name = "precompression"
pier_load = "200 kN"
[[stage]]
name = "push"
at = { x = "0 m", y = "3.12 m", courses = 3 }
direction = "+x"
velocity = "10 mm/s"
until = "50 mm"
)";

inline std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("no such text in the model: " + from);
  return text.replace(at, from.size(), to);
}

inline Texts faults_of(const std::string& text, const Texts& overrides = {}) {
  Texts out;
  try {
    (void)parse_model(text, "model.toml", overrides);
  } catch (const InputError& error) {
    for (const Fault& fault : error.faults()) out.push_back(to_string(fault));
  }
  return out;
}

// The only fault of the model after one line is changed.
inline std::string fault_of(const std::string& from, const std::string& to) {
  return joined(faults_of(with(kModel, from, to)), "\n");
}

inline std::string fault_of_set(const std::string& override_text) {
  return joined(faults_of(kModel, {override_text}), "\n");
}

class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "wythe_io_XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  std::string write(const std::string& name, const std::string& text) const {
    const std::string path = (path_ / name).string();
    std::ofstream(path) << text;
    return path;
  }

 private:
  std::filesystem::path path_;
};

}  // namespace wythe::io_tests
