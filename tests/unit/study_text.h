// A study that uses all keys, and the texts of its faults: study_input_test.cpp, study_faults_test.cpp.
#pragma once

#include <string>

#include "core/text.h"
#include "unit/io_helpers.h"
#include "wythe/parts/io.h"
#include "wythe/parts/study.h"

namespace wythe::io_tests {

// Line numbers below count from the first line of this text; the model is at its end.
inline const std::string kStudy = R"toml([variable.ft_j]
path = "material.joint.tensile_strength"
distribution = "lognormal"
mean = "0.15 MPa"
cov = 0.3
[variable.phi]
path = "material.joint.friction_angle"
distribution = "normal"
mean = "16 deg"
cov = 0.2
lower = "2 deg"
[variable.R]
distribution = "normal"
mean = 0.5
cov = 0.2
[dependent.c]
path = "material.joint.cohesion"
formula = "1.5 * ft_j"
[dependent.GI]
path = "material.joint.mode_1_energy"
formula = "w * ft_j"
[dependent.w]
formula = "0.029 mm + 0 mm * R"
[dependent.phi_res]
path = "material.joint.residual_friction_angle"
formula = "atan(0.9 * tan(phi))"
[[correlation]]
between = ["ft_j", "phi"]
rank = 0.3
[study]
model = "model.toml"
samples = 20
seed = 7
states = ["10 mm", "20 mm"]
read_modes_at = "20 mm"
fractions = [0.8, 0.5]
set = ["wall.unit.split=none"]
)toml" + std::string("model_text = '''\n") +
                                  kModel + "'''\n";

inline StudySpec parsed(const std::string& text, const Texts& overrides = {}) {
  return parse_study(text, "study.toml", overrides);
}

inline Texts study_faults(const std::string& text, const Texts& overrides = {}) {
  Texts out;
  try {
    (void)parsed(text, overrides);
  } catch (const InputError& error) {
    for (const Fault& fault : error.faults()) out.push_back(to_string(fault));
  }
  return out;
}

inline std::string study_fault(const std::string& from, const std::string& to) {
  return joined(study_faults(with(kStudy, from, to)), "\n");
}

inline std::string added(const std::string& tables) {
  return with(kStudy, "[study]\n", tables + "[study]\n");
}

}  // namespace wythe::io_tests
