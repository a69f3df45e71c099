// Makes the motions of a shake from records and pulses, finds what they drive, and sets dashpots (14.6) and Maxwell elements.
// The first record determines the common factor. Motions of driven blocks are relative to the base, in whose frame the
// wall is computed. A peak beyond that of any earthquake is refused as a wrong unit. Dashpots need final masses, so they
// come last.
#include "model/shaking.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/elementary.h"
#include "core/hash.h"
#include "model/geometry.h"
#include "model/parts.h"
#include "model/rebound.h"

namespace wythe {
namespace {

constexpr double kLeastShake = 1e-4;  // less is no earthquake [g]

double in_metres(RecordUnit unit, double gravity) {
  switch (unit) {
    case RecordUnit::kGravity: return gravity;
    case RecordUnit::kCentimetres: return 1e-2;
    default: return 1;
  }
}

// A pulse as samples; linear interpolation deviates by less than 1e-4 of its amplitude.
GroundMotion pulse_motion(const RecordSpec& r) {
  constexpr double kSamples = 400;     // per period
  constexpr double kHalfRicker = 1.5;  // periods before its peak: the rest is below 1e-8
  const double turns = r.pulse == PulseShape::kHalfCycle ? 0.5
                       : r.pulse == PulseShape::kCycle   ? 1.0
                                                         : 2 * kHalfRicker;
  std::vector<double> time, acceleration;
  for (double k = 0; k <= turns * kSamples; ++k) {
    const double x = k / kSamples;
    const double z = M_PI * M_PI * (x - kHalfRicker) * (x - kHalfRicker);
    const double shape = r.pulse == PulseShape::kRicker       ? (1 - 2 * z) * elementary::exp(-z)
                         : 2 * k == kSamples || k == kSamples ? 0.0
                                                              : elementary::sin(2 * M_PI * x);
    time.push_back(x * r.period);
    acceleration.push_back(r.amplitude * shape);
  }
  return ground_motion(std::move(time), std::move(acceleration));
}

// Samples of a record other than a pulse [m/s^2]; faults are reported where it is read.
GroundMotion table_motion(const RecordSpec& r, double gravity) {
  std::vector<double> time = r.read_times, acceleration = r.read_accelerations;
  if (r.file.empty()) {
    time = r.times;
    for (const double a : r.accelerations) acceleration.push_back(a * in_metres(r.unit, gravity));
    for (std::size_t k = 0; r.times.empty() && k < acceleration.size(); ++k)
      time.push_back(static_cast<double>(k) * r.step);
  }
  const double start = time.empty() ? 0.0 : time.front();
  for (double& t : time) t -= start;
  return ground_motion(std::move(time), std::move(acceleration));
}

class ShakeCompiler {
 public:
  ShakeCompiler(const std::string& path, const WallPlaces& places, Model& model, Stage& stage,
                FaultList& faults)
      : path_(path),
        places_(places),
        model_(model),
        stage_(stage),
        shake_(stage.spec.get<ShakeStage>()),
        faults_(faults) {}

