// Existing masonry by Circolare 7/2019: Table C8.5.I by knowledge level (C8.5.4.1), the coefficients of
// Table C8.5.II, and tests by [C8.5.4.3] (docs/theory/material_rules.md, "Values of Circolare 7/2019").
//
// Used by src/io/model/materials.cpp where [masonry] states a knowledge level.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "materials/library.h"

namespace wythe::materials {

enum class KnowledgeLevel { kNone, kLc1, kLc2, kLc3 };
inline constexpr Word<KnowledgeLevel> kKnowledgeLevelWords[] = {
    {"LC1", KnowledgeLevel::kLc1}, {"LC2", KnowledgeLevel::kLc2}, {"LC3", KnowledgeLevel::kLc3}};
// Confidence factor FC of C8.5.4.
[[nodiscard]] double confidence_factor(KnowledgeLevel level);

// A column of Table C8.5.II, or a factor from C8.5.3.1 and the notes of Table C8.5.I.
struct Correction {
  enum Kind {
    kState,     // of the existing wall: at most the two largest act
    kWork,      // strengthening
    kFootnote,  // acts beside the others, outside the limit of the product
  };
  const char* key;  // of [masonry]
  Kind kind;
  const char* meaning;
};
[[nodiscard]] std::span<const Correction> corrections();
[[nodiscard]] bool is_in_table(const Entry& entry);  // a row of Table C8.5.I

// Factor on strengths that the table gives for this masonry, 0 where it has none. Good mortar of bricks has a factor by its
// strength [Pa]; NaN where that is not known.
[[nodiscard]] double allowed(const Entry& entry, const Correction& correction, double mortar);

struct Applied {
  const Correction* correction;
  double factor;
};
// Direct tests of one value: mean (in the unit of its datum), number, and weight kappa of the table.
struct Tests {
  std::string method;
  double mean;
  int number;
  double kappa;
};
// kappa of Table C8.5.III; nothing where a method does not measure this key.
[[nodiscard]] std::optional<double> kappa_of(std::string_view method, std::string_view key);
[[nodiscard]] std::vector<std::string> methods_of(std::string_view key);

struct Taken {
  double value;     // in the unit of the datum
  std::string way;  // "minimum 2.6 MPa x 1.3 transverse_connection / 1.35"
};
// Value of a datum by knowledge level, corrections and tests. Weight and friction stay unchanged. `tests` may be nullptr.
[[nodiscard]] Taken take(const Entry& entry, const Datum& datum, KnowledgeLevel level,
                         std::span<const Applied> applied, const Tests* tests);
// Whether the `way` of an earlier run begins with the present value of the table.
[[nodiscard]] bool begins_with_table(std::string_view way, const Datum& datum);

}  // namespace wythe::materials
