// parse_study() of io.h, also for a text that the program made from a model.
#pragma once

#include <string>
#include <vector>

#include "wythe/parts/assessment.h"
#include "wythe/parts/study.h"
#include "wythe/parts/verdict.h"

namespace wythe::io {

enum class StudyText {
  kWritten,  // a setting of a key that a formula sets would be lost, and is refused
  kMade      // its formulas use the values of the base model, with its settings
};
[[nodiscard]] StudySpec parse_study_text(const std::string& toml_text, const std::string& file_name,
                                         const std::vector<std::string>& overrides, StudyText from);
// The study of a model's walls: the first way of pushing is its own, each other one a [[variant]]. `tables` come before them.
[[nodiscard]] std::string text_of_ways(const AskedWalls& asked, const std::vector<PushWay>& ways,
                                       const std::string& tables = "");

}  // namespace wythe::io