  void run() {
    stage_.drive_x = stage_.drive_y = stage_.drive_z = 0;
    std::vector<GroundMotion> motions;
    for (std::size_t k = 0; k < shake_.record.size(); ++k) {
      if (!is_sound(shake_.record[k], k)) return;
      GroundMotion motion = shake_.record[k].pulse == PulseShape::kNone
                                ? table_motion(shake_.record[k], model_.solve.gravity)
                                : pulse_motion(shake_.record[k]);
      motion.along = places_.axis(shake_.record[k].direction);
      if (geometry_of(model_).dimension < 3 && motion.along.z != 0)
        return fault(key_of(k, "direction"),
                     std::string(word_of(kDirectionWords, shake_.record[k].direction)),
                     "is out of the wall's plane, and this wall is no wall in space",
                     "write +x, -x, +y or -y, or give its blocks a third dimension");
      motion.source = !shake_.record[k].file.empty() ? shake_.record[k].file
                      : shake_.record[k].pulse != PulseShape::kNone
                          ? std::string(word_of(kPulseShapeWords, shake_.record[k].pulse))
                          : "table";
      motions.push_back(std::move(motion));
    }
    const bool weighs = std::any_of(model_.stages.begin(), model_.stages.end(), [](const Stage& b) {
      return b.spec.kind() == StageKind::kGravity;
    });
    if (!weighs && model_.solve.gravity > 0)
      fault("record", "", "shakes a wall that does not carry its weight yet",
            "put a gravity stage before it");
    if (motions.empty()) return fault("record", "", "is missing", "write [[stage.record]]");
    const double factor = common_factor(motions.front());
    for (std::size_t k = 0; k < motions.size(); ++k) {
      const std::size_t before = faults_.all().size();
      weigh(motions[k], k);
      GroundMotion motion = scaled(std::move(motions[k]), factor);
      if (faults_.all().size() == before) check_motion(motion, k);
      if (is_stated(shake_.record[k].at))
        drive(std::move(motion), k);
      else
        add_to_base(std::move(motion), k);
    }
    note_rest();
    relate();
    limit_rows();
  }

 private:
  void fault(const std::string& key, std::string value, std::string problem, std::string cure) {
    faults_.add({"", path_ + "." + key, std::move(value), std::move(problem), std::move(cure), 0});
  }
  static std::string key_of(std::size_t k, const char* name) {
    return fmt::format("record.{}.{}", k, name);
  }

  void limit_rows() {
    constexpr double kMostRows = 1e6;
    constexpr double kTail =
        0.1;  // of the rows: residuals are their mean (dynamics/stages/shake.cpp)
    double longest = stage_.driven_motion.duration();
    for (const GroundMotion& m : stage_.base) longest = std::max(longest, m.duration());
    longest += shake_.free_vibration;
    if (shake_.free_vibration < kTail * longest)
      note("shake.residuals_in_record", {{"stage", stage_.spec.name},
                                         {"free_s", shake_.free_vibration},
                                         {"wanted_s", kTail * longest}});
    if (shake_.interval * kMostRows < longest)
      fault("interval", fmt::format("{:g} s", shake_.interval),
            fmt::format("makes {:.3g} rows, at most a million are kept", longest / shake_.interval),
            "write a longer one");
    if (shake_.interval > longest_interval(longest))
      note("shake.rows", {{"stage", stage_.spec.name},
                          {"interval_s", longest_interval(longest)},
                          {"stated_s", shake_.interval}});
  }

  // Checks for models from programs; files are checked where they are read.
  bool is_sound(const RecordSpec& r, std::size_t k) {
    const std::size_t before = faults_.all().size();
    if (r.pulse != PulseShape::kNone) {
      if (!(r.period > 0) || !is_set(r.amplitude))
        fault(key_of(k, "pulse"), std::string(word_of(kPulseShapeWords, r.pulse)),
              "needs an amplitude and a period",
              "write amplitude = \"3 m/s^2\", period = \"0.5 s\"");
      return faults_.all().size() == before;
    }
    const bool listed = r.file.empty();
    const std::vector<double>& times = listed ? r.times : r.read_times;
    const std::vector<double>& values = listed ? r.accelerations : r.read_accelerations;
    const char* const name = listed ? "accelerations" : "file";
    if (values.size() < 2)
      fault(key_of(k, name), "", "holds fewer than two accelerations", "give the whole record");
    if (listed && r.unit == RecordUnit::kNone)
      fault(key_of(k, "unit"), "", "is missing: no acceleration without its unit",
            "write unit = \"g\", \"m/s2\" or \"cm/s2\"");
    if (times.empty() && !(r.step > 0))
      fault(key_of(k, "step"), "", "is missing, and no times are given",
            "write step = \"0.005 s\", or times");
    if (!times.empty() && times.size() != values.size())
      fault(key_of(k, "times"), fmt::format("{}", times.size()),
            fmt::format("are not as many as accelerations, {}", values.size()),
            "write one time for each");
    for (std::size_t i = 1; i < times.size(); ++i)
      if (!(times[i] > times[i - 1])) {
        fault(key_of(k, "times"), fmt::format("{:g} s after {:g} s", times[i], times[i - 1]),
              "do not rise", "sort them, and write each time once");
        break;
      }
    if (faults_.all().size() == before) check_times(times, k, listed ? "times" : "file");
    return faults_.all().size() == before;
  }

