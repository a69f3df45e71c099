// The requests of [masonry] to Circolare 7/2019: a knowledge level, coefficients and tests (src/materials/circolare.h).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "io/text/toml_reader.h"
#include "materials/circolare.h"

namespace wythe::io {

struct OfficeMasonry {
  materials::KnowledgeLevel level = materials::KnowledgeLevel::kNone;
  std::vector<materials::Applied> applied = {};
  std::map<std::string, materials::Tests, std::less<>> tests = {};  // by key

  [[nodiscard]] bool is_asked() const { return level != materials::KnowledgeLevel::kNone; }
  [[nodiscard]] std::string word() const {
    return std::string(word_of(materials::kKnowledgeLevelWords, level));
  }
  [[nodiscard]] materials::Taken taken(const materials::Entry& entry,
                                       const materials::Datum& datum) const {
    const auto found = tests.find(datum.key);
    return materials::take(entry, datum, level, applied,
                           found == tests.end() ? nullptr : &found->second);
  }
};

// Parses those keys and removes them from the table. `use`: its
// typology, null where there is none; its fault may be reported already.
[[nodiscard]] OfficeMasonry parse_office(ReadContext& context, toml::table& masonry,
                                         const materials::Entry* use, bool use_is_told);

}  // namespace wythe::io
