// Converts levels and cycles of a test to the targets of a push, and finds the first fault of a stated protocol.
// Levels are displacements [m], or drifts times the height; they must not decrease. One number of cycles may serve all levels.
#include "model/protocol.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace wythe {
namespace {

constexpr double kMostCycles = 1e4;  // in all

const std::vector<double>& levels_of(const PushStage& push) {
  return push.amplitudes.empty() ? push.drifts : push.amplitudes;
}

double cycles_at(const PushStage& push, std::size_t level) {
  if (push.cycles.empty()) return 1;
  return push.cycles[std::min(level, push.cycles.size() - 1)];
}

std::string shown(const PushStage& push, double level) {
  return push.amplitudes.empty() ? fmt::format("{:g} %", 1e2 * level)
                                 : fmt::format("{:g} mm", 1e3 * level);
}

// First fault of the levels alone.
std::optional<ProtocolFault> fault_of_levels(const PushStage& push) {
  const std::vector<double>& levels = levels_of(push);
  const char* key = push.amplitudes.empty() ? "drifts" : "amplitudes";
  for (std::size_t k = 0; k < levels.size(); ++k) {
    const auto fault = [&](std::string problem, const char* cure) {
      return ProtocolFault{fmt::format("{}.{}", key, k), shown(push, levels[k]), std::move(problem),
                           cure};
    };
    if (!(levels[k] > 0) || !std::isfinite(levels[k]))
      return fault("is no level, each cycle goes that far to both sides",
                   "write how far it goes, above 0");
    if (k > 0 && levels[k] < levels[k - 1])
      return fault(
          fmt::format("falls back behind the level before it, {}", shown(push, levels[k - 1])),
          "write levels that grow; for any other order write every displacement in targets");
  }
  return std::nullopt;
}

std::optional<ProtocolFault> fault_of_cycles(const PushStage& push) {
  const std::size_t levels = levels_of(push).size();
  if (push.cycles.size() > 1 && push.cycles.size() != levels)
    return ProtocolFault{"cycles", "",
                         fmt::format("must be one number, or one a level: {} and not {}", levels,
                                     push.cycles.size()),
                         "write e.g. cycles = 2"};
  for (std::size_t k = 0; k < push.cycles.size(); ++k) {
    const double n = push.cycles[k];
    if (n >= 1 && n == std::floor(n)) continue;
    return ProtocolFault{fmt::format("cycles.{}", k), fmt::format("{:g}", n),
                         n == 0 ? "asks for no cycle" : "is no number of cycles",
                         "write a whole number from 1 on, or leave the level out"};
  }
  double all = 0;
  for (std::size_t k = 0; k < levels; ++k) all += cycles_at(push, k);
  if (all <= kMostCycles) return std::nullopt;
  return ProtocolFault{
      "cycles", "",
      fmt::format("asks for {:g} cycles in all, at most {:g} are run", all, kMostCycles),
      "write fewer cycles, or fewer levels"};
}

}  // namespace

bool has_protocol(const PushStage& push) { return !levels_of(push).empty(); }

bool goes_to_and_fro(const PushStage& push) { return !push.targets.empty() || has_protocol(push); }

std::vector<double> targets_of(const PushStage& push, double height) {
  if (!push.targets.empty() || !has_protocol(push)) return push.targets;
  const std::vector<double>& levels = levels_of(push);
  std::vector<double> targets;
  for (std::size_t k = 0; k < levels.size(); ++k) {
    const double far = push.amplitudes.empty() ? levels[k] * height : levels[k];
    for (double cycle = 0; cycle < cycles_at(push, k); ++cycle)
      targets.insert(targets.end(), {far, -far});
  }
  targets.push_back(0);
  return targets;
}

std::string told_levels(const PushStage& push) {
  const std::vector<double>& levels = levels_of(push);
  const double to_unit = push.amplitudes.empty() ? 1e2 : 1e3;
  std::string text;
  for (std::size_t k = 0; k < levels.size(); ++k)
    text +=
        fmt::format("{}{:g} × {:g}", k > 0 ? ", " : "", cycles_at(push, k), to_unit * levels[k]);
  return text;
}

std::optional<ProtocolFault> fault_of_protocol(const PushStage& push) {
  if (!has_protocol(push)) {
    if (push.cycles.empty()) return std::nullopt;
    return ProtocolFault{"cycles", "", "has no levels",
                         "write e.g. amplitudes = [\"2 mm\", \"4 mm\", \"8 mm\"]"};
  }
  if (!push.targets.empty())
    return ProtocolFault{"targets", "",
                         "says where the push goes, and so do the levels of a protocol",
                         "keep one of them"};
  if (!push.amplitudes.empty() && !push.drifts.empty())
    return ProtocolFault{"drifts", "", "states levels, and so does amplitudes", "keep one of them"};
  if (const auto fault = fault_of_levels(push)) return fault;
  return fault_of_cycles(push);
}

}  // namespace wythe
