// Faults as text, and InputError, which carries all of them.
#include "wythe/error.h"

namespace wythe {
namespace {

std::string listed(const std::vector<Fault>& faults) {
  std::string out;
  for (const Fault& fault : faults) {
    if (!out.empty()) out += '\n';
    out += to_string(fault);
  }
  return out;
}

}  // namespace

std::string to_string(const Fault& fault) {
  std::string out = fault.file;
  if (fault.line > 0) out += ':' + std::to_string(fault.line);
  if (!out.empty()) out += ": ";
  out += fault.path;
  if (!fault.value.empty()) out += (fault.path.empty() ? "" : " = ") + fault.value;
  if (!fault.path.empty() || !fault.value.empty()) out += ": ";
  out += fault.problem;
  if (!fault.cure.empty()) out += "; " + fault.cure;
  return out;
}

InputError::InputError(std::vector<Fault> faults)
    : std::runtime_error(listed(faults)), faults_(std::move(faults)) {}

void FaultList::throw_if_any() const {
  if (!faults_.empty()) throw InputError(faults_);
}

}  // namespace wythe
