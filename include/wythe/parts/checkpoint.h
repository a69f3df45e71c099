// The checkpoint of a run: one file in the folder of its results, from which the run goes on after
// whatever ended it. `wythe run --checkpoint` writes it, `wythe run --resume` reads it.
#pragma once

#include <cstdint>
#include <string>

#include "wythe/parts/model.h"
#include "wythe/parts/recording.h"
#include "wythe/parts/wall_spec.h"

namespace wythe {

inline constexpr const char* kCheckpointFile = "checkpoint.wythe";

// What the run was asked for.
struct RunOrder {
  std::string model_file;  // as it was named; the text below stands for it
  std::string model_text;  // write_model() of the spec, overrides applied
  std::string blocks;      // content of the blocks file; "" where there is none
  std::string language;    // of the report
  double every = 0;        // between checkpoints, by the clock on the wall [s]
};
[[nodiscard]] RunOrder order_of(const ModelSpec& spec, const std::string& model_file);

struct Checkpoint {
  RunOrder order = {};
  ModelSpec spec = {};
  Model model = {};
  State state = {};
  RunRecord record = {};
};

// The whole file; docs/reference/results.md, "checkpoint.wythe".
[[nodiscard]] std::string checkpoint_bytes(const RunOrder& order, const Model& model,
                                           const State& state, const RunRecord& record);
// Reads the checkpoint in `folder`. Throws InputError where there is none, or where it is a link, no
// file, cut short, damaged, of another program, or of another model than it says.
[[nodiscard]] Checkpoint read_checkpoint(const std::string& folder);

}  // namespace wythe
