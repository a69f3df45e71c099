// The checkpoint of a run: one file in the folder of its results, from which an interrupted run
// continues. `wythe run --checkpoint` writes it, `wythe run --resume` reads it.
#pragma once

#include <cstdint>
#include <string>

#include "wythe/parts/model.h"
#include "wythe/parts/recording.h"
#include "wythe/parts/wall_spec.h"

namespace wythe {

inline constexpr const char* kCheckpointFile = "checkpoint.wythe";

// The inputs and options of the run.
struct RunOrder {
  std::string model_file;  // name as given; `model_text` has its content
  std::string model_text;  // write_model() of the spec, overrides applied
  std::string blocks;      // content of the blocks file; "" where there is none
  std::string language;    // of the report
  double every = 0;        // time between checkpoints [s of wall-clock time]
};
[[nodiscard]] RunOrder order_of(const ModelSpec& spec, const std::string& model_file);

struct Checkpoint {
  RunOrder order = {};
  ModelSpec spec = {};
  Model model = {};
  State state = {};
  RunRecord record = {};
};

// Bytes of the whole file; format: docs/reference/results.md, "checkpoint.wythe".
[[nodiscard]] std::string checkpoint_bytes(const RunOrder& order, const Model& model,
                                           const State& state, const RunRecord& record);
// Reads the checkpoint in `folder`. Throws InputError where there is none, or it is a link or no regular file; where it is
// truncated or damaged; and where it belongs to another program version, or to another model than it states.
[[nodiscard]] Checkpoint read_checkpoint(const std::string& folder);

}  // namespace wythe
