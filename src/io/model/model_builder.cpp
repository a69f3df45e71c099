// model_builder: the base model of a study with the settings of a sample.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/text.h"
#include "wythe/parts/io.h"

namespace wythe {

ModelBuilder model_builder(const StudySpec& study) {
  std::vector<std::string> settings = study.settings;
  std::vector<double> states = study.states;
  if (!states.empty() && !std::isnan(study.read_modes_at) &&
      std::find(states.begin(), states.end(), study.read_modes_at) == states.end())
    states.push_back(study.read_modes_at);
  std::sort(states.begin(), states.end());
  std::vector<std::string> texts;
  for (const double state : states) texts.push_back(fmt::format("\"{:.17g} m\"", state));
  if (!texts.empty()) settings.push_back("output.states=[" + joined(texts, ", ") + "]");
  return [=, text = study.model_text, file = study.model_file, blocks = study.blocks_text,
          records = study.record_text](const std::vector<std::string>& own) {
    std::vector<std::string> all = settings;
    all.insert(all.end(), own.begin(), own.end());
    return parse_model(text, file, all, blocks, records);
  };
}

}  // namespace wythe
