// Texts of lengths and shares for faults (a length has six digits), and checks of required numbers.
#include "geometry/text.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace wythe::geometry {
namespace {

std::string write_example(const Needed& number) {
  return "write e.g. " + last_key(number.path) + " = \"" + number.example + "\"";
}

bool is_finite(const Needed& given, FaultList& faults) {
  if (std::isnan(given.value)) {
    add_fault(faults, given.path, "", "missing", write_example(given));
  } else if (std::isinf(given.value)) {
    add_fault(faults, given.path, "infinite", "must be finite", write_example(given));
  }
  return std::isfinite(given.value);
}

std::string value_text(const Needed& given) {
  return fmt::format("{:.6g} {}", given.value, given.unit);
}

}  // namespace

std::string metres(double length) { return fmt::format("{:.6g} m", length); }
std::string millimetres(double length) { return fmt::format("{:.6g} mm", 1000 * length); }
std::string percent(double share) { return fmt::format("{:+.1f} %", 100 * share); }

std::string last_key(const std::string& path) { return path.substr(path.rfind('.') + 1); }

std::string times(double factor) { return fmt::format("{:.2g}", factor); }

std::string opening_path(int index, const std::string& key) {
  return "wall.opening." + std::to_string(index) + "." + key;
}

std::string storey_path(int index, const std::string& key) {
  return "storey." + std::to_string(index) + "." + key;
}

std::string opening_name(int index, const std::string& name) {
  return "opening " + std::to_string(index) + (name.empty() ? "" : " (" + name + ")");
}

Message opening_words(int index, const std::string& name) {
  if (name.empty()) return {"opening.numbered", {{"index", index}}};
  return {"opening.named", {{"index", index}, {"name", name}}};
}

void add_fault(FaultList& faults, std::string path, std::string value, std::string problem,
               std::string cure) {
  Fault fault;
  fault.path = std::move(path);
  fault.value = std::move(value);
  fault.problem = std::move(problem);
  fault.cure = std::move(cure);
  faults.add(std::move(fault));
}

bool is_positive(const Needed& given, FaultList& faults) {
  if (!is_finite(given, faults)) return false;
  if (given.value > 0) return true;
  add_fault(faults, given.path, value_text(given), "must be positive", write_example(given));
  return false;
}

bool is_not_negative(const Needed& given, FaultList& faults) {
  if (!is_finite(given, faults)) return false;
  if (given.value >= 0) return true;
  add_fault(faults, given.path, value_text(given), "must not be negative", write_example(given));
  return false;
}

}  // namespace wythe::geometry
