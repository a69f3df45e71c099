// Writes and parses a line of `origin`: "cohesion 0.21 MPa: typical of clay_brick_old (Magenes and Calvi 1992, CoV 0.40)".
#pragma once

#include <optional>
#include <string>

namespace wythe::materials {

struct Origin {
  enum Kind { kGiven, kDerived, kTypical };
  std::string key;
  std::string value;  // as the table writes it
  Kind kind = kGiven;
  std::string by;  // "by gi_from_ft from tensile_strength 0.15 MPa"
};

// Why a joint has no slope of GII although a rule would give one: "mode_2_energy_per_pressure 0 mm: given as
// mode_2_energy is stated", "... is typical of NAME", "... is by NAME". This line has no value beside it.
inline const std::string kAsEnergyIs = "as mode_2_energy is ", kTypicalOf = "typical of ",
                         kBy = "by ";
// For a stated value that replaces that of a knowledge level: "masonry_strength 3 MPa: given as
// stated beside knowledge_level LC1, not minimum 2.6 MPa / 1.35".
inline const std::string kBesideLevel = "as stated beside knowledge_level ", kNot = ", not ";

[[nodiscard]] inline std::string kind_word(Origin::Kind kind) {
  return kind == Origin::kGiven ? "given" : kind == Origin::kDerived ? "derived" : "typical";
}
[[nodiscard]] inline std::string to_text(const Origin& origin) {
  return origin.key + ' ' + origin.value + ": " + kind_word(origin.kind) + ' ' + origin.by;
}
[[nodiscard]] inline std::optional<Origin> origin_of(const std::string& line) {
  const std::size_t space = line.find(' '), colon = line.find(": ", space);
  if (space == std::string::npos || colon == std::string::npos) return std::nullopt;
  Origin out{line.substr(0, space), line.substr(space + 1, colon - space - 1), Origin::kGiven, ""};
  for (const Origin::Kind kind : {Origin::kGiven, Origin::kDerived, Origin::kTypical}) {
    const std::string word = kind_word(kind) + ' ';
    if (line.compare(colon + 2, word.size(), word) != 0) continue;
    out.kind = kind;
    out.by = line.substr(colon + 2 + word.size());
    return out;
  }
  return std::nullopt;
}

}  // namespace wythe::materials
