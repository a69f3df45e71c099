// read(write(spec)) = spec, to the bit, for specs with every member drawn at random.
//
// The generator is a visitor of the description, so a new key is drawn without a line here.
// Values are drawn within the key's range. Half of them are decimal numbers as people write
// them, half have random bits. Optional members are sometimes unset. Conditions between keys
// (kinds of stages, one load in each stage, a law without snap-back) are restored afterwards.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "io/keys/same_spec.h"
#include "io/text/magnitude.h"
#include "model/protocol.h"
#include "wythe/parts/io.h"
#include "wythe/parts/units.h"

namespace wythe::io::spec_roundtrip_test {
namespace {

// Fixed unless the environment asks for another.
[[maybe_unused]] const int kSeeded = setenv("RC_PARAMS", "seed=20240229", 0);

bool coin(int one_in) { return *rc::gen::inRange(0, one_in) == 0; }

double any_bits() {
  const double mantissa =
      1 + static_cast<double>(*rc::gen::inRange<std::int64_t>(0, 1LL << 52)) * 0x1p-52;
  return std::ldexp(coin(4) ? -mantissa : mantissa, *rc::gen::inRange(-60, 60));
}

double decimal(const Key& key) {
  const int number = *rc::gen::inRange(-1000, 100000);
  const std::string text = fmt::format("{}.{}", number, *rc::gen::inRange(0, 1000));
  return *key.unit ? parse_quantity(text + " " + key.shown, key.unit) : std::stod(text);
}

double within(const Key& key) {
  const Magnitude m = magnitude_of(*key.unit ? key.unit : "1");
  const double drawn = coin(2) ? decimal(key) : any_bits();
  const double value =
      drawn == 0 ? 0 : std::copysign(std::clamp(std::fabs(drawn), m.least, m.most), drawn);
  if (key.range.holds(value)) return value;
  if (key.range.holds(-value)) return -value;
  // Fold into a finite range, both ends left out.
  const double share = 0.5 + std::atan(value) / 3.2;
  const double high = std::isfinite(key.range.high) ? key.range.high : key.range.low + 10;
  return key.range.low + (high - key.range.low) * share;
}

std::string any_text() {
  static const std::string kPieces[] = {"a",  "Z",  "7", " ", "\"", "\\",   "\n",
                                        "\t", "\r", "#", "=", "é",  "\x01", "\x7f",
                                        "'",  "[",  "]", ".", "{",  "µ",    "\\u0041"};
  std::string out;
  for (int i = *rc::gen::inRange(1, 9); i > 0; --i)
    out += kPieces[*rc::gen::inRange<std::size_t>(0, std::size(kPieces))];
  return out;
}

class Draw {
 public:
  void quantity(const char*, double& value, const Key& key) {
    if (foreign(key) || (std::isnan(value) && coin(3))) return;
    value = key.may_be_unlimited && coin(4) ? kUnlimited : within(key);
  }
  void number(const char*, double& value, const Key& key) {
    if (!foreign(key) && (!std::isnan(value) || !coin(3))) value = within(key);
  }
  void quantities(const char*, std::vector<double>& values, const Key& key) {
    for (int i = foreign(key) ? 0 : *rc::gen::inRange(0, 4); i > 0; --i)
      values.push_back(within(key));
  }
  void numbers(const char* name, std::vector<double>& values, const Key& key) {
    quantities(name, values, key);
  }
  void points(const char*, std::vector<std::array<double, 2>>& points, const Key& key) {
    for (int i = *rc::gen::inRange(0, 4); i > 0; --i) points.push_back({within(key), within(key)});
  }
  void integer(const char*, int& value, const Key& key) {
    const int low = static_cast<int>(key.range.low);
    const double most = std::min(key.range.high, low + 14.0);
    value = *rc::gen::inRange(low, static_cast<int>(most) + 1);
  }
  void flag(const char*, bool& value, const Key& key) {
    if (!foreign(key)) value = coin(2);
  }
  void text(const char*, std::string& value, const Key& key) {
    if (!foreign(key) && coin(2)) value = any_text();
  }
  void texts(const char*, std::vector<std::string>& values, const Key& key) {
    for (int i = 0; i < key.count; ++i) values.push_back(any_text());
  }
  template <class E, std::size_t N>
  void choice(const char*, E& value, const Word<E> (&words)[N], const Key& key) {
    if (!foreign(key)) value = words[*rc::gen::inRange<std::size_t>(0, N)].value;
    if constexpr (std::is_same_v<E, StageKind>) kind_ = kind_bit(value);
  }
  template <class T>
  void table(const char*, T& value, const Key& key) {
    if (!foreign(key) && (!key.optional || !coin(3))) describe(*this, value);
    if constexpr (std::is_same_v<T, PlaceSpec>)
      if (!value.role.empty()) value.role = "slab";  // it must be a word of BlockRole
  }
  template <class T>
  void list(const char*, std::vector<T>& values, const Key& key) {
    for (int i = foreign(key) ? 0 : *rc::gen::inRange(0, 4); i > 0; --i)
      describe(*this, values.emplace_back());
  }
  template <class T>
  void map(const char*, std::map<std::string, T>& values, const Key&) {
    for (int i = *rc::gen::inRange(0, 3); i > 0; --i) describe(*this, values[any_text()]);
  }

