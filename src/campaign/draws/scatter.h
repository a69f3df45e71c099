// [scatter] of a model: fields of the strengths of joints and units, and what follows them.
#pragma once

#include <functional>
#include <string>

#include "wythe/error.h"
#include "wythe/wall_spec.h"

namespace wythe::study {

// Names of its fields: "scatter_joint_tensile_strength".
inline constexpr const char* kScatterPrefix = "scatter_";

// Adds the fields that [scatter] asks for, of keys that have places in the wall; a field that stands there
// already keeps what it says. Refuses an unknown kind of masonry and a scatter of nothing.
void add_scatter(ModelSpec& spec, const std::function<bool(const std::string& path)>& has_places,
                 FaultList& faults);

}  // namespace wythe::study
