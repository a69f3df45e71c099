// Estimates blocks, memory, steps and time from stated lengths and measured costs, and refuses impossible runs.
// Millimetres in place of metres, or the reverse, are reported first and alone, since further messages would be wrong. WYTHE_MEMORY
// may state the memory; otherwise it is that of the machine or its container.
#include "model/size.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include "core/number.h"
#include "core/text.h"
#include "geometry/wall/storeys.h"
#include "model/protocol.h"
#include "model/quadrature.h"
#include "wythe/parts/curve.h"

namespace wythe {
namespace {

// Measured on plain walls of 20 000 and 80 000 blocks, rounded up.
constexpr double kBuildBytes = 2000;      // a block, its joints and names while the model is built
constexpr double kStateDoubles = 6;       // numbers of a block in a state, and of a contact point
constexpr double kJointsPerBlock = 3;     // running bond with split units
constexpr double kCopies = 2;             // of a stored state: in memory, and in the page
constexpr double kFramesKept = 64;        // for animations, and start, peak, end
constexpr double kReadEvery = 1e-3;       // a state is stored for reading each millimetre [m]
constexpr double kSecondsPerStep = 1e-7;  // for each block on one core
constexpr double kMostNumbers = 2.5e8;    // of blocks: joints and points are numbered in 32 bits
constexpr double kMostRowsOfModel = 1e6;  // as output.rows
constexpr double kMostSeconds = 3.2e8;    // ten years
constexpr double kSeconds = 0.1;          // of a ramp, and usual time of settling

std::string bytes_text(double bytes) {
  if (bytes < 1e9) return fmt::format("{:.0f} MB", bytes * 1e-6);
  if (bytes < 1e12) return fmt::format("{:.0f} GB", bytes * 1e-9);
  return fmt::format("{:.3g} TB", bytes * 1e-12);
}

std::string time_text(double seconds) {
  if (seconds < 120) return fmt::format("{:.0f} s", seconds);
  if (seconds < 2 * 3600) return fmt::format("{:.0f} min", seconds / 60);
  if (seconds < 2 * 86400) return fmt::format("{:.0f} h", seconds / 3600);
  if (seconds < 2 * 3.15e7) return fmt::format("{:.0f} days", seconds / 86400);
  return fmt::format("{:.3g} years", seconds / 3.15e7);
}

std::string count_text(double count) {
  return count < 1e6 ? fmt::format("{:.0f}", count) : fmt::format("{:.3g} million", count * 1e-6);
}

bool is_length(double value) { return std::isfinite(value) && value > 0; }

double or_else(double value, double otherwise) { return std::isnan(value) ? otherwise : value; }

// Number of blocks; 0 where lengths are missing, which are separate faults.
double blocks_of(const geometry::Storey& storey) {
  const UnitSpec& unit = storey.unit;
  const bool headers = storey.bond == Bond::kHeader;
  const double length = headers ? or_else(unit.width, unit.length / 2) : unit.length;
  if (!is_length(storey.length) || !is_length(storey.height) || !is_length(length) ||
      !is_length(unit.height))
    return 0;
  const double pieces = unit.split == Split::kAtJoints             ? 3
                        : unit.split == Split::kMiddle && !headers ? 2
                                                                   : 1;
  return std::ceil(pieces * storey.length / length) * std::ceil(storey.height / unit.height);
}

double blocks_of(const ModelSpec& spec) {
  if (!spec.block.empty() || !spec.wall.blocks.empty())
    return static_cast<double>(spec.block.size());
  double blocks = 0;
  for (const geometry::Storey& storey : geometry::stated_storeys(spec.wall, spec.storey))
    blocks += blocks_of(storey);
  return blocks;
}

// Turns of a push [m]. Before the wall is built the height of drifts is unknown; `kUsualHeight` replaces it.
std::vector<double> turns_of(const PushStage& push) {
  constexpr double kUsualHeight = 3;                               // [m]
  if (push.targets.empty() && fault_of_protocol(push)) return {};  // reported elsewhere
  return targets_of(push, kUsualHeight);
}

// Largest |displacement| of a push: states for reading are stored up to it once, however often it returns.
double push_reach(const PushStage& push) {
  if (!goes_to_and_fro(push)) return or_else(push.until, 0);
  double reach = 0;
  for (const double target : turns_of(push)) reach = std::max(reach, std::fabs(target));
  return reach;
}

double push_path(const PushStage& push) {
  if (!goes_to_and_fro(push)) return or_else(push.until, 0);
  double path = 0, at = 0;
  for (const double target : turns_of(push)) {
    path += std::fabs(target - at);
    at = target;
  }
  return path;
}

// Duration of the longest record with its free vibration.
double shake_seconds(const ShakeStage& shake) {
  double longest = 0;
  for (const RecordSpec& r : shake.record) {
    const std::vector<double>& times = r.file.empty() ? r.times : r.read_times;
    if (!times.empty()) longest = std::max(longest, times.back() - times.front());
    if (times.empty() && !r.accelerations.empty())
      longest =
          std::max(longest, static_cast<double>(r.accelerations.size() - 1) * or_else(r.step, 0));
    if (r.pulse != PulseShape::kNone) longest = std::max(longest, 3 * or_else(r.period, 0));
  }
  return longest + shake.free_vibration;
}

// Time step of the stiffest joint between two units [s]: 2 / omega with omega^2 = 2 K / m.
double step_of(const ModelSpec& spec) {
  constexpr double kUsual = 3e-5;  // for walls without stated sizes
  const UnitSpec unit = geometry::stated_storeys(spec.wall, spec.storey).front().unit;
  double stiffest = 0;
  for (const auto& [name, material] : spec.material)
    stiffest = std::max(stiffest, or_else(material.normal_stiffness, 0));
  const double mass = unit.length * unit.height * unit.density;  // per metre of thickness
  const double step = 2 / std::sqrt(4 * stiffest * (unit.length + unit.height) / mass);
  return is_length(step) ? step : kUsual;
}

double memory_of_this_machine() {
  double bytes =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  double limit = 0;  // of a container
  if (std::ifstream("/sys/fs/cgroup/memory.max") >> limit && limit > 0)
    bytes = std::min(bytes, limit);
  return bytes;
}

std::string beyond_memory(double bytes) {
  return fmt::format("about {} of memory ({} may be used)", bytes_text(bytes),
                     bytes_text(memory_limit()));
}

const char* const kMoreMemory =
    "or state what may be used: WYTHE_MEMORY=\"64 GB\" before the command";

void check_blocks(const ModelSpec& spec, const Size& size, FaultList& faults) {
  const bool countable = size.blocks <= kMostNumbers;
  if (countable && size.bytes <= memory_limit()) return;
  const std::string needs =
      countable ? fmt::format("needs {} and {} of computing", beyond_memory(size.bytes),
                              time_text(size.seconds))
                : fmt::format(
                      "is more than {} blocks, the most that are numbered; about {} and {} "
                      "of computing",
                      count_text(kMostNumbers), bytes_text(size.bytes), time_text(size.seconds));
  const bool from_file = !spec.wall.blocks.empty();
  faults.add({"", from_file ? "wall.blocks" : "wall.unit", count_text(size.blocks) + " blocks",
              needs,
              from_file ? std::string("fewer blocks, ") + kMoreMemory
                        : std::string("write larger units or a smaller wall") +
                              (countable ? std::string(", ") + kMoreMemory : ""),
              0});
}

void check_rows(const ModelSpec& spec, FaultList& faults) {
  const double window = spec.output.window;
  if (!is_length(window)) return;
  double rows = 0, path = 0;
  for (const StageSpec& stage : spec.stage) path = std::max(path, pace_of(stage).path);
  rows = path / window;
  if (rows <= kMostRowsOfModel * (1 + 1e-9)) return;
  faults.add({"", "output.window", fmt::format("{:g} mm", 1e3 * window),
              fmt::format("makes {:.3g} rows of the path of {:g} mm, at most {} are kept", rows,
                          1e3 * path, count_text(kMostRowsOfModel)),
              fmt::format("write window = \"{:.6g} mm\" or more", 1e3 * path / kMostRowsOfModel),
              0});
}

void check_time(const ModelSpec& spec, const Size& size, FaultList& faults) {
  if (size.seconds <= kMostSeconds || size.blocks == 0) return;
  std::size_t longest = 0;
  for (std::size_t i = 0; i < spec.stage.size(); ++i)
    if (pace_of(spec.stage[i]).seconds > pace_of(spec.stage[longest]).seconds) longest = i;
  if (spec.stage.empty()) return;
  faults.add({"", fmt::format("stage.{}.{}", longest, pace_of(spec.stage[longest]).key), "",
              fmt::format("the run would take about {:.3g} steps, {} of computing", size.steps,
                          time_text(size.seconds)),
              "write a faster one or a shorter way, so that it ends within ten years", 0});
}

}  // namespace

PushStage with_velocity(PushStage push) {
  if (!std::isnan(push.velocity)) return push;
  push.velocity = kWaitingVelocity;
  if (std::isnan(push.fast_velocity)) push.fast_velocity = kAdaptedVelocity;
  return push;
}

Pace pace_of(const StageSpec& stage) {
  const double ramp = or_else(stage.ramp, kSeconds);
  const auto at_rate = [](double path, double rate, const char* key) -> Pace {
    return {path, or_else(path / rate, 0), key};
  };
  if (const auto* push = std::get_if<PushStage>(&stage.action)) {
    const PushStage adapted = with_velocity(*push);
    // adaptive pushes took 1 to 5 times as many steps as at full speed (docs/evidence/rate.md)
    constexpr double kOfAdapting = 2;
    const bool adapts = adapted.fast_velocity > adapted.velocity;
    Pace pace =
        at_rate(push_path(*push), adapts ? adapted.fast_velocity / kOfAdapting : adapted.velocity,
                adapts ? "fast_velocity" : "velocity");
    pace.seconds += 0.5 * ramp;
    return pace;
  }
  if (const auto* force = std::get_if<BodyForceStage>(&stage.action))
    return at_rate(or_else(force->factor, 0), force->rate, "rate");
  if (const auto* tilt = std::get_if<TiltStage>(&stage.action))
    return at_rate(or_else(tilt->tilt_until, 0), tilt->tilt_rate, "tilt_rate");
  if (const auto* hold = std::get_if<HoldStage>(&stage.action))
    return {0, or_else(hold->duration, 0), "duration"};
  if (const auto* shake = std::get_if<ShakeStage>(&stage.action))
    return {0, shake_seconds(*shake), "record"};
  return {0, ramp + kSeconds, "ramp"};
}

Size size_of(const ModelSpec& spec) {
  Size size;
  size.blocks = blocks_of(spec);
  const double points = kJointsPerBlock * quadrature_choice(spec.solve).points;
  const double state = kStateDoubles * (1 + points) * sizeof(double);
  const double height = geometry::stated_storeys(spec.wall, spec.storey).back().top();
  double kept = kFramesKept + static_cast<double>(spec.output.states.size());
  double seconds = 0;
  for (const StageSpec& stage : spec.stage) {
    seconds += pace_of(stage).seconds;
    // a wall pushed by its own height has fallen
    if (const auto* push = std::get_if<PushStage>(&stage.action))
      kept += std::min(push_reach(*push), or_else(height, 1)) / kReadEvery;
  }
  size.bytes = size.blocks * (kBuildBytes + kCopies * kept * state);
  size.steps = seconds / step_of(spec);
  size.seconds = size.steps * size.blocks * kSecondsPerStep * points / (2 * kJointsPerBlock);
  return size;
}

constexpr double kShortestWall = 0.03, kThinnestWall = 0.002, kLongestUnit = 10;  // [m]

// Refuses millimetres in place of metres, or the reverse. Reported alone, since every opening would be reported as outside the wall.
static void check_scale(const ModelSpec& spec, FaultList& faults) {
  const auto wall = [&](const std::string& path, double size, double least = kShortestWall) {
    if (size > 0 && size < least)
      faults.add({"", path, fmt::format("{:g} mm", 1e3 * size), "is smaller than any wall",
                  fmt::format("write \"{:g} m\", if metres are meant", 1e3 * size), 0});
  };
  const auto unit = [&](const char* path, double size) {
    if (size > kLongestUnit)
      faults.add({"", path, fmt::format("{:g} m", size), "is larger than any unit of masonry",
                  fmt::format("write \"{:g} mm\", if millimetres are meant", size), 0});
  };
  wall("wall.thickness", spec.wall.thickness, kThinnestWall);
  if (!spec.block.empty() || !spec.body.empty() || !spec.wall.blocks.empty()) return;
  wall("wall.length", spec.wall.length);
  wall("wall.height", spec.wall.height);
  for (const StoreySpec& storey : spec.storey)
    wall("storey." + storey.name + ".height", storey.height);
  for (std::size_t i = 0; i < spec.region.size(); ++i)
    wall(fmt::format("region.{}.thickness", i), spec.region[i].thickness, kThinnestWall);
  unit("wall.unit.length", spec.wall.unit.length);
  unit("wall.unit.height", spec.wall.unit.height);
}

void check_size(const ModelSpec& spec, FaultList& faults) {
  check_scale(spec, faults);
  if (!faults.empty()) return;
  const Size size = size_of(spec);
  check_blocks(spec, size, faults);
  check_rows(spec, faults);
  check_time(spec, size, faults);
}

SizeProblem check_samples(const ModelSpec& spec, double samples) {
  const double a_sample = spec.output.rows * static_cast<double>(sizeof(CurveRow));
  const double bytes = samples * a_sample;
  if (bytes <= memory_limit()) return {};
  return {fmt::format("{} samples with their curves need {} and {} of computing on one core",
                      count_text(samples), beyond_memory(bytes),
                      time_text(samples * size_of(spec).seconds)),
          fmt::format("write at most {:.0f}, or shorter curves (output.rows), {}",
                      std::floor(memory_limit() / a_sample), kMoreMemory)};
}

double memory_limit() {
  const char* stated = std::getenv("WYTHE_MEMORY");
  if (stated == nullptr) return memory_of_this_machine();
  std::string_view text = trimmed(stated);
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto [number, unit] = leading_number(text).value_or(LeadingNumber<double>{});
  for (const auto& [name, factor] : {std::pair("GB", 1e9), std::pair("MB", 1e6), {"TB", 1e12}})
    if ((unit == name || unit == std::string(" ") + name) && std::isfinite(number) && number > 0)
      return number * factor;
  throw InputError({{.file = "WYTHE_MEMORY",
                     .value = stated,
                     .problem = "is no size of memory",
                     .cure = "write e.g. WYTHE_MEMORY=\"64 GB\""}});
}

}  // namespace wythe