 private:
  // A stage holds the keys of its own kind; the others keep their defaults.
  [[nodiscard]] bool foreign(const Key& key) const {
    return key.kinds != 0 && !(key.kinds & kind_);
  }

  Kinds kind_ = 0;
};

void set_if_unset(double& value, double otherwise) {
  if (std::isnan(value)) value = otherwise;
}

void make_one_load(LoadStage& stage) {
  const double load = std::clamp(std::abs(any_bits()), 1e-3, 1e12);
  PlaceSpec point, far;
  point.x = -0.0, point.y = 0.7, point.z = 1.0 / 3;
  far.x = 1.0 / 3, far.y = 0.7, far.z = -0.0;
  stage.pier_load = stage.pressure = stage.beam_load = stage.force = stage.line_load = kUnset;
  stage.at = stage.from = stage.to = {};
  stage.along.clear();
  if (stage.floors) {
    stage.as = Manner::kDefault;
    return;
  }
  double* const loads[] = {&stage.pier_load, &stage.pressure, &stage.beam_load, &stage.force,
                           &stage.line_load};
  const std::size_t which = *rc::gen::inRange<std::size_t>(0, 5);
  *loads[which] = load;
  if (which > 2) {
    stage.as = Manner::kDefault, stage.on = {}, stage.face.clear();
    if (coin(2)) stage.along = {1.0 / 3, -0.0, 1};
  }
  if (which == 3) stage.at = point;
  if (which == 4) stage.from = point, stage.to = far;
  if (stage.as != Manner::kDefault)
    stage.as = which == 0 && coin(2) ? Manner::kPlate : Manner::kPressure;
}

void make_place(PlaceSpec& at) {
  const int courses = at.courses;
  const double width = std::isnan(at.width) ? 1.0 / 3 : at.width;
  const double x = std::isnan(at.x) ? -0.0 : at.x, y = std::isnan(at.y) ? 0.7 : at.y;
  at = PlaceSpec{};
  at.courses = courses;
  switch (*rc::gen::inRange(0, 4)) {
    case 0: at.beam = true; break;
    case 1: at.block = any_text(); break;
    case 2: at.width = width, at.height = width; [[fallthrough]];
    default: at.x = x, at.y = y;
  }
}

void make_pattern(PushStage& stage) {
  const std::vector<double> levels = stage.levels;
  stage.levels.clear(), stage.shares.clear();
  stage.control = {};
  if (stage.pattern == Pattern::kNone || coin(2)) {
    stage.pattern = Pattern::kNone;
    return make_place(stage.at);
  }
  stage.at = {};
  if (!goes_to_and_fro(stage) && coin(2)) stage.control.x = -0.0, stage.control.y = 1.0 / 3;
  if (stage.pattern == Pattern::kMass || stage.pattern == Pattern::kArea) return;
  stage.levels = levels.empty() ? std::vector<double>{1.0 / 3} : levels;
  if (stage.pattern == Pattern::kGiven) stage.shares.assign(stage.levels.size(), -0.0);
}

// Levels that grow, by one of their keys, with cycles for all or for each.
void make_protocol(PushStage& stage) {
  stage.amplitudes.clear(), stage.drifts.clear(), stage.cycles.clear();
  if (!stage.targets.empty() || coin(2)) return;
  (coin(2) ? stage.drifts : stage.amplitudes) = {0.001, 1.0 / 3};
  if (coin(2)) stage.cycles.assign(coin(2) ? 1 : 2, 3);
}

// A target that is reached before it is driven to is refused.
void make_targets(std::vector<double>& targets) {
  if (!targets.empty() && targets.front() == 0) targets.front() = 1.0 / 3;
  targets.erase(std::unique(targets.begin(), targets.end()), targets.end());
}

void make_push(PushStage& stage) {
  make_targets(stage.targets);
  make_protocol(stage);
  make_pattern(stage);
  set_if_unset(stage.velocity, 0.01);
  stage.fast_velocity = coin(2) ? kUnset : stage.velocity;
  if (std::isnan(stage.fast_velocity)) stage.fast_below = PushStage{}.fast_below;
  if (!goes_to_and_fro(stage)) set_if_unset(stage.until, 0.05);
  const bool alike = stage.pattern == Pattern::kNone && coin(2);
  stage.as = coin(3) ? Manner::kDefault : alike ? Manner::kEach : Manner::kSpreader;
  const Direction direction = stage.drive.direction;
  const bool level = direction == Direction::kPlusX || direction == Direction::kMinusX;
  if (!level || stage.pattern != Pattern::kNone || stage.as == Manner::kEach ||
      stage.fixity.rotation == Freedom::kBlocked || goes_to_and_fro(stage))
    stage.contraflexure = kUnset;  // is for one head that turns
}

// A pulse in each of some directions, and one of the ways to scale them.
void make_shake(ShakeStage& stage) {
  if (stage.record.empty()) stage.record.emplace_back();
  for (RecordSpec& record : stage.record) {
    if (record.pulse == PulseShape::kNone) record.pulse = PulseShape::kRicker;
    set_if_unset(record.amplitude, 1.0 / 3), set_if_unset(record.period, 0.1);
    record.file.clear(), record.accelerations.clear();
    record.column.clear(), record.times.clear(), record.step = kUnset;  // of files and lists
    record.unit = RecordUnit::kNone;
    make_place(record.at);
  }
  const bool by_factor = coin(2);
  stage.scale.pga = stage.scale.pgv = kUnset;
  if (by_factor) {
    stage.scale = {};
    stage.scale.factor = -0.0;
  } else {
    stage.scale.factor = kUnset;
    set_if_unset(stage.scale.sa, 1.0 / 3), set_if_unset(stage.scale.period, 0.1);
  }
  for (ViscousSpec* viscous : {&stage.mass_damping, &stage.joint_damping, &stage.maxwell_damping}) {
    if (std::isnan(viscous->fraction) && std::isnan(viscous->frequency)) continue;
    set_if_unset(viscous->fraction, 0.05), set_if_unset(viscous->frequency, 1.0 / 3);
  }
}

void make_valid(StageSpec& stage, std::size_t index) {
  stage.name += std::to_string(index);
  const auto make_level = [](DriveSpec& drive) {
    if (drive.direction != Direction::kPlusX) drive.direction = Direction::kMinusX;
  };
  if (auto* load = std::get_if<LoadStage>(&stage.action)) {
    make_one_load(*load);
    if (load->as != Manner::kPlate) load->plate_joint = LoadStage{}.plate_joint;
  }
  if (auto* push = std::get_if<PushStage>(&stage.action)) make_push(*push);
  if (auto* force = std::get_if<BodyForceStage>(&stage.action)) {
    make_level(force->drive);
    set_if_unset(force->rate, 0.1), set_if_unset(force->factor, 1.0 / 3);
  }
  if (auto* tilt = std::get_if<TiltStage>(&stage.action)) {
    make_level(tilt->drive);
    set_if_unset(tilt->tilt_rate, 0.1), set_if_unset(tilt->tilt_until, 0.3);
  }
  if (auto* hold = std::get_if<HoldStage>(&stage.action)) set_if_unset(hold->duration, 1.0 / 3);
  if (auto* shake = std::get_if<ShakeStage>(&stage.action)) make_shake(*shake);
}

// A law the check accepts: Table 1 of the paper, with more energy than snap-back needs, or a body.
void make_valid(JointMaterial& material) {
  const JointMaterial drawn = material;
  material = JointMaterial{.softening = drawn.softening,
                           .coupling = drawn.coupling,
                           .unloading = drawn.unloading,
                           .density = drawn.density,
                           .youngs_modulus = drawn.youngs_modulus,
                           .shear_modulus = drawn.shear_modulus};
  if (coin(3)) return;
  const double more = 1 + static_cast<double>(*rc::gen::inRange(0, 1 << 30)) * 0x1p-30;
  material.normal_stiffness = 20e9;
  material.shear_stiffness = 8e9 / 3;
  material.tensile_strength = 0.15e6 / more;
  material.cohesion = 0.15e6 / more;
  material.friction_angle = 0.28 * more;
  material.residual_friction_angle = 0.28 * more;
  material.residual_cohesion = coin(2) ? 0.0 : -0.0;
  material.mode_1_energy = 43 * more;
  material.mode_2_energy = 1250 * more;
  material.compressive_strength = coin(2) ? kUnlimited : 3.96e6 / more;
  material.compressive_energy = 128000 * more;
}

// Keeps only the keys of the spectrum's kind.
void make_valid(SpectrumSpec& s) {
  const SpectrumSpec drawn = s;
  s = {};
  s.kind = drawn.kind;
  if (drawn.kind == SpectrumKind::kTable) {
    s.corner_period = 1.0 / 3;
    s.periods = {0, 1.0 / 3, 2};
    s.accelerations = {2, 5, 1.0 / 3};
  } else if (drawn.kind != SpectrumKind::kNone) {
    s.ground_acceleration = 1.0 / 3, s.ground = coin(2) ? "E" : "A";
    s.topography = drawn.topography, s.damping = drawn.damping;
    if (drawn.kind == SpectrumKind::kEn1998) s.shape = coin(2) ? "1" : "2";
    if (drawn.kind == SpectrumKind::kNtc2018) s.amplification = 2.45, s.corner_period = 1.0 / 3;
  }
}

// A part that stands on its foot; what holds it is stated.
void make_valid(PartSpec& part) {
  if (part.foot >= part.head) part.head = part.foot + 1;
  if (part.left >= part.right) part.right = part.left + 1;
  for (HoldSpec& hold : part.hold)
    set_if_unset(hold.height, 1.0 / 3), set_if_unset(hold.force, 1e4 / 3);
  TeethSpec& teeth = part.teeth;
  if (teeth.corners == 0) {
    teeth = {};
    return;
  }
  set_if_unset(teeth.length, 0.3), set_if_unset(teeth.course, 1.0 / 3);
  set_if_unset(teeth.friction, 0.5);
}

void make_valid(AssessmentSpec& assessment) {
  if (assessment.code.empty()) {  // not asked for: no table
    assessment = {};
    return;
  }
  assessment.code = coin(2) ? "circolare_2019" : "en1998_3";
  assessment.limit_state = coin(2) ? "near_collapse" : "damage_limitation";
  if (!(assessment.added_mass > 0)) assessment.added_height = kUnset;
  SpectraSpec& own = assessment.spectra;
  for (SpectrumSpec* s : {&assessment.spectrum, &own.operational, &own.damage_limitation,
                          &own.life_safety, &own.near_collapse})
    make_valid(*s);
  if (assessment.code == "en1998_3") own.operational = {};
  for (PartSpec& part : assessment.part) make_valid(part);
  // one spectrum for the limit state that is asked
  if (assessment.spectrum.kind != SpectrumKind::kNone)
    (assessment.limit_state == "near_collapse" ? own.near_collapse : own.damage_limitation) =
        SpectrumSpec{};
}

ModelSpec any_spec() {
  ModelSpec spec;
  Draw draw;
  describe(draw, spec);
  spec.wall.blocks.clear();                          // names a file, which would be read
  spec.wall.up.clear(), spec.wall.supports.clear();  // of such a file
  if (std::isnan(spec.wall.beam.height)) spec.wall.beam = {};
  if (spec.stage.empty()) spec.stage.emplace_back();
  for (std::size_t i = 0; i < spec.stage.size(); ++i) make_valid(spec.stage[i], i);
  for (auto& [name, material] : spec.material) make_valid(material);
  make_valid(spec.assessment);
  if (!spec.scatter.use.empty()) spec.scatter.use = coin(2) ? "tuff" : "stone";
  for (std::size_t i = 0; i < spec.history.size(); ++i)
    spec.history[i].name += std::to_string(i), make_place(spec.history[i].at);
  // a name of one's own; what has no kind is not there
  for (std::size_t i = 0; i < spec.wall.opening.size(); ++i) {
    OpeningSpec& opening = spec.wall.opening[i];
    if (!opening.name.empty()) opening.name += std::to_string(i);
    if (opening.lintel.kind.empty()) opening.lintel = {};
    if (opening.sill.kind.empty()) opening.sill = {};
    if (opening.arch.kind == ArchKind::kNone) opening.arch = {};
  }
  for (std::size_t i = 0; i < spec.region.size(); ++i)
    if (!spec.region[i].name.empty()) spec.region[i].name += std::to_string(i);
  for (std::size_t i = 0; i < spec.floor.size(); ++i)
    if (!spec.floor[i].name.empty()) spec.floor[i].name += std::to_string(i);
  for (ContactRule& rule : spec.contact)
    if (rule.material.empty()) rule.material = "joint";
  return spec;
}

RC_GTEST_PROP(SpecRoundTrip, reading_what_was_written_gives_the_same_bits, ()) {
  const ModelSpec spec = any_spec();
  const std::string text = write_model(spec);
  RC_LOG(text);
  RC_ASSERT(first_difference(spec, parse_model(text, "written.toml")) == "");
}

RC_GTEST_PROP(SpecRoundTrip, writing_what_was_read_gives_the_same_text, ()) {
  const std::string text = write_model(any_spec());
  RC_ASSERT(write_model(parse_model(text, "written.toml")) == text);
}

// Any bits of a double, in any unit an engineer would choose.
RC_GTEST_PROP(QuantityRoundTrip, every_finite_double_returns, (std::uint64_t bits)) {
  const double value = std::bit_cast<double>(bits);
  RC_PRE(std::isfinite(value));
  for (const auto& [si, shown] :
       {std::pair("m", "mm"), std::pair("Pa", "MPa"), std::pair("Pa/m", "GPa/m"),
        std::pair("rad", "deg"), std::pair("N", "kN")}) {
    const double back = parse_quantity(format_quantity(value, si, shown), si);
    RC_ASSERT(std::bit_cast<std::uint64_t>(back) == bits);
  }
}

}  // namespace
}  // namespace wythe::io::spec_roundtrip_test
