// A model run to its end, with its state and result.
#pragma once

#include "wythe/parts/model.h"
#include "wythe/parts/solve.h"

namespace wythe::scenes {

struct Outcome {
  Model model;
  State state;
  Result result;
};

[[nodiscard]] inline Outcome run(const ModelSpec& spec) {
  Outcome r;
  r.model = compile(spec);
  r.state = initial_state(r.model);
  r.result = solve(r.model, r.state, {});
  return r;
}

}  // namespace wythe::scenes
