#include "scenes/shaken_study.h"

#include <fmt/format.h>

#include "wythe/parts/io.h"

namespace wythe::scenes {
namespace {

constexpr const char* kBlock = R"toml(
name = "a block"
[wall]
length = "0.2 m"
height = "0.8 m"
thickness = "1 m"
unit = { length = "200 mm", height = "800 mm", density = "2000 kg/m^3", split = "none" }
[material.joint]
use = "limestone_dry"
normal_stiffness = "0.2 GPa/m"
shear_stiffness = "0.1 GPa/m"
friction_tan = 0.7
residual_friction_tan = 0.7
compressive_strength = "unlimited"
[[stage]]
name = "gravity"
[[stage]]
name = "quake"
record = { pulse = "half_cycle", amplitude = "1 m/s^2", period = "0.6 s", direction = "+x" }
free_vibration = "2 s"
restitution = 0.3
[[history]]
name = "top"
at = { x = "0.1 m", y = "0.75 m" }
[solve]
point_rule = "corners"
)toml";

}  // namespace

std::string shaken_text(const std::string& shaking, const std::vector<double>& periods, int samples,
                        const std::string& more) {
  std::string text = fmt::format(
      "[study]\nname = \"block\"\nmodel = \"block.toml\"\nsamples = {}\nseed = 5\n"
      "model_text = '''{}'''\n",
      samples, kBlock);
  if (samples > 1)
    text +=
        "[variable.length]\npath = \"wall.length\"\ndistribution = \"normal\"\nmean = \"0.2 m\"\n"
        "cov = 0.06\n[dependent.unit]\npath = \"wall.unit.length\"\nformula = \"length\"\n";
  text += "[shaking]\n" + shaking + "\n";
  for (std::size_t i = 0; i < periods.size(); ++i)
    text += fmt::format(
        "[[record]]\nname = \"pulse of {0:g} s\"\npulse = \"half_cycle\"\n"
        "amplitude = \"1 m/s^2\"\nperiod = \"{0:g} s\"\n",
        periods[i]);
  return text + more;
}

StudySpec shaken_study(const std::string& shaking, const std::vector<double>& periods, int samples,
                       const std::string& more) {
  return parse_study(shaken_text(shaking, periods, samples, more), "shaken.toml");
}

}  // namespace wythe::scenes