  void check_times(const std::vector<double>& times, std::size_t k, const char* name) {
    constexpr double kLeast = 1e-6, kMost = 1e6;  // [s]: of an interval, of a record
    for (std::size_t i = 1; i < times.size(); ++i)
      if (times[i] - times[i - 1] < kLeast || !(times[i] - times[0] < kMost))
        return fault(key_of(k, name), fmt::format("{:g} s after {:g} s", times[i], times[i - 1]),
                     "are no times of a record in seconds", "write the times in seconds");
    for (const Gap& gap : gaps_of(times))
      return fault(key_of(k, name),
                   fmt::format("{:g} s to {:g} s", times[gap.after], times[gap.after + 1]),
                   fmt::format("times are missing: elsewhere one follows each {:g} s", gap.usual),
                   "complete the record; where it should be a straight line, write its points");
  }

  double common_factor(const GroundMotion& first) {
    const ScaleSpec& s = shake_.scale;
    if (is_set(s.factor)) return s.factor;
    if (is_set(s.pga)) return reach(s.pga, peak_acceleration(first));
    if (is_set(s.pgv)) return reach(s.pgv, peak_velocity(first));
    if (!is_set(s.sa)) return 1;
    const double damping = is_set(s.damping) ? s.damping : 0.05;
    return reach(s.sa, pseudo_acceleration(first, s.period, damping));
  }
  double reach(double wanted, double now) {
    const double factor = wanted / now;
    if (std::isfinite(factor)) return factor;
    fault("scale", fmt::format("{:g}", wanted),
          "cannot be reached: the first record has nothing to scale",
          "give a record that shakes, or a pulse with an amplitude");
    return 1;
  }

  void note(const char* code, std::vector<Argument> arguments) {
    model_.anatomy.notes.push_back({code, std::move(arguments)});
  }

  // Refuses records whose size shows a wrong unit, by a factor of ten or a hundred.
  void weigh(const GroundMotion& m, std::size_t k) {
    constexpr double kMost = 5, kLeast = kLeastShake;  // [g]: limits of all records
    const double pga = peak_acceleration(m) / kGravityOfRecords;
    if (shake_.record[k].pulse != PulseShape::kNone || (pga >= kLeast && pga <= kMost)) return;
    if (pga == 0)
      return fault(key_of(k, shake_.record[k].file.empty() ? "accelerations" : "file"), "",
                   "is zero throughout: nothing shakes", "give a record, or leave the stage out");
    fault(key_of(k, "unit"), fmt::format("{:.3g} g", pga),
          "is the peak acceleration with this unit, and no earthquake's",
          pga > kMost ? "numbers like these are often cm/s2" : "numbers like these are often g");
  }

  // Checks the applied motion, and the drift of its baseline.
  void check_motion(const GroundMotion& m, std::size_t k) {
    constexpr double kMost = 20;     // [g]: beyond lies a wrong scale
    constexpr double kDrift = 0.05;  // of the largest velocity left at the end
    const double pga = peak_acceleration(m) / kGravityOfRecords;
    if (!(pga <= kMost))
      fault(shake_.record[k].pulse == PulseShape::kNone ? "scale" : key_of(k, "amplitude"),
            fmt::format("{:.3g} g", pga), "is the peak acceleration that follows",
            "write a smaller one");
    note_record(m, shake_.record[k], pga);
    note_coarse(m, k);
    const double left = std::fabs(m.velocity.back()), most = peak_velocity(m);
    if (left > kDrift * most)
      note("shake.baseline", {{"stage", stage_.spec.name},
                              {"record", m.source},
                              {"velocity_mm_per_s", 1e3 * m.velocity.back()},
                              {"percent", 100 * left / most},
                              {"displacement_mm", 1e3 * m.displacement.back()},
                              {"mean_g", m.velocity.back() / m.duration() / kGravityOfRecords}});
  }

