// [scatter] of a model: fields for the strengths of joints and units, and for properties that follow them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "wythe/parts/error.h"
#include "wythe/parts/message.h"
#include "wythe/parts/model.h"
#include "wythe/parts/wall_spec.h"

namespace wythe::study {

// Names of its fields: "scatter_joint_tensile_strength".
inline constexpr const char* kScatterPrefix = "scatter_";

// Adds the fields of [scatter] for keys that have places in the wall. An existing field keeps
// its values. Refuses an unknown kind of masonry and a scatter that applies to nothing.
void add_scatter(ModelSpec& spec, const std::function<bool(const std::string& path)>& has_places,
                 FaultList& faults);

// Notes a field of the model that replaces one of these: properties that would follow the strength keep their mean.
[[nodiscard]] std::vector<Message> notes_of_scatter(const ModelSpec& spec);

// A strength whose given scatter is far from the scatter of tests.
struct OddScatter {
  const char* words;   // code of a message: which strength
  double cov, tested;  // within a wall and between walls, stated and of tests [-]
};
// From a compiled model and the scatter of its mean strength between walls (NaN: none). The scatter
// is unusual below half or above 2.5 times the scatter of tests of this masonry within a wall.
[[nodiscard]] std::vector<OddScatter> odd_scatter(const ModelSpec& spec, const Model& model,
                                                  double between);

}  // namespace wythe::study
