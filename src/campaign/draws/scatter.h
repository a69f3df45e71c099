// [scatter] of a model: fields of the strengths of joints and units, and what follows them.
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

// Adds the fields that [scatter] asks for, of keys that have places in the wall; a field that stands there
// already keeps what it says. Refuses an unknown kind of masonry and a scatter of nothing.
void add_scatter(ModelSpec& spec, const std::function<bool(const std::string& path)>& has_places,
                 FaultList& faults);

// A field of the model in the place of one of these: what would follow a strength keeps its mean beside it.
[[nodiscard]] std::vector<Message> notes_of_scatter(const ModelSpec& spec);

// A strength whose stated scatter is far from that of tests.
struct OddScatter {
  const char* words;   // code of a message: which strength
  double cov, tested;  // within a wall and between walls, stated and of tests [-]
};
// Of a compiled model and the scatter of its mean strength between walls (NaN: none): less than half of what tests of this
// masonry have within a wall, or more than 2.5 times.
[[nodiscard]] std::vector<OddScatter> odd_scatter(const ModelSpec& spec, const Model& model,
                                                  double between);

}  // namespace wythe::study
