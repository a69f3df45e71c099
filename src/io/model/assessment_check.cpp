// What the keys of [assessment] must be together: each kind of spectrum needs some and knows only its own.
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "io/text/toml_reader.h"
#include "wythe/assessment.h"

namespace wythe::io {
namespace {

// Whether a spectrum of this kind takes the key, or the key says no more than its default.
bool has_use(std::string_view key, const SpectrumSpec& s) {
  const SpectrumSpec plain;
  const bool is_table = s.kind == SpectrumKind::kTable, is_ntc = s.kind == SpectrumKind::kNtc2018;
  if (key == "ground_acceleration") return !is_table;
  if (key == "ground") return !is_table || s.ground == plain.ground;
  if (key == "topography") return !is_table || s.topography == plain.topography;
  if (key == "damping") return !is_table || s.damping == plain.damping;
  if (key == "shape") return s.kind == SpectrumKind::kEn1998 || s.shape == plain.shape;
  if (key == "amplification") return is_ntc;
  if (key == "corner_period") return is_ntc || is_table;
  if (key == "periods" || key == "accelerations") return is_table;
  return true;
}

bool is_faulty(TableReader& reader, const std::string& key) {
  return reader.context().has_fault_at(reader.below(key));
}

void report(TableReader& reader, const std::vector<Fault>& faults) {
  for (const Fault& fault : faults) {
    if (is_faulty(reader, fault.path)) continue;
    if (reader.has(fault.path))
      reader.refuse(fault.path, fault.problem, fault.cure);
    else
      reader.miss(fault.path, "is missing: " + fault.problem, fault.cure);
  }
}

}  // namespace

void finish(TableReader& reader, SpectrumSpec& spectrum) {
  if (spectrum.kind == SpectrumKind::kNone) {
    if (!is_faulty(reader, "kind"))
      reader.miss("kind", "is missing, a spectrum needs it",
                  "write kind = \"en1998\", \"ntc2018\" or \"table\"");
    return;
  }
  for (const TableReader::Entry& entry : reader.entries())
    if (entry.node && !is_faulty(reader, entry.name) && !has_use(entry.name, spectrum))
      reader.refuse(entry.name,
                    fmt::format("a spectrum of kind {} has no such key",
                                word_of(kSpectrumKindWords, spectrum.kind)),
                    "leave it out");
  report(reader, faults_of(spectrum));
}

void finish(TableReader& reader, AssessmentSpec& assessment) {
  report(reader, faults_of(assessment));
}

}  // namespace wythe::io
