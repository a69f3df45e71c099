// Checks the keys of [assessment] together: each kind of spectrum requires some and allows only its own.
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "io/text/toml_reader.h"
#include "wythe/parts/assessment.h"

namespace wythe::io {
namespace {

// Whether a spectrum of this kind uses the key, or the key only has its default.
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

void finish(TableReader& reader, HoldSpec& hold) {
  if (std::isnan(hold.height) && !is_faulty(reader, "height"))
    reader.miss("height", "is missing",
                "write the height at which it holds, e.g. height = \"6.0 m\"");
  if (std::isnan(hold.force) && !is_faulty(reader, "force"))
    reader.miss("force", "is missing: what holds needs a strength",
                "write the least of bar, anchor plate and masonry, e.g. force = \"25 kN\"");
}

void finish(TableReader& reader, TeethSpec& teeth) {
  const auto need = [&](double value, const char* key, const char* cure) {
    if (std::isnan(value) && !is_faulty(reader, key)) reader.miss(key, "is missing", cure);
  };
  if (teeth.corners == 0 && !is_faulty(reader, "corners"))
    reader.miss("corners", "is missing", "write how many walls across hold the part, 1 or 2");
  need(teeth.length, "length", "write the thickness of a wall across, e.g. length = \"0.3 m\"");
  need(teeth.course, "course",
       "write the height between faces that slide, e.g. course = \"200 mm\"");
  need(teeth.friction, "friction", "write the tangent of the angle, e.g. friction = 0.5");
}

void finish(TableReader& reader, PartSpec& part) {
  if (part.foot >= part.head)
    reader.refuse("head", "is not above foot",
                  "write the height of its top, above that of its foot");
  if (part.left >= part.right)
    reader.refuse("right", "is not right of left", "write its right end, from the wall's left");
}

void finish(TableReader& reader, AssessmentSpec& assessment) {
  report(reader, faults_of(assessment));
}

}  // namespace wythe::io