  // The step between times, or its least and largest value.
  static Message between(const std::vector<double>& time) {
    constexpr double kEven = 0.02;  // times are written with few digits
    double least = time[1] - time[0], most = least;
    for (std::size_t k = 1; k + 1 < time.size(); ++k) {
      least = std::min(least, time[k + 1] - time[k]);
      most = std::max(most, time[k + 1] - time[k]);
    }
    if (most - least > kEven * most)
      return {"shake.each_from", {{"least_ms", 1e3 * least}, {"most_ms", 1e3 * most}}};
    const double mean = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
    return {"shake.each", {{"step_ms", 1e3 * mean}}};
  }

  // Notes what was read from a file: a wrong column or unit shows only here.
  void note_record(const GroundMotion& m, const RecordSpec& r, double pga) {
    std::vector<Argument> said = {{"stage", stage_.spec.name},
                                  {"record", m.source},
                                  {"pga_g", pga},
                                  {"pgv_mm_per_s", 1e3 * peak_velocity(m)},
                                  {"duration_s", m.duration()},
                                  {"factor", m.factor}};
    if (r.file.empty()) return note("shake.record", std::move(said));
    double sum = 0;
    for (const double a : m.acceleration) sum += a;
    const auto count = static_cast<double>(m.acceleration.size());
    const double peak = peak_acceleration(m);
    said.push_back(
        {"column", r.column.empty() ? Message{} : Message{"shake.column", {{"name", r.column}}}});
    said.push_back({"unit", std::string(word_of(kRecordUnitWords, r.unit))});
    said.push_back({"count", count});
    said.push_back({"each", between(m.time)});
    said.push_back({"mean_percent", peak > 0 ? 100 * sum / count / peak : 0});
    note("shake.record_file", std::move(said));
  }

  // Notes a wall that stands since nothing shakes it.
  void note_rest() {
    double most = peak_acceleration(stage_.driven_motion);
    for (const GroundMotion& m : stage_.base) most = std::max(most, peak_acceleration(m));
    if (most < kLeastShake * kGravityOfRecords)
      note("shake.nothing", {{"stage", stage_.spec.name}, {"pga_g", most / kGravityOfRecords}});
  }

  // In the plane compile.cpp compares the samples of the base with the wall's first period.
  void note_coarse(const GroundMotion& m, std::size_t k) {
    constexpr double kUsual = 0.0201;  // [s] between samples; older records have 0.02
    const RecordSpec& r = shake_.record[k];
    const bool compared = geometry_of(model_).dimension == 2 && !is_stated(r.at);
    if (compared || r.pulse != PulseShape::kNone || m.time.size() < 3) return;
    const double step = m.duration() / static_cast<double>(m.time.size() - 1);
    if (step > kUsual)
      note("shake.coarse_record", {{"stage", stage_.spec.name},
                                   {"record", m.source},
                                   {"step_ms", 1e3 * step},
                                   {"frequency_hz", 0.5 / step}});
  }

  void add_to_base(GroundMotion motion, std::size_t k) {
    for (const GroundMotion& other : stage_.base)
      if (std::fabs(dot(other.along, motion.along)) > 0.5)
        return fault(key_of(k, "direction"),
                     std::string(word_of(kDirectionWords, shake_.record[k].direction)),
                     "has a record already", "give each direction one record");
    stage_.base.push_back(std::move(motion));
  }

  // Adds a motion other than that of the base; all such motions must be one motion in one direction.
  void drive(GroundMotion motion, std::size_t k) {
    if (!stage_.driven_motion.empty())
      return fault(key_of(k, "at"), "", "is a second motion beside that of the base",
                   "move one group of blocks or supports, along one direction");
    stage_.driven = places_.blocks(shake_.record[k].at);
    const auto support = [&](BlockId id) { return id >= model_.n_block; };
    const auto supports = std::count_if(stage_.driven.begin(), stage_.driven.end(), support);
    if (stage_.driven.empty() ||
        (supports > 0 && supports < static_cast<std::ptrdiff_t>(stage_.driven.size())))
      return fault(key_of(k, "at"), "",
                   stage_.driven.empty() ? "finds nothing that could move"
                                         : "finds both supports and blocks",
                   "name blocks by id, a point in a block, or a box round their centres");
    stage_.driven_share.assign(stage_.driven.size(), 1.0);
    stage_.drive_x = motion.along.x, stage_.drive_y = motion.along.y;
    stage_.drive_z = motion.along.z;
    stage_.driven_motion = std::move(motion);
  }

  // Makes the driven motion relative to the base, in whose frame the wall is computed.
  void relate() {
    if (stage_.driven_motion.empty()) return;
    for (const GroundMotion& base : stage_.base)
      stage_.driven_motion =
          combined(stage_.driven_motion, base, -dot(base.along, stage_.driven_motion.along));
  }

  const std::string& path_;
  const WallPlaces& places_;
  Model& model_;
  Stage& stage_;
  const ShakeStage& shake_;
  FaultList& faults_;
};

double mass_between(const Model& m, std::size_t joint) {
  const double b = m.mass[m.joint_b[joint]];
  if (static_cast<int>(joint) >= m.n_pair) return b;
  const double a = m.mass[m.joint_a[joint]];
  return a * b / (a + b);
}

}  // namespace

Vec3 vector_of(Direction direction) {
  switch (direction) {
    case Direction::kPlusX: return {1, 0, 0};
    case Direction::kMinusX: return {-1, 0, 0};
    case Direction::kPlusY: return {0, 1, 0};
    case Direction::kMinusY: return {0, -1, 0};
    case Direction::kPlusZ: return {0, 0, 1};
    case Direction::kMinusZ: return {0, 0, -1};
  }
  return {};
}

void compile_shake(const std::string& path, const WallPlaces& places, Model& model, Stage& stage,
                   FaultList& faults) {
  ShakeCompiler(path, places, model, stage, faults).run();
}

void compile_watched(const std::vector<HistorySpec>& history, const WallPlaces& places,
                     Model& model, FaultList& faults) {
  for (std::size_t k = 0; k < history.size(); ++k) {
    const std::vector<BlockId> found = places.blocks(history[k].at);
    if (found.empty() || found.front() >= model.n_block) {
      faults.add({"", fmt::format("history.{}.at", k), history[k].at.block,
                  "finds no block that moves", "name a point in a block, or its id", 0});
      continue;
    }
    const BlockId block = found.front();
    const Vec3 point = places.point(history[k].at, block),
               middle = geometry_of(model).centroid(model, block);
    model.watched.push_back({history[k].name, block, point - middle, point.y - places.lowest});
  }
  const bool shakes = std::any_of(model.stages.begin(), model.stages.end(), [](const Stage& s) {
    return s.spec.kind() == StageKind::kShake;
  });
  if (!history.empty() || !shakes || model.n_block == 0) return;
  const auto top = std::max_element(model.centroid_y.begin(), model.centroid_y.end());
  const auto block = static_cast<BlockId>(top - model.centroid_y.begin());
  model.watched.push_back(
      {"top", block, {}, geometry_of(model).centroid(model, block).y - places.lowest});
}

// Notes loads without mass in a shake: they press the wall and make it appear safer.
static void note_loads_without_mass(const Stage& shake, double pressed, double bare, Model& model) {
  constexpr double kSome = 0.02;  // of the wall's weight
  double carried = 0;
  for (const PointLoad& mass : shake.carried) carried += mass.fx * model.solve.gravity;
  if (pressed - carried > kSome * bare * model.solve.gravity)
    model.anatomy.notes.push_back(
        {"shake.loads_without_mass",
         {{"stage", shake.spec.name}, {"load_kN", 1e-3 * pressed}, {"mass_kN", 1e-3 * carried}}});
}

// A body force is proportional to the weights of blocks. Loads press and so raise the factor; where they represent masses, an
// earthquake acts on these too.
static void note_loads_left_out(const Stage& factor, double pressed, double carried, Model& model) {
  constexpr double kSome = 0.02;  // of the wall's weight
  double weight = 0;
  for (const double mass : model.gravity_mass) weight += mass * model.solve.gravity;
  for (const double mass : model.solids.node_gravity_mass) weight += mass * model.solve.gravity;
  for (const double mass : model.space.solids.node_gravity_mass)
    weight += mass * model.solve.gravity;
  if (pressed > kSome * weight)
    model.anatomy.notes.push_back(
        {factor.spec.kind() == StageKind::kTilt ? "tilt.loads_left_out"
                                                : "body_force.loads_left_out",
         {{"stage", factor.spec.name}, {"load_kN", 1e-3 * pressed}, {"weight_kN", 1e-3 * weight}}});
  // a mass of floors without a load is left out too
  if (const double more = carried * model.solve.gravity - pressed; more > kSome * weight)
    model.anatomy.notes.push_back(
        {"body_force.masses_left_out",
         {{"stage", factor.spec.name}, {"mass_kg", more / model.solve.gravity}}});
}

void carry_floors(const std::vector<double>& bare, Model& model) {
  double pressed = 0, carried = 0;
  const double all = std::accumulate(bare.begin(), bare.end(), 0.0);
  for (std::size_t i = 0; i < bare.size(); ++i) carried += std::fmax(0.0, model.mass[i] - bare[i]);
  for (Stage& stage : model.stages) {
    for (const PointLoad& load : stage.loads) pressed += std::fmax(0, -load.fy);
    if (stage.spec.kind() == StageKind::kBodyForce || stage.spec.kind() == StageKind::kTilt)
      note_loads_left_out(stage, pressed, carried, model);
    if (stage.spec.kind() != StageKind::kShake) continue;
    for (std::size_t i = 0; i < bare.size(); ++i)
      if (model.mass[i] > bare[i])
        stage.carried.push_back({static_cast<BlockId>(i), 0, 0, model.mass[i] - bare[i], 0});
    note_loads_without_mass(stage, pressed, all, model);
  }
}

double fraction_of_restitution(double restitution) {
  constexpr double kMost = kNoRebound;
  const auto comes_back = [](double xi) {
    if (xi < 1) {
      const double psi = elementary::asin(xi);
      return elementary::exp(-elementary::tan(psi) * (M_PI - 2 * psi));
    }
    const double root = std::sqrt(xi * xi - 1);
    return root == 0 ? elementary::exp(-2.0)
                     : elementary::exp(-xi / root * elementary::log((xi + root) / (xi - root)));
  };
  if (restitution <= comes_back(kMost)) return kMost;
  double low = 0, high = kMost;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (comes_back(middle) > restitution ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

MaxwellElement maxwell_element(double fraction, double frequency) {
  const double share =
      8 * fraction * fraction + 4 * fraction * std::sqrt(1 + 4 * fraction * fraction);
  return {share, 1 / (2 * M_PI * frequency * std::sqrt(1 + share))};
}

double viscous_fraction(const ShakeStage& shake, double frequency) {
  const auto of = [&](const ViscousSpec& v, auto share) {
    return is_set(v.fraction) ? v.fraction * share(frequency / v.frequency) : 0;
  };
  return of(shake.mass_damping, [](double r) { return 1 / r; }) +
         of(shake.joint_damping, [](double r) { return r; }) +
         of(shake.maxwell_damping, [](double r) { return 2 * r / (1 + r * r); });
}

double share_of_step(double omega_max, const Dashpots& d) {
  const double stiffer = std::sqrt(1 + d.spring_share);
  const double xi = 0.5 * d.rate / (omega_max * stiffer);
  return (std::sqrt(1 + xi * xi) - xi) / stiffer;
}

namespace {

// Sets one row for each joint.
void put_dashpots(const Model& m, Dashpots& d) {
  for (std::size_t j = 0; j < static_cast<std::size_t>(m.n_joint); ++j) {
    const JointMaterial& law = m.materials[m.joint_material[j]];
    const double share = mass_between(m, j) / m.area[j];
    const auto dashpot = [&](double stiffness) {
      return d.proportional * stiffness + 2 * d.impact * std::sqrt(stiffness * share);
    };
    d.normal.push_back(dashpot(law.normal_stiffness));
    d.shear.push_back(dashpot(law.shear_stiffness));
  }
}

// Notes a pulse of few steps: the wall only experiences its change of velocity.
void note_brief_pulses(const Stage& stage, Model& m) {
  constexpr double kFewest = 10;  // steps
  const double step = 1 / m.omega_max;
  for (const GroundMotion& motion : stage.base)
    if (motion.duration() < kFewest * step)
      m.anatomy.notes.push_back({"shake.brief",
                                 {{"stage", stage.spec.name},
                                  {"record", motion.source},
                                  {"duration_ms", 1e3 * motion.duration()},
                                  {"step_ms", 1e3 * step}}});
}

}  // namespace

// Notes that the stated restitution holds for a single block that falls flat, not for a pile.
static void note_rebound(const std::string& name, double restitution, const Dashpots& d, Model& m) {
  constexpr double kApart = 0.05;
  if (!(d.impact > 0)) return;
  const std::optional<double> obtained = rebound_of_wall(m, d);
  if (obtained && std::fabs(*obtained - restitution) > kApart)
    m.anatomy.notes.push_back({"shake.rebound",
                               {{"stage", name},
                                {"restitution", restitution},
                                {"obtained", *obtained},
                                {"energy_percent", 100 * *obtained * *obtained}}});
}

// Notes the damping obtained: a fraction is stated at one frequency, the wall has its own (docs/theory/dynamics.md, 14.9a).
static void note_damping_obtained(Model& model) {
  constexpr double kApart =
      0.2;  // of the request: Maxwell elements keep 0.8 of it within an octave
  for (const Stage& stage : model.stages) {
    const auto* shake = std::get_if<ShakeStage>(&stage.spec.action);
    if (shake == nullptr || stage.base.empty()) continue;
    double asked = 0;
    for (const ViscousSpec& v : {shake->mass_damping, shake->joint_damping, shake->maxwell_damping})
      asked = std::fmax(asked, v.fraction);
    if (!(asked > 0)) continue;
    const auto& along = stage.base.front().along;
    const double frequency = 1 / geometry_of(model).first_period(model, along);
    const double obtained = viscous_fraction(*shake, frequency);
    if (!(std::fabs(obtained - asked) > kApart * asked)) continue;
    model.anatomy.notes.push_back(
        {"shake.damping_obtained",
         {{"stage", stage.spec.name},
          {"asked_percent", 100 * asked},
          {"obtained_percent", 100 * obtained},
          {"frequency_hz", frequency},
          {"half_percent", 100 * viscous_fraction(*shake, 0.5 * frequency)},
          {"half_hz", 0.5 * frequency}}});
  }
}

void set_dashpots(Model& m) {
  note_damping_obtained(m);
  for (Stage& stage : m.stages) {
    const auto* shake = std::get_if<ShakeStage>(&stage.spec.action);
    if (shake == nullptr) continue;
    const std::string& name = stage.spec.name;
    note_brief_pulses(stage, m);
    Dashpots& d = stage.dashpots;
    if (is_set(shake->restitution) && shake->restitution < 1)
      d.impact = fraction_of_restitution(shake->restitution);
    if (is_set(shake->joint_damping.fraction))
      d.proportional = shake->joint_damping.fraction / (M_PI * shake->joint_damping.frequency);
    if (is_set(shake->maxwell_damping.fraction)) {
      const MaxwellElement e =
          maxwell_element(shake->maxwell_damping.fraction, shake->maxwell_damping.frequency);
      d.spring_share = e.share, d.relaxation = e.relaxation;
      m.anatomy.notes.push_back({"shake.maxwell",
                                 {{"stage", name},
                                  {"fraction_percent", 100 * shake->maxwell_damping.fraction},
                                  {"frequency_hz", shake->maxwell_damping.frequency},
                                  {"stiffer_percent", 100 * e.share},
                                  {"times", std::sqrt(1 + e.share)}}});
    }
    const bool has_dashpots = d.impact > 0 || d.proportional > 0;
    if (!has_dashpots && !(d.spring_share > 0)) continue;
    put_dashpots(m, d);
    if (!has_dashpots) continue;
    note_rebound(name, shake->restitution, d, m);
    d.rate = geometry_of(m).dashpot_rate(m, d);
    m.anatomy.notes.push_back(
        {"shake.dashpots", {{"stage", name}, {"times", 1 / share_of_step(m.omega_max, d)}}});
  }
}

std::vector<Message> damping_of(const StageSpec& stage,
                                const std::map<std::string, std::string>& drawn) {
  const auto& shake = stage.get<ShakeStage>();
  std::vector<Message> out;
  const auto tell = [&](const char* key, bool is_stated, const Message& stated) {
    if (const auto input = drawn.find(key); input != drawn.end())
      out.push_back({"damping.drawn", {{"key", key}, {"input", input->second}}});
    else if (is_stated)
      out.push_back(stated);
  };
  const auto viscous = [&](const char* key, const char* code, const ViscousSpec& v) {
    tell(key, is_set(v.fraction),
         {code, {{"fraction_percent", 100 * v.fraction}, {"frequency_hz", v.frequency}}});
  };
  viscous("mass_damping", "damping.mass", shake.mass_damping);
  viscous("joint_damping", "damping.joints", shake.joint_damping);
  viscous("maxwell_damping", "damping.maxwell", shake.maxwell_damping);
  tell("restitution", is_set(shake.restitution),
       {"damping.restitution", {{"restitution", shake.restitution}}});
  tell("damping", is_set(stage.damping) && stage.damping > 0,
       {"damping.local", {{"share", stage.damping}}});
  if (out.empty()) out.push_back({"damping.none"});
  return out;
}

std::vector<std::vector<BlockId>> blocks_at_tops(const Model& m) {
  const Anatomy& a = m.anatomy;
  std::vector<std::vector<BlockId>> found(a.storey_top.size());
  const double slack = 1e-6 * a.height;
  for (BlockId b = 0; b < m.n_block && !found.empty(); ++b) {
    const auto [low, high] = geometry_of(m).heights(m, b);
    for (std::size_t k = 0; k < found.size(); ++k)
      if (a.storey_top[k] > low + slack && a.storey_top[k] <= high + slack) found[k].push_back(b);
  }
  return found;
}

void note_storeys_without_top(Model& m) {
  const bool shakes = std::any_of(m.stages.begin(), m.stages.end(), [](const Stage& s) {
    return s.spec.kind() == StageKind::kShake;
  });
  if (!shakes) return;
  const auto found = blocks_at_tops(m);
  for (std::size_t k = 0; k < found.size(); ++k)
    if (found[k].empty())
      return m.anatomy.notes.push_back(
          {"shake.no_storeys", {{"storey", m.anatomy.storey_name[k]}}});
}

// Gaps where samples are missing: nearly all steps are equal, and a few are at least half again as long.
std::vector<Gap> gaps_of(const std::vector<double>& time) {
  constexpr double kEqual = 0.01, kGap = 1.5, kMostAreEqual = 0.9;
  if (time.size() < 10) return {};
  std::vector<double> step;
  for (std::size_t k = 1; k < time.size(); ++k) step.push_back(time[k] - time[k - 1]);
  std::vector<double> sorted = step;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  const double usual = *middle;
  const auto equal = std::count_if(step.begin(), step.end(),
                                   [&](double h) { return std::fabs(h - usual) < kEqual * usual; });
  if (static_cast<double>(equal) < kMostAreEqual * static_cast<double>(step.size())) return {};
  std::vector<Gap> found;
  for (std::size_t k = 0; k < step.size(); ++k)
    if (step[k] > kGap * usual) found.push_back({k, usual});
  return found;
}

std::string record_hash(const std::vector<double>& times,
                        const std::vector<double>& accelerations) {
  Hash hash;
  hash.add(times);
  hash.add(accelerations);
  return hash.text();
}

}  // namespace wythe
